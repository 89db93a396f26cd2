struct type_5 {
    member: array<array<u32, 4>>,
}

struct type_9 {
    member: array<array<u32, 2>>,
}

@group(0) @binding(0) 
var<storage> global: type_9;
@group(0) @binding(1) 
var<storage, read_write> global_1: type_5;

fn function_() {
    var phi_55_: array<u32, 2>;

    switch bitcast<i32>(0u) {
        default: {
            let _e11 = arrayLength((&global.member));
            let _e13 = arrayLength((&global_1.member));
            if (_e13 == 0u) {
            } else {
                let _e17 = (_e11 - (1u + (_e11 / 1000u)));
                let _e18 = (_e17 < _e11);
                if _e18 {
                    if _e18 {
                    } else {
                        break;
                    }
                    let _e21 = global.member[_e17];
                    phi_55_ = _e21;
                } else {
                    phi_55_ = array<u32, 2>(0u, 0u);
                }
                let _e23 = phi_55_;
                if (0u < _e13) {
                } else {
                    break;
                }
                global_1.member[0u][0u] = _e23[0];
                global_1.member[0u][1u] = 0u;
                global_1.member[0u][2u] = 0u;
                global_1.member[0u][3u] = 0u;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(1, 1, 1) 
fn view_heat_range() {
    function_();
}
