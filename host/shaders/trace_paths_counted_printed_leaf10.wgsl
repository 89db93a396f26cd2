struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_19 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_21 {
    member: array<type_19>,
}

struct type_23 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_24 {
    member: type_23,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_26 {
    member: array<type_24>,
}

struct type_34 {
    member: type_19,
    member_1: f32,
}

struct type_36 {
    member: type_34,
    member_1: u32,
    member_2: u32,
}

struct type_38 {
    member: array<vec4<u32>, 2>,
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

struct type_45 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_47 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_49 {
    member: array<type_47>,
}

struct type_53 {
    member: type_45,
    member_1: u32,
}

struct type_58 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(4) 
var<storage, read_write> global_1: type_21;
@group(0) @binding(0) 
var<uniform> global_2: type_38;
@group(0) @binding(3) 
var<storage> global_3: type_26;
@group(0) @binding(5) 
var<storage, read_write> global_4: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_5: type_58;
@group(0) @binding(1) 
var<storage> global_6: type_42;
@group(0) @binding(2) 
var<storage> global_7: type_49;

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
    var phi_340_: i32;
    var phi_341_: i32;
    var phi_351_: bool;
    var phi_361_: u32;
    var phi_362_: u32;
    var phi_364_: bool;
    var phi_369_: u32;
    var phi_401_: i32;
    var phi_419_: f32;
    var phi_425_: f32;
    var phi_436_: f32;
    var phi_442_: f32;
    var phi_465_: f32;
    var phi_476_: f32;
    var phi_485_: f32;
    var phi_491_: f32;
    var phi_502_: f32;
    var phi_508_: f32;
    var phi_531_: f32;
    var phi_542_: f32;
    var phi_551_: f32;
    var phi_557_: f32;
    var phi_568_: f32;
    var phi_574_: f32;
    var phi_597_: f32;
    var phi_608_: f32;
    var phi_708_: f32;
    var phi_709_: f32;
    var phi_3017_: bool;
    var phi_791_: type_36;
    var phi_794_: type_53;
    var phi_796_: u32;
    var phi_798_: bool;
    var phi_800_: u32;
    var phi_811_: bool;
    var phi_897_: type_53;
    var phi_898_: bool;
    var phi_899_: u32;
    var phi_1856_: type_40;
    var phi_2688_: type_53;
    var phi_2765_: type_53;
    var phi_2766_: type_53;
    var phi_2767_: u32;
    var phi_2769_: type_53;
    var phi_2770_: u32;
    var phi_2771_: bool;
    var phi_2778_: type_53;
    var phi_2783_: type_53;
    var phi_2784_: bool;
    var phi_918_: type_36;
    var phi_921_: type_7;
    var phi_922_: type_7;
    var phi_944_: type_7;
    var phi_972_: u32;
    var phi_988_: type_47;
    var phi_1694_: vec3<f32>;
    var phi_1695_: vec3<f32>;
    var phi_1726_: bool;
    var phi_1735_: vec3<f32>;
    var phi_1775_: type_19;
    var phi_1777_: type_19;
    var phi_1778_: bool;
    var phi_1782_: type_19;
    var phi_1783_: type_19;
    var phi_1784_: type_19;
    var phi_1785_: bool;
    var phi_1789_: type_19;
    var phi_1790_: bool;
    var phi_1794_: type_19;
    var phi_1795_: bool;
    var phi_1799_: type_19;
    var phi_1824_: bool;
    var phi_1825_: bool;
    var phi_1832_: type_36;
    var phi_1833_: type_36;
    var phi_1834_: type_36;
    var phi_919_: type_36;
    var phi_3011_: bool;
    var phi_3147_: bool;
    var phi_2786_: type_36;
    var phi_2787_: type_53;
    var phi_2788_: bool;
    var phi_2789_: u32;
    var phi_3146_: bool;
    var phi_2790_: type_36;
    var phi_2791_: type_53;
    var phi_2792_: u32;
    var phi_2793_: bool;
    var phi_2794_: u32;
    var phi_3145_: bool;
    var phi_2795_: type_36;
    var phi_2796_: type_53;
    var phi_2797_: u32;
    var phi_2798_: bool;
    var phi_2799_: u32;
    var phi_3144_: bool;
    var phi_792_: type_36;
    var phi_795_: type_53;
    var phi_797_: u32;
    var phi_799_: bool;
    var phi_801_: u32;
    var phi_2800_: bool;
    var phi_3143_: bool;
    var local_10: type_36;
    var phi_2852_: type_19;
    var local_11: type_36;
    var local_12: type_36;

    switch bitcast<i32>(0u) {
        default: {
            let _e75 = global;
            let _e78 = arrayLength((&global_6.member));
            let _e89 = arrayLength((&global_5.member));
            let _e93 = global_2.member[0u][0u];
            let _e97 = global_2.member[0u][1u];
            let _e101 = global_2.member[0u][2u];
            let _e105 = global_2.member[1u][0u];
            let _e109 = global_2.member[1u][1u];
            let _e113 = global_2.member[1u][2u];
            let _e117 = global_2.member[1u][3u];
            let _e121 = (_e75.x + (_e75.y * 2097152u));
            let _e128 = (_e121 < arrayLength((&global_3.member)));
            if _e128 {
                let _e129 = (_e121 < arrayLength((&global_1.member)));
                if _e129 {
                    let _e130 = (_e121 < arrayLength((&global_4.member)));
                    if _e130 {
                        if _e128 {
                        } else {
                            break;
                        }
                        let _e140 = global_3.member[_e121].member.member_2[0u];
                        let _e142 = (bitcast<u32>(_e140) & 2147483647u);
                        let _e148 = global_3.member[_e121].member.member_2[1u];
                        let _e150 = (bitcast<u32>(_e148) & 2147483647u);
                        let _e156 = global_3.member[_e121].member.member_2[2u];
                        let _e158 = (bitcast<u32>(_e156) & 2147483647u);
                        let _e164 = global_3.member[_e121].member.member[0u];
                        let _e166 = (bitcast<u32>(_e164) & 2147483647u);
                        let _e172 = global_3.member[_e121].member.member[1u];
                        let _e174 = (bitcast<u32>(_e172) & 2147483647u);
                        let _e180 = global_3.member[_e121].member.member[2u];
                        let _e182 = (bitcast<u32>(_e180) & 2147483647u);
                        let _e184 = select(_e150, _e142, (_e150 < _e142));
                        let _e186 = select(_e158, _e184, (_e158 < _e184));
                        let _e188 = select(_e166, _e186, (_e166 < _e186));
                        let _e190 = select(_e174, _e188, (_e174 < _e188));
                        let _e192 = select(_e182, _e190, (_e182 < _e190));
                        let _e197 = global_3.member[_e121].member.member_1;
                        let _e199 = (bitcast<u32>(_e197) & 2147483647u);
                        let _e207 = global_3.member[_e121].member.member_3;
                        let _e213 = (((select(_e199, _e192, (_e199 < _e192)) < 2139095040u) && ((bitcast<u32>(_e207) & 2147483647u) <= 2139095040u)) && (_e186 > 0u));
                        if _e213 {
                            let _e216 = (bitcast<u32>(bitcast<f32>(_e186)) & 2147483647u);
                            if (_e216 >= 8388608u) {
                                phi_340_ = (bitcast<i32>((_e216 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_340_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e216)), 32u, (_e216 == 0u))));
                            }
                            let _e230 = phi_340_;
                            phi_341_ = _e230;
                        } else {
                            phi_341_ = 0i;
                        }
                        let _e232 = phi_341_;
                        let _e233 = (_e142 == _e186);
                        if _e233 {
                            phi_351_ = true;
                        } else {
                            phi_351_ = (_e150 == _e186);
                        }
                        let _e236 = phi_351_;
                        let _e237 = select(1u, 0u, _e233);
                        if _e236 {
                            let _e238 = (_e237 + 1u);
                            phi_361_ = _e238;
                            phi_362_ = _e238;
                            phi_364_ = select(true, false, (_e238 == 2u));
                        } else {
                            phi_361_ = u32();
                            phi_362_ = 0u;
                            phi_364_ = true;
                        }
                        let _e242 = phi_361_;
                        let _e244 = phi_362_;
                        let _e246 = phi_364_;
                        if _e246 {
                            phi_369_ = (_e244 + 1u);
                        } else {
                            phi_369_ = 0u;
                        }
                        let _e250 = phi_369_;
                        let _e251 = select(_e242, _e244, _e246);
                        let _e252 = select(_e237, select(2u, _e237, _e236), _e246);
                        let _e253 = -(_e232);
                        if (_e253 < -126i) {
                            phi_401_ = -126i;
                        } else {
                            phi_401_ = select(_e253, 127i, (_e253 > 127i));
                        }
                        let _e258 = phi_401_;
                        let _e263 = bitcast<f32>((bitcast<u32>((_e258 + 127i)) << bitcast<u32>(23i)));
                        let _e269 = bitcast<f32>((bitcast<u32>(((_e253 - _e258) + 127i)) << bitcast<u32>(23i)));
                        let _e274 = global_3.member[_e121].member.member;
                        let _e275 = (_e251 == 0u);
                        if _e275 {
                            phi_419_ = _e274[0];
                        } else {
                            phi_419_ = _e274[1];
                        }
                        let _e279 = phi_419_;
                        let _e280 = (_e251 == 2u);
                        if _e280 {
                            phi_425_ = _e274[2];
                        } else {
                            phi_425_ = _e279;
                        }
                        let _e283 = phi_425_;
                        let _e284 = global_3.member[_e121].member.member_2;
                        if _e275 {
                            phi_436_ = _e284[0];
                        } else {
                            phi_436_ = _e284[1];
                        }
                        let _e288 = phi_436_;
                        if _e280 {
                            phi_442_ = _e284[2];
                        } else {
                            phi_442_ = _e288;
                        }
                        let _e291 = phi_442_;
                        let _e293 = ((_e291 * _e263) * _e269);
                        let _e297 = (bitcast<f32>((bitcast<u32>(_e293) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e297 {
                            let _e301 = (bitcast<f32>((bitcast<u32>(_e283) & 2147483647u)) * 0.00000011920929f);
                            phi_465_ = select(0.00000000000011368684f, _e301, (_e301 > 0.00000000000011368684f));
                        } else {
                            phi_465_ = 0f;
                        }
                        let _e305 = phi_465_;
                        let _e306 = (_e283 + _e305);
                        let _e307 = (_e283 - _e305);
                        let _e308 = select(_e293, 0f, _e297);
                        if _e297 {
                            phi_476_ = 38685626000000000000000000f;
                        } else {
                            phi_476_ = (1f / _e293);
                        }
                        let _e311 = phi_476_;
                        let _e312 = (_e250 == 0u);
                        if _e312 {
                            phi_485_ = _e274[0];
                        } else {
                            phi_485_ = _e274[1];
                        }
                        let _e316 = phi_485_;
                        let _e317 = (_e250 == 2u);
                        if _e317 {
                            phi_491_ = _e274[2];
                        } else {
                            phi_491_ = _e316;
                        }
                        let _e320 = phi_491_;
                        if _e312 {
                            phi_502_ = _e284[0];
                        } else {
                            phi_502_ = _e284[1];
                        }
                        let _e324 = phi_502_;
                        if _e317 {
                            phi_508_ = _e284[2];
                        } else {
                            phi_508_ = _e324;
                        }
                        let _e327 = phi_508_;
                        let _e329 = ((_e327 * _e263) * _e269);
                        let _e333 = (bitcast<f32>((bitcast<u32>(_e329) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e333 {
                            let _e337 = (bitcast<f32>((bitcast<u32>(_e320) & 2147483647u)) * 0.00000011920929f);
                            phi_531_ = select(0.00000000000011368684f, _e337, (_e337 > 0.00000000000011368684f));
                        } else {
                            phi_531_ = 0f;
                        }
                        let _e341 = phi_531_;
                        let _e342 = (_e320 + _e341);
                        let _e343 = (_e320 - _e341);
                        let _e344 = select(_e329, 0f, _e333);
                        if _e333 {
                            phi_542_ = 38685626000000000000000000f;
                        } else {
                            phi_542_ = (1f / _e329);
                        }
                        let _e347 = phi_542_;
                        let _e348 = (_e252 == 0u);
                        if _e348 {
                            phi_551_ = _e274[0];
                        } else {
                            phi_551_ = _e274[1];
                        }
                        let _e352 = phi_551_;
                        let _e353 = (_e252 == 2u);
                        if _e353 {
                            phi_557_ = _e274[2];
                        } else {
                            phi_557_ = _e352;
                        }
                        let _e356 = phi_557_;
                        if _e348 {
                            phi_568_ = _e284[0];
                        } else {
                            phi_568_ = _e284[1];
                        }
                        let _e360 = phi_568_;
                        if _e353 {
                            phi_574_ = _e284[2];
                        } else {
                            phi_574_ = _e360;
                        }
                        let _e363 = phi_574_;
                        let _e365 = ((_e363 * _e263) * _e269);
                        let _e369 = (bitcast<f32>((bitcast<u32>(_e365) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e369 {
                            let _e373 = (bitcast<f32>((bitcast<u32>(_e356) & 2147483647u)) * 0.00000011920929f);
                            phi_597_ = select(0.00000000000011368684f, _e373, (_e373 > 0.00000000000011368684f));
                        } else {
                            phi_597_ = 0f;
                        }
                        let _e377 = phi_597_;
                        let _e378 = (_e356 + _e377);
                        let _e379 = (_e356 - _e377);
                        let _e380 = select(_e365, 0f, _e369);
                        if _e369 {
                            phi_608_ = 38685626000000000000000000f;
                        } else {
                            phi_608_ = (1f / _e365);
                        }
                        let _e383 = phi_608_;
                        let _e386 = bitcast<f32>((bitcast<u32>(_e283) & 2147483647u));
                        let _e389 = bitcast<f32>((bitcast<u32>(_e320) & 2147483647u));
                        let _e391 = select(_e389, _e386, (_e386 > _e389));
                        let _e394 = bitcast<f32>((bitcast<u32>(_e356) & 2147483647u));
                        if (_e213 && (select(_e394, _e391, (_e391 > _e394)) <= 1099511600000f)) {
                            let _e399 = (_e232 / 3i);
                            let _e406 = bitcast<f32>((bitcast<u32>((_e399 + 127i)) << bitcast<u32>(23i)));
                            let _e413 = bitcast<f32>((bitcast<u32>(((_e232 - (2i * _e399)) + 127i)) << bitcast<u32>(23i)));
                            let _e414 = (((_e197 * _e406) * _e406) * _e413);
                            let _e416 = select(340282350000000000000000000000000000000f, _e414, (_e414 < 340282350000000000000000000000000000000f));
                            let _e421 = (((_e207 * _e406) * _e406) * _e413);
                            let _e423 = select(340282350000000000000000000000000000000f, _e421, (_e421 < 340282350000000000000000000000000000000f));
                            phi_708_ = select(-340282350000000000000000000000000000000f, _e423, (_e423 > -340282350000000000000000000000000000000f));
                            phi_709_ = select(-340282350000000000000000000000000000000f, _e416, (_e416 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_708_ = 0f;
                            phi_709_ = 1f;
                        }
                        let _e427 = phi_708_;
                        let _e429 = phi_709_;
                        if _e128 {
                        } else {
                            break;
                        }
                        let _e435 = global_3.member[_e121].member_2;
                        local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 3>(bitcast<f32>(_e93), bitcast<f32>(_e97), bitcast<f32>(_e101));
                        let _e439 = (_e251 % 3u);
                        let _e440 = (_e439 < 3u);
                        if _e440 {
                        } else {
                            break;
                        }
                        let _e442 = local_9[_e439];
                        let _e443 = (_e250 % 3u);
                        let _e444 = (_e443 < 3u);
                        if _e444 {
                        } else {
                            break;
                        }
                        let _e446 = local_9[_e443];
                        let _e447 = (_e252 % 3u);
                        let _e448 = (_e447 < 3u);
                        if _e448 {
                        } else {
                            break;
                        }
                        let _e450 = local_9[_e447];
                        local_8 = array<f32, 3>(bitcast<f32>(_e105), bitcast<f32>(_e109), bitcast<f32>(_e113));
                        if _e440 {
                        } else {
                            break;
                        }
                        let _e454 = local_8[_e439];
                        if _e444 {
                        } else {
                            break;
                        }
                        let _e456 = local_8[_e443];
                        if _e448 {
                        } else {
                            break;
                        }
                        let _e458 = local_8[_e447];
                        phi_3017_ = false;
                        phi_791_ = type_36(type_34(type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e427), 0u, 0u);
                        phi_794_ = type_53(type_45(array<f32, 3>(_e442, _e446, _e450), array<f32, 3>(_e454, _e456, _e458)), select(0u, 2147483648u, (_e78 == 0u)));
                        phi_796_ = ((3u * _e78) + 1u);
                        phi_798_ = (_e429 <= _e427);
                        phi_800_ = 0u;
                        loop {
                            let _e466 = phi_3017_;
                            let _e468 = phi_791_;
                            let _e470 = phi_794_;
                            let _e472 = phi_796_;
                            let _e474 = phi_798_;
                            let _e476 = phi_800_;
                            local_10 = _e468;
                            local_11 = _e468;
                            if _e474 {
                                phi_811_ = true;
                            } else {
                                phi_811_ = (_e476 > 0u);
                            }
                            let _e479 = phi_811_;
                            if _e479 {
                                let _e480 = (_e472 > 0u);
                                if _e480 {
                                    if _e474 {
                                        phi_897_ = _e470;
                                        phi_898_ = _e474;
                                        phi_899_ = _e476;
                                    } else {
                                        let _e481 = (_e476 - 1u);
                                        let _e482 = (_e481 % 128u);
                                        let _e483 = (_e482 < 128u);
                                        if _e483 {
                                        } else {
                                            phi_3143_ = true;
                                            break;
                                        }
                                        let _e485 = local_6[_e482];
                                        if _e483 {
                                        } else {
                                            phi_3143_ = true;
                                            break;
                                        }
                                        let _e487 = local_5[_e482];
                                        if _e483 {
                                        } else {
                                            phi_3143_ = true;
                                            break;
                                        }
                                        let _e489 = local_4[_e482];
                                        if _e483 {
                                        } else {
                                            phi_3143_ = true;
                                            break;
                                        }
                                        let _e491 = local_3[_e482];
                                        if _e483 {
                                        } else {
                                            phi_3143_ = true;
                                            break;
                                        }
                                        let _e494 = local_2[_e482];
                                        if _e483 {
                                        } else {
                                            phi_3143_ = true;
                                            break;
                                        }
                                        let _e496 = local_1[_e482];
                                        if _e483 {
                                        } else {
                                            phi_3143_ = true;
                                            break;
                                        }
                                        let _e498 = local[_e482];
                                        if _e483 {
                                        } else {
                                            phi_3143_ = true;
                                            break;
                                        }
                                        let _e503 = local_7[_e482];
                                        phi_897_ = type_53(type_45(array<f32, 3>(_e487, _e489, _e491), array<f32, 3>(_e494, _e496, _e498)), _e485);
                                        phi_898_ = (_e503 <= _e468.member.member_1);
                                        phi_899_ = _e481;
                                    }
                                    let _e508 = phi_897_;
                                    let _e510 = phi_898_;
                                    let _e512 = phi_899_;
                                    if _e510 {
                                        if ((_e508.member_1 & 2147483648u) != 0u) {
                                            phi_918_ = _e468;
                                            phi_921_ = type_7(0u, ((_e508.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e872 = phi_918_;
                                                let _e874 = phi_921_;
                                                local_12 = _e872;
                                                if (_e874.member < _e874.member_1) {
                                                    phi_922_ = type_7((_e874.member + 1u), _e874.member_1);
                                                    phi_944_ = type_7(1u, _e874.member);
                                                } else {
                                                    phi_922_ = _e874;
                                                    phi_944_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e887 = phi_922_;
                                                let _e889 = phi_944_;
                                                let _e893 = (bitcast<i32>(_e889.member) != 0i);
                                                if _e893 {
                                                    let _e899 = type_36(_e872.member, _e872.member_1, (_e872.member_2 + 1u));
                                                    let _e900 = ((_e508.member_1 & 268435455u) + _e889.member_1);
                                                    let _e901 = (_e900 < arrayLength((&global_7.member)));
                                                    if _e901 {
                                                        if _e901 {
                                                        } else {
                                                            phi_3011_ = true;
                                                            break;
                                                        }
                                                        let _e904 = global_7.member[_e900].member_1;
                                                        phi_972_ = _e904;
                                                    } else {
                                                        phi_972_ = 4294967295u;
                                                    }
                                                    let _e906 = phi_972_;
                                                    if _e901 {
                                                        if _e901 {
                                                        } else {
                                                            phi_3011_ = true;
                                                            break;
                                                        }
                                                        let _e908 = global_7.member[_e900];
                                                        phi_988_ = _e908;
                                                    } else {
                                                        phi_988_ = type_47(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                    }
                                                    let _e910 = phi_988_;
                                                    let _e922 = ((10u * _e251) & 31u);
                                                    let _e925 = ((_e910.member[0] >> bitcast<u32>(_e922)) & 1023u);
                                                    let _e930 = bitcast<f32>((bitcast<u32>(((_e508.member.member_1[0] - _e508.member.member[0]) * 0.0009775171f)) ^ _e117));
                                                    let _e936 = (_e508.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e925) * _e930)) ^ _e117)));
                                                    let _e940 = select(select(_e508.member.member_1[0], _e936, (_e936 < _e508.member.member_1[0])), _e508.member.member_1[0], (_e925 == 1023u));
                                                    let _e942 = ((10u * _e250) & 31u);
                                                    let _e945 = ((_e910.member[0] >> bitcast<u32>(_e942)) & 1023u);
                                                    let _e950 = bitcast<f32>((bitcast<u32>(((_e508.member.member_1[1] - _e508.member.member[1]) * 0.0009775171f)) ^ _e117));
                                                    let _e956 = (_e508.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e945) * _e950)) ^ _e117)));
                                                    let _e960 = select(select(_e508.member.member_1[1], _e956, (_e956 < _e508.member.member_1[1])), _e508.member.member_1[1], (_e945 == 1023u));
                                                    let _e962 = ((10u * _e252) & 31u);
                                                    let _e965 = ((_e910.member[0] >> bitcast<u32>(_e962)) & 1023u);
                                                    let _e970 = bitcast<f32>((bitcast<u32>(((_e508.member.member_1[2] - _e508.member.member[2]) * 0.0009775171f)) ^ _e117));
                                                    let _e976 = (_e508.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e965) * _e970)) ^ _e117)));
                                                    let _e980 = select(select(_e508.member.member_1[2], _e976, (_e976 < _e508.member.member_1[2])), _e508.member.member_1[2], (_e965 == 1023u));
                                                    let _e984 = ((_e910.member[1] >> bitcast<u32>(_e922)) & 1023u);
                                                    let _e990 = (_e508.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e984) * _e930)) ^ _e117)));
                                                    let _e994 = select(select(_e508.member.member_1[0], _e990, (_e990 < _e508.member.member_1[0])), _e508.member.member_1[0], (_e984 == 1023u));
                                                    let _e997 = ((_e910.member[1] >> bitcast<u32>(_e942)) & 1023u);
                                                    let _e1003 = (_e508.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e997) * _e950)) ^ _e117)));
                                                    let _e1007 = select(select(_e508.member.member_1[1], _e1003, (_e1003 < _e508.member.member_1[1])), _e508.member.member_1[1], (_e997 == 1023u));
                                                    let _e1010 = ((_e910.member[1] >> bitcast<u32>(_e962)) & 1023u);
                                                    let _e1016 = (_e508.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1010) * _e970)) ^ _e117)));
                                                    let _e1020 = select(select(_e508.member.member_1[2], _e1016, (_e1016 < _e508.member.member_1[2])), _e508.member.member_1[2], (_e1010 == 1023u));
                                                    let _e1024 = ((_e910.member[2] >> bitcast<u32>(_e922)) & 1023u);
                                                    let _e1030 = (_e508.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1024) * _e930)) ^ _e117)));
                                                    let _e1034 = select(select(_e508.member.member_1[0], _e1030, (_e1030 < _e508.member.member_1[0])), _e508.member.member_1[0], (_e1024 == 1023u));
                                                    let _e1037 = ((_e910.member[2] >> bitcast<u32>(_e942)) & 1023u);
                                                    let _e1043 = (_e508.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1037) * _e950)) ^ _e117)));
                                                    let _e1047 = select(select(_e508.member.member_1[1], _e1043, (_e1043 < _e508.member.member_1[1])), _e508.member.member_1[1], (_e1037 == 1023u));
                                                    let _e1050 = ((_e910.member[2] >> bitcast<u32>(_e962)) & 1023u);
                                                    let _e1056 = (_e508.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1050) * _e970)) ^ _e117)));
                                                    let _e1060 = select(select(_e508.member.member_1[2], _e1056, (_e1056 < _e508.member.member_1[2])), _e508.member.member_1[2], (_e1050 == 1023u));
                                                    let _e1065 = (_e980 - _e356);
                                                    let _e1068 = (((_e940 - _e283) * _e380) - (_e1065 * _e308));
                                                    let _e1071 = (((_e960 - _e320) * _e380) - (_e1065 * _e344));
                                                    let _e1074 = (_e1020 - _e356);
                                                    let _e1077 = (((_e994 - _e283) * _e380) - (_e1074 * _e308));
                                                    let _e1080 = (((_e1007 - _e320) * _e380) - (_e1074 * _e344));
                                                    let _e1083 = (_e1060 - _e356);
                                                    let _e1086 = (((_e1034 - _e283) * _e380) - (_e1083 * _e308));
                                                    let _e1089 = (((_e1047 - _e320) * _e380) - (_e1083 * _e344));
                                                    let _e1090 = (_e1086 * _e1080);
                                                    let _e1091 = (_e1089 * _e1077);
                                                    let _e1092 = (_e1068 * _e1089);
                                                    let _e1093 = (_e1071 * _e1086);
                                                    let _e1094 = (_e1077 * _e1071);
                                                    let _e1095 = (_e1080 * _e1068);
                                                    let _e1100 = (((_e1090 >= _e1091) && (_e1092 >= _e1093)) && (_e1094 >= _e1095));
                                                    if (_e1100 || (((_e1090 <= _e1091) && (_e1092 <= _e1093)) && (_e1094 <= _e1095))) {
                                                        let _e1107 = select(-1f, 1f, _e1100);
                                                        let _e1109 = ((_e1090 - _e1091) * _e1107);
                                                        let _e1111 = select(0f, _e1109, (_e1109 > 0f));
                                                        let _e1113 = ((_e1092 - _e1093) * _e1107);
                                                        let _e1115 = select(0f, _e1113, (_e1113 > 0f));
                                                        let _e1117 = ((_e1094 - _e1095) * _e1107);
                                                        let _e1119 = select(0f, _e1117, (_e1117 > 0f));
                                                        let _e1121 = ((_e1111 + _e1115) + _e1119);
                                                        if (_e1121 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1789_ = type_19();
                                                            phi_1790_ = true;
                                                        } else {
                                                            let _e1124 = select(_e994, _e940, (_e940 < _e994));
                                                            let _e1128 = select(_e994, _e940, (_e940 > _e994));
                                                            let _e1132 = select(_e1007, _e960, (_e960 < _e1007));
                                                            let _e1136 = select(_e1007, _e960, (_e960 > _e1007));
                                                            let _e1140 = select(_e1020, _e980, (_e980 < _e1020));
                                                            let _e1144 = select(_e1020, _e980, (_e980 > _e1020));
                                                            let _e1149 = ((select(_e1034, _e1124, (_e1124 < _e1034)) - _e306) * _e311);
                                                            let _e1150 = ((select(_e1034, _e1128, (_e1128 > _e1034)) - _e307) * _e311);
                                                            let _e1153 = ((select(_e1047, _e1132, (_e1132 < _e1047)) - _e342) * _e347);
                                                            let _e1154 = ((select(_e1047, _e1136, (_e1136 > _e1047)) - _e343) * _e347);
                                                            let _e1157 = ((select(_e1060, _e1140, (_e1140 < _e1060)) - _e378) * _e383);
                                                            let _e1158 = ((select(_e1060, _e1144, (_e1144 > _e1060)) - _e379) * _e383);
                                                            let _e1160 = select(_e1158, _e1157, (_e1157 < _e1158));
                                                            let _e1162 = select(_e1158, _e1157, (_e1157 > _e1158));
                                                            let _e1164 = select(_e1150, _e1149, (_e1149 < _e1150));
                                                            let _e1166 = select(_e1154, _e1153, (_e1153 < _e1154));
                                                            let _e1168 = select(_e1166, _e1164, (_e1164 > _e1166));
                                                            let _e1170 = select(_e1160, _e1168, (_e1168 > _e1160));
                                                            let _e1172 = select(_e1150, _e1149, (_e1149 > _e1150));
                                                            let _e1174 = select(_e1154, _e1153, (_e1153 > _e1154));
                                                            let _e1176 = select(_e1174, _e1172, (_e1172 < _e1174));
                                                            let _e1178 = select(_e1162, _e1176, (_e1176 < _e1162));
                                                            let _e1179 = -(_e1160);
                                                            let _e1185 = select(_e429, _e1170, (_e1170 > _e429));
                                                            if (_e1185 > (_e1178 + (select(_e1179, _e1162, (_e1162 > _e1179)) * 0.0000019073523f))) {
                                                                phi_1784_ = type_19();
                                                                phi_1785_ = true;
                                                            } else {
                                                                let _e1187 = (_e1185 > _e872.member.member_1);
                                                                if _e1187 {
                                                                    phi_1783_ = type_19();
                                                                } else {
                                                                    let _e1191 = (_e994 - _e940);
                                                                    let _e1192 = (_e1007 - _e960);
                                                                    let _e1193 = (_e1020 - _e980);
                                                                    let _e1194 = vec3<f32>(_e1191, _e1192, _e1193);
                                                                    let _e1195 = (_e1034 - _e994);
                                                                    let _e1196 = (_e1047 - _e1007);
                                                                    let _e1197 = (_e1060 - _e1020);
                                                                    let _e1198 = vec3<f32>(_e1195, _e1196, _e1197);
                                                                    let _e1199 = (_e940 - _e1034);
                                                                    let _e1200 = (_e960 - _e1047);
                                                                    let _e1201 = (_e980 - _e1060);
                                                                    let _e1202 = vec3<f32>(_e1199, _e1200, _e1201);
                                                                    let _e1205 = bitcast<f32>((bitcast<u32>(_e1191) & 2147483647u));
                                                                    let _e1208 = bitcast<f32>((bitcast<u32>(_e1192) & 2147483647u));
                                                                    let _e1210 = select(_e1208, _e1205, (_e1205 > _e1208));
                                                                    let _e1213 = bitcast<f32>((bitcast<u32>(_e1193) & 2147483647u));
                                                                    let _e1215 = select(_e1213, _e1210, (_e1210 > _e1213));
                                                                    let _e1218 = bitcast<f32>((bitcast<u32>(_e1195) & 2147483647u));
                                                                    let _e1221 = bitcast<f32>((bitcast<u32>(_e1196) & 2147483647u));
                                                                    let _e1223 = select(_e1221, _e1218, (_e1218 > _e1221));
                                                                    let _e1226 = bitcast<f32>((bitcast<u32>(_e1197) & 2147483647u));
                                                                    let _e1228 = select(_e1226, _e1223, (_e1223 > _e1226));
                                                                    let _e1231 = bitcast<f32>((bitcast<u32>(_e1199) & 2147483647u));
                                                                    let _e1234 = bitcast<f32>((bitcast<u32>(_e1200) & 2147483647u));
                                                                    let _e1236 = select(_e1234, _e1231, (_e1231 > _e1234));
                                                                    let _e1239 = bitcast<f32>((bitcast<u32>(_e1201) & 2147483647u));
                                                                    let _e1241 = select(_e1239, _e1236, (_e1236 > _e1239));
                                                                    let _e1243 = select(_e1228, _e1215, (_e1215 > _e1228));
                                                                    let _e1245 = select(_e1241, _e1243, (_e1243 > _e1241));
                                                                    if (_e1215 == _e1245) {
                                                                        phi_1694_ = _e1198;
                                                                        phi_1695_ = _e1202;
                                                                    } else {
                                                                        let _e1248 = vec3((_e1228 == _e1245));
                                                                        phi_1694_ = select(_e1194, _e1202, _e1248);
                                                                        phi_1695_ = select(_e1198, _e1194, _e1248);
                                                                    }
                                                                    let _e1252 = phi_1694_;
                                                                    let _e1254 = phi_1695_;
                                                                    let _e1261 = ((_e1252.y * _e1254.z) - (_e1254.y * _e1252.z));
                                                                    let _e1266 = ((_e1252.z * _e1254.x) - (_e1254.z * _e1252.x));
                                                                    let _e1269 = ((_e1252.x * _e1254.y) - (_e1254.x * _e1252.y));
                                                                    if (_e1111 >= _e1115) {
                                                                        phi_1726_ = select(true, false, (_e1111 >= _e1119));
                                                                    } else {
                                                                        phi_1726_ = true;
                                                                    }
                                                                    let _e1274 = phi_1726_;
                                                                    if _e1274 {
                                                                        phi_1735_ = select(vec3<f32>(_e1034, _e1047, _e1060), vec3<f32>(_e994, _e1007, _e1020), vec3((_e1115 >= _e1119)));
                                                                    } else {
                                                                        phi_1735_ = vec3<f32>(_e940, _e960, _e980);
                                                                    }
                                                                    let _e1279 = phi_1735_;
                                                                    let _e1296 = ((((_e1261 * (_e1279.x - _e283)) + (_e1266 * (_e1279.y - _e320))) + (_e1269 * (_e1279.z - _e356))) / (((_e1261 * _e308) + (_e1266 * _e344)) + (_e1269 * _e380)));
                                                                    let _e1298 = select(_e1178, _e1296, (_e1296 < _e1178));
                                                                    let _e1300 = select(_e1170, _e1298, (_e1298 > _e1170));
                                                                    if (_e1300 >= _e429) {
                                                                        let _e1302 = (_e1300 <= _e872.member.member_1);
                                                                        if _e1302 {
                                                                            let _e1303 = (1f / _e1121);
                                                                            phi_1775_ = type_19(_e1300, (_e1115 * _e1303), (_e1119 * _e1303), _e906);
                                                                        } else {
                                                                            phi_1775_ = type_19();
                                                                        }
                                                                        let _e1308 = phi_1775_;
                                                                        phi_1777_ = _e1308;
                                                                        phi_1778_ = select(true, false, _e1302);
                                                                    } else {
                                                                        phi_1777_ = type_19();
                                                                        phi_1778_ = true;
                                                                    }
                                                                    let _e1311 = phi_1777_;
                                                                    let _e1313 = phi_1778_;
                                                                    if _e1313 {
                                                                        phi_1782_ = type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_1782_ = _e1311;
                                                                    }
                                                                    let _e1315 = phi_1782_;
                                                                    phi_1783_ = _e1315;
                                                                }
                                                                let _e1317 = phi_1783_;
                                                                phi_1784_ = _e1317;
                                                                phi_1785_ = _e1187;
                                                            }
                                                            let _e1319 = phi_1784_;
                                                            let _e1321 = phi_1785_;
                                                            phi_1789_ = _e1319;
                                                            phi_1790_ = _e1321;
                                                        }
                                                        let _e1323 = phi_1789_;
                                                        let _e1325 = phi_1790_;
                                                        phi_1794_ = _e1323;
                                                        phi_1795_ = _e1325;
                                                    } else {
                                                        phi_1794_ = type_19();
                                                        phi_1795_ = true;
                                                    }
                                                    let _e1327 = phi_1794_;
                                                    let _e1329 = phi_1795_;
                                                    if _e1329 {
                                                        phi_1799_ = type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1799_ = _e1327;
                                                    }
                                                    let _e1331 = phi_1799_;
                                                    if (_e1331.member_3 != 4294967295u) {
                                                        if (_e906 != _e435) {
                                                            if (_e1331.member < _e872.member.member.member) {
                                                                phi_1825_ = true;
                                                            } else {
                                                                if (_e1331.member == _e872.member.member.member) {
                                                                    phi_1824_ = (_e1331.member_3 < _e872.member.member.member_3);
                                                                } else {
                                                                    phi_1824_ = false;
                                                                }
                                                                let _e1346 = phi_1824_;
                                                                phi_1825_ = _e1346;
                                                            }
                                                            let _e1348 = phi_1825_;
                                                            if _e1348 {
                                                                phi_1832_ = type_36(type_34(_e1331, _e1331.member), _e899.member_1, _e899.member_2);
                                                            } else {
                                                                phi_1832_ = _e899;
                                                            }
                                                            let _e1355 = phi_1832_;
                                                            phi_1833_ = _e1355;
                                                        } else {
                                                            phi_1833_ = _e899;
                                                        }
                                                        let _e1357 = phi_1833_;
                                                        phi_1834_ = _e1357;
                                                    } else {
                                                        phi_1834_ = _e899;
                                                    }
                                                    let _e1359 = phi_1834_;
                                                    phi_919_ = _e1359;
                                                } else {
                                                    phi_919_ = type_36();
                                                }
                                                let _e1361 = phi_919_;
                                                continue;
                                                continuing {
                                                    phi_918_ = _e1361;
                                                    phi_921_ = _e887;
                                                    phi_3011_ = _e466;
                                                    break if !(_e893);
                                                }
                                            }
                                            let _e1364 = phi_3011_;
                                            phi_3143_ = _e1364;
                                            if _e1364 {
                                                break;
                                            }
                                            phi_3147_ = _e1364;
                                            let _e1574 = local_12;
                                            phi_2786_ = _e1574;
                                            phi_2787_ = _e508;
                                            phi_2788_ = false;
                                            phi_2789_ = _e512;
                                        } else {
                                            let _e528 = (_e508.member_1 < _e78);
                                            if _e528 {
                                                if _e528 {
                                                } else {
                                                    phi_3143_ = true;
                                                    break;
                                                }
                                                let _e530 = global_6.member[_e508.member_1];
                                                phi_1856_ = _e530;
                                            } else {
                                                phi_1856_ = type_40(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e532 = phi_1856_;
                                            let _e547 = ((10u * _e251) & 31u);
                                            let _e550 = ((_e532.member[0] >> bitcast<u32>(_e547)) & 1023u);
                                            let _e555 = bitcast<f32>((bitcast<u32>(((_e508.member.member_1[0] - _e508.member.member[0]) * 0.0009775171f)) ^ _e117));
                                            let _e561 = (_e508.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e550) * _e555)) ^ _e117)));
                                            let _e565 = select(select(_e508.member.member_1[0], _e561, (_e561 < _e508.member.member_1[0])), _e508.member.member_1[0], (_e550 == 1023u));
                                            let _e567 = ((10u * _e250) & 31u);
                                            let _e570 = ((_e532.member[0] >> bitcast<u32>(_e567)) & 1023u);
                                            let _e575 = bitcast<f32>((bitcast<u32>(((_e508.member.member_1[1] - _e508.member.member[1]) * 0.0009775171f)) ^ _e117));
                                            let _e581 = (_e508.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e570) * _e575)) ^ _e117)));
                                            let _e585 = select(select(_e508.member.member_1[1], _e581, (_e581 < _e508.member.member_1[1])), _e508.member.member_1[1], (_e570 == 1023u));
                                            let _e587 = ((10u * _e252) & 31u);
                                            let _e590 = ((_e532.member[0] >> bitcast<u32>(_e587)) & 1023u);
                                            let _e595 = bitcast<f32>((bitcast<u32>(((_e508.member.member_1[2] - _e508.member.member[2]) * 0.0009775171f)) ^ _e117));
                                            let _e601 = (_e508.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e590) * _e595)) ^ _e117)));
                                            let _e605 = select(select(_e508.member.member_1[2], _e601, (_e601 < _e508.member.member_1[2])), _e508.member.member_1[2], (_e590 == 1023u));
                                            let _e608 = ((_e532.member[1] >> bitcast<u32>(_e547)) & 1023u);
                                            let _e614 = (_e508.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e608) * _e555)) ^ _e117)));
                                            let _e618 = select(select(_e508.member.member_1[0], _e614, (_e614 < _e508.member.member_1[0])), _e508.member.member_1[0], (_e608 == 1023u));
                                            let _e621 = ((_e532.member[1] >> bitcast<u32>(_e567)) & 1023u);
                                            let _e627 = (_e508.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e621) * _e575)) ^ _e117)));
                                            let _e631 = select(select(_e508.member.member_1[1], _e627, (_e627 < _e508.member.member_1[1])), _e508.member.member_1[1], (_e621 == 1023u));
                                            let _e634 = ((_e532.member[1] >> bitcast<u32>(_e587)) & 1023u);
                                            let _e640 = (_e508.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e634) * _e595)) ^ _e117)));
                                            let _e644 = select(select(_e508.member.member_1[2], _e640, (_e640 < _e508.member.member_1[2])), _e508.member.member_1[2], (_e634 == 1023u));
                                            let _e650 = ((_e532.member_1[0] >> bitcast<u32>(_e547)) & 1023u);
                                            let _e656 = (_e508.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e650) * _e555)) ^ _e117)));
                                            let _e660 = select(select(_e508.member.member_1[0], _e656, (_e656 < _e508.member.member_1[0])), _e508.member.member_1[0], (_e650 == 1023u));
                                            let _e663 = ((_e532.member_1[0] >> bitcast<u32>(_e567)) & 1023u);
                                            let _e669 = (_e508.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e663) * _e575)) ^ _e117)));
                                            let _e673 = select(select(_e508.member.member_1[1], _e669, (_e669 < _e508.member.member_1[1])), _e508.member.member_1[1], (_e663 == 1023u));
                                            let _e676 = ((_e532.member_1[0] >> bitcast<u32>(_e587)) & 1023u);
                                            let _e682 = (_e508.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e676) * _e595)) ^ _e117)));
                                            let _e686 = select(select(_e508.member.member_1[2], _e682, (_e682 < _e508.member.member_1[2])), _e508.member.member_1[2], (_e676 == 1023u));
                                            let _e689 = ((_e532.member_1[1] >> bitcast<u32>(_e547)) & 1023u);
                                            let _e695 = (_e508.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e689) * _e555)) ^ _e117)));
                                            let _e699 = select(select(_e508.member.member_1[0], _e695, (_e695 < _e508.member.member_1[0])), _e508.member.member_1[0], (_e689 == 1023u));
                                            let _e702 = ((_e532.member_1[1] >> bitcast<u32>(_e567)) & 1023u);
                                            let _e708 = (_e508.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e702) * _e575)) ^ _e117)));
                                            let _e712 = select(select(_e508.member.member_1[1], _e708, (_e708 < _e508.member.member_1[1])), _e508.member.member_1[1], (_e702 == 1023u));
                                            let _e715 = ((_e532.member_1[1] >> bitcast<u32>(_e587)) & 1023u);
                                            let _e721 = (_e508.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e715) * _e595)) ^ _e117)));
                                            let _e725 = select(select(_e508.member.member_1[2], _e721, (_e721 < _e508.member.member_1[2])), _e508.member.member_1[2], (_e715 == 1023u));
                                            let _e730 = type_53(type_45(array<f32, 3>(_e565, _e585, _e605), array<f32, 3>(_e618, _e631, _e644)), _e532.member_2);
                                            let _e735 = type_53(type_45(array<f32, 3>(_e660, _e673, _e686), array<f32, 3>(_e699, _e712, _e725)), _e532.member_3);
                                            let _e742 = ((_e565 - _e306) * _e311);
                                            let _e743 = ((_e660 - _e306) * _e311);
                                            let _e744 = ((_e618 - _e307) * _e311);
                                            let _e745 = ((_e699 - _e307) * _e311);
                                            let _e750 = ((_e585 - _e342) * _e347);
                                            let _e751 = ((_e673 - _e342) * _e347);
                                            let _e752 = ((_e631 - _e343) * _e347);
                                            let _e753 = ((_e712 - _e343) * _e347);
                                            let _e758 = ((_e605 - _e378) * _e383);
                                            let _e759 = ((_e686 - _e378) * _e383);
                                            let _e760 = ((_e644 - _e379) * _e383);
                                            let _e761 = ((_e725 - _e379) * _e383);
                                            let _e763 = select(_e760, _e758, (_e758 < _e760));
                                            let _e765 = select(_e761, _e759, (_e759 < _e761));
                                            let _e767 = select(_e760, _e758, (_e758 > _e760));
                                            let _e769 = select(_e761, _e759, (_e759 > _e761));
                                            let _e771 = select(_e744, _e742, (_e742 < _e744));
                                            let _e773 = select(_e745, _e743, (_e743 < _e745));
                                            let _e775 = select(_e752, _e750, (_e750 < _e752));
                                            let _e777 = select(_e753, _e751, (_e751 < _e753));
                                            let _e779 = select(_e775, _e771, (_e771 > _e775));
                                            let _e781 = select(_e777, _e773, (_e773 > _e777));
                                            let _e783 = select(_e763, _e779, (_e779 > _e763));
                                            let _e785 = select(_e765, _e781, (_e781 > _e765));
                                            let _e787 = select(_e744, _e742, (_e742 > _e744));
                                            let _e789 = select(_e745, _e743, (_e743 > _e745));
                                            let _e791 = select(_e752, _e750, (_e750 > _e752));
                                            let _e793 = select(_e753, _e751, (_e751 > _e753));
                                            let _e795 = select(_e791, _e787, (_e787 < _e791));
                                            let _e797 = select(_e793, _e789, (_e789 < _e793));
                                            let _e802 = -(_e763);
                                            let _e803 = -(_e765);
                                            let _e810 = (select(_e767, _e795, (_e795 < _e767)) + (select(_e802, _e767, (_e767 > _e802)) * 0.0000019073523f));
                                            let _e811 = (select(_e769, _e797, (_e797 < _e769)) + (select(_e803, _e769, (_e769 > _e803)) * 0.0000019073523f));
                                            let _e813 = select(_e429, _e783, (_e783 > _e429));
                                            let _e815 = select(_e429, _e785, (_e785 > _e429));
                                            let _e820 = (_e813 <= select(_e468.member.member_1, _e810, (_e810 < _e468.member.member_1)));
                                            let _e821 = (_e815 <= select(_e468.member.member_1, _e811, (_e811 < _e468.member.member_1)));
                                            let _e822 = (_e813 <= _e815);
                                            if _e820 {
                                                if _e821 {
                                                    if _e822 {
                                                        phi_2688_ = _e735;
                                                    } else {
                                                        phi_2688_ = _e730;
                                                    }
                                                    let _e824 = phi_2688_;
                                                    let _e832 = (_e512 % 128u);
                                                    let _e833 = (_e832 < 128u);
                                                    if _e833 {
                                                    } else {
                                                        phi_3143_ = true;
                                                        break;
                                                    }
                                                    local_6[_e832] = _e824.member_1;
                                                    if _e833 {
                                                    } else {
                                                        phi_3143_ = true;
                                                        break;
                                                    }
                                                    local_5[_e832] = _e824.member.member[0];
                                                    if _e833 {
                                                    } else {
                                                        phi_3143_ = true;
                                                        break;
                                                    }
                                                    local_4[_e832] = _e824.member.member[1];
                                                    if _e833 {
                                                    } else {
                                                        phi_3143_ = true;
                                                        break;
                                                    }
                                                    local_3[_e832] = _e824.member.member[2];
                                                    if _e833 {
                                                    } else {
                                                        phi_3143_ = true;
                                                        break;
                                                    }
                                                    local_2[_e832] = _e824.member.member_1[0];
                                                    if _e833 {
                                                    } else {
                                                        phi_3143_ = true;
                                                        break;
                                                    }
                                                    local_1[_e832] = _e824.member.member_1[1];
                                                    if _e833 {
                                                    } else {
                                                        phi_3143_ = true;
                                                        break;
                                                    }
                                                    local[_e832] = _e824.member.member_1[2];
                                                    if _e833 {
                                                    } else {
                                                        phi_3143_ = true;
                                                        break;
                                                    }
                                                    local_7[_e832] = select(_e815, _e813, (_e813 > _e815));
                                                    if _e822 {
                                                        phi_2765_ = _e730;
                                                    } else {
                                                        phi_2765_ = _e735;
                                                    }
                                                    let _e850 = phi_2765_;
                                                    phi_2766_ = _e850;
                                                    phi_2767_ = (_e512 + 1u);
                                                } else {
                                                    phi_2766_ = type_53();
                                                    phi_2767_ = u32();
                                                }
                                                let _e852 = phi_2766_;
                                                let _e854 = phi_2767_;
                                                phi_2769_ = _e852;
                                                phi_2770_ = _e854;
                                                phi_2771_ = select(true, false, _e821);
                                            } else {
                                                phi_2769_ = type_53();
                                                phi_2770_ = u32();
                                                phi_2771_ = true;
                                            }
                                            let _e857 = phi_2769_;
                                            let _e859 = phi_2770_;
                                            let _e861 = phi_2771_;
                                            if _e861 {
                                                if _e820 {
                                                    phi_2778_ = _e730;
                                                } else {
                                                    phi_2778_ = _e735;
                                                }
                                                let _e863 = phi_2778_;
                                                phi_2783_ = _e863;
                                                phi_2784_ = select(_e821, true, _e820);
                                            } else {
                                                phi_2783_ = _e857;
                                                phi_2784_ = _e510;
                                            }
                                            let _e866 = phi_2783_;
                                            let _e868 = phi_2784_;
                                            phi_3147_ = _e466;
                                            phi_2786_ = type_36(_e468.member, (_e468.member_1 + 1u), _e468.member_2);
                                            phi_2787_ = _e866;
                                            phi_2788_ = _e868;
                                            phi_2789_ = select(_e859, _e512, _e861);
                                        }
                                        let _e1366 = phi_3147_;
                                        let _e1368 = phi_2786_;
                                        let _e1370 = phi_2787_;
                                        let _e1372 = phi_2788_;
                                        let _e1374 = phi_2789_;
                                        phi_3146_ = _e1366;
                                        phi_2790_ = _e1368;
                                        phi_2791_ = _e1370;
                                        phi_2792_ = (_e472 - 1u);
                                        phi_2793_ = _e1372;
                                        phi_2794_ = _e1374;
                                    } else {
                                        phi_3146_ = _e466;
                                        phi_2790_ = _e468;
                                        phi_2791_ = _e508;
                                        phi_2792_ = _e472;
                                        phi_2793_ = _e510;
                                        phi_2794_ = _e512;
                                    }
                                    let _e1376 = phi_3146_;
                                    let _e1378 = phi_2790_;
                                    let _e1380 = phi_2791_;
                                    let _e1382 = phi_2792_;
                                    let _e1384 = phi_2793_;
                                    let _e1386 = phi_2794_;
                                    phi_3145_ = _e1376;
                                    phi_2795_ = _e1378;
                                    phi_2796_ = _e1380;
                                    phi_2797_ = _e1382;
                                    phi_2798_ = _e1384;
                                    phi_2799_ = _e1386;
                                } else {
                                    phi_3145_ = _e466;
                                    phi_2795_ = type_36();
                                    phi_2796_ = type_53();
                                    phi_2797_ = u32();
                                    phi_2798_ = bool();
                                    phi_2799_ = u32();
                                }
                                let _e1388 = phi_3145_;
                                let _e1390 = phi_2795_;
                                let _e1392 = phi_2796_;
                                let _e1394 = phi_2797_;
                                let _e1396 = phi_2798_;
                                let _e1398 = phi_2799_;
                                phi_3144_ = _e1388;
                                phi_792_ = _e1390;
                                phi_795_ = _e1392;
                                phi_797_ = _e1394;
                                phi_799_ = _e1396;
                                phi_801_ = _e1398;
                                phi_2800_ = _e480;
                            } else {
                                phi_3144_ = _e466;
                                phi_792_ = type_36();
                                phi_795_ = type_53();
                                phi_797_ = u32();
                                phi_799_ = bool();
                                phi_801_ = u32();
                                phi_2800_ = false;
                            }
                            let _e1400 = phi_3144_;
                            let _e1402 = phi_792_;
                            let _e1404 = phi_795_;
                            let _e1406 = phi_797_;
                            let _e1408 = phi_799_;
                            let _e1410 = phi_801_;
                            let _e1412 = phi_2800_;
                            continue;
                            continuing {
                                phi_3017_ = _e1400;
                                phi_791_ = _e1402;
                                phi_794_ = _e1404;
                                phi_796_ = _e1406;
                                phi_798_ = _e1408;
                                phi_800_ = _e1410;
                                phi_3143_ = _e1400;
                                break if !(_e1412);
                            }
                        }
                        let _e1415 = phi_3143_;
                        if _e1415 {
                            break;
                        }
                        let _e1417 = local_10;
                        if (_e1417.member.member.member_3 != 4294967295u) {
                            let _e1423 = (_e253 / 3i);
                            let _e1430 = bitcast<f32>((bitcast<u32>((_e1423 + 127i)) << bitcast<u32>(23i)));
                            let _e1438 = (((_e1417.member.member.member * _e1430) * _e1430) * bitcast<f32>((bitcast<u32>(((_e253 - (2i * _e1423)) + 127i)) << bitcast<u32>(23i))));
                            let _e1440 = select(340282350000000000000000000000000000000f, _e1438, (_e1438 < 340282350000000000000000000000000000000f));
                            phi_2852_ = type_19(select(-340282350000000000000000000000000000000f, _e1440, (_e1440 > -340282350000000000000000000000000000000f)), _e1417.member.member.member_1, _e1417.member.member.member_2, _e1417.member.member.member_3);
                        } else {
                            phi_2852_ = type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1447 = phi_2852_;
                        if _e129 {
                        } else {
                            break;
                        }
                        global_1.member[_e121] = _e1447;
                        let _e1451 = local_11;
                        if _e130 {
                        } else {
                            break;
                        }
                        global_4.member[_e121] = _e1451.member_1;
                        if _e128 {
                        } else {
                            break;
                        }
                        let _e1456 = select(0u, 1u, (_e197 <= _e207));
                        if (_e1456 > 0u) {
                            let _e1458 = (1u < _e89);
                            if _e1458 {
                                if (0u < _e89) {
                                } else {
                                    break;
                                }
                                let _e1462 = atomicAdd((&global_5.member[0u]), _e1456);
                                if ((_e1462 + _e1456) < _e1462) {
                                    if _e1458 {
                                    } else {
                                        break;
                                    }
                                    let _e1467 = atomicAdd((&global_5.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1470 = select(0u, 1u, (_e1447.member_3 != 4294967295u));
                        if (_e1470 > 0u) {
                            let _e1472 = (3u < _e89);
                            if _e1472 {
                                if (2u < _e89) {
                                } else {
                                    break;
                                }
                                let _e1476 = atomicAdd((&global_5.member[2u]), _e1470);
                                if ((_e1476 + _e1470) < _e1476) {
                                    if _e1472 {
                                    } else {
                                        break;
                                    }
                                    let _e1481 = atomicAdd((&global_5.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1451.member_1 > 0u) {
                            let _e1483 = (5u < _e89);
                            if _e1483 {
                                if (4u < _e89) {
                                } else {
                                    break;
                                }
                                let _e1487 = atomicAdd((&global_5.member[4u]), _e1451.member_1);
                                if ((_e1487 + _e1451.member_1) < _e1487) {
                                    if _e1483 {
                                    } else {
                                        break;
                                    }
                                    let _e1492 = atomicAdd((&global_5.member[5u]), 1u);
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
fn trace_paths_counted_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
