struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_14 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_16 {
    member: array<type_14>,
}

struct type_21 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_23 {
    member: array<type_21>,
}

struct type_25 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_26 {
    member: type_25,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_28 {
    member: array<type_26>,
}

struct type_33 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_36 {
    member: type_21,
    member_1: f32,
}

struct type_40 {
    member: type_36,
    member_1: u32,
    member_2: u32,
}

struct type_42 {
    member: array<vec4<u32>, 2>,
}

struct type_49 {
    member: array<array<u32, 7>>,
}

struct type_51 {
    member: type_33,
    member_1: u32,
}

struct type_54 {
    member: array<vec4<f32>, 3>,
    member_1: type_51,
    member_2: type_51,
}

struct type_59 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(2) 
var<storage> global_1: type_16;
@group(0) @binding(4) 
var<storage, read_write> global_2: type_23;
@group(0) @binding(0) 
var<uniform> global_3: type_42;
@group(0) @binding(3) 
var<storage> global_4: type_28;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_6: type_59;
@group(0) @binding(1) 
var<storage> global_7: type_49;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<type_51, 128>;
    var phi_390_: i32;
    var phi_391_: i32;
    var phi_401_: bool;
    var phi_411_: u32;
    var phi_412_: u32;
    var phi_414_: bool;
    var phi_419_: u32;
    var phi_464_: f32;
    var phi_470_: f32;
    var phi_481_: f32;
    var phi_487_: f32;
    var phi_510_: f32;
    var phi_521_: f32;
    var phi_530_: f32;
    var phi_536_: f32;
    var phi_547_: f32;
    var phi_553_: f32;
    var phi_576_: f32;
    var phi_587_: f32;
    var phi_596_: f32;
    var phi_602_: f32;
    var phi_613_: f32;
    var phi_619_: f32;
    var phi_642_: f32;
    var phi_653_: f32;
    var phi_753_: f32;
    var phi_754_: f32;
    var phi_4385_: bool;
    var phi_1883_: type_40;
    var phi_1886_: type_51;
    var phi_1888_: u32;
    var phi_1890_: bool;
    var phi_1892_: u32;
    var phi_1903_: bool;
    var phi_1940_: type_51;
    var phi_1941_: bool;
    var phi_1942_: u32;
    var phi_3577_: u32;
    var phi_3578_: u32;
    var phi_3588_: u32;
    var phi_3590_: u32;
    var phi_3591_: bool;
    var phi_3611_: u32;
    var phi_3612_: u32;
    var phi_3616_: type_54;
    var phi_3960_: type_51;
    var phi_3993_: type_51;
    var phi_3994_: type_51;
    var phi_3995_: u32;
    var phi_3997_: type_51;
    var phi_3998_: u32;
    var phi_3999_: bool;
    var phi_4008_: type_51;
    var phi_4013_: type_51;
    var phi_4014_: bool;
    var phi_1960_: type_40;
    var phi_1963_: type_7;
    var phi_1964_: type_7;
    var phi_1986_: type_7;
    var phi_2010_: u32;
    var phi_2099_: array<array<f32, 3>, 3>;
    var phi_2570_: vec3<f32>;
    var phi_2571_: vec3<f32>;
    var phi_2602_: bool;
    var phi_2611_: vec3<f32>;
    var phi_2651_: type_21;
    var phi_2653_: type_21;
    var phi_2654_: bool;
    var phi_2658_: type_21;
    var phi_2659_: type_21;
    var phi_2660_: type_21;
    var phi_2661_: bool;
    var phi_2665_: type_21;
    var phi_2666_: bool;
    var phi_2670_: type_21;
    var phi_2671_: bool;
    var phi_2675_: type_21;
    var phi_2700_: bool;
    var phi_2701_: bool;
    var phi_2708_: type_40;
    var phi_2709_: type_40;
    var phi_2710_: type_40;
    var phi_1961_: type_40;
    var phi_4379_: bool;
    var phi_4493_: bool;
    var phi_4016_: type_40;
    var phi_4017_: type_51;
    var phi_4018_: bool;
    var phi_4019_: u32;
    var phi_4492_: bool;
    var phi_4020_: type_40;
    var phi_4021_: type_51;
    var phi_4022_: u32;
    var phi_4023_: bool;
    var phi_4024_: u32;
    var phi_4491_: bool;
    var phi_4025_: type_40;
    var phi_4026_: type_51;
    var phi_4027_: u32;
    var phi_4028_: bool;
    var phi_4029_: u32;
    var phi_4490_: bool;
    var phi_1884_: type_40;
    var phi_1887_: type_51;
    var phi_1889_: u32;
    var phi_1891_: bool;
    var phi_1893_: u32;
    var phi_4030_: bool;
    var phi_4489_: bool;
    var local_4: type_40;
    var phi_4082_: type_21;
    var local_5: type_40;
    var local_6: type_40;

    switch bitcast<i32>(0u) {
        default: {
            let _e78 = global;
            let _e80 = arrayLength((&global_7.member));
            let _e82 = arrayLength((&global_1.member));
            let _e90 = arrayLength((&global_6.member));
            let _e94 = global_3.member[0u][0u];
            let _e98 = global_3.member[0u][1u];
            let _e102 = global_3.member[0u][2u];
            let _e106 = global_3.member[0u][3u];
            let _e110 = global_3.member[1u][0u];
            let _e114 = global_3.member[1u][1u];
            let _e118 = global_3.member[1u][2u];
            let _e122 = (_e78.x + (_e78.y * 2097152u));
            let _e134 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e106) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e94), bitcast<i32>(_e98), bitcast<i32>(_e102));
            local = array<i32, 3>(bitcast<i32>(_e110), bitcast<i32>(_e114), bitcast<i32>(_e118));
            let _e137 = (_e122 < arrayLength((&global_4.member)));
            if _e137 {
                let _e138 = (_e122 < arrayLength((&global_2.member)));
                if _e138 {
                    let _e139 = (_e122 < arrayLength((&global_5.member)));
                    if _e139 {
                        if _e137 {
                        } else {
                            break;
                        }
                        let _e149 = global_4.member[_e122].member.member_2[0u];
                        let _e151 = (bitcast<u32>(_e149) & 2147483647u);
                        let _e157 = global_4.member[_e122].member.member_2[1u];
                        let _e159 = (bitcast<u32>(_e157) & 2147483647u);
                        let _e165 = global_4.member[_e122].member.member_2[2u];
                        let _e167 = (bitcast<u32>(_e165) & 2147483647u);
                        let _e173 = global_4.member[_e122].member.member[0u];
                        let _e175 = (bitcast<u32>(_e173) & 2147483647u);
                        let _e181 = global_4.member[_e122].member.member[1u];
                        let _e183 = (bitcast<u32>(_e181) & 2147483647u);
                        let _e189 = global_4.member[_e122].member.member[2u];
                        let _e191 = (bitcast<u32>(_e189) & 2147483647u);
                        let _e193 = select(_e159, _e151, (_e159 < _e151));
                        let _e195 = select(_e167, _e193, (_e167 < _e193));
                        let _e197 = select(_e175, _e195, (_e175 < _e195));
                        let _e199 = select(_e183, _e197, (_e183 < _e197));
                        let _e201 = select(_e191, _e199, (_e191 < _e199));
                        let _e206 = global_4.member[_e122].member.member_1;
                        let _e208 = (bitcast<u32>(_e206) & 2147483647u);
                        let _e216 = global_4.member[_e122].member.member_3;
                        let _e222 = (((select(_e208, _e201, (_e208 < _e201)) < 2139095040u) && ((bitcast<u32>(_e216) & 2147483647u) <= 2139095040u)) && (_e195 > 0u));
                        if _e222 {
                            let _e225 = (bitcast<u32>(bitcast<f32>(_e195)) & 2147483647u);
                            if (_e225 >= 8388608u) {
                                phi_390_ = (bitcast<i32>((_e225 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_390_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e225)), 32u, (_e225 == 0u))));
                            }
                            let _e239 = phi_390_;
                            phi_391_ = _e239;
                        } else {
                            phi_391_ = 0i;
                        }
                        let _e241 = phi_391_;
                        let _e242 = (_e151 == _e195);
                        if _e242 {
                            phi_401_ = true;
                        } else {
                            phi_401_ = (_e159 == _e195);
                        }
                        let _e245 = phi_401_;
                        let _e246 = select(1u, 0u, _e242);
                        if _e245 {
                            let _e247 = (_e246 + 1u);
                            phi_411_ = _e247;
                            phi_412_ = _e247;
                            phi_414_ = select(true, false, (_e247 == 2u));
                        } else {
                            phi_411_ = u32();
                            phi_412_ = 0u;
                            phi_414_ = true;
                        }
                        let _e251 = phi_411_;
                        let _e253 = phi_412_;
                        let _e255 = phi_414_;
                        if _e255 {
                            phi_419_ = (_e253 + 1u);
                        } else {
                            phi_419_ = 0u;
                        }
                        let _e259 = phi_419_;
                        let _e260 = select(_e251, _e253, _e255);
                        let _e261 = select(_e246, select(2u, _e246, _e245), _e255);
                        let _e262 = -(_e241);
                        let _e263 = (_e262 / 2i);
                        let _e268 = bitcast<f32>((bitcast<u32>((_e263 + 127i)) << bitcast<u32>(23i)));
                        let _e274 = bitcast<f32>((bitcast<u32>(((_e262 - _e263) + 127i)) << bitcast<u32>(23i)));
                        let _e279 = global_4.member[_e122].member.member;
                        let _e280 = (_e260 == 0u);
                        if _e280 {
                            phi_464_ = _e279[0];
                        } else {
                            phi_464_ = _e279[1];
                        }
                        let _e284 = phi_464_;
                        let _e285 = (_e260 == 2u);
                        if _e285 {
                            phi_470_ = _e279[2];
                        } else {
                            phi_470_ = _e284;
                        }
                        let _e288 = phi_470_;
                        let _e289 = global_4.member[_e122].member.member_2;
                        if _e280 {
                            phi_481_ = _e289[0];
                        } else {
                            phi_481_ = _e289[1];
                        }
                        let _e293 = phi_481_;
                        if _e285 {
                            phi_487_ = _e289[2];
                        } else {
                            phi_487_ = _e293;
                        }
                        let _e296 = phi_487_;
                        let _e298 = ((_e296 * _e268) * _e274);
                        let _e302 = (bitcast<f32>((bitcast<u32>(_e298) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e302 {
                            let _e306 = (bitcast<f32>((bitcast<u32>(_e288) & 2147483647u)) * 0.00000011920929f);
                            phi_510_ = select(0.00000000000011368684f, _e306, (_e306 > 0.00000000000011368684f));
                        } else {
                            phi_510_ = 0f;
                        }
                        let _e310 = phi_510_;
                        let _e311 = (_e288 + _e310);
                        let _e312 = (_e288 - _e310);
                        let _e313 = select(_e298, 0f, _e302);
                        if _e302 {
                            phi_521_ = 38685626000000000000000000f;
                        } else {
                            phi_521_ = (1f / _e298);
                        }
                        let _e316 = phi_521_;
                        let _e317 = (_e259 == 0u);
                        if _e317 {
                            phi_530_ = _e279[0];
                        } else {
                            phi_530_ = _e279[1];
                        }
                        let _e321 = phi_530_;
                        let _e322 = (_e259 == 2u);
                        if _e322 {
                            phi_536_ = _e279[2];
                        } else {
                            phi_536_ = _e321;
                        }
                        let _e325 = phi_536_;
                        if _e317 {
                            phi_547_ = _e289[0];
                        } else {
                            phi_547_ = _e289[1];
                        }
                        let _e329 = phi_547_;
                        if _e322 {
                            phi_553_ = _e289[2];
                        } else {
                            phi_553_ = _e329;
                        }
                        let _e332 = phi_553_;
                        let _e334 = ((_e332 * _e268) * _e274);
                        let _e338 = (bitcast<f32>((bitcast<u32>(_e334) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e338 {
                            let _e342 = (bitcast<f32>((bitcast<u32>(_e325) & 2147483647u)) * 0.00000011920929f);
                            phi_576_ = select(0.00000000000011368684f, _e342, (_e342 > 0.00000000000011368684f));
                        } else {
                            phi_576_ = 0f;
                        }
                        let _e346 = phi_576_;
                        let _e347 = (_e325 + _e346);
                        let _e348 = (_e325 - _e346);
                        let _e349 = select(_e334, 0f, _e338);
                        if _e338 {
                            phi_587_ = 38685626000000000000000000f;
                        } else {
                            phi_587_ = (1f / _e334);
                        }
                        let _e352 = phi_587_;
                        let _e353 = (_e261 == 0u);
                        if _e353 {
                            phi_596_ = _e279[0];
                        } else {
                            phi_596_ = _e279[1];
                        }
                        let _e357 = phi_596_;
                        let _e358 = (_e261 == 2u);
                        if _e358 {
                            phi_602_ = _e279[2];
                        } else {
                            phi_602_ = _e357;
                        }
                        let _e361 = phi_602_;
                        if _e353 {
                            phi_613_ = _e289[0];
                        } else {
                            phi_613_ = _e289[1];
                        }
                        let _e365 = phi_613_;
                        if _e358 {
                            phi_619_ = _e289[2];
                        } else {
                            phi_619_ = _e365;
                        }
                        let _e368 = phi_619_;
                        let _e370 = ((_e368 * _e268) * _e274);
                        let _e374 = (bitcast<f32>((bitcast<u32>(_e370) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e374 {
                            let _e378 = (bitcast<f32>((bitcast<u32>(_e361) & 2147483647u)) * 0.00000011920929f);
                            phi_642_ = select(0.00000000000011368684f, _e378, (_e378 > 0.00000000000011368684f));
                        } else {
                            phi_642_ = 0f;
                        }
                        let _e382 = phi_642_;
                        let _e383 = (_e361 + _e382);
                        let _e384 = (_e361 - _e382);
                        let _e385 = select(_e370, 0f, _e374);
                        if _e374 {
                            phi_653_ = 38685626000000000000000000f;
                        } else {
                            phi_653_ = (1f / _e370);
                        }
                        let _e388 = phi_653_;
                        let _e391 = bitcast<f32>((bitcast<u32>(_e288) & 2147483647u));
                        let _e394 = bitcast<f32>((bitcast<u32>(_e325) & 2147483647u));
                        let _e396 = select(_e394, _e391, (_e391 > _e394));
                        let _e399 = bitcast<f32>((bitcast<u32>(_e361) & 2147483647u));
                        if (_e222 && (select(_e399, _e396, (_e396 > _e399)) <= 1099511600000f)) {
                            let _e404 = (_e241 / 3i);
                            let _e411 = bitcast<f32>((bitcast<u32>((_e404 + 127i)) << bitcast<u32>(23i)));
                            let _e418 = bitcast<f32>((bitcast<u32>(((_e241 - (2i * _e404)) + 127i)) << bitcast<u32>(23i)));
                            let _e419 = (((_e206 * _e411) * _e411) * _e418);
                            let _e421 = select(340282350000000000000000000000000000000f, _e419, (_e419 < 340282350000000000000000000000000000000f));
                            let _e426 = (((_e216 * _e411) * _e411) * _e418);
                            let _e428 = select(340282350000000000000000000000000000000f, _e426, (_e426 < 340282350000000000000000000000000000000f));
                            phi_753_ = select(-340282350000000000000000000000000000000f, _e428, (_e428 > -340282350000000000000000000000000000000f));
                            phi_754_ = select(-340282350000000000000000000000000000000f, _e421, (_e421 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_753_ = 0f;
                            phi_754_ = 1f;
                        }
                        let _e432 = phi_753_;
                        let _e434 = phi_754_;
                        if _e137 {
                        } else {
                            break;
                        }
                        let _e440 = global_4.member[_e122].member_2;
                        local_3 = array<type_51, 128>(type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e443 = (_e260 % 3u);
                        let _e444 = (_e443 < 3u);
                        if _e444 {
                        } else {
                            break;
                        }
                        let _e446 = local_1[_e443];
                        let _e449 = (_e259 % 3u);
                        let _e450 = (_e449 < 3u);
                        if _e450 {
                        } else {
                            break;
                        }
                        let _e452 = local_1[_e449];
                        let _e455 = (_e261 % 3u);
                        let _e456 = (_e455 < 3u);
                        if _e456 {
                        } else {
                            break;
                        }
                        let _e458 = local_1[_e455];
                        if _e444 {
                        } else {
                            break;
                        }
                        let _e463 = local[_e443];
                        if _e450 {
                        } else {
                            break;
                        }
                        let _e467 = local[_e449];
                        if _e456 {
                        } else {
                            break;
                        }
                        let _e471 = local[_e455];
                        phi_4385_ = false;
                        phi_1883_ = type_40(type_36(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e432), 0u, 0u);
                        phi_1886_ = type_51(type_33(vec4<f32>((f32(_e446) * _e134), (f32(_e452) * _e134), (f32(_e458) * _e134), 0f), vec4<f32>((f32(_e463) * _e134), (f32(_e467) * _e134), (f32(_e471) * _e134), 0f)), select(0u, 2147483648u, (_e80 == 0u)));
                        phi_1888_ = ((3u * _e80) + 1u);
                        phi_1890_ = (_e434 <= _e432);
                        phi_1892_ = 0u;
                        loop {
                            let _e481 = phi_4385_;
                            let _e483 = phi_1883_;
                            let _e485 = phi_1886_;
                            let _e487 = phi_1888_;
                            let _e489 = phi_1890_;
                            let _e491 = phi_1892_;
                            local_4 = _e483;
                            local_5 = _e483;
                            if _e489 {
                                phi_1903_ = true;
                            } else {
                                phi_1903_ = (_e491 > 0u);
                            }
                            let _e494 = phi_1903_;
                            if _e494 {
                                let _e495 = (_e487 > 0u);
                                if _e495 {
                                    if _e489 {
                                        phi_1940_ = _e485;
                                        phi_1941_ = _e489;
                                        phi_1942_ = _e491;
                                    } else {
                                        let _e496 = (_e491 - 1u);
                                        let _e497 = (_e496 % 128u);
                                        let _e498 = (_e497 < 128u);
                                        if _e498 {
                                        } else {
                                            phi_4489_ = true;
                                            break;
                                        }
                                        let _e500 = local_3[_e497];
                                        if _e498 {
                                        } else {
                                            phi_4489_ = true;
                                            break;
                                        }
                                        let _e508 = local_2[_e497];
                                        phi_1940_ = type_51(type_33(_e500.member.member, _e500.member.member_1), _e500.member_1);
                                        phi_1941_ = (_e508 <= _e483.member.member_1);
                                        phi_1942_ = _e496;
                                    }
                                    let _e513 = phi_1940_;
                                    let _e515 = phi_1941_;
                                    let _e517 = phi_1942_;
                                    if _e515 {
                                        if ((_e513.member_1 & 2147483648u) != 0u) {
                                            phi_1960_ = _e483;
                                            phi_1963_ = type_7(0u, ((_e513.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e970 = phi_1960_;
                                                let _e972 = phi_1963_;
                                                local_6 = _e970;
                                                if (_e972.member < _e972.member_1) {
                                                    phi_1964_ = type_7((_e972.member + 1u), _e972.member_1);
                                                    phi_1986_ = type_7(1u, _e972.member);
                                                } else {
                                                    phi_1964_ = _e972;
                                                    phi_1986_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e985 = phi_1964_;
                                                let _e987 = phi_1986_;
                                                let _e991 = (bitcast<i32>(_e987.member) != 0i);
                                                if _e991 {
                                                    let _e997 = type_40(_e970.member, _e970.member_1, (_e970.member_2 + 1u));
                                                    let _e998 = ((_e513.member_1 & 268435455u) + _e987.member_1);
                                                    let _e999 = (_e998 < _e82);
                                                    if _e999 {
                                                        if _e999 {
                                                        } else {
                                                            phi_4379_ = true;
                                                            break;
                                                        }
                                                        let _e1003 = global_1.member[_e998].member_1;
                                                        phi_2010_ = _e1003;
                                                    } else {
                                                        phi_2010_ = 4294967295u;
                                                    }
                                                    let _e1005 = phi_2010_;
                                                    if (_e998 >= _e82) {
                                                        phi_2099_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e999 {
                                                        } else {
                                                            phi_4379_ = true;
                                                            break;
                                                        }
                                                        if (_e443 < 9u) {
                                                        } else {
                                                            phi_4379_ = true;
                                                            break;
                                                        }
                                                        let _e1012 = global_1.member[_e998].member[_e443];
                                                        if (_e449 < 9u) {
                                                        } else {
                                                            phi_4379_ = true;
                                                            break;
                                                        }
                                                        let _e1018 = global_1.member[_e998].member[_e449];
                                                        if (_e455 < 9u) {
                                                        } else {
                                                            phi_4379_ = true;
                                                            break;
                                                        }
                                                        let _e1024 = global_1.member[_e998].member[_e455];
                                                        let _e1026 = (3u + _e443);
                                                        if (_e1026 < 9u) {
                                                        } else {
                                                            phi_4379_ = true;
                                                            break;
                                                        }
                                                        let _e1032 = global_1.member[_e998].member[_e1026];
                                                        let _e1033 = (3u + _e449);
                                                        if (_e1033 < 9u) {
                                                        } else {
                                                            phi_4379_ = true;
                                                            break;
                                                        }
                                                        let _e1039 = global_1.member[_e998].member[_e1033];
                                                        let _e1040 = (3u + _e455);
                                                        if (_e1040 < 9u) {
                                                        } else {
                                                            phi_4379_ = true;
                                                            break;
                                                        }
                                                        let _e1046 = global_1.member[_e998].member[_e1040];
                                                        let _e1048 = (6u + _e443);
                                                        if (_e1048 < 9u) {
                                                        } else {
                                                            phi_4379_ = true;
                                                            break;
                                                        }
                                                        let _e1054 = global_1.member[_e998].member[_e1048];
                                                        let _e1055 = (6u + _e449);
                                                        if (_e1055 < 9u) {
                                                        } else {
                                                            phi_4379_ = true;
                                                            break;
                                                        }
                                                        let _e1061 = global_1.member[_e998].member[_e1055];
                                                        let _e1062 = (6u + _e455);
                                                        if (_e1062 < 9u) {
                                                        } else {
                                                            phi_4379_ = true;
                                                            break;
                                                        }
                                                        let _e1068 = global_1.member[_e998].member[_e1062];
                                                        phi_2099_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1012, _e1018, _e1024), array<f32, 3>(_e1032, _e1039, _e1046), array<f32, 3>(_e1054, _e1061, _e1068));
                                                    }
                                                    let _e1072 = phi_2099_;
                                                    let _e1081 = (_e1072[0][2] - _e361);
                                                    let _e1084 = (((_e1072[0][0] - _e288) * _e385) - (_e1081 * _e313));
                                                    let _e1087 = (((_e1072[0][1] - _e325) * _e385) - (_e1081 * _e349));
                                                    let _e1094 = (_e1072[1][2] - _e361);
                                                    let _e1097 = (((_e1072[1][0] - _e288) * _e385) - (_e1094 * _e313));
                                                    let _e1100 = (((_e1072[1][1] - _e325) * _e385) - (_e1094 * _e349));
                                                    let _e1107 = (_e1072[2][2] - _e361);
                                                    let _e1110 = (((_e1072[2][0] - _e288) * _e385) - (_e1107 * _e313));
                                                    let _e1113 = (((_e1072[2][1] - _e325) * _e385) - (_e1107 * _e349));
                                                    let _e1114 = (_e1110 * _e1100);
                                                    let _e1115 = (_e1113 * _e1097);
                                                    let _e1116 = (_e1084 * _e1113);
                                                    let _e1117 = (_e1087 * _e1110);
                                                    let _e1118 = (_e1097 * _e1087);
                                                    let _e1119 = (_e1100 * _e1084);
                                                    let _e1124 = (((_e1114 >= _e1115) && (_e1116 >= _e1117)) && (_e1118 >= _e1119));
                                                    if (_e1124 || (((_e1114 <= _e1115) && (_e1116 <= _e1117)) && (_e1118 <= _e1119))) {
                                                        let _e1131 = select(-1f, 1f, _e1124);
                                                        let _e1133 = ((_e1114 - _e1115) * _e1131);
                                                        let _e1135 = select(0f, _e1133, (_e1133 > 0f));
                                                        let _e1137 = ((_e1116 - _e1117) * _e1131);
                                                        let _e1139 = select(0f, _e1137, (_e1137 > 0f));
                                                        let _e1141 = ((_e1118 - _e1119) * _e1131);
                                                        let _e1143 = select(0f, _e1141, (_e1141 > 0f));
                                                        let _e1145 = ((_e1135 + _e1139) + _e1143);
                                                        if (_e1145 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2665_ = type_21();
                                                            phi_2666_ = true;
                                                        } else {
                                                            let _e1148 = select(_e1072[1][0], _e1072[0][0], (_e1072[0][0] < _e1072[1][0]));
                                                            let _e1152 = select(_e1072[1][0], _e1072[0][0], (_e1072[0][0] > _e1072[1][0]));
                                                            let _e1156 = select(_e1072[1][1], _e1072[0][1], (_e1072[0][1] < _e1072[1][1]));
                                                            let _e1160 = select(_e1072[1][1], _e1072[0][1], (_e1072[0][1] > _e1072[1][1]));
                                                            let _e1164 = select(_e1072[1][2], _e1072[0][2], (_e1072[0][2] < _e1072[1][2]));
                                                            let _e1168 = select(_e1072[1][2], _e1072[0][2], (_e1072[0][2] > _e1072[1][2]));
                                                            let _e1173 = ((select(_e1072[2][0], _e1148, (_e1148 < _e1072[2][0])) - _e311) * _e316);
                                                            let _e1174 = ((select(_e1072[2][0], _e1152, (_e1152 > _e1072[2][0])) - _e312) * _e316);
                                                            let _e1177 = ((select(_e1072[2][1], _e1156, (_e1156 < _e1072[2][1])) - _e347) * _e352);
                                                            let _e1178 = ((select(_e1072[2][1], _e1160, (_e1160 > _e1072[2][1])) - _e348) * _e352);
                                                            let _e1181 = ((select(_e1072[2][2], _e1164, (_e1164 < _e1072[2][2])) - _e383) * _e388);
                                                            let _e1182 = ((select(_e1072[2][2], _e1168, (_e1168 > _e1072[2][2])) - _e384) * _e388);
                                                            let _e1184 = select(_e1182, _e1181, (_e1181 < _e1182));
                                                            let _e1186 = select(_e1182, _e1181, (_e1181 > _e1182));
                                                            let _e1188 = select(_e1174, _e1173, (_e1173 < _e1174));
                                                            let _e1190 = select(_e1178, _e1177, (_e1177 < _e1178));
                                                            let _e1192 = select(_e1190, _e1188, (_e1188 > _e1190));
                                                            let _e1194 = select(_e1184, _e1192, (_e1192 > _e1184));
                                                            let _e1196 = select(_e1174, _e1173, (_e1173 > _e1174));
                                                            let _e1198 = select(_e1178, _e1177, (_e1177 > _e1178));
                                                            let _e1200 = select(_e1198, _e1196, (_e1196 < _e1198));
                                                            let _e1202 = select(_e1186, _e1200, (_e1200 < _e1186));
                                                            let _e1203 = -(_e1184);
                                                            let _e1209 = select(_e434, _e1194, (_e1194 > _e434));
                                                            if (_e1209 > (_e1202 + (select(_e1203, _e1186, (_e1186 > _e1203)) * 0.0000019073523f))) {
                                                                phi_2660_ = type_21();
                                                                phi_2661_ = true;
                                                            } else {
                                                                let _e1211 = (_e1209 > _e970.member.member_1);
                                                                if _e1211 {
                                                                    phi_2659_ = type_21();
                                                                } else {
                                                                    let _e1215 = (_e1072[1][0] - _e1072[0][0]);
                                                                    let _e1216 = (_e1072[1][1] - _e1072[0][1]);
                                                                    let _e1217 = (_e1072[1][2] - _e1072[0][2]);
                                                                    let _e1218 = vec3<f32>(_e1215, _e1216, _e1217);
                                                                    let _e1219 = (_e1072[2][0] - _e1072[1][0]);
                                                                    let _e1220 = (_e1072[2][1] - _e1072[1][1]);
                                                                    let _e1221 = (_e1072[2][2] - _e1072[1][2]);
                                                                    let _e1222 = vec3<f32>(_e1219, _e1220, _e1221);
                                                                    let _e1223 = (_e1072[0][0] - _e1072[2][0]);
                                                                    let _e1224 = (_e1072[0][1] - _e1072[2][1]);
                                                                    let _e1225 = (_e1072[0][2] - _e1072[2][2]);
                                                                    let _e1226 = vec3<f32>(_e1223, _e1224, _e1225);
                                                                    let _e1229 = bitcast<f32>((bitcast<u32>(_e1215) & 2147483647u));
                                                                    let _e1232 = bitcast<f32>((bitcast<u32>(_e1216) & 2147483647u));
                                                                    let _e1234 = select(_e1232, _e1229, (_e1229 > _e1232));
                                                                    let _e1237 = bitcast<f32>((bitcast<u32>(_e1217) & 2147483647u));
                                                                    let _e1239 = select(_e1237, _e1234, (_e1234 > _e1237));
                                                                    let _e1242 = bitcast<f32>((bitcast<u32>(_e1219) & 2147483647u));
                                                                    let _e1245 = bitcast<f32>((bitcast<u32>(_e1220) & 2147483647u));
                                                                    let _e1247 = select(_e1245, _e1242, (_e1242 > _e1245));
                                                                    let _e1250 = bitcast<f32>((bitcast<u32>(_e1221) & 2147483647u));
                                                                    let _e1252 = select(_e1250, _e1247, (_e1247 > _e1250));
                                                                    let _e1255 = bitcast<f32>((bitcast<u32>(_e1223) & 2147483647u));
                                                                    let _e1258 = bitcast<f32>((bitcast<u32>(_e1224) & 2147483647u));
                                                                    let _e1260 = select(_e1258, _e1255, (_e1255 > _e1258));
                                                                    let _e1263 = bitcast<f32>((bitcast<u32>(_e1225) & 2147483647u));
                                                                    let _e1265 = select(_e1263, _e1260, (_e1260 > _e1263));
                                                                    let _e1267 = select(_e1252, _e1239, (_e1239 > _e1252));
                                                                    let _e1269 = select(_e1265, _e1267, (_e1267 > _e1265));
                                                                    if (_e1239 == _e1269) {
                                                                        phi_2570_ = _e1222;
                                                                        phi_2571_ = _e1226;
                                                                    } else {
                                                                        let _e1272 = vec3((_e1252 == _e1269));
                                                                        phi_2570_ = select(_e1218, _e1226, _e1272);
                                                                        phi_2571_ = select(_e1222, _e1218, _e1272);
                                                                    }
                                                                    let _e1276 = phi_2570_;
                                                                    let _e1278 = phi_2571_;
                                                                    let _e1285 = ((_e1276.y * _e1278.z) - (_e1278.y * _e1276.z));
                                                                    let _e1290 = ((_e1276.z * _e1278.x) - (_e1278.z * _e1276.x));
                                                                    let _e1293 = ((_e1276.x * _e1278.y) - (_e1278.x * _e1276.y));
                                                                    if (_e1135 >= _e1139) {
                                                                        phi_2602_ = select(true, false, (_e1135 >= _e1143));
                                                                    } else {
                                                                        phi_2602_ = true;
                                                                    }
                                                                    let _e1298 = phi_2602_;
                                                                    if _e1298 {
                                                                        phi_2611_ = select(vec3<f32>(_e1072[2][0], _e1072[2][1], _e1072[2][2]), vec3<f32>(_e1072[1][0], _e1072[1][1], _e1072[1][2]), vec3((_e1139 >= _e1143)));
                                                                    } else {
                                                                        phi_2611_ = vec3<f32>(_e1072[0][0], _e1072[0][1], _e1072[0][2]);
                                                                    }
                                                                    let _e1303 = phi_2611_;
                                                                    let _e1320 = ((((_e1285 * (_e1303.x - _e288)) + (_e1290 * (_e1303.y - _e325))) + (_e1293 * (_e1303.z - _e361))) / (((_e1285 * _e313) + (_e1290 * _e349)) + (_e1293 * _e385)));
                                                                    let _e1322 = select(_e1202, _e1320, (_e1320 < _e1202));
                                                                    let _e1324 = select(_e1194, _e1322, (_e1322 > _e1194));
                                                                    if (_e1324 >= _e434) {
                                                                        let _e1326 = (_e1324 <= _e970.member.member_1);
                                                                        if _e1326 {
                                                                            let _e1327 = (1f / _e1145);
                                                                            phi_2651_ = type_21(_e1324, (_e1139 * _e1327), (_e1143 * _e1327), _e1005);
                                                                        } else {
                                                                            phi_2651_ = type_21();
                                                                        }
                                                                        let _e1332 = phi_2651_;
                                                                        phi_2653_ = _e1332;
                                                                        phi_2654_ = select(true, false, _e1326);
                                                                    } else {
                                                                        phi_2653_ = type_21();
                                                                        phi_2654_ = true;
                                                                    }
                                                                    let _e1335 = phi_2653_;
                                                                    let _e1337 = phi_2654_;
                                                                    if _e1337 {
                                                                        phi_2658_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_2658_ = _e1335;
                                                                    }
                                                                    let _e1339 = phi_2658_;
                                                                    phi_2659_ = _e1339;
                                                                }
                                                                let _e1341 = phi_2659_;
                                                                phi_2660_ = _e1341;
                                                                phi_2661_ = _e1211;
                                                            }
                                                            let _e1343 = phi_2660_;
                                                            let _e1345 = phi_2661_;
                                                            phi_2665_ = _e1343;
                                                            phi_2666_ = _e1345;
                                                        }
                                                        let _e1347 = phi_2665_;
                                                        let _e1349 = phi_2666_;
                                                        phi_2670_ = _e1347;
                                                        phi_2671_ = _e1349;
                                                    } else {
                                                        phi_2670_ = type_21();
                                                        phi_2671_ = true;
                                                    }
                                                    let _e1351 = phi_2670_;
                                                    let _e1353 = phi_2671_;
                                                    if _e1353 {
                                                        phi_2675_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2675_ = _e1351;
                                                    }
                                                    let _e1355 = phi_2675_;
                                                    if (_e1355.member_3 != 4294967295u) {
                                                        if (_e1005 != _e440) {
                                                            if (_e1355.member < _e970.member.member.member) {
                                                                phi_2701_ = true;
                                                            } else {
                                                                if (_e1355.member == _e970.member.member.member) {
                                                                    phi_2700_ = (_e1355.member_3 < _e970.member.member.member_3);
                                                                } else {
                                                                    phi_2700_ = false;
                                                                }
                                                                let _e1370 = phi_2700_;
                                                                phi_2701_ = _e1370;
                                                            }
                                                            let _e1372 = phi_2701_;
                                                            if _e1372 {
                                                                phi_2708_ = type_40(type_36(_e1355, _e1355.member), _e997.member_1, _e997.member_2);
                                                            } else {
                                                                phi_2708_ = _e997;
                                                            }
                                                            let _e1379 = phi_2708_;
                                                            phi_2709_ = _e1379;
                                                        } else {
                                                            phi_2709_ = _e997;
                                                        }
                                                        let _e1381 = phi_2709_;
                                                        phi_2710_ = _e1381;
                                                    } else {
                                                        phi_2710_ = _e997;
                                                    }
                                                    let _e1383 = phi_2710_;
                                                    phi_1961_ = _e1383;
                                                } else {
                                                    phi_1961_ = type_40();
                                                }
                                                let _e1385 = phi_1961_;
                                                continue;
                                                continuing {
                                                    phi_1960_ = _e1385;
                                                    phi_1963_ = _e985;
                                                    phi_4379_ = _e481;
                                                    break if !(_e991);
                                                }
                                            }
                                            let _e1388 = phi_4379_;
                                            phi_4489_ = _e1388;
                                            if _e1388 {
                                                break;
                                            }
                                            phi_4493_ = _e1388;
                                            let _e1604 = local_6;
                                            phi_4016_ = _e1604;
                                            phi_4017_ = _e513;
                                            phi_4018_ = false;
                                            phi_4019_ = _e517;
                                        } else {
                                            if (_e513.member_1 >= _e80) {
                                                phi_3616_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e513.member_1 < _e80) {
                                                } else {
                                                    phi_4489_ = true;
                                                    break;
                                                }
                                                let _e536 = ((1u + (_e260 * 2u)) % 7u);
                                                if (_e536 < 7u) {
                                                } else {
                                                    phi_4489_ = true;
                                                    break;
                                                }
                                                let _e541 = global_7.member[_e513.member_1][_e536];
                                                let _e544 = ((1u + (_e259 * 2u)) % 7u);
                                                if (_e544 < 7u) {
                                                } else {
                                                    phi_4489_ = true;
                                                    break;
                                                }
                                                let _e549 = global_7.member[_e513.member_1][_e544];
                                                let _e552 = ((1u + (_e261 * 2u)) % 7u);
                                                if (_e552 < 7u) {
                                                } else {
                                                    phi_4489_ = true;
                                                    break;
                                                }
                                                let _e557 = global_7.member[_e513.member_1][_e552];
                                                let _e560 = (((_e260 + 1u) * 2u) % 7u);
                                                if (_e560 < 7u) {
                                                } else {
                                                    phi_4489_ = true;
                                                    break;
                                                }
                                                let _e565 = global_7.member[_e513.member_1][_e560];
                                                let _e568 = (((_e259 + 1u) * 2u) % 7u);
                                                if (_e568 < 7u) {
                                                } else {
                                                    phi_4489_ = true;
                                                    break;
                                                }
                                                let _e573 = global_7.member[_e513.member_1][_e568];
                                                let _e576 = (((_e261 + 1u) * 2u) % 7u);
                                                if (_e576 < 7u) {
                                                } else {
                                                    phi_4489_ = true;
                                                    break;
                                                }
                                                let _e581 = global_7.member[_e513.member_1][_e576];
                                                let _e604 = (bitcast<f32>((bitcast<u32>((_e513.member.member_1.x - _e513.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e605 = (bitcast<f32>((bitcast<u32>((_e513.member.member_1.y - _e513.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e606 = (bitcast<f32>((bitcast<u32>((_e513.member.member_1.z - _e513.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e608 = select(_e134, _e604, (_e604 > _e134));
                                                let _e610 = select(_e134, _e605, (_e605 > _e134));
                                                let _e612 = select(_e134, _e606, (_e606 > _e134));
                                                let _e637 = bitcast<u32>((f32(bitcast<i32>((_e541 & 2097151u))) * _e608));
                                                let _e642 = (bitcast<i32>((_e541 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e645 = bitcast<f32>((_e637 & bitcast<u32>(_e642)));
                                                let _e646 = bitcast<u32>((f32(bitcast<i32>((_e549 & 2097151u))) * _e610));
                                                let _e651 = (bitcast<i32>((_e549 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e654 = bitcast<f32>((_e646 & bitcast<u32>(_e651)));
                                                let _e655 = bitcast<u32>((f32(bitcast<i32>((_e557 & 2097151u))) * _e612));
                                                let _e660 = (bitcast<i32>((_e557 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e663 = bitcast<f32>((_e655 & bitcast<u32>(_e660)));
                                                let _e667 = bitcast<f32>((_e637 & bitcast<u32>(~(_e642))));
                                                let _e671 = bitcast<f32>((_e646 & bitcast<u32>(~(_e651))));
                                                let _e675 = bitcast<f32>((_e655 & bitcast<u32>(~(_e660))));
                                                let _e676 = bitcast<u32>((f32(bitcast<i32>((_e565 & 2097151u))) * _e608));
                                                let _e681 = (bitcast<i32>((_e565 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e684 = bitcast<f32>((_e676 & bitcast<u32>(_e681)));
                                                let _e685 = bitcast<u32>((f32(bitcast<i32>((_e573 & 2097151u))) * _e610));
                                                let _e690 = (bitcast<i32>((_e573 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e693 = bitcast<f32>((_e685 & bitcast<u32>(_e690)));
                                                let _e694 = bitcast<u32>((f32(bitcast<i32>((_e581 & 2097151u))) * _e612));
                                                let _e699 = (bitcast<i32>((_e581 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e702 = bitcast<f32>((_e694 & bitcast<u32>(_e699)));
                                                let _e706 = bitcast<f32>((_e676 & bitcast<u32>(~(_e681))));
                                                let _e710 = bitcast<f32>((_e685 & bitcast<u32>(~(_e690))));
                                                let _e714 = bitcast<f32>((_e694 & bitcast<u32>(~(_e699))));
                                                let _e744 = global_7.member[_e513.member_1][0u];
                                                let _e748 = global_7.member[_e513.member_1][2u];
                                                let _e752 = global_7.member[_e513.member_1][4u];
                                                let _e756 = global_7.member[_e513.member_1][6u];
                                                let _e768 = (((_e748 >> bitcast<u32>(22i)) | ((_e752 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e756 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e769 = (_e744 & 268435455u);
                                                let _e770 = (_e768 & 268435455u);
                                                let _e773 = ((_e744 >> bitcast<u32>(28u)) & 7u);
                                                let _e781 = ((_e744 >> bitcast<u32>(31i)) | (((_e768 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e782 = (_e773 != 0u);
                                                if (_e773 == 0u) {
                                                    phi_3578_ = _e769;
                                                } else {
                                                    if (_e773 == 7u) {
                                                        phi_3577_ = 2147483648u;
                                                    } else {
                                                        phi_3577_ = ((2147483648u | (_e773 << bitcast<u32>(28u))) | (_e770 & 268435455u));
                                                    }
                                                    let _e791 = phi_3577_;
                                                    phi_3578_ = _e791;
                                                }
                                                let _e793 = phi_3578_;
                                                if _e782 {
                                                    let _e794 = (_e773 != 7u);
                                                    if _e794 {
                                                        phi_3588_ = (_e770 + _e773);
                                                    } else {
                                                        phi_3588_ = u32();
                                                    }
                                                    let _e797 = phi_3588_;
                                                    phi_3590_ = _e797;
                                                    phi_3591_ = select(true, false, _e794);
                                                } else {
                                                    phi_3590_ = u32();
                                                    phi_3591_ = true;
                                                }
                                                let _e800 = phi_3590_;
                                                let _e802 = phi_3591_;
                                                if (_e781 == 0u) {
                                                    phi_3612_ = (_e769 + select(0u, 1u, !(_e782)));
                                                } else {
                                                    if (_e781 == 7u) {
                                                        phi_3611_ = 2147483648u;
                                                    } else {
                                                        phi_3611_ = ((2147483648u | (_e781 << bitcast<u32>(28u))) | (select(_e800, _e770, _e802) & 268435455u));
                                                    }
                                                    let _e815 = phi_3611_;
                                                    phi_3612_ = _e815;
                                                }
                                                let _e817 = phi_3612_;
                                                phi_3616_ = type_54(array<vec4<f32>, 3>(vec4<f32>((_e513.member.member.x + _e645), (_e513.member.member.x + _e667), (_e513.member.member_1.x - _e684), (_e513.member.member_1.x - _e706)), vec4<f32>((_e513.member.member.y + _e654), (_e513.member.member.y + _e671), (_e513.member.member_1.y - _e693), (_e513.member.member_1.y - _e710)), vec4<f32>((_e513.member.member.z + _e663), (_e513.member.member.z + _e675), (_e513.member.member_1.z - _e702), (_e513.member.member_1.z - _e714))), type_51(type_33((_e513.member.member + vec4<f32>(_e645, _e654, _e663, 0f)), (_e513.member.member_1 - vec4<f32>(_e684, _e693, _e702, 0f))), _e793), type_51(type_33((_e513.member.member + vec4<f32>(_e667, _e671, _e675, 0f)), (_e513.member.member_1 - vec4<f32>(_e706, _e710, _e714, 0f))), _e817));
                                            }
                                            let _e822 = phi_3616_;
                                            let _e835 = ((_e822.member[0].x - _e311) * _e316);
                                            let _e836 = ((_e822.member[0].y - _e311) * _e316);
                                            let _e837 = ((_e822.member[0].z - _e312) * _e316);
                                            let _e838 = ((_e822.member[0].w - _e312) * _e316);
                                            let _e848 = ((_e822.member[1].x - _e347) * _e352);
                                            let _e849 = ((_e822.member[1].y - _e347) * _e352);
                                            let _e850 = ((_e822.member[1].z - _e348) * _e352);
                                            let _e851 = ((_e822.member[1].w - _e348) * _e352);
                                            let _e861 = ((_e822.member[2].x - _e383) * _e388);
                                            let _e862 = ((_e822.member[2].y - _e383) * _e388);
                                            let _e863 = ((_e822.member[2].z - _e384) * _e388);
                                            let _e864 = ((_e822.member[2].w - _e384) * _e388);
                                            let _e866 = select(_e863, _e861, (_e861 < _e863));
                                            let _e868 = select(_e864, _e862, (_e862 < _e864));
                                            let _e870 = select(_e863, _e861, (_e861 > _e863));
                                            let _e872 = select(_e864, _e862, (_e862 > _e864));
                                            let _e874 = select(_e837, _e835, (_e835 < _e837));
                                            let _e876 = select(_e838, _e836, (_e836 < _e838));
                                            let _e878 = select(_e850, _e848, (_e848 < _e850));
                                            let _e880 = select(_e851, _e849, (_e849 < _e851));
                                            let _e882 = select(_e878, _e874, (_e874 > _e878));
                                            let _e884 = select(_e880, _e876, (_e876 > _e880));
                                            let _e886 = select(_e866, _e882, (_e882 > _e866));
                                            let _e888 = select(_e868, _e884, (_e884 > _e868));
                                            let _e890 = select(_e837, _e835, (_e835 > _e837));
                                            let _e892 = select(_e838, _e836, (_e836 > _e838));
                                            let _e894 = select(_e850, _e848, (_e848 > _e850));
                                            let _e896 = select(_e851, _e849, (_e849 > _e851));
                                            let _e898 = select(_e894, _e890, (_e890 < _e894));
                                            let _e900 = select(_e896, _e892, (_e892 < _e896));
                                            let _e905 = -(_e866);
                                            let _e906 = -(_e868);
                                            let _e913 = (select(_e870, _e898, (_e898 < _e870)) + (select(_e905, _e870, (_e870 > _e905)) * 0.0000019073523f));
                                            let _e914 = (select(_e872, _e900, (_e900 < _e872)) + (select(_e906, _e872, (_e872 > _e906)) * 0.0000019073523f));
                                            let _e916 = select(_e434, _e886, (_e886 > _e434));
                                            let _e918 = select(_e434, _e888, (_e888 > _e434));
                                            let _e923 = (_e916 <= select(_e483.member.member_1, _e913, (_e913 < _e483.member.member_1)));
                                            let _e924 = (_e918 <= select(_e483.member.member_1, _e914, (_e914 < _e483.member.member_1)));
                                            let _e925 = (_e916 <= _e918);
                                            if _e923 {
                                                if _e924 {
                                                    if _e925 {
                                                        phi_3960_ = _e822.member_2;
                                                    } else {
                                                        phi_3960_ = _e822.member_1;
                                                    }
                                                    let _e929 = phi_3960_;
                                                    let _e930 = (_e517 % 128u);
                                                    let _e931 = (_e930 < 128u);
                                                    if _e931 {
                                                    } else {
                                                        phi_4489_ = true;
                                                        break;
                                                    }
                                                    local_3[_e930] = type_51(type_33(_e929.member.member, _e929.member.member_1), _e929.member_1);
                                                    if _e931 {
                                                    } else {
                                                        phi_4489_ = true;
                                                        break;
                                                    }
                                                    local_2[_e930] = select(_e918, _e916, (_e916 > _e918));
                                                    if _e925 {
                                                        phi_3993_ = _e822.member_1;
                                                    } else {
                                                        phi_3993_ = _e822.member_2;
                                                    }
                                                    let _e946 = phi_3993_;
                                                    phi_3994_ = _e946;
                                                    phi_3995_ = (_e517 + 1u);
                                                } else {
                                                    phi_3994_ = type_51();
                                                    phi_3995_ = u32();
                                                }
                                                let _e948 = phi_3994_;
                                                let _e950 = phi_3995_;
                                                phi_3997_ = _e948;
                                                phi_3998_ = _e950;
                                                phi_3999_ = select(true, false, _e924);
                                            } else {
                                                phi_3997_ = type_51();
                                                phi_3998_ = u32();
                                                phi_3999_ = true;
                                            }
                                            let _e953 = phi_3997_;
                                            let _e955 = phi_3998_;
                                            let _e957 = phi_3999_;
                                            if _e957 {
                                                if _e923 {
                                                    phi_4008_ = _e822.member_1;
                                                } else {
                                                    phi_4008_ = _e822.member_2;
                                                }
                                                let _e961 = phi_4008_;
                                                phi_4013_ = _e961;
                                                phi_4014_ = select(_e924, true, _e923);
                                            } else {
                                                phi_4013_ = _e953;
                                                phi_4014_ = _e515;
                                            }
                                            let _e964 = phi_4013_;
                                            let _e966 = phi_4014_;
                                            phi_4493_ = _e481;
                                            phi_4016_ = type_40(_e483.member, (_e483.member_1 + 1u), _e483.member_2);
                                            phi_4017_ = _e964;
                                            phi_4018_ = _e966;
                                            phi_4019_ = select(_e955, _e517, _e957);
                                        }
                                        let _e1390 = phi_4493_;
                                        let _e1392 = phi_4016_;
                                        let _e1394 = phi_4017_;
                                        let _e1396 = phi_4018_;
                                        let _e1398 = phi_4019_;
                                        phi_4492_ = _e1390;
                                        phi_4020_ = _e1392;
                                        phi_4021_ = _e1394;
                                        phi_4022_ = (_e487 - 1u);
                                        phi_4023_ = _e1396;
                                        phi_4024_ = _e1398;
                                    } else {
                                        phi_4492_ = _e481;
                                        phi_4020_ = _e483;
                                        phi_4021_ = _e513;
                                        phi_4022_ = _e487;
                                        phi_4023_ = _e515;
                                        phi_4024_ = _e517;
                                    }
                                    let _e1400 = phi_4492_;
                                    let _e1402 = phi_4020_;
                                    let _e1404 = phi_4021_;
                                    let _e1406 = phi_4022_;
                                    let _e1408 = phi_4023_;
                                    let _e1410 = phi_4024_;
                                    phi_4491_ = _e1400;
                                    phi_4025_ = _e1402;
                                    phi_4026_ = _e1404;
                                    phi_4027_ = _e1406;
                                    phi_4028_ = _e1408;
                                    phi_4029_ = _e1410;
                                } else {
                                    phi_4491_ = _e481;
                                    phi_4025_ = type_40();
                                    phi_4026_ = type_51();
                                    phi_4027_ = u32();
                                    phi_4028_ = bool();
                                    phi_4029_ = u32();
                                }
                                let _e1412 = phi_4491_;
                                let _e1414 = phi_4025_;
                                let _e1416 = phi_4026_;
                                let _e1418 = phi_4027_;
                                let _e1420 = phi_4028_;
                                let _e1422 = phi_4029_;
                                phi_4490_ = _e1412;
                                phi_1884_ = _e1414;
                                phi_1887_ = _e1416;
                                phi_1889_ = _e1418;
                                phi_1891_ = _e1420;
                                phi_1893_ = _e1422;
                                phi_4030_ = _e495;
                            } else {
                                phi_4490_ = _e481;
                                phi_1884_ = type_40();
                                phi_1887_ = type_51();
                                phi_1889_ = u32();
                                phi_1891_ = bool();
                                phi_1893_ = u32();
                                phi_4030_ = false;
                            }
                            let _e1424 = phi_4490_;
                            let _e1426 = phi_1884_;
                            let _e1428 = phi_1887_;
                            let _e1430 = phi_1889_;
                            let _e1432 = phi_1891_;
                            let _e1434 = phi_1893_;
                            let _e1436 = phi_4030_;
                            continue;
                            continuing {
                                phi_4385_ = _e1424;
                                phi_1883_ = _e1426;
                                phi_1886_ = _e1428;
                                phi_1888_ = _e1430;
                                phi_1890_ = _e1432;
                                phi_1892_ = _e1434;
                                phi_4489_ = _e1424;
                                break if !(_e1436);
                            }
                        }
                        let _e1439 = phi_4489_;
                        if _e1439 {
                            break;
                        }
                        let _e1441 = local_4;
                        if (_e1441.member.member.member_3 != 4294967295u) {
                            let _e1447 = (_e262 / 3i);
                            let _e1454 = bitcast<f32>((bitcast<u32>((_e1447 + 127i)) << bitcast<u32>(23i)));
                            let _e1462 = (((_e1441.member.member.member * _e1454) * _e1454) * bitcast<f32>((bitcast<u32>(((_e262 - (2i * _e1447)) + 127i)) << bitcast<u32>(23i))));
                            let _e1464 = select(340282350000000000000000000000000000000f, _e1462, (_e1462 < 340282350000000000000000000000000000000f));
                            phi_4082_ = type_21(select(-340282350000000000000000000000000000000f, _e1464, (_e1464 > -340282350000000000000000000000000000000f)), _e1441.member.member.member_1, _e1441.member.member.member_2, _e1441.member.member.member_3);
                        } else {
                            phi_4082_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1471 = phi_4082_;
                        if _e138 {
                        } else {
                            break;
                        }
                        global_2.member[_e122] = _e1471;
                        let _e1475 = local_5;
                        if _e139 {
                        } else {
                            break;
                        }
                        global_5.member[_e122] = _e1475.member_1;
                        if _e137 {
                        } else {
                            break;
                        }
                        let _e1480 = select(0u, 1u, (_e206 <= _e216));
                        if (_e1480 > 0u) {
                            let _e1482 = (1u < _e90);
                            if _e1482 {
                                if (0u < _e90) {
                                } else {
                                    break;
                                }
                                let _e1486 = atomicAdd((&global_6.member[0u]), _e1480);
                                if ((_e1486 + _e1480) < _e1486) {
                                    if _e1482 {
                                    } else {
                                        break;
                                    }
                                    let _e1491 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1494 = select(0u, 1u, (_e1471.member_3 != 4294967295u));
                        if (_e1494 > 0u) {
                            let _e1496 = (3u < _e90);
                            if _e1496 {
                                if (2u < _e90) {
                                } else {
                                    break;
                                }
                                let _e1500 = atomicAdd((&global_6.member[2u]), _e1494);
                                if ((_e1500 + _e1494) < _e1500) {
                                    if _e1496 {
                                    } else {
                                        break;
                                    }
                                    let _e1505 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1475.member_1 > 0u) {
                            let _e1507 = (5u < _e90);
                            if _e1507 {
                                if (4u < _e90) {
                                } else {
                                    break;
                                }
                                let _e1511 = atomicAdd((&global_6.member[4u]), _e1475.member_1);
                                if ((_e1511 + _e1475.member_1) < _e1511) {
                                    if _e1507 {
                                    } else {
                                        break;
                                    }
                                    let _e1516 = atomicAdd((&global_6.member[5u]), 1u);
                                }
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
fn trace_paths_counted_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
