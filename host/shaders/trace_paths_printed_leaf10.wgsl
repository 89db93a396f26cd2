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

struct type_22 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_24 {
    member: array<type_22>,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_27 {
    member: type_26,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_29 {
    member: array<type_27>,
}

struct type_35 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_38 {
    member: type_22,
    member_1: f32,
}

struct type_41 {
    member: array<vec4<u32>, 2>,
}

struct type_44 {
    member: array<i32>,
}

struct type_48 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_50 {
    member: array<type_48>,
}

struct type_53 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_55 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_57 {
    member: array<type_55>,
}

struct type_61 {
    member: type_53,
    member_1: u32,
}

struct type_66 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_41;
@group(0) @binding(2) 
var<uniform> global_3: type_41;
@group(0) @binding(5) 
var<storage> global_4: type_4;
@group(0) @binding(6) 
var<storage> global_5: type_44;
@group(0) @binding(7) 
var<storage> global_6: type_29;
@group(0) @binding(8) 
var<storage, read_write> global_7: type_24;
@group(0) @binding(9) 
var<storage, read_write> global_8: type_66;
@group(0) @binding(3) 
var<storage> global_9: type_50;
@group(0) @binding(4) 
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
    var phi_275_: u32;
    var phi_319_: i32;
    var phi_343_: type_35;
    var phi_449_: i32;
    var phi_450_: i32;
    var phi_460_: bool;
    var phi_470_: u32;
    var phi_471_: u32;
    var phi_473_: bool;
    var phi_478_: u32;
    var phi_510_: i32;
    var phi_528_: f32;
    var phi_534_: f32;
    var phi_545_: f32;
    var phi_551_: f32;
    var phi_574_: f32;
    var phi_585_: f32;
    var phi_594_: f32;
    var phi_600_: f32;
    var phi_611_: f32;
    var phi_617_: f32;
    var phi_640_: f32;
    var phi_651_: f32;
    var phi_660_: f32;
    var phi_666_: f32;
    var phi_677_: f32;
    var phi_683_: f32;
    var phi_706_: f32;
    var phi_717_: f32;
    var phi_817_: f32;
    var phi_818_: f32;
    var phi_3650_: bool;
    var phi_891_: type_38;
    var phi_894_: type_61;
    var phi_896_: u32;
    var phi_898_: bool;
    var phi_900_: u32;
    var phi_911_: bool;
    var phi_997_: type_61;
    var phi_998_: bool;
    var phi_999_: u32;
    var phi_2527_: type_48;
    var phi_3359_: type_61;
    var phi_3436_: type_61;
    var phi_3437_: type_61;
    var phi_3438_: u32;
    var phi_3440_: type_61;
    var phi_3441_: u32;
    var phi_3442_: bool;
    var phi_3449_: type_61;
    var phi_3454_: type_61;
    var phi_3455_: bool;
    var phi_1018_: type_38;
    var phi_1021_: type_8;
    var phi_1022_: type_8;
    var phi_1044_: type_8;
    var phi_1069_: u32;
    var phi_1085_: type_55;
    var phi_1461_: bool;
    var phi_1490_: bool;
    var phi_1867_: f32;
    var phi_1868_: f32;
    var phi_1869_: f32;
    var phi_1870_: f32;
    var phi_1871_: vec3<f32>;
    var phi_1872_: vec3<f32>;
    var phi_1873_: vec3<f32>;
    var phi_1874_: vec3<f32>;
    var phi_1905_: bool;
    var phi_1914_: vec3<f32>;
    var phi_2081_: bool;
    var phi_2105_: f32;
    var phi_2106_: f32;
    var phi_2129_: type_22;
    var phi_2131_: type_22;
    var phi_2132_: bool;
    var phi_2136_: type_22;
    var phi_2137_: type_22;
    var phi_2138_: type_22;
    var phi_2139_: bool;
    var phi_2143_: type_22;
    var phi_2144_: bool;
    var phi_2145_: type_22;
    var phi_2146_: bool;
    var phi_2147_: bool;
    var phi_2148_: type_22;
    var phi_2149_: bool;
    var phi_2150_: bool;
    var phi_2158_: type_22;
    var phi_2159_: bool;
    var phi_2163_: type_22;
    var phi_2186_: u32;
    var phi_2200_: i32;
    var phi_2216_: vec3<f32>;
    var phi_2217_: vec3<f32>;
    var phi_2229_: vec3<f32>;
    var phi_2230_: vec3<f32>;
    var phi_2242_: vec3<f32>;
    var phi_2243_: vec3<f32>;
    var phi_2279_: vec3<f32>;
    var phi_2461_: f32;
    var phi_2479_: bool;
    var phi_2480_: bool;
    var phi_2499_: bool;
    var phi_2500_: bool;
    var phi_2506_: type_38;
    var phi_2507_: type_38;
    var phi_2508_: type_38;
    var phi_1019_: type_38;
    var phi_3644_: bool;
    var phi_3832_: bool;
    var phi_3457_: type_38;
    var phi_3458_: type_61;
    var phi_3459_: bool;
    var phi_3460_: u32;
    var phi_3831_: bool;
    var phi_3461_: type_38;
    var phi_3462_: type_61;
    var phi_3463_: u32;
    var phi_3464_: bool;
    var phi_3465_: u32;
    var phi_3830_: bool;
    var phi_3466_: type_38;
    var phi_3467_: type_61;
    var phi_3468_: u32;
    var phi_3469_: bool;
    var phi_3470_: u32;
    var phi_3829_: bool;
    var phi_892_: type_38;
    var phi_895_: type_61;
    var phi_897_: u32;
    var phi_899_: bool;
    var phi_901_: u32;
    var phi_3471_: bool;
    var phi_3828_: bool;
    var local_10: type_38;
    var phi_3523_: type_22;
    var local_11: type_38;

    switch bitcast<i32>(0u) {
        default: {
            let _e85 = global;
            let _e88 = arrayLength((&global_9.member));
            let _e103 = arrayLength((&global_8.member));
            let _e107 = global_3.member[0u][0u];
            let _e111 = global_3.member[0u][1u];
            let _e115 = global_3.member[0u][2u];
            let _e119 = global_3.member[1u][0u];
            let _e123 = global_3.member[1u][1u];
            let _e127 = global_3.member[1u][2u];
            let _e131 = global_3.member[1u][3u];
            let _e135 = (_e85.x + (_e85.y * 2097152u));
            let _e142 = (_e135 < arrayLength((&global_6.member)));
            if _e142 {
                if _e142 {
                } else {
                    break;
                }
                let _e146 = global_6.member[_e135].member_2;
                phi_275_ = _e146;
            } else {
                phi_275_ = 4294967295u;
            }
            let _e148 = phi_275_;
            let _e151 = global_1.member[0u];
            let _e155 = global_2.member[0u][0u];
            let _e159 = global_2.member[0u][1u];
            let _e163 = global_2.member[0u][2u];
            let _e167 = global_2.member[0u][3u];
            let _e171 = global_2.member[1u][0u];
            let _e175 = global_2.member[1u][1u];
            let _e179 = global_2.member[1u][2u];
            let _e183 = global_2.member[1u][3u];
            let _e184 = bitcast<f32>(_e155);
            let _e185 = bitcast<f32>(_e159);
            let _e186 = bitcast<f32>(_e163);
            let _e188 = bitcast<f32>(_e171);
            let _e189 = array<u32, 3>(_e175, _e179, _e183);
            let _e191 = bitcast<i32>(_e151);
            if (_e191 < -126i) {
                phi_319_ = -126i;
            } else {
                phi_319_ = select(_e191, 127i, (_e191 > 127i));
            }
            let _e196 = phi_319_;
            let _e201 = bitcast<f32>((bitcast<u32>((_e196 + 127i)) << bitcast<u32>(23i)));
            let _e207 = bitcast<f32>((bitcast<u32>(((_e191 - _e196) + 127i)) << bitcast<u32>(23i)));
            if (_e167 == 0u) {
                phi_343_ = type_35(array<f32, 3>(_e184, _e185, _e186), _e167, _e188, _e189);
            } else {
                phi_343_ = type_35(array<f32, 3>(((_e184 * _e201) * _e207), ((_e185 * _e201) * _e207), ((_e186 * _e201) * _e207)), _e167, ((_e188 * _e201) * _e207), _e189);
            }
            let _e220 = phi_343_;
            if _e142 {
                let _e221 = (_e135 < arrayLength((&global_7.member)));
                if _e221 {
                    if _e142 {
                    } else {
                        break;
                    }
                    let _e231 = global_6.member[_e135].member.member_2[0u];
                    let _e233 = (bitcast<u32>(_e231) & 2147483647u);
                    let _e239 = global_6.member[_e135].member.member_2[1u];
                    let _e241 = (bitcast<u32>(_e239) & 2147483647u);
                    let _e247 = global_6.member[_e135].member.member_2[2u];
                    let _e249 = (bitcast<u32>(_e247) & 2147483647u);
                    let _e255 = global_6.member[_e135].member.member[0u];
                    let _e257 = (bitcast<u32>(_e255) & 2147483647u);
                    let _e263 = global_6.member[_e135].member.member[1u];
                    let _e265 = (bitcast<u32>(_e263) & 2147483647u);
                    let _e271 = global_6.member[_e135].member.member[2u];
                    let _e273 = (bitcast<u32>(_e271) & 2147483647u);
                    let _e275 = select(_e241, _e233, (_e241 < _e233));
                    let _e277 = select(_e249, _e275, (_e249 < _e275));
                    let _e279 = select(_e257, _e277, (_e257 < _e277));
                    let _e281 = select(_e265, _e279, (_e265 < _e279));
                    let _e283 = select(_e273, _e281, (_e273 < _e281));
                    let _e288 = global_6.member[_e135].member.member_1;
                    let _e290 = (bitcast<u32>(_e288) & 2147483647u);
                    let _e298 = global_6.member[_e135].member.member_3;
                    let _e304 = (((select(_e290, _e283, (_e290 < _e283)) < 2139095040u) && ((bitcast<u32>(_e298) & 2147483647u) <= 2139095040u)) && (_e277 > 0u));
                    if _e304 {
                        let _e307 = (bitcast<u32>(bitcast<f32>(_e277)) & 2147483647u);
                        if (_e307 >= 8388608u) {
                            phi_449_ = (bitcast<i32>((_e307 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_449_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e307)), 32u, (_e307 == 0u))));
                        }
                        let _e321 = phi_449_;
                        phi_450_ = _e321;
                    } else {
                        phi_450_ = 0i;
                    }
                    let _e323 = phi_450_;
                    let _e324 = (_e233 == _e277);
                    if _e324 {
                        phi_460_ = true;
                    } else {
                        phi_460_ = (_e241 == _e277);
                    }
                    let _e327 = phi_460_;
                    let _e328 = select(1u, 0u, _e324);
                    if _e327 {
                        let _e329 = (_e328 + 1u);
                        phi_470_ = _e329;
                        phi_471_ = _e329;
                        phi_473_ = select(true, false, (_e329 == 2u));
                    } else {
                        phi_470_ = u32();
                        phi_471_ = 0u;
                        phi_473_ = true;
                    }
                    let _e333 = phi_470_;
                    let _e335 = phi_471_;
                    let _e337 = phi_473_;
                    if _e337 {
                        phi_478_ = (_e335 + 1u);
                    } else {
                        phi_478_ = 0u;
                    }
                    let _e341 = phi_478_;
                    let _e342 = select(_e333, _e335, _e337);
                    let _e343 = select(_e328, select(2u, _e328, _e327), _e337);
                    let _e344 = -(_e323);
                    if (_e344 < -126i) {
                        phi_510_ = -126i;
                    } else {
                        phi_510_ = select(_e344, 127i, (_e344 > 127i));
                    }
                    let _e349 = phi_510_;
                    let _e354 = bitcast<f32>((bitcast<u32>((_e349 + 127i)) << bitcast<u32>(23i)));
                    let _e360 = bitcast<f32>((bitcast<u32>(((_e344 - _e349) + 127i)) << bitcast<u32>(23i)));
                    let _e365 = global_6.member[_e135].member.member;
                    let _e366 = (_e342 == 0u);
                    if _e366 {
                        phi_528_ = _e365[0];
                    } else {
                        phi_528_ = _e365[1];
                    }
                    let _e370 = phi_528_;
                    let _e371 = (_e342 == 2u);
                    if _e371 {
                        phi_534_ = _e365[2];
                    } else {
                        phi_534_ = _e370;
                    }
                    let _e374 = phi_534_;
                    let _e375 = global_6.member[_e135].member.member_2;
                    if _e366 {
                        phi_545_ = _e375[0];
                    } else {
                        phi_545_ = _e375[1];
                    }
                    let _e379 = phi_545_;
                    if _e371 {
                        phi_551_ = _e375[2];
                    } else {
                        phi_551_ = _e379;
                    }
                    let _e382 = phi_551_;
                    let _e384 = ((_e382 * _e354) * _e360);
                    let _e388 = (bitcast<f32>((bitcast<u32>(_e384) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e388 {
                        let _e392 = (bitcast<f32>((bitcast<u32>(_e374) & 2147483647u)) * 0.00000011920929f);
                        phi_574_ = select(0.00000000000011368684f, _e392, (_e392 > 0.00000000000011368684f));
                    } else {
                        phi_574_ = 0f;
                    }
                    let _e396 = phi_574_;
                    let _e397 = (_e374 + _e396);
                    let _e398 = (_e374 - _e396);
                    let _e399 = select(_e384, 0f, _e388);
                    if _e388 {
                        phi_585_ = 38685626000000000000000000f;
                    } else {
                        phi_585_ = (1f / _e384);
                    }
                    let _e402 = phi_585_;
                    let _e403 = (_e341 == 0u);
                    if _e403 {
                        phi_594_ = _e365[0];
                    } else {
                        phi_594_ = _e365[1];
                    }
                    let _e407 = phi_594_;
                    let _e408 = (_e341 == 2u);
                    if _e408 {
                        phi_600_ = _e365[2];
                    } else {
                        phi_600_ = _e407;
                    }
                    let _e411 = phi_600_;
                    if _e403 {
                        phi_611_ = _e375[0];
                    } else {
                        phi_611_ = _e375[1];
                    }
                    let _e415 = phi_611_;
                    if _e408 {
                        phi_617_ = _e375[2];
                    } else {
                        phi_617_ = _e415;
                    }
                    let _e418 = phi_617_;
                    let _e420 = ((_e418 * _e354) * _e360);
                    let _e424 = (bitcast<f32>((bitcast<u32>(_e420) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e424 {
                        let _e428 = (bitcast<f32>((bitcast<u32>(_e411) & 2147483647u)) * 0.00000011920929f);
                        phi_640_ = select(0.00000000000011368684f, _e428, (_e428 > 0.00000000000011368684f));
                    } else {
                        phi_640_ = 0f;
                    }
                    let _e432 = phi_640_;
                    let _e433 = (_e411 + _e432);
                    let _e434 = (_e411 - _e432);
                    let _e435 = select(_e420, 0f, _e424);
                    if _e424 {
                        phi_651_ = 38685626000000000000000000f;
                    } else {
                        phi_651_ = (1f / _e420);
                    }
                    let _e438 = phi_651_;
                    let _e439 = (_e343 == 0u);
                    if _e439 {
                        phi_660_ = _e365[0];
                    } else {
                        phi_660_ = _e365[1];
                    }
                    let _e443 = phi_660_;
                    let _e444 = (_e343 == 2u);
                    if _e444 {
                        phi_666_ = _e365[2];
                    } else {
                        phi_666_ = _e443;
                    }
                    let _e447 = phi_666_;
                    if _e439 {
                        phi_677_ = _e375[0];
                    } else {
                        phi_677_ = _e375[1];
                    }
                    let _e451 = phi_677_;
                    if _e444 {
                        phi_683_ = _e375[2];
                    } else {
                        phi_683_ = _e451;
                    }
                    let _e454 = phi_683_;
                    let _e456 = ((_e454 * _e354) * _e360);
                    let _e460 = (bitcast<f32>((bitcast<u32>(_e456) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e460 {
                        let _e464 = (bitcast<f32>((bitcast<u32>(_e447) & 2147483647u)) * 0.00000011920929f);
                        phi_706_ = select(0.00000000000011368684f, _e464, (_e464 > 0.00000000000011368684f));
                    } else {
                        phi_706_ = 0f;
                    }
                    let _e468 = phi_706_;
                    let _e469 = (_e447 + _e468);
                    let _e470 = (_e447 - _e468);
                    let _e471 = select(_e456, 0f, _e460);
                    if _e460 {
                        phi_717_ = 38685626000000000000000000f;
                    } else {
                        phi_717_ = (1f / _e456);
                    }
                    let _e474 = phi_717_;
                    let _e477 = bitcast<f32>((bitcast<u32>(_e374) & 2147483647u));
                    let _e480 = bitcast<f32>((bitcast<u32>(_e411) & 2147483647u));
                    let _e482 = select(_e480, _e477, (_e477 > _e480));
                    let _e485 = bitcast<f32>((bitcast<u32>(_e447) & 2147483647u));
                    if (_e304 && (select(_e485, _e482, (_e482 > _e485)) <= 1099511600000f)) {
                        let _e490 = (_e323 / 3i);
                        let _e497 = bitcast<f32>((bitcast<u32>((_e490 + 127i)) << bitcast<u32>(23i)));
                        let _e504 = bitcast<f32>((bitcast<u32>(((_e323 - (2i * _e490)) + 127i)) << bitcast<u32>(23i)));
                        let _e505 = (((_e288 * _e497) * _e497) * _e504);
                        let _e507 = select(340282350000000000000000000000000000000f, _e505, (_e505 < 340282350000000000000000000000000000000f));
                        let _e512 = (((_e298 * _e497) * _e497) * _e504);
                        let _e514 = select(340282350000000000000000000000000000000f, _e512, (_e512 < 340282350000000000000000000000000000000f));
                        phi_817_ = select(-340282350000000000000000000000000000000f, _e514, (_e514 > -340282350000000000000000000000000000000f));
                        phi_818_ = select(-340282350000000000000000000000000000000f, _e507, (_e507 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_817_ = 0f;
                        phi_818_ = 1f;
                    }
                    let _e518 = phi_817_;
                    let _e520 = phi_818_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e107), bitcast<f32>(_e111), bitcast<f32>(_e115));
                    let _e525 = (_e342 % 3u);
                    let _e526 = (_e525 < 3u);
                    if _e526 {
                    } else {
                        break;
                    }
                    let _e528 = local_9[_e525];
                    let _e529 = (_e341 % 3u);
                    let _e530 = (_e529 < 3u);
                    if _e530 {
                    } else {
                        break;
                    }
                    let _e532 = local_9[_e529];
                    let _e533 = (_e343 % 3u);
                    let _e534 = (_e533 < 3u);
                    if _e534 {
                    } else {
                        break;
                    }
                    let _e536 = local_9[_e533];
                    local_8 = array<f32, 3>(bitcast<f32>(_e119), bitcast<f32>(_e123), bitcast<f32>(_e127));
                    if _e526 {
                    } else {
                        break;
                    }
                    let _e540 = local_8[_e525];
                    if _e530 {
                    } else {
                        break;
                    }
                    let _e542 = local_8[_e529];
                    if _e534 {
                    } else {
                        break;
                    }
                    let _e544 = local_8[_e533];
                    phi_3650_ = false;
                    phi_891_ = type_38(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e518);
                    phi_894_ = type_61(type_53(array<f32, 3>(_e528, _e532, _e536), array<f32, 3>(_e540, _e542, _e544)), select(0u, 2147483648u, (_e88 == 0u)));
                    phi_896_ = ((3u * _e88) + 1u);
                    phi_898_ = (_e520 <= _e518);
                    phi_900_ = 0u;
                    loop {
                        let _e552 = phi_3650_;
                        let _e554 = phi_891_;
                        let _e556 = phi_894_;
                        let _e558 = phi_896_;
                        let _e560 = phi_898_;
                        let _e562 = phi_900_;
                        local_10 = _e554;
                        if _e560 {
                            phi_911_ = true;
                        } else {
                            phi_911_ = (_e562 > 0u);
                        }
                        let _e565 = phi_911_;
                        if _e565 {
                            let _e566 = (_e558 > 0u);
                            if _e566 {
                                if _e560 {
                                    phi_997_ = _e556;
                                    phi_998_ = _e560;
                                    phi_999_ = _e562;
                                } else {
                                    let _e567 = (_e562 - 1u);
                                    let _e568 = (_e567 % 128u);
                                    let _e569 = (_e568 < 128u);
                                    if _e569 {
                                    } else {
                                        phi_3828_ = true;
                                        break;
                                    }
                                    let _e571 = local_6[_e568];
                                    if _e569 {
                                    } else {
                                        phi_3828_ = true;
                                        break;
                                    }
                                    let _e573 = local_5[_e568];
                                    if _e569 {
                                    } else {
                                        phi_3828_ = true;
                                        break;
                                    }
                                    let _e575 = local_4[_e568];
                                    if _e569 {
                                    } else {
                                        phi_3828_ = true;
                                        break;
                                    }
                                    let _e577 = local_3[_e568];
                                    if _e569 {
                                    } else {
                                        phi_3828_ = true;
                                        break;
                                    }
                                    let _e580 = local_2[_e568];
                                    if _e569 {
                                    } else {
                                        phi_3828_ = true;
                                        break;
                                    }
                                    let _e582 = local_1[_e568];
                                    if _e569 {
                                    } else {
                                        phi_3828_ = true;
                                        break;
                                    }
                                    let _e584 = local[_e568];
                                    if _e569 {
                                    } else {
                                        phi_3828_ = true;
                                        break;
                                    }
                                    let _e589 = local_7[_e568];
                                    phi_997_ = type_61(type_53(array<f32, 3>(_e573, _e575, _e577), array<f32, 3>(_e580, _e582, _e584)), _e571);
                                    phi_998_ = (_e589 <= _e554.member_1);
                                    phi_999_ = _e567;
                                }
                                let _e593 = phi_997_;
                                let _e595 = phi_998_;
                                let _e597 = phi_999_;
                                if _e595 {
                                    if ((_e593.member_1 & 2147483648u) != 0u) {
                                        phi_1018_ = _e554;
                                        phi_1021_ = type_8(0u, ((_e593.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e950 = phi_1018_;
                                            let _e952 = phi_1021_;
                                            local_11 = _e950;
                                            if (_e952.member < _e952.member_1) {
                                                phi_1022_ = type_8((_e952.member + 1u), _e952.member_1);
                                                phi_1044_ = type_8(1u, _e952.member);
                                            } else {
                                                phi_1022_ = _e952;
                                                phi_1044_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e965 = phi_1022_;
                                            let _e967 = phi_1044_;
                                            let _e971 = (bitcast<i32>(_e967.member) != 0i);
                                            if _e971 {
                                                let _e972 = ((_e593.member_1 & 268435455u) + _e967.member_1);
                                                let _e973 = (_e972 < arrayLength((&global_10.member)));
                                                if _e973 {
                                                    if _e973 {
                                                    } else {
                                                        phi_3644_ = true;
                                                        break;
                                                    }
                                                    let _e976 = global_10.member[_e972].member_1;
                                                    phi_1069_ = _e976;
                                                } else {
                                                    phi_1069_ = 4294967295u;
                                                }
                                                let _e978 = phi_1069_;
                                                if _e973 {
                                                    if _e973 {
                                                    } else {
                                                        phi_3644_ = true;
                                                        break;
                                                    }
                                                    let _e980 = global_10.member[_e972];
                                                    phi_1085_ = _e980;
                                                } else {
                                                    phi_1085_ = type_55(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e982 = phi_1085_;
                                                let _e994 = ((10u * _e342) & 31u);
                                                let _e997 = ((_e982.member[0] >> bitcast<u32>(_e994)) & 1023u);
                                                let _e1002 = bitcast<f32>((bitcast<u32>(((_e593.member.member_1[0] - _e593.member.member[0]) * 0.0009775171f)) ^ _e131));
                                                let _e1008 = (_e593.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e997) * _e1002)) ^ _e131)));
                                                let _e1012 = select(select(_e593.member.member_1[0], _e1008, (_e1008 < _e593.member.member_1[0])), _e593.member.member_1[0], (_e997 == 1023u));
                                                let _e1014 = ((10u * _e341) & 31u);
                                                let _e1017 = ((_e982.member[0] >> bitcast<u32>(_e1014)) & 1023u);
                                                let _e1022 = bitcast<f32>((bitcast<u32>(((_e593.member.member_1[1] - _e593.member.member[1]) * 0.0009775171f)) ^ _e131));
                                                let _e1028 = (_e593.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1017) * _e1022)) ^ _e131)));
                                                let _e1032 = select(select(_e593.member.member_1[1], _e1028, (_e1028 < _e593.member.member_1[1])), _e593.member.member_1[1], (_e1017 == 1023u));
                                                let _e1034 = ((10u * _e343) & 31u);
                                                let _e1037 = ((_e982.member[0] >> bitcast<u32>(_e1034)) & 1023u);
                                                let _e1042 = bitcast<f32>((bitcast<u32>(((_e593.member.member_1[2] - _e593.member.member[2]) * 0.0009775171f)) ^ _e131));
                                                let _e1048 = (_e593.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1037) * _e1042)) ^ _e131)));
                                                let _e1052 = select(select(_e593.member.member_1[2], _e1048, (_e1048 < _e593.member.member_1[2])), _e593.member.member_1[2], (_e1037 == 1023u));
                                                let _e1056 = ((_e982.member[1] >> bitcast<u32>(_e994)) & 1023u);
                                                let _e1062 = (_e593.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1056) * _e1002)) ^ _e131)));
                                                let _e1066 = select(select(_e593.member.member_1[0], _e1062, (_e1062 < _e593.member.member_1[0])), _e593.member.member_1[0], (_e1056 == 1023u));
                                                let _e1069 = ((_e982.member[1] >> bitcast<u32>(_e1014)) & 1023u);
                                                let _e1075 = (_e593.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1069) * _e1022)) ^ _e131)));
                                                let _e1079 = select(select(_e593.member.member_1[1], _e1075, (_e1075 < _e593.member.member_1[1])), _e593.member.member_1[1], (_e1069 == 1023u));
                                                let _e1082 = ((_e982.member[1] >> bitcast<u32>(_e1034)) & 1023u);
                                                let _e1088 = (_e593.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1082) * _e1042)) ^ _e131)));
                                                let _e1092 = select(select(_e593.member.member_1[2], _e1088, (_e1088 < _e593.member.member_1[2])), _e593.member.member_1[2], (_e1082 == 1023u));
                                                let _e1096 = ((_e982.member[2] >> bitcast<u32>(_e994)) & 1023u);
                                                let _e1102 = (_e593.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1096) * _e1002)) ^ _e131)));
                                                let _e1106 = select(select(_e593.member.member_1[0], _e1102, (_e1102 < _e593.member.member_1[0])), _e593.member.member_1[0], (_e1096 == 1023u));
                                                let _e1109 = ((_e982.member[2] >> bitcast<u32>(_e1014)) & 1023u);
                                                let _e1115 = (_e593.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1109) * _e1022)) ^ _e131)));
                                                let _e1119 = select(select(_e593.member.member_1[1], _e1115, (_e1115 < _e593.member.member_1[1])), _e593.member.member_1[1], (_e1109 == 1023u));
                                                let _e1122 = ((_e982.member[2] >> bitcast<u32>(_e1034)) & 1023u);
                                                let _e1128 = (_e593.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1122) * _e1042)) ^ _e131)));
                                                let _e1132 = select(select(_e593.member.member_1[2], _e1128, (_e1128 < _e593.member.member_1[2])), _e593.member.member_1[2], (_e1122 == 1023u));
                                                let _e1136 = (_e1052 - _e447);
                                                let _e1139 = (((_e1012 - _e374) * _e471) - (_e1136 * _e399));
                                                let _e1142 = (((_e1032 - _e411) * _e471) - (_e1136 * _e435));
                                                let _e1145 = (_e1092 - _e447);
                                                let _e1148 = (((_e1066 - _e374) * _e471) - (_e1145 * _e399));
                                                let _e1151 = (((_e1079 - _e411) * _e471) - (_e1145 * _e435));
                                                let _e1154 = (_e1132 - _e447);
                                                let _e1157 = (((_e1106 - _e374) * _e471) - (_e1154 * _e399));
                                                let _e1160 = (((_e1119 - _e411) * _e471) - (_e1154 * _e435));
                                                let _e1161 = (_e1157 * _e1151);
                                                let _e1162 = (_e1160 * _e1148);
                                                let _e1163 = (_e1139 * _e1160);
                                                let _e1164 = (_e1142 * _e1157);
                                                let _e1165 = (_e1148 * _e1142);
                                                let _e1166 = (_e1151 * _e1139);
                                                let _e1171 = (((_e1161 >= _e1162) && (_e1163 >= _e1164)) && (_e1165 >= _e1166));
                                                if (_e1171 || (((_e1161 <= _e1162) && (_e1163 <= _e1164)) && (_e1165 <= _e1166))) {
                                                    let _e1178 = select(-1f, 1f, _e1171);
                                                    let _e1180 = ((_e1161 - _e1162) * _e1178);
                                                    let _e1182 = select(0f, _e1180, (_e1180 > 0f));
                                                    let _e1184 = ((_e1163 - _e1164) * _e1178);
                                                    let _e1186 = select(0f, _e1184, (_e1184 > 0f));
                                                    let _e1188 = ((_e1165 - _e1166) * _e1178);
                                                    let _e1190 = select(0f, _e1188, (_e1188 > 0f));
                                                    let _e1192 = ((_e1182 + _e1186) + _e1190);
                                                    if (_e1192 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2148_ = type_22();
                                                        phi_2149_ = true;
                                                        phi_2150_ = false;
                                                    } else {
                                                        let _e1195 = select(_e1148, _e1139, (_e1139 < _e1148));
                                                        if (select(_e1157, _e1195, (_e1195 < _e1157)) > 0f) {
                                                            phi_1461_ = true;
                                                        } else {
                                                            let _e1200 = select(_e1148, _e1139, (_e1139 > _e1148));
                                                            phi_1461_ = (select(_e1157, _e1200, (_e1200 > _e1157)) < 0f);
                                                        }
                                                        let _e1205 = phi_1461_;
                                                        if _e1205 {
                                                            phi_2145_ = type_22();
                                                            phi_2146_ = true;
                                                            phi_2147_ = false;
                                                        } else {
                                                            let _e1207 = select(_e1151, _e1142, (_e1142 < _e1151));
                                                            if (select(_e1160, _e1207, (_e1207 < _e1160)) > 0f) {
                                                                phi_1490_ = true;
                                                            } else {
                                                                let _e1212 = select(_e1151, _e1142, (_e1142 > _e1151));
                                                                phi_1490_ = (select(_e1160, _e1212, (_e1212 > _e1160)) < 0f);
                                                            }
                                                            let _e1217 = phi_1490_;
                                                            if _e1217 {
                                                                phi_2143_ = type_22();
                                                                phi_2144_ = false;
                                                            } else {
                                                                let _e1219 = select(_e1066, _e1012, (_e1012 < _e1066));
                                                                let _e1223 = select(_e1066, _e1012, (_e1012 > _e1066));
                                                                let _e1227 = select(_e1079, _e1032, (_e1032 < _e1079));
                                                                let _e1231 = select(_e1079, _e1032, (_e1032 > _e1079));
                                                                let _e1235 = select(_e1092, _e1052, (_e1052 < _e1092));
                                                                let _e1239 = select(_e1092, _e1052, (_e1052 > _e1092));
                                                                let _e1244 = ((select(_e1106, _e1219, (_e1219 < _e1106)) - _e397) * _e402);
                                                                let _e1245 = ((select(_e1106, _e1223, (_e1223 > _e1106)) - _e398) * _e402);
                                                                let _e1248 = ((select(_e1119, _e1227, (_e1227 < _e1119)) - _e433) * _e438);
                                                                let _e1249 = ((select(_e1119, _e1231, (_e1231 > _e1119)) - _e434) * _e438);
                                                                let _e1252 = ((select(_e1132, _e1235, (_e1235 < _e1132)) - _e469) * _e474);
                                                                let _e1253 = ((select(_e1132, _e1239, (_e1239 > _e1132)) - _e470) * _e474);
                                                                let _e1255 = select(_e1253, _e1252, (_e1252 < _e1253));
                                                                let _e1257 = select(_e1253, _e1252, (_e1252 > _e1253));
                                                                let _e1259 = select(_e1245, _e1244, (_e1244 < _e1245));
                                                                let _e1261 = select(_e1249, _e1248, (_e1248 < _e1249));
                                                                let _e1263 = select(_e1261, _e1259, (_e1259 > _e1261));
                                                                let _e1265 = select(_e1255, _e1263, (_e1263 > _e1255));
                                                                let _e1267 = select(_e1245, _e1244, (_e1244 > _e1245));
                                                                let _e1269 = select(_e1249, _e1248, (_e1248 > _e1249));
                                                                let _e1271 = select(_e1269, _e1267, (_e1267 < _e1269));
                                                                let _e1273 = select(_e1257, _e1271, (_e1271 < _e1257));
                                                                let _e1274 = -(_e1255);
                                                                let _e1280 = select(_e520, _e1265, (_e1265 > _e520));
                                                                if (_e1280 > (_e1273 + (select(_e1274, _e1257, (_e1257 > _e1274)) * 0.0000019073523f))) {
                                                                    phi_2138_ = type_22();
                                                                    phi_2139_ = true;
                                                                } else {
                                                                    let _e1282 = (_e1280 > _e950.member_1);
                                                                    if _e1282 {
                                                                        phi_2137_ = type_22();
                                                                    } else {
                                                                        let _e1283 = vec3<f32>(_e1012, _e1032, _e1052);
                                                                        let _e1284 = vec3<f32>(_e1066, _e1079, _e1092);
                                                                        let _e1285 = vec3<f32>(_e1106, _e1119, _e1132);
                                                                        let _e1286 = (_e1066 - _e1012);
                                                                        let _e1287 = (_e1079 - _e1032);
                                                                        let _e1288 = (_e1092 - _e1052);
                                                                        let _e1289 = vec3<f32>(_e1286, _e1287, _e1288);
                                                                        let _e1290 = (_e1106 - _e1066);
                                                                        let _e1291 = (_e1119 - _e1079);
                                                                        let _e1292 = (_e1132 - _e1092);
                                                                        let _e1293 = vec3<f32>(_e1290, _e1291, _e1292);
                                                                        let _e1294 = (_e1012 - _e1106);
                                                                        let _e1295 = (_e1032 - _e1119);
                                                                        let _e1296 = (_e1052 - _e1132);
                                                                        let _e1297 = vec3<f32>(_e1294, _e1295, _e1296);
                                                                        let _e1300 = bitcast<f32>((bitcast<u32>(_e1286) & 2147483647u));
                                                                        let _e1303 = bitcast<f32>((bitcast<u32>(_e1287) & 2147483647u));
                                                                        let _e1305 = select(_e1303, _e1300, (_e1300 > _e1303));
                                                                        let _e1308 = bitcast<f32>((bitcast<u32>(_e1288) & 2147483647u));
                                                                        let _e1310 = select(_e1308, _e1305, (_e1305 > _e1308));
                                                                        let _e1313 = bitcast<f32>((bitcast<u32>(_e1290) & 2147483647u));
                                                                        let _e1316 = bitcast<f32>((bitcast<u32>(_e1291) & 2147483647u));
                                                                        let _e1318 = select(_e1316, _e1313, (_e1313 > _e1316));
                                                                        let _e1321 = bitcast<f32>((bitcast<u32>(_e1292) & 2147483647u));
                                                                        let _e1323 = select(_e1321, _e1318, (_e1318 > _e1321));
                                                                        let _e1326 = bitcast<f32>((bitcast<u32>(_e1294) & 2147483647u));
                                                                        let _e1329 = bitcast<f32>((bitcast<u32>(_e1295) & 2147483647u));
                                                                        let _e1331 = select(_e1329, _e1326, (_e1326 > _e1329));
                                                                        let _e1334 = bitcast<f32>((bitcast<u32>(_e1296) & 2147483647u));
                                                                        let _e1336 = select(_e1334, _e1331, (_e1331 > _e1334));
                                                                        let _e1338 = select(_e1323, _e1310, (_e1310 > _e1323));
                                                                        let _e1340 = select(_e1336, _e1338, (_e1338 > _e1336));
                                                                        if (_e1310 == _e1340) {
                                                                            phi_1867_ = _e1151;
                                                                            phi_1868_ = _e1148;
                                                                            phi_1869_ = _e1142;
                                                                            phi_1870_ = _e1139;
                                                                            phi_1871_ = _e1283;
                                                                            phi_1872_ = _e1297;
                                                                            phi_1873_ = _e1293;
                                                                            phi_1874_ = _e1289;
                                                                        } else {
                                                                            let _e1342 = (_e1323 == _e1340);
                                                                            let _e1347 = vec3(_e1342);
                                                                            phi_1867_ = select(_e1142, _e1160, _e1342);
                                                                            phi_1868_ = select(_e1139, _e1157, _e1342);
                                                                            phi_1869_ = select(_e1160, _e1151, _e1342);
                                                                            phi_1870_ = select(_e1157, _e1148, _e1342);
                                                                            phi_1871_ = select(_e1285, _e1284, _e1347);
                                                                            phi_1872_ = select(_e1293, _e1289, _e1347);
                                                                            phi_1873_ = select(_e1289, _e1297, _e1347);
                                                                            phi_1874_ = select(_e1297, _e1293, _e1347);
                                                                        }
                                                                        let _e1353 = phi_1867_;
                                                                        let _e1355 = phi_1868_;
                                                                        let _e1357 = phi_1869_;
                                                                        let _e1359 = phi_1870_;
                                                                        let _e1361 = phi_1871_;
                                                                        let _e1363 = phi_1872_;
                                                                        let _e1365 = phi_1873_;
                                                                        let _e1367 = phi_1874_;
                                                                        let _e1374 = ((_e1365.y * _e1363.z) - (_e1363.y * _e1365.z));
                                                                        let _e1379 = ((_e1365.z * _e1363.x) - (_e1363.z * _e1365.x));
                                                                        let _e1382 = ((_e1365.x * _e1363.y) - (_e1363.x * _e1365.y));
                                                                        if (_e1182 >= _e1186) {
                                                                            phi_1905_ = select(true, false, (_e1182 >= _e1190));
                                                                        } else {
                                                                            phi_1905_ = true;
                                                                        }
                                                                        let _e1387 = phi_1905_;
                                                                        if _e1387 {
                                                                            phi_1914_ = select(_e1285, _e1284, vec3((_e1186 >= _e1190)));
                                                                        } else {
                                                                            phi_1914_ = _e1283;
                                                                        }
                                                                        let _e1392 = phi_1914_;
                                                                        let _e1397 = (((_e1374 * _e399) + (_e1379 * _e435)) + (_e1382 * _e471));
                                                                        let _e1408 = (((_e1374 * (_e1392.x - _e374)) + (_e1379 * (_e1392.y - _e411))) + (_e1382 * (_e1392.z - _e447)));
                                                                        let _e1410 = (_e1355 - _e1359);
                                                                        let _e1411 = (_e1353 - _e1357);
                                                                        let _e1419 = (-(((_e1359 * _e1410) + (_e1357 * _e1411))) / ((_e1410 * _e1410) + (_e1411 * _e1411)));
                                                                        let _e1421 = select(1f, _e1419, (_e1419 < 1f));
                                                                        let _e1423 = select(0f, _e1421, (_e1421 > 0f));
                                                                        let _e1436 = ((_e1361.x + (_e1367.x * _e1423)) - _e374);
                                                                        let _e1437 = ((_e1361.y + (_e1367.y * _e1423)) - _e411);
                                                                        let _e1438 = ((_e1361.z + (_e1367.z * _e1423)) - _e447);
                                                                        let _e1439 = (_e1438 / _e471);
                                                                        let _e1451 = bitcast<f32>((bitcast<u32>(_e1436) & 2147483647u));
                                                                        let _e1454 = bitcast<f32>((bitcast<u32>(_e1437) & 2147483647u));
                                                                        let _e1456 = select(_e1454, _e1451, (_e1451 > _e1454));
                                                                        let _e1459 = bitcast<f32>((bitcast<u32>(_e1438) & 2147483647u));
                                                                        let _e1461 = select(_e1459, _e1456, (_e1456 > _e1459));
                                                                        let _e1467 = bitcast<f32>((bitcast<u32>(_e1374) & 2147483647u));
                                                                        let _e1470 = bitcast<f32>((bitcast<u32>(_e1379) & 2147483647u));
                                                                        let _e1472 = select(_e1470, _e1467, (_e1467 > _e1470));
                                                                        let _e1475 = bitcast<f32>((bitcast<u32>(_e1382) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1374 * _e1436) + (_e1379 * _e1437)) + (_e1382 * _e1438)) - _e1408)) & 2147483647u)) <= ((0.0000009536743f * select(_e1340, _e1461, (_e1461 > _e1340))) * select(_e1475, _e1472, (_e1472 > _e1475)))) {
                                                                            let _e1485 = bitcast<f32>((bitcast<u32>(_e1365.x) & 2147483647u));
                                                                            let _e1488 = bitcast<f32>((bitcast<u32>(_e1365.y) & 2147483647u));
                                                                            let _e1490 = select(_e1488, _e1485, (_e1485 > _e1488));
                                                                            let _e1493 = bitcast<f32>((bitcast<u32>(_e1365.z) & 2147483647u));
                                                                            let _e1499 = bitcast<f32>((bitcast<u32>(_e1363.x) & 2147483647u));
                                                                            let _e1502 = bitcast<f32>((bitcast<u32>(_e1363.y) & 2147483647u));
                                                                            let _e1504 = select(_e1502, _e1499, (_e1499 > _e1502));
                                                                            let _e1507 = bitcast<f32>((bitcast<u32>(_e1363.z) & 2147483647u));
                                                                            phi_2081_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1397) & 2147483647u)) > ((0.0000038146973f * select(_e1493, _e1490, (_e1490 > _e1493))) * select(_e1507, _e1504, (_e1504 > _e1507)))));
                                                                        } else {
                                                                            phi_2081_ = true;
                                                                        }
                                                                        let _e1514 = phi_2081_;
                                                                        if _e1514 {
                                                                            let _e1525 = ((((_e1374 * (_e1436 - (_e399 * _e1439))) + (_e1379 * (_e1437 - (_e435 * _e1439)))) + (_e1382 * (_e1438 - _e1438))) / _e1397);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1525) & 2147483647u)) <= _e1340) {
                                                                                phi_2105_ = (_e1439 + _e1525);
                                                                            } else {
                                                                                phi_2105_ = _e1439;
                                                                            }
                                                                            let _e1532 = phi_2105_;
                                                                            phi_2106_ = _e1532;
                                                                        } else {
                                                                            phi_2106_ = (_e1408 / _e1397);
                                                                        }
                                                                        let _e1534 = phi_2106_;
                                                                        let _e1536 = select(_e1273, _e1534, (_e1534 < _e1273));
                                                                        let _e1538 = select(_e1265, _e1536, (_e1536 > _e1265));
                                                                        if (_e1538 >= _e520) {
                                                                            let _e1540 = (_e1538 <= _e950.member_1);
                                                                            if _e1540 {
                                                                                let _e1541 = (1f / _e1192);
                                                                                phi_2129_ = type_22(_e1538, (_e1186 * _e1541), (_e1190 * _e1541), _e978);
                                                                            } else {
                                                                                phi_2129_ = type_22();
                                                                            }
                                                                            let _e1546 = phi_2129_;
                                                                            phi_2131_ = _e1546;
                                                                            phi_2132_ = select(true, false, _e1540);
                                                                        } else {
                                                                            phi_2131_ = type_22();
                                                                            phi_2132_ = true;
                                                                        }
                                                                        let _e1549 = phi_2131_;
                                                                        let _e1551 = phi_2132_;
                                                                        if _e1551 {
                                                                            phi_2136_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2136_ = _e1549;
                                                                        }
                                                                        let _e1553 = phi_2136_;
                                                                        phi_2137_ = _e1553;
                                                                    }
                                                                    let _e1555 = phi_2137_;
                                                                    phi_2138_ = _e1555;
                                                                    phi_2139_ = _e1282;
                                                                }
                                                                let _e1557 = phi_2138_;
                                                                let _e1559 = phi_2139_;
                                                                phi_2143_ = _e1557;
                                                                phi_2144_ = _e1559;
                                                            }
                                                            let _e1561 = phi_2143_;
                                                            let _e1563 = phi_2144_;
                                                            phi_2145_ = _e1561;
                                                            phi_2146_ = _e1217;
                                                            phi_2147_ = _e1563;
                                                        }
                                                        let _e1565 = phi_2145_;
                                                        let _e1567 = phi_2146_;
                                                        let _e1569 = phi_2147_;
                                                        phi_2148_ = _e1565;
                                                        phi_2149_ = _e1567;
                                                        phi_2150_ = _e1569;
                                                    }
                                                    let _e1571 = phi_2148_;
                                                    let _e1573 = phi_2149_;
                                                    let _e1575 = phi_2150_;
                                                    phi_2158_ = _e1571;
                                                    phi_2159_ = select(_e1575, true, _e1573);
                                                } else {
                                                    phi_2158_ = type_22();
                                                    phi_2159_ = true;
                                                }
                                                let _e1578 = phi_2158_;
                                                let _e1580 = phi_2159_;
                                                if _e1580 {
                                                    phi_2163_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2163_ = _e1578;
                                                }
                                                let _e1582 = phi_2163_;
                                                if (_e1582.member_3 != 4294967295u) {
                                                    if (_e978 == _e148) {
                                                        phi_2480_ = false;
                                                    } else {
                                                        let _e1586 = (_e978 < arrayLength((&global_4.member)));
                                                        if _e1586 {
                                                            if _e1586 {
                                                            } else {
                                                                phi_3644_ = true;
                                                                break;
                                                            }
                                                            let _e1588 = global_4.member[_e978];
                                                            phi_2186_ = _e1588;
                                                        } else {
                                                            phi_2186_ = 4294967295u;
                                                        }
                                                        let _e1590 = phi_2186_;
                                                        let _e1591 = (_e1590 < arrayLength((&global_5.member)));
                                                        if _e1591 {
                                                            if _e1591 {
                                                            } else {
                                                                phi_3644_ = true;
                                                                break;
                                                            }
                                                            let _e1593 = global_5.member[_e1590];
                                                            phi_2200_ = _e1593;
                                                        } else {
                                                            phi_2200_ = 0i;
                                                        }
                                                        let _e1595 = phi_2200_;
                                                        let _e1596 = (_e1595 == 0i);
                                                        if _e1596 {
                                                            phi_2479_ = true;
                                                        } else {
                                                            if _e366 {
                                                                phi_2217_ = vec3<f32>(_e1012, _e1032, _e1052);
                                                            } else {
                                                                if (_e342 == 1u) {
                                                                    phi_2216_ = vec3<f32>(_e1052, _e1012, _e1032);
                                                                } else {
                                                                    phi_2216_ = vec3<f32>(_e1032, _e1052, _e1012);
                                                                }
                                                                let _e1601 = phi_2216_;
                                                                phi_2217_ = _e1601;
                                                            }
                                                            let _e1604 = phi_2217_;
                                                            if _e366 {
                                                                phi_2230_ = vec3<f32>(_e1066, _e1079, _e1092);
                                                            } else {
                                                                if (_e342 == 1u) {
                                                                    phi_2229_ = vec3<f32>(_e1092, _e1066, _e1079);
                                                                } else {
                                                                    phi_2229_ = vec3<f32>(_e1079, _e1092, _e1066);
                                                                }
                                                                let _e1609 = phi_2229_;
                                                                phi_2230_ = _e1609;
                                                            }
                                                            let _e1612 = phi_2230_;
                                                            if _e366 {
                                                                phi_2243_ = vec3<f32>(_e1106, _e1119, _e1132);
                                                            } else {
                                                                if (_e342 == 1u) {
                                                                    phi_2242_ = vec3<f32>(_e1132, _e1106, _e1119);
                                                                } else {
                                                                    phi_2242_ = vec3<f32>(_e1119, _e1132, _e1106);
                                                                }
                                                                let _e1617 = phi_2242_;
                                                                phi_2243_ = _e1617;
                                                            }
                                                            let _e1620 = phi_2243_;
                                                            let _e1623 = (_e1612.x - _e1604.x);
                                                            let _e1626 = (_e1612.y - _e1604.y);
                                                            let _e1629 = (_e1612.z - _e1604.z);
                                                            let _e1631 = (_e1620.x - _e1604.x);
                                                            let _e1633 = (_e1620.y - _e1604.y);
                                                            let _e1635 = (_e1620.z - _e1604.z);
                                                            if (_e220.member_1 == 1u) {
                                                                phi_2279_ = (vec3<f32>(_e220.member[0], _e220.member[1], _e220.member[2]) - _e1604);
                                                            } else {
                                                                phi_2279_ = vec3<f32>(_e220.member[0], _e220.member[1], _e220.member[2]);
                                                            }
                                                            let _e1650 = phi_2279_;
                                                            let _e1656 = bitcast<f32>((bitcast<u32>((_e1623 * _e1633)) ^ _e220.member_3[0]));
                                                            let _e1660 = bitcast<f32>((bitcast<u32>((_e1626 * _e1631)) ^ _e220.member_3[0]));
                                                            let _e1664 = bitcast<f32>((bitcast<u32>((_e1626 * _e1635)) ^ _e220.member_3[0]));
                                                            let _e1668 = bitcast<f32>((bitcast<u32>((_e1629 * _e1633)) ^ _e220.member_3[0]));
                                                            let _e1672 = bitcast<f32>((bitcast<u32>((_e1629 * _e1631)) ^ _e220.member_3[0]));
                                                            let _e1676 = bitcast<f32>((bitcast<u32>((_e1623 * _e1635)) ^ _e220.member_3[0]));
                                                            let _e1677 = (_e1664 - _e1668);
                                                            let _e1678 = (_e1672 - _e1676);
                                                            let _e1679 = (_e1656 - _e1660);
                                                            let _e1703 = (bitcast<f32>((bitcast<u32>(_e1664) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1668) & 2147483647u)));
                                                            let _e1710 = (bitcast<f32>((bitcast<u32>(_e1672) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1676) & 2147483647u)));
                                                            let _e1717 = (bitcast<f32>((bitcast<u32>(_e1656) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1660) & 2147483647u)));
                                                            if (_e220.member_2 == 0f) {
                                                                phi_2461_ = 0f;
                                                            } else {
                                                                let _e1747 = bitcast<f32>((bitcast<u32>(_e1677) & 2147483647u));
                                                                let _e1750 = bitcast<f32>((bitcast<u32>(_e1678) & 2147483647u));
                                                                let _e1753 = bitcast<f32>((bitcast<u32>(_e1679) & 2147483647u));
                                                                let _e1755 = select(_e1753, _e1750, (_e1750 > _e1753));
                                                                let _e1759 = select(_e1753, _e1750, (_e1750 < _e1753));
                                                                let _e1763 = select(_e1750, _e1747, (_e1747 < _e1750));
                                                                let _e1765 = select(_e1750, _e1747, (_e1747 > _e1750));
                                                                let _e1767 = select(_e1753, _e1765, (_e1765 < _e1753));
                                                                phi_2461_ = bitcast<f32>((bitcast<u32>((_e220.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1755, _e1747, (_e1747 > _e1755)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1767, _e1763, (_e1763 > _e1767)))) ^ _e220.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1759, _e1747, (_e1747 < _e1759)))) ^ _e220.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1703 + _e1710) + _e1717))) ^ _e220.member_3[0]))) * 1.0000005f)) ^ _e220.member_3[0])))) ^ _e220.member_3[0]));
                                                            }
                                                            let _e1794 = phi_2461_;
                                                            phi_2479_ = (_e1596 || !(((((bitcast<f32>((bitcast<u32>((_e1650.x * _e1677)) ^ _e220.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1650.y * _e1678)) ^ _e220.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1650.z * _e1679)) ^ _e220.member_3[0]))) * f32(-(_e1595))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1650.x) & 2147483647u)) * _e1703)) ^ _e220.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1650.y) & 2147483647u)) * _e1710)) ^ _e220.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1650.z) & 2147483647u)) * _e1717)) ^ _e220.member_3[0]))))) ^ _e220.member_3[0])) + _e1794) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1808 = phi_2479_;
                                                        phi_2480_ = _e1808;
                                                    }
                                                    let _e1810 = phi_2480_;
                                                    if _e1810 {
                                                        if (_e1582.member < _e950.member.member) {
                                                            phi_2500_ = true;
                                                        } else {
                                                            if (_e1582.member == _e950.member.member) {
                                                                phi_2499_ = (_e1582.member_3 < _e950.member.member_3);
                                                            } else {
                                                                phi_2499_ = false;
                                                            }
                                                            let _e1820 = phi_2499_;
                                                            phi_2500_ = _e1820;
                                                        }
                                                        let _e1822 = phi_2500_;
                                                        if _e1822 {
                                                            phi_2506_ = type_38(_e1582, _e1582.member);
                                                        } else {
                                                            phi_2506_ = _e950;
                                                        }
                                                        let _e1825 = phi_2506_;
                                                        phi_2507_ = _e1825;
                                                    } else {
                                                        phi_2507_ = _e950;
                                                    }
                                                    let _e1827 = phi_2507_;
                                                    phi_2508_ = _e1827;
                                                } else {
                                                    phi_2508_ = _e950;
                                                }
                                                let _e1829 = phi_2508_;
                                                phi_1019_ = _e1829;
                                            } else {
                                                phi_1019_ = type_38();
                                            }
                                            let _e1831 = phi_1019_;
                                            continue;
                                            continuing {
                                                phi_1018_ = _e1831;
                                                phi_1021_ = _e965;
                                                phi_3644_ = _e552;
                                                break if !(_e971);
                                            }
                                        }
                                        let _e1834 = phi_3644_;
                                        phi_3828_ = _e1834;
                                        if _e1834 {
                                            break;
                                        }
                                        phi_3832_ = _e1834;
                                        let _e2059 = local_11;
                                        phi_3457_ = _e2059;
                                        phi_3458_ = _e593;
                                        phi_3459_ = false;
                                        phi_3460_ = _e597;
                                    } else {
                                        let _e607 = (_e593.member_1 < _e88);
                                        if _e607 {
                                            if _e607 {
                                            } else {
                                                phi_3828_ = true;
                                                break;
                                            }
                                            let _e609 = global_9.member[_e593.member_1];
                                            phi_2527_ = _e609;
                                        } else {
                                            phi_2527_ = type_48(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e611 = phi_2527_;
                                        let _e626 = ((10u * _e342) & 31u);
                                        let _e629 = ((_e611.member[0] >> bitcast<u32>(_e626)) & 1023u);
                                        let _e634 = bitcast<f32>((bitcast<u32>(((_e593.member.member_1[0] - _e593.member.member[0]) * 0.0009775171f)) ^ _e131));
                                        let _e640 = (_e593.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e629) * _e634)) ^ _e131)));
                                        let _e644 = select(select(_e593.member.member_1[0], _e640, (_e640 < _e593.member.member_1[0])), _e593.member.member_1[0], (_e629 == 1023u));
                                        let _e646 = ((10u * _e341) & 31u);
                                        let _e649 = ((_e611.member[0] >> bitcast<u32>(_e646)) & 1023u);
                                        let _e654 = bitcast<f32>((bitcast<u32>(((_e593.member.member_1[1] - _e593.member.member[1]) * 0.0009775171f)) ^ _e131));
                                        let _e660 = (_e593.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e649) * _e654)) ^ _e131)));
                                        let _e664 = select(select(_e593.member.member_1[1], _e660, (_e660 < _e593.member.member_1[1])), _e593.member.member_1[1], (_e649 == 1023u));
                                        let _e666 = ((10u * _e343) & 31u);
                                        let _e669 = ((_e611.member[0] >> bitcast<u32>(_e666)) & 1023u);
                                        let _e674 = bitcast<f32>((bitcast<u32>(((_e593.member.member_1[2] - _e593.member.member[2]) * 0.0009775171f)) ^ _e131));
                                        let _e680 = (_e593.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e669) * _e674)) ^ _e131)));
                                        let _e684 = select(select(_e593.member.member_1[2], _e680, (_e680 < _e593.member.member_1[2])), _e593.member.member_1[2], (_e669 == 1023u));
                                        let _e687 = ((_e611.member[1] >> bitcast<u32>(_e626)) & 1023u);
                                        let _e693 = (_e593.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e687) * _e634)) ^ _e131)));
                                        let _e697 = select(select(_e593.member.member_1[0], _e693, (_e693 < _e593.member.member_1[0])), _e593.member.member_1[0], (_e687 == 1023u));
                                        let _e700 = ((_e611.member[1] >> bitcast<u32>(_e646)) & 1023u);
                                        let _e706 = (_e593.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e700) * _e654)) ^ _e131)));
                                        let _e710 = select(select(_e593.member.member_1[1], _e706, (_e706 < _e593.member.member_1[1])), _e593.member.member_1[1], (_e700 == 1023u));
                                        let _e713 = ((_e611.member[1] >> bitcast<u32>(_e666)) & 1023u);
                                        let _e719 = (_e593.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e713) * _e674)) ^ _e131)));
                                        let _e723 = select(select(_e593.member.member_1[2], _e719, (_e719 < _e593.member.member_1[2])), _e593.member.member_1[2], (_e713 == 1023u));
                                        let _e729 = ((_e611.member_1[0] >> bitcast<u32>(_e626)) & 1023u);
                                        let _e735 = (_e593.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e729) * _e634)) ^ _e131)));
                                        let _e739 = select(select(_e593.member.member_1[0], _e735, (_e735 < _e593.member.member_1[0])), _e593.member.member_1[0], (_e729 == 1023u));
                                        let _e742 = ((_e611.member_1[0] >> bitcast<u32>(_e646)) & 1023u);
                                        let _e748 = (_e593.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e742) * _e654)) ^ _e131)));
                                        let _e752 = select(select(_e593.member.member_1[1], _e748, (_e748 < _e593.member.member_1[1])), _e593.member.member_1[1], (_e742 == 1023u));
                                        let _e755 = ((_e611.member_1[0] >> bitcast<u32>(_e666)) & 1023u);
                                        let _e761 = (_e593.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e755) * _e674)) ^ _e131)));
                                        let _e765 = select(select(_e593.member.member_1[2], _e761, (_e761 < _e593.member.member_1[2])), _e593.member.member_1[2], (_e755 == 1023u));
                                        let _e768 = ((_e611.member_1[1] >> bitcast<u32>(_e626)) & 1023u);
                                        let _e774 = (_e593.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e768) * _e634)) ^ _e131)));
                                        let _e778 = select(select(_e593.member.member_1[0], _e774, (_e774 < _e593.member.member_1[0])), _e593.member.member_1[0], (_e768 == 1023u));
                                        let _e781 = ((_e611.member_1[1] >> bitcast<u32>(_e646)) & 1023u);
                                        let _e787 = (_e593.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e781) * _e654)) ^ _e131)));
                                        let _e791 = select(select(_e593.member.member_1[1], _e787, (_e787 < _e593.member.member_1[1])), _e593.member.member_1[1], (_e781 == 1023u));
                                        let _e794 = ((_e611.member_1[1] >> bitcast<u32>(_e666)) & 1023u);
                                        let _e800 = (_e593.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e794) * _e674)) ^ _e131)));
                                        let _e804 = select(select(_e593.member.member_1[2], _e800, (_e800 < _e593.member.member_1[2])), _e593.member.member_1[2], (_e794 == 1023u));
                                        let _e809 = type_61(type_53(array<f32, 3>(_e644, _e664, _e684), array<f32, 3>(_e697, _e710, _e723)), _e611.member_2);
                                        let _e814 = type_61(type_53(array<f32, 3>(_e739, _e752, _e765), array<f32, 3>(_e778, _e791, _e804)), _e611.member_3);
                                        let _e820 = ((_e644 - _e397) * _e402);
                                        let _e821 = ((_e739 - _e397) * _e402);
                                        let _e822 = ((_e697 - _e398) * _e402);
                                        let _e823 = ((_e778 - _e398) * _e402);
                                        let _e828 = ((_e664 - _e433) * _e438);
                                        let _e829 = ((_e752 - _e433) * _e438);
                                        let _e830 = ((_e710 - _e434) * _e438);
                                        let _e831 = ((_e791 - _e434) * _e438);
                                        let _e836 = ((_e684 - _e469) * _e474);
                                        let _e837 = ((_e765 - _e469) * _e474);
                                        let _e838 = ((_e723 - _e470) * _e474);
                                        let _e839 = ((_e804 - _e470) * _e474);
                                        let _e841 = select(_e838, _e836, (_e836 < _e838));
                                        let _e843 = select(_e839, _e837, (_e837 < _e839));
                                        let _e845 = select(_e838, _e836, (_e836 > _e838));
                                        let _e847 = select(_e839, _e837, (_e837 > _e839));
                                        let _e849 = select(_e822, _e820, (_e820 < _e822));
                                        let _e851 = select(_e823, _e821, (_e821 < _e823));
                                        let _e853 = select(_e830, _e828, (_e828 < _e830));
                                        let _e855 = select(_e831, _e829, (_e829 < _e831));
                                        let _e857 = select(_e853, _e849, (_e849 > _e853));
                                        let _e859 = select(_e855, _e851, (_e851 > _e855));
                                        let _e861 = select(_e841, _e857, (_e857 > _e841));
                                        let _e863 = select(_e843, _e859, (_e859 > _e843));
                                        let _e865 = select(_e822, _e820, (_e820 > _e822));
                                        let _e867 = select(_e823, _e821, (_e821 > _e823));
                                        let _e869 = select(_e830, _e828, (_e828 > _e830));
                                        let _e871 = select(_e831, _e829, (_e829 > _e831));
                                        let _e873 = select(_e869, _e865, (_e865 < _e869));
                                        let _e875 = select(_e871, _e867, (_e867 < _e871));
                                        let _e880 = -(_e841);
                                        let _e881 = -(_e843);
                                        let _e888 = (select(_e845, _e873, (_e873 < _e845)) + (select(_e880, _e845, (_e845 > _e880)) * 0.0000019073523f));
                                        let _e889 = (select(_e847, _e875, (_e875 < _e847)) + (select(_e881, _e847, (_e847 > _e881)) * 0.0000019073523f));
                                        let _e891 = select(_e520, _e861, (_e861 > _e520));
                                        let _e893 = select(_e520, _e863, (_e863 > _e520));
                                        let _e898 = (_e891 <= select(_e554.member_1, _e888, (_e888 < _e554.member_1)));
                                        let _e899 = (_e893 <= select(_e554.member_1, _e889, (_e889 < _e554.member_1)));
                                        let _e900 = (_e891 <= _e893);
                                        if _e898 {
                                            if _e899 {
                                                if _e900 {
                                                    phi_3359_ = _e814;
                                                } else {
                                                    phi_3359_ = _e809;
                                                }
                                                let _e902 = phi_3359_;
                                                let _e910 = (_e597 % 128u);
                                                let _e911 = (_e910 < 128u);
                                                if _e911 {
                                                } else {
                                                    phi_3828_ = true;
                                                    break;
                                                }
                                                local_6[_e910] = _e902.member_1;
                                                if _e911 {
                                                } else {
                                                    phi_3828_ = true;
                                                    break;
                                                }
                                                local_5[_e910] = _e902.member.member[0];
                                                if _e911 {
                                                } else {
                                                    phi_3828_ = true;
                                                    break;
                                                }
                                                local_4[_e910] = _e902.member.member[1];
                                                if _e911 {
                                                } else {
                                                    phi_3828_ = true;
                                                    break;
                                                }
                                                local_3[_e910] = _e902.member.member[2];
                                                if _e911 {
                                                } else {
                                                    phi_3828_ = true;
                                                    break;
                                                }
                                                local_2[_e910] = _e902.member.member_1[0];
                                                if _e911 {
                                                } else {
                                                    phi_3828_ = true;
                                                    break;
                                                }
                                                local_1[_e910] = _e902.member.member_1[1];
                                                if _e911 {
                                                } else {
                                                    phi_3828_ = true;
                                                    break;
                                                }
                                                local[_e910] = _e902.member.member_1[2];
                                                if _e911 {
                                                } else {
                                                    phi_3828_ = true;
                                                    break;
                                                }
                                                local_7[_e910] = select(_e893, _e891, (_e891 > _e893));
                                                if _e900 {
                                                    phi_3436_ = _e809;
                                                } else {
                                                    phi_3436_ = _e814;
                                                }
                                                let _e928 = phi_3436_;
                                                phi_3437_ = _e928;
                                                phi_3438_ = (_e597 + 1u);
                                            } else {
                                                phi_3437_ = type_61();
                                                phi_3438_ = u32();
                                            }
                                            let _e930 = phi_3437_;
                                            let _e932 = phi_3438_;
                                            phi_3440_ = _e930;
                                            phi_3441_ = _e932;
                                            phi_3442_ = select(true, false, _e899);
                                        } else {
                                            phi_3440_ = type_61();
                                            phi_3441_ = u32();
                                            phi_3442_ = true;
                                        }
                                        let _e935 = phi_3440_;
                                        let _e937 = phi_3441_;
                                        let _e939 = phi_3442_;
                                        if _e939 {
                                            if _e898 {
                                                phi_3449_ = _e809;
                                            } else {
                                                phi_3449_ = _e814;
                                            }
                                            let _e941 = phi_3449_;
                                            phi_3454_ = _e941;
                                            phi_3455_ = select(_e899, true, _e898);
                                        } else {
                                            phi_3454_ = _e935;
                                            phi_3455_ = _e595;
                                        }
                                        let _e944 = phi_3454_;
                                        let _e946 = phi_3455_;
                                        phi_3832_ = _e552;
                                        phi_3457_ = _e554;
                                        phi_3458_ = _e944;
                                        phi_3459_ = _e946;
                                        phi_3460_ = select(_e937, _e597, _e939);
                                    }
                                    let _e1836 = phi_3832_;
                                    let _e1838 = phi_3457_;
                                    let _e1840 = phi_3458_;
                                    let _e1842 = phi_3459_;
                                    let _e1844 = phi_3460_;
                                    phi_3831_ = _e1836;
                                    phi_3461_ = _e1838;
                                    phi_3462_ = _e1840;
                                    phi_3463_ = (_e558 - 1u);
                                    phi_3464_ = _e1842;
                                    phi_3465_ = _e1844;
                                } else {
                                    phi_3831_ = _e552;
                                    phi_3461_ = _e554;
                                    phi_3462_ = _e593;
                                    phi_3463_ = _e558;
                                    phi_3464_ = _e595;
                                    phi_3465_ = _e597;
                                }
                                let _e1846 = phi_3831_;
                                let _e1848 = phi_3461_;
                                let _e1850 = phi_3462_;
                                let _e1852 = phi_3463_;
                                let _e1854 = phi_3464_;
                                let _e1856 = phi_3465_;
                                phi_3830_ = _e1846;
                                phi_3466_ = _e1848;
                                phi_3467_ = _e1850;
                                phi_3468_ = _e1852;
                                phi_3469_ = _e1854;
                                phi_3470_ = _e1856;
                            } else {
                                phi_3830_ = _e552;
                                phi_3466_ = type_38();
                                phi_3467_ = type_61();
                                phi_3468_ = u32();
                                phi_3469_ = bool();
                                phi_3470_ = u32();
                            }
                            let _e1858 = phi_3830_;
                            let _e1860 = phi_3466_;
                            let _e1862 = phi_3467_;
                            let _e1864 = phi_3468_;
                            let _e1866 = phi_3469_;
                            let _e1868 = phi_3470_;
                            phi_3829_ = _e1858;
                            phi_892_ = _e1860;
                            phi_895_ = _e1862;
                            phi_897_ = _e1864;
                            phi_899_ = _e1866;
                            phi_901_ = _e1868;
                            phi_3471_ = _e566;
                        } else {
                            phi_3829_ = _e552;
                            phi_892_ = type_38();
                            phi_895_ = type_61();
                            phi_897_ = u32();
                            phi_899_ = bool();
                            phi_901_ = u32();
                            phi_3471_ = false;
                        }
                        let _e1870 = phi_3829_;
                        let _e1872 = phi_892_;
                        let _e1874 = phi_895_;
                        let _e1876 = phi_897_;
                        let _e1878 = phi_899_;
                        let _e1880 = phi_901_;
                        let _e1882 = phi_3471_;
                        continue;
                        continuing {
                            phi_3650_ = _e1870;
                            phi_891_ = _e1872;
                            phi_894_ = _e1874;
                            phi_896_ = _e1876;
                            phi_898_ = _e1878;
                            phi_900_ = _e1880;
                            phi_3828_ = _e1870;
                            break if !(_e1882);
                        }
                    }
                    let _e1885 = phi_3828_;
                    if _e1885 {
                        break;
                    }
                    let _e1887 = local_10;
                    if (_e1887.member.member_3 != 4294967295u) {
                        let _e1892 = (_e344 / 3i);
                        let _e1899 = bitcast<f32>((bitcast<u32>((_e1892 + 127i)) << bitcast<u32>(23i)));
                        let _e1907 = (((_e1887.member.member * _e1899) * _e1899) * bitcast<f32>((bitcast<u32>(((_e344 - (2i * _e1892)) + 127i)) << bitcast<u32>(23i))));
                        let _e1909 = select(340282350000000000000000000000000000000f, _e1907, (_e1907 < 340282350000000000000000000000000000000f));
                        phi_3523_ = type_22(select(-340282350000000000000000000000000000000f, _e1909, (_e1909 > -340282350000000000000000000000000000000f)), _e1887.member.member_1, _e1887.member.member_2, _e1887.member.member_3);
                    } else {
                        phi_3523_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1916 = phi_3523_;
                    if _e221 {
                    } else {
                        break;
                    }
                    global_7.member[_e135] = _e1916;
                    if _e142 {
                    } else {
                        break;
                    }
                    let _e1920 = select(0u, 1u, (_e288 <= _e298));
                    if (_e1920 > 0u) {
                        let _e1922 = (1u < _e103);
                        if _e1922 {
                            if (0u < _e103) {
                            } else {
                                break;
                            }
                            let _e1926 = atomicAdd((&global_8.member[0u]), _e1920);
                            if ((_e1926 + _e1920) < _e1926) {
                                if _e1922 {
                                } else {
                                    break;
                                }
                                let _e1931 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1934 = select(0u, 1u, (_e1916.member_3 != 4294967295u));
                    if (_e1934 > 0u) {
                        let _e1936 = (3u < _e103);
                        if _e1936 {
                            if (2u < _e103) {
                            } else {
                                break;
                            }
                            let _e1940 = atomicAdd((&global_8.member[2u]), _e1934);
                            if ((_e1940 + _e1934) < _e1940) {
                                if _e1936 {
                                } else {
                                    break;
                                }
                                let _e1945 = atomicAdd((&global_8.member[3u]), 1u);
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
fn trace_paths_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
