// Made by slimbvh's shader builder from its Rust: rays traced from your own WGSL. Put this text before yours, bind the
// tree's exponent, nodes and triangles to group 0, and call
//
//   slimbvh_closest_hit(origin, t_min, direction, t_max) -> SlimbvhHit
//   slimbvh_any_hit(origin, t_min, direction, t_max) -> bool
//
// from any stage. t is in units of the direction's length; a miss has the primitive 0xffffffff.

struct SlimbvhTypeA {
    member: u32,
    member_1: u32,
}

struct SlimbvhTypeB {
    member: vec4<u32>,
}

struct SlimbvhTypeC {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct SlimbvhTypeD {
    member: array<array<vec4<f32>, 4>>,
}

struct SlimbvhTypeE {
    member: array<array<vec4<f32>, 5>>,
}

struct SlimbvhTypeF {
    member: vec4<f32>,
}

struct SlimbvhTypeG {
    member: u32,
}

struct SlimbvhTypeH {
    member: SlimbvhTypeC,
    member_1: f32,
}

struct SlimbvhTypeI {
    member: SlimbvhTypeH,
    member_1: bool,
}

struct SlimbvhTypeJ {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct SlimbvhTypeK {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

@group(0) @binding(0) 
var<uniform> slimbvh_exponent: SlimbvhTypeB;
@group(0) @binding(1) 
var<storage> slimbvh_nodes: SlimbvhTypeD;
@group(0) @binding(2) 
var<storage> slimbvh_triangles: SlimbvhTypeE;
var<private> slimbvh_origin: SlimbvhTypeF;
var<private> slimbvh_direction: SlimbvhTypeF;
var<private> slimbvh_any_will_do: SlimbvhTypeG;
var<private> slimbvh_hit: SlimbvhTypeB;

fn slimbvh_trace() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_258_: i32;
    var phi_259_: i32;
    var phi_269_: bool;
    var phi_279_: u32;
    var phi_280_: u32;
    var phi_282_: bool;
    var phi_287_: u32;
    var phi_300_: i32;
    var phi_320_: i32;
    var phi_745_: i32;
    var phi_767_: u32;
    var phi_768_: u32;
    var phi_803_: i32;
    var phi_825_: u32;
    var phi_826_: u32;
    var phi_834_: f32;
    var phi_835_: f32;
    var phi_849_: SlimbvhTypeI;
    var phi_862_: SlimbvhTypeI;
    var phi_865_: u32;
    var phi_867_: i32;
    var phi_869_: u32;
    var phi_878_: u32;
    var phi_881_: i32;
    var phi_883_: u32;
    var phi_973_: SlimbvhTypeJ;
    var phi_1189_: u32;
    var phi_1128_: u32;
    var phi_1139_: u32;
    var phi_1162_: i32;
    var phi_1190_: u32;
    var phi_1191_: i32;
    var phi_1198_: u32;
    var phi_1199_: i32;
    var phi_1200_: u32;
    var phi_879_: u32;
    var phi_882_: i32;
    var phi_884_: u32;
    var phi_1202_: bool;
    var local_2: bool;
    var local_3: u32;
    var local_4: u32;
    var phi_1216_: SlimbvhTypeI;
    var phi_1219_: SlimbvhTypeA;
    var phi_1220_: SlimbvhTypeA;
    var phi_1242_: SlimbvhTypeA;
    var phi_1326_: array<vec4<f32>, 3>;
    var phi_1327_: array<vec4<f32>, 3>;
    var phi_1330_: u32;
    var phi_1402_: array<vec4<f32>, 3>;
    var phi_1403_: array<vec4<f32>, 3>;
    var phi_1426_: array<f32, 3>;
    var phi_1427_: array<f32, 3>;
    var phi_1441_: array<f32, 3>;
    var phi_1442_: array<f32, 3>;
    var phi_1456_: array<f32, 3>;
    var phi_1457_: array<f32, 3>;
    var phi_1773_: f32;
    var phi_1774_: f32;
    var phi_1775_: f32;
    var phi_1776_: f32;
    var phi_1777_: vec3<f32>;
    var phi_1778_: vec3<f32>;
    var phi_1779_: vec3<f32>;
    var phi_1780_: vec3<f32>;
    var phi_1959_: f32;
    var phi_1985_: SlimbvhTypeK;
    var phi_1986_: SlimbvhTypeK;
    var phi_1989_: SlimbvhTypeK;
    var phi_1990_: SlimbvhTypeK;
    var phi_1991_: bool;
    var phi_1995_: SlimbvhTypeK;
    var phi_2004_: SlimbvhTypeC;
    var phi_2029_: bool;
    var phi_2030_: bool;
    var phi_2037_: SlimbvhTypeI;
    var phi_2043_: SlimbvhTypeI;
    var phi_2044_: SlimbvhTypeI;
    var phi_2045_: SlimbvhTypeI;
    var phi_1217_: SlimbvhTypeI;
    var local_5: i32;
    var local_6: SlimbvhTypeI;
    var phi_2072_: u32;
    var phi_2079_: SlimbvhTypeI;
    var phi_2080_: u32;
    var phi_2081_: i32;
    var phi_863_: SlimbvhTypeI;
    var phi_866_: u32;
    var phi_868_: i32;
    var phi_870_: u32;
    var local_7: SlimbvhTypeI;
    var phi_2115_: f32;
    var phi_2117_: f32;
    var phi_2118_: bool;
    var phi_2119_: f32;
    var phi_2120_: bool;
    var phi_2373_: u32;
    var phi_2391_: bool;
    var phi_2394_: bool;
    var phi_2407_: f32;
    var phi_2408_: f32;
    var phi_2413_: f32;
    var phi_2414_: f32;
    var phi_2415_: bool;
    var phi_2423_: f32;
    var phi_2135_: f32;
    var phi_2136_: f32;
    var phi_2148_: f32;
    var phi_2153_: SlimbvhTypeC;
    var local_8: SlimbvhTypeI;
    var local_9: u32;
    var local_10: i32;
    var local_11: u32;

    let _e72 = arrayLength((&slimbvh_nodes.member));
    let _e74 = arrayLength((&slimbvh_triangles.member));
    let _e79 = slimbvh_origin.member;
    let _e85 = slimbvh_origin.member[3u];
    let _e86 = slimbvh_direction.member;
    let _e92 = slimbvh_direction.member[3u];
    let _e95 = slimbvh_exponent.member[0u];
    let _e96 = bitcast<i32>(_e95);
    let _e98 = (bitcast<u32>(_e86.x) & 2147483647u);
    let _e100 = (bitcast<u32>(_e86.y) & 2147483647u);
    let _e102 = (bitcast<u32>(_e86.z) & 2147483647u);
    let _e104 = (bitcast<u32>(_e79.x) & 2147483647u);
    let _e106 = (bitcast<u32>(_e79.y) & 2147483647u);
    let _e108 = (bitcast<u32>(_e79.z) & 2147483647u);
    let _e110 = select(_e100, _e98, (_e100 < _e98));
    let _e112 = select(_e102, _e110, (_e102 < _e110));
    let _e114 = select(_e104, _e112, (_e104 < _e112));
    let _e116 = select(_e106, _e114, (_e106 < _e114));
    let _e118 = select(_e108, _e116, (_e108 < _e116));
    let _e119 = bitcast<u32>(_e85);
    let _e120 = (_e119 & 2147483647u);
    let _e124 = bitcast<u32>(_e92);
    let _e125 = (_e124 & 2147483647u);
    let _e129 = (((select(_e120, _e118, (_e120 < _e118)) < 2139095040u) && (_e125 <= 2139095040u)) && (_e112 > 0u));
    if _e129 {
        let _e132 = (bitcast<u32>(bitcast<f32>(_e112)) & 2147483647u);
        if (_e132 >= 8388608u) {
            phi_258_ = (bitcast<i32>((_e132 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_258_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e132)), 32u, (_e132 == 0u))));
        }
        let _e146 = phi_258_;
        phi_259_ = _e146;
    } else {
        phi_259_ = 0i;
    }
    let _e148 = phi_259_;
    let _e149 = (_e98 == _e112);
    if _e149 {
        phi_269_ = true;
    } else {
        phi_269_ = (_e100 == _e112);
    }
    let _e152 = phi_269_;
    let _e153 = select(1u, 0u, _e149);
    if _e152 {
        let _e154 = (_e153 + 1u);
        phi_279_ = _e154;
        phi_280_ = _e154;
        phi_282_ = select(true, false, (_e154 == 2u));
    } else {
        phi_279_ = u32();
        phi_280_ = 0u;
        phi_282_ = true;
    }
    let _e158 = phi_279_;
    let _e160 = phi_280_;
    let _e162 = phi_282_;
    if _e162 {
        phi_287_ = (_e160 + 1u);
    } else {
        phi_287_ = 0u;
    }
    let _e166 = phi_287_;
    let _e167 = select(_e158, _e160, _e162);
    let _e168 = select(_e153, select(2u, _e153, _e152), _e162);
    if (_e96 < -126i) {
        phi_300_ = -126i;
    } else {
        phi_300_ = select(_e96, 127i, (_e96 > 127i));
    }
    let _e173 = phi_300_;
    let _e178 = bitcast<f32>((bitcast<u32>((_e173 + 127i)) << bitcast<u32>(23i)));
    let _e184 = bitcast<f32>((bitcast<u32>(((_e96 - _e173) + 127i)) << bitcast<u32>(23i)));
    let _e185 = -(_e148);
    if (_e185 < -126i) {
        phi_320_ = -126i;
    } else {
        phi_320_ = select(_e185, 127i, (_e185 > 127i));
    }
    let _e190 = phi_320_;
    let _e195 = bitcast<f32>((bitcast<u32>((_e190 + 127i)) << bitcast<u32>(23i)));
    let _e201 = bitcast<f32>((bitcast<u32>(((_e185 - _e190) + 127i)) << bitcast<u32>(23i)));
    let _e202 = (_e167 == 0u);
    let _e204 = (_e167 == 2u);
    let _e205 = select(select(_e79.y, _e79.x, _e202), _e79.z, _e204);
    let _e206 = bitcast<u32>(_e205);
    let _e208 = ((_e206 & 2139095040u) != 0u);
    let _e222 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e206 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e206 & 2147483648u))), _e205, _e208) * _e178) * select(0.00000011920929f, 1f, _e208)) * _e184);
    let _e224 = select(select(_e86.y, _e86.x, _e202), _e86.z, _e204);
    let _e225 = bitcast<u32>(_e224);
    let _e227 = ((_e225 & 2139095040u) != 0u);
    let _e241 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e225 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e225 & 2147483648u))), _e224, _e227) * _e195) * select(0.00000011920929f, 1f, _e227)) * _e201);
    let _e245 = (bitcast<f32>((bitcast<u32>(_e241) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e248 = bitcast<f32>((bitcast<u32>(_e222) & 2147483647u));
    let _e249 = (_e248 * 0.00000011920929f);
    let _e252 = select(select(0.00000000000011368684f, _e249, (_e249 > 0.00000000000011368684f)), 0f, _e245);
    let _e253 = select(0f, _e241, _e245);
    let _e254 = (_e222 + _e252);
    let _e255 = (_e222 - _e252);
    let _e257 = select(38685626000000000000000000f, (1f / _e241), _e245);
    let _e258 = (_e166 == 0u);
    let _e260 = (_e166 == 2u);
    let _e261 = select(select(_e79.y, _e79.x, _e258), _e79.z, _e260);
    let _e262 = bitcast<u32>(_e261);
    let _e264 = ((_e262 & 2139095040u) != 0u);
    let _e278 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e262 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e262 & 2147483648u))), _e261, _e264) * _e178) * select(0.00000011920929f, 1f, _e264)) * _e184);
    let _e280 = select(select(_e86.y, _e86.x, _e258), _e86.z, _e260);
    let _e281 = bitcast<u32>(_e280);
    let _e283 = ((_e281 & 2139095040u) != 0u);
    let _e297 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e281 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e281 & 2147483648u))), _e280, _e283) * _e195) * select(0.00000011920929f, 1f, _e283)) * _e201);
    let _e301 = (bitcast<f32>((bitcast<u32>(_e297) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e304 = bitcast<f32>((bitcast<u32>(_e278) & 2147483647u));
    let _e305 = (_e304 * 0.00000011920929f);
    let _e308 = select(select(0.00000000000011368684f, _e305, (_e305 > 0.00000000000011368684f)), 0f, _e301);
    let _e309 = select(0f, _e297, _e301);
    let _e310 = (_e278 + _e308);
    let _e311 = (_e278 - _e308);
    let _e313 = select(38685626000000000000000000f, (1f / _e297), _e301);
    let _e314 = (_e168 == 0u);
    let _e316 = (_e168 == 2u);
    let _e317 = select(select(_e79.y, _e79.x, _e314), _e79.z, _e316);
    let _e318 = bitcast<u32>(_e317);
    let _e320 = ((_e318 & 2139095040u) != 0u);
    let _e334 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e318 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e318 & 2147483648u))), _e317, _e320) * _e178) * select(0.00000011920929f, 1f, _e320)) * _e184);
    let _e336 = select(select(_e86.y, _e86.x, _e314), _e86.z, _e316);
    let _e337 = bitcast<u32>(_e336);
    let _e339 = ((_e337 & 2139095040u) != 0u);
    let _e353 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e337 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e337 & 2147483648u))), _e336, _e339) * _e195) * select(0.00000011920929f, 1f, _e339)) * _e201);
    let _e357 = (bitcast<f32>((bitcast<u32>(_e353) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e360 = bitcast<f32>((bitcast<u32>(_e334) & 2147483647u));
    let _e361 = (_e360 * 0.00000011920929f);
    let _e364 = select(select(0.00000000000011368684f, _e361, (_e361 > 0.00000000000011368684f)), 0f, _e357);
    let _e365 = select(0f, _e353, _e357);
    let _e366 = (_e334 + _e364);
    let _e367 = (_e334 - _e364);
    let _e369 = select(38685626000000000000000000f, (1f / _e353), _e357);
    let _e371 = select(_e304, _e248, (_e248 > _e304));
    let _e374 = (_e96 + _e148);
    if (_e129 && (select(_e360, _e371, (_e371 > _e360)) <= 1099511600000f)) {
        let _e384 = ((_e120 & 8388607u) | (select(0u, 1u, ((_e120 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e387 = bitcast<i32>((_e120 >> bitcast<u32>(23i)));
        let _e391 = (_e384 == 0u);
        let _e394 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e384)), 32u, _e391)) - 8i);
        if (_e387 == 255i) {
            phi_745_ = 255i;
        } else {
            phi_745_ = (((_e387 + select(0i, 1i, (_e387 == 0i))) - _e394) + _e374);
        }
        let _e402 = phi_745_;
        let _e412 = (_e402 <= 0i);
        if _e412 {
            phi_768_ = u32();
        } else {
            if _e391 {
                phi_767_ = u32();
            } else {
                phi_767_ = select(((bitcast<u32>(_e402) << bitcast<u32>(23i)) | ((_e384 << bitcast<u32>(((_e394 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e402 >= 255i));
            }
            let _e416 = phi_767_;
            phi_768_ = _e416;
        }
        let _e418 = phi_768_;
        let _e430 = ((_e125 & 8388607u) | (select(0u, 1u, ((_e125 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e433 = bitcast<i32>((_e125 >> bitcast<u32>(23i)));
        let _e437 = (_e430 == 0u);
        let _e440 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e430)), 32u, _e437)) - 8i);
        if (_e433 == 255i) {
            phi_803_ = 255i;
        } else {
            phi_803_ = (((_e433 + select(0i, 1i, (_e433 == 0i))) - _e440) + _e374);
        }
        let _e448 = phi_803_;
        let _e458 = (_e448 <= 0i);
        if _e458 {
            phi_826_ = u32();
        } else {
            if _e437 {
                phi_825_ = u32();
            } else {
                phi_825_ = select(((bitcast<u32>(_e448) << bitcast<u32>(23i)) | ((_e430 << bitcast<u32>(((_e440 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e448 >= 255i));
            }
            let _e462 = phi_825_;
            phi_826_ = _e462;
        }
        let _e464 = phi_826_;
        phi_834_ = bitcast<f32>(((_e124 & 2147483648u) | select(_e464, 0u, select(_e437, true, _e458))));
        phi_835_ = bitcast<f32>(((_e119 & 2147483648u) | select(_e418, 0u, select(_e391, true, _e412))));
    } else {
        phi_834_ = 0f;
        phi_835_ = 1f;
    }
    let _e470 = phi_834_;
    let _e472 = phi_835_;
    let _e473 = slimbvh_any_will_do.member;
    if (_e473 == 1u) {
        phi_849_ = SlimbvhTypeI(SlimbvhTypeH(SlimbvhTypeC(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e470), true);
    } else {
        phi_849_ = SlimbvhTypeI(SlimbvhTypeH(SlimbvhTypeC(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e470), false);
    }
    let _e480 = phi_849_;
    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
    phi_862_ = _e480;
    phi_865_ = select(0u, 2147483648u, (_e72 == 0u));
    phi_867_ = select(-1i, 0i, (_e472 <= _e470));
    phi_869_ = (_e72 + 1u);
    loop {
        let _e487 = phi_862_;
        let _e489 = phi_865_;
        let _e491 = phi_867_;
        let _e493 = phi_869_;
        local_7 = _e487;
        let _e494 = (_e491 > -1i);
        if _e494 {
            phi_878_ = _e489;
            phi_881_ = _e491;
            phi_883_ = _e493;
            loop {
                let _e496 = phi_878_;
                let _e498 = phi_881_;
                let _e500 = phi_883_;
                local_3 = _e496;
                local_4 = _e496;
                local_5 = _e498;
                local_9 = _e496;
                local_10 = _e498;
                local_11 = _e500;
                let _e501 = (_e498 > -1i);
                local_2 = _e501;
                if _e501 {
                    let _e503 = ((_e496 & 2147483648u) != 0u);
                    if _e503 {
                        phi_1198_ = u32();
                        phi_1199_ = i32();
                        phi_1200_ = u32();
                    } else {
                        if (_e496 >= _e72) {
                            phi_973_ = SlimbvhTypeJ(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                        } else {
                            let _e509 = slimbvh_nodes.member[_e496][3u][0u];
                            let _e514 = slimbvh_nodes.member[_e496][3u][1u];
                            let _e519 = slimbvh_nodes.member[_e496][(_e167 % 3u)];
                            let _e524 = slimbvh_nodes.member[_e496][(_e166 % 3u)];
                            let _e529 = slimbvh_nodes.member[_e496][(_e168 % 3u)];
                            phi_973_ = SlimbvhTypeJ(array<vec4<f32>, 3>(_e519, _e524, _e529), bitcast<u32>(_e509), bitcast<u32>(_e514));
                        }
                        let _e535 = phi_973_;
                        let _e548 = ((_e535.member[0].x - _e254) * _e257);
                        let _e549 = ((_e535.member[0].y - _e254) * _e257);
                        let _e550 = ((_e535.member[0].z - _e255) * _e257);
                        let _e551 = ((_e535.member[0].w - _e255) * _e257);
                        let _e561 = ((_e535.member[1].x - _e310) * _e313);
                        let _e562 = ((_e535.member[1].y - _e310) * _e313);
                        let _e563 = ((_e535.member[1].z - _e311) * _e313);
                        let _e564 = ((_e535.member[1].w - _e311) * _e313);
                        let _e574 = ((_e535.member[2].x - _e366) * _e369);
                        let _e575 = ((_e535.member[2].y - _e366) * _e369);
                        let _e576 = ((_e535.member[2].z - _e367) * _e369);
                        let _e577 = ((_e535.member[2].w - _e367) * _e369);
                        let _e578 = min(_e574, _e576);
                        let _e579 = min(_e575, _e577);
                        let _e580 = max(_e574, _e576);
                        let _e581 = max(_e575, _e577);
                        let _e606 = max(max(max(min(_e548, _e550), min(_e561, _e563)), _e578), _e472);
                        let _e607 = max(max(max(min(_e549, _e551), min(_e562, _e564)), _e579), _e472);
                        let _e610 = (_e606 <= min((min(min(max(_e548, _e550), max(_e561, _e563)), _e580) + (max(_e580, -(_e578)) * 0.0000019073523f)), _e487.member.member_1));
                        let _e611 = (_e607 <= min((min(min(max(_e549, _e551), max(_e562, _e564)), _e581) + (max(_e581, -(_e579)) * 0.0000019073523f)), _e487.member.member_1));
                        if (_e610 || _e611) {
                            let _e626 = (_e610 && ((_e606 <= _e607) || !(_e611)));
                            if _e626 {
                                phi_1128_ = _e535.member_1;
                            } else {
                                phi_1128_ = _e535.member_2;
                            }
                            let _e630 = phi_1128_;
                            if (_e610 && _e611) {
                                if _e626 {
                                    phi_1139_ = _e535.member_2;
                                } else {
                                    phi_1139_ = _e535.member_1;
                                }
                                let _e635 = phi_1139_;
                                let _e638 = (bitcast<u32>(_e498) % 128u);
                                local_1[_e638] = _e635;
                                local[_e638] = select(_e606, _e607, _e626);
                                phi_1162_ = (_e498 + 1i);
                            } else {
                                phi_1162_ = _e498;
                            }
                            let _e643 = phi_1162_;
                            phi_1190_ = _e630;
                            phi_1191_ = _e643;
                        } else {
                            let _e614 = (_e498 - 1i);
                            let _e616 = (bitcast<u32>(_e614) % 128u);
                            let _e618 = local[_e616];
                            if (_e618 <= _e487.member.member_1) {
                                let _e621 = local_1[_e616];
                                phi_1189_ = _e621;
                            } else {
                                phi_1189_ = 2147483648u;
                            }
                            let _e623 = phi_1189_;
                            phi_1190_ = _e623;
                            phi_1191_ = _e614;
                        }
                        let _e645 = phi_1190_;
                        let _e647 = phi_1191_;
                        let _e648 = (_e500 - 1u);
                        phi_1198_ = _e645;
                        phi_1199_ = select(_e647, -1i, (_e648 == 0u));
                        phi_1200_ = _e648;
                    }
                    let _e652 = phi_1198_;
                    let _e654 = phi_1199_;
                    let _e656 = phi_1200_;
                    phi_879_ = _e652;
                    phi_882_ = _e654;
                    phi_884_ = _e656;
                    phi_1202_ = select(true, false, _e503);
                } else {
                    phi_879_ = u32();
                    phi_882_ = i32();
                    phi_884_ = u32();
                    phi_1202_ = false;
                }
                let _e659 = phi_879_;
                let _e661 = phi_882_;
                let _e663 = phi_884_;
                let _e665 = phi_1202_;
                continue;
                continuing {
                    phi_878_ = _e659;
                    phi_881_ = _e661;
                    phi_883_ = _e663;
                    break if !(_e665);
                }
            }
            let _e668 = local_2;
            if _e668 {
                let _e670 = local_3;
                let _e673 = local_4;
                phi_1216_ = _e487;
                phi_1219_ = SlimbvhTypeA(0u, ((_e673 >> bitcast<u32>(28u)) & 7u));
                loop {
                    let _e679 = phi_1216_;
                    let _e681 = phi_1219_;
                    local_6 = _e679;
                    local_8 = _e679;
                    if (_e681.member < _e681.member_1) {
                        phi_1220_ = SlimbvhTypeA((_e681.member + 1u), _e681.member_1);
                        phi_1242_ = SlimbvhTypeA(1u, _e681.member);
                    } else {
                        phi_1220_ = _e681;
                        phi_1242_ = SlimbvhTypeA(0u, SlimbvhTypeA().member_1);
                    }
                    let _e694 = phi_1220_;
                    let _e696 = phi_1242_;
                    let _e700 = (bitcast<i32>(_e696.member) != 0i);
                    if _e700 {
                        let _e701 = ((_e670 & 268435455u) + _e696.member_1);
                        let _e702 = (_e701 / 2u);
                        if (_e702 < _e74) {
                            let _e704 = (_e701 % 2u);
                            if (_e702 >= _e74) {
                                phi_1327_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                            } else {
                                let _e706 = (2u * _e704);
                                let _e710 = slimbvh_triangles.member[_e702][_e706];
                                let _e715 = slimbvh_triangles.member[_e702][(_e706 + 1u)];
                                let _e720 = slimbvh_triangles.member[_e702][(_e706 + 2u)];
                                if (_e704 == 0u) {
                                    phi_1326_ = array<vec4<f32>, 3>(_e710, _e715, _e720);
                                } else {
                                    phi_1326_ = array<vec4<f32>, 3>(vec4<f32>(_e710.z, _e710.w, _e715.x, _e715.y), vec4<f32>(_e715.z, _e715.w, _e720.x, _e720.y), vec4<f32>(_e720.z, _e720.w, 0f, 0f));
                                }
                                let _e738 = phi_1326_;
                                phi_1327_ = _e738;
                            }
                            let _e740 = phi_1327_;
                            phi_1330_ = bitcast<u32>(_e740[2].y);
                        } else {
                            phi_1330_ = 4294967295u;
                        }
                        let _e745 = phi_1330_;
                        let _e746 = (_e701 % 2u);
                        if (_e702 >= _e74) {
                            phi_1403_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                        } else {
                            let _e748 = (2u * _e746);
                            let _e752 = slimbvh_triangles.member[_e702][_e748];
                            let _e757 = slimbvh_triangles.member[_e702][(_e748 + 1u)];
                            let _e762 = slimbvh_triangles.member[_e702][(_e748 + 2u)];
                            if (_e746 == 0u) {
                                phi_1402_ = array<vec4<f32>, 3>(_e752, _e757, _e762);
                            } else {
                                phi_1402_ = array<vec4<f32>, 3>(vec4<f32>(_e752.z, _e752.w, _e757.x, _e757.y), vec4<f32>(_e757.z, _e757.w, _e762.x, _e762.y), vec4<f32>(_e762.z, _e762.w, 0f, 0f));
                            }
                            let _e780 = phi_1402_;
                            phi_1403_ = _e780;
                        }
                        let _e782 = phi_1403_;
                        if _e202 {
                            phi_1427_ = array<f32, 3>(_e782[0].x, _e782[0].y, _e782[0].z);
                        } else {
                            if (_e167 == 1u) {
                                phi_1426_ = array<f32, 3>(_e782[0].y, _e782[0].z, _e782[0].x);
                            } else {
                                phi_1426_ = array<f32, 3>(_e782[0].z, _e782[0].x, _e782[0].y);
                            }
                            let _e805 = phi_1426_;
                            phi_1427_ = _e805;
                        }
                        let _e808 = phi_1427_;
                        if _e202 {
                            phi_1442_ = array<f32, 3>(_e782[0].w, _e782[1].x, _e782[1].y);
                        } else {
                            if (_e167 == 1u) {
                                phi_1441_ = array<f32, 3>(_e782[1].x, _e782[1].y, _e782[0].w);
                            } else {
                                phi_1441_ = array<f32, 3>(_e782[1].y, _e782[0].w, _e782[1].x);
                            }
                            let _e813 = phi_1441_;
                            phi_1442_ = _e813;
                        }
                        let _e816 = phi_1442_;
                        if _e202 {
                            phi_1457_ = array<f32, 3>(_e782[1].z, _e782[1].w, _e782[2].x);
                        } else {
                            if (_e167 == 1u) {
                                phi_1456_ = array<f32, 3>(_e782[1].w, _e782[2].x, _e782[1].z);
                            } else {
                                phi_1456_ = array<f32, 3>(_e782[2].x, _e782[1].z, _e782[1].w);
                            }
                            let _e821 = phi_1456_;
                            phi_1457_ = _e821;
                        }
                        let _e824 = phi_1457_;
                        let _e838 = (_e808[2] - _e334);
                        let _e841 = (((_e808[0] - _e222) * _e365) - (_e838 * _e253));
                        let _e844 = (((_e808[1] - _e278) * _e365) - (_e838 * _e309));
                        let _e847 = (_e816[2] - _e334);
                        let _e850 = (((_e816[0] - _e222) * _e365) - (_e847 * _e253));
                        let _e853 = (((_e816[1] - _e278) * _e365) - (_e847 * _e309));
                        let _e856 = (_e824[2] - _e334);
                        let _e859 = (((_e824[0] - _e222) * _e365) - (_e856 * _e253));
                        let _e862 = (((_e824[1] - _e278) * _e365) - (_e856 * _e309));
                        let _e863 = (_e859 * _e853);
                        let _e864 = (_e862 * _e850);
                        let _e865 = (_e841 * _e862);
                        let _e866 = (_e844 * _e859);
                        let _e867 = (_e850 * _e844);
                        let _e868 = (_e853 * _e841);
                        let _e873 = (((_e863 >= _e864) && (_e865 >= _e866)) && (_e867 >= _e868));
                        let _e879 = (_e873 || (((_e863 <= _e864) && (_e865 <= _e866)) && (_e867 <= _e868)));
                        if _e879 {
                            let _e881 = select(-1f, 1f, _e873);
                            let _e883 = ((_e863 - _e864) * _e881);
                            let _e885 = select(0f, _e883, (_e883 > 0f));
                            let _e887 = ((_e865 - _e866) * _e881);
                            let _e889 = select(0f, _e887, (_e887 > 0f));
                            let _e891 = ((_e867 - _e868) * _e881);
                            let _e893 = select(0f, _e891, (_e891 > 0f));
                            let _e895 = ((_e885 + _e889) + _e893);
                            let _e910 = ((min(min(_e808[0], _e816[0]), _e824[0]) - _e254) * _e257);
                            let _e911 = ((max(max(_e808[0], _e816[0]), _e824[0]) - _e255) * _e257);
                            let _e914 = ((min(min(_e808[1], _e816[1]), _e824[1]) - _e310) * _e313);
                            let _e915 = ((max(max(_e808[1], _e816[1]), _e824[1]) - _e311) * _e313);
                            let _e918 = ((min(min(_e808[2], _e816[2]), _e824[2]) - _e366) * _e369);
                            let _e919 = ((max(max(_e808[2], _e816[2]), _e824[2]) - _e367) * _e369);
                            let _e920 = min(_e918, _e919);
                            let _e921 = max(_e918, _e919);
                            let _e925 = max(max(min(_e910, _e911), min(_e914, _e915)), _e920);
                            let _e929 = min(min(max(_e910, _e911), max(_e914, _e915)), _e921);
                            let _e934 = max(_e925, _e472);
                            let _e956 = (((((_e879 && (_e895 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e841, _e850), _e859) <= 0f) && (max(max(_e841, _e850), _e859) >= 0f))) && ((min(min(_e844, _e853), _e862) <= 0f) && (max(max(_e844, _e853), _e862) >= 0f))) && (_e934 <= (_e929 + (max(_e921, -(_e920)) * 0.0000019073523f)))) && (_e934 <= _e679.member.member_1));
                            if _e956 {
                                let _e961 = (_e816[0] - _e808[0]);
                                let _e962 = (_e816[1] - _e808[1]);
                                let _e963 = (_e816[2] - _e808[2]);
                                let _e964 = vec3<f32>(_e961, _e962, _e963);
                                let _e965 = (_e824[0] - _e816[0]);
                                let _e966 = (_e824[1] - _e816[1]);
                                let _e967 = (_e824[2] - _e816[2]);
                                let _e968 = vec3<f32>(_e965, _e966, _e967);
                                let _e969 = (_e808[0] - _e824[0]);
                                let _e970 = (_e808[1] - _e824[1]);
                                let _e971 = (_e808[2] - _e824[2]);
                                let _e972 = vec3<f32>(_e969, _e970, _e971);
                                let _e983 = max(max(bitcast<f32>((bitcast<u32>(_e961) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e962) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e963) & 2147483647u)));
                                let _e994 = max(max(bitcast<f32>((bitcast<u32>(_e965) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e966) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e967) & 2147483647u)));
                                let _e1007 = max(max(_e983, _e994), max(max(bitcast<f32>((bitcast<u32>(_e969) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e970) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e971) & 2147483647u))));
                                if (_e983 == _e1007) {
                                    phi_1773_ = _e853;
                                    phi_1774_ = _e850;
                                    phi_1775_ = _e844;
                                    phi_1776_ = _e841;
                                    phi_1777_ = vec3<f32>(_e808[0], _e808[1], _e808[2]);
                                    phi_1778_ = _e972;
                                    phi_1779_ = _e968;
                                    phi_1780_ = _e964;
                                } else {
                                    let _e1009 = (_e994 == _e1007);
                                    let _e1014 = vec3(_e1009);
                                    phi_1773_ = select(_e844, _e862, _e1009);
                                    phi_1774_ = select(_e841, _e859, _e1009);
                                    phi_1775_ = select(_e862, _e853, _e1009);
                                    phi_1776_ = select(_e859, _e850, _e1009);
                                    phi_1777_ = select(vec3<f32>(_e824[0], _e824[1], _e824[2]), vec3<f32>(_e816[0], _e816[1], _e816[2]), _e1014);
                                    phi_1778_ = select(_e968, _e964, _e1014);
                                    phi_1779_ = select(_e964, _e972, _e1014);
                                    phi_1780_ = select(_e972, _e968, _e1014);
                                }
                                let _e1020 = phi_1773_;
                                let _e1022 = phi_1774_;
                                let _e1024 = phi_1775_;
                                let _e1026 = phi_1776_;
                                let _e1028 = phi_1777_;
                                let _e1030 = phi_1778_;
                                let _e1032 = phi_1779_;
                                let _e1034 = phi_1780_;
                                let _e1041 = ((_e1032.y * _e1030.z) - (_e1030.y * _e1032.z));
                                let _e1046 = ((_e1032.z * _e1030.x) - (_e1030.z * _e1032.x));
                                let _e1049 = ((_e1032.x * _e1030.y) - (_e1030.x * _e1032.y));
                                let _e1052 = ((_e885 >= _e889) && (_e885 >= _e893));
                                let _e1053 = (_e889 >= _e893);
                                let _e1067 = (((_e1041 * (select(select(_e824[0], _e816[0], _e1053), _e808[0], _e1052) - _e222)) + (_e1046 * (select(select(_e824[1], _e816[1], _e1053), _e808[1], _e1052) - _e278))) + (_e1049 * (select(select(_e824[2], _e816[2], _e1053), _e808[2], _e1052) - _e334)));
                                let _e1072 = (((_e1041 * _e253) + (_e1046 * _e309)) + (_e1049 * _e365));
                                let _e1073 = (_e1022 - _e1026);
                                let _e1074 = (_e1020 - _e1024);
                                let _e1077 = ((_e1073 * _e1073) + (_e1074 * _e1074));
                                let _e1084 = (-(((_e1026 * _e1073) + (_e1024 * _e1074))) / select(0.000000000000000000000000000000000000011754944f, _e1077, (_e1077 > 0.000000000000000000000000000000000000011754944f)));
                                let _e1086 = select(1f, _e1084, (_e1084 < 1f));
                                let _e1088 = select(0f, _e1086, (_e1086 > 0f));
                                let _e1097 = ((_e1028.x + (_e1034.x * _e1088)) - _e222);
                                let _e1100 = ((_e1028.y + (_e1034.y * _e1088)) - _e278);
                                let _e1103 = ((_e1028.z + (_e1034.z * _e1088)) - _e334);
                                let _e1168 = ((bitcast<f32>((bitcast<u32>(((((_e1041 * _e1097) + (_e1046 * _e1100)) + (_e1049 * _e1103)) - _e1067)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e1097) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1100) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1103) & 2147483647u))), _e1007)) * max(max(bitcast<f32>((bitcast<u32>(_e1041) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1046) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1049) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e1072) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e1032.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1032.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1032.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e1030.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1030.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1030.z) & 2147483647u)))))));
                                let _e1169 = (_e1067 / _e1072);
                                if (_e956 && !(_e1168)) {
                                    let _e1172 = (_e1103 / _e365);
                                    let _e1180 = (((_e1041 * (_e1097 - (_e253 * _e1172))) + (_e1046 * (_e1100 - (_e309 * _e1172)))) / _e1072);
                                    phi_1959_ = select(select(_e1172, (_e1172 + _e1180), (bitcast<f32>((bitcast<u32>(_e1180) & 2147483647u)) <= _e1007)), _e1169, _e1168);
                                } else {
                                    phi_1959_ = _e1169;
                                }
                                let _e1189 = phi_1959_;
                                let _e1191 = select(_e929, _e1189, (_e1189 < _e929));
                                let _e1193 = select(_e925, _e1191, (_e1191 > _e925));
                                let _e1196 = select(_e1193, 0f, (bitcast<u32>(_e1193) == 2147483648u));
                                let _e1197 = (1f / _e895);
                                phi_1985_ = SlimbvhTypeK(_e1196, (_e889 * _e1197), (_e893 * _e1197), ((_e956 && (_e1196 >= _e472)) && (_e1196 <= _e679.member.member_1)));
                                phi_1986_ = SlimbvhTypeK();
                            } else {
                                phi_1985_ = SlimbvhTypeK();
                                phi_1986_ = SlimbvhTypeK(0f, 0f, 0f, _e956);
                            }
                            let _e1206 = phi_1985_;
                            let _e1208 = phi_1986_;
                            phi_1989_ = _e1206;
                            phi_1990_ = _e1208;
                            phi_1991_ = select(true, false, _e956);
                        } else {
                            phi_1989_ = SlimbvhTypeK();
                            phi_1990_ = SlimbvhTypeK(0f, 0f, 0f, _e879);
                            phi_1991_ = true;
                        }
                        let _e1211 = phi_1989_;
                        let _e1213 = phi_1990_;
                        let _e1215 = phi_1991_;
                        if _e1215 {
                            phi_1995_ = _e1213;
                        } else {
                            phi_1995_ = _e1211;
                        }
                        let _e1217 = phi_1995_;
                        if _e1217.member_3 {
                            phi_2004_ = SlimbvhTypeC(_e1217.member, _e1217.member_1, _e1217.member_2, _e745);
                        } else {
                            phi_2004_ = SlimbvhTypeC(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1224 = phi_2004_;
                        if (_e1224.member_3 != 4294967295u) {
                            if (_e745 != 4294967295u) {
                                if (_e1224.member < _e679.member.member.member) {
                                    phi_2030_ = true;
                                } else {
                                    if (_e1224.member == _e679.member.member.member) {
                                        phi_2029_ = (_e1224.member_3 < _e679.member.member.member_3);
                                    } else {
                                        phi_2029_ = false;
                                    }
                                    let _e1239 = phi_2029_;
                                    phi_2030_ = _e1239;
                                }
                                let _e1241 = phi_2030_;
                                if _e1241 {
                                    phi_2037_ = SlimbvhTypeI(SlimbvhTypeH(_e1224, _e1224.member), _e679.member_1);
                                } else {
                                    phi_2037_ = _e679;
                                }
                                let _e1247 = phi_2037_;
                                if _e1247.member_1 {
                                    phi_2043_ = SlimbvhTypeI(SlimbvhTypeH(_e1247.member.member, -340282350000000000000000000000000000000f), _e1247.member_1);
                                } else {
                                    phi_2043_ = _e1247;
                                }
                                let _e1256 = phi_2043_;
                                phi_2044_ = _e1256;
                            } else {
                                phi_2044_ = _e679;
                            }
                            let _e1258 = phi_2044_;
                            phi_2045_ = _e1258;
                        } else {
                            phi_2045_ = _e679;
                        }
                        let _e1260 = phi_2045_;
                        phi_1217_ = _e1260;
                    } else {
                        phi_1217_ = SlimbvhTypeI();
                    }
                    let _e1262 = phi_1217_;
                    continue;
                    continuing {
                        phi_1216_ = _e1262;
                        phi_1219_ = _e694;
                        break if !(_e700);
                    }
                }
                let _e1265 = local_5;
                let _e1266 = (_e1265 - 1i);
                let _e1268 = (bitcast<u32>(_e1266) % 128u);
                let _e1270 = local[_e1268];
                let _e1272 = local_6;
                if (_e1270 <= _e1272.member.member_1) {
                    let _e1277 = local_1[_e1268];
                    phi_2072_ = _e1277;
                } else {
                    phi_2072_ = 2147483648u;
                }
                let _e1279 = phi_2072_;
                let _e1516 = local_8;
                phi_2079_ = _e1516;
                phi_2080_ = _e1279;
                phi_2081_ = select(_e1266, -1i, (_e472 > _e1272.member.member_1));
            } else {
                phi_2079_ = _e487;
                let _e1519 = local_9;
                phi_2080_ = _e1519;
                let _e1522 = local_10;
                phi_2081_ = _e1522;
            }
            let _e1283 = phi_2079_;
            let _e1285 = phi_2080_;
            let _e1287 = phi_2081_;
            phi_863_ = _e1283;
            phi_866_ = _e1285;
            phi_868_ = _e1287;
            let _e1528 = local_11;
            phi_870_ = _e1528;
        } else {
            phi_863_ = SlimbvhTypeI();
            phi_866_ = u32();
            phi_868_ = i32();
            phi_870_ = u32();
        }
        let _e1289 = phi_863_;
        let _e1291 = phi_866_;
        let _e1293 = phi_868_;
        let _e1295 = phi_870_;
        continue;
        continuing {
            phi_862_ = _e1289;
            phi_865_ = _e1291;
            phi_867_ = _e1293;
            phi_869_ = _e1295;
            break if !(_e494);
        }
    }
    let _e1298 = local_7;
    if (_e1298.member.member.member_3 != 4294967295u) {
        let _e1304 = -(_e374);
        let _e1305 = bitcast<u32>(_e1298.member.member.member);
        let _e1309 = (bitcast<i32>((_e1305 >> bitcast<u32>(23i))) & 255i);
        let _e1310 = (_e1309 + _e1304);
        if (_e1309 == 255i) {
            phi_2136_ = _e1298.member.member.member;
        } else {
            if (_e1309 > 0i) {
                if (_e1310 > 0i) {
                    let _e1314 = (_e1310 < 255i);
                    if _e1314 {
                        phi_2115_ = bitcast<f32>((_e1305 + bitcast<u32>((_e1304 << bitcast<u32>(23i)))));
                    } else {
                        phi_2115_ = f32();
                    }
                    let _e1321 = phi_2115_;
                    phi_2117_ = _e1321;
                    phi_2118_ = select(true, false, _e1314);
                } else {
                    phi_2117_ = f32();
                    phi_2118_ = true;
                }
                let _e1324 = phi_2117_;
                let _e1326 = phi_2118_;
                phi_2119_ = _e1324;
                phi_2120_ = _e1326;
            } else {
                phi_2119_ = f32();
                phi_2120_ = true;
            }
            let _e1328 = phi_2119_;
            let _e1330 = phi_2120_;
            if _e1330 {
                let _e1331 = (_e1305 & 2147483648u);
                let _e1338 = ((_e1305 & 8388607u) | (select(0u, 1u, ((_e1305 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e1342 = (_e1338 == 0u);
                if _e1342 {
                    phi_2423_ = bitcast<f32>(_e1331);
                } else {
                    let _e1347 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1338)), 32u, _e1342) - 8u);
                    let _e1350 = (_e1338 << bitcast<u32>((_e1347 & 31u)));
                    let _e1352 = ((_e1310 + select(0i, 1i, (_e1309 == 0i))) - bitcast<i32>(_e1347));
                    if (_e1352 >= 255i) {
                        phi_2413_ = bitcast<f32>((_e1331 | 2139095040u));
                        phi_2414_ = f32();
                        phi_2415_ = true;
                    } else {
                        let _e1354 = (_e1352 > 0i);
                        if _e1354 {
                            phi_2407_ = bitcast<f32>(((_e1331 | (bitcast<u32>(_e1352) << bitcast<u32>(23i))) | (_e1350 & 8388607u)));
                            phi_2408_ = f32();
                        } else {
                            if (_e1352 < -24i) {
                                phi_2373_ = 26u;
                            } else {
                                phi_2373_ = bitcast<u32>((1i - _e1352));
                            }
                            let _e1359 = phi_2373_;
                            let _e1360 = (_e1359 & 31u);
                            let _e1362 = (_e1350 >> bitcast<u32>(_e1360));
                            let _e1366 = (_e1350 & ((1u << bitcast<u32>(_e1360)) - 1u));
                            let _e1370 = (1u << bitcast<u32>(((_e1359 - 1u) & 31u)));
                            if (_e1366 > _e1370) {
                                phi_2394_ = true;
                            } else {
                                if (_e1366 == _e1370) {
                                    phi_2391_ = ((_e1362 & 1u) == 1u);
                                } else {
                                    phi_2391_ = false;
                                }
                                let _e1376 = phi_2391_;
                                phi_2394_ = _e1376;
                            }
                            let _e1378 = phi_2394_;
                            phi_2407_ = f32();
                            phi_2408_ = bitcast<f32>((_e1331 | (_e1362 + select(0u, 1u, _e1378))));
                        }
                        let _e1391 = phi_2407_;
                        let _e1393 = phi_2408_;
                        phi_2413_ = _e1391;
                        phi_2414_ = _e1393;
                        phi_2415_ = _e1354;
                    }
                    let _e1397 = phi_2413_;
                    let _e1399 = phi_2414_;
                    let _e1401 = phi_2415_;
                    phi_2423_ = select(_e1399, _e1397, _e1401);
                }
                let _e1405 = phi_2423_;
                phi_2135_ = _e1405;
            } else {
                phi_2135_ = _e1328;
            }
            let _e1407 = phi_2135_;
            phi_2136_ = _e1407;
        }
        let _e1409 = phi_2136_;
        let _e1410 = bitcast<u32>(_e1409);
        if ((_e1410 & 2147483647u) >= 2139095040u) {
            phi_2148_ = bitcast<f32>(((_e1410 & 2147483648u) | 2139095039u));
        } else {
            phi_2148_ = _e1409;
        }
        let _e1417 = phi_2148_;
        phi_2153_ = SlimbvhTypeC(_e1417, _e1298.member.member.member_1, _e1298.member.member.member_2, _e1298.member.member.member_3);
    } else {
        phi_2153_ = SlimbvhTypeC(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
    }
    let _e1422 = phi_2153_;
    slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e1422.member), bitcast<u32>(_e1422.member_1), bitcast<u32>(_e1422.member_2), _e1422.member_3);
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
