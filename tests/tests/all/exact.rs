//! Hits are right, not only consistent: they equal exact answers on a grid, and agree with `f64` elsewhere.

use proptest::array::uniform3;
use proptest::prelude::*;
use slimbvh::CodeBits;
use slimbvh::generate::soup;
use slimbvh_core::Ray;
use slimbvh_tests::oracle::double::meet;
use slimbvh_tests::oracle::exact::{ExactHit, GridRay, GridTriangle, intersect};
use slimbvh_tests::random::Random;
use slimbvh_tests::strategies::{grid_triangles, mesh_of};
use slimbvh_tests::{build, cases};

/// Half an ulp of 1.
const UNIT: f64 = 1.0 / 16_777_216.0;

fn grid_ray() -> impl Strategy<Value = GridRay> {
    let largest = prop_oneof![Just(1i32), Just(2), Just(4)];
    let direction = (largest, uniform3(-4i32..=4), 0usize..3, any::<bool>()).prop_map(
        |(largest, direction, axis, negative)| {
            let mut direction = direction.map(|x| x.clamp(-largest, largest));
            direction[axis] = if negative { -largest } else { largest };
            direction
        },
    );
    (uniform3(-7i32..=7), direction).prop_map(|(origin, direction)| GridRay { origin, direction })
}

/// The exact hit with the smallest t.
fn nearest(ray: &GridRay, triangles: &[GridTriangle]) -> Option<ExactHit> {
    let hits = triangles
        .iter()
        .filter_map(|triangle| intersect(ray, triangle));
    hits.min_by(|a, b| a.t.compare(&b.t))
}

proptest! {
    #![proptest_config(cases(1500))]

    #[test]
    fn exact_on_the_integer_grid(triangles in grid_triangles(7, 60), rays in proptest::collection::vec(grid_ray(), 40)) {
        let corners: Vec<_> = triangles.iter().map(|t| t.map(|p| p.map(|x| x as f32))).collect();
        let bvh = build(&mesh_of(&corners), CodeBits::Bits30);
        for grid_ray in rays {
            let ray = grid_ray.ray();
            let hit = bvh.closest_hit(ray);
            let Some(expected) = nearest(&grid_ray, &triangles) else {
                prop_assert!(!hit.is_hit(), "{:?} {:?}", grid_ray, hit);
                continue;
            };
            prop_assert!(hit.is_hit() && bvh.any_hit(ray), "{:?} {:?}", grid_ray, expected);

            // The exact ray hits this triangle, at a t that is the smallest up to rounding; the reported t is off by at most 4
            // roundings.
            let own = intersect(&grid_ray, &triangles[hit.primitive as usize]);
            let Some(own) = own else {
                return Err(TestCaseError::fail(format!("{grid_ray:?} misses {hit:?}")));
            };
            let close = |computed: f32, exact: f64| (f64::from(computed) - exact).abs() <= 4.0 * UNIT * exact.abs();
            prop_assert!(close(hit.t, own.t.value()), "{:?} {:?}", hit, own);
            prop_assert!(close(hit.t, expected.t.value()), "{:?} {:?}", hit, expected);
            prop_assert!(close(hit.u, own.u.value()) && close(hit.v, own.v.value()), "{:?} {:?}", hit, own);
        }
    }

    #[test]
    fn all_exact_hits_are_counted(triangles in grid_triangles(7, 24), ray in grid_ray()) {
        let corners: Vec<_> = triangles.iter().map(|t| t.map(|p| p.map(|x| x as f32))).collect();
        let bvh = build(&mesh_of(&corners), CodeBits::Bits63);
        let hits = bvh.nearest_hits::<24>(&ray.ray());
        let mut found: Vec<u32> = hits.iter().filter(|hit| hit.is_hit()).map(|hit| hit.primitive).collect();
        found.sort_unstable();
        let expected: Vec<u32> = (0..triangles.len() as u32)
            .filter(|&i| intersect(&ray, &triangles[i as usize]).is_some())
            .collect();
        prop_assert_eq!(found, expected);
    }
}

/// The largest error of t over random rays at random points of triangles: in units of the products' rounding error
/// ([`slimbvh_tests::oracle::double::PlaneHit::sensitivity`]), and in ulps of t for faces that are not seen edge-on.
#[test]
fn t_is_accurate() {
    let mesh = soup(400, 9);
    let bvh = build(&mesh, CodeBits::Bits30);
    let mut random = Random::new(4);
    let (mut worst, mut worst_plain, mut count) = (0f64, 0f64, 0);
    for _ in 0..100_000 {
        let leaf = &bvh.leaf_triangles()[random.below(400)];
        let [a, b, c] = mesh.indices[leaf.primitive as usize]
            .map(|v| glam::Vec3::from(mesh.vertices[v as usize]));
        let (u, v) = (random.unit(), random.unit());
        let (u, v) = if u + v > 1.0 {
            (1.0 - u, 1.0 - v)
        } else {
            (u, v)
        };
        let target = a + u * (b - a) + v * (c - a);
        let origin = random.point() * 3.0;
        let ray = Ray::new(origin.to_array(), (target - origin).to_array());
        for hit in bvh
            .nearest_hits::<8>(&ray)
            .iter()
            .filter(|hit| hit.is_hit())
        {
            let leaf = bvh
                .leaf_triangles()
                .iter()
                .find(|leaf| leaf.primitive == hit.primitive);
            let exact = leaf.and_then(|leaf| meet(&ray, leaf, bvh.scene_exponent()));
            let Some(exact) = exact else { continue };
            let error = (f64::from(hit.t) - exact.t).abs() / UNIT;
            worst = worst.max(error / exact.sensitivity);
            // Products hardly cancel here.
            if exact.sensitivity < 20.0 * exact.t {
                worst_plain = worst_plain.max(error / exact.t);
            }
            count += 1;
        }
    }
    eprintln!(
        "t_is_accurate: {count} hits, worst {worst:.2} of the condition, {worst_plain:.2} units of t where well seen"
    );
    assert!(count > 50_000);
    assert!(worst < 8.0, "{worst}");
    assert!(worst_plain < 20.0, "{worst_plain}");
}
