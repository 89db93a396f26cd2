struct type_2 {
    member: array<u32>,
}

struct type_8 {
    member: array<array<u32, 4>>,
}

struct type_11 {
    member: vec4<u32>,
}

struct type_17 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_19 {
    member: array<type_17>,
}

@group(0) @binding(0) 
var<uniform> global: type_11;
@group(0) @binding(2) 
var<storage, read_write> global_1: type_2;
@group(0) @binding(1) 
var<storage, read_write> global_2: type_19;
@group(0) @binding(3) 
var<storage, read_write> global_3: type_8;

fn function_() {
    var phi_100_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e18 = arrayLength((&global_2.member));
            let _e20 = arrayLength((&global_1.member));
            let _e22 = arrayLength((&global_3.member));
            if (_e18 == 0u) {
            } else {
                if (_e20 == 0u) {
                } else {
                    if (_e22 == 0u) {
                    } else {
                        let _e28 = global.member[0u];
                        let _e31 = (2147483648u | (_e28 << bitcast<u32>(28u)));
                        if (0u < _e18) {
                        } else {
                            break;
                        }
                        global_2.member[0u] = type_17(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), _e31, 2147483648u, 0u, (_e28 - select(0u, 1u, (_e28 > 0u))));
                        if ((_e31 & 2147483648u) != 0u) {
                            phi_100_ = (((_e31 & 268435455u) + ((_e31 >> bitcast<u32>(28u)) & 7u)) - 1u);
                        } else {
                            phi_100_ = 0u;
                        }
                        let _e48 = phi_100_;
                        if (0u < _e20) {
                        } else {
                            break;
                        }
                        global_1.member[0u] = _e48;
                        if (0u < _e22) {
                        } else {
                            break;
                        }
                        global_3.member[0u][0u] = 1u;
                        global_3.member[0u][1u] = 1u;
                        global_3.member[0u][2u] = 1u;
                        global_3.member[0u][3u] = 1u;
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(1, 1, 1) 
fn topology_single() {
    function_();
}
