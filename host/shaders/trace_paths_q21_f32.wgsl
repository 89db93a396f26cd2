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

struct type_25 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_27 {
    member: array<type_25>,
}

struct type_29 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_30 {
    member: type_29,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_32 {
    member: array<type_30>,
}

struct type_37 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_39 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_41 {
    member: type_25,
    member_1: f32,
}

struct type_46 {
    member: array<vec4<u32>, 2>,
}

struct type_49 {
    member: array<i32>,
}

struct type_58 {
    member: array<array<u32, 7>>,
}

struct type_60 {
    member: type_37,
    member_1: u32,
}

struct type_63 {
    member: array<vec4<f32>, 3>,
    member_1: type_60,
    member_2: type_60,
}

struct type_68 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_46;
@group(0) @binding(2) 
var<uniform> global_3: type_46;
@group(0) @binding(4) 
var<storage> global_4: type_20;
@group(0) @binding(5) 
var<storage> global_5: type_4;
@group(0) @binding(6) 
var<storage> global_6: type_49;
@group(0) @binding(7) 
var<storage> global_7: type_32;
@group(0) @binding(8) 
var<storage, read_write> global_8: type_27;
@group(0) @binding(9) 
var<storage, read_write> global_9: type_68;
@group(0) @binding(3) 
var<storage> global_10: type_58;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<type_60, 128>;
    var phi_322_: u32;
    var phi_387_: type_39;
    var phi_493_: i32;
    var phi_494_: i32;
    var phi_504_: bool;
    var phi_514_: u32;
    var phi_515_: u32;
    var phi_517_: bool;
    var phi_522_: u32;
    var phi_567_: f32;
    var phi_573_: f32;
    var phi_584_: f32;
    var phi_590_: f32;
    var phi_613_: f32;
    var phi_624_: f32;
    var phi_633_: f32;
    var phi_639_: f32;
    var phi_650_: f32;
    var phi_656_: f32;
    var phi_679_: f32;
    var phi_690_: f32;
    var phi_699_: f32;
    var phi_705_: f32;
    var phi_716_: f32;
    var phi_722_: f32;
    var phi_745_: f32;
    var phi_756_: f32;
    var phi_856_: f32;
    var phi_857_: f32;
    var phi_4757_: bool;
    var phi_1977_: type_41;
    var phi_1980_: type_60;
    var phi_1982_: u32;
    var phi_1984_: bool;
    var phi_1986_: u32;
    var phi_1997_: bool;
    var phi_2034_: type_60;
    var phi_2035_: bool;
    var phi_2036_: u32;
    var phi_3987_: u32;
    var phi_3988_: u32;
    var phi_3998_: u32;
    var phi_4000_: u32;
    var phi_4001_: bool;
    var phi_4021_: u32;
    var phi_4022_: u32;
    var phi_4026_: type_63;
    var phi_4370_: type_60;
    var phi_4403_: type_60;
    var phi_4404_: type_60;
    var phi_4405_: u32;
    var phi_4407_: type_60;
    var phi_4408_: u32;
    var phi_4409_: bool;
    var phi_4418_: type_60;
    var phi_4423_: type_60;
    var phi_4424_: bool;
    var phi_2054_: type_41;
    var phi_2057_: type_8;
    var phi_2058_: type_8;
    var phi_2080_: type_8;
    var phi_2101_: u32;
    var phi_2190_: array<array<f32, 3>, 3>;
    var phi_2661_: vec3<f32>;
    var phi_2662_: vec3<f32>;
    var phi_2693_: bool;
    var phi_2702_: vec3<f32>;
    var phi_2742_: type_25;
    var phi_2744_: type_25;
    var phi_2745_: bool;
    var phi_2749_: type_25;
    var phi_2750_: type_25;
    var phi_2751_: type_25;
    var phi_2752_: bool;
    var phi_2756_: type_25;
    var phi_2757_: bool;
    var phi_2761_: type_25;
    var phi_2762_: bool;
    var phi_2766_: type_25;
    var phi_2789_: u32;
    var phi_2803_: i32;
    var phi_2823_: vec3<f32>;
    var phi_2824_: vec3<f32>;
    var phi_2840_: vec3<f32>;
    var phi_2841_: vec3<f32>;
    var phi_2857_: vec3<f32>;
    var phi_2858_: vec3<f32>;
    var phi_2894_: vec3<f32>;
    var phi_3076_: f32;
    var phi_3094_: bool;
    var phi_3095_: bool;
    var phi_3114_: bool;
    var phi_3115_: bool;
    var phi_3121_: type_41;
    var phi_3122_: type_41;
    var phi_3123_: type_41;
    var phi_2055_: type_41;
    var phi_4751_: bool;
    var phi_4887_: bool;
    var phi_4426_: type_41;
    var phi_4427_: type_60;
    var phi_4428_: bool;
    var phi_4429_: u32;
    var phi_4886_: bool;
    var phi_4430_: type_41;
    var phi_4431_: type_60;
    var phi_4432_: u32;
    var phi_4433_: bool;
    var phi_4434_: u32;
    var phi_4885_: bool;
    var phi_4435_: type_41;
    var phi_4436_: type_60;
    var phi_4437_: u32;
    var phi_4438_: bool;
    var phi_4439_: u32;
    var phi_4884_: bool;
    var phi_1978_: type_41;
    var phi_1981_: type_60;
    var phi_1983_: u32;
    var phi_1985_: bool;
    var phi_1987_: u32;
    var phi_4440_: bool;
    var phi_4883_: bool;
    var local_4: type_41;
    var phi_4492_: type_25;
    var local_5: type_41;

    switch bitcast<i32>(0u) {
        default: {
            let _e87 = global;
            let _e89 = arrayLength((&global_10.member));
            let _e91 = arrayLength((&global_4.member));
            let _e103 = arrayLength((&global_9.member));
            let _e107 = global_3.member[0u][0u];
            let _e111 = global_3.member[0u][1u];
            let _e115 = global_3.member[0u][2u];
            let _e119 = global_3.member[0u][3u];
            let _e123 = global_3.member[1u][0u];
            let _e127 = global_3.member[1u][1u];
            let _e131 = global_3.member[1u][2u];
            let _e135 = (_e87.x + (_e87.y * 2097152u));
            let _e147 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e119) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e107), bitcast<i32>(_e111), bitcast<i32>(_e115));
            local = array<i32, 3>(bitcast<i32>(_e123), bitcast<i32>(_e127), bitcast<i32>(_e131));
            let _e150 = (_e135 < arrayLength((&global_7.member)));
            if _e150 {
                if _e150 {
                } else {
                    break;
                }
                let _e154 = global_7.member[_e135].member_2;
                phi_322_ = _e154;
            } else {
                phi_322_ = 4294967295u;
            }
            let _e156 = phi_322_;
            let _e159 = global_1.member[0u];
            let _e163 = global_2.member[0u][0u];
            let _e167 = global_2.member[0u][1u];
            let _e171 = global_2.member[0u][2u];
            let _e175 = global_2.member[0u][3u];
            let _e179 = global_2.member[1u][0u];
            let _e183 = global_2.member[1u][1u];
            let _e187 = global_2.member[1u][2u];
            let _e191 = global_2.member[1u][3u];
            let _e192 = bitcast<f32>(_e163);
            let _e193 = bitcast<f32>(_e167);
            let _e194 = bitcast<f32>(_e171);
            let _e196 = bitcast<f32>(_e179);
            let _e197 = array<u32, 3>(_e183, _e187, _e191);
            let _e199 = bitcast<i32>(_e159);
            let _e200 = (_e199 / 2i);
            let _e205 = bitcast<f32>((bitcast<u32>((_e200 + 127i)) << bitcast<u32>(23i)));
            let _e211 = bitcast<f32>((bitcast<u32>(((_e199 - _e200) + 127i)) << bitcast<u32>(23i)));
            if (_e175 == 0u) {
                phi_387_ = type_39(array<f32, 3>(_e192, _e193, _e194), _e175, _e196, _e197);
            } else {
                phi_387_ = type_39(array<f32, 3>(((_e192 * _e205) * _e211), ((_e193 * _e205) * _e211), ((_e194 * _e205) * _e211)), _e175, ((_e196 * _e205) * _e211), _e197);
            }
            let _e224 = phi_387_;
            if _e150 {
                let _e225 = (_e135 < arrayLength((&global_8.member)));
                if _e225 {
                    if _e150 {
                    } else {
                        break;
                    }
                    let _e235 = global_7.member[_e135].member.member_2[0u];
                    let _e237 = (bitcast<u32>(_e235) & 2147483647u);
                    let _e243 = global_7.member[_e135].member.member_2[1u];
                    let _e245 = (bitcast<u32>(_e243) & 2147483647u);
                    let _e251 = global_7.member[_e135].member.member_2[2u];
                    let _e253 = (bitcast<u32>(_e251) & 2147483647u);
                    let _e259 = global_7.member[_e135].member.member[0u];
                    let _e261 = (bitcast<u32>(_e259) & 2147483647u);
                    let _e267 = global_7.member[_e135].member.member[1u];
                    let _e269 = (bitcast<u32>(_e267) & 2147483647u);
                    let _e275 = global_7.member[_e135].member.member[2u];
                    let _e277 = (bitcast<u32>(_e275) & 2147483647u);
                    let _e279 = select(_e245, _e237, (_e245 < _e237));
                    let _e281 = select(_e253, _e279, (_e253 < _e279));
                    let _e283 = select(_e261, _e281, (_e261 < _e281));
                    let _e285 = select(_e269, _e283, (_e269 < _e283));
                    let _e287 = select(_e277, _e285, (_e277 < _e285));
                    let _e292 = global_7.member[_e135].member.member_1;
                    let _e294 = (bitcast<u32>(_e292) & 2147483647u);
                    let _e302 = global_7.member[_e135].member.member_3;
                    let _e308 = (((select(_e294, _e287, (_e294 < _e287)) < 2139095040u) && ((bitcast<u32>(_e302) & 2147483647u) <= 2139095040u)) && (_e281 > 0u));
                    if _e308 {
                        let _e311 = (bitcast<u32>(bitcast<f32>(_e281)) & 2147483647u);
                        if (_e311 >= 8388608u) {
                            phi_493_ = (bitcast<i32>((_e311 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_493_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e311)), 32u, (_e311 == 0u))));
                        }
                        let _e325 = phi_493_;
                        phi_494_ = _e325;
                    } else {
                        phi_494_ = 0i;
                    }
                    let _e327 = phi_494_;
                    let _e328 = (_e237 == _e281);
                    if _e328 {
                        phi_504_ = true;
                    } else {
                        phi_504_ = (_e245 == _e281);
                    }
                    let _e331 = phi_504_;
                    let _e332 = select(1u, 0u, _e328);
                    if _e331 {
                        let _e333 = (_e332 + 1u);
                        phi_514_ = _e333;
                        phi_515_ = _e333;
                        phi_517_ = select(true, false, (_e333 == 2u));
                    } else {
                        phi_514_ = u32();
                        phi_515_ = 0u;
                        phi_517_ = true;
                    }
                    let _e337 = phi_514_;
                    let _e339 = phi_515_;
                    let _e341 = phi_517_;
                    if _e341 {
                        phi_522_ = (_e339 + 1u);
                    } else {
                        phi_522_ = 0u;
                    }
                    let _e345 = phi_522_;
                    let _e346 = select(_e337, _e339, _e341);
                    let _e347 = select(_e332, select(2u, _e332, _e331), _e341);
                    let _e348 = -(_e327);
                    let _e349 = (_e348 / 2i);
                    let _e354 = bitcast<f32>((bitcast<u32>((_e349 + 127i)) << bitcast<u32>(23i)));
                    let _e360 = bitcast<f32>((bitcast<u32>(((_e348 - _e349) + 127i)) << bitcast<u32>(23i)));
                    let _e365 = global_7.member[_e135].member.member;
                    let _e366 = (_e346 == 0u);
                    if _e366 {
                        phi_567_ = _e365[0];
                    } else {
                        phi_567_ = _e365[1];
                    }
                    let _e370 = phi_567_;
                    let _e371 = (_e346 == 2u);
                    if _e371 {
                        phi_573_ = _e365[2];
                    } else {
                        phi_573_ = _e370;
                    }
                    let _e374 = phi_573_;
                    let _e375 = global_7.member[_e135].member.member_2;
                    if _e366 {
                        phi_584_ = _e375[0];
                    } else {
                        phi_584_ = _e375[1];
                    }
                    let _e379 = phi_584_;
                    if _e371 {
                        phi_590_ = _e375[2];
                    } else {
                        phi_590_ = _e379;
                    }
                    let _e382 = phi_590_;
                    let _e384 = ((_e382 * _e354) * _e360);
                    let _e388 = (bitcast<f32>((bitcast<u32>(_e384) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e388 {
                        let _e392 = (bitcast<f32>((bitcast<u32>(_e374) & 2147483647u)) * 0.00000011920929f);
                        phi_613_ = select(0.00000000000011368684f, _e392, (_e392 > 0.00000000000011368684f));
                    } else {
                        phi_613_ = 0f;
                    }
                    let _e396 = phi_613_;
                    let _e397 = (_e374 + _e396);
                    let _e398 = (_e374 - _e396);
                    let _e399 = select(_e384, 0f, _e388);
                    if _e388 {
                        phi_624_ = 38685626000000000000000000f;
                    } else {
                        phi_624_ = (1f / _e384);
                    }
                    let _e402 = phi_624_;
                    let _e403 = (_e345 == 0u);
                    if _e403 {
                        phi_633_ = _e365[0];
                    } else {
                        phi_633_ = _e365[1];
                    }
                    let _e407 = phi_633_;
                    let _e408 = (_e345 == 2u);
                    if _e408 {
                        phi_639_ = _e365[2];
                    } else {
                        phi_639_ = _e407;
                    }
                    let _e411 = phi_639_;
                    if _e403 {
                        phi_650_ = _e375[0];
                    } else {
                        phi_650_ = _e375[1];
                    }
                    let _e415 = phi_650_;
                    if _e408 {
                        phi_656_ = _e375[2];
                    } else {
                        phi_656_ = _e415;
                    }
                    let _e418 = phi_656_;
                    let _e420 = ((_e418 * _e354) * _e360);
                    let _e424 = (bitcast<f32>((bitcast<u32>(_e420) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e424 {
                        let _e428 = (bitcast<f32>((bitcast<u32>(_e411) & 2147483647u)) * 0.00000011920929f);
                        phi_679_ = select(0.00000000000011368684f, _e428, (_e428 > 0.00000000000011368684f));
                    } else {
                        phi_679_ = 0f;
                    }
                    let _e432 = phi_679_;
                    let _e433 = (_e411 + _e432);
                    let _e434 = (_e411 - _e432);
                    let _e435 = select(_e420, 0f, _e424);
                    if _e424 {
                        phi_690_ = 38685626000000000000000000f;
                    } else {
                        phi_690_ = (1f / _e420);
                    }
                    let _e438 = phi_690_;
                    let _e439 = (_e347 == 0u);
                    if _e439 {
                        phi_699_ = _e365[0];
                    } else {
                        phi_699_ = _e365[1];
                    }
                    let _e443 = phi_699_;
                    let _e444 = (_e347 == 2u);
                    if _e444 {
                        phi_705_ = _e365[2];
                    } else {
                        phi_705_ = _e443;
                    }
                    let _e447 = phi_705_;
                    if _e439 {
                        phi_716_ = _e375[0];
                    } else {
                        phi_716_ = _e375[1];
                    }
                    let _e451 = phi_716_;
                    if _e444 {
                        phi_722_ = _e375[2];
                    } else {
                        phi_722_ = _e451;
                    }
                    let _e454 = phi_722_;
                    let _e456 = ((_e454 * _e354) * _e360);
                    let _e460 = (bitcast<f32>((bitcast<u32>(_e456) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e460 {
                        let _e464 = (bitcast<f32>((bitcast<u32>(_e447) & 2147483647u)) * 0.00000011920929f);
                        phi_745_ = select(0.00000000000011368684f, _e464, (_e464 > 0.00000000000011368684f));
                    } else {
                        phi_745_ = 0f;
                    }
                    let _e468 = phi_745_;
                    let _e469 = (_e447 + _e468);
                    let _e470 = (_e447 - _e468);
                    let _e471 = select(_e456, 0f, _e460);
                    if _e460 {
                        phi_756_ = 38685626000000000000000000f;
                    } else {
                        phi_756_ = (1f / _e456);
                    }
                    let _e474 = phi_756_;
                    let _e477 = bitcast<f32>((bitcast<u32>(_e374) & 2147483647u));
                    let _e480 = bitcast<f32>((bitcast<u32>(_e411) & 2147483647u));
                    let _e482 = select(_e480, _e477, (_e477 > _e480));
                    let _e485 = bitcast<f32>((bitcast<u32>(_e447) & 2147483647u));
                    if (_e308 && (select(_e485, _e482, (_e482 > _e485)) <= 1099511600000f)) {
                        let _e490 = (_e327 / 3i);
                        let _e497 = bitcast<f32>((bitcast<u32>((_e490 + 127i)) << bitcast<u32>(23i)));
                        let _e504 = bitcast<f32>((bitcast<u32>(((_e327 - (2i * _e490)) + 127i)) << bitcast<u32>(23i)));
                        let _e505 = (((_e292 * _e497) * _e497) * _e504);
                        let _e507 = select(340282350000000000000000000000000000000f, _e505, (_e505 < 340282350000000000000000000000000000000f));
                        let _e512 = (((_e302 * _e497) * _e497) * _e504);
                        let _e514 = select(340282350000000000000000000000000000000f, _e512, (_e512 < 340282350000000000000000000000000000000f));
                        phi_856_ = select(-340282350000000000000000000000000000000f, _e514, (_e514 > -340282350000000000000000000000000000000f));
                        phi_857_ = select(-340282350000000000000000000000000000000f, _e507, (_e507 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_856_ = 0f;
                        phi_857_ = 1f;
                    }
                    let _e518 = phi_856_;
                    let _e520 = phi_857_;
                    local_3 = array<type_60, 128>(type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e524 = (_e346 % 3u);
                    let _e525 = (_e524 < 3u);
                    if _e525 {
                    } else {
                        break;
                    }
                    let _e527 = local_1[_e524];
                    let _e530 = (_e345 % 3u);
                    let _e531 = (_e530 < 3u);
                    if _e531 {
                    } else {
                        break;
                    }
                    let _e533 = local_1[_e530];
                    let _e536 = (_e347 % 3u);
                    let _e537 = (_e536 < 3u);
                    if _e537 {
                    } else {
                        break;
                    }
                    let _e539 = local_1[_e536];
                    if _e525 {
                    } else {
                        break;
                    }
                    let _e544 = local[_e524];
                    if _e531 {
                    } else {
                        break;
                    }
                    let _e548 = local[_e530];
                    if _e537 {
                    } else {
                        break;
                    }
                    let _e552 = local[_e536];
                    phi_4757_ = false;
                    phi_1977_ = type_41(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e518);
                    phi_1980_ = type_60(type_37(vec4<f32>((f32(_e527) * _e147), (f32(_e533) * _e147), (f32(_e539) * _e147), 0f), vec4<f32>((f32(_e544) * _e147), (f32(_e548) * _e147), (f32(_e552) * _e147), 0f)), select(0u, 2147483648u, (_e89 == 0u)));
                    phi_1982_ = ((3u * _e89) + 1u);
                    phi_1984_ = (_e520 <= _e518);
                    phi_1986_ = 0u;
                    loop {
                        let _e562 = phi_4757_;
                        let _e564 = phi_1977_;
                        let _e566 = phi_1980_;
                        let _e568 = phi_1982_;
                        let _e570 = phi_1984_;
                        let _e572 = phi_1986_;
                        local_4 = _e564;
                        if _e570 {
                            phi_1997_ = true;
                        } else {
                            phi_1997_ = (_e572 > 0u);
                        }
                        let _e575 = phi_1997_;
                        if _e575 {
                            let _e576 = (_e568 > 0u);
                            if _e576 {
                                if _e570 {
                                    phi_2034_ = _e566;
                                    phi_2035_ = _e570;
                                    phi_2036_ = _e572;
                                } else {
                                    let _e577 = (_e572 - 1u);
                                    let _e578 = (_e577 % 128u);
                                    let _e579 = (_e578 < 128u);
                                    if _e579 {
                                    } else {
                                        phi_4883_ = true;
                                        break;
                                    }
                                    let _e581 = local_3[_e578];
                                    if _e579 {
                                    } else {
                                        phi_4883_ = true;
                                        break;
                                    }
                                    let _e589 = local_2[_e578];
                                    phi_2034_ = type_60(type_37(_e581.member.member, _e581.member.member_1), _e581.member_1);
                                    phi_2035_ = (_e589 <= _e564.member_1);
                                    phi_2036_ = _e577;
                                }
                                let _e593 = phi_2034_;
                                let _e595 = phi_2035_;
                                let _e597 = phi_2036_;
                                if _e595 {
                                    if ((_e593.member_1 & 2147483648u) != 0u) {
                                        phi_2054_ = _e564;
                                        phi_2057_ = type_8(0u, ((_e593.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1043 = phi_2054_;
                                            let _e1045 = phi_2057_;
                                            local_5 = _e1043;
                                            if (_e1045.member < _e1045.member_1) {
                                                phi_2058_ = type_8((_e1045.member + 1u), _e1045.member_1);
                                                phi_2080_ = type_8(1u, _e1045.member);
                                            } else {
                                                phi_2058_ = _e1045;
                                                phi_2080_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1058 = phi_2058_;
                                            let _e1060 = phi_2080_;
                                            let _e1064 = (bitcast<i32>(_e1060.member) != 0i);
                                            if _e1064 {
                                                let _e1065 = ((_e593.member_1 & 268435455u) + _e1060.member_1);
                                                let _e1066 = (_e1065 < _e91);
                                                if _e1066 {
                                                    if _e1066 {
                                                    } else {
                                                        phi_4751_ = true;
                                                        break;
                                                    }
                                                    let _e1070 = global_4.member[_e1065].member_1;
                                                    phi_2101_ = _e1070;
                                                } else {
                                                    phi_2101_ = 4294967295u;
                                                }
                                                let _e1072 = phi_2101_;
                                                if (_e1065 >= _e91) {
                                                    phi_2190_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1066 {
                                                    } else {
                                                        phi_4751_ = true;
                                                        break;
                                                    }
                                                    if (_e524 < 9u) {
                                                    } else {
                                                        phi_4751_ = true;
                                                        break;
                                                    }
                                                    let _e1079 = global_4.member[_e1065].member[_e524];
                                                    if (_e530 < 9u) {
                                                    } else {
                                                        phi_4751_ = true;
                                                        break;
                                                    }
                                                    let _e1085 = global_4.member[_e1065].member[_e530];
                                                    if (_e536 < 9u) {
                                                    } else {
                                                        phi_4751_ = true;
                                                        break;
                                                    }
                                                    let _e1091 = global_4.member[_e1065].member[_e536];
                                                    let _e1093 = (3u + _e524);
                                                    if (_e1093 < 9u) {
                                                    } else {
                                                        phi_4751_ = true;
                                                        break;
                                                    }
                                                    let _e1099 = global_4.member[_e1065].member[_e1093];
                                                    let _e1100 = (3u + _e530);
                                                    if (_e1100 < 9u) {
                                                    } else {
                                                        phi_4751_ = true;
                                                        break;
                                                    }
                                                    let _e1106 = global_4.member[_e1065].member[_e1100];
                                                    let _e1107 = (3u + _e536);
                                                    if (_e1107 < 9u) {
                                                    } else {
                                                        phi_4751_ = true;
                                                        break;
                                                    }
                                                    let _e1113 = global_4.member[_e1065].member[_e1107];
                                                    let _e1115 = (6u + _e524);
                                                    if (_e1115 < 9u) {
                                                    } else {
                                                        phi_4751_ = true;
                                                        break;
                                                    }
                                                    let _e1121 = global_4.member[_e1065].member[_e1115];
                                                    let _e1122 = (6u + _e530);
                                                    if (_e1122 < 9u) {
                                                    } else {
                                                        phi_4751_ = true;
                                                        break;
                                                    }
                                                    let _e1128 = global_4.member[_e1065].member[_e1122];
                                                    let _e1129 = (6u + _e536);
                                                    if (_e1129 < 9u) {
                                                    } else {
                                                        phi_4751_ = true;
                                                        break;
                                                    }
                                                    let _e1135 = global_4.member[_e1065].member[_e1129];
                                                    phi_2190_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1079, _e1085, _e1091), array<f32, 3>(_e1099, _e1106, _e1113), array<f32, 3>(_e1121, _e1128, _e1135));
                                                }
                                                let _e1139 = phi_2190_;
                                                let _e1147 = (_e1139[0][2] - _e447);
                                                let _e1150 = (((_e1139[0][0] - _e374) * _e471) - (_e1147 * _e399));
                                                let _e1153 = (((_e1139[0][1] - _e411) * _e471) - (_e1147 * _e435));
                                                let _e1160 = (_e1139[1][2] - _e447);
                                                let _e1163 = (((_e1139[1][0] - _e374) * _e471) - (_e1160 * _e399));
                                                let _e1166 = (((_e1139[1][1] - _e411) * _e471) - (_e1160 * _e435));
                                                let _e1173 = (_e1139[2][2] - _e447);
                                                let _e1176 = (((_e1139[2][0] - _e374) * _e471) - (_e1173 * _e399));
                                                let _e1179 = (((_e1139[2][1] - _e411) * _e471) - (_e1173 * _e435));
                                                let _e1180 = (_e1176 * _e1166);
                                                let _e1181 = (_e1179 * _e1163);
                                                let _e1182 = (_e1150 * _e1179);
                                                let _e1183 = (_e1153 * _e1176);
                                                let _e1184 = (_e1163 * _e1153);
                                                let _e1185 = (_e1166 * _e1150);
                                                let _e1190 = (((_e1180 >= _e1181) && (_e1182 >= _e1183)) && (_e1184 >= _e1185));
                                                if (_e1190 || (((_e1180 <= _e1181) && (_e1182 <= _e1183)) && (_e1184 <= _e1185))) {
                                                    let _e1197 = select(-1f, 1f, _e1190);
                                                    let _e1199 = ((_e1180 - _e1181) * _e1197);
                                                    let _e1201 = select(0f, _e1199, (_e1199 > 0f));
                                                    let _e1203 = ((_e1182 - _e1183) * _e1197);
                                                    let _e1205 = select(0f, _e1203, (_e1203 > 0f));
                                                    let _e1207 = ((_e1184 - _e1185) * _e1197);
                                                    let _e1209 = select(0f, _e1207, (_e1207 > 0f));
                                                    let _e1211 = ((_e1201 + _e1205) + _e1209);
                                                    if (_e1211 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2756_ = type_25();
                                                        phi_2757_ = true;
                                                    } else {
                                                        let _e1214 = select(_e1139[1][0], _e1139[0][0], (_e1139[0][0] < _e1139[1][0]));
                                                        let _e1218 = select(_e1139[1][0], _e1139[0][0], (_e1139[0][0] > _e1139[1][0]));
                                                        let _e1222 = select(_e1139[1][1], _e1139[0][1], (_e1139[0][1] < _e1139[1][1]));
                                                        let _e1226 = select(_e1139[1][1], _e1139[0][1], (_e1139[0][1] > _e1139[1][1]));
                                                        let _e1230 = select(_e1139[1][2], _e1139[0][2], (_e1139[0][2] < _e1139[1][2]));
                                                        let _e1234 = select(_e1139[1][2], _e1139[0][2], (_e1139[0][2] > _e1139[1][2]));
                                                        let _e1239 = ((select(_e1139[2][0], _e1214, (_e1214 < _e1139[2][0])) - _e397) * _e402);
                                                        let _e1240 = ((select(_e1139[2][0], _e1218, (_e1218 > _e1139[2][0])) - _e398) * _e402);
                                                        let _e1243 = ((select(_e1139[2][1], _e1222, (_e1222 < _e1139[2][1])) - _e433) * _e438);
                                                        let _e1244 = ((select(_e1139[2][1], _e1226, (_e1226 > _e1139[2][1])) - _e434) * _e438);
                                                        let _e1247 = ((select(_e1139[2][2], _e1230, (_e1230 < _e1139[2][2])) - _e469) * _e474);
                                                        let _e1248 = ((select(_e1139[2][2], _e1234, (_e1234 > _e1139[2][2])) - _e470) * _e474);
                                                        let _e1250 = select(_e1248, _e1247, (_e1247 < _e1248));
                                                        let _e1252 = select(_e1248, _e1247, (_e1247 > _e1248));
                                                        let _e1254 = select(_e1240, _e1239, (_e1239 < _e1240));
                                                        let _e1256 = select(_e1244, _e1243, (_e1243 < _e1244));
                                                        let _e1258 = select(_e1256, _e1254, (_e1254 > _e1256));
                                                        let _e1260 = select(_e1250, _e1258, (_e1258 > _e1250));
                                                        let _e1262 = select(_e1240, _e1239, (_e1239 > _e1240));
                                                        let _e1264 = select(_e1244, _e1243, (_e1243 > _e1244));
                                                        let _e1266 = select(_e1264, _e1262, (_e1262 < _e1264));
                                                        let _e1268 = select(_e1252, _e1266, (_e1266 < _e1252));
                                                        let _e1269 = -(_e1250);
                                                        let _e1275 = select(_e520, _e1260, (_e1260 > _e520));
                                                        if (_e1275 > (_e1268 + (select(_e1269, _e1252, (_e1252 > _e1269)) * 0.0000019073523f))) {
                                                            phi_2751_ = type_25();
                                                            phi_2752_ = true;
                                                        } else {
                                                            let _e1277 = (_e1275 > _e1043.member_1);
                                                            if _e1277 {
                                                                phi_2750_ = type_25();
                                                            } else {
                                                                let _e1281 = (_e1139[1][0] - _e1139[0][0]);
                                                                let _e1282 = (_e1139[1][1] - _e1139[0][1]);
                                                                let _e1283 = (_e1139[1][2] - _e1139[0][2]);
                                                                let _e1284 = vec3<f32>(_e1281, _e1282, _e1283);
                                                                let _e1285 = (_e1139[2][0] - _e1139[1][0]);
                                                                let _e1286 = (_e1139[2][1] - _e1139[1][1]);
                                                                let _e1287 = (_e1139[2][2] - _e1139[1][2]);
                                                                let _e1288 = vec3<f32>(_e1285, _e1286, _e1287);
                                                                let _e1289 = (_e1139[0][0] - _e1139[2][0]);
                                                                let _e1290 = (_e1139[0][1] - _e1139[2][1]);
                                                                let _e1291 = (_e1139[0][2] - _e1139[2][2]);
                                                                let _e1292 = vec3<f32>(_e1289, _e1290, _e1291);
                                                                let _e1295 = bitcast<f32>((bitcast<u32>(_e1281) & 2147483647u));
                                                                let _e1298 = bitcast<f32>((bitcast<u32>(_e1282) & 2147483647u));
                                                                let _e1300 = select(_e1298, _e1295, (_e1295 > _e1298));
                                                                let _e1303 = bitcast<f32>((bitcast<u32>(_e1283) & 2147483647u));
                                                                let _e1305 = select(_e1303, _e1300, (_e1300 > _e1303));
                                                                let _e1308 = bitcast<f32>((bitcast<u32>(_e1285) & 2147483647u));
                                                                let _e1311 = bitcast<f32>((bitcast<u32>(_e1286) & 2147483647u));
                                                                let _e1313 = select(_e1311, _e1308, (_e1308 > _e1311));
                                                                let _e1316 = bitcast<f32>((bitcast<u32>(_e1287) & 2147483647u));
                                                                let _e1318 = select(_e1316, _e1313, (_e1313 > _e1316));
                                                                let _e1321 = bitcast<f32>((bitcast<u32>(_e1289) & 2147483647u));
                                                                let _e1324 = bitcast<f32>((bitcast<u32>(_e1290) & 2147483647u));
                                                                let _e1326 = select(_e1324, _e1321, (_e1321 > _e1324));
                                                                let _e1329 = bitcast<f32>((bitcast<u32>(_e1291) & 2147483647u));
                                                                let _e1331 = select(_e1329, _e1326, (_e1326 > _e1329));
                                                                let _e1333 = select(_e1318, _e1305, (_e1305 > _e1318));
                                                                let _e1335 = select(_e1331, _e1333, (_e1333 > _e1331));
                                                                if (_e1305 == _e1335) {
                                                                    phi_2661_ = _e1288;
                                                                    phi_2662_ = _e1292;
                                                                } else {
                                                                    let _e1338 = vec3((_e1318 == _e1335));
                                                                    phi_2661_ = select(_e1284, _e1292, _e1338);
                                                                    phi_2662_ = select(_e1288, _e1284, _e1338);
                                                                }
                                                                let _e1342 = phi_2661_;
                                                                let _e1344 = phi_2662_;
                                                                let _e1351 = ((_e1342.y * _e1344.z) - (_e1344.y * _e1342.z));
                                                                let _e1356 = ((_e1342.z * _e1344.x) - (_e1344.z * _e1342.x));
                                                                let _e1359 = ((_e1342.x * _e1344.y) - (_e1344.x * _e1342.y));
                                                                if (_e1201 >= _e1205) {
                                                                    phi_2693_ = select(true, false, (_e1201 >= _e1209));
                                                                } else {
                                                                    phi_2693_ = true;
                                                                }
                                                                let _e1364 = phi_2693_;
                                                                if _e1364 {
                                                                    phi_2702_ = select(vec3<f32>(_e1139[2][0], _e1139[2][1], _e1139[2][2]), vec3<f32>(_e1139[1][0], _e1139[1][1], _e1139[1][2]), vec3((_e1205 >= _e1209)));
                                                                } else {
                                                                    phi_2702_ = vec3<f32>(_e1139[0][0], _e1139[0][1], _e1139[0][2]);
                                                                }
                                                                let _e1369 = phi_2702_;
                                                                let _e1386 = ((((_e1351 * (_e1369.x - _e374)) + (_e1356 * (_e1369.y - _e411))) + (_e1359 * (_e1369.z - _e447))) / (((_e1351 * _e399) + (_e1356 * _e435)) + (_e1359 * _e471)));
                                                                let _e1388 = select(_e1268, _e1386, (_e1386 < _e1268));
                                                                let _e1390 = select(_e1260, _e1388, (_e1388 > _e1260));
                                                                if (_e1390 >= _e520) {
                                                                    let _e1392 = (_e1390 <= _e1043.member_1);
                                                                    if _e1392 {
                                                                        let _e1393 = (1f / _e1211);
                                                                        phi_2742_ = type_25(_e1390, (_e1205 * _e1393), (_e1209 * _e1393), _e1072);
                                                                    } else {
                                                                        phi_2742_ = type_25();
                                                                    }
                                                                    let _e1398 = phi_2742_;
                                                                    phi_2744_ = _e1398;
                                                                    phi_2745_ = select(true, false, _e1392);
                                                                } else {
                                                                    phi_2744_ = type_25();
                                                                    phi_2745_ = true;
                                                                }
                                                                let _e1401 = phi_2744_;
                                                                let _e1403 = phi_2745_;
                                                                if _e1403 {
                                                                    phi_2749_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2749_ = _e1401;
                                                                }
                                                                let _e1405 = phi_2749_;
                                                                phi_2750_ = _e1405;
                                                            }
                                                            let _e1407 = phi_2750_;
                                                            phi_2751_ = _e1407;
                                                            phi_2752_ = _e1277;
                                                        }
                                                        let _e1409 = phi_2751_;
                                                        let _e1411 = phi_2752_;
                                                        phi_2756_ = _e1409;
                                                        phi_2757_ = _e1411;
                                                    }
                                                    let _e1413 = phi_2756_;
                                                    let _e1415 = phi_2757_;
                                                    phi_2761_ = _e1413;
                                                    phi_2762_ = _e1415;
                                                } else {
                                                    phi_2761_ = type_25();
                                                    phi_2762_ = true;
                                                }
                                                let _e1417 = phi_2761_;
                                                let _e1419 = phi_2762_;
                                                if _e1419 {
                                                    phi_2766_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2766_ = _e1417;
                                                }
                                                let _e1421 = phi_2766_;
                                                if (_e1421.member_3 != 4294967295u) {
                                                    if (_e1072 == _e156) {
                                                        phi_3095_ = false;
                                                    } else {
                                                        let _e1425 = (_e1072 < arrayLength((&global_5.member)));
                                                        if _e1425 {
                                                            if _e1425 {
                                                            } else {
                                                                phi_4751_ = true;
                                                                break;
                                                            }
                                                            let _e1427 = global_5.member[_e1072];
                                                            phi_2789_ = _e1427;
                                                        } else {
                                                            phi_2789_ = 4294967295u;
                                                        }
                                                        let _e1429 = phi_2789_;
                                                        let _e1430 = (_e1429 < arrayLength((&global_6.member)));
                                                        if _e1430 {
                                                            if _e1430 {
                                                            } else {
                                                                phi_4751_ = true;
                                                                break;
                                                            }
                                                            let _e1432 = global_6.member[_e1429];
                                                            phi_2803_ = _e1432;
                                                        } else {
                                                            phi_2803_ = 0i;
                                                        }
                                                        let _e1434 = phi_2803_;
                                                        let _e1435 = (_e1434 == 0i);
                                                        if _e1435 {
                                                            phi_3094_ = true;
                                                        } else {
                                                            if _e366 {
                                                                phi_2824_ = vec3<f32>(_e1139[0][0], _e1139[0][1], _e1139[0][2]);
                                                            } else {
                                                                if (_e346 == 1u) {
                                                                    phi_2823_ = vec3<f32>(_e1139[0][2], _e1139[0][0], _e1139[0][1]);
                                                                } else {
                                                                    phi_2823_ = vec3<f32>(_e1139[0][1], _e1139[0][2], _e1139[0][0]);
                                                                }
                                                                let _e1440 = phi_2823_;
                                                                phi_2824_ = _e1440;
                                                            }
                                                            let _e1443 = phi_2824_;
                                                            if _e366 {
                                                                phi_2841_ = vec3<f32>(_e1139[1][0], _e1139[1][1], _e1139[1][2]);
                                                            } else {
                                                                if (_e346 == 1u) {
                                                                    phi_2840_ = vec3<f32>(_e1139[1][2], _e1139[1][0], _e1139[1][1]);
                                                                } else {
                                                                    phi_2840_ = vec3<f32>(_e1139[1][1], _e1139[1][2], _e1139[1][0]);
                                                                }
                                                                let _e1448 = phi_2840_;
                                                                phi_2841_ = _e1448;
                                                            }
                                                            let _e1451 = phi_2841_;
                                                            if _e366 {
                                                                phi_2858_ = vec3<f32>(_e1139[2][0], _e1139[2][1], _e1139[2][2]);
                                                            } else {
                                                                if (_e346 == 1u) {
                                                                    phi_2857_ = vec3<f32>(_e1139[2][2], _e1139[2][0], _e1139[2][1]);
                                                                } else {
                                                                    phi_2857_ = vec3<f32>(_e1139[2][1], _e1139[2][2], _e1139[2][0]);
                                                                }
                                                                let _e1456 = phi_2857_;
                                                                phi_2858_ = _e1456;
                                                            }
                                                            let _e1459 = phi_2858_;
                                                            let _e1462 = (_e1451.x - _e1443.x);
                                                            let _e1465 = (_e1451.y - _e1443.y);
                                                            let _e1468 = (_e1451.z - _e1443.z);
                                                            let _e1470 = (_e1459.x - _e1443.x);
                                                            let _e1472 = (_e1459.y - _e1443.y);
                                                            let _e1474 = (_e1459.z - _e1443.z);
                                                            if (_e224.member_1 == 1u) {
                                                                phi_2894_ = (vec3<f32>(_e224.member[0], _e224.member[1], _e224.member[2]) - _e1443);
                                                            } else {
                                                                phi_2894_ = vec3<f32>(_e224.member[0], _e224.member[1], _e224.member[2]);
                                                            }
                                                            let _e1489 = phi_2894_;
                                                            let _e1495 = bitcast<f32>((bitcast<u32>((_e1462 * _e1472)) ^ _e224.member_3[0]));
                                                            let _e1499 = bitcast<f32>((bitcast<u32>((_e1465 * _e1470)) ^ _e224.member_3[0]));
                                                            let _e1503 = bitcast<f32>((bitcast<u32>((_e1465 * _e1474)) ^ _e224.member_3[0]));
                                                            let _e1507 = bitcast<f32>((bitcast<u32>((_e1468 * _e1472)) ^ _e224.member_3[0]));
                                                            let _e1511 = bitcast<f32>((bitcast<u32>((_e1468 * _e1470)) ^ _e224.member_3[0]));
                                                            let _e1515 = bitcast<f32>((bitcast<u32>((_e1462 * _e1474)) ^ _e224.member_3[0]));
                                                            let _e1516 = (_e1503 - _e1507);
                                                            let _e1517 = (_e1511 - _e1515);
                                                            let _e1518 = (_e1495 - _e1499);
                                                            let _e1542 = (bitcast<f32>((bitcast<u32>(_e1503) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1507) & 2147483647u)));
                                                            let _e1549 = (bitcast<f32>((bitcast<u32>(_e1511) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1515) & 2147483647u)));
                                                            let _e1556 = (bitcast<f32>((bitcast<u32>(_e1495) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1499) & 2147483647u)));
                                                            if (_e224.member_2 == 0f) {
                                                                phi_3076_ = 0f;
                                                            } else {
                                                                let _e1586 = bitcast<f32>((bitcast<u32>(_e1516) & 2147483647u));
                                                                let _e1589 = bitcast<f32>((bitcast<u32>(_e1517) & 2147483647u));
                                                                let _e1592 = bitcast<f32>((bitcast<u32>(_e1518) & 2147483647u));
                                                                let _e1594 = select(_e1592, _e1589, (_e1589 > _e1592));
                                                                let _e1598 = select(_e1592, _e1589, (_e1589 < _e1592));
                                                                let _e1602 = select(_e1589, _e1586, (_e1586 < _e1589));
                                                                let _e1604 = select(_e1589, _e1586, (_e1586 > _e1589));
                                                                let _e1606 = select(_e1592, _e1604, (_e1604 < _e1592));
                                                                phi_3076_ = bitcast<f32>((bitcast<u32>((_e224.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1594, _e1586, (_e1586 > _e1594)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1606, _e1602, (_e1602 > _e1606)))) ^ _e224.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1598, _e1586, (_e1586 < _e1598)))) ^ _e224.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1542 + _e1549) + _e1556))) ^ _e224.member_3[0]))) * 1.0000005f)) ^ _e224.member_3[0])))) ^ _e224.member_3[0]));
                                                            }
                                                            let _e1633 = phi_3076_;
                                                            phi_3094_ = (_e1435 || !(((((bitcast<f32>((bitcast<u32>((_e1489.x * _e1516)) ^ _e224.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1489.y * _e1517)) ^ _e224.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1489.z * _e1518)) ^ _e224.member_3[0]))) * f32(-(_e1434))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1489.x) & 2147483647u)) * _e1542)) ^ _e224.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1489.y) & 2147483647u)) * _e1549)) ^ _e224.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1489.z) & 2147483647u)) * _e1556)) ^ _e224.member_3[0]))))) ^ _e224.member_3[0])) + _e1633) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1647 = phi_3094_;
                                                        phi_3095_ = _e1647;
                                                    }
                                                    let _e1649 = phi_3095_;
                                                    if _e1649 {
                                                        if (_e1421.member < _e1043.member.member) {
                                                            phi_3115_ = true;
                                                        } else {
                                                            if (_e1421.member == _e1043.member.member) {
                                                                phi_3114_ = (_e1421.member_3 < _e1043.member.member_3);
                                                            } else {
                                                                phi_3114_ = false;
                                                            }
                                                            let _e1659 = phi_3114_;
                                                            phi_3115_ = _e1659;
                                                        }
                                                        let _e1661 = phi_3115_;
                                                        if _e1661 {
                                                            phi_3121_ = type_41(_e1421, _e1421.member);
                                                        } else {
                                                            phi_3121_ = _e1043;
                                                        }
                                                        let _e1664 = phi_3121_;
                                                        phi_3122_ = _e1664;
                                                    } else {
                                                        phi_3122_ = _e1043;
                                                    }
                                                    let _e1666 = phi_3122_;
                                                    phi_3123_ = _e1666;
                                                } else {
                                                    phi_3123_ = _e1043;
                                                }
                                                let _e1668 = phi_3123_;
                                                phi_2055_ = _e1668;
                                            } else {
                                                phi_2055_ = type_41();
                                            }
                                            let _e1670 = phi_2055_;
                                            continue;
                                            continuing {
                                                phi_2054_ = _e1670;
                                                phi_2057_ = _e1058;
                                                phi_4751_ = _e562;
                                                break if !(_e1064);
                                            }
                                        }
                                        let _e1673 = phi_4751_;
                                        phi_4883_ = _e1673;
                                        if _e1673 {
                                            break;
                                        }
                                        phi_4887_ = _e1673;
                                        let _e1886 = local_5;
                                        phi_4426_ = _e1886;
                                        phi_4427_ = _e593;
                                        phi_4428_ = false;
                                        phi_4429_ = _e597;
                                    } else {
                                        if (_e593.member_1 >= _e89) {
                                            phi_4026_ = type_63(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e593.member_1 < _e89) {
                                            } else {
                                                phi_4883_ = true;
                                                break;
                                            }
                                            let _e610 = ((1u + (_e346 * 2u)) % 7u);
                                            if (_e610 < 7u) {
                                            } else {
                                                phi_4883_ = true;
                                                break;
                                            }
                                            let _e615 = global_10.member[_e593.member_1][_e610];
                                            let _e618 = ((1u + (_e345 * 2u)) % 7u);
                                            if (_e618 < 7u) {
                                            } else {
                                                phi_4883_ = true;
                                                break;
                                            }
                                            let _e623 = global_10.member[_e593.member_1][_e618];
                                            let _e626 = ((1u + (_e347 * 2u)) % 7u);
                                            if (_e626 < 7u) {
                                            } else {
                                                phi_4883_ = true;
                                                break;
                                            }
                                            let _e631 = global_10.member[_e593.member_1][_e626];
                                            let _e634 = (((_e346 + 1u) * 2u) % 7u);
                                            if (_e634 < 7u) {
                                            } else {
                                                phi_4883_ = true;
                                                break;
                                            }
                                            let _e639 = global_10.member[_e593.member_1][_e634];
                                            let _e642 = (((_e345 + 1u) * 2u) % 7u);
                                            if (_e642 < 7u) {
                                            } else {
                                                phi_4883_ = true;
                                                break;
                                            }
                                            let _e647 = global_10.member[_e593.member_1][_e642];
                                            let _e650 = (((_e347 + 1u) * 2u) % 7u);
                                            if (_e650 < 7u) {
                                            } else {
                                                phi_4883_ = true;
                                                break;
                                            }
                                            let _e655 = global_10.member[_e593.member_1][_e650];
                                            let _e678 = (bitcast<f32>((bitcast<u32>((_e593.member.member_1.x - _e593.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e679 = (bitcast<f32>((bitcast<u32>((_e593.member.member_1.y - _e593.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e680 = (bitcast<f32>((bitcast<u32>((_e593.member.member_1.z - _e593.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e682 = select(_e147, _e678, (_e678 > _e147));
                                            let _e684 = select(_e147, _e679, (_e679 > _e147));
                                            let _e686 = select(_e147, _e680, (_e680 > _e147));
                                            let _e711 = bitcast<u32>((f32(bitcast<i32>((_e615 & 2097151u))) * _e682));
                                            let _e716 = (bitcast<i32>((_e615 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e719 = bitcast<f32>((_e711 & bitcast<u32>(_e716)));
                                            let _e720 = bitcast<u32>((f32(bitcast<i32>((_e623 & 2097151u))) * _e684));
                                            let _e725 = (bitcast<i32>((_e623 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e728 = bitcast<f32>((_e720 & bitcast<u32>(_e725)));
                                            let _e729 = bitcast<u32>((f32(bitcast<i32>((_e631 & 2097151u))) * _e686));
                                            let _e734 = (bitcast<i32>((_e631 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e737 = bitcast<f32>((_e729 & bitcast<u32>(_e734)));
                                            let _e741 = bitcast<f32>((_e711 & bitcast<u32>(~(_e716))));
                                            let _e745 = bitcast<f32>((_e720 & bitcast<u32>(~(_e725))));
                                            let _e749 = bitcast<f32>((_e729 & bitcast<u32>(~(_e734))));
                                            let _e750 = bitcast<u32>((f32(bitcast<i32>((_e639 & 2097151u))) * _e682));
                                            let _e755 = (bitcast<i32>((_e639 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e758 = bitcast<f32>((_e750 & bitcast<u32>(_e755)));
                                            let _e759 = bitcast<u32>((f32(bitcast<i32>((_e647 & 2097151u))) * _e684));
                                            let _e764 = (bitcast<i32>((_e647 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e767 = bitcast<f32>((_e759 & bitcast<u32>(_e764)));
                                            let _e768 = bitcast<u32>((f32(bitcast<i32>((_e655 & 2097151u))) * _e686));
                                            let _e773 = (bitcast<i32>((_e655 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e776 = bitcast<f32>((_e768 & bitcast<u32>(_e773)));
                                            let _e780 = bitcast<f32>((_e750 & bitcast<u32>(~(_e755))));
                                            let _e784 = bitcast<f32>((_e759 & bitcast<u32>(~(_e764))));
                                            let _e788 = bitcast<f32>((_e768 & bitcast<u32>(~(_e773))));
                                            let _e818 = global_10.member[_e593.member_1][0u];
                                            let _e822 = global_10.member[_e593.member_1][2u];
                                            let _e826 = global_10.member[_e593.member_1][4u];
                                            let _e830 = global_10.member[_e593.member_1][6u];
                                            let _e842 = (((_e822 >> bitcast<u32>(22i)) | ((_e826 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e830 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e843 = (_e818 & 268435455u);
                                            let _e844 = (_e842 & 268435455u);
                                            let _e847 = ((_e818 >> bitcast<u32>(28u)) & 7u);
                                            let _e855 = ((_e818 >> bitcast<u32>(31i)) | (((_e842 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e856 = (_e847 != 0u);
                                            if (_e847 == 0u) {
                                                phi_3988_ = _e843;
                                            } else {
                                                if (_e847 == 7u) {
                                                    phi_3987_ = 2147483648u;
                                                } else {
                                                    phi_3987_ = ((2147483648u | (_e847 << bitcast<u32>(28u))) | (_e844 & 268435455u));
                                                }
                                                let _e865 = phi_3987_;
                                                phi_3988_ = _e865;
                                            }
                                            let _e867 = phi_3988_;
                                            if _e856 {
                                                let _e868 = (_e847 != 7u);
                                                if _e868 {
                                                    phi_3998_ = (_e844 + _e847);
                                                } else {
                                                    phi_3998_ = u32();
                                                }
                                                let _e871 = phi_3998_;
                                                phi_4000_ = _e871;
                                                phi_4001_ = select(true, false, _e868);
                                            } else {
                                                phi_4000_ = u32();
                                                phi_4001_ = true;
                                            }
                                            let _e874 = phi_4000_;
                                            let _e876 = phi_4001_;
                                            if (_e855 == 0u) {
                                                phi_4022_ = (_e843 + select(0u, 1u, !(_e856)));
                                            } else {
                                                if (_e855 == 7u) {
                                                    phi_4021_ = 2147483648u;
                                                } else {
                                                    phi_4021_ = ((2147483648u | (_e855 << bitcast<u32>(28u))) | (select(_e874, _e844, _e876) & 268435455u));
                                                }
                                                let _e889 = phi_4021_;
                                                phi_4022_ = _e889;
                                            }
                                            let _e891 = phi_4022_;
                                            phi_4026_ = type_63(array<vec4<f32>, 3>(vec4<f32>((_e593.member.member.x + _e719), (_e593.member.member.x + _e741), (_e593.member.member_1.x - _e758), (_e593.member.member_1.x - _e780)), vec4<f32>((_e593.member.member.y + _e728), (_e593.member.member.y + _e745), (_e593.member.member_1.y - _e767), (_e593.member.member_1.y - _e784)), vec4<f32>((_e593.member.member.z + _e737), (_e593.member.member.z + _e749), (_e593.member.member_1.z - _e776), (_e593.member.member_1.z - _e788))), type_60(type_37((_e593.member.member + vec4<f32>(_e719, _e728, _e737, 0f)), (_e593.member.member_1 - vec4<f32>(_e758, _e767, _e776, 0f))), _e867), type_60(type_37((_e593.member.member + vec4<f32>(_e741, _e745, _e749, 0f)), (_e593.member.member_1 - vec4<f32>(_e780, _e784, _e788, 0f))), _e891));
                                        }
                                        let _e896 = phi_4026_;
                                        let _e908 = ((_e896.member[0].x - _e397) * _e402);
                                        let _e909 = ((_e896.member[0].y - _e397) * _e402);
                                        let _e910 = ((_e896.member[0].z - _e398) * _e402);
                                        let _e911 = ((_e896.member[0].w - _e398) * _e402);
                                        let _e921 = ((_e896.member[1].x - _e433) * _e438);
                                        let _e922 = ((_e896.member[1].y - _e433) * _e438);
                                        let _e923 = ((_e896.member[1].z - _e434) * _e438);
                                        let _e924 = ((_e896.member[1].w - _e434) * _e438);
                                        let _e934 = ((_e896.member[2].x - _e469) * _e474);
                                        let _e935 = ((_e896.member[2].y - _e469) * _e474);
                                        let _e936 = ((_e896.member[2].z - _e470) * _e474);
                                        let _e937 = ((_e896.member[2].w - _e470) * _e474);
                                        let _e939 = select(_e936, _e934, (_e934 < _e936));
                                        let _e941 = select(_e937, _e935, (_e935 < _e937));
                                        let _e943 = select(_e936, _e934, (_e934 > _e936));
                                        let _e945 = select(_e937, _e935, (_e935 > _e937));
                                        let _e947 = select(_e910, _e908, (_e908 < _e910));
                                        let _e949 = select(_e911, _e909, (_e909 < _e911));
                                        let _e951 = select(_e923, _e921, (_e921 < _e923));
                                        let _e953 = select(_e924, _e922, (_e922 < _e924));
                                        let _e955 = select(_e951, _e947, (_e947 > _e951));
                                        let _e957 = select(_e953, _e949, (_e949 > _e953));
                                        let _e959 = select(_e939, _e955, (_e955 > _e939));
                                        let _e961 = select(_e941, _e957, (_e957 > _e941));
                                        let _e963 = select(_e910, _e908, (_e908 > _e910));
                                        let _e965 = select(_e911, _e909, (_e909 > _e911));
                                        let _e967 = select(_e923, _e921, (_e921 > _e923));
                                        let _e969 = select(_e924, _e922, (_e922 > _e924));
                                        let _e971 = select(_e967, _e963, (_e963 < _e967));
                                        let _e973 = select(_e969, _e965, (_e965 < _e969));
                                        let _e978 = -(_e939);
                                        let _e979 = -(_e941);
                                        let _e986 = (select(_e943, _e971, (_e971 < _e943)) + (select(_e978, _e943, (_e943 > _e978)) * 0.0000019073523f));
                                        let _e987 = (select(_e945, _e973, (_e973 < _e945)) + (select(_e979, _e945, (_e945 > _e979)) * 0.0000019073523f));
                                        let _e989 = select(_e520, _e959, (_e959 > _e520));
                                        let _e991 = select(_e520, _e961, (_e961 > _e520));
                                        let _e996 = (_e989 <= select(_e564.member_1, _e986, (_e986 < _e564.member_1)));
                                        let _e997 = (_e991 <= select(_e564.member_1, _e987, (_e987 < _e564.member_1)));
                                        let _e998 = (_e989 <= _e991);
                                        if _e996 {
                                            if _e997 {
                                                if _e998 {
                                                    phi_4370_ = _e896.member_2;
                                                } else {
                                                    phi_4370_ = _e896.member_1;
                                                }
                                                let _e1002 = phi_4370_;
                                                let _e1003 = (_e597 % 128u);
                                                let _e1004 = (_e1003 < 128u);
                                                if _e1004 {
                                                } else {
                                                    phi_4883_ = true;
                                                    break;
                                                }
                                                local_3[_e1003] = type_60(type_37(_e1002.member.member, _e1002.member.member_1), _e1002.member_1);
                                                if _e1004 {
                                                } else {
                                                    phi_4883_ = true;
                                                    break;
                                                }
                                                local_2[_e1003] = select(_e991, _e989, (_e989 > _e991));
                                                if _e998 {
                                                    phi_4403_ = _e896.member_1;
                                                } else {
                                                    phi_4403_ = _e896.member_2;
                                                }
                                                let _e1019 = phi_4403_;
                                                phi_4404_ = _e1019;
                                                phi_4405_ = (_e597 + 1u);
                                            } else {
                                                phi_4404_ = type_60();
                                                phi_4405_ = u32();
                                            }
                                            let _e1021 = phi_4404_;
                                            let _e1023 = phi_4405_;
                                            phi_4407_ = _e1021;
                                            phi_4408_ = _e1023;
                                            phi_4409_ = select(true, false, _e997);
                                        } else {
                                            phi_4407_ = type_60();
                                            phi_4408_ = u32();
                                            phi_4409_ = true;
                                        }
                                        let _e1026 = phi_4407_;
                                        let _e1028 = phi_4408_;
                                        let _e1030 = phi_4409_;
                                        if _e1030 {
                                            if _e996 {
                                                phi_4418_ = _e896.member_1;
                                            } else {
                                                phi_4418_ = _e896.member_2;
                                            }
                                            let _e1034 = phi_4418_;
                                            phi_4423_ = _e1034;
                                            phi_4424_ = select(_e997, true, _e996);
                                        } else {
                                            phi_4423_ = _e1026;
                                            phi_4424_ = _e595;
                                        }
                                        let _e1037 = phi_4423_;
                                        let _e1039 = phi_4424_;
                                        phi_4887_ = _e562;
                                        phi_4426_ = _e564;
                                        phi_4427_ = _e1037;
                                        phi_4428_ = _e1039;
                                        phi_4429_ = select(_e1028, _e597, _e1030);
                                    }
                                    let _e1675 = phi_4887_;
                                    let _e1677 = phi_4426_;
                                    let _e1679 = phi_4427_;
                                    let _e1681 = phi_4428_;
                                    let _e1683 = phi_4429_;
                                    phi_4886_ = _e1675;
                                    phi_4430_ = _e1677;
                                    phi_4431_ = _e1679;
                                    phi_4432_ = (_e568 - 1u);
                                    phi_4433_ = _e1681;
                                    phi_4434_ = _e1683;
                                } else {
                                    phi_4886_ = _e562;
                                    phi_4430_ = _e564;
                                    phi_4431_ = _e593;
                                    phi_4432_ = _e568;
                                    phi_4433_ = _e595;
                                    phi_4434_ = _e597;
                                }
                                let _e1685 = phi_4886_;
                                let _e1687 = phi_4430_;
                                let _e1689 = phi_4431_;
                                let _e1691 = phi_4432_;
                                let _e1693 = phi_4433_;
                                let _e1695 = phi_4434_;
                                phi_4885_ = _e1685;
                                phi_4435_ = _e1687;
                                phi_4436_ = _e1689;
                                phi_4437_ = _e1691;
                                phi_4438_ = _e1693;
                                phi_4439_ = _e1695;
                            } else {
                                phi_4885_ = _e562;
                                phi_4435_ = type_41();
                                phi_4436_ = type_60();
                                phi_4437_ = u32();
                                phi_4438_ = bool();
                                phi_4439_ = u32();
                            }
                            let _e1697 = phi_4885_;
                            let _e1699 = phi_4435_;
                            let _e1701 = phi_4436_;
                            let _e1703 = phi_4437_;
                            let _e1705 = phi_4438_;
                            let _e1707 = phi_4439_;
                            phi_4884_ = _e1697;
                            phi_1978_ = _e1699;
                            phi_1981_ = _e1701;
                            phi_1983_ = _e1703;
                            phi_1985_ = _e1705;
                            phi_1987_ = _e1707;
                            phi_4440_ = _e576;
                        } else {
                            phi_4884_ = _e562;
                            phi_1978_ = type_41();
                            phi_1981_ = type_60();
                            phi_1983_ = u32();
                            phi_1985_ = bool();
                            phi_1987_ = u32();
                            phi_4440_ = false;
                        }
                        let _e1709 = phi_4884_;
                        let _e1711 = phi_1978_;
                        let _e1713 = phi_1981_;
                        let _e1715 = phi_1983_;
                        let _e1717 = phi_1985_;
                        let _e1719 = phi_1987_;
                        let _e1721 = phi_4440_;
                        continue;
                        continuing {
                            phi_4757_ = _e1709;
                            phi_1977_ = _e1711;
                            phi_1980_ = _e1713;
                            phi_1982_ = _e1715;
                            phi_1984_ = _e1717;
                            phi_1986_ = _e1719;
                            phi_4883_ = _e1709;
                            break if !(_e1721);
                        }
                    }
                    let _e1724 = phi_4883_;
                    if _e1724 {
                        break;
                    }
                    let _e1726 = local_4;
                    if (_e1726.member.member_3 != 4294967295u) {
                        let _e1731 = (_e348 / 3i);
                        let _e1738 = bitcast<f32>((bitcast<u32>((_e1731 + 127i)) << bitcast<u32>(23i)));
                        let _e1746 = (((_e1726.member.member * _e1738) * _e1738) * bitcast<f32>((bitcast<u32>(((_e348 - (2i * _e1731)) + 127i)) << bitcast<u32>(23i))));
                        let _e1748 = select(340282350000000000000000000000000000000f, _e1746, (_e1746 < 340282350000000000000000000000000000000f));
                        phi_4492_ = type_25(select(-340282350000000000000000000000000000000f, _e1748, (_e1748 > -340282350000000000000000000000000000000f)), _e1726.member.member_1, _e1726.member.member_2, _e1726.member.member_3);
                    } else {
                        phi_4492_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1755 = phi_4492_;
                    if _e225 {
                    } else {
                        break;
                    }
                    global_8.member[_e135] = _e1755;
                    if _e150 {
                    } else {
                        break;
                    }
                    let _e1759 = select(0u, 1u, (_e292 <= _e302));
                    if (_e1759 > 0u) {
                        let _e1761 = (1u < _e103);
                        if _e1761 {
                            if (0u < _e103) {
                            } else {
                                break;
                            }
                            let _e1765 = atomicAdd((&global_9.member[0u]), _e1759);
                            if ((_e1765 + _e1759) < _e1765) {
                                if _e1761 {
                                } else {
                                    break;
                                }
                                let _e1770 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1773 = select(0u, 1u, (_e1755.member_3 != 4294967295u));
                    if (_e1773 > 0u) {
                        let _e1775 = (3u < _e103);
                        if _e1775 {
                            if (2u < _e103) {
                            } else {
                                break;
                            }
                            let _e1779 = atomicAdd((&global_9.member[2u]), _e1773);
                            if ((_e1779 + _e1773) < _e1779) {
                                if _e1775 {
                                } else {
                                    break;
                                }
                                let _e1784 = atomicAdd((&global_9.member[3u]), 1u);
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
fn trace_paths_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
