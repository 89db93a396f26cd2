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

struct type_15 {
    member: vec4<u32>,
}

struct type_20 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_22 {
    member: array<type_20>,
}

struct type_28 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_29 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_32 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_40 {
    member: array<type_29>,
}

struct type_42 {
    member: f32,
    member_1: bool,
}

struct type_44 {
    member: array<vec4<u32>, 2>,
}

struct type_49 {
    member: type_32,
    member_1: u32,
}

struct type_50 {
    member: array<vec4<f32>, 3>,
    member_1: type_49,
    member_2: type_49,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_15;
@group(0) @binding(3) 
var<storage> global_2: type_22;
@group(0) @binding(1) 
var<uniform> global_3: type_44;
@group(0) @binding(2) 
var<storage> global_4: type_12;
@group(0) @binding(4) 
var<storage> global_5: type_40;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_4;

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
    var phi_364_: i32;
    var phi_365_: i32;
    var phi_375_: bool;
    var phi_385_: u32;
    var phi_386_: u32;
    var phi_388_: bool;
    var phi_393_: u32;
    var phi_405_: i32;
    var phi_425_: i32;
    var phi_443_: f32;
    var phi_449_: f32;
    var phi_460_: f32;
    var phi_466_: f32;
    var phi_489_: f32;
    var phi_500_: f32;
    var phi_509_: f32;
    var phi_515_: f32;
    var phi_526_: f32;
    var phi_532_: f32;
    var phi_555_: f32;
    var phi_566_: f32;
    var phi_575_: f32;
    var phi_581_: f32;
    var phi_592_: f32;
    var phi_598_: f32;
    var phi_621_: f32;
    var phi_632_: f32;
    var phi_732_: f32;
    var phi_733_: f32;
    var phi_3384_: bool;
    var phi_822_: type_42;
    var phi_825_: type_49;
    var phi_827_: u32;
    var phi_829_: bool;
    var phi_831_: u32;
    var phi_842_: bool;
    var phi_928_: type_49;
    var phi_929_: bool;
    var phi_930_: u32;
    var phi_2662_: u32;
    var phi_2663_: u32;
    var phi_2673_: u32;
    var phi_2675_: u32;
    var phi_2676_: bool;
    var phi_2696_: u32;
    var phi_2697_: u32;
    var phi_2701_: type_50;
    var phi_3045_: type_49;
    var phi_3122_: type_49;
    var phi_3123_: type_49;
    var phi_3124_: u32;
    var phi_3126_: type_49;
    var phi_3127_: u32;
    var phi_3128_: bool;
    var phi_3137_: type_49;
    var phi_3142_: type_49;
    var phi_3143_: bool;
    var phi_948_: type_42;
    var phi_951_: type_7;
    var phi_952_: type_7;
    var phi_974_: type_7;
    var phi_995_: u32;
    var phi_1084_: array<array<f32, 3>, 3>;
    var phi_1201_: bool;
    var phi_1230_: bool;
    var phi_1631_: f32;
    var phi_1632_: f32;
    var phi_1633_: f32;
    var phi_1634_: f32;
    var phi_1635_: vec3<f32>;
    var phi_1636_: vec3<f32>;
    var phi_1637_: vec3<f32>;
    var phi_1638_: vec3<f32>;
    var phi_1669_: bool;
    var phi_1678_: vec3<f32>;
    var phi_1845_: bool;
    var phi_1869_: f32;
    var phi_1870_: f32;
    var phi_1893_: type_28;
    var phi_1895_: type_28;
    var phi_1896_: bool;
    var phi_1900_: type_28;
    var phi_1901_: type_28;
    var phi_1902_: type_28;
    var phi_1903_: bool;
    var phi_1907_: type_28;
    var phi_1908_: bool;
    var phi_1909_: type_28;
    var phi_1910_: bool;
    var phi_1911_: bool;
    var phi_1912_: type_28;
    var phi_1913_: bool;
    var phi_1914_: bool;
    var phi_1922_: type_28;
    var phi_1923_: bool;
    var phi_1927_: type_28;
    var phi_1938_: type_42;
    var phi_1939_: type_42;
    var phi_949_: type_42;
    var phi_3378_: bool;
    var local_10: type_42;
    var phi_3521_: bool;
    var phi_3145_: type_42;
    var phi_3146_: type_49;
    var phi_3147_: bool;
    var phi_3148_: u32;
    var phi_3520_: bool;
    var phi_3149_: type_42;
    var phi_3150_: type_49;
    var phi_3151_: u32;
    var phi_3152_: bool;
    var phi_3153_: u32;
    var phi_3519_: bool;
    var phi_3154_: type_42;
    var phi_3155_: type_49;
    var phi_3156_: u32;
    var phi_3157_: bool;
    var phi_3158_: u32;
    var phi_3518_: bool;
    var phi_823_: type_42;
    var phi_826_: type_49;
    var phi_828_: u32;
    var phi_830_: bool;
    var phi_832_: u32;
    var phi_3159_: bool;
    var phi_3517_: bool;
    var local_11: type_42;
    var local_12: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e84 = global;
            let _e86 = arrayLength((&global_4.member));
            let _e88 = arrayLength((&global_2.member));
            let _e96 = global_3.member[0u][0u];
            let _e100 = global_3.member[0u][1u];
            let _e104 = global_3.member[0u][2u];
            let _e108 = global_3.member[0u][3u];
            let _e112 = global_3.member[1u][0u];
            let _e116 = global_3.member[1u][1u];
            let _e120 = global_3.member[1u][2u];
            let _e123 = global_1.member[0u];
            let _e124 = bitcast<i32>(_e123);
            let _e136 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e108) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e96), bitcast<i32>(_e100), bitcast<i32>(_e104));
            local = array<i32, 3>(bitcast<i32>(_e112), bitcast<i32>(_e116), bitcast<i32>(_e120));
            let _e142 = (_e84.x + (_e84.y * 2097152u));
            let _e143 = (_e142 < arrayLength((&global_5.member)));
            if _e143 {
                let _e144 = (_e142 < arrayLength((&global_6.member)));
                if _e144 {
                    if _e143 {
                    } else {
                        break;
                    }
                    let _e152 = global_5.member[_e142].member_2[0u];
                    let _e154 = (bitcast<u32>(_e152) & 2147483647u);
                    let _e159 = global_5.member[_e142].member_2[1u];
                    let _e161 = (bitcast<u32>(_e159) & 2147483647u);
                    let _e166 = global_5.member[_e142].member_2[2u];
                    let _e168 = (bitcast<u32>(_e166) & 2147483647u);
                    let _e173 = global_5.member[_e142].member[0u];
                    let _e175 = (bitcast<u32>(_e173) & 2147483647u);
                    let _e180 = global_5.member[_e142].member[1u];
                    let _e182 = (bitcast<u32>(_e180) & 2147483647u);
                    let _e187 = global_5.member[_e142].member[2u];
                    let _e189 = (bitcast<u32>(_e187) & 2147483647u);
                    let _e191 = select(_e161, _e154, (_e161 < _e154));
                    let _e193 = select(_e168, _e191, (_e168 < _e191));
                    let _e195 = select(_e175, _e193, (_e175 < _e193));
                    let _e197 = select(_e182, _e195, (_e182 < _e195));
                    let _e199 = select(_e189, _e197, (_e189 < _e197));
                    let _e203 = global_5.member[_e142].member_1;
                    let _e205 = (bitcast<u32>(_e203) & 2147483647u);
                    let _e212 = global_5.member[_e142].member_3;
                    let _e218 = (((select(_e205, _e199, (_e205 < _e199)) < 2139095040u) && ((bitcast<u32>(_e212) & 2147483647u) <= 2139095040u)) && (_e193 > 0u));
                    if _e218 {
                        let _e221 = (bitcast<u32>(bitcast<f32>(_e193)) & 2147483647u);
                        if (_e221 >= 8388608u) {
                            phi_364_ = (bitcast<i32>((_e221 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_364_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e221)), 32u, (_e221 == 0u))));
                        }
                        let _e235 = phi_364_;
                        phi_365_ = _e235;
                    } else {
                        phi_365_ = 0i;
                    }
                    let _e237 = phi_365_;
                    let _e238 = (_e154 == _e193);
                    if _e238 {
                        phi_375_ = true;
                    } else {
                        phi_375_ = (_e161 == _e193);
                    }
                    let _e241 = phi_375_;
                    let _e242 = select(1u, 0u, _e238);
                    if _e241 {
                        let _e243 = (_e242 + 1u);
                        phi_385_ = _e243;
                        phi_386_ = _e243;
                        phi_388_ = select(true, false, (_e243 == 2u));
                    } else {
                        phi_385_ = u32();
                        phi_386_ = 0u;
                        phi_388_ = true;
                    }
                    let _e247 = phi_385_;
                    let _e249 = phi_386_;
                    let _e251 = phi_388_;
                    if _e251 {
                        phi_393_ = (_e249 + 1u);
                    } else {
                        phi_393_ = 0u;
                    }
                    let _e255 = phi_393_;
                    let _e256 = select(_e247, _e249, _e251);
                    let _e257 = select(_e242, select(2u, _e242, _e241), _e251);
                    if (_e124 < -126i) {
                        phi_405_ = -126i;
                    } else {
                        phi_405_ = select(_e124, 127i, (_e124 > 127i));
                    }
                    let _e262 = phi_405_;
                    let _e267 = bitcast<f32>((bitcast<u32>((_e262 + 127i)) << bitcast<u32>(23i)));
                    let _e273 = bitcast<f32>((bitcast<u32>(((_e124 - _e262) + 127i)) << bitcast<u32>(23i)));
                    let _e274 = -(_e237);
                    if (_e274 < -126i) {
                        phi_425_ = -126i;
                    } else {
                        phi_425_ = select(_e274, 127i, (_e274 > 127i));
                    }
                    let _e279 = phi_425_;
                    let _e284 = bitcast<f32>((bitcast<u32>((_e279 + 127i)) << bitcast<u32>(23i)));
                    let _e290 = bitcast<f32>((bitcast<u32>(((_e274 - _e279) + 127i)) << bitcast<u32>(23i)));
                    let _e294 = global_5.member[_e142].member;
                    let _e295 = (_e256 == 0u);
                    if _e295 {
                        phi_443_ = _e294[0];
                    } else {
                        phi_443_ = _e294[1];
                    }
                    let _e299 = phi_443_;
                    let _e300 = (_e256 == 2u);
                    if _e300 {
                        phi_449_ = _e294[2];
                    } else {
                        phi_449_ = _e299;
                    }
                    let _e303 = phi_449_;
                    let _e305 = ((_e303 * _e267) * _e273);
                    let _e306 = global_5.member[_e142].member_2;
                    if _e295 {
                        phi_460_ = _e306[0];
                    } else {
                        phi_460_ = _e306[1];
                    }
                    let _e310 = phi_460_;
                    if _e300 {
                        phi_466_ = _e306[2];
                    } else {
                        phi_466_ = _e310;
                    }
                    let _e313 = phi_466_;
                    let _e315 = ((_e313 * _e284) * _e290);
                    let _e319 = (bitcast<f32>((bitcast<u32>(_e315) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e319 {
                        let _e323 = (bitcast<f32>((bitcast<u32>(_e305) & 2147483647u)) * 0.00000011920929f);
                        phi_489_ = select(0.00000000000011368684f, _e323, (_e323 > 0.00000000000011368684f));
                    } else {
                        phi_489_ = 0f;
                    }
                    let _e327 = phi_489_;
                    let _e328 = (_e305 + _e327);
                    let _e329 = (_e305 - _e327);
                    let _e330 = select(_e315, 0f, _e319);
                    if _e319 {
                        phi_500_ = 38685626000000000000000000f;
                    } else {
                        phi_500_ = (1f / _e315);
                    }
                    let _e333 = phi_500_;
                    let _e334 = (_e255 == 0u);
                    if _e334 {
                        phi_509_ = _e294[0];
                    } else {
                        phi_509_ = _e294[1];
                    }
                    let _e338 = phi_509_;
                    let _e339 = (_e255 == 2u);
                    if _e339 {
                        phi_515_ = _e294[2];
                    } else {
                        phi_515_ = _e338;
                    }
                    let _e342 = phi_515_;
                    let _e344 = ((_e342 * _e267) * _e273);
                    if _e334 {
                        phi_526_ = _e306[0];
                    } else {
                        phi_526_ = _e306[1];
                    }
                    let _e348 = phi_526_;
                    if _e339 {
                        phi_532_ = _e306[2];
                    } else {
                        phi_532_ = _e348;
                    }
                    let _e351 = phi_532_;
                    let _e353 = ((_e351 * _e284) * _e290);
                    let _e357 = (bitcast<f32>((bitcast<u32>(_e353) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e357 {
                        let _e361 = (bitcast<f32>((bitcast<u32>(_e344) & 2147483647u)) * 0.00000011920929f);
                        phi_555_ = select(0.00000000000011368684f, _e361, (_e361 > 0.00000000000011368684f));
                    } else {
                        phi_555_ = 0f;
                    }
                    let _e365 = phi_555_;
                    let _e366 = (_e344 + _e365);
                    let _e367 = (_e344 - _e365);
                    let _e368 = select(_e353, 0f, _e357);
                    if _e357 {
                        phi_566_ = 38685626000000000000000000f;
                    } else {
                        phi_566_ = (1f / _e353);
                    }
                    let _e371 = phi_566_;
                    let _e372 = (_e257 == 0u);
                    if _e372 {
                        phi_575_ = _e294[0];
                    } else {
                        phi_575_ = _e294[1];
                    }
                    let _e376 = phi_575_;
                    let _e377 = (_e257 == 2u);
                    if _e377 {
                        phi_581_ = _e294[2];
                    } else {
                        phi_581_ = _e376;
                    }
                    let _e380 = phi_581_;
                    let _e382 = ((_e380 * _e267) * _e273);
                    if _e372 {
                        phi_592_ = _e306[0];
                    } else {
                        phi_592_ = _e306[1];
                    }
                    let _e386 = phi_592_;
                    if _e377 {
                        phi_598_ = _e306[2];
                    } else {
                        phi_598_ = _e386;
                    }
                    let _e389 = phi_598_;
                    let _e391 = ((_e389 * _e284) * _e290);
                    let _e395 = (bitcast<f32>((bitcast<u32>(_e391) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e395 {
                        let _e399 = (bitcast<f32>((bitcast<u32>(_e382) & 2147483647u)) * 0.00000011920929f);
                        phi_621_ = select(0.00000000000011368684f, _e399, (_e399 > 0.00000000000011368684f));
                    } else {
                        phi_621_ = 0f;
                    }
                    let _e403 = phi_621_;
                    let _e404 = (_e382 + _e403);
                    let _e405 = (_e382 - _e403);
                    let _e406 = select(_e391, 0f, _e395);
                    if _e395 {
                        phi_632_ = 38685626000000000000000000f;
                    } else {
                        phi_632_ = (1f / _e391);
                    }
                    let _e409 = phi_632_;
                    let _e412 = bitcast<f32>((bitcast<u32>(_e305) & 2147483647u));
                    let _e415 = bitcast<f32>((bitcast<u32>(_e344) & 2147483647u));
                    let _e417 = select(_e415, _e412, (_e412 > _e415));
                    let _e420 = bitcast<f32>((bitcast<u32>(_e382) & 2147483647u));
                    let _e423 = (_e124 + _e237);
                    if (_e218 && (select(_e420, _e417, (_e417 > _e420)) <= 1099511600000f)) {
                        let _e426 = (_e423 / 3i);
                        let _e433 = bitcast<f32>((bitcast<u32>((_e426 + 127i)) << bitcast<u32>(23i)));
                        let _e440 = bitcast<f32>((bitcast<u32>(((_e423 - (2i * _e426)) + 127i)) << bitcast<u32>(23i)));
                        let _e441 = (((_e203 * _e433) * _e433) * _e440);
                        let _e443 = select(340282350000000000000000000000000000000f, _e441, (_e441 < 340282350000000000000000000000000000000f));
                        let _e448 = (((_e212 * _e433) * _e433) * _e440);
                        let _e450 = select(340282350000000000000000000000000000000f, _e448, (_e448 < 340282350000000000000000000000000000000f));
                        phi_732_ = select(-340282350000000000000000000000000000000f, _e450, (_e450 > -340282350000000000000000000000000000000f));
                        phi_733_ = select(-340282350000000000000000000000000000000f, _e443, (_e443 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_732_ = 0f;
                        phi_733_ = 1f;
                    }
                    let _e454 = phi_732_;
                    let _e456 = phi_733_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e460 = (_e256 % 3u);
                    let _e461 = (_e460 < 3u);
                    if _e461 {
                    } else {
                        break;
                    }
                    let _e463 = local_1[_e460];
                    let _e466 = (_e255 % 3u);
                    let _e467 = (_e466 < 3u);
                    if _e467 {
                    } else {
                        break;
                    }
                    let _e469 = local_1[_e466];
                    let _e472 = (_e257 % 3u);
                    let _e473 = (_e472 < 3u);
                    if _e473 {
                    } else {
                        break;
                    }
                    let _e475 = local_1[_e472];
                    if _e461 {
                    } else {
                        break;
                    }
                    let _e480 = local[_e460];
                    if _e467 {
                    } else {
                        break;
                    }
                    let _e484 = local[_e466];
                    if _e473 {
                    } else {
                        break;
                    }
                    let _e488 = local[_e472];
                    phi_3384_ = false;
                    phi_822_ = type_42(_e454, false);
                    phi_825_ = type_49(type_32(vec4<f32>((f32(_e463) * _e136), (f32(_e469) * _e136), (f32(_e475) * _e136), 0f), vec4<f32>((f32(_e480) * _e136), (f32(_e484) * _e136), (f32(_e488) * _e136), 0f)), select(0u, 2147483648u, (_e86 == 0u)));
                    phi_827_ = ((3u * _e86) + 1u);
                    phi_829_ = (_e456 <= _e454);
                    phi_831_ = 0u;
                    loop {
                        let _e498 = phi_3384_;
                        let _e500 = phi_822_;
                        let _e502 = phi_825_;
                        let _e504 = phi_827_;
                        let _e506 = phi_829_;
                        let _e508 = phi_831_;
                        local_11 = _e500;
                        if _e506 {
                            phi_842_ = true;
                        } else {
                            phi_842_ = (_e508 > 0u);
                        }
                        let _e511 = phi_842_;
                        if _e511 {
                            let _e512 = (_e504 > 0u);
                            if _e512 {
                                if _e506 {
                                    phi_928_ = _e502;
                                    phi_929_ = _e506;
                                    phi_930_ = _e508;
                                } else {
                                    let _e513 = (_e508 - 1u);
                                    let _e514 = (_e513 % 128u);
                                    let _e515 = (_e514 < 128u);
                                    if _e515 {
                                    } else {
                                        phi_3517_ = true;
                                        break;
                                    }
                                    let _e517 = local_7[_e514];
                                    if _e515 {
                                    } else {
                                        phi_3517_ = true;
                                        break;
                                    }
                                    let _e519 = local_6[_e514];
                                    if _e515 {
                                    } else {
                                        phi_3517_ = true;
                                        break;
                                    }
                                    let _e521 = local_5[_e514];
                                    if _e515 {
                                    } else {
                                        phi_3517_ = true;
                                        break;
                                    }
                                    let _e523 = local_4[_e514];
                                    if _e515 {
                                    } else {
                                        phi_3517_ = true;
                                        break;
                                    }
                                    let _e525 = local_3[_e514];
                                    if _e515 {
                                    } else {
                                        phi_3517_ = true;
                                        break;
                                    }
                                    let _e527 = local_2[_e514];
                                    if _e515 {
                                    } else {
                                        phi_3517_ = true;
                                        break;
                                    }
                                    let _e532 = local_8[_e514];
                                    if _e515 {
                                    } else {
                                        phi_3517_ = true;
                                        break;
                                    }
                                    let _e535 = local_9[_e514];
                                    phi_928_ = type_49(type_32(vec4<f32>(_e517, _e519, _e521, 0f), vec4<f32>(_e523, _e525, _e527, 0f)), _e532);
                                    phi_929_ = (_e535 <= _e500.member);
                                    phi_930_ = _e513;
                                }
                                let _e539 = phi_928_;
                                let _e541 = phi_929_;
                                let _e543 = phi_930_;
                                if _e541 {
                                    if ((_e539.member_1 & 2147483648u) != 0u) {
                                        phi_948_ = _e500;
                                        phi_951_ = type_7(0u, ((_e539.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e987 = phi_948_;
                                            let _e989 = phi_951_;
                                            local_10 = _e987;
                                            local_12 = _e987;
                                            if (_e989.member < _e989.member_1) {
                                                phi_952_ = type_7((_e989.member + 1u), _e989.member_1);
                                                phi_974_ = type_7(1u, _e989.member);
                                            } else {
                                                phi_952_ = _e989;
                                                phi_974_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e1002 = phi_952_;
                                            let _e1004 = phi_974_;
                                            let _e1008 = (bitcast<i32>(_e1004.member) != 0i);
                                            if _e1008 {
                                                let _e1009 = ((_e539.member_1 & 268435455u) + _e1004.member_1);
                                                let _e1010 = (_e1009 < _e88);
                                                if _e1010 {
                                                    if _e1010 {
                                                    } else {
                                                        phi_3378_ = true;
                                                        break;
                                                    }
                                                    let _e1014 = global_2.member[_e1009].member_1;
                                                    phi_995_ = _e1014;
                                                } else {
                                                    phi_995_ = 4294967295u;
                                                }
                                                let _e1016 = phi_995_;
                                                if (_e1009 >= _e88) {
                                                    phi_1084_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1010 {
                                                    } else {
                                                        phi_3378_ = true;
                                                        break;
                                                    }
                                                    if (_e460 < 9u) {
                                                    } else {
                                                        phi_3378_ = true;
                                                        break;
                                                    }
                                                    let _e1023 = global_2.member[_e1009].member[_e460];
                                                    if (_e466 < 9u) {
                                                    } else {
                                                        phi_3378_ = true;
                                                        break;
                                                    }
                                                    let _e1029 = global_2.member[_e1009].member[_e466];
                                                    if (_e472 < 9u) {
                                                    } else {
                                                        phi_3378_ = true;
                                                        break;
                                                    }
                                                    let _e1035 = global_2.member[_e1009].member[_e472];
                                                    let _e1037 = (3u + _e460);
                                                    if (_e1037 < 9u) {
                                                    } else {
                                                        phi_3378_ = true;
                                                        break;
                                                    }
                                                    let _e1043 = global_2.member[_e1009].member[_e1037];
                                                    let _e1044 = (3u + _e466);
                                                    if (_e1044 < 9u) {
                                                    } else {
                                                        phi_3378_ = true;
                                                        break;
                                                    }
                                                    let _e1050 = global_2.member[_e1009].member[_e1044];
                                                    let _e1051 = (3u + _e472);
                                                    if (_e1051 < 9u) {
                                                    } else {
                                                        phi_3378_ = true;
                                                        break;
                                                    }
                                                    let _e1057 = global_2.member[_e1009].member[_e1051];
                                                    let _e1059 = (6u + _e460);
                                                    if (_e1059 < 9u) {
                                                    } else {
                                                        phi_3378_ = true;
                                                        break;
                                                    }
                                                    let _e1065 = global_2.member[_e1009].member[_e1059];
                                                    let _e1066 = (6u + _e466);
                                                    if (_e1066 < 9u) {
                                                    } else {
                                                        phi_3378_ = true;
                                                        break;
                                                    }
                                                    let _e1072 = global_2.member[_e1009].member[_e1066];
                                                    let _e1073 = (6u + _e472);
                                                    if (_e1073 < 9u) {
                                                    } else {
                                                        phi_3378_ = true;
                                                        break;
                                                    }
                                                    let _e1079 = global_2.member[_e1009].member[_e1073];
                                                    phi_1084_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1023, _e1029, _e1035), array<f32, 3>(_e1043, _e1050, _e1057), array<f32, 3>(_e1065, _e1072, _e1079));
                                                }
                                                let _e1083 = phi_1084_;
                                                let _e1091 = (_e1083[0][2] - _e382);
                                                let _e1094 = (((_e1083[0][0] - _e305) * _e406) - (_e1091 * _e330));
                                                let _e1097 = (((_e1083[0][1] - _e344) * _e406) - (_e1091 * _e368));
                                                let _e1104 = (_e1083[1][2] - _e382);
                                                let _e1107 = (((_e1083[1][0] - _e305) * _e406) - (_e1104 * _e330));
                                                let _e1110 = (((_e1083[1][1] - _e344) * _e406) - (_e1104 * _e368));
                                                let _e1117 = (_e1083[2][2] - _e382);
                                                let _e1120 = (((_e1083[2][0] - _e305) * _e406) - (_e1117 * _e330));
                                                let _e1123 = (((_e1083[2][1] - _e344) * _e406) - (_e1117 * _e368));
                                                let _e1124 = (_e1120 * _e1110);
                                                let _e1125 = (_e1123 * _e1107);
                                                let _e1126 = (_e1094 * _e1123);
                                                let _e1127 = (_e1097 * _e1120);
                                                let _e1128 = (_e1107 * _e1097);
                                                let _e1129 = (_e1110 * _e1094);
                                                let _e1134 = (((_e1124 >= _e1125) && (_e1126 >= _e1127)) && (_e1128 >= _e1129));
                                                if (_e1134 || (((_e1124 <= _e1125) && (_e1126 <= _e1127)) && (_e1128 <= _e1129))) {
                                                    let _e1141 = select(-1f, 1f, _e1134);
                                                    let _e1143 = ((_e1124 - _e1125) * _e1141);
                                                    let _e1145 = select(0f, _e1143, (_e1143 > 0f));
                                                    let _e1147 = ((_e1126 - _e1127) * _e1141);
                                                    let _e1149 = select(0f, _e1147, (_e1147 > 0f));
                                                    let _e1151 = ((_e1128 - _e1129) * _e1141);
                                                    let _e1153 = select(0f, _e1151, (_e1151 > 0f));
                                                    let _e1155 = ((_e1145 + _e1149) + _e1153);
                                                    if (_e1155 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1912_ = type_28();
                                                        phi_1913_ = true;
                                                        phi_1914_ = false;
                                                    } else {
                                                        let _e1158 = select(_e1107, _e1094, (_e1094 < _e1107));
                                                        if (select(_e1120, _e1158, (_e1158 < _e1120)) > 0f) {
                                                            phi_1201_ = true;
                                                        } else {
                                                            let _e1163 = select(_e1107, _e1094, (_e1094 > _e1107));
                                                            phi_1201_ = (select(_e1120, _e1163, (_e1163 > _e1120)) < 0f);
                                                        }
                                                        let _e1168 = phi_1201_;
                                                        if _e1168 {
                                                            phi_1909_ = type_28();
                                                            phi_1910_ = true;
                                                            phi_1911_ = false;
                                                        } else {
                                                            let _e1170 = select(_e1110, _e1097, (_e1097 < _e1110));
                                                            if (select(_e1123, _e1170, (_e1170 < _e1123)) > 0f) {
                                                                phi_1230_ = true;
                                                            } else {
                                                                let _e1175 = select(_e1110, _e1097, (_e1097 > _e1110));
                                                                phi_1230_ = (select(_e1123, _e1175, (_e1175 > _e1123)) < 0f);
                                                            }
                                                            let _e1180 = phi_1230_;
                                                            if _e1180 {
                                                                phi_1907_ = type_28();
                                                                phi_1908_ = false;
                                                            } else {
                                                                let _e1182 = select(_e1083[1][0], _e1083[0][0], (_e1083[0][0] < _e1083[1][0]));
                                                                let _e1186 = select(_e1083[1][0], _e1083[0][0], (_e1083[0][0] > _e1083[1][0]));
                                                                let _e1190 = select(_e1083[1][1], _e1083[0][1], (_e1083[0][1] < _e1083[1][1]));
                                                                let _e1194 = select(_e1083[1][1], _e1083[0][1], (_e1083[0][1] > _e1083[1][1]));
                                                                let _e1198 = select(_e1083[1][2], _e1083[0][2], (_e1083[0][2] < _e1083[1][2]));
                                                                let _e1202 = select(_e1083[1][2], _e1083[0][2], (_e1083[0][2] > _e1083[1][2]));
                                                                let _e1207 = ((select(_e1083[2][0], _e1182, (_e1182 < _e1083[2][0])) - _e328) * _e333);
                                                                let _e1208 = ((select(_e1083[2][0], _e1186, (_e1186 > _e1083[2][0])) - _e329) * _e333);
                                                                let _e1211 = ((select(_e1083[2][1], _e1190, (_e1190 < _e1083[2][1])) - _e366) * _e371);
                                                                let _e1212 = ((select(_e1083[2][1], _e1194, (_e1194 > _e1083[2][1])) - _e367) * _e371);
                                                                let _e1215 = ((select(_e1083[2][2], _e1198, (_e1198 < _e1083[2][2])) - _e404) * _e409);
                                                                let _e1216 = ((select(_e1083[2][2], _e1202, (_e1202 > _e1083[2][2])) - _e405) * _e409);
                                                                let _e1218 = select(_e1216, _e1215, (_e1215 < _e1216));
                                                                let _e1220 = select(_e1216, _e1215, (_e1215 > _e1216));
                                                                let _e1222 = select(_e1208, _e1207, (_e1207 < _e1208));
                                                                let _e1224 = select(_e1212, _e1211, (_e1211 < _e1212));
                                                                let _e1226 = select(_e1224, _e1222, (_e1222 > _e1224));
                                                                let _e1228 = select(_e1218, _e1226, (_e1226 > _e1218));
                                                                let _e1230 = select(_e1208, _e1207, (_e1207 > _e1208));
                                                                let _e1232 = select(_e1212, _e1211, (_e1211 > _e1212));
                                                                let _e1234 = select(_e1232, _e1230, (_e1230 < _e1232));
                                                                let _e1236 = select(_e1220, _e1234, (_e1234 < _e1220));
                                                                let _e1237 = -(_e1218);
                                                                let _e1243 = select(_e456, _e1228, (_e1228 > _e456));
                                                                if (_e1243 > (_e1236 + (select(_e1237, _e1220, (_e1220 > _e1237)) * 0.0000019073523f))) {
                                                                    phi_1902_ = type_28();
                                                                    phi_1903_ = true;
                                                                } else {
                                                                    let _e1245 = (_e1243 > _e987.member);
                                                                    if _e1245 {
                                                                        phi_1901_ = type_28();
                                                                    } else {
                                                                        let _e1246 = vec3<f32>(_e1083[0][0], _e1083[0][1], _e1083[0][2]);
                                                                        let _e1247 = vec3<f32>(_e1083[1][0], _e1083[1][1], _e1083[1][2]);
                                                                        let _e1248 = vec3<f32>(_e1083[2][0], _e1083[2][1], _e1083[2][2]);
                                                                        let _e1249 = (_e1083[1][0] - _e1083[0][0]);
                                                                        let _e1250 = (_e1083[1][1] - _e1083[0][1]);
                                                                        let _e1251 = (_e1083[1][2] - _e1083[0][2]);
                                                                        let _e1252 = vec3<f32>(_e1249, _e1250, _e1251);
                                                                        let _e1253 = (_e1083[2][0] - _e1083[1][0]);
                                                                        let _e1254 = (_e1083[2][1] - _e1083[1][1]);
                                                                        let _e1255 = (_e1083[2][2] - _e1083[1][2]);
                                                                        let _e1256 = vec3<f32>(_e1253, _e1254, _e1255);
                                                                        let _e1257 = (_e1083[0][0] - _e1083[2][0]);
                                                                        let _e1258 = (_e1083[0][1] - _e1083[2][1]);
                                                                        let _e1259 = (_e1083[0][2] - _e1083[2][2]);
                                                                        let _e1260 = vec3<f32>(_e1257, _e1258, _e1259);
                                                                        let _e1263 = bitcast<f32>((bitcast<u32>(_e1249) & 2147483647u));
                                                                        let _e1266 = bitcast<f32>((bitcast<u32>(_e1250) & 2147483647u));
                                                                        let _e1268 = select(_e1266, _e1263, (_e1263 > _e1266));
                                                                        let _e1271 = bitcast<f32>((bitcast<u32>(_e1251) & 2147483647u));
                                                                        let _e1273 = select(_e1271, _e1268, (_e1268 > _e1271));
                                                                        let _e1276 = bitcast<f32>((bitcast<u32>(_e1253) & 2147483647u));
                                                                        let _e1279 = bitcast<f32>((bitcast<u32>(_e1254) & 2147483647u));
                                                                        let _e1281 = select(_e1279, _e1276, (_e1276 > _e1279));
                                                                        let _e1284 = bitcast<f32>((bitcast<u32>(_e1255) & 2147483647u));
                                                                        let _e1286 = select(_e1284, _e1281, (_e1281 > _e1284));
                                                                        let _e1289 = bitcast<f32>((bitcast<u32>(_e1257) & 2147483647u));
                                                                        let _e1292 = bitcast<f32>((bitcast<u32>(_e1258) & 2147483647u));
                                                                        let _e1294 = select(_e1292, _e1289, (_e1289 > _e1292));
                                                                        let _e1297 = bitcast<f32>((bitcast<u32>(_e1259) & 2147483647u));
                                                                        let _e1299 = select(_e1297, _e1294, (_e1294 > _e1297));
                                                                        let _e1301 = select(_e1286, _e1273, (_e1273 > _e1286));
                                                                        let _e1303 = select(_e1299, _e1301, (_e1301 > _e1299));
                                                                        if (_e1273 == _e1303) {
                                                                            phi_1631_ = _e1110;
                                                                            phi_1632_ = _e1107;
                                                                            phi_1633_ = _e1097;
                                                                            phi_1634_ = _e1094;
                                                                            phi_1635_ = _e1246;
                                                                            phi_1636_ = _e1260;
                                                                            phi_1637_ = _e1256;
                                                                            phi_1638_ = _e1252;
                                                                        } else {
                                                                            let _e1305 = (_e1286 == _e1303);
                                                                            let _e1310 = vec3(_e1305);
                                                                            phi_1631_ = select(_e1097, _e1123, _e1305);
                                                                            phi_1632_ = select(_e1094, _e1120, _e1305);
                                                                            phi_1633_ = select(_e1123, _e1110, _e1305);
                                                                            phi_1634_ = select(_e1120, _e1107, _e1305);
                                                                            phi_1635_ = select(_e1248, _e1247, _e1310);
                                                                            phi_1636_ = select(_e1256, _e1252, _e1310);
                                                                            phi_1637_ = select(_e1252, _e1260, _e1310);
                                                                            phi_1638_ = select(_e1260, _e1256, _e1310);
                                                                        }
                                                                        let _e1316 = phi_1631_;
                                                                        let _e1318 = phi_1632_;
                                                                        let _e1320 = phi_1633_;
                                                                        let _e1322 = phi_1634_;
                                                                        let _e1324 = phi_1635_;
                                                                        let _e1326 = phi_1636_;
                                                                        let _e1328 = phi_1637_;
                                                                        let _e1330 = phi_1638_;
                                                                        let _e1337 = ((_e1328.y * _e1326.z) - (_e1326.y * _e1328.z));
                                                                        let _e1342 = ((_e1328.z * _e1326.x) - (_e1326.z * _e1328.x));
                                                                        let _e1345 = ((_e1328.x * _e1326.y) - (_e1326.x * _e1328.y));
                                                                        if (_e1145 >= _e1149) {
                                                                            phi_1669_ = select(true, false, (_e1145 >= _e1153));
                                                                        } else {
                                                                            phi_1669_ = true;
                                                                        }
                                                                        let _e1350 = phi_1669_;
                                                                        if _e1350 {
                                                                            phi_1678_ = select(_e1248, _e1247, vec3((_e1149 >= _e1153)));
                                                                        } else {
                                                                            phi_1678_ = _e1246;
                                                                        }
                                                                        let _e1355 = phi_1678_;
                                                                        let _e1360 = (((_e1337 * _e330) + (_e1342 * _e368)) + (_e1345 * _e406));
                                                                        let _e1371 = (((_e1337 * (_e1355.x - _e305)) + (_e1342 * (_e1355.y - _e344))) + (_e1345 * (_e1355.z - _e382)));
                                                                        let _e1373 = (_e1318 - _e1322);
                                                                        let _e1374 = (_e1316 - _e1320);
                                                                        let _e1382 = (-(((_e1322 * _e1373) + (_e1320 * _e1374))) / ((_e1373 * _e1373) + (_e1374 * _e1374)));
                                                                        let _e1384 = select(1f, _e1382, (_e1382 < 1f));
                                                                        let _e1386 = select(0f, _e1384, (_e1384 > 0f));
                                                                        let _e1399 = ((_e1324.x + (_e1330.x * _e1386)) - _e305);
                                                                        let _e1400 = ((_e1324.y + (_e1330.y * _e1386)) - _e344);
                                                                        let _e1401 = ((_e1324.z + (_e1330.z * _e1386)) - _e382);
                                                                        let _e1402 = (_e1401 / _e406);
                                                                        let _e1414 = bitcast<f32>((bitcast<u32>(_e1399) & 2147483647u));
                                                                        let _e1417 = bitcast<f32>((bitcast<u32>(_e1400) & 2147483647u));
                                                                        let _e1419 = select(_e1417, _e1414, (_e1414 > _e1417));
                                                                        let _e1422 = bitcast<f32>((bitcast<u32>(_e1401) & 2147483647u));
                                                                        let _e1424 = select(_e1422, _e1419, (_e1419 > _e1422));
                                                                        let _e1430 = bitcast<f32>((bitcast<u32>(_e1337) & 2147483647u));
                                                                        let _e1433 = bitcast<f32>((bitcast<u32>(_e1342) & 2147483647u));
                                                                        let _e1435 = select(_e1433, _e1430, (_e1430 > _e1433));
                                                                        let _e1438 = bitcast<f32>((bitcast<u32>(_e1345) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1337 * _e1399) + (_e1342 * _e1400)) + (_e1345 * _e1401)) - _e1371)) & 2147483647u)) <= ((0.0000009536743f * select(_e1303, _e1424, (_e1424 > _e1303))) * select(_e1438, _e1435, (_e1435 > _e1438)))) {
                                                                            let _e1448 = bitcast<f32>((bitcast<u32>(_e1328.x) & 2147483647u));
                                                                            let _e1451 = bitcast<f32>((bitcast<u32>(_e1328.y) & 2147483647u));
                                                                            let _e1453 = select(_e1451, _e1448, (_e1448 > _e1451));
                                                                            let _e1456 = bitcast<f32>((bitcast<u32>(_e1328.z) & 2147483647u));
                                                                            let _e1462 = bitcast<f32>((bitcast<u32>(_e1326.x) & 2147483647u));
                                                                            let _e1465 = bitcast<f32>((bitcast<u32>(_e1326.y) & 2147483647u));
                                                                            let _e1467 = select(_e1465, _e1462, (_e1462 > _e1465));
                                                                            let _e1470 = bitcast<f32>((bitcast<u32>(_e1326.z) & 2147483647u));
                                                                            phi_1845_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1360) & 2147483647u)) > ((0.0000038146973f * select(_e1456, _e1453, (_e1453 > _e1456))) * select(_e1470, _e1467, (_e1467 > _e1470)))));
                                                                        } else {
                                                                            phi_1845_ = true;
                                                                        }
                                                                        let _e1477 = phi_1845_;
                                                                        if _e1477 {
                                                                            let _e1488 = ((((_e1337 * (_e1399 - (_e330 * _e1402))) + (_e1342 * (_e1400 - (_e368 * _e1402)))) + (_e1345 * (_e1401 - _e1401))) / _e1360);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1488) & 2147483647u)) <= _e1303) {
                                                                                phi_1869_ = (_e1402 + _e1488);
                                                                            } else {
                                                                                phi_1869_ = _e1402;
                                                                            }
                                                                            let _e1495 = phi_1869_;
                                                                            phi_1870_ = _e1495;
                                                                        } else {
                                                                            phi_1870_ = (_e1371 / _e1360);
                                                                        }
                                                                        let _e1497 = phi_1870_;
                                                                        let _e1499 = select(_e1236, _e1497, (_e1497 < _e1236));
                                                                        let _e1501 = select(_e1228, _e1499, (_e1499 > _e1228));
                                                                        if (_e1501 >= _e456) {
                                                                            let _e1503 = (_e1501 <= _e987.member);
                                                                            if _e1503 {
                                                                                let _e1504 = (1f / _e1155);
                                                                                phi_1893_ = type_28(_e1501, (_e1149 * _e1504), (_e1153 * _e1504), _e1016);
                                                                            } else {
                                                                                phi_1893_ = type_28();
                                                                            }
                                                                            let _e1509 = phi_1893_;
                                                                            phi_1895_ = _e1509;
                                                                            phi_1896_ = select(true, false, _e1503);
                                                                        } else {
                                                                            phi_1895_ = type_28();
                                                                            phi_1896_ = true;
                                                                        }
                                                                        let _e1512 = phi_1895_;
                                                                        let _e1514 = phi_1896_;
                                                                        if _e1514 {
                                                                            phi_1900_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1900_ = _e1512;
                                                                        }
                                                                        let _e1516 = phi_1900_;
                                                                        phi_1901_ = _e1516;
                                                                    }
                                                                    let _e1518 = phi_1901_;
                                                                    phi_1902_ = _e1518;
                                                                    phi_1903_ = _e1245;
                                                                }
                                                                let _e1520 = phi_1902_;
                                                                let _e1522 = phi_1903_;
                                                                phi_1907_ = _e1520;
                                                                phi_1908_ = _e1522;
                                                            }
                                                            let _e1524 = phi_1907_;
                                                            let _e1526 = phi_1908_;
                                                            phi_1909_ = _e1524;
                                                            phi_1910_ = _e1180;
                                                            phi_1911_ = _e1526;
                                                        }
                                                        let _e1528 = phi_1909_;
                                                        let _e1530 = phi_1910_;
                                                        let _e1532 = phi_1911_;
                                                        phi_1912_ = _e1528;
                                                        phi_1913_ = _e1530;
                                                        phi_1914_ = _e1532;
                                                    }
                                                    let _e1534 = phi_1912_;
                                                    let _e1536 = phi_1913_;
                                                    let _e1538 = phi_1914_;
                                                    phi_1922_ = _e1534;
                                                    phi_1923_ = select(_e1538, true, _e1536);
                                                } else {
                                                    phi_1922_ = type_28();
                                                    phi_1923_ = true;
                                                }
                                                let _e1541 = phi_1922_;
                                                let _e1543 = phi_1923_;
                                                if _e1543 {
                                                    phi_1927_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1927_ = _e1541;
                                                }
                                                let _e1545 = phi_1927_;
                                                if (_e1545.member_3 != 4294967295u) {
                                                    if (_e1016 != 4294967295u) {
                                                        phi_1938_ = type_42(_e987.member, true);
                                                    } else {
                                                        phi_1938_ = _e987;
                                                    }
                                                    let _e1553 = phi_1938_;
                                                    phi_1939_ = _e1553;
                                                } else {
                                                    phi_1939_ = _e987;
                                                }
                                                let _e1555 = phi_1939_;
                                                phi_949_ = _e1555;
                                            } else {
                                                phi_949_ = type_42();
                                            }
                                            let _e1557 = phi_949_;
                                            continue;
                                            continuing {
                                                phi_948_ = _e1557;
                                                phi_951_ = _e1002;
                                                phi_3378_ = _e498;
                                                break if !(_e1008);
                                            }
                                        }
                                        let _e1560 = phi_3378_;
                                        phi_3517_ = _e1560;
                                        if _e1560 {
                                            break;
                                        }
                                        let _e1562 = local_10;
                                        phi_3521_ = _e1560;
                                        let _e1726 = local_12;
                                        phi_3145_ = _e1726;
                                        phi_3146_ = _e539;
                                        phi_3147_ = false;
                                        phi_3148_ = select(_e543, 0u, _e1562.member_1);
                                    } else {
                                        if (_e539.member_1 >= _e86) {
                                            phi_2701_ = type_50(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e539.member_1 < _e86) {
                                            } else {
                                                phi_3517_ = true;
                                                break;
                                            }
                                            let _e555 = ((1u + _e256) % 4u);
                                            if (_e555 < 4u) {
                                            } else {
                                                phi_3517_ = true;
                                                break;
                                            }
                                            let _e560 = global_4.member[_e539.member_1][_e555];
                                            let _e562 = (_e560 >> bitcast<u32>(11u));
                                            let _e564 = ((1u + _e255) % 4u);
                                            if (_e564 < 4u) {
                                            } else {
                                                phi_3517_ = true;
                                                break;
                                            }
                                            let _e569 = global_4.member[_e539.member_1][_e564];
                                            let _e571 = (_e569 >> bitcast<u32>(11u));
                                            let _e573 = ((1u + _e257) % 4u);
                                            if (_e573 < 4u) {
                                            } else {
                                                phi_3517_ = true;
                                                break;
                                            }
                                            let _e578 = global_4.member[_e539.member_1][_e573];
                                            let _e580 = (_e578 >> bitcast<u32>(11u));
                                            let _e603 = (bitcast<f32>((bitcast<u32>((_e539.member.member_1.x - _e539.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e604 = (bitcast<f32>((bitcast<u32>((_e539.member.member_1.y - _e539.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e605 = (bitcast<f32>((bitcast<u32>((_e539.member.member_1.z - _e539.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e607 = select(_e136, _e603, (_e603 > _e136));
                                            let _e609 = select(_e136, _e604, (_e604 > _e136));
                                            let _e611 = select(_e136, _e605, (_e605 > _e136));
                                            let _e636 = bitcast<u32>((f32(bitcast<i32>((_e560 & 1023u))) * _e607));
                                            let _e641 = (bitcast<i32>((_e560 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e644 = bitcast<f32>((_e636 & bitcast<u32>(_e641)));
                                            let _e645 = bitcast<u32>((f32(bitcast<i32>((_e569 & 1023u))) * _e609));
                                            let _e650 = (bitcast<i32>((_e569 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e653 = bitcast<f32>((_e645 & bitcast<u32>(_e650)));
                                            let _e654 = bitcast<u32>((f32(bitcast<i32>((_e578 & 1023u))) * _e611));
                                            let _e659 = (bitcast<i32>((_e578 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e662 = bitcast<f32>((_e654 & bitcast<u32>(_e659)));
                                            let _e666 = bitcast<f32>((_e636 & bitcast<u32>(~(_e641))));
                                            let _e670 = bitcast<f32>((_e645 & bitcast<u32>(~(_e650))));
                                            let _e674 = bitcast<f32>((_e654 & bitcast<u32>(~(_e659))));
                                            let _e675 = bitcast<u32>((f32(bitcast<i32>((_e562 & 1023u))) * _e607));
                                            let _e680 = (bitcast<i32>((_e562 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e683 = bitcast<f32>((_e675 & bitcast<u32>(_e680)));
                                            let _e684 = bitcast<u32>((f32(bitcast<i32>((_e571 & 1023u))) * _e609));
                                            let _e689 = (bitcast<i32>((_e571 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e692 = bitcast<f32>((_e684 & bitcast<u32>(_e689)));
                                            let _e693 = bitcast<u32>((f32(bitcast<i32>((_e580 & 1023u))) * _e611));
                                            let _e698 = (bitcast<i32>((_e580 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e701 = bitcast<f32>((_e693 & bitcast<u32>(_e698)));
                                            let _e705 = bitcast<f32>((_e675 & bitcast<u32>(~(_e680))));
                                            let _e709 = bitcast<f32>((_e684 & bitcast<u32>(~(_e689))));
                                            let _e713 = bitcast<f32>((_e693 & bitcast<u32>(~(_e698))));
                                            let _e743 = global_4.member[_e539.member_1][0u];
                                            let _e747 = global_4.member[_e539.member_1][1u];
                                            let _e751 = global_4.member[_e539.member_1][2u];
                                            let _e755 = global_4.member[_e539.member_1][3u];
                                            let _e767 = (((_e747 >> bitcast<u32>(22i)) | ((_e751 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e755 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e768 = (_e743 & 268435455u);
                                            let _e769 = (_e767 & 268435455u);
                                            let _e772 = ((_e743 >> bitcast<u32>(28u)) & 7u);
                                            let _e780 = ((_e743 >> bitcast<u32>(31i)) | (((_e767 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e781 = (_e772 != 0u);
                                            if (_e772 == 0u) {
                                                phi_2663_ = _e768;
                                            } else {
                                                if (_e772 == 7u) {
                                                    phi_2662_ = 2147483648u;
                                                } else {
                                                    phi_2662_ = ((2147483648u | (_e772 << bitcast<u32>(28u))) | (_e769 & 268435455u));
                                                }
                                                let _e790 = phi_2662_;
                                                phi_2663_ = _e790;
                                            }
                                            let _e792 = phi_2663_;
                                            if _e781 {
                                                let _e793 = (_e772 != 7u);
                                                if _e793 {
                                                    phi_2673_ = (_e769 + _e772);
                                                } else {
                                                    phi_2673_ = u32();
                                                }
                                                let _e796 = phi_2673_;
                                                phi_2675_ = _e796;
                                                phi_2676_ = select(true, false, _e793);
                                            } else {
                                                phi_2675_ = u32();
                                                phi_2676_ = true;
                                            }
                                            let _e799 = phi_2675_;
                                            let _e801 = phi_2676_;
                                            if (_e780 == 0u) {
                                                phi_2697_ = (_e768 + select(0u, 1u, !(_e781)));
                                            } else {
                                                if (_e780 == 7u) {
                                                    phi_2696_ = 2147483648u;
                                                } else {
                                                    phi_2696_ = ((2147483648u | (_e780 << bitcast<u32>(28u))) | (select(_e799, _e769, _e801) & 268435455u));
                                                }
                                                let _e814 = phi_2696_;
                                                phi_2697_ = _e814;
                                            }
                                            let _e816 = phi_2697_;
                                            phi_2701_ = type_50(array<vec4<f32>, 3>(vec4<f32>((_e539.member.member.x + _e644), (_e539.member.member.x + _e666), (_e539.member.member_1.x - _e683), (_e539.member.member_1.x - _e705)), vec4<f32>((_e539.member.member.y + _e653), (_e539.member.member.y + _e670), (_e539.member.member_1.y - _e692), (_e539.member.member_1.y - _e709)), vec4<f32>((_e539.member.member.z + _e662), (_e539.member.member.z + _e674), (_e539.member.member_1.z - _e701), (_e539.member.member_1.z - _e713))), type_49(type_32((_e539.member.member + vec4<f32>(_e644, _e653, _e662, 0f)), (_e539.member.member_1 - vec4<f32>(_e683, _e692, _e701, 0f))), _e792), type_49(type_32((_e539.member.member + vec4<f32>(_e666, _e670, _e674, 0f)), (_e539.member.member_1 - vec4<f32>(_e705, _e709, _e713, 0f))), _e816));
                                        }
                                        let _e821 = phi_2701_;
                                        let _e833 = ((_e821.member[0].x - _e328) * _e333);
                                        let _e834 = ((_e821.member[0].y - _e328) * _e333);
                                        let _e835 = ((_e821.member[0].z - _e329) * _e333);
                                        let _e836 = ((_e821.member[0].w - _e329) * _e333);
                                        let _e846 = ((_e821.member[1].x - _e366) * _e371);
                                        let _e847 = ((_e821.member[1].y - _e366) * _e371);
                                        let _e848 = ((_e821.member[1].z - _e367) * _e371);
                                        let _e849 = ((_e821.member[1].w - _e367) * _e371);
                                        let _e859 = ((_e821.member[2].x - _e404) * _e409);
                                        let _e860 = ((_e821.member[2].y - _e404) * _e409);
                                        let _e861 = ((_e821.member[2].z - _e405) * _e409);
                                        let _e862 = ((_e821.member[2].w - _e405) * _e409);
                                        let _e864 = select(_e861, _e859, (_e859 < _e861));
                                        let _e866 = select(_e862, _e860, (_e860 < _e862));
                                        let _e868 = select(_e861, _e859, (_e859 > _e861));
                                        let _e870 = select(_e862, _e860, (_e860 > _e862));
                                        let _e872 = select(_e835, _e833, (_e833 < _e835));
                                        let _e874 = select(_e836, _e834, (_e834 < _e836));
                                        let _e876 = select(_e848, _e846, (_e846 < _e848));
                                        let _e878 = select(_e849, _e847, (_e847 < _e849));
                                        let _e880 = select(_e876, _e872, (_e872 > _e876));
                                        let _e882 = select(_e878, _e874, (_e874 > _e878));
                                        let _e884 = select(_e864, _e880, (_e880 > _e864));
                                        let _e886 = select(_e866, _e882, (_e882 > _e866));
                                        let _e888 = select(_e835, _e833, (_e833 > _e835));
                                        let _e890 = select(_e836, _e834, (_e834 > _e836));
                                        let _e892 = select(_e848, _e846, (_e846 > _e848));
                                        let _e894 = select(_e849, _e847, (_e847 > _e849));
                                        let _e896 = select(_e892, _e888, (_e888 < _e892));
                                        let _e898 = select(_e894, _e890, (_e890 < _e894));
                                        let _e903 = -(_e864);
                                        let _e904 = -(_e866);
                                        let _e911 = (select(_e868, _e896, (_e896 < _e868)) + (select(_e903, _e868, (_e868 > _e903)) * 0.0000019073523f));
                                        let _e912 = (select(_e870, _e898, (_e898 < _e870)) + (select(_e904, _e870, (_e870 > _e904)) * 0.0000019073523f));
                                        let _e914 = select(_e456, _e884, (_e884 > _e456));
                                        let _e916 = select(_e456, _e886, (_e886 > _e456));
                                        let _e921 = (_e914 <= select(_e500.member, _e911, (_e911 < _e500.member)));
                                        let _e922 = (_e916 <= select(_e500.member, _e912, (_e912 < _e500.member)));
                                        let _e923 = (_e914 <= _e916);
                                        if _e921 {
                                            if _e922 {
                                                if _e923 {
                                                    phi_3045_ = _e821.member_2;
                                                } else {
                                                    phi_3045_ = _e821.member_1;
                                                }
                                                let _e927 = phi_3045_;
                                                let _e949 = (_e543 % 128u);
                                                let _e950 = (_e949 < 128u);
                                                if _e950 {
                                                } else {
                                                    phi_3517_ = true;
                                                    break;
                                                }
                                                local_8[_e949] = _e927.member_1;
                                                if _e950 {
                                                } else {
                                                    phi_3517_ = true;
                                                    break;
                                                }
                                                local_7[_e949] = _e927.member.member.x;
                                                if _e950 {
                                                } else {
                                                    phi_3517_ = true;
                                                    break;
                                                }
                                                local_6[_e949] = _e927.member.member.y;
                                                if _e950 {
                                                } else {
                                                    phi_3517_ = true;
                                                    break;
                                                }
                                                local_5[_e949] = _e927.member.member.z;
                                                if _e950 {
                                                } else {
                                                    phi_3517_ = true;
                                                    break;
                                                }
                                                local_4[_e949] = _e927.member.member_1.x;
                                                if _e950 {
                                                } else {
                                                    phi_3517_ = true;
                                                    break;
                                                }
                                                local_3[_e949] = _e927.member.member_1.y;
                                                if _e950 {
                                                } else {
                                                    phi_3517_ = true;
                                                    break;
                                                }
                                                local_2[_e949] = _e927.member.member_1.z;
                                                if _e950 {
                                                } else {
                                                    phi_3517_ = true;
                                                    break;
                                                }
                                                local_9[_e949] = select(_e916, _e914, (_e914 > _e916));
                                                if _e923 {
                                                    phi_3122_ = _e821.member_1;
                                                } else {
                                                    phi_3122_ = _e821.member_2;
                                                }
                                                let _e963 = phi_3122_;
                                                phi_3123_ = _e963;
                                                phi_3124_ = (_e543 + 1u);
                                            } else {
                                                phi_3123_ = type_49();
                                                phi_3124_ = u32();
                                            }
                                            let _e965 = phi_3123_;
                                            let _e967 = phi_3124_;
                                            phi_3126_ = _e965;
                                            phi_3127_ = _e967;
                                            phi_3128_ = select(true, false, _e922);
                                        } else {
                                            phi_3126_ = type_49();
                                            phi_3127_ = u32();
                                            phi_3128_ = true;
                                        }
                                        let _e970 = phi_3126_;
                                        let _e972 = phi_3127_;
                                        let _e974 = phi_3128_;
                                        if _e974 {
                                            if _e921 {
                                                phi_3137_ = _e821.member_1;
                                            } else {
                                                phi_3137_ = _e821.member_2;
                                            }
                                            let _e978 = phi_3137_;
                                            phi_3142_ = _e978;
                                            phi_3143_ = select(_e922, true, _e921);
                                        } else {
                                            phi_3142_ = _e970;
                                            phi_3143_ = _e541;
                                        }
                                        let _e981 = phi_3142_;
                                        let _e983 = phi_3143_;
                                        phi_3521_ = _e498;
                                        phi_3145_ = _e500;
                                        phi_3146_ = _e981;
                                        phi_3147_ = _e983;
                                        phi_3148_ = select(_e972, _e543, _e974);
                                    }
                                    let _e1566 = phi_3521_;
                                    let _e1568 = phi_3145_;
                                    let _e1570 = phi_3146_;
                                    let _e1572 = phi_3147_;
                                    let _e1574 = phi_3148_;
                                    phi_3520_ = _e1566;
                                    phi_3149_ = _e1568;
                                    phi_3150_ = _e1570;
                                    phi_3151_ = (_e504 - 1u);
                                    phi_3152_ = _e1572;
                                    phi_3153_ = _e1574;
                                } else {
                                    phi_3520_ = _e498;
                                    phi_3149_ = _e500;
                                    phi_3150_ = _e539;
                                    phi_3151_ = _e504;
                                    phi_3152_ = _e541;
                                    phi_3153_ = _e543;
                                }
                                let _e1576 = phi_3520_;
                                let _e1578 = phi_3149_;
                                let _e1580 = phi_3150_;
                                let _e1582 = phi_3151_;
                                let _e1584 = phi_3152_;
                                let _e1586 = phi_3153_;
                                phi_3519_ = _e1576;
                                phi_3154_ = _e1578;
                                phi_3155_ = _e1580;
                                phi_3156_ = _e1582;
                                phi_3157_ = _e1584;
                                phi_3158_ = _e1586;
                            } else {
                                phi_3519_ = _e498;
                                phi_3154_ = type_42();
                                phi_3155_ = type_49();
                                phi_3156_ = u32();
                                phi_3157_ = bool();
                                phi_3158_ = u32();
                            }
                            let _e1588 = phi_3519_;
                            let _e1590 = phi_3154_;
                            let _e1592 = phi_3155_;
                            let _e1594 = phi_3156_;
                            let _e1596 = phi_3157_;
                            let _e1598 = phi_3158_;
                            phi_3518_ = _e1588;
                            phi_823_ = _e1590;
                            phi_826_ = _e1592;
                            phi_828_ = _e1594;
                            phi_830_ = _e1596;
                            phi_832_ = _e1598;
                            phi_3159_ = _e512;
                        } else {
                            phi_3518_ = _e498;
                            phi_823_ = type_42();
                            phi_826_ = type_49();
                            phi_828_ = u32();
                            phi_830_ = bool();
                            phi_832_ = u32();
                            phi_3159_ = false;
                        }
                        let _e1600 = phi_3518_;
                        let _e1602 = phi_823_;
                        let _e1604 = phi_826_;
                        let _e1606 = phi_828_;
                        let _e1608 = phi_830_;
                        let _e1610 = phi_832_;
                        let _e1612 = phi_3159_;
                        continue;
                        continuing {
                            phi_3384_ = _e1600;
                            phi_822_ = _e1602;
                            phi_825_ = _e1604;
                            phi_827_ = _e1606;
                            phi_829_ = _e1608;
                            phi_831_ = _e1610;
                            phi_3517_ = _e1600;
                            break if !(_e1612);
                        }
                    }
                    let _e1615 = phi_3517_;
                    if _e1615 {
                        break;
                    }
                    let _e1617 = local_11;
                    if _e144 {
                    } else {
                        break;
                    }
                    global_6.member[_e142] = select(0u, 1u, _e1617.member_1);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_any_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
