struct type_9 {
    member: array<array<f32, 3>>,
}

struct type_13 {
    member: array<array<u32, 3>>,
}

struct type_21 {
    member: array<array<u32, 2>>,
}

struct type_23 {
    member: i32,
    member_1: i32,
    member_2: u32,
}

struct type_25 {
    member: array<type_23, 3>,
    member_1: u32,
}

struct type_27 {
    member: array<type_25>,
}

var<private> global: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_1: type_9;
@group(0) @binding(2) 
var<storage> global_2: type_13;
@group(0) @binding(0) 
var<storage> global_3: type_27;
@group(0) @binding(3) 
var<storage, read_write> global_4: type_21;

fn function_() {
    var phi_124_: array<u32, 3>;
    var phi_139_: array<f32, 3>;
    var phi_157_: array<f32, 3>;
    var phi_175_: array<f32, 3>;

    switch bitcast<i32>(0u) {
        default: {
            let _e33 = global;
            let _e35 = arrayLength((&global_3.member));
            let _e38 = arrayLength((&global_1.member));
            let _e47 = (_e33.x + (_e33.y * 2097152u));
            let _e48 = (_e47 < arrayLength((&global_4.member)));
            if _e48 {
                if (_e35 == 0u) {
                } else {
                    let _e50 = (_e47 < arrayLength((&global_2.member)));
                    if _e50 {
                        if _e50 {
                        } else {
                            break;
                        }
                        let _e52 = global_2.member[_e47];
                        phi_124_ = _e52;
                    } else {
                        phi_124_ = array<u32, 3>(0u, 0u, 0u);
                    }
                    let _e54 = phi_124_;
                    let _e56 = (_e54[0] < _e38);
                    if _e56 {
                        if _e56 {
                        } else {
                            break;
                        }
                        let _e58 = global_1.member[_e54[0]];
                        phi_139_ = _e58;
                    } else {
                        phi_139_ = array<f32, 3>(0f, 0f, 0f);
                    }
                    let _e60 = phi_139_;
                    let _e65 = (_e54[1] < _e38);
                    if _e65 {
                        if _e65 {
                        } else {
                            break;
                        }
                        let _e67 = global_1.member[_e54[1]];
                        phi_157_ = _e67;
                    } else {
                        phi_157_ = array<f32, 3>(0f, 0f, 0f);
                    }
                    let _e69 = phi_157_;
                    let _e74 = (_e54[2] < _e38);
                    if _e74 {
                        if _e74 {
                        } else {
                            break;
                        }
                        let _e76 = global_1.member[_e54[2]];
                        phi_175_ = _e76;
                    } else {
                        phi_175_ = array<f32, 3>(0f, 0f, 0f);
                    }
                    let _e78 = phi_175_;
                    let _e83 = select(_e69[0], _e60[0], (_e60[0] < _e69[0]));
                    let _e85 = select(_e69[1], _e60[1], (_e60[1] < _e69[1]));
                    let _e87 = select(_e69[2], _e60[2], (_e60[2] < _e69[2]));
                    let _e95 = select(_e69[0], _e60[0], (_e60[0] > _e69[0]));
                    let _e97 = select(_e69[1], _e60[1], (_e60[1] > _e69[1]));
                    let _e99 = select(_e69[2], _e60[2], (_e60[2] > _e69[2]));
                    if (0u < _e35) {
                    } else {
                        break;
                    }
                    let _e111 = global_3.member[0u].member[0u];
                    let _e117 = bitcast<f32>((bitcast<u32>((127i - _e111.member)) << bitcast<u32>(23i)));
                    let _e118 = (select(_e78[0], _e83, (_e83 < _e78[0])) * _e117);
                    let _e126 = (select(_e78[0], _e95, (_e95 > _e78[0])) * _e117);
                    let _e142 = (bitcast<u32>(((select(0i, select(select(i32(_e118), i32(-2147483648), (_e118 < -2147483600f)), 2147483647i, (_e118 > 2147483500f)), (_e118 == _e118)) + select(0i, select(select(i32(_e126), i32(-2147483648), (_e126 < -2147483600f)), 2147483647i, (_e126 > 2147483500f)), (_e126 == _e126))) - _e111.member_1)) << bitcast<u32>(((_e111.member_2 & 31u) & 31u)));
                    let _e146 = global_3.member[0u].member_1;
                    let _e148 = (_e142 >> bitcast<u32>(16i));
                    let _e149 = (_e142 & 65535u);
                    let _e151 = (_e146 >> bitcast<u32>(16i));
                    let _e152 = (_e146 & 65535u);
                    let _e157 = ((_e148 * _e152) + ((_e149 * _e152) >> bitcast<u32>(16i)));
                    let _e178 = global_3.member[0u].member[1u];
                    let _e184 = bitcast<f32>((bitcast<u32>((127i - _e178.member)) << bitcast<u32>(23i)));
                    let _e185 = (select(_e78[1], _e85, (_e85 < _e78[1])) * _e184);
                    let _e193 = (select(_e78[1], _e97, (_e97 > _e78[1])) * _e184);
                    let _e209 = (bitcast<u32>(((select(0i, select(select(i32(_e185), i32(-2147483648), (_e185 < -2147483600f)), 2147483647i, (_e185 > 2147483500f)), (_e185 == _e185)) + select(0i, select(select(i32(_e193), i32(-2147483648), (_e193 < -2147483600f)), 2147483647i, (_e193 > 2147483500f)), (_e193 == _e193))) - _e178.member_1)) << bitcast<u32>(((_e178.member_2 & 31u) & 31u)));
                    let _e211 = (_e209 >> bitcast<u32>(16i));
                    let _e212 = (_e209 & 65535u);
                    let _e217 = ((_e211 * _e152) + ((_e212 * _e152) >> bitcast<u32>(16i)));
                    let _e238 = global_3.member[0u].member[2u];
                    let _e244 = bitcast<f32>((bitcast<u32>((127i - _e238.member)) << bitcast<u32>(23i)));
                    let _e245 = (select(_e78[2], _e87, (_e87 < _e78[2])) * _e244);
                    let _e253 = (select(_e78[2], _e99, (_e99 > _e78[2])) * _e244);
                    let _e269 = (bitcast<u32>(((select(0i, select(select(i32(_e245), i32(-2147483648), (_e245 < -2147483600f)), 2147483647i, (_e245 > 2147483500f)), (_e245 == _e245)) + select(0i, select(select(i32(_e253), i32(-2147483648), (_e253 < -2147483600f)), 2147483647i, (_e253 > 2147483500f)), (_e253 == _e253))) - _e238.member_1)) << bitcast<u32>(((_e238.member_2 & 31u) & 31u)));
                    let _e271 = (_e269 >> bitcast<u32>(16i));
                    let _e272 = (_e269 & 65535u);
                    let _e277 = ((_e271 * _e152) + ((_e272 * _e152) >> bitcast<u32>(16i)));
                    let _e294 = (((((_e148 * _e151) + (_e157 >> bitcast<u32>(16i))) + (((_e149 * _e151) + (_e157 & 65535u)) >> bitcast<u32>(16i))) >> bitcast<u32>((((_e111.member_2 >> bitcast<u32>(16i)) & 31u) & 31u))) & 1023u);
                    let _e298 = ((_e294 | (_e294 << bitcast<u32>(16i))) & 50331903u);
                    let _e302 = ((_e298 | (_e298 << bitcast<u32>(8i))) & 50393103u);
                    let _e306 = ((_e302 | (_e302 << bitcast<u32>(4i))) & 51130563u);
                    let _e313 = (((((_e211 * _e151) + (_e217 >> bitcast<u32>(16i))) + (((_e212 * _e151) + (_e217 & 65535u)) >> bitcast<u32>(16i))) >> bitcast<u32>((((_e178.member_2 >> bitcast<u32>(16i)) & 31u) & 31u))) & 1023u);
                    let _e317 = ((_e313 | (_e313 << bitcast<u32>(16i))) & 50331903u);
                    let _e321 = ((_e317 | (_e317 << bitcast<u32>(8i))) & 50393103u);
                    let _e325 = ((_e321 | (_e321 << bitcast<u32>(4i))) & 51130563u);
                    let _e333 = (((((_e271 * _e151) + (_e277 >> bitcast<u32>(16i))) + (((_e272 * _e151) + (_e277 & 65535u)) >> bitcast<u32>(16i))) >> bitcast<u32>((((_e238.member_2 >> bitcast<u32>(16i)) & 31u) & 31u))) & 1023u);
                    let _e337 = ((_e333 | (_e333 << bitcast<u32>(16i))) & 50331903u);
                    let _e341 = ((_e337 | (_e337 << bitcast<u32>(8i))) & 50393103u);
                    let _e345 = ((_e341 | (_e341 << bitcast<u32>(4i))) & 51130563u);
                    if _e48 {
                    } else {
                        break;
                    }
                    global_4.member[_e47][0u] = (((((_e306 | (_e306 << bitcast<u32>(2i))) & 153391689u) << bitcast<u32>(2i)) | (((_e325 | (_e325 << bitcast<u32>(2i))) & 153391689u) << bitcast<u32>(1i))) | ((_e345 | (_e345 << bitcast<u32>(2i))) & 153391689u));
                    global_4.member[_e47][1u] = _e47;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn morton_30_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
