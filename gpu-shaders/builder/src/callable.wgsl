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
