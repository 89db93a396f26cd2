struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_9 {
    member: vec4<u32>,
}

struct type_15 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_17 {
    member: array<type_15>,
}

struct type_26 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_28 {
    member: array<type_26>,
}

struct type_31 {
    member: vec3<f32>,
    member_1: vec3<f32>,
}

struct type_32 {
    member: array<u32, 4>,
    member_1: array<u32, 4>,
}

struct type_34 {
    member: array<type_32>,
}

struct type_37 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_39 {
    member: array<type_37>,
}

struct type_41 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_43 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_45 {
    member: array<type_43>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_9;
@group(0) @binding(3) 
var<storage> global_2: type_17;
@group(0) @binding(1) 
var<uniform> global_3: type_9;
@group(0) @binding(2) 
var<storage> global_4: type_28;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_39;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_45;
@group(0) @binding(6) 
var<storage, read_write> global_7: type_34;

fn function_() {
    var phi_170_: type_26;
    var phi_188_: type_31;
    var phi_206_: type_31;
    var phi_258_: type_4;
    var phi_261_: type_41;
    var phi_263_: u32;
    var phi_259_: type_4;
    var phi_286_: type_4;
    var phi_308_: type_26;
    var phi_317_: bool;
    var phi_335_: type_31;
    var phi_353_: type_31;
    var phi_357_: type_31;
    var phi_385_: f32;
    var phi_418_: u32;
    var phi_420_: u32;
    var phi_421_: bool;
    var phi_443_: u32;
    var phi_444_: u32;
    var phi_479_: u32;
    var phi_481_: u32;
    var phi_482_: bool;
    var phi_522_: u32;
    var phi_523_: u32;
    var phi_567_: f32;
    var phi_600_: u32;
    var phi_602_: u32;
    var phi_603_: bool;
    var phi_625_: u32;
    var phi_626_: u32;
    var phi_661_: u32;
    var phi_663_: u32;
    var phi_664_: bool;
    var phi_704_: u32;
    var phi_705_: u32;
    var phi_751_: f32;
    var phi_784_: u32;
    var phi_786_: u32;
    var phi_787_: bool;
    var phi_809_: u32;
    var phi_810_: u32;
    var phi_845_: u32;
    var phi_847_: u32;
    var phi_848_: bool;
    var phi_888_: u32;
    var phi_889_: u32;
    var phi_935_: f32;
    var phi_968_: u32;
    var phi_970_: u32;
    var phi_971_: bool;
    var phi_993_: u32;
    var phi_994_: u32;
    var phi_1029_: u32;
    var phi_1031_: u32;
    var phi_1032_: bool;
    var phi_1072_: u32;
    var phi_1073_: u32;
    var phi_1138_: u32;
    var phi_1140_: u32;
    var phi_1141_: bool;
    var phi_1189_: f32;
    var phi_1222_: u32;
    var phi_1224_: u32;
    var phi_1225_: bool;
    var phi_1247_: u32;
    var phi_1248_: u32;
    var phi_1283_: u32;
    var phi_1285_: u32;
    var phi_1286_: bool;
    var phi_1326_: u32;
    var phi_1327_: u32;
    var phi_1392_: u32;
    var phi_1394_: u32;
    var phi_1395_: bool;
    var phi_1445_: f32;
    var phi_1478_: u32;
    var phi_1480_: u32;
    var phi_1481_: bool;
    var phi_1503_: u32;
    var phi_1504_: u32;
    var phi_1539_: u32;
    var phi_1541_: u32;
    var phi_1542_: bool;
    var phi_1582_: u32;
    var phi_1583_: u32;
    var phi_1648_: u32;
    var phi_1650_: u32;
    var phi_1651_: bool;
    var phi_1885_: type_41;
    var phi_1886_: u32;
    var phi_262_: type_41;
    var phi_264_: u32;
    var phi_1888_: bool;
    var phi_9765_: bool;
    var phi_1916_: type_31;
    var phi_1938_: type_31;
    var local: type_41;
    var local_1: type_41;
    var phi_1973_: f32;
    var phi_2006_: u32;
    var phi_2008_: u32;
    var phi_2009_: bool;
    var phi_2031_: u32;
    var phi_2032_: u32;
    var phi_2067_: u32;
    var phi_2069_: u32;
    var phi_2070_: bool;
    var phi_2110_: u32;
    var phi_2111_: u32;
    var phi_2155_: f32;
    var phi_2188_: u32;
    var phi_2190_: u32;
    var phi_2191_: bool;
    var phi_2213_: u32;
    var phi_2214_: u32;
    var phi_2249_: u32;
    var phi_2251_: u32;
    var phi_2252_: bool;
    var phi_2292_: u32;
    var phi_2293_: u32;
    var phi_2339_: f32;
    var phi_2372_: u32;
    var phi_2374_: u32;
    var phi_2375_: bool;
    var phi_2397_: u32;
    var phi_2398_: u32;
    var phi_2433_: u32;
    var phi_2435_: u32;
    var phi_2436_: bool;
    var phi_2476_: u32;
    var phi_2477_: u32;
    var phi_2523_: f32;
    var phi_2556_: u32;
    var phi_2558_: u32;
    var phi_2559_: bool;
    var phi_2581_: u32;
    var phi_2582_: u32;
    var phi_2617_: u32;
    var phi_2619_: u32;
    var phi_2620_: bool;
    var phi_2660_: u32;
    var phi_2661_: u32;
    var phi_2726_: u32;
    var phi_2728_: u32;
    var phi_2729_: bool;
    var phi_2777_: f32;
    var phi_2810_: u32;
    var phi_2812_: u32;
    var phi_2813_: bool;
    var phi_2835_: u32;
    var phi_2836_: u32;
    var phi_2871_: u32;
    var phi_2873_: u32;
    var phi_2874_: bool;
    var phi_2914_: u32;
    var phi_2915_: u32;
    var phi_2980_: u32;
    var phi_2982_: u32;
    var phi_2983_: bool;
    var phi_3033_: f32;
    var phi_3066_: u32;
    var phi_3068_: u32;
    var phi_3069_: bool;
    var phi_3091_: u32;
    var phi_3092_: u32;
    var phi_3127_: u32;
    var phi_3129_: u32;
    var phi_3130_: bool;
    var phi_3170_: u32;
    var phi_3171_: u32;
    var phi_3236_: u32;
    var phi_3238_: u32;
    var phi_3239_: bool;
    var phi_3298_: f32;
    var phi_3331_: u32;
    var phi_3333_: u32;
    var phi_3334_: bool;
    var phi_3356_: u32;
    var phi_3357_: u32;
    var phi_3392_: u32;
    var phi_3394_: u32;
    var phi_3395_: bool;
    var phi_3435_: u32;
    var phi_3436_: u32;
    var phi_3480_: f32;
    var phi_3513_: u32;
    var phi_3515_: u32;
    var phi_3516_: bool;
    var phi_3538_: u32;
    var phi_3539_: u32;
    var phi_3574_: u32;
    var phi_3576_: u32;
    var phi_3577_: bool;
    var phi_3617_: u32;
    var phi_3618_: u32;
    var phi_3664_: f32;
    var phi_3697_: u32;
    var phi_3699_: u32;
    var phi_3700_: bool;
    var phi_3722_: u32;
    var phi_3723_: u32;
    var phi_3758_: u32;
    var phi_3760_: u32;
    var phi_3761_: bool;
    var phi_3801_: u32;
    var phi_3802_: u32;
    var phi_3848_: f32;
    var phi_3881_: u32;
    var phi_3883_: u32;
    var phi_3884_: bool;
    var phi_3906_: u32;
    var phi_3907_: u32;
    var phi_3942_: u32;
    var phi_3944_: u32;
    var phi_3945_: bool;
    var phi_3985_: u32;
    var phi_3986_: u32;
    var phi_4051_: u32;
    var phi_4053_: u32;
    var phi_4054_: bool;
    var phi_4102_: f32;
    var phi_4135_: u32;
    var phi_4137_: u32;
    var phi_4138_: bool;
    var phi_4160_: u32;
    var phi_4161_: u32;
    var phi_4196_: u32;
    var phi_4198_: u32;
    var phi_4199_: bool;
    var phi_4239_: u32;
    var phi_4240_: u32;
    var phi_4305_: u32;
    var phi_4307_: u32;
    var phi_4308_: bool;
    var phi_4358_: f32;
    var phi_4391_: u32;
    var phi_4393_: u32;
    var phi_4394_: bool;
    var phi_4416_: u32;
    var phi_4417_: u32;
    var phi_4452_: u32;
    var phi_4454_: u32;
    var phi_4455_: bool;
    var phi_4495_: u32;
    var phi_4496_: u32;
    var phi_4561_: u32;
    var phi_4563_: u32;
    var phi_4564_: bool;
    var phi_5012_: type_4;
    var phi_5013_: type_4;
    var phi_5036_: type_4;
    var phi_5079_: f32;
    var phi_5112_: u32;
    var phi_5114_: u32;
    var phi_5115_: bool;
    var phi_5137_: u32;
    var phi_5138_: u32;
    var phi_5173_: u32;
    var phi_5175_: u32;
    var phi_5176_: bool;
    var phi_5216_: u32;
    var phi_5217_: u32;
    var phi_5253_: u32;
    var phi_5330_: f32;
    var phi_5363_: u32;
    var phi_5365_: u32;
    var phi_5366_: bool;
    var phi_5388_: u32;
    var phi_5389_: u32;
    var phi_5424_: u32;
    var phi_5426_: u32;
    var phi_5427_: bool;
    var phi_5467_: u32;
    var phi_5468_: u32;
    var phi_5504_: u32;
    var phi_5583_: f32;
    var phi_5616_: u32;
    var phi_5618_: u32;
    var phi_5619_: bool;
    var phi_5641_: u32;
    var phi_5642_: u32;
    var phi_5677_: u32;
    var phi_5679_: u32;
    var phi_5680_: bool;
    var phi_5720_: u32;
    var phi_5721_: u32;
    var phi_5757_: u32;
    var phi_5842_: f32;
    var phi_5875_: u32;
    var phi_5877_: u32;
    var phi_5878_: bool;
    var phi_5900_: u32;
    var phi_5901_: u32;
    var phi_5936_: u32;
    var phi_5938_: u32;
    var phi_5939_: bool;
    var phi_5979_: u32;
    var phi_5980_: u32;
    var phi_6016_: u32;
    var phi_6093_: f32;
    var phi_6126_: u32;
    var phi_6128_: u32;
    var phi_6129_: bool;
    var phi_6151_: u32;
    var phi_6152_: u32;
    var phi_6187_: u32;
    var phi_6189_: u32;
    var phi_6190_: bool;
    var phi_6230_: u32;
    var phi_6231_: u32;
    var phi_6267_: u32;
    var phi_6346_: f32;
    var phi_6379_: u32;
    var phi_6381_: u32;
    var phi_6382_: bool;
    var phi_6404_: u32;
    var phi_6405_: u32;
    var phi_6440_: u32;
    var phi_6442_: u32;
    var phi_6443_: bool;
    var phi_6483_: u32;
    var phi_6484_: u32;
    var phi_6520_: u32;
    var phi_6605_: f32;
    var phi_6638_: u32;
    var phi_6640_: u32;
    var phi_6641_: bool;
    var phi_6663_: u32;
    var phi_6664_: u32;
    var phi_6699_: u32;
    var phi_6701_: u32;
    var phi_6702_: bool;
    var phi_6742_: u32;
    var phi_6743_: u32;
    var phi_6779_: u32;
    var phi_6856_: f32;
    var phi_6889_: u32;
    var phi_6891_: u32;
    var phi_6892_: bool;
    var phi_6914_: u32;
    var phi_6915_: u32;
    var phi_6950_: u32;
    var phi_6952_: u32;
    var phi_6953_: bool;
    var phi_6993_: u32;
    var phi_6994_: u32;
    var phi_7030_: u32;
    var phi_7109_: f32;
    var phi_7142_: u32;
    var phi_7144_: u32;
    var phi_7145_: bool;
    var phi_7167_: u32;
    var phi_7168_: u32;
    var phi_7203_: u32;
    var phi_7205_: u32;
    var phi_7206_: bool;
    var phi_7246_: u32;
    var phi_7247_: u32;
    var phi_7283_: u32;
    var phi_9935_: bool;
    var phi_10472_: bool;
    var phi_7378_: type_4;
    var phi_7379_: type_4;
    var phi_7402_: type_4;
    var phi_7445_: f32;
    var phi_7478_: u32;
    var phi_7480_: u32;
    var phi_7481_: bool;
    var phi_7503_: u32;
    var phi_7504_: u32;
    var phi_7539_: u32;
    var phi_7541_: u32;
    var phi_7542_: bool;
    var phi_7582_: u32;
    var phi_7583_: u32;
    var phi_7619_: u32;
    var phi_7696_: f32;
    var phi_7729_: u32;
    var phi_7731_: u32;
    var phi_7732_: bool;
    var phi_7754_: u32;
    var phi_7755_: u32;
    var phi_7790_: u32;
    var phi_7792_: u32;
    var phi_7793_: bool;
    var phi_7833_: u32;
    var phi_7834_: u32;
    var phi_7870_: u32;
    var phi_7949_: f32;
    var phi_7982_: u32;
    var phi_7984_: u32;
    var phi_7985_: bool;
    var phi_8007_: u32;
    var phi_8008_: u32;
    var phi_8043_: u32;
    var phi_8045_: u32;
    var phi_8046_: bool;
    var phi_8086_: u32;
    var phi_8087_: u32;
    var phi_8123_: u32;
    var phi_8208_: f32;
    var phi_8241_: u32;
    var phi_8243_: u32;
    var phi_8244_: bool;
    var phi_8266_: u32;
    var phi_8267_: u32;
    var phi_8302_: u32;
    var phi_8304_: u32;
    var phi_8305_: bool;
    var phi_8345_: u32;
    var phi_8346_: u32;
    var phi_8382_: u32;
    var phi_8459_: f32;
    var phi_8492_: u32;
    var phi_8494_: u32;
    var phi_8495_: bool;
    var phi_8517_: u32;
    var phi_8518_: u32;
    var phi_8553_: u32;
    var phi_8555_: u32;
    var phi_8556_: bool;
    var phi_8596_: u32;
    var phi_8597_: u32;
    var phi_8633_: u32;
    var phi_8712_: f32;
    var phi_8745_: u32;
    var phi_8747_: u32;
    var phi_8748_: bool;
    var phi_8770_: u32;
    var phi_8771_: u32;
    var phi_8806_: u32;
    var phi_8808_: u32;
    var phi_8809_: bool;
    var phi_8849_: u32;
    var phi_8850_: u32;
    var phi_8886_: u32;
    var phi_8971_: f32;
    var phi_9004_: u32;
    var phi_9006_: u32;
    var phi_9007_: bool;
    var phi_9029_: u32;
    var phi_9030_: u32;
    var phi_9065_: u32;
    var phi_9067_: u32;
    var phi_9068_: bool;
    var phi_9108_: u32;
    var phi_9109_: u32;
    var phi_9145_: u32;
    var phi_9222_: f32;
    var phi_9255_: u32;
    var phi_9257_: u32;
    var phi_9258_: bool;
    var phi_9280_: u32;
    var phi_9281_: u32;
    var phi_9316_: u32;
    var phi_9318_: u32;
    var phi_9319_: bool;
    var phi_9359_: u32;
    var phi_9360_: u32;
    var phi_9396_: u32;
    var phi_9475_: f32;
    var phi_9508_: u32;
    var phi_9510_: u32;
    var phi_9511_: bool;
    var phi_9533_: u32;
    var phi_9534_: u32;
    var phi_9569_: u32;
    var phi_9571_: u32;
    var phi_9572_: bool;
    var phi_9612_: u32;
    var phi_9613_: u32;
    var phi_9649_: u32;
    var phi_10468_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e51 = global;
            let _e53 = arrayLength((&global_4.member));
            let _e55 = arrayLength((&global_2.member));
            let _e59 = arrayLength((&global_6.member));
            let _e61 = arrayLength((&global_7.member));
            let _e65 = (_e51.x + (_e51.y * 2097152u));
            let _e68 = global_1.member[0u];
            if (_e65 < _e68) {
                let _e70 = (_e65 < _e53);
                if _e70 {
                    let _e71 = (_e65 < arrayLength((&global_5.member)));
                    if _e71 {
                        let _e74 = global_3.member[0u];
                        let _e75 = (0u < _e53);
                        if _e75 {
                            if _e75 {
                            } else {
                                break;
                            }
                            let _e78 = global_4.member[0u];
                            phi_170_ = _e78;
                        } else {
                            phi_170_ = type_26(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                        }
                        let _e80 = phi_170_;
                        if (_e80.member_1 == 2147483648u) {
                            phi_188_ = type_31(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        } else {
                            phi_188_ = type_31(vec3<f32>(_e80.member[0][0], _e80.member[1][0], _e80.member[2][0]), vec3<f32>(_e80.member[0][2], _e80.member[1][2], _e80.member[2][2]));
                        }
                        let _e99 = phi_188_;
                        if (_e80.member_2 == 2147483648u) {
                            phi_206_ = _e99;
                        } else {
                            phi_206_ = type_31(vec3<f32>(_e80.member[0][1], _e80.member[1][1], _e80.member[2][1]), vec3<f32>(_e80.member[0][3], _e80.member[1][3], _e80.member[2][3]));
                        }
                        let _e118 = phi_206_;
                        phi_258_ = type_4(0u, 128u);
                        phi_261_ = type_41(array<f32, 3>(select(_e118.member.x, _e99.member.x, (_e99.member.x < _e118.member.x)), select(_e118.member.y, _e99.member.y, (_e99.member.y < _e118.member.y)), select(_e118.member.z, _e99.member.z, (_e99.member.z < _e118.member.z))), array<f32, 3>(select(_e118.member_1.x, _e99.member_1.x, (_e99.member_1.x > _e118.member_1.x)), select(_e118.member_1.y, _e99.member_1.y, (_e99.member_1.y > _e118.member_1.y)), select(_e118.member_1.z, _e99.member_1.z, (_e99.member_1.z > _e118.member_1.z))));
                        phi_263_ = 0u;
                        loop {
                            let _e151 = phi_258_;
                            let _e153 = phi_261_;
                            let _e155 = phi_263_;
                            local = _e153;
                            local_1 = _e153;
                            if (_e151.member < _e151.member_1) {
                                phi_259_ = type_4((_e151.member + 1u), _e151.member_1);
                                phi_286_ = type_4(1u, _e151.member);
                            } else {
                                phi_259_ = _e151;
                                phi_286_ = type_4(0u, type_4().member_1);
                            }
                            let _e168 = phi_259_;
                            let _e170 = phi_286_;
                            if (bitcast<i32>(_e170.member) != 0i) {
                                let _e174 = (_e155 == _e65);
                                if _e174 {
                                    phi_1885_ = type_41();
                                    phi_1886_ = u32();
                                } else {
                                    let _e175 = (_e155 < _e53);
                                    if _e175 {
                                        if _e175 {
                                        } else {
                                            phi_9765_ = true;
                                            break;
                                        }
                                        let _e178 = global_4.member[_e155];
                                        phi_308_ = _e178;
                                    } else {
                                        phi_308_ = type_26(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                                    }
                                    let _e180 = phi_308_;
                                    if ((_e180.member_1 & 2147483648u) != 0u) {
                                        phi_317_ = false;
                                    } else {
                                        phi_317_ = (_e65 <= _e180.member_1);
                                    }
                                    let _e187 = phi_317_;
                                    if (_e180.member_1 == 2147483648u) {
                                        phi_335_ = type_31(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                    } else {
                                        phi_335_ = type_31(vec3<f32>(_e180.member[0][0], _e180.member[1][0], _e180.member[2][0]), vec3<f32>(_e180.member[0][2], _e180.member[1][2], _e180.member[2][2]));
                                    }
                                    let _e205 = phi_335_;
                                    if (_e180.member_2 == 2147483648u) {
                                        phi_353_ = _e205;
                                    } else {
                                        phi_353_ = type_31(vec3<f32>(_e180.member[0][1], _e180.member[1][1], _e180.member[2][1]), vec3<f32>(_e180.member[0][3], _e180.member[1][3], _e180.member[2][3]));
                                    }
                                    let _e223 = phi_353_;
                                    if _e187 {
                                        phi_357_ = _e205;
                                    } else {
                                        phi_357_ = _e223;
                                    }
                                    let _e225 = phi_357_;
                                    let _e246 = (_e225.member.x - _e153.member[0]);
                                    let _e251 = bitcast<f32>((bitcast<u32>(((_e153.member_1[0] - _e153.member[0]) * 0.0009775171f)) ^ _e74));
                                    let _e252 = (_e251 > 0f);
                                    if _e252 {
                                        phi_385_ = (_e246 / _e251);
                                    } else {
                                        phi_385_ = 0f;
                                    }
                                    let _e255 = phi_385_;
                                    let _e257 = select(1023f, _e255, (_e255 < 1023f));
                                    let _e265 = bitcast<u32>(select(0i, select(select(i32(_e257), i32(-2147483648), (_e257 < -2147483600f)), 2147483647i, (_e257 > 2147483500f)), (_e257 == _e257)));
                                    if (_e265 > 0u) {
                                        let _e274 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e265)) - 8388608f) * _e251)) ^ _e74)) > _e246);
                                        if _e274 {
                                            phi_418_ = (_e265 - 1u);
                                        } else {
                                            phi_418_ = u32();
                                        }
                                        let _e277 = phi_418_;
                                        phi_420_ = _e277;
                                        phi_421_ = select(true, false, _e274);
                                    } else {
                                        phi_420_ = u32();
                                        phi_421_ = true;
                                    }
                                    let _e280 = phi_420_;
                                    let _e282 = phi_421_;
                                    if _e282 {
                                        if (_e265 < 1023u) {
                                            let _e284 = (_e265 + 1u);
                                            phi_443_ = select(_e265, _e284, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e284)) - 8388608f) * _e251)) ^ _e74)) <= _e246));
                                        } else {
                                            phi_443_ = _e265;
                                        }
                                        let _e295 = phi_443_;
                                        phi_444_ = _e295;
                                    } else {
                                        phi_444_ = _e280;
                                    }
                                    let _e297 = phi_444_;
                                    if (_e297 > 0u) {
                                        let _e306 = (_e153.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e297)) - 8388608f) * _e251)) ^ _e74)));
                                        let _e311 = (select(select(_e153.member_1[0], _e306, (_e306 < _e153.member_1[0])), _e153.member_1[0], (_e297 == 1023u)) > _e225.member.x);
                                        if _e311 {
                                            phi_479_ = (_e297 - 1u);
                                        } else {
                                            phi_479_ = u32();
                                        }
                                        let _e314 = phi_479_;
                                        phi_481_ = _e314;
                                        phi_482_ = select(true, false, _e311);
                                    } else {
                                        phi_481_ = u32();
                                        phi_482_ = true;
                                    }
                                    let _e317 = phi_481_;
                                    let _e319 = phi_482_;
                                    if _e319 {
                                        if (_e297 < 1023u) {
                                            let _e321 = (_e297 + 1u);
                                            let _e329 = (_e153.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e321)) - 8388608f) * _e251)) ^ _e74)));
                                            phi_522_ = select(_e297, _e321, (select(select(_e153.member_1[0], _e329, (_e329 < _e153.member_1[0])), _e153.member_1[0], (_e321 == 1023u)) <= _e225.member.x));
                                        } else {
                                            phi_522_ = _e297;
                                        }
                                        let _e337 = phi_522_;
                                        phi_523_ = _e337;
                                    } else {
                                        phi_523_ = _e317;
                                    }
                                    let _e339 = phi_523_;
                                    let _e347 = (_e153.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e339)) - 8388608f) * _e251)) ^ _e74)));
                                    let _e354 = (_e225.member.y - _e153.member[1]);
                                    let _e359 = bitcast<f32>((bitcast<u32>(((_e153.member_1[1] - _e153.member[1]) * 0.0009775171f)) ^ _e74));
                                    let _e360 = (_e359 > 0f);
                                    if _e360 {
                                        phi_567_ = (_e354 / _e359);
                                    } else {
                                        phi_567_ = 0f;
                                    }
                                    let _e363 = phi_567_;
                                    let _e365 = select(1023f, _e363, (_e363 < 1023f));
                                    let _e373 = bitcast<u32>(select(0i, select(select(i32(_e365), i32(-2147483648), (_e365 < -2147483600f)), 2147483647i, (_e365 > 2147483500f)), (_e365 == _e365)));
                                    if (_e373 > 0u) {
                                        let _e382 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e373)) - 8388608f) * _e359)) ^ _e74)) > _e354);
                                        if _e382 {
                                            phi_600_ = (_e373 - 1u);
                                        } else {
                                            phi_600_ = u32();
                                        }
                                        let _e385 = phi_600_;
                                        phi_602_ = _e385;
                                        phi_603_ = select(true, false, _e382);
                                    } else {
                                        phi_602_ = u32();
                                        phi_603_ = true;
                                    }
                                    let _e388 = phi_602_;
                                    let _e390 = phi_603_;
                                    if _e390 {
                                        if (_e373 < 1023u) {
                                            let _e392 = (_e373 + 1u);
                                            phi_625_ = select(_e373, _e392, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e392)) - 8388608f) * _e359)) ^ _e74)) <= _e354));
                                        } else {
                                            phi_625_ = _e373;
                                        }
                                        let _e403 = phi_625_;
                                        phi_626_ = _e403;
                                    } else {
                                        phi_626_ = _e388;
                                    }
                                    let _e405 = phi_626_;
                                    if (_e405 > 0u) {
                                        let _e414 = (_e153.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e405)) - 8388608f) * _e359)) ^ _e74)));
                                        let _e419 = (select(select(_e153.member_1[1], _e414, (_e414 < _e153.member_1[1])), _e153.member_1[1], (_e405 == 1023u)) > _e225.member.y);
                                        if _e419 {
                                            phi_661_ = (_e405 - 1u);
                                        } else {
                                            phi_661_ = u32();
                                        }
                                        let _e422 = phi_661_;
                                        phi_663_ = _e422;
                                        phi_664_ = select(true, false, _e419);
                                    } else {
                                        phi_663_ = u32();
                                        phi_664_ = true;
                                    }
                                    let _e425 = phi_663_;
                                    let _e427 = phi_664_;
                                    if _e427 {
                                        if (_e405 < 1023u) {
                                            let _e429 = (_e405 + 1u);
                                            let _e437 = (_e153.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e429)) - 8388608f) * _e359)) ^ _e74)));
                                            phi_704_ = select(_e405, _e429, (select(select(_e153.member_1[1], _e437, (_e437 < _e153.member_1[1])), _e153.member_1[1], (_e429 == 1023u)) <= _e225.member.y));
                                        } else {
                                            phi_704_ = _e405;
                                        }
                                        let _e445 = phi_704_;
                                        phi_705_ = _e445;
                                    } else {
                                        phi_705_ = _e425;
                                    }
                                    let _e447 = phi_705_;
                                    let _e455 = (_e153.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e447)) - 8388608f) * _e359)) ^ _e74)));
                                    let _e465 = (_e225.member.z - _e153.member[2]);
                                    let _e470 = bitcast<f32>((bitcast<u32>(((_e153.member_1[2] - _e153.member[2]) * 0.0009775171f)) ^ _e74));
                                    let _e471 = (_e470 > 0f);
                                    if _e471 {
                                        phi_751_ = (_e465 / _e470);
                                    } else {
                                        phi_751_ = 0f;
                                    }
                                    let _e474 = phi_751_;
                                    let _e476 = select(1023f, _e474, (_e474 < 1023f));
                                    let _e484 = bitcast<u32>(select(0i, select(select(i32(_e476), i32(-2147483648), (_e476 < -2147483600f)), 2147483647i, (_e476 > 2147483500f)), (_e476 == _e476)));
                                    if (_e484 > 0u) {
                                        let _e493 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e484)) - 8388608f) * _e470)) ^ _e74)) > _e465);
                                        if _e493 {
                                            phi_784_ = (_e484 - 1u);
                                        } else {
                                            phi_784_ = u32();
                                        }
                                        let _e496 = phi_784_;
                                        phi_786_ = _e496;
                                        phi_787_ = select(true, false, _e493);
                                    } else {
                                        phi_786_ = u32();
                                        phi_787_ = true;
                                    }
                                    let _e499 = phi_786_;
                                    let _e501 = phi_787_;
                                    if _e501 {
                                        if (_e484 < 1023u) {
                                            let _e503 = (_e484 + 1u);
                                            phi_809_ = select(_e484, _e503, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e503)) - 8388608f) * _e470)) ^ _e74)) <= _e465));
                                        } else {
                                            phi_809_ = _e484;
                                        }
                                        let _e514 = phi_809_;
                                        phi_810_ = _e514;
                                    } else {
                                        phi_810_ = _e499;
                                    }
                                    let _e516 = phi_810_;
                                    if (_e516 > 0u) {
                                        let _e525 = (_e153.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e516)) - 8388608f) * _e470)) ^ _e74)));
                                        let _e530 = (select(select(_e153.member_1[2], _e525, (_e525 < _e153.member_1[2])), _e153.member_1[2], (_e516 == 1023u)) > _e225.member.z);
                                        if _e530 {
                                            phi_845_ = (_e516 - 1u);
                                        } else {
                                            phi_845_ = u32();
                                        }
                                        let _e533 = phi_845_;
                                        phi_847_ = _e533;
                                        phi_848_ = select(true, false, _e530);
                                    } else {
                                        phi_847_ = u32();
                                        phi_848_ = true;
                                    }
                                    let _e536 = phi_847_;
                                    let _e538 = phi_848_;
                                    if _e538 {
                                        if (_e516 < 1023u) {
                                            let _e540 = (_e516 + 1u);
                                            let _e548 = (_e153.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e540)) - 8388608f) * _e470)) ^ _e74)));
                                            phi_888_ = select(_e516, _e540, (select(select(_e153.member_1[2], _e548, (_e548 < _e153.member_1[2])), _e153.member_1[2], (_e540 == 1023u)) <= _e225.member.z));
                                        } else {
                                            phi_888_ = _e516;
                                        }
                                        let _e556 = phi_888_;
                                        phi_889_ = _e556;
                                    } else {
                                        phi_889_ = _e536;
                                    }
                                    let _e558 = phi_889_;
                                    let _e566 = (_e153.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e558)) - 8388608f) * _e470)) ^ _e74)));
                                    let _e575 = ((select(_e339, 0u, (select(select(_e153.member_1[0], _e347, (_e347 < _e153.member_1[0])), _e153.member_1[0], (_e339 == 1023u)) > _e225.member.x)) | (select(_e447, 0u, (select(select(_e153.member_1[1], _e455, (_e455 < _e153.member_1[1])), _e153.member_1[1], (_e447 == 1023u)) > _e225.member.y)) << bitcast<u32>(10i))) | (select(_e558, 0u, (select(select(_e153.member_1[2], _e566, (_e566 < _e153.member_1[2])), _e153.member_1[2], (_e558 == 1023u)) > _e225.member.z)) << bitcast<u32>(20i)));
                                    let _e576 = (_e225.member_1.x - _e153.member[0]);
                                    if _e252 {
                                        phi_935_ = (_e576 / _e251);
                                    } else {
                                        phi_935_ = 0f;
                                    }
                                    let _e579 = phi_935_;
                                    let _e581 = select(1023f, _e579, (_e579 < 1023f));
                                    let _e589 = bitcast<u32>(select(0i, select(select(i32(_e581), i32(-2147483648), (_e581 < -2147483600f)), 2147483647i, (_e581 > 2147483500f)), (_e581 == _e581)));
                                    if (_e589 > 0u) {
                                        let _e598 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e589)) - 8388608f) * _e251)) ^ _e74)) > _e576);
                                        if _e598 {
                                            phi_968_ = (_e589 - 1u);
                                        } else {
                                            phi_968_ = u32();
                                        }
                                        let _e601 = phi_968_;
                                        phi_970_ = _e601;
                                        phi_971_ = select(true, false, _e598);
                                    } else {
                                        phi_970_ = u32();
                                        phi_971_ = true;
                                    }
                                    let _e604 = phi_970_;
                                    let _e606 = phi_971_;
                                    if _e606 {
                                        if (_e589 < 1023u) {
                                            let _e608 = (_e589 + 1u);
                                            phi_993_ = select(_e589, _e608, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e608)) - 8388608f) * _e251)) ^ _e74)) <= _e576));
                                        } else {
                                            phi_993_ = _e589;
                                        }
                                        let _e619 = phi_993_;
                                        phi_994_ = _e619;
                                    } else {
                                        phi_994_ = _e604;
                                    }
                                    let _e621 = phi_994_;
                                    if (_e621 > 0u) {
                                        let _e630 = (_e153.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e621)) - 8388608f) * _e251)) ^ _e74)));
                                        let _e635 = (select(select(_e153.member_1[0], _e630, (_e630 < _e153.member_1[0])), _e153.member_1[0], (_e621 == 1023u)) > _e225.member_1.x);
                                        if _e635 {
                                            phi_1029_ = (_e621 - 1u);
                                        } else {
                                            phi_1029_ = u32();
                                        }
                                        let _e638 = phi_1029_;
                                        phi_1031_ = _e638;
                                        phi_1032_ = select(true, false, _e635);
                                    } else {
                                        phi_1031_ = u32();
                                        phi_1032_ = true;
                                    }
                                    let _e641 = phi_1031_;
                                    let _e643 = phi_1032_;
                                    if _e643 {
                                        if (_e621 < 1023u) {
                                            let _e645 = (_e621 + 1u);
                                            let _e653 = (_e153.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e645)) - 8388608f) * _e251)) ^ _e74)));
                                            phi_1072_ = select(_e621, _e645, (select(select(_e153.member_1[0], _e653, (_e653 < _e153.member_1[0])), _e153.member_1[0], (_e645 == 1023u)) <= _e225.member_1.x));
                                        } else {
                                            phi_1072_ = _e621;
                                        }
                                        let _e661 = phi_1072_;
                                        phi_1073_ = _e661;
                                    } else {
                                        phi_1073_ = _e641;
                                    }
                                    let _e663 = phi_1073_;
                                    let _e671 = (_e153.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e663)) - 8388608f) * _e251)) ^ _e74)));
                                    let _e677 = select(_e663, 0u, (select(select(_e153.member_1[0], _e671, (_e671 < _e153.member_1[0])), _e153.member_1[0], (_e663 == 1023u)) > _e225.member_1.x));
                                    if (_e677 < 1023u) {
                                        let _e686 = (_e153.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e677)) - 8388608f) * _e251)) ^ _e74)));
                                        let _e691 = (select(select(_e153.member_1[0], _e686, (_e686 < _e153.member_1[0])), _e153.member_1[0], (_e677 == 1023u)) < _e225.member_1.x);
                                        if _e691 {
                                            phi_1138_ = (_e677 + 1u);
                                        } else {
                                            phi_1138_ = u32();
                                        }
                                        let _e694 = phi_1138_;
                                        phi_1140_ = _e694;
                                        phi_1141_ = select(true, false, _e691);
                                    } else {
                                        phi_1140_ = u32();
                                        phi_1141_ = true;
                                    }
                                    let _e697 = phi_1140_;
                                    let _e699 = phi_1141_;
                                    let _e700 = select(_e697, _e677, _e699);
                                    let _e708 = (_e153.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e700)) - 8388608f) * _e251)) ^ _e74)));
                                    let _e715 = (_e225.member_1.y - _e153.member[1]);
                                    if _e360 {
                                        phi_1189_ = (_e715 / _e359);
                                    } else {
                                        phi_1189_ = 0f;
                                    }
                                    let _e718 = phi_1189_;
                                    let _e720 = select(1023f, _e718, (_e718 < 1023f));
                                    let _e728 = bitcast<u32>(select(0i, select(select(i32(_e720), i32(-2147483648), (_e720 < -2147483600f)), 2147483647i, (_e720 > 2147483500f)), (_e720 == _e720)));
                                    if (_e728 > 0u) {
                                        let _e737 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e728)) - 8388608f) * _e359)) ^ _e74)) > _e715);
                                        if _e737 {
                                            phi_1222_ = (_e728 - 1u);
                                        } else {
                                            phi_1222_ = u32();
                                        }
                                        let _e740 = phi_1222_;
                                        phi_1224_ = _e740;
                                        phi_1225_ = select(true, false, _e737);
                                    } else {
                                        phi_1224_ = u32();
                                        phi_1225_ = true;
                                    }
                                    let _e743 = phi_1224_;
                                    let _e745 = phi_1225_;
                                    if _e745 {
                                        if (_e728 < 1023u) {
                                            let _e747 = (_e728 + 1u);
                                            phi_1247_ = select(_e728, _e747, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e747)) - 8388608f) * _e359)) ^ _e74)) <= _e715));
                                        } else {
                                            phi_1247_ = _e728;
                                        }
                                        let _e758 = phi_1247_;
                                        phi_1248_ = _e758;
                                    } else {
                                        phi_1248_ = _e743;
                                    }
                                    let _e760 = phi_1248_;
                                    if (_e760 > 0u) {
                                        let _e769 = (_e153.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e760)) - 8388608f) * _e359)) ^ _e74)));
                                        let _e774 = (select(select(_e153.member_1[1], _e769, (_e769 < _e153.member_1[1])), _e153.member_1[1], (_e760 == 1023u)) > _e225.member_1.y);
                                        if _e774 {
                                            phi_1283_ = (_e760 - 1u);
                                        } else {
                                            phi_1283_ = u32();
                                        }
                                        let _e777 = phi_1283_;
                                        phi_1285_ = _e777;
                                        phi_1286_ = select(true, false, _e774);
                                    } else {
                                        phi_1285_ = u32();
                                        phi_1286_ = true;
                                    }
                                    let _e780 = phi_1285_;
                                    let _e782 = phi_1286_;
                                    if _e782 {
                                        if (_e760 < 1023u) {
                                            let _e784 = (_e760 + 1u);
                                            let _e792 = (_e153.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e784)) - 8388608f) * _e359)) ^ _e74)));
                                            phi_1326_ = select(_e760, _e784, (select(select(_e153.member_1[1], _e792, (_e792 < _e153.member_1[1])), _e153.member_1[1], (_e784 == 1023u)) <= _e225.member_1.y));
                                        } else {
                                            phi_1326_ = _e760;
                                        }
                                        let _e800 = phi_1326_;
                                        phi_1327_ = _e800;
                                    } else {
                                        phi_1327_ = _e780;
                                    }
                                    let _e802 = phi_1327_;
                                    let _e810 = (_e153.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e802)) - 8388608f) * _e359)) ^ _e74)));
                                    let _e816 = select(_e802, 0u, (select(select(_e153.member_1[1], _e810, (_e810 < _e153.member_1[1])), _e153.member_1[1], (_e802 == 1023u)) > _e225.member_1.y));
                                    if (_e816 < 1023u) {
                                        let _e825 = (_e153.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e816)) - 8388608f) * _e359)) ^ _e74)));
                                        let _e830 = (select(select(_e153.member_1[1], _e825, (_e825 < _e153.member_1[1])), _e153.member_1[1], (_e816 == 1023u)) < _e225.member_1.y);
                                        if _e830 {
                                            phi_1392_ = (_e816 + 1u);
                                        } else {
                                            phi_1392_ = u32();
                                        }
                                        let _e833 = phi_1392_;
                                        phi_1394_ = _e833;
                                        phi_1395_ = select(true, false, _e830);
                                    } else {
                                        phi_1394_ = u32();
                                        phi_1395_ = true;
                                    }
                                    let _e836 = phi_1394_;
                                    let _e838 = phi_1395_;
                                    let _e839 = select(_e836, _e816, _e838);
                                    let _e847 = (_e153.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e839)) - 8388608f) * _e359)) ^ _e74)));
                                    let _e857 = (_e225.member_1.z - _e153.member[2]);
                                    if _e471 {
                                        phi_1445_ = (_e857 / _e470);
                                    } else {
                                        phi_1445_ = 0f;
                                    }
                                    let _e860 = phi_1445_;
                                    let _e862 = select(1023f, _e860, (_e860 < 1023f));
                                    let _e870 = bitcast<u32>(select(0i, select(select(i32(_e862), i32(-2147483648), (_e862 < -2147483600f)), 2147483647i, (_e862 > 2147483500f)), (_e862 == _e862)));
                                    if (_e870 > 0u) {
                                        let _e879 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e870)) - 8388608f) * _e470)) ^ _e74)) > _e857);
                                        if _e879 {
                                            phi_1478_ = (_e870 - 1u);
                                        } else {
                                            phi_1478_ = u32();
                                        }
                                        let _e882 = phi_1478_;
                                        phi_1480_ = _e882;
                                        phi_1481_ = select(true, false, _e879);
                                    } else {
                                        phi_1480_ = u32();
                                        phi_1481_ = true;
                                    }
                                    let _e885 = phi_1480_;
                                    let _e887 = phi_1481_;
                                    if _e887 {
                                        if (_e870 < 1023u) {
                                            let _e889 = (_e870 + 1u);
                                            phi_1503_ = select(_e870, _e889, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e889)) - 8388608f) * _e470)) ^ _e74)) <= _e857));
                                        } else {
                                            phi_1503_ = _e870;
                                        }
                                        let _e900 = phi_1503_;
                                        phi_1504_ = _e900;
                                    } else {
                                        phi_1504_ = _e885;
                                    }
                                    let _e902 = phi_1504_;
                                    if (_e902 > 0u) {
                                        let _e911 = (_e153.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e902)) - 8388608f) * _e470)) ^ _e74)));
                                        let _e916 = (select(select(_e153.member_1[2], _e911, (_e911 < _e153.member_1[2])), _e153.member_1[2], (_e902 == 1023u)) > _e225.member_1.z);
                                        if _e916 {
                                            phi_1539_ = (_e902 - 1u);
                                        } else {
                                            phi_1539_ = u32();
                                        }
                                        let _e919 = phi_1539_;
                                        phi_1541_ = _e919;
                                        phi_1542_ = select(true, false, _e916);
                                    } else {
                                        phi_1541_ = u32();
                                        phi_1542_ = true;
                                    }
                                    let _e922 = phi_1541_;
                                    let _e924 = phi_1542_;
                                    if _e924 {
                                        if (_e902 < 1023u) {
                                            let _e926 = (_e902 + 1u);
                                            let _e934 = (_e153.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e926)) - 8388608f) * _e470)) ^ _e74)));
                                            phi_1582_ = select(_e902, _e926, (select(select(_e153.member_1[2], _e934, (_e934 < _e153.member_1[2])), _e153.member_1[2], (_e926 == 1023u)) <= _e225.member_1.z));
                                        } else {
                                            phi_1582_ = _e902;
                                        }
                                        let _e942 = phi_1582_;
                                        phi_1583_ = _e942;
                                    } else {
                                        phi_1583_ = _e922;
                                    }
                                    let _e944 = phi_1583_;
                                    let _e952 = (_e153.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e944)) - 8388608f) * _e470)) ^ _e74)));
                                    let _e958 = select(_e944, 0u, (select(select(_e153.member_1[2], _e952, (_e952 < _e153.member_1[2])), _e153.member_1[2], (_e944 == 1023u)) > _e225.member_1.z));
                                    if (_e958 < 1023u) {
                                        let _e967 = (_e153.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e958)) - 8388608f) * _e470)) ^ _e74)));
                                        let _e972 = (select(select(_e153.member_1[2], _e967, (_e967 < _e153.member_1[2])), _e153.member_1[2], (_e958 == 1023u)) < _e225.member_1.z);
                                        if _e972 {
                                            phi_1648_ = (_e958 + 1u);
                                        } else {
                                            phi_1648_ = u32();
                                        }
                                        let _e975 = phi_1648_;
                                        phi_1650_ = _e975;
                                        phi_1651_ = select(true, false, _e972);
                                    } else {
                                        phi_1650_ = u32();
                                        phi_1651_ = true;
                                    }
                                    let _e978 = phi_1650_;
                                    let _e980 = phi_1651_;
                                    let _e981 = select(_e978, _e958, _e980);
                                    let _e989 = (_e153.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e981)) - 8388608f) * _e470)) ^ _e74)));
                                    let _e998 = ((select(_e700, 1023u, (select(select(_e153.member_1[0], _e708, (_e708 < _e153.member_1[0])), _e153.member_1[0], (_e700 == 1023u)) < _e225.member_1.x)) | (select(_e839, 1023u, (select(select(_e153.member_1[1], _e847, (_e847 < _e153.member_1[1])), _e153.member_1[1], (_e839 == 1023u)) < _e225.member_1.y)) << bitcast<u32>(10i))) | (select(_e981, 1023u, (select(select(_e153.member_1[2], _e989, (_e989 < _e153.member_1[2])), _e153.member_1[2], (_e981 == 1023u)) < _e225.member_1.z)) << bitcast<u32>(20i)));
                                    let _e999 = (_e575 & 1023u);
                                    let _e1007 = (_e153.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e999)) - 8388608f) * _e251)) ^ _e74)));
                                    let _e1014 = ((_e575 >> bitcast<u32>(10u)) & 1023u);
                                    let _e1022 = (_e153.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1014)) - 8388608f) * _e359)) ^ _e74)));
                                    let _e1029 = ((_e575 >> bitcast<u32>(20u)) & 1023u);
                                    let _e1037 = (_e153.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1029)) - 8388608f) * _e470)) ^ _e74)));
                                    let _e1043 = (_e998 & 1023u);
                                    let _e1051 = (_e153.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1043)) - 8388608f) * _e251)) ^ _e74)));
                                    let _e1058 = ((_e998 >> bitcast<u32>(10u)) & 1023u);
                                    let _e1066 = (_e153.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1058)) - 8388608f) * _e359)) ^ _e74)));
                                    let _e1073 = ((_e998 >> bitcast<u32>(20u)) & 1023u);
                                    let _e1081 = (_e153.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1073)) - 8388608f) * _e470)) ^ _e74)));
                                    phi_1885_ = type_41(array<f32, 3>(select(select(_e153.member_1[0], _e1007, (_e1007 < _e153.member_1[0])), _e153.member_1[0], (_e999 == 1023u)), select(select(_e153.member_1[1], _e1022, (_e1022 < _e153.member_1[1])), _e153.member_1[1], (_e1014 == 1023u)), select(select(_e153.member_1[2], _e1037, (_e1037 < _e153.member_1[2])), _e153.member_1[2], (_e1029 == 1023u))), array<f32, 3>(select(select(_e153.member_1[0], _e1051, (_e1051 < _e153.member_1[0])), _e153.member_1[0], (_e1043 == 1023u)), select(select(_e153.member_1[1], _e1066, (_e1066 < _e153.member_1[1])), _e153.member_1[1], (_e1058 == 1023u)), select(select(_e153.member_1[2], _e1081, (_e1081 < _e153.member_1[2])), _e153.member_1[2], (_e1073 == 1023u))));
                                    phi_1886_ = select(_e180.member_2, _e180.member_1, _e187);
                                }
                                let _e1090 = phi_1885_;
                                let _e1092 = phi_1886_;
                                phi_262_ = _e1090;
                                phi_264_ = _e1092;
                                phi_1888_ = select(true, false, _e174);
                            } else {
                                phi_262_ = type_41();
                                phi_264_ = u32();
                                phi_1888_ = false;
                            }
                            let _e1095 = phi_262_;
                            let _e1097 = phi_264_;
                            let _e1099 = phi_1888_;
                            continue;
                            continuing {
                                phi_258_ = _e168;
                                phi_261_ = _e1095;
                                phi_263_ = _e1097;
                                phi_9765_ = false;
                                break if !(_e1099);
                            }
                        }
                        let _e1102 = phi_9765_;
                        if _e1102 {
                            break;
                        }
                        if _e70 {
                        } else {
                            break;
                        }
                        let _e1106 = global_4.member[_e65].member_1;
                        if (_e1106 == 2147483648u) {
                            phi_1916_ = type_31(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        } else {
                            let _e1112 = global_4.member[_e65].member[0u];
                            let _e1117 = global_4.member[_e65].member[1u];
                            let _e1122 = global_4.member[_e65].member[2u];
                            phi_1916_ = type_31(vec3<f32>(_e1112[0], _e1117[0], _e1122[0]), vec3<f32>(_e1112[2], _e1117[2], _e1122[2]));
                        }
                        let _e1133 = phi_1916_;
                        let _e1137 = global_4.member[_e65].member_2;
                        if (_e1137 == 2147483648u) {
                            phi_1938_ = _e1133;
                        } else {
                            let _e1143 = global_4.member[_e65].member[0u];
                            let _e1148 = global_4.member[_e65].member[1u];
                            let _e1153 = global_4.member[_e65].member[2u];
                            phi_1938_ = type_31(vec3<f32>(_e1143[1], _e1148[1], _e1153[1]), vec3<f32>(_e1143[3], _e1148[3], _e1153[3]));
                        }
                        let _e1164 = phi_1938_;
                        let _e1190 = local;
                        let _e1193 = local_1;
                        let _e1201 = (_e1133.member.x - _e1190.member[0]);
                        let _e1206 = bitcast<f32>((bitcast<u32>(((_e1193.member_1[0] - _e1190.member[0]) * 0.0009775171f)) ^ _e74));
                        let _e1207 = (_e1206 > 0f);
                        if _e1207 {
                            phi_1973_ = (_e1201 / _e1206);
                        } else {
                            phi_1973_ = 0f;
                        }
                        let _e1210 = phi_1973_;
                        let _e1212 = select(1023f, _e1210, (_e1210 < 1023f));
                        let _e1220 = bitcast<u32>(select(0i, select(select(i32(_e1212), i32(-2147483648), (_e1212 < -2147483600f)), 2147483647i, (_e1212 > 2147483500f)), (_e1212 == _e1212)));
                        if (_e1220 > 0u) {
                            let _e1229 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1220)) - 8388608f) * _e1206)) ^ _e74)) > _e1201);
                            if _e1229 {
                                phi_2006_ = (_e1220 - 1u);
                            } else {
                                phi_2006_ = u32();
                            }
                            let _e1232 = phi_2006_;
                            phi_2008_ = _e1232;
                            phi_2009_ = select(true, false, _e1229);
                        } else {
                            phi_2008_ = u32();
                            phi_2009_ = true;
                        }
                        let _e1235 = phi_2008_;
                        let _e1237 = phi_2009_;
                        if _e1237 {
                            if (_e1220 < 1023u) {
                                let _e1239 = (_e1220 + 1u);
                                phi_2031_ = select(_e1220, _e1239, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1239)) - 8388608f) * _e1206)) ^ _e74)) <= _e1201));
                            } else {
                                phi_2031_ = _e1220;
                            }
                            let _e1250 = phi_2031_;
                            phi_2032_ = _e1250;
                        } else {
                            phi_2032_ = _e1235;
                        }
                        let _e1252 = phi_2032_;
                        if (_e1252 > 0u) {
                            let _e1261 = (_e1190.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1252)) - 8388608f) * _e1206)) ^ _e74)));
                            let _e1266 = (select(select(_e1193.member_1[0], _e1261, (_e1261 < _e1193.member_1[0])), _e1193.member_1[0], (_e1252 == 1023u)) > _e1133.member.x);
                            if _e1266 {
                                phi_2067_ = (_e1252 - 1u);
                            } else {
                                phi_2067_ = u32();
                            }
                            let _e1269 = phi_2067_;
                            phi_2069_ = _e1269;
                            phi_2070_ = select(true, false, _e1266);
                        } else {
                            phi_2069_ = u32();
                            phi_2070_ = true;
                        }
                        let _e1272 = phi_2069_;
                        let _e1274 = phi_2070_;
                        if _e1274 {
                            if (_e1252 < 1023u) {
                                let _e1276 = (_e1252 + 1u);
                                let _e1284 = (_e1190.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1276)) - 8388608f) * _e1206)) ^ _e74)));
                                phi_2110_ = select(_e1252, _e1276, (select(select(_e1193.member_1[0], _e1284, (_e1284 < _e1193.member_1[0])), _e1193.member_1[0], (_e1276 == 1023u)) <= _e1133.member.x));
                            } else {
                                phi_2110_ = _e1252;
                            }
                            let _e1292 = phi_2110_;
                            phi_2111_ = _e1292;
                        } else {
                            phi_2111_ = _e1272;
                        }
                        let _e1294 = phi_2111_;
                        let _e1302 = (_e1190.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1294)) - 8388608f) * _e1206)) ^ _e74)));
                        let _e1309 = (_e1133.member.y - _e1190.member[1]);
                        let _e1314 = bitcast<f32>((bitcast<u32>(((_e1193.member_1[1] - _e1190.member[1]) * 0.0009775171f)) ^ _e74));
                        let _e1315 = (_e1314 > 0f);
                        if _e1315 {
                            phi_2155_ = (_e1309 / _e1314);
                        } else {
                            phi_2155_ = 0f;
                        }
                        let _e1318 = phi_2155_;
                        let _e1320 = select(1023f, _e1318, (_e1318 < 1023f));
                        let _e1328 = bitcast<u32>(select(0i, select(select(i32(_e1320), i32(-2147483648), (_e1320 < -2147483600f)), 2147483647i, (_e1320 > 2147483500f)), (_e1320 == _e1320)));
                        if (_e1328 > 0u) {
                            let _e1337 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1328)) - 8388608f) * _e1314)) ^ _e74)) > _e1309);
                            if _e1337 {
                                phi_2188_ = (_e1328 - 1u);
                            } else {
                                phi_2188_ = u32();
                            }
                            let _e1340 = phi_2188_;
                            phi_2190_ = _e1340;
                            phi_2191_ = select(true, false, _e1337);
                        } else {
                            phi_2190_ = u32();
                            phi_2191_ = true;
                        }
                        let _e1343 = phi_2190_;
                        let _e1345 = phi_2191_;
                        if _e1345 {
                            if (_e1328 < 1023u) {
                                let _e1347 = (_e1328 + 1u);
                                phi_2213_ = select(_e1328, _e1347, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1347)) - 8388608f) * _e1314)) ^ _e74)) <= _e1309));
                            } else {
                                phi_2213_ = _e1328;
                            }
                            let _e1358 = phi_2213_;
                            phi_2214_ = _e1358;
                        } else {
                            phi_2214_ = _e1343;
                        }
                        let _e1360 = phi_2214_;
                        if (_e1360 > 0u) {
                            let _e1369 = (_e1190.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1360)) - 8388608f) * _e1314)) ^ _e74)));
                            let _e1374 = (select(select(_e1193.member_1[1], _e1369, (_e1369 < _e1193.member_1[1])), _e1193.member_1[1], (_e1360 == 1023u)) > _e1133.member.y);
                            if _e1374 {
                                phi_2249_ = (_e1360 - 1u);
                            } else {
                                phi_2249_ = u32();
                            }
                            let _e1377 = phi_2249_;
                            phi_2251_ = _e1377;
                            phi_2252_ = select(true, false, _e1374);
                        } else {
                            phi_2251_ = u32();
                            phi_2252_ = true;
                        }
                        let _e1380 = phi_2251_;
                        let _e1382 = phi_2252_;
                        if _e1382 {
                            if (_e1360 < 1023u) {
                                let _e1384 = (_e1360 + 1u);
                                let _e1392 = (_e1190.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1384)) - 8388608f) * _e1314)) ^ _e74)));
                                phi_2292_ = select(_e1360, _e1384, (select(select(_e1193.member_1[1], _e1392, (_e1392 < _e1193.member_1[1])), _e1193.member_1[1], (_e1384 == 1023u)) <= _e1133.member.y));
                            } else {
                                phi_2292_ = _e1360;
                            }
                            let _e1400 = phi_2292_;
                            phi_2293_ = _e1400;
                        } else {
                            phi_2293_ = _e1380;
                        }
                        let _e1402 = phi_2293_;
                        let _e1410 = (_e1190.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1402)) - 8388608f) * _e1314)) ^ _e74)));
                        let _e1420 = (_e1133.member.z - _e1190.member[2]);
                        let _e1425 = bitcast<f32>((bitcast<u32>(((_e1193.member_1[2] - _e1190.member[2]) * 0.0009775171f)) ^ _e74));
                        let _e1426 = (_e1425 > 0f);
                        if _e1426 {
                            phi_2339_ = (_e1420 / _e1425);
                        } else {
                            phi_2339_ = 0f;
                        }
                        let _e1429 = phi_2339_;
                        let _e1431 = select(1023f, _e1429, (_e1429 < 1023f));
                        let _e1439 = bitcast<u32>(select(0i, select(select(i32(_e1431), i32(-2147483648), (_e1431 < -2147483600f)), 2147483647i, (_e1431 > 2147483500f)), (_e1431 == _e1431)));
                        if (_e1439 > 0u) {
                            let _e1448 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1439)) - 8388608f) * _e1425)) ^ _e74)) > _e1420);
                            if _e1448 {
                                phi_2372_ = (_e1439 - 1u);
                            } else {
                                phi_2372_ = u32();
                            }
                            let _e1451 = phi_2372_;
                            phi_2374_ = _e1451;
                            phi_2375_ = select(true, false, _e1448);
                        } else {
                            phi_2374_ = u32();
                            phi_2375_ = true;
                        }
                        let _e1454 = phi_2374_;
                        let _e1456 = phi_2375_;
                        if _e1456 {
                            if (_e1439 < 1023u) {
                                let _e1458 = (_e1439 + 1u);
                                phi_2397_ = select(_e1439, _e1458, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1458)) - 8388608f) * _e1425)) ^ _e74)) <= _e1420));
                            } else {
                                phi_2397_ = _e1439;
                            }
                            let _e1469 = phi_2397_;
                            phi_2398_ = _e1469;
                        } else {
                            phi_2398_ = _e1454;
                        }
                        let _e1471 = phi_2398_;
                        if (_e1471 > 0u) {
                            let _e1480 = (_e1190.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1471)) - 8388608f) * _e1425)) ^ _e74)));
                            let _e1485 = (select(select(_e1193.member_1[2], _e1480, (_e1480 < _e1193.member_1[2])), _e1193.member_1[2], (_e1471 == 1023u)) > _e1133.member.z);
                            if _e1485 {
                                phi_2433_ = (_e1471 - 1u);
                            } else {
                                phi_2433_ = u32();
                            }
                            let _e1488 = phi_2433_;
                            phi_2435_ = _e1488;
                            phi_2436_ = select(true, false, _e1485);
                        } else {
                            phi_2435_ = u32();
                            phi_2436_ = true;
                        }
                        let _e1491 = phi_2435_;
                        let _e1493 = phi_2436_;
                        if _e1493 {
                            if (_e1471 < 1023u) {
                                let _e1495 = (_e1471 + 1u);
                                let _e1503 = (_e1190.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1495)) - 8388608f) * _e1425)) ^ _e74)));
                                phi_2476_ = select(_e1471, _e1495, (select(select(_e1193.member_1[2], _e1503, (_e1503 < _e1193.member_1[2])), _e1193.member_1[2], (_e1495 == 1023u)) <= _e1133.member.z));
                            } else {
                                phi_2476_ = _e1471;
                            }
                            let _e1511 = phi_2476_;
                            phi_2477_ = _e1511;
                        } else {
                            phi_2477_ = _e1491;
                        }
                        let _e1513 = phi_2477_;
                        let _e1521 = (_e1190.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1513)) - 8388608f) * _e1425)) ^ _e74)));
                        let _e1530 = ((select(_e1294, 0u, (select(select(_e1193.member_1[0], _e1302, (_e1302 < _e1193.member_1[0])), _e1193.member_1[0], (_e1294 == 1023u)) > _e1133.member.x)) | (select(_e1402, 0u, (select(select(_e1193.member_1[1], _e1410, (_e1410 < _e1193.member_1[1])), _e1193.member_1[1], (_e1402 == 1023u)) > _e1133.member.y)) << bitcast<u32>(10i))) | (select(_e1513, 0u, (select(select(_e1193.member_1[2], _e1521, (_e1521 < _e1193.member_1[2])), _e1193.member_1[2], (_e1513 == 1023u)) > _e1133.member.z)) << bitcast<u32>(20i)));
                        let _e1531 = (_e1133.member_1.x - _e1190.member[0]);
                        if _e1207 {
                            phi_2523_ = (_e1531 / _e1206);
                        } else {
                            phi_2523_ = 0f;
                        }
                        let _e1534 = phi_2523_;
                        let _e1536 = select(1023f, _e1534, (_e1534 < 1023f));
                        let _e1544 = bitcast<u32>(select(0i, select(select(i32(_e1536), i32(-2147483648), (_e1536 < -2147483600f)), 2147483647i, (_e1536 > 2147483500f)), (_e1536 == _e1536)));
                        if (_e1544 > 0u) {
                            let _e1553 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1544)) - 8388608f) * _e1206)) ^ _e74)) > _e1531);
                            if _e1553 {
                                phi_2556_ = (_e1544 - 1u);
                            } else {
                                phi_2556_ = u32();
                            }
                            let _e1556 = phi_2556_;
                            phi_2558_ = _e1556;
                            phi_2559_ = select(true, false, _e1553);
                        } else {
                            phi_2558_ = u32();
                            phi_2559_ = true;
                        }
                        let _e1559 = phi_2558_;
                        let _e1561 = phi_2559_;
                        if _e1561 {
                            if (_e1544 < 1023u) {
                                let _e1563 = (_e1544 + 1u);
                                phi_2581_ = select(_e1544, _e1563, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1563)) - 8388608f) * _e1206)) ^ _e74)) <= _e1531));
                            } else {
                                phi_2581_ = _e1544;
                            }
                            let _e1574 = phi_2581_;
                            phi_2582_ = _e1574;
                        } else {
                            phi_2582_ = _e1559;
                        }
                        let _e1576 = phi_2582_;
                        if (_e1576 > 0u) {
                            let _e1585 = (_e1190.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1576)) - 8388608f) * _e1206)) ^ _e74)));
                            let _e1590 = (select(select(_e1193.member_1[0], _e1585, (_e1585 < _e1193.member_1[0])), _e1193.member_1[0], (_e1576 == 1023u)) > _e1133.member_1.x);
                            if _e1590 {
                                phi_2617_ = (_e1576 - 1u);
                            } else {
                                phi_2617_ = u32();
                            }
                            let _e1593 = phi_2617_;
                            phi_2619_ = _e1593;
                            phi_2620_ = select(true, false, _e1590);
                        } else {
                            phi_2619_ = u32();
                            phi_2620_ = true;
                        }
                        let _e1596 = phi_2619_;
                        let _e1598 = phi_2620_;
                        if _e1598 {
                            if (_e1576 < 1023u) {
                                let _e1600 = (_e1576 + 1u);
                                let _e1608 = (_e1190.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1600)) - 8388608f) * _e1206)) ^ _e74)));
                                phi_2660_ = select(_e1576, _e1600, (select(select(_e1193.member_1[0], _e1608, (_e1608 < _e1193.member_1[0])), _e1193.member_1[0], (_e1600 == 1023u)) <= _e1133.member_1.x));
                            } else {
                                phi_2660_ = _e1576;
                            }
                            let _e1616 = phi_2660_;
                            phi_2661_ = _e1616;
                        } else {
                            phi_2661_ = _e1596;
                        }
                        let _e1618 = phi_2661_;
                        let _e1626 = (_e1190.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1618)) - 8388608f) * _e1206)) ^ _e74)));
                        let _e1632 = select(_e1618, 0u, (select(select(_e1193.member_1[0], _e1626, (_e1626 < _e1193.member_1[0])), _e1193.member_1[0], (_e1618 == 1023u)) > _e1133.member_1.x));
                        if (_e1632 < 1023u) {
                            let _e1641 = (_e1190.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1632)) - 8388608f) * _e1206)) ^ _e74)));
                            let _e1646 = (select(select(_e1193.member_1[0], _e1641, (_e1641 < _e1193.member_1[0])), _e1193.member_1[0], (_e1632 == 1023u)) < _e1133.member_1.x);
                            if _e1646 {
                                phi_2726_ = (_e1632 + 1u);
                            } else {
                                phi_2726_ = u32();
                            }
                            let _e1649 = phi_2726_;
                            phi_2728_ = _e1649;
                            phi_2729_ = select(true, false, _e1646);
                        } else {
                            phi_2728_ = u32();
                            phi_2729_ = true;
                        }
                        let _e1652 = phi_2728_;
                        let _e1654 = phi_2729_;
                        let _e1655 = select(_e1652, _e1632, _e1654);
                        let _e1663 = (_e1190.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1655)) - 8388608f) * _e1206)) ^ _e74)));
                        let _e1670 = (_e1133.member_1.y - _e1190.member[1]);
                        if _e1315 {
                            phi_2777_ = (_e1670 / _e1314);
                        } else {
                            phi_2777_ = 0f;
                        }
                        let _e1673 = phi_2777_;
                        let _e1675 = select(1023f, _e1673, (_e1673 < 1023f));
                        let _e1683 = bitcast<u32>(select(0i, select(select(i32(_e1675), i32(-2147483648), (_e1675 < -2147483600f)), 2147483647i, (_e1675 > 2147483500f)), (_e1675 == _e1675)));
                        if (_e1683 > 0u) {
                            let _e1692 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1683)) - 8388608f) * _e1314)) ^ _e74)) > _e1670);
                            if _e1692 {
                                phi_2810_ = (_e1683 - 1u);
                            } else {
                                phi_2810_ = u32();
                            }
                            let _e1695 = phi_2810_;
                            phi_2812_ = _e1695;
                            phi_2813_ = select(true, false, _e1692);
                        } else {
                            phi_2812_ = u32();
                            phi_2813_ = true;
                        }
                        let _e1698 = phi_2812_;
                        let _e1700 = phi_2813_;
                        if _e1700 {
                            if (_e1683 < 1023u) {
                                let _e1702 = (_e1683 + 1u);
                                phi_2835_ = select(_e1683, _e1702, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1702)) - 8388608f) * _e1314)) ^ _e74)) <= _e1670));
                            } else {
                                phi_2835_ = _e1683;
                            }
                            let _e1713 = phi_2835_;
                            phi_2836_ = _e1713;
                        } else {
                            phi_2836_ = _e1698;
                        }
                        let _e1715 = phi_2836_;
                        if (_e1715 > 0u) {
                            let _e1724 = (_e1190.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1715)) - 8388608f) * _e1314)) ^ _e74)));
                            let _e1729 = (select(select(_e1193.member_1[1], _e1724, (_e1724 < _e1193.member_1[1])), _e1193.member_1[1], (_e1715 == 1023u)) > _e1133.member_1.y);
                            if _e1729 {
                                phi_2871_ = (_e1715 - 1u);
                            } else {
                                phi_2871_ = u32();
                            }
                            let _e1732 = phi_2871_;
                            phi_2873_ = _e1732;
                            phi_2874_ = select(true, false, _e1729);
                        } else {
                            phi_2873_ = u32();
                            phi_2874_ = true;
                        }
                        let _e1735 = phi_2873_;
                        let _e1737 = phi_2874_;
                        if _e1737 {
                            if (_e1715 < 1023u) {
                                let _e1739 = (_e1715 + 1u);
                                let _e1747 = (_e1190.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1739)) - 8388608f) * _e1314)) ^ _e74)));
                                phi_2914_ = select(_e1715, _e1739, (select(select(_e1193.member_1[1], _e1747, (_e1747 < _e1193.member_1[1])), _e1193.member_1[1], (_e1739 == 1023u)) <= _e1133.member_1.y));
                            } else {
                                phi_2914_ = _e1715;
                            }
                            let _e1755 = phi_2914_;
                            phi_2915_ = _e1755;
                        } else {
                            phi_2915_ = _e1735;
                        }
                        let _e1757 = phi_2915_;
                        let _e1765 = (_e1190.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1757)) - 8388608f) * _e1314)) ^ _e74)));
                        let _e1771 = select(_e1757, 0u, (select(select(_e1193.member_1[1], _e1765, (_e1765 < _e1193.member_1[1])), _e1193.member_1[1], (_e1757 == 1023u)) > _e1133.member_1.y));
                        if (_e1771 < 1023u) {
                            let _e1780 = (_e1190.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1771)) - 8388608f) * _e1314)) ^ _e74)));
                            let _e1785 = (select(select(_e1193.member_1[1], _e1780, (_e1780 < _e1193.member_1[1])), _e1193.member_1[1], (_e1771 == 1023u)) < _e1133.member_1.y);
                            if _e1785 {
                                phi_2980_ = (_e1771 + 1u);
                            } else {
                                phi_2980_ = u32();
                            }
                            let _e1788 = phi_2980_;
                            phi_2982_ = _e1788;
                            phi_2983_ = select(true, false, _e1785);
                        } else {
                            phi_2982_ = u32();
                            phi_2983_ = true;
                        }
                        let _e1791 = phi_2982_;
                        let _e1793 = phi_2983_;
                        let _e1794 = select(_e1791, _e1771, _e1793);
                        let _e1802 = (_e1190.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1794)) - 8388608f) * _e1314)) ^ _e74)));
                        let _e1812 = (_e1133.member_1.z - _e1190.member[2]);
                        if _e1426 {
                            phi_3033_ = (_e1812 / _e1425);
                        } else {
                            phi_3033_ = 0f;
                        }
                        let _e1815 = phi_3033_;
                        let _e1817 = select(1023f, _e1815, (_e1815 < 1023f));
                        let _e1825 = bitcast<u32>(select(0i, select(select(i32(_e1817), i32(-2147483648), (_e1817 < -2147483600f)), 2147483647i, (_e1817 > 2147483500f)), (_e1817 == _e1817)));
                        if (_e1825 > 0u) {
                            let _e1834 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1825)) - 8388608f) * _e1425)) ^ _e74)) > _e1812);
                            if _e1834 {
                                phi_3066_ = (_e1825 - 1u);
                            } else {
                                phi_3066_ = u32();
                            }
                            let _e1837 = phi_3066_;
                            phi_3068_ = _e1837;
                            phi_3069_ = select(true, false, _e1834);
                        } else {
                            phi_3068_ = u32();
                            phi_3069_ = true;
                        }
                        let _e1840 = phi_3068_;
                        let _e1842 = phi_3069_;
                        if _e1842 {
                            if (_e1825 < 1023u) {
                                let _e1844 = (_e1825 + 1u);
                                phi_3091_ = select(_e1825, _e1844, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1844)) - 8388608f) * _e1425)) ^ _e74)) <= _e1812));
                            } else {
                                phi_3091_ = _e1825;
                            }
                            let _e1855 = phi_3091_;
                            phi_3092_ = _e1855;
                        } else {
                            phi_3092_ = _e1840;
                        }
                        let _e1857 = phi_3092_;
                        if (_e1857 > 0u) {
                            let _e1866 = (_e1190.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1857)) - 8388608f) * _e1425)) ^ _e74)));
                            let _e1871 = (select(select(_e1193.member_1[2], _e1866, (_e1866 < _e1193.member_1[2])), _e1193.member_1[2], (_e1857 == 1023u)) > _e1133.member_1.z);
                            if _e1871 {
                                phi_3127_ = (_e1857 - 1u);
                            } else {
                                phi_3127_ = u32();
                            }
                            let _e1874 = phi_3127_;
                            phi_3129_ = _e1874;
                            phi_3130_ = select(true, false, _e1871);
                        } else {
                            phi_3129_ = u32();
                            phi_3130_ = true;
                        }
                        let _e1877 = phi_3129_;
                        let _e1879 = phi_3130_;
                        if _e1879 {
                            if (_e1857 < 1023u) {
                                let _e1881 = (_e1857 + 1u);
                                let _e1889 = (_e1190.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1881)) - 8388608f) * _e1425)) ^ _e74)));
                                phi_3170_ = select(_e1857, _e1881, (select(select(_e1193.member_1[2], _e1889, (_e1889 < _e1193.member_1[2])), _e1193.member_1[2], (_e1881 == 1023u)) <= _e1133.member_1.z));
                            } else {
                                phi_3170_ = _e1857;
                            }
                            let _e1897 = phi_3170_;
                            phi_3171_ = _e1897;
                        } else {
                            phi_3171_ = _e1877;
                        }
                        let _e1899 = phi_3171_;
                        let _e1907 = (_e1190.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1899)) - 8388608f) * _e1425)) ^ _e74)));
                        let _e1913 = select(_e1899, 0u, (select(select(_e1193.member_1[2], _e1907, (_e1907 < _e1193.member_1[2])), _e1193.member_1[2], (_e1899 == 1023u)) > _e1133.member_1.z));
                        if (_e1913 < 1023u) {
                            let _e1922 = (_e1190.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1913)) - 8388608f) * _e1425)) ^ _e74)));
                            let _e1927 = (select(select(_e1193.member_1[2], _e1922, (_e1922 < _e1193.member_1[2])), _e1193.member_1[2], (_e1913 == 1023u)) < _e1133.member_1.z);
                            if _e1927 {
                                phi_3236_ = (_e1913 + 1u);
                            } else {
                                phi_3236_ = u32();
                            }
                            let _e1930 = phi_3236_;
                            phi_3238_ = _e1930;
                            phi_3239_ = select(true, false, _e1927);
                        } else {
                            phi_3238_ = u32();
                            phi_3239_ = true;
                        }
                        let _e1933 = phi_3238_;
                        let _e1935 = phi_3239_;
                        let _e1936 = select(_e1933, _e1913, _e1935);
                        let _e1944 = (_e1190.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1936)) - 8388608f) * _e1425)) ^ _e74)));
                        let _e1953 = ((select(_e1655, 1023u, (select(select(_e1193.member_1[0], _e1663, (_e1663 < _e1193.member_1[0])), _e1193.member_1[0], (_e1655 == 1023u)) < _e1133.member_1.x)) | (select(_e1794, 1023u, (select(select(_e1193.member_1[1], _e1802, (_e1802 < _e1193.member_1[1])), _e1193.member_1[1], (_e1794 == 1023u)) < _e1133.member_1.y)) << bitcast<u32>(10i))) | (select(_e1936, 1023u, (select(select(_e1193.member_1[2], _e1944, (_e1944 < _e1193.member_1[2])), _e1193.member_1[2], (_e1936 == 1023u)) < _e1133.member_1.z)) << bitcast<u32>(20i)));
                        let _e1955 = (_e1164.member.x - _e1190.member[0]);
                        if _e1207 {
                            phi_3298_ = (_e1955 / _e1206);
                        } else {
                            phi_3298_ = 0f;
                        }
                        let _e1958 = phi_3298_;
                        let _e1960 = select(1023f, _e1958, (_e1958 < 1023f));
                        let _e1968 = bitcast<u32>(select(0i, select(select(i32(_e1960), i32(-2147483648), (_e1960 < -2147483600f)), 2147483647i, (_e1960 > 2147483500f)), (_e1960 == _e1960)));
                        if (_e1968 > 0u) {
                            let _e1977 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1968)) - 8388608f) * _e1206)) ^ _e74)) > _e1955);
                            if _e1977 {
                                phi_3331_ = (_e1968 - 1u);
                            } else {
                                phi_3331_ = u32();
                            }
                            let _e1980 = phi_3331_;
                            phi_3333_ = _e1980;
                            phi_3334_ = select(true, false, _e1977);
                        } else {
                            phi_3333_ = u32();
                            phi_3334_ = true;
                        }
                        let _e1983 = phi_3333_;
                        let _e1985 = phi_3334_;
                        if _e1985 {
                            if (_e1968 < 1023u) {
                                let _e1987 = (_e1968 + 1u);
                                phi_3356_ = select(_e1968, _e1987, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1987)) - 8388608f) * _e1206)) ^ _e74)) <= _e1955));
                            } else {
                                phi_3356_ = _e1968;
                            }
                            let _e1998 = phi_3356_;
                            phi_3357_ = _e1998;
                        } else {
                            phi_3357_ = _e1983;
                        }
                        let _e2000 = phi_3357_;
                        if (_e2000 > 0u) {
                            let _e2009 = (_e1190.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2000)) - 8388608f) * _e1206)) ^ _e74)));
                            let _e2014 = (select(select(_e1193.member_1[0], _e2009, (_e2009 < _e1193.member_1[0])), _e1193.member_1[0], (_e2000 == 1023u)) > _e1164.member.x);
                            if _e2014 {
                                phi_3392_ = (_e2000 - 1u);
                            } else {
                                phi_3392_ = u32();
                            }
                            let _e2017 = phi_3392_;
                            phi_3394_ = _e2017;
                            phi_3395_ = select(true, false, _e2014);
                        } else {
                            phi_3394_ = u32();
                            phi_3395_ = true;
                        }
                        let _e2020 = phi_3394_;
                        let _e2022 = phi_3395_;
                        if _e2022 {
                            if (_e2000 < 1023u) {
                                let _e2024 = (_e2000 + 1u);
                                let _e2032 = (_e1190.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2024)) - 8388608f) * _e1206)) ^ _e74)));
                                phi_3435_ = select(_e2000, _e2024, (select(select(_e1193.member_1[0], _e2032, (_e2032 < _e1193.member_1[0])), _e1193.member_1[0], (_e2024 == 1023u)) <= _e1164.member.x));
                            } else {
                                phi_3435_ = _e2000;
                            }
                            let _e2040 = phi_3435_;
                            phi_3436_ = _e2040;
                        } else {
                            phi_3436_ = _e2020;
                        }
                        let _e2042 = phi_3436_;
                        let _e2050 = (_e1190.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2042)) - 8388608f) * _e1206)) ^ _e74)));
                        let _e2057 = (_e1164.member.y - _e1190.member[1]);
                        if _e1315 {
                            phi_3480_ = (_e2057 / _e1314);
                        } else {
                            phi_3480_ = 0f;
                        }
                        let _e2060 = phi_3480_;
                        let _e2062 = select(1023f, _e2060, (_e2060 < 1023f));
                        let _e2070 = bitcast<u32>(select(0i, select(select(i32(_e2062), i32(-2147483648), (_e2062 < -2147483600f)), 2147483647i, (_e2062 > 2147483500f)), (_e2062 == _e2062)));
                        if (_e2070 > 0u) {
                            let _e2079 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2070)) - 8388608f) * _e1314)) ^ _e74)) > _e2057);
                            if _e2079 {
                                phi_3513_ = (_e2070 - 1u);
                            } else {
                                phi_3513_ = u32();
                            }
                            let _e2082 = phi_3513_;
                            phi_3515_ = _e2082;
                            phi_3516_ = select(true, false, _e2079);
                        } else {
                            phi_3515_ = u32();
                            phi_3516_ = true;
                        }
                        let _e2085 = phi_3515_;
                        let _e2087 = phi_3516_;
                        if _e2087 {
                            if (_e2070 < 1023u) {
                                let _e2089 = (_e2070 + 1u);
                                phi_3538_ = select(_e2070, _e2089, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2089)) - 8388608f) * _e1314)) ^ _e74)) <= _e2057));
                            } else {
                                phi_3538_ = _e2070;
                            }
                            let _e2100 = phi_3538_;
                            phi_3539_ = _e2100;
                        } else {
                            phi_3539_ = _e2085;
                        }
                        let _e2102 = phi_3539_;
                        if (_e2102 > 0u) {
                            let _e2111 = (_e1190.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2102)) - 8388608f) * _e1314)) ^ _e74)));
                            let _e2116 = (select(select(_e1193.member_1[1], _e2111, (_e2111 < _e1193.member_1[1])), _e1193.member_1[1], (_e2102 == 1023u)) > _e1164.member.y);
                            if _e2116 {
                                phi_3574_ = (_e2102 - 1u);
                            } else {
                                phi_3574_ = u32();
                            }
                            let _e2119 = phi_3574_;
                            phi_3576_ = _e2119;
                            phi_3577_ = select(true, false, _e2116);
                        } else {
                            phi_3576_ = u32();
                            phi_3577_ = true;
                        }
                        let _e2122 = phi_3576_;
                        let _e2124 = phi_3577_;
                        if _e2124 {
                            if (_e2102 < 1023u) {
                                let _e2126 = (_e2102 + 1u);
                                let _e2134 = (_e1190.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2126)) - 8388608f) * _e1314)) ^ _e74)));
                                phi_3617_ = select(_e2102, _e2126, (select(select(_e1193.member_1[1], _e2134, (_e2134 < _e1193.member_1[1])), _e1193.member_1[1], (_e2126 == 1023u)) <= _e1164.member.y));
                            } else {
                                phi_3617_ = _e2102;
                            }
                            let _e2142 = phi_3617_;
                            phi_3618_ = _e2142;
                        } else {
                            phi_3618_ = _e2122;
                        }
                        let _e2144 = phi_3618_;
                        let _e2152 = (_e1190.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2144)) - 8388608f) * _e1314)) ^ _e74)));
                        let _e2162 = (_e1164.member.z - _e1190.member[2]);
                        if _e1426 {
                            phi_3664_ = (_e2162 / _e1425);
                        } else {
                            phi_3664_ = 0f;
                        }
                        let _e2165 = phi_3664_;
                        let _e2167 = select(1023f, _e2165, (_e2165 < 1023f));
                        let _e2175 = bitcast<u32>(select(0i, select(select(i32(_e2167), i32(-2147483648), (_e2167 < -2147483600f)), 2147483647i, (_e2167 > 2147483500f)), (_e2167 == _e2167)));
                        if (_e2175 > 0u) {
                            let _e2184 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2175)) - 8388608f) * _e1425)) ^ _e74)) > _e2162);
                            if _e2184 {
                                phi_3697_ = (_e2175 - 1u);
                            } else {
                                phi_3697_ = u32();
                            }
                            let _e2187 = phi_3697_;
                            phi_3699_ = _e2187;
                            phi_3700_ = select(true, false, _e2184);
                        } else {
                            phi_3699_ = u32();
                            phi_3700_ = true;
                        }
                        let _e2190 = phi_3699_;
                        let _e2192 = phi_3700_;
                        if _e2192 {
                            if (_e2175 < 1023u) {
                                let _e2194 = (_e2175 + 1u);
                                phi_3722_ = select(_e2175, _e2194, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2194)) - 8388608f) * _e1425)) ^ _e74)) <= _e2162));
                            } else {
                                phi_3722_ = _e2175;
                            }
                            let _e2205 = phi_3722_;
                            phi_3723_ = _e2205;
                        } else {
                            phi_3723_ = _e2190;
                        }
                        let _e2207 = phi_3723_;
                        if (_e2207 > 0u) {
                            let _e2216 = (_e1190.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2207)) - 8388608f) * _e1425)) ^ _e74)));
                            let _e2221 = (select(select(_e1193.member_1[2], _e2216, (_e2216 < _e1193.member_1[2])), _e1193.member_1[2], (_e2207 == 1023u)) > _e1164.member.z);
                            if _e2221 {
                                phi_3758_ = (_e2207 - 1u);
                            } else {
                                phi_3758_ = u32();
                            }
                            let _e2224 = phi_3758_;
                            phi_3760_ = _e2224;
                            phi_3761_ = select(true, false, _e2221);
                        } else {
                            phi_3760_ = u32();
                            phi_3761_ = true;
                        }
                        let _e2227 = phi_3760_;
                        let _e2229 = phi_3761_;
                        if _e2229 {
                            if (_e2207 < 1023u) {
                                let _e2231 = (_e2207 + 1u);
                                let _e2239 = (_e1190.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2231)) - 8388608f) * _e1425)) ^ _e74)));
                                phi_3801_ = select(_e2207, _e2231, (select(select(_e1193.member_1[2], _e2239, (_e2239 < _e1193.member_1[2])), _e1193.member_1[2], (_e2231 == 1023u)) <= _e1164.member.z));
                            } else {
                                phi_3801_ = _e2207;
                            }
                            let _e2247 = phi_3801_;
                            phi_3802_ = _e2247;
                        } else {
                            phi_3802_ = _e2227;
                        }
                        let _e2249 = phi_3802_;
                        let _e2257 = (_e1190.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2249)) - 8388608f) * _e1425)) ^ _e74)));
                        let _e2266 = ((select(_e2042, 0u, (select(select(_e1193.member_1[0], _e2050, (_e2050 < _e1193.member_1[0])), _e1193.member_1[0], (_e2042 == 1023u)) > _e1164.member.x)) | (select(_e2144, 0u, (select(select(_e1193.member_1[1], _e2152, (_e2152 < _e1193.member_1[1])), _e1193.member_1[1], (_e2144 == 1023u)) > _e1164.member.y)) << bitcast<u32>(10i))) | (select(_e2249, 0u, (select(select(_e1193.member_1[2], _e2257, (_e2257 < _e1193.member_1[2])), _e1193.member_1[2], (_e2249 == 1023u)) > _e1164.member.z)) << bitcast<u32>(20i)));
                        let _e2267 = (_e1164.member_1.x - _e1190.member[0]);
                        if _e1207 {
                            phi_3848_ = (_e2267 / _e1206);
                        } else {
                            phi_3848_ = 0f;
                        }
                        let _e2270 = phi_3848_;
                        let _e2272 = select(1023f, _e2270, (_e2270 < 1023f));
                        let _e2280 = bitcast<u32>(select(0i, select(select(i32(_e2272), i32(-2147483648), (_e2272 < -2147483600f)), 2147483647i, (_e2272 > 2147483500f)), (_e2272 == _e2272)));
                        if (_e2280 > 0u) {
                            let _e2289 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2280)) - 8388608f) * _e1206)) ^ _e74)) > _e2267);
                            if _e2289 {
                                phi_3881_ = (_e2280 - 1u);
                            } else {
                                phi_3881_ = u32();
                            }
                            let _e2292 = phi_3881_;
                            phi_3883_ = _e2292;
                            phi_3884_ = select(true, false, _e2289);
                        } else {
                            phi_3883_ = u32();
                            phi_3884_ = true;
                        }
                        let _e2295 = phi_3883_;
                        let _e2297 = phi_3884_;
                        if _e2297 {
                            if (_e2280 < 1023u) {
                                let _e2299 = (_e2280 + 1u);
                                phi_3906_ = select(_e2280, _e2299, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2299)) - 8388608f) * _e1206)) ^ _e74)) <= _e2267));
                            } else {
                                phi_3906_ = _e2280;
                            }
                            let _e2310 = phi_3906_;
                            phi_3907_ = _e2310;
                        } else {
                            phi_3907_ = _e2295;
                        }
                        let _e2312 = phi_3907_;
                        if (_e2312 > 0u) {
                            let _e2321 = (_e1190.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2312)) - 8388608f) * _e1206)) ^ _e74)));
                            let _e2326 = (select(select(_e1193.member_1[0], _e2321, (_e2321 < _e1193.member_1[0])), _e1193.member_1[0], (_e2312 == 1023u)) > _e1164.member_1.x);
                            if _e2326 {
                                phi_3942_ = (_e2312 - 1u);
                            } else {
                                phi_3942_ = u32();
                            }
                            let _e2329 = phi_3942_;
                            phi_3944_ = _e2329;
                            phi_3945_ = select(true, false, _e2326);
                        } else {
                            phi_3944_ = u32();
                            phi_3945_ = true;
                        }
                        let _e2332 = phi_3944_;
                        let _e2334 = phi_3945_;
                        if _e2334 {
                            if (_e2312 < 1023u) {
                                let _e2336 = (_e2312 + 1u);
                                let _e2344 = (_e1190.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2336)) - 8388608f) * _e1206)) ^ _e74)));
                                phi_3985_ = select(_e2312, _e2336, (select(select(_e1193.member_1[0], _e2344, (_e2344 < _e1193.member_1[0])), _e1193.member_1[0], (_e2336 == 1023u)) <= _e1164.member_1.x));
                            } else {
                                phi_3985_ = _e2312;
                            }
                            let _e2352 = phi_3985_;
                            phi_3986_ = _e2352;
                        } else {
                            phi_3986_ = _e2332;
                        }
                        let _e2354 = phi_3986_;
                        let _e2362 = (_e1190.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2354)) - 8388608f) * _e1206)) ^ _e74)));
                        let _e2368 = select(_e2354, 0u, (select(select(_e1193.member_1[0], _e2362, (_e2362 < _e1193.member_1[0])), _e1193.member_1[0], (_e2354 == 1023u)) > _e1164.member_1.x));
                        if (_e2368 < 1023u) {
                            let _e2377 = (_e1190.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2368)) - 8388608f) * _e1206)) ^ _e74)));
                            let _e2382 = (select(select(_e1193.member_1[0], _e2377, (_e2377 < _e1193.member_1[0])), _e1193.member_1[0], (_e2368 == 1023u)) < _e1164.member_1.x);
                            if _e2382 {
                                phi_4051_ = (_e2368 + 1u);
                            } else {
                                phi_4051_ = u32();
                            }
                            let _e2385 = phi_4051_;
                            phi_4053_ = _e2385;
                            phi_4054_ = select(true, false, _e2382);
                        } else {
                            phi_4053_ = u32();
                            phi_4054_ = true;
                        }
                        let _e2388 = phi_4053_;
                        let _e2390 = phi_4054_;
                        let _e2391 = select(_e2388, _e2368, _e2390);
                        let _e2399 = (_e1190.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2391)) - 8388608f) * _e1206)) ^ _e74)));
                        let _e2406 = (_e1164.member_1.y - _e1190.member[1]);
                        if _e1315 {
                            phi_4102_ = (_e2406 / _e1314);
                        } else {
                            phi_4102_ = 0f;
                        }
                        let _e2409 = phi_4102_;
                        let _e2411 = select(1023f, _e2409, (_e2409 < 1023f));
                        let _e2419 = bitcast<u32>(select(0i, select(select(i32(_e2411), i32(-2147483648), (_e2411 < -2147483600f)), 2147483647i, (_e2411 > 2147483500f)), (_e2411 == _e2411)));
                        if (_e2419 > 0u) {
                            let _e2428 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2419)) - 8388608f) * _e1314)) ^ _e74)) > _e2406);
                            if _e2428 {
                                phi_4135_ = (_e2419 - 1u);
                            } else {
                                phi_4135_ = u32();
                            }
                            let _e2431 = phi_4135_;
                            phi_4137_ = _e2431;
                            phi_4138_ = select(true, false, _e2428);
                        } else {
                            phi_4137_ = u32();
                            phi_4138_ = true;
                        }
                        let _e2434 = phi_4137_;
                        let _e2436 = phi_4138_;
                        if _e2436 {
                            if (_e2419 < 1023u) {
                                let _e2438 = (_e2419 + 1u);
                                phi_4160_ = select(_e2419, _e2438, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2438)) - 8388608f) * _e1314)) ^ _e74)) <= _e2406));
                            } else {
                                phi_4160_ = _e2419;
                            }
                            let _e2449 = phi_4160_;
                            phi_4161_ = _e2449;
                        } else {
                            phi_4161_ = _e2434;
                        }
                        let _e2451 = phi_4161_;
                        if (_e2451 > 0u) {
                            let _e2460 = (_e1190.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2451)) - 8388608f) * _e1314)) ^ _e74)));
                            let _e2465 = (select(select(_e1193.member_1[1], _e2460, (_e2460 < _e1193.member_1[1])), _e1193.member_1[1], (_e2451 == 1023u)) > _e1164.member_1.y);
                            if _e2465 {
                                phi_4196_ = (_e2451 - 1u);
                            } else {
                                phi_4196_ = u32();
                            }
                            let _e2468 = phi_4196_;
                            phi_4198_ = _e2468;
                            phi_4199_ = select(true, false, _e2465);
                        } else {
                            phi_4198_ = u32();
                            phi_4199_ = true;
                        }
                        let _e2471 = phi_4198_;
                        let _e2473 = phi_4199_;
                        if _e2473 {
                            if (_e2451 < 1023u) {
                                let _e2475 = (_e2451 + 1u);
                                let _e2483 = (_e1190.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2475)) - 8388608f) * _e1314)) ^ _e74)));
                                phi_4239_ = select(_e2451, _e2475, (select(select(_e1193.member_1[1], _e2483, (_e2483 < _e1193.member_1[1])), _e1193.member_1[1], (_e2475 == 1023u)) <= _e1164.member_1.y));
                            } else {
                                phi_4239_ = _e2451;
                            }
                            let _e2491 = phi_4239_;
                            phi_4240_ = _e2491;
                        } else {
                            phi_4240_ = _e2471;
                        }
                        let _e2493 = phi_4240_;
                        let _e2501 = (_e1190.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2493)) - 8388608f) * _e1314)) ^ _e74)));
                        let _e2507 = select(_e2493, 0u, (select(select(_e1193.member_1[1], _e2501, (_e2501 < _e1193.member_1[1])), _e1193.member_1[1], (_e2493 == 1023u)) > _e1164.member_1.y));
                        if (_e2507 < 1023u) {
                            let _e2516 = (_e1190.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2507)) - 8388608f) * _e1314)) ^ _e74)));
                            let _e2521 = (select(select(_e1193.member_1[1], _e2516, (_e2516 < _e1193.member_1[1])), _e1193.member_1[1], (_e2507 == 1023u)) < _e1164.member_1.y);
                            if _e2521 {
                                phi_4305_ = (_e2507 + 1u);
                            } else {
                                phi_4305_ = u32();
                            }
                            let _e2524 = phi_4305_;
                            phi_4307_ = _e2524;
                            phi_4308_ = select(true, false, _e2521);
                        } else {
                            phi_4307_ = u32();
                            phi_4308_ = true;
                        }
                        let _e2527 = phi_4307_;
                        let _e2529 = phi_4308_;
                        let _e2530 = select(_e2527, _e2507, _e2529);
                        let _e2538 = (_e1190.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2530)) - 8388608f) * _e1314)) ^ _e74)));
                        let _e2548 = (_e1164.member_1.z - _e1190.member[2]);
                        if _e1426 {
                            phi_4358_ = (_e2548 / _e1425);
                        } else {
                            phi_4358_ = 0f;
                        }
                        let _e2551 = phi_4358_;
                        let _e2553 = select(1023f, _e2551, (_e2551 < 1023f));
                        let _e2561 = bitcast<u32>(select(0i, select(select(i32(_e2553), i32(-2147483648), (_e2553 < -2147483600f)), 2147483647i, (_e2553 > 2147483500f)), (_e2553 == _e2553)));
                        if (_e2561 > 0u) {
                            let _e2570 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2561)) - 8388608f) * _e1425)) ^ _e74)) > _e2548);
                            if _e2570 {
                                phi_4391_ = (_e2561 - 1u);
                            } else {
                                phi_4391_ = u32();
                            }
                            let _e2573 = phi_4391_;
                            phi_4393_ = _e2573;
                            phi_4394_ = select(true, false, _e2570);
                        } else {
                            phi_4393_ = u32();
                            phi_4394_ = true;
                        }
                        let _e2576 = phi_4393_;
                        let _e2578 = phi_4394_;
                        if _e2578 {
                            if (_e2561 < 1023u) {
                                let _e2580 = (_e2561 + 1u);
                                phi_4416_ = select(_e2561, _e2580, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2580)) - 8388608f) * _e1425)) ^ _e74)) <= _e2548));
                            } else {
                                phi_4416_ = _e2561;
                            }
                            let _e2591 = phi_4416_;
                            phi_4417_ = _e2591;
                        } else {
                            phi_4417_ = _e2576;
                        }
                        let _e2593 = phi_4417_;
                        if (_e2593 > 0u) {
                            let _e2602 = (_e1190.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2593)) - 8388608f) * _e1425)) ^ _e74)));
                            let _e2607 = (select(select(_e1193.member_1[2], _e2602, (_e2602 < _e1193.member_1[2])), _e1193.member_1[2], (_e2593 == 1023u)) > _e1164.member_1.z);
                            if _e2607 {
                                phi_4452_ = (_e2593 - 1u);
                            } else {
                                phi_4452_ = u32();
                            }
                            let _e2610 = phi_4452_;
                            phi_4454_ = _e2610;
                            phi_4455_ = select(true, false, _e2607);
                        } else {
                            phi_4454_ = u32();
                            phi_4455_ = true;
                        }
                        let _e2613 = phi_4454_;
                        let _e2615 = phi_4455_;
                        if _e2615 {
                            if (_e2593 < 1023u) {
                                let _e2617 = (_e2593 + 1u);
                                let _e2625 = (_e1190.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2617)) - 8388608f) * _e1425)) ^ _e74)));
                                phi_4495_ = select(_e2593, _e2617, (select(select(_e1193.member_1[2], _e2625, (_e2625 < _e1193.member_1[2])), _e1193.member_1[2], (_e2617 == 1023u)) <= _e1164.member_1.z));
                            } else {
                                phi_4495_ = _e2593;
                            }
                            let _e2633 = phi_4495_;
                            phi_4496_ = _e2633;
                        } else {
                            phi_4496_ = _e2613;
                        }
                        let _e2635 = phi_4496_;
                        let _e2643 = (_e1190.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2635)) - 8388608f) * _e1425)) ^ _e74)));
                        let _e2649 = select(_e2635, 0u, (select(select(_e1193.member_1[2], _e2643, (_e2643 < _e1193.member_1[2])), _e1193.member_1[2], (_e2635 == 1023u)) > _e1164.member_1.z));
                        if (_e2649 < 1023u) {
                            let _e2658 = (_e1190.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2649)) - 8388608f) * _e1425)) ^ _e74)));
                            let _e2663 = (select(select(_e1193.member_1[2], _e2658, (_e2658 < _e1193.member_1[2])), _e1193.member_1[2], (_e2649 == 1023u)) < _e1164.member_1.z);
                            if _e2663 {
                                phi_4561_ = (_e2649 + 1u);
                            } else {
                                phi_4561_ = u32();
                            }
                            let _e2666 = phi_4561_;
                            phi_4563_ = _e2666;
                            phi_4564_ = select(true, false, _e2663);
                        } else {
                            phi_4563_ = u32();
                            phi_4564_ = true;
                        }
                        let _e2669 = phi_4563_;
                        let _e2671 = phi_4564_;
                        let _e2672 = select(_e2669, _e2649, _e2671);
                        let _e2680 = (_e1190.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2672)) - 8388608f) * _e1425)) ^ _e74)));
                        let _e2689 = ((select(_e2391, 1023u, (select(select(_e1193.member_1[0], _e2399, (_e2399 < _e1193.member_1[0])), _e1193.member_1[0], (_e2391 == 1023u)) < _e1164.member_1.x)) | (select(_e2530, 1023u, (select(select(_e1193.member_1[1], _e2538, (_e2538 < _e1193.member_1[1])), _e1193.member_1[1], (_e2530 == 1023u)) < _e1164.member_1.y)) << bitcast<u32>(10i))) | (select(_e2672, 1023u, (select(select(_e1193.member_1[2], _e2680, (_e2680 < _e1193.member_1[2])), _e1193.member_1[2], (_e2672 == 1023u)) < _e1164.member_1.z)) << bitcast<u32>(20i)));
                        let _e2692 = (_e1530 & 1023u);
                        let _e2700 = (_e1190.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2692)) - 8388608f) * _e1206)) ^ _e74)));
                        let _e2704 = select(select(_e1193.member_1[0], _e2700, (_e2700 < _e1193.member_1[0])), _e1193.member_1[0], (_e2692 == 1023u));
                        let _e2707 = ((_e1530 >> bitcast<u32>(10u)) & 1023u);
                        let _e2715 = (_e1190.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2707)) - 8388608f) * _e1314)) ^ _e74)));
                        let _e2719 = select(select(_e1193.member_1[1], _e2715, (_e2715 < _e1193.member_1[1])), _e1193.member_1[1], (_e2707 == 1023u));
                        let _e2722 = ((_e1530 >> bitcast<u32>(20u)) & 1023u);
                        let _e2730 = (_e1190.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2722)) - 8388608f) * _e1425)) ^ _e74)));
                        let _e2734 = select(select(_e1193.member_1[2], _e2730, (_e2730 < _e1193.member_1[2])), _e1193.member_1[2], (_e2722 == 1023u));
                        let _e2735 = (_e1953 & 1023u);
                        let _e2743 = (_e1190.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2735)) - 8388608f) * _e1206)) ^ _e74)));
                        let _e2747 = select(select(_e1193.member_1[0], _e2743, (_e2743 < _e1193.member_1[0])), _e1193.member_1[0], (_e2735 == 1023u));
                        let _e2750 = ((_e1953 >> bitcast<u32>(10u)) & 1023u);
                        let _e2758 = (_e1190.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2750)) - 8388608f) * _e1314)) ^ _e74)));
                        let _e2762 = select(select(_e1193.member_1[1], _e2758, (_e2758 < _e1193.member_1[1])), _e1193.member_1[1], (_e2750 == 1023u));
                        let _e2765 = ((_e1953 >> bitcast<u32>(20u)) & 1023u);
                        let _e2773 = (_e1190.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2765)) - 8388608f) * _e1425)) ^ _e74)));
                        let _e2777 = select(select(_e1193.member_1[2], _e2773, (_e2773 < _e1193.member_1[2])), _e1193.member_1[2], (_e2765 == 1023u));
                        let _e2778 = (_e2266 & 1023u);
                        let _e2786 = (_e1190.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2778)) - 8388608f) * _e1206)) ^ _e74)));
                        let _e2790 = select(select(_e1193.member_1[0], _e2786, (_e2786 < _e1193.member_1[0])), _e1193.member_1[0], (_e2778 == 1023u));
                        let _e2793 = ((_e2266 >> bitcast<u32>(10u)) & 1023u);
                        let _e2801 = (_e1190.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2793)) - 8388608f) * _e1314)) ^ _e74)));
                        let _e2805 = select(select(_e1193.member_1[1], _e2801, (_e2801 < _e1193.member_1[1])), _e1193.member_1[1], (_e2793 == 1023u));
                        let _e2808 = ((_e2266 >> bitcast<u32>(20u)) & 1023u);
                        let _e2816 = (_e1190.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2808)) - 8388608f) * _e1425)) ^ _e74)));
                        let _e2820 = select(select(_e1193.member_1[2], _e2816, (_e2816 < _e1193.member_1[2])), _e1193.member_1[2], (_e2808 == 1023u));
                        let _e2821 = (_e2689 & 1023u);
                        let _e2829 = (_e1190.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2821)) - 8388608f) * _e1206)) ^ _e74)));
                        let _e2833 = select(select(_e1193.member_1[0], _e2829, (_e2829 < _e1193.member_1[0])), _e1193.member_1[0], (_e2821 == 1023u));
                        let _e2836 = ((_e2689 >> bitcast<u32>(10u)) & 1023u);
                        let _e2844 = (_e1190.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2836)) - 8388608f) * _e1314)) ^ _e74)));
                        let _e2848 = select(select(_e1193.member_1[1], _e2844, (_e2844 < _e1193.member_1[1])), _e1193.member_1[1], (_e2836 == 1023u));
                        let _e2851 = ((_e2689 >> bitcast<u32>(20u)) & 1023u);
                        let _e2859 = (_e1190.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2851)) - 8388608f) * _e1425)) ^ _e74)));
                        let _e2863 = select(select(_e1193.member_1[2], _e2859, (_e2859 < _e1193.member_1[2])), _e1193.member_1[2], (_e2851 == 1023u));
                        if _e71 {
                        } else {
                            break;
                        }
                        global_5.member[_e65] = type_37(array<u32, 2>(_e1530, _e1953), array<u32, 2>(_e2266, _e2689), _e1106, _e1137);
                        if _e70 {
                        } else {
                            break;
                        }
                        if ((_e1106 & 2147483648u) != 0u) {
                            phi_5012_ = type_4(0u, ((_e1106 >> bitcast<u32>(28u)) & 7u));
                            loop {
                                let _e2873 = phi_5012_;
                                if (_e2873.member < _e2873.member_1) {
                                    phi_5013_ = type_4((_e2873.member + 1u), _e2873.member_1);
                                    phi_5036_ = type_4(1u, _e2873.member);
                                } else {
                                    phi_5013_ = _e2873;
                                    phi_5036_ = type_4(0u, type_4().member_1);
                                }
                                let _e2886 = phi_5013_;
                                let _e2888 = phi_5036_;
                                let _e2892 = (bitcast<i32>(_e2888.member) != 0i);
                                if _e2892 {
                                    let _e2894 = ((_e1106 & 268435455u) + _e2888.member_1);
                                    let _e2895 = (_e2894 < _e55);
                                    if _e2895 {
                                        let _e2896 = (_e2894 < _e59);
                                        if _e2896 {
                                            if _e2895 {
                                            } else {
                                                phi_9935_ = true;
                                                break;
                                            }
                                            let _e2901 = global_2.member[_e2894].member[0u];
                                            let _e2906 = global_2.member[_e2894].member[1u];
                                            let _e2911 = global_2.member[_e2894].member[2u];
                                            let _e2912 = (_e2901 - _e2704);
                                            let _e2917 = bitcast<f32>((bitcast<u32>(((_e2747 - _e2704) * 0.0009775171f)) ^ _e74));
                                            let _e2918 = (_e2917 > 0f);
                                            if _e2918 {
                                                phi_5079_ = (_e2912 / _e2917);
                                            } else {
                                                phi_5079_ = 0f;
                                            }
                                            let _e2921 = phi_5079_;
                                            let _e2923 = select(1023f, _e2921, (_e2921 < 1023f));
                                            let _e2931 = bitcast<u32>(select(0i, select(select(i32(_e2923), i32(-2147483648), (_e2923 < -2147483600f)), 2147483647i, (_e2923 > 2147483500f)), (_e2923 == _e2923)));
                                            if (_e2931 > 0u) {
                                                let _e2940 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2931)) - 8388608f) * _e2917)) ^ _e74)) > _e2912);
                                                if _e2940 {
                                                    phi_5112_ = (_e2931 - 1u);
                                                } else {
                                                    phi_5112_ = u32();
                                                }
                                                let _e2943 = phi_5112_;
                                                phi_5114_ = _e2943;
                                                phi_5115_ = select(true, false, _e2940);
                                            } else {
                                                phi_5114_ = u32();
                                                phi_5115_ = true;
                                            }
                                            let _e2946 = phi_5114_;
                                            let _e2948 = phi_5115_;
                                            if _e2948 {
                                                if (_e2931 < 1023u) {
                                                    let _e2950 = (_e2931 + 1u);
                                                    phi_5137_ = select(_e2931, _e2950, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2950)) - 8388608f) * _e2917)) ^ _e74)) <= _e2912));
                                                } else {
                                                    phi_5137_ = _e2931;
                                                }
                                                let _e2961 = phi_5137_;
                                                phi_5138_ = _e2961;
                                            } else {
                                                phi_5138_ = _e2946;
                                            }
                                            let _e2963 = phi_5138_;
                                            if (_e2963 > 0u) {
                                                let _e2972 = (_e2704 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2963)) - 8388608f) * _e2917)) ^ _e74)));
                                                let _e2977 = (select(select(_e2747, _e2972, (_e2972 < _e2747)), _e2747, (_e2963 == 1023u)) > _e2901);
                                                if _e2977 {
                                                    phi_5173_ = (_e2963 - 1u);
                                                } else {
                                                    phi_5173_ = u32();
                                                }
                                                let _e2980 = phi_5173_;
                                                phi_5175_ = _e2980;
                                                phi_5176_ = select(true, false, _e2977);
                                            } else {
                                                phi_5175_ = u32();
                                                phi_5176_ = true;
                                            }
                                            let _e2983 = phi_5175_;
                                            let _e2985 = phi_5176_;
                                            if _e2985 {
                                                if (_e2963 < 1023u) {
                                                    let _e2987 = (_e2963 + 1u);
                                                    let _e2995 = (_e2704 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2987)) - 8388608f) * _e2917)) ^ _e74)));
                                                    phi_5216_ = select(_e2963, _e2987, (select(select(_e2747, _e2995, (_e2995 < _e2747)), _e2747, (_e2987 == 1023u)) <= _e2901));
                                                } else {
                                                    phi_5216_ = _e2963;
                                                }
                                                let _e3003 = phi_5216_;
                                                phi_5217_ = _e3003;
                                            } else {
                                                phi_5217_ = _e2983;
                                            }
                                            let _e3005 = phi_5217_;
                                            let _e3013 = (_e2704 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3005)) - 8388608f) * _e2917)) ^ _e74)));
                                            let _e3019 = select(_e3005, 0u, (select(select(_e2747, _e3013, (_e3013 < _e2747)), _e2747, (_e3005 == 1023u)) > _e2901));
                                            if (_e3019 < 1023u) {
                                                phi_5253_ = (_e3019 + 1u);
                                            } else {
                                                phi_5253_ = _e3019;
                                            }
                                            let _e3023 = phi_5253_;
                                            let _e3031 = (_e2704 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3019)) - 8388608f) * _e2917)) ^ _e74)));
                                            let _e3047 = (_e2704 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3023)) - 8388608f) * _e2917)) ^ _e74)));
                                            let _e3058 = (_e2906 - _e2719);
                                            let _e3063 = bitcast<f32>((bitcast<u32>(((_e2762 - _e2719) * 0.0009775171f)) ^ _e74));
                                            let _e3064 = (_e3063 > 0f);
                                            if _e3064 {
                                                phi_5330_ = (_e3058 / _e3063);
                                            } else {
                                                phi_5330_ = 0f;
                                            }
                                            let _e3067 = phi_5330_;
                                            let _e3069 = select(1023f, _e3067, (_e3067 < 1023f));
                                            let _e3077 = bitcast<u32>(select(0i, select(select(i32(_e3069), i32(-2147483648), (_e3069 < -2147483600f)), 2147483647i, (_e3069 > 2147483500f)), (_e3069 == _e3069)));
                                            if (_e3077 > 0u) {
                                                let _e3086 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3077)) - 8388608f) * _e3063)) ^ _e74)) > _e3058);
                                                if _e3086 {
                                                    phi_5363_ = (_e3077 - 1u);
                                                } else {
                                                    phi_5363_ = u32();
                                                }
                                                let _e3089 = phi_5363_;
                                                phi_5365_ = _e3089;
                                                phi_5366_ = select(true, false, _e3086);
                                            } else {
                                                phi_5365_ = u32();
                                                phi_5366_ = true;
                                            }
                                            let _e3092 = phi_5365_;
                                            let _e3094 = phi_5366_;
                                            if _e3094 {
                                                if (_e3077 < 1023u) {
                                                    let _e3096 = (_e3077 + 1u);
                                                    phi_5388_ = select(_e3077, _e3096, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3096)) - 8388608f) * _e3063)) ^ _e74)) <= _e3058));
                                                } else {
                                                    phi_5388_ = _e3077;
                                                }
                                                let _e3107 = phi_5388_;
                                                phi_5389_ = _e3107;
                                            } else {
                                                phi_5389_ = _e3092;
                                            }
                                            let _e3109 = phi_5389_;
                                            if (_e3109 > 0u) {
                                                let _e3118 = (_e2719 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3109)) - 8388608f) * _e3063)) ^ _e74)));
                                                let _e3123 = (select(select(_e2762, _e3118, (_e3118 < _e2762)), _e2762, (_e3109 == 1023u)) > _e2906);
                                                if _e3123 {
                                                    phi_5424_ = (_e3109 - 1u);
                                                } else {
                                                    phi_5424_ = u32();
                                                }
                                                let _e3126 = phi_5424_;
                                                phi_5426_ = _e3126;
                                                phi_5427_ = select(true, false, _e3123);
                                            } else {
                                                phi_5426_ = u32();
                                                phi_5427_ = true;
                                            }
                                            let _e3129 = phi_5426_;
                                            let _e3131 = phi_5427_;
                                            if _e3131 {
                                                if (_e3109 < 1023u) {
                                                    let _e3133 = (_e3109 + 1u);
                                                    let _e3141 = (_e2719 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3133)) - 8388608f) * _e3063)) ^ _e74)));
                                                    phi_5467_ = select(_e3109, _e3133, (select(select(_e2762, _e3141, (_e3141 < _e2762)), _e2762, (_e3133 == 1023u)) <= _e2906));
                                                } else {
                                                    phi_5467_ = _e3109;
                                                }
                                                let _e3149 = phi_5467_;
                                                phi_5468_ = _e3149;
                                            } else {
                                                phi_5468_ = _e3129;
                                            }
                                            let _e3151 = phi_5468_;
                                            let _e3159 = (_e2719 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3151)) - 8388608f) * _e3063)) ^ _e74)));
                                            let _e3165 = select(_e3151, 0u, (select(select(_e2762, _e3159, (_e3159 < _e2762)), _e2762, (_e3151 == 1023u)) > _e2906));
                                            if (_e3165 < 1023u) {
                                                phi_5504_ = (_e3165 + 1u);
                                            } else {
                                                phi_5504_ = _e3165;
                                            }
                                            let _e3169 = phi_5504_;
                                            let _e3177 = (_e2719 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3165)) - 8388608f) * _e3063)) ^ _e74)));
                                            let _e3193 = (_e2719 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3169)) - 8388608f) * _e3063)) ^ _e74)));
                                            let _e3207 = (_e2911 - _e2734);
                                            let _e3212 = bitcast<f32>((bitcast<u32>(((_e2777 - _e2734) * 0.0009775171f)) ^ _e74));
                                            let _e3213 = (_e3212 > 0f);
                                            if _e3213 {
                                                phi_5583_ = (_e3207 / _e3212);
                                            } else {
                                                phi_5583_ = 0f;
                                            }
                                            let _e3216 = phi_5583_;
                                            let _e3218 = select(1023f, _e3216, (_e3216 < 1023f));
                                            let _e3226 = bitcast<u32>(select(0i, select(select(i32(_e3218), i32(-2147483648), (_e3218 < -2147483600f)), 2147483647i, (_e3218 > 2147483500f)), (_e3218 == _e3218)));
                                            if (_e3226 > 0u) {
                                                let _e3235 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3226)) - 8388608f) * _e3212)) ^ _e74)) > _e3207);
                                                if _e3235 {
                                                    phi_5616_ = (_e3226 - 1u);
                                                } else {
                                                    phi_5616_ = u32();
                                                }
                                                let _e3238 = phi_5616_;
                                                phi_5618_ = _e3238;
                                                phi_5619_ = select(true, false, _e3235);
                                            } else {
                                                phi_5618_ = u32();
                                                phi_5619_ = true;
                                            }
                                            let _e3241 = phi_5618_;
                                            let _e3243 = phi_5619_;
                                            if _e3243 {
                                                if (_e3226 < 1023u) {
                                                    let _e3245 = (_e3226 + 1u);
                                                    phi_5641_ = select(_e3226, _e3245, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3245)) - 8388608f) * _e3212)) ^ _e74)) <= _e3207));
                                                } else {
                                                    phi_5641_ = _e3226;
                                                }
                                                let _e3256 = phi_5641_;
                                                phi_5642_ = _e3256;
                                            } else {
                                                phi_5642_ = _e3241;
                                            }
                                            let _e3258 = phi_5642_;
                                            if (_e3258 > 0u) {
                                                let _e3267 = (_e2734 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3258)) - 8388608f) * _e3212)) ^ _e74)));
                                                let _e3272 = (select(select(_e2777, _e3267, (_e3267 < _e2777)), _e2777, (_e3258 == 1023u)) > _e2911);
                                                if _e3272 {
                                                    phi_5677_ = (_e3258 - 1u);
                                                } else {
                                                    phi_5677_ = u32();
                                                }
                                                let _e3275 = phi_5677_;
                                                phi_5679_ = _e3275;
                                                phi_5680_ = select(true, false, _e3272);
                                            } else {
                                                phi_5679_ = u32();
                                                phi_5680_ = true;
                                            }
                                            let _e3278 = phi_5679_;
                                            let _e3280 = phi_5680_;
                                            if _e3280 {
                                                if (_e3258 < 1023u) {
                                                    let _e3282 = (_e3258 + 1u);
                                                    let _e3290 = (_e2734 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3282)) - 8388608f) * _e3212)) ^ _e74)));
                                                    phi_5720_ = select(_e3258, _e3282, (select(select(_e2777, _e3290, (_e3290 < _e2777)), _e2777, (_e3282 == 1023u)) <= _e2911));
                                                } else {
                                                    phi_5720_ = _e3258;
                                                }
                                                let _e3298 = phi_5720_;
                                                phi_5721_ = _e3298;
                                            } else {
                                                phi_5721_ = _e3278;
                                            }
                                            let _e3300 = phi_5721_;
                                            let _e3308 = (_e2734 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3300)) - 8388608f) * _e3212)) ^ _e74)));
                                            let _e3314 = select(_e3300, 0u, (select(select(_e2777, _e3308, (_e3308 < _e2777)), _e2777, (_e3300 == 1023u)) > _e2911));
                                            if (_e3314 < 1023u) {
                                                phi_5757_ = (_e3314 + 1u);
                                            } else {
                                                phi_5757_ = _e3314;
                                            }
                                            let _e3318 = phi_5757_;
                                            let _e3326 = (_e2734 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3314)) - 8388608f) * _e3212)) ^ _e74)));
                                            let _e3342 = (_e2734 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3318)) - 8388608f) * _e3212)) ^ _e74)));
                                            let _e3360 = global_2.member[_e2894].member[3u];
                                            let _e3365 = global_2.member[_e2894].member[4u];
                                            let _e3370 = global_2.member[_e2894].member[5u];
                                            let _e3371 = (_e3360 - _e2704);
                                            if _e2918 {
                                                phi_5842_ = (_e3371 / _e2917);
                                            } else {
                                                phi_5842_ = 0f;
                                            }
                                            let _e3374 = phi_5842_;
                                            let _e3376 = select(1023f, _e3374, (_e3374 < 1023f));
                                            let _e3384 = bitcast<u32>(select(0i, select(select(i32(_e3376), i32(-2147483648), (_e3376 < -2147483600f)), 2147483647i, (_e3376 > 2147483500f)), (_e3376 == _e3376)));
                                            if (_e3384 > 0u) {
                                                let _e3393 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3384)) - 8388608f) * _e2917)) ^ _e74)) > _e3371);
                                                if _e3393 {
                                                    phi_5875_ = (_e3384 - 1u);
                                                } else {
                                                    phi_5875_ = u32();
                                                }
                                                let _e3396 = phi_5875_;
                                                phi_5877_ = _e3396;
                                                phi_5878_ = select(true, false, _e3393);
                                            } else {
                                                phi_5877_ = u32();
                                                phi_5878_ = true;
                                            }
                                            let _e3399 = phi_5877_;
                                            let _e3401 = phi_5878_;
                                            if _e3401 {
                                                if (_e3384 < 1023u) {
                                                    let _e3403 = (_e3384 + 1u);
                                                    phi_5900_ = select(_e3384, _e3403, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3403)) - 8388608f) * _e2917)) ^ _e74)) <= _e3371));
                                                } else {
                                                    phi_5900_ = _e3384;
                                                }
                                                let _e3414 = phi_5900_;
                                                phi_5901_ = _e3414;
                                            } else {
                                                phi_5901_ = _e3399;
                                            }
                                            let _e3416 = phi_5901_;
                                            if (_e3416 > 0u) {
                                                let _e3425 = (_e2704 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3416)) - 8388608f) * _e2917)) ^ _e74)));
                                                let _e3430 = (select(select(_e2747, _e3425, (_e3425 < _e2747)), _e2747, (_e3416 == 1023u)) > _e3360);
                                                if _e3430 {
                                                    phi_5936_ = (_e3416 - 1u);
                                                } else {
                                                    phi_5936_ = u32();
                                                }
                                                let _e3433 = phi_5936_;
                                                phi_5938_ = _e3433;
                                                phi_5939_ = select(true, false, _e3430);
                                            } else {
                                                phi_5938_ = u32();
                                                phi_5939_ = true;
                                            }
                                            let _e3436 = phi_5938_;
                                            let _e3438 = phi_5939_;
                                            if _e3438 {
                                                if (_e3416 < 1023u) {
                                                    let _e3440 = (_e3416 + 1u);
                                                    let _e3448 = (_e2704 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3440)) - 8388608f) * _e2917)) ^ _e74)));
                                                    phi_5979_ = select(_e3416, _e3440, (select(select(_e2747, _e3448, (_e3448 < _e2747)), _e2747, (_e3440 == 1023u)) <= _e3360));
                                                } else {
                                                    phi_5979_ = _e3416;
                                                }
                                                let _e3456 = phi_5979_;
                                                phi_5980_ = _e3456;
                                            } else {
                                                phi_5980_ = _e3436;
                                            }
                                            let _e3458 = phi_5980_;
                                            let _e3466 = (_e2704 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3458)) - 8388608f) * _e2917)) ^ _e74)));
                                            let _e3472 = select(_e3458, 0u, (select(select(_e2747, _e3466, (_e3466 < _e2747)), _e2747, (_e3458 == 1023u)) > _e3360));
                                            if (_e3472 < 1023u) {
                                                phi_6016_ = (_e3472 + 1u);
                                            } else {
                                                phi_6016_ = _e3472;
                                            }
                                            let _e3476 = phi_6016_;
                                            let _e3484 = (_e2704 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3472)) - 8388608f) * _e2917)) ^ _e74)));
                                            let _e3500 = (_e2704 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3476)) - 8388608f) * _e2917)) ^ _e74)));
                                            let _e3511 = (_e3365 - _e2719);
                                            if _e3064 {
                                                phi_6093_ = (_e3511 / _e3063);
                                            } else {
                                                phi_6093_ = 0f;
                                            }
                                            let _e3514 = phi_6093_;
                                            let _e3516 = select(1023f, _e3514, (_e3514 < 1023f));
                                            let _e3524 = bitcast<u32>(select(0i, select(select(i32(_e3516), i32(-2147483648), (_e3516 < -2147483600f)), 2147483647i, (_e3516 > 2147483500f)), (_e3516 == _e3516)));
                                            if (_e3524 > 0u) {
                                                let _e3533 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3524)) - 8388608f) * _e3063)) ^ _e74)) > _e3511);
                                                if _e3533 {
                                                    phi_6126_ = (_e3524 - 1u);
                                                } else {
                                                    phi_6126_ = u32();
                                                }
                                                let _e3536 = phi_6126_;
                                                phi_6128_ = _e3536;
                                                phi_6129_ = select(true, false, _e3533);
                                            } else {
                                                phi_6128_ = u32();
                                                phi_6129_ = true;
                                            }
                                            let _e3539 = phi_6128_;
                                            let _e3541 = phi_6129_;
                                            if _e3541 {
                                                if (_e3524 < 1023u) {
                                                    let _e3543 = (_e3524 + 1u);
                                                    phi_6151_ = select(_e3524, _e3543, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3543)) - 8388608f) * _e3063)) ^ _e74)) <= _e3511));
                                                } else {
                                                    phi_6151_ = _e3524;
                                                }
                                                let _e3554 = phi_6151_;
                                                phi_6152_ = _e3554;
                                            } else {
                                                phi_6152_ = _e3539;
                                            }
                                            let _e3556 = phi_6152_;
                                            if (_e3556 > 0u) {
                                                let _e3565 = (_e2719 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3556)) - 8388608f) * _e3063)) ^ _e74)));
                                                let _e3570 = (select(select(_e2762, _e3565, (_e3565 < _e2762)), _e2762, (_e3556 == 1023u)) > _e3365);
                                                if _e3570 {
                                                    phi_6187_ = (_e3556 - 1u);
                                                } else {
                                                    phi_6187_ = u32();
                                                }
                                                let _e3573 = phi_6187_;
                                                phi_6189_ = _e3573;
                                                phi_6190_ = select(true, false, _e3570);
                                            } else {
                                                phi_6189_ = u32();
                                                phi_6190_ = true;
                                            }
                                            let _e3576 = phi_6189_;
                                            let _e3578 = phi_6190_;
                                            if _e3578 {
                                                if (_e3556 < 1023u) {
                                                    let _e3580 = (_e3556 + 1u);
                                                    let _e3588 = (_e2719 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3580)) - 8388608f) * _e3063)) ^ _e74)));
                                                    phi_6230_ = select(_e3556, _e3580, (select(select(_e2762, _e3588, (_e3588 < _e2762)), _e2762, (_e3580 == 1023u)) <= _e3365));
                                                } else {
                                                    phi_6230_ = _e3556;
                                                }
                                                let _e3596 = phi_6230_;
                                                phi_6231_ = _e3596;
                                            } else {
                                                phi_6231_ = _e3576;
                                            }
                                            let _e3598 = phi_6231_;
                                            let _e3606 = (_e2719 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3598)) - 8388608f) * _e3063)) ^ _e74)));
                                            let _e3612 = select(_e3598, 0u, (select(select(_e2762, _e3606, (_e3606 < _e2762)), _e2762, (_e3598 == 1023u)) > _e3365));
                                            if (_e3612 < 1023u) {
                                                phi_6267_ = (_e3612 + 1u);
                                            } else {
                                                phi_6267_ = _e3612;
                                            }
                                            let _e3616 = phi_6267_;
                                            let _e3624 = (_e2719 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3612)) - 8388608f) * _e3063)) ^ _e74)));
                                            let _e3640 = (_e2719 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3616)) - 8388608f) * _e3063)) ^ _e74)));
                                            let _e3654 = (_e3370 - _e2734);
                                            if _e3213 {
                                                phi_6346_ = (_e3654 / _e3212);
                                            } else {
                                                phi_6346_ = 0f;
                                            }
                                            let _e3657 = phi_6346_;
                                            let _e3659 = select(1023f, _e3657, (_e3657 < 1023f));
                                            let _e3667 = bitcast<u32>(select(0i, select(select(i32(_e3659), i32(-2147483648), (_e3659 < -2147483600f)), 2147483647i, (_e3659 > 2147483500f)), (_e3659 == _e3659)));
                                            if (_e3667 > 0u) {
                                                let _e3676 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3667)) - 8388608f) * _e3212)) ^ _e74)) > _e3654);
                                                if _e3676 {
                                                    phi_6379_ = (_e3667 - 1u);
                                                } else {
                                                    phi_6379_ = u32();
                                                }
                                                let _e3679 = phi_6379_;
                                                phi_6381_ = _e3679;
                                                phi_6382_ = select(true, false, _e3676);
                                            } else {
                                                phi_6381_ = u32();
                                                phi_6382_ = true;
                                            }
                                            let _e3682 = phi_6381_;
                                            let _e3684 = phi_6382_;
                                            if _e3684 {
                                                if (_e3667 < 1023u) {
                                                    let _e3686 = (_e3667 + 1u);
                                                    phi_6404_ = select(_e3667, _e3686, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3686)) - 8388608f) * _e3212)) ^ _e74)) <= _e3654));
                                                } else {
                                                    phi_6404_ = _e3667;
                                                }
                                                let _e3697 = phi_6404_;
                                                phi_6405_ = _e3697;
                                            } else {
                                                phi_6405_ = _e3682;
                                            }
                                            let _e3699 = phi_6405_;
                                            if (_e3699 > 0u) {
                                                let _e3708 = (_e2734 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3699)) - 8388608f) * _e3212)) ^ _e74)));
                                                let _e3713 = (select(select(_e2777, _e3708, (_e3708 < _e2777)), _e2777, (_e3699 == 1023u)) > _e3370);
                                                if _e3713 {
                                                    phi_6440_ = (_e3699 - 1u);
                                                } else {
                                                    phi_6440_ = u32();
                                                }
                                                let _e3716 = phi_6440_;
                                                phi_6442_ = _e3716;
                                                phi_6443_ = select(true, false, _e3713);
                                            } else {
                                                phi_6442_ = u32();
                                                phi_6443_ = true;
                                            }
                                            let _e3719 = phi_6442_;
                                            let _e3721 = phi_6443_;
                                            if _e3721 {
                                                if (_e3699 < 1023u) {
                                                    let _e3723 = (_e3699 + 1u);
                                                    let _e3731 = (_e2734 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3723)) - 8388608f) * _e3212)) ^ _e74)));
                                                    phi_6483_ = select(_e3699, _e3723, (select(select(_e2777, _e3731, (_e3731 < _e2777)), _e2777, (_e3723 == 1023u)) <= _e3370));
                                                } else {
                                                    phi_6483_ = _e3699;
                                                }
                                                let _e3739 = phi_6483_;
                                                phi_6484_ = _e3739;
                                            } else {
                                                phi_6484_ = _e3719;
                                            }
                                            let _e3741 = phi_6484_;
                                            let _e3749 = (_e2734 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3741)) - 8388608f) * _e3212)) ^ _e74)));
                                            let _e3755 = select(_e3741, 0u, (select(select(_e2777, _e3749, (_e3749 < _e2777)), _e2777, (_e3741 == 1023u)) > _e3370));
                                            if (_e3755 < 1023u) {
                                                phi_6520_ = (_e3755 + 1u);
                                            } else {
                                                phi_6520_ = _e3755;
                                            }
                                            let _e3759 = phi_6520_;
                                            let _e3767 = (_e2734 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3755)) - 8388608f) * _e3212)) ^ _e74)));
                                            let _e3783 = (_e2734 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3759)) - 8388608f) * _e3212)) ^ _e74)));
                                            let _e3801 = global_2.member[_e2894].member[6u];
                                            let _e3806 = global_2.member[_e2894].member[7u];
                                            let _e3811 = global_2.member[_e2894].member[8u];
                                            let _e3812 = (_e3801 - _e2704);
                                            if _e2918 {
                                                phi_6605_ = (_e3812 / _e2917);
                                            } else {
                                                phi_6605_ = 0f;
                                            }
                                            let _e3815 = phi_6605_;
                                            let _e3817 = select(1023f, _e3815, (_e3815 < 1023f));
                                            let _e3825 = bitcast<u32>(select(0i, select(select(i32(_e3817), i32(-2147483648), (_e3817 < -2147483600f)), 2147483647i, (_e3817 > 2147483500f)), (_e3817 == _e3817)));
                                            if (_e3825 > 0u) {
                                                let _e3834 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3825)) - 8388608f) * _e2917)) ^ _e74)) > _e3812);
                                                if _e3834 {
                                                    phi_6638_ = (_e3825 - 1u);
                                                } else {
                                                    phi_6638_ = u32();
                                                }
                                                let _e3837 = phi_6638_;
                                                phi_6640_ = _e3837;
                                                phi_6641_ = select(true, false, _e3834);
                                            } else {
                                                phi_6640_ = u32();
                                                phi_6641_ = true;
                                            }
                                            let _e3840 = phi_6640_;
                                            let _e3842 = phi_6641_;
                                            if _e3842 {
                                                if (_e3825 < 1023u) {
                                                    let _e3844 = (_e3825 + 1u);
                                                    phi_6663_ = select(_e3825, _e3844, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3844)) - 8388608f) * _e2917)) ^ _e74)) <= _e3812));
                                                } else {
                                                    phi_6663_ = _e3825;
                                                }
                                                let _e3855 = phi_6663_;
                                                phi_6664_ = _e3855;
                                            } else {
                                                phi_6664_ = _e3840;
                                            }
                                            let _e3857 = phi_6664_;
                                            if (_e3857 > 0u) {
                                                let _e3866 = (_e2704 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3857)) - 8388608f) * _e2917)) ^ _e74)));
                                                let _e3871 = (select(select(_e2747, _e3866, (_e3866 < _e2747)), _e2747, (_e3857 == 1023u)) > _e3801);
                                                if _e3871 {
                                                    phi_6699_ = (_e3857 - 1u);
                                                } else {
                                                    phi_6699_ = u32();
                                                }
                                                let _e3874 = phi_6699_;
                                                phi_6701_ = _e3874;
                                                phi_6702_ = select(true, false, _e3871);
                                            } else {
                                                phi_6701_ = u32();
                                                phi_6702_ = true;
                                            }
                                            let _e3877 = phi_6701_;
                                            let _e3879 = phi_6702_;
                                            if _e3879 {
                                                if (_e3857 < 1023u) {
                                                    let _e3881 = (_e3857 + 1u);
                                                    let _e3889 = (_e2704 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3881)) - 8388608f) * _e2917)) ^ _e74)));
                                                    phi_6742_ = select(_e3857, _e3881, (select(select(_e2747, _e3889, (_e3889 < _e2747)), _e2747, (_e3881 == 1023u)) <= _e3801));
                                                } else {
                                                    phi_6742_ = _e3857;
                                                }
                                                let _e3897 = phi_6742_;
                                                phi_6743_ = _e3897;
                                            } else {
                                                phi_6743_ = _e3877;
                                            }
                                            let _e3899 = phi_6743_;
                                            let _e3907 = (_e2704 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3899)) - 8388608f) * _e2917)) ^ _e74)));
                                            let _e3913 = select(_e3899, 0u, (select(select(_e2747, _e3907, (_e3907 < _e2747)), _e2747, (_e3899 == 1023u)) > _e3801));
                                            if (_e3913 < 1023u) {
                                                phi_6779_ = (_e3913 + 1u);
                                            } else {
                                                phi_6779_ = _e3913;
                                            }
                                            let _e3917 = phi_6779_;
                                            let _e3925 = (_e2704 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3913)) - 8388608f) * _e2917)) ^ _e74)));
                                            let _e3941 = (_e2704 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3917)) - 8388608f) * _e2917)) ^ _e74)));
                                            let _e3952 = (_e3806 - _e2719);
                                            if _e3064 {
                                                phi_6856_ = (_e3952 / _e3063);
                                            } else {
                                                phi_6856_ = 0f;
                                            }
                                            let _e3955 = phi_6856_;
                                            let _e3957 = select(1023f, _e3955, (_e3955 < 1023f));
                                            let _e3965 = bitcast<u32>(select(0i, select(select(i32(_e3957), i32(-2147483648), (_e3957 < -2147483600f)), 2147483647i, (_e3957 > 2147483500f)), (_e3957 == _e3957)));
                                            if (_e3965 > 0u) {
                                                let _e3974 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3965)) - 8388608f) * _e3063)) ^ _e74)) > _e3952);
                                                if _e3974 {
                                                    phi_6889_ = (_e3965 - 1u);
                                                } else {
                                                    phi_6889_ = u32();
                                                }
                                                let _e3977 = phi_6889_;
                                                phi_6891_ = _e3977;
                                                phi_6892_ = select(true, false, _e3974);
                                            } else {
                                                phi_6891_ = u32();
                                                phi_6892_ = true;
                                            }
                                            let _e3980 = phi_6891_;
                                            let _e3982 = phi_6892_;
                                            if _e3982 {
                                                if (_e3965 < 1023u) {
                                                    let _e3984 = (_e3965 + 1u);
                                                    phi_6914_ = select(_e3965, _e3984, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3984)) - 8388608f) * _e3063)) ^ _e74)) <= _e3952));
                                                } else {
                                                    phi_6914_ = _e3965;
                                                }
                                                let _e3995 = phi_6914_;
                                                phi_6915_ = _e3995;
                                            } else {
                                                phi_6915_ = _e3980;
                                            }
                                            let _e3997 = phi_6915_;
                                            if (_e3997 > 0u) {
                                                let _e4006 = (_e2719 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e3997)) - 8388608f) * _e3063)) ^ _e74)));
                                                let _e4011 = (select(select(_e2762, _e4006, (_e4006 < _e2762)), _e2762, (_e3997 == 1023u)) > _e3806);
                                                if _e4011 {
                                                    phi_6950_ = (_e3997 - 1u);
                                                } else {
                                                    phi_6950_ = u32();
                                                }
                                                let _e4014 = phi_6950_;
                                                phi_6952_ = _e4014;
                                                phi_6953_ = select(true, false, _e4011);
                                            } else {
                                                phi_6952_ = u32();
                                                phi_6953_ = true;
                                            }
                                            let _e4017 = phi_6952_;
                                            let _e4019 = phi_6953_;
                                            if _e4019 {
                                                if (_e3997 < 1023u) {
                                                    let _e4021 = (_e3997 + 1u);
                                                    let _e4029 = (_e2719 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4021)) - 8388608f) * _e3063)) ^ _e74)));
                                                    phi_6993_ = select(_e3997, _e4021, (select(select(_e2762, _e4029, (_e4029 < _e2762)), _e2762, (_e4021 == 1023u)) <= _e3806));
                                                } else {
                                                    phi_6993_ = _e3997;
                                                }
                                                let _e4037 = phi_6993_;
                                                phi_6994_ = _e4037;
                                            } else {
                                                phi_6994_ = _e4017;
                                            }
                                            let _e4039 = phi_6994_;
                                            let _e4047 = (_e2719 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4039)) - 8388608f) * _e3063)) ^ _e74)));
                                            let _e4053 = select(_e4039, 0u, (select(select(_e2762, _e4047, (_e4047 < _e2762)), _e2762, (_e4039 == 1023u)) > _e3806));
                                            if (_e4053 < 1023u) {
                                                phi_7030_ = (_e4053 + 1u);
                                            } else {
                                                phi_7030_ = _e4053;
                                            }
                                            let _e4057 = phi_7030_;
                                            let _e4065 = (_e2719 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4053)) - 8388608f) * _e3063)) ^ _e74)));
                                            let _e4081 = (_e2719 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4057)) - 8388608f) * _e3063)) ^ _e74)));
                                            let _e4095 = (_e3811 - _e2734);
                                            if _e3213 {
                                                phi_7109_ = (_e4095 / _e3212);
                                            } else {
                                                phi_7109_ = 0f;
                                            }
                                            let _e4098 = phi_7109_;
                                            let _e4100 = select(1023f, _e4098, (_e4098 < 1023f));
                                            let _e4108 = bitcast<u32>(select(0i, select(select(i32(_e4100), i32(-2147483648), (_e4100 < -2147483600f)), 2147483647i, (_e4100 > 2147483500f)), (_e4100 == _e4100)));
                                            if (_e4108 > 0u) {
                                                let _e4117 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4108)) - 8388608f) * _e3212)) ^ _e74)) > _e4095);
                                                if _e4117 {
                                                    phi_7142_ = (_e4108 - 1u);
                                                } else {
                                                    phi_7142_ = u32();
                                                }
                                                let _e4120 = phi_7142_;
                                                phi_7144_ = _e4120;
                                                phi_7145_ = select(true, false, _e4117);
                                            } else {
                                                phi_7144_ = u32();
                                                phi_7145_ = true;
                                            }
                                            let _e4123 = phi_7144_;
                                            let _e4125 = phi_7145_;
                                            if _e4125 {
                                                if (_e4108 < 1023u) {
                                                    let _e4127 = (_e4108 + 1u);
                                                    phi_7167_ = select(_e4108, _e4127, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4127)) - 8388608f) * _e3212)) ^ _e74)) <= _e4095));
                                                } else {
                                                    phi_7167_ = _e4108;
                                                }
                                                let _e4138 = phi_7167_;
                                                phi_7168_ = _e4138;
                                            } else {
                                                phi_7168_ = _e4123;
                                            }
                                            let _e4140 = phi_7168_;
                                            if (_e4140 > 0u) {
                                                let _e4149 = (_e2734 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4140)) - 8388608f) * _e3212)) ^ _e74)));
                                                let _e4154 = (select(select(_e2777, _e4149, (_e4149 < _e2777)), _e2777, (_e4140 == 1023u)) > _e3811);
                                                if _e4154 {
                                                    phi_7203_ = (_e4140 - 1u);
                                                } else {
                                                    phi_7203_ = u32();
                                                }
                                                let _e4157 = phi_7203_;
                                                phi_7205_ = _e4157;
                                                phi_7206_ = select(true, false, _e4154);
                                            } else {
                                                phi_7205_ = u32();
                                                phi_7206_ = true;
                                            }
                                            let _e4160 = phi_7205_;
                                            let _e4162 = phi_7206_;
                                            if _e4162 {
                                                if (_e4140 < 1023u) {
                                                    let _e4164 = (_e4140 + 1u);
                                                    let _e4172 = (_e2734 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4164)) - 8388608f) * _e3212)) ^ _e74)));
                                                    phi_7246_ = select(_e4140, _e4164, (select(select(_e2777, _e4172, (_e4172 < _e2777)), _e2777, (_e4164 == 1023u)) <= _e3811));
                                                } else {
                                                    phi_7246_ = _e4140;
                                                }
                                                let _e4180 = phi_7246_;
                                                phi_7247_ = _e4180;
                                            } else {
                                                phi_7247_ = _e4160;
                                            }
                                            let _e4182 = phi_7247_;
                                            let _e4190 = (_e2734 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4182)) - 8388608f) * _e3212)) ^ _e74)));
                                            let _e4196 = select(_e4182, 0u, (select(select(_e2777, _e4190, (_e4190 < _e2777)), _e2777, (_e4182 == 1023u)) > _e3811));
                                            if (_e4196 < 1023u) {
                                                phi_7283_ = (_e4196 + 1u);
                                            } else {
                                                phi_7283_ = _e4196;
                                            }
                                            let _e4200 = phi_7283_;
                                            let _e4208 = (_e2734 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4196)) - 8388608f) * _e3212)) ^ _e74)));
                                            let _e4224 = (_e2734 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4200)) - 8388608f) * _e3212)) ^ _e74)));
                                            let _e4242 = global_2.member[_e2894].member_1;
                                            if _e2896 {
                                            } else {
                                                phi_9935_ = true;
                                                break;
                                            }
                                            global_6.member[_e2894] = type_43(array<u32, 3>(((select(_e3019, _e3023, (bitcast<f32>((bitcast<u32>((select(select(_e2747, _e3047, (_e3047 < _e2747)), _e2747, (_e3023 == 1023u)) - _e2901)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e2901 - select(select(_e2747, _e3031, (_e3031 < _e2747)), _e2747, (_e3019 == 1023u)))) & 2147483647u)))) | (select(_e3165, _e3169, (bitcast<f32>((bitcast<u32>((select(select(_e2762, _e3193, (_e3193 < _e2762)), _e2762, (_e3169 == 1023u)) - _e2906)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e2906 - select(select(_e2762, _e3177, (_e3177 < _e2762)), _e2762, (_e3165 == 1023u)))) & 2147483647u)))) << bitcast<u32>(10i))) | (select(_e3314, _e3318, (bitcast<f32>((bitcast<u32>((select(select(_e2777, _e3342, (_e3342 < _e2777)), _e2777, (_e3318 == 1023u)) - _e2911)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e2911 - select(select(_e2777, _e3326, (_e3326 < _e2777)), _e2777, (_e3314 == 1023u)))) & 2147483647u)))) << bitcast<u32>(20i))), ((select(_e3472, _e3476, (bitcast<f32>((bitcast<u32>((select(select(_e2747, _e3500, (_e3500 < _e2747)), _e2747, (_e3476 == 1023u)) - _e3360)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e3360 - select(select(_e2747, _e3484, (_e3484 < _e2747)), _e2747, (_e3472 == 1023u)))) & 2147483647u)))) | (select(_e3612, _e3616, (bitcast<f32>((bitcast<u32>((select(select(_e2762, _e3640, (_e3640 < _e2762)), _e2762, (_e3616 == 1023u)) - _e3365)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e3365 - select(select(_e2762, _e3624, (_e3624 < _e2762)), _e2762, (_e3612 == 1023u)))) & 2147483647u)))) << bitcast<u32>(10i))) | (select(_e3755, _e3759, (bitcast<f32>((bitcast<u32>((select(select(_e2777, _e3783, (_e3783 < _e2777)), _e2777, (_e3759 == 1023u)) - _e3370)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e3370 - select(select(_e2777, _e3767, (_e3767 < _e2777)), _e2777, (_e3755 == 1023u)))) & 2147483647u)))) << bitcast<u32>(20i))), ((select(_e3913, _e3917, (bitcast<f32>((bitcast<u32>((select(select(_e2747, _e3941, (_e3941 < _e2747)), _e2747, (_e3917 == 1023u)) - _e3801)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e3801 - select(select(_e2747, _e3925, (_e3925 < _e2747)), _e2747, (_e3913 == 1023u)))) & 2147483647u)))) | (select(_e4053, _e4057, (bitcast<f32>((bitcast<u32>((select(select(_e2762, _e4081, (_e4081 < _e2762)), _e2762, (_e4057 == 1023u)) - _e3806)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e3806 - select(select(_e2762, _e4065, (_e4065 < _e2762)), _e2762, (_e4053 == 1023u)))) & 2147483647u)))) << bitcast<u32>(10i))) | (select(_e4196, _e4200, (bitcast<f32>((bitcast<u32>((select(select(_e2777, _e4224, (_e4224 < _e2777)), _e2777, (_e4200 == 1023u)) - _e3811)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e3811 - select(select(_e2777, _e4208, (_e4208 < _e2777)), _e2777, (_e4196 == 1023u)))) & 2147483647u)))) << bitcast<u32>(20i)))), _e4242);
                                        }
                                    }
                                }
                                continue;
                                continuing {
                                    phi_5012_ = _e2886;
                                    phi_9935_ = _e1102;
                                    break if !(_e2892);
                                }
                            }
                            let _e4248 = phi_9935_;
                            if _e4248 {
                                break;
                            }
                            phi_10472_ = _e4248;
                        } else {
                            phi_10472_ = _e1102;
                        }
                        let _e4250 = phi_10472_;
                        if _e70 {
                        } else {
                            break;
                        }
                        if ((_e1137 & 2147483648u) != 0u) {
                            phi_7378_ = type_4(0u, ((_e1137 >> bitcast<u32>(28u)) & 7u));
                            loop {
                                let _e4258 = phi_7378_;
                                if (_e4258.member < _e4258.member_1) {
                                    phi_7379_ = type_4((_e4258.member + 1u), _e4258.member_1);
                                    phi_7402_ = type_4(1u, _e4258.member);
                                } else {
                                    phi_7379_ = _e4258;
                                    phi_7402_ = type_4(0u, type_4().member_1);
                                }
                                let _e4271 = phi_7379_;
                                let _e4273 = phi_7402_;
                                let _e4277 = (bitcast<i32>(_e4273.member) != 0i);
                                if _e4277 {
                                    let _e4279 = ((_e1137 & 268435455u) + _e4273.member_1);
                                    let _e4280 = (_e4279 < _e55);
                                    if _e4280 {
                                        let _e4281 = (_e4279 < _e59);
                                        if _e4281 {
                                            if _e4280 {
                                            } else {
                                                phi_10468_ = true;
                                                break;
                                            }
                                            let _e4286 = global_2.member[_e4279].member[0u];
                                            let _e4291 = global_2.member[_e4279].member[1u];
                                            let _e4296 = global_2.member[_e4279].member[2u];
                                            let _e4297 = (_e4286 - _e2790);
                                            let _e4302 = bitcast<f32>((bitcast<u32>(((_e2833 - _e2790) * 0.0009775171f)) ^ _e74));
                                            let _e4303 = (_e4302 > 0f);
                                            if _e4303 {
                                                phi_7445_ = (_e4297 / _e4302);
                                            } else {
                                                phi_7445_ = 0f;
                                            }
                                            let _e4306 = phi_7445_;
                                            let _e4308 = select(1023f, _e4306, (_e4306 < 1023f));
                                            let _e4316 = bitcast<u32>(select(0i, select(select(i32(_e4308), i32(-2147483648), (_e4308 < -2147483600f)), 2147483647i, (_e4308 > 2147483500f)), (_e4308 == _e4308)));
                                            if (_e4316 > 0u) {
                                                let _e4325 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4316)) - 8388608f) * _e4302)) ^ _e74)) > _e4297);
                                                if _e4325 {
                                                    phi_7478_ = (_e4316 - 1u);
                                                } else {
                                                    phi_7478_ = u32();
                                                }
                                                let _e4328 = phi_7478_;
                                                phi_7480_ = _e4328;
                                                phi_7481_ = select(true, false, _e4325);
                                            } else {
                                                phi_7480_ = u32();
                                                phi_7481_ = true;
                                            }
                                            let _e4331 = phi_7480_;
                                            let _e4333 = phi_7481_;
                                            if _e4333 {
                                                if (_e4316 < 1023u) {
                                                    let _e4335 = (_e4316 + 1u);
                                                    phi_7503_ = select(_e4316, _e4335, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4335)) - 8388608f) * _e4302)) ^ _e74)) <= _e4297));
                                                } else {
                                                    phi_7503_ = _e4316;
                                                }
                                                let _e4346 = phi_7503_;
                                                phi_7504_ = _e4346;
                                            } else {
                                                phi_7504_ = _e4331;
                                            }
                                            let _e4348 = phi_7504_;
                                            if (_e4348 > 0u) {
                                                let _e4357 = (_e2790 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4348)) - 8388608f) * _e4302)) ^ _e74)));
                                                let _e4362 = (select(select(_e2833, _e4357, (_e4357 < _e2833)), _e2833, (_e4348 == 1023u)) > _e4286);
                                                if _e4362 {
                                                    phi_7539_ = (_e4348 - 1u);
                                                } else {
                                                    phi_7539_ = u32();
                                                }
                                                let _e4365 = phi_7539_;
                                                phi_7541_ = _e4365;
                                                phi_7542_ = select(true, false, _e4362);
                                            } else {
                                                phi_7541_ = u32();
                                                phi_7542_ = true;
                                            }
                                            let _e4368 = phi_7541_;
                                            let _e4370 = phi_7542_;
                                            if _e4370 {
                                                if (_e4348 < 1023u) {
                                                    let _e4372 = (_e4348 + 1u);
                                                    let _e4380 = (_e2790 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4372)) - 8388608f) * _e4302)) ^ _e74)));
                                                    phi_7582_ = select(_e4348, _e4372, (select(select(_e2833, _e4380, (_e4380 < _e2833)), _e2833, (_e4372 == 1023u)) <= _e4286));
                                                } else {
                                                    phi_7582_ = _e4348;
                                                }
                                                let _e4388 = phi_7582_;
                                                phi_7583_ = _e4388;
                                            } else {
                                                phi_7583_ = _e4368;
                                            }
                                            let _e4390 = phi_7583_;
                                            let _e4398 = (_e2790 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4390)) - 8388608f) * _e4302)) ^ _e74)));
                                            let _e4404 = select(_e4390, 0u, (select(select(_e2833, _e4398, (_e4398 < _e2833)), _e2833, (_e4390 == 1023u)) > _e4286));
                                            if (_e4404 < 1023u) {
                                                phi_7619_ = (_e4404 + 1u);
                                            } else {
                                                phi_7619_ = _e4404;
                                            }
                                            let _e4408 = phi_7619_;
                                            let _e4416 = (_e2790 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4404)) - 8388608f) * _e4302)) ^ _e74)));
                                            let _e4432 = (_e2790 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4408)) - 8388608f) * _e4302)) ^ _e74)));
                                            let _e4443 = (_e4291 - _e2805);
                                            let _e4448 = bitcast<f32>((bitcast<u32>(((_e2848 - _e2805) * 0.0009775171f)) ^ _e74));
                                            let _e4449 = (_e4448 > 0f);
                                            if _e4449 {
                                                phi_7696_ = (_e4443 / _e4448);
                                            } else {
                                                phi_7696_ = 0f;
                                            }
                                            let _e4452 = phi_7696_;
                                            let _e4454 = select(1023f, _e4452, (_e4452 < 1023f));
                                            let _e4462 = bitcast<u32>(select(0i, select(select(i32(_e4454), i32(-2147483648), (_e4454 < -2147483600f)), 2147483647i, (_e4454 > 2147483500f)), (_e4454 == _e4454)));
                                            if (_e4462 > 0u) {
                                                let _e4471 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4462)) - 8388608f) * _e4448)) ^ _e74)) > _e4443);
                                                if _e4471 {
                                                    phi_7729_ = (_e4462 - 1u);
                                                } else {
                                                    phi_7729_ = u32();
                                                }
                                                let _e4474 = phi_7729_;
                                                phi_7731_ = _e4474;
                                                phi_7732_ = select(true, false, _e4471);
                                            } else {
                                                phi_7731_ = u32();
                                                phi_7732_ = true;
                                            }
                                            let _e4477 = phi_7731_;
                                            let _e4479 = phi_7732_;
                                            if _e4479 {
                                                if (_e4462 < 1023u) {
                                                    let _e4481 = (_e4462 + 1u);
                                                    phi_7754_ = select(_e4462, _e4481, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4481)) - 8388608f) * _e4448)) ^ _e74)) <= _e4443));
                                                } else {
                                                    phi_7754_ = _e4462;
                                                }
                                                let _e4492 = phi_7754_;
                                                phi_7755_ = _e4492;
                                            } else {
                                                phi_7755_ = _e4477;
                                            }
                                            let _e4494 = phi_7755_;
                                            if (_e4494 > 0u) {
                                                let _e4503 = (_e2805 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4494)) - 8388608f) * _e4448)) ^ _e74)));
                                                let _e4508 = (select(select(_e2848, _e4503, (_e4503 < _e2848)), _e2848, (_e4494 == 1023u)) > _e4291);
                                                if _e4508 {
                                                    phi_7790_ = (_e4494 - 1u);
                                                } else {
                                                    phi_7790_ = u32();
                                                }
                                                let _e4511 = phi_7790_;
                                                phi_7792_ = _e4511;
                                                phi_7793_ = select(true, false, _e4508);
                                            } else {
                                                phi_7792_ = u32();
                                                phi_7793_ = true;
                                            }
                                            let _e4514 = phi_7792_;
                                            let _e4516 = phi_7793_;
                                            if _e4516 {
                                                if (_e4494 < 1023u) {
                                                    let _e4518 = (_e4494 + 1u);
                                                    let _e4526 = (_e2805 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4518)) - 8388608f) * _e4448)) ^ _e74)));
                                                    phi_7833_ = select(_e4494, _e4518, (select(select(_e2848, _e4526, (_e4526 < _e2848)), _e2848, (_e4518 == 1023u)) <= _e4291));
                                                } else {
                                                    phi_7833_ = _e4494;
                                                }
                                                let _e4534 = phi_7833_;
                                                phi_7834_ = _e4534;
                                            } else {
                                                phi_7834_ = _e4514;
                                            }
                                            let _e4536 = phi_7834_;
                                            let _e4544 = (_e2805 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4536)) - 8388608f) * _e4448)) ^ _e74)));
                                            let _e4550 = select(_e4536, 0u, (select(select(_e2848, _e4544, (_e4544 < _e2848)), _e2848, (_e4536 == 1023u)) > _e4291));
                                            if (_e4550 < 1023u) {
                                                phi_7870_ = (_e4550 + 1u);
                                            } else {
                                                phi_7870_ = _e4550;
                                            }
                                            let _e4554 = phi_7870_;
                                            let _e4562 = (_e2805 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4550)) - 8388608f) * _e4448)) ^ _e74)));
                                            let _e4578 = (_e2805 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4554)) - 8388608f) * _e4448)) ^ _e74)));
                                            let _e4592 = (_e4296 - _e2820);
                                            let _e4597 = bitcast<f32>((bitcast<u32>(((_e2863 - _e2820) * 0.0009775171f)) ^ _e74));
                                            let _e4598 = (_e4597 > 0f);
                                            if _e4598 {
                                                phi_7949_ = (_e4592 / _e4597);
                                            } else {
                                                phi_7949_ = 0f;
                                            }
                                            let _e4601 = phi_7949_;
                                            let _e4603 = select(1023f, _e4601, (_e4601 < 1023f));
                                            let _e4611 = bitcast<u32>(select(0i, select(select(i32(_e4603), i32(-2147483648), (_e4603 < -2147483600f)), 2147483647i, (_e4603 > 2147483500f)), (_e4603 == _e4603)));
                                            if (_e4611 > 0u) {
                                                let _e4620 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4611)) - 8388608f) * _e4597)) ^ _e74)) > _e4592);
                                                if _e4620 {
                                                    phi_7982_ = (_e4611 - 1u);
                                                } else {
                                                    phi_7982_ = u32();
                                                }
                                                let _e4623 = phi_7982_;
                                                phi_7984_ = _e4623;
                                                phi_7985_ = select(true, false, _e4620);
                                            } else {
                                                phi_7984_ = u32();
                                                phi_7985_ = true;
                                            }
                                            let _e4626 = phi_7984_;
                                            let _e4628 = phi_7985_;
                                            if _e4628 {
                                                if (_e4611 < 1023u) {
                                                    let _e4630 = (_e4611 + 1u);
                                                    phi_8007_ = select(_e4611, _e4630, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4630)) - 8388608f) * _e4597)) ^ _e74)) <= _e4592));
                                                } else {
                                                    phi_8007_ = _e4611;
                                                }
                                                let _e4641 = phi_8007_;
                                                phi_8008_ = _e4641;
                                            } else {
                                                phi_8008_ = _e4626;
                                            }
                                            let _e4643 = phi_8008_;
                                            if (_e4643 > 0u) {
                                                let _e4652 = (_e2820 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4643)) - 8388608f) * _e4597)) ^ _e74)));
                                                let _e4657 = (select(select(_e2863, _e4652, (_e4652 < _e2863)), _e2863, (_e4643 == 1023u)) > _e4296);
                                                if _e4657 {
                                                    phi_8043_ = (_e4643 - 1u);
                                                } else {
                                                    phi_8043_ = u32();
                                                }
                                                let _e4660 = phi_8043_;
                                                phi_8045_ = _e4660;
                                                phi_8046_ = select(true, false, _e4657);
                                            } else {
                                                phi_8045_ = u32();
                                                phi_8046_ = true;
                                            }
                                            let _e4663 = phi_8045_;
                                            let _e4665 = phi_8046_;
                                            if _e4665 {
                                                if (_e4643 < 1023u) {
                                                    let _e4667 = (_e4643 + 1u);
                                                    let _e4675 = (_e2820 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4667)) - 8388608f) * _e4597)) ^ _e74)));
                                                    phi_8086_ = select(_e4643, _e4667, (select(select(_e2863, _e4675, (_e4675 < _e2863)), _e2863, (_e4667 == 1023u)) <= _e4296));
                                                } else {
                                                    phi_8086_ = _e4643;
                                                }
                                                let _e4683 = phi_8086_;
                                                phi_8087_ = _e4683;
                                            } else {
                                                phi_8087_ = _e4663;
                                            }
                                            let _e4685 = phi_8087_;
                                            let _e4693 = (_e2820 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4685)) - 8388608f) * _e4597)) ^ _e74)));
                                            let _e4699 = select(_e4685, 0u, (select(select(_e2863, _e4693, (_e4693 < _e2863)), _e2863, (_e4685 == 1023u)) > _e4296));
                                            if (_e4699 < 1023u) {
                                                phi_8123_ = (_e4699 + 1u);
                                            } else {
                                                phi_8123_ = _e4699;
                                            }
                                            let _e4703 = phi_8123_;
                                            let _e4711 = (_e2820 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4699)) - 8388608f) * _e4597)) ^ _e74)));
                                            let _e4727 = (_e2820 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4703)) - 8388608f) * _e4597)) ^ _e74)));
                                            let _e4745 = global_2.member[_e4279].member[3u];
                                            let _e4750 = global_2.member[_e4279].member[4u];
                                            let _e4755 = global_2.member[_e4279].member[5u];
                                            let _e4756 = (_e4745 - _e2790);
                                            if _e4303 {
                                                phi_8208_ = (_e4756 / _e4302);
                                            } else {
                                                phi_8208_ = 0f;
                                            }
                                            let _e4759 = phi_8208_;
                                            let _e4761 = select(1023f, _e4759, (_e4759 < 1023f));
                                            let _e4769 = bitcast<u32>(select(0i, select(select(i32(_e4761), i32(-2147483648), (_e4761 < -2147483600f)), 2147483647i, (_e4761 > 2147483500f)), (_e4761 == _e4761)));
                                            if (_e4769 > 0u) {
                                                let _e4778 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4769)) - 8388608f) * _e4302)) ^ _e74)) > _e4756);
                                                if _e4778 {
                                                    phi_8241_ = (_e4769 - 1u);
                                                } else {
                                                    phi_8241_ = u32();
                                                }
                                                let _e4781 = phi_8241_;
                                                phi_8243_ = _e4781;
                                                phi_8244_ = select(true, false, _e4778);
                                            } else {
                                                phi_8243_ = u32();
                                                phi_8244_ = true;
                                            }
                                            let _e4784 = phi_8243_;
                                            let _e4786 = phi_8244_;
                                            if _e4786 {
                                                if (_e4769 < 1023u) {
                                                    let _e4788 = (_e4769 + 1u);
                                                    phi_8266_ = select(_e4769, _e4788, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4788)) - 8388608f) * _e4302)) ^ _e74)) <= _e4756));
                                                } else {
                                                    phi_8266_ = _e4769;
                                                }
                                                let _e4799 = phi_8266_;
                                                phi_8267_ = _e4799;
                                            } else {
                                                phi_8267_ = _e4784;
                                            }
                                            let _e4801 = phi_8267_;
                                            if (_e4801 > 0u) {
                                                let _e4810 = (_e2790 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4801)) - 8388608f) * _e4302)) ^ _e74)));
                                                let _e4815 = (select(select(_e2833, _e4810, (_e4810 < _e2833)), _e2833, (_e4801 == 1023u)) > _e4745);
                                                if _e4815 {
                                                    phi_8302_ = (_e4801 - 1u);
                                                } else {
                                                    phi_8302_ = u32();
                                                }
                                                let _e4818 = phi_8302_;
                                                phi_8304_ = _e4818;
                                                phi_8305_ = select(true, false, _e4815);
                                            } else {
                                                phi_8304_ = u32();
                                                phi_8305_ = true;
                                            }
                                            let _e4821 = phi_8304_;
                                            let _e4823 = phi_8305_;
                                            if _e4823 {
                                                if (_e4801 < 1023u) {
                                                    let _e4825 = (_e4801 + 1u);
                                                    let _e4833 = (_e2790 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4825)) - 8388608f) * _e4302)) ^ _e74)));
                                                    phi_8345_ = select(_e4801, _e4825, (select(select(_e2833, _e4833, (_e4833 < _e2833)), _e2833, (_e4825 == 1023u)) <= _e4745));
                                                } else {
                                                    phi_8345_ = _e4801;
                                                }
                                                let _e4841 = phi_8345_;
                                                phi_8346_ = _e4841;
                                            } else {
                                                phi_8346_ = _e4821;
                                            }
                                            let _e4843 = phi_8346_;
                                            let _e4851 = (_e2790 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4843)) - 8388608f) * _e4302)) ^ _e74)));
                                            let _e4857 = select(_e4843, 0u, (select(select(_e2833, _e4851, (_e4851 < _e2833)), _e2833, (_e4843 == 1023u)) > _e4745));
                                            if (_e4857 < 1023u) {
                                                phi_8382_ = (_e4857 + 1u);
                                            } else {
                                                phi_8382_ = _e4857;
                                            }
                                            let _e4861 = phi_8382_;
                                            let _e4869 = (_e2790 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4857)) - 8388608f) * _e4302)) ^ _e74)));
                                            let _e4885 = (_e2790 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4861)) - 8388608f) * _e4302)) ^ _e74)));
                                            let _e4896 = (_e4750 - _e2805);
                                            if _e4449 {
                                                phi_8459_ = (_e4896 / _e4448);
                                            } else {
                                                phi_8459_ = 0f;
                                            }
                                            let _e4899 = phi_8459_;
                                            let _e4901 = select(1023f, _e4899, (_e4899 < 1023f));
                                            let _e4909 = bitcast<u32>(select(0i, select(select(i32(_e4901), i32(-2147483648), (_e4901 < -2147483600f)), 2147483647i, (_e4901 > 2147483500f)), (_e4901 == _e4901)));
                                            if (_e4909 > 0u) {
                                                let _e4918 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4909)) - 8388608f) * _e4448)) ^ _e74)) > _e4896);
                                                if _e4918 {
                                                    phi_8492_ = (_e4909 - 1u);
                                                } else {
                                                    phi_8492_ = u32();
                                                }
                                                let _e4921 = phi_8492_;
                                                phi_8494_ = _e4921;
                                                phi_8495_ = select(true, false, _e4918);
                                            } else {
                                                phi_8494_ = u32();
                                                phi_8495_ = true;
                                            }
                                            let _e4924 = phi_8494_;
                                            let _e4926 = phi_8495_;
                                            if _e4926 {
                                                if (_e4909 < 1023u) {
                                                    let _e4928 = (_e4909 + 1u);
                                                    phi_8517_ = select(_e4909, _e4928, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4928)) - 8388608f) * _e4448)) ^ _e74)) <= _e4896));
                                                } else {
                                                    phi_8517_ = _e4909;
                                                }
                                                let _e4939 = phi_8517_;
                                                phi_8518_ = _e4939;
                                            } else {
                                                phi_8518_ = _e4924;
                                            }
                                            let _e4941 = phi_8518_;
                                            if (_e4941 > 0u) {
                                                let _e4950 = (_e2805 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4941)) - 8388608f) * _e4448)) ^ _e74)));
                                                let _e4955 = (select(select(_e2848, _e4950, (_e4950 < _e2848)), _e2848, (_e4941 == 1023u)) > _e4750);
                                                if _e4955 {
                                                    phi_8553_ = (_e4941 - 1u);
                                                } else {
                                                    phi_8553_ = u32();
                                                }
                                                let _e4958 = phi_8553_;
                                                phi_8555_ = _e4958;
                                                phi_8556_ = select(true, false, _e4955);
                                            } else {
                                                phi_8555_ = u32();
                                                phi_8556_ = true;
                                            }
                                            let _e4961 = phi_8555_;
                                            let _e4963 = phi_8556_;
                                            if _e4963 {
                                                if (_e4941 < 1023u) {
                                                    let _e4965 = (_e4941 + 1u);
                                                    let _e4973 = (_e2805 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4965)) - 8388608f) * _e4448)) ^ _e74)));
                                                    phi_8596_ = select(_e4941, _e4965, (select(select(_e2848, _e4973, (_e4973 < _e2848)), _e2848, (_e4965 == 1023u)) <= _e4750));
                                                } else {
                                                    phi_8596_ = _e4941;
                                                }
                                                let _e4981 = phi_8596_;
                                                phi_8597_ = _e4981;
                                            } else {
                                                phi_8597_ = _e4961;
                                            }
                                            let _e4983 = phi_8597_;
                                            let _e4991 = (_e2805 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4983)) - 8388608f) * _e4448)) ^ _e74)));
                                            let _e4997 = select(_e4983, 0u, (select(select(_e2848, _e4991, (_e4991 < _e2848)), _e2848, (_e4983 == 1023u)) > _e4750));
                                            if (_e4997 < 1023u) {
                                                phi_8633_ = (_e4997 + 1u);
                                            } else {
                                                phi_8633_ = _e4997;
                                            }
                                            let _e5001 = phi_8633_;
                                            let _e5009 = (_e2805 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e4997)) - 8388608f) * _e4448)) ^ _e74)));
                                            let _e5025 = (_e2805 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e5001)) - 8388608f) * _e4448)) ^ _e74)));
                                            let _e5039 = (_e4755 - _e2820);
                                            if _e4598 {
                                                phi_8712_ = (_e5039 / _e4597);
                                            } else {
                                                phi_8712_ = 0f;
                                            }
                                            let _e5042 = phi_8712_;
                                            let _e5044 = select(1023f, _e5042, (_e5042 < 1023f));
                                            let _e5052 = bitcast<u32>(select(0i, select(select(i32(_e5044), i32(-2147483648), (_e5044 < -2147483600f)), 2147483647i, (_e5044 > 2147483500f)), (_e5044 == _e5044)));
                                            if (_e5052 > 0u) {
                                                let _e5061 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e5052)) - 8388608f) * _e4597)) ^ _e74)) > _e5039);
                                                if _e5061 {
                                                    phi_8745_ = (_e5052 - 1u);
                                                } else {
                                                    phi_8745_ = u32();
                                                }
                                                let _e5064 = phi_8745_;
                                                phi_8747_ = _e5064;
                                                phi_8748_ = select(true, false, _e5061);
                                            } else {
                                                phi_8747_ = u32();
                                                phi_8748_ = true;
                                            }
                                            let _e5067 = phi_8747_;
                                            let _e5069 = phi_8748_;
                                            if _e5069 {
                                                if (_e5052 < 1023u) {
                                                    let _e5071 = (_e5052 + 1u);
                                                    phi_8770_ = select(_e5052, _e5071, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e5071)) - 8388608f) * _e4597)) ^ _e74)) <= _e5039));
                                                } else {
                                                    phi_8770_ = _e5052;
                                                }
                                                let _e5082 = phi_8770_;
                                                phi_8771_ = _e5082;
                                            } else {
                                                phi_8771_ = _e5067;
                                            }
                                            let _e5084 = phi_8771_;
                                            if (_e5084 > 0u) {
                                                let _e5093 = (_e2820 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e5084)) - 8388608f) * _e4597)) ^ _e74)));
                                                let _e5098 = (select(select(_e2863, _e5093, (_e5093 < _e2863)), _e2863, (_e5084 == 1023u)) > _e4755);
                                                if _e5098 {
                                                    phi_8806_ = (_e5084 - 1u);
                                                } else {
                                                    phi_8806_ = u32();
                                                }
                                                let _e5101 = phi_8806_;
                                                phi_8808_ = _e5101;
                                                phi_8809_ = select(true, false, _e5098);
                                            } else {
                                                phi_8808_ = u32();
                                                phi_8809_ = true;
                                            }
                                            let _e5104 = phi_8808_;
                                            let _e5106 = phi_8809_;
                                            if _e5106 {
                                                if (_e5084 < 1023u) {
                                                    let _e5108 = (_e5084 + 1u);
                                                    let _e5116 = (_e2820 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e5108)) - 8388608f) * _e4597)) ^ _e74)));
                                                    phi_8849_ = select(_e5084, _e5108, (select(select(_e2863, _e5116, (_e5116 < _e2863)), _e2863, (_e5108 == 1023u)) <= _e4755));
                                                } else {
                                                    phi_8849_ = _e5084;
                                                }
                                                let _e5124 = phi_8849_;
                                                phi_8850_ = _e5124;
                                            } else {
                                                phi_8850_ = _e5104;
                                            }
                                            let _e5126 = phi_8850_;
                                            let _e5134 = (_e2820 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e5126)) - 8388608f) * _e4597)) ^ _e74)));
                                            let _e5140 = select(_e5126, 0u, (select(select(_e2863, _e5134, (_e5134 < _e2863)), _e2863, (_e5126 == 1023u)) > _e4755));
                                            if (_e5140 < 1023u) {
                                                phi_8886_ = (_e5140 + 1u);
                                            } else {
                                                phi_8886_ = _e5140;
                                            }
                                            let _e5144 = phi_8886_;
                                            let _e5152 = (_e2820 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e5140)) - 8388608f) * _e4597)) ^ _e74)));
                                            let _e5168 = (_e2820 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e5144)) - 8388608f) * _e4597)) ^ _e74)));
                                            let _e5186 = global_2.member[_e4279].member[6u];
                                            let _e5191 = global_2.member[_e4279].member[7u];
                                            let _e5196 = global_2.member[_e4279].member[8u];
                                            let _e5197 = (_e5186 - _e2790);
                                            if _e4303 {
                                                phi_8971_ = (_e5197 / _e4302);
                                            } else {
                                                phi_8971_ = 0f;
                                            }
                                            let _e5200 = phi_8971_;
                                            let _e5202 = select(1023f, _e5200, (_e5200 < 1023f));
                                            let _e5210 = bitcast<u32>(select(0i, select(select(i32(_e5202), i32(-2147483648), (_e5202 < -2147483600f)), 2147483647i, (_e5202 > 2147483500f)), (_e5202 == _e5202)));
                                            if (_e5210 > 0u) {
                                                let _e5219 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e5210)) - 8388608f) * _e4302)) ^ _e74)) > _e5197);
                                                if _e5219 {
                                                    phi_9004_ = (_e5210 - 1u);
                                                } else {
                                                    phi_9004_ = u32();
                                                }
                                                let _e5222 = phi_9004_;
                                                phi_9006_ = _e5222;
                                                phi_9007_ = select(true, false, _e5219);
                                            } else {
                                                phi_9006_ = u32();
                                                phi_9007_ = true;
                                            }
                                            let _e5225 = phi_9006_;
                                            let _e5227 = phi_9007_;
                                            if _e5227 {
                                                if (_e5210 < 1023u) {
                                                    let _e5229 = (_e5210 + 1u);
                                                    phi_9029_ = select(_e5210, _e5229, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e5229)) - 8388608f) * _e4302)) ^ _e74)) <= _e5197));
                                                } else {
                                                    phi_9029_ = _e5210;
                                                }
                                                let _e5240 = phi_9029_;
                                                phi_9030_ = _e5240;
                                            } else {
                                                phi_9030_ = _e5225;
                                            }
                                            let _e5242 = phi_9030_;
                                            if (_e5242 > 0u) {
                                                let _e5251 = (_e2790 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e5242)) - 8388608f) * _e4302)) ^ _e74)));
                                                let _e5256 = (select(select(_e2833, _e5251, (_e5251 < _e2833)), _e2833, (_e5242 == 1023u)) > _e5186);
                                                if _e5256 {
                                                    phi_9065_ = (_e5242 - 1u);
                                                } else {
                                                    phi_9065_ = u32();
                                                }
                                                let _e5259 = phi_9065_;
                                                phi_9067_ = _e5259;
                                                phi_9068_ = select(true, false, _e5256);
                                            } else {
                                                phi_9067_ = u32();
                                                phi_9068_ = true;
                                            }
                                            let _e5262 = phi_9067_;
                                            let _e5264 = phi_9068_;
                                            if _e5264 {
                                                if (_e5242 < 1023u) {
                                                    let _e5266 = (_e5242 + 1u);
                                                    let _e5274 = (_e2790 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e5266)) - 8388608f) * _e4302)) ^ _e74)));
                                                    phi_9108_ = select(_e5242, _e5266, (select(select(_e2833, _e5274, (_e5274 < _e2833)), _e2833, (_e5266 == 1023u)) <= _e5186));
                                                } else {
                                                    phi_9108_ = _e5242;
                                                }
                                                let _e5282 = phi_9108_;
                                                phi_9109_ = _e5282;
                                            } else {
                                                phi_9109_ = _e5262;
                                            }
                                            let _e5284 = phi_9109_;
                                            let _e5292 = (_e2790 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e5284)) - 8388608f) * _e4302)) ^ _e74)));
                                            let _e5298 = select(_e5284, 0u, (select(select(_e2833, _e5292, (_e5292 < _e2833)), _e2833, (_e5284 == 1023u)) > _e5186));
                                            if (_e5298 < 1023u) {
                                                phi_9145_ = (_e5298 + 1u);
                                            } else {
                                                phi_9145_ = _e5298;
                                            }
                                            let _e5302 = phi_9145_;
                                            let _e5310 = (_e2790 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e5298)) - 8388608f) * _e4302)) ^ _e74)));
                                            let _e5326 = (_e2790 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e5302)) - 8388608f) * _e4302)) ^ _e74)));
                                            let _e5337 = (_e5191 - _e2805);
                                            if _e4449 {
                                                phi_9222_ = (_e5337 / _e4448);
                                            } else {
                                                phi_9222_ = 0f;
                                            }
                                            let _e5340 = phi_9222_;
                                            let _e5342 = select(1023f, _e5340, (_e5340 < 1023f));
                                            let _e5350 = bitcast<u32>(select(0i, select(select(i32(_e5342), i32(-2147483648), (_e5342 < -2147483600f)), 2147483647i, (_e5342 > 2147483500f)), (_e5342 == _e5342)));
                                            if (_e5350 > 0u) {
                                                let _e5359 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e5350)) - 8388608f) * _e4448)) ^ _e74)) > _e5337);
                                                if _e5359 {
                                                    phi_9255_ = (_e5350 - 1u);
                                                } else {
                                                    phi_9255_ = u32();
                                                }
                                                let _e5362 = phi_9255_;
                                                phi_9257_ = _e5362;
                                                phi_9258_ = select(true, false, _e5359);
                                            } else {
                                                phi_9257_ = u32();
                                                phi_9258_ = true;
                                            }
                                            let _e5365 = phi_9257_;
                                            let _e5367 = phi_9258_;
                                            if _e5367 {
                                                if (_e5350 < 1023u) {
                                                    let _e5369 = (_e5350 + 1u);
                                                    phi_9280_ = select(_e5350, _e5369, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e5369)) - 8388608f) * _e4448)) ^ _e74)) <= _e5337));
                                                } else {
                                                    phi_9280_ = _e5350;
                                                }
                                                let _e5380 = phi_9280_;
                                                phi_9281_ = _e5380;
                                            } else {
                                                phi_9281_ = _e5365;
                                            }
                                            let _e5382 = phi_9281_;
                                            if (_e5382 > 0u) {
                                                let _e5391 = (_e2805 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e5382)) - 8388608f) * _e4448)) ^ _e74)));
                                                let _e5396 = (select(select(_e2848, _e5391, (_e5391 < _e2848)), _e2848, (_e5382 == 1023u)) > _e5191);
                                                if _e5396 {
                                                    phi_9316_ = (_e5382 - 1u);
                                                } else {
                                                    phi_9316_ = u32();
                                                }
                                                let _e5399 = phi_9316_;
                                                phi_9318_ = _e5399;
                                                phi_9319_ = select(true, false, _e5396);
                                            } else {
                                                phi_9318_ = u32();
                                                phi_9319_ = true;
                                            }
                                            let _e5402 = phi_9318_;
                                            let _e5404 = phi_9319_;
                                            if _e5404 {
                                                if (_e5382 < 1023u) {
                                                    let _e5406 = (_e5382 + 1u);
                                                    let _e5414 = (_e2805 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e5406)) - 8388608f) * _e4448)) ^ _e74)));
                                                    phi_9359_ = select(_e5382, _e5406, (select(select(_e2848, _e5414, (_e5414 < _e2848)), _e2848, (_e5406 == 1023u)) <= _e5191));
                                                } else {
                                                    phi_9359_ = _e5382;
                                                }
                                                let _e5422 = phi_9359_;
                                                phi_9360_ = _e5422;
                                            } else {
                                                phi_9360_ = _e5402;
                                            }
                                            let _e5424 = phi_9360_;
                                            let _e5432 = (_e2805 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e5424)) - 8388608f) * _e4448)) ^ _e74)));
                                            let _e5438 = select(_e5424, 0u, (select(select(_e2848, _e5432, (_e5432 < _e2848)), _e2848, (_e5424 == 1023u)) > _e5191));
                                            if (_e5438 < 1023u) {
                                                phi_9396_ = (_e5438 + 1u);
                                            } else {
                                                phi_9396_ = _e5438;
                                            }
                                            let _e5442 = phi_9396_;
                                            let _e5450 = (_e2805 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e5438)) - 8388608f) * _e4448)) ^ _e74)));
                                            let _e5466 = (_e2805 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e5442)) - 8388608f) * _e4448)) ^ _e74)));
                                            let _e5480 = (_e5196 - _e2820);
                                            if _e4598 {
                                                phi_9475_ = (_e5480 / _e4597);
                                            } else {
                                                phi_9475_ = 0f;
                                            }
                                            let _e5483 = phi_9475_;
                                            let _e5485 = select(1023f, _e5483, (_e5483 < 1023f));
                                            let _e5493 = bitcast<u32>(select(0i, select(select(i32(_e5485), i32(-2147483648), (_e5485 < -2147483600f)), 2147483647i, (_e5485 > 2147483500f)), (_e5485 == _e5485)));
                                            if (_e5493 > 0u) {
                                                let _e5502 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e5493)) - 8388608f) * _e4597)) ^ _e74)) > _e5480);
                                                if _e5502 {
                                                    phi_9508_ = (_e5493 - 1u);
                                                } else {
                                                    phi_9508_ = u32();
                                                }
                                                let _e5505 = phi_9508_;
                                                phi_9510_ = _e5505;
                                                phi_9511_ = select(true, false, _e5502);
                                            } else {
                                                phi_9510_ = u32();
                                                phi_9511_ = true;
                                            }
                                            let _e5508 = phi_9510_;
                                            let _e5510 = phi_9511_;
                                            if _e5510 {
                                                if (_e5493 < 1023u) {
                                                    let _e5512 = (_e5493 + 1u);
                                                    phi_9533_ = select(_e5493, _e5512, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e5512)) - 8388608f) * _e4597)) ^ _e74)) <= _e5480));
                                                } else {
                                                    phi_9533_ = _e5493;
                                                }
                                                let _e5523 = phi_9533_;
                                                phi_9534_ = _e5523;
                                            } else {
                                                phi_9534_ = _e5508;
                                            }
                                            let _e5525 = phi_9534_;
                                            if (_e5525 > 0u) {
                                                let _e5534 = (_e2820 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e5525)) - 8388608f) * _e4597)) ^ _e74)));
                                                let _e5539 = (select(select(_e2863, _e5534, (_e5534 < _e2863)), _e2863, (_e5525 == 1023u)) > _e5196);
                                                if _e5539 {
                                                    phi_9569_ = (_e5525 - 1u);
                                                } else {
                                                    phi_9569_ = u32();
                                                }
                                                let _e5542 = phi_9569_;
                                                phi_9571_ = _e5542;
                                                phi_9572_ = select(true, false, _e5539);
                                            } else {
                                                phi_9571_ = u32();
                                                phi_9572_ = true;
                                            }
                                            let _e5545 = phi_9571_;
                                            let _e5547 = phi_9572_;
                                            if _e5547 {
                                                if (_e5525 < 1023u) {
                                                    let _e5549 = (_e5525 + 1u);
                                                    let _e5557 = (_e2820 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e5549)) - 8388608f) * _e4597)) ^ _e74)));
                                                    phi_9612_ = select(_e5525, _e5549, (select(select(_e2863, _e5557, (_e5557 < _e2863)), _e2863, (_e5549 == 1023u)) <= _e5196));
                                                } else {
                                                    phi_9612_ = _e5525;
                                                }
                                                let _e5565 = phi_9612_;
                                                phi_9613_ = _e5565;
                                            } else {
                                                phi_9613_ = _e5545;
                                            }
                                            let _e5567 = phi_9613_;
                                            let _e5575 = (_e2820 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e5567)) - 8388608f) * _e4597)) ^ _e74)));
                                            let _e5581 = select(_e5567, 0u, (select(select(_e2863, _e5575, (_e5575 < _e2863)), _e2863, (_e5567 == 1023u)) > _e5196));
                                            if (_e5581 < 1023u) {
                                                phi_9649_ = (_e5581 + 1u);
                                            } else {
                                                phi_9649_ = _e5581;
                                            }
                                            let _e5585 = phi_9649_;
                                            let _e5593 = (_e2820 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e5581)) - 8388608f) * _e4597)) ^ _e74)));
                                            let _e5609 = (_e2820 + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e5585)) - 8388608f) * _e4597)) ^ _e74)));
                                            let _e5627 = global_2.member[_e4279].member_1;
                                            if _e4281 {
                                            } else {
                                                phi_10468_ = true;
                                                break;
                                            }
                                            global_6.member[_e4279] = type_43(array<u32, 3>(((select(_e4404, _e4408, (bitcast<f32>((bitcast<u32>((select(select(_e2833, _e4432, (_e4432 < _e2833)), _e2833, (_e4408 == 1023u)) - _e4286)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e4286 - select(select(_e2833, _e4416, (_e4416 < _e2833)), _e2833, (_e4404 == 1023u)))) & 2147483647u)))) | (select(_e4550, _e4554, (bitcast<f32>((bitcast<u32>((select(select(_e2848, _e4578, (_e4578 < _e2848)), _e2848, (_e4554 == 1023u)) - _e4291)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e4291 - select(select(_e2848, _e4562, (_e4562 < _e2848)), _e2848, (_e4550 == 1023u)))) & 2147483647u)))) << bitcast<u32>(10i))) | (select(_e4699, _e4703, (bitcast<f32>((bitcast<u32>((select(select(_e2863, _e4727, (_e4727 < _e2863)), _e2863, (_e4703 == 1023u)) - _e4296)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e4296 - select(select(_e2863, _e4711, (_e4711 < _e2863)), _e2863, (_e4699 == 1023u)))) & 2147483647u)))) << bitcast<u32>(20i))), ((select(_e4857, _e4861, (bitcast<f32>((bitcast<u32>((select(select(_e2833, _e4885, (_e4885 < _e2833)), _e2833, (_e4861 == 1023u)) - _e4745)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e4745 - select(select(_e2833, _e4869, (_e4869 < _e2833)), _e2833, (_e4857 == 1023u)))) & 2147483647u)))) | (select(_e4997, _e5001, (bitcast<f32>((bitcast<u32>((select(select(_e2848, _e5025, (_e5025 < _e2848)), _e2848, (_e5001 == 1023u)) - _e4750)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e4750 - select(select(_e2848, _e5009, (_e5009 < _e2848)), _e2848, (_e4997 == 1023u)))) & 2147483647u)))) << bitcast<u32>(10i))) | (select(_e5140, _e5144, (bitcast<f32>((bitcast<u32>((select(select(_e2863, _e5168, (_e5168 < _e2863)), _e2863, (_e5144 == 1023u)) - _e4755)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e4755 - select(select(_e2863, _e5152, (_e5152 < _e2863)), _e2863, (_e5140 == 1023u)))) & 2147483647u)))) << bitcast<u32>(20i))), ((select(_e5298, _e5302, (bitcast<f32>((bitcast<u32>((select(select(_e2833, _e5326, (_e5326 < _e2833)), _e2833, (_e5302 == 1023u)) - _e5186)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e5186 - select(select(_e2833, _e5310, (_e5310 < _e2833)), _e2833, (_e5298 == 1023u)))) & 2147483647u)))) | (select(_e5438, _e5442, (bitcast<f32>((bitcast<u32>((select(select(_e2848, _e5466, (_e5466 < _e2848)), _e2848, (_e5442 == 1023u)) - _e5191)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e5191 - select(select(_e2848, _e5450, (_e5450 < _e2848)), _e2848, (_e5438 == 1023u)))) & 2147483647u)))) << bitcast<u32>(10i))) | (select(_e5581, _e5585, (bitcast<f32>((bitcast<u32>((select(select(_e2863, _e5609, (_e5609 < _e2863)), _e2863, (_e5585 == 1023u)) - _e5196)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e5196 - select(select(_e2863, _e5593, (_e5593 < _e2863)), _e2863, (_e5581 == 1023u)))) & 2147483647u)))) << bitcast<u32>(20i)))), _e5627);
                                        }
                                    }
                                }
                                continue;
                                continuing {
                                    phi_7378_ = _e4271;
                                    phi_10468_ = _e4250;
                                    break if !(_e4277);
                                }
                            }
                            let _e5633 = phi_10468_;
                            if _e5633 {
                                break;
                            }
                        }
                        if (_e65 == 0u) {
                            if (_e61 == 0u) {
                            } else {
                                if (0u < _e61) {
                                } else {
                                    break;
                                }
                                global_7.member[0u] = type_32(array<u32, 4>(bitcast<u32>(_e1190.member[0]), bitcast<u32>(_e1190.member[1]), bitcast<u32>(_e1190.member[2]), 0u), array<u32, 4>(bitcast<u32>(_e1193.member_1[0]), bitcast<u32>(_e1193.member_1[1]), bitcast<u32>(_e1193.member_1[2]), 0u));
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
fn encode_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
