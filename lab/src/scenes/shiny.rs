//! Mirrors and a prism around a ball.

use glam::{Quat, Vec3};
use slimbvh::generate::{append, cuboid, icosphere, transformed};
use slimbvh::{Camera, Light, Material, Mesh, Projection, Scene};
use std::f32::consts::TAU;

/// An icosphere in front of five mirrors, beside a prism of glass, on a square of four triangles: 152 triangles, as a scene
/// with a camera and two lights.
///
/// After the scene SHINY of the compressed hierarchies' paper, of which it is known that it has 152 triangles, five mirrors
/// and a prism around an icosphere. The ball has 80, each mirror 12, the prism 8. Most rays that hit go on, some of them many
/// times: from mirror to mirror, and through the glass.
#[must_use]
pub fn shiny() -> Scene {
    let mut scene = Scene {
        cameras: vec![Camera {
            eye: [0.45, 1.75, 7.0],
            target: [0.0, 1.02, 0.0],
            up: [0.0, 1.0, 0.0],
            projection: Projection::Perspective { vertical_fov: 32.0 },
        }],
        lights: vec![
            Light::Directional {
                direction: [0.75, -1.0, -0.45],
                color: [2.9, 2.5, 1.9],
            },
            Light::Point {
                position: [2.2, 3.2, 3.4],
                color: [4.0, 5.4, 8.0],
                range: f32::INFINITY,
            },
        ],
        ..Scene::default()
    };
    for (number, (name, mesh, material)) in (0..).zip(objects()) {
        append(&mut scene.mesh, mesh, name, number);
        scene.materials.push(material);
    }
    // The square's four triangles are of two colours.
    let other = scene.materials.len() as u32;
    for (triangle, material) in scene.mesh.materials[..4].iter_mut().enumerate() {
        *material = if triangle % 2 == 0 { 0 } else { other };
    }
    scene.materials.push(Material {
        base_color: [0.10, 0.16, 0.22],
        ..Material::default()
    });
    scene
}

/// The square first.
fn objects() -> Vec<(&'static str, Mesh, Material)> {
    let floor = Material {
        base_color: [0.62, 0.56, 0.46],
        ..Material::default()
    };
    let ball = Material {
        base_color: [0.80, 0.16, 0.04],
        mirror: 0.22,
        ..Material::default()
    };
    let mirror = Material {
        base_color: [0.55, 0.60, 0.62],
        mirror: 0.88,
        ..Material::default()
    };
    let glass = Material {
        base_color: [0.95, 0.985, 0.97],
        transmission: 1.0,
        ior: 1.5,
        ..Material::default()
    };
    let mut objects = vec![
        ("square", square(30.0), floor),
        ("ball", icosphere(Vec3::new(0.0, 0.9, 0.0), 0.9, 1), ball),
        ("prism", prism(), glass),
    ];
    for i in 0..5 {
        objects.push(("mirror", panel(i as f32 - 2.0), mirror));
    }
    objects
}

/// A square on the ground around the origin, divided at its middle.
fn square(size: f32) -> Mesh {
    let half = size / 2.0;
    Mesh {
        vertices: vec![
            [0.0; 3],
            [-half, 0.0, half],
            [half, 0.0, half],
            [half, 0.0, -half],
            [-half, 0.0, -half],
        ],
        indices: vec![[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1]],
        ..Mesh::default()
    }
}

/// A mirror on the arc behind the ball, so many places from its middle, leaning forward a little.
fn panel(place: f32) -> Mesh {
    let upright = cuboid(Vec3::new(-0.66, 0.0, -0.08), Vec3::new(0.66, 2.5, 0.0));
    let turn = Quat::from_rotation_y(-place * TAU / 10.0);
    let lean = Quat::from_rotation_x(0.09);
    let away = turn * Vec3::new(0.0, 0.02, -2.3);
    transformed(upright, 1.0, turn * lean, away)
}

/// A bar with three equal sides, upright.
fn prism() -> Mesh {
    let corner = |i: u32, y: f32| {
        let (sin, cos) = (i as f32 * TAU / 3.0).sin_cos();
        [0.42 * sin, y, 0.42 * cos]
    };
    let upright = Mesh {
        vertices: (0..6)
            .map(|i| corner(i % 3, if i < 3 { 0.0 } else { 1.7 }))
            .collect(),
        indices: vec![
            [0, 2, 1],
            [3, 4, 5],
            [0, 1, 3],
            [1, 4, 3],
            [1, 2, 4],
            [2, 5, 4],
            [2, 0, 5],
            [0, 3, 5],
        ],
        ..Mesh::default()
    };
    let turn = Quat::from_rotation_y(0.2);
    transformed(upright, 1.0, turn, Vec3::new(-1.3, 0.01, 1.35))
}

#[cfg(test)]
mod tests {
    use super::*;
    use slimbvh::internals::assert_solid;

    #[test]
    fn it_has_as_many_triangles_as_the_papers() {
        let scene = shiny();
        assert_eq!(scene.mesh.validate(), Ok(()));
        assert_eq!(scene.mesh.indices.len(), 152);
        let glass = |material: &u32| scene.materials[*material as usize].transmission > 0.0;
        assert_eq!(scene.mesh.materials.iter().filter(|m| glass(m)).count(), 8);
        let is_mirror = |material: &u32| scene.materials[*material as usize].mirror > 0.5;
        let mirrors = scene.mesh.materials.iter().filter(|m| is_mirror(m));
        assert_eq!(mirrors.count(), 5 * 12);
    }

    #[test]
    fn all_but_the_square_is_solid() {
        let mut mesh = Mesh::default();
        for (name, part, _) in objects().into_iter().skip(1) {
            append(&mut mesh, part, name, 0);
        }
        assert_eq!(assert_solid(&mesh).len(), 7);
    }
}
