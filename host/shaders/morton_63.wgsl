struct type_9 {
    member: array<array<f32, 3>>,
}

struct type_13 {
    member: array<array<u32, 3>>,
}

struct type_19 {
    member: i32,
    member_1: i32,
    member_2: u32,
}

struct type_21 {
    member: array<type_19, 3>,
    member_1: u32,
}

struct type_23 {
    member: array<type_21>,
}

var<private> global: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_1: type_9;
@group(0) @binding(2) 
var<storage> global_2: type_13;
@group(0) @binding(0) 
var<storage> global_3: type_23;
@group(0) @binding(3) 
var<storage, read_write> global_4: type_13;

fn function_() {
    var phi_122_: array<u32, 3>;
    var phi_137_: array<f32, 3>;
    var phi_155_: array<f32, 3>;
    var phi_173_: array<f32, 3>;

    switch bitcast<i32>(0u) {
        default: {
            let _e37 = global;
            let _e39 = arrayLength((&global_3.member));
            let _e42 = arrayLength((&global_1.member));
            let _e51 = (_e37.x + (_e37.y * 2097152u));
            let _e52 = (_e51 < arrayLength((&global_4.member)));
            if _e52 {
                if (_e39 == 0u) {
                } else {
                    let _e54 = (_e51 < arrayLength((&global_2.member)));
                    if _e54 {
                        if _e54 {
                        } else {
                            break;
                        }
                        let _e56 = global_2.member[_e51];
                        phi_122_ = _e56;
                    } else {
                        phi_122_ = array<u32, 3>(0u, 0u, 0u);
                    }
                    let _e58 = phi_122_;
                    let _e60 = (_e58[0] < _e42);
                    if _e60 {
                        if _e60 {
                        } else {
                            break;
                        }
                        let _e62 = global_1.member[_e58[0]];
                        phi_137_ = _e62;
                    } else {
                        phi_137_ = array<f32, 3>(0f, 0f, 0f);
                    }
                    let _e64 = phi_137_;
                    let _e69 = (_e58[1] < _e42);
                    if _e69 {
                        if _e69 {
                        } else {
                            break;
                        }
                        let _e71 = global_1.member[_e58[1]];
                        phi_155_ = _e71;
                    } else {
                        phi_155_ = array<f32, 3>(0f, 0f, 0f);
                    }
                    let _e73 = phi_155_;
                    let _e78 = (_e58[2] < _e42);
                    if _e78 {
                        if _e78 {
                        } else {
                            break;
                        }
                        let _e80 = global_1.member[_e58[2]];
                        phi_173_ = _e80;
                    } else {
                        phi_173_ = array<f32, 3>(0f, 0f, 0f);
                    }
                    let _e82 = phi_173_;
                    let _e87 = select(_e73[0], _e64[0], (_e64[0] < _e73[0]));
                    let _e89 = select(_e73[1], _e64[1], (_e64[1] < _e73[1]));
                    let _e91 = select(_e73[2], _e64[2], (_e64[2] < _e73[2]));
                    let _e99 = select(_e73[0], _e64[0], (_e64[0] > _e73[0]));
                    let _e101 = select(_e73[1], _e64[1], (_e64[1] > _e73[1]));
                    let _e103 = select(_e73[2], _e64[2], (_e64[2] > _e73[2]));
                    if (0u < _e39) {
                    } else {
                        break;
                    }
                    let _e115 = global_3.member[0u].member[0u];
                    let _e121 = bitcast<f32>((bitcast<u32>((127i - _e115.member)) << bitcast<u32>(23i)));
                    let _e122 = (select(_e82[0], _e87, (_e87 < _e82[0])) * _e121);
                    let _e130 = (select(_e82[0], _e99, (_e99 > _e82[0])) * _e121);
                    let _e146 = (bitcast<u32>(((select(0i, select(select(i32(_e122), i32(-2147483648), (_e122 < -2147483600f)), 2147483647i, (_e122 > 2147483500f)), (_e122 == _e122)) + select(0i, select(select(i32(_e130), i32(-2147483648), (_e130 < -2147483600f)), 2147483647i, (_e130 > 2147483500f)), (_e130 == _e130))) - _e115.member_1)) << bitcast<u32>(((_e115.member_2 & 31u) & 31u)));
                    let _e150 = global_3.member[0u].member_1;
                    let _e152 = (_e146 >> bitcast<u32>(16i));
                    let _e153 = (_e146 & 65535u);
                    let _e155 = (_e150 >> bitcast<u32>(16i));
                    let _e156 = (_e150 & 65535u);
                    let _e161 = ((_e152 * _e156) + ((_e153 * _e156) >> bitcast<u32>(16i)));
                    let _e177 = ((((_e152 * _e155) + (_e161 >> bitcast<u32>(16i))) + (((_e153 * _e155) + (_e161 & 65535u)) >> bitcast<u32>(16i))) >> bitcast<u32>((((_e115.member_2 >> bitcast<u32>(16i)) & 31u) & 31u)));
                    let _e182 = global_3.member[0u].member[1u];
                    let _e188 = bitcast<f32>((bitcast<u32>((127i - _e182.member)) << bitcast<u32>(23i)));
                    let _e189 = (select(_e82[1], _e89, (_e89 < _e82[1])) * _e188);
                    let _e197 = (select(_e82[1], _e101, (_e101 > _e82[1])) * _e188);
                    let _e213 = (bitcast<u32>(((select(0i, select(select(i32(_e189), i32(-2147483648), (_e189 < -2147483600f)), 2147483647i, (_e189 > 2147483500f)), (_e189 == _e189)) + select(0i, select(select(i32(_e197), i32(-2147483648), (_e197 < -2147483600f)), 2147483647i, (_e197 > 2147483500f)), (_e197 == _e197))) - _e182.member_1)) << bitcast<u32>(((_e182.member_2 & 31u) & 31u)));
                    let _e215 = (_e213 >> bitcast<u32>(16i));
                    let _e216 = (_e213 & 65535u);
                    let _e221 = ((_e215 * _e156) + ((_e216 * _e156) >> bitcast<u32>(16i)));
                    let _e237 = ((((_e215 * _e155) + (_e221 >> bitcast<u32>(16i))) + (((_e216 * _e155) + (_e221 & 65535u)) >> bitcast<u32>(16i))) >> bitcast<u32>((((_e182.member_2 >> bitcast<u32>(16i)) & 31u) & 31u)));
                    let _e242 = global_3.member[0u].member[2u];
                    let _e248 = bitcast<f32>((bitcast<u32>((127i - _e242.member)) << bitcast<u32>(23i)));
                    let _e249 = (select(_e82[2], _e91, (_e91 < _e82[2])) * _e248);
                    let _e257 = (select(_e82[2], _e103, (_e103 > _e82[2])) * _e248);
                    let _e273 = (bitcast<u32>(((select(0i, select(select(i32(_e249), i32(-2147483648), (_e249 < -2147483600f)), 2147483647i, (_e249 > 2147483500f)), (_e249 == _e249)) + select(0i, select(select(i32(_e257), i32(-2147483648), (_e257 < -2147483600f)), 2147483647i, (_e257 > 2147483500f)), (_e257 == _e257))) - _e242.member_1)) << bitcast<u32>(((_e242.member_2 & 31u) & 31u)));
                    let _e275 = (_e273 >> bitcast<u32>(16i));
                    let _e276 = (_e273 & 65535u);
                    let _e281 = ((_e275 * _e156) + ((_e276 * _e156) >> bitcast<u32>(16i)));
                    let _e297 = ((((_e275 * _e155) + (_e281 >> bitcast<u32>(16i))) + (((_e276 * _e155) + (_e281 & 65535u)) >> bitcast<u32>(16i))) >> bitcast<u32>((((_e242.member_2 >> bitcast<u32>(16i)) & 31u) & 31u)));
                    let _e304 = ((_e177 >> bitcast<u32>(11i)) & 1023u);
                    let _e308 = ((_e304 | (_e304 << bitcast<u32>(16i))) & 50331903u);
                    let _e312 = ((_e308 | (_e308 << bitcast<u32>(8i))) & 50393103u);
                    let _e316 = ((_e312 | (_e312 << bitcast<u32>(4i))) & 51130563u);
                    let _e323 = ((_e237 >> bitcast<u32>(11i)) & 1023u);
                    let _e327 = ((_e323 | (_e323 << bitcast<u32>(16i))) & 50331903u);
                    let _e331 = ((_e327 | (_e327 << bitcast<u32>(8i))) & 50393103u);
                    let _e335 = ((_e331 | (_e331 << bitcast<u32>(4i))) & 51130563u);
                    let _e343 = ((_e297 >> bitcast<u32>(11i)) & 1023u);
                    let _e347 = ((_e343 | (_e343 << bitcast<u32>(16i))) & 50331903u);
                    let _e351 = ((_e347 | (_e347 << bitcast<u32>(8i))) & 50393103u);
                    let _e355 = ((_e351 | (_e351 << bitcast<u32>(4i))) & 51130563u);
                    let _e361 = (_e177 & 1023u);
                    let _e365 = ((_e361 | (_e361 << bitcast<u32>(16i))) & 50331903u);
                    let _e369 = ((_e365 | (_e365 << bitcast<u32>(8i))) & 50393103u);
                    let _e373 = ((_e369 | (_e369 << bitcast<u32>(4i))) & 51130563u);
                    let _e380 = (_e237 & 1023u);
                    let _e384 = ((_e380 | (_e380 << bitcast<u32>(16i))) & 50331903u);
                    let _e388 = ((_e384 | (_e384 << bitcast<u32>(8i))) & 50393103u);
                    let _e392 = ((_e388 | (_e388 << bitcast<u32>(4i))) & 51130563u);
                    let _e400 = (_e297 & 1023u);
                    let _e404 = ((_e400 | (_e400 << bitcast<u32>(16i))) & 50331903u);
                    let _e408 = ((_e404 | (_e404 << bitcast<u32>(8i))) & 50393103u);
                    let _e412 = ((_e408 | (_e408 << bitcast<u32>(4i))) & 51130563u);
                    if _e52 {
                    } else {
                        break;
                    }
                    global_4.member[_e51][0u] = (((((((_e316 | (_e316 << bitcast<u32>(2i))) & 153391689u) << bitcast<u32>(2i)) | (((_e335 | (_e335 << bitcast<u32>(2i))) & 153391689u) << bitcast<u32>(1i))) | ((_e355 | (_e355 << bitcast<u32>(2i))) & 153391689u)) << bitcast<u32>(1i)) | ((_e177 >> bitcast<u32>(10i)) & 1u));
                    global_4.member[_e51][1u] = (((((_e237 >> bitcast<u32>(10i)) & 1u) << bitcast<u32>(31i)) | (((_e297 >> bitcast<u32>(10i)) & 1u) << bitcast<u32>(30i))) | (((((_e373 | (_e373 << bitcast<u32>(2i))) & 153391689u) << bitcast<u32>(2i)) | (((_e392 | (_e392 << bitcast<u32>(2i))) & 153391689u) << bitcast<u32>(1i))) | ((_e412 | (_e412 << bitcast<u32>(2i))) & 153391689u)));
                    global_4.member[_e51][2u] = _e51;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn morton_63_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
