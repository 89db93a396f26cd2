//! The traversal as WGSL text, for the caller's shaders.

/// Functions that trace rays, to be put before the caller's shader, for any shader stage:
///
/// ```wgsl
/// fn slimbvh_closest_hit(origin: vec3<f32>, t_min: f32, direction: vec3<f32>, t_max: f32) -> SlimbvhHit
/// fn slimbvh_any_hit(origin: vec3<f32>, t_min: f32, direction: vec3<f32>, t_max: f32) -> bool
/// struct SlimbvhHit { t: f32, u: f32, v: f32, primitive: u32 }
/// ```
///
/// A miss has the primitive `0xffffffff`. The functions read the hierarchy from bindings 0 to 2 of this group;
/// [`super::Bvh::bindings`] returns them. All names begin with `slimbvh` or `Slimbvh`.
#[must_use]
pub fn wgsl(group: u32) -> String {
    include_str!("../../shaders/slimbvh.wgsl").replace("@group(0)", &format!("@group({group})"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_bindings_move_to_the_group() {
        let text = wgsl(3);
        assert_eq!(text.matches("@group(3)").count(), 3);
        assert_eq!(text.matches("@group(").count(), 3);
    }
}
