//! Tessellated planes: no ray passes through.

use super::{aims, escapes};
use glam::{Quat, Vec3};
use slimbvh::CodeBits;
use slimbvh::generate::{ground, transformed};
use slimbvh_core::Ray;
use slimbvh_tests::build;
use slimbvh_tests::random::Random;

/// Embree's test: a distant plane, with rays at its inner vertices, at its edges, and at points between them.
#[test]
fn watertight_planes() {
    let mut random = Random::new(8);
    for (turn, translation) in [
        (0.0, Vec3::ZERO),
        (0.0, Vec3::new(148_376.0, 1234.0, -223_423.0)),
        (0.6, Vec3::ZERO),
        (0.6, Vec3::new(148_376.0, 1234.0, -223_423.0)),
    ] {
        let rotation = Quat::from_axis_angle(Vec3::new(0.6, 0.0, 0.8), turn);
        let cells = 32;
        let mesh = transformed(ground(64.0, cells), 1.0, rotation, translation);
        let bvh = build(&mesh, CodeBits::Bits30);
        let place = |p: Vec3| rotation * p + translation;
        let mut rays: Vec<Ray> = Vec::new();
        for _ in 0..40 {
            let eye = place(Vec3::new(
                random.between(-30.0, 30.0),
                random.between(5.0, 50.0),
                random.between(-30.0, 30.0),
            ));
            for &vertex in &mesh.vertices {
                let target = Vec3::from(vertex);
                let flat = rotation.inverse() * (target - translation);
                if flat.x.abs() < 31.0 && flat.z.abs() < 31.0 {
                    rays.push(aims::at(eye, target));
                }
            }
            for _ in 0..3000 {
                // Points on the lines between cells, and on the cells' diagonals.
                let (x, z) = (random.between(-31.0, 31.0), random.between(-31.0, 31.0));
                let line = (x / 2.0).round() * 2.0;
                for flat in [[x, z], [line, z], [z, line], [x, x], [x, -x]] {
                    rays.push(aims::at(eye, place(Vec3::new(flat[0], 0.0, flat[1]))));
                }
            }
        }
        let escaped = escapes(&bvh, &rays);
        assert!(
            escaped.is_empty(),
            "{} of {}: {:?}",
            escaped.len(),
            rays.len(),
            escaped[0]
        );
    }
}
