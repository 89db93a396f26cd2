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

struct type_18 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_27 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_28 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_29 {
    member: type_28,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_31 {
    member: array<type_29>,
}

struct type_35 {
    member: type_28,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_37 {
    member: array<type_35>,
}

struct type_41 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_46 {
    member: f32,
    member_1: bool,
}

struct type_48 {
    member: array<vec4<u32>, 2>,
}

struct type_51 {
    member: array<i32>,
}

struct type_55 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_57 {
    member: array<type_55>,
}

struct type_60 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_62 {
    member: type_60,
    member_1: u32,
}

struct type_67 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_31;
@group(0) @binding(1) 
var<uniform> global_3: type_48;
@group(0) @binding(2) 
var<uniform> global_4: type_48;
@group(0) @binding(4) 
var<storage> global_5: type_20;
@group(0) @binding(5) 
var<storage> global_6: type_4;
@group(0) @binding(6) 
var<storage> global_7: type_51;
@group(0) @binding(9) 
var<storage, read_write> global_8: type_67;
@group(0) @binding(7) 
var<storage> global_9: type_37;
@group(0) @binding(3) 
var<storage> global_10: type_57;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<f32, 128>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<u32, 128>;
    var local_7: array<f32, 128>;
    var local_8: array<f32, 3>;
    var local_9: array<f32, 3>;
    var phi_274_: u32;
    var phi_318_: i32;
    var phi_342_: type_41;
    var phi_492_: i32;
    var phi_493_: i32;
    var phi_503_: bool;
    var phi_513_: u32;
    var phi_514_: u32;
    var phi_516_: bool;
    var phi_521_: u32;
    var phi_553_: i32;
    var phi_571_: f32;
    var phi_577_: f32;
    var phi_588_: f32;
    var phi_594_: f32;
    var phi_617_: f32;
    var phi_628_: f32;
    var phi_637_: f32;
    var phi_643_: f32;
    var phi_654_: f32;
    var phi_660_: f32;
    var phi_683_: f32;
    var phi_694_: f32;
    var phi_703_: f32;
    var phi_709_: f32;
    var phi_720_: f32;
    var phi_726_: f32;
    var phi_749_: f32;
    var phi_760_: f32;
    var phi_860_: f32;
    var phi_861_: f32;
    var phi_3433_: bool;
    var phi_934_: type_46;
    var phi_937_: type_62;
    var phi_939_: u32;
    var phi_941_: bool;
    var phi_943_: u32;
    var phi_954_: bool;
    var phi_1040_: type_62;
    var phi_1041_: bool;
    var phi_1042_: u32;
    var phi_2391_: type_55;
    var phi_3223_: type_62;
    var phi_3300_: type_62;
    var phi_3301_: type_62;
    var phi_3302_: u32;
    var phi_3304_: type_62;
    var phi_3305_: u32;
    var phi_3306_: bool;
    var phi_3313_: type_62;
    var phi_3318_: type_62;
    var phi_3319_: bool;
    var phi_1060_: type_46;
    var phi_1063_: type_8;
    var phi_1064_: type_8;
    var phi_1086_: type_8;
    var phi_1107_: u32;
    var phi_1196_: array<array<f32, 3>, 3>;
    var phi_1313_: bool;
    var phi_1342_: bool;
    var phi_1743_: f32;
    var phi_1744_: f32;
    var phi_1745_: f32;
    var phi_1746_: f32;
    var phi_1747_: vec3<f32>;
    var phi_1748_: vec3<f32>;
    var phi_1749_: vec3<f32>;
    var phi_1750_: vec3<f32>;
    var phi_1781_: bool;
    var phi_1790_: vec3<f32>;
    var phi_1955_: f32;
    var phi_1957_: f32;
    var phi_1958_: bool;
    var phi_1978_: f32;
    var phi_1979_: f32;
    var phi_2002_: type_27;
    var phi_2004_: type_27;
    var phi_2005_: bool;
    var phi_2009_: type_27;
    var phi_2010_: type_27;
    var phi_2011_: type_27;
    var phi_2012_: bool;
    var phi_2016_: type_27;
    var phi_2017_: bool;
    var phi_2018_: type_27;
    var phi_2019_: bool;
    var phi_2020_: bool;
    var phi_2021_: type_27;
    var phi_2022_: bool;
    var phi_2023_: bool;
    var phi_2031_: type_27;
    var phi_2032_: bool;
    var phi_2036_: type_27;
    var phi_2059_: u32;
    var phi_2073_: i32;
    var phi_2093_: vec3<f32>;
    var phi_2094_: vec3<f32>;
    var phi_2110_: vec3<f32>;
    var phi_2111_: vec3<f32>;
    var phi_2127_: vec3<f32>;
    var phi_2128_: vec3<f32>;
    var phi_2164_: vec3<f32>;
    var phi_2346_: f32;
    var phi_2364_: bool;
    var phi_2365_: bool;
    var phi_2370_: type_46;
    var phi_2371_: type_46;
    var phi_1061_: type_46;
    var phi_3427_: bool;
    var local_10: type_46;
    var phi_3597_: bool;
    var phi_3321_: type_46;
    var phi_3322_: type_62;
    var phi_3323_: bool;
    var phi_3324_: u32;
    var phi_3596_: bool;
    var phi_3325_: type_46;
    var phi_3326_: type_62;
    var phi_3327_: u32;
    var phi_3328_: bool;
    var phi_3329_: u32;
    var phi_3595_: bool;
    var phi_3330_: type_46;
    var phi_3331_: type_62;
    var phi_3332_: u32;
    var phi_3333_: bool;
    var phi_3334_: u32;
    var phi_3594_: bool;
    var phi_935_: type_46;
    var phi_938_: type_62;
    var phi_940_: u32;
    var phi_942_: bool;
    var phi_944_: u32;
    var phi_3335_: bool;
    var phi_3593_: bool;
    var local_11: type_46;
    var local_12: type_46;

    switch bitcast<i32>(0u) {
        default: {
            let _e88 = global;
            let _e91 = arrayLength((&global_10.member));
            let _e93 = arrayLength((&global_5.member));
            let _e105 = arrayLength((&global_8.member));
            let _e109 = global_4.member[0u][0u];
            let _e113 = global_4.member[0u][1u];
            let _e117 = global_4.member[0u][2u];
            let _e121 = global_4.member[1u][0u];
            let _e125 = global_4.member[1u][1u];
            let _e129 = global_4.member[1u][2u];
            let _e133 = global_4.member[1u][3u];
            let _e137 = (_e88.x + (_e88.y * 2097152u));
            let _e144 = (_e137 < arrayLength((&global_9.member)));
            if _e144 {
                if _e144 {
                } else {
                    break;
                }
                let _e148 = global_9.member[_e137].member_2;
                phi_274_ = _e148;
            } else {
                phi_274_ = 4294967295u;
            }
            let _e150 = phi_274_;
            let _e153 = global_1.member[0u];
            let _e157 = global_3.member[0u][0u];
            let _e161 = global_3.member[0u][1u];
            let _e165 = global_3.member[0u][2u];
            let _e169 = global_3.member[0u][3u];
            let _e173 = global_3.member[1u][0u];
            let _e177 = global_3.member[1u][1u];
            let _e181 = global_3.member[1u][2u];
            let _e185 = global_3.member[1u][3u];
            let _e186 = bitcast<f32>(_e157);
            let _e187 = bitcast<f32>(_e161);
            let _e188 = bitcast<f32>(_e165);
            let _e190 = bitcast<f32>(_e173);
            let _e191 = array<u32, 3>(_e177, _e181, _e185);
            let _e193 = bitcast<i32>(_e153);
            if (_e193 < -126i) {
                phi_318_ = -126i;
            } else {
                phi_318_ = select(_e193, 127i, (_e193 > 127i));
            }
            let _e198 = phi_318_;
            let _e203 = bitcast<f32>((bitcast<u32>((_e198 + 127i)) << bitcast<u32>(23i)));
            let _e209 = bitcast<f32>((bitcast<u32>(((_e193 - _e198) + 127i)) << bitcast<u32>(23i)));
            if (_e169 == 0u) {
                phi_342_ = type_41(array<f32, 3>(_e186, _e187, _e188), _e169, _e190, _e191);
            } else {
                phi_342_ = type_41(array<f32, 3>(((_e186 * _e203) * _e209), ((_e187 * _e203) * _e209), ((_e188 * _e203) * _e209)), _e169, ((_e190 * _e203) * _e209), _e191);
            }
            let _e222 = phi_342_;
            if _e144 {
                let _e223 = (_e137 < arrayLength((&global_2.member)));
                if _e223 {
                    if _e144 {
                    } else {
                        break;
                    }
                    let _e228 = global_9.member[_e137].member.member_1;
                    let _e233 = global_9.member[_e137].member.member_3;
                    if (_e228 <= _e233) {
                        let _e235 = (1u < _e105);
                        if _e235 {
                            if (0u < _e105) {
                            } else {
                                break;
                            }
                            let _e239 = atomicAdd((&global_8.member[0u]), 1u);
                            if ((_e239 + 1u) < _e239) {
                                if _e235 {
                                } else {
                                    break;
                                }
                                let _e244 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                        if _e144 {
                        } else {
                            break;
                        }
                        let _e254 = global_9.member[_e137].member.member_2[0u];
                        let _e256 = (bitcast<u32>(_e254) & 2147483647u);
                        let _e262 = global_9.member[_e137].member.member_2[1u];
                        let _e264 = (bitcast<u32>(_e262) & 2147483647u);
                        let _e270 = global_9.member[_e137].member.member_2[2u];
                        let _e272 = (bitcast<u32>(_e270) & 2147483647u);
                        let _e278 = global_9.member[_e137].member.member[0u];
                        let _e280 = (bitcast<u32>(_e278) & 2147483647u);
                        let _e286 = global_9.member[_e137].member.member[1u];
                        let _e288 = (bitcast<u32>(_e286) & 2147483647u);
                        let _e294 = global_9.member[_e137].member.member[2u];
                        let _e296 = (bitcast<u32>(_e294) & 2147483647u);
                        let _e298 = select(_e264, _e256, (_e264 < _e256));
                        let _e300 = select(_e272, _e298, (_e272 < _e298));
                        let _e302 = select(_e280, _e300, (_e280 < _e300));
                        let _e304 = select(_e288, _e302, (_e288 < _e302));
                        let _e306 = select(_e296, _e304, (_e296 < _e304));
                        let _e308 = (bitcast<u32>(_e228) & 2147483647u);
                        let _e317 = (((select(_e308, _e306, (_e308 < _e306)) < 2139095040u) && ((bitcast<u32>(_e233) & 2147483647u) <= 2139095040u)) && (_e300 > 0u));
                        if _e317 {
                            let _e320 = (bitcast<u32>(bitcast<f32>(_e300)) & 2147483647u);
                            if (_e320 >= 8388608u) {
                                phi_492_ = (bitcast<i32>((_e320 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_492_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e320)), 32u, (_e320 == 0u))));
                            }
                            let _e334 = phi_492_;
                            phi_493_ = _e334;
                        } else {
                            phi_493_ = 0i;
                        }
                        let _e336 = phi_493_;
                        let _e337 = (_e256 == _e300);
                        if _e337 {
                            phi_503_ = true;
                        } else {
                            phi_503_ = (_e264 == _e300);
                        }
                        let _e340 = phi_503_;
                        let _e341 = select(1u, 0u, _e337);
                        if _e340 {
                            let _e342 = (_e341 + 1u);
                            phi_513_ = _e342;
                            phi_514_ = _e342;
                            phi_516_ = select(true, false, (_e342 == 2u));
                        } else {
                            phi_513_ = u32();
                            phi_514_ = 0u;
                            phi_516_ = true;
                        }
                        let _e346 = phi_513_;
                        let _e348 = phi_514_;
                        let _e350 = phi_516_;
                        if _e350 {
                            phi_521_ = (_e348 + 1u);
                        } else {
                            phi_521_ = 0u;
                        }
                        let _e354 = phi_521_;
                        let _e355 = select(_e346, _e348, _e350);
                        let _e356 = select(_e341, select(2u, _e341, _e340), _e350);
                        let _e357 = -(_e336);
                        if (_e357 < -126i) {
                            phi_553_ = -126i;
                        } else {
                            phi_553_ = select(_e357, 127i, (_e357 > 127i));
                        }
                        let _e362 = phi_553_;
                        let _e367 = bitcast<f32>((bitcast<u32>((_e362 + 127i)) << bitcast<u32>(23i)));
                        let _e373 = bitcast<f32>((bitcast<u32>(((_e357 - _e362) + 127i)) << bitcast<u32>(23i)));
                        let _e378 = global_9.member[_e137].member.member;
                        let _e379 = (_e355 == 0u);
                        if _e379 {
                            phi_571_ = _e378[0];
                        } else {
                            phi_571_ = _e378[1];
                        }
                        let _e383 = phi_571_;
                        let _e384 = (_e355 == 2u);
                        if _e384 {
                            phi_577_ = _e378[2];
                        } else {
                            phi_577_ = _e383;
                        }
                        let _e387 = phi_577_;
                        let _e388 = global_9.member[_e137].member.member_2;
                        if _e379 {
                            phi_588_ = _e388[0];
                        } else {
                            phi_588_ = _e388[1];
                        }
                        let _e392 = phi_588_;
                        if _e384 {
                            phi_594_ = _e388[2];
                        } else {
                            phi_594_ = _e392;
                        }
                        let _e395 = phi_594_;
                        let _e397 = ((_e395 * _e367) * _e373);
                        let _e401 = (bitcast<f32>((bitcast<u32>(_e397) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e401 {
                            let _e405 = (bitcast<f32>((bitcast<u32>(_e387) & 2147483647u)) * 0.00000011920929f);
                            phi_617_ = select(0.00000000000011368684f, _e405, (_e405 > 0.00000000000011368684f));
                        } else {
                            phi_617_ = 0f;
                        }
                        let _e409 = phi_617_;
                        let _e410 = (_e387 + _e409);
                        let _e411 = (_e387 - _e409);
                        let _e412 = select(_e397, 0f, _e401);
                        if _e401 {
                            phi_628_ = 38685626000000000000000000f;
                        } else {
                            phi_628_ = (1f / _e397);
                        }
                        let _e415 = phi_628_;
                        let _e416 = (_e354 == 0u);
                        if _e416 {
                            phi_637_ = _e378[0];
                        } else {
                            phi_637_ = _e378[1];
                        }
                        let _e420 = phi_637_;
                        let _e421 = (_e354 == 2u);
                        if _e421 {
                            phi_643_ = _e378[2];
                        } else {
                            phi_643_ = _e420;
                        }
                        let _e424 = phi_643_;
                        if _e416 {
                            phi_654_ = _e388[0];
                        } else {
                            phi_654_ = _e388[1];
                        }
                        let _e428 = phi_654_;
                        if _e421 {
                            phi_660_ = _e388[2];
                        } else {
                            phi_660_ = _e428;
                        }
                        let _e431 = phi_660_;
                        let _e433 = ((_e431 * _e367) * _e373);
                        let _e437 = (bitcast<f32>((bitcast<u32>(_e433) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e437 {
                            let _e441 = (bitcast<f32>((bitcast<u32>(_e424) & 2147483647u)) * 0.00000011920929f);
                            phi_683_ = select(0.00000000000011368684f, _e441, (_e441 > 0.00000000000011368684f));
                        } else {
                            phi_683_ = 0f;
                        }
                        let _e445 = phi_683_;
                        let _e446 = (_e424 + _e445);
                        let _e447 = (_e424 - _e445);
                        let _e448 = select(_e433, 0f, _e437);
                        if _e437 {
                            phi_694_ = 38685626000000000000000000f;
                        } else {
                            phi_694_ = (1f / _e433);
                        }
                        let _e451 = phi_694_;
                        let _e452 = (_e356 == 0u);
                        if _e452 {
                            phi_703_ = _e378[0];
                        } else {
                            phi_703_ = _e378[1];
                        }
                        let _e456 = phi_703_;
                        let _e457 = (_e356 == 2u);
                        if _e457 {
                            phi_709_ = _e378[2];
                        } else {
                            phi_709_ = _e456;
                        }
                        let _e460 = phi_709_;
                        if _e452 {
                            phi_720_ = _e388[0];
                        } else {
                            phi_720_ = _e388[1];
                        }
                        let _e464 = phi_720_;
                        if _e457 {
                            phi_726_ = _e388[2];
                        } else {
                            phi_726_ = _e464;
                        }
                        let _e467 = phi_726_;
                        let _e469 = ((_e467 * _e367) * _e373);
                        let _e473 = (bitcast<f32>((bitcast<u32>(_e469) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e473 {
                            let _e477 = (bitcast<f32>((bitcast<u32>(_e460) & 2147483647u)) * 0.00000011920929f);
                            phi_749_ = select(0.00000000000011368684f, _e477, (_e477 > 0.00000000000011368684f));
                        } else {
                            phi_749_ = 0f;
                        }
                        let _e481 = phi_749_;
                        let _e482 = (_e460 + _e481);
                        let _e483 = (_e460 - _e481);
                        let _e484 = select(_e469, 0f, _e473);
                        if _e473 {
                            phi_760_ = 38685626000000000000000000f;
                        } else {
                            phi_760_ = (1f / _e469);
                        }
                        let _e487 = phi_760_;
                        let _e490 = bitcast<f32>((bitcast<u32>(_e387) & 2147483647u));
                        let _e493 = bitcast<f32>((bitcast<u32>(_e424) & 2147483647u));
                        let _e495 = select(_e493, _e490, (_e490 > _e493));
                        let _e498 = bitcast<f32>((bitcast<u32>(_e460) & 2147483647u));
                        if (_e317 && (select(_e498, _e495, (_e495 > _e498)) <= 1099511600000f)) {
                            let _e503 = (_e336 / 3i);
                            let _e510 = bitcast<f32>((bitcast<u32>((_e503 + 127i)) << bitcast<u32>(23i)));
                            let _e517 = bitcast<f32>((bitcast<u32>(((_e336 - (2i * _e503)) + 127i)) << bitcast<u32>(23i)));
                            let _e518 = (((_e228 * _e510) * _e510) * _e517);
                            let _e520 = select(340282350000000000000000000000000000000f, _e518, (_e518 < 340282350000000000000000000000000000000f));
                            let _e525 = (((_e233 * _e510) * _e510) * _e517);
                            let _e527 = select(340282350000000000000000000000000000000f, _e525, (_e525 < 340282350000000000000000000000000000000f));
                            phi_860_ = select(-340282350000000000000000000000000000000f, _e527, (_e527 > -340282350000000000000000000000000000000f));
                            phi_861_ = select(-340282350000000000000000000000000000000f, _e520, (_e520 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_860_ = 0f;
                            phi_861_ = 1f;
                        }
                        let _e531 = phi_860_;
                        let _e533 = phi_861_;
                        local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 3>(bitcast<f32>(_e109), bitcast<f32>(_e113), bitcast<f32>(_e117));
                        let _e538 = (_e355 % 3u);
                        let _e539 = (_e538 < 3u);
                        if _e539 {
                        } else {
                            break;
                        }
                        let _e541 = local_9[_e538];
                        let _e542 = (_e354 % 3u);
                        let _e543 = (_e542 < 3u);
                        if _e543 {
                        } else {
                            break;
                        }
                        let _e545 = local_9[_e542];
                        let _e546 = (_e356 % 3u);
                        let _e547 = (_e546 < 3u);
                        if _e547 {
                        } else {
                            break;
                        }
                        let _e549 = local_9[_e546];
                        local_8 = array<f32, 3>(bitcast<f32>(_e121), bitcast<f32>(_e125), bitcast<f32>(_e129));
                        if _e539 {
                        } else {
                            break;
                        }
                        let _e553 = local_8[_e538];
                        if _e543 {
                        } else {
                            break;
                        }
                        let _e555 = local_8[_e542];
                        if _e547 {
                        } else {
                            break;
                        }
                        let _e557 = local_8[_e546];
                        phi_3433_ = false;
                        phi_934_ = type_46(_e531, false);
                        phi_937_ = type_62(type_60(array<f32, 3>(_e541, _e545, _e549), array<f32, 3>(_e553, _e555, _e557)), select(0u, 2147483648u, (_e91 == 0u)));
                        phi_939_ = ((3u * _e91) + 1u);
                        phi_941_ = (_e533 <= _e531);
                        phi_943_ = 0u;
                        loop {
                            let _e565 = phi_3433_;
                            let _e567 = phi_934_;
                            let _e569 = phi_937_;
                            let _e571 = phi_939_;
                            let _e573 = phi_941_;
                            let _e575 = phi_943_;
                            local_11 = _e567;
                            if _e573 {
                                phi_954_ = true;
                            } else {
                                phi_954_ = (_e575 > 0u);
                            }
                            let _e578 = phi_954_;
                            if _e578 {
                                let _e579 = (_e571 > 0u);
                                if _e579 {
                                    if _e573 {
                                        phi_1040_ = _e569;
                                        phi_1041_ = _e573;
                                        phi_1042_ = _e575;
                                    } else {
                                        let _e580 = (_e575 - 1u);
                                        let _e581 = (_e580 % 128u);
                                        let _e582 = (_e581 < 128u);
                                        if _e582 {
                                        } else {
                                            phi_3593_ = true;
                                            break;
                                        }
                                        let _e584 = local_6[_e581];
                                        if _e582 {
                                        } else {
                                            phi_3593_ = true;
                                            break;
                                        }
                                        let _e586 = local_5[_e581];
                                        if _e582 {
                                        } else {
                                            phi_3593_ = true;
                                            break;
                                        }
                                        let _e588 = local_4[_e581];
                                        if _e582 {
                                        } else {
                                            phi_3593_ = true;
                                            break;
                                        }
                                        let _e590 = local_3[_e581];
                                        if _e582 {
                                        } else {
                                            phi_3593_ = true;
                                            break;
                                        }
                                        let _e593 = local_2[_e581];
                                        if _e582 {
                                        } else {
                                            phi_3593_ = true;
                                            break;
                                        }
                                        let _e595 = local_1[_e581];
                                        if _e582 {
                                        } else {
                                            phi_3593_ = true;
                                            break;
                                        }
                                        let _e597 = local[_e581];
                                        if _e582 {
                                        } else {
                                            phi_3593_ = true;
                                            break;
                                        }
                                        let _e602 = local_7[_e581];
                                        phi_1040_ = type_62(type_60(array<f32, 3>(_e586, _e588, _e590), array<f32, 3>(_e593, _e595, _e597)), _e584);
                                        phi_1041_ = (_e602 <= _e567.member);
                                        phi_1042_ = _e580;
                                    }
                                    let _e606 = phi_1040_;
                                    let _e608 = phi_1041_;
                                    let _e610 = phi_1042_;
                                    if _e608 {
                                        if ((_e606.member_1 & 2147483648u) != 0u) {
                                            phi_1060_ = _e567;
                                            phi_1063_ = type_8(0u, ((_e606.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e962 = phi_1060_;
                                                let _e964 = phi_1063_;
                                                local_10 = _e962;
                                                local_12 = _e962;
                                                if (_e964.member < _e964.member_1) {
                                                    phi_1064_ = type_8((_e964.member + 1u), _e964.member_1);
                                                    phi_1086_ = type_8(1u, _e964.member);
                                                } else {
                                                    phi_1064_ = _e964;
                                                    phi_1086_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e977 = phi_1064_;
                                                let _e979 = phi_1086_;
                                                let _e983 = (bitcast<i32>(_e979.member) != 0i);
                                                if _e983 {
                                                    let _e984 = ((_e606.member_1 & 268435455u) + _e979.member_1);
                                                    let _e985 = (_e984 < _e93);
                                                    if _e985 {
                                                        if _e985 {
                                                        } else {
                                                            phi_3427_ = true;
                                                            break;
                                                        }
                                                        let _e989 = global_5.member[_e984].member_1;
                                                        phi_1107_ = _e989;
                                                    } else {
                                                        phi_1107_ = 4294967295u;
                                                    }
                                                    let _e991 = phi_1107_;
                                                    if (_e984 >= _e93) {
                                                        phi_1196_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e985 {
                                                        } else {
                                                            phi_3427_ = true;
                                                            break;
                                                        }
                                                        if (_e538 < 9u) {
                                                        } else {
                                                            phi_3427_ = true;
                                                            break;
                                                        }
                                                        let _e998 = global_5.member[_e984].member[_e538];
                                                        if (_e542 < 9u) {
                                                        } else {
                                                            phi_3427_ = true;
                                                            break;
                                                        }
                                                        let _e1004 = global_5.member[_e984].member[_e542];
                                                        if (_e546 < 9u) {
                                                        } else {
                                                            phi_3427_ = true;
                                                            break;
                                                        }
                                                        let _e1010 = global_5.member[_e984].member[_e546];
                                                        let _e1012 = (3u + _e538);
                                                        if (_e1012 < 9u) {
                                                        } else {
                                                            phi_3427_ = true;
                                                            break;
                                                        }
                                                        let _e1018 = global_5.member[_e984].member[_e1012];
                                                        let _e1019 = (3u + _e542);
                                                        if (_e1019 < 9u) {
                                                        } else {
                                                            phi_3427_ = true;
                                                            break;
                                                        }
                                                        let _e1025 = global_5.member[_e984].member[_e1019];
                                                        let _e1026 = (3u + _e546);
                                                        if (_e1026 < 9u) {
                                                        } else {
                                                            phi_3427_ = true;
                                                            break;
                                                        }
                                                        let _e1032 = global_5.member[_e984].member[_e1026];
                                                        let _e1034 = (6u + _e538);
                                                        if (_e1034 < 9u) {
                                                        } else {
                                                            phi_3427_ = true;
                                                            break;
                                                        }
                                                        let _e1040 = global_5.member[_e984].member[_e1034];
                                                        let _e1041 = (6u + _e542);
                                                        if (_e1041 < 9u) {
                                                        } else {
                                                            phi_3427_ = true;
                                                            break;
                                                        }
                                                        let _e1047 = global_5.member[_e984].member[_e1041];
                                                        let _e1048 = (6u + _e546);
                                                        if (_e1048 < 9u) {
                                                        } else {
                                                            phi_3427_ = true;
                                                            break;
                                                        }
                                                        let _e1054 = global_5.member[_e984].member[_e1048];
                                                        phi_1196_ = array<array<f32, 3>, 3>(array<f32, 3>(_e998, _e1004, _e1010), array<f32, 3>(_e1018, _e1025, _e1032), array<f32, 3>(_e1040, _e1047, _e1054));
                                                    }
                                                    let _e1058 = phi_1196_;
                                                    let _e1066 = (_e1058[0][2] - _e460);
                                                    let _e1069 = (((_e1058[0][0] - _e387) * _e484) - (_e1066 * _e412));
                                                    let _e1072 = (((_e1058[0][1] - _e424) * _e484) - (_e1066 * _e448));
                                                    let _e1079 = (_e1058[1][2] - _e460);
                                                    let _e1082 = (((_e1058[1][0] - _e387) * _e484) - (_e1079 * _e412));
                                                    let _e1085 = (((_e1058[1][1] - _e424) * _e484) - (_e1079 * _e448));
                                                    let _e1092 = (_e1058[2][2] - _e460);
                                                    let _e1095 = (((_e1058[2][0] - _e387) * _e484) - (_e1092 * _e412));
                                                    let _e1098 = (((_e1058[2][1] - _e424) * _e484) - (_e1092 * _e448));
                                                    let _e1099 = (_e1095 * _e1085);
                                                    let _e1100 = (_e1098 * _e1082);
                                                    let _e1101 = (_e1069 * _e1098);
                                                    let _e1102 = (_e1072 * _e1095);
                                                    let _e1103 = (_e1082 * _e1072);
                                                    let _e1104 = (_e1085 * _e1069);
                                                    let _e1109 = (((_e1099 >= _e1100) && (_e1101 >= _e1102)) && (_e1103 >= _e1104));
                                                    if (_e1109 || (((_e1099 <= _e1100) && (_e1101 <= _e1102)) && (_e1103 <= _e1104))) {
                                                        let _e1116 = select(-1f, 1f, _e1109);
                                                        let _e1118 = ((_e1099 - _e1100) * _e1116);
                                                        let _e1120 = select(0f, _e1118, (_e1118 > 0f));
                                                        let _e1122 = ((_e1101 - _e1102) * _e1116);
                                                        let _e1124 = select(0f, _e1122, (_e1122 > 0f));
                                                        let _e1126 = ((_e1103 - _e1104) * _e1116);
                                                        let _e1128 = select(0f, _e1126, (_e1126 > 0f));
                                                        let _e1130 = ((_e1120 + _e1124) + _e1128);
                                                        if (_e1130 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2021_ = type_27();
                                                            phi_2022_ = true;
                                                            phi_2023_ = false;
                                                        } else {
                                                            let _e1133 = select(_e1082, _e1069, (_e1069 < _e1082));
                                                            if (select(_e1095, _e1133, (_e1133 < _e1095)) > 0f) {
                                                                phi_1313_ = true;
                                                            } else {
                                                                let _e1138 = select(_e1082, _e1069, (_e1069 > _e1082));
                                                                phi_1313_ = (select(_e1095, _e1138, (_e1138 > _e1095)) < 0f);
                                                            }
                                                            let _e1143 = phi_1313_;
                                                            if _e1143 {
                                                                phi_2018_ = type_27();
                                                                phi_2019_ = true;
                                                                phi_2020_ = false;
                                                            } else {
                                                                let _e1145 = select(_e1085, _e1072, (_e1072 < _e1085));
                                                                if (select(_e1098, _e1145, (_e1145 < _e1098)) > 0f) {
                                                                    phi_1342_ = true;
                                                                } else {
                                                                    let _e1150 = select(_e1085, _e1072, (_e1072 > _e1085));
                                                                    phi_1342_ = (select(_e1098, _e1150, (_e1150 > _e1098)) < 0f);
                                                                }
                                                                let _e1155 = phi_1342_;
                                                                if _e1155 {
                                                                    phi_2016_ = type_27();
                                                                    phi_2017_ = false;
                                                                } else {
                                                                    let _e1157 = select(_e1058[1][0], _e1058[0][0], (_e1058[0][0] < _e1058[1][0]));
                                                                    let _e1161 = select(_e1058[1][0], _e1058[0][0], (_e1058[0][0] > _e1058[1][0]));
                                                                    let _e1165 = select(_e1058[1][1], _e1058[0][1], (_e1058[0][1] < _e1058[1][1]));
                                                                    let _e1169 = select(_e1058[1][1], _e1058[0][1], (_e1058[0][1] > _e1058[1][1]));
                                                                    let _e1173 = select(_e1058[1][2], _e1058[0][2], (_e1058[0][2] < _e1058[1][2]));
                                                                    let _e1177 = select(_e1058[1][2], _e1058[0][2], (_e1058[0][2] > _e1058[1][2]));
                                                                    let _e1182 = ((select(_e1058[2][0], _e1157, (_e1157 < _e1058[2][0])) - _e410) * _e415);
                                                                    let _e1183 = ((select(_e1058[2][0], _e1161, (_e1161 > _e1058[2][0])) - _e411) * _e415);
                                                                    let _e1186 = ((select(_e1058[2][1], _e1165, (_e1165 < _e1058[2][1])) - _e446) * _e451);
                                                                    let _e1187 = ((select(_e1058[2][1], _e1169, (_e1169 > _e1058[2][1])) - _e447) * _e451);
                                                                    let _e1190 = ((select(_e1058[2][2], _e1173, (_e1173 < _e1058[2][2])) - _e482) * _e487);
                                                                    let _e1191 = ((select(_e1058[2][2], _e1177, (_e1177 > _e1058[2][2])) - _e483) * _e487);
                                                                    let _e1193 = select(_e1191, _e1190, (_e1190 < _e1191));
                                                                    let _e1195 = select(_e1191, _e1190, (_e1190 > _e1191));
                                                                    let _e1197 = select(_e1183, _e1182, (_e1182 < _e1183));
                                                                    let _e1199 = select(_e1187, _e1186, (_e1186 < _e1187));
                                                                    let _e1201 = select(_e1199, _e1197, (_e1197 > _e1199));
                                                                    let _e1203 = select(_e1193, _e1201, (_e1201 > _e1193));
                                                                    let _e1205 = select(_e1183, _e1182, (_e1182 > _e1183));
                                                                    let _e1207 = select(_e1187, _e1186, (_e1186 > _e1187));
                                                                    let _e1209 = select(_e1207, _e1205, (_e1205 < _e1207));
                                                                    let _e1211 = select(_e1195, _e1209, (_e1209 < _e1195));
                                                                    let _e1212 = -(_e1193);
                                                                    let _e1218 = select(_e533, _e1203, (_e1203 > _e533));
                                                                    if (_e1218 > (_e1211 + (select(_e1212, _e1195, (_e1195 > _e1212)) * 0.0000019073523f))) {
                                                                        phi_2011_ = type_27();
                                                                        phi_2012_ = true;
                                                                    } else {
                                                                        let _e1220 = (_e1218 > _e962.member);
                                                                        if _e1220 {
                                                                            phi_2010_ = type_27();
                                                                        } else {
                                                                            let _e1221 = vec3<f32>(_e1058[0][0], _e1058[0][1], _e1058[0][2]);
                                                                            let _e1222 = vec3<f32>(_e1058[1][0], _e1058[1][1], _e1058[1][2]);
                                                                            let _e1223 = vec3<f32>(_e1058[2][0], _e1058[2][1], _e1058[2][2]);
                                                                            let _e1224 = (_e1058[1][0] - _e1058[0][0]);
                                                                            let _e1225 = (_e1058[1][1] - _e1058[0][1]);
                                                                            let _e1226 = (_e1058[1][2] - _e1058[0][2]);
                                                                            let _e1227 = vec3<f32>(_e1224, _e1225, _e1226);
                                                                            let _e1228 = (_e1058[2][0] - _e1058[1][0]);
                                                                            let _e1229 = (_e1058[2][1] - _e1058[1][1]);
                                                                            let _e1230 = (_e1058[2][2] - _e1058[1][2]);
                                                                            let _e1231 = vec3<f32>(_e1228, _e1229, _e1230);
                                                                            let _e1232 = (_e1058[0][0] - _e1058[2][0]);
                                                                            let _e1233 = (_e1058[0][1] - _e1058[2][1]);
                                                                            let _e1234 = (_e1058[0][2] - _e1058[2][2]);
                                                                            let _e1235 = vec3<f32>(_e1232, _e1233, _e1234);
                                                                            let _e1238 = bitcast<f32>((bitcast<u32>(_e1224) & 2147483647u));
                                                                            let _e1241 = bitcast<f32>((bitcast<u32>(_e1225) & 2147483647u));
                                                                            let _e1243 = select(_e1241, _e1238, (_e1238 > _e1241));
                                                                            let _e1246 = bitcast<f32>((bitcast<u32>(_e1226) & 2147483647u));
                                                                            let _e1248 = select(_e1246, _e1243, (_e1243 > _e1246));
                                                                            let _e1251 = bitcast<f32>((bitcast<u32>(_e1228) & 2147483647u));
                                                                            let _e1254 = bitcast<f32>((bitcast<u32>(_e1229) & 2147483647u));
                                                                            let _e1256 = select(_e1254, _e1251, (_e1251 > _e1254));
                                                                            let _e1259 = bitcast<f32>((bitcast<u32>(_e1230) & 2147483647u));
                                                                            let _e1261 = select(_e1259, _e1256, (_e1256 > _e1259));
                                                                            let _e1264 = bitcast<f32>((bitcast<u32>(_e1232) & 2147483647u));
                                                                            let _e1267 = bitcast<f32>((bitcast<u32>(_e1233) & 2147483647u));
                                                                            let _e1269 = select(_e1267, _e1264, (_e1264 > _e1267));
                                                                            let _e1272 = bitcast<f32>((bitcast<u32>(_e1234) & 2147483647u));
                                                                            let _e1274 = select(_e1272, _e1269, (_e1269 > _e1272));
                                                                            let _e1276 = select(_e1261, _e1248, (_e1248 > _e1261));
                                                                            let _e1278 = select(_e1274, _e1276, (_e1276 > _e1274));
                                                                            if (_e1248 == _e1278) {
                                                                                phi_1743_ = _e1085;
                                                                                phi_1744_ = _e1082;
                                                                                phi_1745_ = _e1072;
                                                                                phi_1746_ = _e1069;
                                                                                phi_1747_ = _e1221;
                                                                                phi_1748_ = _e1235;
                                                                                phi_1749_ = _e1231;
                                                                                phi_1750_ = _e1227;
                                                                            } else {
                                                                                let _e1280 = (_e1261 == _e1278);
                                                                                let _e1285 = vec3(_e1280);
                                                                                phi_1743_ = select(_e1072, _e1098, _e1280);
                                                                                phi_1744_ = select(_e1069, _e1095, _e1280);
                                                                                phi_1745_ = select(_e1098, _e1085, _e1280);
                                                                                phi_1746_ = select(_e1095, _e1082, _e1280);
                                                                                phi_1747_ = select(_e1223, _e1222, _e1285);
                                                                                phi_1748_ = select(_e1231, _e1227, _e1285);
                                                                                phi_1749_ = select(_e1227, _e1235, _e1285);
                                                                                phi_1750_ = select(_e1235, _e1231, _e1285);
                                                                            }
                                                                            let _e1291 = phi_1743_;
                                                                            let _e1293 = phi_1744_;
                                                                            let _e1295 = phi_1745_;
                                                                            let _e1297 = phi_1746_;
                                                                            let _e1299 = phi_1747_;
                                                                            let _e1301 = phi_1748_;
                                                                            let _e1303 = phi_1749_;
                                                                            let _e1305 = phi_1750_;
                                                                            let _e1312 = ((_e1303.y * _e1301.z) - (_e1301.y * _e1303.z));
                                                                            let _e1317 = ((_e1303.z * _e1301.x) - (_e1301.z * _e1303.x));
                                                                            let _e1320 = ((_e1303.x * _e1301.y) - (_e1301.x * _e1303.y));
                                                                            if (_e1120 >= _e1124) {
                                                                                phi_1781_ = select(true, false, (_e1120 >= _e1128));
                                                                            } else {
                                                                                phi_1781_ = true;
                                                                            }
                                                                            let _e1325 = phi_1781_;
                                                                            if _e1325 {
                                                                                phi_1790_ = select(_e1223, _e1222, vec3((_e1124 >= _e1128)));
                                                                            } else {
                                                                                phi_1790_ = _e1221;
                                                                            }
                                                                            let _e1330 = phi_1790_;
                                                                            let _e1341 = (((_e1312 * (_e1330.x - _e387)) + (_e1317 * (_e1330.y - _e424))) + (_e1320 * (_e1330.z - _e460)));
                                                                            let _e1346 = (((_e1312 * _e412) + (_e1317 * _e448)) + (_e1320 * _e484));
                                                                            let _e1347 = (_e1293 - _e1297);
                                                                            let _e1348 = (_e1291 - _e1295);
                                                                            let _e1356 = (-(((_e1297 * _e1347) + (_e1295 * _e1348))) / ((_e1347 * _e1347) + (_e1348 * _e1348)));
                                                                            let _e1358 = select(1f, _e1356, (_e1356 < 1f));
                                                                            let _e1360 = select(0f, _e1358, (_e1358 > 0f));
                                                                            let _e1373 = ((_e1299.x + (_e1305.x * _e1360)) - _e387);
                                                                            let _e1374 = ((_e1299.y + (_e1305.y * _e1360)) - _e424);
                                                                            let _e1375 = ((_e1299.z + (_e1305.z * _e1360)) - _e460);
                                                                            let _e1376 = (_e1375 / _e484);
                                                                            let _e1388 = bitcast<f32>((bitcast<u32>(_e1373) & 2147483647u));
                                                                            let _e1391 = bitcast<f32>((bitcast<u32>(_e1374) & 2147483647u));
                                                                            let _e1393 = select(_e1391, _e1388, (_e1388 > _e1391));
                                                                            let _e1396 = bitcast<f32>((bitcast<u32>(_e1375) & 2147483647u));
                                                                            let _e1398 = select(_e1396, _e1393, (_e1393 > _e1396));
                                                                            let _e1404 = bitcast<f32>((bitcast<u32>(_e1312) & 2147483647u));
                                                                            let _e1407 = bitcast<f32>((bitcast<u32>(_e1317) & 2147483647u));
                                                                            let _e1409 = select(_e1407, _e1404, (_e1404 > _e1407));
                                                                            let _e1412 = bitcast<f32>((bitcast<u32>(_e1320) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1312 * _e1373) + (_e1317 * _e1374)) + (_e1320 * _e1375)) - _e1341)) & 2147483647u)) <= ((0.0000009536743f * select(_e1278, _e1398, (_e1398 > _e1278))) * select(_e1412, _e1409, (_e1409 > _e1412)))) {
                                                                                let _e1422 = bitcast<f32>((bitcast<u32>(_e1303.x) & 2147483647u));
                                                                                let _e1425 = bitcast<f32>((bitcast<u32>(_e1303.y) & 2147483647u));
                                                                                let _e1427 = select(_e1425, _e1422, (_e1422 > _e1425));
                                                                                let _e1430 = bitcast<f32>((bitcast<u32>(_e1303.z) & 2147483647u));
                                                                                let _e1436 = bitcast<f32>((bitcast<u32>(_e1301.x) & 2147483647u));
                                                                                let _e1439 = bitcast<f32>((bitcast<u32>(_e1301.y) & 2147483647u));
                                                                                let _e1441 = select(_e1439, _e1436, (_e1436 > _e1439));
                                                                                let _e1444 = bitcast<f32>((bitcast<u32>(_e1301.z) & 2147483647u));
                                                                                let _e1448 = (bitcast<f32>((bitcast<u32>(_e1346) & 2147483647u)) > ((0.0000038146973f * select(_e1430, _e1427, (_e1427 > _e1430))) * select(_e1444, _e1441, (_e1441 > _e1444))));
                                                                                if _e1448 {
                                                                                    phi_1955_ = (_e1341 / _e1346);
                                                                                } else {
                                                                                    phi_1955_ = f32();
                                                                                }
                                                                                let _e1451 = phi_1955_;
                                                                                phi_1957_ = _e1451;
                                                                                phi_1958_ = select(true, false, _e1448);
                                                                            } else {
                                                                                phi_1957_ = f32();
                                                                                phi_1958_ = true;
                                                                            }
                                                                            let _e1454 = phi_1957_;
                                                                            let _e1456 = phi_1958_;
                                                                            if _e1456 {
                                                                                let _e1464 = (((_e1312 * (_e1373 - (_e412 * _e1376))) + (_e1317 * (_e1374 - (_e448 * _e1376)))) / _e1346);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1464) & 2147483647u)) <= _e1278) {
                                                                                    phi_1978_ = (_e1376 + _e1464);
                                                                                } else {
                                                                                    phi_1978_ = _e1376;
                                                                                }
                                                                                let _e1471 = phi_1978_;
                                                                                phi_1979_ = _e1471;
                                                                            } else {
                                                                                phi_1979_ = _e1454;
                                                                            }
                                                                            let _e1473 = phi_1979_;
                                                                            let _e1475 = select(_e1211, _e1473, (_e1473 < _e1211));
                                                                            let _e1477 = select(_e1203, _e1475, (_e1475 > _e1203));
                                                                            if (_e1477 >= _e533) {
                                                                                let _e1479 = (_e1477 <= _e962.member);
                                                                                if _e1479 {
                                                                                    let _e1480 = (1f / _e1130);
                                                                                    phi_2002_ = type_27(_e1477, (_e1124 * _e1480), (_e1128 * _e1480), _e991);
                                                                                } else {
                                                                                    phi_2002_ = type_27();
                                                                                }
                                                                                let _e1485 = phi_2002_;
                                                                                phi_2004_ = _e1485;
                                                                                phi_2005_ = select(true, false, _e1479);
                                                                            } else {
                                                                                phi_2004_ = type_27();
                                                                                phi_2005_ = true;
                                                                            }
                                                                            let _e1488 = phi_2004_;
                                                                            let _e1490 = phi_2005_;
                                                                            if _e1490 {
                                                                                phi_2009_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2009_ = _e1488;
                                                                            }
                                                                            let _e1492 = phi_2009_;
                                                                            phi_2010_ = _e1492;
                                                                        }
                                                                        let _e1494 = phi_2010_;
                                                                        phi_2011_ = _e1494;
                                                                        phi_2012_ = _e1220;
                                                                    }
                                                                    let _e1496 = phi_2011_;
                                                                    let _e1498 = phi_2012_;
                                                                    phi_2016_ = _e1496;
                                                                    phi_2017_ = _e1498;
                                                                }
                                                                let _e1500 = phi_2016_;
                                                                let _e1502 = phi_2017_;
                                                                phi_2018_ = _e1500;
                                                                phi_2019_ = _e1155;
                                                                phi_2020_ = _e1502;
                                                            }
                                                            let _e1504 = phi_2018_;
                                                            let _e1506 = phi_2019_;
                                                            let _e1508 = phi_2020_;
                                                            phi_2021_ = _e1504;
                                                            phi_2022_ = _e1506;
                                                            phi_2023_ = _e1508;
                                                        }
                                                        let _e1510 = phi_2021_;
                                                        let _e1512 = phi_2022_;
                                                        let _e1514 = phi_2023_;
                                                        phi_2031_ = _e1510;
                                                        phi_2032_ = select(_e1514, true, _e1512);
                                                    } else {
                                                        phi_2031_ = type_27();
                                                        phi_2032_ = true;
                                                    }
                                                    let _e1517 = phi_2031_;
                                                    let _e1519 = phi_2032_;
                                                    if _e1519 {
                                                        phi_2036_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2036_ = _e1517;
                                                    }
                                                    let _e1521 = phi_2036_;
                                                    if (_e1521.member_3 != 4294967295u) {
                                                        if (_e991 == _e150) {
                                                            phi_2365_ = false;
                                                        } else {
                                                            let _e1525 = (_e991 < arrayLength((&global_6.member)));
                                                            if _e1525 {
                                                                if _e1525 {
                                                                } else {
                                                                    phi_3427_ = true;
                                                                    break;
                                                                }
                                                                let _e1527 = global_6.member[_e991];
                                                                phi_2059_ = _e1527;
                                                            } else {
                                                                phi_2059_ = 4294967295u;
                                                            }
                                                            let _e1529 = phi_2059_;
                                                            let _e1530 = (_e1529 < arrayLength((&global_7.member)));
                                                            if _e1530 {
                                                                if _e1530 {
                                                                } else {
                                                                    phi_3427_ = true;
                                                                    break;
                                                                }
                                                                let _e1532 = global_7.member[_e1529];
                                                                phi_2073_ = _e1532;
                                                            } else {
                                                                phi_2073_ = 0i;
                                                            }
                                                            let _e1534 = phi_2073_;
                                                            let _e1535 = (_e1534 == 0i);
                                                            if _e1535 {
                                                                phi_2364_ = true;
                                                            } else {
                                                                if _e379 {
                                                                    phi_2094_ = vec3<f32>(_e1058[0][0], _e1058[0][1], _e1058[0][2]);
                                                                } else {
                                                                    if (_e355 == 1u) {
                                                                        phi_2093_ = vec3<f32>(_e1058[0][2], _e1058[0][0], _e1058[0][1]);
                                                                    } else {
                                                                        phi_2093_ = vec3<f32>(_e1058[0][1], _e1058[0][2], _e1058[0][0]);
                                                                    }
                                                                    let _e1540 = phi_2093_;
                                                                    phi_2094_ = _e1540;
                                                                }
                                                                let _e1543 = phi_2094_;
                                                                if _e379 {
                                                                    phi_2111_ = vec3<f32>(_e1058[1][0], _e1058[1][1], _e1058[1][2]);
                                                                } else {
                                                                    if (_e355 == 1u) {
                                                                        phi_2110_ = vec3<f32>(_e1058[1][2], _e1058[1][0], _e1058[1][1]);
                                                                    } else {
                                                                        phi_2110_ = vec3<f32>(_e1058[1][1], _e1058[1][2], _e1058[1][0]);
                                                                    }
                                                                    let _e1548 = phi_2110_;
                                                                    phi_2111_ = _e1548;
                                                                }
                                                                let _e1551 = phi_2111_;
                                                                if _e379 {
                                                                    phi_2128_ = vec3<f32>(_e1058[2][0], _e1058[2][1], _e1058[2][2]);
                                                                } else {
                                                                    if (_e355 == 1u) {
                                                                        phi_2127_ = vec3<f32>(_e1058[2][2], _e1058[2][0], _e1058[2][1]);
                                                                    } else {
                                                                        phi_2127_ = vec3<f32>(_e1058[2][1], _e1058[2][2], _e1058[2][0]);
                                                                    }
                                                                    let _e1556 = phi_2127_;
                                                                    phi_2128_ = _e1556;
                                                                }
                                                                let _e1559 = phi_2128_;
                                                                let _e1562 = (_e1551.x - _e1543.x);
                                                                let _e1565 = (_e1551.y - _e1543.y);
                                                                let _e1568 = (_e1551.z - _e1543.z);
                                                                let _e1570 = (_e1559.x - _e1543.x);
                                                                let _e1572 = (_e1559.y - _e1543.y);
                                                                let _e1574 = (_e1559.z - _e1543.z);
                                                                if (_e222.member_1 == 1u) {
                                                                    phi_2164_ = (vec3<f32>(_e222.member[0], _e222.member[1], _e222.member[2]) - _e1543);
                                                                } else {
                                                                    phi_2164_ = vec3<f32>(_e222.member[0], _e222.member[1], _e222.member[2]);
                                                                }
                                                                let _e1589 = phi_2164_;
                                                                let _e1595 = bitcast<f32>((bitcast<u32>((_e1562 * _e1572)) ^ _e222.member_3[0]));
                                                                let _e1599 = bitcast<f32>((bitcast<u32>((_e1565 * _e1570)) ^ _e222.member_3[0]));
                                                                let _e1603 = bitcast<f32>((bitcast<u32>((_e1565 * _e1574)) ^ _e222.member_3[0]));
                                                                let _e1607 = bitcast<f32>((bitcast<u32>((_e1568 * _e1572)) ^ _e222.member_3[0]));
                                                                let _e1611 = bitcast<f32>((bitcast<u32>((_e1568 * _e1570)) ^ _e222.member_3[0]));
                                                                let _e1615 = bitcast<f32>((bitcast<u32>((_e1562 * _e1574)) ^ _e222.member_3[0]));
                                                                let _e1616 = (_e1603 - _e1607);
                                                                let _e1617 = (_e1611 - _e1615);
                                                                let _e1618 = (_e1595 - _e1599);
                                                                let _e1642 = (bitcast<f32>((bitcast<u32>(_e1603) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1607) & 2147483647u)));
                                                                let _e1649 = (bitcast<f32>((bitcast<u32>(_e1611) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1615) & 2147483647u)));
                                                                let _e1656 = (bitcast<f32>((bitcast<u32>(_e1595) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1599) & 2147483647u)));
                                                                if (_e222.member_2 == 0f) {
                                                                    phi_2346_ = 0f;
                                                                } else {
                                                                    let _e1686 = bitcast<f32>((bitcast<u32>(_e1616) & 2147483647u));
                                                                    let _e1689 = bitcast<f32>((bitcast<u32>(_e1617) & 2147483647u));
                                                                    let _e1692 = bitcast<f32>((bitcast<u32>(_e1618) & 2147483647u));
                                                                    let _e1694 = select(_e1692, _e1689, (_e1689 > _e1692));
                                                                    let _e1698 = select(_e1692, _e1689, (_e1689 < _e1692));
                                                                    let _e1702 = select(_e1689, _e1686, (_e1686 < _e1689));
                                                                    let _e1704 = select(_e1689, _e1686, (_e1686 > _e1689));
                                                                    let _e1706 = select(_e1692, _e1704, (_e1704 < _e1692));
                                                                    phi_2346_ = bitcast<f32>((bitcast<u32>((_e222.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1694, _e1686, (_e1686 > _e1694)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1706, _e1702, (_e1702 > _e1706)))) ^ _e222.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1698, _e1686, (_e1686 < _e1698)))) ^ _e222.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1642 + _e1649) + _e1656))) ^ _e222.member_3[0]))) * 1.0000005f)) ^ _e222.member_3[0])))) ^ _e222.member_3[0]));
                                                                }
                                                                let _e1733 = phi_2346_;
                                                                phi_2364_ = (_e1535 || !(((((bitcast<f32>((bitcast<u32>((_e1589.x * _e1616)) ^ _e222.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1589.y * _e1617)) ^ _e222.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1589.z * _e1618)) ^ _e222.member_3[0]))) * f32(-(_e1534))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1589.x) & 2147483647u)) * _e1642)) ^ _e222.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1589.y) & 2147483647u)) * _e1649)) ^ _e222.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1589.z) & 2147483647u)) * _e1656)) ^ _e222.member_3[0]))))) ^ _e222.member_3[0])) + _e1733) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1747 = phi_2364_;
                                                            phi_2365_ = _e1747;
                                                        }
                                                        let _e1749 = phi_2365_;
                                                        if _e1749 {
                                                            phi_2370_ = type_46(_e962.member, true);
                                                        } else {
                                                            phi_2370_ = _e962;
                                                        }
                                                        let _e1754 = phi_2370_;
                                                        phi_2371_ = _e1754;
                                                    } else {
                                                        phi_2371_ = _e962;
                                                    }
                                                    let _e1756 = phi_2371_;
                                                    phi_1061_ = _e1756;
                                                } else {
                                                    phi_1061_ = type_46();
                                                }
                                                let _e1758 = phi_1061_;
                                                continue;
                                                continuing {
                                                    phi_1060_ = _e1758;
                                                    phi_1063_ = _e977;
                                                    phi_3427_ = _e565;
                                                    break if !(_e983);
                                                }
                                            }
                                            let _e1761 = phi_3427_;
                                            phi_3593_ = _e1761;
                                            if _e1761 {
                                                break;
                                            }
                                            let _e1763 = local_10;
                                            phi_3597_ = _e1761;
                                            let _e1962 = local_12;
                                            phi_3321_ = _e1962;
                                            phi_3322_ = _e606;
                                            phi_3323_ = false;
                                            phi_3324_ = select(_e610, 0u, _e1763.member_1);
                                        } else {
                                            let _e619 = (_e606.member_1 < _e91);
                                            if _e619 {
                                                if _e619 {
                                                } else {
                                                    phi_3593_ = true;
                                                    break;
                                                }
                                                let _e621 = global_10.member[_e606.member_1];
                                                phi_2391_ = _e621;
                                            } else {
                                                phi_2391_ = type_55(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e623 = phi_2391_;
                                            let _e638 = ((10u * _e355) & 31u);
                                            let _e641 = ((_e623.member[0] >> bitcast<u32>(_e638)) & 1023u);
                                            let _e646 = bitcast<f32>((bitcast<u32>(((_e606.member.member_1[0] - _e606.member.member[0]) * 0.0009775171f)) ^ _e133));
                                            let _e652 = (_e606.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e641) * _e646)) ^ _e133)));
                                            let _e656 = select(select(_e606.member.member_1[0], _e652, (_e652 < _e606.member.member_1[0])), _e606.member.member_1[0], (_e641 == 1023u));
                                            let _e658 = ((10u * _e354) & 31u);
                                            let _e661 = ((_e623.member[0] >> bitcast<u32>(_e658)) & 1023u);
                                            let _e666 = bitcast<f32>((bitcast<u32>(((_e606.member.member_1[1] - _e606.member.member[1]) * 0.0009775171f)) ^ _e133));
                                            let _e672 = (_e606.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e661) * _e666)) ^ _e133)));
                                            let _e676 = select(select(_e606.member.member_1[1], _e672, (_e672 < _e606.member.member_1[1])), _e606.member.member_1[1], (_e661 == 1023u));
                                            let _e678 = ((10u * _e356) & 31u);
                                            let _e681 = ((_e623.member[0] >> bitcast<u32>(_e678)) & 1023u);
                                            let _e686 = bitcast<f32>((bitcast<u32>(((_e606.member.member_1[2] - _e606.member.member[2]) * 0.0009775171f)) ^ _e133));
                                            let _e692 = (_e606.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e681) * _e686)) ^ _e133)));
                                            let _e696 = select(select(_e606.member.member_1[2], _e692, (_e692 < _e606.member.member_1[2])), _e606.member.member_1[2], (_e681 == 1023u));
                                            let _e699 = ((_e623.member[1] >> bitcast<u32>(_e638)) & 1023u);
                                            let _e705 = (_e606.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e699) * _e646)) ^ _e133)));
                                            let _e709 = select(select(_e606.member.member_1[0], _e705, (_e705 < _e606.member.member_1[0])), _e606.member.member_1[0], (_e699 == 1023u));
                                            let _e712 = ((_e623.member[1] >> bitcast<u32>(_e658)) & 1023u);
                                            let _e718 = (_e606.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e712) * _e666)) ^ _e133)));
                                            let _e722 = select(select(_e606.member.member_1[1], _e718, (_e718 < _e606.member.member_1[1])), _e606.member.member_1[1], (_e712 == 1023u));
                                            let _e725 = ((_e623.member[1] >> bitcast<u32>(_e678)) & 1023u);
                                            let _e731 = (_e606.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e725) * _e686)) ^ _e133)));
                                            let _e735 = select(select(_e606.member.member_1[2], _e731, (_e731 < _e606.member.member_1[2])), _e606.member.member_1[2], (_e725 == 1023u));
                                            let _e741 = ((_e623.member_1[0] >> bitcast<u32>(_e638)) & 1023u);
                                            let _e747 = (_e606.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e741) * _e646)) ^ _e133)));
                                            let _e751 = select(select(_e606.member.member_1[0], _e747, (_e747 < _e606.member.member_1[0])), _e606.member.member_1[0], (_e741 == 1023u));
                                            let _e754 = ((_e623.member_1[0] >> bitcast<u32>(_e658)) & 1023u);
                                            let _e760 = (_e606.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e754) * _e666)) ^ _e133)));
                                            let _e764 = select(select(_e606.member.member_1[1], _e760, (_e760 < _e606.member.member_1[1])), _e606.member.member_1[1], (_e754 == 1023u));
                                            let _e767 = ((_e623.member_1[0] >> bitcast<u32>(_e678)) & 1023u);
                                            let _e773 = (_e606.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e767) * _e686)) ^ _e133)));
                                            let _e777 = select(select(_e606.member.member_1[2], _e773, (_e773 < _e606.member.member_1[2])), _e606.member.member_1[2], (_e767 == 1023u));
                                            let _e780 = ((_e623.member_1[1] >> bitcast<u32>(_e638)) & 1023u);
                                            let _e786 = (_e606.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e780) * _e646)) ^ _e133)));
                                            let _e790 = select(select(_e606.member.member_1[0], _e786, (_e786 < _e606.member.member_1[0])), _e606.member.member_1[0], (_e780 == 1023u));
                                            let _e793 = ((_e623.member_1[1] >> bitcast<u32>(_e658)) & 1023u);
                                            let _e799 = (_e606.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e793) * _e666)) ^ _e133)));
                                            let _e803 = select(select(_e606.member.member_1[1], _e799, (_e799 < _e606.member.member_1[1])), _e606.member.member_1[1], (_e793 == 1023u));
                                            let _e806 = ((_e623.member_1[1] >> bitcast<u32>(_e678)) & 1023u);
                                            let _e812 = (_e606.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e806) * _e686)) ^ _e133)));
                                            let _e816 = select(select(_e606.member.member_1[2], _e812, (_e812 < _e606.member.member_1[2])), _e606.member.member_1[2], (_e806 == 1023u));
                                            let _e821 = type_62(type_60(array<f32, 3>(_e656, _e676, _e696), array<f32, 3>(_e709, _e722, _e735)), _e623.member_2);
                                            let _e826 = type_62(type_60(array<f32, 3>(_e751, _e764, _e777), array<f32, 3>(_e790, _e803, _e816)), _e623.member_3);
                                            let _e832 = ((_e656 - _e410) * _e415);
                                            let _e833 = ((_e751 - _e410) * _e415);
                                            let _e834 = ((_e709 - _e411) * _e415);
                                            let _e835 = ((_e790 - _e411) * _e415);
                                            let _e840 = ((_e676 - _e446) * _e451);
                                            let _e841 = ((_e764 - _e446) * _e451);
                                            let _e842 = ((_e722 - _e447) * _e451);
                                            let _e843 = ((_e803 - _e447) * _e451);
                                            let _e848 = ((_e696 - _e482) * _e487);
                                            let _e849 = ((_e777 - _e482) * _e487);
                                            let _e850 = ((_e735 - _e483) * _e487);
                                            let _e851 = ((_e816 - _e483) * _e487);
                                            let _e853 = select(_e850, _e848, (_e848 < _e850));
                                            let _e855 = select(_e851, _e849, (_e849 < _e851));
                                            let _e857 = select(_e850, _e848, (_e848 > _e850));
                                            let _e859 = select(_e851, _e849, (_e849 > _e851));
                                            let _e861 = select(_e834, _e832, (_e832 < _e834));
                                            let _e863 = select(_e835, _e833, (_e833 < _e835));
                                            let _e865 = select(_e842, _e840, (_e840 < _e842));
                                            let _e867 = select(_e843, _e841, (_e841 < _e843));
                                            let _e869 = select(_e865, _e861, (_e861 > _e865));
                                            let _e871 = select(_e867, _e863, (_e863 > _e867));
                                            let _e873 = select(_e853, _e869, (_e869 > _e853));
                                            let _e875 = select(_e855, _e871, (_e871 > _e855));
                                            let _e877 = select(_e834, _e832, (_e832 > _e834));
                                            let _e879 = select(_e835, _e833, (_e833 > _e835));
                                            let _e881 = select(_e842, _e840, (_e840 > _e842));
                                            let _e883 = select(_e843, _e841, (_e841 > _e843));
                                            let _e885 = select(_e881, _e877, (_e877 < _e881));
                                            let _e887 = select(_e883, _e879, (_e879 < _e883));
                                            let _e892 = -(_e853);
                                            let _e893 = -(_e855);
                                            let _e900 = (select(_e857, _e885, (_e885 < _e857)) + (select(_e892, _e857, (_e857 > _e892)) * 0.0000019073523f));
                                            let _e901 = (select(_e859, _e887, (_e887 < _e859)) + (select(_e893, _e859, (_e859 > _e893)) * 0.0000019073523f));
                                            let _e903 = select(_e533, _e873, (_e873 > _e533));
                                            let _e905 = select(_e533, _e875, (_e875 > _e533));
                                            let _e910 = (_e903 <= select(_e567.member, _e900, (_e900 < _e567.member)));
                                            let _e911 = (_e905 <= select(_e567.member, _e901, (_e901 < _e567.member)));
                                            let _e912 = (_e903 <= _e905);
                                            if _e910 {
                                                if _e911 {
                                                    if _e912 {
                                                        phi_3223_ = _e826;
                                                    } else {
                                                        phi_3223_ = _e821;
                                                    }
                                                    let _e914 = phi_3223_;
                                                    let _e922 = (_e610 % 128u);
                                                    let _e923 = (_e922 < 128u);
                                                    if _e923 {
                                                    } else {
                                                        phi_3593_ = true;
                                                        break;
                                                    }
                                                    local_6[_e922] = _e914.member_1;
                                                    if _e923 {
                                                    } else {
                                                        phi_3593_ = true;
                                                        break;
                                                    }
                                                    local_5[_e922] = _e914.member.member[0];
                                                    if _e923 {
                                                    } else {
                                                        phi_3593_ = true;
                                                        break;
                                                    }
                                                    local_4[_e922] = _e914.member.member[1];
                                                    if _e923 {
                                                    } else {
                                                        phi_3593_ = true;
                                                        break;
                                                    }
                                                    local_3[_e922] = _e914.member.member[2];
                                                    if _e923 {
                                                    } else {
                                                        phi_3593_ = true;
                                                        break;
                                                    }
                                                    local_2[_e922] = _e914.member.member_1[0];
                                                    if _e923 {
                                                    } else {
                                                        phi_3593_ = true;
                                                        break;
                                                    }
                                                    local_1[_e922] = _e914.member.member_1[1];
                                                    if _e923 {
                                                    } else {
                                                        phi_3593_ = true;
                                                        break;
                                                    }
                                                    local[_e922] = _e914.member.member_1[2];
                                                    if _e923 {
                                                    } else {
                                                        phi_3593_ = true;
                                                        break;
                                                    }
                                                    local_7[_e922] = select(_e905, _e903, (_e903 > _e905));
                                                    if _e912 {
                                                        phi_3300_ = _e821;
                                                    } else {
                                                        phi_3300_ = _e826;
                                                    }
                                                    let _e940 = phi_3300_;
                                                    phi_3301_ = _e940;
                                                    phi_3302_ = (_e610 + 1u);
                                                } else {
                                                    phi_3301_ = type_62();
                                                    phi_3302_ = u32();
                                                }
                                                let _e942 = phi_3301_;
                                                let _e944 = phi_3302_;
                                                phi_3304_ = _e942;
                                                phi_3305_ = _e944;
                                                phi_3306_ = select(true, false, _e911);
                                            } else {
                                                phi_3304_ = type_62();
                                                phi_3305_ = u32();
                                                phi_3306_ = true;
                                            }
                                            let _e947 = phi_3304_;
                                            let _e949 = phi_3305_;
                                            let _e951 = phi_3306_;
                                            if _e951 {
                                                if _e910 {
                                                    phi_3313_ = _e821;
                                                } else {
                                                    phi_3313_ = _e826;
                                                }
                                                let _e953 = phi_3313_;
                                                phi_3318_ = _e953;
                                                phi_3319_ = select(_e911, true, _e910);
                                            } else {
                                                phi_3318_ = _e947;
                                                phi_3319_ = _e608;
                                            }
                                            let _e956 = phi_3318_;
                                            let _e958 = phi_3319_;
                                            phi_3597_ = _e565;
                                            phi_3321_ = _e567;
                                            phi_3322_ = _e956;
                                            phi_3323_ = _e958;
                                            phi_3324_ = select(_e949, _e610, _e951);
                                        }
                                        let _e1767 = phi_3597_;
                                        let _e1769 = phi_3321_;
                                        let _e1771 = phi_3322_;
                                        let _e1773 = phi_3323_;
                                        let _e1775 = phi_3324_;
                                        phi_3596_ = _e1767;
                                        phi_3325_ = _e1769;
                                        phi_3326_ = _e1771;
                                        phi_3327_ = (_e571 - 1u);
                                        phi_3328_ = _e1773;
                                        phi_3329_ = _e1775;
                                    } else {
                                        phi_3596_ = _e565;
                                        phi_3325_ = _e567;
                                        phi_3326_ = _e606;
                                        phi_3327_ = _e571;
                                        phi_3328_ = _e608;
                                        phi_3329_ = _e610;
                                    }
                                    let _e1777 = phi_3596_;
                                    let _e1779 = phi_3325_;
                                    let _e1781 = phi_3326_;
                                    let _e1783 = phi_3327_;
                                    let _e1785 = phi_3328_;
                                    let _e1787 = phi_3329_;
                                    phi_3595_ = _e1777;
                                    phi_3330_ = _e1779;
                                    phi_3331_ = _e1781;
                                    phi_3332_ = _e1783;
                                    phi_3333_ = _e1785;
                                    phi_3334_ = _e1787;
                                } else {
                                    phi_3595_ = _e565;
                                    phi_3330_ = type_46();
                                    phi_3331_ = type_62();
                                    phi_3332_ = u32();
                                    phi_3333_ = bool();
                                    phi_3334_ = u32();
                                }
                                let _e1789 = phi_3595_;
                                let _e1791 = phi_3330_;
                                let _e1793 = phi_3331_;
                                let _e1795 = phi_3332_;
                                let _e1797 = phi_3333_;
                                let _e1799 = phi_3334_;
                                phi_3594_ = _e1789;
                                phi_935_ = _e1791;
                                phi_938_ = _e1793;
                                phi_940_ = _e1795;
                                phi_942_ = _e1797;
                                phi_944_ = _e1799;
                                phi_3335_ = _e579;
                            } else {
                                phi_3594_ = _e565;
                                phi_935_ = type_46();
                                phi_938_ = type_62();
                                phi_940_ = u32();
                                phi_942_ = bool();
                                phi_944_ = u32();
                                phi_3335_ = false;
                            }
                            let _e1801 = phi_3594_;
                            let _e1803 = phi_935_;
                            let _e1805 = phi_938_;
                            let _e1807 = phi_940_;
                            let _e1809 = phi_942_;
                            let _e1811 = phi_944_;
                            let _e1813 = phi_3335_;
                            continue;
                            continuing {
                                phi_3433_ = _e1801;
                                phi_934_ = _e1803;
                                phi_937_ = _e1805;
                                phi_939_ = _e1807;
                                phi_941_ = _e1809;
                                phi_943_ = _e1811;
                                phi_3593_ = _e1801;
                                break if !(_e1813);
                            }
                        }
                        let _e1816 = phi_3593_;
                        if _e1816 {
                            break;
                        }
                        let _e1818 = local_11;
                        if _e1818.member_1 {
                        } else {
                            if _e223 {
                            } else {
                                break;
                            }
                            let _e1822 = global_2.member[_e137];
                            if _e144 {
                            } else {
                                break;
                            }
                            let _e1826 = global_9.member[_e137].member_1;
                            if _e223 {
                            } else {
                                break;
                            }
                            global_2.member[_e137] = type_29(_e1822.member, _e1822.member_1, _e1822.member_2, array<f32, 3>((_e1822.member_3[0] + (_e1826[0] * _e1822.member_1[0])), (_e1822.member_3[1] + (_e1826[1] * _e1822.member_1[1])), (_e1822.member_3[2] + (_e1826[2] * _e1822.member_1[2]))), _e1822.member_4);
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
fn trace_shadows_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
