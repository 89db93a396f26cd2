//! All tracers trace the same rays: a direction's length and a ray's range mean the same to each as to slimbvh.

use anyhow::Result;
use glam::Vec3;
use slimbvh::generate::icosphere;
use slimbvh_bench::tracers::tracers;
use slimbvh_bench::{Answer, Input};
use slimbvh_core::Ray;

/// Rays along z, of length 2.5, off the middle of a unit sphere, which they meet at z = ∓1: from here, in this range.
fn ray(z: f32, t_min: f32, t_max: f32) -> Ray {
    Ray {
        origin: [0.031, 0.02, z],
        t_min,
        direction: [0.0, 0.0, 2.5],
        t_max,
    }
}

#[test]
fn lengths_beginnings_and_ends_mean_the_same_to_all() -> Result<()> {
    let mesh = icosphere(Vec3::ZERO, 1.0, 4);
    let input = Input::new(&mesh);
    let rays = [
        (ray(-3.0, 0.0, f32::MAX), Some(0.8)),
        (ray(-3.0, 0.0, f32::INFINITY), Some(0.8)),
        (ray(-3.0, 1.0, f32::MAX), Some(1.6)),
        (ray(-3.0, 0.0, 0.7), None),
        (ray(-3.0, 1.7, f32::MAX), None),
        (ray(-3.0, 1.0, 1.5), None),
        (ray(0.0, 0.0, f32::MAX), Some(0.4)),
        (ray(0.0, -1.0, f32::MAX), Some(-0.4)),
        (ray(3.0, -2.0, -1.0), Some(-1.6)),
        (ray(3.0, -1.0, 0.0), Some(-0.8)),
        (ray(3.0, -0.5, f32::MAX), None),
    ];
    let list = rays.map(|(ray, _)| ray);
    for mut tracer in tracers(&input) {
        tracer.build()?;
        let mut closest = [Answer::MISS; 11];
        let mut any = [false; 11];
        tracer.closest_hits(&list, &mut closest);
        tracer.any_hits(&list, &mut any);
        let name = tracer.name();
        for (i, (answer, any)) in closest.iter().zip(any).enumerate() {
            let expected = rays[i].1;
            assert_eq!(answer.is_hit(), expected.is_some(), "{name}, ray {i}");
            assert_eq!(any, expected.is_some(), "{name}, ray {i}");
            if let Some(t) = expected {
                assert!(
                    (answer.t - t).abs() < 0.002,
                    "{name}, ray {i}: {}",
                    answer.t
                );
            }
        }
    }
    Ok(())
}

/// Numbers of triangles are the caller's, also after a second build into kept buffers.
#[test]
fn all_name_the_same_triangles() -> Result<()> {
    let mesh = icosphere(Vec3::ZERO, 1.0, 4);
    let input = Input::new(&mesh);
    let middle = |face: &[u32; 3]| {
        let corners = face.map(|i| Vec3::from_array(mesh.vertices[i as usize]));
        corners.into_iter().sum::<Vec3>() / 3.0
    };
    // Off all planes of axes, where not all tracers are watertight.
    let aside = Vec3::new(0.051, 0.032, 0.017);
    let inward = |face| {
        let start = 3.0 * middle(face) + aside;
        Ray::new(start.to_array(), (middle(face) - start).to_array())
    };
    let rays: Vec<Ray> = mesh.indices.iter().map(inward).collect();
    for mut tracer in tracers(&input) {
        tracer.build()?;
        tracer.build()?;
        let mut closest = vec![Answer::MISS; rays.len()];
        tracer.closest_hits(&rays, &mut closest);
        for (i, answer) in closest.iter().enumerate() {
            assert_eq!(answer.primitive as usize, i, "{}", tracer.name());
        }
    }
    Ok(())
}
