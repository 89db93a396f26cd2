// What both walks share: rays, hits, the triangle test, one thread a ray. `LANES`, `GROUPS_PER_ROW`
// and `STACK_ROWS` are put before this text.

// As slimbvh's: 32 bytes.
struct Ray {
    origin: vec3<f32>,
    t_min: f32,
    direction: vec3<f32>,
    t_max: f32,
}

// As slimbvh's: P = (1-u-v)·v0 + u·v1 + v·v2. 16 bytes.
struct Hit {
    t: f32,
    u: f32,
    v: f32,
    primitive: u32,
}

const MISS = 0xffffffffu;

// Three rows a triangle in leaf order: each maps a point to w, u or v (see woop.rs).
@group(0) @binding(1) var<storage, read> triangles: array<vec4<f32>>;
// The caller's number of each triangle in leaf order.
@group(0) @binding(2) var<storage, read> numbers: array<u32>;
@group(0) @binding(3) var<storage, read> rays: array<Ray>;
@group(0) @binding(4) var<storage, read_write> hits: array<Hit>;
@group(0) @binding(5) var<storage, read_write> is_hit: array<u32>;

// 1/d, where components near 0 count as ±2^-80, so that planes times it stay finite (Aila and Laine 2009, their kernels).
fn reciprocal(direction: vec3<f32>) -> vec3<f32> {
    let least = vec3(exp2(-80.0));
    let signed = select(least, -least, direction < vec3(0.0));
    return 1.0 / select(direction, signed, abs(direction) < least);
}

fn at_point(row: vec4<f32>, point: vec3<f32>) -> f32 {
    return fma(row.x, point.x, fma(row.y, point.y, fma(row.z, point.z, row.w)));
}

fn along(row: vec4<f32>, direction: vec3<f32>) -> f32 {
    return fma(row.x, direction.x, fma(row.y, direction.y, row.z * direction.z));
}

// Woop's test: the triangle's rows take the ray to the space where the triangle is the unit one. Later rows are read only if
// the test has not failed yet.
fn meet(place: u32, ray: Ray, hit: Hit) -> Hit {
    let w = triangles[3u * place];
    let t = -at_point(w, ray.origin) / along(w, ray.direction);
    if !(t >= ray.t_min && t < hit.t) {
        return hit;
    }
    let u_row = triangles[3u * place + 1u];
    let u = fma(t, along(u_row, ray.direction), at_point(u_row, ray.origin));
    if !(u >= 0.0) {
        return hit;
    }
    let v_row = triangles[3u * place + 2u];
    let v = fma(t, along(v_row, ray.direction), at_point(v_row, ray.origin));
    if !(v >= 0.0 && u + v <= 1.0) {
        return hit;
    }
    return Hit(t, u, v, place);
}

@compute @workgroup_size(LANES)
fn closest(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let index = (group.y * GROUPS_PER_ROW + group.x) * LANES + lane;
    if index >= arrayLength(&rays) {
        return;
    }
    var hit = walk(rays[index], lane, false);
    if hit.primitive != MISS {
        hit.primitive = numbers[hit.primitive];
    }
    hits[index] = hit;
}

@compute @workgroup_size(LANES)
fn any(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let index = (group.y * GROUPS_PER_ROW + group.x) * LANES + lane;
    if index >= arrayLength(&rays) {
        return;
    }
    is_hit[index] = u32(walk(rays[index], lane, true).primitive != MISS);
}
