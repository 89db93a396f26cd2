struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_9 {
    member: vec4<u32>,
}

struct type_14 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_16 {
    member: array<type_14>,
}

struct type_26 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_28 {
    member: array<type_26>,
}

struct type_34 {
    member: vec3<f32>,
    member_1: vec3<f32>,
}

struct type_35 {
    member: array<u32, 4>,
    member_1: array<u32, 4>,
}

struct type_37 {
    member: array<type_35>,
}

struct type_40 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_42 {
    member: array<type_40>,
}

struct type_46 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_48 {
    member: array<type_46>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_9;
@group(0) @binding(3) 
var<storage> global_2: type_16;
@group(0) @binding(1) 
var<uniform> global_3: type_9;
@group(0) @binding(2) 
var<storage> global_4: type_28;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_42;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_48;
@group(0) @binding(6) 
var<storage, read_write> global_7: type_37;

fn function_() {
    var local: array<f32, 3>;
    var local_1: array<f32, 3>;
    var local_2: array<f32, 3>;
    var local_3: array<f32, 3>;
    var local_4: array<f32, 3>;
    var local_5: array<f32, 3>;
    var local_6: array<f32, 3>;
    var local_7: array<f32, 3>;
    var local_8: array<f32, 3>;
    var local_9: array<f32, 3>;
    var local_10: array<f32, 3>;
    var local_11: array<f32, 3>;
    var local_12: array<f32, 3>;
    var local_13: array<f32, 3>;
    var local_14: array<f32, 3>;
    var local_15: array<f32, 3>;
    var local_16: array<f32, 3>;
    var local_17: array<f32, 3>;
    var local_18: array<f32, 3>;
    var local_19: array<f32, 3>;
    var local_20: array<u32, 3>;
    var local_21: array<u32, 3>;
    var local_22: array<u32, 3>;
    var local_23: array<u32, 3>;
    var local_24: array<u32, 3>;
    var phi_193_: type_26;
    var phi_211_: type_34;
    var phi_229_: type_34;
    var phi_3632_: bool;
    var phi_292_: type_4;
    var phi_295_: u32;
    var phi_293_: type_4;
    var phi_318_: type_4;
    var phi_340_: type_26;
    var phi_348_: bool;
    var phi_366_: type_34;
    var phi_384_: type_34;
    var phi_388_: type_34;
    var phi_411_: type_4;
    var phi_414_: array<u32, 2>;
    var phi_412_: type_4;
    var phi_437_: type_4;
    var phi_476_: f32;
    var phi_497_: type_4;
    var phi_500_: u32;
    var phi_498_: type_4;
    var phi_523_: type_4;
    var phi_562_: u32;
    var phi_563_: u32;
    var phi_501_: u32;
    var phi_566_: type_4;
    var phi_569_: u32;
    var phi_567_: type_4;
    var phi_592_: type_4;
    var phi_633_: u32;
    var phi_570_: u32;
    var local_25: u32;
    var local_26: u32;
    var local_27: u32;
    var phi_685_: f32;
    var phi_706_: type_4;
    var phi_709_: u32;
    var phi_707_: type_4;
    var phi_732_: type_4;
    var phi_771_: u32;
    var phi_772_: u32;
    var phi_710_: u32;
    var phi_775_: type_4;
    var phi_778_: u32;
    var phi_776_: type_4;
    var phi_801_: type_4;
    var phi_842_: u32;
    var phi_779_: u32;
    var local_28: u32;
    var local_29: u32;
    var local_30: u32;
    var phi_903_: u32;
    var phi_905_: u32;
    var phi_906_: bool;
    var phi_415_: array<u32, 2>;
    var phi_3622_: bool;
    var phi_924_: type_4;
    var phi_925_: type_4;
    var phi_948_: type_4;
    var local_31: array<u32, 2>;
    var local_32: array<u32, 2>;
    var phi_3687_: bool;
    var phi_3697_: bool;
    var phi_1076_: u32;
    var phi_3696_: bool;
    var phi_296_: u32;
    var phi_1078_: bool;
    var phi_3695_: bool;
    var phi_1129_: type_34;
    var phi_1151_: type_34;
    var phi_1195_: type_4;
    var phi_1198_: array<u32, 2>;
    var phi_1196_: type_4;
    var phi_1221_: type_4;
    var phi_1260_: f32;
    var phi_1281_: type_4;
    var phi_1284_: u32;
    var phi_1282_: type_4;
    var phi_1307_: type_4;
    var phi_1346_: u32;
    var phi_1347_: u32;
    var phi_1285_: u32;
    var phi_1350_: type_4;
    var phi_1353_: u32;
    var phi_1351_: type_4;
    var phi_1376_: type_4;
    var phi_1417_: u32;
    var phi_1354_: u32;
    var local_33: u32;
    var local_34: u32;
    var local_35: u32;
    var phi_1469_: f32;
    var phi_1490_: type_4;
    var phi_1493_: u32;
    var phi_1491_: type_4;
    var phi_1516_: type_4;
    var phi_1555_: u32;
    var phi_1556_: u32;
    var phi_1494_: u32;
    var phi_1559_: type_4;
    var phi_1562_: u32;
    var phi_1560_: type_4;
    var phi_1585_: type_4;
    var phi_1626_: u32;
    var phi_1563_: u32;
    var local_36: u32;
    var local_37: u32;
    var local_38: u32;
    var phi_1687_: u32;
    var phi_1689_: u32;
    var phi_1690_: bool;
    var phi_1199_: array<u32, 2>;
    var phi_3699_: bool;
    var phi_1703_: type_4;
    var phi_1706_: array<u32, 2>;
    var phi_1704_: type_4;
    var phi_1729_: type_4;
    var phi_1768_: f32;
    var phi_1789_: type_4;
    var phi_1792_: u32;
    var phi_1790_: type_4;
    var phi_1815_: type_4;
    var phi_1854_: u32;
    var phi_1855_: u32;
    var phi_1793_: u32;
    var phi_1858_: type_4;
    var phi_1861_: u32;
    var phi_1859_: type_4;
    var phi_1884_: type_4;
    var phi_1925_: u32;
    var phi_1862_: u32;
    var local_39: u32;
    var local_40: u32;
    var local_41: u32;
    var phi_1977_: f32;
    var phi_1998_: type_4;
    var phi_2001_: u32;
    var phi_1999_: type_4;
    var phi_2024_: type_4;
    var phi_2063_: u32;
    var phi_2064_: u32;
    var phi_2002_: u32;
    var phi_2067_: type_4;
    var phi_2070_: u32;
    var phi_2068_: type_4;
    var phi_2093_: type_4;
    var phi_2134_: u32;
    var phi_2071_: u32;
    var local_42: u32;
    var local_43: u32;
    var local_44: u32;
    var phi_2195_: u32;
    var phi_2197_: u32;
    var phi_2198_: bool;
    var phi_1707_: array<u32, 2>;
    var phi_3750_: bool;
    var phi_2221_: type_4;
    var phi_2222_: type_4;
    var phi_2245_: type_4;
    var local_45: array<u32, 2>;
    var local_46: array<u32, 2>;
    var phi_3799_: bool;
    var phi_2362_: type_4;
    var phi_2363_: type_4;
    var phi_2386_: type_4;
    var local_47: array<u32, 2>;
    var local_48: array<u32, 2>;
    var phi_3807_: bool;
    var local_49: array<u32, 2>;
    var local_50: array<u32, 2>;
    var phi_3822_: bool;
    var phi_2574_: type_4;
    var phi_2575_: type_4;
    var phi_2598_: type_4;
    var phi_3820_: bool;
    var phi_2624_: type_4;
    var phi_2625_: type_4;
    var phi_2648_: type_4;
    var phi_2658_: type_4;
    var phi_2659_: type_4;
    var phi_2682_: type_4;
    var phi_2724_: f32;
    var phi_2745_: type_4;
    var phi_2748_: u32;
    var phi_2746_: type_4;
    var phi_2771_: type_4;
    var phi_2810_: u32;
    var phi_2811_: u32;
    var phi_2749_: u32;
    var phi_2814_: type_4;
    var phi_2817_: u32;
    var phi_2815_: type_4;
    var phi_2840_: type_4;
    var phi_2881_: u32;
    var phi_2818_: u32;
    var local_51: u32;
    var local_52: u32;
    var local_53: u32;
    var phi_2915_: u32;
    var phi_3815_: bool;
    var phi_3850_: bool;
    var phi_3849_: bool;
    var phi_3854_: bool;
    var phi_3853_: bool;
    var phi_3852_: bool;
    var phi_3851_: bool;
    var phi_3863_: bool;
    var phi_3862_: bool;
    var phi_3022_: type_4;
    var phi_3023_: type_4;
    var phi_3046_: type_4;
    var phi_3860_: bool;
    var phi_3072_: type_4;
    var phi_3073_: type_4;
    var phi_3096_: type_4;
    var phi_3106_: type_4;
    var phi_3107_: type_4;
    var phi_3130_: type_4;
    var phi_3172_: f32;
    var phi_3193_: type_4;
    var phi_3196_: u32;
    var phi_3194_: type_4;
    var phi_3219_: type_4;
    var phi_3258_: u32;
    var phi_3259_: u32;
    var phi_3197_: u32;
    var phi_3262_: type_4;
    var phi_3265_: u32;
    var phi_3263_: type_4;
    var phi_3288_: type_4;
    var phi_3329_: u32;
    var phi_3266_: u32;
    var local_54: u32;
    var local_55: u32;
    var local_56: u32;
    var phi_3363_: u32;
    var phi_3855_: bool;
    var phi_3891_: bool;
    var phi_3890_: bool;
    var phi_3895_: bool;
    var phi_3894_: bool;
    var phi_3893_: bool;
    var phi_3892_: bool;
    var local_57: u32;
    var local_58: u32;
    var local_59: u32;
    var local_60: u32;
    var local_61: u32;
    var local_62: u32;
    var local_63: u32;
    var local_64: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e72 = global;
            let _e74 = arrayLength((&global_4.member));
            let _e76 = arrayLength((&global_2.member));
            let _e80 = arrayLength((&global_6.member));
            let _e82 = arrayLength((&global_7.member));
            let _e86 = (_e72.x + (_e72.y * 2097152u));
            let _e89 = global_1.member[0u];
            if (_e86 < _e89) {
                let _e91 = (_e86 < _e74);
                if _e91 {
                    let _e92 = (_e86 < arrayLength((&global_5.member)));
                    if _e92 {
                        let _e95 = global_3.member[0u];
                        let _e96 = (0u < _e74);
                        if _e96 {
                            if _e96 {
                            } else {
                                break;
                            }
                            let _e99 = global_4.member[0u];
                            phi_193_ = _e99;
                        } else {
                            phi_193_ = type_26(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                        }
                        let _e101 = phi_193_;
                        if (_e101.member_1 == 2147483648u) {
                            phi_211_ = type_34(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        } else {
                            phi_211_ = type_34(vec3<f32>(_e101.member[0][0], _e101.member[1][0], _e101.member[2][0]), vec3<f32>(_e101.member[0][2], _e101.member[1][2], _e101.member[2][2]));
                        }
                        let _e120 = phi_211_;
                        if (_e101.member_2 == 2147483648u) {
                            phi_229_ = _e120;
                        } else {
                            phi_229_ = type_34(vec3<f32>(_e101.member[0][1], _e101.member[1][1], _e101.member[2][1]), vec3<f32>(_e101.member[0][3], _e101.member[1][3], _e101.member[2][3]));
                        }
                        let _e139 = phi_229_;
                        local_7 = array<f32, 3>(select(_e139.member.x, _e120.member.x, (_e120.member.x < _e139.member.x)), select(_e139.member.y, _e120.member.y, (_e120.member.y < _e139.member.y)), select(_e139.member.z, _e120.member.z, (_e120.member.z < _e139.member.z)));
                        local_6 = array<f32, 3>(select(_e139.member_1.x, _e120.member_1.x, (_e120.member_1.x > _e139.member_1.x)), select(_e139.member_1.y, _e120.member_1.y, (_e120.member_1.y > _e139.member_1.y)), select(_e139.member_1.z, _e120.member_1.z, (_e120.member_1.z > _e139.member_1.z)));
                        phi_3632_ = false;
                        phi_292_ = type_4(0u, 128u);
                        phi_295_ = 0u;
                        loop {
                            let _e171 = phi_3632_;
                            let _e173 = phi_292_;
                            let _e175 = phi_295_;
                            if (_e173.member < _e173.member_1) {
                                phi_293_ = type_4((_e173.member + 1u), _e173.member_1);
                                phi_318_ = type_4(1u, _e173.member);
                            } else {
                                phi_293_ = _e173;
                                phi_318_ = type_4(0u, type_4().member_1);
                            }
                            let _e188 = phi_293_;
                            let _e190 = phi_318_;
                            if (bitcast<i32>(_e190.member) != 0i) {
                                let _e194 = (_e175 == _e86);
                                if _e194 {
                                    phi_3697_ = _e171;
                                    phi_1076_ = u32();
                                } else {
                                    let _e195 = (_e175 < _e74);
                                    if _e195 {
                                        if _e195 {
                                        } else {
                                            phi_3695_ = true;
                                            break;
                                        }
                                        let _e198 = global_4.member[_e175];
                                        phi_340_ = _e198;
                                    } else {
                                        phi_340_ = type_26(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                                    }
                                    let _e200 = phi_340_;
                                    if ((_e200.member_1 & 2147483648u) != 0u) {
                                        phi_348_ = false;
                                    } else {
                                        phi_348_ = (_e86 <= _e200.member_1);
                                    }
                                    let _e206 = phi_348_;
                                    if (_e200.member_1 == 2147483648u) {
                                        phi_366_ = type_34(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                    } else {
                                        phi_366_ = type_34(vec3<f32>(_e200.member[0][0], _e200.member[1][0], _e200.member[2][0]), vec3<f32>(_e200.member[0][2], _e200.member[1][2], _e200.member[2][2]));
                                    }
                                    let _e224 = phi_366_;
                                    if (_e200.member_2 == 2147483648u) {
                                        phi_384_ = _e224;
                                    } else {
                                        phi_384_ = type_34(vec3<f32>(_e200.member[0][1], _e200.member[1][1], _e200.member[2][1]), vec3<f32>(_e200.member[0][3], _e200.member[1][3], _e200.member[2][3]));
                                    }
                                    let _e243 = phi_384_;
                                    if _e206 {
                                        phi_388_ = _e224;
                                    } else {
                                        phi_388_ = _e243;
                                    }
                                    let _e245 = phi_388_;
                                    local_9 = array<f32, 3>(_e245.member.x, _e245.member.y, _e245.member.z);
                                    local_8 = array<f32, 3>(_e245.member_1.x, _e245.member_1.y, _e245.member_1.z);
                                    phi_411_ = type_4(0u, 3u);
                                    phi_414_ = array<u32, 2>(0u, 0u);
                                    loop {
                                        let _e261 = phi_411_;
                                        let _e263 = phi_414_;
                                        local_31 = _e263;
                                        local_32 = _e263;
                                        if (_e261.member < _e261.member_1) {
                                            phi_412_ = type_4((_e261.member + 1u), _e261.member_1);
                                            phi_437_ = type_4(1u, _e261.member);
                                        } else {
                                            phi_412_ = _e261;
                                            phi_437_ = type_4(0u, type_4().member_1);
                                        }
                                        let _e276 = phi_412_;
                                        let _e278 = phi_437_;
                                        let _e282 = (bitcast<i32>(_e278.member) != 0i);
                                        if _e282 {
                                            let _e283 = (_e278.member_1 < 3u);
                                            if _e283 {
                                            } else {
                                                phi_3622_ = true;
                                                break;
                                            }
                                            let _e285 = local_7[_e278.member_1];
                                            if _e283 {
                                            } else {
                                                phi_3622_ = true;
                                                break;
                                            }
                                            let _e287 = local_6[_e278.member_1];
                                            if _e283 {
                                            } else {
                                                phi_3622_ = true;
                                                break;
                                            }
                                            let _e289 = local_9[_e278.member_1];
                                            let _e290 = (_e287 - _e285);
                                            let _e291 = (_e290 > 0f);
                                            if _e291 {
                                                phi_476_ = (((_e289 - _e285) / _e290) * 1023f);
                                            } else {
                                                phi_476_ = 0f;
                                            }
                                            let _e296 = phi_476_;
                                            let _e298 = select(1023f, _e296, (_e296 < 1023f));
                                            let _e300 = select(0f, _e298, (_e298 > 0f));
                                            phi_497_ = type_4(0u, 3u);
                                            phi_500_ = select(select(u32(_e300), 0u, (_e300 < 0f)), 4294967295u, (_e300 > 4294967000f));
                                            loop {
                                                let _e307 = phi_497_;
                                                let _e309 = phi_500_;
                                                local_57 = _e309;
                                                if (_e307.member < _e307.member_1) {
                                                    phi_498_ = type_4((_e307.member + 1u), _e307.member_1);
                                                    phi_523_ = type_4(1u, _e307.member);
                                                } else {
                                                    phi_498_ = _e307;
                                                    phi_523_ = type_4(0u, type_4().member_1);
                                                }
                                                let _e322 = phi_498_;
                                                let _e324 = phi_523_;
                                                let _e327 = (bitcast<i32>(_e324.member) != 0i);
                                                if _e327 {
                                                    if (_e309 > 0u) {
                                                        let _e338 = (_e285 + bitcast<f32>((bitcast<u32>((f32(_e309) * bitcast<f32>((bitcast<u32>((_e290 * 0.0009775171f)) ^ _e95)))) ^ _e95)));
                                                        if (select(select(_e287, _e338, (_e338 < _e287)), _e287, (_e309 == 1023u)) > _e289) {
                                                            phi_562_ = (_e309 - 1u);
                                                        } else {
                                                            phi_562_ = _e309;
                                                        }
                                                        let _e346 = phi_562_;
                                                        phi_563_ = _e346;
                                                    } else {
                                                        phi_563_ = _e309;
                                                    }
                                                    let _e348 = phi_563_;
                                                    phi_501_ = _e348;
                                                } else {
                                                    phi_501_ = u32();
                                                }
                                                let _e350 = phi_501_;
                                                continue;
                                                continuing {
                                                    phi_497_ = _e322;
                                                    phi_500_ = _e350;
                                                    break if !(_e327);
                                                }
                                            }
                                            phi_566_ = type_4(0u, 3u);
                                            let _e2167 = local_57;
                                            phi_569_ = _e2167;
                                            loop {
                                                let _e353 = phi_566_;
                                                let _e355 = phi_569_;
                                                local_25 = _e355;
                                                local_26 = _e355;
                                                local_27 = _e355;
                                                if (_e353.member < _e353.member_1) {
                                                    phi_567_ = type_4((_e353.member + 1u), _e353.member_1);
                                                    phi_592_ = type_4(1u, _e353.member);
                                                } else {
                                                    phi_567_ = _e353;
                                                    phi_592_ = type_4(0u, type_4().member_1);
                                                }
                                                let _e368 = phi_567_;
                                                let _e370 = phi_592_;
                                                let _e373 = (bitcast<i32>(_e370.member) != 0i);
                                                if _e373 {
                                                    if (_e355 < 1023u) {
                                                        let _e375 = (_e355 + 1u);
                                                        let _e385 = (_e285 + bitcast<f32>((bitcast<u32>((f32(_e375) * bitcast<f32>((bitcast<u32>((_e290 * 0.0009775171f)) ^ _e95)))) ^ _e95)));
                                                        phi_633_ = select(_e355, _e375, (select(select(_e287, _e385, (_e385 < _e287)), _e287, (_e375 == 1023u)) <= _e289));
                                                    } else {
                                                        phi_633_ = _e355;
                                                    }
                                                    let _e393 = phi_633_;
                                                    phi_570_ = _e393;
                                                } else {
                                                    phi_570_ = u32();
                                                }
                                                let _e395 = phi_570_;
                                                continue;
                                                continuing {
                                                    phi_566_ = _e368;
                                                    phi_569_ = _e395;
                                                    break if !(_e373);
                                                }
                                            }
                                            let _e400 = bitcast<f32>((bitcast<u32>((_e290 * 0.0009775171f)) ^ _e95));
                                            let _e402 = local_25;
                                            let _e408 = (_e285 + bitcast<f32>((bitcast<u32>((f32(_e402) * _e400)) ^ _e95)));
                                            let _e412 = local_26;
                                            let _e417 = local_27;
                                            let _e420 = ((10u * _e278.member_1) & 31u);
                                            if _e283 {
                                            } else {
                                                phi_3622_ = true;
                                                break;
                                            }
                                            let _e426 = local_8[_e278.member_1];
                                            if _e291 {
                                                phi_685_ = (((_e426 - _e285) / _e290) * 1023f);
                                            } else {
                                                phi_685_ = 0f;
                                            }
                                            let _e431 = phi_685_;
                                            let _e433 = select(1023f, _e431, (_e431 < 1023f));
                                            let _e435 = select(0f, _e433, (_e433 > 0f));
                                            phi_706_ = type_4(0u, 3u);
                                            phi_709_ = select(select(u32(_e435), 0u, (_e435 < 0f)), 4294967295u, (_e435 > 4294967000f));
                                            loop {
                                                let _e442 = phi_706_;
                                                let _e444 = phi_709_;
                                                local_58 = _e444;
                                                if (_e442.member < _e442.member_1) {
                                                    phi_707_ = type_4((_e442.member + 1u), _e442.member_1);
                                                    phi_732_ = type_4(1u, _e442.member);
                                                } else {
                                                    phi_707_ = _e442;
                                                    phi_732_ = type_4(0u, type_4().member_1);
                                                }
                                                let _e457 = phi_707_;
                                                let _e459 = phi_732_;
                                                let _e462 = (bitcast<i32>(_e459.member) != 0i);
                                                if _e462 {
                                                    if (_e444 > 0u) {
                                                        let _e469 = (_e285 + bitcast<f32>((bitcast<u32>((f32(_e444) * _e400)) ^ _e95)));
                                                        if (select(select(_e287, _e469, (_e469 < _e287)), _e287, (_e444 == 1023u)) > _e426) {
                                                            phi_771_ = (_e444 - 1u);
                                                        } else {
                                                            phi_771_ = _e444;
                                                        }
                                                        let _e477 = phi_771_;
                                                        phi_772_ = _e477;
                                                    } else {
                                                        phi_772_ = _e444;
                                                    }
                                                    let _e479 = phi_772_;
                                                    phi_710_ = _e479;
                                                } else {
                                                    phi_710_ = u32();
                                                }
                                                let _e481 = phi_710_;
                                                continue;
                                                continuing {
                                                    phi_706_ = _e457;
                                                    phi_709_ = _e481;
                                                    break if !(_e462);
                                                }
                                            }
                                            phi_775_ = type_4(0u, 3u);
                                            let _e2186 = local_58;
                                            phi_778_ = _e2186;
                                            loop {
                                                let _e484 = phi_775_;
                                                let _e486 = phi_778_;
                                                local_28 = _e486;
                                                local_29 = _e486;
                                                local_30 = _e486;
                                                if (_e484.member < _e484.member_1) {
                                                    phi_776_ = type_4((_e484.member + 1u), _e484.member_1);
                                                    phi_801_ = type_4(1u, _e484.member);
                                                } else {
                                                    phi_776_ = _e484;
                                                    phi_801_ = type_4(0u, type_4().member_1);
                                                }
                                                let _e499 = phi_776_;
                                                let _e501 = phi_801_;
                                                let _e504 = (bitcast<i32>(_e501.member) != 0i);
                                                if _e504 {
                                                    if (_e486 < 1023u) {
                                                        let _e506 = (_e486 + 1u);
                                                        let _e512 = (_e285 + bitcast<f32>((bitcast<u32>((f32(_e506) * _e400)) ^ _e95)));
                                                        phi_842_ = select(_e486, _e506, (select(select(_e287, _e512, (_e512 < _e287)), _e287, (_e506 == 1023u)) <= _e426));
                                                    } else {
                                                        phi_842_ = _e486;
                                                    }
                                                    let _e520 = phi_842_;
                                                    phi_779_ = _e520;
                                                } else {
                                                    phi_779_ = u32();
                                                }
                                                let _e522 = phi_779_;
                                                continue;
                                                continuing {
                                                    phi_775_ = _e499;
                                                    phi_778_ = _e522;
                                                    break if !(_e504);
                                                }
                                            }
                                            let _e525 = local_28;
                                            let _e531 = (_e285 + bitcast<f32>((bitcast<u32>((f32(_e525) * _e400)) ^ _e95)));
                                            let _e535 = local_29;
                                            let _e540 = local_30;
                                            let _e541 = select(_e540, 0u, (select(select(_e287, _e531, (_e531 < _e287)), _e287, (_e535 == 1023u)) > _e426));
                                            if (_e541 < 1023u) {
                                                let _e548 = (_e285 + bitcast<f32>((bitcast<u32>((f32(_e541) * _e400)) ^ _e95)));
                                                let _e553 = (select(select(_e287, _e548, (_e548 < _e287)), _e287, (_e541 == 1023u)) < _e426);
                                                if _e553 {
                                                    phi_903_ = (_e541 + 1u);
                                                } else {
                                                    phi_903_ = u32();
                                                }
                                                let _e556 = phi_903_;
                                                phi_905_ = _e556;
                                                phi_906_ = select(true, false, _e553);
                                            } else {
                                                phi_905_ = u32();
                                                phi_906_ = true;
                                            }
                                            let _e559 = phi_905_;
                                            let _e561 = phi_906_;
                                            phi_415_ = array<u32, 2>((_e263[0] | (select(_e417, 0u, (select(select(_e287, _e408, (_e408 < _e287)), _e287, (_e412 == 1023u)) > _e289)) << bitcast<u32>(_e420))), (_e263[1] | (select(_e559, _e541, _e561) << bitcast<u32>(_e420))));
                                        } else {
                                            phi_415_ = array<u32, 2>();
                                        }
                                        let _e569 = phi_415_;
                                        continue;
                                        continuing {
                                            phi_411_ = _e276;
                                            phi_414_ = _e569;
                                            phi_3622_ = _e171;
                                            break if !(_e282);
                                        }
                                    }
                                    let _e572 = phi_3622_;
                                    phi_3695_ = _e572;
                                    if _e572 {
                                        break;
                                    }
                                    local_24 = array<u32, 3>(0u, 1u, 2u);
                                    local_11 = array<f32, 3>(0f, 0f, 0f);
                                    local_10 = array<f32, 3>(0f, 0f, 0f);
                                    phi_924_ = type_4(0u, 3u);
                                    loop {
                                        let _e574 = phi_924_;
                                        if (_e574.member < _e574.member_1) {
                                            phi_925_ = type_4((_e574.member + 1u), _e574.member_1);
                                            phi_948_ = type_4(1u, _e574.member);
                                        } else {
                                            phi_925_ = _e574;
                                            phi_948_ = type_4(0u, type_4().member_1);
                                        }
                                        let _e587 = phi_925_;
                                        let _e589 = phi_948_;
                                        let _e593 = (bitcast<i32>(_e589.member) != 0i);
                                        if _e593 {
                                            let _e594 = (_e589.member_1 < 3u);
                                            if _e594 {
                                            } else {
                                                phi_3687_ = true;
                                                break;
                                            }
                                            let _e596 = local_24[_e589.member_1];
                                            if _e594 {
                                            } else {
                                                phi_3687_ = true;
                                                break;
                                            }
                                            let _e598 = local_7[_e589.member_1];
                                            if _e594 {
                                            } else {
                                                phi_3687_ = true;
                                                break;
                                            }
                                            let _e600 = local_6[_e589.member_1];
                                            let _e602 = local_31;
                                            let _e605 = ((10u * _e596) & 31u);
                                            let _e608 = ((_e602[0] >> bitcast<u32>(_e605)) & 1023u);
                                            let _e613 = bitcast<f32>((bitcast<u32>(((_e600 - _e598) * 0.0009775171f)) ^ _e95));
                                            let _e619 = (_e598 + bitcast<f32>((bitcast<u32>((f32(_e608) * _e613)) ^ _e95)));
                                            if _e594 {
                                            } else {
                                                phi_3687_ = true;
                                                break;
                                            }
                                            local_11[_e589.member_1] = select(select(_e600, _e619, (_e619 < _e600)), _e600, (_e608 == 1023u));
                                            let _e626 = local_32;
                                            let _e630 = ((_e626[1] >> bitcast<u32>(_e605)) & 1023u);
                                            let _e636 = (_e598 + bitcast<f32>((bitcast<u32>((f32(_e630) * _e613)) ^ _e95)));
                                            if _e594 {
                                            } else {
                                                phi_3687_ = true;
                                                break;
                                            }
                                            local_10[_e589.member_1] = select(select(_e600, _e636, (_e636 < _e600)), _e600, (_e630 == 1023u));
                                        }
                                        continue;
                                        continuing {
                                            phi_924_ = _e587;
                                            phi_3687_ = _e572;
                                            break if !(_e593);
                                        }
                                    }
                                    let _e644 = phi_3687_;
                                    phi_3695_ = _e644;
                                    if _e644 {
                                        break;
                                    }
                                    let _e645 = local_10;
                                    let _e646 = local_11;
                                    local_7 = _e646;
                                    local_6 = _e645;
                                    phi_3697_ = _e644;
                                    phi_1076_ = select(_e200.member_2, _e200.member_1, _e206);
                                }
                                let _e649 = phi_3697_;
                                let _e651 = phi_1076_;
                                phi_3696_ = _e649;
                                phi_296_ = _e651;
                                phi_1078_ = select(true, false, _e194);
                            } else {
                                phi_3696_ = _e171;
                                phi_296_ = u32();
                                phi_1078_ = false;
                            }
                            let _e654 = phi_3696_;
                            let _e656 = phi_296_;
                            let _e658 = phi_1078_;
                            continue;
                            continuing {
                                phi_3632_ = _e654;
                                phi_292_ = _e188;
                                phi_295_ = _e656;
                                phi_3695_ = _e654;
                                break if !(_e658);
                            }
                        }
                        let _e661 = phi_3695_;
                        if _e661 {
                            break;
                        }
                        let _e662 = local_6;
                        let _e663 = local_7;
                        local_5 = _e663;
                        local_4 = _e662;
                        if _e91 {
                        } else {
                            break;
                        }
                        let _e667 = global_4.member[_e86].member_1;
                        if (_e667 == 2147483648u) {
                            phi_1129_ = type_34(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        } else {
                            let _e673 = global_4.member[_e86].member[0u];
                            let _e678 = global_4.member[_e86].member[1u];
                            let _e683 = global_4.member[_e86].member[2u];
                            phi_1129_ = type_34(vec3<f32>(_e673[0], _e678[0], _e683[0]), vec3<f32>(_e673[2], _e678[2], _e683[2]));
                        }
                        let _e694 = phi_1129_;
                        let _e698 = global_4.member[_e86].member_2;
                        if (_e698 == 2147483648u) {
                            phi_1151_ = _e694;
                        } else {
                            let _e704 = global_4.member[_e86].member[0u];
                            let _e709 = global_4.member[_e86].member[1u];
                            let _e714 = global_4.member[_e86].member[2u];
                            phi_1151_ = type_34(vec3<f32>(_e704[1], _e709[1], _e714[1]), vec3<f32>(_e704[3], _e709[3], _e714[3]));
                        }
                        let _e725 = phi_1151_;
                        local_15 = array<f32, 3>(_e694.member.x, _e694.member.y, _e694.member.z);
                        local_14 = array<f32, 3>(_e694.member_1.x, _e694.member_1.y, _e694.member_1.z);
                        local_13 = array<f32, 3>(_e725.member.x, _e725.member.y, _e725.member.z);
                        local_12 = array<f32, 3>(_e725.member_1.x, _e725.member_1.y, _e725.member_1.z);
                        phi_1195_ = type_4(0u, 3u);
                        phi_1198_ = array<u32, 2>(0u, 0u);
                        loop {
                            let _e755 = phi_1195_;
                            let _e757 = phi_1198_;
                            local_45 = _e757;
                            local_46 = _e757;
                            local_49 = _e757;
                            if (_e755.member < _e755.member_1) {
                                phi_1196_ = type_4((_e755.member + 1u), _e755.member_1);
                                phi_1221_ = type_4(1u, _e755.member);
                            } else {
                                phi_1196_ = _e755;
                                phi_1221_ = type_4(0u, type_4().member_1);
                            }
                            let _e770 = phi_1196_;
                            let _e772 = phi_1221_;
                            let _e776 = (bitcast<i32>(_e772.member) != 0i);
                            if _e776 {
                                let _e777 = (_e772.member_1 < 3u);
                                if _e777 {
                                } else {
                                    phi_3699_ = true;
                                    break;
                                }
                                let _e779 = local_5[_e772.member_1];
                                if _e777 {
                                } else {
                                    phi_3699_ = true;
                                    break;
                                }
                                let _e781 = local_4[_e772.member_1];
                                if _e777 {
                                } else {
                                    phi_3699_ = true;
                                    break;
                                }
                                let _e783 = local_15[_e772.member_1];
                                let _e784 = (_e781 - _e779);
                                let _e785 = (_e784 > 0f);
                                if _e785 {
                                    phi_1260_ = (((_e783 - _e779) / _e784) * 1023f);
                                } else {
                                    phi_1260_ = 0f;
                                }
                                let _e790 = phi_1260_;
                                let _e792 = select(1023f, _e790, (_e790 < 1023f));
                                let _e794 = select(0f, _e792, (_e792 > 0f));
                                phi_1281_ = type_4(0u, 3u);
                                phi_1284_ = select(select(u32(_e794), 0u, (_e794 < 0f)), 4294967295u, (_e794 > 4294967000f));
                                loop {
                                    let _e801 = phi_1281_;
                                    let _e803 = phi_1284_;
                                    local_59 = _e803;
                                    if (_e801.member < _e801.member_1) {
                                        phi_1282_ = type_4((_e801.member + 1u), _e801.member_1);
                                        phi_1307_ = type_4(1u, _e801.member);
                                    } else {
                                        phi_1282_ = _e801;
                                        phi_1307_ = type_4(0u, type_4().member_1);
                                    }
                                    let _e816 = phi_1282_;
                                    let _e818 = phi_1307_;
                                    let _e821 = (bitcast<i32>(_e818.member) != 0i);
                                    if _e821 {
                                        if (_e803 > 0u) {
                                            let _e832 = (_e779 + bitcast<f32>((bitcast<u32>((f32(_e803) * bitcast<f32>((bitcast<u32>((_e784 * 0.0009775171f)) ^ _e95)))) ^ _e95)));
                                            if (select(select(_e781, _e832, (_e832 < _e781)), _e781, (_e803 == 1023u)) > _e783) {
                                                phi_1346_ = (_e803 - 1u);
                                            } else {
                                                phi_1346_ = _e803;
                                            }
                                            let _e840 = phi_1346_;
                                            phi_1347_ = _e840;
                                        } else {
                                            phi_1347_ = _e803;
                                        }
                                        let _e842 = phi_1347_;
                                        phi_1285_ = _e842;
                                    } else {
                                        phi_1285_ = u32();
                                    }
                                    let _e844 = phi_1285_;
                                    continue;
                                    continuing {
                                        phi_1281_ = _e816;
                                        phi_1284_ = _e844;
                                        break if !(_e821);
                                    }
                                }
                                phi_1350_ = type_4(0u, 3u);
                                let _e2228 = local_59;
                                phi_1353_ = _e2228;
                                loop {
                                    let _e847 = phi_1350_;
                                    let _e849 = phi_1353_;
                                    local_33 = _e849;
                                    local_34 = _e849;
                                    local_35 = _e849;
                                    if (_e847.member < _e847.member_1) {
                                        phi_1351_ = type_4((_e847.member + 1u), _e847.member_1);
                                        phi_1376_ = type_4(1u, _e847.member);
                                    } else {
                                        phi_1351_ = _e847;
                                        phi_1376_ = type_4(0u, type_4().member_1);
                                    }
                                    let _e862 = phi_1351_;
                                    let _e864 = phi_1376_;
                                    let _e867 = (bitcast<i32>(_e864.member) != 0i);
                                    if _e867 {
                                        if (_e849 < 1023u) {
                                            let _e869 = (_e849 + 1u);
                                            let _e879 = (_e779 + bitcast<f32>((bitcast<u32>((f32(_e869) * bitcast<f32>((bitcast<u32>((_e784 * 0.0009775171f)) ^ _e95)))) ^ _e95)));
                                            phi_1417_ = select(_e849, _e869, (select(select(_e781, _e879, (_e879 < _e781)), _e781, (_e869 == 1023u)) <= _e783));
                                        } else {
                                            phi_1417_ = _e849;
                                        }
                                        let _e887 = phi_1417_;
                                        phi_1354_ = _e887;
                                    } else {
                                        phi_1354_ = u32();
                                    }
                                    let _e889 = phi_1354_;
                                    continue;
                                    continuing {
                                        phi_1350_ = _e862;
                                        phi_1353_ = _e889;
                                        break if !(_e867);
                                    }
                                }
                                let _e894 = bitcast<f32>((bitcast<u32>((_e784 * 0.0009775171f)) ^ _e95));
                                let _e896 = local_33;
                                let _e902 = (_e779 + bitcast<f32>((bitcast<u32>((f32(_e896) * _e894)) ^ _e95)));
                                let _e906 = local_34;
                                let _e911 = local_35;
                                let _e914 = ((10u * _e772.member_1) & 31u);
                                if _e777 {
                                } else {
                                    phi_3699_ = true;
                                    break;
                                }
                                let _e920 = local_14[_e772.member_1];
                                if _e785 {
                                    phi_1469_ = (((_e920 - _e779) / _e784) * 1023f);
                                } else {
                                    phi_1469_ = 0f;
                                }
                                let _e925 = phi_1469_;
                                let _e927 = select(1023f, _e925, (_e925 < 1023f));
                                let _e929 = select(0f, _e927, (_e927 > 0f));
                                phi_1490_ = type_4(0u, 3u);
                                phi_1493_ = select(select(u32(_e929), 0u, (_e929 < 0f)), 4294967295u, (_e929 > 4294967000f));
                                loop {
                                    let _e936 = phi_1490_;
                                    let _e938 = phi_1493_;
                                    local_60 = _e938;
                                    if (_e936.member < _e936.member_1) {
                                        phi_1491_ = type_4((_e936.member + 1u), _e936.member_1);
                                        phi_1516_ = type_4(1u, _e936.member);
                                    } else {
                                        phi_1491_ = _e936;
                                        phi_1516_ = type_4(0u, type_4().member_1);
                                    }
                                    let _e951 = phi_1491_;
                                    let _e953 = phi_1516_;
                                    let _e956 = (bitcast<i32>(_e953.member) != 0i);
                                    if _e956 {
                                        if (_e938 > 0u) {
                                            let _e963 = (_e779 + bitcast<f32>((bitcast<u32>((f32(_e938) * _e894)) ^ _e95)));
                                            if (select(select(_e781, _e963, (_e963 < _e781)), _e781, (_e938 == 1023u)) > _e920) {
                                                phi_1555_ = (_e938 - 1u);
                                            } else {
                                                phi_1555_ = _e938;
                                            }
                                            let _e971 = phi_1555_;
                                            phi_1556_ = _e971;
                                        } else {
                                            phi_1556_ = _e938;
                                        }
                                        let _e973 = phi_1556_;
                                        phi_1494_ = _e973;
                                    } else {
                                        phi_1494_ = u32();
                                    }
                                    let _e975 = phi_1494_;
                                    continue;
                                    continuing {
                                        phi_1490_ = _e951;
                                        phi_1493_ = _e975;
                                        break if !(_e956);
                                    }
                                }
                                phi_1559_ = type_4(0u, 3u);
                                let _e2247 = local_60;
                                phi_1562_ = _e2247;
                                loop {
                                    let _e978 = phi_1559_;
                                    let _e980 = phi_1562_;
                                    local_36 = _e980;
                                    local_37 = _e980;
                                    local_38 = _e980;
                                    if (_e978.member < _e978.member_1) {
                                        phi_1560_ = type_4((_e978.member + 1u), _e978.member_1);
                                        phi_1585_ = type_4(1u, _e978.member);
                                    } else {
                                        phi_1560_ = _e978;
                                        phi_1585_ = type_4(0u, type_4().member_1);
                                    }
                                    let _e993 = phi_1560_;
                                    let _e995 = phi_1585_;
                                    let _e998 = (bitcast<i32>(_e995.member) != 0i);
                                    if _e998 {
                                        if (_e980 < 1023u) {
                                            let _e1000 = (_e980 + 1u);
                                            let _e1006 = (_e779 + bitcast<f32>((bitcast<u32>((f32(_e1000) * _e894)) ^ _e95)));
                                            phi_1626_ = select(_e980, _e1000, (select(select(_e781, _e1006, (_e1006 < _e781)), _e781, (_e1000 == 1023u)) <= _e920));
                                        } else {
                                            phi_1626_ = _e980;
                                        }
                                        let _e1014 = phi_1626_;
                                        phi_1563_ = _e1014;
                                    } else {
                                        phi_1563_ = u32();
                                    }
                                    let _e1016 = phi_1563_;
                                    continue;
                                    continuing {
                                        phi_1559_ = _e993;
                                        phi_1562_ = _e1016;
                                        break if !(_e998);
                                    }
                                }
                                let _e1019 = local_36;
                                let _e1025 = (_e779 + bitcast<f32>((bitcast<u32>((f32(_e1019) * _e894)) ^ _e95)));
                                let _e1029 = local_37;
                                let _e1034 = local_38;
                                let _e1035 = select(_e1034, 0u, (select(select(_e781, _e1025, (_e1025 < _e781)), _e781, (_e1029 == 1023u)) > _e920));
                                if (_e1035 < 1023u) {
                                    let _e1042 = (_e779 + bitcast<f32>((bitcast<u32>((f32(_e1035) * _e894)) ^ _e95)));
                                    let _e1047 = (select(select(_e781, _e1042, (_e1042 < _e781)), _e781, (_e1035 == 1023u)) < _e920);
                                    if _e1047 {
                                        phi_1687_ = (_e1035 + 1u);
                                    } else {
                                        phi_1687_ = u32();
                                    }
                                    let _e1050 = phi_1687_;
                                    phi_1689_ = _e1050;
                                    phi_1690_ = select(true, false, _e1047);
                                } else {
                                    phi_1689_ = u32();
                                    phi_1690_ = true;
                                }
                                let _e1053 = phi_1689_;
                                let _e1055 = phi_1690_;
                                phi_1199_ = array<u32, 2>((_e757[0] | (select(_e911, 0u, (select(select(_e781, _e902, (_e902 < _e781)), _e781, (_e906 == 1023u)) > _e783)) << bitcast<u32>(_e914))), (_e757[1] | (select(_e1053, _e1035, _e1055) << bitcast<u32>(_e914))));
                            } else {
                                phi_1199_ = array<u32, 2>();
                            }
                            let _e1063 = phi_1199_;
                            continue;
                            continuing {
                                phi_1195_ = _e770;
                                phi_1198_ = _e1063;
                                phi_3699_ = _e661;
                                break if !(_e776);
                            }
                        }
                        let _e1066 = phi_3699_;
                        if _e1066 {
                            break;
                        }
                        phi_1703_ = type_4(0u, 3u);
                        phi_1706_ = array<u32, 2>(0u, 0u);
                        loop {
                            let _e1068 = phi_1703_;
                            let _e1070 = phi_1706_;
                            local_47 = _e1070;
                            local_48 = _e1070;
                            local_50 = _e1070;
                            if (_e1068.member < _e1068.member_1) {
                                phi_1704_ = type_4((_e1068.member + 1u), _e1068.member_1);
                                phi_1729_ = type_4(1u, _e1068.member);
                            } else {
                                phi_1704_ = _e1068;
                                phi_1729_ = type_4(0u, type_4().member_1);
                            }
                            let _e1083 = phi_1704_;
                            let _e1085 = phi_1729_;
                            let _e1089 = (bitcast<i32>(_e1085.member) != 0i);
                            if _e1089 {
                                let _e1090 = (_e1085.member_1 < 3u);
                                if _e1090 {
                                } else {
                                    phi_3750_ = true;
                                    break;
                                }
                                let _e1092 = local_5[_e1085.member_1];
                                if _e1090 {
                                } else {
                                    phi_3750_ = true;
                                    break;
                                }
                                let _e1094 = local_4[_e1085.member_1];
                                if _e1090 {
                                } else {
                                    phi_3750_ = true;
                                    break;
                                }
                                let _e1096 = local_13[_e1085.member_1];
                                let _e1097 = (_e1094 - _e1092);
                                let _e1098 = (_e1097 > 0f);
                                if _e1098 {
                                    phi_1768_ = (((_e1096 - _e1092) / _e1097) * 1023f);
                                } else {
                                    phi_1768_ = 0f;
                                }
                                let _e1103 = phi_1768_;
                                let _e1105 = select(1023f, _e1103, (_e1103 < 1023f));
                                let _e1107 = select(0f, _e1105, (_e1105 > 0f));
                                phi_1789_ = type_4(0u, 3u);
                                phi_1792_ = select(select(u32(_e1107), 0u, (_e1107 < 0f)), 4294967295u, (_e1107 > 4294967000f));
                                loop {
                                    let _e1114 = phi_1789_;
                                    let _e1116 = phi_1792_;
                                    local_61 = _e1116;
                                    if (_e1114.member < _e1114.member_1) {
                                        phi_1790_ = type_4((_e1114.member + 1u), _e1114.member_1);
                                        phi_1815_ = type_4(1u, _e1114.member);
                                    } else {
                                        phi_1790_ = _e1114;
                                        phi_1815_ = type_4(0u, type_4().member_1);
                                    }
                                    let _e1129 = phi_1790_;
                                    let _e1131 = phi_1815_;
                                    let _e1134 = (bitcast<i32>(_e1131.member) != 0i);
                                    if _e1134 {
                                        if (_e1116 > 0u) {
                                            let _e1145 = (_e1092 + bitcast<f32>((bitcast<u32>((f32(_e1116) * bitcast<f32>((bitcast<u32>((_e1097 * 0.0009775171f)) ^ _e95)))) ^ _e95)));
                                            if (select(select(_e1094, _e1145, (_e1145 < _e1094)), _e1094, (_e1116 == 1023u)) > _e1096) {
                                                phi_1854_ = (_e1116 - 1u);
                                            } else {
                                                phi_1854_ = _e1116;
                                            }
                                            let _e1153 = phi_1854_;
                                            phi_1855_ = _e1153;
                                        } else {
                                            phi_1855_ = _e1116;
                                        }
                                        let _e1155 = phi_1855_;
                                        phi_1793_ = _e1155;
                                    } else {
                                        phi_1793_ = u32();
                                    }
                                    let _e1157 = phi_1793_;
                                    continue;
                                    continuing {
                                        phi_1789_ = _e1129;
                                        phi_1792_ = _e1157;
                                        break if !(_e1134);
                                    }
                                }
                                phi_1858_ = type_4(0u, 3u);
                                let _e2275 = local_61;
                                phi_1861_ = _e2275;
                                loop {
                                    let _e1160 = phi_1858_;
                                    let _e1162 = phi_1861_;
                                    local_39 = _e1162;
                                    local_40 = _e1162;
                                    local_41 = _e1162;
                                    if (_e1160.member < _e1160.member_1) {
                                        phi_1859_ = type_4((_e1160.member + 1u), _e1160.member_1);
                                        phi_1884_ = type_4(1u, _e1160.member);
                                    } else {
                                        phi_1859_ = _e1160;
                                        phi_1884_ = type_4(0u, type_4().member_1);
                                    }
                                    let _e1175 = phi_1859_;
                                    let _e1177 = phi_1884_;
                                    let _e1180 = (bitcast<i32>(_e1177.member) != 0i);
                                    if _e1180 {
                                        if (_e1162 < 1023u) {
                                            let _e1182 = (_e1162 + 1u);
                                            let _e1192 = (_e1092 + bitcast<f32>((bitcast<u32>((f32(_e1182) * bitcast<f32>((bitcast<u32>((_e1097 * 0.0009775171f)) ^ _e95)))) ^ _e95)));
                                            phi_1925_ = select(_e1162, _e1182, (select(select(_e1094, _e1192, (_e1192 < _e1094)), _e1094, (_e1182 == 1023u)) <= _e1096));
                                        } else {
                                            phi_1925_ = _e1162;
                                        }
                                        let _e1200 = phi_1925_;
                                        phi_1862_ = _e1200;
                                    } else {
                                        phi_1862_ = u32();
                                    }
                                    let _e1202 = phi_1862_;
                                    continue;
                                    continuing {
                                        phi_1858_ = _e1175;
                                        phi_1861_ = _e1202;
                                        break if !(_e1180);
                                    }
                                }
                                let _e1207 = bitcast<f32>((bitcast<u32>((_e1097 * 0.0009775171f)) ^ _e95));
                                let _e1209 = local_39;
                                let _e1215 = (_e1092 + bitcast<f32>((bitcast<u32>((f32(_e1209) * _e1207)) ^ _e95)));
                                let _e1219 = local_40;
                                let _e1224 = local_41;
                                let _e1227 = ((10u * _e1085.member_1) & 31u);
                                if _e1090 {
                                } else {
                                    phi_3750_ = true;
                                    break;
                                }
                                let _e1233 = local_12[_e1085.member_1];
                                if _e1098 {
                                    phi_1977_ = (((_e1233 - _e1092) / _e1097) * 1023f);
                                } else {
                                    phi_1977_ = 0f;
                                }
                                let _e1238 = phi_1977_;
                                let _e1240 = select(1023f, _e1238, (_e1238 < 1023f));
                                let _e1242 = select(0f, _e1240, (_e1240 > 0f));
                                phi_1998_ = type_4(0u, 3u);
                                phi_2001_ = select(select(u32(_e1242), 0u, (_e1242 < 0f)), 4294967295u, (_e1242 > 4294967000f));
                                loop {
                                    let _e1249 = phi_1998_;
                                    let _e1251 = phi_2001_;
                                    local_62 = _e1251;
                                    if (_e1249.member < _e1249.member_1) {
                                        phi_1999_ = type_4((_e1249.member + 1u), _e1249.member_1);
                                        phi_2024_ = type_4(1u, _e1249.member);
                                    } else {
                                        phi_1999_ = _e1249;
                                        phi_2024_ = type_4(0u, type_4().member_1);
                                    }
                                    let _e1264 = phi_1999_;
                                    let _e1266 = phi_2024_;
                                    let _e1269 = (bitcast<i32>(_e1266.member) != 0i);
                                    if _e1269 {
                                        if (_e1251 > 0u) {
                                            let _e1276 = (_e1092 + bitcast<f32>((bitcast<u32>((f32(_e1251) * _e1207)) ^ _e95)));
                                            if (select(select(_e1094, _e1276, (_e1276 < _e1094)), _e1094, (_e1251 == 1023u)) > _e1233) {
                                                phi_2063_ = (_e1251 - 1u);
                                            } else {
                                                phi_2063_ = _e1251;
                                            }
                                            let _e1284 = phi_2063_;
                                            phi_2064_ = _e1284;
                                        } else {
                                            phi_2064_ = _e1251;
                                        }
                                        let _e1286 = phi_2064_;
                                        phi_2002_ = _e1286;
                                    } else {
                                        phi_2002_ = u32();
                                    }
                                    let _e1288 = phi_2002_;
                                    continue;
                                    continuing {
                                        phi_1998_ = _e1264;
                                        phi_2001_ = _e1288;
                                        break if !(_e1269);
                                    }
                                }
                                phi_2067_ = type_4(0u, 3u);
                                let _e2294 = local_62;
                                phi_2070_ = _e2294;
                                loop {
                                    let _e1291 = phi_2067_;
                                    let _e1293 = phi_2070_;
                                    local_42 = _e1293;
                                    local_43 = _e1293;
                                    local_44 = _e1293;
                                    if (_e1291.member < _e1291.member_1) {
                                        phi_2068_ = type_4((_e1291.member + 1u), _e1291.member_1);
                                        phi_2093_ = type_4(1u, _e1291.member);
                                    } else {
                                        phi_2068_ = _e1291;
                                        phi_2093_ = type_4(0u, type_4().member_1);
                                    }
                                    let _e1306 = phi_2068_;
                                    let _e1308 = phi_2093_;
                                    let _e1311 = (bitcast<i32>(_e1308.member) != 0i);
                                    if _e1311 {
                                        if (_e1293 < 1023u) {
                                            let _e1313 = (_e1293 + 1u);
                                            let _e1319 = (_e1092 + bitcast<f32>((bitcast<u32>((f32(_e1313) * _e1207)) ^ _e95)));
                                            phi_2134_ = select(_e1293, _e1313, (select(select(_e1094, _e1319, (_e1319 < _e1094)), _e1094, (_e1313 == 1023u)) <= _e1233));
                                        } else {
                                            phi_2134_ = _e1293;
                                        }
                                        let _e1327 = phi_2134_;
                                        phi_2071_ = _e1327;
                                    } else {
                                        phi_2071_ = u32();
                                    }
                                    let _e1329 = phi_2071_;
                                    continue;
                                    continuing {
                                        phi_2067_ = _e1306;
                                        phi_2070_ = _e1329;
                                        break if !(_e1311);
                                    }
                                }
                                let _e1332 = local_42;
                                let _e1338 = (_e1092 + bitcast<f32>((bitcast<u32>((f32(_e1332) * _e1207)) ^ _e95)));
                                let _e1342 = local_43;
                                let _e1347 = local_44;
                                let _e1348 = select(_e1347, 0u, (select(select(_e1094, _e1338, (_e1338 < _e1094)), _e1094, (_e1342 == 1023u)) > _e1233));
                                if (_e1348 < 1023u) {
                                    let _e1355 = (_e1092 + bitcast<f32>((bitcast<u32>((f32(_e1348) * _e1207)) ^ _e95)));
                                    let _e1360 = (select(select(_e1094, _e1355, (_e1355 < _e1094)), _e1094, (_e1348 == 1023u)) < _e1233);
                                    if _e1360 {
                                        phi_2195_ = (_e1348 + 1u);
                                    } else {
                                        phi_2195_ = u32();
                                    }
                                    let _e1363 = phi_2195_;
                                    phi_2197_ = _e1363;
                                    phi_2198_ = select(true, false, _e1360);
                                } else {
                                    phi_2197_ = u32();
                                    phi_2198_ = true;
                                }
                                let _e1366 = phi_2197_;
                                let _e1368 = phi_2198_;
                                phi_1707_ = array<u32, 2>((_e1070[0] | (select(_e1224, 0u, (select(select(_e1094, _e1215, (_e1215 < _e1094)), _e1094, (_e1219 == 1023u)) > _e1096)) << bitcast<u32>(_e1227))), (_e1070[1] | (select(_e1366, _e1348, _e1368) << bitcast<u32>(_e1227))));
                            } else {
                                phi_1707_ = array<u32, 2>();
                            }
                            let _e1376 = phi_1707_;
                            continue;
                            continuing {
                                phi_1703_ = _e1083;
                                phi_1706_ = _e1376;
                                phi_3750_ = _e1066;
                                break if !(_e1089);
                            }
                        }
                        let _e1379 = phi_3750_;
                        if _e1379 {
                            break;
                        }
                        local_23 = array<u32, 3>(0u, 1u, 2u);
                        local_17 = array<f32, 3>(0f, 0f, 0f);
                        local_16 = array<f32, 3>(0f, 0f, 0f);
                        phi_2221_ = type_4(0u, 3u);
                        loop {
                            let _e1381 = phi_2221_;
                            if (_e1381.member < _e1381.member_1) {
                                phi_2222_ = type_4((_e1381.member + 1u), _e1381.member_1);
                                phi_2245_ = type_4(1u, _e1381.member);
                            } else {
                                phi_2222_ = _e1381;
                                phi_2245_ = type_4(0u, type_4().member_1);
                            }
                            let _e1394 = phi_2222_;
                            let _e1396 = phi_2245_;
                            let _e1400 = (bitcast<i32>(_e1396.member) != 0i);
                            if _e1400 {
                                let _e1401 = (_e1396.member_1 < 3u);
                                if _e1401 {
                                } else {
                                    phi_3799_ = true;
                                    break;
                                }
                                let _e1403 = local_23[_e1396.member_1];
                                if _e1401 {
                                } else {
                                    phi_3799_ = true;
                                    break;
                                }
                                let _e1405 = local_5[_e1396.member_1];
                                if _e1401 {
                                } else {
                                    phi_3799_ = true;
                                    break;
                                }
                                let _e1407 = local_4[_e1396.member_1];
                                let _e1409 = local_45;
                                let _e1412 = ((10u * _e1403) & 31u);
                                let _e1415 = ((_e1409[0] >> bitcast<u32>(_e1412)) & 1023u);
                                let _e1420 = bitcast<f32>((bitcast<u32>(((_e1407 - _e1405) * 0.0009775171f)) ^ _e95));
                                let _e1426 = (_e1405 + bitcast<f32>((bitcast<u32>((f32(_e1415) * _e1420)) ^ _e95)));
                                if _e1401 {
                                } else {
                                    phi_3799_ = true;
                                    break;
                                }
                                local_17[_e1396.member_1] = select(select(_e1407, _e1426, (_e1426 < _e1407)), _e1407, (_e1415 == 1023u));
                                let _e1433 = local_46;
                                let _e1437 = ((_e1433[1] >> bitcast<u32>(_e1412)) & 1023u);
                                let _e1443 = (_e1405 + bitcast<f32>((bitcast<u32>((f32(_e1437) * _e1420)) ^ _e95)));
                                if _e1401 {
                                } else {
                                    phi_3799_ = true;
                                    break;
                                }
                                local_16[_e1396.member_1] = select(select(_e1407, _e1443, (_e1443 < _e1407)), _e1407, (_e1437 == 1023u));
                            }
                            continue;
                            continuing {
                                phi_2221_ = _e1394;
                                phi_3799_ = _e1379;
                                break if !(_e1400);
                            }
                        }
                        let _e1451 = phi_3799_;
                        if _e1451 {
                            break;
                        }
                        let _e1452 = local_16;
                        let _e1453 = local_17;
                        local_22 = array<u32, 3>(0u, 1u, 2u);
                        local_19 = array<f32, 3>(0f, 0f, 0f);
                        local_18 = array<f32, 3>(0f, 0f, 0f);
                        phi_2362_ = type_4(0u, 3u);
                        loop {
                            let _e1455 = phi_2362_;
                            if (_e1455.member < _e1455.member_1) {
                                phi_2363_ = type_4((_e1455.member + 1u), _e1455.member_1);
                                phi_2386_ = type_4(1u, _e1455.member);
                            } else {
                                phi_2363_ = _e1455;
                                phi_2386_ = type_4(0u, type_4().member_1);
                            }
                            let _e1468 = phi_2363_;
                            let _e1470 = phi_2386_;
                            let _e1474 = (bitcast<i32>(_e1470.member) != 0i);
                            if _e1474 {
                                let _e1475 = (_e1470.member_1 < 3u);
                                if _e1475 {
                                } else {
                                    phi_3807_ = true;
                                    break;
                                }
                                let _e1477 = local_22[_e1470.member_1];
                                if _e1475 {
                                } else {
                                    phi_3807_ = true;
                                    break;
                                }
                                let _e1479 = local_5[_e1470.member_1];
                                if _e1475 {
                                } else {
                                    phi_3807_ = true;
                                    break;
                                }
                                let _e1481 = local_4[_e1470.member_1];
                                let _e1483 = local_47;
                                let _e1486 = ((10u * _e1477) & 31u);
                                let _e1489 = ((_e1483[0] >> bitcast<u32>(_e1486)) & 1023u);
                                let _e1494 = bitcast<f32>((bitcast<u32>(((_e1481 - _e1479) * 0.0009775171f)) ^ _e95));
                                let _e1500 = (_e1479 + bitcast<f32>((bitcast<u32>((f32(_e1489) * _e1494)) ^ _e95)));
                                if _e1475 {
                                } else {
                                    phi_3807_ = true;
                                    break;
                                }
                                local_19[_e1470.member_1] = select(select(_e1481, _e1500, (_e1500 < _e1481)), _e1481, (_e1489 == 1023u));
                                let _e1507 = local_48;
                                let _e1511 = ((_e1507[1] >> bitcast<u32>(_e1486)) & 1023u);
                                let _e1517 = (_e1479 + bitcast<f32>((bitcast<u32>((f32(_e1511) * _e1494)) ^ _e95)));
                                if _e1475 {
                                } else {
                                    phi_3807_ = true;
                                    break;
                                }
                                local_18[_e1470.member_1] = select(select(_e1481, _e1517, (_e1517 < _e1481)), _e1481, (_e1511 == 1023u));
                            }
                            continue;
                            continuing {
                                phi_2362_ = _e1468;
                                phi_3807_ = _e1451;
                                break if !(_e1474);
                            }
                        }
                        let _e1525 = phi_3807_;
                        if _e1525 {
                            break;
                        }
                        let _e1526 = local_18;
                        let _e1527 = local_19;
                        local_3 = _e1453;
                        local_2 = _e1452;
                        local_1 = _e1527;
                        local = _e1526;
                        let _e1529 = local_49;
                        let _e1531 = local_50;
                        if _e92 {
                        } else {
                            break;
                        }
                        global_5.member[_e86] = type_40(_e1529, _e1531, _e667, _e698);
                        if _e91 {
                        } else {
                            break;
                        }
                        if ((_e667 & 2147483648u) != 0u) {
                            phi_3822_ = _e1525;
                            phi_2574_ = type_4(0u, ((_e667 >> bitcast<u32>(28u)) & 7u));
                            loop {
                                let _e1542 = phi_3822_;
                                let _e1544 = phi_2574_;
                                if (_e1544.member < _e1544.member_1) {
                                    phi_2575_ = type_4((_e1544.member + 1u), _e1544.member_1);
                                    phi_2598_ = type_4(1u, _e1544.member);
                                } else {
                                    phi_2575_ = _e1544;
                                    phi_2598_ = type_4(0u, type_4().member_1);
                                }
                                let _e1557 = phi_2575_;
                                let _e1559 = phi_2598_;
                                let _e1563 = (bitcast<i32>(_e1559.member) != 0i);
                                if _e1563 {
                                    let _e1565 = ((_e667 & 268435455u) + _e1559.member_1);
                                    let _e1566 = (_e1565 < _e76);
                                    if _e1566 {
                                        let _e1567 = (_e1565 < _e80);
                                        if _e1567 {
                                            if _e1566 {
                                            } else {
                                                phi_3851_ = true;
                                                break;
                                            }
                                            local_21 = array<u32, 3>(0u, 0u, 0u);
                                            phi_3820_ = _e1542;
                                            phi_2624_ = type_4(0u, 3u);
                                            loop {
                                                let _e1569 = phi_3820_;
                                                let _e1571 = phi_2624_;
                                                if (_e1571.member < _e1571.member_1) {
                                                    phi_2625_ = type_4((_e1571.member + 1u), _e1571.member_1);
                                                    phi_2648_ = type_4(1u, _e1571.member);
                                                } else {
                                                    phi_2625_ = _e1571;
                                                    phi_2648_ = type_4(0u, type_4().member_1);
                                                }
                                                let _e1584 = phi_2625_;
                                                let _e1586 = phi_2648_;
                                                let _e1590 = (bitcast<i32>(_e1586.member) != 0i);
                                                if _e1590 {
                                                    phi_2658_ = type_4(0u, 3u);
                                                    loop {
                                                        let _e1592 = phi_2658_;
                                                        if (_e1592.member < _e1592.member_1) {
                                                            phi_2659_ = type_4((_e1592.member + 1u), _e1592.member_1);
                                                            phi_2682_ = type_4(1u, _e1592.member);
                                                        } else {
                                                            phi_2659_ = _e1592;
                                                            phi_2682_ = type_4(0u, type_4().member_1);
                                                        }
                                                        let _e1605 = phi_2659_;
                                                        let _e1607 = phi_2682_;
                                                        let _e1611 = (bitcast<i32>(_e1607.member) != 0i);
                                                        if _e1611 {
                                                            let _e1614 = (((3u * _e1586.member_1) + _e1607.member_1) % 9u);
                                                            if (_e1614 < 9u) {
                                                            } else {
                                                                phi_3815_ = true;
                                                                break;
                                                            }
                                                            let _e1620 = global_2.member[_e1565].member[_e1614];
                                                            let _e1621 = (_e1607.member_1 < 3u);
                                                            if _e1621 {
                                                            } else {
                                                                phi_3815_ = true;
                                                                break;
                                                            }
                                                            let _e1623 = local_3[_e1607.member_1];
                                                            if _e1621 {
                                                            } else {
                                                                phi_3815_ = true;
                                                                break;
                                                            }
                                                            let _e1625 = local_2[_e1607.member_1];
                                                            let _e1626 = (_e1625 - _e1623);
                                                            if (_e1626 > 0f) {
                                                                phi_2724_ = (((_e1620 - _e1623) / _e1626) * 1023f);
                                                            } else {
                                                                phi_2724_ = 0f;
                                                            }
                                                            let _e1632 = phi_2724_;
                                                            let _e1634 = select(1023f, _e1632, (_e1632 < 1023f));
                                                            let _e1636 = select(0f, _e1634, (_e1634 > 0f));
                                                            phi_2745_ = type_4(0u, 3u);
                                                            phi_2748_ = select(select(u32(_e1636), 0u, (_e1636 < 0f)), 4294967295u, (_e1636 > 4294967000f));
                                                            loop {
                                                                let _e1643 = phi_2745_;
                                                                let _e1645 = phi_2748_;
                                                                local_63 = _e1645;
                                                                if (_e1643.member < _e1643.member_1) {
                                                                    phi_2746_ = type_4((_e1643.member + 1u), _e1643.member_1);
                                                                    phi_2771_ = type_4(1u, _e1643.member);
                                                                } else {
                                                                    phi_2746_ = _e1643;
                                                                    phi_2771_ = type_4(0u, type_4().member_1);
                                                                }
                                                                let _e1658 = phi_2746_;
                                                                let _e1660 = phi_2771_;
                                                                let _e1663 = (bitcast<i32>(_e1660.member) != 0i);
                                                                if _e1663 {
                                                                    if (_e1645 > 0u) {
                                                                        let _e1674 = (_e1623 + bitcast<f32>((bitcast<u32>((f32(_e1645) * bitcast<f32>((bitcast<u32>((_e1626 * 0.0009775171f)) ^ _e95)))) ^ _e95)));
                                                                        if (select(select(_e1625, _e1674, (_e1674 < _e1625)), _e1625, (_e1645 == 1023u)) > _e1620) {
                                                                            phi_2810_ = (_e1645 - 1u);
                                                                        } else {
                                                                            phi_2810_ = _e1645;
                                                                        }
                                                                        let _e1682 = phi_2810_;
                                                                        phi_2811_ = _e1682;
                                                                    } else {
                                                                        phi_2811_ = _e1645;
                                                                    }
                                                                    let _e1684 = phi_2811_;
                                                                    phi_2749_ = _e1684;
                                                                } else {
                                                                    phi_2749_ = u32();
                                                                }
                                                                let _e1686 = phi_2749_;
                                                                continue;
                                                                continuing {
                                                                    phi_2745_ = _e1658;
                                                                    phi_2748_ = _e1686;
                                                                    break if !(_e1663);
                                                                }
                                                            }
                                                            phi_2814_ = type_4(0u, 3u);
                                                            let _e2343 = local_63;
                                                            phi_2817_ = _e2343;
                                                            loop {
                                                                let _e1689 = phi_2814_;
                                                                let _e1691 = phi_2817_;
                                                                local_51 = _e1691;
                                                                local_52 = _e1691;
                                                                local_53 = _e1691;
                                                                if (_e1689.member < _e1689.member_1) {
                                                                    phi_2815_ = type_4((_e1689.member + 1u), _e1689.member_1);
                                                                    phi_2840_ = type_4(1u, _e1689.member);
                                                                } else {
                                                                    phi_2815_ = _e1689;
                                                                    phi_2840_ = type_4(0u, type_4().member_1);
                                                                }
                                                                let _e1704 = phi_2815_;
                                                                let _e1706 = phi_2840_;
                                                                let _e1709 = (bitcast<i32>(_e1706.member) != 0i);
                                                                if _e1709 {
                                                                    if (_e1691 < 1023u) {
                                                                        let _e1711 = (_e1691 + 1u);
                                                                        let _e1721 = (_e1623 + bitcast<f32>((bitcast<u32>((f32(_e1711) * bitcast<f32>((bitcast<u32>((_e1626 * 0.0009775171f)) ^ _e95)))) ^ _e95)));
                                                                        phi_2881_ = select(_e1691, _e1711, (select(select(_e1625, _e1721, (_e1721 < _e1625)), _e1625, (_e1711 == 1023u)) <= _e1620));
                                                                    } else {
                                                                        phi_2881_ = _e1691;
                                                                    }
                                                                    let _e1729 = phi_2881_;
                                                                    phi_2818_ = _e1729;
                                                                } else {
                                                                    phi_2818_ = u32();
                                                                }
                                                                let _e1731 = phi_2818_;
                                                                continue;
                                                                continuing {
                                                                    phi_2814_ = _e1704;
                                                                    phi_2817_ = _e1731;
                                                                    break if !(_e1709);
                                                                }
                                                            }
                                                            let _e1736 = bitcast<f32>((bitcast<u32>((_e1626 * 0.0009775171f)) ^ _e95));
                                                            let _e1738 = local_51;
                                                            let _e1744 = (_e1623 + bitcast<f32>((bitcast<u32>((f32(_e1738) * _e1736)) ^ _e95)));
                                                            let _e1748 = local_52;
                                                            let _e1753 = local_53;
                                                            let _e1754 = select(_e1753, 0u, (select(select(_e1625, _e1744, (_e1744 < _e1625)), _e1625, (_e1748 == 1023u)) > _e1620));
                                                            if (_e1754 < 1023u) {
                                                                phi_2915_ = (_e1754 + 1u);
                                                            } else {
                                                                phi_2915_ = _e1754;
                                                            }
                                                            let _e1758 = phi_2915_;
                                                            let _e1764 = (_e1623 + bitcast<f32>((bitcast<u32>((f32(_e1754) * _e1736)) ^ _e95)));
                                                            let _e1778 = (_e1623 + bitcast<f32>((bitcast<u32>((f32(_e1758) * _e1736)) ^ _e95)));
                                                            if (_e1586.member_1 < 3u) {
                                                            } else {
                                                                phi_3815_ = true;
                                                                break;
                                                            }
                                                            let _e1795 = local_21[_e1586.member_1];
                                                            local_21[_e1586.member_1] = (_e1795 | (select(_e1754, _e1758, (bitcast<f32>((bitcast<u32>((select(select(_e1625, _e1778, (_e1778 < _e1625)), _e1625, (_e1758 == 1023u)) - _e1620)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e1620 - select(select(_e1625, _e1764, (_e1764 < _e1625)), _e1625, (_e1754 == 1023u)))) & 2147483647u)))) << bitcast<u32>(((10u * _e1607.member_1) & 31u))));
                                                        }
                                                        continue;
                                                        continuing {
                                                            phi_2658_ = _e1605;
                                                            phi_3815_ = _e1569;
                                                            break if !(_e1611);
                                                        }
                                                    }
                                                    let _e1799 = phi_3815_;
                                                    phi_3849_ = _e1799;
                                                    if _e1799 {
                                                        break;
                                                    }
                                                    phi_3850_ = _e1799;
                                                } else {
                                                    phi_3850_ = _e1569;
                                                }
                                                let _e1801 = phi_3850_;
                                                continue;
                                                continuing {
                                                    phi_3820_ = _e1801;
                                                    phi_2624_ = _e1584;
                                                    phi_3849_ = _e1801;
                                                    break if !(_e1590);
                                                }
                                            }
                                            let _e1804 = phi_3849_;
                                            phi_3851_ = _e1804;
                                            if _e1804 {
                                                break;
                                            }
                                            let _e1808 = global_2.member[_e1565].member_1;
                                            let _e1809 = local_21;
                                            if _e1567 {
                                            } else {
                                                phi_3851_ = true;
                                                break;
                                            }
                                            global_6.member[_e1565] = type_46(array<u32, 3>(_e1809[0], _e1809[1], _e1809[2]), _e1808);
                                            phi_3854_ = _e1804;
                                        } else {
                                            phi_3854_ = _e1542;
                                        }
                                        let _e1818 = phi_3854_;
                                        phi_3853_ = _e1818;
                                    } else {
                                        phi_3853_ = _e1542;
                                    }
                                    let _e1820 = phi_3853_;
                                    phi_3852_ = _e1820;
                                } else {
                                    phi_3852_ = _e1542;
                                }
                                let _e1822 = phi_3852_;
                                continue;
                                continuing {
                                    phi_3822_ = _e1822;
                                    phi_2574_ = _e1557;
                                    phi_3851_ = _e1822;
                                    break if !(_e1563);
                                }
                            }
                            let _e1825 = phi_3851_;
                            if _e1825 {
                                break;
                            }
                            phi_3863_ = _e1825;
                        } else {
                            phi_3863_ = _e1525;
                        }
                        let _e1827 = phi_3863_;
                        if _e91 {
                        } else {
                            break;
                        }
                        if ((_e698 & 2147483648u) != 0u) {
                            phi_3862_ = _e1827;
                            phi_3022_ = type_4(0u, ((_e698 >> bitcast<u32>(28u)) & 7u));
                            loop {
                                let _e1835 = phi_3862_;
                                let _e1837 = phi_3022_;
                                if (_e1837.member < _e1837.member_1) {
                                    phi_3023_ = type_4((_e1837.member + 1u), _e1837.member_1);
                                    phi_3046_ = type_4(1u, _e1837.member);
                                } else {
                                    phi_3023_ = _e1837;
                                    phi_3046_ = type_4(0u, type_4().member_1);
                                }
                                let _e1850 = phi_3023_;
                                let _e1852 = phi_3046_;
                                let _e1856 = (bitcast<i32>(_e1852.member) != 0i);
                                if _e1856 {
                                    let _e1858 = ((_e698 & 268435455u) + _e1852.member_1);
                                    let _e1859 = (_e1858 < _e76);
                                    if _e1859 {
                                        let _e1860 = (_e1858 < _e80);
                                        if _e1860 {
                                            if _e1859 {
                                            } else {
                                                phi_3892_ = true;
                                                break;
                                            }
                                            local_20 = array<u32, 3>(0u, 0u, 0u);
                                            phi_3860_ = _e1835;
                                            phi_3072_ = type_4(0u, 3u);
                                            loop {
                                                let _e1862 = phi_3860_;
                                                let _e1864 = phi_3072_;
                                                if (_e1864.member < _e1864.member_1) {
                                                    phi_3073_ = type_4((_e1864.member + 1u), _e1864.member_1);
                                                    phi_3096_ = type_4(1u, _e1864.member);
                                                } else {
                                                    phi_3073_ = _e1864;
                                                    phi_3096_ = type_4(0u, type_4().member_1);
                                                }
                                                let _e1877 = phi_3073_;
                                                let _e1879 = phi_3096_;
                                                let _e1883 = (bitcast<i32>(_e1879.member) != 0i);
                                                if _e1883 {
                                                    phi_3106_ = type_4(0u, 3u);
                                                    loop {
                                                        let _e1885 = phi_3106_;
                                                        if (_e1885.member < _e1885.member_1) {
                                                            phi_3107_ = type_4((_e1885.member + 1u), _e1885.member_1);
                                                            phi_3130_ = type_4(1u, _e1885.member);
                                                        } else {
                                                            phi_3107_ = _e1885;
                                                            phi_3130_ = type_4(0u, type_4().member_1);
                                                        }
                                                        let _e1898 = phi_3107_;
                                                        let _e1900 = phi_3130_;
                                                        let _e1904 = (bitcast<i32>(_e1900.member) != 0i);
                                                        if _e1904 {
                                                            let _e1907 = (((3u * _e1879.member_1) + _e1900.member_1) % 9u);
                                                            if (_e1907 < 9u) {
                                                            } else {
                                                                phi_3855_ = true;
                                                                break;
                                                            }
                                                            let _e1913 = global_2.member[_e1858].member[_e1907];
                                                            let _e1914 = (_e1900.member_1 < 3u);
                                                            if _e1914 {
                                                            } else {
                                                                phi_3855_ = true;
                                                                break;
                                                            }
                                                            let _e1916 = local_1[_e1900.member_1];
                                                            if _e1914 {
                                                            } else {
                                                                phi_3855_ = true;
                                                                break;
                                                            }
                                                            let _e1918 = local[_e1900.member_1];
                                                            let _e1919 = (_e1918 - _e1916);
                                                            if (_e1919 > 0f) {
                                                                phi_3172_ = (((_e1913 - _e1916) / _e1919) * 1023f);
                                                            } else {
                                                                phi_3172_ = 0f;
                                                            }
                                                            let _e1925 = phi_3172_;
                                                            let _e1927 = select(1023f, _e1925, (_e1925 < 1023f));
                                                            let _e1929 = select(0f, _e1927, (_e1927 > 0f));
                                                            phi_3193_ = type_4(0u, 3u);
                                                            phi_3196_ = select(select(u32(_e1929), 0u, (_e1929 < 0f)), 4294967295u, (_e1929 > 4294967000f));
                                                            loop {
                                                                let _e1936 = phi_3193_;
                                                                let _e1938 = phi_3196_;
                                                                local_64 = _e1938;
                                                                if (_e1936.member < _e1936.member_1) {
                                                                    phi_3194_ = type_4((_e1936.member + 1u), _e1936.member_1);
                                                                    phi_3219_ = type_4(1u, _e1936.member);
                                                                } else {
                                                                    phi_3194_ = _e1936;
                                                                    phi_3219_ = type_4(0u, type_4().member_1);
                                                                }
                                                                let _e1951 = phi_3194_;
                                                                let _e1953 = phi_3219_;
                                                                let _e1956 = (bitcast<i32>(_e1953.member) != 0i);
                                                                if _e1956 {
                                                                    if (_e1938 > 0u) {
                                                                        let _e1967 = (_e1916 + bitcast<f32>((bitcast<u32>((f32(_e1938) * bitcast<f32>((bitcast<u32>((_e1919 * 0.0009775171f)) ^ _e95)))) ^ _e95)));
                                                                        if (select(select(_e1918, _e1967, (_e1967 < _e1918)), _e1918, (_e1938 == 1023u)) > _e1913) {
                                                                            phi_3258_ = (_e1938 - 1u);
                                                                        } else {
                                                                            phi_3258_ = _e1938;
                                                                        }
                                                                        let _e1975 = phi_3258_;
                                                                        phi_3259_ = _e1975;
                                                                    } else {
                                                                        phi_3259_ = _e1938;
                                                                    }
                                                                    let _e1977 = phi_3259_;
                                                                    phi_3197_ = _e1977;
                                                                } else {
                                                                    phi_3197_ = u32();
                                                                }
                                                                let _e1979 = phi_3197_;
                                                                continue;
                                                                continuing {
                                                                    phi_3193_ = _e1951;
                                                                    phi_3196_ = _e1979;
                                                                    break if !(_e1956);
                                                                }
                                                            }
                                                            phi_3262_ = type_4(0u, 3u);
                                                            let _e2382 = local_64;
                                                            phi_3265_ = _e2382;
                                                            loop {
                                                                let _e1982 = phi_3262_;
                                                                let _e1984 = phi_3265_;
                                                                local_54 = _e1984;
                                                                local_55 = _e1984;
                                                                local_56 = _e1984;
                                                                if (_e1982.member < _e1982.member_1) {
                                                                    phi_3263_ = type_4((_e1982.member + 1u), _e1982.member_1);
                                                                    phi_3288_ = type_4(1u, _e1982.member);
                                                                } else {
                                                                    phi_3263_ = _e1982;
                                                                    phi_3288_ = type_4(0u, type_4().member_1);
                                                                }
                                                                let _e1997 = phi_3263_;
                                                                let _e1999 = phi_3288_;
                                                                let _e2002 = (bitcast<i32>(_e1999.member) != 0i);
                                                                if _e2002 {
                                                                    if (_e1984 < 1023u) {
                                                                        let _e2004 = (_e1984 + 1u);
                                                                        let _e2014 = (_e1916 + bitcast<f32>((bitcast<u32>((f32(_e2004) * bitcast<f32>((bitcast<u32>((_e1919 * 0.0009775171f)) ^ _e95)))) ^ _e95)));
                                                                        phi_3329_ = select(_e1984, _e2004, (select(select(_e1918, _e2014, (_e2014 < _e1918)), _e1918, (_e2004 == 1023u)) <= _e1913));
                                                                    } else {
                                                                        phi_3329_ = _e1984;
                                                                    }
                                                                    let _e2022 = phi_3329_;
                                                                    phi_3266_ = _e2022;
                                                                } else {
                                                                    phi_3266_ = u32();
                                                                }
                                                                let _e2024 = phi_3266_;
                                                                continue;
                                                                continuing {
                                                                    phi_3262_ = _e1997;
                                                                    phi_3265_ = _e2024;
                                                                    break if !(_e2002);
                                                                }
                                                            }
                                                            let _e2029 = bitcast<f32>((bitcast<u32>((_e1919 * 0.0009775171f)) ^ _e95));
                                                            let _e2031 = local_54;
                                                            let _e2037 = (_e1916 + bitcast<f32>((bitcast<u32>((f32(_e2031) * _e2029)) ^ _e95)));
                                                            let _e2041 = local_55;
                                                            let _e2046 = local_56;
                                                            let _e2047 = select(_e2046, 0u, (select(select(_e1918, _e2037, (_e2037 < _e1918)), _e1918, (_e2041 == 1023u)) > _e1913));
                                                            if (_e2047 < 1023u) {
                                                                phi_3363_ = (_e2047 + 1u);
                                                            } else {
                                                                phi_3363_ = _e2047;
                                                            }
                                                            let _e2051 = phi_3363_;
                                                            let _e2057 = (_e1916 + bitcast<f32>((bitcast<u32>((f32(_e2047) * _e2029)) ^ _e95)));
                                                            let _e2071 = (_e1916 + bitcast<f32>((bitcast<u32>((f32(_e2051) * _e2029)) ^ _e95)));
                                                            if (_e1879.member_1 < 3u) {
                                                            } else {
                                                                phi_3855_ = true;
                                                                break;
                                                            }
                                                            let _e2088 = local_20[_e1879.member_1];
                                                            local_20[_e1879.member_1] = (_e2088 | (select(_e2047, _e2051, (bitcast<f32>((bitcast<u32>((select(select(_e1918, _e2071, (_e2071 < _e1918)), _e1918, (_e2051 == 1023u)) - _e1913)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e1913 - select(select(_e1918, _e2057, (_e2057 < _e1918)), _e1918, (_e2047 == 1023u)))) & 2147483647u)))) << bitcast<u32>(((10u * _e1900.member_1) & 31u))));
                                                        }
                                                        continue;
                                                        continuing {
                                                            phi_3106_ = _e1898;
                                                            phi_3855_ = _e1862;
                                                            break if !(_e1904);
                                                        }
                                                    }
                                                    let _e2092 = phi_3855_;
                                                    phi_3890_ = _e2092;
                                                    if _e2092 {
                                                        break;
                                                    }
                                                    phi_3891_ = _e2092;
                                                } else {
                                                    phi_3891_ = _e1862;
                                                }
                                                let _e2094 = phi_3891_;
                                                continue;
                                                continuing {
                                                    phi_3860_ = _e2094;
                                                    phi_3072_ = _e1877;
                                                    phi_3890_ = _e2094;
                                                    break if !(_e1883);
                                                }
                                            }
                                            let _e2097 = phi_3890_;
                                            phi_3892_ = _e2097;
                                            if _e2097 {
                                                break;
                                            }
                                            let _e2101 = global_2.member[_e1858].member_1;
                                            let _e2102 = local_20;
                                            if _e1860 {
                                            } else {
                                                phi_3892_ = true;
                                                break;
                                            }
                                            global_6.member[_e1858] = type_46(array<u32, 3>(_e2102[0], _e2102[1], _e2102[2]), _e2101);
                                            phi_3895_ = _e2097;
                                        } else {
                                            phi_3895_ = _e1835;
                                        }
                                        let _e2111 = phi_3895_;
                                        phi_3894_ = _e2111;
                                    } else {
                                        phi_3894_ = _e1835;
                                    }
                                    let _e2113 = phi_3894_;
                                    phi_3893_ = _e2113;
                                } else {
                                    phi_3893_ = _e1835;
                                }
                                let _e2115 = phi_3893_;
                                continue;
                                continuing {
                                    phi_3862_ = _e2115;
                                    phi_3022_ = _e1850;
                                    phi_3892_ = _e2115;
                                    break if !(_e1856);
                                }
                            }
                            let _e2118 = phi_3892_;
                            if _e2118 {
                                break;
                            }
                        }
                        if (_e86 == 0u) {
                            if (_e82 == 0u) {
                            } else {
                                if (0u < _e82) {
                                } else {
                                    break;
                                }
                                global_7.member[0u] = type_35(array<u32, 4>(bitcast<u32>(_e663[0]), bitcast<u32>(_e663[1]), bitcast<u32>(_e663[2]), 0u), array<u32, 4>(bitcast<u32>(_e662[0]), bitcast<u32>(_e662[1]), bitcast<u32>(_e662[2]), 0u));
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
fn encode_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
