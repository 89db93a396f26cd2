// The walk over compressed nodes of eight children (Ylitie, Karras and Laine 2017, "Efficient Incoherent Ray Traversal on GPUs
// Through Compressed Wide BVHs", algorithms 1 and 2): children that are hit wait as the bits of one word, in the order of the
// ray's octant; triangles as the bits of another. The stack of node groups is in workgroup memory. Triangles are not postponed:
// that needs votes of a subgroup.

// Five rows a node, as obvhs stores it: origin with exponents and the mask of inner children; first child, first triangle,
// a byte for each child; lower and upper planes of x, of y, of z.
@group(0) @binding(0) var<storage, read> nodes: array<vec4<u32>>;

// A group of nodes has a child in its high byte; below are the mask of inner children, or the triangles' bits.
const NODES = 0x00ffffffu;

var<workgroup> stack: array<vec2<u32>, LANES * STACK_ROWS>;

// A ray in the cells of a node's boxes: t of plane q is q·scale + offset.
struct InCells {
    scale: vec3<f32>,
    offset: vec3<f32>,
    t_min: f32,
    t_max: f32,
}

fn floats(bytes: u32) -> vec4<f32> {
    return vec4<f32>(unpack4xU8(bytes));
}

// The bits of those of four children that the ray meets.
fn open_four(ray: InCells, meta_bytes: u32, octant: u32, near: vec3<u32>, far: vec3<u32>) -> u32 {
    // Inner children have bits 3 and 4 of their byte set. The octant moves their bit to their turn.
    let is_inner = meta_bytes & (meta_bytes << 1u) & 0x10101010u;
    let inner_bytes = (is_inner >> 4u) * 0xffu;
    let shifts = unpack4xU8((meta_bytes ^ (octant & inner_bytes)) & 0x1f1f1f1fu);
    let bits = unpack4xU8((meta_bytes >> 5u) & 0x07070707u);

    let x0 = fma(floats(near.x), vec4(ray.scale.x), vec4(ray.offset.x));
    let y0 = fma(floats(near.y), vec4(ray.scale.y), vec4(ray.offset.y));
    let z0 = fma(floats(near.z), vec4(ray.scale.z), vec4(ray.offset.z));
    let x1 = fma(floats(far.x), vec4(ray.scale.x), vec4(ray.offset.x));
    let y1 = fma(floats(far.y), vec4(ray.scale.y), vec4(ray.offset.y));
    let z1 = fma(floats(far.z), vec4(ray.scale.z), vec4(ray.offset.z));
    let enter = max(max(x0, y0), max(z0, vec4(ray.t_min)));
    let leave = min(min(x1, y1), min(z1, vec4(ray.t_max)));
    let met = select(vec4(0u), bits << shifts, enter <= leave);
    return met.x | met.y | met.z | met.w;
}

fn walk(ray: Ray, lane: u32, any: bool) -> Hit {
    let inverse = reciprocal(ray.direction);
    let is_negative = ray.direction < vec3(0.0);
    let turns = select(vec3(4u, 2u, 1u), vec3(0u), is_negative);
    let octant = turns.x | turns.y | turns.z;
    let octant4 = octant * 0x01010101u;
    var hit = Hit(ray.t_max, 0.0, 0.0, MISS);
    var top = lane;
    // The root, as the only child.
    var group = vec2(0u, 0x80000000u);
    loop {
        // The next child in the ray's order; the others wait.
        let children = group.y;
        let turn = firstLeadingBit(children);
        group.y &= ~(1u << turn);
        if group.y > NODES {
            stack[top] = group;
            top += LANES;
        }
        let slot = (turn - 24u) ^ octant;
        let row = 5u * (group.x + countOneBits(children & ~(0xffffffffu << slot)));
        let frame = nodes[row];
        let links = nodes[row + 1u];
        let x = nodes[row + 2u];
        let y = nodes[row + 3u];
        let z = nodes[row + 4u];

        let exponents = vec3(frame.w << 23u, (frame.w >> 8u) << 23u, (frame.w >> 16u) << 23u) & vec3(0x7f800000u);
        let scale = bitcast<vec3<f32>>(exponents) * inverse;
        let offset = (bitcast<vec3<f32>>(frame.xyz) - ray.origin) * inverse;
        let cells = InCells(scale, offset, ray.t_min, hit.t);
        let near_x = select(x.xy, x.zw, is_negative.x);
        let far_x = select(x.zw, x.xy, is_negative.x);
        let near_y = select(y.xy, y.zw, is_negative.y);
        let far_y = select(y.zw, y.xy, is_negative.y);
        let near_z = select(z.xy, z.zw, is_negative.z);
        let far_z = select(z.zw, z.xy, is_negative.z);
        let met = open_four(cells, links.z, octant4, vec3(near_x.x, near_y.x, near_z.x), vec3(far_x.x, far_y.x, far_z.x))
            | open_four(cells, links.w, octant4, vec3(near_x.y, near_y.y, near_z.y), vec3(far_x.y, far_y.y, far_z.y));

        group = vec2(links.x, (met & ~NODES) | (frame.w >> 24u));
        var waiting = met & NODES;
        while waiting != 0u {
            let i = firstTrailingBit(waiting);
            waiting &= waiting - 1u;
            hit = meet(links.y + i, ray, hit);
            if any && hit.primitive != MISS {
                return hit;
            }
        }
        if group.y <= NODES {
            if top == lane {
                break;
            }
            top -= LANES;
            group = stack[top];
        }
    }
    return hit;
}
