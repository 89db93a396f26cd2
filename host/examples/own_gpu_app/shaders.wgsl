// Group 0 belongs to slimbvh: each pass binds the tree that its rays are for. Group 1 is the application's.

struct Vertex { position: vec3<f32>, rest: vec3<f32> }
@group(1) @binding(0) var<storage, read_write> vertices: array<Vertex>;
@group(1) @binding(1) var<storage, read_write> indices: array<u32>;
@group(1) @binding(2) var<storage, read_write> hits: array<SlimbvhHit>;
@group(1) @binding(3) var<storage, read_write> shades: array<f32>;
const EYE = vec3<f32>(0.0, 1.2, 4.0);
const LAMP = vec3<f32>(3.0, 4.0, 2.0);

@compute @workgroup_size(64)
fn move_vertices(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x < arrayLength(&vertices) {
        let p = vertices[id.x].position;
        vertices[id.x].position = vec3<f32>(0.96 * p.x - 0.28 * p.z, p.y, 0.28 * p.x + 0.96 * p.z);
    }
}

fn seen(pixel: u32) -> vec3<f32> {
    return vec3<f32>(f32(pixel % 78u) / 39.0 - 1.0, 0.1 - f32(pixel / 78u) / 22.0, -2.0);
}

@compute @workgroup_size(64)
fn look(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    hits[id.x] = slimbvh_closest_hit_in_group(lane, EYE, 0.0, seen(id.x), 1e9);
}

@compute @workgroup_size(64)
fn shade(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let hit = hits[id.x];
    shades[id.x] = -1.0;
    if hit.primitive == 0xffffffffu {
        return;
    }
    let corner = 3u * hit.primitive;
    let v0 = vertices[indices[corner]].position;
    let v1 = vertices[indices[corner + 1u]].position;
    let v2 = vertices[indices[corner + 2u]].position;
    let point = slimbvh_surface(v0, v1, v2, hit, seen(id.x));
    let to_lamp = LAMP - point.leave;
    let is_lit = dot(point.normal, to_lamp) > 0.0 && !slimbvh_any_hit_from_in_group(lane, point.leave, 0.0, to_lamp, 1.0, hit.primitive);
    shades[id.x] = select(0.0, dot(point.normal, normalize(to_lamp)), is_lit);
}
