struct type_4 {
    member: array<u32>,
}

struct type_10 {
    member: vec4<u32>,
}

struct type_16 {
    member: array<array<f32, 4>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_10;
@group(0) @binding(1) 
var<storage> global_2: type_16;
@group(0) @binding(2) 
var<storage, read_write> global_3: type_4;

fn function_() {
    var phi_133_: f32;
    var phi_150_: f32;
    var phi_167_: f32;
    var phi_193_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e24 = global;
            let _e32 = (_e24.x + (_e24.y * 2097152u));
            let _e33 = (_e32 < arrayLength((&global_2.member)));
            if _e33 {
                let _e34 = (_e32 < arrayLength((&global_3.member)));
                if _e34 {
                    if _e33 {
                    } else {
                        break;
                    }
                    let _e38 = global_2.member[_e32][0u];
                    let _e42 = global_2.member[_e32][1u];
                    let _e46 = global_2.member[_e32][2u];
                    let _e48 = select(0f, _e38, (_e38 > 0f));
                    let _e50 = select(1f, _e48, (_e48 < 1f));
                    let _e52 = select(0f, _e42, (_e42 > 0f));
                    let _e54 = select(1f, _e52, (_e52 < 1f));
                    let _e56 = select(0f, _e46, (_e46 > 0f));
                    let _e58 = select(1f, _e56, (_e56 < 1f));
                    if (_e50 <= 0.0031308f) {
                        phi_133_ = (12.92f * _e50);
                    } else {
                        phi_133_ = ((1.055f * pow(_e50, 0.41666666f)) - 0.055f);
                    }
                    let _e67 = phi_133_;
                    let _e69 = ((_e67 * 255f) + 0.5f);
                    let _e74 = select(select(u32(_e69), 0u, (_e69 < 0f)), 4294967295u, (_e69 > 4294967000f));
                    if (_e54 <= 0.0031308f) {
                        phi_150_ = (12.92f * _e54);
                    } else {
                        phi_150_ = ((1.055f * pow(_e54, 0.41666666f)) - 0.055f);
                    }
                    let _e80 = phi_150_;
                    let _e82 = ((_e80 * 255f) + 0.5f);
                    let _e87 = select(select(u32(_e82), 0u, (_e82 < 0f)), 4294967295u, (_e82 > 4294967000f));
                    if (_e58 <= 0.0031308f) {
                        phi_167_ = (12.92f * _e58);
                    } else {
                        phi_167_ = ((1.055f * pow(_e58, 0.41666666f)) - 0.055f);
                    }
                    let _e93 = phi_167_;
                    let _e95 = ((_e93 * 255f) + 0.5f);
                    let _e100 = select(select(u32(_e95), 0u, (_e95 < 0f)), 4294967295u, (_e95 > 4294967000f));
                    let _e103 = global_1.member[0u];
                    if (_e103 == 0u) {
                        phi_193_ = (((_e74 | (_e87 << bitcast<u32>(8i))) | (_e100 << bitcast<u32>(16i))) | 4278190080u);
                    } else {
                        phi_193_ = (((_e100 | (_e87 << bitcast<u32>(8i))) | (_e74 << bitcast<u32>(16i))) | 4278190080u);
                    }
                    let _e120 = phi_193_;
                    if _e34 {
                    } else {
                        break;
                    }
                    global_3.member[_e32] = _e120;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn camera_encode(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
