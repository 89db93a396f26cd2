//! Invalid rays, and rays of extreme magnitude.

use proptest::array::uniform3;
use proptest::prelude::*;
use slimbvh::generate::icosphere;
use slimbvh::{Bvh, CodeBits, Mesh};
use slimbvh_core::float::scale_by_power_of_two;
use slimbvh_core::{Hit, Ray};
use slimbvh_tests::oracle::brute::Parts;
use slimbvh_tests::rays::some_rays;
use slimbvh_tests::strategies::{grid, huge_and_tiny, random_soup, solid};
use slimbvh_tests::{build, cases};

fn sphere() -> Bvh {
    build(&icosphere(glam::Vec3::ZERO, 1.0, 3), CodeBits::Bits30)
}

fn assert_misses(bvh: &Bvh, ray: &Ray) {
    assert_eq!(bvh.closest_hit(ray), Hit::MISS, "{ray:?}");
    assert!(!bvh.any_hit(ray), "{ray:?}");
    assert_eq!(bvh.nearest_hits::<4>(ray), [Hit::MISS; 4], "{ray:?}");
}

#[test]
fn rays_that_are_not_rays_miss() {
    let bvh = sphere();
    let good = Ray::new([0.1, 0.2, 0.3], [0.4, 0.5, 0.6]);
    assert!(bvh.any_hit(good));
    for bad in [f32::NAN, -f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        for axis in 0..3 {
            let mut ray = good;
            ray.origin[axis] = bad;
            assert_misses(&bvh, &ray);
            let mut ray = good;
            ray.direction[axis] = bad;
            assert_misses(&bvh, &ray);
        }
        assert_misses(&bvh, &Ray { t_min: bad, ..good });
    }
    for t_max in [f32::NEG_INFINITY, -1.0, -0.5] {
        assert_misses(&bvh, &Ray { t_max, ..good });
    }
    for zero in [0.0, -0.0] {
        assert_misses(&bvh, &Ray::new([0.0; 3], [zero; 3]));
    }
    assert_misses(&bvh, &Ray::EMPTY);
    assert!(bvh.any_hit(Ray {
        t_max: f32::INFINITY,
        ..good
    }));
}

/// "A ray with a NaN in it hits nothing": also with a NaN in `t_max`, which does not count as infinite.
#[test]
fn a_ray_whose_t_max_is_nan_misses() {
    let t_max = f32::NAN;
    let good = Ray::new([0.1, 0.2, 0.3], [0.4, 0.5, 0.6]);
    assert_misses(&sphere(), &Ray { t_max, ..good });
}

proptest! {
    #![proptest_config(cases(4000))]

    #[test]
    fn any_bits_at_all_terminate_and_agree(bits in any::<[u32; 8]>(), mesh in grid(3, 40)) {
        let bvh = build(&mesh, CodeBits::Bits30);
        let ray: Ray = bytemuck::cast(bits);
        let result = Parts::from(&bvh).compare([&ray]);
        prop_assert!(result.is_ok(), "{:?}", result);
        let hit = bvh.closest_hit(ray);
        prop_assert!(!hit.t.is_nan() && !hit.u.is_nan() && !hit.v.is_nan());
    }

    #[test]
    fn tiny_and_huge_directions_hit_the_same(p in uniform3(-0.5f32..0.5), d in uniform3(-1f32..1.0), e in -120i32..=120) {
        let long = d.map(|x| scale_by_power_of_two(x, e));
        prop_assume!(long.iter().zip(d).all(|(&l, d)| scale_by_power_of_two(l, -e) == d));
        prop_assume!(d.iter().any(|x| x.abs() > 0.01));
        let bvh = sphere();
        let hit = bvh.closest_hit(Ray::new(p, d));
        let scaled = bvh.closest_hit(Ray::new(p, long));
        prop_assert!(hit.is_hit());
        prop_assert_eq!((hit.primitive, hit.u, hit.v), (scaled.primitive, scaled.u, scaled.v));
        prop_assert_eq!(scaled.t, scale_by_power_of_two(hit.t, -e));
    }
}

fn scaled(mesh: &Mesh, e: i32) -> Mesh {
    let mut mesh = mesh.clone();
    for x in mesh.vertices.as_flattened_mut() {
        *x = scale_by_power_of_two(*x, e);
    }
    mesh
}

fn is_exact(xs: &[f32], e: i32) -> bool {
    xs.iter().all(|&x| {
        let there = scale_by_power_of_two(x, e);
        scale_by_power_of_two(there, -e) == x
    })
}

fn ordinary_mesh() -> impl Strategy<Value = Mesh> {
    prop_oneof![random_soup(100), grid(4, 60), huge_and_tiny(60), solid()]
}

proptest! {
    #![proptest_config(cases(400))]

    #[test]
    fn scaling_by_a_power_of_two_changes_no_bit(mesh in ordinary_mesh(), recipes in some_rays(24), e in -60i32..=60) {
        prop_assume!(is_exact(mesh.vertices.as_flattened(), e));
        let (bvh, other) = (build(&mesh, CodeBits::Bits63), build(&scaled(&mesh, e), CodeBits::Bits63));
        prop_assert_eq!(bytemuck::cast_slice::<_, u8>(bvh.nodes()), bytemuck::cast_slice::<_, u8>(other.nodes()));
        prop_assert_eq!(bvh.leaf_triangles(), other.leaf_triangles());
        for recipe in recipes {
            let ray = recipe.cook(&mesh);
            if !is_exact(&ray.origin, e) || !is_exact(&ray.direction, e) {
                continue;
            }
            let origin = ray.origin.map(|x| scale_by_power_of_two(x, e));
            let direction = ray.direction.map(|x| scale_by_power_of_two(x, e));
            let (a, b) = (bvh.closest_hit(ray), other.closest_hit(Ray { origin, direction, ..ray }));
            prop_assert_eq!(bytemuck::bytes_of(&a), bytemuck::bytes_of(&b), "{:?} {:?}", ray, recipe);
        }
    }
}
