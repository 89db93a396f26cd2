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
    var phi_270_: u32;
    var phi_314_: i32;
    var phi_338_: type_35;
    var phi_444_: i32;
    var phi_445_: i32;
    var phi_455_: bool;
    var phi_465_: u32;
    var phi_466_: u32;
    var phi_468_: bool;
    var phi_473_: u32;
    var phi_505_: i32;
    var phi_523_: f32;
    var phi_529_: f32;
    var phi_540_: f32;
    var phi_546_: f32;
    var phi_569_: f32;
    var phi_580_: f32;
    var phi_589_: f32;
    var phi_595_: f32;
    var phi_606_: f32;
    var phi_612_: f32;
    var phi_635_: f32;
    var phi_646_: f32;
    var phi_655_: f32;
    var phi_661_: f32;
    var phi_672_: f32;
    var phi_678_: f32;
    var phi_701_: f32;
    var phi_712_: f32;
    var phi_812_: f32;
    var phi_813_: f32;
    var phi_3378_: bool;
    var phi_886_: type_38;
    var phi_889_: type_61;
    var phi_891_: u32;
    var phi_893_: bool;
    var phi_895_: u32;
    var phi_906_: bool;
    var phi_992_: type_61;
    var phi_993_: bool;
    var phi_994_: u32;
    var phi_2255_: type_48;
    var phi_3087_: type_61;
    var phi_3164_: type_61;
    var phi_3165_: type_61;
    var phi_3166_: u32;
    var phi_3168_: type_61;
    var phi_3169_: u32;
    var phi_3170_: bool;
    var phi_3177_: type_61;
    var phi_3182_: type_61;
    var phi_3183_: bool;
    var phi_1013_: type_38;
    var phi_1016_: type_8;
    var phi_1017_: type_8;
    var phi_1039_: type_8;
    var phi_1064_: u32;
    var phi_1080_: type_55;
    var phi_1786_: vec3<f32>;
    var phi_1787_: vec3<f32>;
    var phi_1818_: bool;
    var phi_1827_: vec3<f32>;
    var phi_1867_: type_22;
    var phi_1869_: type_22;
    var phi_1870_: bool;
    var phi_1874_: type_22;
    var phi_1875_: type_22;
    var phi_1876_: type_22;
    var phi_1877_: bool;
    var phi_1881_: type_22;
    var phi_1882_: bool;
    var phi_1886_: type_22;
    var phi_1887_: bool;
    var phi_1891_: type_22;
    var phi_1914_: u32;
    var phi_1928_: i32;
    var phi_1944_: vec3<f32>;
    var phi_1945_: vec3<f32>;
    var phi_1957_: vec3<f32>;
    var phi_1958_: vec3<f32>;
    var phi_1970_: vec3<f32>;
    var phi_1971_: vec3<f32>;
    var phi_2007_: vec3<f32>;
    var phi_2189_: f32;
    var phi_2207_: bool;
    var phi_2208_: bool;
    var phi_2227_: bool;
    var phi_2228_: bool;
    var phi_2234_: type_38;
    var phi_2235_: type_38;
    var phi_2236_: type_38;
    var phi_1014_: type_38;
    var phi_3372_: bool;
    var phi_3532_: bool;
    var phi_3185_: type_38;
    var phi_3186_: type_61;
    var phi_3187_: bool;
    var phi_3188_: u32;
    var phi_3531_: bool;
    var phi_3189_: type_38;
    var phi_3190_: type_61;
    var phi_3191_: u32;
    var phi_3192_: bool;
    var phi_3193_: u32;
    var phi_3530_: bool;
    var phi_3194_: type_38;
    var phi_3195_: type_61;
    var phi_3196_: u32;
    var phi_3197_: bool;
    var phi_3198_: u32;
    var phi_3529_: bool;
    var phi_887_: type_38;
    var phi_890_: type_61;
    var phi_892_: u32;
    var phi_894_: bool;
    var phi_896_: u32;
    var phi_3199_: bool;
    var phi_3528_: bool;
    var local_10: type_38;
    var phi_3251_: type_22;
    var local_11: type_38;

    switch bitcast<i32>(0u) {
        default: {
            let _e83 = global;
            let _e86 = arrayLength((&global_9.member));
            let _e101 = arrayLength((&global_8.member));
            let _e105 = global_3.member[0u][0u];
            let _e109 = global_3.member[0u][1u];
            let _e113 = global_3.member[0u][2u];
            let _e117 = global_3.member[1u][0u];
            let _e121 = global_3.member[1u][1u];
            let _e125 = global_3.member[1u][2u];
            let _e129 = global_3.member[1u][3u];
            let _e133 = (_e83.x + (_e83.y * 2097152u));
            let _e140 = (_e133 < arrayLength((&global_6.member)));
            if _e140 {
                if _e140 {
                } else {
                    break;
                }
                let _e144 = global_6.member[_e133].member_2;
                phi_270_ = _e144;
            } else {
                phi_270_ = 4294967295u;
            }
            let _e146 = phi_270_;
            let _e149 = global_1.member[0u];
            let _e153 = global_2.member[0u][0u];
            let _e157 = global_2.member[0u][1u];
            let _e161 = global_2.member[0u][2u];
            let _e165 = global_2.member[0u][3u];
            let _e169 = global_2.member[1u][0u];
            let _e173 = global_2.member[1u][1u];
            let _e177 = global_2.member[1u][2u];
            let _e181 = global_2.member[1u][3u];
            let _e182 = bitcast<f32>(_e153);
            let _e183 = bitcast<f32>(_e157);
            let _e184 = bitcast<f32>(_e161);
            let _e186 = bitcast<f32>(_e169);
            let _e187 = array<u32, 3>(_e173, _e177, _e181);
            let _e189 = bitcast<i32>(_e149);
            if (_e189 < -126i) {
                phi_314_ = -126i;
            } else {
                phi_314_ = select(_e189, 127i, (_e189 > 127i));
            }
            let _e194 = phi_314_;
            let _e199 = bitcast<f32>((bitcast<u32>((_e194 + 127i)) << bitcast<u32>(23i)));
            let _e205 = bitcast<f32>((bitcast<u32>(((_e189 - _e194) + 127i)) << bitcast<u32>(23i)));
            if (_e165 == 0u) {
                phi_338_ = type_35(array<f32, 3>(_e182, _e183, _e184), _e165, _e186, _e187);
            } else {
                phi_338_ = type_35(array<f32, 3>(((_e182 * _e199) * _e205), ((_e183 * _e199) * _e205), ((_e184 * _e199) * _e205)), _e165, ((_e186 * _e199) * _e205), _e187);
            }
            let _e218 = phi_338_;
            if _e140 {
                let _e219 = (_e133 < arrayLength((&global_7.member)));
                if _e219 {
                    if _e140 {
                    } else {
                        break;
                    }
                    let _e229 = global_6.member[_e133].member.member_2[0u];
                    let _e231 = (bitcast<u32>(_e229) & 2147483647u);
                    let _e237 = global_6.member[_e133].member.member_2[1u];
                    let _e239 = (bitcast<u32>(_e237) & 2147483647u);
                    let _e245 = global_6.member[_e133].member.member_2[2u];
                    let _e247 = (bitcast<u32>(_e245) & 2147483647u);
                    let _e253 = global_6.member[_e133].member.member[0u];
                    let _e255 = (bitcast<u32>(_e253) & 2147483647u);
                    let _e261 = global_6.member[_e133].member.member[1u];
                    let _e263 = (bitcast<u32>(_e261) & 2147483647u);
                    let _e269 = global_6.member[_e133].member.member[2u];
                    let _e271 = (bitcast<u32>(_e269) & 2147483647u);
                    let _e273 = select(_e239, _e231, (_e239 < _e231));
                    let _e275 = select(_e247, _e273, (_e247 < _e273));
                    let _e277 = select(_e255, _e275, (_e255 < _e275));
                    let _e279 = select(_e263, _e277, (_e263 < _e277));
                    let _e281 = select(_e271, _e279, (_e271 < _e279));
                    let _e286 = global_6.member[_e133].member.member_1;
                    let _e288 = (bitcast<u32>(_e286) & 2147483647u);
                    let _e296 = global_6.member[_e133].member.member_3;
                    let _e302 = (((select(_e288, _e281, (_e288 < _e281)) < 2139095040u) && ((bitcast<u32>(_e296) & 2147483647u) <= 2139095040u)) && (_e275 > 0u));
                    if _e302 {
                        let _e305 = (bitcast<u32>(bitcast<f32>(_e275)) & 2147483647u);
                        if (_e305 >= 8388608u) {
                            phi_444_ = (bitcast<i32>((_e305 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_444_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e305)), 32u, (_e305 == 0u))));
                        }
                        let _e319 = phi_444_;
                        phi_445_ = _e319;
                    } else {
                        phi_445_ = 0i;
                    }
                    let _e321 = phi_445_;
                    let _e322 = (_e231 == _e275);
                    if _e322 {
                        phi_455_ = true;
                    } else {
                        phi_455_ = (_e239 == _e275);
                    }
                    let _e325 = phi_455_;
                    let _e326 = select(1u, 0u, _e322);
                    if _e325 {
                        let _e327 = (_e326 + 1u);
                        phi_465_ = _e327;
                        phi_466_ = _e327;
                        phi_468_ = select(true, false, (_e327 == 2u));
                    } else {
                        phi_465_ = u32();
                        phi_466_ = 0u;
                        phi_468_ = true;
                    }
                    let _e331 = phi_465_;
                    let _e333 = phi_466_;
                    let _e335 = phi_468_;
                    if _e335 {
                        phi_473_ = (_e333 + 1u);
                    } else {
                        phi_473_ = 0u;
                    }
                    let _e339 = phi_473_;
                    let _e340 = select(_e331, _e333, _e335);
                    let _e341 = select(_e326, select(2u, _e326, _e325), _e335);
                    let _e342 = -(_e321);
                    if (_e342 < -126i) {
                        phi_505_ = -126i;
                    } else {
                        phi_505_ = select(_e342, 127i, (_e342 > 127i));
                    }
                    let _e347 = phi_505_;
                    let _e352 = bitcast<f32>((bitcast<u32>((_e347 + 127i)) << bitcast<u32>(23i)));
                    let _e358 = bitcast<f32>((bitcast<u32>(((_e342 - _e347) + 127i)) << bitcast<u32>(23i)));
                    let _e363 = global_6.member[_e133].member.member;
                    let _e364 = (_e340 == 0u);
                    if _e364 {
                        phi_523_ = _e363[0];
                    } else {
                        phi_523_ = _e363[1];
                    }
                    let _e368 = phi_523_;
                    let _e369 = (_e340 == 2u);
                    if _e369 {
                        phi_529_ = _e363[2];
                    } else {
                        phi_529_ = _e368;
                    }
                    let _e372 = phi_529_;
                    let _e373 = global_6.member[_e133].member.member_2;
                    if _e364 {
                        phi_540_ = _e373[0];
                    } else {
                        phi_540_ = _e373[1];
                    }
                    let _e377 = phi_540_;
                    if _e369 {
                        phi_546_ = _e373[2];
                    } else {
                        phi_546_ = _e377;
                    }
                    let _e380 = phi_546_;
                    let _e382 = ((_e380 * _e352) * _e358);
                    let _e386 = (bitcast<f32>((bitcast<u32>(_e382) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e386 {
                        let _e390 = (bitcast<f32>((bitcast<u32>(_e372) & 2147483647u)) * 0.00000011920929f);
                        phi_569_ = select(0.00000000000011368684f, _e390, (_e390 > 0.00000000000011368684f));
                    } else {
                        phi_569_ = 0f;
                    }
                    let _e394 = phi_569_;
                    let _e395 = (_e372 + _e394);
                    let _e396 = (_e372 - _e394);
                    let _e397 = select(_e382, 0f, _e386);
                    if _e386 {
                        phi_580_ = 38685626000000000000000000f;
                    } else {
                        phi_580_ = (1f / _e382);
                    }
                    let _e400 = phi_580_;
                    let _e401 = (_e339 == 0u);
                    if _e401 {
                        phi_589_ = _e363[0];
                    } else {
                        phi_589_ = _e363[1];
                    }
                    let _e405 = phi_589_;
                    let _e406 = (_e339 == 2u);
                    if _e406 {
                        phi_595_ = _e363[2];
                    } else {
                        phi_595_ = _e405;
                    }
                    let _e409 = phi_595_;
                    if _e401 {
                        phi_606_ = _e373[0];
                    } else {
                        phi_606_ = _e373[1];
                    }
                    let _e413 = phi_606_;
                    if _e406 {
                        phi_612_ = _e373[2];
                    } else {
                        phi_612_ = _e413;
                    }
                    let _e416 = phi_612_;
                    let _e418 = ((_e416 * _e352) * _e358);
                    let _e422 = (bitcast<f32>((bitcast<u32>(_e418) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e422 {
                        let _e426 = (bitcast<f32>((bitcast<u32>(_e409) & 2147483647u)) * 0.00000011920929f);
                        phi_635_ = select(0.00000000000011368684f, _e426, (_e426 > 0.00000000000011368684f));
                    } else {
                        phi_635_ = 0f;
                    }
                    let _e430 = phi_635_;
                    let _e431 = (_e409 + _e430);
                    let _e432 = (_e409 - _e430);
                    let _e433 = select(_e418, 0f, _e422);
                    if _e422 {
                        phi_646_ = 38685626000000000000000000f;
                    } else {
                        phi_646_ = (1f / _e418);
                    }
                    let _e436 = phi_646_;
                    let _e437 = (_e341 == 0u);
                    if _e437 {
                        phi_655_ = _e363[0];
                    } else {
                        phi_655_ = _e363[1];
                    }
                    let _e441 = phi_655_;
                    let _e442 = (_e341 == 2u);
                    if _e442 {
                        phi_661_ = _e363[2];
                    } else {
                        phi_661_ = _e441;
                    }
                    let _e445 = phi_661_;
                    if _e437 {
                        phi_672_ = _e373[0];
                    } else {
                        phi_672_ = _e373[1];
                    }
                    let _e449 = phi_672_;
                    if _e442 {
                        phi_678_ = _e373[2];
                    } else {
                        phi_678_ = _e449;
                    }
                    let _e452 = phi_678_;
                    let _e454 = ((_e452 * _e352) * _e358);
                    let _e458 = (bitcast<f32>((bitcast<u32>(_e454) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e458 {
                        let _e462 = (bitcast<f32>((bitcast<u32>(_e445) & 2147483647u)) * 0.00000011920929f);
                        phi_701_ = select(0.00000000000011368684f, _e462, (_e462 > 0.00000000000011368684f));
                    } else {
                        phi_701_ = 0f;
                    }
                    let _e466 = phi_701_;
                    let _e467 = (_e445 + _e466);
                    let _e468 = (_e445 - _e466);
                    let _e469 = select(_e454, 0f, _e458);
                    if _e458 {
                        phi_712_ = 38685626000000000000000000f;
                    } else {
                        phi_712_ = (1f / _e454);
                    }
                    let _e472 = phi_712_;
                    let _e475 = bitcast<f32>((bitcast<u32>(_e372) & 2147483647u));
                    let _e478 = bitcast<f32>((bitcast<u32>(_e409) & 2147483647u));
                    let _e480 = select(_e478, _e475, (_e475 > _e478));
                    let _e483 = bitcast<f32>((bitcast<u32>(_e445) & 2147483647u));
                    if (_e302 && (select(_e483, _e480, (_e480 > _e483)) <= 1099511600000f)) {
                        let _e488 = (_e321 / 3i);
                        let _e495 = bitcast<f32>((bitcast<u32>((_e488 + 127i)) << bitcast<u32>(23i)));
                        let _e502 = bitcast<f32>((bitcast<u32>(((_e321 - (2i * _e488)) + 127i)) << bitcast<u32>(23i)));
                        let _e503 = (((_e286 * _e495) * _e495) * _e502);
                        let _e505 = select(340282350000000000000000000000000000000f, _e503, (_e503 < 340282350000000000000000000000000000000f));
                        let _e510 = (((_e296 * _e495) * _e495) * _e502);
                        let _e512 = select(340282350000000000000000000000000000000f, _e510, (_e510 < 340282350000000000000000000000000000000f));
                        phi_812_ = select(-340282350000000000000000000000000000000f, _e512, (_e512 > -340282350000000000000000000000000000000f));
                        phi_813_ = select(-340282350000000000000000000000000000000f, _e505, (_e505 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_812_ = 0f;
                        phi_813_ = 1f;
                    }
                    let _e516 = phi_812_;
                    let _e518 = phi_813_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e105), bitcast<f32>(_e109), bitcast<f32>(_e113));
                    let _e523 = (_e340 % 3u);
                    let _e524 = (_e523 < 3u);
                    if _e524 {
                    } else {
                        break;
                    }
                    let _e526 = local_9[_e523];
                    let _e527 = (_e339 % 3u);
                    let _e528 = (_e527 < 3u);
                    if _e528 {
                    } else {
                        break;
                    }
                    let _e530 = local_9[_e527];
                    let _e531 = (_e341 % 3u);
                    let _e532 = (_e531 < 3u);
                    if _e532 {
                    } else {
                        break;
                    }
                    let _e534 = local_9[_e531];
                    local_8 = array<f32, 3>(bitcast<f32>(_e117), bitcast<f32>(_e121), bitcast<f32>(_e125));
                    if _e524 {
                    } else {
                        break;
                    }
                    let _e538 = local_8[_e523];
                    if _e528 {
                    } else {
                        break;
                    }
                    let _e540 = local_8[_e527];
                    if _e532 {
                    } else {
                        break;
                    }
                    let _e542 = local_8[_e531];
                    phi_3378_ = false;
                    phi_886_ = type_38(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e516);
                    phi_889_ = type_61(type_53(array<f32, 3>(_e526, _e530, _e534), array<f32, 3>(_e538, _e540, _e542)), select(0u, 2147483648u, (_e86 == 0u)));
                    phi_891_ = ((3u * _e86) + 1u);
                    phi_893_ = (_e518 <= _e516);
                    phi_895_ = 0u;
                    loop {
                        let _e550 = phi_3378_;
                        let _e552 = phi_886_;
                        let _e554 = phi_889_;
                        let _e556 = phi_891_;
                        let _e558 = phi_893_;
                        let _e560 = phi_895_;
                        local_10 = _e552;
                        if _e558 {
                            phi_906_ = true;
                        } else {
                            phi_906_ = (_e560 > 0u);
                        }
                        let _e563 = phi_906_;
                        if _e563 {
                            let _e564 = (_e556 > 0u);
                            if _e564 {
                                if _e558 {
                                    phi_992_ = _e554;
                                    phi_993_ = _e558;
                                    phi_994_ = _e560;
                                } else {
                                    let _e565 = (_e560 - 1u);
                                    let _e566 = (_e565 % 128u);
                                    let _e567 = (_e566 < 128u);
                                    if _e567 {
                                    } else {
                                        phi_3528_ = true;
                                        break;
                                    }
                                    let _e569 = local_6[_e566];
                                    if _e567 {
                                    } else {
                                        phi_3528_ = true;
                                        break;
                                    }
                                    let _e571 = local_5[_e566];
                                    if _e567 {
                                    } else {
                                        phi_3528_ = true;
                                        break;
                                    }
                                    let _e573 = local_4[_e566];
                                    if _e567 {
                                    } else {
                                        phi_3528_ = true;
                                        break;
                                    }
                                    let _e575 = local_3[_e566];
                                    if _e567 {
                                    } else {
                                        phi_3528_ = true;
                                        break;
                                    }
                                    let _e578 = local_2[_e566];
                                    if _e567 {
                                    } else {
                                        phi_3528_ = true;
                                        break;
                                    }
                                    let _e580 = local_1[_e566];
                                    if _e567 {
                                    } else {
                                        phi_3528_ = true;
                                        break;
                                    }
                                    let _e582 = local[_e566];
                                    if _e567 {
                                    } else {
                                        phi_3528_ = true;
                                        break;
                                    }
                                    let _e587 = local_7[_e566];
                                    phi_992_ = type_61(type_53(array<f32, 3>(_e571, _e573, _e575), array<f32, 3>(_e578, _e580, _e582)), _e569);
                                    phi_993_ = (_e587 <= _e552.member_1);
                                    phi_994_ = _e565;
                                }
                                let _e591 = phi_992_;
                                let _e593 = phi_993_;
                                let _e595 = phi_994_;
                                if _e593 {
                                    if ((_e591.member_1 & 2147483648u) != 0u) {
                                        phi_1013_ = _e552;
                                        phi_1016_ = type_8(0u, ((_e591.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e948 = phi_1013_;
                                            let _e950 = phi_1016_;
                                            local_11 = _e948;
                                            if (_e950.member < _e950.member_1) {
                                                phi_1017_ = type_8((_e950.member + 1u), _e950.member_1);
                                                phi_1039_ = type_8(1u, _e950.member);
                                            } else {
                                                phi_1017_ = _e950;
                                                phi_1039_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e963 = phi_1017_;
                                            let _e965 = phi_1039_;
                                            let _e969 = (bitcast<i32>(_e965.member) != 0i);
                                            if _e969 {
                                                let _e970 = ((_e591.member_1 & 268435455u) + _e965.member_1);
                                                let _e971 = (_e970 < arrayLength((&global_10.member)));
                                                if _e971 {
                                                    if _e971 {
                                                    } else {
                                                        phi_3372_ = true;
                                                        break;
                                                    }
                                                    let _e974 = global_10.member[_e970].member_1;
                                                    phi_1064_ = _e974;
                                                } else {
                                                    phi_1064_ = 4294967295u;
                                                }
                                                let _e976 = phi_1064_;
                                                if _e971 {
                                                    if _e971 {
                                                    } else {
                                                        phi_3372_ = true;
                                                        break;
                                                    }
                                                    let _e978 = global_10.member[_e970];
                                                    phi_1080_ = _e978;
                                                } else {
                                                    phi_1080_ = type_55(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e980 = phi_1080_;
                                                let _e992 = ((10u * _e340) & 31u);
                                                let _e995 = ((_e980.member[0] >> bitcast<u32>(_e992)) & 1023u);
                                                let _e1000 = bitcast<f32>((bitcast<u32>(((_e591.member.member_1[0] - _e591.member.member[0]) * 0.0009775171f)) ^ _e129));
                                                let _e1006 = (_e591.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e995) * _e1000)) ^ _e129)));
                                                let _e1010 = select(select(_e591.member.member_1[0], _e1006, (_e1006 < _e591.member.member_1[0])), _e591.member.member_1[0], (_e995 == 1023u));
                                                let _e1012 = ((10u * _e339) & 31u);
                                                let _e1015 = ((_e980.member[0] >> bitcast<u32>(_e1012)) & 1023u);
                                                let _e1020 = bitcast<f32>((bitcast<u32>(((_e591.member.member_1[1] - _e591.member.member[1]) * 0.0009775171f)) ^ _e129));
                                                let _e1026 = (_e591.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1015) * _e1020)) ^ _e129)));
                                                let _e1030 = select(select(_e591.member.member_1[1], _e1026, (_e1026 < _e591.member.member_1[1])), _e591.member.member_1[1], (_e1015 == 1023u));
                                                let _e1032 = ((10u * _e341) & 31u);
                                                let _e1035 = ((_e980.member[0] >> bitcast<u32>(_e1032)) & 1023u);
                                                let _e1040 = bitcast<f32>((bitcast<u32>(((_e591.member.member_1[2] - _e591.member.member[2]) * 0.0009775171f)) ^ _e129));
                                                let _e1046 = (_e591.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1035) * _e1040)) ^ _e129)));
                                                let _e1050 = select(select(_e591.member.member_1[2], _e1046, (_e1046 < _e591.member.member_1[2])), _e591.member.member_1[2], (_e1035 == 1023u));
                                                let _e1054 = ((_e980.member[1] >> bitcast<u32>(_e992)) & 1023u);
                                                let _e1060 = (_e591.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1054) * _e1000)) ^ _e129)));
                                                let _e1064 = select(select(_e591.member.member_1[0], _e1060, (_e1060 < _e591.member.member_1[0])), _e591.member.member_1[0], (_e1054 == 1023u));
                                                let _e1067 = ((_e980.member[1] >> bitcast<u32>(_e1012)) & 1023u);
                                                let _e1073 = (_e591.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1067) * _e1020)) ^ _e129)));
                                                let _e1077 = select(select(_e591.member.member_1[1], _e1073, (_e1073 < _e591.member.member_1[1])), _e591.member.member_1[1], (_e1067 == 1023u));
                                                let _e1080 = ((_e980.member[1] >> bitcast<u32>(_e1032)) & 1023u);
                                                let _e1086 = (_e591.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1080) * _e1040)) ^ _e129)));
                                                let _e1090 = select(select(_e591.member.member_1[2], _e1086, (_e1086 < _e591.member.member_1[2])), _e591.member.member_1[2], (_e1080 == 1023u));
                                                let _e1094 = ((_e980.member[2] >> bitcast<u32>(_e992)) & 1023u);
                                                let _e1100 = (_e591.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1094) * _e1000)) ^ _e129)));
                                                let _e1104 = select(select(_e591.member.member_1[0], _e1100, (_e1100 < _e591.member.member_1[0])), _e591.member.member_1[0], (_e1094 == 1023u));
                                                let _e1107 = ((_e980.member[2] >> bitcast<u32>(_e1012)) & 1023u);
                                                let _e1113 = (_e591.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1107) * _e1020)) ^ _e129)));
                                                let _e1117 = select(select(_e591.member.member_1[1], _e1113, (_e1113 < _e591.member.member_1[1])), _e591.member.member_1[1], (_e1107 == 1023u));
                                                let _e1120 = ((_e980.member[2] >> bitcast<u32>(_e1032)) & 1023u);
                                                let _e1126 = (_e591.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1120) * _e1040)) ^ _e129)));
                                                let _e1130 = select(select(_e591.member.member_1[2], _e1126, (_e1126 < _e591.member.member_1[2])), _e591.member.member_1[2], (_e1120 == 1023u));
                                                let _e1134 = (_e1050 - _e445);
                                                let _e1137 = (((_e1010 - _e372) * _e469) - (_e1134 * _e397));
                                                let _e1140 = (((_e1030 - _e409) * _e469) - (_e1134 * _e433));
                                                let _e1143 = (_e1090 - _e445);
                                                let _e1146 = (((_e1064 - _e372) * _e469) - (_e1143 * _e397));
                                                let _e1149 = (((_e1077 - _e409) * _e469) - (_e1143 * _e433));
                                                let _e1152 = (_e1130 - _e445);
                                                let _e1155 = (((_e1104 - _e372) * _e469) - (_e1152 * _e397));
                                                let _e1158 = (((_e1117 - _e409) * _e469) - (_e1152 * _e433));
                                                let _e1159 = (_e1155 * _e1149);
                                                let _e1160 = (_e1158 * _e1146);
                                                let _e1161 = (_e1137 * _e1158);
                                                let _e1162 = (_e1140 * _e1155);
                                                let _e1163 = (_e1146 * _e1140);
                                                let _e1164 = (_e1149 * _e1137);
                                                let _e1169 = (((_e1159 >= _e1160) && (_e1161 >= _e1162)) && (_e1163 >= _e1164));
                                                if (_e1169 || (((_e1159 <= _e1160) && (_e1161 <= _e1162)) && (_e1163 <= _e1164))) {
                                                    let _e1176 = select(-1f, 1f, _e1169);
                                                    let _e1178 = ((_e1159 - _e1160) * _e1176);
                                                    let _e1180 = select(0f, _e1178, (_e1178 > 0f));
                                                    let _e1182 = ((_e1161 - _e1162) * _e1176);
                                                    let _e1184 = select(0f, _e1182, (_e1182 > 0f));
                                                    let _e1186 = ((_e1163 - _e1164) * _e1176);
                                                    let _e1188 = select(0f, _e1186, (_e1186 > 0f));
                                                    let _e1190 = ((_e1180 + _e1184) + _e1188);
                                                    if (_e1190 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1881_ = type_22();
                                                        phi_1882_ = true;
                                                    } else {
                                                        let _e1193 = select(_e1064, _e1010, (_e1010 < _e1064));
                                                        let _e1197 = select(_e1064, _e1010, (_e1010 > _e1064));
                                                        let _e1201 = select(_e1077, _e1030, (_e1030 < _e1077));
                                                        let _e1205 = select(_e1077, _e1030, (_e1030 > _e1077));
                                                        let _e1209 = select(_e1090, _e1050, (_e1050 < _e1090));
                                                        let _e1213 = select(_e1090, _e1050, (_e1050 > _e1090));
                                                        let _e1218 = ((select(_e1104, _e1193, (_e1193 < _e1104)) - _e395) * _e400);
                                                        let _e1219 = ((select(_e1104, _e1197, (_e1197 > _e1104)) - _e396) * _e400);
                                                        let _e1222 = ((select(_e1117, _e1201, (_e1201 < _e1117)) - _e431) * _e436);
                                                        let _e1223 = ((select(_e1117, _e1205, (_e1205 > _e1117)) - _e432) * _e436);
                                                        let _e1226 = ((select(_e1130, _e1209, (_e1209 < _e1130)) - _e467) * _e472);
                                                        let _e1227 = ((select(_e1130, _e1213, (_e1213 > _e1130)) - _e468) * _e472);
                                                        let _e1229 = select(_e1227, _e1226, (_e1226 < _e1227));
                                                        let _e1231 = select(_e1227, _e1226, (_e1226 > _e1227));
                                                        let _e1233 = select(_e1219, _e1218, (_e1218 < _e1219));
                                                        let _e1235 = select(_e1223, _e1222, (_e1222 < _e1223));
                                                        let _e1237 = select(_e1235, _e1233, (_e1233 > _e1235));
                                                        let _e1239 = select(_e1229, _e1237, (_e1237 > _e1229));
                                                        let _e1241 = select(_e1219, _e1218, (_e1218 > _e1219));
                                                        let _e1243 = select(_e1223, _e1222, (_e1222 > _e1223));
                                                        let _e1245 = select(_e1243, _e1241, (_e1241 < _e1243));
                                                        let _e1247 = select(_e1231, _e1245, (_e1245 < _e1231));
                                                        let _e1248 = -(_e1229);
                                                        let _e1254 = select(_e518, _e1239, (_e1239 > _e518));
                                                        if (_e1254 > (_e1247 + (select(_e1248, _e1231, (_e1231 > _e1248)) * 0.0000019073523f))) {
                                                            phi_1876_ = type_22();
                                                            phi_1877_ = true;
                                                        } else {
                                                            let _e1256 = (_e1254 > _e948.member_1);
                                                            if _e1256 {
                                                                phi_1875_ = type_22();
                                                            } else {
                                                                let _e1260 = (_e1064 - _e1010);
                                                                let _e1261 = (_e1077 - _e1030);
                                                                let _e1262 = (_e1090 - _e1050);
                                                                let _e1263 = vec3<f32>(_e1260, _e1261, _e1262);
                                                                let _e1264 = (_e1104 - _e1064);
                                                                let _e1265 = (_e1117 - _e1077);
                                                                let _e1266 = (_e1130 - _e1090);
                                                                let _e1267 = vec3<f32>(_e1264, _e1265, _e1266);
                                                                let _e1268 = (_e1010 - _e1104);
                                                                let _e1269 = (_e1030 - _e1117);
                                                                let _e1270 = (_e1050 - _e1130);
                                                                let _e1271 = vec3<f32>(_e1268, _e1269, _e1270);
                                                                let _e1274 = bitcast<f32>((bitcast<u32>(_e1260) & 2147483647u));
                                                                let _e1277 = bitcast<f32>((bitcast<u32>(_e1261) & 2147483647u));
                                                                let _e1279 = select(_e1277, _e1274, (_e1274 > _e1277));
                                                                let _e1282 = bitcast<f32>((bitcast<u32>(_e1262) & 2147483647u));
                                                                let _e1284 = select(_e1282, _e1279, (_e1279 > _e1282));
                                                                let _e1287 = bitcast<f32>((bitcast<u32>(_e1264) & 2147483647u));
                                                                let _e1290 = bitcast<f32>((bitcast<u32>(_e1265) & 2147483647u));
                                                                let _e1292 = select(_e1290, _e1287, (_e1287 > _e1290));
                                                                let _e1295 = bitcast<f32>((bitcast<u32>(_e1266) & 2147483647u));
                                                                let _e1297 = select(_e1295, _e1292, (_e1292 > _e1295));
                                                                let _e1300 = bitcast<f32>((bitcast<u32>(_e1268) & 2147483647u));
                                                                let _e1303 = bitcast<f32>((bitcast<u32>(_e1269) & 2147483647u));
                                                                let _e1305 = select(_e1303, _e1300, (_e1300 > _e1303));
                                                                let _e1308 = bitcast<f32>((bitcast<u32>(_e1270) & 2147483647u));
                                                                let _e1310 = select(_e1308, _e1305, (_e1305 > _e1308));
                                                                let _e1312 = select(_e1297, _e1284, (_e1284 > _e1297));
                                                                let _e1314 = select(_e1310, _e1312, (_e1312 > _e1310));
                                                                if (_e1284 == _e1314) {
                                                                    phi_1786_ = _e1267;
                                                                    phi_1787_ = _e1271;
                                                                } else {
                                                                    let _e1317 = vec3((_e1297 == _e1314));
                                                                    phi_1786_ = select(_e1263, _e1271, _e1317);
                                                                    phi_1787_ = select(_e1267, _e1263, _e1317);
                                                                }
                                                                let _e1321 = phi_1786_;
                                                                let _e1323 = phi_1787_;
                                                                let _e1330 = ((_e1321.y * _e1323.z) - (_e1323.y * _e1321.z));
                                                                let _e1335 = ((_e1321.z * _e1323.x) - (_e1323.z * _e1321.x));
                                                                let _e1338 = ((_e1321.x * _e1323.y) - (_e1323.x * _e1321.y));
                                                                if (_e1180 >= _e1184) {
                                                                    phi_1818_ = select(true, false, (_e1180 >= _e1188));
                                                                } else {
                                                                    phi_1818_ = true;
                                                                }
                                                                let _e1343 = phi_1818_;
                                                                if _e1343 {
                                                                    phi_1827_ = select(vec3<f32>(_e1104, _e1117, _e1130), vec3<f32>(_e1064, _e1077, _e1090), vec3((_e1184 >= _e1188)));
                                                                } else {
                                                                    phi_1827_ = vec3<f32>(_e1010, _e1030, _e1050);
                                                                }
                                                                let _e1348 = phi_1827_;
                                                                let _e1365 = ((((_e1330 * (_e1348.x - _e372)) + (_e1335 * (_e1348.y - _e409))) + (_e1338 * (_e1348.z - _e445))) / (((_e1330 * _e397) + (_e1335 * _e433)) + (_e1338 * _e469)));
                                                                let _e1367 = select(_e1247, _e1365, (_e1365 < _e1247));
                                                                let _e1369 = select(_e1239, _e1367, (_e1367 > _e1239));
                                                                if (_e1369 >= _e518) {
                                                                    let _e1371 = (_e1369 <= _e948.member_1);
                                                                    if _e1371 {
                                                                        let _e1372 = (1f / _e1190);
                                                                        phi_1867_ = type_22(_e1369, (_e1184 * _e1372), (_e1188 * _e1372), _e976);
                                                                    } else {
                                                                        phi_1867_ = type_22();
                                                                    }
                                                                    let _e1377 = phi_1867_;
                                                                    phi_1869_ = _e1377;
                                                                    phi_1870_ = select(true, false, _e1371);
                                                                } else {
                                                                    phi_1869_ = type_22();
                                                                    phi_1870_ = true;
                                                                }
                                                                let _e1380 = phi_1869_;
                                                                let _e1382 = phi_1870_;
                                                                if _e1382 {
                                                                    phi_1874_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1874_ = _e1380;
                                                                }
                                                                let _e1384 = phi_1874_;
                                                                phi_1875_ = _e1384;
                                                            }
                                                            let _e1386 = phi_1875_;
                                                            phi_1876_ = _e1386;
                                                            phi_1877_ = _e1256;
                                                        }
                                                        let _e1388 = phi_1876_;
                                                        let _e1390 = phi_1877_;
                                                        phi_1881_ = _e1388;
                                                        phi_1882_ = _e1390;
                                                    }
                                                    let _e1392 = phi_1881_;
                                                    let _e1394 = phi_1882_;
                                                    phi_1886_ = _e1392;
                                                    phi_1887_ = _e1394;
                                                } else {
                                                    phi_1886_ = type_22();
                                                    phi_1887_ = true;
                                                }
                                                let _e1396 = phi_1886_;
                                                let _e1398 = phi_1887_;
                                                if _e1398 {
                                                    phi_1891_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1891_ = _e1396;
                                                }
                                                let _e1400 = phi_1891_;
                                                if (_e1400.member_3 != 4294967295u) {
                                                    if (_e976 == _e146) {
                                                        phi_2208_ = false;
                                                    } else {
                                                        let _e1404 = (_e976 < arrayLength((&global_4.member)));
                                                        if _e1404 {
                                                            if _e1404 {
                                                            } else {
                                                                phi_3372_ = true;
                                                                break;
                                                            }
                                                            let _e1406 = global_4.member[_e976];
                                                            phi_1914_ = _e1406;
                                                        } else {
                                                            phi_1914_ = 4294967295u;
                                                        }
                                                        let _e1408 = phi_1914_;
                                                        let _e1409 = (_e1408 < arrayLength((&global_5.member)));
                                                        if _e1409 {
                                                            if _e1409 {
                                                            } else {
                                                                phi_3372_ = true;
                                                                break;
                                                            }
                                                            let _e1411 = global_5.member[_e1408];
                                                            phi_1928_ = _e1411;
                                                        } else {
                                                            phi_1928_ = 0i;
                                                        }
                                                        let _e1413 = phi_1928_;
                                                        let _e1414 = (_e1413 == 0i);
                                                        if _e1414 {
                                                            phi_2207_ = true;
                                                        } else {
                                                            if _e364 {
                                                                phi_1945_ = vec3<f32>(_e1010, _e1030, _e1050);
                                                            } else {
                                                                if (_e340 == 1u) {
                                                                    phi_1944_ = vec3<f32>(_e1050, _e1010, _e1030);
                                                                } else {
                                                                    phi_1944_ = vec3<f32>(_e1030, _e1050, _e1010);
                                                                }
                                                                let _e1419 = phi_1944_;
                                                                phi_1945_ = _e1419;
                                                            }
                                                            let _e1422 = phi_1945_;
                                                            if _e364 {
                                                                phi_1958_ = vec3<f32>(_e1064, _e1077, _e1090);
                                                            } else {
                                                                if (_e340 == 1u) {
                                                                    phi_1957_ = vec3<f32>(_e1090, _e1064, _e1077);
                                                                } else {
                                                                    phi_1957_ = vec3<f32>(_e1077, _e1090, _e1064);
                                                                }
                                                                let _e1427 = phi_1957_;
                                                                phi_1958_ = _e1427;
                                                            }
                                                            let _e1430 = phi_1958_;
                                                            if _e364 {
                                                                phi_1971_ = vec3<f32>(_e1104, _e1117, _e1130);
                                                            } else {
                                                                if (_e340 == 1u) {
                                                                    phi_1970_ = vec3<f32>(_e1130, _e1104, _e1117);
                                                                } else {
                                                                    phi_1970_ = vec3<f32>(_e1117, _e1130, _e1104);
                                                                }
                                                                let _e1435 = phi_1970_;
                                                                phi_1971_ = _e1435;
                                                            }
                                                            let _e1438 = phi_1971_;
                                                            let _e1441 = (_e1430.x - _e1422.x);
                                                            let _e1444 = (_e1430.y - _e1422.y);
                                                            let _e1447 = (_e1430.z - _e1422.z);
                                                            let _e1449 = (_e1438.x - _e1422.x);
                                                            let _e1451 = (_e1438.y - _e1422.y);
                                                            let _e1453 = (_e1438.z - _e1422.z);
                                                            if (_e218.member_1 == 1u) {
                                                                phi_2007_ = (vec3<f32>(_e218.member[0], _e218.member[1], _e218.member[2]) - _e1422);
                                                            } else {
                                                                phi_2007_ = vec3<f32>(_e218.member[0], _e218.member[1], _e218.member[2]);
                                                            }
                                                            let _e1468 = phi_2007_;
                                                            let _e1474 = bitcast<f32>((bitcast<u32>((_e1441 * _e1451)) ^ _e218.member_3[0]));
                                                            let _e1478 = bitcast<f32>((bitcast<u32>((_e1444 * _e1449)) ^ _e218.member_3[0]));
                                                            let _e1482 = bitcast<f32>((bitcast<u32>((_e1444 * _e1453)) ^ _e218.member_3[0]));
                                                            let _e1486 = bitcast<f32>((bitcast<u32>((_e1447 * _e1451)) ^ _e218.member_3[0]));
                                                            let _e1490 = bitcast<f32>((bitcast<u32>((_e1447 * _e1449)) ^ _e218.member_3[0]));
                                                            let _e1494 = bitcast<f32>((bitcast<u32>((_e1441 * _e1453)) ^ _e218.member_3[0]));
                                                            let _e1495 = (_e1482 - _e1486);
                                                            let _e1496 = (_e1490 - _e1494);
                                                            let _e1497 = (_e1474 - _e1478);
                                                            let _e1521 = (bitcast<f32>((bitcast<u32>(_e1482) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1486) & 2147483647u)));
                                                            let _e1528 = (bitcast<f32>((bitcast<u32>(_e1490) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1494) & 2147483647u)));
                                                            let _e1535 = (bitcast<f32>((bitcast<u32>(_e1474) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1478) & 2147483647u)));
                                                            if (_e218.member_2 == 0f) {
                                                                phi_2189_ = 0f;
                                                            } else {
                                                                let _e1565 = bitcast<f32>((bitcast<u32>(_e1495) & 2147483647u));
                                                                let _e1568 = bitcast<f32>((bitcast<u32>(_e1496) & 2147483647u));
                                                                let _e1571 = bitcast<f32>((bitcast<u32>(_e1497) & 2147483647u));
                                                                let _e1573 = select(_e1571, _e1568, (_e1568 > _e1571));
                                                                let _e1577 = select(_e1571, _e1568, (_e1568 < _e1571));
                                                                let _e1581 = select(_e1568, _e1565, (_e1565 < _e1568));
                                                                let _e1583 = select(_e1568, _e1565, (_e1565 > _e1568));
                                                                let _e1585 = select(_e1571, _e1583, (_e1583 < _e1571));
                                                                phi_2189_ = bitcast<f32>((bitcast<u32>((_e218.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1573, _e1565, (_e1565 > _e1573)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1585, _e1581, (_e1581 > _e1585)))) ^ _e218.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1577, _e1565, (_e1565 < _e1577)))) ^ _e218.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1521 + _e1528) + _e1535))) ^ _e218.member_3[0]))) * 1.0000005f)) ^ _e218.member_3[0])))) ^ _e218.member_3[0]));
                                                            }
                                                            let _e1612 = phi_2189_;
                                                            phi_2207_ = (_e1414 || !(((((bitcast<f32>((bitcast<u32>((_e1468.x * _e1495)) ^ _e218.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1468.y * _e1496)) ^ _e218.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1468.z * _e1497)) ^ _e218.member_3[0]))) * f32(-(_e1413))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1468.x) & 2147483647u)) * _e1521)) ^ _e218.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1468.y) & 2147483647u)) * _e1528)) ^ _e218.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1468.z) & 2147483647u)) * _e1535)) ^ _e218.member_3[0]))))) ^ _e218.member_3[0])) + _e1612) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1626 = phi_2207_;
                                                        phi_2208_ = _e1626;
                                                    }
                                                    let _e1628 = phi_2208_;
                                                    if _e1628 {
                                                        if (_e1400.member < _e948.member.member) {
                                                            phi_2228_ = true;
                                                        } else {
                                                            if (_e1400.member == _e948.member.member) {
                                                                phi_2227_ = (_e1400.member_3 < _e948.member.member_3);
                                                            } else {
                                                                phi_2227_ = false;
                                                            }
                                                            let _e1638 = phi_2227_;
                                                            phi_2228_ = _e1638;
                                                        }
                                                        let _e1640 = phi_2228_;
                                                        if _e1640 {
                                                            phi_2234_ = type_38(_e1400, _e1400.member);
                                                        } else {
                                                            phi_2234_ = _e948;
                                                        }
                                                        let _e1643 = phi_2234_;
                                                        phi_2235_ = _e1643;
                                                    } else {
                                                        phi_2235_ = _e948;
                                                    }
                                                    let _e1645 = phi_2235_;
                                                    phi_2236_ = _e1645;
                                                } else {
                                                    phi_2236_ = _e948;
                                                }
                                                let _e1647 = phi_2236_;
                                                phi_1014_ = _e1647;
                                            } else {
                                                phi_1014_ = type_38();
                                            }
                                            let _e1649 = phi_1014_;
                                            continue;
                                            continuing {
                                                phi_1013_ = _e1649;
                                                phi_1016_ = _e963;
                                                phi_3372_ = _e550;
                                                break if !(_e969);
                                            }
                                        }
                                        let _e1652 = phi_3372_;
                                        phi_3528_ = _e1652;
                                        if _e1652 {
                                            break;
                                        }
                                        phi_3532_ = _e1652;
                                        let _e1860 = local_11;
                                        phi_3185_ = _e1860;
                                        phi_3186_ = _e591;
                                        phi_3187_ = false;
                                        phi_3188_ = _e595;
                                    } else {
                                        let _e605 = (_e591.member_1 < _e86);
                                        if _e605 {
                                            if _e605 {
                                            } else {
                                                phi_3528_ = true;
                                                break;
                                            }
                                            let _e607 = global_9.member[_e591.member_1];
                                            phi_2255_ = _e607;
                                        } else {
                                            phi_2255_ = type_48(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e609 = phi_2255_;
                                        let _e624 = ((10u * _e340) & 31u);
                                        let _e627 = ((_e609.member[0] >> bitcast<u32>(_e624)) & 1023u);
                                        let _e632 = bitcast<f32>((bitcast<u32>(((_e591.member.member_1[0] - _e591.member.member[0]) * 0.0009775171f)) ^ _e129));
                                        let _e638 = (_e591.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e627) * _e632)) ^ _e129)));
                                        let _e642 = select(select(_e591.member.member_1[0], _e638, (_e638 < _e591.member.member_1[0])), _e591.member.member_1[0], (_e627 == 1023u));
                                        let _e644 = ((10u * _e339) & 31u);
                                        let _e647 = ((_e609.member[0] >> bitcast<u32>(_e644)) & 1023u);
                                        let _e652 = bitcast<f32>((bitcast<u32>(((_e591.member.member_1[1] - _e591.member.member[1]) * 0.0009775171f)) ^ _e129));
                                        let _e658 = (_e591.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e647) * _e652)) ^ _e129)));
                                        let _e662 = select(select(_e591.member.member_1[1], _e658, (_e658 < _e591.member.member_1[1])), _e591.member.member_1[1], (_e647 == 1023u));
                                        let _e664 = ((10u * _e341) & 31u);
                                        let _e667 = ((_e609.member[0] >> bitcast<u32>(_e664)) & 1023u);
                                        let _e672 = bitcast<f32>((bitcast<u32>(((_e591.member.member_1[2] - _e591.member.member[2]) * 0.0009775171f)) ^ _e129));
                                        let _e678 = (_e591.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e667) * _e672)) ^ _e129)));
                                        let _e682 = select(select(_e591.member.member_1[2], _e678, (_e678 < _e591.member.member_1[2])), _e591.member.member_1[2], (_e667 == 1023u));
                                        let _e685 = ((_e609.member[1] >> bitcast<u32>(_e624)) & 1023u);
                                        let _e691 = (_e591.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e685) * _e632)) ^ _e129)));
                                        let _e695 = select(select(_e591.member.member_1[0], _e691, (_e691 < _e591.member.member_1[0])), _e591.member.member_1[0], (_e685 == 1023u));
                                        let _e698 = ((_e609.member[1] >> bitcast<u32>(_e644)) & 1023u);
                                        let _e704 = (_e591.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e698) * _e652)) ^ _e129)));
                                        let _e708 = select(select(_e591.member.member_1[1], _e704, (_e704 < _e591.member.member_1[1])), _e591.member.member_1[1], (_e698 == 1023u));
                                        let _e711 = ((_e609.member[1] >> bitcast<u32>(_e664)) & 1023u);
                                        let _e717 = (_e591.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e711) * _e672)) ^ _e129)));
                                        let _e721 = select(select(_e591.member.member_1[2], _e717, (_e717 < _e591.member.member_1[2])), _e591.member.member_1[2], (_e711 == 1023u));
                                        let _e727 = ((_e609.member_1[0] >> bitcast<u32>(_e624)) & 1023u);
                                        let _e733 = (_e591.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e727) * _e632)) ^ _e129)));
                                        let _e737 = select(select(_e591.member.member_1[0], _e733, (_e733 < _e591.member.member_1[0])), _e591.member.member_1[0], (_e727 == 1023u));
                                        let _e740 = ((_e609.member_1[0] >> bitcast<u32>(_e644)) & 1023u);
                                        let _e746 = (_e591.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e740) * _e652)) ^ _e129)));
                                        let _e750 = select(select(_e591.member.member_1[1], _e746, (_e746 < _e591.member.member_1[1])), _e591.member.member_1[1], (_e740 == 1023u));
                                        let _e753 = ((_e609.member_1[0] >> bitcast<u32>(_e664)) & 1023u);
                                        let _e759 = (_e591.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e753) * _e672)) ^ _e129)));
                                        let _e763 = select(select(_e591.member.member_1[2], _e759, (_e759 < _e591.member.member_1[2])), _e591.member.member_1[2], (_e753 == 1023u));
                                        let _e766 = ((_e609.member_1[1] >> bitcast<u32>(_e624)) & 1023u);
                                        let _e772 = (_e591.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e766) * _e632)) ^ _e129)));
                                        let _e776 = select(select(_e591.member.member_1[0], _e772, (_e772 < _e591.member.member_1[0])), _e591.member.member_1[0], (_e766 == 1023u));
                                        let _e779 = ((_e609.member_1[1] >> bitcast<u32>(_e644)) & 1023u);
                                        let _e785 = (_e591.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e779) * _e652)) ^ _e129)));
                                        let _e789 = select(select(_e591.member.member_1[1], _e785, (_e785 < _e591.member.member_1[1])), _e591.member.member_1[1], (_e779 == 1023u));
                                        let _e792 = ((_e609.member_1[1] >> bitcast<u32>(_e664)) & 1023u);
                                        let _e798 = (_e591.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e792) * _e672)) ^ _e129)));
                                        let _e802 = select(select(_e591.member.member_1[2], _e798, (_e798 < _e591.member.member_1[2])), _e591.member.member_1[2], (_e792 == 1023u));
                                        let _e807 = type_61(type_53(array<f32, 3>(_e642, _e662, _e682), array<f32, 3>(_e695, _e708, _e721)), _e609.member_2);
                                        let _e812 = type_61(type_53(array<f32, 3>(_e737, _e750, _e763), array<f32, 3>(_e776, _e789, _e802)), _e609.member_3);
                                        let _e818 = ((_e642 - _e395) * _e400);
                                        let _e819 = ((_e737 - _e395) * _e400);
                                        let _e820 = ((_e695 - _e396) * _e400);
                                        let _e821 = ((_e776 - _e396) * _e400);
                                        let _e826 = ((_e662 - _e431) * _e436);
                                        let _e827 = ((_e750 - _e431) * _e436);
                                        let _e828 = ((_e708 - _e432) * _e436);
                                        let _e829 = ((_e789 - _e432) * _e436);
                                        let _e834 = ((_e682 - _e467) * _e472);
                                        let _e835 = ((_e763 - _e467) * _e472);
                                        let _e836 = ((_e721 - _e468) * _e472);
                                        let _e837 = ((_e802 - _e468) * _e472);
                                        let _e839 = select(_e836, _e834, (_e834 < _e836));
                                        let _e841 = select(_e837, _e835, (_e835 < _e837));
                                        let _e843 = select(_e836, _e834, (_e834 > _e836));
                                        let _e845 = select(_e837, _e835, (_e835 > _e837));
                                        let _e847 = select(_e820, _e818, (_e818 < _e820));
                                        let _e849 = select(_e821, _e819, (_e819 < _e821));
                                        let _e851 = select(_e828, _e826, (_e826 < _e828));
                                        let _e853 = select(_e829, _e827, (_e827 < _e829));
                                        let _e855 = select(_e851, _e847, (_e847 > _e851));
                                        let _e857 = select(_e853, _e849, (_e849 > _e853));
                                        let _e859 = select(_e839, _e855, (_e855 > _e839));
                                        let _e861 = select(_e841, _e857, (_e857 > _e841));
                                        let _e863 = select(_e820, _e818, (_e818 > _e820));
                                        let _e865 = select(_e821, _e819, (_e819 > _e821));
                                        let _e867 = select(_e828, _e826, (_e826 > _e828));
                                        let _e869 = select(_e829, _e827, (_e827 > _e829));
                                        let _e871 = select(_e867, _e863, (_e863 < _e867));
                                        let _e873 = select(_e869, _e865, (_e865 < _e869));
                                        let _e878 = -(_e839);
                                        let _e879 = -(_e841);
                                        let _e886 = (select(_e843, _e871, (_e871 < _e843)) + (select(_e878, _e843, (_e843 > _e878)) * 0.0000019073523f));
                                        let _e887 = (select(_e845, _e873, (_e873 < _e845)) + (select(_e879, _e845, (_e845 > _e879)) * 0.0000019073523f));
                                        let _e889 = select(_e518, _e859, (_e859 > _e518));
                                        let _e891 = select(_e518, _e861, (_e861 > _e518));
                                        let _e896 = (_e889 <= select(_e552.member_1, _e886, (_e886 < _e552.member_1)));
                                        let _e897 = (_e891 <= select(_e552.member_1, _e887, (_e887 < _e552.member_1)));
                                        let _e898 = (_e889 <= _e891);
                                        if _e896 {
                                            if _e897 {
                                                if _e898 {
                                                    phi_3087_ = _e812;
                                                } else {
                                                    phi_3087_ = _e807;
                                                }
                                                let _e900 = phi_3087_;
                                                let _e908 = (_e595 % 128u);
                                                let _e909 = (_e908 < 128u);
                                                if _e909 {
                                                } else {
                                                    phi_3528_ = true;
                                                    break;
                                                }
                                                local_6[_e908] = _e900.member_1;
                                                if _e909 {
                                                } else {
                                                    phi_3528_ = true;
                                                    break;
                                                }
                                                local_5[_e908] = _e900.member.member[0];
                                                if _e909 {
                                                } else {
                                                    phi_3528_ = true;
                                                    break;
                                                }
                                                local_4[_e908] = _e900.member.member[1];
                                                if _e909 {
                                                } else {
                                                    phi_3528_ = true;
                                                    break;
                                                }
                                                local_3[_e908] = _e900.member.member[2];
                                                if _e909 {
                                                } else {
                                                    phi_3528_ = true;
                                                    break;
                                                }
                                                local_2[_e908] = _e900.member.member_1[0];
                                                if _e909 {
                                                } else {
                                                    phi_3528_ = true;
                                                    break;
                                                }
                                                local_1[_e908] = _e900.member.member_1[1];
                                                if _e909 {
                                                } else {
                                                    phi_3528_ = true;
                                                    break;
                                                }
                                                local[_e908] = _e900.member.member_1[2];
                                                if _e909 {
                                                } else {
                                                    phi_3528_ = true;
                                                    break;
                                                }
                                                local_7[_e908] = select(_e891, _e889, (_e889 > _e891));
                                                if _e898 {
                                                    phi_3164_ = _e807;
                                                } else {
                                                    phi_3164_ = _e812;
                                                }
                                                let _e926 = phi_3164_;
                                                phi_3165_ = _e926;
                                                phi_3166_ = (_e595 + 1u);
                                            } else {
                                                phi_3165_ = type_61();
                                                phi_3166_ = u32();
                                            }
                                            let _e928 = phi_3165_;
                                            let _e930 = phi_3166_;
                                            phi_3168_ = _e928;
                                            phi_3169_ = _e930;
                                            phi_3170_ = select(true, false, _e897);
                                        } else {
                                            phi_3168_ = type_61();
                                            phi_3169_ = u32();
                                            phi_3170_ = true;
                                        }
                                        let _e933 = phi_3168_;
                                        let _e935 = phi_3169_;
                                        let _e937 = phi_3170_;
                                        if _e937 {
                                            if _e896 {
                                                phi_3177_ = _e807;
                                            } else {
                                                phi_3177_ = _e812;
                                            }
                                            let _e939 = phi_3177_;
                                            phi_3182_ = _e939;
                                            phi_3183_ = select(_e897, true, _e896);
                                        } else {
                                            phi_3182_ = _e933;
                                            phi_3183_ = _e593;
                                        }
                                        let _e942 = phi_3182_;
                                        let _e944 = phi_3183_;
                                        phi_3532_ = _e550;
                                        phi_3185_ = _e552;
                                        phi_3186_ = _e942;
                                        phi_3187_ = _e944;
                                        phi_3188_ = select(_e935, _e595, _e937);
                                    }
                                    let _e1654 = phi_3532_;
                                    let _e1656 = phi_3185_;
                                    let _e1658 = phi_3186_;
                                    let _e1660 = phi_3187_;
                                    let _e1662 = phi_3188_;
                                    phi_3531_ = _e1654;
                                    phi_3189_ = _e1656;
                                    phi_3190_ = _e1658;
                                    phi_3191_ = (_e556 - 1u);
                                    phi_3192_ = _e1660;
                                    phi_3193_ = _e1662;
                                } else {
                                    phi_3531_ = _e550;
                                    phi_3189_ = _e552;
                                    phi_3190_ = _e591;
                                    phi_3191_ = _e556;
                                    phi_3192_ = _e593;
                                    phi_3193_ = _e595;
                                }
                                let _e1664 = phi_3531_;
                                let _e1666 = phi_3189_;
                                let _e1668 = phi_3190_;
                                let _e1670 = phi_3191_;
                                let _e1672 = phi_3192_;
                                let _e1674 = phi_3193_;
                                phi_3530_ = _e1664;
                                phi_3194_ = _e1666;
                                phi_3195_ = _e1668;
                                phi_3196_ = _e1670;
                                phi_3197_ = _e1672;
                                phi_3198_ = _e1674;
                            } else {
                                phi_3530_ = _e550;
                                phi_3194_ = type_38();
                                phi_3195_ = type_61();
                                phi_3196_ = u32();
                                phi_3197_ = bool();
                                phi_3198_ = u32();
                            }
                            let _e1676 = phi_3530_;
                            let _e1678 = phi_3194_;
                            let _e1680 = phi_3195_;
                            let _e1682 = phi_3196_;
                            let _e1684 = phi_3197_;
                            let _e1686 = phi_3198_;
                            phi_3529_ = _e1676;
                            phi_887_ = _e1678;
                            phi_890_ = _e1680;
                            phi_892_ = _e1682;
                            phi_894_ = _e1684;
                            phi_896_ = _e1686;
                            phi_3199_ = _e564;
                        } else {
                            phi_3529_ = _e550;
                            phi_887_ = type_38();
                            phi_890_ = type_61();
                            phi_892_ = u32();
                            phi_894_ = bool();
                            phi_896_ = u32();
                            phi_3199_ = false;
                        }
                        let _e1688 = phi_3529_;
                        let _e1690 = phi_887_;
                        let _e1692 = phi_890_;
                        let _e1694 = phi_892_;
                        let _e1696 = phi_894_;
                        let _e1698 = phi_896_;
                        let _e1700 = phi_3199_;
                        continue;
                        continuing {
                            phi_3378_ = _e1688;
                            phi_886_ = _e1690;
                            phi_889_ = _e1692;
                            phi_891_ = _e1694;
                            phi_893_ = _e1696;
                            phi_895_ = _e1698;
                            phi_3528_ = _e1688;
                            break if !(_e1700);
                        }
                    }
                    let _e1703 = phi_3528_;
                    if _e1703 {
                        break;
                    }
                    let _e1705 = local_10;
                    if (_e1705.member.member_3 != 4294967295u) {
                        let _e1710 = (_e342 / 3i);
                        let _e1717 = bitcast<f32>((bitcast<u32>((_e1710 + 127i)) << bitcast<u32>(23i)));
                        let _e1725 = (((_e1705.member.member * _e1717) * _e1717) * bitcast<f32>((bitcast<u32>(((_e342 - (2i * _e1710)) + 127i)) << bitcast<u32>(23i))));
                        let _e1727 = select(340282350000000000000000000000000000000f, _e1725, (_e1725 < 340282350000000000000000000000000000000f));
                        phi_3251_ = type_22(select(-340282350000000000000000000000000000000f, _e1727, (_e1727 > -340282350000000000000000000000000000000f)), _e1705.member.member_1, _e1705.member.member_2, _e1705.member.member_3);
                    } else {
                        phi_3251_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1734 = phi_3251_;
                    if _e219 {
                    } else {
                        break;
                    }
                    global_7.member[_e133] = _e1734;
                    if _e140 {
                    } else {
                        break;
                    }
                    let _e1738 = select(0u, 1u, (_e286 <= _e296));
                    if (_e1738 > 0u) {
                        let _e1740 = (1u < _e101);
                        if _e1740 {
                            if (0u < _e101) {
                            } else {
                                break;
                            }
                            let _e1744 = atomicAdd((&global_8.member[0u]), _e1738);
                            if ((_e1744 + _e1738) < _e1744) {
                                if _e1740 {
                                } else {
                                    break;
                                }
                                let _e1749 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1752 = select(0u, 1u, (_e1734.member_3 != 4294967295u));
                    if (_e1752 > 0u) {
                        let _e1754 = (3u < _e101);
                        if _e1754 {
                            if (2u < _e101) {
                            } else {
                                break;
                            }
                            let _e1758 = atomicAdd((&global_8.member[2u]), _e1752);
                            if ((_e1758 + _e1752) < _e1758) {
                                if _e1754 {
                                } else {
                                    break;
                                }
                                let _e1763 = atomicAdd((&global_8.member[3u]), 1u);
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
