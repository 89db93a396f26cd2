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

struct type_24 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_25 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_28 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_35 {
    member: array<type_25>,
}

struct type_39 {
    member: array<array<type_24, 8>>,
}

struct type_45 {
    member: array<vec4<u32>, 2>,
}

struct type_54 {
    member: type_28,
    member_1: u32,
}

struct type_57 {
    member: array<vec4<f32>, 3>,
    member_1: type_54,
    member_2: type_54,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_45;
@group(0) @binding(2) 
var<storage> global_3: type_13;
@group(0) @binding(4) 
var<storage> global_4: type_35;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_39;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<type_24, 8>;
    var local_3: array<f32, 128>;
    var local_4: array<type_54, 128>;
    var local_5: array<u32, 3>;
    var local_6: array<array<f32, 3>, 3>;
    var local_7: array<f32, 4>;
    var phi_409_: i32;
    var phi_410_: i32;
    var phi_420_: bool;
    var phi_430_: u32;
    var phi_431_: u32;
    var phi_433_: bool;
    var phi_438_: u32;
    var phi_483_: f32;
    var phi_489_: f32;
    var phi_500_: f32;
    var phi_506_: f32;
    var phi_529_: f32;
    var phi_540_: f32;
    var phi_549_: f32;
    var phi_555_: f32;
    var phi_566_: f32;
    var phi_572_: f32;
    var phi_595_: f32;
    var phi_606_: f32;
    var phi_615_: f32;
    var phi_621_: f32;
    var phi_632_: f32;
    var phi_638_: f32;
    var phi_661_: f32;
    var phi_672_: f32;
    var phi_772_: f32;
    var phi_773_: f32;
    var phi_4870_: bool;
    var phi_4769_: f32;
    var phi_1946_: type_54;
    var phi_1949_: u32;
    var phi_1951_: bool;
    var phi_1953_: u32;
    var phi_1964_: bool;
    var phi_2002_: type_54;
    var phi_2003_: bool;
    var phi_2004_: u32;
    var phi_3696_: u32;
    var phi_3702_: u32;
    var phi_3956_: u32;
    var phi_3957_: u32;
    var phi_3967_: u32;
    var phi_3969_: u32;
    var phi_3970_: bool;
    var phi_3990_: u32;
    var phi_3991_: u32;
    var phi_3995_: type_57;
    var phi_4340_: type_54;
    var phi_4373_: type_54;
    var phi_4374_: type_54;
    var phi_4375_: u32;
    var phi_4377_: type_54;
    var phi_4378_: u32;
    var phi_4379_: bool;
    var phi_4388_: type_54;
    var phi_4393_: type_54;
    var phi_4394_: bool;
    var phi_4938_: f32;
    var phi_4867_: bool;
    var phi_2023_: type_8;
    var phi_2024_: type_8;
    var phi_2047_: type_8;
    var phi_2088_: u32;
    var phi_2094_: u32;
    var phi_2104_: u32;
    var phi_2120_: u32;
    var phi_2157_: u32;
    var phi_2163_: u32;
    var phi_2173_: u32;
    var phi_4852_: bool;
    var phi_2189_: type_8;
    var phi_2190_: type_8;
    var phi_2213_: type_8;
    var phi_2236_: u32;
    var phi_2251_: u32;
    var phi_2254_: type_8;
    var phi_2255_: type_8;
    var phi_2278_: type_8;
    var phi_2344_: u32;
    var phi_2324_: u32;
    var phi_2325_: u32;
    var phi_2348_: f32;
    var phi_4845_: bool;
    var phi_4920_: bool;
    var phi_4919_: bool;
    var phi_2849_: vec3<f32>;
    var phi_2850_: vec3<f32>;
    var phi_2881_: bool;
    var phi_2890_: vec3<f32>;
    var phi_2930_: type_24;
    var phi_2932_: type_24;
    var phi_2933_: bool;
    var phi_2937_: type_24;
    var phi_2938_: type_24;
    var phi_2939_: type_24;
    var phi_2940_: bool;
    var phi_2944_: type_24;
    var phi_2945_: bool;
    var phi_2949_: type_24;
    var phi_2950_: bool;
    var phi_2954_: type_24;
    var phi_2966_: type_8;
    var phi_2969_: type_24;
    var phi_2967_: type_8;
    var phi_2992_: type_8;
    var phi_3024_: bool;
    var phi_3025_: bool;
    var phi_3046_: type_24;
    var phi_2970_: type_24;
    var phi_4950_: bool;
    var phi_5234_: f32;
    var phi_5233_: f32;
    var phi_5012_: bool;
    var phi_5232_: f32;
    var phi_5011_: bool;
    var phi_5231_: f32;
    var phi_5010_: bool;
    var phi_5171_: f32;
    var phi_5009_: bool;
    var phi_5136_: f32;
    var phi_5018_: bool;
    var phi_4396_: type_54;
    var phi_4397_: bool;
    var phi_4398_: u32;
    var phi_5135_: f32;
    var phi_5017_: bool;
    var phi_4399_: type_54;
    var phi_4400_: u32;
    var phi_4401_: bool;
    var phi_4402_: u32;
    var phi_5134_: f32;
    var phi_5016_: bool;
    var phi_4403_: type_54;
    var phi_4404_: u32;
    var phi_4405_: bool;
    var phi_4406_: u32;
    var phi_5133_: f32;
    var phi_5015_: bool;
    var phi_1947_: type_54;
    var phi_1950_: u32;
    var phi_1952_: bool;
    var phi_1954_: u32;
    var phi_4407_: bool;
    var phi_5014_: bool;
    var phi_4414_: type_8;
    var phi_4415_: type_8;
    var phi_4438_: type_8;
    var phi_4504_: type_24;
    var phi_5126_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e90 = global;
            let _e92 = arrayLength((&global_3.member));
            let _e95 = arrayLength((&global_5.member));
            let _e103 = global_2.member[0u][0u];
            let _e107 = global_2.member[0u][1u];
            let _e111 = global_2.member[0u][2u];
            let _e115 = global_2.member[0u][3u];
            let _e119 = global_2.member[1u][0u];
            let _e123 = global_2.member[1u][1u];
            let _e127 = global_2.member[1u][2u];
            let _e130 = global_1.member[0u];
            let _e131 = bitcast<i32>(_e130);
            let _e143 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e115) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e103), bitcast<i32>(_e107), bitcast<i32>(_e111));
            local = array<i32, 3>(bitcast<i32>(_e119), bitcast<i32>(_e123), bitcast<i32>(_e127));
            let _e149 = (_e90.x + (_e90.y * 2097152u));
            let _e150 = (_e149 < arrayLength((&global_4.member)));
            if _e150 {
                let _e151 = (_e149 < arrayLength((&global_6.member)));
                if _e151 {
                    if _e150 {
                    } else {
                        break;
                    }
                    let _e159 = global_4.member[_e149].member_2[0u];
                    let _e161 = (bitcast<u32>(_e159) & 2147483647u);
                    let _e166 = global_4.member[_e149].member_2[1u];
                    let _e168 = (bitcast<u32>(_e166) & 2147483647u);
                    let _e173 = global_4.member[_e149].member_2[2u];
                    let _e175 = (bitcast<u32>(_e173) & 2147483647u);
                    let _e180 = global_4.member[_e149].member[0u];
                    let _e182 = (bitcast<u32>(_e180) & 2147483647u);
                    let _e187 = global_4.member[_e149].member[1u];
                    let _e189 = (bitcast<u32>(_e187) & 2147483647u);
                    let _e194 = global_4.member[_e149].member[2u];
                    let _e196 = (bitcast<u32>(_e194) & 2147483647u);
                    let _e198 = select(_e168, _e161, (_e168 < _e161));
                    let _e200 = select(_e175, _e198, (_e175 < _e198));
                    let _e202 = select(_e182, _e200, (_e182 < _e200));
                    let _e204 = select(_e189, _e202, (_e189 < _e202));
                    let _e206 = select(_e196, _e204, (_e196 < _e204));
                    let _e210 = global_4.member[_e149].member_1;
                    let _e212 = (bitcast<u32>(_e210) & 2147483647u);
                    let _e219 = global_4.member[_e149].member_3;
                    let _e225 = (((select(_e212, _e206, (_e212 < _e206)) < 2139095040u) && ((bitcast<u32>(_e219) & 2147483647u) <= 2139095040u)) && (_e200 > 0u));
                    if _e225 {
                        let _e228 = (bitcast<u32>(bitcast<f32>(_e200)) & 2147483647u);
                        if (_e228 >= 8388608u) {
                            phi_409_ = (bitcast<i32>((_e228 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_409_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e228)), 32u, (_e228 == 0u))));
                        }
                        let _e242 = phi_409_;
                        phi_410_ = _e242;
                    } else {
                        phi_410_ = 0i;
                    }
                    let _e244 = phi_410_;
                    let _e245 = (_e161 == _e200);
                    if _e245 {
                        phi_420_ = true;
                    } else {
                        phi_420_ = (_e168 == _e200);
                    }
                    let _e248 = phi_420_;
                    let _e249 = select(1u, 0u, _e245);
                    if _e248 {
                        let _e250 = (_e249 + 1u);
                        phi_430_ = _e250;
                        phi_431_ = _e250;
                        phi_433_ = select(true, false, (_e250 == 2u));
                    } else {
                        phi_430_ = u32();
                        phi_431_ = 0u;
                        phi_433_ = true;
                    }
                    let _e254 = phi_430_;
                    let _e256 = phi_431_;
                    let _e258 = phi_433_;
                    if _e258 {
                        phi_438_ = (_e256 + 1u);
                    } else {
                        phi_438_ = 0u;
                    }
                    let _e262 = phi_438_;
                    let _e263 = select(_e254, _e256, _e258);
                    let _e264 = select(_e249, select(2u, _e249, _e248), _e258);
                    let _e265 = (_e131 / 2i);
                    let _e270 = bitcast<f32>((bitcast<u32>((_e265 + 127i)) << bitcast<u32>(23i)));
                    let _e276 = bitcast<f32>((bitcast<u32>(((_e131 - _e265) + 127i)) << bitcast<u32>(23i)));
                    let _e277 = -(_e244);
                    let _e278 = (_e277 / 2i);
                    let _e283 = bitcast<f32>((bitcast<u32>((_e278 + 127i)) << bitcast<u32>(23i)));
                    let _e289 = bitcast<f32>((bitcast<u32>(((_e277 - _e278) + 127i)) << bitcast<u32>(23i)));
                    let _e293 = global_4.member[_e149].member;
                    let _e294 = (_e263 == 0u);
                    if _e294 {
                        phi_483_ = _e293[0];
                    } else {
                        phi_483_ = _e293[1];
                    }
                    let _e298 = phi_483_;
                    let _e299 = (_e263 == 2u);
                    if _e299 {
                        phi_489_ = _e293[2];
                    } else {
                        phi_489_ = _e298;
                    }
                    let _e302 = phi_489_;
                    let _e304 = ((_e302 * _e270) * _e276);
                    let _e305 = global_4.member[_e149].member_2;
                    if _e294 {
                        phi_500_ = _e305[0];
                    } else {
                        phi_500_ = _e305[1];
                    }
                    let _e309 = phi_500_;
                    if _e299 {
                        phi_506_ = _e305[2];
                    } else {
                        phi_506_ = _e309;
                    }
                    let _e312 = phi_506_;
                    let _e314 = ((_e312 * _e283) * _e289);
                    let _e318 = (bitcast<f32>((bitcast<u32>(_e314) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e318 {
                        let _e322 = (bitcast<f32>((bitcast<u32>(_e304) & 2147483647u)) * 0.00000011920929f);
                        phi_529_ = select(0.00000000000011368684f, _e322, (_e322 > 0.00000000000011368684f));
                    } else {
                        phi_529_ = 0f;
                    }
                    let _e326 = phi_529_;
                    let _e327 = (_e304 + _e326);
                    let _e328 = (_e304 - _e326);
                    let _e329 = select(_e314, 0f, _e318);
                    if _e318 {
                        phi_540_ = 38685626000000000000000000f;
                    } else {
                        phi_540_ = (1f / _e314);
                    }
                    let _e332 = phi_540_;
                    let _e333 = (_e262 == 0u);
                    if _e333 {
                        phi_549_ = _e293[0];
                    } else {
                        phi_549_ = _e293[1];
                    }
                    let _e337 = phi_549_;
                    let _e338 = (_e262 == 2u);
                    if _e338 {
                        phi_555_ = _e293[2];
                    } else {
                        phi_555_ = _e337;
                    }
                    let _e341 = phi_555_;
                    let _e343 = ((_e341 * _e270) * _e276);
                    if _e333 {
                        phi_566_ = _e305[0];
                    } else {
                        phi_566_ = _e305[1];
                    }
                    let _e347 = phi_566_;
                    if _e338 {
                        phi_572_ = _e305[2];
                    } else {
                        phi_572_ = _e347;
                    }
                    let _e350 = phi_572_;
                    let _e352 = ((_e350 * _e283) * _e289);
                    let _e356 = (bitcast<f32>((bitcast<u32>(_e352) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e356 {
                        let _e360 = (bitcast<f32>((bitcast<u32>(_e343) & 2147483647u)) * 0.00000011920929f);
                        phi_595_ = select(0.00000000000011368684f, _e360, (_e360 > 0.00000000000011368684f));
                    } else {
                        phi_595_ = 0f;
                    }
                    let _e364 = phi_595_;
                    let _e365 = (_e343 + _e364);
                    let _e366 = (_e343 - _e364);
                    let _e367 = select(_e352, 0f, _e356);
                    if _e356 {
                        phi_606_ = 38685626000000000000000000f;
                    } else {
                        phi_606_ = (1f / _e352);
                    }
                    let _e370 = phi_606_;
                    let _e371 = (_e264 == 0u);
                    if _e371 {
                        phi_615_ = _e293[0];
                    } else {
                        phi_615_ = _e293[1];
                    }
                    let _e375 = phi_615_;
                    let _e376 = (_e264 == 2u);
                    if _e376 {
                        phi_621_ = _e293[2];
                    } else {
                        phi_621_ = _e375;
                    }
                    let _e379 = phi_621_;
                    let _e381 = ((_e379 * _e270) * _e276);
                    if _e371 {
                        phi_632_ = _e305[0];
                    } else {
                        phi_632_ = _e305[1];
                    }
                    let _e385 = phi_632_;
                    if _e376 {
                        phi_638_ = _e305[2];
                    } else {
                        phi_638_ = _e385;
                    }
                    let _e388 = phi_638_;
                    let _e390 = ((_e388 * _e283) * _e289);
                    let _e394 = (bitcast<f32>((bitcast<u32>(_e390) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e394 {
                        let _e398 = (bitcast<f32>((bitcast<u32>(_e381) & 2147483647u)) * 0.00000011920929f);
                        phi_661_ = select(0.00000000000011368684f, _e398, (_e398 > 0.00000000000011368684f));
                    } else {
                        phi_661_ = 0f;
                    }
                    let _e402 = phi_661_;
                    let _e403 = (_e381 + _e402);
                    let _e404 = (_e381 - _e402);
                    let _e405 = select(_e390, 0f, _e394);
                    if _e394 {
                        phi_672_ = 38685626000000000000000000f;
                    } else {
                        phi_672_ = (1f / _e390);
                    }
                    let _e408 = phi_672_;
                    let _e411 = bitcast<f32>((bitcast<u32>(_e304) & 2147483647u));
                    let _e414 = bitcast<f32>((bitcast<u32>(_e343) & 2147483647u));
                    let _e416 = select(_e414, _e411, (_e411 > _e414));
                    let _e419 = bitcast<f32>((bitcast<u32>(_e381) & 2147483647u));
                    let _e422 = (_e131 + _e244);
                    if (_e225 && (select(_e419, _e416, (_e416 > _e419)) <= 1099511600000f)) {
                        let _e425 = (_e422 / 3i);
                        let _e432 = bitcast<f32>((bitcast<u32>((_e425 + 127i)) << bitcast<u32>(23i)));
                        let _e439 = bitcast<f32>((bitcast<u32>(((_e422 - (2i * _e425)) + 127i)) << bitcast<u32>(23i)));
                        let _e440 = (((_e210 * _e432) * _e432) * _e439);
                        let _e442 = select(340282350000000000000000000000000000000f, _e440, (_e440 < 340282350000000000000000000000000000000f));
                        let _e447 = (((_e219 * _e432) * _e432) * _e439);
                        let _e449 = select(340282350000000000000000000000000000000f, _e447, (_e447 < 340282350000000000000000000000000000000f));
                        phi_772_ = select(-340282350000000000000000000000000000000f, _e449, (_e449 > -340282350000000000000000000000000000000f));
                        phi_773_ = select(-340282350000000000000000000000000000000f, _e442, (_e442 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_772_ = 0f;
                        phi_773_ = 1f;
                    }
                    let _e453 = phi_772_;
                    let _e455 = phi_773_;
                    local_2 = array<type_24, 8>(type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_4 = array<type_54, 128>(type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e458 = (_e263 % 3u);
                    let _e459 = (_e458 < 3u);
                    if _e459 {
                    } else {
                        break;
                    }
                    let _e461 = local_1[_e458];
                    let _e464 = (_e262 % 3u);
                    let _e465 = (_e464 < 3u);
                    if _e465 {
                    } else {
                        break;
                    }
                    let _e467 = local_1[_e464];
                    let _e470 = (_e264 % 3u);
                    let _e471 = (_e470 < 3u);
                    if _e471 {
                    } else {
                        break;
                    }
                    let _e473 = local_1[_e470];
                    if _e459 {
                    } else {
                        break;
                    }
                    let _e478 = local[_e458];
                    if _e465 {
                    } else {
                        break;
                    }
                    let _e482 = local[_e464];
                    if _e471 {
                    } else {
                        break;
                    }
                    let _e486 = local[_e470];
                    phi_4870_ = false;
                    phi_4769_ = _e453;
                    phi_1946_ = type_54(type_28(vec4<f32>((f32(_e461) * _e143), (f32(_e467) * _e143), (f32(_e473) * _e143), 0f), vec4<f32>((f32(_e478) * _e143), (f32(_e482) * _e143), (f32(_e486) * _e143), 0f)), select(0u, 2147483648u, (_e92 == 0u)));
                    phi_1949_ = ((3u * _e92) + 1u);
                    phi_1951_ = (_e455 <= _e453);
                    phi_1953_ = 0u;
                    loop {
                        let _e496 = phi_4870_;
                        let _e498 = phi_4769_;
                        let _e500 = phi_1946_;
                        let _e502 = phi_1949_;
                        let _e504 = phi_1951_;
                        let _e506 = phi_1953_;
                        if _e504 {
                            phi_1964_ = true;
                        } else {
                            phi_1964_ = (_e506 > 0u);
                        }
                        let _e509 = phi_1964_;
                        if _e509 {
                            let _e510 = (_e502 > 0u);
                            if _e510 {
                                if _e504 {
                                    phi_2002_ = _e500;
                                    phi_2003_ = _e504;
                                    phi_2004_ = _e506;
                                } else {
                                    let _e511 = (_e506 - 1u);
                                    let _e512 = (_e511 % 128u);
                                    let _e513 = (_e512 < 128u);
                                    if _e513 {
                                    } else {
                                        phi_5014_ = true;
                                        break;
                                    }
                                    let _e515 = local_4[_e512];
                                    if _e513 {
                                    } else {
                                        phi_5014_ = true;
                                        break;
                                    }
                                    let _e523 = local_3[_e512];
                                    phi_2002_ = type_54(type_28(_e515.member.member, _e515.member.member_1), _e515.member_1);
                                    phi_2003_ = (_e523 <= _e498);
                                    phi_2004_ = _e511;
                                }
                                let _e526 = phi_2002_;
                                let _e528 = phi_2003_;
                                let _e530 = phi_2004_;
                                if _e528 {
                                    let _e535 = (_e526.member_1 & 268435455u);
                                    if ((_e526.member_1 & 2147483648u) != 0u) {
                                        phi_4938_ = _e498;
                                        phi_4867_ = _e496;
                                        phi_2023_ = type_8(0u, ((_e526.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e996 = phi_4938_;
                                            let _e998 = phi_4867_;
                                            let _e1000 = phi_2023_;
                                            if (_e1000.member < _e1000.member_1) {
                                                phi_2024_ = type_8((_e1000.member + 1u), _e1000.member_1);
                                                phi_2047_ = type_8(1u, _e1000.member);
                                            } else {
                                                phi_2024_ = _e1000;
                                                phi_2047_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1013 = phi_2024_;
                                            let _e1015 = phi_2047_;
                                            let _e1019 = (bitcast<i32>(_e1015.member) != 0i);
                                            if _e1019 {
                                                let _e1024 = (_e526.member.member_1.x - _e526.member.member.x);
                                                let _e1027 = (_e526.member.member_1.y - _e526.member.member.y);
                                                let _e1030 = (_e526.member.member_1.z - _e526.member.member.z);
                                                let _e1032 = select(_e1027, _e1024, (_e1024 > _e1027));
                                                let _e1034 = select(_e1030, _e1032, (_e1032 > _e1030));
                                                let _e1036 = (_e1034 < (1024f * _e143));
                                                if _e1036 {
                                                    phi_2088_ = 0u;
                                                } else {
                                                    phi_2088_ = select(2u, 1u, (_e1034 < (2097152f * _e143)));
                                                }
                                                let _e1041 = phi_2088_;
                                                switch bitcast<i32>(_e1041) {
                                                    case 0: {
                                                        phi_2094_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2094_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2094_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2094_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1044 = phi_2094_;
                                                switch bitcast<i32>(_e1041) {
                                                    case 0: {
                                                        phi_2104_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2104_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2104_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2104_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1051 = phi_2104_;
                                                let _e1053 = ((_e535 + (_e1015.member_1 * ((3u * _e1044) + 1u))) + (3u * _e1051));
                                                let _e1054 = (_e1053 < _e95);
                                                if _e1054 {
                                                    if _e1054 {
                                                    } else {
                                                        phi_5171_ = _e996;
                                                        phi_5009_ = true;
                                                        break;
                                                    }
                                                    let _e1056 = global_5.member[_e1053];
                                                    phi_2120_ = _e1056;
                                                } else {
                                                    phi_2120_ = 4294967295u;
                                                }
                                                let _e1058 = phi_2120_;
                                                local_5 = array<u32, 3>(_e263, _e262, _e264);
                                                if _e1036 {
                                                    phi_2157_ = 0u;
                                                } else {
                                                    phi_2157_ = select(2u, 1u, (_e1034 < (2097152f * _e143)));
                                                }
                                                let _e1064 = phi_2157_;
                                                switch bitcast<i32>(_e1064) {
                                                    case 0: {
                                                        phi_2163_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2163_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2163_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2163_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1067 = phi_2163_;
                                                switch bitcast<i32>(_e1064) {
                                                    case 0: {
                                                        phi_2173_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2173_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2173_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2173_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1074 = phi_2173_;
                                                local_7 = array<f32, 4>(_e526.member.member.x, _e526.member.member.y, _e526.member.member.z, _e526.member.member.w);
                                                local_6[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_6[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_6[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_4852_ = _e998;
                                                phi_2189_ = type_8(0u, 3u);
                                                loop {
                                                    let _e1088 = phi_4852_;
                                                    let _e1090 = phi_2189_;
                                                    if (_e1090.member < _e1090.member_1) {
                                                        phi_2190_ = type_8((_e1090.member + 1u), _e1090.member_1);
                                                        phi_2213_ = type_8(1u, _e1090.member);
                                                    } else {
                                                        phi_2190_ = _e1090;
                                                        phi_2213_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e1103 = phi_2190_;
                                                    let _e1105 = phi_2213_;
                                                    let _e1109 = (bitcast<i32>(_e1105.member) != 0i);
                                                    if _e1109 {
                                                        let _e1111 = ((_e535 + (_e1015.member_1 * ((3u * _e1067) + 1u))) + (_e1105.member_1 * _e1074));
                                                        let _e1112 = (_e1111 < _e95);
                                                        if _e1112 {
                                                            if _e1112 {
                                                            } else {
                                                                phi_4919_ = true;
                                                                break;
                                                            }
                                                            let _e1114 = global_5.member[_e1111];
                                                            phi_2236_ = _e1114;
                                                        } else {
                                                            phi_2236_ = 0u;
                                                        }
                                                        let _e1116 = phi_2236_;
                                                        let _e1117 = (_e1111 + 1u);
                                                        let _e1118 = (_e1117 < _e95);
                                                        if _e1118 {
                                                            if _e1118 {
                                                            } else {
                                                                phi_4919_ = true;
                                                                break;
                                                            }
                                                            let _e1120 = global_5.member[_e1117];
                                                            phi_2251_ = _e1120;
                                                        } else {
                                                            phi_2251_ = 0u;
                                                        }
                                                        let _e1122 = phi_2251_;
                                                        phi_2254_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e1124 = phi_2254_;
                                                            if (_e1124.member < _e1124.member_1) {
                                                                phi_2255_ = type_8((_e1124.member + 1u), _e1124.member_1);
                                                                phi_2278_ = type_8(1u, _e1124.member);
                                                            } else {
                                                                phi_2255_ = _e1124;
                                                                phi_2278_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1137 = phi_2255_;
                                                            let _e1139 = phi_2278_;
                                                            let _e1143 = (bitcast<i32>(_e1139.member) != 0i);
                                                            if _e1143 {
                                                                let _e1144 = (_e1139.member_1 < 3u);
                                                                if _e1144 {
                                                                } else {
                                                                    phi_4845_ = true;
                                                                    break;
                                                                }
                                                                let _e1146 = local_5[_e1139.member_1];
                                                                if (_e1139.member_1 < 4u) {
                                                                } else {
                                                                    phi_4845_ = true;
                                                                    break;
                                                                }
                                                                let _e1149 = local_7[_e1139.member_1];
                                                                switch bitcast<i32>(_e1064) {
                                                                    case 0: {
                                                                        phi_2348_ = (_e1149 + (f32(((_e1116 >> bitcast<u32>(((10u * _e1146) & 31u))) & 1023u)) * _e143));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        if (_e1146 == 0u) {
                                                                            phi_2325_ = _e1116;
                                                                        } else {
                                                                            if (_e1146 == 1u) {
                                                                                phi_2324_ = ((_e1116 >> bitcast<u32>(21i)) | (_e1122 << bitcast<u32>(11i)));
                                                                            } else {
                                                                                phi_2324_ = (_e1122 >> bitcast<u32>(10i));
                                                                            }
                                                                            let _e1170 = phi_2324_;
                                                                            phi_2325_ = _e1170;
                                                                        }
                                                                        let _e1172 = phi_2325_;
                                                                        phi_2348_ = (_e1149 + (f32((_e1172 & 2097151u)) * _e143));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e1151 = (_e1111 + _e1146);
                                                                        let _e1152 = (_e1151 < _e95);
                                                                        if _e1152 {
                                                                            if _e1152 {
                                                                            } else {
                                                                                phi_4845_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1154 = global_5.member[_e1151];
                                                                            phi_2344_ = _e1154;
                                                                        } else {
                                                                            phi_2344_ = 0u;
                                                                        }
                                                                        let _e1156 = phi_2344_;
                                                                        phi_2348_ = (f32(bitcast<i32>(_e1156)) * _e143);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        phi_2348_ = f32();
                                                                        break;
                                                                    }
                                                                }
                                                                let _e1186 = phi_2348_;
                                                                if (_e1105.member_1 < 3u) {
                                                                } else {
                                                                    phi_4845_ = true;
                                                                    break;
                                                                }
                                                                if _e1144 {
                                                                } else {
                                                                    phi_4845_ = true;
                                                                    break;
                                                                }
                                                                local_6[_e1105.member_1][_e1139.member_1] = _e1186;
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_2254_ = _e1137;
                                                                phi_4845_ = _e1088;
                                                                break if !(_e1143);
                                                            }
                                                        }
                                                        let _e1192 = phi_4845_;
                                                        phi_4919_ = _e1192;
                                                        if _e1192 {
                                                            break;
                                                        }
                                                        phi_4920_ = _e1192;
                                                    } else {
                                                        phi_4920_ = _e1088;
                                                    }
                                                    let _e1194 = phi_4920_;
                                                    continue;
                                                    continuing {
                                                        phi_4852_ = _e1194;
                                                        phi_2189_ = _e1103;
                                                        phi_4919_ = _e1194;
                                                        break if !(_e1109);
                                                    }
                                                }
                                                let _e1197 = phi_4919_;
                                                phi_5171_ = _e996;
                                                phi_5009_ = _e1197;
                                                if _e1197 {
                                                    break;
                                                }
                                                let _e1198 = local_6;
                                                let _e1213 = (_e1198[0][2] - _e381);
                                                let _e1216 = (((_e1198[0][0] - _e304) * _e405) - (_e1213 * _e329));
                                                let _e1219 = (((_e1198[0][1] - _e343) * _e405) - (_e1213 * _e367));
                                                let _e1222 = (_e1198[1][2] - _e381);
                                                let _e1225 = (((_e1198[1][0] - _e304) * _e405) - (_e1222 * _e329));
                                                let _e1228 = (((_e1198[1][1] - _e343) * _e405) - (_e1222 * _e367));
                                                let _e1231 = (_e1198[2][2] - _e381);
                                                let _e1234 = (((_e1198[2][0] - _e304) * _e405) - (_e1231 * _e329));
                                                let _e1237 = (((_e1198[2][1] - _e343) * _e405) - (_e1231 * _e367));
                                                let _e1238 = (_e1234 * _e1228);
                                                let _e1239 = (_e1237 * _e1225);
                                                let _e1240 = (_e1216 * _e1237);
                                                let _e1241 = (_e1219 * _e1234);
                                                let _e1242 = (_e1225 * _e1219);
                                                let _e1243 = (_e1228 * _e1216);
                                                let _e1248 = (((_e1238 >= _e1239) && (_e1240 >= _e1241)) && (_e1242 >= _e1243));
                                                if (_e1248 || (((_e1238 <= _e1239) && (_e1240 <= _e1241)) && (_e1242 <= _e1243))) {
                                                    let _e1255 = select(-1f, 1f, _e1248);
                                                    let _e1257 = ((_e1238 - _e1239) * _e1255);
                                                    let _e1259 = select(0f, _e1257, (_e1257 > 0f));
                                                    let _e1261 = ((_e1240 - _e1241) * _e1255);
                                                    let _e1263 = select(0f, _e1261, (_e1261 > 0f));
                                                    let _e1265 = ((_e1242 - _e1243) * _e1255);
                                                    let _e1267 = select(0f, _e1265, (_e1265 > 0f));
                                                    let _e1269 = ((_e1259 + _e1263) + _e1267);
                                                    if (_e1269 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2944_ = type_24();
                                                        phi_2945_ = true;
                                                    } else {
                                                        let _e1272 = select(_e1198[1][0], _e1198[0][0], (_e1198[0][0] < _e1198[1][0]));
                                                        let _e1276 = select(_e1198[1][0], _e1198[0][0], (_e1198[0][0] > _e1198[1][0]));
                                                        let _e1280 = select(_e1198[1][1], _e1198[0][1], (_e1198[0][1] < _e1198[1][1]));
                                                        let _e1284 = select(_e1198[1][1], _e1198[0][1], (_e1198[0][1] > _e1198[1][1]));
                                                        let _e1288 = select(_e1198[1][2], _e1198[0][2], (_e1198[0][2] < _e1198[1][2]));
                                                        let _e1292 = select(_e1198[1][2], _e1198[0][2], (_e1198[0][2] > _e1198[1][2]));
                                                        let _e1297 = ((select(_e1198[2][0], _e1272, (_e1272 < _e1198[2][0])) - _e327) * _e332);
                                                        let _e1298 = ((select(_e1198[2][0], _e1276, (_e1276 > _e1198[2][0])) - _e328) * _e332);
                                                        let _e1301 = ((select(_e1198[2][1], _e1280, (_e1280 < _e1198[2][1])) - _e365) * _e370);
                                                        let _e1302 = ((select(_e1198[2][1], _e1284, (_e1284 > _e1198[2][1])) - _e366) * _e370);
                                                        let _e1305 = ((select(_e1198[2][2], _e1288, (_e1288 < _e1198[2][2])) - _e403) * _e408);
                                                        let _e1306 = ((select(_e1198[2][2], _e1292, (_e1292 > _e1198[2][2])) - _e404) * _e408);
                                                        let _e1308 = select(_e1306, _e1305, (_e1305 < _e1306));
                                                        let _e1310 = select(_e1306, _e1305, (_e1305 > _e1306));
                                                        let _e1312 = select(_e1298, _e1297, (_e1297 < _e1298));
                                                        let _e1314 = select(_e1302, _e1301, (_e1301 < _e1302));
                                                        let _e1316 = select(_e1314, _e1312, (_e1312 > _e1314));
                                                        let _e1318 = select(_e1308, _e1316, (_e1316 > _e1308));
                                                        let _e1320 = select(_e1298, _e1297, (_e1297 > _e1298));
                                                        let _e1322 = select(_e1302, _e1301, (_e1301 > _e1302));
                                                        let _e1324 = select(_e1322, _e1320, (_e1320 < _e1322));
                                                        let _e1326 = select(_e1310, _e1324, (_e1324 < _e1310));
                                                        let _e1327 = -(_e1308);
                                                        let _e1333 = select(_e455, _e1318, (_e1318 > _e455));
                                                        if (_e1333 > (_e1326 + (select(_e1327, _e1310, (_e1310 > _e1327)) * 0.0000019073523f))) {
                                                            phi_2939_ = type_24();
                                                            phi_2940_ = true;
                                                        } else {
                                                            let _e1335 = (_e1333 > _e996);
                                                            if _e1335 {
                                                                phi_2938_ = type_24();
                                                            } else {
                                                                let _e1339 = (_e1198[1][0] - _e1198[0][0]);
                                                                let _e1340 = (_e1198[1][1] - _e1198[0][1]);
                                                                let _e1341 = (_e1198[1][2] - _e1198[0][2]);
                                                                let _e1342 = vec3<f32>(_e1339, _e1340, _e1341);
                                                                let _e1343 = (_e1198[2][0] - _e1198[1][0]);
                                                                let _e1344 = (_e1198[2][1] - _e1198[1][1]);
                                                                let _e1345 = (_e1198[2][2] - _e1198[1][2]);
                                                                let _e1346 = vec3<f32>(_e1343, _e1344, _e1345);
                                                                let _e1347 = (_e1198[0][0] - _e1198[2][0]);
                                                                let _e1348 = (_e1198[0][1] - _e1198[2][1]);
                                                                let _e1349 = (_e1198[0][2] - _e1198[2][2]);
                                                                let _e1350 = vec3<f32>(_e1347, _e1348, _e1349);
                                                                let _e1353 = bitcast<f32>((bitcast<u32>(_e1339) & 2147483647u));
                                                                let _e1356 = bitcast<f32>((bitcast<u32>(_e1340) & 2147483647u));
                                                                let _e1358 = select(_e1356, _e1353, (_e1353 > _e1356));
                                                                let _e1361 = bitcast<f32>((bitcast<u32>(_e1341) & 2147483647u));
                                                                let _e1363 = select(_e1361, _e1358, (_e1358 > _e1361));
                                                                let _e1366 = bitcast<f32>((bitcast<u32>(_e1343) & 2147483647u));
                                                                let _e1369 = bitcast<f32>((bitcast<u32>(_e1344) & 2147483647u));
                                                                let _e1371 = select(_e1369, _e1366, (_e1366 > _e1369));
                                                                let _e1374 = bitcast<f32>((bitcast<u32>(_e1345) & 2147483647u));
                                                                let _e1376 = select(_e1374, _e1371, (_e1371 > _e1374));
                                                                let _e1379 = bitcast<f32>((bitcast<u32>(_e1347) & 2147483647u));
                                                                let _e1382 = bitcast<f32>((bitcast<u32>(_e1348) & 2147483647u));
                                                                let _e1384 = select(_e1382, _e1379, (_e1379 > _e1382));
                                                                let _e1387 = bitcast<f32>((bitcast<u32>(_e1349) & 2147483647u));
                                                                let _e1389 = select(_e1387, _e1384, (_e1384 > _e1387));
                                                                let _e1391 = select(_e1376, _e1363, (_e1363 > _e1376));
                                                                let _e1393 = select(_e1389, _e1391, (_e1391 > _e1389));
                                                                if (_e1363 == _e1393) {
                                                                    phi_2849_ = _e1346;
                                                                    phi_2850_ = _e1350;
                                                                } else {
                                                                    let _e1396 = vec3((_e1376 == _e1393));
                                                                    phi_2849_ = select(_e1342, _e1350, _e1396);
                                                                    phi_2850_ = select(_e1346, _e1342, _e1396);
                                                                }
                                                                let _e1400 = phi_2849_;
                                                                let _e1402 = phi_2850_;
                                                                let _e1409 = ((_e1400.y * _e1402.z) - (_e1402.y * _e1400.z));
                                                                let _e1414 = ((_e1400.z * _e1402.x) - (_e1402.z * _e1400.x));
                                                                let _e1417 = ((_e1400.x * _e1402.y) - (_e1402.x * _e1400.y));
                                                                if (_e1259 >= _e1263) {
                                                                    phi_2881_ = select(true, false, (_e1259 >= _e1267));
                                                                } else {
                                                                    phi_2881_ = true;
                                                                }
                                                                let _e1422 = phi_2881_;
                                                                if _e1422 {
                                                                    phi_2890_ = select(vec3<f32>(_e1198[2][0], _e1198[2][1], _e1198[2][2]), vec3<f32>(_e1198[1][0], _e1198[1][1], _e1198[1][2]), vec3((_e1263 >= _e1267)));
                                                                } else {
                                                                    phi_2890_ = vec3<f32>(_e1198[0][0], _e1198[0][1], _e1198[0][2]);
                                                                }
                                                                let _e1427 = phi_2890_;
                                                                let _e1444 = ((((_e1409 * (_e1427.x - _e304)) + (_e1414 * (_e1427.y - _e343))) + (_e1417 * (_e1427.z - _e381))) / (((_e1409 * _e329) + (_e1414 * _e367)) + (_e1417 * _e405)));
                                                                let _e1446 = select(_e1326, _e1444, (_e1444 < _e1326));
                                                                let _e1448 = select(_e1318, _e1446, (_e1446 > _e1318));
                                                                if (_e1448 >= _e455) {
                                                                    let _e1450 = (_e1448 <= _e996);
                                                                    if _e1450 {
                                                                        let _e1451 = (1f / _e1269);
                                                                        phi_2930_ = type_24(_e1448, (_e1263 * _e1451), (_e1267 * _e1451), _e1058);
                                                                    } else {
                                                                        phi_2930_ = type_24();
                                                                    }
                                                                    let _e1456 = phi_2930_;
                                                                    phi_2932_ = _e1456;
                                                                    phi_2933_ = select(true, false, _e1450);
                                                                } else {
                                                                    phi_2932_ = type_24();
                                                                    phi_2933_ = true;
                                                                }
                                                                let _e1459 = phi_2932_;
                                                                let _e1461 = phi_2933_;
                                                                if _e1461 {
                                                                    phi_2937_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2937_ = _e1459;
                                                                }
                                                                let _e1463 = phi_2937_;
                                                                phi_2938_ = _e1463;
                                                            }
                                                            let _e1465 = phi_2938_;
                                                            phi_2939_ = _e1465;
                                                            phi_2940_ = _e1335;
                                                        }
                                                        let _e1467 = phi_2939_;
                                                        let _e1469 = phi_2940_;
                                                        phi_2944_ = _e1467;
                                                        phi_2945_ = _e1469;
                                                    }
                                                    let _e1471 = phi_2944_;
                                                    let _e1473 = phi_2945_;
                                                    phi_2949_ = _e1471;
                                                    phi_2950_ = _e1473;
                                                } else {
                                                    phi_2949_ = type_24();
                                                    phi_2950_ = true;
                                                }
                                                let _e1475 = phi_2949_;
                                                let _e1477 = phi_2950_;
                                                if _e1477 {
                                                    phi_2954_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2954_ = _e1475;
                                                }
                                                let _e1479 = phi_2954_;
                                                if (_e1479.member_3 != 4294967295u) {
                                                    if (_e1058 != 4294967295u) {
                                                        phi_2966_ = type_8(0u, 8u);
                                                        phi_2969_ = _e1479;
                                                        loop {
                                                            let _e1484 = phi_2966_;
                                                            let _e1486 = phi_2969_;
                                                            if (_e1484.member < _e1484.member_1) {
                                                                phi_2967_ = type_8((_e1484.member + 1u), _e1484.member_1);
                                                                phi_2992_ = type_8(1u, _e1484.member);
                                                            } else {
                                                                phi_2967_ = _e1484;
                                                                phi_2992_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1499 = phi_2967_;
                                                            let _e1501 = phi_2992_;
                                                            let _e1505 = (bitcast<i32>(_e1501.member) != 0i);
                                                            if _e1505 {
                                                                let _e1506 = (_e1501.member_1 < 8u);
                                                                if _e1506 {
                                                                } else {
                                                                    phi_4950_ = true;
                                                                    break;
                                                                }
                                                                let _e1511 = local_2[_e1501.member_1].member;
                                                                if (_e1486.member < _e1511) {
                                                                    phi_3025_ = true;
                                                                } else {
                                                                    let _e1513 = local_2[_e1501.member_1].member;
                                                                    if (_e1486.member == _e1513) {
                                                                        let _e1518 = local_2[_e1501.member_1].member_3;
                                                                        phi_3024_ = (_e1486.member_3 < _e1518);
                                                                    } else {
                                                                        phi_3024_ = false;
                                                                    }
                                                                    let _e1521 = phi_3024_;
                                                                    phi_3025_ = _e1521;
                                                                }
                                                                let _e1523 = phi_3025_;
                                                                if _e1523 {
                                                                    if _e1506 {
                                                                    } else {
                                                                        phi_4950_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1524 = local_2[_e1501.member_1];
                                                                    local_2[_e1501.member_1] = type_24(_e1486.member, _e1486.member_1, _e1486.member_2, _e1486.member_3);
                                                                    phi_3046_ = type_24(_e1524.member, _e1524.member_1, _e1524.member_2, _e1524.member_3);
                                                                } else {
                                                                    phi_3046_ = _e1486;
                                                                }
                                                                let _e1535 = phi_3046_;
                                                                phi_2970_ = _e1535;
                                                            } else {
                                                                phi_2970_ = type_24();
                                                            }
                                                            let _e1537 = phi_2970_;
                                                            continue;
                                                            continuing {
                                                                phi_2966_ = _e1499;
                                                                phi_2969_ = _e1537;
                                                                phi_4950_ = _e1197;
                                                                break if !(_e1505);
                                                            }
                                                        }
                                                        let _e1540 = phi_4950_;
                                                        phi_5171_ = _e996;
                                                        phi_5009_ = _e1540;
                                                        if _e1540 {
                                                            break;
                                                        }
                                                        let _e1543 = local_2[7u].member_3;
                                                        if (_e1543 != 4294967295u) {
                                                            let _e1547 = local_2[7u].member;
                                                            phi_5234_ = _e1547;
                                                        } else {
                                                            phi_5234_ = _e996;
                                                        }
                                                        let _e1549 = phi_5234_;
                                                        phi_5233_ = _e1549;
                                                        phi_5012_ = _e1540;
                                                    } else {
                                                        phi_5233_ = _e996;
                                                        phi_5012_ = _e1197;
                                                    }
                                                    let _e1551 = phi_5233_;
                                                    let _e1553 = phi_5012_;
                                                    phi_5232_ = _e1551;
                                                    phi_5011_ = _e1553;
                                                } else {
                                                    phi_5232_ = _e996;
                                                    phi_5011_ = _e1197;
                                                }
                                                let _e1555 = phi_5232_;
                                                let _e1557 = phi_5011_;
                                                phi_5231_ = _e1555;
                                                phi_5010_ = _e1557;
                                            } else {
                                                phi_5231_ = _e996;
                                                phi_5010_ = _e998;
                                            }
                                            let _e1559 = phi_5231_;
                                            let _e1561 = phi_5010_;
                                            continue;
                                            continuing {
                                                phi_4938_ = _e1559;
                                                phi_4867_ = _e1561;
                                                phi_2023_ = _e1013;
                                                phi_5171_ = _e1559;
                                                phi_5009_ = _e1561;
                                                break if !(_e1019);
                                            }
                                        }
                                        let _e1564 = phi_5171_;
                                        let _e1566 = phi_5009_;
                                        phi_5014_ = _e1566;
                                        if _e1566 {
                                            break;
                                        }
                                        phi_5136_ = _e1564;
                                        phi_5018_ = _e1566;
                                        phi_4396_ = _e526;
                                        phi_4397_ = false;
                                        phi_4398_ = _e530;
                                    } else {
                                        if (_e526.member_1 >= _e92) {
                                            phi_3995_ = type_57(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e526.member_1 < _e92) {
                                            } else {
                                                phi_5014_ = true;
                                                break;
                                            }
                                            let _e543 = ((1u + _e263) % 4u);
                                            if (_e543 < 4u) {
                                            } else {
                                                phi_5014_ = true;
                                                break;
                                            }
                                            let _e548 = global_3.member[_e526.member_1][_e543];
                                            let _e550 = ((1u + _e262) % 4u);
                                            if (_e550 < 4u) {
                                            } else {
                                                phi_5014_ = true;
                                                break;
                                            }
                                            let _e555 = global_3.member[_e526.member_1][_e550];
                                            let _e557 = ((1u + _e264) % 4u);
                                            if (_e557 < 4u) {
                                            } else {
                                                phi_5014_ = true;
                                                break;
                                            }
                                            let _e562 = global_3.member[_e526.member_1][_e557];
                                            let _e564 = ((_e263 + 1u) % 4u);
                                            if (_e564 < 4u) {
                                            } else {
                                                phi_5014_ = true;
                                                break;
                                            }
                                            let _e569 = global_3.member[_e526.member_1][_e564];
                                            let _e571 = (_e569 >> bitcast<u32>(11u));
                                            let _e573 = ((_e262 + 1u) % 4u);
                                            if (_e573 < 4u) {
                                            } else {
                                                phi_5014_ = true;
                                                break;
                                            }
                                            let _e578 = global_3.member[_e526.member_1][_e573];
                                            let _e580 = (_e578 >> bitcast<u32>(11u));
                                            let _e582 = ((_e264 + 1u) % 4u);
                                            if (_e582 < 4u) {
                                            } else {
                                                phi_5014_ = true;
                                                break;
                                            }
                                            let _e587 = global_3.member[_e526.member_1][_e582];
                                            let _e589 = (_e587 >> bitcast<u32>(11u));
                                            let _e612 = (bitcast<f32>((bitcast<u32>((_e526.member.member_1.x - _e526.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e613 = (bitcast<f32>((bitcast<u32>((_e526.member.member_1.y - _e526.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e614 = (bitcast<f32>((bitcast<u32>((_e526.member.member_1.z - _e526.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e616 = select(_e143, _e612, (_e612 > _e143));
                                            let _e618 = select(_e143, _e613, (_e613 > _e143));
                                            let _e620 = select(_e143, _e614, (_e614 > _e143));
                                            let _e645 = bitcast<u32>((f32(bitcast<i32>((_e548 & 1023u))) * _e616));
                                            let _e650 = (bitcast<i32>((_e548 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e653 = bitcast<f32>((_e645 & bitcast<u32>(_e650)));
                                            let _e654 = bitcast<u32>((f32(bitcast<i32>((_e555 & 1023u))) * _e618));
                                            let _e659 = (bitcast<i32>((_e555 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e662 = bitcast<f32>((_e654 & bitcast<u32>(_e659)));
                                            let _e663 = bitcast<u32>((f32(bitcast<i32>((_e562 & 1023u))) * _e620));
                                            let _e668 = (bitcast<i32>((_e562 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e671 = bitcast<f32>((_e663 & bitcast<u32>(_e668)));
                                            let _e675 = bitcast<f32>((_e645 & bitcast<u32>(~(_e650))));
                                            let _e679 = bitcast<f32>((_e654 & bitcast<u32>(~(_e659))));
                                            let _e683 = bitcast<f32>((_e663 & bitcast<u32>(~(_e668))));
                                            let _e684 = bitcast<u32>((f32(bitcast<i32>((_e571 & 1023u))) * _e616));
                                            let _e689 = (bitcast<i32>((_e571 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e692 = bitcast<f32>((_e684 & bitcast<u32>(_e689)));
                                            let _e693 = bitcast<u32>((f32(bitcast<i32>((_e580 & 1023u))) * _e618));
                                            let _e698 = (bitcast<i32>((_e580 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e701 = bitcast<f32>((_e693 & bitcast<u32>(_e698)));
                                            let _e702 = bitcast<u32>((f32(bitcast<i32>((_e589 & 1023u))) * _e620));
                                            let _e707 = (bitcast<i32>((_e589 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e710 = bitcast<f32>((_e702 & bitcast<u32>(_e707)));
                                            let _e714 = bitcast<f32>((_e684 & bitcast<u32>(~(_e689))));
                                            let _e718 = bitcast<f32>((_e693 & bitcast<u32>(~(_e698))));
                                            let _e722 = bitcast<f32>((_e702 & bitcast<u32>(~(_e707))));
                                            let _e723 = (_e526.member.member.x + _e653);
                                            let _e724 = (_e526.member.member.y + _e662);
                                            let _e725 = (_e526.member.member.z + _e671);
                                            let _e728 = (_e526.member.member_1.x - _e692);
                                            let _e729 = (_e526.member.member_1.y - _e701);
                                            let _e730 = (_e526.member.member_1.z - _e710);
                                            let _e749 = (_e728 - _e723);
                                            let _e750 = (_e729 - _e724);
                                            let _e751 = (_e730 - _e725);
                                            let _e753 = select(_e750, _e749, (_e749 > _e750));
                                            let _e755 = select(_e751, _e753, (_e753 > _e751));
                                            if (_e755 < (1024f * _e143)) {
                                                phi_3696_ = 0u;
                                            } else {
                                                phi_3696_ = select(2u, 1u, (_e755 < (2097152f * _e143)));
                                            }
                                            let _e762 = phi_3696_;
                                            switch bitcast<i32>(_e762) {
                                                case 0: {
                                                    phi_3702_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3702_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3702_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3702_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e765 = phi_3702_;
                                            let _e771 = global_3.member[_e526.member_1][0u];
                                            let _e775 = global_3.member[_e526.member_1][1u];
                                            let _e779 = global_3.member[_e526.member_1][2u];
                                            let _e783 = global_3.member[_e526.member_1][3u];
                                            let _e795 = (((_e775 >> bitcast<u32>(22i)) | ((_e779 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e783 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e796 = (_e771 & 268435455u);
                                            let _e797 = (_e795 & 268435455u);
                                            let _e800 = ((_e771 >> bitcast<u32>(28u)) & 7u);
                                            let _e808 = ((_e771 >> bitcast<u32>(31i)) | (((_e795 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e809 = (_e800 != 0u);
                                            if (_e800 == 0u) {
                                                phi_3957_ = _e796;
                                            } else {
                                                if (_e800 == 7u) {
                                                    phi_3956_ = 2147483648u;
                                                } else {
                                                    phi_3956_ = ((2147483648u | (_e800 << bitcast<u32>(28u))) | (_e797 & 268435455u));
                                                }
                                                let _e818 = phi_3956_;
                                                phi_3957_ = _e818;
                                            }
                                            let _e820 = phi_3957_;
                                            if _e809 {
                                                let _e821 = (_e800 != 7u);
                                                if _e821 {
                                                    phi_3967_ = (_e797 + (_e800 * ((3u * _e765) + 1u)));
                                                } else {
                                                    phi_3967_ = u32();
                                                }
                                                let _e825 = phi_3967_;
                                                phi_3969_ = _e825;
                                                phi_3970_ = select(true, false, _e821);
                                            } else {
                                                phi_3969_ = u32();
                                                phi_3970_ = true;
                                            }
                                            let _e828 = phi_3969_;
                                            let _e830 = phi_3970_;
                                            if (_e808 == 0u) {
                                                phi_3991_ = (_e796 + select(0u, 1u, !(_e809)));
                                            } else {
                                                if (_e808 == 7u) {
                                                    phi_3990_ = 2147483648u;
                                                } else {
                                                    phi_3990_ = ((2147483648u | (_e808 << bitcast<u32>(28u))) | (select(_e828, _e797, _e830) & 268435455u));
                                                }
                                                let _e843 = phi_3990_;
                                                phi_3991_ = _e843;
                                            }
                                            let _e845 = phi_3991_;
                                            phi_3995_ = type_57(array<vec4<f32>, 3>(vec4<f32>(_e723, (_e526.member.member.x + _e675), _e728, (_e526.member.member_1.x - _e714)), vec4<f32>(_e724, (_e526.member.member.y + _e679), _e729, (_e526.member.member_1.y - _e718)), vec4<f32>(_e725, (_e526.member.member.z + _e683), _e730, (_e526.member.member_1.z - _e722))), type_54(type_28((_e526.member.member + vec4<f32>(_e653, _e662, _e671, 0f)), (_e526.member.member_1 - vec4<f32>(_e692, _e701, _e710, 0f))), _e820), type_54(type_28((_e526.member.member + vec4<f32>(_e675, _e679, _e683, 0f)), (_e526.member.member_1 - vec4<f32>(_e714, _e718, _e722, 0f))), _e845));
                                        }
                                        let _e850 = phi_3995_;
                                        let _e861 = ((_e850.member[0].x - _e327) * _e332);
                                        let _e862 = ((_e850.member[0].y - _e327) * _e332);
                                        let _e863 = ((_e850.member[0].z - _e328) * _e332);
                                        let _e864 = ((_e850.member[0].w - _e328) * _e332);
                                        let _e874 = ((_e850.member[1].x - _e365) * _e370);
                                        let _e875 = ((_e850.member[1].y - _e365) * _e370);
                                        let _e876 = ((_e850.member[1].z - _e366) * _e370);
                                        let _e877 = ((_e850.member[1].w - _e366) * _e370);
                                        let _e887 = ((_e850.member[2].x - _e403) * _e408);
                                        let _e888 = ((_e850.member[2].y - _e403) * _e408);
                                        let _e889 = ((_e850.member[2].z - _e404) * _e408);
                                        let _e890 = ((_e850.member[2].w - _e404) * _e408);
                                        let _e892 = select(_e889, _e887, (_e887 < _e889));
                                        let _e894 = select(_e890, _e888, (_e888 < _e890));
                                        let _e896 = select(_e889, _e887, (_e887 > _e889));
                                        let _e898 = select(_e890, _e888, (_e888 > _e890));
                                        let _e900 = select(_e863, _e861, (_e861 < _e863));
                                        let _e902 = select(_e864, _e862, (_e862 < _e864));
                                        let _e904 = select(_e876, _e874, (_e874 < _e876));
                                        let _e906 = select(_e877, _e875, (_e875 < _e877));
                                        let _e908 = select(_e904, _e900, (_e900 > _e904));
                                        let _e910 = select(_e906, _e902, (_e902 > _e906));
                                        let _e912 = select(_e892, _e908, (_e908 > _e892));
                                        let _e914 = select(_e894, _e910, (_e910 > _e894));
                                        let _e916 = select(_e863, _e861, (_e861 > _e863));
                                        let _e918 = select(_e864, _e862, (_e862 > _e864));
                                        let _e920 = select(_e876, _e874, (_e874 > _e876));
                                        let _e922 = select(_e877, _e875, (_e875 > _e877));
                                        let _e924 = select(_e920, _e916, (_e916 < _e920));
                                        let _e926 = select(_e922, _e918, (_e918 < _e922));
                                        let _e931 = -(_e892);
                                        let _e932 = -(_e894);
                                        let _e939 = (select(_e896, _e924, (_e924 < _e896)) + (select(_e931, _e896, (_e896 > _e931)) * 0.0000019073523f));
                                        let _e940 = (select(_e898, _e926, (_e926 < _e898)) + (select(_e932, _e898, (_e898 > _e932)) * 0.0000019073523f));
                                        let _e942 = select(_e455, _e912, (_e912 > _e455));
                                        let _e944 = select(_e455, _e914, (_e914 > _e455));
                                        let _e949 = (_e942 <= select(_e498, _e939, (_e939 < _e498)));
                                        let _e950 = (_e944 <= select(_e498, _e940, (_e940 < _e498)));
                                        let _e951 = (_e942 <= _e944);
                                        if _e949 {
                                            if _e950 {
                                                if _e951 {
                                                    phi_4340_ = _e850.member_2;
                                                } else {
                                                    phi_4340_ = _e850.member_1;
                                                }
                                                let _e955 = phi_4340_;
                                                let _e956 = (_e530 % 128u);
                                                let _e957 = (_e956 < 128u);
                                                if _e957 {
                                                } else {
                                                    phi_5014_ = true;
                                                    break;
                                                }
                                                local_4[_e956] = type_54(type_28(_e955.member.member, _e955.member.member_1), _e955.member_1);
                                                if _e957 {
                                                } else {
                                                    phi_5014_ = true;
                                                    break;
                                                }
                                                local_3[_e956] = select(_e944, _e942, (_e942 > _e944));
                                                if _e951 {
                                                    phi_4373_ = _e850.member_1;
                                                } else {
                                                    phi_4373_ = _e850.member_2;
                                                }
                                                let _e972 = phi_4373_;
                                                phi_4374_ = _e972;
                                                phi_4375_ = (_e530 + 1u);
                                            } else {
                                                phi_4374_ = type_54();
                                                phi_4375_ = u32();
                                            }
                                            let _e974 = phi_4374_;
                                            let _e976 = phi_4375_;
                                            phi_4377_ = _e974;
                                            phi_4378_ = _e976;
                                            phi_4379_ = select(true, false, _e950);
                                        } else {
                                            phi_4377_ = type_54();
                                            phi_4378_ = u32();
                                            phi_4379_ = true;
                                        }
                                        let _e979 = phi_4377_;
                                        let _e981 = phi_4378_;
                                        let _e983 = phi_4379_;
                                        if _e983 {
                                            if _e949 {
                                                phi_4388_ = _e850.member_1;
                                            } else {
                                                phi_4388_ = _e850.member_2;
                                            }
                                            let _e987 = phi_4388_;
                                            phi_4393_ = _e987;
                                            phi_4394_ = select(_e950, true, _e949);
                                        } else {
                                            phi_4393_ = _e979;
                                            phi_4394_ = _e528;
                                        }
                                        let _e990 = phi_4393_;
                                        let _e992 = phi_4394_;
                                        phi_5136_ = _e498;
                                        phi_5018_ = _e496;
                                        phi_4396_ = _e990;
                                        phi_4397_ = _e992;
                                        phi_4398_ = select(_e981, _e530, _e983);
                                    }
                                    let _e1568 = phi_5136_;
                                    let _e1570 = phi_5018_;
                                    let _e1572 = phi_4396_;
                                    let _e1574 = phi_4397_;
                                    let _e1576 = phi_4398_;
                                    phi_5135_ = _e1568;
                                    phi_5017_ = _e1570;
                                    phi_4399_ = _e1572;
                                    phi_4400_ = (_e502 - 1u);
                                    phi_4401_ = _e1574;
                                    phi_4402_ = _e1576;
                                } else {
                                    phi_5135_ = _e498;
                                    phi_5017_ = _e496;
                                    phi_4399_ = _e526;
                                    phi_4400_ = _e502;
                                    phi_4401_ = _e528;
                                    phi_4402_ = _e530;
                                }
                                let _e1578 = phi_5135_;
                                let _e1580 = phi_5017_;
                                let _e1582 = phi_4399_;
                                let _e1584 = phi_4400_;
                                let _e1586 = phi_4401_;
                                let _e1588 = phi_4402_;
                                phi_5134_ = _e1578;
                                phi_5016_ = _e1580;
                                phi_4403_ = _e1582;
                                phi_4404_ = _e1584;
                                phi_4405_ = _e1586;
                                phi_4406_ = _e1588;
                            } else {
                                phi_5134_ = _e498;
                                phi_5016_ = _e496;
                                phi_4403_ = type_54();
                                phi_4404_ = u32();
                                phi_4405_ = bool();
                                phi_4406_ = u32();
                            }
                            let _e1590 = phi_5134_;
                            let _e1592 = phi_5016_;
                            let _e1594 = phi_4403_;
                            let _e1596 = phi_4404_;
                            let _e1598 = phi_4405_;
                            let _e1600 = phi_4406_;
                            phi_5133_ = _e1590;
                            phi_5015_ = _e1592;
                            phi_1947_ = _e1594;
                            phi_1950_ = _e1596;
                            phi_1952_ = _e1598;
                            phi_1954_ = _e1600;
                            phi_4407_ = _e510;
                        } else {
                            phi_5133_ = _e498;
                            phi_5015_ = _e496;
                            phi_1947_ = type_54();
                            phi_1950_ = u32();
                            phi_1952_ = bool();
                            phi_1954_ = u32();
                            phi_4407_ = false;
                        }
                        let _e1602 = phi_5133_;
                        let _e1604 = phi_5015_;
                        let _e1606 = phi_1947_;
                        let _e1608 = phi_1950_;
                        let _e1610 = phi_1952_;
                        let _e1612 = phi_1954_;
                        let _e1614 = phi_4407_;
                        continue;
                        continuing {
                            phi_4870_ = _e1604;
                            phi_4769_ = _e1602;
                            phi_1946_ = _e1606;
                            phi_1949_ = _e1608;
                            phi_1951_ = _e1610;
                            phi_1953_ = _e1612;
                            phi_5014_ = _e1604;
                            break if !(_e1614);
                        }
                    }
                    let _e1617 = phi_5014_;
                    if _e1617 {
                        break;
                    }
                    phi_4414_ = type_8(0u, 8u);
                    loop {
                        let _e1619 = phi_4414_;
                        if (_e1619.member < _e1619.member_1) {
                            phi_4415_ = type_8((_e1619.member + 1u), _e1619.member_1);
                            phi_4438_ = type_8(1u, _e1619.member);
                        } else {
                            phi_4415_ = _e1619;
                            phi_4438_ = type_8(0u, type_8().member_1);
                        }
                        let _e1632 = phi_4415_;
                        let _e1634 = phi_4438_;
                        let _e1638 = (bitcast<i32>(_e1634.member) != 0i);
                        if _e1638 {
                            let _e1639 = (_e1634.member_1 < 8u);
                            if _e1639 {
                            } else {
                                phi_5126_ = true;
                                break;
                            }
                            let _e1641 = local_2[_e1634.member_1];
                            if (_e1641.member_3 != 4294967295u) {
                                let _e1647 = -(_e422);
                                let _e1648 = (_e1647 / 3i);
                                let _e1655 = bitcast<f32>((bitcast<u32>((_e1648 + 127i)) << bitcast<u32>(23i)));
                                let _e1663 = (((_e1641.member * _e1655) * _e1655) * bitcast<f32>((bitcast<u32>(((_e1647 - (2i * _e1648)) + 127i)) << bitcast<u32>(23i))));
                                let _e1665 = select(340282350000000000000000000000000000000f, _e1663, (_e1663 < 340282350000000000000000000000000000000f));
                                phi_4504_ = type_24(select(-340282350000000000000000000000000000000f, _e1665, (_e1665 > -340282350000000000000000000000000000000f)), _e1641.member_1, _e1641.member_2, _e1641.member_3);
                            } else {
                                phi_4504_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1670 = phi_4504_;
                            if _e1639 {
                            } else {
                                phi_5126_ = true;
                                break;
                            }
                            local_2[_e1634.member_1] = type_24(_e1670.member, _e1670.member_1, _e1670.member_2, _e1670.member_3);
                        }
                        continue;
                        continuing {
                            phi_4414_ = _e1632;
                            phi_5126_ = _e1617;
                            break if !(_e1638);
                        }
                    }
                    let _e1678 = phi_5126_;
                    if _e1678 {
                        break;
                    }
                    let _e1679 = local_2;
                    if _e151 {
                    } else {
                        break;
                    }
                    global_6.member[_e149] = array<type_24, 8>(type_24(_e1679[0].member, _e1679[0].member_1, _e1679[0].member_2, _e1679[0].member_3), type_24(_e1679[1].member, _e1679[1].member_1, _e1679[1].member_2, _e1679[1].member_3), type_24(_e1679[2].member, _e1679[2].member_1, _e1679[2].member_2, _e1679[2].member_3), type_24(_e1679[3].member, _e1679[3].member_1, _e1679[3].member_2, _e1679[3].member_3), type_24(_e1679[4].member, _e1679[4].member_1, _e1679[4].member_2, _e1679[4].member_3), type_24(_e1679[5].member, _e1679[5].member_1, _e1679[5].member_2, _e1679[5].member_3), type_24(_e1679[6].member, _e1679[6].member_1, _e1679[6].member_2, _e1679[6].member_3), type_24(_e1679[7].member, _e1679[7].member_1, _e1679[7].member_2, _e1679[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
