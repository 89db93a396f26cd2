//! The slab test by itself.

use glam::Vec3;
use proptest::array::uniform3;
use proptest::prelude::*;
use slimbvh_core::planes::PlanePair;
use slimbvh_core::ray::PreparedRay;
use slimbvh_core::slab::slab;
use slimbvh_core::{Aabb, Ray};
use slimbvh_tests::cases;

/// The planes of two boxes, in the order of the ray's axes.
fn planes(ray: &PreparedRay, a: &Aabb, b: &Aabb) -> [PlanePair; 3] {
    ray.axes.map(|axis| {
        let axis = axis as usize;
        PlanePair::new(a.min[axis], b.min[axis], a.max[axis], b.max[axis])
    })
}

/// Numbers where roundings and ties are likely: few bits, many magnitudes, zeros.
fn number() -> impl Strategy<Value = f32> {
    prop_oneof![
        2 => -1f32..1.0,
        2 => (-8i32..=8).prop_map(|x| x as f32 / 8.0),
        1 => (-1f32..1.0, -40i32..=0).prop_map(|(x, e)| x * 2f32.powi(e)),
        1 => Just(0.0f32),
        1 => Just(-0.0f32),
    ]
}

fn box_of(p: [f32; 3], q: [f32; 3]) -> Aabb {
    let (p, q) = (Vec3::from(p), Vec3::from(q));
    // Boxes of trees have no negative zeros.
    Aabb {
        min: p.min(q) + Vec3::ZERO,
        max: p.max(q) + Vec3::ZERO,
    }
}

fn any_ray() -> impl Strategy<Value = Ray> {
    let origin = prop_oneof![
        3 => uniform3(number()),
        1 => (uniform3(number()), 0i32..=40).prop_map(|(p, e)| p.map(|x| x * 2f32.powi(e))),
    ];
    let component = prop_oneof![
        4 => number(),
        1 => (number(), -80i32..=-20).prop_map(|(x, e)| x * 2f32.powi(e)),
    ];
    (origin, uniform3(component), -1f32..2.0).prop_map(|(origin, direction, t_min)| Ray {
        t_min: t_min.max(0.0),
        ..Ray::new(origin, direction)
    })
}

proptest! {
    #![proptest_config(cases(20_000))]

    #[test]
    fn slab_is_monotone(
        ray in any_ray(),
        corners in uniform3(uniform3(number())),
        more in uniform3(number()),
        limit in prop_oneof![Just(f32::MAX), 0f32..4.0],
    ) {
        let ray = PreparedRay::new(&ray, 0);
        let inner = box_of(corners[0], corners[1]);
        let outer = inner.union_point(Vec3::from(corners[2])).union_point(Vec3::from(more));
        prop_assert!(outer.contains(&inner));
        let both = slab(&ray, planes(&ray, &inner, &outer), limit);
        prop_assert!(both.enter_b <= both.enter_a, "{:?}", both);
        prop_assert!(both.meets_b || !both.meets_a, "{:?}", both);
        prop_assert!(both.enter_a >= ray.t_min && both.enter_b >= ray.t_min);
        prop_assert!(!both.meets_a || both.enter_a <= limit);
    }

    #[test]
    fn slab_treats_both_boxes_alike(ray in any_ray(), corners in [uniform3(number()), uniform3(number())], limit in 0f32..4.0) {
        let ray = PreparedRay::new(&ray, 0);
        let a = box_of(corners[0], corners[1]);
        let b = box_of(corners[1], [0.0; 3]);
        let ab = slab(&ray, planes(&ray, &a, &b), limit);
        let ba = slab(&ray, planes(&ray, &b, &a), limit);
        prop_assert_eq!(ab.enter_a.to_bits(), ba.enter_b.to_bits());
        prop_assert_eq!((ab.meets_a, ab.meets_b), (ba.meets_b, ba.meets_a));
    }

    #[test]
    fn a_box_is_met_where_the_exact_ray_meets_it(ray in any_ray(), corners in [uniform3(number()), uniform3(number())]) {
        let bounds = box_of(corners[0], corners[1]);
        let prepared = PreparedRay::new(&ray, 0);
        prop_assume!(prepared.t_min <= prepared.t_max);

        // The exact ray is the prepared one; in f64 only a band of 2^-40 is in doubt.
        let mut enter = f64::from(prepared.t_min);
        let mut exit = f64::MAX;
        for (place, axis) in prepared.axes.into_iter().enumerate() {
            let (low, high) = (bounds.min[axis as usize], bounds.max[axis as usize]);
            let (origin, d) = (f64::from(prepared.origin[place]), f64::from(prepared.direction[place]));
            if d == 0.0 {
                if origin < f64::from(low) || origin > f64::from(high) {
                    exit = -1.0;
                }
            } else {
                let (a, b) = ((f64::from(low) - origin) / d, (f64::from(high) - origin) / d);
                enter = enter.max(a.min(b));
                exit = exit.min(a.max(b));
            }
        }
        let hit = slab(&prepared, planes(&prepared, &bounds, &bounds), f32::MAX);
        if enter <= exit {
            prop_assert!(hit.meets_a && hit.meets_b, "{} {} {:?} {:?}", enter, exit, hit, prepared);
            let error = (f64::from(hit.enter_a) - enter).abs();
            prop_assert!(error <= enter * 4.0 * 2f64.powi(-24), "{} {:?}", enter, hit);
        }
    }
}
