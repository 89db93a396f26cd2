struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_13 {
    member: array<array<u32, 4>>,
}

struct type_16 {
    member: vec4<u32>,
}

struct type_20 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_22 {
    member: array<type_20>,
}

struct type_29 {
    member: array<array<i32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_31 {
    member: array<type_29>,
}

struct type_35 {
    member: array<vec4<u32>, 2>,
}

struct type_38 {
    member: array<i32, 3>,
    member_1: array<i32, 3>,
}

struct type_41 {
    member: array<type_38>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(3) 
var<storage> global_2: type_22;
@group(0) @binding(1) 
var<uniform> global_3: type_35;
@group(0) @binding(2) 
var<storage> global_4: type_31;
@group(0) @binding(4) 
var<storage> global_5: type_41;
@group(0) @binding(5) 
var<storage> global_6: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_7: type_13;
@group(0) @binding(7) 
var<storage, read_write> global_8: type_4;

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
    var phi_1294_: u32;
    var phi_1300_: u32;
    var phi_1310_: u32;
    var phi_1313_: type_8;
    var phi_1314_: type_8;
    var phi_1337_: type_8;
    var phi_1437_: u32;
    var phi_1634_: i32;
    var phi_1668_: i32;
    var phi_1702_: i32;
    var phi_1736_: i32;
    var phi_1770_: i32;
    var phi_1804_: i32;
    var phi_1838_: i32;
    var phi_1872_: i32;
    var phi_1906_: i32;
    var phi_1924_: array<u32, 10>;
    var phi_2848_: bool;
    var phi_2090_: u32;
    var phi_2096_: u32;
    var phi_2106_: u32;
    var phi_2109_: type_8;
    var phi_2110_: type_8;
    var phi_2133_: type_8;
    var phi_2233_: u32;
    var phi_2430_: i32;
    var phi_2464_: i32;
    var phi_2498_: i32;
    var phi_2532_: i32;
    var phi_2566_: i32;
    var phi_2600_: i32;
    var phi_2634_: i32;
    var phi_2668_: i32;
    var phi_2702_: i32;
    var phi_2720_: array<u32, 10>;
    var phi_2962_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e57 = global;
            let _e63 = arrayLength((&global_2.member));
            let _e69 = arrayLength((&global_6.member));
            let _e73 = arrayLength((&global_8.member));
            let _e77 = global_3.member[0u][3u];
            let _e82 = (_e57.x + (_e57.y * 2097152u));
            let _e85 = global_1.member[0u];
            if (_e82 < _e85) {
                let _e87 = (_e82 < arrayLength((&global_4.member)));
                if _e87 {
                    let _e88 = (_e82 < arrayLength((&global_5.member)));
                    if _e88 {
                        let _e89 = (_e82 < arrayLength((&global_7.member)));
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
                            let _e107 = global_7.member[_e82][1u];
                            let _e109 = (_e107 >> bitcast<u32>(11u));
                            let _e111 = bitcast<u32>((_e97[0] - _e94[0]));
                            let _e117 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e111)), 32u, (_e111 == 0u)));
                            let _e122 = ((select(10u, _e117, (_e117 > 10u)) - 10u) & 31u);
                            let _e126 = (_e94[0] + bitcast<i32>(((_e107 & 1023u) << bitcast<u32>(_e122))));
                            let _e131 = (_e97[0] - bitcast<i32>(((_e109 & 1023u) << bitcast<u32>(_e122))));
                            let _e135 = (((_e107 >> bitcast<u32>(10u)) & 1u) == 1u);
                            let _e139 = (((_e109 >> bitcast<u32>(10u)) & 1u) == 1u);
                            let _e140 = select(_e94[0], _e126, _e135);
                            let _e141 = select(_e126, _e94[0], _e135);
                            let _e147 = global_7.member[_e82][2u];
                            let _e149 = (_e147 >> bitcast<u32>(11u));
                            let _e151 = bitcast<u32>((_e97[1] - _e94[1]));
                            let _e157 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e151)), 32u, (_e151 == 0u)));
                            let _e162 = ((select(10u, _e157, (_e157 > 10u)) - 10u) & 31u);
                            let _e166 = (_e94[1] + bitcast<i32>(((_e147 & 1023u) << bitcast<u32>(_e162))));
                            let _e171 = (_e97[1] - bitcast<i32>(((_e149 & 1023u) << bitcast<u32>(_e162))));
                            let _e175 = (((_e147 >> bitcast<u32>(10u)) & 1u) == 1u);
                            let _e179 = (((_e149 >> bitcast<u32>(10u)) & 1u) == 1u);
                            let _e180 = select(_e94[1], _e166, _e175);
                            let _e181 = select(_e166, _e94[1], _e175);
                            let _e187 = global_7.member[_e82][3u];
                            let _e189 = (_e187 >> bitcast<u32>(11u));
                            let _e191 = bitcast<u32>((_e97[2] - _e94[2]));
                            let _e197 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e191)), 32u, (_e191 == 0u)));
                            let _e202 = ((select(10u, _e197, (_e197 > 10u)) - 10u) & 31u);
                            let _e206 = (_e94[2] + bitcast<i32>(((_e187 & 1023u) << bitcast<u32>(_e202))));
                            let _e211 = (_e97[2] - bitcast<i32>(((_e189 & 1023u) << bitcast<u32>(_e202))));
                            let _e215 = (((_e187 >> bitcast<u32>(10u)) & 1u) == 1u);
                            let _e219 = (((_e189 >> bitcast<u32>(10u)) & 1u) == 1u);
                            let _e220 = select(_e94[2], _e206, _e215);
                            let _e221 = select(_e206, _e94[2], _e215);
                            if _e89 {
                            } else {
                                break;
                            }
                            let _e224 = global_7.member[_e82];
                            if _e87 {
                            } else {
                                break;
                            }
                            let _e227 = global_4.member[_e82].member_1;
                            let _e230 = global_4.member[_e82].member_2;
                            let _e232 = ((_e227 & 2147483648u) != 0u);
                            if _e232 {
                                let _e236 = (((_e227 >> bitcast<u32>(28u)) & 7u) > 0u);
                                if _e236 {
                                    phi_685_ = (_e227 & 268435455u);
                                } else {
                                    phi_685_ = u32();
                                }
                                let _e239 = phi_685_;
                                phi_687_ = _e239;
                                phi_688_ = select(true, false, _e236);
                            } else {
                                phi_687_ = u32();
                                phi_688_ = true;
                            }
                            let _e242 = phi_687_;
                            let _e244 = phi_688_;
                            if _e244 {
                                if ((_e230 & 2147483648u) != 0u) {
                                    let _e250 = (((_e230 >> bitcast<u32>(28u)) & 7u) > 0u);
                                    if _e250 {
                                        phi_704_ = (_e230 & 268435455u);
                                    } else {
                                        phi_704_ = u32();
                                    }
                                    let _e253 = phi_704_;
                                    phi_706_ = _e253;
                                    phi_707_ = select(true, false, _e250);
                                } else {
                                    phi_706_ = u32();
                                    phi_707_ = true;
                                }
                                let _e256 = phi_706_;
                                let _e258 = phi_707_;
                                phi_712_ = select(_e256, 0u, _e258);
                            } else {
                                phi_712_ = _e242;
                            }
                            let _e261 = phi_712_;
                            let _e262 = (_e261 < _e69);
                            if _e262 {
                                if _e262 {
                                } else {
                                    break;
                                }
                                let _e264 = global_6.member[_e261];
                                phi_724_ = _e264;
                            } else {
                                phi_724_ = 0u;
                            }
                            let _e266 = phi_724_;
                            if _e232 {
                                phi_740_ = select(_e230, 0u, ((_e230 & 2147483648u) != 0u));
                            } else {
                                phi_740_ = _e227;
                            }
                            let _e271 = phi_740_;
                            if _e232 {
                                let _e274 = ((_e227 >> bitcast<u32>(28u)) & 7u);
                                phi_755_ = select(_e274, 7u, (_e274 == 0u));
                            } else {
                                phi_755_ = 0u;
                            }
                            let _e278 = phi_755_;
                            let _e280 = ((_e230 & 2147483648u) != 0u);
                            if _e280 {
                                let _e283 = ((_e230 >> bitcast<u32>(28u)) & 7u);
                                phi_770_ = select(_e283, 7u, (_e283 == 0u));
                            } else {
                                phi_770_ = 0u;
                            }
                            let _e287 = phi_770_;
                            let _e300 = ((_e266 & 268435455u) | ((_e287 >> bitcast<u32>(1i)) << bitcast<u32>(28u)));
                            if _e89 {
                            } else {
                                break;
                            }
                            global_7.member[_e82] = array<u32, 4>((((_e271 & 268435455u) | (_e278 << bitcast<u32>(28u))) | (_e287 << bitcast<u32>(31i))), (_e224[1] | (_e300 << bitcast<u32>(22i))), (_e224[2] | ((_e300 >> bitcast<u32>(10u)) << bitcast<u32>(22i))), (_e224[3] | ((_e300 >> bitcast<u32>(20u)) << bitcast<u32>(22i))));
                            if _e87 {
                            } else {
                                break;
                            }
                            let _e322 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e77) + 127i)) << bitcast<u32>(23i)));
                            let _e330 = ((bitcast<u32>((select(_e97[0], _e131, _e139) - _e140)) | bitcast<u32>((select(_e97[1], _e171, _e179) - _e180))) | bitcast<u32>((select(_e97[2], _e211, _e219) - _e220)));
                            let _e331 = (_e330 < 1024u);
                            if _e331 {
                                phi_1294_ = 0u;
                            } else {
                                phi_1294_ = select(2u, 1u, (_e330 < 2097152u));
                            }
                            let _e335 = phi_1294_;
                            switch bitcast<i32>(_e335) {
                                case 0: {
                                    phi_1300_ = 1u;
                                    break;
                                }
                                case 1: {
                                    phi_1300_ = 2u;
                                    break;
                                }
                                case 2: {
                                    phi_1300_ = 3u;
                                    break;
                                }
                                default: {
                                    phi_1300_ = u32();
                                    break;
                                }
                            }
                            let _e338 = phi_1300_;
                            let _e340 = ((3u * _e338) + 1u);
                            if _e232 {
                                phi_1310_ = ((_e227 >> bitcast<u32>(28u)) & 7u);
                            } else {
                                phi_1310_ = 0u;
                            }
                            let _e345 = phi_1310_;
                            phi_1313_ = type_8(0u, _e345);
                            loop {
                                let _e348 = phi_1313_;
                                if (_e348.member < _e348.member_1) {
                                    phi_1314_ = type_8((_e348.member + 1u), _e348.member_1);
                                    phi_1337_ = type_8(1u, _e348.member);
                                } else {
                                    phi_1314_ = _e348;
                                    phi_1337_ = type_8(0u, type_8().member_1);
                                }
                                let _e361 = phi_1314_;
                                let _e363 = phi_1337_;
                                let _e367 = (bitcast<i32>(_e363.member) != 0i);
                                if _e367 {
                                    let _e369 = ((_e227 & 268435455u) + _e363.member_1);
                                    let _e370 = (_e369 < _e63);
                                    if _e370 {
                                        let _e371 = (_e369 < _e69);
                                        if _e371 {
                                            if _e371 {
                                            } else {
                                                phi_2848_ = true;
                                                break;
                                            }
                                            let _e373 = global_6.member[_e369];
                                            if ((_e373 + _e340) <= _e73) {
                                                if _e370 {
                                                } else {
                                                    phi_2848_ = true;
                                                    break;
                                                }
                                                let _e378 = global_2.member[_e369].member_1;
                                                if _e331 {
                                                    phi_1437_ = 0u;
                                                } else {
                                                    phi_1437_ = select(2u, 1u, (_e330 < 2097152u));
                                                }
                                                let _e382 = phi_1437_;
                                                switch bitcast<i32>(_e382) {
                                                    case 0: {
                                                        let _e781 = (f32(_e140) * _e322);
                                                        let _e783 = (f32(_e180) * _e322);
                                                        let _e785 = (f32(_e220) * _e322);
                                                        let _e786 = (1f / _e322);
                                                        let _e790 = global_2.member[_e369].member[0u];
                                                        let _e794 = global_2.member[_e369].member[1u];
                                                        let _e798 = global_2.member[_e369].member[2u];
                                                        let _e802 = (1024f / _e322);
                                                        let _e819 = global_2.member[_e369].member[3u];
                                                        let _e823 = global_2.member[_e369].member[4u];
                                                        let _e827 = global_2.member[_e369].member[5u];
                                                        let _e847 = global_2.member[_e369].member[6u];
                                                        let _e851 = global_2.member[_e369].member[7u];
                                                        let _e855 = global_2.member[_e369].member[8u];
                                                        phi_1924_ = array<u32, 10>(((bitcast<u32>(((((_e790 - _e781) * _e786) + ((_e794 - _e783) * _e802)) + 8388608f)) & 4194303u) | ((bitcast<u32>((((_e798 - _e785) * _e786) + 8388608f)) & 4194303u) << bitcast<u32>(20i))), ((bitcast<u32>(((((_e819 - _e781) * _e786) + ((_e823 - _e783) * _e802)) + 8388608f)) & 4194303u) | ((bitcast<u32>((((_e827 - _e785) * _e786) + 8388608f)) & 4194303u) << bitcast<u32>(20i))), ((bitcast<u32>(((((_e847 - _e781) * _e786) + ((_e851 - _e783) * _e802)) + 8388608f)) & 4194303u) | ((bitcast<u32>((((_e855 - _e785) * _e786) + 8388608f)) & 4194303u) << bitcast<u32>(20i))), _e378, 0u, 0u, 0u, 0u, 0u, 0u);
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e668 = (f32(_e140) * _e322);
                                                        let _e670 = (f32(_e180) * _e322);
                                                        let _e672 = (f32(_e220) * _e322);
                                                        let _e673 = (1f / _e322);
                                                        let _e677 = global_2.member[_e369].member[0u];
                                                        let _e681 = global_2.member[_e369].member[1u];
                                                        let _e685 = global_2.member[_e369].member[2u];
                                                        let _e690 = (bitcast<u32>((((_e681 - _e670) * _e673) + 8388608f)) & 4194303u);
                                                        let _e712 = global_2.member[_e369].member[3u];
                                                        let _e716 = global_2.member[_e369].member[4u];
                                                        let _e720 = global_2.member[_e369].member[5u];
                                                        let _e725 = (bitcast<u32>((((_e716 - _e670) * _e673) + 8388608f)) & 4194303u);
                                                        let _e747 = global_2.member[_e369].member[6u];
                                                        let _e751 = global_2.member[_e369].member[7u];
                                                        let _e755 = global_2.member[_e369].member[8u];
                                                        let _e760 = (bitcast<u32>((((_e751 - _e670) * _e673) + 8388608f)) & 4194303u);
                                                        phi_1924_ = array<u32, 10>(((bitcast<u32>((((_e677 - _e668) * _e673) + 8388608f)) & 4194303u) | (_e690 << bitcast<u32>(21i))), ((_e690 >> bitcast<u32>(11i)) | ((bitcast<u32>((((_e685 - _e672) * _e673) + 8388608f)) & 4194303u) << bitcast<u32>(10i))), ((bitcast<u32>((((_e712 - _e668) * _e673) + 8388608f)) & 4194303u) | (_e725 << bitcast<u32>(21i))), ((_e725 >> bitcast<u32>(11i)) | ((bitcast<u32>((((_e720 - _e672) * _e673) + 8388608f)) & 4194303u) << bitcast<u32>(10i))), ((bitcast<u32>((((_e747 - _e668) * _e673) + 8388608f)) & 4194303u) | (_e760 << bitcast<u32>(21i))), ((_e760 >> bitcast<u32>(11i)) | ((bitcast<u32>((((_e755 - _e672) * _e673) + 8388608f)) & 4194303u) << bitcast<u32>(10i))), _e378, 0u, 0u, 0u);
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e387 = global_2.member[_e369].member[0u];
                                                        let _e389 = (bitcast<u32>(_e322) & 2147483647u);
                                                        let _e390 = (_e389 >= 8388608u);
                                                        if _e390 {
                                                            phi_1634_ = (bitcast<i32>((_e389 >> bitcast<u32>(23i))) - 127i);
                                                        } else {
                                                            phi_1634_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e389)), 32u, (_e389 == 0u))));
                                                        }
                                                        let _e403 = phi_1634_;
                                                        let _e409 = (_e387 * bitcast<f32>((bitcast<u32>((127i - _e403)) << bitcast<u32>(23i))));
                                                        let _e421 = global_2.member[_e369].member[1u];
                                                        if _e390 {
                                                            phi_1668_ = (bitcast<i32>((_e389 >> bitcast<u32>(23i))) - 127i);
                                                        } else {
                                                            phi_1668_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e389)), 32u, (_e389 == 0u))));
                                                        }
                                                        let _e434 = phi_1668_;
                                                        let _e440 = (_e421 * bitcast<f32>((bitcast<u32>((127i - _e434)) << bitcast<u32>(23i))));
                                                        let _e452 = global_2.member[_e369].member[2u];
                                                        if _e390 {
                                                            phi_1702_ = (bitcast<i32>((_e389 >> bitcast<u32>(23i))) - 127i);
                                                        } else {
                                                            phi_1702_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e389)), 32u, (_e389 == 0u))));
                                                        }
                                                        let _e465 = phi_1702_;
                                                        let _e471 = (_e452 * bitcast<f32>((bitcast<u32>((127i - _e465)) << bitcast<u32>(23i))));
                                                        let _e483 = global_2.member[_e369].member[3u];
                                                        if _e390 {
                                                            phi_1736_ = (bitcast<i32>((_e389 >> bitcast<u32>(23i))) - 127i);
                                                        } else {
                                                            phi_1736_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e389)), 32u, (_e389 == 0u))));
                                                        }
                                                        let _e496 = phi_1736_;
                                                        let _e502 = (_e483 * bitcast<f32>((bitcast<u32>((127i - _e496)) << bitcast<u32>(23i))));
                                                        let _e514 = global_2.member[_e369].member[4u];
                                                        if _e390 {
                                                            phi_1770_ = (bitcast<i32>((_e389 >> bitcast<u32>(23i))) - 127i);
                                                        } else {
                                                            phi_1770_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e389)), 32u, (_e389 == 0u))));
                                                        }
                                                        let _e527 = phi_1770_;
                                                        let _e533 = (_e514 * bitcast<f32>((bitcast<u32>((127i - _e527)) << bitcast<u32>(23i))));
                                                        let _e545 = global_2.member[_e369].member[5u];
                                                        if _e390 {
                                                            phi_1804_ = (bitcast<i32>((_e389 >> bitcast<u32>(23i))) - 127i);
                                                        } else {
                                                            phi_1804_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e389)), 32u, (_e389 == 0u))));
                                                        }
                                                        let _e558 = phi_1804_;
                                                        let _e564 = (_e545 * bitcast<f32>((bitcast<u32>((127i - _e558)) << bitcast<u32>(23i))));
                                                        let _e576 = global_2.member[_e369].member[6u];
                                                        if _e390 {
                                                            phi_1838_ = (bitcast<i32>((_e389 >> bitcast<u32>(23i))) - 127i);
                                                        } else {
                                                            phi_1838_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e389)), 32u, (_e389 == 0u))));
                                                        }
                                                        let _e589 = phi_1838_;
                                                        let _e595 = (_e576 * bitcast<f32>((bitcast<u32>((127i - _e589)) << bitcast<u32>(23i))));
                                                        let _e607 = global_2.member[_e369].member[7u];
                                                        if _e390 {
                                                            phi_1872_ = (bitcast<i32>((_e389 >> bitcast<u32>(23i))) - 127i);
                                                        } else {
                                                            phi_1872_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e389)), 32u, (_e389 == 0u))));
                                                        }
                                                        let _e620 = phi_1872_;
                                                        let _e626 = (_e607 * bitcast<f32>((bitcast<u32>((127i - _e620)) << bitcast<u32>(23i))));
                                                        let _e638 = global_2.member[_e369].member[8u];
                                                        if _e390 {
                                                            phi_1906_ = (bitcast<i32>((_e389 >> bitcast<u32>(23i))) - 127i);
                                                        } else {
                                                            phi_1906_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e389)), 32u, (_e389 == 0u))));
                                                        }
                                                        let _e651 = phi_1906_;
                                                        let _e657 = (_e638 * bitcast<f32>((bitcast<u32>((127i - _e651)) << bitcast<u32>(23i))));
                                                        phi_1924_ = array<u32, 10>(bitcast<u32>(select(0i, select(select(i32(_e409), i32(-2147483648), (_e409 < -2147483600f)), 2147483647i, (_e409 > 2147483500f)), (_e409 == _e409))), bitcast<u32>(select(0i, select(select(i32(_e440), i32(-2147483648), (_e440 < -2147483600f)), 2147483647i, (_e440 > 2147483500f)), (_e440 == _e440))), bitcast<u32>(select(0i, select(select(i32(_e471), i32(-2147483648), (_e471 < -2147483600f)), 2147483647i, (_e471 > 2147483500f)), (_e471 == _e471))), bitcast<u32>(select(0i, select(select(i32(_e502), i32(-2147483648), (_e502 < -2147483600f)), 2147483647i, (_e502 > 2147483500f)), (_e502 == _e502))), bitcast<u32>(select(0i, select(select(i32(_e533), i32(-2147483648), (_e533 < -2147483600f)), 2147483647i, (_e533 > 2147483500f)), (_e533 == _e533))), bitcast<u32>(select(0i, select(select(i32(_e564), i32(-2147483648), (_e564 < -2147483600f)), 2147483647i, (_e564 > 2147483500f)), (_e564 == _e564))), bitcast<u32>(select(0i, select(select(i32(_e595), i32(-2147483648), (_e595 < -2147483600f)), 2147483647i, (_e595 > 2147483500f)), (_e595 == _e595))), bitcast<u32>(select(0i, select(select(i32(_e626), i32(-2147483648), (_e626 < -2147483600f)), 2147483647i, (_e626 > 2147483500f)), (_e626 == _e626))), bitcast<u32>(select(0i, select(select(i32(_e657), i32(-2147483648), (_e657 < -2147483600f)), 2147483647i, (_e657 > 2147483500f)), (_e657 == _e657))), _e378);
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1924_ = array<u32, 10>();
                                                        break;
                                                    }
                                                }
                                                let _e874 = phi_1924_;
                                                if (_e373 < _e73) {
                                                } else {
                                                    phi_2848_ = true;
                                                    break;
                                                }
                                                global_8.member[_e373] = _e874[0];
                                                let _e888 = (_e373 + 1u);
                                                if (_e888 < _e73) {
                                                } else {
                                                    phi_2848_ = true;
                                                    break;
                                                }
                                                global_8.member[_e888] = _e874[1];
                                                let _e892 = (_e373 + 2u);
                                                if (_e892 < _e73) {
                                                } else {
                                                    phi_2848_ = true;
                                                    break;
                                                }
                                                global_8.member[_e892] = _e874[2];
                                                let _e896 = (_e373 + 3u);
                                                if (_e896 < _e73) {
                                                } else {
                                                    phi_2848_ = true;
                                                    break;
                                                }
                                                global_8.member[_e896] = _e874[3];
                                                if (_e340 > 4u) {
                                                    let _e901 = (_e373 + 4u);
                                                    if (_e901 < _e73) {
                                                    } else {
                                                        phi_2848_ = true;
                                                        break;
                                                    }
                                                    global_8.member[_e901] = _e874[4];
                                                    let _e905 = (_e373 + 5u);
                                                    if (_e905 < _e73) {
                                                    } else {
                                                        phi_2848_ = true;
                                                        break;
                                                    }
                                                    global_8.member[_e905] = _e874[5];
                                                    let _e909 = (_e373 + 6u);
                                                    if (_e909 < _e73) {
                                                    } else {
                                                        phi_2848_ = true;
                                                        break;
                                                    }
                                                    global_8.member[_e909] = _e874[6];
                                                }
                                                if (_e340 > 7u) {
                                                    let _e914 = (_e373 + 7u);
                                                    if (_e914 < _e73) {
                                                    } else {
                                                        phi_2848_ = true;
                                                        break;
                                                    }
                                                    global_8.member[_e914] = _e874[7];
                                                    let _e918 = (_e373 + 8u);
                                                    if (_e918 < _e73) {
                                                    } else {
                                                        phi_2848_ = true;
                                                        break;
                                                    }
                                                    global_8.member[_e918] = _e874[8];
                                                    let _e922 = (_e373 + 9u);
                                                    if (_e922 < _e73) {
                                                    } else {
                                                        phi_2848_ = true;
                                                        break;
                                                    }
                                                    global_8.member[_e922] = _e874[9];
                                                }
                                            }
                                        }
                                    }
                                }
                                continue;
                                continuing {
                                    phi_1313_ = _e361;
                                    phi_2848_ = false;
                                    break if !(_e367);
                                }
                            }
                            let _e928 = phi_2848_;
                            if _e928 {
                                break;
                            }
                            if _e87 {
                            } else {
                                break;
                            }
                            let _e936 = ((bitcast<u32>((select(_e131, _e97[0], _e139) - _e141)) | bitcast<u32>((select(_e171, _e97[1], _e179) - _e181))) | bitcast<u32>((select(_e211, _e97[2], _e219) - _e221)));
                            let _e937 = (_e936 < 1024u);
                            if _e937 {
                                phi_2090_ = 0u;
                            } else {
                                phi_2090_ = select(2u, 1u, (_e936 < 2097152u));
                            }
                            let _e941 = phi_2090_;
                            switch bitcast<i32>(_e941) {
                                case 0: {
                                    phi_2096_ = 1u;
                                    break;
                                }
                                case 1: {
                                    phi_2096_ = 2u;
                                    break;
                                }
                                case 2: {
                                    phi_2096_ = 3u;
                                    break;
                                }
                                default: {
                                    phi_2096_ = u32();
                                    break;
                                }
                            }
                            let _e944 = phi_2096_;
                            let _e946 = ((3u * _e944) + 1u);
                            if _e280 {
                                phi_2106_ = ((_e230 >> bitcast<u32>(28u)) & 7u);
                            } else {
                                phi_2106_ = 0u;
                            }
                            let _e951 = phi_2106_;
                            phi_2109_ = type_8(0u, _e951);
                            loop {
                                let _e954 = phi_2109_;
                                if (_e954.member < _e954.member_1) {
                                    phi_2110_ = type_8((_e954.member + 1u), _e954.member_1);
                                    phi_2133_ = type_8(1u, _e954.member);
                                } else {
                                    phi_2110_ = _e954;
                                    phi_2133_ = type_8(0u, type_8().member_1);
                                }
                                let _e967 = phi_2110_;
                                let _e969 = phi_2133_;
                                let _e973 = (bitcast<i32>(_e969.member) != 0i);
                                if _e973 {
                                    let _e975 = ((_e230 & 268435455u) + _e969.member_1);
                                    let _e976 = (_e975 < _e63);
                                    if _e976 {
                                        let _e977 = (_e975 < _e69);
                                        if _e977 {
                                            if _e977 {
                                            } else {
                                                phi_2962_ = true;
                                                break;
                                            }
                                            let _e979 = global_6.member[_e975];
                                            if ((_e979 + _e946) <= _e73) {
                                                if _e976 {
                                                } else {
                                                    phi_2962_ = true;
                                                    break;
                                                }
                                                let _e984 = global_2.member[_e975].member_1;
                                                if _e937 {
                                                    phi_2233_ = 0u;
                                                } else {
                                                    phi_2233_ = select(2u, 1u, (_e936 < 2097152u));
                                                }
                                                let _e988 = phi_2233_;
                                                switch bitcast<i32>(_e988) {
                                                    case 0: {
                                                        let _e1387 = (f32(_e141) * _e322);
                                                        let _e1389 = (f32(_e181) * _e322);
                                                        let _e1391 = (f32(_e221) * _e322);
                                                        let _e1392 = (1f / _e322);
                                                        let _e1396 = global_2.member[_e975].member[0u];
                                                        let _e1400 = global_2.member[_e975].member[1u];
                                                        let _e1404 = global_2.member[_e975].member[2u];
                                                        let _e1408 = (1024f / _e322);
                                                        let _e1425 = global_2.member[_e975].member[3u];
                                                        let _e1429 = global_2.member[_e975].member[4u];
                                                        let _e1433 = global_2.member[_e975].member[5u];
                                                        let _e1453 = global_2.member[_e975].member[6u];
                                                        let _e1457 = global_2.member[_e975].member[7u];
                                                        let _e1461 = global_2.member[_e975].member[8u];
                                                        phi_2720_ = array<u32, 10>(((bitcast<u32>(((((_e1396 - _e1387) * _e1392) + ((_e1400 - _e1389) * _e1408)) + 8388608f)) & 4194303u) | ((bitcast<u32>((((_e1404 - _e1391) * _e1392) + 8388608f)) & 4194303u) << bitcast<u32>(20i))), ((bitcast<u32>(((((_e1425 - _e1387) * _e1392) + ((_e1429 - _e1389) * _e1408)) + 8388608f)) & 4194303u) | ((bitcast<u32>((((_e1433 - _e1391) * _e1392) + 8388608f)) & 4194303u) << bitcast<u32>(20i))), ((bitcast<u32>(((((_e1453 - _e1387) * _e1392) + ((_e1457 - _e1389) * _e1408)) + 8388608f)) & 4194303u) | ((bitcast<u32>((((_e1461 - _e1391) * _e1392) + 8388608f)) & 4194303u) << bitcast<u32>(20i))), _e984, 0u, 0u, 0u, 0u, 0u, 0u);
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1274 = (f32(_e141) * _e322);
                                                        let _e1276 = (f32(_e181) * _e322);
                                                        let _e1278 = (f32(_e221) * _e322);
                                                        let _e1279 = (1f / _e322);
                                                        let _e1283 = global_2.member[_e975].member[0u];
                                                        let _e1287 = global_2.member[_e975].member[1u];
                                                        let _e1291 = global_2.member[_e975].member[2u];
                                                        let _e1296 = (bitcast<u32>((((_e1287 - _e1276) * _e1279) + 8388608f)) & 4194303u);
                                                        let _e1318 = global_2.member[_e975].member[3u];
                                                        let _e1322 = global_2.member[_e975].member[4u];
                                                        let _e1326 = global_2.member[_e975].member[5u];
                                                        let _e1331 = (bitcast<u32>((((_e1322 - _e1276) * _e1279) + 8388608f)) & 4194303u);
                                                        let _e1353 = global_2.member[_e975].member[6u];
                                                        let _e1357 = global_2.member[_e975].member[7u];
                                                        let _e1361 = global_2.member[_e975].member[8u];
                                                        let _e1366 = (bitcast<u32>((((_e1357 - _e1276) * _e1279) + 8388608f)) & 4194303u);
                                                        phi_2720_ = array<u32, 10>(((bitcast<u32>((((_e1283 - _e1274) * _e1279) + 8388608f)) & 4194303u) | (_e1296 << bitcast<u32>(21i))), ((_e1296 >> bitcast<u32>(11i)) | ((bitcast<u32>((((_e1291 - _e1278) * _e1279) + 8388608f)) & 4194303u) << bitcast<u32>(10i))), ((bitcast<u32>((((_e1318 - _e1274) * _e1279) + 8388608f)) & 4194303u) | (_e1331 << bitcast<u32>(21i))), ((_e1331 >> bitcast<u32>(11i)) | ((bitcast<u32>((((_e1326 - _e1278) * _e1279) + 8388608f)) & 4194303u) << bitcast<u32>(10i))), ((bitcast<u32>((((_e1353 - _e1274) * _e1279) + 8388608f)) & 4194303u) | (_e1366 << bitcast<u32>(21i))), ((_e1366 >> bitcast<u32>(11i)) | ((bitcast<u32>((((_e1361 - _e1278) * _e1279) + 8388608f)) & 4194303u) << bitcast<u32>(10i))), _e984, 0u, 0u, 0u);
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e993 = global_2.member[_e975].member[0u];
                                                        let _e995 = (bitcast<u32>(_e322) & 2147483647u);
                                                        let _e996 = (_e995 >= 8388608u);
                                                        if _e996 {
                                                            phi_2430_ = (bitcast<i32>((_e995 >> bitcast<u32>(23i))) - 127i);
                                                        } else {
                                                            phi_2430_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e995)), 32u, (_e995 == 0u))));
                                                        }
                                                        let _e1009 = phi_2430_;
                                                        let _e1015 = (_e993 * bitcast<f32>((bitcast<u32>((127i - _e1009)) << bitcast<u32>(23i))));
                                                        let _e1027 = global_2.member[_e975].member[1u];
                                                        if _e996 {
                                                            phi_2464_ = (bitcast<i32>((_e995 >> bitcast<u32>(23i))) - 127i);
                                                        } else {
                                                            phi_2464_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e995)), 32u, (_e995 == 0u))));
                                                        }
                                                        let _e1040 = phi_2464_;
                                                        let _e1046 = (_e1027 * bitcast<f32>((bitcast<u32>((127i - _e1040)) << bitcast<u32>(23i))));
                                                        let _e1058 = global_2.member[_e975].member[2u];
                                                        if _e996 {
                                                            phi_2498_ = (bitcast<i32>((_e995 >> bitcast<u32>(23i))) - 127i);
                                                        } else {
                                                            phi_2498_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e995)), 32u, (_e995 == 0u))));
                                                        }
                                                        let _e1071 = phi_2498_;
                                                        let _e1077 = (_e1058 * bitcast<f32>((bitcast<u32>((127i - _e1071)) << bitcast<u32>(23i))));
                                                        let _e1089 = global_2.member[_e975].member[3u];
                                                        if _e996 {
                                                            phi_2532_ = (bitcast<i32>((_e995 >> bitcast<u32>(23i))) - 127i);
                                                        } else {
                                                            phi_2532_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e995)), 32u, (_e995 == 0u))));
                                                        }
                                                        let _e1102 = phi_2532_;
                                                        let _e1108 = (_e1089 * bitcast<f32>((bitcast<u32>((127i - _e1102)) << bitcast<u32>(23i))));
                                                        let _e1120 = global_2.member[_e975].member[4u];
                                                        if _e996 {
                                                            phi_2566_ = (bitcast<i32>((_e995 >> bitcast<u32>(23i))) - 127i);
                                                        } else {
                                                            phi_2566_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e995)), 32u, (_e995 == 0u))));
                                                        }
                                                        let _e1133 = phi_2566_;
                                                        let _e1139 = (_e1120 * bitcast<f32>((bitcast<u32>((127i - _e1133)) << bitcast<u32>(23i))));
                                                        let _e1151 = global_2.member[_e975].member[5u];
                                                        if _e996 {
                                                            phi_2600_ = (bitcast<i32>((_e995 >> bitcast<u32>(23i))) - 127i);
                                                        } else {
                                                            phi_2600_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e995)), 32u, (_e995 == 0u))));
                                                        }
                                                        let _e1164 = phi_2600_;
                                                        let _e1170 = (_e1151 * bitcast<f32>((bitcast<u32>((127i - _e1164)) << bitcast<u32>(23i))));
                                                        let _e1182 = global_2.member[_e975].member[6u];
                                                        if _e996 {
                                                            phi_2634_ = (bitcast<i32>((_e995 >> bitcast<u32>(23i))) - 127i);
                                                        } else {
                                                            phi_2634_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e995)), 32u, (_e995 == 0u))));
                                                        }
                                                        let _e1195 = phi_2634_;
                                                        let _e1201 = (_e1182 * bitcast<f32>((bitcast<u32>((127i - _e1195)) << bitcast<u32>(23i))));
                                                        let _e1213 = global_2.member[_e975].member[7u];
                                                        if _e996 {
                                                            phi_2668_ = (bitcast<i32>((_e995 >> bitcast<u32>(23i))) - 127i);
                                                        } else {
                                                            phi_2668_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e995)), 32u, (_e995 == 0u))));
                                                        }
                                                        let _e1226 = phi_2668_;
                                                        let _e1232 = (_e1213 * bitcast<f32>((bitcast<u32>((127i - _e1226)) << bitcast<u32>(23i))));
                                                        let _e1244 = global_2.member[_e975].member[8u];
                                                        if _e996 {
                                                            phi_2702_ = (bitcast<i32>((_e995 >> bitcast<u32>(23i))) - 127i);
                                                        } else {
                                                            phi_2702_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e995)), 32u, (_e995 == 0u))));
                                                        }
                                                        let _e1257 = phi_2702_;
                                                        let _e1263 = (_e1244 * bitcast<f32>((bitcast<u32>((127i - _e1257)) << bitcast<u32>(23i))));
                                                        phi_2720_ = array<u32, 10>(bitcast<u32>(select(0i, select(select(i32(_e1015), i32(-2147483648), (_e1015 < -2147483600f)), 2147483647i, (_e1015 > 2147483500f)), (_e1015 == _e1015))), bitcast<u32>(select(0i, select(select(i32(_e1046), i32(-2147483648), (_e1046 < -2147483600f)), 2147483647i, (_e1046 > 2147483500f)), (_e1046 == _e1046))), bitcast<u32>(select(0i, select(select(i32(_e1077), i32(-2147483648), (_e1077 < -2147483600f)), 2147483647i, (_e1077 > 2147483500f)), (_e1077 == _e1077))), bitcast<u32>(select(0i, select(select(i32(_e1108), i32(-2147483648), (_e1108 < -2147483600f)), 2147483647i, (_e1108 > 2147483500f)), (_e1108 == _e1108))), bitcast<u32>(select(0i, select(select(i32(_e1139), i32(-2147483648), (_e1139 < -2147483600f)), 2147483647i, (_e1139 > 2147483500f)), (_e1139 == _e1139))), bitcast<u32>(select(0i, select(select(i32(_e1170), i32(-2147483648), (_e1170 < -2147483600f)), 2147483647i, (_e1170 > 2147483500f)), (_e1170 == _e1170))), bitcast<u32>(select(0i, select(select(i32(_e1201), i32(-2147483648), (_e1201 < -2147483600f)), 2147483647i, (_e1201 > 2147483500f)), (_e1201 == _e1201))), bitcast<u32>(select(0i, select(select(i32(_e1232), i32(-2147483648), (_e1232 < -2147483600f)), 2147483647i, (_e1232 > 2147483500f)), (_e1232 == _e1232))), bitcast<u32>(select(0i, select(select(i32(_e1263), i32(-2147483648), (_e1263 < -2147483600f)), 2147483647i, (_e1263 > 2147483500f)), (_e1263 == _e1263))), _e984);
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2720_ = array<u32, 10>();
                                                        break;
                                                    }
                                                }
                                                let _e1480 = phi_2720_;
                                                if (_e979 < _e73) {
                                                } else {
                                                    phi_2962_ = true;
                                                    break;
                                                }
                                                global_8.member[_e979] = _e1480[0];
                                                let _e1494 = (_e979 + 1u);
                                                if (_e1494 < _e73) {
                                                } else {
                                                    phi_2962_ = true;
                                                    break;
                                                }
                                                global_8.member[_e1494] = _e1480[1];
                                                let _e1498 = (_e979 + 2u);
                                                if (_e1498 < _e73) {
                                                } else {
                                                    phi_2962_ = true;
                                                    break;
                                                }
                                                global_8.member[_e1498] = _e1480[2];
                                                let _e1502 = (_e979 + 3u);
                                                if (_e1502 < _e73) {
                                                } else {
                                                    phi_2962_ = true;
                                                    break;
                                                }
                                                global_8.member[_e1502] = _e1480[3];
                                                if (_e946 > 4u) {
                                                    let _e1507 = (_e979 + 4u);
                                                    if (_e1507 < _e73) {
                                                    } else {
                                                        phi_2962_ = true;
                                                        break;
                                                    }
                                                    global_8.member[_e1507] = _e1480[4];
                                                    let _e1511 = (_e979 + 5u);
                                                    if (_e1511 < _e73) {
                                                    } else {
                                                        phi_2962_ = true;
                                                        break;
                                                    }
                                                    global_8.member[_e1511] = _e1480[5];
                                                    let _e1515 = (_e979 + 6u);
                                                    if (_e1515 < _e73) {
                                                    } else {
                                                        phi_2962_ = true;
                                                        break;
                                                    }
                                                    global_8.member[_e1515] = _e1480[6];
                                                }
                                                if (_e946 > 7u) {
                                                    let _e1520 = (_e979 + 7u);
                                                    if (_e1520 < _e73) {
                                                    } else {
                                                        phi_2962_ = true;
                                                        break;
                                                    }
                                                    global_8.member[_e1520] = _e1480[7];
                                                    let _e1524 = (_e979 + 8u);
                                                    if (_e1524 < _e73) {
                                                    } else {
                                                        phi_2962_ = true;
                                                        break;
                                                    }
                                                    global_8.member[_e1524] = _e1480[8];
                                                    let _e1528 = (_e979 + 9u);
                                                    if (_e1528 < _e73) {
                                                    } else {
                                                        phi_2962_ = true;
                                                        break;
                                                    }
                                                    global_8.member[_e1528] = _e1480[9];
                                                }
                                            }
                                        }
                                    }
                                }
                                continue;
                                continuing {
                                    phi_2109_ = _e967;
                                    phi_2962_ = _e928;
                                    break if !(_e973);
                                }
                            }
                            let _e1534 = phi_2962_;
                            if _e1534 {
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
fn encode_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
