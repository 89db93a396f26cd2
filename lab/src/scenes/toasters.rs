//! Two toasters.

use glam::{Quat, Vec3};
use slimbvh::generate::concatenate;
use slimbvh::generate::{RoundedBox, Sides, cuboid, rounded_box, transformed};
use slimbvh::{Camera, Light, Material, Mesh, Projection, Scene};

/// Two toasters with slots, slices, levers, knobs and feet, 1.6 wide, on one board of 12 triangles, as a scene with a
/// camera and a light. Every part is a solid of its own.
///
/// `cells` divides the height of a toaster's body, at least 8. Of 57 there are 105 628 triangles; the scene of Wong, Cheng
/// and Lii ("Reduced BVHs for GPU Ray Tracing", 2012) has 105 774. There 81 794 face the camera, 77 in 100, and as many the
/// light. It is so here too: bottoms and backs are [coarse](Sides::CoarseBehind), so front, top and two ends have nearly
/// all triangles, of which one end faces away; and front and top are twice as finely divided as the ends. The light comes
/// over the camera's shoulder, and sees the same sides.
#[must_use]
pub fn toasters(cells: u32) -> Scene {
    let mut scene = Scene {
        materials: MATERIALS.to_vec(),
        cameras: vec![Camera {
            eye: [5.4, 5.0, 7.4],
            target: [0.1, 0.45, 0.0],
            up: [0.0, 1.0, 0.0],
            projection: Projection::Perspective { vertical_fov: 24.0 },
        }],
        lights: vec![Light::Directional {
            direction: [-0.4, -1.0, -0.5],
            color: [2.9, 2.7, 2.4],
        }],
        ..Scene::default()
    };
    let board = cuboid(Vec3::new(-2.6, -0.12, -1.7), Vec3::new(2.6, 0.0, 1.7));
    add(&mut scene.mesh, &board, BOARD);
    let place = |x: f32, z: f32, degrees: f32| {
        (
            Quat::from_rotation_y(f32::to_radians(degrees)),
            Vec3::new(x, 0.0, z),
        )
    };
    for (paint, (turn, at)) in [
        (RED, place(-1.02, -0.28, 14.0)),
        (CREAM, place(0.98, 0.22, -6.0)),
    ] {
        for (part, material) in parts(cells.max(8), paint) {
            add(&mut scene.mesh, &transformed(part, 1.0, turn, at), material);
        }
    }
    scene
}

/// What parts are made of.
const BOARD: u32 = 0;
const RED: u32 = 1;
const CREAM: u32 = 2;
const DARK: u32 = 3;
const TOAST: u32 = 4;
const STEEL: u32 = 5;

const MATERIALS: [Material; 6] = [
    material([0.40, 0.25, 0.14], 0.02),
    material([0.55, 0.07, 0.06], 0.12),
    material([0.72, 0.66, 0.50], 0.10),
    material([0.03, 0.03, 0.035], 0.04),
    material([0.55, 0.29, 0.10], 0.0),
    material([0.62, 0.63, 0.65], 0.45),
];

const fn material(base_color: [f32; 3], mirror: f32) -> Material {
    Material {
        base_color,
        mirror,
        transmission: 0.0,
        ior: 1.0,
        double_sided: true,
    }
}

/// The parts of a toaster that stands on the origin, front to +z, its lever on the end at +x, and what they are made of.
fn parts(cells: u32, paint: u32) -> Vec<(Mesh, u32)> {
    // Cells by share of the body's.
    let part = |center: [f32; 3], half: [f32; 3], radius: f32, shares: [f32; 3]| {
        rounded_box(&RoundedBox {
            center: center.into(),
            half: half.into(),
            radius,
            cells: shares.map(|share| (share * cells as f32).round() as u32),
            sides: Sides::CoarseBehind,
        })
    };
    let mut parts = vec![
        (
            part([0.0, 0.56, 0.0], [0.8, 0.5, 0.46], 0.2, [2.0, 1.0, 1.0]),
            paint,
        ),
        (
            part(
                [0.0, 0.14, 0.0],
                [0.74, 0.06, 0.42],
                0.05,
                [0.5, 0.12, 0.24],
            ),
            STEEL,
        ),
        // The lever and the knob under it.
        (
            part(
                [0.86, 0.78, 0.0],
                [0.09, 0.035, 0.11],
                0.03,
                [0.2, 0.16, 0.2],
            ),
            DARK,
        ),
        (
            part([0.82, 0.4, 0.0], [0.06, 0.08, 0.08], 0.05, [0.2, 0.2, 0.2]),
            STEEL,
        ),
    ];
    for (z, rise) in [(-0.17, 0.02), (0.17, 0.0)] {
        // A rim around the slot, and the slice in it.
        parts.push((
            part([0.0, 1.055, z], [0.6, 0.022, 0.1], 0.02, [0.5, 0.09, 0.2]),
            DARK,
        ));
        parts.push((
            part(
                [0.0, 1.02 + rise, z],
                [0.46, 0.3, 0.055],
                0.05,
                [0.48, 0.34, 0.2],
            ),
            TOAST,
        ));
    }
    for [x, z] in [[-0.6, -0.3], [-0.6, 0.3], [0.6, -0.3], [0.6, 0.3]] {
        parts.push((
            part([x, 0.055, z], [0.07, 0.05, 0.07], 0.03, [0.1, 0.09, 0.09]),
            DARK,
        ));
    }
    parts
}

fn add(mesh: &mut Mesh, part: &Mesh, material: u32) {
    concatenate(mesh, part);
    mesh.materials.resize(mesh.indices.len(), material);
}

#[cfg(test)]
mod tests {
    use super::*;
    use slimbvh::internals::assert_solid;

    #[test]
    fn every_part_is_solid() {
        let mesh = toasters(20).mesh;
        assert_eq!(assert_solid(&mesh).len(), 1 + 2 * 12);
    }

    /// How many triangles, and the share that faces each of two points, as in the printed table.
    #[test]
    fn triangles_face_the_camera_and_the_light() {
        let scene = toasters(57);
        let mesh = &scene.mesh;
        assert_eq!(mesh.validate(), Ok(()));
        let count = mesh.indices.len();
        let toward = |from: &dyn Fn(Vec3) -> Vec3| {
            let faces = mesh.indices.iter().filter(|triangle| {
                let [a, b, c] = triangle.map(|v| Vec3::from(mesh.vertices[v as usize]));
                (b - a).cross(c - a).dot(from(a)) > 0.0
            });
            faces.count() as f64 / count as f64
        };
        let eye = Vec3::from(scene.cameras[0].eye);
        let Light::Directional { direction, .. } = scene.lights[0] else {
            unreachable!("it is a sun");
        };
        let to_eye = toward(&|a| eye - a);
        let to_light = toward(&|_| -Vec3::from(direction));
        println!("{count} triangles, {to_eye:.3} face the camera, {to_light:.3} the light");
        assert_eq!(count, 105_628);
        assert!((0.76..0.79).contains(&to_eye), "{to_eye}");
        assert!((0.76..0.79).contains(&to_light), "{to_light}");
    }
}
