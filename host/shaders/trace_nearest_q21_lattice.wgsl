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

struct type_20 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_21 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_24 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_31 {
    member: array<type_21>,
}

struct type_35 {
    member: array<array<type_20, 8>>,
}

struct type_41 {
    member: array<vec4<u32>, 2>,
}

struct type_48 {
    member: array<array<u32, 7>>,
}

struct type_54 {
    member: type_24,
    member_1: u32,
}

struct type_57 {
    member: array<vec4<f32>, 3>,
    member_1: type_54,
    member_2: type_54,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_41;
@group(0) @binding(4) 
var<storage> global_3: type_31;
@group(0) @binding(2) 
var<storage> global_4: type_48;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_35;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<type_20, 8>;
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
    var phi_2930_: type_20;
    var phi_2932_: type_20;
    var phi_2933_: bool;
    var phi_2937_: type_20;
    var phi_2938_: type_20;
    var phi_2939_: type_20;
    var phi_2940_: bool;
    var phi_2944_: type_20;
    var phi_2945_: bool;
    var phi_2949_: type_20;
    var phi_2950_: bool;
    var phi_2954_: type_20;
    var phi_2966_: type_8;
    var phi_2969_: type_20;
    var phi_2967_: type_8;
    var phi_2992_: type_8;
    var phi_3024_: bool;
    var phi_3025_: bool;
    var phi_3046_: type_20;
    var phi_2970_: type_20;
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
    var phi_4504_: type_20;
    var phi_5126_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e89 = global;
            let _e91 = arrayLength((&global_4.member));
            let _e94 = arrayLength((&global_5.member));
            let _e102 = global_2.member[0u][0u];
            let _e106 = global_2.member[0u][1u];
            let _e110 = global_2.member[0u][2u];
            let _e114 = global_2.member[0u][3u];
            let _e118 = global_2.member[1u][0u];
            let _e122 = global_2.member[1u][1u];
            let _e126 = global_2.member[1u][2u];
            let _e129 = global_1.member[0u];
            let _e130 = bitcast<i32>(_e129);
            let _e142 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e114) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e102), bitcast<i32>(_e106), bitcast<i32>(_e110));
            local = array<i32, 3>(bitcast<i32>(_e118), bitcast<i32>(_e122), bitcast<i32>(_e126));
            let _e148 = (_e89.x + (_e89.y * 2097152u));
            let _e149 = (_e148 < arrayLength((&global_3.member)));
            if _e149 {
                let _e150 = (_e148 < arrayLength((&global_6.member)));
                if _e150 {
                    if _e149 {
                    } else {
                        break;
                    }
                    let _e158 = global_3.member[_e148].member_2[0u];
                    let _e160 = (bitcast<u32>(_e158) & 2147483647u);
                    let _e165 = global_3.member[_e148].member_2[1u];
                    let _e167 = (bitcast<u32>(_e165) & 2147483647u);
                    let _e172 = global_3.member[_e148].member_2[2u];
                    let _e174 = (bitcast<u32>(_e172) & 2147483647u);
                    let _e179 = global_3.member[_e148].member[0u];
                    let _e181 = (bitcast<u32>(_e179) & 2147483647u);
                    let _e186 = global_3.member[_e148].member[1u];
                    let _e188 = (bitcast<u32>(_e186) & 2147483647u);
                    let _e193 = global_3.member[_e148].member[2u];
                    let _e195 = (bitcast<u32>(_e193) & 2147483647u);
                    let _e197 = select(_e167, _e160, (_e167 < _e160));
                    let _e199 = select(_e174, _e197, (_e174 < _e197));
                    let _e201 = select(_e181, _e199, (_e181 < _e199));
                    let _e203 = select(_e188, _e201, (_e188 < _e201));
                    let _e205 = select(_e195, _e203, (_e195 < _e203));
                    let _e209 = global_3.member[_e148].member_1;
                    let _e211 = (bitcast<u32>(_e209) & 2147483647u);
                    let _e218 = global_3.member[_e148].member_3;
                    let _e224 = (((select(_e211, _e205, (_e211 < _e205)) < 2139095040u) && ((bitcast<u32>(_e218) & 2147483647u) <= 2139095040u)) && (_e199 > 0u));
                    if _e224 {
                        let _e227 = (bitcast<u32>(bitcast<f32>(_e199)) & 2147483647u);
                        if (_e227 >= 8388608u) {
                            phi_409_ = (bitcast<i32>((_e227 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_409_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e227)), 32u, (_e227 == 0u))));
                        }
                        let _e241 = phi_409_;
                        phi_410_ = _e241;
                    } else {
                        phi_410_ = 0i;
                    }
                    let _e243 = phi_410_;
                    let _e244 = (_e160 == _e199);
                    if _e244 {
                        phi_420_ = true;
                    } else {
                        phi_420_ = (_e167 == _e199);
                    }
                    let _e247 = phi_420_;
                    let _e248 = select(1u, 0u, _e244);
                    if _e247 {
                        let _e249 = (_e248 + 1u);
                        phi_430_ = _e249;
                        phi_431_ = _e249;
                        phi_433_ = select(true, false, (_e249 == 2u));
                    } else {
                        phi_430_ = u32();
                        phi_431_ = 0u;
                        phi_433_ = true;
                    }
                    let _e253 = phi_430_;
                    let _e255 = phi_431_;
                    let _e257 = phi_433_;
                    if _e257 {
                        phi_438_ = (_e255 + 1u);
                    } else {
                        phi_438_ = 0u;
                    }
                    let _e261 = phi_438_;
                    let _e262 = select(_e253, _e255, _e257);
                    let _e263 = select(_e248, select(2u, _e248, _e247), _e257);
                    let _e264 = (_e130 / 2i);
                    let _e269 = bitcast<f32>((bitcast<u32>((_e264 + 127i)) << bitcast<u32>(23i)));
                    let _e275 = bitcast<f32>((bitcast<u32>(((_e130 - _e264) + 127i)) << bitcast<u32>(23i)));
                    let _e276 = -(_e243);
                    let _e277 = (_e276 / 2i);
                    let _e282 = bitcast<f32>((bitcast<u32>((_e277 + 127i)) << bitcast<u32>(23i)));
                    let _e288 = bitcast<f32>((bitcast<u32>(((_e276 - _e277) + 127i)) << bitcast<u32>(23i)));
                    let _e292 = global_3.member[_e148].member;
                    let _e293 = (_e262 == 0u);
                    if _e293 {
                        phi_483_ = _e292[0];
                    } else {
                        phi_483_ = _e292[1];
                    }
                    let _e297 = phi_483_;
                    let _e298 = (_e262 == 2u);
                    if _e298 {
                        phi_489_ = _e292[2];
                    } else {
                        phi_489_ = _e297;
                    }
                    let _e301 = phi_489_;
                    let _e303 = ((_e301 * _e269) * _e275);
                    let _e304 = global_3.member[_e148].member_2;
                    if _e293 {
                        phi_500_ = _e304[0];
                    } else {
                        phi_500_ = _e304[1];
                    }
                    let _e308 = phi_500_;
                    if _e298 {
                        phi_506_ = _e304[2];
                    } else {
                        phi_506_ = _e308;
                    }
                    let _e311 = phi_506_;
                    let _e313 = ((_e311 * _e282) * _e288);
                    let _e317 = (bitcast<f32>((bitcast<u32>(_e313) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e317 {
                        let _e321 = (bitcast<f32>((bitcast<u32>(_e303) & 2147483647u)) * 0.00000011920929f);
                        phi_529_ = select(0.00000000000011368684f, _e321, (_e321 > 0.00000000000011368684f));
                    } else {
                        phi_529_ = 0f;
                    }
                    let _e325 = phi_529_;
                    let _e326 = (_e303 + _e325);
                    let _e327 = (_e303 - _e325);
                    let _e328 = select(_e313, 0f, _e317);
                    if _e317 {
                        phi_540_ = 38685626000000000000000000f;
                    } else {
                        phi_540_ = (1f / _e313);
                    }
                    let _e331 = phi_540_;
                    let _e332 = (_e261 == 0u);
                    if _e332 {
                        phi_549_ = _e292[0];
                    } else {
                        phi_549_ = _e292[1];
                    }
                    let _e336 = phi_549_;
                    let _e337 = (_e261 == 2u);
                    if _e337 {
                        phi_555_ = _e292[2];
                    } else {
                        phi_555_ = _e336;
                    }
                    let _e340 = phi_555_;
                    let _e342 = ((_e340 * _e269) * _e275);
                    if _e332 {
                        phi_566_ = _e304[0];
                    } else {
                        phi_566_ = _e304[1];
                    }
                    let _e346 = phi_566_;
                    if _e337 {
                        phi_572_ = _e304[2];
                    } else {
                        phi_572_ = _e346;
                    }
                    let _e349 = phi_572_;
                    let _e351 = ((_e349 * _e282) * _e288);
                    let _e355 = (bitcast<f32>((bitcast<u32>(_e351) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e355 {
                        let _e359 = (bitcast<f32>((bitcast<u32>(_e342) & 2147483647u)) * 0.00000011920929f);
                        phi_595_ = select(0.00000000000011368684f, _e359, (_e359 > 0.00000000000011368684f));
                    } else {
                        phi_595_ = 0f;
                    }
                    let _e363 = phi_595_;
                    let _e364 = (_e342 + _e363);
                    let _e365 = (_e342 - _e363);
                    let _e366 = select(_e351, 0f, _e355);
                    if _e355 {
                        phi_606_ = 38685626000000000000000000f;
                    } else {
                        phi_606_ = (1f / _e351);
                    }
                    let _e369 = phi_606_;
                    let _e370 = (_e263 == 0u);
                    if _e370 {
                        phi_615_ = _e292[0];
                    } else {
                        phi_615_ = _e292[1];
                    }
                    let _e374 = phi_615_;
                    let _e375 = (_e263 == 2u);
                    if _e375 {
                        phi_621_ = _e292[2];
                    } else {
                        phi_621_ = _e374;
                    }
                    let _e378 = phi_621_;
                    let _e380 = ((_e378 * _e269) * _e275);
                    if _e370 {
                        phi_632_ = _e304[0];
                    } else {
                        phi_632_ = _e304[1];
                    }
                    let _e384 = phi_632_;
                    if _e375 {
                        phi_638_ = _e304[2];
                    } else {
                        phi_638_ = _e384;
                    }
                    let _e387 = phi_638_;
                    let _e389 = ((_e387 * _e282) * _e288);
                    let _e393 = (bitcast<f32>((bitcast<u32>(_e389) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e393 {
                        let _e397 = (bitcast<f32>((bitcast<u32>(_e380) & 2147483647u)) * 0.00000011920929f);
                        phi_661_ = select(0.00000000000011368684f, _e397, (_e397 > 0.00000000000011368684f));
                    } else {
                        phi_661_ = 0f;
                    }
                    let _e401 = phi_661_;
                    let _e402 = (_e380 + _e401);
                    let _e403 = (_e380 - _e401);
                    let _e404 = select(_e389, 0f, _e393);
                    if _e393 {
                        phi_672_ = 38685626000000000000000000f;
                    } else {
                        phi_672_ = (1f / _e389);
                    }
                    let _e407 = phi_672_;
                    let _e410 = bitcast<f32>((bitcast<u32>(_e303) & 2147483647u));
                    let _e413 = bitcast<f32>((bitcast<u32>(_e342) & 2147483647u));
                    let _e415 = select(_e413, _e410, (_e410 > _e413));
                    let _e418 = bitcast<f32>((bitcast<u32>(_e380) & 2147483647u));
                    let _e421 = (_e130 + _e243);
                    if (_e224 && (select(_e418, _e415, (_e415 > _e418)) <= 1099511600000f)) {
                        let _e424 = (_e421 / 3i);
                        let _e431 = bitcast<f32>((bitcast<u32>((_e424 + 127i)) << bitcast<u32>(23i)));
                        let _e438 = bitcast<f32>((bitcast<u32>(((_e421 - (2i * _e424)) + 127i)) << bitcast<u32>(23i)));
                        let _e439 = (((_e209 * _e431) * _e431) * _e438);
                        let _e441 = select(340282350000000000000000000000000000000f, _e439, (_e439 < 340282350000000000000000000000000000000f));
                        let _e446 = (((_e218 * _e431) * _e431) * _e438);
                        let _e448 = select(340282350000000000000000000000000000000f, _e446, (_e446 < 340282350000000000000000000000000000000f));
                        phi_772_ = select(-340282350000000000000000000000000000000f, _e448, (_e448 > -340282350000000000000000000000000000000f));
                        phi_773_ = select(-340282350000000000000000000000000000000f, _e441, (_e441 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_772_ = 0f;
                        phi_773_ = 1f;
                    }
                    let _e452 = phi_772_;
                    let _e454 = phi_773_;
                    local_2 = array<type_20, 8>(type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_4 = array<type_54, 128>(type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e457 = (_e262 % 3u);
                    let _e458 = (_e457 < 3u);
                    if _e458 {
                    } else {
                        break;
                    }
                    let _e460 = local_1[_e457];
                    let _e463 = (_e261 % 3u);
                    let _e464 = (_e463 < 3u);
                    if _e464 {
                    } else {
                        break;
                    }
                    let _e466 = local_1[_e463];
                    let _e469 = (_e263 % 3u);
                    let _e470 = (_e469 < 3u);
                    if _e470 {
                    } else {
                        break;
                    }
                    let _e472 = local_1[_e469];
                    if _e458 {
                    } else {
                        break;
                    }
                    let _e477 = local[_e457];
                    if _e464 {
                    } else {
                        break;
                    }
                    let _e481 = local[_e463];
                    if _e470 {
                    } else {
                        break;
                    }
                    let _e485 = local[_e469];
                    phi_4870_ = false;
                    phi_4769_ = _e452;
                    phi_1946_ = type_54(type_24(vec4<f32>((f32(_e460) * _e142), (f32(_e466) * _e142), (f32(_e472) * _e142), 0f), vec4<f32>((f32(_e477) * _e142), (f32(_e481) * _e142), (f32(_e485) * _e142), 0f)), select(0u, 2147483648u, (_e91 == 0u)));
                    phi_1949_ = ((3u * _e91) + 1u);
                    phi_1951_ = (_e454 <= _e452);
                    phi_1953_ = 0u;
                    loop {
                        let _e495 = phi_4870_;
                        let _e497 = phi_4769_;
                        let _e499 = phi_1946_;
                        let _e501 = phi_1949_;
                        let _e503 = phi_1951_;
                        let _e505 = phi_1953_;
                        if _e503 {
                            phi_1964_ = true;
                        } else {
                            phi_1964_ = (_e505 > 0u);
                        }
                        let _e508 = phi_1964_;
                        if _e508 {
                            let _e509 = (_e501 > 0u);
                            if _e509 {
                                if _e503 {
                                    phi_2002_ = _e499;
                                    phi_2003_ = _e503;
                                    phi_2004_ = _e505;
                                } else {
                                    let _e510 = (_e505 - 1u);
                                    let _e511 = (_e510 % 128u);
                                    let _e512 = (_e511 < 128u);
                                    if _e512 {
                                    } else {
                                        phi_5014_ = true;
                                        break;
                                    }
                                    let _e514 = local_4[_e511];
                                    if _e512 {
                                    } else {
                                        phi_5014_ = true;
                                        break;
                                    }
                                    let _e522 = local_3[_e511];
                                    phi_2002_ = type_54(type_24(_e514.member.member, _e514.member.member_1), _e514.member_1);
                                    phi_2003_ = (_e522 <= _e497);
                                    phi_2004_ = _e510;
                                }
                                let _e525 = phi_2002_;
                                let _e527 = phi_2003_;
                                let _e529 = phi_2004_;
                                if _e527 {
                                    let _e534 = (_e525.member_1 & 268435455u);
                                    if ((_e525.member_1 & 2147483648u) != 0u) {
                                        phi_4938_ = _e497;
                                        phi_4867_ = _e495;
                                        phi_2023_ = type_8(0u, ((_e525.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e995 = phi_4938_;
                                            let _e997 = phi_4867_;
                                            let _e999 = phi_2023_;
                                            if (_e999.member < _e999.member_1) {
                                                phi_2024_ = type_8((_e999.member + 1u), _e999.member_1);
                                                phi_2047_ = type_8(1u, _e999.member);
                                            } else {
                                                phi_2024_ = _e999;
                                                phi_2047_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1012 = phi_2024_;
                                            let _e1014 = phi_2047_;
                                            let _e1018 = (bitcast<i32>(_e1014.member) != 0i);
                                            if _e1018 {
                                                let _e1023 = (_e525.member.member_1.x - _e525.member.member.x);
                                                let _e1026 = (_e525.member.member_1.y - _e525.member.member.y);
                                                let _e1029 = (_e525.member.member_1.z - _e525.member.member.z);
                                                let _e1031 = select(_e1026, _e1023, (_e1023 > _e1026));
                                                let _e1033 = select(_e1029, _e1031, (_e1031 > _e1029));
                                                let _e1035 = (_e1033 < (1024f * _e142));
                                                if _e1035 {
                                                    phi_2088_ = 0u;
                                                } else {
                                                    phi_2088_ = select(2u, 1u, (_e1033 < (2097152f * _e142)));
                                                }
                                                let _e1040 = phi_2088_;
                                                switch bitcast<i32>(_e1040) {
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
                                                let _e1043 = phi_2094_;
                                                switch bitcast<i32>(_e1040) {
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
                                                let _e1050 = phi_2104_;
                                                let _e1052 = ((_e534 + (_e1014.member_1 * ((3u * _e1043) + 1u))) + (3u * _e1050));
                                                let _e1053 = (_e1052 < _e94);
                                                if _e1053 {
                                                    if _e1053 {
                                                    } else {
                                                        phi_5171_ = _e995;
                                                        phi_5009_ = true;
                                                        break;
                                                    }
                                                    let _e1055 = global_5.member[_e1052];
                                                    phi_2120_ = _e1055;
                                                } else {
                                                    phi_2120_ = 4294967295u;
                                                }
                                                let _e1057 = phi_2120_;
                                                local_5 = array<u32, 3>(_e262, _e261, _e263);
                                                if _e1035 {
                                                    phi_2157_ = 0u;
                                                } else {
                                                    phi_2157_ = select(2u, 1u, (_e1033 < (2097152f * _e142)));
                                                }
                                                let _e1063 = phi_2157_;
                                                switch bitcast<i32>(_e1063) {
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
                                                let _e1066 = phi_2163_;
                                                switch bitcast<i32>(_e1063) {
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
                                                let _e1073 = phi_2173_;
                                                local_7 = array<f32, 4>(_e525.member.member.x, _e525.member.member.y, _e525.member.member.z, _e525.member.member.w);
                                                local_6[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_6[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_6[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_4852_ = _e997;
                                                phi_2189_ = type_8(0u, 3u);
                                                loop {
                                                    let _e1087 = phi_4852_;
                                                    let _e1089 = phi_2189_;
                                                    if (_e1089.member < _e1089.member_1) {
                                                        phi_2190_ = type_8((_e1089.member + 1u), _e1089.member_1);
                                                        phi_2213_ = type_8(1u, _e1089.member);
                                                    } else {
                                                        phi_2190_ = _e1089;
                                                        phi_2213_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e1102 = phi_2190_;
                                                    let _e1104 = phi_2213_;
                                                    let _e1108 = (bitcast<i32>(_e1104.member) != 0i);
                                                    if _e1108 {
                                                        let _e1110 = ((_e534 + (_e1014.member_1 * ((3u * _e1066) + 1u))) + (_e1104.member_1 * _e1073));
                                                        let _e1111 = (_e1110 < _e94);
                                                        if _e1111 {
                                                            if _e1111 {
                                                            } else {
                                                                phi_4919_ = true;
                                                                break;
                                                            }
                                                            let _e1113 = global_5.member[_e1110];
                                                            phi_2236_ = _e1113;
                                                        } else {
                                                            phi_2236_ = 0u;
                                                        }
                                                        let _e1115 = phi_2236_;
                                                        let _e1116 = (_e1110 + 1u);
                                                        let _e1117 = (_e1116 < _e94);
                                                        if _e1117 {
                                                            if _e1117 {
                                                            } else {
                                                                phi_4919_ = true;
                                                                break;
                                                            }
                                                            let _e1119 = global_5.member[_e1116];
                                                            phi_2251_ = _e1119;
                                                        } else {
                                                            phi_2251_ = 0u;
                                                        }
                                                        let _e1121 = phi_2251_;
                                                        phi_2254_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e1123 = phi_2254_;
                                                            if (_e1123.member < _e1123.member_1) {
                                                                phi_2255_ = type_8((_e1123.member + 1u), _e1123.member_1);
                                                                phi_2278_ = type_8(1u, _e1123.member);
                                                            } else {
                                                                phi_2255_ = _e1123;
                                                                phi_2278_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1136 = phi_2255_;
                                                            let _e1138 = phi_2278_;
                                                            let _e1142 = (bitcast<i32>(_e1138.member) != 0i);
                                                            if _e1142 {
                                                                let _e1143 = (_e1138.member_1 < 3u);
                                                                if _e1143 {
                                                                } else {
                                                                    phi_4845_ = true;
                                                                    break;
                                                                }
                                                                let _e1145 = local_5[_e1138.member_1];
                                                                if (_e1138.member_1 < 4u) {
                                                                } else {
                                                                    phi_4845_ = true;
                                                                    break;
                                                                }
                                                                let _e1148 = local_7[_e1138.member_1];
                                                                switch bitcast<i32>(_e1063) {
                                                                    case 0: {
                                                                        phi_2348_ = (_e1148 + (f32(((_e1115 >> bitcast<u32>(((10u * _e1145) & 31u))) & 1023u)) * _e142));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        if (_e1145 == 0u) {
                                                                            phi_2325_ = _e1115;
                                                                        } else {
                                                                            if (_e1145 == 1u) {
                                                                                phi_2324_ = ((_e1115 >> bitcast<u32>(21i)) | (_e1121 << bitcast<u32>(11i)));
                                                                            } else {
                                                                                phi_2324_ = (_e1121 >> bitcast<u32>(10i));
                                                                            }
                                                                            let _e1169 = phi_2324_;
                                                                            phi_2325_ = _e1169;
                                                                        }
                                                                        let _e1171 = phi_2325_;
                                                                        phi_2348_ = (_e1148 + (f32((_e1171 & 2097151u)) * _e142));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e1150 = (_e1110 + _e1145);
                                                                        let _e1151 = (_e1150 < _e94);
                                                                        if _e1151 {
                                                                            if _e1151 {
                                                                            } else {
                                                                                phi_4845_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1153 = global_5.member[_e1150];
                                                                            phi_2344_ = _e1153;
                                                                        } else {
                                                                            phi_2344_ = 0u;
                                                                        }
                                                                        let _e1155 = phi_2344_;
                                                                        phi_2348_ = (f32(bitcast<i32>(_e1155)) * _e142);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        phi_2348_ = f32();
                                                                        break;
                                                                    }
                                                                }
                                                                let _e1185 = phi_2348_;
                                                                if (_e1104.member_1 < 3u) {
                                                                } else {
                                                                    phi_4845_ = true;
                                                                    break;
                                                                }
                                                                if _e1143 {
                                                                } else {
                                                                    phi_4845_ = true;
                                                                    break;
                                                                }
                                                                local_6[_e1104.member_1][_e1138.member_1] = _e1185;
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_2254_ = _e1136;
                                                                phi_4845_ = _e1087;
                                                                break if !(_e1142);
                                                            }
                                                        }
                                                        let _e1191 = phi_4845_;
                                                        phi_4919_ = _e1191;
                                                        if _e1191 {
                                                            break;
                                                        }
                                                        phi_4920_ = _e1191;
                                                    } else {
                                                        phi_4920_ = _e1087;
                                                    }
                                                    let _e1193 = phi_4920_;
                                                    continue;
                                                    continuing {
                                                        phi_4852_ = _e1193;
                                                        phi_2189_ = _e1102;
                                                        phi_4919_ = _e1193;
                                                        break if !(_e1108);
                                                    }
                                                }
                                                let _e1196 = phi_4919_;
                                                phi_5171_ = _e995;
                                                phi_5009_ = _e1196;
                                                if _e1196 {
                                                    break;
                                                }
                                                let _e1197 = local_6;
                                                let _e1212 = (_e1197[0][2] - _e380);
                                                let _e1215 = (((_e1197[0][0] - _e303) * _e404) - (_e1212 * _e328));
                                                let _e1218 = (((_e1197[0][1] - _e342) * _e404) - (_e1212 * _e366));
                                                let _e1221 = (_e1197[1][2] - _e380);
                                                let _e1224 = (((_e1197[1][0] - _e303) * _e404) - (_e1221 * _e328));
                                                let _e1227 = (((_e1197[1][1] - _e342) * _e404) - (_e1221 * _e366));
                                                let _e1230 = (_e1197[2][2] - _e380);
                                                let _e1233 = (((_e1197[2][0] - _e303) * _e404) - (_e1230 * _e328));
                                                let _e1236 = (((_e1197[2][1] - _e342) * _e404) - (_e1230 * _e366));
                                                let _e1237 = (_e1233 * _e1227);
                                                let _e1238 = (_e1236 * _e1224);
                                                let _e1239 = (_e1215 * _e1236);
                                                let _e1240 = (_e1218 * _e1233);
                                                let _e1241 = (_e1224 * _e1218);
                                                let _e1242 = (_e1227 * _e1215);
                                                let _e1247 = (((_e1237 >= _e1238) && (_e1239 >= _e1240)) && (_e1241 >= _e1242));
                                                if (_e1247 || (((_e1237 <= _e1238) && (_e1239 <= _e1240)) && (_e1241 <= _e1242))) {
                                                    let _e1254 = select(-1f, 1f, _e1247);
                                                    let _e1256 = ((_e1237 - _e1238) * _e1254);
                                                    let _e1258 = select(0f, _e1256, (_e1256 > 0f));
                                                    let _e1260 = ((_e1239 - _e1240) * _e1254);
                                                    let _e1262 = select(0f, _e1260, (_e1260 > 0f));
                                                    let _e1264 = ((_e1241 - _e1242) * _e1254);
                                                    let _e1266 = select(0f, _e1264, (_e1264 > 0f));
                                                    let _e1268 = ((_e1258 + _e1262) + _e1266);
                                                    if (_e1268 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2944_ = type_20();
                                                        phi_2945_ = true;
                                                    } else {
                                                        let _e1271 = select(_e1197[1][0], _e1197[0][0], (_e1197[0][0] < _e1197[1][0]));
                                                        let _e1275 = select(_e1197[1][0], _e1197[0][0], (_e1197[0][0] > _e1197[1][0]));
                                                        let _e1279 = select(_e1197[1][1], _e1197[0][1], (_e1197[0][1] < _e1197[1][1]));
                                                        let _e1283 = select(_e1197[1][1], _e1197[0][1], (_e1197[0][1] > _e1197[1][1]));
                                                        let _e1287 = select(_e1197[1][2], _e1197[0][2], (_e1197[0][2] < _e1197[1][2]));
                                                        let _e1291 = select(_e1197[1][2], _e1197[0][2], (_e1197[0][2] > _e1197[1][2]));
                                                        let _e1296 = ((select(_e1197[2][0], _e1271, (_e1271 < _e1197[2][0])) - _e326) * _e331);
                                                        let _e1297 = ((select(_e1197[2][0], _e1275, (_e1275 > _e1197[2][0])) - _e327) * _e331);
                                                        let _e1300 = ((select(_e1197[2][1], _e1279, (_e1279 < _e1197[2][1])) - _e364) * _e369);
                                                        let _e1301 = ((select(_e1197[2][1], _e1283, (_e1283 > _e1197[2][1])) - _e365) * _e369);
                                                        let _e1304 = ((select(_e1197[2][2], _e1287, (_e1287 < _e1197[2][2])) - _e402) * _e407);
                                                        let _e1305 = ((select(_e1197[2][2], _e1291, (_e1291 > _e1197[2][2])) - _e403) * _e407);
                                                        let _e1307 = select(_e1305, _e1304, (_e1304 < _e1305));
                                                        let _e1309 = select(_e1305, _e1304, (_e1304 > _e1305));
                                                        let _e1311 = select(_e1297, _e1296, (_e1296 < _e1297));
                                                        let _e1313 = select(_e1301, _e1300, (_e1300 < _e1301));
                                                        let _e1315 = select(_e1313, _e1311, (_e1311 > _e1313));
                                                        let _e1317 = select(_e1307, _e1315, (_e1315 > _e1307));
                                                        let _e1319 = select(_e1297, _e1296, (_e1296 > _e1297));
                                                        let _e1321 = select(_e1301, _e1300, (_e1300 > _e1301));
                                                        let _e1323 = select(_e1321, _e1319, (_e1319 < _e1321));
                                                        let _e1325 = select(_e1309, _e1323, (_e1323 < _e1309));
                                                        let _e1326 = -(_e1307);
                                                        let _e1332 = select(_e454, _e1317, (_e1317 > _e454));
                                                        if (_e1332 > (_e1325 + (select(_e1326, _e1309, (_e1309 > _e1326)) * 0.0000019073523f))) {
                                                            phi_2939_ = type_20();
                                                            phi_2940_ = true;
                                                        } else {
                                                            let _e1334 = (_e1332 > _e995);
                                                            if _e1334 {
                                                                phi_2938_ = type_20();
                                                            } else {
                                                                let _e1338 = (_e1197[1][0] - _e1197[0][0]);
                                                                let _e1339 = (_e1197[1][1] - _e1197[0][1]);
                                                                let _e1340 = (_e1197[1][2] - _e1197[0][2]);
                                                                let _e1341 = vec3<f32>(_e1338, _e1339, _e1340);
                                                                let _e1342 = (_e1197[2][0] - _e1197[1][0]);
                                                                let _e1343 = (_e1197[2][1] - _e1197[1][1]);
                                                                let _e1344 = (_e1197[2][2] - _e1197[1][2]);
                                                                let _e1345 = vec3<f32>(_e1342, _e1343, _e1344);
                                                                let _e1346 = (_e1197[0][0] - _e1197[2][0]);
                                                                let _e1347 = (_e1197[0][1] - _e1197[2][1]);
                                                                let _e1348 = (_e1197[0][2] - _e1197[2][2]);
                                                                let _e1349 = vec3<f32>(_e1346, _e1347, _e1348);
                                                                let _e1352 = bitcast<f32>((bitcast<u32>(_e1338) & 2147483647u));
                                                                let _e1355 = bitcast<f32>((bitcast<u32>(_e1339) & 2147483647u));
                                                                let _e1357 = select(_e1355, _e1352, (_e1352 > _e1355));
                                                                let _e1360 = bitcast<f32>((bitcast<u32>(_e1340) & 2147483647u));
                                                                let _e1362 = select(_e1360, _e1357, (_e1357 > _e1360));
                                                                let _e1365 = bitcast<f32>((bitcast<u32>(_e1342) & 2147483647u));
                                                                let _e1368 = bitcast<f32>((bitcast<u32>(_e1343) & 2147483647u));
                                                                let _e1370 = select(_e1368, _e1365, (_e1365 > _e1368));
                                                                let _e1373 = bitcast<f32>((bitcast<u32>(_e1344) & 2147483647u));
                                                                let _e1375 = select(_e1373, _e1370, (_e1370 > _e1373));
                                                                let _e1378 = bitcast<f32>((bitcast<u32>(_e1346) & 2147483647u));
                                                                let _e1381 = bitcast<f32>((bitcast<u32>(_e1347) & 2147483647u));
                                                                let _e1383 = select(_e1381, _e1378, (_e1378 > _e1381));
                                                                let _e1386 = bitcast<f32>((bitcast<u32>(_e1348) & 2147483647u));
                                                                let _e1388 = select(_e1386, _e1383, (_e1383 > _e1386));
                                                                let _e1390 = select(_e1375, _e1362, (_e1362 > _e1375));
                                                                let _e1392 = select(_e1388, _e1390, (_e1390 > _e1388));
                                                                if (_e1362 == _e1392) {
                                                                    phi_2849_ = _e1345;
                                                                    phi_2850_ = _e1349;
                                                                } else {
                                                                    let _e1395 = vec3((_e1375 == _e1392));
                                                                    phi_2849_ = select(_e1341, _e1349, _e1395);
                                                                    phi_2850_ = select(_e1345, _e1341, _e1395);
                                                                }
                                                                let _e1399 = phi_2849_;
                                                                let _e1401 = phi_2850_;
                                                                let _e1408 = ((_e1399.y * _e1401.z) - (_e1401.y * _e1399.z));
                                                                let _e1413 = ((_e1399.z * _e1401.x) - (_e1401.z * _e1399.x));
                                                                let _e1416 = ((_e1399.x * _e1401.y) - (_e1401.x * _e1399.y));
                                                                if (_e1258 >= _e1262) {
                                                                    phi_2881_ = select(true, false, (_e1258 >= _e1266));
                                                                } else {
                                                                    phi_2881_ = true;
                                                                }
                                                                let _e1421 = phi_2881_;
                                                                if _e1421 {
                                                                    phi_2890_ = select(vec3<f32>(_e1197[2][0], _e1197[2][1], _e1197[2][2]), vec3<f32>(_e1197[1][0], _e1197[1][1], _e1197[1][2]), vec3((_e1262 >= _e1266)));
                                                                } else {
                                                                    phi_2890_ = vec3<f32>(_e1197[0][0], _e1197[0][1], _e1197[0][2]);
                                                                }
                                                                let _e1426 = phi_2890_;
                                                                let _e1443 = ((((_e1408 * (_e1426.x - _e303)) + (_e1413 * (_e1426.y - _e342))) + (_e1416 * (_e1426.z - _e380))) / (((_e1408 * _e328) + (_e1413 * _e366)) + (_e1416 * _e404)));
                                                                let _e1445 = select(_e1325, _e1443, (_e1443 < _e1325));
                                                                let _e1447 = select(_e1317, _e1445, (_e1445 > _e1317));
                                                                if (_e1447 >= _e454) {
                                                                    let _e1449 = (_e1447 <= _e995);
                                                                    if _e1449 {
                                                                        let _e1450 = (1f / _e1268);
                                                                        phi_2930_ = type_20(_e1447, (_e1262 * _e1450), (_e1266 * _e1450), _e1057);
                                                                    } else {
                                                                        phi_2930_ = type_20();
                                                                    }
                                                                    let _e1455 = phi_2930_;
                                                                    phi_2932_ = _e1455;
                                                                    phi_2933_ = select(true, false, _e1449);
                                                                } else {
                                                                    phi_2932_ = type_20();
                                                                    phi_2933_ = true;
                                                                }
                                                                let _e1458 = phi_2932_;
                                                                let _e1460 = phi_2933_;
                                                                if _e1460 {
                                                                    phi_2937_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2937_ = _e1458;
                                                                }
                                                                let _e1462 = phi_2937_;
                                                                phi_2938_ = _e1462;
                                                            }
                                                            let _e1464 = phi_2938_;
                                                            phi_2939_ = _e1464;
                                                            phi_2940_ = _e1334;
                                                        }
                                                        let _e1466 = phi_2939_;
                                                        let _e1468 = phi_2940_;
                                                        phi_2944_ = _e1466;
                                                        phi_2945_ = _e1468;
                                                    }
                                                    let _e1470 = phi_2944_;
                                                    let _e1472 = phi_2945_;
                                                    phi_2949_ = _e1470;
                                                    phi_2950_ = _e1472;
                                                } else {
                                                    phi_2949_ = type_20();
                                                    phi_2950_ = true;
                                                }
                                                let _e1474 = phi_2949_;
                                                let _e1476 = phi_2950_;
                                                if _e1476 {
                                                    phi_2954_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2954_ = _e1474;
                                                }
                                                let _e1478 = phi_2954_;
                                                if (_e1478.member_3 != 4294967295u) {
                                                    if (_e1057 != 4294967295u) {
                                                        phi_2966_ = type_8(0u, 8u);
                                                        phi_2969_ = _e1478;
                                                        loop {
                                                            let _e1483 = phi_2966_;
                                                            let _e1485 = phi_2969_;
                                                            if (_e1483.member < _e1483.member_1) {
                                                                phi_2967_ = type_8((_e1483.member + 1u), _e1483.member_1);
                                                                phi_2992_ = type_8(1u, _e1483.member);
                                                            } else {
                                                                phi_2967_ = _e1483;
                                                                phi_2992_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1498 = phi_2967_;
                                                            let _e1500 = phi_2992_;
                                                            let _e1504 = (bitcast<i32>(_e1500.member) != 0i);
                                                            if _e1504 {
                                                                let _e1505 = (_e1500.member_1 < 8u);
                                                                if _e1505 {
                                                                } else {
                                                                    phi_4950_ = true;
                                                                    break;
                                                                }
                                                                let _e1510 = local_2[_e1500.member_1].member;
                                                                if (_e1485.member < _e1510) {
                                                                    phi_3025_ = true;
                                                                } else {
                                                                    let _e1512 = local_2[_e1500.member_1].member;
                                                                    if (_e1485.member == _e1512) {
                                                                        let _e1517 = local_2[_e1500.member_1].member_3;
                                                                        phi_3024_ = (_e1485.member_3 < _e1517);
                                                                    } else {
                                                                        phi_3024_ = false;
                                                                    }
                                                                    let _e1520 = phi_3024_;
                                                                    phi_3025_ = _e1520;
                                                                }
                                                                let _e1522 = phi_3025_;
                                                                if _e1522 {
                                                                    if _e1505 {
                                                                    } else {
                                                                        phi_4950_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1523 = local_2[_e1500.member_1];
                                                                    local_2[_e1500.member_1] = type_20(_e1485.member, _e1485.member_1, _e1485.member_2, _e1485.member_3);
                                                                    phi_3046_ = type_20(_e1523.member, _e1523.member_1, _e1523.member_2, _e1523.member_3);
                                                                } else {
                                                                    phi_3046_ = _e1485;
                                                                }
                                                                let _e1534 = phi_3046_;
                                                                phi_2970_ = _e1534;
                                                            } else {
                                                                phi_2970_ = type_20();
                                                            }
                                                            let _e1536 = phi_2970_;
                                                            continue;
                                                            continuing {
                                                                phi_2966_ = _e1498;
                                                                phi_2969_ = _e1536;
                                                                phi_4950_ = _e1196;
                                                                break if !(_e1504);
                                                            }
                                                        }
                                                        let _e1539 = phi_4950_;
                                                        phi_5171_ = _e995;
                                                        phi_5009_ = _e1539;
                                                        if _e1539 {
                                                            break;
                                                        }
                                                        let _e1542 = local_2[7u].member_3;
                                                        if (_e1542 != 4294967295u) {
                                                            let _e1546 = local_2[7u].member;
                                                            phi_5234_ = _e1546;
                                                        } else {
                                                            phi_5234_ = _e995;
                                                        }
                                                        let _e1548 = phi_5234_;
                                                        phi_5233_ = _e1548;
                                                        phi_5012_ = _e1539;
                                                    } else {
                                                        phi_5233_ = _e995;
                                                        phi_5012_ = _e1196;
                                                    }
                                                    let _e1550 = phi_5233_;
                                                    let _e1552 = phi_5012_;
                                                    phi_5232_ = _e1550;
                                                    phi_5011_ = _e1552;
                                                } else {
                                                    phi_5232_ = _e995;
                                                    phi_5011_ = _e1196;
                                                }
                                                let _e1554 = phi_5232_;
                                                let _e1556 = phi_5011_;
                                                phi_5231_ = _e1554;
                                                phi_5010_ = _e1556;
                                            } else {
                                                phi_5231_ = _e995;
                                                phi_5010_ = _e997;
                                            }
                                            let _e1558 = phi_5231_;
                                            let _e1560 = phi_5010_;
                                            continue;
                                            continuing {
                                                phi_4938_ = _e1558;
                                                phi_4867_ = _e1560;
                                                phi_2023_ = _e1012;
                                                phi_5171_ = _e1558;
                                                phi_5009_ = _e1560;
                                                break if !(_e1018);
                                            }
                                        }
                                        let _e1563 = phi_5171_;
                                        let _e1565 = phi_5009_;
                                        phi_5014_ = _e1565;
                                        if _e1565 {
                                            break;
                                        }
                                        phi_5136_ = _e1563;
                                        phi_5018_ = _e1565;
                                        phi_4396_ = _e525;
                                        phi_4397_ = false;
                                        phi_4398_ = _e529;
                                    } else {
                                        if (_e525.member_1 >= _e91) {
                                            phi_3995_ = type_57(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e525.member_1 < _e91) {
                                            } else {
                                                phi_5014_ = true;
                                                break;
                                            }
                                            let _e543 = ((1u + (_e262 * 2u)) % 7u);
                                            if (_e543 < 7u) {
                                            } else {
                                                phi_5014_ = true;
                                                break;
                                            }
                                            let _e548 = global_4.member[_e525.member_1][_e543];
                                            let _e551 = ((1u + (_e261 * 2u)) % 7u);
                                            if (_e551 < 7u) {
                                            } else {
                                                phi_5014_ = true;
                                                break;
                                            }
                                            let _e556 = global_4.member[_e525.member_1][_e551];
                                            let _e559 = ((1u + (_e263 * 2u)) % 7u);
                                            if (_e559 < 7u) {
                                            } else {
                                                phi_5014_ = true;
                                                break;
                                            }
                                            let _e564 = global_4.member[_e525.member_1][_e559];
                                            let _e567 = (((_e262 + 1u) * 2u) % 7u);
                                            if (_e567 < 7u) {
                                            } else {
                                                phi_5014_ = true;
                                                break;
                                            }
                                            let _e572 = global_4.member[_e525.member_1][_e567];
                                            let _e575 = (((_e261 + 1u) * 2u) % 7u);
                                            if (_e575 < 7u) {
                                            } else {
                                                phi_5014_ = true;
                                                break;
                                            }
                                            let _e580 = global_4.member[_e525.member_1][_e575];
                                            let _e583 = (((_e263 + 1u) * 2u) % 7u);
                                            if (_e583 < 7u) {
                                            } else {
                                                phi_5014_ = true;
                                                break;
                                            }
                                            let _e588 = global_4.member[_e525.member_1][_e583];
                                            let _e611 = (bitcast<f32>((bitcast<u32>((_e525.member.member_1.x - _e525.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e612 = (bitcast<f32>((bitcast<u32>((_e525.member.member_1.y - _e525.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e613 = (bitcast<f32>((bitcast<u32>((_e525.member.member_1.z - _e525.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e615 = select(_e142, _e611, (_e611 > _e142));
                                            let _e617 = select(_e142, _e612, (_e612 > _e142));
                                            let _e619 = select(_e142, _e613, (_e613 > _e142));
                                            let _e644 = bitcast<u32>((f32(bitcast<i32>((_e548 & 2097151u))) * _e615));
                                            let _e649 = (bitcast<i32>((_e548 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e652 = bitcast<f32>((_e644 & bitcast<u32>(_e649)));
                                            let _e653 = bitcast<u32>((f32(bitcast<i32>((_e556 & 2097151u))) * _e617));
                                            let _e658 = (bitcast<i32>((_e556 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e661 = bitcast<f32>((_e653 & bitcast<u32>(_e658)));
                                            let _e662 = bitcast<u32>((f32(bitcast<i32>((_e564 & 2097151u))) * _e619));
                                            let _e667 = (bitcast<i32>((_e564 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e670 = bitcast<f32>((_e662 & bitcast<u32>(_e667)));
                                            let _e674 = bitcast<f32>((_e644 & bitcast<u32>(~(_e649))));
                                            let _e678 = bitcast<f32>((_e653 & bitcast<u32>(~(_e658))));
                                            let _e682 = bitcast<f32>((_e662 & bitcast<u32>(~(_e667))));
                                            let _e683 = bitcast<u32>((f32(bitcast<i32>((_e572 & 2097151u))) * _e615));
                                            let _e688 = (bitcast<i32>((_e572 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e691 = bitcast<f32>((_e683 & bitcast<u32>(_e688)));
                                            let _e692 = bitcast<u32>((f32(bitcast<i32>((_e580 & 2097151u))) * _e617));
                                            let _e697 = (bitcast<i32>((_e580 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e700 = bitcast<f32>((_e692 & bitcast<u32>(_e697)));
                                            let _e701 = bitcast<u32>((f32(bitcast<i32>((_e588 & 2097151u))) * _e619));
                                            let _e706 = (bitcast<i32>((_e588 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e709 = bitcast<f32>((_e701 & bitcast<u32>(_e706)));
                                            let _e713 = bitcast<f32>((_e683 & bitcast<u32>(~(_e688))));
                                            let _e717 = bitcast<f32>((_e692 & bitcast<u32>(~(_e697))));
                                            let _e721 = bitcast<f32>((_e701 & bitcast<u32>(~(_e706))));
                                            let _e722 = (_e525.member.member.x + _e652);
                                            let _e723 = (_e525.member.member.y + _e661);
                                            let _e724 = (_e525.member.member.z + _e670);
                                            let _e727 = (_e525.member.member_1.x - _e691);
                                            let _e728 = (_e525.member.member_1.y - _e700);
                                            let _e729 = (_e525.member.member_1.z - _e709);
                                            let _e748 = (_e727 - _e722);
                                            let _e749 = (_e728 - _e723);
                                            let _e750 = (_e729 - _e724);
                                            let _e752 = select(_e749, _e748, (_e748 > _e749));
                                            let _e754 = select(_e750, _e752, (_e752 > _e750));
                                            if (_e754 < (1024f * _e142)) {
                                                phi_3696_ = 0u;
                                            } else {
                                                phi_3696_ = select(2u, 1u, (_e754 < (2097152f * _e142)));
                                            }
                                            let _e761 = phi_3696_;
                                            switch bitcast<i32>(_e761) {
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
                                            let _e764 = phi_3702_;
                                            let _e770 = global_4.member[_e525.member_1][0u];
                                            let _e774 = global_4.member[_e525.member_1][2u];
                                            let _e778 = global_4.member[_e525.member_1][4u];
                                            let _e782 = global_4.member[_e525.member_1][6u];
                                            let _e794 = (((_e774 >> bitcast<u32>(22i)) | ((_e778 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e782 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e795 = (_e770 & 268435455u);
                                            let _e796 = (_e794 & 268435455u);
                                            let _e799 = ((_e770 >> bitcast<u32>(28u)) & 7u);
                                            let _e807 = ((_e770 >> bitcast<u32>(31i)) | (((_e794 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e808 = (_e799 != 0u);
                                            if (_e799 == 0u) {
                                                phi_3957_ = _e795;
                                            } else {
                                                if (_e799 == 7u) {
                                                    phi_3956_ = 2147483648u;
                                                } else {
                                                    phi_3956_ = ((2147483648u | (_e799 << bitcast<u32>(28u))) | (_e796 & 268435455u));
                                                }
                                                let _e817 = phi_3956_;
                                                phi_3957_ = _e817;
                                            }
                                            let _e819 = phi_3957_;
                                            if _e808 {
                                                let _e820 = (_e799 != 7u);
                                                if _e820 {
                                                    phi_3967_ = (_e796 + (_e799 * ((3u * _e764) + 1u)));
                                                } else {
                                                    phi_3967_ = u32();
                                                }
                                                let _e824 = phi_3967_;
                                                phi_3969_ = _e824;
                                                phi_3970_ = select(true, false, _e820);
                                            } else {
                                                phi_3969_ = u32();
                                                phi_3970_ = true;
                                            }
                                            let _e827 = phi_3969_;
                                            let _e829 = phi_3970_;
                                            if (_e807 == 0u) {
                                                phi_3991_ = (_e795 + select(0u, 1u, !(_e808)));
                                            } else {
                                                if (_e807 == 7u) {
                                                    phi_3990_ = 2147483648u;
                                                } else {
                                                    phi_3990_ = ((2147483648u | (_e807 << bitcast<u32>(28u))) | (select(_e827, _e796, _e829) & 268435455u));
                                                }
                                                let _e842 = phi_3990_;
                                                phi_3991_ = _e842;
                                            }
                                            let _e844 = phi_3991_;
                                            phi_3995_ = type_57(array<vec4<f32>, 3>(vec4<f32>(_e722, (_e525.member.member.x + _e674), _e727, (_e525.member.member_1.x - _e713)), vec4<f32>(_e723, (_e525.member.member.y + _e678), _e728, (_e525.member.member_1.y - _e717)), vec4<f32>(_e724, (_e525.member.member.z + _e682), _e729, (_e525.member.member_1.z - _e721))), type_54(type_24((_e525.member.member + vec4<f32>(_e652, _e661, _e670, 0f)), (_e525.member.member_1 - vec4<f32>(_e691, _e700, _e709, 0f))), _e819), type_54(type_24((_e525.member.member + vec4<f32>(_e674, _e678, _e682, 0f)), (_e525.member.member_1 - vec4<f32>(_e713, _e717, _e721, 0f))), _e844));
                                        }
                                        let _e849 = phi_3995_;
                                        let _e860 = ((_e849.member[0].x - _e326) * _e331);
                                        let _e861 = ((_e849.member[0].y - _e326) * _e331);
                                        let _e862 = ((_e849.member[0].z - _e327) * _e331);
                                        let _e863 = ((_e849.member[0].w - _e327) * _e331);
                                        let _e873 = ((_e849.member[1].x - _e364) * _e369);
                                        let _e874 = ((_e849.member[1].y - _e364) * _e369);
                                        let _e875 = ((_e849.member[1].z - _e365) * _e369);
                                        let _e876 = ((_e849.member[1].w - _e365) * _e369);
                                        let _e886 = ((_e849.member[2].x - _e402) * _e407);
                                        let _e887 = ((_e849.member[2].y - _e402) * _e407);
                                        let _e888 = ((_e849.member[2].z - _e403) * _e407);
                                        let _e889 = ((_e849.member[2].w - _e403) * _e407);
                                        let _e891 = select(_e888, _e886, (_e886 < _e888));
                                        let _e893 = select(_e889, _e887, (_e887 < _e889));
                                        let _e895 = select(_e888, _e886, (_e886 > _e888));
                                        let _e897 = select(_e889, _e887, (_e887 > _e889));
                                        let _e899 = select(_e862, _e860, (_e860 < _e862));
                                        let _e901 = select(_e863, _e861, (_e861 < _e863));
                                        let _e903 = select(_e875, _e873, (_e873 < _e875));
                                        let _e905 = select(_e876, _e874, (_e874 < _e876));
                                        let _e907 = select(_e903, _e899, (_e899 > _e903));
                                        let _e909 = select(_e905, _e901, (_e901 > _e905));
                                        let _e911 = select(_e891, _e907, (_e907 > _e891));
                                        let _e913 = select(_e893, _e909, (_e909 > _e893));
                                        let _e915 = select(_e862, _e860, (_e860 > _e862));
                                        let _e917 = select(_e863, _e861, (_e861 > _e863));
                                        let _e919 = select(_e875, _e873, (_e873 > _e875));
                                        let _e921 = select(_e876, _e874, (_e874 > _e876));
                                        let _e923 = select(_e919, _e915, (_e915 < _e919));
                                        let _e925 = select(_e921, _e917, (_e917 < _e921));
                                        let _e930 = -(_e891);
                                        let _e931 = -(_e893);
                                        let _e938 = (select(_e895, _e923, (_e923 < _e895)) + (select(_e930, _e895, (_e895 > _e930)) * 0.0000019073523f));
                                        let _e939 = (select(_e897, _e925, (_e925 < _e897)) + (select(_e931, _e897, (_e897 > _e931)) * 0.0000019073523f));
                                        let _e941 = select(_e454, _e911, (_e911 > _e454));
                                        let _e943 = select(_e454, _e913, (_e913 > _e454));
                                        let _e948 = (_e941 <= select(_e497, _e938, (_e938 < _e497)));
                                        let _e949 = (_e943 <= select(_e497, _e939, (_e939 < _e497)));
                                        let _e950 = (_e941 <= _e943);
                                        if _e948 {
                                            if _e949 {
                                                if _e950 {
                                                    phi_4340_ = _e849.member_2;
                                                } else {
                                                    phi_4340_ = _e849.member_1;
                                                }
                                                let _e954 = phi_4340_;
                                                let _e955 = (_e529 % 128u);
                                                let _e956 = (_e955 < 128u);
                                                if _e956 {
                                                } else {
                                                    phi_5014_ = true;
                                                    break;
                                                }
                                                local_4[_e955] = type_54(type_24(_e954.member.member, _e954.member.member_1), _e954.member_1);
                                                if _e956 {
                                                } else {
                                                    phi_5014_ = true;
                                                    break;
                                                }
                                                local_3[_e955] = select(_e943, _e941, (_e941 > _e943));
                                                if _e950 {
                                                    phi_4373_ = _e849.member_1;
                                                } else {
                                                    phi_4373_ = _e849.member_2;
                                                }
                                                let _e971 = phi_4373_;
                                                phi_4374_ = _e971;
                                                phi_4375_ = (_e529 + 1u);
                                            } else {
                                                phi_4374_ = type_54();
                                                phi_4375_ = u32();
                                            }
                                            let _e973 = phi_4374_;
                                            let _e975 = phi_4375_;
                                            phi_4377_ = _e973;
                                            phi_4378_ = _e975;
                                            phi_4379_ = select(true, false, _e949);
                                        } else {
                                            phi_4377_ = type_54();
                                            phi_4378_ = u32();
                                            phi_4379_ = true;
                                        }
                                        let _e978 = phi_4377_;
                                        let _e980 = phi_4378_;
                                        let _e982 = phi_4379_;
                                        if _e982 {
                                            if _e948 {
                                                phi_4388_ = _e849.member_1;
                                            } else {
                                                phi_4388_ = _e849.member_2;
                                            }
                                            let _e986 = phi_4388_;
                                            phi_4393_ = _e986;
                                            phi_4394_ = select(_e949, true, _e948);
                                        } else {
                                            phi_4393_ = _e978;
                                            phi_4394_ = _e527;
                                        }
                                        let _e989 = phi_4393_;
                                        let _e991 = phi_4394_;
                                        phi_5136_ = _e497;
                                        phi_5018_ = _e495;
                                        phi_4396_ = _e989;
                                        phi_4397_ = _e991;
                                        phi_4398_ = select(_e980, _e529, _e982);
                                    }
                                    let _e1567 = phi_5136_;
                                    let _e1569 = phi_5018_;
                                    let _e1571 = phi_4396_;
                                    let _e1573 = phi_4397_;
                                    let _e1575 = phi_4398_;
                                    phi_5135_ = _e1567;
                                    phi_5017_ = _e1569;
                                    phi_4399_ = _e1571;
                                    phi_4400_ = (_e501 - 1u);
                                    phi_4401_ = _e1573;
                                    phi_4402_ = _e1575;
                                } else {
                                    phi_5135_ = _e497;
                                    phi_5017_ = _e495;
                                    phi_4399_ = _e525;
                                    phi_4400_ = _e501;
                                    phi_4401_ = _e527;
                                    phi_4402_ = _e529;
                                }
                                let _e1577 = phi_5135_;
                                let _e1579 = phi_5017_;
                                let _e1581 = phi_4399_;
                                let _e1583 = phi_4400_;
                                let _e1585 = phi_4401_;
                                let _e1587 = phi_4402_;
                                phi_5134_ = _e1577;
                                phi_5016_ = _e1579;
                                phi_4403_ = _e1581;
                                phi_4404_ = _e1583;
                                phi_4405_ = _e1585;
                                phi_4406_ = _e1587;
                            } else {
                                phi_5134_ = _e497;
                                phi_5016_ = _e495;
                                phi_4403_ = type_54();
                                phi_4404_ = u32();
                                phi_4405_ = bool();
                                phi_4406_ = u32();
                            }
                            let _e1589 = phi_5134_;
                            let _e1591 = phi_5016_;
                            let _e1593 = phi_4403_;
                            let _e1595 = phi_4404_;
                            let _e1597 = phi_4405_;
                            let _e1599 = phi_4406_;
                            phi_5133_ = _e1589;
                            phi_5015_ = _e1591;
                            phi_1947_ = _e1593;
                            phi_1950_ = _e1595;
                            phi_1952_ = _e1597;
                            phi_1954_ = _e1599;
                            phi_4407_ = _e509;
                        } else {
                            phi_5133_ = _e497;
                            phi_5015_ = _e495;
                            phi_1947_ = type_54();
                            phi_1950_ = u32();
                            phi_1952_ = bool();
                            phi_1954_ = u32();
                            phi_4407_ = false;
                        }
                        let _e1601 = phi_5133_;
                        let _e1603 = phi_5015_;
                        let _e1605 = phi_1947_;
                        let _e1607 = phi_1950_;
                        let _e1609 = phi_1952_;
                        let _e1611 = phi_1954_;
                        let _e1613 = phi_4407_;
                        continue;
                        continuing {
                            phi_4870_ = _e1603;
                            phi_4769_ = _e1601;
                            phi_1946_ = _e1605;
                            phi_1949_ = _e1607;
                            phi_1951_ = _e1609;
                            phi_1953_ = _e1611;
                            phi_5014_ = _e1603;
                            break if !(_e1613);
                        }
                    }
                    let _e1616 = phi_5014_;
                    if _e1616 {
                        break;
                    }
                    phi_4414_ = type_8(0u, 8u);
                    loop {
                        let _e1618 = phi_4414_;
                        if (_e1618.member < _e1618.member_1) {
                            phi_4415_ = type_8((_e1618.member + 1u), _e1618.member_1);
                            phi_4438_ = type_8(1u, _e1618.member);
                        } else {
                            phi_4415_ = _e1618;
                            phi_4438_ = type_8(0u, type_8().member_1);
                        }
                        let _e1631 = phi_4415_;
                        let _e1633 = phi_4438_;
                        let _e1637 = (bitcast<i32>(_e1633.member) != 0i);
                        if _e1637 {
                            let _e1638 = (_e1633.member_1 < 8u);
                            if _e1638 {
                            } else {
                                phi_5126_ = true;
                                break;
                            }
                            let _e1640 = local_2[_e1633.member_1];
                            if (_e1640.member_3 != 4294967295u) {
                                let _e1646 = -(_e421);
                                let _e1647 = (_e1646 / 3i);
                                let _e1654 = bitcast<f32>((bitcast<u32>((_e1647 + 127i)) << bitcast<u32>(23i)));
                                let _e1662 = (((_e1640.member * _e1654) * _e1654) * bitcast<f32>((bitcast<u32>(((_e1646 - (2i * _e1647)) + 127i)) << bitcast<u32>(23i))));
                                let _e1664 = select(340282350000000000000000000000000000000f, _e1662, (_e1662 < 340282350000000000000000000000000000000f));
                                phi_4504_ = type_20(select(-340282350000000000000000000000000000000f, _e1664, (_e1664 > -340282350000000000000000000000000000000f)), _e1640.member_1, _e1640.member_2, _e1640.member_3);
                            } else {
                                phi_4504_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1669 = phi_4504_;
                            if _e1638 {
                            } else {
                                phi_5126_ = true;
                                break;
                            }
                            local_2[_e1633.member_1] = type_20(_e1669.member, _e1669.member_1, _e1669.member_2, _e1669.member_3);
                        }
                        continue;
                        continuing {
                            phi_4414_ = _e1631;
                            phi_5126_ = _e1616;
                            break if !(_e1637);
                        }
                    }
                    let _e1677 = phi_5126_;
                    if _e1677 {
                        break;
                    }
                    let _e1678 = local_2;
                    if _e150 {
                    } else {
                        break;
                    }
                    global_6.member[_e148] = array<type_20, 8>(type_20(_e1678[0].member, _e1678[0].member_1, _e1678[0].member_2, _e1678[0].member_3), type_20(_e1678[1].member, _e1678[1].member_1, _e1678[1].member_2, _e1678[1].member_3), type_20(_e1678[2].member, _e1678[2].member_1, _e1678[2].member_2, _e1678[2].member_3), type_20(_e1678[3].member, _e1678[3].member_1, _e1678[3].member_2, _e1678[3].member_3), type_20(_e1678[4].member, _e1678[4].member_1, _e1678[4].member_2, _e1678[4].member_3), type_20(_e1678[5].member, _e1678[5].member_1, _e1678[5].member_2, _e1678[5].member_3), type_20(_e1678[6].member, _e1678[6].member_1, _e1678[6].member_2, _e1678[6].member_3), type_20(_e1678[7].member, _e1678[7].member_1, _e1678[7].member_2, _e1678[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
