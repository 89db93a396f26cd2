// While-while over a binary tree: one loop opens nodes until a leaf is found, the next tests its triangles (Aila and Laine 2009,
// "Understanding the Efficiency of Ray Traversal on GPUs", section 3). The stack is a column of workgroup memory.

// Four rows a node (see aila_laine.rs): x and y of the first child's box, of the second's, z of both, two references.
@group(0) @binding(0) var<storage, read> nodes: array<vec4<f32>>;

// References from here on are leaves: 28 bits of the first triangle's place, 3 bits of their number less 1.
const LEAF = 0x80000000u;
// Under the stack. No leaf has this reference.
const END = 0xffffffffu;

var<workgroup> stack: array<u32, LANES * STACK_ROWS>;

fn walk(ray: Ray, lane: u32, any: bool) -> Hit {
    let inverse = reciprocal(ray.direction);
    let offset = -ray.origin * inverse;
    var hit = Hit(ray.t_max, 0.0, 0.0, MISS);
    var top = lane;
    stack[top] = END;
    var reference = 0u;
    loop {
        while reference < LEAF {
            let first = nodes[reference];
            let second = nodes[reference + 1u];
            let depth = nodes[reference + 2u];
            let children = bitcast<vec2<u32>>(nodes[reference + 3u].xy);
            // Where the ray crosses each pair of planes.
            let x0 = fma(first.xy, inverse.xx, offset.xx);
            let y0 = fma(first.zw, inverse.yy, offset.yy);
            let z0 = fma(depth.xy, inverse.zz, offset.zz);
            let x1 = fma(second.xy, inverse.xx, offset.xx);
            let y1 = fma(second.zw, inverse.yy, offset.yy);
            let z1 = fma(depth.zw, inverse.zz, offset.zz);
            let enter0 = max(max(min(x0.x, x0.y), min(y0.x, y0.y)), max(min(z0.x, z0.y), ray.t_min));
            let leave0 = min(min(max(x0.x, x0.y), max(y0.x, y0.y)), min(max(z0.x, z0.y), hit.t));
            let enter1 = max(max(min(x1.x, x1.y), min(y1.x, y1.y)), max(min(z1.x, z1.y), ray.t_min));
            let leave1 = min(min(max(x1.x, x1.y), max(y1.x, y1.y)), min(max(z1.x, z1.y), hit.t));
            let meets0 = enter0 <= leave0;
            let meets1 = enter1 <= leave1;
            if meets0 || meets1 {
                // The nearer child next, the other one on the stack.
                let second_next = !meets0 || (meets1 && enter1 < enter0);
                reference = select(children.x, children.y, second_next);
                if meets0 && meets1 {
                    top += LANES;
                    stack[top] = select(children.y, children.x, second_next);
                }
            } else {
                reference = stack[top];
                top -= LANES;
            }
        }
        if reference == END {
            break;
        }
        var place = (reference & 0x7fffffffu) >> 3u;
        let end = place + (reference & 7u) + 1u;
        while place < end {
            hit = meet(place, ray, hit);
            place += 1u;
        }
        if any && hit.primitive != MISS {
            break;
        }
        reference = stack[top];
        top -= LANES;
    }
    return hit;
}
