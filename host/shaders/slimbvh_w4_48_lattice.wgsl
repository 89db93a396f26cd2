// Made by slimbvh's shader builder from its Rust: rays traced from your own WGSL. Put this text before yours, bind the
// tree's exponent, nodes, triangles and, if it has one, root to group 0, and call
//
//   slimbvh_closest_hit(origin, t_min, direction, t_max) -> SlimbvhHit
//   slimbvh_any_hit(origin, t_min, direction, t_max) -> bool
//
// from any stage. t is in units of the direction's length; a miss has the primitive 0xffffffff. The stack is private
// memory, up to 1 KiB an invocation: in compute shaders the functions of the text slimbvh_compute are faster.

struct SlimbvhTypeA {
    member: vec4<u32>,
}

struct SlimbvhTypeB {
    member: array<u32>,
}

struct SlimbvhTypeC {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
    member_2: f32,
    member_3: f32,
    member_4: i32,
}

struct SlimbvhTypeD {
    member: u32,
    member_1: u32,
}

struct SlimbvhTypeE {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct SlimbvhTypeF {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct SlimbvhTypeG {
    member: array<vec4<u32>, 2>,
}

struct SlimbvhTypeH {
    member: SlimbvhTypeF,
    member_1: f32,
}

struct SlimbvhTypeI {
    member: u32,
    member_1: f32,
}

struct SlimbvhTypeJ {
    member: array<array<vec4<u32>, 3>>,
}

struct SlimbvhTypeK {
    member: vec4<f32>,
    member_1: u32,
}

struct SlimbvhTypeL {
    member: SlimbvhTypeK,
    member_1: u32,
    member_2: u32,
}

struct SlimbvhTypeM {
    member: vec4<f32>,
}

struct SlimbvhTypeN {
    member: u32,
}

struct SlimbvhTypeO {
    member: SlimbvhTypeH,
    member_1: bool,
}

@group(0) @binding(0) 
var<uniform> slimbvh_exponent: SlimbvhTypeA;

@group(0) @binding(1) 
var<storage> slimbvh_nodes: SlimbvhTypeJ;

@group(0) @binding(2) 
var<storage> slimbvh_triangles: SlimbvhTypeB;

@group(0) @binding(3) 
var<uniform> slimbvh_root: SlimbvhTypeG;

var<private> slimbvh_origin: SlimbvhTypeM;

var<private> slimbvh_direction: SlimbvhTypeM;

var<private> slimbvh_any_will_do: SlimbvhTypeN;

var<private> slimbvh_hit: SlimbvhTypeA;

fn slimbvh_trace() {
    var local: array<u32, 128>;
    var phi_716_: u32;
    var phi_722_: u32;
    var phi_728_: u32;
    var phi_993_: i32;
    var phi_1004_: i32;
    var phi_1118_: i32;
    var phi_1247_: i32;
    var phi_1269_: u32;
    var phi_1270_: u32;
    var phi_1271_: bool;
    var phi_1305_: i32;
    var phi_1327_: u32;
    var phi_1328_: u32;
    var phi_1329_: bool;
    var phi_890_: i32;
    var phi_896_: u32;
    var phi_915_: u32;
    var phi_916_: u32;
    var phi_917_: bool;
    var phi_935_: i32;
    var phi_941_: u32;
    var phi_960_: u32;
    var phi_961_: u32;
    var phi_962_: bool;
    var phi_1339_: SlimbvhTypeC;
    var phi_1568_: SlimbvhTypeO;
    var phi_1631_: array<f32, 3>;
    var phi_1632_: array<f32, 3>;
    var phi_1650_: array<f32, 3>;
    var phi_1651_: array<f32, 3>;
    var phi_1824_: SlimbvhTypeO;
    var phi_1827_: u32;
    var phi_1829_: u32;
    var phi_1831_: u32;
    var phi_1840_: u32;
    var phi_1843_: u32;
    var phi_1845_: u32;
    var phi_1938_: SlimbvhTypeI;
    var phi_1939_: SlimbvhTypeI;
    var phi_1979_: SlimbvhTypeI;
    var phi_1980_: SlimbvhTypeI;
    var phi_2020_: SlimbvhTypeI;
    var phi_2021_: SlimbvhTypeI;
    var phi_2501_: u32;
    var phi_2514_: u32;
    var phi_2527_: u32;
    var phi_2540_: u32;
    var phi_4779_: SlimbvhTypeD;
    var phi_4791_: SlimbvhTypeD;
    var phi_4803_: SlimbvhTypeD;
    var phi_4815_: SlimbvhTypeD;
    var phi_4827_: SlimbvhTypeD;
    var phi_2621_: u32;
    var phi_2626_: u32;
    var phi_2627_: u32;
    var phi_2684_: u32;
    var phi_2685_: u32;
    var phi_1841_: u32;
    var phi_1844_: u32;
    var phi_1846_: u32;
    var local_1: bool;
    var local_2: u32;
    var phi_2815_: u32;
    var phi_2891_: u32;
    var phi_2934_: SlimbvhTypeL;
    var phi_2938_: SlimbvhTypeO;
    var phi_2941_: SlimbvhTypeD;
    var phi_2942_: SlimbvhTypeD;
    var phi_2964_: SlimbvhTypeD;
    var phi_2981_: u32;
    var phi_2992_: u32;
    var phi_3008_: u32;
    var phi_3023_: u32;
    var phi_3488_: u32;
    var phi_3506_: u32;
    var phi_3524_: u32;
    var phi_3547_: u32;
    var phi_3565_: u32;
    var phi_3583_: u32;
    var phi_3606_: u32;
    var phi_3624_: u32;
    var phi_3642_: u32;
    var phi_3196_: u32;
    var phi_3211_: u32;
    var phi_3221_: u32;
    var phi_3242_: u32;
    var phi_3263_: u32;
    var phi_3293_: u32;
    var phi_3308_: u32;
    var phi_3318_: u32;
    var phi_3339_: u32;
    var phi_3360_: u32;
    var phi_3390_: u32;
    var phi_3405_: u32;
    var phi_3415_: u32;
    var phi_3436_: u32;
    var phi_3457_: u32;
    var phi_3049_: u32;
    var phi_3098_: u32;
    var phi_3147_: u32;
    var phi_3648_: array<array<f32, 3>, 3>;
    var phi_4013_: f32;
    var phi_4014_: f32;
    var phi_4015_: f32;
    var phi_4016_: f32;
    var phi_4017_: vec3<f32>;
    var phi_4018_: vec3<f32>;
    var phi_4019_: vec3<f32>;
    var phi_4020_: vec3<f32>;
    var phi_4199_: f32;
    var phi_4225_: SlimbvhTypeE;
    var phi_4226_: SlimbvhTypeE;
    var phi_4229_: SlimbvhTypeE;
    var phi_4230_: SlimbvhTypeE;
    var phi_4231_: bool;
    var phi_4235_: SlimbvhTypeE;
    var phi_4244_: SlimbvhTypeF;
    var phi_4271_: bool;
    var phi_4272_: bool;
    var phi_4279_: SlimbvhTypeO;
    var phi_4285_: SlimbvhTypeO;
    var phi_4286_: SlimbvhTypeO;
    var phi_4287_: SlimbvhTypeO;
    var phi_2939_: SlimbvhTypeO;
    var local_3: u32;
    var local_4: u32;
    var phi_4379_: u32;
    var phi_4380_: u32;
    var local_5: SlimbvhTypeO;
    var phi_4389_: SlimbvhTypeO;
    var phi_4390_: u32;
    var phi_4391_: u32;
    var phi_1825_: SlimbvhTypeO;
    var phi_1828_: u32;
    var phi_1830_: u32;
    var phi_1832_: u32;
    var local_6: SlimbvhTypeO;
    var phi_4427_: f32;
    var phi_4429_: f32;
    var phi_4430_: bool;
    var phi_4431_: f32;
    var phi_4432_: bool;
    var phi_5058_: u32;
    var phi_5076_: bool;
    var phi_5079_: bool;
    var phi_5092_: f32;
    var phi_5093_: f32;
    var phi_5098_: f32;
    var phi_5099_: f32;
    var phi_5100_: bool;
    var phi_5108_: f32;
    var phi_4447_: f32;
    var phi_4448_: f32;
    var phi_4460_: f32;
    var phi_4465_: SlimbvhTypeF;
    var local_7: SlimbvhTypeO;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;

    let _e111 = SlimbvhTypeF(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
    let _e115 = arrayLength((&slimbvh_nodes.member));
    let _e118 = arrayLength((&slimbvh_triangles.member));
    let _e126 = slimbvh_root.member[0u][0u];
    let _e130 = slimbvh_root.member[0u][1u];
    let _e134 = slimbvh_root.member[0u][2u];
    let _e138 = slimbvh_root.member[0u][3u];
    let _e142 = slimbvh_root.member[1u][0u];
    let _e146 = slimbvh_root.member[1u][1u];
    let _e150 = slimbvh_root.member[1u][2u];
    let _e162 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e138) + 127i)) << bitcast<u32>(23i)));
    local = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
    let _e163 = slimbvh_origin.member;
    let _e169 = slimbvh_origin.member[3u];
    let _e170 = slimbvh_direction.member;
    let _e176 = slimbvh_direction.member[3u];
    let _e179 = slimbvh_exponent.member[0u];
    let _e180 = bitcast<i32>(_e179);
    let _e182 = (bitcast<u32>(_e163.x) & 2147483647u);
    let _e184 = (bitcast<u32>(_e163.y) & 2147483647u);
    let _e186 = (bitcast<u32>(_e163.z) & 2147483647u);
    let _e187 = bitcast<u32>(_e169);
    let _e188 = (_e187 & 2147483647u);
    let _e190 = (bitcast<u32>(_e170.x) & 2147483647u);
    let _e192 = (bitcast<u32>(_e170.y) & 2147483647u);
    let _e194 = (bitcast<u32>(_e170.z) & 2147483647u);
    let _e195 = bitcast<u32>(_e176);
    let _e196 = (_e195 & 2147483647u);
    let _e198 = select(_e192, _e190, (_e192 < _e190));
    let _e200 = select(_e194, _e198, (_e194 < _e198));
    let _e202 = select(_e182, _e200, (_e182 < _e200));
    let _e204 = select(_e184, _e202, (_e184 < _e202));
    let _e206 = select(_e186, _e204, (_e186 < _e204));
    let _e213 = (((select(_e188, _e206, (_e188 < _e206)) < 2139095040u) && (_e196 <= 2139095040u)) && (_e200 > 0u));
    if (_e190 == _e200) {
        phi_716_ = 0u;
    } else {
        phi_716_ = select(2u, 1u, (_e192 == _e200));
    }
    let _e218 = phi_716_;
    let _e219 = (_e218 == 2u);
    if _e219 {
        phi_722_ = 0u;
    } else {
        phi_722_ = (_e218 + 1u);
    }
    let _e222 = phi_722_;
    let _e223 = (_e222 == 2u);
    if _e223 {
        phi_728_ = 0u;
    } else {
        phi_728_ = (_e222 + 1u);
    }
    let _e226 = phi_728_;
    let _e227 = (_e222 == 0u);
    let _e229 = select(select(_e163.y, _e163.x, _e227), _e163.z, _e223);
    let _e230 = (_e226 == 0u);
    let _e232 = (_e226 == 2u);
    let _e233 = select(select(_e163.y, _e163.x, _e230), _e163.z, _e232);
    let _e234 = (_e218 == 0u);
    let _e236 = select(select(_e163.y, _e163.x, _e234), _e163.z, _e219);
    let _e238 = select(select(_e170.y, _e170.x, _e227), _e170.z, _e223);
    let _e240 = select(select(_e170.y, _e170.x, _e230), _e170.z, _e232);
    let _e242 = select(select(_e170.y, _e170.x, _e234), _e170.z, _e219);
    let _e243 = (_e188 - 1u);
    let _e244 = (_e196 - 1u);
    let _e246 = select(_e243, _e244, (_e244 < _e243));
    let _e247 = (_e182 - 1u);
    let _e248 = (_e184 - 1u);
    let _e250 = select(_e247, _e248, (_e248 < _e247));
    let _e251 = (_e186 - 1u);
    let _e253 = select(_e250, _e251, (_e251 < _e250));
    let _e254 = (_e190 - 1u);
    let _e255 = (_e192 - 1u);
    let _e257 = select(_e254, _e255, (_e255 < _e254));
    let _e258 = (_e194 - 1u);
    let _e260 = select(_e257, _e258, (_e258 < _e257));
    let _e262 = select(_e253, _e260, (_e260 < _e253));
    if (((select(_e262, _e246, (_e246 < _e262)) >= 8388607u) && (_e200 < 2130706432u)) && (bitcast<u32>((_e180 + 126i)) <= 253u)) {
        let _e527 = bitcast<i32>((_e200 >> bitcast<u32>(23i)));
        let _e528 = (_e527 - 127i);
        let _e529 = (_e180 + _e528);
        let _e534 = bitcast<f32>((bitcast<u32>((_e180 + 127i)) << bitcast<u32>(23i)));
        let _e539 = bitcast<f32>((bitcast<u32>((254i - _e527)) << bitcast<u32>(23i)));
        if (_e188 >= 2139095040u) {
            phi_890_ = 255i;
        } else {
            phi_890_ = (bitcast<i32>((_e188 >> bitcast<u32>(23i))) + _e529);
        }
        let _e554 = phi_890_;
        if (_e188 == 0u) {
            phi_896_ = 0u;
        } else {
            phi_896_ = (_e188 | 8388608u);
        }
        let _e558 = phi_896_;
        if (_e554 <= 0i) {
            phi_916_ = u32();
            phi_917_ = true;
        } else {
            let _e565 = (_e558 == 0u);
            if _e565 {
                phi_915_ = u32();
            } else {
                phi_915_ = select(((bitcast<u32>(_e554) << bitcast<u32>(23i)) | (_e558 & 8388607u)), 2139095039u, (_e554 >= 255i));
            }
            let _e569 = phi_915_;
            phi_916_ = _e569;
            phi_917_ = _e565;
        }
        let _e571 = phi_916_;
        let _e573 = phi_917_;
        if (_e196 >= 2139095040u) {
            phi_935_ = 255i;
        } else {
            phi_935_ = (bitcast<i32>((_e196 >> bitcast<u32>(23i))) + _e529);
        }
        let _e584 = phi_935_;
        if (_e196 == 0u) {
            phi_941_ = 0u;
        } else {
            phi_941_ = (_e196 | 8388608u);
        }
        let _e588 = phi_941_;
        if (_e584 <= 0i) {
            phi_961_ = u32();
            phi_962_ = true;
        } else {
            let _e595 = (_e588 == 0u);
            if _e595 {
                phi_960_ = u32();
            } else {
                phi_960_ = select(((bitcast<u32>(_e584) << bitcast<u32>(23i)) | (_e588 & 8388607u)), 2139095039u, (_e584 >= 255i));
            }
            let _e599 = phi_960_;
            phi_961_ = _e599;
            phi_962_ = _e595;
        }
        let _e601 = phi_961_;
        let _e603 = phi_962_;
        phi_1339_ = SlimbvhTypeC(array<f32, 3>((_e229 * _e534), (_e233 * _e534), (_e236 * _e534)), array<f32, 3>((_e238 * _e539), (_e240 * _e539), (_e242 * _e539)), bitcast<f32>(((_e187 & 2147483648u) | select(_e571, 0u, _e573))), bitcast<f32>(((_e195 & 2147483648u) | select(_e601, 0u, _e603))), _e528);
    } else {
        let _e275 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e200, _e213))) & 2147483647u);
        if (_e275 >= 8388608u) {
            phi_993_ = (bitcast<i32>((_e275 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_993_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e275)), 32u, (_e275 == 0u))));
        }
        let _e289 = phi_993_;
        let _e290 = (_e180 + _e289);
        if (_e180 < -126i) {
            phi_1004_ = -126i;
        } else {
            phi_1004_ = select(_e180, 127i, (_e180 > 127i));
        }
        let _e295 = phi_1004_;
        let _e300 = bitcast<f32>((bitcast<u32>((_e295 + 127i)) << bitcast<u32>(23i)));
        let _e306 = bitcast<f32>((bitcast<u32>(((_e180 - _e295) + 127i)) << bitcast<u32>(23i)));
        let _e307 = bitcast<u32>(_e229);
        let _e309 = ((_e307 & 2139095040u) != 0u);
        let _e324 = bitcast<u32>(_e233);
        let _e326 = ((_e324 & 2139095040u) != 0u);
        let _e341 = bitcast<u32>(_e236);
        let _e343 = ((_e341 & 2139095040u) != 0u);
        let _e359 = -(_e289);
        if (_e359 < -126i) {
            phi_1118_ = -126i;
        } else {
            phi_1118_ = select(_e359, 127i, (_e359 > 127i));
        }
        let _e364 = phi_1118_;
        let _e369 = bitcast<f32>((bitcast<u32>((_e364 + 127i)) << bitcast<u32>(23i)));
        let _e375 = bitcast<f32>((bitcast<u32>(((_e359 - _e364) + 127i)) << bitcast<u32>(23i)));
        let _e376 = bitcast<u32>(_e238);
        let _e378 = ((_e376 & 2139095040u) != 0u);
        let _e393 = bitcast<u32>(_e240);
        let _e395 = ((_e393 & 2139095040u) != 0u);
        let _e410 = bitcast<u32>(_e242);
        let _e412 = ((_e410 & 2139095040u) != 0u);
        let _e434 = ((_e188 & 8388607u) | (select(0u, 1u, ((_e188 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e437 = bitcast<i32>((_e188 >> bitcast<u32>(23i)));
        let _e444 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e434)), 32u, (_e434 == 0u))) - 8i);
        if (_e437 == 255i) {
            phi_1247_ = 255i;
        } else {
            phi_1247_ = (((_e437 + select(0i, 1i, (_e437 == 0i))) - _e444) + _e290);
        }
        let _e452 = phi_1247_;
        let _e456 = (_e434 << bitcast<u32>(((_e444 & 31i) & 31i)));
        if (_e452 <= 0i) {
            phi_1270_ = u32();
            phi_1271_ = true;
        } else {
            let _e463 = (_e456 == 0u);
            if _e463 {
                phi_1269_ = u32();
            } else {
                phi_1269_ = select(((bitcast<u32>(_e452) << bitcast<u32>(23i)) | (_e456 & 8388607u)), 2139095039u, (_e452 >= 255i));
            }
            let _e467 = phi_1269_;
            phi_1270_ = _e467;
            phi_1271_ = _e463;
        }
        let _e469 = phi_1270_;
        let _e471 = phi_1271_;
        let _e482 = ((_e196 & 8388607u) | (select(0u, 1u, ((_e196 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e485 = bitcast<i32>((_e196 >> bitcast<u32>(23i)));
        let _e492 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e482)), 32u, (_e482 == 0u))) - 8i);
        if (_e485 == 255i) {
            phi_1305_ = 255i;
        } else {
            phi_1305_ = (((_e485 + select(0i, 1i, (_e485 == 0i))) - _e492) + _e290);
        }
        let _e500 = phi_1305_;
        let _e504 = (_e482 << bitcast<u32>(((_e492 & 31i) & 31i)));
        if (_e500 <= 0i) {
            phi_1328_ = u32();
            phi_1329_ = true;
        } else {
            let _e511 = (_e504 == 0u);
            if _e511 {
                phi_1327_ = u32();
            } else {
                phi_1327_ = select(((bitcast<u32>(_e500) << bitcast<u32>(23i)) | (_e504 & 8388607u)), 2139095039u, (_e500 >= 255i));
            }
            let _e515 = phi_1327_;
            phi_1328_ = _e515;
            phi_1329_ = _e511;
        }
        let _e517 = phi_1328_;
        let _e519 = phi_1329_;
        phi_1339_ = SlimbvhTypeC(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e307 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e307 & 2147483648u))), _e229, _e309) * _e300) * select(0.00000011920929f, 1f, _e309)) * _e306), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e324 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e324 & 2147483648u))), _e233, _e326) * _e300) * select(0.00000011920929f, 1f, _e326)) * _e306), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e341 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e341 & 2147483648u))), _e236, _e343) * _e300) * select(0.00000011920929f, 1f, _e343)) * _e306)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e376 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e376 & 2147483648u))), _e238, _e378) * _e369) * select(0.00000011920929f, 1f, _e378)) * _e375), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e393 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e393 & 2147483648u))), _e240, _e395) * _e369) * select(0.00000011920929f, 1f, _e395)) * _e375), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e410 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e410 & 2147483648u))), _e242, _e412) * _e369) * select(0.00000011920929f, 1f, _e412)) * _e375)), bitcast<f32>(((_e187 & 2147483648u) | select(_e469, 0u, _e471))), bitcast<f32>(((_e195 & 2147483648u) | select(_e517, 0u, _e519))), _e289);
    }
    let _e610 = phi_1339_;
    let _e625 = (bitcast<f32>((bitcast<u32>(_e610.member_1[0]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e628 = bitcast<f32>((bitcast<u32>(_e610.member[0]) & 2147483647u));
    let _e629 = (_e628 * 0.00000011920929f);
    let _e632 = select(select(0.00000000000011368684f, _e629, (_e629 > 0.00000000000011368684f)), 0f, _e625);
    let _e633 = select(0f, _e610.member_1[0], _e625);
    let _e634 = (_e610.member[0] + _e632);
    let _e635 = (_e610.member[0] - _e632);
    let _e637 = select(38685626000000000000000000f, (1f / _e610.member_1[0]), _e625);
    let _e641 = (bitcast<f32>((bitcast<u32>(_e610.member_1[1]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e644 = bitcast<f32>((bitcast<u32>(_e610.member[1]) & 2147483647u));
    let _e645 = (_e644 * 0.00000011920929f);
    let _e648 = select(select(0.00000000000011368684f, _e645, (_e645 > 0.00000000000011368684f)), 0f, _e641);
    let _e649 = select(0f, _e610.member_1[1], _e641);
    let _e650 = (_e610.member[1] + _e648);
    let _e651 = (_e610.member[1] - _e648);
    let _e653 = select(38685626000000000000000000f, (1f / _e610.member_1[1]), _e641);
    let _e657 = (bitcast<f32>((bitcast<u32>(_e610.member_1[2]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e660 = bitcast<f32>((bitcast<u32>(_e610.member[2]) & 2147483647u));
    let _e661 = (_e660 * 0.00000011920929f);
    let _e664 = select(select(0.00000000000011368684f, _e661, (_e661 > 0.00000000000011368684f)), 0f, _e657);
    let _e665 = select(0f, _e610.member_1[2], _e657);
    let _e666 = (_e610.member[2] + _e664);
    let _e667 = (_e610.member[2] - _e664);
    let _e669 = select(38685626000000000000000000f, (1f / _e610.member_1[2]), _e657);
    let _e671 = select(_e644, _e628, (_e628 > _e644));
    let _e675 = (_e213 && (select(_e660, _e671, (_e671 > _e660)) <= 1099511600000f));
    let _e676 = select(0f, _e610.member_3, _e675);
    let _e677 = select(1f, _e610.member_2, _e675);
    let _e679 = slimbvh_any_will_do.member;
    if (_e679 == 1u) {
        phi_1568_ = SlimbvhTypeO(SlimbvhTypeH(_e111, _e676), true);
    } else {
        phi_1568_ = SlimbvhTypeO(SlimbvhTypeH(_e111, _e676), false);
    }
    let _e686 = phi_1568_;
    let _e691 = (_e222 & 3u);
    let _e692 = (_e226 & 3u);
    let _e693 = (_e218 & 3u);
    let _e706 = (f32(bitcast<i32>(_e126)) * _e162);
    let _e708 = (f32(bitcast<i32>(_e130)) * _e162);
    let _e710 = (f32(bitcast<i32>(_e134)) * _e162);
    let _e711 = (_e691 == 0u);
    if _e711 {
        phi_1632_ = array<f32, 3>(_e706, _e708, _e710);
    } else {
        if (_e691 == 1u) {
            phi_1631_ = array<f32, 3>(_e708, _e710, _e706);
        } else {
            phi_1631_ = array<f32, 3>(_e710, _e706, _e708);
        }
        let _e716 = phi_1631_;
        phi_1632_ = _e716;
    }
    let _e719 = phi_1632_;
    let _e721 = (f32(bitcast<i32>(_e142)) * _e162);
    let _e723 = (f32(bitcast<i32>(_e146)) * _e162);
    let _e725 = (f32(bitcast<i32>(_e150)) * _e162);
    if _e711 {
        phi_1651_ = array<f32, 3>(_e721, _e723, _e725);
    } else {
        if (_e691 == 1u) {
            phi_1650_ = array<f32, 3>(_e723, _e725, _e721);
        } else {
            phi_1650_ = array<f32, 3>(_e725, _e721, _e723);
        }
        let _e730 = phi_1650_;
        phi_1651_ = _e730;
    }
    let _e733 = phi_1651_;
    let _e744 = ((_e719[0] - _e634) * _e637);
    let _e745 = ((_e733[0] - _e635) * _e637);
    let _e746 = vec4<f32>(_e744, f32(), _e745, f32());
    let _e749 = ((_e719[1] - _e650) * _e653);
    let _e750 = ((_e733[1] - _e651) * _e653);
    let _e751 = vec4<f32>(_e749, f32(), _e750, f32());
    let _e754 = ((_e719[2] - _e666) * _e669);
    let _e755 = ((_e733[2] - _e667) * _e669);
    let _e756 = vec4<f32>(_e754, f32(), _e755, f32());
    let _e757 = vec4<f32>(_e745, f32(), _e744, f32());
    let _e759 = vec4<f32>(_e750, f32(), _e749, f32());
    let _e761 = vec4<f32>(_e755, f32(), _e754, f32());
    phi_1824_ = _e686;
    phi_1827_ = select(4294967295u, select(4294967295u, 0u, (_e677 <= _e676)), (max(max(max(min(_e746, _e757).x, min(_e751, _e759).x), min(_e756, _e761).x), _e677) <= min((min(min(max(_e746, _e757).x, max(_e751, _e759).x), max(_e756, _e761).x) + (max(max(_e756, _e761).x, -(min(_e756, _e761).x)) * 0.0000019073523f)), _e686.member.member_1)));
    phi_1829_ = select(0u, 4294967295u, (_e115 == 0u));
    phi_1831_ = (_e115 + 1u);
    loop {
        let _e785 = phi_1824_;
        let _e787 = phi_1827_;
        let _e789 = phi_1829_;
        let _e791 = phi_1831_;
        local_6 = _e785;
        let _e792 = (_e787 <= 2147483647u);
        if _e792 {
            phi_1840_ = _e787;
            phi_1843_ = _e789;
            phi_1845_ = _e791;
            loop {
                let _e794 = phi_1840_;
                let _e796 = phi_1843_;
                let _e798 = phi_1845_;
                local_2 = _e796;
                local_3 = _e794;
                local_4 = _e794;
                local_8 = _e794;
                local_9 = _e796;
                local_10 = _e798;
                let _e799 = (_e794 <= 2147483647u);
                let _e802 = (_e799 && !((_e796 >= _e115)));
                local_1 = _e799;
                if _e802 {
                    let _e807 = slimbvh_nodes.member[_e796][select(_e691, 2u, (2u < _e691))];
                    let _e812 = slimbvh_nodes.member[_e796][select(_e692, 2u, (2u < _e692))];
                    let _e817 = slimbvh_nodes.member[_e796][select(_e693, 2u, (2u < _e693))];
                    let _e820 = bitcast<u32>(_e162);
                    let _e825 = bitcast<f32>(_e807.x);
                    let _e826 = bitcast<f32>((_e820 + ((_e807.w & 31u) << bitcast<u32>(23i))));
                    let _e827 = (_e825 + _e826);
                    if ((bitcast<u32>(_e637) >> bitcast<u32>(31i)) == 0u) {
                        phi_1938_ = SlimbvhTypeI(_e807.z, _e827);
                        phi_1939_ = SlimbvhTypeI(_e807.y, _e825);
                    } else {
                        phi_1938_ = SlimbvhTypeI(_e807.y, _e825);
                        phi_1939_ = SlimbvhTypeI(_e807.z, _e827);
                    }
                    let _e838 = phi_1938_;
                    let _e840 = phi_1939_;
                    let _e879 = bitcast<f32>(_e812.x);
                    let _e880 = bitcast<f32>((_e820 + ((_e812.w & 31u) << bitcast<u32>(23i))));
                    let _e881 = (_e879 + _e880);
                    if ((bitcast<u32>(_e653) >> bitcast<u32>(31i)) == 0u) {
                        phi_1979_ = SlimbvhTypeI(_e812.z, _e881);
                        phi_1980_ = SlimbvhTypeI(_e812.y, _e879);
                    } else {
                        phi_1979_ = SlimbvhTypeI(_e812.y, _e879);
                        phi_1980_ = SlimbvhTypeI(_e812.z, _e881);
                    }
                    let _e892 = phi_1979_;
                    let _e894 = phi_1980_;
                    let _e933 = bitcast<f32>(_e817.x);
                    let _e934 = bitcast<f32>((_e820 + ((_e817.w & 31u) << bitcast<u32>(23i))));
                    let _e935 = (_e933 + _e934);
                    if ((bitcast<u32>(_e669) >> bitcast<u32>(31i)) == 0u) {
                        phi_2020_ = SlimbvhTypeI(_e817.z, _e935);
                        phi_2021_ = SlimbvhTypeI(_e817.y, _e933);
                    } else {
                        phi_2020_ = SlimbvhTypeI(_e817.y, _e933);
                        phi_2021_ = SlimbvhTypeI(_e817.z, _e935);
                    }
                    let _e946 = phi_2020_;
                    let _e948 = phi_2021_;
                    let _e983 = (_e826 * _e637);
                    let _e986 = bitcast<f32>((bitcast<u32>(_e983) & 2147483647u));
                    let _e990 = (((_e840.member_1 - _e634) * _e637) + (_e986 * -0.00012207031f));
                    let _e1002 = (((_e838.member_1 - _e635) * _e637) + (_e986 * 0.00012207031f));
                    let _e1011 = (_e880 * _e653);
                    let _e1014 = bitcast<f32>((bitcast<u32>(_e1011) & 2147483647u));
                    let _e1018 = (((_e894.member_1 - _e650) * _e653) + (_e1014 * -0.00012207031f));
                    let _e1030 = (((_e892.member_1 - _e651) * _e653) + (_e1014 * 0.00012207031f));
                    let _e1039 = (_e934 * _e669);
                    let _e1042 = bitcast<f32>((bitcast<u32>(_e1039) & 2147483647u));
                    let _e1046 = (((_e948.member_1 - _e666) * _e669) + (_e1042 * -0.00012207031f));
                    let _e1051 = ((f32((_e948.member & 255u)) * _e1039) + _e1046);
                    let _e1052 = ((f32(((_e948.member >> bitcast<u32>(8u)) & 255u)) * _e1039) + _e1046);
                    let _e1053 = ((f32(((_e948.member >> bitcast<u32>(16u)) & 255u)) * _e1039) + _e1046);
                    let _e1054 = ((f32(((_e948.member >> bitcast<u32>(24u)) & 255u)) * _e1039) + _e1046);
                    let _e1058 = (((_e946.member_1 - _e667) * _e669) + (_e1042 * 0.00012207031f));
                    let _e1063 = ((f32((_e946.member & 255u)) * _e1039) + _e1058);
                    let _e1064 = ((f32(((_e946.member >> bitcast<u32>(8u)) & 255u)) * _e1039) + _e1058);
                    let _e1065 = ((f32(((_e946.member >> bitcast<u32>(16u)) & 255u)) * _e1039) + _e1058);
                    let _e1066 = ((f32(((_e946.member >> bitcast<u32>(24u)) & 255u)) * _e1039) + _e1058);
                    let _e1099 = max(max(max(((f32((_e840.member & 255u)) * _e983) + _e990), ((f32((_e894.member & 255u)) * _e1011) + _e1018)), _e1051), _e677);
                    let _e1100 = max(max(max(((f32(((_e840.member >> bitcast<u32>(8u)) & 255u)) * _e983) + _e990), ((f32(((_e894.member >> bitcast<u32>(8u)) & 255u)) * _e1011) + _e1018)), _e1052), _e677);
                    let _e1101 = max(max(max(((f32(((_e840.member >> bitcast<u32>(16u)) & 255u)) * _e983) + _e990), ((f32(((_e894.member >> bitcast<u32>(16u)) & 255u)) * _e1011) + _e1018)), _e1053), _e677);
                    let _e1102 = max(max(max(((f32(((_e840.member >> bitcast<u32>(24u)) & 255u)) * _e983) + _e990), ((f32(((_e894.member >> bitcast<u32>(24u)) & 255u)) * _e1011) + _e1018)), _e1054), _e677);
                    let _e1107 = (_e785.member.member_1 + (bitcast<f32>((bitcast<u32>(_e785.member.member_1) & 2147483647u)) * 0.0000004768374f));
                    if (_e1099 <= min((min(min(((f32((_e838.member & 255u)) * _e983) + _e1002), ((f32((_e892.member & 255u)) * _e1011) + _e1030)), _e1063) + (max(_e1063, -(_e1051)) * 0.0000023841915f)), _e1107)) {
                        phi_2501_ = (((bitcast<u32>(_e1099) ^ select(0u, 4294967288u, _e686.member_1)) & 2147483640u) | 4u);
                    } else {
                        phi_2501_ = 4294967288u;
                    }
                    let _e1122 = phi_2501_;
                    if (_e1100 <= min((min(min(((f32(((_e838.member >> bitcast<u32>(8u)) & 255u)) * _e983) + _e1002), ((f32(((_e892.member >> bitcast<u32>(8u)) & 255u)) * _e1011) + _e1030)), _e1064) + (max(_e1064, -(_e1052)) * 0.0000023841915f)), _e1107)) {
                        phi_2514_ = ((((bitcast<u32>(_e1100) ^ select(0u, 4294967288u, _e686.member_1)) & 2147483640u) | 4u) | 1u);
                    } else {
                        phi_2514_ = 4294967288u;
                    }
                    let _e1130 = phi_2514_;
                    if (_e1101 <= min((min(min(((f32(((_e838.member >> bitcast<u32>(16u)) & 255u)) * _e983) + _e1002), ((f32(((_e892.member >> bitcast<u32>(16u)) & 255u)) * _e1011) + _e1030)), _e1065) + (max(_e1065, -(_e1053)) * 0.0000023841915f)), _e1107)) {
                        phi_2527_ = ((((bitcast<u32>(_e1101) ^ select(0u, 4294967288u, _e686.member_1)) & 2147483640u) | 4u) | 2u);
                    } else {
                        phi_2527_ = 4294967288u;
                    }
                    let _e1138 = phi_2527_;
                    if (_e1102 <= min((min(min(((f32(((_e838.member >> bitcast<u32>(24u)) & 255u)) * _e983) + _e1002), ((f32(((_e892.member >> bitcast<u32>(24u)) & 255u)) * _e1011) + _e1030)), _e1066) + (max(_e1066, -(_e1054)) * 0.0000023841915f)), _e1107)) {
                        phi_2540_ = ((((bitcast<u32>(_e1102) ^ select(0u, 4294967288u, _e686.member_1)) & 2147483640u) | 4u) | 3u);
                    } else {
                        phi_2540_ = 4294967288u;
                    }
                    let _e1146 = phi_2540_;
                    if (_e1122 < _e1130) {
                        phi_4779_ = SlimbvhTypeD(_e1122, _e1130);
                    } else {
                        phi_4779_ = SlimbvhTypeD(_e1130, _e1122);
                    }
                    let _e1151 = phi_4779_;
                    if (_e1138 < _e1146) {
                        phi_4791_ = SlimbvhTypeD(_e1138, _e1146);
                    } else {
                        phi_4791_ = SlimbvhTypeD(_e1146, _e1138);
                    }
                    let _e1158 = phi_4791_;
                    if (_e1151.member < _e1158.member) {
                        phi_4803_ = SlimbvhTypeD(_e1151.member, _e1158.member);
                    } else {
                        phi_4803_ = SlimbvhTypeD(_e1158.member, _e1151.member);
                    }
                    let _e1165 = phi_4803_;
                    if (_e1151.member_1 < _e1158.member_1) {
                        phi_4815_ = SlimbvhTypeD(_e1151.member_1, _e1158.member_1);
                    } else {
                        phi_4815_ = SlimbvhTypeD(_e1158.member_1, _e1151.member_1);
                    }
                    let _e1172 = phi_4815_;
                    if (_e1172.member < _e1165.member_1) {
                        phi_4827_ = SlimbvhTypeD(_e1172.member, _e1165.member_1);
                    } else {
                        phi_4827_ = SlimbvhTypeD(_e1165.member_1, _e1172.member);
                    }
                    let _e1179 = phi_4827_;
                    let _e1194 = (((_e1165.member & 7u) | ((_e1179.member & 7u) << bitcast<u32>(3u))) | (((_e1179.member_1 & 7u) | ((_e1172.member_1 & 7u) << bitcast<u32>(3u))) << bitcast<u32>(6u)));
                    if (_e1194 == 0u) {
                        let _e1212 = (_e794 - 1u);
                        let _e1215 = local[(_e1212 % 128u)];
                        let _e1216 = (_e1215 & 511u);
                        let _e1218 = (_e1216 >> bitcast<u32>(3u));
                        let _e1221 = ((_e1218 == 0u) || (_e1212 == 4294967295u));
                        if _e1221 {
                        } else {
                            local[(_e1212 % 128u)] = (((_e1215 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e1218);
                        }
                        phi_2626_ = select(_e794, _e1212, _e1221);
                        phi_2627_ = (((_e1215 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e1216 & 3u) & 3u));
                    } else {
                        let _e1197 = (_e1194 >> bitcast<u32>(3u));
                        if (_e1197 == 0u) {
                            phi_2621_ = _e794;
                        } else {
                            local[(_e794 % 128u)] = ((_e796 << bitcast<u32>(9u)) | _e1197);
                            phi_2621_ = (_e794 + 1u);
                        }
                        let _e1206 = phi_2621_;
                        phi_2626_ = _e1206;
                        phi_2627_ = ((_e796 << bitcast<u32>(2i)) | ((_e1194 & 3u) & 3u));
                    }
                    let _e1236 = phi_2626_;
                    let _e1238 = phi_2627_;
                    let _e1240 = (_e1238 >> bitcast<u32>(2i));
                    if (_e1240 >= _e115) {
                        phi_2685_ = 4294967295u;
                    } else {
                        let _e1245 = slimbvh_nodes.member[_e1240][0u][3u];
                        let _e1249 = slimbvh_nodes.member[_e1240][2u][3u];
                        let _e1260 = ((_e1249 >> bitcast<u32>(5u)) & 65535u);
                        let _e1261 = (_e1238 & 3u);
                        if (((_e1260 >> bitcast<u32>((((4u * _e1261) & 31u) & 31u))) & 8u) != 0u) {
                            let _e1273 = ((_e1260 | (_e1260 << bitcast<u32>(8i))) & 16711935u);
                            phi_2684_ = (((_e1245 >> bitcast<u32>(5u)) | (((_e1249 >> bitcast<u32>(21u)) & 1u) << bitcast<u32>(27u))) + (((((((_e1273 | (_e1273 << bitcast<u32>(4i))) & 252645135u) >> bitcast<u32>(3i)) & 16843009u) * 16843008u) >> bitcast<u32>((((8u * _e1261) & 31u) & 31u))) & 255u));
                        } else {
                            phi_2684_ = (2147483648u | _e1238);
                        }
                        let _e1290 = phi_2684_;
                        phi_2685_ = _e1290;
                    }
                    let _e1292 = phi_2685_;
                    let _e1293 = (_e798 - 1u);
                    phi_1841_ = select(_e1236, 4294967295u, (_e1293 == 0u));
                    phi_1844_ = _e1292;
                    phi_1846_ = _e1293;
                } else {
                    phi_1841_ = u32();
                    phi_1844_ = u32();
                    phi_1846_ = u32();
                }
                let _e1297 = phi_1841_;
                let _e1299 = phi_1844_;
                let _e1301 = phi_1846_;
                continue;
                continuing {
                    phi_1840_ = _e1297;
                    phi_1843_ = _e1299;
                    phi_1845_ = _e1301;
                    break if !(_e802);
                }
            }
            let _e1304 = local_1;
            if _e1304 {
                let _e1306 = local_2;
                let _e1307 = (_e1306 & 2147483647u);
                let _e1309 = (_e1307 >> bitcast<u32>(2i));
                if (_e1309 >= _e115) {
                    phi_2934_ = SlimbvhTypeL(SlimbvhTypeK(vec4<f32>(0f, 0f, 0f, 0f), 0u), 0u, 0u);
                } else {
                    let _e1315 = slimbvh_nodes.member[_e1309][select(_e691, 2u, (2u < _e691))];
                    let _e1324 = slimbvh_nodes.member[_e1309][select(_e692, 2u, (2u < _e692))];
                    let _e1333 = slimbvh_nodes.member[_e1309][select(_e693, 2u, (2u < _e693))];
                    let _e1341 = slimbvh_nodes.member[_e1309][0u][3u];
                    let _e1345 = slimbvh_nodes.member[_e1309][1u][3u];
                    let _e1349 = slimbvh_nodes.member[_e1309][2u][3u];
                    let _e1368 = ((_e1349 >> bitcast<u32>(5u)) & 65535u);
                    let _e1371 = ((_e1349 >> bitcast<u32>(23u)) & 255u);
                    let _e1372 = (_e1307 & 3u);
                    switch bitcast<i32>(((_e1371 >> bitcast<u32>((((2u * _e1372) & 31u) & 31u))) & 3u)) {
                        case 0: {
                            phi_2815_ = 0u;
                            break;
                        }
                        case 1: {
                            phi_2815_ = 1u;
                            break;
                        }
                        default: {
                            phi_2815_ = 2u;
                            break;
                        }
                    }
                    let _e1381 = phi_2815_;
                    let _e1386 = (_e1368 >> bitcast<u32>((((4u * _e1372) & 31u) & 31u)));
                    if ((_e1386 & 8u) != 0u) {
                        let _e1437 = ((_e1368 | (_e1368 << bitcast<u32>(8i))) & 16711935u);
                        phi_2891_ = (((_e1341 >> bitcast<u32>(5u)) | (((_e1349 >> bitcast<u32>(21u)) & 1u) << bitcast<u32>(27u))) + (((((((_e1437 | (_e1437 << bitcast<u32>(4i))) & 252645135u) >> bitcast<u32>(3i)) & 16843009u) * 16843008u) >> bitcast<u32>((((8u * _e1372) & 31u) & 31u))) & 255u));
                    } else {
                        let _e1392 = ((_e1368 | (_e1368 << bitcast<u32>(8i))) & 16711935u);
                        let _e1397 = (((_e1392 | (_e1392 << bitcast<u32>(4i))) & 252645135u) & 117901063u);
                        let _e1401 = ((_e1371 | (_e1371 << bitcast<u32>(12i))) & 983055u);
                        let _e1405 = ((_e1401 | (_e1401 << bitcast<u32>(6i))) & 50529027u);
                        phi_2891_ = ((2147483648u | (((_e1386 & 15u) & 7u) << bitcast<u32>(28u))) | ((((_e1345 >> bitcast<u32>(5u)) | (((_e1349 >> bitcast<u32>(22u)) & 1u) << bitcast<u32>(27u))) + (((((4u * _e1397) + (3u * ((_e1397 & ((_e1405 & 16843009u) * 255u)) + (2u * (_e1397 & (((_e1405 >> bitcast<u32>(1i)) & 16843009u) * 255u)))))) * 16843008u) >> bitcast<u32>((((8u * _e1372) & 31u) & 31u))) & 255u)) & 268435455u));
                    }
                    let _e1454 = phi_2891_;
                    let _e1457 = (((8u * _e1372) & 31u) & 31u);
                    phi_2934_ = SlimbvhTypeL(SlimbvhTypeK(vec4<f32>((bitcast<f32>(_e1315.x) + (f32((((_e1315.y >> bitcast<u32>(_e1457)) & 255u) << bitcast<u32>(((_e1315.w & 31u) & 31u)))) * _e162)), (bitcast<f32>(_e1324.x) + (f32((((_e1324.y >> bitcast<u32>(_e1457)) & 255u) << bitcast<u32>(((_e1324.w & 31u) & 31u)))) * _e162)), (bitcast<f32>(_e1333.x) + (f32((((_e1333.y >> bitcast<u32>(_e1457)) & 255u) << bitcast<u32>(((_e1333.w & 31u) & 31u)))) * _e162)), 0f), _e1381), (_e1454 & 268435455u), ((_e1454 >> bitcast<u32>(28u)) & 7u));
                }
                let _e1496 = phi_2934_;
                phi_2938_ = _e785;
                phi_2941_ = SlimbvhTypeD(0u, _e1496.member_2);
                loop {
                    let _e1500 = phi_2938_;
                    let _e1502 = phi_2941_;
                    local_5 = _e1500;
                    local_7 = _e1500;
                    if (_e1502.member < _e1502.member_1) {
                        phi_2942_ = SlimbvhTypeD((_e1502.member + 1u), _e1502.member_1);
                        phi_2964_ = SlimbvhTypeD(1u, _e1502.member);
                    } else {
                        phi_2942_ = _e1502;
                        phi_2964_ = SlimbvhTypeD(0u, SlimbvhTypeD().member_1);
                    }
                    let _e1515 = phi_2942_;
                    let _e1517 = phi_2964_;
                    let _e1521 = (bitcast<i32>(_e1517.member) != 0i);
                    if _e1521 {
                        switch bitcast<i32>(_e1496.member.member_1) {
                            case 0: {
                                phi_2981_ = 1u;
                                break;
                            }
                            case 1: {
                                phi_2981_ = 2u;
                                break;
                            }
                            case 2: {
                                phi_2981_ = 3u;
                                break;
                            }
                            default: {
                                phi_2981_ = u32();
                                break;
                            }
                        }
                        let _e1527 = phi_2981_;
                        switch bitcast<i32>(_e1496.member.member_1) {
                            case 0: {
                                phi_2992_ = 1u;
                                break;
                            }
                            case 1: {
                                phi_2992_ = 2u;
                                break;
                            }
                            case 2: {
                                phi_2992_ = 3u;
                                break;
                            }
                            default: {
                                phi_2992_ = u32();
                                break;
                            }
                        }
                        let _e1534 = phi_2992_;
                        let _e1536 = ((_e1496.member_1 + (_e1517.member_1 * ((3u * _e1527) + 1u))) + (3u * _e1534));
                        if (_e1536 < _e118) {
                            let _e1539 = slimbvh_triangles.member[_e1536];
                            phi_3008_ = _e1539;
                        } else {
                            phi_3008_ = 4294967295u;
                        }
                        let _e1541 = phi_3008_;
                        switch bitcast<i32>(_e1496.member.member_1) {
                            case 0: {
                                phi_3023_ = 1u;
                                break;
                            }
                            case 1: {
                                phi_3023_ = 2u;
                                break;
                            }
                            case 2: {
                                phi_3023_ = 3u;
                                break;
                            }
                            default: {
                                phi_3023_ = u32();
                                break;
                            }
                        }
                        let _e1545 = phi_3023_;
                        let _e1549 = (_e1496.member_1 + (_e1517.member_1 * ((3u * _e1545) + 1u)));
                        switch bitcast<i32>(_e1496.member.member_1) {
                            case 0: {
                                if (_e1549 < _e118) {
                                    let _e1829 = slimbvh_triangles.member[_e1549];
                                    phi_3049_ = _e1829;
                                } else {
                                    phi_3049_ = 0u;
                                }
                                let _e1831 = phi_3049_;
                                let _e1834 = ((10u * _e222) & 31u);
                                let _e1845 = ((10u * _e226) & 31u);
                                let _e1856 = ((10u * _e218) & 31u);
                                let _e1866 = (_e1549 + 1u);
                                if (_e1866 < _e118) {
                                    let _e1869 = slimbvh_triangles.member[_e1866];
                                    phi_3098_ = _e1869;
                                } else {
                                    phi_3098_ = 0u;
                                }
                                let _e1871 = phi_3098_;
                                let _e1897 = (_e1549 + 2u);
                                if (_e1897 < _e118) {
                                    let _e1900 = slimbvh_triangles.member[_e1897];
                                    phi_3147_ = _e1900;
                                } else {
                                    phi_3147_ = 0u;
                                }
                                let _e1902 = phi_3147_;
                                phi_3648_ = array<array<f32, 3>, 3>(array<f32, 3>((_e1496.member.member.x + ((bitcast<f32>((1258291200u | ((_e1831 >> bitcast<u32>(_e1834)) & 1023u))) - 8388608f) * _e162)), (_e1496.member.member.y + ((bitcast<f32>((1258291200u | ((_e1831 >> bitcast<u32>(_e1845)) & 1023u))) - 8388608f) * _e162)), (_e1496.member.member.z + ((bitcast<f32>((1258291200u | ((_e1831 >> bitcast<u32>(_e1856)) & 1023u))) - 8388608f) * _e162))), array<f32, 3>((_e1496.member.member.x + ((bitcast<f32>((1258291200u | ((_e1871 >> bitcast<u32>(_e1834)) & 1023u))) - 8388608f) * _e162)), (_e1496.member.member.y + ((bitcast<f32>((1258291200u | ((_e1871 >> bitcast<u32>(_e1845)) & 1023u))) - 8388608f) * _e162)), (_e1496.member.member.z + ((bitcast<f32>((1258291200u | ((_e1871 >> bitcast<u32>(_e1856)) & 1023u))) - 8388608f) * _e162))), array<f32, 3>((_e1496.member.member.x + ((bitcast<f32>((1258291200u | ((_e1902 >> bitcast<u32>(_e1834)) & 1023u))) - 8388608f) * _e162)), (_e1496.member.member.y + ((bitcast<f32>((1258291200u | ((_e1902 >> bitcast<u32>(_e1845)) & 1023u))) - 8388608f) * _e162)), (_e1496.member.member.z + ((bitcast<f32>((1258291200u | ((_e1902 >> bitcast<u32>(_e1856)) & 1023u))) - 8388608f) * _e162))));
                                break;
                            }
                            case 1: {
                                if (_e1549 < _e118) {
                                    let _e1640 = slimbvh_triangles.member[_e1549];
                                    phi_3196_ = _e1640;
                                } else {
                                    phi_3196_ = 0u;
                                }
                                let _e1642 = phi_3196_;
                                let _e1643 = (_e1549 + 1u);
                                if (_e1643 < _e118) {
                                    let _e1646 = slimbvh_triangles.member[_e1643];
                                    phi_3211_ = _e1646;
                                } else {
                                    phi_3211_ = 0u;
                                }
                                let _e1648 = phi_3211_;
                                let _e1650 = (_e222 == 1u);
                                if _e1650 {
                                    phi_3221_ = ((_e1642 >> bitcast<u32>(21i)) | (_e1648 << bitcast<u32>(11i)));
                                } else {
                                    phi_3221_ = (_e1648 >> bitcast<u32>(10i));
                                }
                                let _e1659 = phi_3221_;
                                let _e1668 = (_e226 == 1u);
                                if _e1668 {
                                    phi_3242_ = ((_e1642 >> bitcast<u32>(21i)) | (_e1648 << bitcast<u32>(11i)));
                                } else {
                                    phi_3242_ = (_e1648 >> bitcast<u32>(10i));
                                }
                                let _e1677 = phi_3242_;
                                let _e1686 = (_e218 == 1u);
                                if _e1686 {
                                    phi_3263_ = ((_e1642 >> bitcast<u32>(21i)) | (_e1648 << bitcast<u32>(11i)));
                                } else {
                                    phi_3263_ = (_e1648 >> bitcast<u32>(10i));
                                }
                                let _e1695 = phi_3263_;
                                let _e1704 = (_e1549 + 2u);
                                if (_e1704 < _e118) {
                                    let _e1707 = slimbvh_triangles.member[_e1704];
                                    phi_3293_ = _e1707;
                                } else {
                                    phi_3293_ = 0u;
                                }
                                let _e1709 = phi_3293_;
                                let _e1710 = (_e1549 + 3u);
                                if (_e1710 < _e118) {
                                    let _e1713 = slimbvh_triangles.member[_e1710];
                                    phi_3308_ = _e1713;
                                } else {
                                    phi_3308_ = 0u;
                                }
                                let _e1715 = phi_3308_;
                                if _e1650 {
                                    phi_3318_ = ((_e1709 >> bitcast<u32>(21i)) | (_e1715 << bitcast<u32>(11i)));
                                } else {
                                    phi_3318_ = (_e1715 >> bitcast<u32>(10i));
                                }
                                let _e1724 = phi_3318_;
                                if _e1668 {
                                    phi_3339_ = ((_e1709 >> bitcast<u32>(21i)) | (_e1715 << bitcast<u32>(11i)));
                                } else {
                                    phi_3339_ = (_e1715 >> bitcast<u32>(10i));
                                }
                                let _e1740 = phi_3339_;
                                if _e1686 {
                                    phi_3360_ = ((_e1709 >> bitcast<u32>(21i)) | (_e1715 << bitcast<u32>(11i)));
                                } else {
                                    phi_3360_ = (_e1715 >> bitcast<u32>(10i));
                                }
                                let _e1756 = phi_3360_;
                                let _e1765 = (_e1549 + 4u);
                                if (_e1765 < _e118) {
                                    let _e1768 = slimbvh_triangles.member[_e1765];
                                    phi_3390_ = _e1768;
                                } else {
                                    phi_3390_ = 0u;
                                }
                                let _e1770 = phi_3390_;
                                let _e1771 = (_e1549 + 5u);
                                if (_e1771 < _e118) {
                                    let _e1774 = slimbvh_triangles.member[_e1771];
                                    phi_3405_ = _e1774;
                                } else {
                                    phi_3405_ = 0u;
                                }
                                let _e1776 = phi_3405_;
                                if _e1650 {
                                    phi_3415_ = ((_e1770 >> bitcast<u32>(21i)) | (_e1776 << bitcast<u32>(11i)));
                                } else {
                                    phi_3415_ = (_e1776 >> bitcast<u32>(10i));
                                }
                                let _e1785 = phi_3415_;
                                if _e1668 {
                                    phi_3436_ = ((_e1770 >> bitcast<u32>(21i)) | (_e1776 << bitcast<u32>(11i)));
                                } else {
                                    phi_3436_ = (_e1776 >> bitcast<u32>(10i));
                                }
                                let _e1801 = phi_3436_;
                                if _e1686 {
                                    phi_3457_ = ((_e1770 >> bitcast<u32>(21i)) | (_e1776 << bitcast<u32>(11i)));
                                } else {
                                    phi_3457_ = (_e1776 >> bitcast<u32>(10i));
                                }
                                let _e1817 = phi_3457_;
                                phi_3648_ = array<array<f32, 3>, 3>(array<f32, 3>((_e1496.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1659, _e1642, _e227) & 2097151u))) - 8388608f) * _e162)), (_e1496.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1677, _e1642, _e230) & 2097151u))) - 8388608f) * _e162)), (_e1496.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1695, _e1642, _e234) & 2097151u))) - 8388608f) * _e162))), array<f32, 3>((_e1496.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1724, _e1709, _e227) & 2097151u))) - 8388608f) * _e162)), (_e1496.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1740, _e1709, _e230) & 2097151u))) - 8388608f) * _e162)), (_e1496.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1756, _e1709, _e234) & 2097151u))) - 8388608f) * _e162))), array<f32, 3>((_e1496.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1785, _e1770, _e227) & 2097151u))) - 8388608f) * _e162)), (_e1496.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1801, _e1770, _e230) & 2097151u))) - 8388608f) * _e162)), (_e1496.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1817, _e1770, _e234) & 2097151u))) - 8388608f) * _e162))));
                                break;
                            }
                            case 2: {
                                let _e1551 = (_e1549 + _e222);
                                if (_e1551 < _e118) {
                                    let _e1554 = slimbvh_triangles.member[_e1551];
                                    phi_3488_ = _e1554;
                                } else {
                                    phi_3488_ = 0u;
                                }
                                let _e1556 = phi_3488_;
                                let _e1560 = (_e1549 + _e226);
                                if (_e1560 < _e118) {
                                    let _e1563 = slimbvh_triangles.member[_e1560];
                                    phi_3506_ = _e1563;
                                } else {
                                    phi_3506_ = 0u;
                                }
                                let _e1565 = phi_3506_;
                                let _e1569 = (_e1549 + _e218);
                                if (_e1569 < _e118) {
                                    let _e1572 = slimbvh_triangles.member[_e1569];
                                    phi_3524_ = _e1572;
                                } else {
                                    phi_3524_ = 0u;
                                }
                                let _e1574 = phi_3524_;
                                let _e1579 = (_e1549 + 3u);
                                let _e1580 = (_e1579 + _e222);
                                if (_e1580 < _e118) {
                                    let _e1583 = slimbvh_triangles.member[_e1580];
                                    phi_3547_ = _e1583;
                                } else {
                                    phi_3547_ = 0u;
                                }
                                let _e1585 = phi_3547_;
                                let _e1589 = (_e1579 + _e226);
                                if (_e1589 < _e118) {
                                    let _e1592 = slimbvh_triangles.member[_e1589];
                                    phi_3565_ = _e1592;
                                } else {
                                    phi_3565_ = 0u;
                                }
                                let _e1594 = phi_3565_;
                                let _e1598 = (_e1579 + _e218);
                                if (_e1598 < _e118) {
                                    let _e1601 = slimbvh_triangles.member[_e1598];
                                    phi_3583_ = _e1601;
                                } else {
                                    phi_3583_ = 0u;
                                }
                                let _e1603 = phi_3583_;
                                let _e1608 = (_e1549 + 6u);
                                let _e1609 = (_e1608 + _e222);
                                if (_e1609 < _e118) {
                                    let _e1612 = slimbvh_triangles.member[_e1609];
                                    phi_3606_ = _e1612;
                                } else {
                                    phi_3606_ = 0u;
                                }
                                let _e1614 = phi_3606_;
                                let _e1618 = (_e1608 + _e226);
                                if (_e1618 < _e118) {
                                    let _e1621 = slimbvh_triangles.member[_e1618];
                                    phi_3624_ = _e1621;
                                } else {
                                    phi_3624_ = 0u;
                                }
                                let _e1623 = phi_3624_;
                                let _e1627 = (_e1608 + _e218);
                                if (_e1627 < _e118) {
                                    let _e1630 = slimbvh_triangles.member[_e1627];
                                    phi_3642_ = _e1630;
                                } else {
                                    phi_3642_ = 0u;
                                }
                                let _e1632 = phi_3642_;
                                phi_3648_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1556)) * _e162), (f32(bitcast<i32>(_e1565)) * _e162), (f32(bitcast<i32>(_e1574)) * _e162)), array<f32, 3>((f32(bitcast<i32>(_e1585)) * _e162), (f32(bitcast<i32>(_e1594)) * _e162), (f32(bitcast<i32>(_e1603)) * _e162)), array<f32, 3>((f32(bitcast<i32>(_e1614)) * _e162), (f32(bitcast<i32>(_e1623)) * _e162), (f32(bitcast<i32>(_e1632)) * _e162)));
                                break;
                            }
                            default: {
                                phi_3648_ = array<array<f32, 3>, 3>();
                                break;
                            }
                        }
                        let _e1930 = phi_3648_;
                        let _e1947 = (_e1930[0][2] - _e610.member[2]);
                        let _e1950 = (((_e1930[0][0] - _e610.member[0]) * _e665) - (_e1947 * _e633));
                        let _e1953 = (((_e1930[0][1] - _e610.member[1]) * _e665) - (_e1947 * _e649));
                        let _e1956 = (_e1930[1][2] - _e610.member[2]);
                        let _e1959 = (((_e1930[1][0] - _e610.member[0]) * _e665) - (_e1956 * _e633));
                        let _e1962 = (((_e1930[1][1] - _e610.member[1]) * _e665) - (_e1956 * _e649));
                        let _e1965 = (_e1930[2][2] - _e610.member[2]);
                        let _e1968 = (((_e1930[2][0] - _e610.member[0]) * _e665) - (_e1965 * _e633));
                        let _e1971 = (((_e1930[2][1] - _e610.member[1]) * _e665) - (_e1965 * _e649));
                        let _e1972 = (_e1968 * _e1962);
                        let _e1973 = (_e1971 * _e1959);
                        let _e1974 = (_e1950 * _e1971);
                        let _e1975 = (_e1953 * _e1968);
                        let _e1976 = (_e1959 * _e1953);
                        let _e1977 = (_e1962 * _e1950);
                        let _e1982 = (((_e1972 >= _e1973) && (_e1974 >= _e1975)) && (_e1976 >= _e1977));
                        let _e1988 = (_e1982 || (((_e1972 <= _e1973) && (_e1974 <= _e1975)) && (_e1976 <= _e1977)));
                        if _e1988 {
                            let _e1990 = select(-1f, 1f, _e1982);
                            let _e1992 = ((_e1972 - _e1973) * _e1990);
                            let _e1994 = select(0f, _e1992, (_e1992 > 0f));
                            let _e1996 = ((_e1974 - _e1975) * _e1990);
                            let _e1998 = select(0f, _e1996, (_e1996 > 0f));
                            let _e2000 = ((_e1976 - _e1977) * _e1990);
                            let _e2002 = select(0f, _e2000, (_e2000 > 0f));
                            let _e2004 = ((_e1994 + _e1998) + _e2002);
                            let _e2019 = ((min(min(_e1930[0][0], _e1930[1][0]), _e1930[2][0]) - _e634) * _e637);
                            let _e2020 = ((max(max(_e1930[0][0], _e1930[1][0]), _e1930[2][0]) - _e635) * _e637);
                            let _e2021 = vec4<f32>(_e2019, f32(), _e2020, f32());
                            let _e2024 = ((min(min(_e1930[0][1], _e1930[1][1]), _e1930[2][1]) - _e650) * _e653);
                            let _e2025 = ((max(max(_e1930[0][1], _e1930[1][1]), _e1930[2][1]) - _e651) * _e653);
                            let _e2026 = vec4<f32>(_e2024, f32(), _e2025, f32());
                            let _e2029 = ((min(min(_e1930[0][2], _e1930[1][2]), _e1930[2][2]) - _e666) * _e669);
                            let _e2030 = ((max(max(_e1930[0][2], _e1930[1][2]), _e1930[2][2]) - _e667) * _e669);
                            let _e2031 = vec4<f32>(_e2029, f32(), _e2030, f32());
                            let _e2032 = vec4<f32>(_e2020, f32(), _e2019, f32());
                            let _e2034 = vec4<f32>(_e2025, f32(), _e2024, f32());
                            let _e2036 = vec4<f32>(_e2030, f32(), _e2029, f32());
                            let _e2045 = max(max(min(_e2021, _e2032).x, min(_e2026, _e2034).x), min(_e2031, _e2036).x);
                            let _e2050 = min(min(max(_e2021, _e2032).x, max(_e2026, _e2034).x), max(_e2031, _e2036).x);
                            let _e2055 = max(_e2045, _e677);
                            let _e2077 = (((((_e1988 && (_e2004 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e1950, _e1959), _e1968) <= 0f) && (max(max(_e1950, _e1959), _e1968) >= 0f))) && ((min(min(_e1953, _e1962), _e1971) <= 0f) && (max(max(_e1953, _e1962), _e1971) >= 0f))) && (_e2055 <= (_e2050 + (max(max(_e2031, _e2036).x, -(min(_e2031, _e2036).x)) * 0.0000019073523f)))) && (_e2055 <= _e1500.member.member_1));
                            if _e2077 {
                                let _e2082 = (_e1930[1][0] - _e1930[0][0]);
                                let _e2083 = (_e1930[1][1] - _e1930[0][1]);
                                let _e2084 = (_e1930[1][2] - _e1930[0][2]);
                                let _e2085 = vec3<f32>(_e2082, _e2083, _e2084);
                                let _e2086 = (_e1930[2][0] - _e1930[1][0]);
                                let _e2087 = (_e1930[2][1] - _e1930[1][1]);
                                let _e2088 = (_e1930[2][2] - _e1930[1][2]);
                                let _e2089 = vec3<f32>(_e2086, _e2087, _e2088);
                                let _e2090 = (_e1930[0][0] - _e1930[2][0]);
                                let _e2091 = (_e1930[0][1] - _e1930[2][1]);
                                let _e2092 = (_e1930[0][2] - _e1930[2][2]);
                                let _e2093 = vec3<f32>(_e2090, _e2091, _e2092);
                                let _e2104 = max(max(bitcast<f32>((bitcast<u32>(_e2082) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2083) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2084) & 2147483647u)));
                                let _e2115 = max(max(bitcast<f32>((bitcast<u32>(_e2086) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2087) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2088) & 2147483647u)));
                                let _e2128 = max(max(_e2104, _e2115), max(max(bitcast<f32>((bitcast<u32>(_e2090) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2091) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2092) & 2147483647u))));
                                if (_e2104 == _e2128) {
                                    phi_4013_ = _e1962;
                                    phi_4014_ = _e1959;
                                    phi_4015_ = _e1953;
                                    phi_4016_ = _e1950;
                                    phi_4017_ = vec3<f32>(_e1930[0][0], _e1930[0][1], _e1930[0][2]);
                                    phi_4018_ = _e2093;
                                    phi_4019_ = _e2089;
                                    phi_4020_ = _e2085;
                                } else {
                                    let _e2130 = (_e2115 == _e2128);
                                    let _e2135 = vec3(_e2130);
                                    phi_4013_ = select(_e1953, _e1971, _e2130);
                                    phi_4014_ = select(_e1950, _e1968, _e2130);
                                    phi_4015_ = select(_e1971, _e1962, _e2130);
                                    phi_4016_ = select(_e1968, _e1959, _e2130);
                                    phi_4017_ = select(vec3<f32>(_e1930[2][0], _e1930[2][1], _e1930[2][2]), vec3<f32>(_e1930[1][0], _e1930[1][1], _e1930[1][2]), _e2135);
                                    phi_4018_ = select(_e2089, _e2085, _e2135);
                                    phi_4019_ = select(_e2085, _e2093, _e2135);
                                    phi_4020_ = select(_e2093, _e2089, _e2135);
                                }
                                let _e2141 = phi_4013_;
                                let _e2143 = phi_4014_;
                                let _e2145 = phi_4015_;
                                let _e2147 = phi_4016_;
                                let _e2149 = phi_4017_;
                                let _e2151 = phi_4018_;
                                let _e2153 = phi_4019_;
                                let _e2155 = phi_4020_;
                                let _e2162 = ((_e2153.y * _e2151.z) - (_e2151.y * _e2153.z));
                                let _e2167 = ((_e2153.z * _e2151.x) - (_e2151.z * _e2153.x));
                                let _e2170 = ((_e2153.x * _e2151.y) - (_e2151.x * _e2153.y));
                                let _e2173 = ((_e1994 >= _e1998) && (_e1994 >= _e2002));
                                let _e2174 = (_e1998 >= _e2002);
                                let _e2188 = (((_e2162 * (select(select(_e1930[2][0], _e1930[1][0], _e2174), _e1930[0][0], _e2173) - _e610.member[0])) + (_e2167 * (select(select(_e1930[2][1], _e1930[1][1], _e2174), _e1930[0][1], _e2173) - _e610.member[1]))) + (_e2170 * (select(select(_e1930[2][2], _e1930[1][2], _e2174), _e1930[0][2], _e2173) - _e610.member[2])));
                                let _e2193 = (((_e2162 * _e633) + (_e2167 * _e649)) + (_e2170 * _e665));
                                let _e2194 = (_e2143 - _e2147);
                                let _e2195 = (_e2141 - _e2145);
                                let _e2198 = ((_e2194 * _e2194) + (_e2195 * _e2195));
                                let _e2205 = (-(((_e2147 * _e2194) + (_e2145 * _e2195))) / select(0.000000000000000000000000000000000000011754944f, _e2198, (_e2198 > 0.000000000000000000000000000000000000011754944f)));
                                let _e2207 = select(1f, _e2205, (_e2205 < 1f));
                                let _e2209 = select(0f, _e2207, (_e2207 > 0f));
                                let _e2218 = ((_e2149.x + (_e2155.x * _e2209)) - _e610.member[0]);
                                let _e2221 = ((_e2149.y + (_e2155.y * _e2209)) - _e610.member[1]);
                                let _e2224 = ((_e2149.z + (_e2155.z * _e2209)) - _e610.member[2]);
                                let _e2289 = ((bitcast<f32>((bitcast<u32>(((((_e2162 * _e2218) + (_e2167 * _e2221)) + (_e2170 * _e2224)) - _e2188)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e2218) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2221) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2224) & 2147483647u))), _e2128)) * max(max(bitcast<f32>((bitcast<u32>(_e2162) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2167) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2170) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e2193) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e2153.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2153.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2153.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e2151.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2151.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2151.z) & 2147483647u)))))));
                                let _e2290 = (_e2188 / _e2193);
                                if (_e2077 && !(_e2289)) {
                                    let _e2293 = (_e2224 / _e665);
                                    let _e2301 = (((_e2162 * (_e2218 - (_e633 * _e2293))) + (_e2167 * (_e2221 - (_e649 * _e2293)))) / _e2193);
                                    phi_4199_ = select(select(_e2293, (_e2293 + _e2301), (bitcast<f32>((bitcast<u32>(_e2301) & 2147483647u)) <= _e2128)), _e2290, _e2289);
                                } else {
                                    phi_4199_ = _e2290;
                                }
                                let _e2310 = phi_4199_;
                                let _e2312 = select(_e2050, _e2310, (_e2310 < _e2050));
                                let _e2314 = select(_e2045, _e2312, (_e2312 > _e2045));
                                let _e2317 = select(_e2314, 0f, (bitcast<u32>(_e2314) == 2147483648u));
                                let _e2318 = (1f / _e2004);
                                phi_4225_ = SlimbvhTypeE(_e2317, (_e1998 * _e2318), (_e2002 * _e2318), ((_e2077 && (_e2317 >= _e677)) && (_e2317 <= _e1500.member.member_1)));
                                phi_4226_ = SlimbvhTypeE();
                            } else {
                                phi_4225_ = SlimbvhTypeE();
                                phi_4226_ = SlimbvhTypeE(0f, 0f, 0f, _e2077);
                            }
                            let _e2327 = phi_4225_;
                            let _e2329 = phi_4226_;
                            phi_4229_ = _e2327;
                            phi_4230_ = _e2329;
                            phi_4231_ = select(true, false, _e2077);
                        } else {
                            phi_4229_ = SlimbvhTypeE();
                            phi_4230_ = SlimbvhTypeE(0f, 0f, 0f, _e1988);
                            phi_4231_ = true;
                        }
                        let _e2332 = phi_4229_;
                        let _e2334 = phi_4230_;
                        let _e2336 = phi_4231_;
                        if _e2336 {
                            phi_4235_ = _e2334;
                        } else {
                            phi_4235_ = _e2332;
                        }
                        let _e2338 = phi_4235_;
                        if _e2338.member_3 {
                            phi_4244_ = SlimbvhTypeF(_e2338.member, _e2338.member_1, _e2338.member_2, _e1541);
                        } else {
                            phi_4244_ = _e111;
                        }
                        let _e2345 = phi_4244_;
                        if (_e2345.member_3 != 4294967295u) {
                            if (_e1541 != 4294967295u) {
                                if (_e2345.member < _e1500.member.member.member) {
                                    phi_4272_ = true;
                                } else {
                                    if (_e2345.member == _e1500.member.member.member) {
                                        phi_4271_ = (_e2345.member_3 < _e1500.member.member.member_3);
                                    } else {
                                        phi_4271_ = false;
                                    }
                                    let _e2360 = phi_4271_;
                                    phi_4272_ = _e2360;
                                }
                                let _e2362 = phi_4272_;
                                if _e2362 {
                                    phi_4279_ = SlimbvhTypeO(SlimbvhTypeH(_e2345, _e2345.member), _e1500.member_1);
                                } else {
                                    phi_4279_ = _e1500;
                                }
                                let _e2368 = phi_4279_;
                                if _e2368.member_1 {
                                    phi_4285_ = SlimbvhTypeO(SlimbvhTypeH(_e2368.member.member, bitcast<f32>(4286578687u)), _e2368.member_1);
                                } else {
                                    phi_4285_ = _e2368;
                                }
                                let _e2377 = phi_4285_;
                                phi_4286_ = _e2377;
                            } else {
                                phi_4286_ = _e1500;
                            }
                            let _e2379 = phi_4286_;
                            phi_4287_ = _e2379;
                        } else {
                            phi_4287_ = _e1500;
                        }
                        let _e2381 = phi_4287_;
                        phi_2939_ = _e2381;
                    } else {
                        phi_2939_ = SlimbvhTypeO();
                    }
                    let _e2383 = phi_2939_;
                    continue;
                    continuing {
                        phi_2938_ = _e2383;
                        phi_2941_ = _e1515;
                        break if !(_e1521);
                    }
                }
                let _e2386 = local_3;
                let _e2387 = (_e2386 - 1u);
                let _e2390 = local[(_e2387 % 128u)];
                let _e2391 = (_e2390 & 511u);
                let _e2393 = (_e2391 >> bitcast<u32>(3u));
                let _e2396 = ((_e2393 == 0u) || (_e2387 == 4294967295u));
                if _e2396 {
                } else {
                    local[(_e2387 % 128u)] = (((_e2390 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e2393);
                }
                let _e2403 = local_4;
                let _e2411 = (((_e2390 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e2391 & 3u) & 3u));
                let _e2413 = (_e2411 >> bitcast<u32>(2i));
                if (_e2413 >= _e115) {
                    phi_4380_ = 4294967295u;
                } else {
                    let _e2418 = slimbvh_nodes.member[_e2413][0u][3u];
                    let _e2422 = slimbvh_nodes.member[_e2413][2u][3u];
                    let _e2433 = ((_e2422 >> bitcast<u32>(5u)) & 65535u);
                    let _e2434 = (_e2411 & 3u);
                    if (((_e2433 >> bitcast<u32>((((4u * _e2434) & 31u) & 31u))) & 8u) != 0u) {
                        let _e2446 = ((_e2433 | (_e2433 << bitcast<u32>(8i))) & 16711935u);
                        phi_4379_ = (((_e2418 >> bitcast<u32>(5u)) | (((_e2422 >> bitcast<u32>(21u)) & 1u) << bitcast<u32>(27u))) + (((((((_e2446 | (_e2446 << bitcast<u32>(4i))) & 252645135u) >> bitcast<u32>(3i)) & 16843009u) * 16843008u) >> bitcast<u32>((((8u * _e2434) & 31u) & 31u))) & 255u));
                    } else {
                        phi_4379_ = (2147483648u | _e2411);
                    }
                    let _e2463 = phi_4379_;
                    phi_4380_ = _e2463;
                }
                let _e2465 = phi_4380_;
                let _e2467 = local_5;
                let _e2752 = local_7;
                phi_4389_ = _e2752;
                phi_4390_ = select(select(_e2403, _e2387, _e2396), 4294967295u, (_e677 > _e2467.member.member_1));
                phi_4391_ = _e2465;
            } else {
                phi_4389_ = _e785;
                let _e2755 = local_8;
                phi_4390_ = _e2755;
                let _e2758 = local_9;
                phi_4391_ = _e2758;
            }
            let _e2473 = phi_4389_;
            let _e2475 = phi_4390_;
            let _e2477 = phi_4391_;
            phi_1825_ = _e2473;
            phi_1828_ = _e2475;
            phi_1830_ = _e2477;
            let _e2764 = local_10;
            phi_1832_ = _e2764;
        } else {
            phi_1825_ = SlimbvhTypeO();
            phi_1828_ = u32();
            phi_1830_ = u32();
            phi_1832_ = u32();
        }
        let _e2479 = phi_1825_;
        let _e2481 = phi_1828_;
        let _e2483 = phi_1830_;
        let _e2485 = phi_1832_;
        continue;
        continuing {
            phi_1824_ = _e2479;
            phi_1827_ = _e2481;
            phi_1829_ = _e2483;
            phi_1831_ = _e2485;
            break if !(_e792);
        }
    }
    let _e2488 = local_6;
    if (_e2488.member.member.member_3 != 4294967295u) {
        let _e2494 = -((_e180 + _e610.member_4));
        let _e2495 = bitcast<u32>(_e2488.member.member.member);
        let _e2499 = (bitcast<i32>((_e2495 >> bitcast<u32>(23i))) & 255i);
        let _e2500 = (_e2499 + _e2494);
        if (_e2499 == 255i) {
            phi_4448_ = _e2488.member.member.member;
        } else {
            if (_e2499 > 0i) {
                if (_e2500 > 0i) {
                    let _e2504 = (_e2500 < 255i);
                    if _e2504 {
                        phi_4427_ = bitcast<f32>((_e2495 + bitcast<u32>((_e2494 << bitcast<u32>(23i)))));
                    } else {
                        phi_4427_ = f32();
                    }
                    let _e2511 = phi_4427_;
                    phi_4429_ = _e2511;
                    phi_4430_ = select(true, false, _e2504);
                } else {
                    phi_4429_ = f32();
                    phi_4430_ = true;
                }
                let _e2514 = phi_4429_;
                let _e2516 = phi_4430_;
                phi_4431_ = _e2514;
                phi_4432_ = _e2516;
            } else {
                phi_4431_ = f32();
                phi_4432_ = true;
            }
            let _e2518 = phi_4431_;
            let _e2520 = phi_4432_;
            if _e2520 {
                let _e2521 = (_e2495 & 2147483648u);
                let _e2528 = ((_e2495 & 8388607u) | (select(0u, 1u, ((_e2495 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e2532 = (_e2528 == 0u);
                if _e2532 {
                    phi_5108_ = bitcast<f32>(_e2521);
                } else {
                    let _e2537 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2528)), 32u, _e2532) - 8u);
                    let _e2540 = (_e2528 << bitcast<u32>((_e2537 & 31u)));
                    let _e2542 = ((_e2500 + select(0i, 1i, (_e2499 == 0i))) - bitcast<i32>(_e2537));
                    if (_e2542 >= 255i) {
                        phi_5098_ = bitcast<f32>((_e2521 | 2139095040u));
                        phi_5099_ = f32();
                        phi_5100_ = true;
                    } else {
                        let _e2544 = (_e2542 > 0i);
                        if _e2544 {
                            phi_5092_ = bitcast<f32>(((_e2521 | (bitcast<u32>(_e2542) << bitcast<u32>(23i))) | (_e2540 & 8388607u)));
                            phi_5093_ = f32();
                        } else {
                            if (_e2542 < -24i) {
                                phi_5058_ = 26u;
                            } else {
                                phi_5058_ = bitcast<u32>((1i - _e2542));
                            }
                            let _e2549 = phi_5058_;
                            let _e2550 = (_e2549 & 31u);
                            let _e2552 = (_e2540 >> bitcast<u32>(_e2550));
                            let _e2556 = (_e2540 & ((1u << bitcast<u32>(_e2550)) - 1u));
                            let _e2560 = (1u << bitcast<u32>(((_e2549 - 1u) & 31u)));
                            if (_e2556 > _e2560) {
                                phi_5079_ = true;
                            } else {
                                if (_e2556 == _e2560) {
                                    phi_5076_ = ((_e2552 & 1u) == 1u);
                                } else {
                                    phi_5076_ = false;
                                }
                                let _e2566 = phi_5076_;
                                phi_5079_ = _e2566;
                            }
                            let _e2568 = phi_5079_;
                            phi_5092_ = f32();
                            phi_5093_ = bitcast<f32>((_e2521 | (_e2552 + select(0u, 1u, _e2568))));
                        }
                        let _e2581 = phi_5092_;
                        let _e2583 = phi_5093_;
                        phi_5098_ = _e2581;
                        phi_5099_ = _e2583;
                        phi_5100_ = _e2544;
                    }
                    let _e2587 = phi_5098_;
                    let _e2589 = phi_5099_;
                    let _e2591 = phi_5100_;
                    phi_5108_ = select(_e2589, _e2587, _e2591);
                }
                let _e2595 = phi_5108_;
                phi_4447_ = _e2595;
            } else {
                phi_4447_ = _e2518;
            }
            let _e2597 = phi_4447_;
            phi_4448_ = _e2597;
        }
        let _e2599 = phi_4448_;
        let _e2600 = bitcast<u32>(_e2599);
        if ((_e2600 & 2147483647u) >= 2139095040u) {
            phi_4460_ = bitcast<f32>(((_e2600 & 2147483648u) | 2139095039u));
        } else {
            phi_4460_ = _e2599;
        }
        let _e2607 = phi_4460_;
        phi_4465_ = SlimbvhTypeF(_e2607, _e2488.member.member.member_1, _e2488.member.member.member_2, _e2488.member.member.member_3);
    } else {
        phi_4465_ = _e111;
    }
    let _e2612 = phi_4465_;
    slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e2612.member), bitcast<u32>(_e2612.member_1), bitcast<u32>(_e2612.member_2), _e2612.member_3);
    return;
}

struct SlimbvhHit {
    t: f32,
    u: f32,
    v: f32,
    primitive: u32,
}

fn slimbvh_closest_hit(origin: vec3<f32>, t_min: f32, direction: vec3<f32>, t_max: f32) -> SlimbvhHit {
    slimbvh_origin.member = vec4<f32>(origin, t_min);
    slimbvh_direction.member = vec4<f32>(direction, t_max);
    slimbvh_any_will_do.member = 0u;
    slimbvh_trace();
    let hit = slimbvh_hit.member;
    return SlimbvhHit(bitcast<f32>(hit.x), bitcast<f32>(hit.y), bitcast<f32>(hit.z), hit.w);
}

fn slimbvh_any_hit(origin: vec3<f32>, t_min: f32, direction: vec3<f32>, t_max: f32) -> bool {
    slimbvh_origin.member = vec4<f32>(origin, t_min);
    slimbvh_direction.member = vec4<f32>(direction, t_max);
    slimbvh_any_will_do.member = 1u;
    slimbvh_trace();
    return slimbvh_hit.member.w != 0xffffffffu;
}
