struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: array<array<u32, 4>>,
}

struct type_18 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_26 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_28 {
    member: array<type_26>,
}

struct type_30 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_31 {
    member: type_30,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_33 {
    member: array<type_31>,
}

struct type_38 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_42 {
    member: type_26,
    member_1: f32,
}

struct type_46 {
    member: type_42,
    member_1: u32,
    member_2: u32,
}

struct type_48 {
    member: array<vec4<u32>, 2>,
}

struct type_53 {
    member: type_38,
    member_1: u32,
}

struct type_54 {
    member: array<vec4<f32>, 3>,
    member_1: type_53,
    member_2: type_53,
}

struct type_59 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(2) 
var<storage> global_1: type_20;
@group(0) @binding(4) 
var<storage, read_write> global_2: type_28;
@group(0) @binding(0) 
var<uniform> global_3: type_48;
@group(0) @binding(1) 
var<storage> global_4: type_12;
@group(0) @binding(3) 
var<storage> global_5: type_33;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_7: type_59;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<f32, 128>;
    var local_7: array<f32, 128>;
    var local_8: array<u32, 128>;
    var local_9: array<f32, 128>;
    var phi_393_: i32;
    var phi_394_: i32;
    var phi_404_: bool;
    var phi_414_: u32;
    var phi_415_: u32;
    var phi_417_: bool;
    var phi_422_: u32;
    var phi_454_: i32;
    var phi_472_: f32;
    var phi_478_: f32;
    var phi_489_: f32;
    var phi_495_: f32;
    var phi_518_: f32;
    var phi_529_: f32;
    var phi_538_: f32;
    var phi_544_: f32;
    var phi_555_: f32;
    var phi_561_: f32;
    var phi_584_: f32;
    var phi_595_: f32;
    var phi_604_: f32;
    var phi_610_: f32;
    var phi_621_: f32;
    var phi_627_: f32;
    var phi_650_: f32;
    var phi_661_: f32;
    var phi_761_: f32;
    var phi_762_: f32;
    var phi_3594_: bool;
    var phi_860_: type_46;
    var phi_863_: type_53;
    var phi_865_: u32;
    var phi_867_: bool;
    var phi_869_: u32;
    var phi_880_: bool;
    var phi_966_: type_53;
    var phi_967_: bool;
    var phi_968_: u32;
    var phi_2728_: u32;
    var phi_2729_: u32;
    var phi_2739_: u32;
    var phi_2741_: u32;
    var phi_2742_: bool;
    var phi_2762_: u32;
    var phi_2763_: u32;
    var phi_2767_: type_54;
    var phi_3111_: type_53;
    var phi_3188_: type_53;
    var phi_3189_: type_53;
    var phi_3190_: u32;
    var phi_3192_: type_53;
    var phi_3193_: u32;
    var phi_3194_: bool;
    var phi_3203_: type_53;
    var phi_3208_: type_53;
    var phi_3209_: bool;
    var phi_986_: type_46;
    var phi_989_: type_7;
    var phi_990_: type_7;
    var phi_1012_: type_7;
    var phi_1036_: u32;
    var phi_1125_: array<array<f32, 3>, 3>;
    var phi_1242_: bool;
    var phi_1271_: bool;
    var phi_1672_: f32;
    var phi_1673_: f32;
    var phi_1674_: f32;
    var phi_1675_: f32;
    var phi_1676_: vec3<f32>;
    var phi_1677_: vec3<f32>;
    var phi_1678_: vec3<f32>;
    var phi_1679_: vec3<f32>;
    var phi_1710_: bool;
    var phi_1719_: vec3<f32>;
    var phi_1886_: bool;
    var phi_1910_: f32;
    var phi_1911_: f32;
    var phi_1934_: type_26;
    var phi_1936_: type_26;
    var phi_1937_: bool;
    var phi_1941_: type_26;
    var phi_1942_: type_26;
    var phi_1943_: type_26;
    var phi_1944_: bool;
    var phi_1948_: type_26;
    var phi_1949_: bool;
    var phi_1950_: type_26;
    var phi_1951_: bool;
    var phi_1952_: bool;
    var phi_1953_: type_26;
    var phi_1954_: bool;
    var phi_1955_: bool;
    var phi_1963_: type_26;
    var phi_1964_: bool;
    var phi_1968_: type_26;
    var phi_1993_: bool;
    var phi_1994_: bool;
    var phi_2001_: type_46;
    var phi_2002_: type_46;
    var phi_2003_: type_46;
    var phi_987_: type_46;
    var phi_3588_: bool;
    var phi_3734_: bool;
    var phi_3211_: type_46;
    var phi_3212_: type_53;
    var phi_3213_: bool;
    var phi_3214_: u32;
    var phi_3733_: bool;
    var phi_3215_: type_46;
    var phi_3216_: type_53;
    var phi_3217_: u32;
    var phi_3218_: bool;
    var phi_3219_: u32;
    var phi_3732_: bool;
    var phi_3220_: type_46;
    var phi_3221_: type_53;
    var phi_3222_: u32;
    var phi_3223_: bool;
    var phi_3224_: u32;
    var phi_3731_: bool;
    var phi_861_: type_46;
    var phi_864_: type_53;
    var phi_866_: u32;
    var phi_868_: bool;
    var phi_870_: u32;
    var phi_3225_: bool;
    var phi_3730_: bool;
    var local_10: type_46;
    var phi_3277_: type_26;
    var local_11: type_46;
    var local_12: type_46;

    switch bitcast<i32>(0u) {
        default: {
            let _e86 = global;
            let _e88 = arrayLength((&global_4.member));
            let _e90 = arrayLength((&global_1.member));
            let _e98 = arrayLength((&global_7.member));
            let _e102 = global_3.member[0u][0u];
            let _e106 = global_3.member[0u][1u];
            let _e110 = global_3.member[0u][2u];
            let _e114 = global_3.member[0u][3u];
            let _e118 = global_3.member[1u][0u];
            let _e122 = global_3.member[1u][1u];
            let _e126 = global_3.member[1u][2u];
            let _e130 = (_e86.x + (_e86.y * 2097152u));
            let _e142 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e114) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e102), bitcast<i32>(_e106), bitcast<i32>(_e110));
            local = array<i32, 3>(bitcast<i32>(_e118), bitcast<i32>(_e122), bitcast<i32>(_e126));
            let _e145 = (_e130 < arrayLength((&global_5.member)));
            if _e145 {
                let _e146 = (_e130 < arrayLength((&global_2.member)));
                if _e146 {
                    let _e147 = (_e130 < arrayLength((&global_6.member)));
                    if _e147 {
                        if _e145 {
                        } else {
                            break;
                        }
                        let _e157 = global_5.member[_e130].member.member_2[0u];
                        let _e159 = (bitcast<u32>(_e157) & 2147483647u);
                        let _e165 = global_5.member[_e130].member.member_2[1u];
                        let _e167 = (bitcast<u32>(_e165) & 2147483647u);
                        let _e173 = global_5.member[_e130].member.member_2[2u];
                        let _e175 = (bitcast<u32>(_e173) & 2147483647u);
                        let _e181 = global_5.member[_e130].member.member[0u];
                        let _e183 = (bitcast<u32>(_e181) & 2147483647u);
                        let _e189 = global_5.member[_e130].member.member[1u];
                        let _e191 = (bitcast<u32>(_e189) & 2147483647u);
                        let _e197 = global_5.member[_e130].member.member[2u];
                        let _e199 = (bitcast<u32>(_e197) & 2147483647u);
                        let _e201 = select(_e167, _e159, (_e167 < _e159));
                        let _e203 = select(_e175, _e201, (_e175 < _e201));
                        let _e205 = select(_e183, _e203, (_e183 < _e203));
                        let _e207 = select(_e191, _e205, (_e191 < _e205));
                        let _e209 = select(_e199, _e207, (_e199 < _e207));
                        let _e214 = global_5.member[_e130].member.member_1;
                        let _e216 = (bitcast<u32>(_e214) & 2147483647u);
                        let _e224 = global_5.member[_e130].member.member_3;
                        let _e230 = (((select(_e216, _e209, (_e216 < _e209)) < 2139095040u) && ((bitcast<u32>(_e224) & 2147483647u) <= 2139095040u)) && (_e203 > 0u));
                        if _e230 {
                            let _e233 = (bitcast<u32>(bitcast<f32>(_e203)) & 2147483647u);
                            if (_e233 >= 8388608u) {
                                phi_393_ = (bitcast<i32>((_e233 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_393_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e233)), 32u, (_e233 == 0u))));
                            }
                            let _e247 = phi_393_;
                            phi_394_ = _e247;
                        } else {
                            phi_394_ = 0i;
                        }
                        let _e249 = phi_394_;
                        let _e250 = (_e159 == _e203);
                        if _e250 {
                            phi_404_ = true;
                        } else {
                            phi_404_ = (_e167 == _e203);
                        }
                        let _e253 = phi_404_;
                        let _e254 = select(1u, 0u, _e250);
                        if _e253 {
                            let _e255 = (_e254 + 1u);
                            phi_414_ = _e255;
                            phi_415_ = _e255;
                            phi_417_ = select(true, false, (_e255 == 2u));
                        } else {
                            phi_414_ = u32();
                            phi_415_ = 0u;
                            phi_417_ = true;
                        }
                        let _e259 = phi_414_;
                        let _e261 = phi_415_;
                        let _e263 = phi_417_;
                        if _e263 {
                            phi_422_ = (_e261 + 1u);
                        } else {
                            phi_422_ = 0u;
                        }
                        let _e267 = phi_422_;
                        let _e268 = select(_e259, _e261, _e263);
                        let _e269 = select(_e254, select(2u, _e254, _e253), _e263);
                        let _e270 = -(_e249);
                        if (_e270 < -126i) {
                            phi_454_ = -126i;
                        } else {
                            phi_454_ = select(_e270, 127i, (_e270 > 127i));
                        }
                        let _e275 = phi_454_;
                        let _e280 = bitcast<f32>((bitcast<u32>((_e275 + 127i)) << bitcast<u32>(23i)));
                        let _e286 = bitcast<f32>((bitcast<u32>(((_e270 - _e275) + 127i)) << bitcast<u32>(23i)));
                        let _e291 = global_5.member[_e130].member.member;
                        let _e292 = (_e268 == 0u);
                        if _e292 {
                            phi_472_ = _e291[0];
                        } else {
                            phi_472_ = _e291[1];
                        }
                        let _e296 = phi_472_;
                        let _e297 = (_e268 == 2u);
                        if _e297 {
                            phi_478_ = _e291[2];
                        } else {
                            phi_478_ = _e296;
                        }
                        let _e300 = phi_478_;
                        let _e301 = global_5.member[_e130].member.member_2;
                        if _e292 {
                            phi_489_ = _e301[0];
                        } else {
                            phi_489_ = _e301[1];
                        }
                        let _e305 = phi_489_;
                        if _e297 {
                            phi_495_ = _e301[2];
                        } else {
                            phi_495_ = _e305;
                        }
                        let _e308 = phi_495_;
                        let _e310 = ((_e308 * _e280) * _e286);
                        let _e314 = (bitcast<f32>((bitcast<u32>(_e310) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e314 {
                            let _e318 = (bitcast<f32>((bitcast<u32>(_e300) & 2147483647u)) * 0.00000011920929f);
                            phi_518_ = select(0.00000000000011368684f, _e318, (_e318 > 0.00000000000011368684f));
                        } else {
                            phi_518_ = 0f;
                        }
                        let _e322 = phi_518_;
                        let _e323 = (_e300 + _e322);
                        let _e324 = (_e300 - _e322);
                        let _e325 = select(_e310, 0f, _e314);
                        if _e314 {
                            phi_529_ = 38685626000000000000000000f;
                        } else {
                            phi_529_ = (1f / _e310);
                        }
                        let _e328 = phi_529_;
                        let _e329 = (_e267 == 0u);
                        if _e329 {
                            phi_538_ = _e291[0];
                        } else {
                            phi_538_ = _e291[1];
                        }
                        let _e333 = phi_538_;
                        let _e334 = (_e267 == 2u);
                        if _e334 {
                            phi_544_ = _e291[2];
                        } else {
                            phi_544_ = _e333;
                        }
                        let _e337 = phi_544_;
                        if _e329 {
                            phi_555_ = _e301[0];
                        } else {
                            phi_555_ = _e301[1];
                        }
                        let _e341 = phi_555_;
                        if _e334 {
                            phi_561_ = _e301[2];
                        } else {
                            phi_561_ = _e341;
                        }
                        let _e344 = phi_561_;
                        let _e346 = ((_e344 * _e280) * _e286);
                        let _e350 = (bitcast<f32>((bitcast<u32>(_e346) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e350 {
                            let _e354 = (bitcast<f32>((bitcast<u32>(_e337) & 2147483647u)) * 0.00000011920929f);
                            phi_584_ = select(0.00000000000011368684f, _e354, (_e354 > 0.00000000000011368684f));
                        } else {
                            phi_584_ = 0f;
                        }
                        let _e358 = phi_584_;
                        let _e359 = (_e337 + _e358);
                        let _e360 = (_e337 - _e358);
                        let _e361 = select(_e346, 0f, _e350);
                        if _e350 {
                            phi_595_ = 38685626000000000000000000f;
                        } else {
                            phi_595_ = (1f / _e346);
                        }
                        let _e364 = phi_595_;
                        let _e365 = (_e269 == 0u);
                        if _e365 {
                            phi_604_ = _e291[0];
                        } else {
                            phi_604_ = _e291[1];
                        }
                        let _e369 = phi_604_;
                        let _e370 = (_e269 == 2u);
                        if _e370 {
                            phi_610_ = _e291[2];
                        } else {
                            phi_610_ = _e369;
                        }
                        let _e373 = phi_610_;
                        if _e365 {
                            phi_621_ = _e301[0];
                        } else {
                            phi_621_ = _e301[1];
                        }
                        let _e377 = phi_621_;
                        if _e370 {
                            phi_627_ = _e301[2];
                        } else {
                            phi_627_ = _e377;
                        }
                        let _e380 = phi_627_;
                        let _e382 = ((_e380 * _e280) * _e286);
                        let _e386 = (bitcast<f32>((bitcast<u32>(_e382) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e386 {
                            let _e390 = (bitcast<f32>((bitcast<u32>(_e373) & 2147483647u)) * 0.00000011920929f);
                            phi_650_ = select(0.00000000000011368684f, _e390, (_e390 > 0.00000000000011368684f));
                        } else {
                            phi_650_ = 0f;
                        }
                        let _e394 = phi_650_;
                        let _e395 = (_e373 + _e394);
                        let _e396 = (_e373 - _e394);
                        let _e397 = select(_e382, 0f, _e386);
                        if _e386 {
                            phi_661_ = 38685626000000000000000000f;
                        } else {
                            phi_661_ = (1f / _e382);
                        }
                        let _e400 = phi_661_;
                        let _e403 = bitcast<f32>((bitcast<u32>(_e300) & 2147483647u));
                        let _e406 = bitcast<f32>((bitcast<u32>(_e337) & 2147483647u));
                        let _e408 = select(_e406, _e403, (_e403 > _e406));
                        let _e411 = bitcast<f32>((bitcast<u32>(_e373) & 2147483647u));
                        if (_e230 && (select(_e411, _e408, (_e408 > _e411)) <= 1099511600000f)) {
                            let _e416 = (_e249 / 3i);
                            let _e423 = bitcast<f32>((bitcast<u32>((_e416 + 127i)) << bitcast<u32>(23i)));
                            let _e430 = bitcast<f32>((bitcast<u32>(((_e249 - (2i * _e416)) + 127i)) << bitcast<u32>(23i)));
                            let _e431 = (((_e214 * _e423) * _e423) * _e430);
                            let _e433 = select(340282350000000000000000000000000000000f, _e431, (_e431 < 340282350000000000000000000000000000000f));
                            let _e438 = (((_e224 * _e423) * _e423) * _e430);
                            let _e440 = select(340282350000000000000000000000000000000f, _e438, (_e438 < 340282350000000000000000000000000000000f));
                            phi_761_ = select(-340282350000000000000000000000000000000f, _e440, (_e440 > -340282350000000000000000000000000000000f));
                            phi_762_ = select(-340282350000000000000000000000000000000f, _e433, (_e433 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_761_ = 0f;
                            phi_762_ = 1f;
                        }
                        let _e444 = phi_761_;
                        let _e446 = phi_762_;
                        if _e145 {
                        } else {
                            break;
                        }
                        let _e452 = global_5.member[_e130].member_2;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e455 = (_e268 % 3u);
                        let _e456 = (_e455 < 3u);
                        if _e456 {
                        } else {
                            break;
                        }
                        let _e458 = local_1[_e455];
                        let _e461 = (_e267 % 3u);
                        let _e462 = (_e461 < 3u);
                        if _e462 {
                        } else {
                            break;
                        }
                        let _e464 = local_1[_e461];
                        let _e467 = (_e269 % 3u);
                        let _e468 = (_e467 < 3u);
                        if _e468 {
                        } else {
                            break;
                        }
                        let _e470 = local_1[_e467];
                        if _e456 {
                        } else {
                            break;
                        }
                        let _e475 = local[_e455];
                        if _e462 {
                        } else {
                            break;
                        }
                        let _e479 = local[_e461];
                        if _e468 {
                        } else {
                            break;
                        }
                        let _e483 = local[_e467];
                        phi_3594_ = false;
                        phi_860_ = type_46(type_42(type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e444), 0u, 0u);
                        phi_863_ = type_53(type_38(vec4<f32>((f32(_e458) * _e142), (f32(_e464) * _e142), (f32(_e470) * _e142), 0f), vec4<f32>((f32(_e475) * _e142), (f32(_e479) * _e142), (f32(_e483) * _e142), 0f)), select(0u, 2147483648u, (_e88 == 0u)));
                        phi_865_ = ((3u * _e88) + 1u);
                        phi_867_ = (_e446 <= _e444);
                        phi_869_ = 0u;
                        loop {
                            let _e493 = phi_3594_;
                            let _e495 = phi_860_;
                            let _e497 = phi_863_;
                            let _e499 = phi_865_;
                            let _e501 = phi_867_;
                            let _e503 = phi_869_;
                            local_10 = _e495;
                            local_11 = _e495;
                            if _e501 {
                                phi_880_ = true;
                            } else {
                                phi_880_ = (_e503 > 0u);
                            }
                            let _e506 = phi_880_;
                            if _e506 {
                                let _e507 = (_e499 > 0u);
                                if _e507 {
                                    if _e501 {
                                        phi_966_ = _e497;
                                        phi_967_ = _e501;
                                        phi_968_ = _e503;
                                    } else {
                                        let _e508 = (_e503 - 1u);
                                        let _e509 = (_e508 % 128u);
                                        let _e510 = (_e509 < 128u);
                                        if _e510 {
                                        } else {
                                            phi_3730_ = true;
                                            break;
                                        }
                                        let _e512 = local_7[_e509];
                                        if _e510 {
                                        } else {
                                            phi_3730_ = true;
                                            break;
                                        }
                                        let _e514 = local_6[_e509];
                                        if _e510 {
                                        } else {
                                            phi_3730_ = true;
                                            break;
                                        }
                                        let _e516 = local_5[_e509];
                                        if _e510 {
                                        } else {
                                            phi_3730_ = true;
                                            break;
                                        }
                                        let _e518 = local_4[_e509];
                                        if _e510 {
                                        } else {
                                            phi_3730_ = true;
                                            break;
                                        }
                                        let _e520 = local_3[_e509];
                                        if _e510 {
                                        } else {
                                            phi_3730_ = true;
                                            break;
                                        }
                                        let _e522 = local_2[_e509];
                                        if _e510 {
                                        } else {
                                            phi_3730_ = true;
                                            break;
                                        }
                                        let _e527 = local_8[_e509];
                                        if _e510 {
                                        } else {
                                            phi_3730_ = true;
                                            break;
                                        }
                                        let _e530 = local_9[_e509];
                                        phi_966_ = type_53(type_38(vec4<f32>(_e512, _e514, _e516, 0f), vec4<f32>(_e518, _e520, _e522, 0f)), _e527);
                                        phi_967_ = (_e530 <= _e495.member.member_1);
                                        phi_968_ = _e508;
                                    }
                                    let _e535 = phi_966_;
                                    let _e537 = phi_967_;
                                    let _e539 = phi_968_;
                                    if _e537 {
                                        if ((_e535.member_1 & 2147483648u) != 0u) {
                                            phi_986_ = _e495;
                                            phi_989_ = type_7(0u, ((_e535.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e990 = phi_986_;
                                                let _e992 = phi_989_;
                                                local_12 = _e990;
                                                if (_e992.member < _e992.member_1) {
                                                    phi_990_ = type_7((_e992.member + 1u), _e992.member_1);
                                                    phi_1012_ = type_7(1u, _e992.member);
                                                } else {
                                                    phi_990_ = _e992;
                                                    phi_1012_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e1005 = phi_990_;
                                                let _e1007 = phi_1012_;
                                                let _e1011 = (bitcast<i32>(_e1007.member) != 0i);
                                                if _e1011 {
                                                    let _e1017 = type_46(_e990.member, _e990.member_1, (_e990.member_2 + 1u));
                                                    let _e1018 = ((_e535.member_1 & 268435455u) + _e1007.member_1);
                                                    let _e1019 = (_e1018 < _e90);
                                                    if _e1019 {
                                                        if _e1019 {
                                                        } else {
                                                            phi_3588_ = true;
                                                            break;
                                                        }
                                                        let _e1023 = global_1.member[_e1018].member_1;
                                                        phi_1036_ = _e1023;
                                                    } else {
                                                        phi_1036_ = 4294967295u;
                                                    }
                                                    let _e1025 = phi_1036_;
                                                    if (_e1018 >= _e90) {
                                                        phi_1125_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1019 {
                                                        } else {
                                                            phi_3588_ = true;
                                                            break;
                                                        }
                                                        if (_e455 < 9u) {
                                                        } else {
                                                            phi_3588_ = true;
                                                            break;
                                                        }
                                                        let _e1032 = global_1.member[_e1018].member[_e455];
                                                        if (_e461 < 9u) {
                                                        } else {
                                                            phi_3588_ = true;
                                                            break;
                                                        }
                                                        let _e1038 = global_1.member[_e1018].member[_e461];
                                                        if (_e467 < 9u) {
                                                        } else {
                                                            phi_3588_ = true;
                                                            break;
                                                        }
                                                        let _e1044 = global_1.member[_e1018].member[_e467];
                                                        let _e1046 = (3u + _e455);
                                                        if (_e1046 < 9u) {
                                                        } else {
                                                            phi_3588_ = true;
                                                            break;
                                                        }
                                                        let _e1052 = global_1.member[_e1018].member[_e1046];
                                                        let _e1053 = (3u + _e461);
                                                        if (_e1053 < 9u) {
                                                        } else {
                                                            phi_3588_ = true;
                                                            break;
                                                        }
                                                        let _e1059 = global_1.member[_e1018].member[_e1053];
                                                        let _e1060 = (3u + _e467);
                                                        if (_e1060 < 9u) {
                                                        } else {
                                                            phi_3588_ = true;
                                                            break;
                                                        }
                                                        let _e1066 = global_1.member[_e1018].member[_e1060];
                                                        let _e1068 = (6u + _e455);
                                                        if (_e1068 < 9u) {
                                                        } else {
                                                            phi_3588_ = true;
                                                            break;
                                                        }
                                                        let _e1074 = global_1.member[_e1018].member[_e1068];
                                                        let _e1075 = (6u + _e461);
                                                        if (_e1075 < 9u) {
                                                        } else {
                                                            phi_3588_ = true;
                                                            break;
                                                        }
                                                        let _e1081 = global_1.member[_e1018].member[_e1075];
                                                        let _e1082 = (6u + _e467);
                                                        if (_e1082 < 9u) {
                                                        } else {
                                                            phi_3588_ = true;
                                                            break;
                                                        }
                                                        let _e1088 = global_1.member[_e1018].member[_e1082];
                                                        phi_1125_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1032, _e1038, _e1044), array<f32, 3>(_e1052, _e1059, _e1066), array<f32, 3>(_e1074, _e1081, _e1088));
                                                    }
                                                    let _e1092 = phi_1125_;
                                                    let _e1101 = (_e1092[0][2] - _e373);
                                                    let _e1104 = (((_e1092[0][0] - _e300) * _e397) - (_e1101 * _e325));
                                                    let _e1107 = (((_e1092[0][1] - _e337) * _e397) - (_e1101 * _e361));
                                                    let _e1114 = (_e1092[1][2] - _e373);
                                                    let _e1117 = (((_e1092[1][0] - _e300) * _e397) - (_e1114 * _e325));
                                                    let _e1120 = (((_e1092[1][1] - _e337) * _e397) - (_e1114 * _e361));
                                                    let _e1127 = (_e1092[2][2] - _e373);
                                                    let _e1130 = (((_e1092[2][0] - _e300) * _e397) - (_e1127 * _e325));
                                                    let _e1133 = (((_e1092[2][1] - _e337) * _e397) - (_e1127 * _e361));
                                                    let _e1134 = (_e1130 * _e1120);
                                                    let _e1135 = (_e1133 * _e1117);
                                                    let _e1136 = (_e1104 * _e1133);
                                                    let _e1137 = (_e1107 * _e1130);
                                                    let _e1138 = (_e1117 * _e1107);
                                                    let _e1139 = (_e1120 * _e1104);
                                                    let _e1144 = (((_e1134 >= _e1135) && (_e1136 >= _e1137)) && (_e1138 >= _e1139));
                                                    if (_e1144 || (((_e1134 <= _e1135) && (_e1136 <= _e1137)) && (_e1138 <= _e1139))) {
                                                        let _e1151 = select(-1f, 1f, _e1144);
                                                        let _e1153 = ((_e1134 - _e1135) * _e1151);
                                                        let _e1155 = select(0f, _e1153, (_e1153 > 0f));
                                                        let _e1157 = ((_e1136 - _e1137) * _e1151);
                                                        let _e1159 = select(0f, _e1157, (_e1157 > 0f));
                                                        let _e1161 = ((_e1138 - _e1139) * _e1151);
                                                        let _e1163 = select(0f, _e1161, (_e1161 > 0f));
                                                        let _e1165 = ((_e1155 + _e1159) + _e1163);
                                                        if (_e1165 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1953_ = type_26();
                                                            phi_1954_ = true;
                                                            phi_1955_ = false;
                                                        } else {
                                                            let _e1168 = select(_e1117, _e1104, (_e1104 < _e1117));
                                                            if (select(_e1130, _e1168, (_e1168 < _e1130)) > 0f) {
                                                                phi_1242_ = true;
                                                            } else {
                                                                let _e1173 = select(_e1117, _e1104, (_e1104 > _e1117));
                                                                phi_1242_ = (select(_e1130, _e1173, (_e1173 > _e1130)) < 0f);
                                                            }
                                                            let _e1178 = phi_1242_;
                                                            if _e1178 {
                                                                phi_1950_ = type_26();
                                                                phi_1951_ = true;
                                                                phi_1952_ = false;
                                                            } else {
                                                                let _e1180 = select(_e1120, _e1107, (_e1107 < _e1120));
                                                                if (select(_e1133, _e1180, (_e1180 < _e1133)) > 0f) {
                                                                    phi_1271_ = true;
                                                                } else {
                                                                    let _e1185 = select(_e1120, _e1107, (_e1107 > _e1120));
                                                                    phi_1271_ = (select(_e1133, _e1185, (_e1185 > _e1133)) < 0f);
                                                                }
                                                                let _e1190 = phi_1271_;
                                                                if _e1190 {
                                                                    phi_1948_ = type_26();
                                                                    phi_1949_ = false;
                                                                } else {
                                                                    let _e1192 = select(_e1092[1][0], _e1092[0][0], (_e1092[0][0] < _e1092[1][0]));
                                                                    let _e1196 = select(_e1092[1][0], _e1092[0][0], (_e1092[0][0] > _e1092[1][0]));
                                                                    let _e1200 = select(_e1092[1][1], _e1092[0][1], (_e1092[0][1] < _e1092[1][1]));
                                                                    let _e1204 = select(_e1092[1][1], _e1092[0][1], (_e1092[0][1] > _e1092[1][1]));
                                                                    let _e1208 = select(_e1092[1][2], _e1092[0][2], (_e1092[0][2] < _e1092[1][2]));
                                                                    let _e1212 = select(_e1092[1][2], _e1092[0][2], (_e1092[0][2] > _e1092[1][2]));
                                                                    let _e1217 = ((select(_e1092[2][0], _e1192, (_e1192 < _e1092[2][0])) - _e323) * _e328);
                                                                    let _e1218 = ((select(_e1092[2][0], _e1196, (_e1196 > _e1092[2][0])) - _e324) * _e328);
                                                                    let _e1221 = ((select(_e1092[2][1], _e1200, (_e1200 < _e1092[2][1])) - _e359) * _e364);
                                                                    let _e1222 = ((select(_e1092[2][1], _e1204, (_e1204 > _e1092[2][1])) - _e360) * _e364);
                                                                    let _e1225 = ((select(_e1092[2][2], _e1208, (_e1208 < _e1092[2][2])) - _e395) * _e400);
                                                                    let _e1226 = ((select(_e1092[2][2], _e1212, (_e1212 > _e1092[2][2])) - _e396) * _e400);
                                                                    let _e1228 = select(_e1226, _e1225, (_e1225 < _e1226));
                                                                    let _e1230 = select(_e1226, _e1225, (_e1225 > _e1226));
                                                                    let _e1232 = select(_e1218, _e1217, (_e1217 < _e1218));
                                                                    let _e1234 = select(_e1222, _e1221, (_e1221 < _e1222));
                                                                    let _e1236 = select(_e1234, _e1232, (_e1232 > _e1234));
                                                                    let _e1238 = select(_e1228, _e1236, (_e1236 > _e1228));
                                                                    let _e1240 = select(_e1218, _e1217, (_e1217 > _e1218));
                                                                    let _e1242 = select(_e1222, _e1221, (_e1221 > _e1222));
                                                                    let _e1244 = select(_e1242, _e1240, (_e1240 < _e1242));
                                                                    let _e1246 = select(_e1230, _e1244, (_e1244 < _e1230));
                                                                    let _e1247 = -(_e1228);
                                                                    let _e1253 = select(_e446, _e1238, (_e1238 > _e446));
                                                                    if (_e1253 > (_e1246 + (select(_e1247, _e1230, (_e1230 > _e1247)) * 0.0000019073523f))) {
                                                                        phi_1943_ = type_26();
                                                                        phi_1944_ = true;
                                                                    } else {
                                                                        let _e1255 = (_e1253 > _e990.member.member_1);
                                                                        if _e1255 {
                                                                            phi_1942_ = type_26();
                                                                        } else {
                                                                            let _e1256 = vec3<f32>(_e1092[0][0], _e1092[0][1], _e1092[0][2]);
                                                                            let _e1257 = vec3<f32>(_e1092[1][0], _e1092[1][1], _e1092[1][2]);
                                                                            let _e1258 = vec3<f32>(_e1092[2][0], _e1092[2][1], _e1092[2][2]);
                                                                            let _e1259 = (_e1092[1][0] - _e1092[0][0]);
                                                                            let _e1260 = (_e1092[1][1] - _e1092[0][1]);
                                                                            let _e1261 = (_e1092[1][2] - _e1092[0][2]);
                                                                            let _e1262 = vec3<f32>(_e1259, _e1260, _e1261);
                                                                            let _e1263 = (_e1092[2][0] - _e1092[1][0]);
                                                                            let _e1264 = (_e1092[2][1] - _e1092[1][1]);
                                                                            let _e1265 = (_e1092[2][2] - _e1092[1][2]);
                                                                            let _e1266 = vec3<f32>(_e1263, _e1264, _e1265);
                                                                            let _e1267 = (_e1092[0][0] - _e1092[2][0]);
                                                                            let _e1268 = (_e1092[0][1] - _e1092[2][1]);
                                                                            let _e1269 = (_e1092[0][2] - _e1092[2][2]);
                                                                            let _e1270 = vec3<f32>(_e1267, _e1268, _e1269);
                                                                            let _e1273 = bitcast<f32>((bitcast<u32>(_e1259) & 2147483647u));
                                                                            let _e1276 = bitcast<f32>((bitcast<u32>(_e1260) & 2147483647u));
                                                                            let _e1278 = select(_e1276, _e1273, (_e1273 > _e1276));
                                                                            let _e1281 = bitcast<f32>((bitcast<u32>(_e1261) & 2147483647u));
                                                                            let _e1283 = select(_e1281, _e1278, (_e1278 > _e1281));
                                                                            let _e1286 = bitcast<f32>((bitcast<u32>(_e1263) & 2147483647u));
                                                                            let _e1289 = bitcast<f32>((bitcast<u32>(_e1264) & 2147483647u));
                                                                            let _e1291 = select(_e1289, _e1286, (_e1286 > _e1289));
                                                                            let _e1294 = bitcast<f32>((bitcast<u32>(_e1265) & 2147483647u));
                                                                            let _e1296 = select(_e1294, _e1291, (_e1291 > _e1294));
                                                                            let _e1299 = bitcast<f32>((bitcast<u32>(_e1267) & 2147483647u));
                                                                            let _e1302 = bitcast<f32>((bitcast<u32>(_e1268) & 2147483647u));
                                                                            let _e1304 = select(_e1302, _e1299, (_e1299 > _e1302));
                                                                            let _e1307 = bitcast<f32>((bitcast<u32>(_e1269) & 2147483647u));
                                                                            let _e1309 = select(_e1307, _e1304, (_e1304 > _e1307));
                                                                            let _e1311 = select(_e1296, _e1283, (_e1283 > _e1296));
                                                                            let _e1313 = select(_e1309, _e1311, (_e1311 > _e1309));
                                                                            if (_e1283 == _e1313) {
                                                                                phi_1672_ = _e1120;
                                                                                phi_1673_ = _e1117;
                                                                                phi_1674_ = _e1107;
                                                                                phi_1675_ = _e1104;
                                                                                phi_1676_ = _e1256;
                                                                                phi_1677_ = _e1270;
                                                                                phi_1678_ = _e1266;
                                                                                phi_1679_ = _e1262;
                                                                            } else {
                                                                                let _e1315 = (_e1296 == _e1313);
                                                                                let _e1320 = vec3(_e1315);
                                                                                phi_1672_ = select(_e1107, _e1133, _e1315);
                                                                                phi_1673_ = select(_e1104, _e1130, _e1315);
                                                                                phi_1674_ = select(_e1133, _e1120, _e1315);
                                                                                phi_1675_ = select(_e1130, _e1117, _e1315);
                                                                                phi_1676_ = select(_e1258, _e1257, _e1320);
                                                                                phi_1677_ = select(_e1266, _e1262, _e1320);
                                                                                phi_1678_ = select(_e1262, _e1270, _e1320);
                                                                                phi_1679_ = select(_e1270, _e1266, _e1320);
                                                                            }
                                                                            let _e1326 = phi_1672_;
                                                                            let _e1328 = phi_1673_;
                                                                            let _e1330 = phi_1674_;
                                                                            let _e1332 = phi_1675_;
                                                                            let _e1334 = phi_1676_;
                                                                            let _e1336 = phi_1677_;
                                                                            let _e1338 = phi_1678_;
                                                                            let _e1340 = phi_1679_;
                                                                            let _e1347 = ((_e1338.y * _e1336.z) - (_e1336.y * _e1338.z));
                                                                            let _e1352 = ((_e1338.z * _e1336.x) - (_e1336.z * _e1338.x));
                                                                            let _e1355 = ((_e1338.x * _e1336.y) - (_e1336.x * _e1338.y));
                                                                            if (_e1155 >= _e1159) {
                                                                                phi_1710_ = select(true, false, (_e1155 >= _e1163));
                                                                            } else {
                                                                                phi_1710_ = true;
                                                                            }
                                                                            let _e1360 = phi_1710_;
                                                                            if _e1360 {
                                                                                phi_1719_ = select(_e1258, _e1257, vec3((_e1159 >= _e1163)));
                                                                            } else {
                                                                                phi_1719_ = _e1256;
                                                                            }
                                                                            let _e1365 = phi_1719_;
                                                                            let _e1370 = (((_e1347 * _e325) + (_e1352 * _e361)) + (_e1355 * _e397));
                                                                            let _e1381 = (((_e1347 * (_e1365.x - _e300)) + (_e1352 * (_e1365.y - _e337))) + (_e1355 * (_e1365.z - _e373)));
                                                                            let _e1383 = (_e1328 - _e1332);
                                                                            let _e1384 = (_e1326 - _e1330);
                                                                            let _e1392 = (-(((_e1332 * _e1383) + (_e1330 * _e1384))) / ((_e1383 * _e1383) + (_e1384 * _e1384)));
                                                                            let _e1394 = select(1f, _e1392, (_e1392 < 1f));
                                                                            let _e1396 = select(0f, _e1394, (_e1394 > 0f));
                                                                            let _e1409 = ((_e1334.x + (_e1340.x * _e1396)) - _e300);
                                                                            let _e1410 = ((_e1334.y + (_e1340.y * _e1396)) - _e337);
                                                                            let _e1411 = ((_e1334.z + (_e1340.z * _e1396)) - _e373);
                                                                            let _e1412 = (_e1411 / _e397);
                                                                            let _e1424 = bitcast<f32>((bitcast<u32>(_e1409) & 2147483647u));
                                                                            let _e1427 = bitcast<f32>((bitcast<u32>(_e1410) & 2147483647u));
                                                                            let _e1429 = select(_e1427, _e1424, (_e1424 > _e1427));
                                                                            let _e1432 = bitcast<f32>((bitcast<u32>(_e1411) & 2147483647u));
                                                                            let _e1434 = select(_e1432, _e1429, (_e1429 > _e1432));
                                                                            let _e1440 = bitcast<f32>((bitcast<u32>(_e1347) & 2147483647u));
                                                                            let _e1443 = bitcast<f32>((bitcast<u32>(_e1352) & 2147483647u));
                                                                            let _e1445 = select(_e1443, _e1440, (_e1440 > _e1443));
                                                                            let _e1448 = bitcast<f32>((bitcast<u32>(_e1355) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1347 * _e1409) + (_e1352 * _e1410)) + (_e1355 * _e1411)) - _e1381)) & 2147483647u)) <= ((0.0000009536743f * select(_e1313, _e1434, (_e1434 > _e1313))) * select(_e1448, _e1445, (_e1445 > _e1448)))) {
                                                                                let _e1458 = bitcast<f32>((bitcast<u32>(_e1338.x) & 2147483647u));
                                                                                let _e1461 = bitcast<f32>((bitcast<u32>(_e1338.y) & 2147483647u));
                                                                                let _e1463 = select(_e1461, _e1458, (_e1458 > _e1461));
                                                                                let _e1466 = bitcast<f32>((bitcast<u32>(_e1338.z) & 2147483647u));
                                                                                let _e1472 = bitcast<f32>((bitcast<u32>(_e1336.x) & 2147483647u));
                                                                                let _e1475 = bitcast<f32>((bitcast<u32>(_e1336.y) & 2147483647u));
                                                                                let _e1477 = select(_e1475, _e1472, (_e1472 > _e1475));
                                                                                let _e1480 = bitcast<f32>((bitcast<u32>(_e1336.z) & 2147483647u));
                                                                                phi_1886_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1370) & 2147483647u)) > ((0.0000038146973f * select(_e1466, _e1463, (_e1463 > _e1466))) * select(_e1480, _e1477, (_e1477 > _e1480)))));
                                                                            } else {
                                                                                phi_1886_ = true;
                                                                            }
                                                                            let _e1487 = phi_1886_;
                                                                            if _e1487 {
                                                                                let _e1498 = ((((_e1347 * (_e1409 - (_e325 * _e1412))) + (_e1352 * (_e1410 - (_e361 * _e1412)))) + (_e1355 * (_e1411 - _e1411))) / _e1370);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1498) & 2147483647u)) <= _e1313) {
                                                                                    phi_1910_ = (_e1412 + _e1498);
                                                                                } else {
                                                                                    phi_1910_ = _e1412;
                                                                                }
                                                                                let _e1505 = phi_1910_;
                                                                                phi_1911_ = _e1505;
                                                                            } else {
                                                                                phi_1911_ = (_e1381 / _e1370);
                                                                            }
                                                                            let _e1507 = phi_1911_;
                                                                            let _e1509 = select(_e1246, _e1507, (_e1507 < _e1246));
                                                                            let _e1511 = select(_e1238, _e1509, (_e1509 > _e1238));
                                                                            if (_e1511 >= _e446) {
                                                                                let _e1513 = (_e1511 <= _e990.member.member_1);
                                                                                if _e1513 {
                                                                                    let _e1514 = (1f / _e1165);
                                                                                    phi_1934_ = type_26(_e1511, (_e1159 * _e1514), (_e1163 * _e1514), _e1025);
                                                                                } else {
                                                                                    phi_1934_ = type_26();
                                                                                }
                                                                                let _e1519 = phi_1934_;
                                                                                phi_1936_ = _e1519;
                                                                                phi_1937_ = select(true, false, _e1513);
                                                                            } else {
                                                                                phi_1936_ = type_26();
                                                                                phi_1937_ = true;
                                                                            }
                                                                            let _e1522 = phi_1936_;
                                                                            let _e1524 = phi_1937_;
                                                                            if _e1524 {
                                                                                phi_1941_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_1941_ = _e1522;
                                                                            }
                                                                            let _e1526 = phi_1941_;
                                                                            phi_1942_ = _e1526;
                                                                        }
                                                                        let _e1528 = phi_1942_;
                                                                        phi_1943_ = _e1528;
                                                                        phi_1944_ = _e1255;
                                                                    }
                                                                    let _e1530 = phi_1943_;
                                                                    let _e1532 = phi_1944_;
                                                                    phi_1948_ = _e1530;
                                                                    phi_1949_ = _e1532;
                                                                }
                                                                let _e1534 = phi_1948_;
                                                                let _e1536 = phi_1949_;
                                                                phi_1950_ = _e1534;
                                                                phi_1951_ = _e1190;
                                                                phi_1952_ = _e1536;
                                                            }
                                                            let _e1538 = phi_1950_;
                                                            let _e1540 = phi_1951_;
                                                            let _e1542 = phi_1952_;
                                                            phi_1953_ = _e1538;
                                                            phi_1954_ = _e1540;
                                                            phi_1955_ = _e1542;
                                                        }
                                                        let _e1544 = phi_1953_;
                                                        let _e1546 = phi_1954_;
                                                        let _e1548 = phi_1955_;
                                                        phi_1963_ = _e1544;
                                                        phi_1964_ = select(_e1548, true, _e1546);
                                                    } else {
                                                        phi_1963_ = type_26();
                                                        phi_1964_ = true;
                                                    }
                                                    let _e1551 = phi_1963_;
                                                    let _e1553 = phi_1964_;
                                                    if _e1553 {
                                                        phi_1968_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1968_ = _e1551;
                                                    }
                                                    let _e1555 = phi_1968_;
                                                    if (_e1555.member_3 != 4294967295u) {
                                                        if (_e1025 != _e452) {
                                                            if (_e1555.member < _e990.member.member.member) {
                                                                phi_1994_ = true;
                                                            } else {
                                                                if (_e1555.member == _e990.member.member.member) {
                                                                    phi_1993_ = (_e1555.member_3 < _e990.member.member.member_3);
                                                                } else {
                                                                    phi_1993_ = false;
                                                                }
                                                                let _e1570 = phi_1993_;
                                                                phi_1994_ = _e1570;
                                                            }
                                                            let _e1572 = phi_1994_;
                                                            if _e1572 {
                                                                phi_2001_ = type_46(type_42(_e1555, _e1555.member), _e1017.member_1, _e1017.member_2);
                                                            } else {
                                                                phi_2001_ = _e1017;
                                                            }
                                                            let _e1579 = phi_2001_;
                                                            phi_2002_ = _e1579;
                                                        } else {
                                                            phi_2002_ = _e1017;
                                                        }
                                                        let _e1581 = phi_2002_;
                                                        phi_2003_ = _e1581;
                                                    } else {
                                                        phi_2003_ = _e1017;
                                                    }
                                                    let _e1583 = phi_2003_;
                                                    phi_987_ = _e1583;
                                                } else {
                                                    phi_987_ = type_46();
                                                }
                                                let _e1585 = phi_987_;
                                                continue;
                                                continuing {
                                                    phi_986_ = _e1585;
                                                    phi_989_ = _e1005;
                                                    phi_3588_ = _e493;
                                                    break if !(_e1011);
                                                }
                                            }
                                            let _e1588 = phi_3588_;
                                            phi_3730_ = _e1588;
                                            if _e1588 {
                                                break;
                                            }
                                            phi_3734_ = _e1588;
                                            let _e1822 = local_12;
                                            phi_3211_ = _e1822;
                                            phi_3212_ = _e535;
                                            phi_3213_ = false;
                                            phi_3214_ = _e539;
                                        } else {
                                            if (_e535.member_1 >= _e88) {
                                                phi_2767_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_53(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_53(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e535.member_1 < _e88) {
                                                } else {
                                                    phi_3730_ = true;
                                                    break;
                                                }
                                                let _e557 = ((1u + _e268) % 4u);
                                                if (_e557 < 4u) {
                                                } else {
                                                    phi_3730_ = true;
                                                    break;
                                                }
                                                let _e562 = global_4.member[_e535.member_1][_e557];
                                                let _e564 = (_e562 >> bitcast<u32>(11u));
                                                let _e566 = ((1u + _e267) % 4u);
                                                if (_e566 < 4u) {
                                                } else {
                                                    phi_3730_ = true;
                                                    break;
                                                }
                                                let _e571 = global_4.member[_e535.member_1][_e566];
                                                let _e573 = (_e571 >> bitcast<u32>(11u));
                                                let _e575 = ((1u + _e269) % 4u);
                                                if (_e575 < 4u) {
                                                } else {
                                                    phi_3730_ = true;
                                                    break;
                                                }
                                                let _e580 = global_4.member[_e535.member_1][_e575];
                                                let _e582 = (_e580 >> bitcast<u32>(11u));
                                                let _e605 = (bitcast<f32>((bitcast<u32>((_e535.member.member_1.x - _e535.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e606 = (bitcast<f32>((bitcast<u32>((_e535.member.member_1.y - _e535.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e607 = (bitcast<f32>((bitcast<u32>((_e535.member.member_1.z - _e535.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e609 = select(_e142, _e605, (_e605 > _e142));
                                                let _e611 = select(_e142, _e606, (_e606 > _e142));
                                                let _e613 = select(_e142, _e607, (_e607 > _e142));
                                                let _e638 = bitcast<u32>((f32(bitcast<i32>((_e562 & 1023u))) * _e609));
                                                let _e643 = (bitcast<i32>((_e562 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e646 = bitcast<f32>((_e638 & bitcast<u32>(_e643)));
                                                let _e647 = bitcast<u32>((f32(bitcast<i32>((_e571 & 1023u))) * _e611));
                                                let _e652 = (bitcast<i32>((_e571 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e655 = bitcast<f32>((_e647 & bitcast<u32>(_e652)));
                                                let _e656 = bitcast<u32>((f32(bitcast<i32>((_e580 & 1023u))) * _e613));
                                                let _e661 = (bitcast<i32>((_e580 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e664 = bitcast<f32>((_e656 & bitcast<u32>(_e661)));
                                                let _e668 = bitcast<f32>((_e638 & bitcast<u32>(~(_e643))));
                                                let _e672 = bitcast<f32>((_e647 & bitcast<u32>(~(_e652))));
                                                let _e676 = bitcast<f32>((_e656 & bitcast<u32>(~(_e661))));
                                                let _e677 = bitcast<u32>((f32(bitcast<i32>((_e564 & 1023u))) * _e609));
                                                let _e682 = (bitcast<i32>((_e564 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e685 = bitcast<f32>((_e677 & bitcast<u32>(_e682)));
                                                let _e686 = bitcast<u32>((f32(bitcast<i32>((_e573 & 1023u))) * _e611));
                                                let _e691 = (bitcast<i32>((_e573 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e694 = bitcast<f32>((_e686 & bitcast<u32>(_e691)));
                                                let _e695 = bitcast<u32>((f32(bitcast<i32>((_e582 & 1023u))) * _e613));
                                                let _e700 = (bitcast<i32>((_e582 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e703 = bitcast<f32>((_e695 & bitcast<u32>(_e700)));
                                                let _e707 = bitcast<f32>((_e677 & bitcast<u32>(~(_e682))));
                                                let _e711 = bitcast<f32>((_e686 & bitcast<u32>(~(_e691))));
                                                let _e715 = bitcast<f32>((_e695 & bitcast<u32>(~(_e700))));
                                                let _e745 = global_4.member[_e535.member_1][0u];
                                                let _e749 = global_4.member[_e535.member_1][1u];
                                                let _e753 = global_4.member[_e535.member_1][2u];
                                                let _e757 = global_4.member[_e535.member_1][3u];
                                                let _e769 = (((_e749 >> bitcast<u32>(22i)) | ((_e753 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e757 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e770 = (_e745 & 268435455u);
                                                let _e771 = (_e769 & 268435455u);
                                                let _e774 = ((_e745 >> bitcast<u32>(28u)) & 7u);
                                                let _e782 = ((_e745 >> bitcast<u32>(31i)) | (((_e769 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e783 = (_e774 != 0u);
                                                if (_e774 == 0u) {
                                                    phi_2729_ = _e770;
                                                } else {
                                                    if (_e774 == 7u) {
                                                        phi_2728_ = 2147483648u;
                                                    } else {
                                                        phi_2728_ = ((2147483648u | (_e774 << bitcast<u32>(28u))) | (_e771 & 268435455u));
                                                    }
                                                    let _e792 = phi_2728_;
                                                    phi_2729_ = _e792;
                                                }
                                                let _e794 = phi_2729_;
                                                if _e783 {
                                                    let _e795 = (_e774 != 7u);
                                                    if _e795 {
                                                        phi_2739_ = (_e771 + _e774);
                                                    } else {
                                                        phi_2739_ = u32();
                                                    }
                                                    let _e798 = phi_2739_;
                                                    phi_2741_ = _e798;
                                                    phi_2742_ = select(true, false, _e795);
                                                } else {
                                                    phi_2741_ = u32();
                                                    phi_2742_ = true;
                                                }
                                                let _e801 = phi_2741_;
                                                let _e803 = phi_2742_;
                                                if (_e782 == 0u) {
                                                    phi_2763_ = (_e770 + select(0u, 1u, !(_e783)));
                                                } else {
                                                    if (_e782 == 7u) {
                                                        phi_2762_ = 2147483648u;
                                                    } else {
                                                        phi_2762_ = ((2147483648u | (_e782 << bitcast<u32>(28u))) | (select(_e801, _e771, _e803) & 268435455u));
                                                    }
                                                    let _e816 = phi_2762_;
                                                    phi_2763_ = _e816;
                                                }
                                                let _e818 = phi_2763_;
                                                phi_2767_ = type_54(array<vec4<f32>, 3>(vec4<f32>((_e535.member.member.x + _e646), (_e535.member.member.x + _e668), (_e535.member.member_1.x - _e685), (_e535.member.member_1.x - _e707)), vec4<f32>((_e535.member.member.y + _e655), (_e535.member.member.y + _e672), (_e535.member.member_1.y - _e694), (_e535.member.member_1.y - _e711)), vec4<f32>((_e535.member.member.z + _e664), (_e535.member.member.z + _e676), (_e535.member.member_1.z - _e703), (_e535.member.member_1.z - _e715))), type_53(type_38((_e535.member.member + vec4<f32>(_e646, _e655, _e664, 0f)), (_e535.member.member_1 - vec4<f32>(_e685, _e694, _e703, 0f))), _e794), type_53(type_38((_e535.member.member + vec4<f32>(_e668, _e672, _e676, 0f)), (_e535.member.member_1 - vec4<f32>(_e707, _e711, _e715, 0f))), _e818));
                                            }
                                            let _e823 = phi_2767_;
                                            let _e836 = ((_e823.member[0].x - _e323) * _e328);
                                            let _e837 = ((_e823.member[0].y - _e323) * _e328);
                                            let _e838 = ((_e823.member[0].z - _e324) * _e328);
                                            let _e839 = ((_e823.member[0].w - _e324) * _e328);
                                            let _e849 = ((_e823.member[1].x - _e359) * _e364);
                                            let _e850 = ((_e823.member[1].y - _e359) * _e364);
                                            let _e851 = ((_e823.member[1].z - _e360) * _e364);
                                            let _e852 = ((_e823.member[1].w - _e360) * _e364);
                                            let _e862 = ((_e823.member[2].x - _e395) * _e400);
                                            let _e863 = ((_e823.member[2].y - _e395) * _e400);
                                            let _e864 = ((_e823.member[2].z - _e396) * _e400);
                                            let _e865 = ((_e823.member[2].w - _e396) * _e400);
                                            let _e867 = select(_e864, _e862, (_e862 < _e864));
                                            let _e869 = select(_e865, _e863, (_e863 < _e865));
                                            let _e871 = select(_e864, _e862, (_e862 > _e864));
                                            let _e873 = select(_e865, _e863, (_e863 > _e865));
                                            let _e875 = select(_e838, _e836, (_e836 < _e838));
                                            let _e877 = select(_e839, _e837, (_e837 < _e839));
                                            let _e879 = select(_e851, _e849, (_e849 < _e851));
                                            let _e881 = select(_e852, _e850, (_e850 < _e852));
                                            let _e883 = select(_e879, _e875, (_e875 > _e879));
                                            let _e885 = select(_e881, _e877, (_e877 > _e881));
                                            let _e887 = select(_e867, _e883, (_e883 > _e867));
                                            let _e889 = select(_e869, _e885, (_e885 > _e869));
                                            let _e891 = select(_e838, _e836, (_e836 > _e838));
                                            let _e893 = select(_e839, _e837, (_e837 > _e839));
                                            let _e895 = select(_e851, _e849, (_e849 > _e851));
                                            let _e897 = select(_e852, _e850, (_e850 > _e852));
                                            let _e899 = select(_e895, _e891, (_e891 < _e895));
                                            let _e901 = select(_e897, _e893, (_e893 < _e897));
                                            let _e906 = -(_e867);
                                            let _e907 = -(_e869);
                                            let _e914 = (select(_e871, _e899, (_e899 < _e871)) + (select(_e906, _e871, (_e871 > _e906)) * 0.0000019073523f));
                                            let _e915 = (select(_e873, _e901, (_e901 < _e873)) + (select(_e907, _e873, (_e873 > _e907)) * 0.0000019073523f));
                                            let _e917 = select(_e446, _e887, (_e887 > _e446));
                                            let _e919 = select(_e446, _e889, (_e889 > _e446));
                                            let _e924 = (_e917 <= select(_e495.member.member_1, _e914, (_e914 < _e495.member.member_1)));
                                            let _e925 = (_e919 <= select(_e495.member.member_1, _e915, (_e915 < _e495.member.member_1)));
                                            let _e926 = (_e917 <= _e919);
                                            if _e924 {
                                                if _e925 {
                                                    if _e926 {
                                                        phi_3111_ = _e823.member_2;
                                                    } else {
                                                        phi_3111_ = _e823.member_1;
                                                    }
                                                    let _e930 = phi_3111_;
                                                    let _e952 = (_e539 % 128u);
                                                    let _e953 = (_e952 < 128u);
                                                    if _e953 {
                                                    } else {
                                                        phi_3730_ = true;
                                                        break;
                                                    }
                                                    local_8[_e952] = _e930.member_1;
                                                    if _e953 {
                                                    } else {
                                                        phi_3730_ = true;
                                                        break;
                                                    }
                                                    local_7[_e952] = _e930.member.member.x;
                                                    if _e953 {
                                                    } else {
                                                        phi_3730_ = true;
                                                        break;
                                                    }
                                                    local_6[_e952] = _e930.member.member.y;
                                                    if _e953 {
                                                    } else {
                                                        phi_3730_ = true;
                                                        break;
                                                    }
                                                    local_5[_e952] = _e930.member.member.z;
                                                    if _e953 {
                                                    } else {
                                                        phi_3730_ = true;
                                                        break;
                                                    }
                                                    local_4[_e952] = _e930.member.member_1.x;
                                                    if _e953 {
                                                    } else {
                                                        phi_3730_ = true;
                                                        break;
                                                    }
                                                    local_3[_e952] = _e930.member.member_1.y;
                                                    if _e953 {
                                                    } else {
                                                        phi_3730_ = true;
                                                        break;
                                                    }
                                                    local_2[_e952] = _e930.member.member_1.z;
                                                    if _e953 {
                                                    } else {
                                                        phi_3730_ = true;
                                                        break;
                                                    }
                                                    local_9[_e952] = select(_e919, _e917, (_e917 > _e919));
                                                    if _e926 {
                                                        phi_3188_ = _e823.member_1;
                                                    } else {
                                                        phi_3188_ = _e823.member_2;
                                                    }
                                                    let _e966 = phi_3188_;
                                                    phi_3189_ = _e966;
                                                    phi_3190_ = (_e539 + 1u);
                                                } else {
                                                    phi_3189_ = type_53();
                                                    phi_3190_ = u32();
                                                }
                                                let _e968 = phi_3189_;
                                                let _e970 = phi_3190_;
                                                phi_3192_ = _e968;
                                                phi_3193_ = _e970;
                                                phi_3194_ = select(true, false, _e925);
                                            } else {
                                                phi_3192_ = type_53();
                                                phi_3193_ = u32();
                                                phi_3194_ = true;
                                            }
                                            let _e973 = phi_3192_;
                                            let _e975 = phi_3193_;
                                            let _e977 = phi_3194_;
                                            if _e977 {
                                                if _e924 {
                                                    phi_3203_ = _e823.member_1;
                                                } else {
                                                    phi_3203_ = _e823.member_2;
                                                }
                                                let _e981 = phi_3203_;
                                                phi_3208_ = _e981;
                                                phi_3209_ = select(_e925, true, _e924);
                                            } else {
                                                phi_3208_ = _e973;
                                                phi_3209_ = _e537;
                                            }
                                            let _e984 = phi_3208_;
                                            let _e986 = phi_3209_;
                                            phi_3734_ = _e493;
                                            phi_3211_ = type_46(_e495.member, (_e495.member_1 + 1u), _e495.member_2);
                                            phi_3212_ = _e984;
                                            phi_3213_ = _e986;
                                            phi_3214_ = select(_e975, _e539, _e977);
                                        }
                                        let _e1590 = phi_3734_;
                                        let _e1592 = phi_3211_;
                                        let _e1594 = phi_3212_;
                                        let _e1596 = phi_3213_;
                                        let _e1598 = phi_3214_;
                                        phi_3733_ = _e1590;
                                        phi_3215_ = _e1592;
                                        phi_3216_ = _e1594;
                                        phi_3217_ = (_e499 - 1u);
                                        phi_3218_ = _e1596;
                                        phi_3219_ = _e1598;
                                    } else {
                                        phi_3733_ = _e493;
                                        phi_3215_ = _e495;
                                        phi_3216_ = _e535;
                                        phi_3217_ = _e499;
                                        phi_3218_ = _e537;
                                        phi_3219_ = _e539;
                                    }
                                    let _e1600 = phi_3733_;
                                    let _e1602 = phi_3215_;
                                    let _e1604 = phi_3216_;
                                    let _e1606 = phi_3217_;
                                    let _e1608 = phi_3218_;
                                    let _e1610 = phi_3219_;
                                    phi_3732_ = _e1600;
                                    phi_3220_ = _e1602;
                                    phi_3221_ = _e1604;
                                    phi_3222_ = _e1606;
                                    phi_3223_ = _e1608;
                                    phi_3224_ = _e1610;
                                } else {
                                    phi_3732_ = _e493;
                                    phi_3220_ = type_46();
                                    phi_3221_ = type_53();
                                    phi_3222_ = u32();
                                    phi_3223_ = bool();
                                    phi_3224_ = u32();
                                }
                                let _e1612 = phi_3732_;
                                let _e1614 = phi_3220_;
                                let _e1616 = phi_3221_;
                                let _e1618 = phi_3222_;
                                let _e1620 = phi_3223_;
                                let _e1622 = phi_3224_;
                                phi_3731_ = _e1612;
                                phi_861_ = _e1614;
                                phi_864_ = _e1616;
                                phi_866_ = _e1618;
                                phi_868_ = _e1620;
                                phi_870_ = _e1622;
                                phi_3225_ = _e507;
                            } else {
                                phi_3731_ = _e493;
                                phi_861_ = type_46();
                                phi_864_ = type_53();
                                phi_866_ = u32();
                                phi_868_ = bool();
                                phi_870_ = u32();
                                phi_3225_ = false;
                            }
                            let _e1624 = phi_3731_;
                            let _e1626 = phi_861_;
                            let _e1628 = phi_864_;
                            let _e1630 = phi_866_;
                            let _e1632 = phi_868_;
                            let _e1634 = phi_870_;
                            let _e1636 = phi_3225_;
                            continue;
                            continuing {
                                phi_3594_ = _e1624;
                                phi_860_ = _e1626;
                                phi_863_ = _e1628;
                                phi_865_ = _e1630;
                                phi_867_ = _e1632;
                                phi_869_ = _e1634;
                                phi_3730_ = _e1624;
                                break if !(_e1636);
                            }
                        }
                        let _e1639 = phi_3730_;
                        if _e1639 {
                            break;
                        }
                        let _e1641 = local_10;
                        if (_e1641.member.member.member_3 != 4294967295u) {
                            let _e1647 = (_e270 / 3i);
                            let _e1654 = bitcast<f32>((bitcast<u32>((_e1647 + 127i)) << bitcast<u32>(23i)));
                            let _e1662 = (((_e1641.member.member.member * _e1654) * _e1654) * bitcast<f32>((bitcast<u32>(((_e270 - (2i * _e1647)) + 127i)) << bitcast<u32>(23i))));
                            let _e1664 = select(340282350000000000000000000000000000000f, _e1662, (_e1662 < 340282350000000000000000000000000000000f));
                            phi_3277_ = type_26(select(-340282350000000000000000000000000000000f, _e1664, (_e1664 > -340282350000000000000000000000000000000f)), _e1641.member.member.member_1, _e1641.member.member.member_2, _e1641.member.member.member_3);
                        } else {
                            phi_3277_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1671 = phi_3277_;
                        if _e146 {
                        } else {
                            break;
                        }
                        global_2.member[_e130] = _e1671;
                        let _e1675 = local_11;
                        if _e147 {
                        } else {
                            break;
                        }
                        global_6.member[_e130] = _e1675.member_1;
                        if _e145 {
                        } else {
                            break;
                        }
                        let _e1680 = select(0u, 1u, (_e214 <= _e224));
                        if (_e1680 > 0u) {
                            let _e1682 = (1u < _e98);
                            if _e1682 {
                                if (0u < _e98) {
                                } else {
                                    break;
                                }
                                let _e1686 = atomicAdd((&global_7.member[0u]), _e1680);
                                if ((_e1686 + _e1680) < _e1686) {
                                    if _e1682 {
                                    } else {
                                        break;
                                    }
                                    let _e1691 = atomicAdd((&global_7.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1694 = select(0u, 1u, (_e1671.member_3 != 4294967295u));
                        if (_e1694 > 0u) {
                            let _e1696 = (3u < _e98);
                            if _e1696 {
                                if (2u < _e98) {
                                } else {
                                    break;
                                }
                                let _e1700 = atomicAdd((&global_7.member[2u]), _e1694);
                                if ((_e1700 + _e1694) < _e1700) {
                                    if _e1696 {
                                    } else {
                                        break;
                                    }
                                    let _e1705 = atomicAdd((&global_7.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1675.member_1 > 0u) {
                            let _e1707 = (5u < _e98);
                            if _e1707 {
                                if (4u < _e98) {
                                } else {
                                    break;
                                }
                                let _e1711 = atomicAdd((&global_7.member[4u]), _e1675.member_1);
                                if ((_e1711 + _e1675.member_1) < _e1711) {
                                    if _e1707 {
                                    } else {
                                        break;
                                    }
                                    let _e1716 = atomicAdd((&global_7.member[5u]), 1u);
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
fn trace_paths_counted_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
