//! Any hit goes to the farther of two children first: the answer is the same, the way shorter.

use glam::Vec3;
use slimbvh::generate::terrain;
use slimbvh::{Bvh, CodeBits};
use slimbvh_core::RayEnds;
use slimbvh_core::ray::PreparedRay;
use slimbvh_core::trace::{AnyHit, Collector, Counted};
use slimbvh_core::{Hit, Ray};
use slimbvh_tests::build;

/// Any hit, the nearer child first.
struct NearerFirst(AnyHit);

impl Collector for NearerFirst {
    fn limit(&self) -> f32 {
        self.0.limit()
    }

    fn offer(&mut self, hit: Hit) {
        self.0.offer(hit);
    }
}

/// How many of the rays hit, and how many nodes and triangles that takes.
fn counted<C: Collector>(
    bvh: &Bvh,
    rays: &[Ray],
    new: impl Fn(f32) -> C,
    found: impl Fn(&C) -> bool,
) -> [u32; 3] {
    let mut sum = [0; 3];
    for ray in rays {
        let ray = PreparedRay::new(ray, bvh.scene_exponent());
        let mut collector = Counted::new(new(ray.t_max));
        bvh.collect(&ray, &RayEnds::NONE, &mut collector);
        sum[0] += u32::from(found(&collector.inner));
        sum[1] += collector.node_count;
        sum[2] += collector.triangle_count;
    }
    sum
}

#[test]
fn any_hits_are_found_sooner_behind_the_farther_child() {
    let mesh = terrain(8.0, 64, 3);
    let bvh = build(&mesh, CodeBits::Bits30);
    let sun = Vec3::new(1.0, 0.15, 0.2).normalize();
    // Shadow rays, from the middles of what faces the sun.
    let shadow_ray = |index: &[u32; 3]| {
        let [a, b, c] = index.map(|i| Vec3::from_array(mesh.vertices[i as usize]));
        let normal = (b - a).cross(c - a).normalize();
        let normal = normal * normal.y.signum();
        let above = (a + b + c) / 3.0 + normal * 1e-3;
        (normal.dot(sun) > 0.0).then(|| Ray::new(above.to_array(), sun.to_array()))
    };
    let rays: Vec<Ray> = mesh.indices.iter().filter_map(shadow_ray).collect();
    let farther = counted(&bvh, &rays, AnyHit::new, |any| any.found);
    let nearer = counted(
        &bvh,
        &rays,
        |t_max| NearerFirst(AnyHit::new(t_max)),
        |any| any.0.found,
    );
    assert_eq!(farther[0], nearer[0]);
    assert!(farther[0] > 100 && farther[0] < rays.len() as u32);
    assert!(
        farther[1] < nearer[1] && farther[2] < nearer[2],
        "{farther:?}, nearer first {nearer:?}"
    );
}
