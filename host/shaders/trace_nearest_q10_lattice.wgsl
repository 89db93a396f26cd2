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

struct type_36 {
    member: array<type_25>,
}

struct type_40 {
    member: array<array<type_24, 8>>,
}

struct type_46 {
    member: array<vec4<u32>, 2>,
}

struct type_51 {
    member: type_28,
    member_1: u32,
}

struct type_52 {
    member: array<vec4<f32>, 3>,
    member_1: type_51,
    member_2: type_51,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_46;
@group(0) @binding(2) 
var<storage> global_3: type_13;
@group(0) @binding(4) 
var<storage> global_4: type_36;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_40;

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
    var local_9: array<type_24, 8>;
    var local_10: array<f32, 128>;
    var phi_492_: i32;
    var phi_493_: i32;
    var phi_503_: bool;
    var phi_513_: u32;
    var phi_514_: u32;
    var phi_516_: bool;
    var phi_521_: u32;
    var phi_534_: i32;
    var phi_554_: i32;
    var phi_572_: f32;
    var phi_578_: f32;
    var phi_618_: f32;
    var phi_624_: f32;
    var phi_676_: f32;
    var phi_688_: f32;
    var phi_697_: f32;
    var phi_703_: f32;
    var phi_743_: f32;
    var phi_749_: f32;
    var phi_801_: f32;
    var phi_813_: f32;
    var phi_822_: f32;
    var phi_828_: f32;
    var phi_868_: f32;
    var phi_874_: f32;
    var phi_926_: f32;
    var phi_938_: f32;
    var phi_993_: i32;
    var phi_1015_: u32;
    var phi_1016_: u32;
    var phi_1053_: i32;
    var phi_1075_: u32;
    var phi_1076_: u32;
    var phi_1084_: f32;
    var phi_1085_: f32;
    var phi_4976_: bool;
    var phi_4890_: f32;
    var phi_1234_: u32;
    var phi_1237_: bool;
    var phi_1239_: u32;
    var phi_1241_: type_51;
    var phi_1252_: bool;
    var phi_1339_: bool;
    var phi_1340_: u32;
    var phi_1341_: type_51;
    var phi_4973_: bool;
    var phi_4915_: f32;
    var phi_1360_: type_8;
    var phi_1361_: type_8;
    var phi_1384_: type_8;
    var phi_1425_: u32;
    var phi_1431_: u32;
    var phi_1441_: u32;
    var phi_1457_: u32;
    var phi_1490_: u32;
    var phi_1496_: u32;
    var phi_1962_: u32;
    var phi_1980_: u32;
    var phi_1998_: u32;
    var phi_2021_: u32;
    var phi_2039_: u32;
    var phi_2057_: u32;
    var phi_2080_: u32;
    var phi_2098_: u32;
    var phi_2116_: u32;
    var phi_1670_: u32;
    var phi_1685_: u32;
    var phi_1695_: u32;
    var phi_1716_: u32;
    var phi_1737_: u32;
    var phi_1767_: u32;
    var phi_1782_: u32;
    var phi_1792_: u32;
    var phi_1813_: u32;
    var phi_1834_: u32;
    var phi_1864_: u32;
    var phi_1879_: u32;
    var phi_1889_: u32;
    var phi_1910_: u32;
    var phi_1931_: u32;
    var phi_1523_: u32;
    var phi_1572_: u32;
    var phi_1621_: u32;
    var phi_2122_: array<array<f32, 3>, 3>;
    var phi_2275_: bool;
    var phi_2304_: bool;
    var phi_2723_: f32;
    var phi_2724_: f32;
    var phi_2725_: f32;
    var phi_2726_: f32;
    var phi_2727_: vec3<f32>;
    var phi_2728_: vec3<f32>;
    var phi_2729_: vec3<f32>;
    var phi_2730_: vec3<f32>;
    var phi_2767_: bool;
    var phi_2776_: vec3<f32>;
    var phi_2941_: f32;
    var phi_2943_: f32;
    var phi_2944_: bool;
    var phi_2964_: f32;
    var phi_2965_: f32;
    var phi_2988_: type_24;
    var phi_2990_: type_24;
    var phi_2991_: bool;
    var phi_2995_: type_24;
    var phi_2996_: type_24;
    var phi_2997_: type_24;
    var phi_2998_: bool;
    var phi_3002_: type_24;
    var phi_3003_: bool;
    var phi_3004_: type_24;
    var phi_3005_: bool;
    var phi_3006_: bool;
    var phi_3007_: type_24;
    var phi_3008_: bool;
    var phi_3009_: bool;
    var phi_3017_: type_24;
    var phi_3018_: bool;
    var phi_3022_: type_24;
    var phi_3034_: type_8;
    var phi_3037_: type_24;
    var phi_3035_: type_8;
    var phi_3060_: type_8;
    var phi_3092_: bool;
    var phi_3093_: bool;
    var phi_3114_: type_24;
    var phi_3038_: type_24;
    var phi_4944_: bool;
    var phi_5305_: f32;
    var phi_5304_: f32;
    var phi_5154_: bool;
    var phi_5303_: f32;
    var phi_5153_: bool;
    var phi_5302_: f32;
    var phi_5152_: bool;
    var phi_5214_: f32;
    var phi_5151_: bool;
    var phi_5398_: bool;
    var phi_5213_: f32;
    var phi_3627_: u32;
    var phi_3633_: u32;
    var phi_3887_: u32;
    var phi_3888_: u32;
    var phi_3898_: u32;
    var phi_3900_: u32;
    var phi_3901_: bool;
    var phi_3921_: u32;
    var phi_3922_: u32;
    var phi_3926_: type_52;
    var phi_4289_: type_51;
    var phi_4365_: type_51;
    var phi_4366_: u32;
    var phi_4367_: type_51;
    var phi_4369_: u32;
    var phi_4370_: type_51;
    var phi_4371_: bool;
    var phi_4380_: type_51;
    var phi_4385_: bool;
    var phi_4387_: type_51;
    var phi_4391_: bool;
    var phi_4392_: u32;
    var phi_4393_: type_51;
    var phi_4403_: type_51;
    var phi_5426_: f32;
    var phi_5310_: bool;
    var phi_4404_: u32;
    var phi_4405_: bool;
    var phi_4406_: u32;
    var phi_4407_: type_51;
    var phi_5425_: f32;
    var phi_5309_: bool;
    var phi_4408_: u32;
    var phi_4409_: bool;
    var phi_4410_: u32;
    var phi_4411_: type_51;
    var phi_5424_: f32;
    var phi_5308_: bool;
    var phi_1235_: u32;
    var phi_1238_: bool;
    var phi_1240_: u32;
    var phi_1242_: type_51;
    var phi_4412_: bool;
    var phi_5307_: bool;
    var phi_4419_: type_8;
    var phi_4420_: type_8;
    var phi_4443_: type_8;
    var phi_4495_: f32;
    var phi_4497_: f32;
    var phi_4498_: bool;
    var phi_4499_: f32;
    var phi_4500_: bool;
    var phi_4787_: u32;
    var phi_4805_: bool;
    var phi_4808_: bool;
    var phi_4821_: f32;
    var phi_4822_: f32;
    var phi_4827_: f32;
    var phi_4828_: f32;
    var phi_4829_: bool;
    var phi_4837_: f32;
    var phi_4515_: f32;
    var phi_4516_: f32;
    var phi_4528_: f32;
    var phi_4533_: type_24;
    var phi_5406_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e100 = global;
            let _e102 = arrayLength((&global_3.member));
            let _e105 = arrayLength((&global_5.member));
            let _e113 = global_2.member[0u][0u];
            let _e117 = global_2.member[0u][1u];
            let _e121 = global_2.member[0u][2u];
            let _e125 = global_2.member[0u][3u];
            let _e129 = global_2.member[1u][0u];
            let _e133 = global_2.member[1u][1u];
            let _e137 = global_2.member[1u][2u];
            let _e140 = global_1.member[0u];
            let _e141 = bitcast<i32>(_e140);
            let _e153 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e125) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e113), bitcast<i32>(_e117), bitcast<i32>(_e121));
            local = array<i32, 3>(bitcast<i32>(_e129), bitcast<i32>(_e133), bitcast<i32>(_e137));
            let _e159 = (_e100.x + (_e100.y * 2097152u));
            let _e160 = (_e159 < arrayLength((&global_4.member)));
            if _e160 {
                let _e161 = (_e159 < arrayLength((&global_6.member)));
                if _e161 {
                    if _e160 {
                    } else {
                        break;
                    }
                    let _e169 = global_4.member[_e159].member_2[0u];
                    let _e171 = (bitcast<u32>(_e169) & 2147483647u);
                    let _e176 = global_4.member[_e159].member_2[1u];
                    let _e178 = (bitcast<u32>(_e176) & 2147483647u);
                    let _e183 = global_4.member[_e159].member_2[2u];
                    let _e185 = (bitcast<u32>(_e183) & 2147483647u);
                    let _e190 = global_4.member[_e159].member[0u];
                    let _e192 = (bitcast<u32>(_e190) & 2147483647u);
                    let _e197 = global_4.member[_e159].member[1u];
                    let _e199 = (bitcast<u32>(_e197) & 2147483647u);
                    let _e204 = global_4.member[_e159].member[2u];
                    let _e206 = (bitcast<u32>(_e204) & 2147483647u);
                    let _e208 = select(_e178, _e171, (_e178 < _e171));
                    let _e210 = select(_e185, _e208, (_e185 < _e208));
                    let _e212 = select(_e192, _e210, (_e192 < _e210));
                    let _e214 = select(_e199, _e212, (_e199 < _e212));
                    let _e216 = select(_e206, _e214, (_e206 < _e214));
                    let _e220 = global_4.member[_e159].member_1;
                    let _e221 = bitcast<u32>(_e220);
                    let _e222 = (_e221 & 2147483647u);
                    let _e229 = global_4.member[_e159].member_3;
                    let _e230 = bitcast<u32>(_e229);
                    let _e231 = (_e230 & 2147483647u);
                    let _e235 = (((select(_e222, _e216, (_e222 < _e216)) < 2139095040u) && (_e231 <= 2139095040u)) && (_e210 > 0u));
                    if _e235 {
                        let _e238 = (bitcast<u32>(bitcast<f32>(_e210)) & 2147483647u);
                        if (_e238 >= 8388608u) {
                            phi_492_ = (bitcast<i32>((_e238 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_492_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e238)), 32u, (_e238 == 0u))));
                        }
                        let _e252 = phi_492_;
                        phi_493_ = _e252;
                    } else {
                        phi_493_ = 0i;
                    }
                    let _e254 = phi_493_;
                    let _e255 = (_e171 == _e210);
                    if _e255 {
                        phi_503_ = true;
                    } else {
                        phi_503_ = (_e178 == _e210);
                    }
                    let _e258 = phi_503_;
                    let _e259 = select(1u, 0u, _e255);
                    if _e258 {
                        let _e260 = (_e259 + 1u);
                        phi_513_ = _e260;
                        phi_514_ = _e260;
                        phi_516_ = select(true, false, (_e260 == 2u));
                    } else {
                        phi_513_ = u32();
                        phi_514_ = 0u;
                        phi_516_ = true;
                    }
                    let _e264 = phi_513_;
                    let _e266 = phi_514_;
                    let _e268 = phi_516_;
                    if _e268 {
                        phi_521_ = (_e266 + 1u);
                    } else {
                        phi_521_ = 0u;
                    }
                    let _e272 = phi_521_;
                    let _e273 = select(_e264, _e266, _e268);
                    let _e274 = select(_e259, select(2u, _e259, _e258), _e268);
                    if (_e141 < -126i) {
                        phi_534_ = -126i;
                    } else {
                        phi_534_ = select(_e141, 127i, (_e141 > 127i));
                    }
                    let _e279 = phi_534_;
                    let _e284 = bitcast<f32>((bitcast<u32>((_e279 + 127i)) << bitcast<u32>(23i)));
                    let _e290 = bitcast<f32>((bitcast<u32>(((_e141 - _e279) + 127i)) << bitcast<u32>(23i)));
                    let _e291 = -(_e254);
                    if (_e291 < -126i) {
                        phi_554_ = -126i;
                    } else {
                        phi_554_ = select(_e291, 127i, (_e291 > 127i));
                    }
                    let _e296 = phi_554_;
                    let _e301 = bitcast<f32>((bitcast<u32>((_e296 + 127i)) << bitcast<u32>(23i)));
                    let _e307 = bitcast<f32>((bitcast<u32>(((_e291 - _e296) + 127i)) << bitcast<u32>(23i)));
                    let _e311 = global_4.member[_e159].member;
                    let _e312 = (_e273 == 0u);
                    if _e312 {
                        phi_572_ = _e311[0];
                    } else {
                        phi_572_ = _e311[1];
                    }
                    let _e316 = phi_572_;
                    let _e317 = (_e273 == 2u);
                    if _e317 {
                        phi_578_ = _e311[2];
                    } else {
                        phi_578_ = _e316;
                    }
                    let _e320 = phi_578_;
                    let _e321 = bitcast<u32>(_e320);
                    let _e323 = ((_e321 & 2139095040u) != 0u);
                    let _e337 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e321 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e321 & 2147483648u))), _e320, _e323) * _e284) * select(0.00000011920929f, 1f, _e323)) * _e290);
                    let _e338 = global_4.member[_e159].member_2;
                    if _e312 {
                        phi_618_ = _e338[0];
                    } else {
                        phi_618_ = _e338[1];
                    }
                    let _e342 = phi_618_;
                    if _e317 {
                        phi_624_ = _e338[2];
                    } else {
                        phi_624_ = _e342;
                    }
                    let _e345 = phi_624_;
                    let _e346 = bitcast<u32>(_e345);
                    let _e348 = ((_e346 & 2139095040u) != 0u);
                    let _e362 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e346 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e346 & 2147483648u))), _e345, _e348) * _e301) * select(0.00000011920929f, 1f, _e348)) * _e307);
                    let _e366 = (bitcast<f32>((bitcast<u32>(_e362) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e366 {
                        let _e370 = (bitcast<f32>((bitcast<u32>(_e337) & 2147483647u)) * 0.00000011920929f);
                        phi_676_ = select(0.00000000000011368684f, _e370, (_e370 > 0.00000000000011368684f));
                    } else {
                        phi_676_ = 0f;
                    }
                    let _e374 = phi_676_;
                    let _e375 = (_e337 + _e374);
                    let _e376 = (_e337 - _e374);
                    let _e377 = select(_e362, 0f, _e366);
                    if _e366 {
                        phi_688_ = 38685626000000000000000000f;
                    } else {
                        phi_688_ = (1f / _e362);
                    }
                    let _e380 = phi_688_;
                    let _e381 = (_e272 == 0u);
                    if _e381 {
                        phi_697_ = _e311[0];
                    } else {
                        phi_697_ = _e311[1];
                    }
                    let _e385 = phi_697_;
                    let _e386 = (_e272 == 2u);
                    if _e386 {
                        phi_703_ = _e311[2];
                    } else {
                        phi_703_ = _e385;
                    }
                    let _e389 = phi_703_;
                    let _e390 = bitcast<u32>(_e389);
                    let _e392 = ((_e390 & 2139095040u) != 0u);
                    let _e406 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e390 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e390 & 2147483648u))), _e389, _e392) * _e284) * select(0.00000011920929f, 1f, _e392)) * _e290);
                    if _e381 {
                        phi_743_ = _e338[0];
                    } else {
                        phi_743_ = _e338[1];
                    }
                    let _e410 = phi_743_;
                    if _e386 {
                        phi_749_ = _e338[2];
                    } else {
                        phi_749_ = _e410;
                    }
                    let _e413 = phi_749_;
                    let _e414 = bitcast<u32>(_e413);
                    let _e416 = ((_e414 & 2139095040u) != 0u);
                    let _e430 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e414 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e414 & 2147483648u))), _e413, _e416) * _e301) * select(0.00000011920929f, 1f, _e416)) * _e307);
                    let _e434 = (bitcast<f32>((bitcast<u32>(_e430) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e434 {
                        let _e438 = (bitcast<f32>((bitcast<u32>(_e406) & 2147483647u)) * 0.00000011920929f);
                        phi_801_ = select(0.00000000000011368684f, _e438, (_e438 > 0.00000000000011368684f));
                    } else {
                        phi_801_ = 0f;
                    }
                    let _e442 = phi_801_;
                    let _e443 = (_e406 + _e442);
                    let _e444 = (_e406 - _e442);
                    let _e445 = select(_e430, 0f, _e434);
                    if _e434 {
                        phi_813_ = 38685626000000000000000000f;
                    } else {
                        phi_813_ = (1f / _e430);
                    }
                    let _e448 = phi_813_;
                    let _e449 = (_e274 == 0u);
                    if _e449 {
                        phi_822_ = _e311[0];
                    } else {
                        phi_822_ = _e311[1];
                    }
                    let _e453 = phi_822_;
                    let _e454 = (_e274 == 2u);
                    if _e454 {
                        phi_828_ = _e311[2];
                    } else {
                        phi_828_ = _e453;
                    }
                    let _e457 = phi_828_;
                    let _e458 = bitcast<u32>(_e457);
                    let _e460 = ((_e458 & 2139095040u) != 0u);
                    let _e474 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e458 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e458 & 2147483648u))), _e457, _e460) * _e284) * select(0.00000011920929f, 1f, _e460)) * _e290);
                    if _e449 {
                        phi_868_ = _e338[0];
                    } else {
                        phi_868_ = _e338[1];
                    }
                    let _e478 = phi_868_;
                    if _e454 {
                        phi_874_ = _e338[2];
                    } else {
                        phi_874_ = _e478;
                    }
                    let _e481 = phi_874_;
                    let _e482 = bitcast<u32>(_e481);
                    let _e484 = ((_e482 & 2139095040u) != 0u);
                    let _e498 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e482 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e482 & 2147483648u))), _e481, _e484) * _e301) * select(0.00000011920929f, 1f, _e484)) * _e307);
                    let _e502 = (bitcast<f32>((bitcast<u32>(_e498) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e502 {
                        let _e506 = (bitcast<f32>((bitcast<u32>(_e474) & 2147483647u)) * 0.00000011920929f);
                        phi_926_ = select(0.00000000000011368684f, _e506, (_e506 > 0.00000000000011368684f));
                    } else {
                        phi_926_ = 0f;
                    }
                    let _e510 = phi_926_;
                    let _e511 = (_e474 + _e510);
                    let _e512 = (_e474 - _e510);
                    let _e513 = select(_e498, 0f, _e502);
                    if _e502 {
                        phi_938_ = 38685626000000000000000000f;
                    } else {
                        phi_938_ = (1f / _e498);
                    }
                    let _e516 = phi_938_;
                    let _e519 = bitcast<f32>((bitcast<u32>(_e337) & 2147483647u));
                    let _e522 = bitcast<f32>((bitcast<u32>(_e406) & 2147483647u));
                    let _e524 = select(_e522, _e519, (_e519 > _e522));
                    let _e527 = bitcast<f32>((bitcast<u32>(_e474) & 2147483647u));
                    let _e530 = (_e141 + _e254);
                    if (_e235 && (select(_e527, _e524, (_e524 > _e527)) <= 1099511600000f)) {
                        let _e540 = ((_e222 & 8388607u) | (select(0u, 1u, ((_e222 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e543 = bitcast<i32>((_e222 >> bitcast<u32>(23i)));
                        let _e547 = (_e540 == 0u);
                        let _e550 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e540)), 32u, _e547)) - 8i);
                        if (_e543 == 255i) {
                            phi_993_ = 255i;
                        } else {
                            phi_993_ = (((_e543 + select(0i, 1i, (_e543 == 0i))) - _e550) + _e530);
                        }
                        let _e558 = phi_993_;
                        let _e568 = (_e558 <= 0i);
                        if _e568 {
                            phi_1016_ = u32();
                        } else {
                            if _e547 {
                                phi_1015_ = u32();
                            } else {
                                phi_1015_ = select(((bitcast<u32>(_e558) << bitcast<u32>(23i)) | ((_e540 << bitcast<u32>(((_e550 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e558 >= 255i));
                            }
                            let _e572 = phi_1015_;
                            phi_1016_ = _e572;
                        }
                        let _e574 = phi_1016_;
                        let _e586 = ((_e231 & 8388607u) | (select(0u, 1u, ((_e231 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e589 = bitcast<i32>((_e231 >> bitcast<u32>(23i)));
                        let _e593 = (_e586 == 0u);
                        let _e596 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e586)), 32u, _e593)) - 8i);
                        if (_e589 == 255i) {
                            phi_1053_ = 255i;
                        } else {
                            phi_1053_ = (((_e589 + select(0i, 1i, (_e589 == 0i))) - _e596) + _e530);
                        }
                        let _e604 = phi_1053_;
                        let _e614 = (_e604 <= 0i);
                        if _e614 {
                            phi_1076_ = u32();
                        } else {
                            if _e593 {
                                phi_1075_ = u32();
                            } else {
                                phi_1075_ = select(((bitcast<u32>(_e604) << bitcast<u32>(23i)) | ((_e586 << bitcast<u32>(((_e596 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e604 >= 255i));
                            }
                            let _e618 = phi_1075_;
                            phi_1076_ = _e618;
                        }
                        let _e620 = phi_1076_;
                        phi_1084_ = bitcast<f32>(((_e230 & 2147483648u) | select(_e620, 0u, select(_e593, true, _e614))));
                        phi_1085_ = bitcast<f32>(((_e221 & 2147483648u) | select(_e574, 0u, select(_e547, true, _e568))));
                    } else {
                        phi_1084_ = 0f;
                        phi_1085_ = 1f;
                    }
                    let _e626 = phi_1084_;
                    let _e628 = phi_1085_;
                    local_9 = array<type_24, 8>(type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_10 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e631 = (_e273 % 3u);
                    let _e632 = (_e631 < 3u);
                    if _e632 {
                    } else {
                        break;
                    }
                    let _e634 = local_1[_e631];
                    let _e637 = (_e272 % 3u);
                    let _e638 = (_e637 < 3u);
                    if _e638 {
                    } else {
                        break;
                    }
                    let _e640 = local_1[_e637];
                    let _e643 = (_e274 % 3u);
                    let _e644 = (_e643 < 3u);
                    if _e644 {
                    } else {
                        break;
                    }
                    let _e646 = local_1[_e643];
                    if _e632 {
                    } else {
                        break;
                    }
                    let _e651 = local[_e631];
                    if _e638 {
                    } else {
                        break;
                    }
                    let _e655 = local[_e637];
                    if _e644 {
                    } else {
                        break;
                    }
                    let _e659 = local[_e643];
                    phi_4976_ = false;
                    phi_4890_ = _e626;
                    phi_1234_ = ((3u * _e102) + 1u);
                    phi_1237_ = (_e628 <= _e626);
                    phi_1239_ = 0u;
                    phi_1241_ = type_51(type_28(vec4<f32>((f32(_e634) * _e153), (f32(_e640) * _e153), (f32(_e646) * _e153), 0f), vec4<f32>((f32(_e651) * _e153), (f32(_e655) * _e153), (f32(_e659) * _e153), 0f)), select(0u, 2147483648u, (_e102 == 0u)));
                    loop {
                        let _e669 = phi_4976_;
                        let _e671 = phi_4890_;
                        let _e673 = phi_1234_;
                        let _e675 = phi_1237_;
                        let _e677 = phi_1239_;
                        let _e679 = phi_1241_;
                        if _e675 {
                            phi_1252_ = true;
                        } else {
                            phi_1252_ = (_e677 > 0u);
                        }
                        let _e682 = phi_1252_;
                        if _e682 {
                            let _e683 = (_e673 > 0u);
                            if _e683 {
                                if _e675 {
                                    phi_1339_ = _e675;
                                    phi_1340_ = _e677;
                                    phi_1341_ = _e679;
                                } else {
                                    let _e684 = (_e677 - 1u);
                                    let _e685 = (_e684 % 128u);
                                    let _e686 = (_e685 < 128u);
                                    if _e686 {
                                    } else {
                                        phi_5307_ = true;
                                        break;
                                    }
                                    let _e688 = local_7[_e685];
                                    if _e686 {
                                    } else {
                                        phi_5307_ = true;
                                        break;
                                    }
                                    let _e690 = local_6[_e685];
                                    if _e686 {
                                    } else {
                                        phi_5307_ = true;
                                        break;
                                    }
                                    let _e692 = local_5[_e685];
                                    if _e686 {
                                    } else {
                                        phi_5307_ = true;
                                        break;
                                    }
                                    let _e694 = local_4[_e685];
                                    if _e686 {
                                    } else {
                                        phi_5307_ = true;
                                        break;
                                    }
                                    let _e696 = local_3[_e685];
                                    if _e686 {
                                    } else {
                                        phi_5307_ = true;
                                        break;
                                    }
                                    let _e698 = local_2[_e685];
                                    if _e686 {
                                    } else {
                                        phi_5307_ = true;
                                        break;
                                    }
                                    let _e703 = local_8[_e685];
                                    if _e686 {
                                    } else {
                                        phi_5307_ = true;
                                        break;
                                    }
                                    let _e706 = local_10[_e685];
                                    phi_1339_ = (_e706 <= _e671);
                                    phi_1340_ = _e684;
                                    phi_1341_ = type_51(type_28(vec4<f32>(_e688, _e690, _e692, 0f), vec4<f32>(_e694, _e696, _e698, 0f)), _e703);
                                }
                                let _e709 = phi_1339_;
                                let _e711 = phi_1340_;
                                let _e713 = phi_1341_;
                                if _e709 {
                                    let _e717 = ((_e713.member_1 & 2147483648u) != 0u);
                                    let _e718 = (_e713.member_1 & 268435455u);
                                    if _e717 {
                                        phi_4973_ = _e669;
                                        phi_4915_ = _e671;
                                        phi_1360_ = type_8(0u, ((_e713.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e725 = phi_4973_;
                                            let _e727 = phi_4915_;
                                            let _e729 = phi_1360_;
                                            if (_e729.member < _e729.member_1) {
                                                phi_1361_ = type_8((_e729.member + 1u), _e729.member_1);
                                                phi_1384_ = type_8(1u, _e729.member);
                                            } else {
                                                phi_1361_ = _e729;
                                                phi_1384_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e742 = phi_1361_;
                                            let _e744 = phi_1384_;
                                            let _e748 = (bitcast<i32>(_e744.member) != 0i);
                                            if _e748 {
                                                let _e753 = (_e713.member.member_1.x - _e713.member.member.x);
                                                let _e756 = (_e713.member.member_1.y - _e713.member.member.y);
                                                let _e759 = (_e713.member.member_1.z - _e713.member.member.z);
                                                let _e761 = select(_e756, _e753, (_e753 > _e756));
                                                let _e763 = select(_e759, _e761, (_e761 > _e759));
                                                let _e765 = (_e763 < (1024f * _e153));
                                                if _e765 {
                                                    phi_1425_ = 0u;
                                                } else {
                                                    phi_1425_ = select(2u, 1u, (_e763 < (2097152f * _e153)));
                                                }
                                                let _e770 = phi_1425_;
                                                switch bitcast<i32>(_e770) {
                                                    case 0: {
                                                        phi_1431_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1431_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1431_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1431_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e773 = phi_1431_;
                                                switch bitcast<i32>(_e770) {
                                                    case 0: {
                                                        phi_1441_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1441_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1441_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1441_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e780 = phi_1441_;
                                                let _e782 = ((_e718 + (_e744.member_1 * ((3u * _e773) + 1u))) + (3u * _e780));
                                                let _e783 = (_e782 < _e105);
                                                if _e783 {
                                                    if _e783 {
                                                    } else {
                                                        phi_5214_ = _e727;
                                                        phi_5151_ = true;
                                                        break;
                                                    }
                                                    let _e785 = global_5.member[_e782];
                                                    phi_1457_ = _e785;
                                                } else {
                                                    phi_1457_ = 4294967295u;
                                                }
                                                let _e787 = phi_1457_;
                                                if _e765 {
                                                    phi_1490_ = 0u;
                                                } else {
                                                    phi_1490_ = select(2u, 1u, (_e763 < (2097152f * _e153)));
                                                }
                                                let _e792 = phi_1490_;
                                                switch bitcast<i32>(_e792) {
                                                    case 0: {
                                                        phi_1496_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1496_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1496_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1496_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e795 = phi_1496_;
                                                let _e799 = (_e718 + (_e744.member_1 * ((3u * _e795) + 1u)));
                                                switch bitcast<i32>(_e792) {
                                                    case 0: {
                                                        let _e1074 = (_e799 < _e105);
                                                        if _e1074 {
                                                            if _e1074 {
                                                            } else {
                                                                phi_5214_ = _e727;
                                                                phi_5151_ = true;
                                                                break;
                                                            }
                                                            let _e1076 = global_5.member[_e799];
                                                            phi_1523_ = _e1076;
                                                        } else {
                                                            phi_1523_ = 0u;
                                                        }
                                                        let _e1078 = phi_1523_;
                                                        let _e1080 = ((10u * _e273) & 31u);
                                                        let _e1090 = ((10u * _e272) & 31u);
                                                        let _e1100 = ((10u * _e274) & 31u);
                                                        let _e1110 = (_e799 + 1u);
                                                        let _e1111 = (_e1110 < _e105);
                                                        if _e1111 {
                                                            if _e1111 {
                                                            } else {
                                                                phi_5214_ = _e727;
                                                                phi_5151_ = true;
                                                                break;
                                                            }
                                                            let _e1113 = global_5.member[_e1110];
                                                            phi_1572_ = _e1113;
                                                        } else {
                                                            phi_1572_ = 0u;
                                                        }
                                                        let _e1115 = phi_1572_;
                                                        let _e1141 = (_e799 + 2u);
                                                        let _e1142 = (_e1141 < _e105);
                                                        if _e1142 {
                                                            if _e1142 {
                                                            } else {
                                                                phi_5214_ = _e727;
                                                                phi_5151_ = true;
                                                                break;
                                                            }
                                                            let _e1144 = global_5.member[_e1141];
                                                            phi_1621_ = _e1144;
                                                        } else {
                                                            phi_1621_ = 0u;
                                                        }
                                                        let _e1146 = phi_1621_;
                                                        phi_2122_ = array<array<f32, 3>, 3>(array<f32, 3>((_e713.member.member.x + ((bitcast<f32>((1258291200u | ((_e1078 >> bitcast<u32>(_e1080)) & 1023u))) - 8388608f) * _e153)), (_e713.member.member.y + ((bitcast<f32>((1258291200u | ((_e1078 >> bitcast<u32>(_e1090)) & 1023u))) - 8388608f) * _e153)), (_e713.member.member.z + ((bitcast<f32>((1258291200u | ((_e1078 >> bitcast<u32>(_e1100)) & 1023u))) - 8388608f) * _e153))), array<f32, 3>((_e713.member.member.x + ((bitcast<f32>((1258291200u | ((_e1115 >> bitcast<u32>(_e1080)) & 1023u))) - 8388608f) * _e153)), (_e713.member.member.y + ((bitcast<f32>((1258291200u | ((_e1115 >> bitcast<u32>(_e1090)) & 1023u))) - 8388608f) * _e153)), (_e713.member.member.z + ((bitcast<f32>((1258291200u | ((_e1115 >> bitcast<u32>(_e1100)) & 1023u))) - 8388608f) * _e153))), array<f32, 3>((_e713.member.member.x + ((bitcast<f32>((1258291200u | ((_e1146 >> bitcast<u32>(_e1080)) & 1023u))) - 8388608f) * _e153)), (_e713.member.member.y + ((bitcast<f32>((1258291200u | ((_e1146 >> bitcast<u32>(_e1090)) & 1023u))) - 8388608f) * _e153)), (_e713.member.member.z + ((bitcast<f32>((1258291200u | ((_e1146 >> bitcast<u32>(_e1100)) & 1023u))) - 8388608f) * _e153))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e888 = (_e799 < _e105);
                                                        if _e888 {
                                                            if _e888 {
                                                            } else {
                                                                phi_5214_ = _e727;
                                                                phi_5151_ = true;
                                                                break;
                                                            }
                                                            let _e890 = global_5.member[_e799];
                                                            phi_1670_ = _e890;
                                                        } else {
                                                            phi_1670_ = 0u;
                                                        }
                                                        let _e892 = phi_1670_;
                                                        let _e893 = (_e799 + 1u);
                                                        let _e894 = (_e893 < _e105);
                                                        if _e894 {
                                                            if _e894 {
                                                            } else {
                                                                phi_5214_ = _e727;
                                                                phi_5151_ = true;
                                                                break;
                                                            }
                                                            let _e896 = global_5.member[_e893];
                                                            phi_1685_ = _e896;
                                                        } else {
                                                            phi_1685_ = 0u;
                                                        }
                                                        let _e898 = phi_1685_;
                                                        let _e899 = (_e273 == 1u);
                                                        if _e899 {
                                                            phi_1695_ = ((_e892 >> bitcast<u32>(21i)) | (_e898 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1695_ = (_e898 >> bitcast<u32>(10i));
                                                        }
                                                        let _e908 = phi_1695_;
                                                        let _e916 = (_e272 == 1u);
                                                        if _e916 {
                                                            phi_1716_ = ((_e892 >> bitcast<u32>(21i)) | (_e898 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1716_ = (_e898 >> bitcast<u32>(10i));
                                                        }
                                                        let _e925 = phi_1716_;
                                                        let _e933 = (_e274 == 1u);
                                                        if _e933 {
                                                            phi_1737_ = ((_e892 >> bitcast<u32>(21i)) | (_e898 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1737_ = (_e898 >> bitcast<u32>(10i));
                                                        }
                                                        let _e942 = phi_1737_;
                                                        let _e951 = (_e799 + 2u);
                                                        let _e952 = (_e951 < _e105);
                                                        if _e952 {
                                                            if _e952 {
                                                            } else {
                                                                phi_5214_ = _e727;
                                                                phi_5151_ = true;
                                                                break;
                                                            }
                                                            let _e954 = global_5.member[_e951];
                                                            phi_1767_ = _e954;
                                                        } else {
                                                            phi_1767_ = 0u;
                                                        }
                                                        let _e956 = phi_1767_;
                                                        let _e957 = (_e799 + 3u);
                                                        let _e958 = (_e957 < _e105);
                                                        if _e958 {
                                                            if _e958 {
                                                            } else {
                                                                phi_5214_ = _e727;
                                                                phi_5151_ = true;
                                                                break;
                                                            }
                                                            let _e960 = global_5.member[_e957];
                                                            phi_1782_ = _e960;
                                                        } else {
                                                            phi_1782_ = 0u;
                                                        }
                                                        let _e962 = phi_1782_;
                                                        if _e899 {
                                                            phi_1792_ = ((_e956 >> bitcast<u32>(21i)) | (_e962 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1792_ = (_e962 >> bitcast<u32>(10i));
                                                        }
                                                        let _e971 = phi_1792_;
                                                        if _e916 {
                                                            phi_1813_ = ((_e956 >> bitcast<u32>(21i)) | (_e962 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1813_ = (_e962 >> bitcast<u32>(10i));
                                                        }
                                                        let _e987 = phi_1813_;
                                                        if _e933 {
                                                            phi_1834_ = ((_e956 >> bitcast<u32>(21i)) | (_e962 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1834_ = (_e962 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1003 = phi_1834_;
                                                        let _e1012 = (_e799 + 4u);
                                                        let _e1013 = (_e1012 < _e105);
                                                        if _e1013 {
                                                            if _e1013 {
                                                            } else {
                                                                phi_5214_ = _e727;
                                                                phi_5151_ = true;
                                                                break;
                                                            }
                                                            let _e1015 = global_5.member[_e1012];
                                                            phi_1864_ = _e1015;
                                                        } else {
                                                            phi_1864_ = 0u;
                                                        }
                                                        let _e1017 = phi_1864_;
                                                        let _e1018 = (_e799 + 5u);
                                                        let _e1019 = (_e1018 < _e105);
                                                        if _e1019 {
                                                            if _e1019 {
                                                            } else {
                                                                phi_5214_ = _e727;
                                                                phi_5151_ = true;
                                                                break;
                                                            }
                                                            let _e1021 = global_5.member[_e1018];
                                                            phi_1879_ = _e1021;
                                                        } else {
                                                            phi_1879_ = 0u;
                                                        }
                                                        let _e1023 = phi_1879_;
                                                        if _e899 {
                                                            phi_1889_ = ((_e1017 >> bitcast<u32>(21i)) | (_e1023 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1889_ = (_e1023 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1032 = phi_1889_;
                                                        if _e916 {
                                                            phi_1910_ = ((_e1017 >> bitcast<u32>(21i)) | (_e1023 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1910_ = (_e1023 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1048 = phi_1910_;
                                                        if _e933 {
                                                            phi_1931_ = ((_e1017 >> bitcast<u32>(21i)) | (_e1023 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1931_ = (_e1023 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1064 = phi_1931_;
                                                        phi_2122_ = array<array<f32, 3>, 3>(array<f32, 3>((_e713.member.member.x + ((bitcast<f32>((1258291200u | (select(_e908, _e892, _e312) & 2097151u))) - 8388608f) * _e153)), (_e713.member.member.y + ((bitcast<f32>((1258291200u | (select(_e925, _e892, _e381) & 2097151u))) - 8388608f) * _e153)), (_e713.member.member.z + ((bitcast<f32>((1258291200u | (select(_e942, _e892, _e449) & 2097151u))) - 8388608f) * _e153))), array<f32, 3>((_e713.member.member.x + ((bitcast<f32>((1258291200u | (select(_e971, _e956, _e312) & 2097151u))) - 8388608f) * _e153)), (_e713.member.member.y + ((bitcast<f32>((1258291200u | (select(_e987, _e956, _e381) & 2097151u))) - 8388608f) * _e153)), (_e713.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1003, _e956, _e449) & 2097151u))) - 8388608f) * _e153))), array<f32, 3>((_e713.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1032, _e1017, _e312) & 2097151u))) - 8388608f) * _e153)), (_e713.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1048, _e1017, _e381) & 2097151u))) - 8388608f) * _e153)), (_e713.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1064, _e1017, _e449) & 2097151u))) - 8388608f) * _e153))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e801 = (_e799 + _e273);
                                                        let _e802 = (_e801 < _e105);
                                                        if _e802 {
                                                            if _e802 {
                                                            } else {
                                                                phi_5214_ = _e727;
                                                                phi_5151_ = true;
                                                                break;
                                                            }
                                                            let _e804 = global_5.member[_e801];
                                                            phi_1962_ = _e804;
                                                        } else {
                                                            phi_1962_ = 0u;
                                                        }
                                                        let _e806 = phi_1962_;
                                                        let _e810 = (_e799 + _e272);
                                                        let _e811 = (_e810 < _e105);
                                                        if _e811 {
                                                            if _e811 {
                                                            } else {
                                                                phi_5214_ = _e727;
                                                                phi_5151_ = true;
                                                                break;
                                                            }
                                                            let _e813 = global_5.member[_e810];
                                                            phi_1980_ = _e813;
                                                        } else {
                                                            phi_1980_ = 0u;
                                                        }
                                                        let _e815 = phi_1980_;
                                                        let _e819 = (_e799 + _e274);
                                                        let _e820 = (_e819 < _e105);
                                                        if _e820 {
                                                            if _e820 {
                                                            } else {
                                                                phi_5214_ = _e727;
                                                                phi_5151_ = true;
                                                                break;
                                                            }
                                                            let _e822 = global_5.member[_e819];
                                                            phi_1998_ = _e822;
                                                        } else {
                                                            phi_1998_ = 0u;
                                                        }
                                                        let _e824 = phi_1998_;
                                                        let _e829 = (_e799 + 3u);
                                                        let _e830 = (_e829 + _e273);
                                                        let _e831 = (_e830 < _e105);
                                                        if _e831 {
                                                            if _e831 {
                                                            } else {
                                                                phi_5214_ = _e727;
                                                                phi_5151_ = true;
                                                                break;
                                                            }
                                                            let _e833 = global_5.member[_e830];
                                                            phi_2021_ = _e833;
                                                        } else {
                                                            phi_2021_ = 0u;
                                                        }
                                                        let _e835 = phi_2021_;
                                                        let _e839 = (_e829 + _e272);
                                                        let _e840 = (_e839 < _e105);
                                                        if _e840 {
                                                            if _e840 {
                                                            } else {
                                                                phi_5214_ = _e727;
                                                                phi_5151_ = true;
                                                                break;
                                                            }
                                                            let _e842 = global_5.member[_e839];
                                                            phi_2039_ = _e842;
                                                        } else {
                                                            phi_2039_ = 0u;
                                                        }
                                                        let _e844 = phi_2039_;
                                                        let _e848 = (_e829 + _e274);
                                                        let _e849 = (_e848 < _e105);
                                                        if _e849 {
                                                            if _e849 {
                                                            } else {
                                                                phi_5214_ = _e727;
                                                                phi_5151_ = true;
                                                                break;
                                                            }
                                                            let _e851 = global_5.member[_e848];
                                                            phi_2057_ = _e851;
                                                        } else {
                                                            phi_2057_ = 0u;
                                                        }
                                                        let _e853 = phi_2057_;
                                                        let _e858 = (_e799 + 6u);
                                                        let _e859 = (_e858 + _e273);
                                                        let _e860 = (_e859 < _e105);
                                                        if _e860 {
                                                            if _e860 {
                                                            } else {
                                                                phi_5214_ = _e727;
                                                                phi_5151_ = true;
                                                                break;
                                                            }
                                                            let _e862 = global_5.member[_e859];
                                                            phi_2080_ = _e862;
                                                        } else {
                                                            phi_2080_ = 0u;
                                                        }
                                                        let _e864 = phi_2080_;
                                                        let _e868 = (_e858 + _e272);
                                                        let _e869 = (_e868 < _e105);
                                                        if _e869 {
                                                            if _e869 {
                                                            } else {
                                                                phi_5214_ = _e727;
                                                                phi_5151_ = true;
                                                                break;
                                                            }
                                                            let _e871 = global_5.member[_e868];
                                                            phi_2098_ = _e871;
                                                        } else {
                                                            phi_2098_ = 0u;
                                                        }
                                                        let _e873 = phi_2098_;
                                                        let _e877 = (_e858 + _e274);
                                                        let _e878 = (_e877 < _e105);
                                                        if _e878 {
                                                            if _e878 {
                                                            } else {
                                                                phi_5214_ = _e727;
                                                                phi_5151_ = true;
                                                                break;
                                                            }
                                                            let _e880 = global_5.member[_e877];
                                                            phi_2116_ = _e880;
                                                        } else {
                                                            phi_2116_ = 0u;
                                                        }
                                                        let _e882 = phi_2116_;
                                                        phi_2122_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e806)) * _e153), (f32(bitcast<i32>(_e815)) * _e153), (f32(bitcast<i32>(_e824)) * _e153)), array<f32, 3>((f32(bitcast<i32>(_e835)) * _e153), (f32(bitcast<i32>(_e844)) * _e153), (f32(bitcast<i32>(_e853)) * _e153)), array<f32, 3>((f32(bitcast<i32>(_e864)) * _e153), (f32(bitcast<i32>(_e873)) * _e153), (f32(bitcast<i32>(_e882)) * _e153)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2122_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1174 = phi_2122_;
                                                let _e1181 = (_e1174[0][2] - _e474);
                                                let _e1184 = (((_e1174[0][0] - _e337) * _e513) - (_e1181 * _e377));
                                                let _e1187 = (((_e1174[0][1] - _e406) * _e513) - (_e1181 * _e445));
                                                let _e1194 = (_e1174[1][2] - _e474);
                                                let _e1197 = (((_e1174[1][0] - _e337) * _e513) - (_e1194 * _e377));
                                                let _e1200 = (((_e1174[1][1] - _e406) * _e513) - (_e1194 * _e445));
                                                let _e1207 = (_e1174[2][2] - _e474);
                                                let _e1210 = (((_e1174[2][0] - _e337) * _e513) - (_e1207 * _e377));
                                                let _e1213 = (((_e1174[2][1] - _e406) * _e513) - (_e1207 * _e445));
                                                let _e1214 = (_e1210 * _e1200);
                                                let _e1215 = (_e1213 * _e1197);
                                                let _e1216 = (_e1184 * _e1213);
                                                let _e1217 = (_e1187 * _e1210);
                                                let _e1218 = (_e1197 * _e1187);
                                                let _e1219 = (_e1200 * _e1184);
                                                let _e1224 = (((_e1214 >= _e1215) && (_e1216 >= _e1217)) && (_e1218 >= _e1219));
                                                if (_e1224 || (((_e1214 <= _e1215) && (_e1216 <= _e1217)) && (_e1218 <= _e1219))) {
                                                    let _e1231 = select(-1f, 1f, _e1224);
                                                    let _e1233 = ((_e1214 - _e1215) * _e1231);
                                                    let _e1235 = select(0f, _e1233, (_e1233 > 0f));
                                                    let _e1237 = ((_e1216 - _e1217) * _e1231);
                                                    let _e1239 = select(0f, _e1237, (_e1237 > 0f));
                                                    let _e1241 = ((_e1218 - _e1219) * _e1231);
                                                    let _e1243 = select(0f, _e1241, (_e1241 > 0f));
                                                    let _e1245 = ((_e1235 + _e1239) + _e1243);
                                                    if (_e1245 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_3007_ = type_24();
                                                        phi_3008_ = true;
                                                        phi_3009_ = false;
                                                    } else {
                                                        let _e1248 = select(_e1197, _e1184, (_e1184 < _e1197));
                                                        if (select(_e1210, _e1248, (_e1248 < _e1210)) > 0f) {
                                                            phi_2275_ = true;
                                                        } else {
                                                            let _e1253 = select(_e1197, _e1184, (_e1184 > _e1197));
                                                            phi_2275_ = (select(_e1210, _e1253, (_e1253 > _e1210)) < 0f);
                                                        }
                                                        let _e1258 = phi_2275_;
                                                        if _e1258 {
                                                            phi_3004_ = type_24();
                                                            phi_3005_ = true;
                                                            phi_3006_ = false;
                                                        } else {
                                                            let _e1260 = select(_e1200, _e1187, (_e1187 < _e1200));
                                                            if (select(_e1213, _e1260, (_e1260 < _e1213)) > 0f) {
                                                                phi_2304_ = true;
                                                            } else {
                                                                let _e1265 = select(_e1200, _e1187, (_e1187 > _e1200));
                                                                phi_2304_ = (select(_e1213, _e1265, (_e1265 > _e1213)) < 0f);
                                                            }
                                                            let _e1270 = phi_2304_;
                                                            if _e1270 {
                                                                phi_3002_ = type_24();
                                                                phi_3003_ = false;
                                                            } else {
                                                                let _e1272 = select(_e1174[1][0], _e1174[0][0], (_e1174[0][0] < _e1174[1][0]));
                                                                let _e1276 = select(_e1174[1][0], _e1174[0][0], (_e1174[0][0] > _e1174[1][0]));
                                                                let _e1280 = select(_e1174[1][1], _e1174[0][1], (_e1174[0][1] < _e1174[1][1]));
                                                                let _e1284 = select(_e1174[1][1], _e1174[0][1], (_e1174[0][1] > _e1174[1][1]));
                                                                let _e1288 = select(_e1174[1][2], _e1174[0][2], (_e1174[0][2] < _e1174[1][2]));
                                                                let _e1292 = select(_e1174[1][2], _e1174[0][2], (_e1174[0][2] > _e1174[1][2]));
                                                                let _e1297 = ((select(_e1174[2][0], _e1272, (_e1272 < _e1174[2][0])) - _e375) * _e380);
                                                                let _e1298 = ((select(_e1174[2][0], _e1276, (_e1276 > _e1174[2][0])) - _e376) * _e380);
                                                                let _e1301 = ((select(_e1174[2][1], _e1280, (_e1280 < _e1174[2][1])) - _e443) * _e448);
                                                                let _e1302 = ((select(_e1174[2][1], _e1284, (_e1284 > _e1174[2][1])) - _e444) * _e448);
                                                                let _e1305 = ((select(_e1174[2][2], _e1288, (_e1288 < _e1174[2][2])) - _e511) * _e516);
                                                                let _e1306 = ((select(_e1174[2][2], _e1292, (_e1292 > _e1174[2][2])) - _e512) * _e516);
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
                                                                let _e1333 = select(_e628, _e1318, (_e1318 > _e628));
                                                                if (_e1333 > (_e1326 + (select(_e1327, _e1310, (_e1310 > _e1327)) * 0.0000019073523f))) {
                                                                    phi_2997_ = type_24();
                                                                    phi_2998_ = true;
                                                                } else {
                                                                    let _e1335 = (_e1333 > _e727);
                                                                    if _e1335 {
                                                                        phi_2996_ = type_24();
                                                                    } else {
                                                                        let _e1336 = vec3<f32>(_e1174[0][0], _e1174[0][1], _e1174[0][2]);
                                                                        let _e1337 = vec3<f32>(_e1174[1][0], _e1174[1][1], _e1174[1][2]);
                                                                        let _e1338 = vec3<f32>(_e1174[2][0], _e1174[2][1], _e1174[2][2]);
                                                                        let _e1339 = (_e1174[1][0] - _e1174[0][0]);
                                                                        let _e1340 = (_e1174[1][1] - _e1174[0][1]);
                                                                        let _e1341 = (_e1174[1][2] - _e1174[0][2]);
                                                                        let _e1342 = vec3<f32>(_e1339, _e1340, _e1341);
                                                                        let _e1343 = (_e1174[2][0] - _e1174[1][0]);
                                                                        let _e1344 = (_e1174[2][1] - _e1174[1][1]);
                                                                        let _e1345 = (_e1174[2][2] - _e1174[1][2]);
                                                                        let _e1346 = vec3<f32>(_e1343, _e1344, _e1345);
                                                                        let _e1347 = (_e1174[0][0] - _e1174[2][0]);
                                                                        let _e1348 = (_e1174[0][1] - _e1174[2][1]);
                                                                        let _e1349 = (_e1174[0][2] - _e1174[2][2]);
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
                                                                            phi_2723_ = _e1200;
                                                                            phi_2724_ = _e1197;
                                                                            phi_2725_ = _e1187;
                                                                            phi_2726_ = _e1184;
                                                                            phi_2727_ = _e1336;
                                                                            phi_2728_ = _e1350;
                                                                            phi_2729_ = _e1346;
                                                                            phi_2730_ = _e1342;
                                                                        } else {
                                                                            let _e1395 = (_e1376 == _e1393);
                                                                            let _e1400 = vec3(_e1395);
                                                                            phi_2723_ = select(_e1187, _e1213, _e1395);
                                                                            phi_2724_ = select(_e1184, _e1210, _e1395);
                                                                            phi_2725_ = select(_e1213, _e1200, _e1395);
                                                                            phi_2726_ = select(_e1210, _e1197, _e1395);
                                                                            phi_2727_ = select(_e1338, _e1337, _e1400);
                                                                            phi_2728_ = select(_e1346, _e1342, _e1400);
                                                                            phi_2729_ = select(_e1342, _e1350, _e1400);
                                                                            phi_2730_ = select(_e1350, _e1346, _e1400);
                                                                        }
                                                                        let _e1406 = phi_2723_;
                                                                        let _e1408 = phi_2724_;
                                                                        let _e1410 = phi_2725_;
                                                                        let _e1412 = phi_2726_;
                                                                        let _e1414 = phi_2727_;
                                                                        let _e1416 = phi_2728_;
                                                                        let _e1418 = phi_2729_;
                                                                        let _e1420 = phi_2730_;
                                                                        let _e1427 = ((_e1418.y * _e1416.z) - (_e1416.y * _e1418.z));
                                                                        let _e1432 = ((_e1418.z * _e1416.x) - (_e1416.z * _e1418.x));
                                                                        let _e1435 = ((_e1418.x * _e1416.y) - (_e1416.x * _e1418.y));
                                                                        if (_e1235 >= _e1239) {
                                                                            phi_2767_ = select(true, false, (_e1235 >= _e1243));
                                                                        } else {
                                                                            phi_2767_ = true;
                                                                        }
                                                                        let _e1440 = phi_2767_;
                                                                        if _e1440 {
                                                                            phi_2776_ = select(_e1338, _e1337, vec3((_e1239 >= _e1243)));
                                                                        } else {
                                                                            phi_2776_ = _e1336;
                                                                        }
                                                                        let _e1445 = phi_2776_;
                                                                        let _e1456 = (((_e1427 * (_e1445.x - _e337)) + (_e1432 * (_e1445.y - _e406))) + (_e1435 * (_e1445.z - _e474)));
                                                                        let _e1461 = (((_e1427 * _e377) + (_e1432 * _e445)) + (_e1435 * _e513));
                                                                        let _e1462 = (_e1408 - _e1412);
                                                                        let _e1463 = (_e1406 - _e1410);
                                                                        let _e1471 = (-(((_e1412 * _e1462) + (_e1410 * _e1463))) / ((_e1462 * _e1462) + (_e1463 * _e1463)));
                                                                        let _e1473 = select(1f, _e1471, (_e1471 < 1f));
                                                                        let _e1475 = select(0f, _e1473, (_e1473 > 0f));
                                                                        let _e1488 = ((_e1414.x + (_e1420.x * _e1475)) - _e337);
                                                                        let _e1489 = ((_e1414.y + (_e1420.y * _e1475)) - _e406);
                                                                        let _e1490 = ((_e1414.z + (_e1420.z * _e1475)) - _e474);
                                                                        let _e1491 = (_e1490 / _e513);
                                                                        let _e1503 = bitcast<f32>((bitcast<u32>(_e1488) & 2147483647u));
                                                                        let _e1506 = bitcast<f32>((bitcast<u32>(_e1489) & 2147483647u));
                                                                        let _e1508 = select(_e1506, _e1503, (_e1503 > _e1506));
                                                                        let _e1511 = bitcast<f32>((bitcast<u32>(_e1490) & 2147483647u));
                                                                        let _e1513 = select(_e1511, _e1508, (_e1508 > _e1511));
                                                                        let _e1519 = bitcast<f32>((bitcast<u32>(_e1427) & 2147483647u));
                                                                        let _e1522 = bitcast<f32>((bitcast<u32>(_e1432) & 2147483647u));
                                                                        let _e1524 = select(_e1522, _e1519, (_e1519 > _e1522));
                                                                        let _e1527 = bitcast<f32>((bitcast<u32>(_e1435) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1427 * _e1488) + (_e1432 * _e1489)) + (_e1435 * _e1490)) - _e1456)) & 2147483647u)) <= ((0.0000009536743f * select(_e1393, _e1513, (_e1513 > _e1393))) * select(_e1527, _e1524, (_e1524 > _e1527)))) {
                                                                            let _e1537 = bitcast<f32>((bitcast<u32>(_e1418.x) & 2147483647u));
                                                                            let _e1540 = bitcast<f32>((bitcast<u32>(_e1418.y) & 2147483647u));
                                                                            let _e1542 = select(_e1540, _e1537, (_e1537 > _e1540));
                                                                            let _e1545 = bitcast<f32>((bitcast<u32>(_e1418.z) & 2147483647u));
                                                                            let _e1551 = bitcast<f32>((bitcast<u32>(_e1416.x) & 2147483647u));
                                                                            let _e1554 = bitcast<f32>((bitcast<u32>(_e1416.y) & 2147483647u));
                                                                            let _e1556 = select(_e1554, _e1551, (_e1551 > _e1554));
                                                                            let _e1559 = bitcast<f32>((bitcast<u32>(_e1416.z) & 2147483647u));
                                                                            let _e1563 = (bitcast<f32>((bitcast<u32>(_e1461) & 2147483647u)) > ((0.0000038146973f * select(_e1545, _e1542, (_e1542 > _e1545))) * select(_e1559, _e1556, (_e1556 > _e1559))));
                                                                            if _e1563 {
                                                                                phi_2941_ = (_e1456 / _e1461);
                                                                            } else {
                                                                                phi_2941_ = f32();
                                                                            }
                                                                            let _e1566 = phi_2941_;
                                                                            phi_2943_ = _e1566;
                                                                            phi_2944_ = select(true, false, _e1563);
                                                                        } else {
                                                                            phi_2943_ = f32();
                                                                            phi_2944_ = true;
                                                                        }
                                                                        let _e1569 = phi_2943_;
                                                                        let _e1571 = phi_2944_;
                                                                        if _e1571 {
                                                                            let _e1579 = (((_e1427 * (_e1488 - (_e377 * _e1491))) + (_e1432 * (_e1489 - (_e445 * _e1491)))) / _e1461);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1579) & 2147483647u)) <= _e1393) {
                                                                                phi_2964_ = (_e1491 + _e1579);
                                                                            } else {
                                                                                phi_2964_ = _e1491;
                                                                            }
                                                                            let _e1586 = phi_2964_;
                                                                            phi_2965_ = _e1586;
                                                                        } else {
                                                                            phi_2965_ = _e1569;
                                                                        }
                                                                        let _e1588 = phi_2965_;
                                                                        let _e1590 = select(_e1326, _e1588, (_e1588 < _e1326));
                                                                        let _e1592 = select(_e1318, _e1590, (_e1590 > _e1318));
                                                                        if (_e1592 >= _e628) {
                                                                            let _e1594 = (_e1592 <= _e727);
                                                                            if _e1594 {
                                                                                let _e1595 = (1f / _e1245);
                                                                                phi_2988_ = type_24(_e1592, (_e1239 * _e1595), (_e1243 * _e1595), _e787);
                                                                            } else {
                                                                                phi_2988_ = type_24();
                                                                            }
                                                                            let _e1600 = phi_2988_;
                                                                            phi_2990_ = _e1600;
                                                                            phi_2991_ = select(true, false, _e1594);
                                                                        } else {
                                                                            phi_2990_ = type_24();
                                                                            phi_2991_ = true;
                                                                        }
                                                                        let _e1603 = phi_2990_;
                                                                        let _e1605 = phi_2991_;
                                                                        if _e1605 {
                                                                            phi_2995_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2995_ = _e1603;
                                                                        }
                                                                        let _e1607 = phi_2995_;
                                                                        phi_2996_ = _e1607;
                                                                    }
                                                                    let _e1609 = phi_2996_;
                                                                    phi_2997_ = _e1609;
                                                                    phi_2998_ = _e1335;
                                                                }
                                                                let _e1611 = phi_2997_;
                                                                let _e1613 = phi_2998_;
                                                                phi_3002_ = _e1611;
                                                                phi_3003_ = _e1613;
                                                            }
                                                            let _e1615 = phi_3002_;
                                                            let _e1617 = phi_3003_;
                                                            phi_3004_ = _e1615;
                                                            phi_3005_ = _e1270;
                                                            phi_3006_ = _e1617;
                                                        }
                                                        let _e1619 = phi_3004_;
                                                        let _e1621 = phi_3005_;
                                                        let _e1623 = phi_3006_;
                                                        phi_3007_ = _e1619;
                                                        phi_3008_ = _e1621;
                                                        phi_3009_ = _e1623;
                                                    }
                                                    let _e1625 = phi_3007_;
                                                    let _e1627 = phi_3008_;
                                                    let _e1629 = phi_3009_;
                                                    phi_3017_ = _e1625;
                                                    phi_3018_ = select(_e1629, true, _e1627);
                                                } else {
                                                    phi_3017_ = type_24();
                                                    phi_3018_ = true;
                                                }
                                                let _e1632 = phi_3017_;
                                                let _e1634 = phi_3018_;
                                                if _e1634 {
                                                    phi_3022_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_3022_ = _e1632;
                                                }
                                                let _e1636 = phi_3022_;
                                                if (_e1636.member_3 != 4294967295u) {
                                                    if (_e787 != 4294967295u) {
                                                        phi_3034_ = type_8(0u, 8u);
                                                        phi_3037_ = _e1636;
                                                        loop {
                                                            let _e1641 = phi_3034_;
                                                            let _e1643 = phi_3037_;
                                                            if (_e1641.member < _e1641.member_1) {
                                                                phi_3035_ = type_8((_e1641.member + 1u), _e1641.member_1);
                                                                phi_3060_ = type_8(1u, _e1641.member);
                                                            } else {
                                                                phi_3035_ = _e1641;
                                                                phi_3060_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1656 = phi_3035_;
                                                            let _e1658 = phi_3060_;
                                                            let _e1662 = (bitcast<i32>(_e1658.member) != 0i);
                                                            if _e1662 {
                                                                let _e1663 = (_e1658.member_1 < 8u);
                                                                if _e1663 {
                                                                } else {
                                                                    phi_4944_ = true;
                                                                    break;
                                                                }
                                                                let _e1668 = local_9[_e1658.member_1].member;
                                                                if (_e1643.member < _e1668) {
                                                                    phi_3093_ = true;
                                                                } else {
                                                                    let _e1670 = local_9[_e1658.member_1].member;
                                                                    if (_e1643.member == _e1670) {
                                                                        let _e1675 = local_9[_e1658.member_1].member_3;
                                                                        phi_3092_ = (_e1643.member_3 < _e1675);
                                                                    } else {
                                                                        phi_3092_ = false;
                                                                    }
                                                                    let _e1678 = phi_3092_;
                                                                    phi_3093_ = _e1678;
                                                                }
                                                                let _e1680 = phi_3093_;
                                                                if _e1680 {
                                                                    if _e1663 {
                                                                    } else {
                                                                        phi_4944_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1681 = local_9[_e1658.member_1];
                                                                    local_9[_e1658.member_1] = type_24(_e1643.member, _e1643.member_1, _e1643.member_2, _e1643.member_3);
                                                                    phi_3114_ = type_24(_e1681.member, _e1681.member_1, _e1681.member_2, _e1681.member_3);
                                                                } else {
                                                                    phi_3114_ = _e1643;
                                                                }
                                                                let _e1692 = phi_3114_;
                                                                phi_3038_ = _e1692;
                                                            } else {
                                                                phi_3038_ = type_24();
                                                            }
                                                            let _e1694 = phi_3038_;
                                                            continue;
                                                            continuing {
                                                                phi_3034_ = _e1656;
                                                                phi_3037_ = _e1694;
                                                                phi_4944_ = _e725;
                                                                break if !(_e1662);
                                                            }
                                                        }
                                                        let _e1697 = phi_4944_;
                                                        phi_5214_ = _e727;
                                                        phi_5151_ = _e1697;
                                                        if _e1697 {
                                                            break;
                                                        }
                                                        let _e1700 = local_9[7u].member_3;
                                                        if (_e1700 != 4294967295u) {
                                                            let _e1704 = local_9[7u].member;
                                                            phi_5305_ = _e1704;
                                                        } else {
                                                            phi_5305_ = _e727;
                                                        }
                                                        let _e1706 = phi_5305_;
                                                        phi_5304_ = _e1706;
                                                        phi_5154_ = _e1697;
                                                    } else {
                                                        phi_5304_ = _e727;
                                                        phi_5154_ = _e725;
                                                    }
                                                    let _e1708 = phi_5304_;
                                                    let _e1710 = phi_5154_;
                                                    phi_5303_ = _e1708;
                                                    phi_5153_ = _e1710;
                                                } else {
                                                    phi_5303_ = _e727;
                                                    phi_5153_ = _e725;
                                                }
                                                let _e1712 = phi_5303_;
                                                let _e1714 = phi_5153_;
                                                phi_5302_ = _e1712;
                                                phi_5152_ = _e1714;
                                            } else {
                                                phi_5302_ = _e727;
                                                phi_5152_ = _e725;
                                            }
                                            let _e1716 = phi_5302_;
                                            let _e1718 = phi_5152_;
                                            continue;
                                            continuing {
                                                phi_4973_ = _e1718;
                                                phi_4915_ = _e1716;
                                                phi_1360_ = _e742;
                                                phi_5214_ = _e1716;
                                                phi_5151_ = _e1718;
                                                break if !(_e748);
                                            }
                                        }
                                        let _e1721 = phi_5214_;
                                        let _e1723 = phi_5151_;
                                        phi_5307_ = _e1723;
                                        if _e1723 {
                                            break;
                                        }
                                        phi_5398_ = _e1723;
                                        phi_5213_ = _e1721;
                                    } else {
                                        phi_5398_ = _e669;
                                        phi_5213_ = _e671;
                                    }
                                    let _e1725 = phi_5398_;
                                    let _e1727 = phi_5213_;
                                    if _e717 {
                                        phi_4391_ = bool();
                                        phi_4392_ = u32();
                                        phi_4393_ = type_51();
                                    } else {
                                        if (_e713.member_1 >= _e102) {
                                            phi_3926_ = type_52(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e713.member_1 < _e102) {
                                            } else {
                                                phi_5307_ = true;
                                                break;
                                            }
                                            let _e1731 = ((1u + _e273) % 4u);
                                            if (_e1731 < 4u) {
                                            } else {
                                                phi_5307_ = true;
                                                break;
                                            }
                                            let _e1736 = global_3.member[_e713.member_1][_e1731];
                                            let _e1738 = (_e1736 >> bitcast<u32>(11u));
                                            let _e1740 = ((1u + _e272) % 4u);
                                            if (_e1740 < 4u) {
                                            } else {
                                                phi_5307_ = true;
                                                break;
                                            }
                                            let _e1745 = global_3.member[_e713.member_1][_e1740];
                                            let _e1747 = (_e1745 >> bitcast<u32>(11u));
                                            let _e1749 = ((1u + _e274) % 4u);
                                            if (_e1749 < 4u) {
                                            } else {
                                                phi_5307_ = true;
                                                break;
                                            }
                                            let _e1754 = global_3.member[_e713.member_1][_e1749];
                                            let _e1756 = (_e1754 >> bitcast<u32>(11u));
                                            let _e1779 = (bitcast<f32>((bitcast<u32>((_e713.member.member_1.x - _e713.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e1780 = (bitcast<f32>((bitcast<u32>((_e713.member.member_1.y - _e713.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e1781 = (bitcast<f32>((bitcast<u32>((_e713.member.member_1.z - _e713.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e1783 = select(_e153, _e1779, (_e1779 > _e153));
                                            let _e1785 = select(_e153, _e1780, (_e1780 > _e153));
                                            let _e1787 = select(_e153, _e1781, (_e1781 > _e153));
                                            let _e1818 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1736 & 1023u))) - 8388608f) * _e1783));
                                            let _e1823 = (bitcast<i32>((_e1736 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1826 = bitcast<f32>((_e1818 & bitcast<u32>(_e1823)));
                                            let _e1827 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1745 & 1023u))) - 8388608f) * _e1785));
                                            let _e1832 = (bitcast<i32>((_e1745 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1835 = bitcast<f32>((_e1827 & bitcast<u32>(_e1832)));
                                            let _e1836 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1754 & 1023u))) - 8388608f) * _e1787));
                                            let _e1841 = (bitcast<i32>((_e1754 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1844 = bitcast<f32>((_e1836 & bitcast<u32>(_e1841)));
                                            let _e1848 = bitcast<f32>((_e1818 & bitcast<u32>(~(_e1823))));
                                            let _e1852 = bitcast<f32>((_e1827 & bitcast<u32>(~(_e1832))));
                                            let _e1856 = bitcast<f32>((_e1836 & bitcast<u32>(~(_e1841))));
                                            let _e1857 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1738 & 1023u))) - 8388608f) * _e1783));
                                            let _e1862 = (bitcast<i32>((_e1738 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1865 = bitcast<f32>((_e1857 & bitcast<u32>(_e1862)));
                                            let _e1866 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1747 & 1023u))) - 8388608f) * _e1785));
                                            let _e1871 = (bitcast<i32>((_e1747 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1874 = bitcast<f32>((_e1866 & bitcast<u32>(_e1871)));
                                            let _e1875 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1756 & 1023u))) - 8388608f) * _e1787));
                                            let _e1880 = (bitcast<i32>((_e1756 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1883 = bitcast<f32>((_e1875 & bitcast<u32>(_e1880)));
                                            let _e1887 = bitcast<f32>((_e1857 & bitcast<u32>(~(_e1862))));
                                            let _e1891 = bitcast<f32>((_e1866 & bitcast<u32>(~(_e1871))));
                                            let _e1895 = bitcast<f32>((_e1875 & bitcast<u32>(~(_e1880))));
                                            let _e1896 = (_e713.member.member.x + _e1826);
                                            let _e1897 = (_e713.member.member.y + _e1835);
                                            let _e1898 = (_e713.member.member.z + _e1844);
                                            let _e1901 = (_e713.member.member_1.x - _e1865);
                                            let _e1902 = (_e713.member.member_1.y - _e1874);
                                            let _e1903 = (_e713.member.member_1.z - _e1883);
                                            let _e1922 = (_e1901 - _e1896);
                                            let _e1923 = (_e1902 - _e1897);
                                            let _e1924 = (_e1903 - _e1898);
                                            let _e1926 = select(_e1923, _e1922, (_e1922 > _e1923));
                                            let _e1928 = select(_e1924, _e1926, (_e1926 > _e1924));
                                            if (_e1928 < (1024f * _e153)) {
                                                phi_3627_ = 0u;
                                            } else {
                                                phi_3627_ = select(2u, 1u, (_e1928 < (2097152f * _e153)));
                                            }
                                            let _e1935 = phi_3627_;
                                            switch bitcast<i32>(_e1935) {
                                                case 0: {
                                                    phi_3633_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3633_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3633_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3633_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e1938 = phi_3633_;
                                            let _e1944 = global_3.member[_e713.member_1][0u];
                                            let _e1948 = global_3.member[_e713.member_1][1u];
                                            let _e1952 = global_3.member[_e713.member_1][2u];
                                            let _e1956 = global_3.member[_e713.member_1][3u];
                                            let _e1968 = (((_e1948 >> bitcast<u32>(22i)) | ((_e1952 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1956 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1969 = (_e1944 & 268435455u);
                                            let _e1970 = (_e1968 & 268435455u);
                                            let _e1973 = ((_e1944 >> bitcast<u32>(28u)) & 7u);
                                            let _e1981 = ((_e1944 >> bitcast<u32>(31i)) | (((_e1968 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1982 = (_e1973 != 0u);
                                            if (_e1973 == 0u) {
                                                phi_3888_ = _e1969;
                                            } else {
                                                if (_e1973 == 7u) {
                                                    phi_3887_ = 2147483648u;
                                                } else {
                                                    phi_3887_ = ((2147483648u | (_e1973 << bitcast<u32>(28u))) | (_e1970 & 268435455u));
                                                }
                                                let _e1991 = phi_3887_;
                                                phi_3888_ = _e1991;
                                            }
                                            let _e1993 = phi_3888_;
                                            if _e1982 {
                                                let _e1994 = (_e1973 != 7u);
                                                if _e1994 {
                                                    phi_3898_ = (_e1970 + (_e1973 * ((3u * _e1938) + 1u)));
                                                } else {
                                                    phi_3898_ = u32();
                                                }
                                                let _e1998 = phi_3898_;
                                                phi_3900_ = _e1998;
                                                phi_3901_ = select(true, false, _e1994);
                                            } else {
                                                phi_3900_ = u32();
                                                phi_3901_ = true;
                                            }
                                            let _e2001 = phi_3900_;
                                            let _e2003 = phi_3901_;
                                            if (_e1981 == 0u) {
                                                phi_3922_ = (_e1969 + select(0u, 1u, !(_e1982)));
                                            } else {
                                                if (_e1981 == 7u) {
                                                    phi_3921_ = 2147483648u;
                                                } else {
                                                    phi_3921_ = ((2147483648u | (_e1981 << bitcast<u32>(28u))) | (select(_e2001, _e1970, _e2003) & 268435455u));
                                                }
                                                let _e2016 = phi_3921_;
                                                phi_3922_ = _e2016;
                                            }
                                            let _e2018 = phi_3922_;
                                            phi_3926_ = type_52(array<vec4<f32>, 3>(vec4<f32>(_e1896, (_e713.member.member.x + _e1848), _e1901, (_e713.member.member_1.x - _e1887)), vec4<f32>(_e1897, (_e713.member.member.y + _e1852), _e1902, (_e713.member.member_1.y - _e1891)), vec4<f32>(_e1898, (_e713.member.member.z + _e1856), _e1903, (_e713.member.member_1.z - _e1895))), type_51(type_28((_e713.member.member + vec4<f32>(_e1826, _e1835, _e1844, 0f)), (_e713.member.member_1 - vec4<f32>(_e1865, _e1874, _e1883, 0f))), _e1993), type_51(type_28((_e713.member.member + vec4<f32>(_e1848, _e1852, _e1856, 0f)), (_e713.member.member_1 - vec4<f32>(_e1887, _e1891, _e1895, 0f))), _e2018));
                                        }
                                        let _e2023 = phi_3926_;
                                        let _e2034 = ((_e2023.member[0].x - _e375) * _e380);
                                        let _e2035 = ((_e2023.member[0].y - _e375) * _e380);
                                        let _e2036 = ((_e2023.member[0].z - _e376) * _e380);
                                        let _e2037 = ((_e2023.member[0].w - _e376) * _e380);
                                        let _e2047 = ((_e2023.member[1].x - _e443) * _e448);
                                        let _e2048 = ((_e2023.member[1].y - _e443) * _e448);
                                        let _e2049 = ((_e2023.member[1].z - _e444) * _e448);
                                        let _e2050 = ((_e2023.member[1].w - _e444) * _e448);
                                        let _e2060 = ((_e2023.member[2].x - _e511) * _e516);
                                        let _e2061 = ((_e2023.member[2].y - _e511) * _e516);
                                        let _e2062 = ((_e2023.member[2].z - _e512) * _e516);
                                        let _e2063 = ((_e2023.member[2].w - _e512) * _e516);
                                        let _e2065 = select(_e2062, _e2060, (_e2060 < _e2062));
                                        let _e2067 = select(_e2063, _e2061, (_e2061 < _e2063));
                                        let _e2069 = select(_e2062, _e2060, (_e2060 > _e2062));
                                        let _e2071 = select(_e2063, _e2061, (_e2061 > _e2063));
                                        let _e2073 = select(_e2036, _e2034, (_e2034 < _e2036));
                                        let _e2075 = select(_e2037, _e2035, (_e2035 < _e2037));
                                        let _e2077 = select(_e2049, _e2047, (_e2047 < _e2049));
                                        let _e2079 = select(_e2050, _e2048, (_e2048 < _e2050));
                                        let _e2081 = select(_e2077, _e2073, (_e2073 > _e2077));
                                        let _e2083 = select(_e2079, _e2075, (_e2075 > _e2079));
                                        let _e2085 = select(_e2065, _e2081, (_e2081 > _e2065));
                                        let _e2087 = select(_e2067, _e2083, (_e2083 > _e2067));
                                        let _e2089 = select(_e2036, _e2034, (_e2034 > _e2036));
                                        let _e2091 = select(_e2037, _e2035, (_e2035 > _e2037));
                                        let _e2093 = select(_e2049, _e2047, (_e2047 > _e2049));
                                        let _e2095 = select(_e2050, _e2048, (_e2048 > _e2050));
                                        let _e2097 = select(_e2093, _e2089, (_e2089 < _e2093));
                                        let _e2099 = select(_e2095, _e2091, (_e2091 < _e2095));
                                        let _e2104 = -(_e2065);
                                        let _e2105 = -(_e2067);
                                        let _e2112 = (select(_e2069, _e2097, (_e2097 < _e2069)) + (select(_e2104, _e2069, (_e2069 > _e2104)) * 0.0000019073523f));
                                        let _e2113 = (select(_e2071, _e2099, (_e2099 < _e2071)) + (select(_e2105, _e2071, (_e2071 > _e2105)) * 0.0000019073523f));
                                        let _e2115 = select(_e628, _e2085, (_e2085 > _e628));
                                        let _e2117 = select(_e628, _e2087, (_e2087 > _e628));
                                        let _e2122 = (_e2115 <= select(_e1727, _e2112, (_e2112 < _e1727)));
                                        let _e2123 = (_e2117 <= select(_e1727, _e2113, (_e2113 < _e1727)));
                                        let _e2124 = (_e2115 <= _e2117);
                                        if _e2122 {
                                            if _e2123 {
                                                if _e2124 {
                                                    phi_4289_ = _e2023.member_2;
                                                } else {
                                                    phi_4289_ = _e2023.member_1;
                                                }
                                                let _e2128 = phi_4289_;
                                                let _e2149 = (_e711 % 128u);
                                                let _e2150 = (_e2149 < 128u);
                                                if _e2150 {
                                                } else {
                                                    phi_5307_ = true;
                                                    break;
                                                }
                                                local_8[_e2149] = _e2128.member_1;
                                                if _e2150 {
                                                } else {
                                                    phi_5307_ = true;
                                                    break;
                                                }
                                                local_7[_e2149] = _e2128.member.member.x;
                                                if _e2150 {
                                                } else {
                                                    phi_5307_ = true;
                                                    break;
                                                }
                                                local_6[_e2149] = _e2128.member.member.y;
                                                if _e2150 {
                                                } else {
                                                    phi_5307_ = true;
                                                    break;
                                                }
                                                local_5[_e2149] = _e2128.member.member.z;
                                                if _e2150 {
                                                } else {
                                                    phi_5307_ = true;
                                                    break;
                                                }
                                                local_4[_e2149] = _e2128.member.member_1.x;
                                                if _e2150 {
                                                } else {
                                                    phi_5307_ = true;
                                                    break;
                                                }
                                                local_3[_e2149] = _e2128.member.member_1.y;
                                                if _e2150 {
                                                } else {
                                                    phi_5307_ = true;
                                                    break;
                                                }
                                                local_2[_e2149] = _e2128.member.member_1.z;
                                                if _e2150 {
                                                } else {
                                                    phi_5307_ = true;
                                                    break;
                                                }
                                                local_10[_e2149] = select(_e2115, _e2117, _e2124);
                                                if _e2124 {
                                                    phi_4365_ = _e2023.member_1;
                                                } else {
                                                    phi_4365_ = _e2023.member_2;
                                                }
                                                let _e2163 = phi_4365_;
                                                phi_4366_ = (_e711 + 1u);
                                                phi_4367_ = _e2163;
                                            } else {
                                                phi_4366_ = u32();
                                                phi_4367_ = type_51();
                                            }
                                            let _e2165 = phi_4366_;
                                            let _e2167 = phi_4367_;
                                            phi_4369_ = _e2165;
                                            phi_4370_ = _e2167;
                                            phi_4371_ = select(true, false, _e2123);
                                        } else {
                                            phi_4369_ = u32();
                                            phi_4370_ = type_51();
                                            phi_4371_ = true;
                                        }
                                        let _e2170 = phi_4369_;
                                        let _e2172 = phi_4370_;
                                        let _e2174 = phi_4371_;
                                        if _e2174 {
                                            if _e2122 {
                                                phi_4380_ = _e2023.member_1;
                                            } else {
                                                phi_4380_ = _e2023.member_2;
                                            }
                                            let _e2178 = phi_4380_;
                                            phi_4385_ = select(_e2123, true, _e2122);
                                            phi_4387_ = _e2178;
                                        } else {
                                            phi_4385_ = _e709;
                                            phi_4387_ = _e2172;
                                        }
                                        let _e2181 = phi_4385_;
                                        let _e2183 = phi_4387_;
                                        phi_4391_ = _e2181;
                                        phi_4392_ = select(_e2170, _e711, _e2174);
                                        phi_4393_ = _e2183;
                                    }
                                    let _e2186 = phi_4391_;
                                    let _e2188 = phi_4392_;
                                    let _e2190 = phi_4393_;
                                    if _e717 {
                                        phi_4403_ = _e713;
                                    } else {
                                        phi_4403_ = _e2190;
                                    }
                                    let _e2192 = phi_4403_;
                                    phi_5426_ = _e1727;
                                    phi_5310_ = _e1725;
                                    phi_4404_ = (_e673 - 1u);
                                    phi_4405_ = select(_e2186, false, _e717);
                                    phi_4406_ = select(_e2188, _e711, _e717);
                                    phi_4407_ = _e2192;
                                } else {
                                    phi_5426_ = _e671;
                                    phi_5310_ = _e669;
                                    phi_4404_ = _e673;
                                    phi_4405_ = _e709;
                                    phi_4406_ = _e711;
                                    phi_4407_ = _e713;
                                }
                                let _e2196 = phi_5426_;
                                let _e2198 = phi_5310_;
                                let _e2200 = phi_4404_;
                                let _e2202 = phi_4405_;
                                let _e2204 = phi_4406_;
                                let _e2206 = phi_4407_;
                                phi_5425_ = _e2196;
                                phi_5309_ = _e2198;
                                phi_4408_ = _e2200;
                                phi_4409_ = _e2202;
                                phi_4410_ = _e2204;
                                phi_4411_ = _e2206;
                            } else {
                                phi_5425_ = _e671;
                                phi_5309_ = _e669;
                                phi_4408_ = u32();
                                phi_4409_ = bool();
                                phi_4410_ = u32();
                                phi_4411_ = type_51();
                            }
                            let _e2208 = phi_5425_;
                            let _e2210 = phi_5309_;
                            let _e2212 = phi_4408_;
                            let _e2214 = phi_4409_;
                            let _e2216 = phi_4410_;
                            let _e2218 = phi_4411_;
                            phi_5424_ = _e2208;
                            phi_5308_ = _e2210;
                            phi_1235_ = _e2212;
                            phi_1238_ = _e2214;
                            phi_1240_ = _e2216;
                            phi_1242_ = _e2218;
                            phi_4412_ = _e683;
                        } else {
                            phi_5424_ = _e671;
                            phi_5308_ = _e669;
                            phi_1235_ = u32();
                            phi_1238_ = bool();
                            phi_1240_ = u32();
                            phi_1242_ = type_51();
                            phi_4412_ = false;
                        }
                        let _e2220 = phi_5424_;
                        let _e2222 = phi_5308_;
                        let _e2224 = phi_1235_;
                        let _e2226 = phi_1238_;
                        let _e2228 = phi_1240_;
                        let _e2230 = phi_1242_;
                        let _e2232 = phi_4412_;
                        continue;
                        continuing {
                            phi_4976_ = _e2222;
                            phi_4890_ = _e2220;
                            phi_1234_ = _e2224;
                            phi_1237_ = _e2226;
                            phi_1239_ = _e2228;
                            phi_1241_ = _e2230;
                            phi_5307_ = _e2222;
                            break if !(_e2232);
                        }
                    }
                    let _e2235 = phi_5307_;
                    if _e2235 {
                        break;
                    }
                    phi_4419_ = type_8(0u, 8u);
                    loop {
                        let _e2237 = phi_4419_;
                        if (_e2237.member < _e2237.member_1) {
                            phi_4420_ = type_8((_e2237.member + 1u), _e2237.member_1);
                            phi_4443_ = type_8(1u, _e2237.member);
                        } else {
                            phi_4420_ = _e2237;
                            phi_4443_ = type_8(0u, type_8().member_1);
                        }
                        let _e2250 = phi_4420_;
                        let _e2252 = phi_4443_;
                        let _e2256 = (bitcast<i32>(_e2252.member) != 0i);
                        if _e2256 {
                            let _e2257 = (_e2252.member_1 < 8u);
                            if _e2257 {
                            } else {
                                phi_5406_ = true;
                                break;
                            }
                            let _e2259 = local_9[_e2252.member_1];
                            if (_e2259.member_3 != 4294967295u) {
                                let _e2265 = -(_e530);
                                let _e2266 = bitcast<u32>(_e2259.member);
                                let _e2270 = (bitcast<i32>((_e2266 >> bitcast<u32>(23i))) & 255i);
                                let _e2271 = (_e2270 + _e2265);
                                if (_e2270 == 255i) {
                                    phi_4516_ = _e2259.member;
                                } else {
                                    if (_e2270 > 0i) {
                                        if (_e2271 > 0i) {
                                            let _e2275 = (_e2271 < 255i);
                                            if _e2275 {
                                                phi_4495_ = bitcast<f32>((_e2266 + bitcast<u32>((_e2265 << bitcast<u32>(23i)))));
                                            } else {
                                                phi_4495_ = f32();
                                            }
                                            let _e2282 = phi_4495_;
                                            phi_4497_ = _e2282;
                                            phi_4498_ = select(true, false, _e2275);
                                        } else {
                                            phi_4497_ = f32();
                                            phi_4498_ = true;
                                        }
                                        let _e2285 = phi_4497_;
                                        let _e2287 = phi_4498_;
                                        phi_4499_ = _e2285;
                                        phi_4500_ = _e2287;
                                    } else {
                                        phi_4499_ = f32();
                                        phi_4500_ = true;
                                    }
                                    let _e2289 = phi_4499_;
                                    let _e2291 = phi_4500_;
                                    if _e2291 {
                                        let _e2292 = (_e2266 & 2147483648u);
                                        let _e2299 = ((_e2266 & 8388607u) | (select(0u, 1u, ((_e2266 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                        let _e2303 = (_e2299 == 0u);
                                        if _e2303 {
                                            phi_4837_ = bitcast<f32>(_e2292);
                                        } else {
                                            let _e2308 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2299)), 32u, _e2303) - 8u);
                                            let _e2311 = (_e2299 << bitcast<u32>((_e2308 & 31u)));
                                            let _e2313 = ((_e2271 + select(0i, 1i, (_e2270 == 0i))) - bitcast<i32>(_e2308));
                                            if (_e2313 >= 255i) {
                                                phi_4827_ = bitcast<f32>((_e2292 | 2139095040u));
                                                phi_4828_ = f32();
                                                phi_4829_ = true;
                                            } else {
                                                let _e2315 = (_e2313 > 0i);
                                                if _e2315 {
                                                    phi_4821_ = bitcast<f32>(((_e2292 | (bitcast<u32>(_e2313) << bitcast<u32>(23i))) | (_e2311 & 8388607u)));
                                                    phi_4822_ = f32();
                                                } else {
                                                    if (_e2313 < -24i) {
                                                        phi_4787_ = 26u;
                                                    } else {
                                                        phi_4787_ = bitcast<u32>((1i - _e2313));
                                                    }
                                                    let _e2320 = phi_4787_;
                                                    let _e2321 = (_e2320 & 31u);
                                                    let _e2323 = (_e2311 >> bitcast<u32>(_e2321));
                                                    let _e2327 = (_e2311 & ((1u << bitcast<u32>(_e2321)) - 1u));
                                                    let _e2331 = (1u << bitcast<u32>(((_e2320 - 1u) & 31u)));
                                                    if (_e2327 > _e2331) {
                                                        phi_4808_ = true;
                                                    } else {
                                                        if (_e2327 == _e2331) {
                                                            phi_4805_ = ((_e2323 & 1u) == 1u);
                                                        } else {
                                                            phi_4805_ = false;
                                                        }
                                                        let _e2337 = phi_4805_;
                                                        phi_4808_ = _e2337;
                                                    }
                                                    let _e2339 = phi_4808_;
                                                    phi_4821_ = f32();
                                                    phi_4822_ = bitcast<f32>((_e2292 | (_e2323 + select(0u, 1u, _e2339))));
                                                }
                                                let _e2352 = phi_4821_;
                                                let _e2354 = phi_4822_;
                                                phi_4827_ = _e2352;
                                                phi_4828_ = _e2354;
                                                phi_4829_ = _e2315;
                                            }
                                            let _e2358 = phi_4827_;
                                            let _e2360 = phi_4828_;
                                            let _e2362 = phi_4829_;
                                            phi_4837_ = select(_e2360, _e2358, _e2362);
                                        }
                                        let _e2366 = phi_4837_;
                                        phi_4515_ = _e2366;
                                    } else {
                                        phi_4515_ = _e2289;
                                    }
                                    let _e2368 = phi_4515_;
                                    phi_4516_ = _e2368;
                                }
                                let _e2370 = phi_4516_;
                                let _e2371 = bitcast<u32>(_e2370);
                                if ((_e2371 & 2147483647u) >= 2139095040u) {
                                    phi_4528_ = bitcast<f32>(((_e2371 & 2147483648u) | 2139095039u));
                                } else {
                                    phi_4528_ = _e2370;
                                }
                                let _e2378 = phi_4528_;
                                phi_4533_ = type_24(_e2378, _e2259.member_1, _e2259.member_2, _e2259.member_3);
                            } else {
                                phi_4533_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e2381 = phi_4533_;
                            if _e2257 {
                            } else {
                                phi_5406_ = true;
                                break;
                            }
                            local_9[_e2252.member_1] = type_24(_e2381.member, _e2381.member_1, _e2381.member_2, _e2381.member_3);
                        }
                        continue;
                        continuing {
                            phi_4419_ = _e2250;
                            phi_5406_ = _e2235;
                            break if !(_e2256);
                        }
                    }
                    let _e2389 = phi_5406_;
                    if _e2389 {
                        break;
                    }
                    let _e2390 = local_9;
                    if _e161 {
                    } else {
                        break;
                    }
                    global_6.member[_e159] = array<type_24, 8>(type_24(_e2390[0].member, _e2390[0].member_1, _e2390[0].member_2, _e2390[0].member_3), type_24(_e2390[1].member, _e2390[1].member_1, _e2390[1].member_2, _e2390[1].member_3), type_24(_e2390[2].member, _e2390[2].member_1, _e2390[2].member_2, _e2390[2].member_3), type_24(_e2390[3].member, _e2390[3].member_1, _e2390[3].member_2, _e2390[3].member_3), type_24(_e2390[4].member, _e2390[4].member_1, _e2390[4].member_2, _e2390[4].member_3), type_24(_e2390[5].member, _e2390[5].member_1, _e2390[5].member_2, _e2390[5].member_3), type_24(_e2390[6].member, _e2390[6].member_1, _e2390[6].member_2, _e2390[6].member_3), type_24(_e2390[7].member, _e2390[7].member_1, _e2390[7].member_2, _e2390[7].member_3));
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
