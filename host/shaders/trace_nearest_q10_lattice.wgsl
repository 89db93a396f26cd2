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
    var phi_5032_: bool;
    var phi_4889_: f32;
    var phi_1236_: bool;
    var phi_1239_: u32;
    var phi_1241_: u32;
    var phi_1243_: type_51;
    var phi_1254_: bool;
    var phi_1341_: bool;
    var phi_1342_: u32;
    var phi_1343_: type_51;
    var phi_3634_: u32;
    var phi_3640_: u32;
    var phi_3894_: u32;
    var phi_3895_: u32;
    var phi_3905_: u32;
    var phi_3907_: u32;
    var phi_3908_: bool;
    var phi_3928_: u32;
    var phi_3929_: u32;
    var phi_3933_: type_52;
    var phi_4296_: type_51;
    var phi_4373_: type_51;
    var phi_4374_: u32;
    var phi_4375_: type_51;
    var phi_4377_: u32;
    var phi_4378_: type_51;
    var phi_4379_: bool;
    var phi_4388_: type_51;
    var phi_4393_: bool;
    var phi_4395_: type_51;
    var phi_5029_: bool;
    var phi_4972_: f32;
    var phi_1362_: type_8;
    var phi_1363_: type_8;
    var phi_1386_: type_8;
    var phi_1427_: u32;
    var phi_1433_: u32;
    var phi_1443_: u32;
    var phi_1459_: u32;
    var phi_1492_: u32;
    var phi_1498_: u32;
    var phi_1964_: u32;
    var phi_1982_: u32;
    var phi_2000_: u32;
    var phi_2023_: u32;
    var phi_2041_: u32;
    var phi_2059_: u32;
    var phi_2082_: u32;
    var phi_2100_: u32;
    var phi_2118_: u32;
    var phi_1672_: u32;
    var phi_1687_: u32;
    var phi_1697_: u32;
    var phi_1718_: u32;
    var phi_1739_: u32;
    var phi_1769_: u32;
    var phi_1784_: u32;
    var phi_1794_: u32;
    var phi_1815_: u32;
    var phi_1836_: u32;
    var phi_1866_: u32;
    var phi_1881_: u32;
    var phi_1891_: u32;
    var phi_1912_: u32;
    var phi_1933_: u32;
    var phi_1525_: u32;
    var phi_1574_: u32;
    var phi_1623_: u32;
    var phi_2124_: array<array<f32, 3>, 3>;
    var phi_2277_: bool;
    var phi_2306_: bool;
    var phi_2725_: f32;
    var phi_2726_: f32;
    var phi_2727_: f32;
    var phi_2728_: f32;
    var phi_2729_: vec3<f32>;
    var phi_2730_: vec3<f32>;
    var phi_2731_: vec3<f32>;
    var phi_2732_: vec3<f32>;
    var phi_2769_: bool;
    var phi_2778_: vec3<f32>;
    var phi_2943_: f32;
    var phi_2945_: f32;
    var phi_2946_: bool;
    var phi_2966_: f32;
    var phi_2967_: f32;
    var phi_2990_: type_24;
    var phi_2992_: type_24;
    var phi_2993_: bool;
    var phi_2997_: type_24;
    var phi_2998_: type_24;
    var phi_2999_: type_24;
    var phi_3000_: bool;
    var phi_3004_: type_24;
    var phi_3005_: bool;
    var phi_3006_: type_24;
    var phi_3007_: bool;
    var phi_3008_: bool;
    var phi_3009_: type_24;
    var phi_3010_: bool;
    var phi_3011_: bool;
    var phi_3019_: type_24;
    var phi_3020_: bool;
    var phi_3024_: type_24;
    var phi_3036_: type_8;
    var phi_3039_: type_24;
    var phi_3037_: type_8;
    var phi_3062_: type_8;
    var phi_3094_: bool;
    var phi_3095_: bool;
    var phi_3116_: type_24;
    var phi_3040_: type_24;
    var phi_5000_: bool;
    var phi_5456_: f32;
    var phi_5455_: f32;
    var phi_5210_: bool;
    var phi_5454_: f32;
    var phi_5209_: bool;
    var phi_5453_: f32;
    var phi_5208_: bool;
    var phi_5365_: f32;
    var phi_5207_: bool;
    var phi_5330_: f32;
    var phi_5216_: bool;
    var phi_4399_: bool;
    var phi_4400_: u32;
    var phi_4401_: type_51;
    var phi_5329_: f32;
    var phi_5215_: bool;
    var phi_4402_: bool;
    var phi_4403_: u32;
    var phi_4404_: u32;
    var phi_4405_: type_51;
    var phi_5328_: f32;
    var phi_5214_: bool;
    var phi_4406_: bool;
    var phi_4407_: u32;
    var phi_4408_: u32;
    var phi_4409_: type_51;
    var phi_5327_: f32;
    var phi_5213_: bool;
    var phi_1237_: bool;
    var phi_1240_: u32;
    var phi_1242_: u32;
    var phi_1244_: type_51;
    var phi_4410_: bool;
    var phi_5212_: bool;
    var phi_4417_: type_8;
    var phi_4418_: type_8;
    var phi_4441_: type_8;
    var phi_4493_: f32;
    var phi_4495_: f32;
    var phi_4496_: bool;
    var phi_4497_: f32;
    var phi_4498_: bool;
    var phi_4785_: u32;
    var phi_4803_: bool;
    var phi_4806_: bool;
    var phi_4819_: f32;
    var phi_4820_: f32;
    var phi_4825_: f32;
    var phi_4826_: f32;
    var phi_4827_: bool;
    var phi_4835_: f32;
    var phi_4513_: f32;
    var phi_4514_: f32;
    var phi_4526_: f32;
    var phi_4531_: type_24;
    var phi_5309_: bool;

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
                    phi_5032_ = false;
                    phi_4889_ = _e626;
                    phi_1236_ = (_e628 <= _e626);
                    phi_1239_ = ((3u * _e102) + 1u);
                    phi_1241_ = 0u;
                    phi_1243_ = type_51(type_28(vec4<f32>((f32(_e634) * _e153), (f32(_e640) * _e153), (f32(_e646) * _e153), 0f), vec4<f32>((f32(_e651) * _e153), (f32(_e655) * _e153), (f32(_e659) * _e153), 0f)), select(0u, 2147483648u, (_e102 == 0u)));
                    loop {
                        let _e669 = phi_5032_;
                        let _e671 = phi_4889_;
                        let _e673 = phi_1236_;
                        let _e675 = phi_1239_;
                        let _e677 = phi_1241_;
                        let _e679 = phi_1243_;
                        if _e673 {
                            phi_1254_ = true;
                        } else {
                            phi_1254_ = (_e677 > 0u);
                        }
                        let _e682 = phi_1254_;
                        if _e682 {
                            let _e683 = (_e675 > 0u);
                            if _e683 {
                                if _e673 {
                                    phi_1341_ = _e673;
                                    phi_1342_ = _e677;
                                    phi_1343_ = _e679;
                                } else {
                                    let _e684 = (_e677 - 1u);
                                    let _e685 = (_e684 % 128u);
                                    let _e686 = (_e685 < 128u);
                                    if _e686 {
                                    } else {
                                        phi_5212_ = true;
                                        break;
                                    }
                                    let _e688 = local_7[_e685];
                                    if _e686 {
                                    } else {
                                        phi_5212_ = true;
                                        break;
                                    }
                                    let _e690 = local_6[_e685];
                                    if _e686 {
                                    } else {
                                        phi_5212_ = true;
                                        break;
                                    }
                                    let _e692 = local_5[_e685];
                                    if _e686 {
                                    } else {
                                        phi_5212_ = true;
                                        break;
                                    }
                                    let _e694 = local_4[_e685];
                                    if _e686 {
                                    } else {
                                        phi_5212_ = true;
                                        break;
                                    }
                                    let _e696 = local_3[_e685];
                                    if _e686 {
                                    } else {
                                        phi_5212_ = true;
                                        break;
                                    }
                                    let _e698 = local_2[_e685];
                                    if _e686 {
                                    } else {
                                        phi_5212_ = true;
                                        break;
                                    }
                                    let _e703 = local_8[_e685];
                                    if _e686 {
                                    } else {
                                        phi_5212_ = true;
                                        break;
                                    }
                                    let _e706 = local_10[_e685];
                                    phi_1341_ = (_e706 <= _e671);
                                    phi_1342_ = _e684;
                                    phi_1343_ = type_51(type_28(vec4<f32>(_e688, _e690, _e692, 0f), vec4<f32>(_e694, _e696, _e698, 0f)), _e703);
                                }
                                let _e709 = phi_1341_;
                                let _e711 = phi_1342_;
                                let _e713 = phi_1343_;
                                if _e709 {
                                    let _e718 = (_e713.member_1 & 268435455u);
                                    if ((_e713.member_1 & 2147483648u) != 0u) {
                                        phi_5029_ = _e669;
                                        phi_4972_ = _e671;
                                        phi_1362_ = type_8(0u, ((_e713.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1183 = phi_5029_;
                                            let _e1185 = phi_4972_;
                                            let _e1187 = phi_1362_;
                                            if (_e1187.member < _e1187.member_1) {
                                                phi_1363_ = type_8((_e1187.member + 1u), _e1187.member_1);
                                                phi_1386_ = type_8(1u, _e1187.member);
                                            } else {
                                                phi_1363_ = _e1187;
                                                phi_1386_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1200 = phi_1363_;
                                            let _e1202 = phi_1386_;
                                            let _e1206 = (bitcast<i32>(_e1202.member) != 0i);
                                            if _e1206 {
                                                let _e1211 = (_e713.member.member_1.x - _e713.member.member.x);
                                                let _e1214 = (_e713.member.member_1.y - _e713.member.member.y);
                                                let _e1217 = (_e713.member.member_1.z - _e713.member.member.z);
                                                let _e1219 = select(_e1214, _e1211, (_e1211 > _e1214));
                                                let _e1221 = select(_e1217, _e1219, (_e1219 > _e1217));
                                                let _e1223 = (_e1221 < (1024f * _e153));
                                                if _e1223 {
                                                    phi_1427_ = 0u;
                                                } else {
                                                    phi_1427_ = select(2u, 1u, (_e1221 < (2097152f * _e153)));
                                                }
                                                let _e1228 = phi_1427_;
                                                switch bitcast<i32>(_e1228) {
                                                    case 0: {
                                                        phi_1433_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1433_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1433_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1433_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1231 = phi_1433_;
                                                switch bitcast<i32>(_e1228) {
                                                    case 0: {
                                                        phi_1443_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1443_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1443_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1443_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1238 = phi_1443_;
                                                let _e1240 = ((_e718 + (_e1202.member_1 * ((3u * _e1231) + 1u))) + (3u * _e1238));
                                                let _e1241 = (_e1240 < _e105);
                                                if _e1241 {
                                                    if _e1241 {
                                                    } else {
                                                        phi_5365_ = _e1185;
                                                        phi_5207_ = true;
                                                        break;
                                                    }
                                                    let _e1243 = global_5.member[_e1240];
                                                    phi_1459_ = _e1243;
                                                } else {
                                                    phi_1459_ = 4294967295u;
                                                }
                                                let _e1245 = phi_1459_;
                                                if _e1223 {
                                                    phi_1492_ = 0u;
                                                } else {
                                                    phi_1492_ = select(2u, 1u, (_e1221 < (2097152f * _e153)));
                                                }
                                                let _e1250 = phi_1492_;
                                                switch bitcast<i32>(_e1250) {
                                                    case 0: {
                                                        phi_1498_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1498_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1498_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1498_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1253 = phi_1498_;
                                                let _e1257 = (_e718 + (_e1202.member_1 * ((3u * _e1253) + 1u)));
                                                switch bitcast<i32>(_e1250) {
                                                    case 0: {
                                                        let _e1532 = (_e1257 < _e105);
                                                        if _e1532 {
                                                            if _e1532 {
                                                            } else {
                                                                phi_5365_ = _e1185;
                                                                phi_5207_ = true;
                                                                break;
                                                            }
                                                            let _e1534 = global_5.member[_e1257];
                                                            phi_1525_ = _e1534;
                                                        } else {
                                                            phi_1525_ = 0u;
                                                        }
                                                        let _e1536 = phi_1525_;
                                                        let _e1538 = ((10u * _e273) & 31u);
                                                        let _e1548 = ((10u * _e272) & 31u);
                                                        let _e1558 = ((10u * _e274) & 31u);
                                                        let _e1568 = (_e1257 + 1u);
                                                        let _e1569 = (_e1568 < _e105);
                                                        if _e1569 {
                                                            if _e1569 {
                                                            } else {
                                                                phi_5365_ = _e1185;
                                                                phi_5207_ = true;
                                                                break;
                                                            }
                                                            let _e1571 = global_5.member[_e1568];
                                                            phi_1574_ = _e1571;
                                                        } else {
                                                            phi_1574_ = 0u;
                                                        }
                                                        let _e1573 = phi_1574_;
                                                        let _e1599 = (_e1257 + 2u);
                                                        let _e1600 = (_e1599 < _e105);
                                                        if _e1600 {
                                                            if _e1600 {
                                                            } else {
                                                                phi_5365_ = _e1185;
                                                                phi_5207_ = true;
                                                                break;
                                                            }
                                                            let _e1602 = global_5.member[_e1599];
                                                            phi_1623_ = _e1602;
                                                        } else {
                                                            phi_1623_ = 0u;
                                                        }
                                                        let _e1604 = phi_1623_;
                                                        phi_2124_ = array<array<f32, 3>, 3>(array<f32, 3>((_e713.member.member.x + ((bitcast<f32>((1258291200u | ((_e1536 >> bitcast<u32>(_e1538)) & 1023u))) - 8388608f) * _e153)), (_e713.member.member.y + ((bitcast<f32>((1258291200u | ((_e1536 >> bitcast<u32>(_e1548)) & 1023u))) - 8388608f) * _e153)), (_e713.member.member.z + ((bitcast<f32>((1258291200u | ((_e1536 >> bitcast<u32>(_e1558)) & 1023u))) - 8388608f) * _e153))), array<f32, 3>((_e713.member.member.x + ((bitcast<f32>((1258291200u | ((_e1573 >> bitcast<u32>(_e1538)) & 1023u))) - 8388608f) * _e153)), (_e713.member.member.y + ((bitcast<f32>((1258291200u | ((_e1573 >> bitcast<u32>(_e1548)) & 1023u))) - 8388608f) * _e153)), (_e713.member.member.z + ((bitcast<f32>((1258291200u | ((_e1573 >> bitcast<u32>(_e1558)) & 1023u))) - 8388608f) * _e153))), array<f32, 3>((_e713.member.member.x + ((bitcast<f32>((1258291200u | ((_e1604 >> bitcast<u32>(_e1538)) & 1023u))) - 8388608f) * _e153)), (_e713.member.member.y + ((bitcast<f32>((1258291200u | ((_e1604 >> bitcast<u32>(_e1548)) & 1023u))) - 8388608f) * _e153)), (_e713.member.member.z + ((bitcast<f32>((1258291200u | ((_e1604 >> bitcast<u32>(_e1558)) & 1023u))) - 8388608f) * _e153))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1346 = (_e1257 < _e105);
                                                        if _e1346 {
                                                            if _e1346 {
                                                            } else {
                                                                phi_5365_ = _e1185;
                                                                phi_5207_ = true;
                                                                break;
                                                            }
                                                            let _e1348 = global_5.member[_e1257];
                                                            phi_1672_ = _e1348;
                                                        } else {
                                                            phi_1672_ = 0u;
                                                        }
                                                        let _e1350 = phi_1672_;
                                                        let _e1351 = (_e1257 + 1u);
                                                        let _e1352 = (_e1351 < _e105);
                                                        if _e1352 {
                                                            if _e1352 {
                                                            } else {
                                                                phi_5365_ = _e1185;
                                                                phi_5207_ = true;
                                                                break;
                                                            }
                                                            let _e1354 = global_5.member[_e1351];
                                                            phi_1687_ = _e1354;
                                                        } else {
                                                            phi_1687_ = 0u;
                                                        }
                                                        let _e1356 = phi_1687_;
                                                        let _e1357 = (_e273 == 1u);
                                                        if _e1357 {
                                                            phi_1697_ = ((_e1350 >> bitcast<u32>(21i)) | (_e1356 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1697_ = (_e1356 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1366 = phi_1697_;
                                                        let _e1374 = (_e272 == 1u);
                                                        if _e1374 {
                                                            phi_1718_ = ((_e1350 >> bitcast<u32>(21i)) | (_e1356 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1718_ = (_e1356 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1383 = phi_1718_;
                                                        let _e1391 = (_e274 == 1u);
                                                        if _e1391 {
                                                            phi_1739_ = ((_e1350 >> bitcast<u32>(21i)) | (_e1356 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1739_ = (_e1356 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1400 = phi_1739_;
                                                        let _e1409 = (_e1257 + 2u);
                                                        let _e1410 = (_e1409 < _e105);
                                                        if _e1410 {
                                                            if _e1410 {
                                                            } else {
                                                                phi_5365_ = _e1185;
                                                                phi_5207_ = true;
                                                                break;
                                                            }
                                                            let _e1412 = global_5.member[_e1409];
                                                            phi_1769_ = _e1412;
                                                        } else {
                                                            phi_1769_ = 0u;
                                                        }
                                                        let _e1414 = phi_1769_;
                                                        let _e1415 = (_e1257 + 3u);
                                                        let _e1416 = (_e1415 < _e105);
                                                        if _e1416 {
                                                            if _e1416 {
                                                            } else {
                                                                phi_5365_ = _e1185;
                                                                phi_5207_ = true;
                                                                break;
                                                            }
                                                            let _e1418 = global_5.member[_e1415];
                                                            phi_1784_ = _e1418;
                                                        } else {
                                                            phi_1784_ = 0u;
                                                        }
                                                        let _e1420 = phi_1784_;
                                                        if _e1357 {
                                                            phi_1794_ = ((_e1414 >> bitcast<u32>(21i)) | (_e1420 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1794_ = (_e1420 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1429 = phi_1794_;
                                                        if _e1374 {
                                                            phi_1815_ = ((_e1414 >> bitcast<u32>(21i)) | (_e1420 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1815_ = (_e1420 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1445 = phi_1815_;
                                                        if _e1391 {
                                                            phi_1836_ = ((_e1414 >> bitcast<u32>(21i)) | (_e1420 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1836_ = (_e1420 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1461 = phi_1836_;
                                                        let _e1470 = (_e1257 + 4u);
                                                        let _e1471 = (_e1470 < _e105);
                                                        if _e1471 {
                                                            if _e1471 {
                                                            } else {
                                                                phi_5365_ = _e1185;
                                                                phi_5207_ = true;
                                                                break;
                                                            }
                                                            let _e1473 = global_5.member[_e1470];
                                                            phi_1866_ = _e1473;
                                                        } else {
                                                            phi_1866_ = 0u;
                                                        }
                                                        let _e1475 = phi_1866_;
                                                        let _e1476 = (_e1257 + 5u);
                                                        let _e1477 = (_e1476 < _e105);
                                                        if _e1477 {
                                                            if _e1477 {
                                                            } else {
                                                                phi_5365_ = _e1185;
                                                                phi_5207_ = true;
                                                                break;
                                                            }
                                                            let _e1479 = global_5.member[_e1476];
                                                            phi_1881_ = _e1479;
                                                        } else {
                                                            phi_1881_ = 0u;
                                                        }
                                                        let _e1481 = phi_1881_;
                                                        if _e1357 {
                                                            phi_1891_ = ((_e1475 >> bitcast<u32>(21i)) | (_e1481 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1891_ = (_e1481 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1490 = phi_1891_;
                                                        if _e1374 {
                                                            phi_1912_ = ((_e1475 >> bitcast<u32>(21i)) | (_e1481 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1912_ = (_e1481 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1506 = phi_1912_;
                                                        if _e1391 {
                                                            phi_1933_ = ((_e1475 >> bitcast<u32>(21i)) | (_e1481 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1933_ = (_e1481 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1522 = phi_1933_;
                                                        phi_2124_ = array<array<f32, 3>, 3>(array<f32, 3>((_e713.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1366, _e1350, _e312) & 2097151u))) - 8388608f) * _e153)), (_e713.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1383, _e1350, _e381) & 2097151u))) - 8388608f) * _e153)), (_e713.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1400, _e1350, _e449) & 2097151u))) - 8388608f) * _e153))), array<f32, 3>((_e713.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1429, _e1414, _e312) & 2097151u))) - 8388608f) * _e153)), (_e713.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1445, _e1414, _e381) & 2097151u))) - 8388608f) * _e153)), (_e713.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1461, _e1414, _e449) & 2097151u))) - 8388608f) * _e153))), array<f32, 3>((_e713.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1490, _e1475, _e312) & 2097151u))) - 8388608f) * _e153)), (_e713.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1506, _e1475, _e381) & 2097151u))) - 8388608f) * _e153)), (_e713.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1522, _e1475, _e449) & 2097151u))) - 8388608f) * _e153))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1259 = (_e1257 + _e273);
                                                        let _e1260 = (_e1259 < _e105);
                                                        if _e1260 {
                                                            if _e1260 {
                                                            } else {
                                                                phi_5365_ = _e1185;
                                                                phi_5207_ = true;
                                                                break;
                                                            }
                                                            let _e1262 = global_5.member[_e1259];
                                                            phi_1964_ = _e1262;
                                                        } else {
                                                            phi_1964_ = 0u;
                                                        }
                                                        let _e1264 = phi_1964_;
                                                        let _e1268 = (_e1257 + _e272);
                                                        let _e1269 = (_e1268 < _e105);
                                                        if _e1269 {
                                                            if _e1269 {
                                                            } else {
                                                                phi_5365_ = _e1185;
                                                                phi_5207_ = true;
                                                                break;
                                                            }
                                                            let _e1271 = global_5.member[_e1268];
                                                            phi_1982_ = _e1271;
                                                        } else {
                                                            phi_1982_ = 0u;
                                                        }
                                                        let _e1273 = phi_1982_;
                                                        let _e1277 = (_e1257 + _e274);
                                                        let _e1278 = (_e1277 < _e105);
                                                        if _e1278 {
                                                            if _e1278 {
                                                            } else {
                                                                phi_5365_ = _e1185;
                                                                phi_5207_ = true;
                                                                break;
                                                            }
                                                            let _e1280 = global_5.member[_e1277];
                                                            phi_2000_ = _e1280;
                                                        } else {
                                                            phi_2000_ = 0u;
                                                        }
                                                        let _e1282 = phi_2000_;
                                                        let _e1287 = (_e1257 + 3u);
                                                        let _e1288 = (_e1287 + _e273);
                                                        let _e1289 = (_e1288 < _e105);
                                                        if _e1289 {
                                                            if _e1289 {
                                                            } else {
                                                                phi_5365_ = _e1185;
                                                                phi_5207_ = true;
                                                                break;
                                                            }
                                                            let _e1291 = global_5.member[_e1288];
                                                            phi_2023_ = _e1291;
                                                        } else {
                                                            phi_2023_ = 0u;
                                                        }
                                                        let _e1293 = phi_2023_;
                                                        let _e1297 = (_e1287 + _e272);
                                                        let _e1298 = (_e1297 < _e105);
                                                        if _e1298 {
                                                            if _e1298 {
                                                            } else {
                                                                phi_5365_ = _e1185;
                                                                phi_5207_ = true;
                                                                break;
                                                            }
                                                            let _e1300 = global_5.member[_e1297];
                                                            phi_2041_ = _e1300;
                                                        } else {
                                                            phi_2041_ = 0u;
                                                        }
                                                        let _e1302 = phi_2041_;
                                                        let _e1306 = (_e1287 + _e274);
                                                        let _e1307 = (_e1306 < _e105);
                                                        if _e1307 {
                                                            if _e1307 {
                                                            } else {
                                                                phi_5365_ = _e1185;
                                                                phi_5207_ = true;
                                                                break;
                                                            }
                                                            let _e1309 = global_5.member[_e1306];
                                                            phi_2059_ = _e1309;
                                                        } else {
                                                            phi_2059_ = 0u;
                                                        }
                                                        let _e1311 = phi_2059_;
                                                        let _e1316 = (_e1257 + 6u);
                                                        let _e1317 = (_e1316 + _e273);
                                                        let _e1318 = (_e1317 < _e105);
                                                        if _e1318 {
                                                            if _e1318 {
                                                            } else {
                                                                phi_5365_ = _e1185;
                                                                phi_5207_ = true;
                                                                break;
                                                            }
                                                            let _e1320 = global_5.member[_e1317];
                                                            phi_2082_ = _e1320;
                                                        } else {
                                                            phi_2082_ = 0u;
                                                        }
                                                        let _e1322 = phi_2082_;
                                                        let _e1326 = (_e1316 + _e272);
                                                        let _e1327 = (_e1326 < _e105);
                                                        if _e1327 {
                                                            if _e1327 {
                                                            } else {
                                                                phi_5365_ = _e1185;
                                                                phi_5207_ = true;
                                                                break;
                                                            }
                                                            let _e1329 = global_5.member[_e1326];
                                                            phi_2100_ = _e1329;
                                                        } else {
                                                            phi_2100_ = 0u;
                                                        }
                                                        let _e1331 = phi_2100_;
                                                        let _e1335 = (_e1316 + _e274);
                                                        let _e1336 = (_e1335 < _e105);
                                                        if _e1336 {
                                                            if _e1336 {
                                                            } else {
                                                                phi_5365_ = _e1185;
                                                                phi_5207_ = true;
                                                                break;
                                                            }
                                                            let _e1338 = global_5.member[_e1335];
                                                            phi_2118_ = _e1338;
                                                        } else {
                                                            phi_2118_ = 0u;
                                                        }
                                                        let _e1340 = phi_2118_;
                                                        phi_2124_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1264)) * _e153), (f32(bitcast<i32>(_e1273)) * _e153), (f32(bitcast<i32>(_e1282)) * _e153)), array<f32, 3>((f32(bitcast<i32>(_e1293)) * _e153), (f32(bitcast<i32>(_e1302)) * _e153), (f32(bitcast<i32>(_e1311)) * _e153)), array<f32, 3>((f32(bitcast<i32>(_e1322)) * _e153), (f32(bitcast<i32>(_e1331)) * _e153), (f32(bitcast<i32>(_e1340)) * _e153)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2124_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1632 = phi_2124_;
                                                let _e1639 = (_e1632[0][2] - _e474);
                                                let _e1642 = (((_e1632[0][0] - _e337) * _e513) - (_e1639 * _e377));
                                                let _e1645 = (((_e1632[0][1] - _e406) * _e513) - (_e1639 * _e445));
                                                let _e1652 = (_e1632[1][2] - _e474);
                                                let _e1655 = (((_e1632[1][0] - _e337) * _e513) - (_e1652 * _e377));
                                                let _e1658 = (((_e1632[1][1] - _e406) * _e513) - (_e1652 * _e445));
                                                let _e1665 = (_e1632[2][2] - _e474);
                                                let _e1668 = (((_e1632[2][0] - _e337) * _e513) - (_e1665 * _e377));
                                                let _e1671 = (((_e1632[2][1] - _e406) * _e513) - (_e1665 * _e445));
                                                let _e1672 = (_e1668 * _e1658);
                                                let _e1673 = (_e1671 * _e1655);
                                                let _e1674 = (_e1642 * _e1671);
                                                let _e1675 = (_e1645 * _e1668);
                                                let _e1676 = (_e1655 * _e1645);
                                                let _e1677 = (_e1658 * _e1642);
                                                let _e1682 = (((_e1672 >= _e1673) && (_e1674 >= _e1675)) && (_e1676 >= _e1677));
                                                if (_e1682 || (((_e1672 <= _e1673) && (_e1674 <= _e1675)) && (_e1676 <= _e1677))) {
                                                    let _e1689 = select(-1f, 1f, _e1682);
                                                    let _e1691 = ((_e1672 - _e1673) * _e1689);
                                                    let _e1693 = select(0f, _e1691, (_e1691 > 0f));
                                                    let _e1695 = ((_e1674 - _e1675) * _e1689);
                                                    let _e1697 = select(0f, _e1695, (_e1695 > 0f));
                                                    let _e1699 = ((_e1676 - _e1677) * _e1689);
                                                    let _e1701 = select(0f, _e1699, (_e1699 > 0f));
                                                    let _e1703 = ((_e1693 + _e1697) + _e1701);
                                                    if (_e1703 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_3009_ = type_24();
                                                        phi_3010_ = true;
                                                        phi_3011_ = false;
                                                    } else {
                                                        let _e1706 = select(_e1655, _e1642, (_e1642 < _e1655));
                                                        if (select(_e1668, _e1706, (_e1706 < _e1668)) > 0f) {
                                                            phi_2277_ = true;
                                                        } else {
                                                            let _e1711 = select(_e1655, _e1642, (_e1642 > _e1655));
                                                            phi_2277_ = (select(_e1668, _e1711, (_e1711 > _e1668)) < 0f);
                                                        }
                                                        let _e1716 = phi_2277_;
                                                        if _e1716 {
                                                            phi_3006_ = type_24();
                                                            phi_3007_ = true;
                                                            phi_3008_ = false;
                                                        } else {
                                                            let _e1718 = select(_e1658, _e1645, (_e1645 < _e1658));
                                                            if (select(_e1671, _e1718, (_e1718 < _e1671)) > 0f) {
                                                                phi_2306_ = true;
                                                            } else {
                                                                let _e1723 = select(_e1658, _e1645, (_e1645 > _e1658));
                                                                phi_2306_ = (select(_e1671, _e1723, (_e1723 > _e1671)) < 0f);
                                                            }
                                                            let _e1728 = phi_2306_;
                                                            if _e1728 {
                                                                phi_3004_ = type_24();
                                                                phi_3005_ = false;
                                                            } else {
                                                                let _e1730 = select(_e1632[1][0], _e1632[0][0], (_e1632[0][0] < _e1632[1][0]));
                                                                let _e1734 = select(_e1632[1][0], _e1632[0][0], (_e1632[0][0] > _e1632[1][0]));
                                                                let _e1738 = select(_e1632[1][1], _e1632[0][1], (_e1632[0][1] < _e1632[1][1]));
                                                                let _e1742 = select(_e1632[1][1], _e1632[0][1], (_e1632[0][1] > _e1632[1][1]));
                                                                let _e1746 = select(_e1632[1][2], _e1632[0][2], (_e1632[0][2] < _e1632[1][2]));
                                                                let _e1750 = select(_e1632[1][2], _e1632[0][2], (_e1632[0][2] > _e1632[1][2]));
                                                                let _e1755 = ((select(_e1632[2][0], _e1730, (_e1730 < _e1632[2][0])) - _e375) * _e380);
                                                                let _e1756 = ((select(_e1632[2][0], _e1734, (_e1734 > _e1632[2][0])) - _e376) * _e380);
                                                                let _e1759 = ((select(_e1632[2][1], _e1738, (_e1738 < _e1632[2][1])) - _e443) * _e448);
                                                                let _e1760 = ((select(_e1632[2][1], _e1742, (_e1742 > _e1632[2][1])) - _e444) * _e448);
                                                                let _e1763 = ((select(_e1632[2][2], _e1746, (_e1746 < _e1632[2][2])) - _e511) * _e516);
                                                                let _e1764 = ((select(_e1632[2][2], _e1750, (_e1750 > _e1632[2][2])) - _e512) * _e516);
                                                                let _e1766 = select(_e1764, _e1763, (_e1763 < _e1764));
                                                                let _e1768 = select(_e1764, _e1763, (_e1763 > _e1764));
                                                                let _e1770 = select(_e1756, _e1755, (_e1755 < _e1756));
                                                                let _e1772 = select(_e1760, _e1759, (_e1759 < _e1760));
                                                                let _e1774 = select(_e1772, _e1770, (_e1770 > _e1772));
                                                                let _e1776 = select(_e1766, _e1774, (_e1774 > _e1766));
                                                                let _e1778 = select(_e1756, _e1755, (_e1755 > _e1756));
                                                                let _e1780 = select(_e1760, _e1759, (_e1759 > _e1760));
                                                                let _e1782 = select(_e1780, _e1778, (_e1778 < _e1780));
                                                                let _e1784 = select(_e1768, _e1782, (_e1782 < _e1768));
                                                                let _e1785 = -(_e1766);
                                                                let _e1791 = select(_e628, _e1776, (_e1776 > _e628));
                                                                if (_e1791 > (_e1784 + (select(_e1785, _e1768, (_e1768 > _e1785)) * 0.0000019073523f))) {
                                                                    phi_2999_ = type_24();
                                                                    phi_3000_ = true;
                                                                } else {
                                                                    let _e1793 = (_e1791 > _e1185);
                                                                    if _e1793 {
                                                                        phi_2998_ = type_24();
                                                                    } else {
                                                                        let _e1794 = vec3<f32>(_e1632[0][0], _e1632[0][1], _e1632[0][2]);
                                                                        let _e1795 = vec3<f32>(_e1632[1][0], _e1632[1][1], _e1632[1][2]);
                                                                        let _e1796 = vec3<f32>(_e1632[2][0], _e1632[2][1], _e1632[2][2]);
                                                                        let _e1797 = (_e1632[1][0] - _e1632[0][0]);
                                                                        let _e1798 = (_e1632[1][1] - _e1632[0][1]);
                                                                        let _e1799 = (_e1632[1][2] - _e1632[0][2]);
                                                                        let _e1800 = vec3<f32>(_e1797, _e1798, _e1799);
                                                                        let _e1801 = (_e1632[2][0] - _e1632[1][0]);
                                                                        let _e1802 = (_e1632[2][1] - _e1632[1][1]);
                                                                        let _e1803 = (_e1632[2][2] - _e1632[1][2]);
                                                                        let _e1804 = vec3<f32>(_e1801, _e1802, _e1803);
                                                                        let _e1805 = (_e1632[0][0] - _e1632[2][0]);
                                                                        let _e1806 = (_e1632[0][1] - _e1632[2][1]);
                                                                        let _e1807 = (_e1632[0][2] - _e1632[2][2]);
                                                                        let _e1808 = vec3<f32>(_e1805, _e1806, _e1807);
                                                                        let _e1811 = bitcast<f32>((bitcast<u32>(_e1797) & 2147483647u));
                                                                        let _e1814 = bitcast<f32>((bitcast<u32>(_e1798) & 2147483647u));
                                                                        let _e1816 = select(_e1814, _e1811, (_e1811 > _e1814));
                                                                        let _e1819 = bitcast<f32>((bitcast<u32>(_e1799) & 2147483647u));
                                                                        let _e1821 = select(_e1819, _e1816, (_e1816 > _e1819));
                                                                        let _e1824 = bitcast<f32>((bitcast<u32>(_e1801) & 2147483647u));
                                                                        let _e1827 = bitcast<f32>((bitcast<u32>(_e1802) & 2147483647u));
                                                                        let _e1829 = select(_e1827, _e1824, (_e1824 > _e1827));
                                                                        let _e1832 = bitcast<f32>((bitcast<u32>(_e1803) & 2147483647u));
                                                                        let _e1834 = select(_e1832, _e1829, (_e1829 > _e1832));
                                                                        let _e1837 = bitcast<f32>((bitcast<u32>(_e1805) & 2147483647u));
                                                                        let _e1840 = bitcast<f32>((bitcast<u32>(_e1806) & 2147483647u));
                                                                        let _e1842 = select(_e1840, _e1837, (_e1837 > _e1840));
                                                                        let _e1845 = bitcast<f32>((bitcast<u32>(_e1807) & 2147483647u));
                                                                        let _e1847 = select(_e1845, _e1842, (_e1842 > _e1845));
                                                                        let _e1849 = select(_e1834, _e1821, (_e1821 > _e1834));
                                                                        let _e1851 = select(_e1847, _e1849, (_e1849 > _e1847));
                                                                        if (_e1821 == _e1851) {
                                                                            phi_2725_ = _e1658;
                                                                            phi_2726_ = _e1655;
                                                                            phi_2727_ = _e1645;
                                                                            phi_2728_ = _e1642;
                                                                            phi_2729_ = _e1794;
                                                                            phi_2730_ = _e1808;
                                                                            phi_2731_ = _e1804;
                                                                            phi_2732_ = _e1800;
                                                                        } else {
                                                                            let _e1853 = (_e1834 == _e1851);
                                                                            let _e1858 = vec3(_e1853);
                                                                            phi_2725_ = select(_e1645, _e1671, _e1853);
                                                                            phi_2726_ = select(_e1642, _e1668, _e1853);
                                                                            phi_2727_ = select(_e1671, _e1658, _e1853);
                                                                            phi_2728_ = select(_e1668, _e1655, _e1853);
                                                                            phi_2729_ = select(_e1796, _e1795, _e1858);
                                                                            phi_2730_ = select(_e1804, _e1800, _e1858);
                                                                            phi_2731_ = select(_e1800, _e1808, _e1858);
                                                                            phi_2732_ = select(_e1808, _e1804, _e1858);
                                                                        }
                                                                        let _e1864 = phi_2725_;
                                                                        let _e1866 = phi_2726_;
                                                                        let _e1868 = phi_2727_;
                                                                        let _e1870 = phi_2728_;
                                                                        let _e1872 = phi_2729_;
                                                                        let _e1874 = phi_2730_;
                                                                        let _e1876 = phi_2731_;
                                                                        let _e1878 = phi_2732_;
                                                                        let _e1885 = ((_e1876.y * _e1874.z) - (_e1874.y * _e1876.z));
                                                                        let _e1890 = ((_e1876.z * _e1874.x) - (_e1874.z * _e1876.x));
                                                                        let _e1893 = ((_e1876.x * _e1874.y) - (_e1874.x * _e1876.y));
                                                                        if (_e1693 >= _e1697) {
                                                                            phi_2769_ = select(true, false, (_e1693 >= _e1701));
                                                                        } else {
                                                                            phi_2769_ = true;
                                                                        }
                                                                        let _e1898 = phi_2769_;
                                                                        if _e1898 {
                                                                            phi_2778_ = select(_e1796, _e1795, vec3((_e1697 >= _e1701)));
                                                                        } else {
                                                                            phi_2778_ = _e1794;
                                                                        }
                                                                        let _e1903 = phi_2778_;
                                                                        let _e1914 = (((_e1885 * (_e1903.x - _e337)) + (_e1890 * (_e1903.y - _e406))) + (_e1893 * (_e1903.z - _e474)));
                                                                        let _e1919 = (((_e1885 * _e377) + (_e1890 * _e445)) + (_e1893 * _e513));
                                                                        let _e1920 = (_e1866 - _e1870);
                                                                        let _e1921 = (_e1864 - _e1868);
                                                                        let _e1929 = (-(((_e1870 * _e1920) + (_e1868 * _e1921))) / ((_e1920 * _e1920) + (_e1921 * _e1921)));
                                                                        let _e1931 = select(1f, _e1929, (_e1929 < 1f));
                                                                        let _e1933 = select(0f, _e1931, (_e1931 > 0f));
                                                                        let _e1946 = ((_e1872.x + (_e1878.x * _e1933)) - _e337);
                                                                        let _e1947 = ((_e1872.y + (_e1878.y * _e1933)) - _e406);
                                                                        let _e1948 = ((_e1872.z + (_e1878.z * _e1933)) - _e474);
                                                                        let _e1949 = (_e1948 / _e513);
                                                                        let _e1961 = bitcast<f32>((bitcast<u32>(_e1946) & 2147483647u));
                                                                        let _e1964 = bitcast<f32>((bitcast<u32>(_e1947) & 2147483647u));
                                                                        let _e1966 = select(_e1964, _e1961, (_e1961 > _e1964));
                                                                        let _e1969 = bitcast<f32>((bitcast<u32>(_e1948) & 2147483647u));
                                                                        let _e1971 = select(_e1969, _e1966, (_e1966 > _e1969));
                                                                        let _e1977 = bitcast<f32>((bitcast<u32>(_e1885) & 2147483647u));
                                                                        let _e1980 = bitcast<f32>((bitcast<u32>(_e1890) & 2147483647u));
                                                                        let _e1982 = select(_e1980, _e1977, (_e1977 > _e1980));
                                                                        let _e1985 = bitcast<f32>((bitcast<u32>(_e1893) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1885 * _e1946) + (_e1890 * _e1947)) + (_e1893 * _e1948)) - _e1914)) & 2147483647u)) <= ((0.0000009536743f * select(_e1851, _e1971, (_e1971 > _e1851))) * select(_e1985, _e1982, (_e1982 > _e1985)))) {
                                                                            let _e1995 = bitcast<f32>((bitcast<u32>(_e1876.x) & 2147483647u));
                                                                            let _e1998 = bitcast<f32>((bitcast<u32>(_e1876.y) & 2147483647u));
                                                                            let _e2000 = select(_e1998, _e1995, (_e1995 > _e1998));
                                                                            let _e2003 = bitcast<f32>((bitcast<u32>(_e1876.z) & 2147483647u));
                                                                            let _e2009 = bitcast<f32>((bitcast<u32>(_e1874.x) & 2147483647u));
                                                                            let _e2012 = bitcast<f32>((bitcast<u32>(_e1874.y) & 2147483647u));
                                                                            let _e2014 = select(_e2012, _e2009, (_e2009 > _e2012));
                                                                            let _e2017 = bitcast<f32>((bitcast<u32>(_e1874.z) & 2147483647u));
                                                                            let _e2021 = (bitcast<f32>((bitcast<u32>(_e1919) & 2147483647u)) > ((0.0000038146973f * select(_e2003, _e2000, (_e2000 > _e2003))) * select(_e2017, _e2014, (_e2014 > _e2017))));
                                                                            if _e2021 {
                                                                                phi_2943_ = (_e1914 / _e1919);
                                                                            } else {
                                                                                phi_2943_ = f32();
                                                                            }
                                                                            let _e2024 = phi_2943_;
                                                                            phi_2945_ = _e2024;
                                                                            phi_2946_ = select(true, false, _e2021);
                                                                        } else {
                                                                            phi_2945_ = f32();
                                                                            phi_2946_ = true;
                                                                        }
                                                                        let _e2027 = phi_2945_;
                                                                        let _e2029 = phi_2946_;
                                                                        if _e2029 {
                                                                            let _e2037 = (((_e1885 * (_e1946 - (_e377 * _e1949))) + (_e1890 * (_e1947 - (_e445 * _e1949)))) / _e1919);
                                                                            if (bitcast<f32>((bitcast<u32>(_e2037) & 2147483647u)) <= _e1851) {
                                                                                phi_2966_ = (_e1949 + _e2037);
                                                                            } else {
                                                                                phi_2966_ = _e1949;
                                                                            }
                                                                            let _e2044 = phi_2966_;
                                                                            phi_2967_ = _e2044;
                                                                        } else {
                                                                            phi_2967_ = _e2027;
                                                                        }
                                                                        let _e2046 = phi_2967_;
                                                                        let _e2048 = select(_e1784, _e2046, (_e2046 < _e1784));
                                                                        let _e2050 = select(_e1776, _e2048, (_e2048 > _e1776));
                                                                        if (_e2050 >= _e628) {
                                                                            let _e2052 = (_e2050 <= _e1185);
                                                                            if _e2052 {
                                                                                let _e2053 = (1f / _e1703);
                                                                                phi_2990_ = type_24(_e2050, (_e1697 * _e2053), (_e1701 * _e2053), _e1245);
                                                                            } else {
                                                                                phi_2990_ = type_24();
                                                                            }
                                                                            let _e2058 = phi_2990_;
                                                                            phi_2992_ = _e2058;
                                                                            phi_2993_ = select(true, false, _e2052);
                                                                        } else {
                                                                            phi_2992_ = type_24();
                                                                            phi_2993_ = true;
                                                                        }
                                                                        let _e2061 = phi_2992_;
                                                                        let _e2063 = phi_2993_;
                                                                        if _e2063 {
                                                                            phi_2997_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2997_ = _e2061;
                                                                        }
                                                                        let _e2065 = phi_2997_;
                                                                        phi_2998_ = _e2065;
                                                                    }
                                                                    let _e2067 = phi_2998_;
                                                                    phi_2999_ = _e2067;
                                                                    phi_3000_ = _e1793;
                                                                }
                                                                let _e2069 = phi_2999_;
                                                                let _e2071 = phi_3000_;
                                                                phi_3004_ = _e2069;
                                                                phi_3005_ = _e2071;
                                                            }
                                                            let _e2073 = phi_3004_;
                                                            let _e2075 = phi_3005_;
                                                            phi_3006_ = _e2073;
                                                            phi_3007_ = _e1728;
                                                            phi_3008_ = _e2075;
                                                        }
                                                        let _e2077 = phi_3006_;
                                                        let _e2079 = phi_3007_;
                                                        let _e2081 = phi_3008_;
                                                        phi_3009_ = _e2077;
                                                        phi_3010_ = _e2079;
                                                        phi_3011_ = _e2081;
                                                    }
                                                    let _e2083 = phi_3009_;
                                                    let _e2085 = phi_3010_;
                                                    let _e2087 = phi_3011_;
                                                    phi_3019_ = _e2083;
                                                    phi_3020_ = select(_e2087, true, _e2085);
                                                } else {
                                                    phi_3019_ = type_24();
                                                    phi_3020_ = true;
                                                }
                                                let _e2090 = phi_3019_;
                                                let _e2092 = phi_3020_;
                                                if _e2092 {
                                                    phi_3024_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_3024_ = _e2090;
                                                }
                                                let _e2094 = phi_3024_;
                                                if (_e2094.member_3 != 4294967295u) {
                                                    if (_e1245 != 4294967295u) {
                                                        phi_3036_ = type_8(0u, 8u);
                                                        phi_3039_ = _e2094;
                                                        loop {
                                                            let _e2099 = phi_3036_;
                                                            let _e2101 = phi_3039_;
                                                            if (_e2099.member < _e2099.member_1) {
                                                                phi_3037_ = type_8((_e2099.member + 1u), _e2099.member_1);
                                                                phi_3062_ = type_8(1u, _e2099.member);
                                                            } else {
                                                                phi_3037_ = _e2099;
                                                                phi_3062_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e2114 = phi_3037_;
                                                            let _e2116 = phi_3062_;
                                                            let _e2120 = (bitcast<i32>(_e2116.member) != 0i);
                                                            if _e2120 {
                                                                let _e2121 = (_e2116.member_1 < 8u);
                                                                if _e2121 {
                                                                } else {
                                                                    phi_5000_ = true;
                                                                    break;
                                                                }
                                                                let _e2126 = local_9[_e2116.member_1].member;
                                                                if (_e2101.member < _e2126) {
                                                                    phi_3095_ = true;
                                                                } else {
                                                                    let _e2128 = local_9[_e2116.member_1].member;
                                                                    if (_e2101.member == _e2128) {
                                                                        let _e2133 = local_9[_e2116.member_1].member_3;
                                                                        phi_3094_ = (_e2101.member_3 < _e2133);
                                                                    } else {
                                                                        phi_3094_ = false;
                                                                    }
                                                                    let _e2136 = phi_3094_;
                                                                    phi_3095_ = _e2136;
                                                                }
                                                                let _e2138 = phi_3095_;
                                                                if _e2138 {
                                                                    if _e2121 {
                                                                    } else {
                                                                        phi_5000_ = true;
                                                                        break;
                                                                    }
                                                                    let _e2139 = local_9[_e2116.member_1];
                                                                    local_9[_e2116.member_1] = type_24(_e2101.member, _e2101.member_1, _e2101.member_2, _e2101.member_3);
                                                                    phi_3116_ = type_24(_e2139.member, _e2139.member_1, _e2139.member_2, _e2139.member_3);
                                                                } else {
                                                                    phi_3116_ = _e2101;
                                                                }
                                                                let _e2150 = phi_3116_;
                                                                phi_3040_ = _e2150;
                                                            } else {
                                                                phi_3040_ = type_24();
                                                            }
                                                            let _e2152 = phi_3040_;
                                                            continue;
                                                            continuing {
                                                                phi_3036_ = _e2114;
                                                                phi_3039_ = _e2152;
                                                                phi_5000_ = _e1183;
                                                                break if !(_e2120);
                                                            }
                                                        }
                                                        let _e2155 = phi_5000_;
                                                        phi_5365_ = _e1185;
                                                        phi_5207_ = _e2155;
                                                        if _e2155 {
                                                            break;
                                                        }
                                                        let _e2158 = local_9[7u].member_3;
                                                        if (_e2158 != 4294967295u) {
                                                            let _e2162 = local_9[7u].member;
                                                            phi_5456_ = _e2162;
                                                        } else {
                                                            phi_5456_ = _e1185;
                                                        }
                                                        let _e2164 = phi_5456_;
                                                        phi_5455_ = _e2164;
                                                        phi_5210_ = _e2155;
                                                    } else {
                                                        phi_5455_ = _e1185;
                                                        phi_5210_ = _e1183;
                                                    }
                                                    let _e2166 = phi_5455_;
                                                    let _e2168 = phi_5210_;
                                                    phi_5454_ = _e2166;
                                                    phi_5209_ = _e2168;
                                                } else {
                                                    phi_5454_ = _e1185;
                                                    phi_5209_ = _e1183;
                                                }
                                                let _e2170 = phi_5454_;
                                                let _e2172 = phi_5209_;
                                                phi_5453_ = _e2170;
                                                phi_5208_ = _e2172;
                                            } else {
                                                phi_5453_ = _e1185;
                                                phi_5208_ = _e1183;
                                            }
                                            let _e2174 = phi_5453_;
                                            let _e2176 = phi_5208_;
                                            continue;
                                            continuing {
                                                phi_5029_ = _e2176;
                                                phi_4972_ = _e2174;
                                                phi_1362_ = _e1200;
                                                phi_5365_ = _e2174;
                                                phi_5207_ = _e2176;
                                                break if !(_e1206);
                                            }
                                        }
                                        let _e2179 = phi_5365_;
                                        let _e2181 = phi_5207_;
                                        phi_5212_ = _e2181;
                                        if _e2181 {
                                            break;
                                        }
                                        phi_5330_ = _e2179;
                                        phi_5216_ = _e2181;
                                        phi_4399_ = false;
                                        phi_4400_ = _e711;
                                        phi_4401_ = _e713;
                                    } else {
                                        if (_e713.member_1 >= _e102) {
                                            phi_3933_ = type_52(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e713.member_1 < _e102) {
                                            } else {
                                                phi_5212_ = true;
                                                break;
                                            }
                                            let _e726 = ((1u + _e273) % 4u);
                                            if (_e726 < 4u) {
                                            } else {
                                                phi_5212_ = true;
                                                break;
                                            }
                                            let _e731 = global_3.member[_e713.member_1][_e726];
                                            let _e733 = (_e731 >> bitcast<u32>(11u));
                                            let _e735 = ((1u + _e272) % 4u);
                                            if (_e735 < 4u) {
                                            } else {
                                                phi_5212_ = true;
                                                break;
                                            }
                                            let _e740 = global_3.member[_e713.member_1][_e735];
                                            let _e742 = (_e740 >> bitcast<u32>(11u));
                                            let _e744 = ((1u + _e274) % 4u);
                                            if (_e744 < 4u) {
                                            } else {
                                                phi_5212_ = true;
                                                break;
                                            }
                                            let _e749 = global_3.member[_e713.member_1][_e744];
                                            let _e751 = (_e749 >> bitcast<u32>(11u));
                                            let _e774 = (bitcast<f32>((bitcast<u32>((_e713.member.member_1.x - _e713.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e775 = (bitcast<f32>((bitcast<u32>((_e713.member.member_1.y - _e713.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e776 = (bitcast<f32>((bitcast<u32>((_e713.member.member_1.z - _e713.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e778 = select(_e153, _e774, (_e774 > _e153));
                                            let _e780 = select(_e153, _e775, (_e775 > _e153));
                                            let _e782 = select(_e153, _e776, (_e776 > _e153));
                                            let _e813 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e731 & 1023u))) - 8388608f) * _e778));
                                            let _e818 = (bitcast<i32>((_e731 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e821 = bitcast<f32>((_e813 & bitcast<u32>(_e818)));
                                            let _e822 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e740 & 1023u))) - 8388608f) * _e780));
                                            let _e827 = (bitcast<i32>((_e740 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e830 = bitcast<f32>((_e822 & bitcast<u32>(_e827)));
                                            let _e831 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e749 & 1023u))) - 8388608f) * _e782));
                                            let _e836 = (bitcast<i32>((_e749 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e839 = bitcast<f32>((_e831 & bitcast<u32>(_e836)));
                                            let _e843 = bitcast<f32>((_e813 & bitcast<u32>(~(_e818))));
                                            let _e847 = bitcast<f32>((_e822 & bitcast<u32>(~(_e827))));
                                            let _e851 = bitcast<f32>((_e831 & bitcast<u32>(~(_e836))));
                                            let _e852 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e733 & 1023u))) - 8388608f) * _e778));
                                            let _e857 = (bitcast<i32>((_e733 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e860 = bitcast<f32>((_e852 & bitcast<u32>(_e857)));
                                            let _e861 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e742 & 1023u))) - 8388608f) * _e780));
                                            let _e866 = (bitcast<i32>((_e742 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e869 = bitcast<f32>((_e861 & bitcast<u32>(_e866)));
                                            let _e870 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e751 & 1023u))) - 8388608f) * _e782));
                                            let _e875 = (bitcast<i32>((_e751 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e878 = bitcast<f32>((_e870 & bitcast<u32>(_e875)));
                                            let _e882 = bitcast<f32>((_e852 & bitcast<u32>(~(_e857))));
                                            let _e886 = bitcast<f32>((_e861 & bitcast<u32>(~(_e866))));
                                            let _e890 = bitcast<f32>((_e870 & bitcast<u32>(~(_e875))));
                                            let _e891 = (_e713.member.member.x + _e821);
                                            let _e892 = (_e713.member.member.y + _e830);
                                            let _e893 = (_e713.member.member.z + _e839);
                                            let _e896 = (_e713.member.member_1.x - _e860);
                                            let _e897 = (_e713.member.member_1.y - _e869);
                                            let _e898 = (_e713.member.member_1.z - _e878);
                                            let _e917 = (_e896 - _e891);
                                            let _e918 = (_e897 - _e892);
                                            let _e919 = (_e898 - _e893);
                                            let _e921 = select(_e918, _e917, (_e917 > _e918));
                                            let _e923 = select(_e919, _e921, (_e921 > _e919));
                                            if (_e923 < (1024f * _e153)) {
                                                phi_3634_ = 0u;
                                            } else {
                                                phi_3634_ = select(2u, 1u, (_e923 < (2097152f * _e153)));
                                            }
                                            let _e930 = phi_3634_;
                                            switch bitcast<i32>(_e930) {
                                                case 0: {
                                                    phi_3640_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3640_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3640_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3640_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e933 = phi_3640_;
                                            let _e939 = global_3.member[_e713.member_1][0u];
                                            let _e943 = global_3.member[_e713.member_1][1u];
                                            let _e947 = global_3.member[_e713.member_1][2u];
                                            let _e951 = global_3.member[_e713.member_1][3u];
                                            let _e963 = (((_e943 >> bitcast<u32>(22i)) | ((_e947 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e951 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e964 = (_e939 & 268435455u);
                                            let _e965 = (_e963 & 268435455u);
                                            let _e968 = ((_e939 >> bitcast<u32>(28u)) & 7u);
                                            let _e976 = ((_e939 >> bitcast<u32>(31i)) | (((_e963 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e977 = (_e968 != 0u);
                                            if (_e968 == 0u) {
                                                phi_3895_ = _e964;
                                            } else {
                                                if (_e968 == 7u) {
                                                    phi_3894_ = 2147483648u;
                                                } else {
                                                    phi_3894_ = ((2147483648u | (_e968 << bitcast<u32>(28u))) | (_e965 & 268435455u));
                                                }
                                                let _e986 = phi_3894_;
                                                phi_3895_ = _e986;
                                            }
                                            let _e988 = phi_3895_;
                                            if _e977 {
                                                let _e989 = (_e968 != 7u);
                                                if _e989 {
                                                    phi_3905_ = (_e965 + (_e968 * ((3u * _e933) + 1u)));
                                                } else {
                                                    phi_3905_ = u32();
                                                }
                                                let _e993 = phi_3905_;
                                                phi_3907_ = _e993;
                                                phi_3908_ = select(true, false, _e989);
                                            } else {
                                                phi_3907_ = u32();
                                                phi_3908_ = true;
                                            }
                                            let _e996 = phi_3907_;
                                            let _e998 = phi_3908_;
                                            if (_e976 == 0u) {
                                                phi_3929_ = (_e964 + select(0u, 1u, !(_e977)));
                                            } else {
                                                if (_e976 == 7u) {
                                                    phi_3928_ = 2147483648u;
                                                } else {
                                                    phi_3928_ = ((2147483648u | (_e976 << bitcast<u32>(28u))) | (select(_e996, _e965, _e998) & 268435455u));
                                                }
                                                let _e1011 = phi_3928_;
                                                phi_3929_ = _e1011;
                                            }
                                            let _e1013 = phi_3929_;
                                            phi_3933_ = type_52(array<vec4<f32>, 3>(vec4<f32>(_e891, (_e713.member.member.x + _e843), _e896, (_e713.member.member_1.x - _e882)), vec4<f32>(_e892, (_e713.member.member.y + _e847), _e897, (_e713.member.member_1.y - _e886)), vec4<f32>(_e893, (_e713.member.member.z + _e851), _e898, (_e713.member.member_1.z - _e890))), type_51(type_28((_e713.member.member + vec4<f32>(_e821, _e830, _e839, 0f)), (_e713.member.member_1 - vec4<f32>(_e860, _e869, _e878, 0f))), _e988), type_51(type_28((_e713.member.member + vec4<f32>(_e843, _e847, _e851, 0f)), (_e713.member.member_1 - vec4<f32>(_e882, _e886, _e890, 0f))), _e1013));
                                        }
                                        let _e1018 = phi_3933_;
                                        let _e1029 = ((_e1018.member[0].x - _e375) * _e380);
                                        let _e1030 = ((_e1018.member[0].y - _e375) * _e380);
                                        let _e1031 = ((_e1018.member[0].z - _e376) * _e380);
                                        let _e1032 = ((_e1018.member[0].w - _e376) * _e380);
                                        let _e1042 = ((_e1018.member[1].x - _e443) * _e448);
                                        let _e1043 = ((_e1018.member[1].y - _e443) * _e448);
                                        let _e1044 = ((_e1018.member[1].z - _e444) * _e448);
                                        let _e1045 = ((_e1018.member[1].w - _e444) * _e448);
                                        let _e1055 = ((_e1018.member[2].x - _e511) * _e516);
                                        let _e1056 = ((_e1018.member[2].y - _e511) * _e516);
                                        let _e1057 = ((_e1018.member[2].z - _e512) * _e516);
                                        let _e1058 = ((_e1018.member[2].w - _e512) * _e516);
                                        let _e1060 = select(_e1057, _e1055, (_e1055 < _e1057));
                                        let _e1062 = select(_e1058, _e1056, (_e1056 < _e1058));
                                        let _e1064 = select(_e1057, _e1055, (_e1055 > _e1057));
                                        let _e1066 = select(_e1058, _e1056, (_e1056 > _e1058));
                                        let _e1068 = select(_e1031, _e1029, (_e1029 < _e1031));
                                        let _e1070 = select(_e1032, _e1030, (_e1030 < _e1032));
                                        let _e1072 = select(_e1044, _e1042, (_e1042 < _e1044));
                                        let _e1074 = select(_e1045, _e1043, (_e1043 < _e1045));
                                        let _e1076 = select(_e1072, _e1068, (_e1068 > _e1072));
                                        let _e1078 = select(_e1074, _e1070, (_e1070 > _e1074));
                                        let _e1080 = select(_e1060, _e1076, (_e1076 > _e1060));
                                        let _e1082 = select(_e1062, _e1078, (_e1078 > _e1062));
                                        let _e1084 = select(_e1031, _e1029, (_e1029 > _e1031));
                                        let _e1086 = select(_e1032, _e1030, (_e1030 > _e1032));
                                        let _e1088 = select(_e1044, _e1042, (_e1042 > _e1044));
                                        let _e1090 = select(_e1045, _e1043, (_e1043 > _e1045));
                                        let _e1092 = select(_e1088, _e1084, (_e1084 < _e1088));
                                        let _e1094 = select(_e1090, _e1086, (_e1086 < _e1090));
                                        let _e1099 = -(_e1060);
                                        let _e1100 = -(_e1062);
                                        let _e1107 = (select(_e1064, _e1092, (_e1092 < _e1064)) + (select(_e1099, _e1064, (_e1064 > _e1099)) * 0.0000019073523f));
                                        let _e1108 = (select(_e1066, _e1094, (_e1094 < _e1066)) + (select(_e1100, _e1066, (_e1066 > _e1100)) * 0.0000019073523f));
                                        let _e1110 = select(_e628, _e1080, (_e1080 > _e628));
                                        let _e1112 = select(_e628, _e1082, (_e1082 > _e628));
                                        let _e1117 = (_e1110 <= select(_e671, _e1107, (_e1107 < _e671)));
                                        let _e1118 = (_e1112 <= select(_e671, _e1108, (_e1108 < _e671)));
                                        let _e1119 = (_e1110 <= _e1112);
                                        if _e1117 {
                                            if _e1118 {
                                                if _e1119 {
                                                    phi_4296_ = _e1018.member_2;
                                                } else {
                                                    phi_4296_ = _e1018.member_1;
                                                }
                                                let _e1123 = phi_4296_;
                                                let _e1145 = (_e711 % 128u);
                                                let _e1146 = (_e1145 < 128u);
                                                if _e1146 {
                                                } else {
                                                    phi_5212_ = true;
                                                    break;
                                                }
                                                local_8[_e1145] = _e1123.member_1;
                                                if _e1146 {
                                                } else {
                                                    phi_5212_ = true;
                                                    break;
                                                }
                                                local_7[_e1145] = _e1123.member.member.x;
                                                if _e1146 {
                                                } else {
                                                    phi_5212_ = true;
                                                    break;
                                                }
                                                local_6[_e1145] = _e1123.member.member.y;
                                                if _e1146 {
                                                } else {
                                                    phi_5212_ = true;
                                                    break;
                                                }
                                                local_5[_e1145] = _e1123.member.member.z;
                                                if _e1146 {
                                                } else {
                                                    phi_5212_ = true;
                                                    break;
                                                }
                                                local_4[_e1145] = _e1123.member.member_1.x;
                                                if _e1146 {
                                                } else {
                                                    phi_5212_ = true;
                                                    break;
                                                }
                                                local_3[_e1145] = _e1123.member.member_1.y;
                                                if _e1146 {
                                                } else {
                                                    phi_5212_ = true;
                                                    break;
                                                }
                                                local_2[_e1145] = _e1123.member.member_1.z;
                                                if _e1146 {
                                                } else {
                                                    phi_5212_ = true;
                                                    break;
                                                }
                                                local_10[_e1145] = select(_e1112, _e1110, !(_e1119));
                                                if _e1119 {
                                                    phi_4373_ = _e1018.member_1;
                                                } else {
                                                    phi_4373_ = _e1018.member_2;
                                                }
                                                let _e1159 = phi_4373_;
                                                phi_4374_ = (_e711 + 1u);
                                                phi_4375_ = _e1159;
                                            } else {
                                                phi_4374_ = u32();
                                                phi_4375_ = type_51();
                                            }
                                            let _e1161 = phi_4374_;
                                            let _e1163 = phi_4375_;
                                            phi_4377_ = _e1161;
                                            phi_4378_ = _e1163;
                                            phi_4379_ = select(true, false, _e1118);
                                        } else {
                                            phi_4377_ = u32();
                                            phi_4378_ = type_51();
                                            phi_4379_ = true;
                                        }
                                        let _e1166 = phi_4377_;
                                        let _e1168 = phi_4378_;
                                        let _e1170 = phi_4379_;
                                        if _e1170 {
                                            if _e1117 {
                                                phi_4388_ = _e1018.member_1;
                                            } else {
                                                phi_4388_ = _e1018.member_2;
                                            }
                                            let _e1174 = phi_4388_;
                                            phi_4393_ = select(_e1118, true, _e1117);
                                            phi_4395_ = _e1174;
                                        } else {
                                            phi_4393_ = _e709;
                                            phi_4395_ = _e1168;
                                        }
                                        let _e1177 = phi_4393_;
                                        let _e1179 = phi_4395_;
                                        phi_5330_ = _e671;
                                        phi_5216_ = _e669;
                                        phi_4399_ = _e1177;
                                        phi_4400_ = select(_e1166, _e711, _e1170);
                                        phi_4401_ = _e1179;
                                    }
                                    let _e2183 = phi_5330_;
                                    let _e2185 = phi_5216_;
                                    let _e2187 = phi_4399_;
                                    let _e2189 = phi_4400_;
                                    let _e2191 = phi_4401_;
                                    phi_5329_ = _e2183;
                                    phi_5215_ = _e2185;
                                    phi_4402_ = _e2187;
                                    phi_4403_ = (_e675 - 1u);
                                    phi_4404_ = _e2189;
                                    phi_4405_ = _e2191;
                                } else {
                                    phi_5329_ = _e671;
                                    phi_5215_ = _e669;
                                    phi_4402_ = _e709;
                                    phi_4403_ = _e675;
                                    phi_4404_ = _e711;
                                    phi_4405_ = _e713;
                                }
                                let _e2193 = phi_5329_;
                                let _e2195 = phi_5215_;
                                let _e2197 = phi_4402_;
                                let _e2199 = phi_4403_;
                                let _e2201 = phi_4404_;
                                let _e2203 = phi_4405_;
                                phi_5328_ = _e2193;
                                phi_5214_ = _e2195;
                                phi_4406_ = _e2197;
                                phi_4407_ = _e2199;
                                phi_4408_ = _e2201;
                                phi_4409_ = _e2203;
                            } else {
                                phi_5328_ = _e671;
                                phi_5214_ = _e669;
                                phi_4406_ = bool();
                                phi_4407_ = u32();
                                phi_4408_ = u32();
                                phi_4409_ = type_51();
                            }
                            let _e2205 = phi_5328_;
                            let _e2207 = phi_5214_;
                            let _e2209 = phi_4406_;
                            let _e2211 = phi_4407_;
                            let _e2213 = phi_4408_;
                            let _e2215 = phi_4409_;
                            phi_5327_ = _e2205;
                            phi_5213_ = _e2207;
                            phi_1237_ = _e2209;
                            phi_1240_ = _e2211;
                            phi_1242_ = _e2213;
                            phi_1244_ = _e2215;
                            phi_4410_ = _e683;
                        } else {
                            phi_5327_ = _e671;
                            phi_5213_ = _e669;
                            phi_1237_ = bool();
                            phi_1240_ = u32();
                            phi_1242_ = u32();
                            phi_1244_ = type_51();
                            phi_4410_ = false;
                        }
                        let _e2217 = phi_5327_;
                        let _e2219 = phi_5213_;
                        let _e2221 = phi_1237_;
                        let _e2223 = phi_1240_;
                        let _e2225 = phi_1242_;
                        let _e2227 = phi_1244_;
                        let _e2229 = phi_4410_;
                        continue;
                        continuing {
                            phi_5032_ = _e2219;
                            phi_4889_ = _e2217;
                            phi_1236_ = _e2221;
                            phi_1239_ = _e2223;
                            phi_1241_ = _e2225;
                            phi_1243_ = _e2227;
                            phi_5212_ = _e2219;
                            break if !(_e2229);
                        }
                    }
                    let _e2232 = phi_5212_;
                    if _e2232 {
                        break;
                    }
                    phi_4417_ = type_8(0u, 8u);
                    loop {
                        let _e2234 = phi_4417_;
                        if (_e2234.member < _e2234.member_1) {
                            phi_4418_ = type_8((_e2234.member + 1u), _e2234.member_1);
                            phi_4441_ = type_8(1u, _e2234.member);
                        } else {
                            phi_4418_ = _e2234;
                            phi_4441_ = type_8(0u, type_8().member_1);
                        }
                        let _e2247 = phi_4418_;
                        let _e2249 = phi_4441_;
                        let _e2253 = (bitcast<i32>(_e2249.member) != 0i);
                        if _e2253 {
                            let _e2254 = (_e2249.member_1 < 8u);
                            if _e2254 {
                            } else {
                                phi_5309_ = true;
                                break;
                            }
                            let _e2256 = local_9[_e2249.member_1];
                            if (_e2256.member_3 != 4294967295u) {
                                let _e2262 = -(_e530);
                                let _e2263 = bitcast<u32>(_e2256.member);
                                let _e2267 = (bitcast<i32>((_e2263 >> bitcast<u32>(23i))) & 255i);
                                let _e2268 = (_e2267 + _e2262);
                                if (_e2267 == 255i) {
                                    phi_4514_ = _e2256.member;
                                } else {
                                    if (_e2267 > 0i) {
                                        if (_e2268 > 0i) {
                                            let _e2272 = (_e2268 < 255i);
                                            if _e2272 {
                                                phi_4493_ = bitcast<f32>((_e2263 + bitcast<u32>((_e2262 << bitcast<u32>(23i)))));
                                            } else {
                                                phi_4493_ = f32();
                                            }
                                            let _e2279 = phi_4493_;
                                            phi_4495_ = _e2279;
                                            phi_4496_ = select(true, false, _e2272);
                                        } else {
                                            phi_4495_ = f32();
                                            phi_4496_ = true;
                                        }
                                        let _e2282 = phi_4495_;
                                        let _e2284 = phi_4496_;
                                        phi_4497_ = _e2282;
                                        phi_4498_ = _e2284;
                                    } else {
                                        phi_4497_ = f32();
                                        phi_4498_ = true;
                                    }
                                    let _e2286 = phi_4497_;
                                    let _e2288 = phi_4498_;
                                    if _e2288 {
                                        let _e2289 = (_e2263 & 2147483648u);
                                        let _e2296 = ((_e2263 & 8388607u) | (select(0u, 1u, ((_e2263 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                        let _e2300 = (_e2296 == 0u);
                                        if _e2300 {
                                            phi_4835_ = bitcast<f32>(_e2289);
                                        } else {
                                            let _e2305 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2296)), 32u, _e2300) - 8u);
                                            let _e2308 = (_e2296 << bitcast<u32>((_e2305 & 31u)));
                                            let _e2310 = ((_e2268 + select(0i, 1i, (_e2267 == 0i))) - bitcast<i32>(_e2305));
                                            if (_e2310 >= 255i) {
                                                phi_4825_ = bitcast<f32>((_e2289 | 2139095040u));
                                                phi_4826_ = f32();
                                                phi_4827_ = true;
                                            } else {
                                                let _e2312 = (_e2310 > 0i);
                                                if _e2312 {
                                                    phi_4819_ = bitcast<f32>(((_e2289 | (bitcast<u32>(_e2310) << bitcast<u32>(23i))) | (_e2308 & 8388607u)));
                                                    phi_4820_ = f32();
                                                } else {
                                                    if (_e2310 < -24i) {
                                                        phi_4785_ = 26u;
                                                    } else {
                                                        phi_4785_ = bitcast<u32>((1i - _e2310));
                                                    }
                                                    let _e2317 = phi_4785_;
                                                    let _e2318 = (_e2317 & 31u);
                                                    let _e2320 = (_e2308 >> bitcast<u32>(_e2318));
                                                    let _e2324 = (_e2308 & ((1u << bitcast<u32>(_e2318)) - 1u));
                                                    let _e2328 = (1u << bitcast<u32>(((_e2317 - 1u) & 31u)));
                                                    if (_e2324 > _e2328) {
                                                        phi_4806_ = true;
                                                    } else {
                                                        if (_e2324 == _e2328) {
                                                            phi_4803_ = ((_e2320 & 1u) == 1u);
                                                        } else {
                                                            phi_4803_ = false;
                                                        }
                                                        let _e2334 = phi_4803_;
                                                        phi_4806_ = _e2334;
                                                    }
                                                    let _e2336 = phi_4806_;
                                                    phi_4819_ = f32();
                                                    phi_4820_ = bitcast<f32>((_e2289 | (_e2320 + select(0u, 1u, _e2336))));
                                                }
                                                let _e2349 = phi_4819_;
                                                let _e2351 = phi_4820_;
                                                phi_4825_ = _e2349;
                                                phi_4826_ = _e2351;
                                                phi_4827_ = _e2312;
                                            }
                                            let _e2355 = phi_4825_;
                                            let _e2357 = phi_4826_;
                                            let _e2359 = phi_4827_;
                                            phi_4835_ = select(_e2357, _e2355, _e2359);
                                        }
                                        let _e2363 = phi_4835_;
                                        phi_4513_ = _e2363;
                                    } else {
                                        phi_4513_ = _e2286;
                                    }
                                    let _e2365 = phi_4513_;
                                    phi_4514_ = _e2365;
                                }
                                let _e2367 = phi_4514_;
                                let _e2368 = bitcast<u32>(_e2367);
                                if ((_e2368 & 2147483647u) >= 2139095040u) {
                                    phi_4526_ = bitcast<f32>(((_e2368 & 2147483648u) | 2139095039u));
                                } else {
                                    phi_4526_ = _e2367;
                                }
                                let _e2375 = phi_4526_;
                                phi_4531_ = type_24(_e2375, _e2256.member_1, _e2256.member_2, _e2256.member_3);
                            } else {
                                phi_4531_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e2378 = phi_4531_;
                            if _e2254 {
                            } else {
                                phi_5309_ = true;
                                break;
                            }
                            local_9[_e2249.member_1] = type_24(_e2378.member, _e2378.member_1, _e2378.member_2, _e2378.member_3);
                        }
                        continue;
                        continuing {
                            phi_4417_ = _e2247;
                            phi_5309_ = _e2232;
                            break if !(_e2253);
                        }
                    }
                    let _e2386 = phi_5309_;
                    if _e2386 {
                        break;
                    }
                    let _e2387 = local_9;
                    if _e161 {
                    } else {
                        break;
                    }
                    global_6.member[_e159] = array<type_24, 8>(type_24(_e2387[0].member, _e2387[0].member_1, _e2387[0].member_2, _e2387[0].member_3), type_24(_e2387[1].member, _e2387[1].member_1, _e2387[1].member_2, _e2387[1].member_3), type_24(_e2387[2].member, _e2387[2].member_1, _e2387[2].member_2, _e2387[2].member_3), type_24(_e2387[3].member, _e2387[3].member_1, _e2387[3].member_2, _e2387[3].member_3), type_24(_e2387[4].member, _e2387[4].member_1, _e2387[4].member_2, _e2387[4].member_3), type_24(_e2387[5].member, _e2387[5].member_1, _e2387[5].member_2, _e2387[5].member_3), type_24(_e2387[6].member, _e2387[6].member_1, _e2387[6].member_2, _e2387[6].member_3), type_24(_e2387[7].member, _e2387[7].member_1, _e2387[7].member_2, _e2387[7].member_3));
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
