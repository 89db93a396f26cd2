//! Solids of all shapes, at all places.

use super::{Aims, aims, escapes};
use crate::meshes::{Solid, solids};
use glam::Vec3;
use slimbvh::CodeBits;
use slimbvh::analysis::analyze;
use slimbvh_tests::build;
use slimbvh_tests::closed::points_inside;
use slimbvh_tests::scenes::real_meshes;

fn assert_watertight(solid: &Solid, aims: Aims) {
    assert!(!solid.inside.is_empty(), "{}: no point inside", solid.name);
    let bvh = build(&solid.mesh, CodeBits::Bits30);
    let rays = aims::rays(solid, aims);
    let escaped = escapes(&bvh, &rays);
    assert!(
        escaped.is_empty(),
        "{}: {} of {} rays escape, the first {:?}",
        solid.name,
        escaped.len(),
        rays.len(),
        escaped[0]
    );
}

#[test]
fn watertight() {
    let aims = Aims {
        random_count: 100_000,
        per_edge: 4,
    };
    for solid in solids() {
        assert_watertight(&solid, aims);
    }
}

/// Far from the origin vertices round to a coarse lattice, but shared vertices round alike.
#[test]
fn watertight_far_from_the_origin() {
    let aims = Aims {
        random_count: 20_000,
        per_edge: 2,
    };
    // The needle collapses there.
    for solid in solids().iter().filter(|solid| solid.name != "needle prism") {
        for scale in [1.0, 100.0] {
            let mut placed = solid.placed(scale, Vec3::new(148_376.0, 1234.0, -223_423.0));
            placed.inside.retain(|p| {
                let winding = slimbvh_tests::closed::winding_number(&placed.mesh, p.to_array());
                winding > 0.99
            });
            if placed.inside.is_empty() {
                // A needle collapses there.
                assert!(
                    solid.name.contains("needle") || solid.name.contains("prism"),
                    "{}",
                    placed.name
                );
            } else {
                assert_watertight(&placed, aims);
            }
        }
    }
}

#[test]
fn watertight_at_every_magnitude() {
    let aims = Aims {
        random_count: 10_000,
        per_edge: 1,
    };
    for solid in solids() {
        for scale in [1e-30, 1e-20, 1e-6, 1e6, 1e20, 1e30] {
            assert_watertight(&solid.placed(scale, Vec3::ZERO), aims);
        }
    }
}

#[test]
fn watertight_real_meshes() {
    for (name, mesh) in real_meshes(&["armadillo.off", "bunny00.off", "refined_elephant.off"]) {
        let component = &analyze(&mesh).components[0];
        assert!(component.closed, "{name}");
        let size = (0..3).map(|axis| component.bounds.max[axis] - component.bounds.min[axis]);
        let inside = points_inside(&mesh, 0.01 * size.fold(0.0, f32::max), 3, 1);
        let solid = Solid::new(&name, mesh, &inside);
        assert_watertight(
            &solid,
            Aims {
                random_count: 50_000,
                per_edge: 1,
            },
        );
    }
}

/// Embree's test: the ray at a small triangle's centroid returns that triangle.
#[test]
fn a_ray_at_a_centroid_returns_that_triangle() {
    for solid in solids()
        .iter()
        .filter(|solid| solid.name.contains("sphere") && !solid.name.contains("flake"))
    {
        let bvh = build(&solid.mesh, CodeBits::Bits30);
        for (face, primitive) in solid.mesh.indices.iter().zip(0..) {
            let [a, b, c] = face.map(|v| Vec3::from(solid.mesh.vertices[v as usize]));
            let hit = bvh.closest_hit(aims::at(Vec3::ZERO, (a + b + c) / 3.0));
            assert_eq!(hit.primitive, primitive, "{}", solid.name);
            assert!((hit.t - 1.0).abs() < 1e-4, "{}: {}", solid.name, hit.t);
        }
    }
}
