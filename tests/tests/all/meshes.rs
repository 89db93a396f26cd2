//! Meshes for several tests.

use glam::{Quat, Vec3};
use slimbvh::Mesh;
use slimbvh::generate::{
    TorusKnot, cuboid, default_scene, grid_of_objects, ground, huge_and_tiny, icosphere, slivers,
    soup, sphere_flake, subdivide, subdivide_curved, teapot, terrain, torus_knot, transformed,
};
use slimbvh_tests::closed::{dented_sphere, long_prism};

/// One mesh of each kind that the library generates, small enough for brute force.
pub fn generated() -> Vec<(&'static str, Mesh)> {
    let unit_box = cuboid(Vec3::new(-0.5, -1.0, -1.5), Vec3::new(0.5, 1.0, 1.5));
    vec![
        ("icosphere", icosphere(Vec3::new(1.0, 2.0, 3.0), 2.0, 3)),
        ("torus knot", medium_torus_knot()),
        ("terrain", terrain(10.0, 24, 3)),
        ("ground", ground(100.0, 16)),
        ("soup", soup(1500, 7)),
        ("slivers", slivers(800, 8)),
        ("sphere flake", sphere_flake(2, 1)),
        ("teapot", teapot()),
        ("finer teapot", subdivide_curved(&teapot(), 1)),
        ("finer box", subdivide(&unit_box, 4)),
        (
            "grid",
            grid_of_objects(&unit_box, [4, 3, 5], Vec3::splat(2.5)),
        ),
        (
            "huge and tiny",
            huge_and_tiny(icosphere(Vec3::ZERO, 1.0, 2), 1e6),
        ),
        (
            "turned",
            transformed(
                teapot(),
                0.01,
                Quat::from_rotation_x(1.0),
                Vec3::splat(50.0),
            ),
        ),
        ("default scene", default_scene().mesh),
    ]
}

/// Closed solids, each with points deep inside.
pub fn solids() -> Vec<Solid> {
    let knot = TorusKnot {
        p: 2,
        q: 3,
        segments: 300,
        sides: 16,
        major_radius: 1.0,
        minor_radius: 0.4,
        tube_radius: 0.15,
    };
    vec![
        Solid::new(
            "icosphere",
            icosphere(Vec3::ZERO, 1.0, 4),
            &[Vec3::ZERO, Vec3::new(0.3, 0.7, -0.2)],
        ),
        Solid::new(
            "dented sphere",
            dented_sphere(4, 0.3, 1),
            &[Vec3::ZERO, Vec3::new(0.01, -0.2, 0.3)],
        ),
        Solid::new(
            "very dented sphere",
            dented_sphere(5, 0.9, 2),
            &[Vec3::ZERO],
        ),
        Solid::new("torus knot", torus_knot(&knot), &[]),
        Solid::new(
            "cuboid",
            cuboid(Vec3::new(-1.0, -2.0, -3.0), Vec3::new(1.0, 1.0, 2.0)),
            &[Vec3::ZERO, Vec3::new(0.9, 0.9, -2.9)],
        ),
        Solid::new("sphere flake", sphere_flake(2, 3), &[Vec3::ZERO]),
        Solid::new(
            "long prism",
            long_prism(1000.0, 0.5, 9),
            &[Vec3::new(0.01, 0.0, 0.0), Vec3::new(500.0, 0.1, 0.2)],
        ),
        Solid::new(
            "needle prism",
            long_prism(1.0, 1e-5, 200),
            &[Vec3::new(1e-5, 0.0, 0.0), Vec3::new(0.5, 1e-6, 0.0)],
        ),
    ]
}

/// A closed mesh, and points inside of it.
pub struct Solid {
    /// The name in messages.
    pub name: String,
    /// The surface.
    pub mesh: Mesh,
    /// The origins of rays.
    pub inside: Vec<Vec3>,
}

impl Solid {
    pub fn new(name: &str, mesh: Mesh, inside: &[Vec3]) -> Self {
        let inside = if inside.is_empty() {
            slimbvh_tests::closed::points_inside(&mesh, 0.02, 4, 5)
        } else {
            inside.to_vec()
        };
        Self {
            name: name.to_owned(),
            mesh,
            inside,
        }
    }

    /// The solid at another place.
    pub fn placed(&self, scale: f32, translation: Vec3) -> Self {
        let mesh = slimbvh_tests::closed::placed(self.mesh.clone(), scale, translation);
        Self {
            name: format!("{} times {scale:e}, moved by {translation}", self.name),
            mesh,
            inside: self
                .inside
                .iter()
                .map(|&p| p * scale + translation)
                .collect(),
        }
    }
}

fn medium_torus_knot() -> Mesh {
    torus_knot(&TorusKnot {
        p: 3,
        q: 4,
        segments: 90,
        sides: 8,
        major_radius: 2.0,
        minor_radius: 0.6,
        tube_radius: 0.2,
    })
}
