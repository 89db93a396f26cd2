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

struct type_22 {
    member: array<type_20>,
}

struct type_24 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_28 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_32 {
    member: type_20,
    member_1: f32,
}

struct type_37 {
    member: array<type_24>,
}

struct type_40 {
    member: array<vec4<u32>, 2>,
}

struct type_44 {
    member: array<array<u32, 7>>,
}

struct type_49 {
    member: type_28,
    member_1: u32,
}

struct type_50 {
    member: array<vec4<f32>, 3>,
    member_1: type_49,
    member_2: type_49,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_40;
@group(0) @binding(4) 
var<storage> global_3: type_37;
@group(0) @binding(2) 
var<storage> global_4: type_44;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_22;

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
    var phi_477_: i32;
    var phi_478_: i32;
    var phi_488_: bool;
    var phi_498_: u32;
    var phi_499_: u32;
    var phi_501_: bool;
    var phi_506_: u32;
    var phi_518_: i32;
    var phi_538_: i32;
    var phi_556_: f32;
    var phi_562_: f32;
    var phi_602_: f32;
    var phi_608_: f32;
    var phi_660_: f32;
    var phi_671_: f32;
    var phi_680_: f32;
    var phi_686_: f32;
    var phi_726_: f32;
    var phi_732_: f32;
    var phi_784_: f32;
    var phi_795_: f32;
    var phi_804_: f32;
    var phi_810_: f32;
    var phi_850_: f32;
    var phi_856_: f32;
    var phi_908_: f32;
    var phi_919_: f32;
    var phi_974_: i32;
    var phi_996_: u32;
    var phi_997_: u32;
    var phi_1034_: i32;
    var phi_1056_: u32;
    var phi_1057_: u32;
    var phi_1065_: f32;
    var phi_1066_: f32;
    var phi_4509_: bool;
    var phi_1155_: type_32;
    var phi_1158_: type_49;
    var phi_1160_: u32;
    var phi_1162_: bool;
    var phi_1164_: u32;
    var phi_1175_: bool;
    var phi_1261_: type_49;
    var phi_1262_: bool;
    var phi_1263_: u32;
    var phi_3390_: u32;
    var phi_3396_: u32;
    var phi_3650_: u32;
    var phi_3651_: u32;
    var phi_3661_: u32;
    var phi_3663_: u32;
    var phi_3664_: bool;
    var phi_3684_: u32;
    var phi_3685_: u32;
    var phi_3689_: type_50;
    var phi_4033_: type_49;
    var phi_4110_: type_49;
    var phi_4111_: type_49;
    var phi_4112_: u32;
    var phi_4114_: type_49;
    var phi_4115_: u32;
    var phi_4116_: bool;
    var phi_4125_: type_49;
    var phi_4130_: type_49;
    var phi_4131_: bool;
    var phi_1282_: type_32;
    var phi_1285_: type_8;
    var phi_1286_: type_8;
    var phi_1308_: type_8;
    var phi_1349_: u32;
    var phi_1355_: u32;
    var phi_1365_: u32;
    var phi_1381_: u32;
    var phi_1414_: u32;
    var phi_1420_: u32;
    var phi_1865_: u32;
    var phi_1883_: u32;
    var phi_1901_: u32;
    var phi_1921_: u32;
    var phi_1939_: u32;
    var phi_1957_: u32;
    var phi_1977_: u32;
    var phi_1995_: u32;
    var phi_2013_: u32;
    var phi_1582_: u32;
    var phi_1597_: u32;
    var phi_1607_: u32;
    var phi_1628_: u32;
    var phi_1649_: u32;
    var phi_1676_: u32;
    var phi_1691_: u32;
    var phi_1701_: u32;
    var phi_1722_: u32;
    var phi_1743_: u32;
    var phi_1770_: u32;
    var phi_1785_: u32;
    var phi_1795_: u32;
    var phi_1816_: u32;
    var phi_1837_: u32;
    var phi_1444_: u32;
    var phi_1490_: u32;
    var phi_1536_: u32;
    var phi_2019_: array<array<f32, 3>, 3>;
    var phi_2136_: bool;
    var phi_2165_: bool;
    var phi_2566_: f32;
    var phi_2567_: f32;
    var phi_2568_: f32;
    var phi_2569_: f32;
    var phi_2570_: vec3<f32>;
    var phi_2571_: vec3<f32>;
    var phi_2572_: vec3<f32>;
    var phi_2573_: vec3<f32>;
    var phi_2604_: bool;
    var phi_2613_: vec3<f32>;
    var phi_2778_: f32;
    var phi_2780_: f32;
    var phi_2781_: bool;
    var phi_2801_: f32;
    var phi_2802_: f32;
    var phi_2825_: type_20;
    var phi_2827_: type_20;
    var phi_2828_: bool;
    var phi_2832_: type_20;
    var phi_2833_: type_20;
    var phi_2834_: type_20;
    var phi_2835_: bool;
    var phi_2839_: type_20;
    var phi_2840_: bool;
    var phi_2841_: type_20;
    var phi_2842_: bool;
    var phi_2843_: bool;
    var phi_2844_: type_20;
    var phi_2845_: bool;
    var phi_2846_: bool;
    var phi_2854_: type_20;
    var phi_2855_: bool;
    var phi_2859_: type_20;
    var phi_2884_: bool;
    var phi_2885_: bool;
    var phi_2891_: type_32;
    var phi_2892_: type_32;
    var phi_2893_: type_32;
    var phi_1283_: type_32;
    var phi_4503_: bool;
    var phi_4714_: bool;
    var phi_4133_: type_32;
    var phi_4134_: type_49;
    var phi_4135_: bool;
    var phi_4136_: u32;
    var phi_4713_: bool;
    var phi_4137_: type_32;
    var phi_4138_: type_49;
    var phi_4139_: u32;
    var phi_4140_: bool;
    var phi_4141_: u32;
    var phi_4712_: bool;
    var phi_4142_: type_32;
    var phi_4143_: type_49;
    var phi_4144_: u32;
    var phi_4145_: bool;
    var phi_4146_: u32;
    var phi_4711_: bool;
    var phi_1156_: type_32;
    var phi_1159_: type_49;
    var phi_1161_: u32;
    var phi_1163_: bool;
    var phi_1165_: u32;
    var phi_4147_: bool;
    var phi_4710_: bool;
    var local_10: type_32;
    var phi_4185_: f32;
    var phi_4187_: f32;
    var phi_4188_: bool;
    var phi_4189_: f32;
    var phi_4190_: bool;
    var phi_4411_: u32;
    var phi_4429_: bool;
    var phi_4432_: bool;
    var phi_4445_: f32;
    var phi_4446_: f32;
    var phi_4451_: f32;
    var phi_4452_: f32;
    var phi_4453_: bool;
    var phi_4461_: f32;
    var phi_4205_: f32;
    var phi_4206_: f32;
    var phi_4218_: f32;
    var phi_4223_: type_20;
    var local_11: type_32;

    switch bitcast<i32>(0u) {
        default: {
            let _e94 = global;
            let _e96 = arrayLength((&global_4.member));
            let _e99 = arrayLength((&global_5.member));
            let _e107 = global_2.member[0u][0u];
            let _e111 = global_2.member[0u][1u];
            let _e115 = global_2.member[0u][2u];
            let _e119 = global_2.member[0u][3u];
            let _e123 = global_2.member[1u][0u];
            let _e127 = global_2.member[1u][1u];
            let _e131 = global_2.member[1u][2u];
            let _e134 = global_1.member[0u];
            let _e135 = bitcast<i32>(_e134);
            let _e147 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e119) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e107), bitcast<i32>(_e111), bitcast<i32>(_e115));
            local = array<i32, 3>(bitcast<i32>(_e123), bitcast<i32>(_e127), bitcast<i32>(_e131));
            let _e153 = (_e94.x + (_e94.y * 2097152u));
            let _e154 = (_e153 < arrayLength((&global_3.member)));
            if _e154 {
                let _e155 = (_e153 < arrayLength((&global_6.member)));
                if _e155 {
                    if _e154 {
                    } else {
                        break;
                    }
                    let _e163 = global_3.member[_e153].member_2[0u];
                    let _e165 = (bitcast<u32>(_e163) & 2147483647u);
                    let _e170 = global_3.member[_e153].member_2[1u];
                    let _e172 = (bitcast<u32>(_e170) & 2147483647u);
                    let _e177 = global_3.member[_e153].member_2[2u];
                    let _e179 = (bitcast<u32>(_e177) & 2147483647u);
                    let _e184 = global_3.member[_e153].member[0u];
                    let _e186 = (bitcast<u32>(_e184) & 2147483647u);
                    let _e191 = global_3.member[_e153].member[1u];
                    let _e193 = (bitcast<u32>(_e191) & 2147483647u);
                    let _e198 = global_3.member[_e153].member[2u];
                    let _e200 = (bitcast<u32>(_e198) & 2147483647u);
                    let _e202 = select(_e172, _e165, (_e172 < _e165));
                    let _e204 = select(_e179, _e202, (_e179 < _e202));
                    let _e206 = select(_e186, _e204, (_e186 < _e204));
                    let _e208 = select(_e193, _e206, (_e193 < _e206));
                    let _e210 = select(_e200, _e208, (_e200 < _e208));
                    let _e214 = global_3.member[_e153].member_1;
                    let _e215 = bitcast<u32>(_e214);
                    let _e216 = (_e215 & 2147483647u);
                    let _e223 = global_3.member[_e153].member_3;
                    let _e224 = bitcast<u32>(_e223);
                    let _e225 = (_e224 & 2147483647u);
                    let _e229 = (((select(_e216, _e210, (_e216 < _e210)) < 2139095040u) && (_e225 <= 2139095040u)) && (_e204 > 0u));
                    if _e229 {
                        let _e232 = (bitcast<u32>(bitcast<f32>(_e204)) & 2147483647u);
                        if (_e232 >= 8388608u) {
                            phi_477_ = (bitcast<i32>((_e232 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_477_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e232)), 32u, (_e232 == 0u))));
                        }
                        let _e246 = phi_477_;
                        phi_478_ = _e246;
                    } else {
                        phi_478_ = 0i;
                    }
                    let _e248 = phi_478_;
                    let _e249 = (_e165 == _e204);
                    if _e249 {
                        phi_488_ = true;
                    } else {
                        phi_488_ = (_e172 == _e204);
                    }
                    let _e252 = phi_488_;
                    let _e253 = select(1u, 0u, _e249);
                    if _e252 {
                        let _e254 = (_e253 + 1u);
                        phi_498_ = _e254;
                        phi_499_ = _e254;
                        phi_501_ = select(true, false, (_e254 == 2u));
                    } else {
                        phi_498_ = u32();
                        phi_499_ = 0u;
                        phi_501_ = true;
                    }
                    let _e258 = phi_498_;
                    let _e260 = phi_499_;
                    let _e262 = phi_501_;
                    if _e262 {
                        phi_506_ = (_e260 + 1u);
                    } else {
                        phi_506_ = 0u;
                    }
                    let _e266 = phi_506_;
                    let _e267 = select(_e258, _e260, _e262);
                    let _e268 = select(_e253, select(2u, _e253, _e252), _e262);
                    if (_e135 < -126i) {
                        phi_518_ = -126i;
                    } else {
                        phi_518_ = select(_e135, 127i, (_e135 > 127i));
                    }
                    let _e273 = phi_518_;
                    let _e278 = bitcast<f32>((bitcast<u32>((_e273 + 127i)) << bitcast<u32>(23i)));
                    let _e284 = bitcast<f32>((bitcast<u32>(((_e135 - _e273) + 127i)) << bitcast<u32>(23i)));
                    let _e285 = -(_e248);
                    if (_e285 < -126i) {
                        phi_538_ = -126i;
                    } else {
                        phi_538_ = select(_e285, 127i, (_e285 > 127i));
                    }
                    let _e290 = phi_538_;
                    let _e295 = bitcast<f32>((bitcast<u32>((_e290 + 127i)) << bitcast<u32>(23i)));
                    let _e301 = bitcast<f32>((bitcast<u32>(((_e285 - _e290) + 127i)) << bitcast<u32>(23i)));
                    let _e305 = global_3.member[_e153].member;
                    let _e306 = (_e267 == 0u);
                    if _e306 {
                        phi_556_ = _e305[0];
                    } else {
                        phi_556_ = _e305[1];
                    }
                    let _e310 = phi_556_;
                    let _e311 = (_e267 == 2u);
                    if _e311 {
                        phi_562_ = _e305[2];
                    } else {
                        phi_562_ = _e310;
                    }
                    let _e314 = phi_562_;
                    let _e315 = bitcast<u32>(_e314);
                    let _e317 = ((_e315 & 2139095040u) != 0u);
                    let _e331 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e315 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e315 & 2147483648u))), _e314, _e317) * _e278) * select(0.00000011920929f, 1f, _e317)) * _e284);
                    let _e332 = global_3.member[_e153].member_2;
                    if _e306 {
                        phi_602_ = _e332[0];
                    } else {
                        phi_602_ = _e332[1];
                    }
                    let _e336 = phi_602_;
                    if _e311 {
                        phi_608_ = _e332[2];
                    } else {
                        phi_608_ = _e336;
                    }
                    let _e339 = phi_608_;
                    let _e340 = bitcast<u32>(_e339);
                    let _e342 = ((_e340 & 2139095040u) != 0u);
                    let _e356 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e340 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e340 & 2147483648u))), _e339, _e342) * _e295) * select(0.00000011920929f, 1f, _e342)) * _e301);
                    let _e360 = (bitcast<f32>((bitcast<u32>(_e356) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e360 {
                        let _e364 = (bitcast<f32>((bitcast<u32>(_e331) & 2147483647u)) * 0.00000011920929f);
                        phi_660_ = select(0.00000000000011368684f, _e364, (_e364 > 0.00000000000011368684f));
                    } else {
                        phi_660_ = 0f;
                    }
                    let _e368 = phi_660_;
                    let _e369 = (_e331 + _e368);
                    let _e370 = (_e331 - _e368);
                    let _e371 = select(_e356, 0f, _e360);
                    if _e360 {
                        phi_671_ = 38685626000000000000000000f;
                    } else {
                        phi_671_ = (1f / _e356);
                    }
                    let _e374 = phi_671_;
                    let _e375 = (_e266 == 0u);
                    if _e375 {
                        phi_680_ = _e305[0];
                    } else {
                        phi_680_ = _e305[1];
                    }
                    let _e379 = phi_680_;
                    let _e380 = (_e266 == 2u);
                    if _e380 {
                        phi_686_ = _e305[2];
                    } else {
                        phi_686_ = _e379;
                    }
                    let _e383 = phi_686_;
                    let _e384 = bitcast<u32>(_e383);
                    let _e386 = ((_e384 & 2139095040u) != 0u);
                    let _e400 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e384 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e384 & 2147483648u))), _e383, _e386) * _e278) * select(0.00000011920929f, 1f, _e386)) * _e284);
                    if _e375 {
                        phi_726_ = _e332[0];
                    } else {
                        phi_726_ = _e332[1];
                    }
                    let _e404 = phi_726_;
                    if _e380 {
                        phi_732_ = _e332[2];
                    } else {
                        phi_732_ = _e404;
                    }
                    let _e407 = phi_732_;
                    let _e408 = bitcast<u32>(_e407);
                    let _e410 = ((_e408 & 2139095040u) != 0u);
                    let _e424 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e408 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e408 & 2147483648u))), _e407, _e410) * _e295) * select(0.00000011920929f, 1f, _e410)) * _e301);
                    let _e428 = (bitcast<f32>((bitcast<u32>(_e424) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e428 {
                        let _e432 = (bitcast<f32>((bitcast<u32>(_e400) & 2147483647u)) * 0.00000011920929f);
                        phi_784_ = select(0.00000000000011368684f, _e432, (_e432 > 0.00000000000011368684f));
                    } else {
                        phi_784_ = 0f;
                    }
                    let _e436 = phi_784_;
                    let _e437 = (_e400 + _e436);
                    let _e438 = (_e400 - _e436);
                    let _e439 = select(_e424, 0f, _e428);
                    if _e428 {
                        phi_795_ = 38685626000000000000000000f;
                    } else {
                        phi_795_ = (1f / _e424);
                    }
                    let _e442 = phi_795_;
                    let _e443 = (_e268 == 0u);
                    if _e443 {
                        phi_804_ = _e305[0];
                    } else {
                        phi_804_ = _e305[1];
                    }
                    let _e447 = phi_804_;
                    let _e448 = (_e268 == 2u);
                    if _e448 {
                        phi_810_ = _e305[2];
                    } else {
                        phi_810_ = _e447;
                    }
                    let _e451 = phi_810_;
                    let _e452 = bitcast<u32>(_e451);
                    let _e454 = ((_e452 & 2139095040u) != 0u);
                    let _e468 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e452 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e452 & 2147483648u))), _e451, _e454) * _e278) * select(0.00000011920929f, 1f, _e454)) * _e284);
                    if _e443 {
                        phi_850_ = _e332[0];
                    } else {
                        phi_850_ = _e332[1];
                    }
                    let _e472 = phi_850_;
                    if _e448 {
                        phi_856_ = _e332[2];
                    } else {
                        phi_856_ = _e472;
                    }
                    let _e475 = phi_856_;
                    let _e476 = bitcast<u32>(_e475);
                    let _e478 = ((_e476 & 2139095040u) != 0u);
                    let _e492 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e476 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e476 & 2147483648u))), _e475, _e478) * _e295) * select(0.00000011920929f, 1f, _e478)) * _e301);
                    let _e496 = (bitcast<f32>((bitcast<u32>(_e492) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e496 {
                        let _e500 = (bitcast<f32>((bitcast<u32>(_e468) & 2147483647u)) * 0.00000011920929f);
                        phi_908_ = select(0.00000000000011368684f, _e500, (_e500 > 0.00000000000011368684f));
                    } else {
                        phi_908_ = 0f;
                    }
                    let _e504 = phi_908_;
                    let _e505 = (_e468 + _e504);
                    let _e506 = (_e468 - _e504);
                    let _e507 = select(_e492, 0f, _e496);
                    if _e496 {
                        phi_919_ = 38685626000000000000000000f;
                    } else {
                        phi_919_ = (1f / _e492);
                    }
                    let _e510 = phi_919_;
                    let _e513 = bitcast<f32>((bitcast<u32>(_e331) & 2147483647u));
                    let _e516 = bitcast<f32>((bitcast<u32>(_e400) & 2147483647u));
                    let _e518 = select(_e516, _e513, (_e513 > _e516));
                    let _e521 = bitcast<f32>((bitcast<u32>(_e468) & 2147483647u));
                    let _e524 = (_e135 + _e248);
                    if (_e229 && (select(_e521, _e518, (_e518 > _e521)) <= 1099511600000f)) {
                        let _e534 = ((_e216 & 8388607u) | (select(0u, 1u, ((_e216 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e537 = bitcast<i32>((_e216 >> bitcast<u32>(23i)));
                        let _e541 = (_e534 == 0u);
                        let _e544 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e534)), 32u, _e541)) - 8i);
                        if (_e537 == 255i) {
                            phi_974_ = 255i;
                        } else {
                            phi_974_ = (((_e537 + select(0i, 1i, (_e537 == 0i))) - _e544) + _e524);
                        }
                        let _e552 = phi_974_;
                        let _e562 = (_e552 <= 0i);
                        if _e562 {
                            phi_997_ = u32();
                        } else {
                            if _e541 {
                                phi_996_ = u32();
                            } else {
                                phi_996_ = select(((bitcast<u32>(_e552) << bitcast<u32>(23i)) | ((_e534 << bitcast<u32>(((_e544 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e552 >= 255i));
                            }
                            let _e566 = phi_996_;
                            phi_997_ = _e566;
                        }
                        let _e568 = phi_997_;
                        let _e580 = ((_e225 & 8388607u) | (select(0u, 1u, ((_e225 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e583 = bitcast<i32>((_e225 >> bitcast<u32>(23i)));
                        let _e587 = (_e580 == 0u);
                        let _e590 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e580)), 32u, _e587)) - 8i);
                        if (_e583 == 255i) {
                            phi_1034_ = 255i;
                        } else {
                            phi_1034_ = (((_e583 + select(0i, 1i, (_e583 == 0i))) - _e590) + _e524);
                        }
                        let _e598 = phi_1034_;
                        let _e608 = (_e598 <= 0i);
                        if _e608 {
                            phi_1057_ = u32();
                        } else {
                            if _e587 {
                                phi_1056_ = u32();
                            } else {
                                phi_1056_ = select(((bitcast<u32>(_e598) << bitcast<u32>(23i)) | ((_e580 << bitcast<u32>(((_e590 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e598 >= 255i));
                            }
                            let _e612 = phi_1056_;
                            phi_1057_ = _e612;
                        }
                        let _e614 = phi_1057_;
                        phi_1065_ = bitcast<f32>(((_e224 & 2147483648u) | select(_e614, 0u, select(_e587, true, _e608))));
                        phi_1066_ = bitcast<f32>(((_e215 & 2147483648u) | select(_e568, 0u, select(_e541, true, _e562))));
                    } else {
                        phi_1065_ = 0f;
                        phi_1066_ = 1f;
                    }
                    let _e620 = phi_1065_;
                    let _e622 = phi_1066_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e626 = (_e267 % 3u);
                    let _e627 = (_e626 < 3u);
                    if _e627 {
                    } else {
                        break;
                    }
                    let _e629 = local_1[_e626];
                    let _e632 = (_e266 % 3u);
                    let _e633 = (_e632 < 3u);
                    if _e633 {
                    } else {
                        break;
                    }
                    let _e635 = local_1[_e632];
                    let _e638 = (_e268 % 3u);
                    let _e639 = (_e638 < 3u);
                    if _e639 {
                    } else {
                        break;
                    }
                    let _e641 = local_1[_e638];
                    if _e627 {
                    } else {
                        break;
                    }
                    let _e646 = local[_e626];
                    if _e633 {
                    } else {
                        break;
                    }
                    let _e650 = local[_e632];
                    if _e639 {
                    } else {
                        break;
                    }
                    let _e654 = local[_e638];
                    phi_4509_ = false;
                    phi_1155_ = type_32(type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e620);
                    phi_1158_ = type_49(type_28(vec4<f32>((f32(_e629) * _e147), (f32(_e635) * _e147), (f32(_e641) * _e147), 0f), vec4<f32>((f32(_e646) * _e147), (f32(_e650) * _e147), (f32(_e654) * _e147), 0f)), select(0u, 2147483648u, (_e96 == 0u)));
                    phi_1160_ = ((3u * _e96) + 1u);
                    phi_1162_ = (_e622 <= _e620);
                    phi_1164_ = 0u;
                    loop {
                        let _e664 = phi_4509_;
                        let _e666 = phi_1155_;
                        let _e668 = phi_1158_;
                        let _e670 = phi_1160_;
                        let _e672 = phi_1162_;
                        let _e674 = phi_1164_;
                        local_10 = _e666;
                        if _e672 {
                            phi_1175_ = true;
                        } else {
                            phi_1175_ = (_e674 > 0u);
                        }
                        let _e677 = phi_1175_;
                        if _e677 {
                            let _e678 = (_e670 > 0u);
                            if _e678 {
                                if _e672 {
                                    phi_1261_ = _e668;
                                    phi_1262_ = _e672;
                                    phi_1263_ = _e674;
                                } else {
                                    let _e679 = (_e674 - 1u);
                                    let _e680 = (_e679 % 128u);
                                    let _e681 = (_e680 < 128u);
                                    if _e681 {
                                    } else {
                                        phi_4710_ = true;
                                        break;
                                    }
                                    let _e683 = local_7[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4710_ = true;
                                        break;
                                    }
                                    let _e685 = local_6[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4710_ = true;
                                        break;
                                    }
                                    let _e687 = local_5[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4710_ = true;
                                        break;
                                    }
                                    let _e689 = local_4[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4710_ = true;
                                        break;
                                    }
                                    let _e691 = local_3[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4710_ = true;
                                        break;
                                    }
                                    let _e693 = local_2[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4710_ = true;
                                        break;
                                    }
                                    let _e698 = local_8[_e680];
                                    if _e681 {
                                    } else {
                                        phi_4710_ = true;
                                        break;
                                    }
                                    let _e701 = local_9[_e680];
                                    phi_1261_ = type_49(type_28(vec4<f32>(_e683, _e685, _e687, 0f), vec4<f32>(_e689, _e691, _e693, 0f)), _e698);
                                    phi_1262_ = (_e701 <= _e666.member_1);
                                    phi_1263_ = _e679;
                                }
                                let _e705 = phi_1261_;
                                let _e707 = phi_1262_;
                                let _e709 = phi_1263_;
                                if _e707 {
                                    let _e714 = (_e705.member_1 & 268435455u);
                                    if ((_e705.member_1 & 2147483648u) != 0u) {
                                        phi_1282_ = _e666;
                                        phi_1285_ = type_8(0u, ((_e705.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1198 = phi_1282_;
                                            let _e1200 = phi_1285_;
                                            local_11 = _e1198;
                                            if (_e1200.member < _e1200.member_1) {
                                                phi_1286_ = type_8((_e1200.member + 1u), _e1200.member_1);
                                                phi_1308_ = type_8(1u, _e1200.member);
                                            } else {
                                                phi_1286_ = _e1200;
                                                phi_1308_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1213 = phi_1286_;
                                            let _e1215 = phi_1308_;
                                            let _e1219 = (bitcast<i32>(_e1215.member) != 0i);
                                            if _e1219 {
                                                let _e1224 = (_e705.member.member_1.x - _e705.member.member.x);
                                                let _e1227 = (_e705.member.member_1.y - _e705.member.member.y);
                                                let _e1230 = (_e705.member.member_1.z - _e705.member.member.z);
                                                let _e1232 = select(_e1227, _e1224, (_e1224 > _e1227));
                                                let _e1234 = select(_e1230, _e1232, (_e1232 > _e1230));
                                                let _e1236 = (_e1234 < (1024f * _e147));
                                                if _e1236 {
                                                    phi_1349_ = 0u;
                                                } else {
                                                    phi_1349_ = select(2u, 1u, (_e1234 < (2097152f * _e147)));
                                                }
                                                let _e1241 = phi_1349_;
                                                switch bitcast<i32>(_e1241) {
                                                    case 0: {
                                                        phi_1355_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1355_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1355_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1355_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1244 = phi_1355_;
                                                switch bitcast<i32>(_e1241) {
                                                    case 0: {
                                                        phi_1365_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1365_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1365_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1365_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1251 = phi_1365_;
                                                let _e1253 = ((_e714 + (_e1215.member_1 * ((3u * _e1244) + 1u))) + (3u * _e1251));
                                                let _e1254 = (_e1253 < _e99);
                                                if _e1254 {
                                                    if _e1254 {
                                                    } else {
                                                        phi_4503_ = true;
                                                        break;
                                                    }
                                                    let _e1256 = global_5.member[_e1253];
                                                    phi_1381_ = _e1256;
                                                } else {
                                                    phi_1381_ = 4294967295u;
                                                }
                                                let _e1258 = phi_1381_;
                                                if _e1236 {
                                                    phi_1414_ = 0u;
                                                } else {
                                                    phi_1414_ = select(2u, 1u, (_e1234 < (2097152f * _e147)));
                                                }
                                                let _e1263 = phi_1414_;
                                                switch bitcast<i32>(_e1263) {
                                                    case 0: {
                                                        phi_1420_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1420_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1420_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1420_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1266 = phi_1420_;
                                                let _e1270 = (_e714 + (_e1215.member_1 * ((3u * _e1266) + 1u)));
                                                switch bitcast<i32>(_e1263) {
                                                    case 0: {
                                                        let _e1545 = (_e1270 < _e99);
                                                        if _e1545 {
                                                            if _e1545 {
                                                            } else {
                                                                phi_4503_ = true;
                                                                break;
                                                            }
                                                            let _e1547 = global_5.member[_e1270];
                                                            phi_1444_ = _e1547;
                                                        } else {
                                                            phi_1444_ = 0u;
                                                        }
                                                        let _e1549 = phi_1444_;
                                                        let _e1551 = ((10u * _e267) & 31u);
                                                        let _e1561 = ((10u * _e266) & 31u);
                                                        let _e1571 = ((10u * _e268) & 31u);
                                                        let _e1581 = (_e1270 + 1u);
                                                        let _e1582 = (_e1581 < _e99);
                                                        if _e1582 {
                                                            if _e1582 {
                                                            } else {
                                                                phi_4503_ = true;
                                                                break;
                                                            }
                                                            let _e1584 = global_5.member[_e1581];
                                                            phi_1490_ = _e1584;
                                                        } else {
                                                            phi_1490_ = 0u;
                                                        }
                                                        let _e1586 = phi_1490_;
                                                        let _e1612 = (_e1270 + 2u);
                                                        let _e1613 = (_e1612 < _e99);
                                                        if _e1613 {
                                                            if _e1613 {
                                                            } else {
                                                                phi_4503_ = true;
                                                                break;
                                                            }
                                                            let _e1615 = global_5.member[_e1612];
                                                            phi_1536_ = _e1615;
                                                        } else {
                                                            phi_1536_ = 0u;
                                                        }
                                                        let _e1617 = phi_1536_;
                                                        phi_2019_ = array<array<f32, 3>, 3>(array<f32, 3>((_e705.member.member.x + ((bitcast<f32>((1258291200u | ((_e1549 >> bitcast<u32>(_e1551)) & 1023u))) - 8388608f) * _e147)), (_e705.member.member.y + ((bitcast<f32>((1258291200u | ((_e1549 >> bitcast<u32>(_e1561)) & 1023u))) - 8388608f) * _e147)), (_e705.member.member.z + ((bitcast<f32>((1258291200u | ((_e1549 >> bitcast<u32>(_e1571)) & 1023u))) - 8388608f) * _e147))), array<f32, 3>((_e705.member.member.x + ((bitcast<f32>((1258291200u | ((_e1586 >> bitcast<u32>(_e1551)) & 1023u))) - 8388608f) * _e147)), (_e705.member.member.y + ((bitcast<f32>((1258291200u | ((_e1586 >> bitcast<u32>(_e1561)) & 1023u))) - 8388608f) * _e147)), (_e705.member.member.z + ((bitcast<f32>((1258291200u | ((_e1586 >> bitcast<u32>(_e1571)) & 1023u))) - 8388608f) * _e147))), array<f32, 3>((_e705.member.member.x + ((bitcast<f32>((1258291200u | ((_e1617 >> bitcast<u32>(_e1551)) & 1023u))) - 8388608f) * _e147)), (_e705.member.member.y + ((bitcast<f32>((1258291200u | ((_e1617 >> bitcast<u32>(_e1561)) & 1023u))) - 8388608f) * _e147)), (_e705.member.member.z + ((bitcast<f32>((1258291200u | ((_e1617 >> bitcast<u32>(_e1571)) & 1023u))) - 8388608f) * _e147))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1359 = (_e1270 < _e99);
                                                        if _e1359 {
                                                            if _e1359 {
                                                            } else {
                                                                phi_4503_ = true;
                                                                break;
                                                            }
                                                            let _e1361 = global_5.member[_e1270];
                                                            phi_1582_ = _e1361;
                                                        } else {
                                                            phi_1582_ = 0u;
                                                        }
                                                        let _e1363 = phi_1582_;
                                                        let _e1364 = (_e1270 + 1u);
                                                        let _e1365 = (_e1364 < _e99);
                                                        if _e1365 {
                                                            if _e1365 {
                                                            } else {
                                                                phi_4503_ = true;
                                                                break;
                                                            }
                                                            let _e1367 = global_5.member[_e1364];
                                                            phi_1597_ = _e1367;
                                                        } else {
                                                            phi_1597_ = 0u;
                                                        }
                                                        let _e1369 = phi_1597_;
                                                        let _e1370 = (_e267 == 1u);
                                                        if _e1370 {
                                                            phi_1607_ = ((_e1363 >> bitcast<u32>(21i)) | (_e1369 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1607_ = (_e1369 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1379 = phi_1607_;
                                                        let _e1387 = (_e266 == 1u);
                                                        if _e1387 {
                                                            phi_1628_ = ((_e1363 >> bitcast<u32>(21i)) | (_e1369 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1628_ = (_e1369 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1396 = phi_1628_;
                                                        let _e1404 = (_e268 == 1u);
                                                        if _e1404 {
                                                            phi_1649_ = ((_e1363 >> bitcast<u32>(21i)) | (_e1369 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1649_ = (_e1369 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1413 = phi_1649_;
                                                        let _e1422 = (_e1270 + 2u);
                                                        let _e1423 = (_e1422 < _e99);
                                                        if _e1423 {
                                                            if _e1423 {
                                                            } else {
                                                                phi_4503_ = true;
                                                                break;
                                                            }
                                                            let _e1425 = global_5.member[_e1422];
                                                            phi_1676_ = _e1425;
                                                        } else {
                                                            phi_1676_ = 0u;
                                                        }
                                                        let _e1427 = phi_1676_;
                                                        let _e1428 = (_e1270 + 3u);
                                                        let _e1429 = (_e1428 < _e99);
                                                        if _e1429 {
                                                            if _e1429 {
                                                            } else {
                                                                phi_4503_ = true;
                                                                break;
                                                            }
                                                            let _e1431 = global_5.member[_e1428];
                                                            phi_1691_ = _e1431;
                                                        } else {
                                                            phi_1691_ = 0u;
                                                        }
                                                        let _e1433 = phi_1691_;
                                                        if _e1370 {
                                                            phi_1701_ = ((_e1427 >> bitcast<u32>(21i)) | (_e1433 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1701_ = (_e1433 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1442 = phi_1701_;
                                                        if _e1387 {
                                                            phi_1722_ = ((_e1427 >> bitcast<u32>(21i)) | (_e1433 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1722_ = (_e1433 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1458 = phi_1722_;
                                                        if _e1404 {
                                                            phi_1743_ = ((_e1427 >> bitcast<u32>(21i)) | (_e1433 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1743_ = (_e1433 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1474 = phi_1743_;
                                                        let _e1483 = (_e1270 + 4u);
                                                        let _e1484 = (_e1483 < _e99);
                                                        if _e1484 {
                                                            if _e1484 {
                                                            } else {
                                                                phi_4503_ = true;
                                                                break;
                                                            }
                                                            let _e1486 = global_5.member[_e1483];
                                                            phi_1770_ = _e1486;
                                                        } else {
                                                            phi_1770_ = 0u;
                                                        }
                                                        let _e1488 = phi_1770_;
                                                        let _e1489 = (_e1270 + 5u);
                                                        let _e1490 = (_e1489 < _e99);
                                                        if _e1490 {
                                                            if _e1490 {
                                                            } else {
                                                                phi_4503_ = true;
                                                                break;
                                                            }
                                                            let _e1492 = global_5.member[_e1489];
                                                            phi_1785_ = _e1492;
                                                        } else {
                                                            phi_1785_ = 0u;
                                                        }
                                                        let _e1494 = phi_1785_;
                                                        if _e1370 {
                                                            phi_1795_ = ((_e1488 >> bitcast<u32>(21i)) | (_e1494 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1795_ = (_e1494 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1503 = phi_1795_;
                                                        if _e1387 {
                                                            phi_1816_ = ((_e1488 >> bitcast<u32>(21i)) | (_e1494 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1816_ = (_e1494 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1519 = phi_1816_;
                                                        if _e1404 {
                                                            phi_1837_ = ((_e1488 >> bitcast<u32>(21i)) | (_e1494 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1837_ = (_e1494 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1535 = phi_1837_;
                                                        phi_2019_ = array<array<f32, 3>, 3>(array<f32, 3>((_e705.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1379, _e1363, _e306) & 2097151u))) - 8388608f) * _e147)), (_e705.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1396, _e1363, _e375) & 2097151u))) - 8388608f) * _e147)), (_e705.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1413, _e1363, _e443) & 2097151u))) - 8388608f) * _e147))), array<f32, 3>((_e705.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1442, _e1427, _e306) & 2097151u))) - 8388608f) * _e147)), (_e705.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1458, _e1427, _e375) & 2097151u))) - 8388608f) * _e147)), (_e705.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1474, _e1427, _e443) & 2097151u))) - 8388608f) * _e147))), array<f32, 3>((_e705.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1503, _e1488, _e306) & 2097151u))) - 8388608f) * _e147)), (_e705.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1519, _e1488, _e375) & 2097151u))) - 8388608f) * _e147)), (_e705.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1535, _e1488, _e443) & 2097151u))) - 8388608f) * _e147))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1272 = (_e1270 + _e267);
                                                        let _e1273 = (_e1272 < _e99);
                                                        if _e1273 {
                                                            if _e1273 {
                                                            } else {
                                                                phi_4503_ = true;
                                                                break;
                                                            }
                                                            let _e1275 = global_5.member[_e1272];
                                                            phi_1865_ = _e1275;
                                                        } else {
                                                            phi_1865_ = 0u;
                                                        }
                                                        let _e1277 = phi_1865_;
                                                        let _e1281 = (_e1270 + _e266);
                                                        let _e1282 = (_e1281 < _e99);
                                                        if _e1282 {
                                                            if _e1282 {
                                                            } else {
                                                                phi_4503_ = true;
                                                                break;
                                                            }
                                                            let _e1284 = global_5.member[_e1281];
                                                            phi_1883_ = _e1284;
                                                        } else {
                                                            phi_1883_ = 0u;
                                                        }
                                                        let _e1286 = phi_1883_;
                                                        let _e1290 = (_e1270 + _e268);
                                                        let _e1291 = (_e1290 < _e99);
                                                        if _e1291 {
                                                            if _e1291 {
                                                            } else {
                                                                phi_4503_ = true;
                                                                break;
                                                            }
                                                            let _e1293 = global_5.member[_e1290];
                                                            phi_1901_ = _e1293;
                                                        } else {
                                                            phi_1901_ = 0u;
                                                        }
                                                        let _e1295 = phi_1901_;
                                                        let _e1300 = (_e1270 + 3u);
                                                        let _e1301 = (_e1300 + _e267);
                                                        let _e1302 = (_e1301 < _e99);
                                                        if _e1302 {
                                                            if _e1302 {
                                                            } else {
                                                                phi_4503_ = true;
                                                                break;
                                                            }
                                                            let _e1304 = global_5.member[_e1301];
                                                            phi_1921_ = _e1304;
                                                        } else {
                                                            phi_1921_ = 0u;
                                                        }
                                                        let _e1306 = phi_1921_;
                                                        let _e1310 = (_e1300 + _e266);
                                                        let _e1311 = (_e1310 < _e99);
                                                        if _e1311 {
                                                            if _e1311 {
                                                            } else {
                                                                phi_4503_ = true;
                                                                break;
                                                            }
                                                            let _e1313 = global_5.member[_e1310];
                                                            phi_1939_ = _e1313;
                                                        } else {
                                                            phi_1939_ = 0u;
                                                        }
                                                        let _e1315 = phi_1939_;
                                                        let _e1319 = (_e1300 + _e268);
                                                        let _e1320 = (_e1319 < _e99);
                                                        if _e1320 {
                                                            if _e1320 {
                                                            } else {
                                                                phi_4503_ = true;
                                                                break;
                                                            }
                                                            let _e1322 = global_5.member[_e1319];
                                                            phi_1957_ = _e1322;
                                                        } else {
                                                            phi_1957_ = 0u;
                                                        }
                                                        let _e1324 = phi_1957_;
                                                        let _e1329 = (_e1270 + 6u);
                                                        let _e1330 = (_e1329 + _e267);
                                                        let _e1331 = (_e1330 < _e99);
                                                        if _e1331 {
                                                            if _e1331 {
                                                            } else {
                                                                phi_4503_ = true;
                                                                break;
                                                            }
                                                            let _e1333 = global_5.member[_e1330];
                                                            phi_1977_ = _e1333;
                                                        } else {
                                                            phi_1977_ = 0u;
                                                        }
                                                        let _e1335 = phi_1977_;
                                                        let _e1339 = (_e1329 + _e266);
                                                        let _e1340 = (_e1339 < _e99);
                                                        if _e1340 {
                                                            if _e1340 {
                                                            } else {
                                                                phi_4503_ = true;
                                                                break;
                                                            }
                                                            let _e1342 = global_5.member[_e1339];
                                                            phi_1995_ = _e1342;
                                                        } else {
                                                            phi_1995_ = 0u;
                                                        }
                                                        let _e1344 = phi_1995_;
                                                        let _e1348 = (_e1329 + _e268);
                                                        let _e1349 = (_e1348 < _e99);
                                                        if _e1349 {
                                                            if _e1349 {
                                                            } else {
                                                                phi_4503_ = true;
                                                                break;
                                                            }
                                                            let _e1351 = global_5.member[_e1348];
                                                            phi_2013_ = _e1351;
                                                        } else {
                                                            phi_2013_ = 0u;
                                                        }
                                                        let _e1353 = phi_2013_;
                                                        phi_2019_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1277)) * _e147), (f32(bitcast<i32>(_e1286)) * _e147), (f32(bitcast<i32>(_e1295)) * _e147)), array<f32, 3>((f32(bitcast<i32>(_e1306)) * _e147), (f32(bitcast<i32>(_e1315)) * _e147), (f32(bitcast<i32>(_e1324)) * _e147)), array<f32, 3>((f32(bitcast<i32>(_e1335)) * _e147), (f32(bitcast<i32>(_e1344)) * _e147), (f32(bitcast<i32>(_e1353)) * _e147)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2019_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1645 = phi_2019_;
                                                let _e1653 = (_e1645[0][2] - _e468);
                                                let _e1656 = (((_e1645[0][0] - _e331) * _e507) - (_e1653 * _e371));
                                                let _e1659 = (((_e1645[0][1] - _e400) * _e507) - (_e1653 * _e439));
                                                let _e1666 = (_e1645[1][2] - _e468);
                                                let _e1669 = (((_e1645[1][0] - _e331) * _e507) - (_e1666 * _e371));
                                                let _e1672 = (((_e1645[1][1] - _e400) * _e507) - (_e1666 * _e439));
                                                let _e1679 = (_e1645[2][2] - _e468);
                                                let _e1682 = (((_e1645[2][0] - _e331) * _e507) - (_e1679 * _e371));
                                                let _e1685 = (((_e1645[2][1] - _e400) * _e507) - (_e1679 * _e439));
                                                let _e1686 = (_e1682 * _e1672);
                                                let _e1687 = (_e1685 * _e1669);
                                                let _e1688 = (_e1656 * _e1685);
                                                let _e1689 = (_e1659 * _e1682);
                                                let _e1690 = (_e1669 * _e1659);
                                                let _e1691 = (_e1672 * _e1656);
                                                let _e1696 = (((_e1686 >= _e1687) && (_e1688 >= _e1689)) && (_e1690 >= _e1691));
                                                if (_e1696 || (((_e1686 <= _e1687) && (_e1688 <= _e1689)) && (_e1690 <= _e1691))) {
                                                    let _e1703 = select(-1f, 1f, _e1696);
                                                    let _e1705 = ((_e1686 - _e1687) * _e1703);
                                                    let _e1707 = select(0f, _e1705, (_e1705 > 0f));
                                                    let _e1709 = ((_e1688 - _e1689) * _e1703);
                                                    let _e1711 = select(0f, _e1709, (_e1709 > 0f));
                                                    let _e1713 = ((_e1690 - _e1691) * _e1703);
                                                    let _e1715 = select(0f, _e1713, (_e1713 > 0f));
                                                    let _e1717 = ((_e1707 + _e1711) + _e1715);
                                                    if (_e1717 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2844_ = type_20();
                                                        phi_2845_ = true;
                                                        phi_2846_ = false;
                                                    } else {
                                                        let _e1720 = select(_e1669, _e1656, (_e1656 < _e1669));
                                                        if (select(_e1682, _e1720, (_e1720 < _e1682)) > 0f) {
                                                            phi_2136_ = true;
                                                        } else {
                                                            let _e1725 = select(_e1669, _e1656, (_e1656 > _e1669));
                                                            phi_2136_ = (select(_e1682, _e1725, (_e1725 > _e1682)) < 0f);
                                                        }
                                                        let _e1730 = phi_2136_;
                                                        if _e1730 {
                                                            phi_2841_ = type_20();
                                                            phi_2842_ = true;
                                                            phi_2843_ = false;
                                                        } else {
                                                            let _e1732 = select(_e1672, _e1659, (_e1659 < _e1672));
                                                            if (select(_e1685, _e1732, (_e1732 < _e1685)) > 0f) {
                                                                phi_2165_ = true;
                                                            } else {
                                                                let _e1737 = select(_e1672, _e1659, (_e1659 > _e1672));
                                                                phi_2165_ = (select(_e1685, _e1737, (_e1737 > _e1685)) < 0f);
                                                            }
                                                            let _e1742 = phi_2165_;
                                                            if _e1742 {
                                                                phi_2839_ = type_20();
                                                                phi_2840_ = false;
                                                            } else {
                                                                let _e1744 = select(_e1645[1][0], _e1645[0][0], (_e1645[0][0] < _e1645[1][0]));
                                                                let _e1748 = select(_e1645[1][0], _e1645[0][0], (_e1645[0][0] > _e1645[1][0]));
                                                                let _e1752 = select(_e1645[1][1], _e1645[0][1], (_e1645[0][1] < _e1645[1][1]));
                                                                let _e1756 = select(_e1645[1][1], _e1645[0][1], (_e1645[0][1] > _e1645[1][1]));
                                                                let _e1760 = select(_e1645[1][2], _e1645[0][2], (_e1645[0][2] < _e1645[1][2]));
                                                                let _e1764 = select(_e1645[1][2], _e1645[0][2], (_e1645[0][2] > _e1645[1][2]));
                                                                let _e1769 = ((select(_e1645[2][0], _e1744, (_e1744 < _e1645[2][0])) - _e369) * _e374);
                                                                let _e1770 = ((select(_e1645[2][0], _e1748, (_e1748 > _e1645[2][0])) - _e370) * _e374);
                                                                let _e1773 = ((select(_e1645[2][1], _e1752, (_e1752 < _e1645[2][1])) - _e437) * _e442);
                                                                let _e1774 = ((select(_e1645[2][1], _e1756, (_e1756 > _e1645[2][1])) - _e438) * _e442);
                                                                let _e1777 = ((select(_e1645[2][2], _e1760, (_e1760 < _e1645[2][2])) - _e505) * _e510);
                                                                let _e1778 = ((select(_e1645[2][2], _e1764, (_e1764 > _e1645[2][2])) - _e506) * _e510);
                                                                let _e1780 = select(_e1778, _e1777, (_e1777 < _e1778));
                                                                let _e1782 = select(_e1778, _e1777, (_e1777 > _e1778));
                                                                let _e1784 = select(_e1770, _e1769, (_e1769 < _e1770));
                                                                let _e1786 = select(_e1774, _e1773, (_e1773 < _e1774));
                                                                let _e1788 = select(_e1786, _e1784, (_e1784 > _e1786));
                                                                let _e1790 = select(_e1780, _e1788, (_e1788 > _e1780));
                                                                let _e1792 = select(_e1770, _e1769, (_e1769 > _e1770));
                                                                let _e1794 = select(_e1774, _e1773, (_e1773 > _e1774));
                                                                let _e1796 = select(_e1794, _e1792, (_e1792 < _e1794));
                                                                let _e1798 = select(_e1782, _e1796, (_e1796 < _e1782));
                                                                let _e1799 = -(_e1780);
                                                                let _e1805 = select(_e622, _e1790, (_e1790 > _e622));
                                                                if (_e1805 > (_e1798 + (select(_e1799, _e1782, (_e1782 > _e1799)) * 0.0000019073523f))) {
                                                                    phi_2834_ = type_20();
                                                                    phi_2835_ = true;
                                                                } else {
                                                                    let _e1807 = (_e1805 > _e1198.member_1);
                                                                    if _e1807 {
                                                                        phi_2833_ = type_20();
                                                                    } else {
                                                                        let _e1808 = vec3<f32>(_e1645[0][0], _e1645[0][1], _e1645[0][2]);
                                                                        let _e1809 = vec3<f32>(_e1645[1][0], _e1645[1][1], _e1645[1][2]);
                                                                        let _e1810 = vec3<f32>(_e1645[2][0], _e1645[2][1], _e1645[2][2]);
                                                                        let _e1811 = (_e1645[1][0] - _e1645[0][0]);
                                                                        let _e1812 = (_e1645[1][1] - _e1645[0][1]);
                                                                        let _e1813 = (_e1645[1][2] - _e1645[0][2]);
                                                                        let _e1814 = vec3<f32>(_e1811, _e1812, _e1813);
                                                                        let _e1815 = (_e1645[2][0] - _e1645[1][0]);
                                                                        let _e1816 = (_e1645[2][1] - _e1645[1][1]);
                                                                        let _e1817 = (_e1645[2][2] - _e1645[1][2]);
                                                                        let _e1818 = vec3<f32>(_e1815, _e1816, _e1817);
                                                                        let _e1819 = (_e1645[0][0] - _e1645[2][0]);
                                                                        let _e1820 = (_e1645[0][1] - _e1645[2][1]);
                                                                        let _e1821 = (_e1645[0][2] - _e1645[2][2]);
                                                                        let _e1822 = vec3<f32>(_e1819, _e1820, _e1821);
                                                                        let _e1825 = bitcast<f32>((bitcast<u32>(_e1811) & 2147483647u));
                                                                        let _e1828 = bitcast<f32>((bitcast<u32>(_e1812) & 2147483647u));
                                                                        let _e1830 = select(_e1828, _e1825, (_e1825 > _e1828));
                                                                        let _e1833 = bitcast<f32>((bitcast<u32>(_e1813) & 2147483647u));
                                                                        let _e1835 = select(_e1833, _e1830, (_e1830 > _e1833));
                                                                        let _e1838 = bitcast<f32>((bitcast<u32>(_e1815) & 2147483647u));
                                                                        let _e1841 = bitcast<f32>((bitcast<u32>(_e1816) & 2147483647u));
                                                                        let _e1843 = select(_e1841, _e1838, (_e1838 > _e1841));
                                                                        let _e1846 = bitcast<f32>((bitcast<u32>(_e1817) & 2147483647u));
                                                                        let _e1848 = select(_e1846, _e1843, (_e1843 > _e1846));
                                                                        let _e1851 = bitcast<f32>((bitcast<u32>(_e1819) & 2147483647u));
                                                                        let _e1854 = bitcast<f32>((bitcast<u32>(_e1820) & 2147483647u));
                                                                        let _e1856 = select(_e1854, _e1851, (_e1851 > _e1854));
                                                                        let _e1859 = bitcast<f32>((bitcast<u32>(_e1821) & 2147483647u));
                                                                        let _e1861 = select(_e1859, _e1856, (_e1856 > _e1859));
                                                                        let _e1863 = select(_e1848, _e1835, (_e1835 > _e1848));
                                                                        let _e1865 = select(_e1861, _e1863, (_e1863 > _e1861));
                                                                        if (_e1835 == _e1865) {
                                                                            phi_2566_ = _e1672;
                                                                            phi_2567_ = _e1669;
                                                                            phi_2568_ = _e1659;
                                                                            phi_2569_ = _e1656;
                                                                            phi_2570_ = _e1808;
                                                                            phi_2571_ = _e1822;
                                                                            phi_2572_ = _e1818;
                                                                            phi_2573_ = _e1814;
                                                                        } else {
                                                                            let _e1867 = (_e1848 == _e1865);
                                                                            let _e1872 = vec3(_e1867);
                                                                            phi_2566_ = select(_e1659, _e1685, _e1867);
                                                                            phi_2567_ = select(_e1656, _e1682, _e1867);
                                                                            phi_2568_ = select(_e1685, _e1672, _e1867);
                                                                            phi_2569_ = select(_e1682, _e1669, _e1867);
                                                                            phi_2570_ = select(_e1810, _e1809, _e1872);
                                                                            phi_2571_ = select(_e1818, _e1814, _e1872);
                                                                            phi_2572_ = select(_e1814, _e1822, _e1872);
                                                                            phi_2573_ = select(_e1822, _e1818, _e1872);
                                                                        }
                                                                        let _e1878 = phi_2566_;
                                                                        let _e1880 = phi_2567_;
                                                                        let _e1882 = phi_2568_;
                                                                        let _e1884 = phi_2569_;
                                                                        let _e1886 = phi_2570_;
                                                                        let _e1888 = phi_2571_;
                                                                        let _e1890 = phi_2572_;
                                                                        let _e1892 = phi_2573_;
                                                                        let _e1899 = ((_e1890.y * _e1888.z) - (_e1888.y * _e1890.z));
                                                                        let _e1904 = ((_e1890.z * _e1888.x) - (_e1888.z * _e1890.x));
                                                                        let _e1907 = ((_e1890.x * _e1888.y) - (_e1888.x * _e1890.y));
                                                                        if (_e1707 >= _e1711) {
                                                                            phi_2604_ = select(true, false, (_e1707 >= _e1715));
                                                                        } else {
                                                                            phi_2604_ = true;
                                                                        }
                                                                        let _e1912 = phi_2604_;
                                                                        if _e1912 {
                                                                            phi_2613_ = select(_e1810, _e1809, vec3((_e1711 >= _e1715)));
                                                                        } else {
                                                                            phi_2613_ = _e1808;
                                                                        }
                                                                        let _e1917 = phi_2613_;
                                                                        let _e1928 = (((_e1899 * (_e1917.x - _e331)) + (_e1904 * (_e1917.y - _e400))) + (_e1907 * (_e1917.z - _e468)));
                                                                        let _e1933 = (((_e1899 * _e371) + (_e1904 * _e439)) + (_e1907 * _e507));
                                                                        let _e1934 = (_e1880 - _e1884);
                                                                        let _e1935 = (_e1878 - _e1882);
                                                                        let _e1943 = (-(((_e1884 * _e1934) + (_e1882 * _e1935))) / ((_e1934 * _e1934) + (_e1935 * _e1935)));
                                                                        let _e1945 = select(1f, _e1943, (_e1943 < 1f));
                                                                        let _e1947 = select(0f, _e1945, (_e1945 > 0f));
                                                                        let _e1960 = ((_e1886.x + (_e1892.x * _e1947)) - _e331);
                                                                        let _e1961 = ((_e1886.y + (_e1892.y * _e1947)) - _e400);
                                                                        let _e1962 = ((_e1886.z + (_e1892.z * _e1947)) - _e468);
                                                                        let _e1963 = (_e1962 / _e507);
                                                                        let _e1975 = bitcast<f32>((bitcast<u32>(_e1960) & 2147483647u));
                                                                        let _e1978 = bitcast<f32>((bitcast<u32>(_e1961) & 2147483647u));
                                                                        let _e1980 = select(_e1978, _e1975, (_e1975 > _e1978));
                                                                        let _e1983 = bitcast<f32>((bitcast<u32>(_e1962) & 2147483647u));
                                                                        let _e1985 = select(_e1983, _e1980, (_e1980 > _e1983));
                                                                        let _e1991 = bitcast<f32>((bitcast<u32>(_e1899) & 2147483647u));
                                                                        let _e1994 = bitcast<f32>((bitcast<u32>(_e1904) & 2147483647u));
                                                                        let _e1996 = select(_e1994, _e1991, (_e1991 > _e1994));
                                                                        let _e1999 = bitcast<f32>((bitcast<u32>(_e1907) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1899 * _e1960) + (_e1904 * _e1961)) + (_e1907 * _e1962)) - _e1928)) & 2147483647u)) <= ((0.0000009536743f * select(_e1865, _e1985, (_e1985 > _e1865))) * select(_e1999, _e1996, (_e1996 > _e1999)))) {
                                                                            let _e2009 = bitcast<f32>((bitcast<u32>(_e1890.x) & 2147483647u));
                                                                            let _e2012 = bitcast<f32>((bitcast<u32>(_e1890.y) & 2147483647u));
                                                                            let _e2014 = select(_e2012, _e2009, (_e2009 > _e2012));
                                                                            let _e2017 = bitcast<f32>((bitcast<u32>(_e1890.z) & 2147483647u));
                                                                            let _e2023 = bitcast<f32>((bitcast<u32>(_e1888.x) & 2147483647u));
                                                                            let _e2026 = bitcast<f32>((bitcast<u32>(_e1888.y) & 2147483647u));
                                                                            let _e2028 = select(_e2026, _e2023, (_e2023 > _e2026));
                                                                            let _e2031 = bitcast<f32>((bitcast<u32>(_e1888.z) & 2147483647u));
                                                                            let _e2035 = (bitcast<f32>((bitcast<u32>(_e1933) & 2147483647u)) > ((0.0000038146973f * select(_e2017, _e2014, (_e2014 > _e2017))) * select(_e2031, _e2028, (_e2028 > _e2031))));
                                                                            if _e2035 {
                                                                                phi_2778_ = (_e1928 / _e1933);
                                                                            } else {
                                                                                phi_2778_ = f32();
                                                                            }
                                                                            let _e2038 = phi_2778_;
                                                                            phi_2780_ = _e2038;
                                                                            phi_2781_ = select(true, false, _e2035);
                                                                        } else {
                                                                            phi_2780_ = f32();
                                                                            phi_2781_ = true;
                                                                        }
                                                                        let _e2041 = phi_2780_;
                                                                        let _e2043 = phi_2781_;
                                                                        if _e2043 {
                                                                            let _e2051 = (((_e1899 * (_e1960 - (_e371 * _e1963))) + (_e1904 * (_e1961 - (_e439 * _e1963)))) / _e1933);
                                                                            if (bitcast<f32>((bitcast<u32>(_e2051) & 2147483647u)) <= _e1865) {
                                                                                phi_2801_ = (_e1963 + _e2051);
                                                                            } else {
                                                                                phi_2801_ = _e1963;
                                                                            }
                                                                            let _e2058 = phi_2801_;
                                                                            phi_2802_ = _e2058;
                                                                        } else {
                                                                            phi_2802_ = _e2041;
                                                                        }
                                                                        let _e2060 = phi_2802_;
                                                                        let _e2062 = select(_e1798, _e2060, (_e2060 < _e1798));
                                                                        let _e2064 = select(_e1790, _e2062, (_e2062 > _e1790));
                                                                        if (_e2064 >= _e622) {
                                                                            let _e2066 = (_e2064 <= _e1198.member_1);
                                                                            if _e2066 {
                                                                                let _e2067 = (1f / _e1717);
                                                                                phi_2825_ = type_20(_e2064, (_e1711 * _e2067), (_e1715 * _e2067), _e1258);
                                                                            } else {
                                                                                phi_2825_ = type_20();
                                                                            }
                                                                            let _e2072 = phi_2825_;
                                                                            phi_2827_ = _e2072;
                                                                            phi_2828_ = select(true, false, _e2066);
                                                                        } else {
                                                                            phi_2827_ = type_20();
                                                                            phi_2828_ = true;
                                                                        }
                                                                        let _e2075 = phi_2827_;
                                                                        let _e2077 = phi_2828_;
                                                                        if _e2077 {
                                                                            phi_2832_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2832_ = _e2075;
                                                                        }
                                                                        let _e2079 = phi_2832_;
                                                                        phi_2833_ = _e2079;
                                                                    }
                                                                    let _e2081 = phi_2833_;
                                                                    phi_2834_ = _e2081;
                                                                    phi_2835_ = _e1807;
                                                                }
                                                                let _e2083 = phi_2834_;
                                                                let _e2085 = phi_2835_;
                                                                phi_2839_ = _e2083;
                                                                phi_2840_ = _e2085;
                                                            }
                                                            let _e2087 = phi_2839_;
                                                            let _e2089 = phi_2840_;
                                                            phi_2841_ = _e2087;
                                                            phi_2842_ = _e1742;
                                                            phi_2843_ = _e2089;
                                                        }
                                                        let _e2091 = phi_2841_;
                                                        let _e2093 = phi_2842_;
                                                        let _e2095 = phi_2843_;
                                                        phi_2844_ = _e2091;
                                                        phi_2845_ = _e2093;
                                                        phi_2846_ = _e2095;
                                                    }
                                                    let _e2097 = phi_2844_;
                                                    let _e2099 = phi_2845_;
                                                    let _e2101 = phi_2846_;
                                                    phi_2854_ = _e2097;
                                                    phi_2855_ = select(_e2101, true, _e2099);
                                                } else {
                                                    phi_2854_ = type_20();
                                                    phi_2855_ = true;
                                                }
                                                let _e2104 = phi_2854_;
                                                let _e2106 = phi_2855_;
                                                if _e2106 {
                                                    phi_2859_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2859_ = _e2104;
                                                }
                                                let _e2108 = phi_2859_;
                                                if (_e2108.member_3 != 4294967295u) {
                                                    if (_e1258 != 4294967295u) {
                                                        if (_e2108.member < _e1198.member.member) {
                                                            phi_2885_ = true;
                                                        } else {
                                                            if (_e2108.member == _e1198.member.member) {
                                                                phi_2884_ = (_e2108.member_3 < _e1198.member.member_3);
                                                            } else {
                                                                phi_2884_ = false;
                                                            }
                                                            let _e2121 = phi_2884_;
                                                            phi_2885_ = _e2121;
                                                        }
                                                        let _e2123 = phi_2885_;
                                                        if _e2123 {
                                                            phi_2891_ = type_32(_e2108, _e2108.member);
                                                        } else {
                                                            phi_2891_ = _e1198;
                                                        }
                                                        let _e2126 = phi_2891_;
                                                        phi_2892_ = _e2126;
                                                    } else {
                                                        phi_2892_ = _e1198;
                                                    }
                                                    let _e2128 = phi_2892_;
                                                    phi_2893_ = _e2128;
                                                } else {
                                                    phi_2893_ = _e1198;
                                                }
                                                let _e2130 = phi_2893_;
                                                phi_1283_ = _e2130;
                                            } else {
                                                phi_1283_ = type_32();
                                            }
                                            let _e2132 = phi_1283_;
                                            continue;
                                            continuing {
                                                phi_1282_ = _e2132;
                                                phi_1285_ = _e1213;
                                                phi_4503_ = _e664;
                                                break if !(_e1219);
                                            }
                                        }
                                        let _e2135 = phi_4503_;
                                        phi_4710_ = _e2135;
                                        if _e2135 {
                                            break;
                                        }
                                        phi_4714_ = _e2135;
                                        let _e2462 = local_11;
                                        phi_4133_ = _e2462;
                                        phi_4134_ = _e705;
                                        phi_4135_ = false;
                                        phi_4136_ = _e709;
                                    } else {
                                        if (_e705.member_1 >= _e96) {
                                            phi_3689_ = type_50(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e705.member_1 < _e96) {
                                            } else {
                                                phi_4710_ = true;
                                                break;
                                            }
                                            let _e721 = (_e267 * 2u);
                                            let _e723 = ((1u + _e721) % 7u);
                                            if (_e723 < 7u) {
                                            } else {
                                                phi_4710_ = true;
                                                break;
                                            }
                                            let _e728 = global_4.member[_e705.member_1][_e723];
                                            let _e730 = ((_e721 + 2u) % 7u);
                                            if (_e730 < 7u) {
                                            } else {
                                                phi_4710_ = true;
                                                break;
                                            }
                                            let _e735 = global_4.member[_e705.member_1][_e730];
                                            let _e736 = (_e266 * 2u);
                                            let _e738 = ((1u + _e736) % 7u);
                                            if (_e738 < 7u) {
                                            } else {
                                                phi_4710_ = true;
                                                break;
                                            }
                                            let _e743 = global_4.member[_e705.member_1][_e738];
                                            let _e745 = ((_e736 + 2u) % 7u);
                                            if (_e745 < 7u) {
                                            } else {
                                                phi_4710_ = true;
                                                break;
                                            }
                                            let _e750 = global_4.member[_e705.member_1][_e745];
                                            let _e751 = (_e268 * 2u);
                                            let _e753 = ((1u + _e751) % 7u);
                                            if (_e753 < 7u) {
                                            } else {
                                                phi_4710_ = true;
                                                break;
                                            }
                                            let _e758 = global_4.member[_e705.member_1][_e753];
                                            let _e760 = ((_e751 + 2u) % 7u);
                                            if (_e760 < 7u) {
                                            } else {
                                                phi_4710_ = true;
                                                break;
                                            }
                                            let _e765 = global_4.member[_e705.member_1][_e760];
                                            let _e788 = (bitcast<f32>((bitcast<u32>((_e705.member.member_1.x - _e705.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e789 = (bitcast<f32>((bitcast<u32>((_e705.member.member_1.y - _e705.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e790 = (bitcast<f32>((bitcast<u32>((_e705.member.member_1.z - _e705.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e792 = select(_e147, _e788, (_e788 > _e147));
                                            let _e794 = select(_e147, _e789, (_e789 > _e147));
                                            let _e796 = select(_e147, _e790, (_e790 > _e147));
                                            let _e827 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e728 & 2097151u))) - 8388608f) * _e792));
                                            let _e832 = (bitcast<i32>((_e728 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e835 = bitcast<f32>((_e827 & bitcast<u32>(_e832)));
                                            let _e836 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e743 & 2097151u))) - 8388608f) * _e794));
                                            let _e841 = (bitcast<i32>((_e743 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e844 = bitcast<f32>((_e836 & bitcast<u32>(_e841)));
                                            let _e845 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e758 & 2097151u))) - 8388608f) * _e796));
                                            let _e850 = (bitcast<i32>((_e758 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e853 = bitcast<f32>((_e845 & bitcast<u32>(_e850)));
                                            let _e857 = bitcast<f32>((_e827 & bitcast<u32>(~(_e832))));
                                            let _e861 = bitcast<f32>((_e836 & bitcast<u32>(~(_e841))));
                                            let _e865 = bitcast<f32>((_e845 & bitcast<u32>(~(_e850))));
                                            let _e866 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e735 & 2097151u))) - 8388608f) * _e792));
                                            let _e871 = (bitcast<i32>((_e735 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e874 = bitcast<f32>((_e866 & bitcast<u32>(_e871)));
                                            let _e875 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e750 & 2097151u))) - 8388608f) * _e794));
                                            let _e880 = (bitcast<i32>((_e750 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e883 = bitcast<f32>((_e875 & bitcast<u32>(_e880)));
                                            let _e884 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e765 & 2097151u))) - 8388608f) * _e796));
                                            let _e889 = (bitcast<i32>((_e765 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e892 = bitcast<f32>((_e884 & bitcast<u32>(_e889)));
                                            let _e896 = bitcast<f32>((_e866 & bitcast<u32>(~(_e871))));
                                            let _e900 = bitcast<f32>((_e875 & bitcast<u32>(~(_e880))));
                                            let _e904 = bitcast<f32>((_e884 & bitcast<u32>(~(_e889))));
                                            let _e905 = (_e705.member.member.x + _e835);
                                            let _e906 = (_e705.member.member.y + _e844);
                                            let _e907 = (_e705.member.member.z + _e853);
                                            let _e910 = (_e705.member.member_1.x - _e874);
                                            let _e911 = (_e705.member.member_1.y - _e883);
                                            let _e912 = (_e705.member.member_1.z - _e892);
                                            let _e931 = (_e910 - _e905);
                                            let _e932 = (_e911 - _e906);
                                            let _e933 = (_e912 - _e907);
                                            let _e935 = select(_e932, _e931, (_e931 > _e932));
                                            let _e937 = select(_e933, _e935, (_e935 > _e933));
                                            if (_e937 < (1024f * _e147)) {
                                                phi_3390_ = 0u;
                                            } else {
                                                phi_3390_ = select(2u, 1u, (_e937 < (2097152f * _e147)));
                                            }
                                            let _e944 = phi_3390_;
                                            switch bitcast<i32>(_e944) {
                                                case 0: {
                                                    phi_3396_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3396_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3396_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3396_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e947 = phi_3396_;
                                            let _e953 = global_4.member[_e705.member_1][0u];
                                            let _e957 = global_4.member[_e705.member_1][2u];
                                            let _e961 = global_4.member[_e705.member_1][4u];
                                            let _e965 = global_4.member[_e705.member_1][6u];
                                            let _e977 = (((_e957 >> bitcast<u32>(22i)) | ((_e961 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e965 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e978 = (_e953 & 268435455u);
                                            let _e979 = (_e977 & 268435455u);
                                            let _e982 = ((_e953 >> bitcast<u32>(28u)) & 7u);
                                            let _e990 = ((_e953 >> bitcast<u32>(31i)) | (((_e977 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e991 = (_e982 != 0u);
                                            if (_e982 == 0u) {
                                                phi_3651_ = _e978;
                                            } else {
                                                if (_e982 == 7u) {
                                                    phi_3650_ = 2147483648u;
                                                } else {
                                                    phi_3650_ = ((2147483648u | (_e982 << bitcast<u32>(28u))) | (_e979 & 268435455u));
                                                }
                                                let _e1000 = phi_3650_;
                                                phi_3651_ = _e1000;
                                            }
                                            let _e1002 = phi_3651_;
                                            if _e991 {
                                                let _e1003 = (_e982 != 7u);
                                                if _e1003 {
                                                    phi_3661_ = (_e979 + (_e982 * ((3u * _e947) + 1u)));
                                                } else {
                                                    phi_3661_ = u32();
                                                }
                                                let _e1007 = phi_3661_;
                                                phi_3663_ = _e1007;
                                                phi_3664_ = select(true, false, _e1003);
                                            } else {
                                                phi_3663_ = u32();
                                                phi_3664_ = true;
                                            }
                                            let _e1010 = phi_3663_;
                                            let _e1012 = phi_3664_;
                                            if (_e990 == 0u) {
                                                phi_3685_ = (_e978 + select(0u, 1u, !(_e991)));
                                            } else {
                                                if (_e990 == 7u) {
                                                    phi_3684_ = 2147483648u;
                                                } else {
                                                    phi_3684_ = ((2147483648u | (_e990 << bitcast<u32>(28u))) | (select(_e1010, _e979, _e1012) & 268435455u));
                                                }
                                                let _e1025 = phi_3684_;
                                                phi_3685_ = _e1025;
                                            }
                                            let _e1027 = phi_3685_;
                                            phi_3689_ = type_50(array<vec4<f32>, 3>(vec4<f32>(_e905, (_e705.member.member.x + _e857), _e910, (_e705.member.member_1.x - _e896)), vec4<f32>(_e906, (_e705.member.member.y + _e861), _e911, (_e705.member.member_1.y - _e900)), vec4<f32>(_e907, (_e705.member.member.z + _e865), _e912, (_e705.member.member_1.z - _e904))), type_49(type_28((_e705.member.member + vec4<f32>(_e835, _e844, _e853, 0f)), (_e705.member.member_1 - vec4<f32>(_e874, _e883, _e892, 0f))), _e1002), type_49(type_28((_e705.member.member + vec4<f32>(_e857, _e861, _e865, 0f)), (_e705.member.member_1 - vec4<f32>(_e896, _e900, _e904, 0f))), _e1027));
                                        }
                                        let _e1032 = phi_3689_;
                                        let _e1044 = ((_e1032.member[0].x - _e369) * _e374);
                                        let _e1045 = ((_e1032.member[0].y - _e369) * _e374);
                                        let _e1046 = ((_e1032.member[0].z - _e370) * _e374);
                                        let _e1047 = ((_e1032.member[0].w - _e370) * _e374);
                                        let _e1057 = ((_e1032.member[1].x - _e437) * _e442);
                                        let _e1058 = ((_e1032.member[1].y - _e437) * _e442);
                                        let _e1059 = ((_e1032.member[1].z - _e438) * _e442);
                                        let _e1060 = ((_e1032.member[1].w - _e438) * _e442);
                                        let _e1070 = ((_e1032.member[2].x - _e505) * _e510);
                                        let _e1071 = ((_e1032.member[2].y - _e505) * _e510);
                                        let _e1072 = ((_e1032.member[2].z - _e506) * _e510);
                                        let _e1073 = ((_e1032.member[2].w - _e506) * _e510);
                                        let _e1075 = select(_e1072, _e1070, (_e1070 < _e1072));
                                        let _e1077 = select(_e1073, _e1071, (_e1071 < _e1073));
                                        let _e1079 = select(_e1072, _e1070, (_e1070 > _e1072));
                                        let _e1081 = select(_e1073, _e1071, (_e1071 > _e1073));
                                        let _e1083 = select(_e1046, _e1044, (_e1044 < _e1046));
                                        let _e1085 = select(_e1047, _e1045, (_e1045 < _e1047));
                                        let _e1087 = select(_e1059, _e1057, (_e1057 < _e1059));
                                        let _e1089 = select(_e1060, _e1058, (_e1058 < _e1060));
                                        let _e1091 = select(_e1087, _e1083, (_e1083 > _e1087));
                                        let _e1093 = select(_e1089, _e1085, (_e1085 > _e1089));
                                        let _e1095 = select(_e1075, _e1091, (_e1091 > _e1075));
                                        let _e1097 = select(_e1077, _e1093, (_e1093 > _e1077));
                                        let _e1099 = select(_e1046, _e1044, (_e1044 > _e1046));
                                        let _e1101 = select(_e1047, _e1045, (_e1045 > _e1047));
                                        let _e1103 = select(_e1059, _e1057, (_e1057 > _e1059));
                                        let _e1105 = select(_e1060, _e1058, (_e1058 > _e1060));
                                        let _e1107 = select(_e1103, _e1099, (_e1099 < _e1103));
                                        let _e1109 = select(_e1105, _e1101, (_e1101 < _e1105));
                                        let _e1114 = -(_e1075);
                                        let _e1115 = -(_e1077);
                                        let _e1122 = (select(_e1079, _e1107, (_e1107 < _e1079)) + (select(_e1114, _e1079, (_e1079 > _e1114)) * 0.0000019073523f));
                                        let _e1123 = (select(_e1081, _e1109, (_e1109 < _e1081)) + (select(_e1115, _e1081, (_e1081 > _e1115)) * 0.0000019073523f));
                                        let _e1125 = select(_e622, _e1095, (_e1095 > _e622));
                                        let _e1127 = select(_e622, _e1097, (_e1097 > _e622));
                                        let _e1132 = (_e1125 <= select(_e666.member_1, _e1122, (_e1122 < _e666.member_1)));
                                        let _e1133 = (_e1127 <= select(_e666.member_1, _e1123, (_e1123 < _e666.member_1)));
                                        let _e1134 = (_e1125 <= _e1127);
                                        if _e1132 {
                                            if _e1133 {
                                                if _e1134 {
                                                    phi_4033_ = _e1032.member_2;
                                                } else {
                                                    phi_4033_ = _e1032.member_1;
                                                }
                                                let _e1138 = phi_4033_;
                                                let _e1160 = (_e709 % 128u);
                                                let _e1161 = (_e1160 < 128u);
                                                if _e1161 {
                                                } else {
                                                    phi_4710_ = true;
                                                    break;
                                                }
                                                local_8[_e1160] = _e1138.member_1;
                                                if _e1161 {
                                                } else {
                                                    phi_4710_ = true;
                                                    break;
                                                }
                                                local_7[_e1160] = _e1138.member.member.x;
                                                if _e1161 {
                                                } else {
                                                    phi_4710_ = true;
                                                    break;
                                                }
                                                local_6[_e1160] = _e1138.member.member.y;
                                                if _e1161 {
                                                } else {
                                                    phi_4710_ = true;
                                                    break;
                                                }
                                                local_5[_e1160] = _e1138.member.member.z;
                                                if _e1161 {
                                                } else {
                                                    phi_4710_ = true;
                                                    break;
                                                }
                                                local_4[_e1160] = _e1138.member.member_1.x;
                                                if _e1161 {
                                                } else {
                                                    phi_4710_ = true;
                                                    break;
                                                }
                                                local_3[_e1160] = _e1138.member.member_1.y;
                                                if _e1161 {
                                                } else {
                                                    phi_4710_ = true;
                                                    break;
                                                }
                                                local_2[_e1160] = _e1138.member.member_1.z;
                                                if _e1161 {
                                                } else {
                                                    phi_4710_ = true;
                                                    break;
                                                }
                                                local_9[_e1160] = select(_e1127, _e1125, (_e1125 > _e1127));
                                                if _e1134 {
                                                    phi_4110_ = _e1032.member_1;
                                                } else {
                                                    phi_4110_ = _e1032.member_2;
                                                }
                                                let _e1174 = phi_4110_;
                                                phi_4111_ = _e1174;
                                                phi_4112_ = (_e709 + 1u);
                                            } else {
                                                phi_4111_ = type_49();
                                                phi_4112_ = u32();
                                            }
                                            let _e1176 = phi_4111_;
                                            let _e1178 = phi_4112_;
                                            phi_4114_ = _e1176;
                                            phi_4115_ = _e1178;
                                            phi_4116_ = select(true, false, _e1133);
                                        } else {
                                            phi_4114_ = type_49();
                                            phi_4115_ = u32();
                                            phi_4116_ = true;
                                        }
                                        let _e1181 = phi_4114_;
                                        let _e1183 = phi_4115_;
                                        let _e1185 = phi_4116_;
                                        if _e1185 {
                                            if _e1132 {
                                                phi_4125_ = _e1032.member_1;
                                            } else {
                                                phi_4125_ = _e1032.member_2;
                                            }
                                            let _e1189 = phi_4125_;
                                            phi_4130_ = _e1189;
                                            phi_4131_ = select(_e1133, true, _e1132);
                                        } else {
                                            phi_4130_ = _e1181;
                                            phi_4131_ = _e707;
                                        }
                                        let _e1192 = phi_4130_;
                                        let _e1194 = phi_4131_;
                                        phi_4714_ = _e664;
                                        phi_4133_ = _e666;
                                        phi_4134_ = _e1192;
                                        phi_4135_ = _e1194;
                                        phi_4136_ = select(_e1183, _e709, _e1185);
                                    }
                                    let _e2137 = phi_4714_;
                                    let _e2139 = phi_4133_;
                                    let _e2141 = phi_4134_;
                                    let _e2143 = phi_4135_;
                                    let _e2145 = phi_4136_;
                                    phi_4713_ = _e2137;
                                    phi_4137_ = _e2139;
                                    phi_4138_ = _e2141;
                                    phi_4139_ = (_e670 - 1u);
                                    phi_4140_ = _e2143;
                                    phi_4141_ = _e2145;
                                } else {
                                    phi_4713_ = _e664;
                                    phi_4137_ = _e666;
                                    phi_4138_ = _e705;
                                    phi_4139_ = _e670;
                                    phi_4140_ = _e707;
                                    phi_4141_ = _e709;
                                }
                                let _e2147 = phi_4713_;
                                let _e2149 = phi_4137_;
                                let _e2151 = phi_4138_;
                                let _e2153 = phi_4139_;
                                let _e2155 = phi_4140_;
                                let _e2157 = phi_4141_;
                                phi_4712_ = _e2147;
                                phi_4142_ = _e2149;
                                phi_4143_ = _e2151;
                                phi_4144_ = _e2153;
                                phi_4145_ = _e2155;
                                phi_4146_ = _e2157;
                            } else {
                                phi_4712_ = _e664;
                                phi_4142_ = type_32();
                                phi_4143_ = type_49();
                                phi_4144_ = u32();
                                phi_4145_ = bool();
                                phi_4146_ = u32();
                            }
                            let _e2159 = phi_4712_;
                            let _e2161 = phi_4142_;
                            let _e2163 = phi_4143_;
                            let _e2165 = phi_4144_;
                            let _e2167 = phi_4145_;
                            let _e2169 = phi_4146_;
                            phi_4711_ = _e2159;
                            phi_1156_ = _e2161;
                            phi_1159_ = _e2163;
                            phi_1161_ = _e2165;
                            phi_1163_ = _e2167;
                            phi_1165_ = _e2169;
                            phi_4147_ = _e678;
                        } else {
                            phi_4711_ = _e664;
                            phi_1156_ = type_32();
                            phi_1159_ = type_49();
                            phi_1161_ = u32();
                            phi_1163_ = bool();
                            phi_1165_ = u32();
                            phi_4147_ = false;
                        }
                        let _e2171 = phi_4711_;
                        let _e2173 = phi_1156_;
                        let _e2175 = phi_1159_;
                        let _e2177 = phi_1161_;
                        let _e2179 = phi_1163_;
                        let _e2181 = phi_1165_;
                        let _e2183 = phi_4147_;
                        continue;
                        continuing {
                            phi_4509_ = _e2171;
                            phi_1155_ = _e2173;
                            phi_1158_ = _e2175;
                            phi_1160_ = _e2177;
                            phi_1162_ = _e2179;
                            phi_1164_ = _e2181;
                            phi_4710_ = _e2171;
                            break if !(_e2183);
                        }
                    }
                    let _e2186 = phi_4710_;
                    if _e2186 {
                        break;
                    }
                    let _e2188 = local_10;
                    if (_e2188.member.member_3 != 4294967295u) {
                        let _e2193 = -(_e524);
                        let _e2194 = bitcast<u32>(_e2188.member.member);
                        let _e2198 = (bitcast<i32>((_e2194 >> bitcast<u32>(23i))) & 255i);
                        let _e2199 = (_e2198 + _e2193);
                        if (_e2198 == 255i) {
                            phi_4206_ = _e2188.member.member;
                        } else {
                            if (_e2198 > 0i) {
                                if (_e2199 > 0i) {
                                    let _e2203 = (_e2199 < 255i);
                                    if _e2203 {
                                        phi_4185_ = bitcast<f32>((_e2194 + bitcast<u32>((_e2193 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_4185_ = f32();
                                    }
                                    let _e2210 = phi_4185_;
                                    phi_4187_ = _e2210;
                                    phi_4188_ = select(true, false, _e2203);
                                } else {
                                    phi_4187_ = f32();
                                    phi_4188_ = true;
                                }
                                let _e2213 = phi_4187_;
                                let _e2215 = phi_4188_;
                                phi_4189_ = _e2213;
                                phi_4190_ = _e2215;
                            } else {
                                phi_4189_ = f32();
                                phi_4190_ = true;
                            }
                            let _e2217 = phi_4189_;
                            let _e2219 = phi_4190_;
                            if _e2219 {
                                let _e2220 = (_e2194 & 2147483648u);
                                let _e2227 = ((_e2194 & 8388607u) | (select(0u, 1u, ((_e2194 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e2231 = (_e2227 == 0u);
                                if _e2231 {
                                    phi_4461_ = bitcast<f32>(_e2220);
                                } else {
                                    let _e2236 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2227)), 32u, _e2231) - 8u);
                                    let _e2239 = (_e2227 << bitcast<u32>((_e2236 & 31u)));
                                    let _e2241 = ((_e2199 + select(0i, 1i, (_e2198 == 0i))) - bitcast<i32>(_e2236));
                                    if (_e2241 >= 255i) {
                                        phi_4451_ = bitcast<f32>((_e2220 | 2139095040u));
                                        phi_4452_ = f32();
                                        phi_4453_ = true;
                                    } else {
                                        let _e2243 = (_e2241 > 0i);
                                        if _e2243 {
                                            phi_4445_ = bitcast<f32>(((_e2220 | (bitcast<u32>(_e2241) << bitcast<u32>(23i))) | (_e2239 & 8388607u)));
                                            phi_4446_ = f32();
                                        } else {
                                            if (_e2241 < -24i) {
                                                phi_4411_ = 26u;
                                            } else {
                                                phi_4411_ = bitcast<u32>((1i - _e2241));
                                            }
                                            let _e2248 = phi_4411_;
                                            let _e2249 = (_e2248 & 31u);
                                            let _e2251 = (_e2239 >> bitcast<u32>(_e2249));
                                            let _e2255 = (_e2239 & ((1u << bitcast<u32>(_e2249)) - 1u));
                                            let _e2259 = (1u << bitcast<u32>(((_e2248 - 1u) & 31u)));
                                            if (_e2255 > _e2259) {
                                                phi_4432_ = true;
                                            } else {
                                                if (_e2255 == _e2259) {
                                                    phi_4429_ = ((_e2251 & 1u) == 1u);
                                                } else {
                                                    phi_4429_ = false;
                                                }
                                                let _e2265 = phi_4429_;
                                                phi_4432_ = _e2265;
                                            }
                                            let _e2267 = phi_4432_;
                                            phi_4445_ = f32();
                                            phi_4446_ = bitcast<f32>((_e2220 | (_e2251 + select(0u, 1u, _e2267))));
                                        }
                                        let _e2280 = phi_4445_;
                                        let _e2282 = phi_4446_;
                                        phi_4451_ = _e2280;
                                        phi_4452_ = _e2282;
                                        phi_4453_ = _e2243;
                                    }
                                    let _e2286 = phi_4451_;
                                    let _e2288 = phi_4452_;
                                    let _e2290 = phi_4453_;
                                    phi_4461_ = select(_e2288, _e2286, _e2290);
                                }
                                let _e2294 = phi_4461_;
                                phi_4205_ = _e2294;
                            } else {
                                phi_4205_ = _e2217;
                            }
                            let _e2296 = phi_4205_;
                            phi_4206_ = _e2296;
                        }
                        let _e2298 = phi_4206_;
                        let _e2299 = bitcast<u32>(_e2298);
                        if ((_e2299 & 2147483647u) >= 2139095040u) {
                            phi_4218_ = bitcast<f32>(((_e2299 & 2147483648u) | 2139095039u));
                        } else {
                            phi_4218_ = _e2298;
                        }
                        let _e2306 = phi_4218_;
                        phi_4223_ = type_20(_e2306, _e2188.member.member_1, _e2188.member.member_2, _e2188.member.member_3);
                    } else {
                        phi_4223_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2311 = phi_4223_;
                    if _e155 {
                    } else {
                        break;
                    }
                    global_6.member[_e153] = _e2311;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_closest_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
