//! Scenes where rounding could matter: surfaces that cut themselves, touch, are seen edge-on, or have an eye or a lamp one
//! step off them.

use super::scenes::{EYE, PERSPECTIVE, SUN, ball, camera, floor, inside_out, lamp, scene};
use glam::{Quat, Vec3};
use slimbvh::generate::{TorusKnot, cuboid, slivers, torus_knot, transformed};
use slimbvh::{Light, Mesh, Projection, Scene};
use slimbvh_tests::closed::{long_prism, placed};
use std::f64::consts::TAU;

/// All scenes, by name.
pub fn scenes() -> Vec<(&'static str, Scene)> {
    let front = || camera(EYE, [0.0; 3], PERSPECTIVE);
    let both = [SUN, lamp([2.5, 2.0, 1.5])];
    let eye_at = |eye: [f32; 3]| camera(eye, [0.0; 3], PERSPECTIVE);
    let block = || cuboid(Vec3::new(-1.0, -1.0, -1.0), Vec3::new(1.0, 0.5, 1.0));
    let step = |x: f32, by: f32| x + by * f32::EPSILON;
    let beside = |x: f32| Scene {
        lights: vec![lamp([x, 0.2, 0.3]), SUN],
        ..scene(
            vec![block(), ball([2.0, 0.0, 0.4], 0.6), floor()],
            front(),
            &[],
        )
    };
    let before = |y: f32, z: f32| {
        let eye = camera([0.3, y, z], [0.1, 0.1, -1.0], PERSPECTIVE);
        scene(
            vec![block(), ball([0.2, -0.3, 1.6], 0.4), floor()],
            eye,
            &both,
        )
    };
    vec![
        (
            "figure eight",
            scene(vec![figure_eight(0.0), floor()], front(), &both),
        ),
        (
            "figure eight that cuts itself",
            scene(vec![figure_eight(0.5), floor()], front(), &both),
        ),
        (
            "knot that cuts itself",
            scene(vec![thick_knot(), floor()], front(), &both),
        ),
        (
            "cut, inside out",
            scene(vec![inside_out(thick_knot()), floor()], front(), &both),
        ),
        ("stack", scene(stack(), front(), &both)),
        (
            "thin plate",
            scene(vec![plate(1e-5), floor()], eye_at([0.7, 0.3, 4.0]), &both),
        ),
        (
            "thin plate on its edge",
            scene(
                vec![plate(1e-6), ball([-0.3, -0.5, 1.5], 0.3), floor()],
                eye_at([0.7, 0.0, 4.0]),
                &[SUN, lamp([3.0, 1e-6, 1.0])],
            ),
        ),
        ("lamp just outside", beside(step(1.0, 1.0))),
        ("lamp just inside", beside(step(1.0, -1.0))),
        ("lamp on a surface", beside(1.0)),
        ("eye just outside", before(-0.2, step(1.0, 1.0))),
        ("eye just inside", before(-0.2, step(1.0, -1.0))),
        ("eye in the plane of a side", before(0.9, 1.0)),
        (
            "slivers",
            scene(
                vec![
                    transformed(
                        slivers(300, 5),
                        2.0,
                        Quat::IDENTITY,
                        Vec3::new(-0.5, -1.0, -1.0),
                    ),
                    placed(long_prism(4e3, 0.02, 5), 1e-3, Vec3::new(-2.0, 0.3, 0.5)),
                    ball([0.2, -0.2, 0.0], 0.7),
                ],
                front(),
                &both,
            ),
        ),
        (
            "long corridor",
            scene(
                vec![
                    inside_out(long_prism(1e4, 1.0, 6)),
                    placed(long_prism(100.0, 0.2, 7), 1.0, Vec3::new(30.0, -0.5, 0.2)),
                ],
                camera([0.5, 0.1, -0.2], [50.0, 0.0, 0.0], PERSPECTIVE),
                &[lamp([20.0, 0.3, 0.4]), SUN],
            ),
        ),
        (
            "far from the origin",
            far_away(scene(
                vec![thick_knot(), plate(1e-3), ball([0.9, 0.6, 0.9], 0.3)],
                front(),
                &both,
            )),
        ),
        (
            "parallel rays along sides",
            scene(
                vec![block(), ball([1.6, 0.0, 0.4], 0.6), floor()],
                camera(
                    [0.0, 3.0, 0.0],
                    [0.0; 3],
                    Projection::Orthographic { height: 5.0 },
                ),
                &[
                    Light::Directional {
                        direction: [-1.0, 0.0, 0.0],
                        color: [2.0; 3],
                    },
                    lamp([1.0, 3.0, 1.0]),
                ],
            ),
        ),
    ]
}

/// A lemniscate in the x–y plane revolved around the y axis, closed and consistently wound; one of its lobes is inside out.
/// With `offset` 0 the lobes share corners where they meet, else the tube cuts itself there.
fn figure_eight(offset: f64) -> Mesh {
    const RINGS: u32 = 32;
    const SIDES: u32 = 16;
    let mut mesh = Mesh::default();
    let vertex = |ring: u32, side: u32| (ring % RINGS) * SIDES + side % SIDES;
    for ring in 0..RINGS {
        for side in 0..SIDES {
            let t = TAU * (f64::from(side) + offset) / f64::from(SIDES);
            let is_crossing = offset == 0.0 && side % (SIDES / 2) == SIDES / 4;
            let (sin, cos) = if is_crossing { (1.0, 0.0) } else { t.sin_cos() };
            let (r, y) = (
                1.0 + 0.5 * cos / (1.0 + sin * sin),
                sin * cos / (1.0 + sin * sin),
            );
            let (sin, cos) = (TAU * f64::from(ring) / f64::from(RINGS)).sin_cos();
            mesh.vertices.push([r * cos, y, r * sin].map(|x| x as f32));
            let [a, b] = [vertex(ring, side), vertex(ring, side + 1)];
            let [c, d] = [vertex(ring + 1, side), vertex(ring + 1, side + 1)];
            mesh.indices.extend([[a, b, c], [b, d, c]]);
        }
    }
    mesh
}

/// A trefoil with a tube so thick that it cuts itself.
fn thick_knot() -> Mesh {
    torus_knot(&TorusKnot {
        p: 2,
        q: 3,
        segments: 60,
        sides: 8,
        major_radius: 0.9,
        minor_radius: 0.4,
        tube_radius: 0.4,
    })
}

/// Stacked blocks on the ground, and a ball that stands on them with one corner: all parts touch.
fn stack() -> Vec<Mesh> {
    let block = |min: [f32; 3], max: [f32; 3]| cuboid(min.into(), max.into());
    vec![
        floor(),
        block([-1.0, -1.0, -0.5], [0.5, -0.25, 0.5]),
        block([0.5, -1.0, -0.25], [1.25, -0.25, 0.75]),
        block([-0.5, -0.25, -0.5], [1.0, 0.25, 0.25]),
        standing([0.25, 0.25, 0.0], 0.5),
    ]
}

/// A ball with its lowest corner at this point.
fn standing(at: [f32; 3], radius: f32) -> Mesh {
    let mesh = ball([0.0; 3], radius);
    let vertices = mesh.vertices.iter();
    let lowest = vertices.fold([f32::INFINITY; 3], |a, &b| if b[1] < a[1] { b } else { a });
    placed(mesh, 1.0, Vec3::from(at) - Vec3::from(lowest))
}

/// A closed plate around y = 0.
fn plate(thickness: f32) -> Mesh {
    let half = Vec3::new(1.5, 0.5 * thickness, 1.0);
    cuboid(-half, half)
}

/// The scene moved so far that steps of the float grid are 2^-14.
fn far_away(mut scene: Scene) -> Scene {
    const BY: [f32; 3] = [700.0, -900.0, 1000.0];
    let moved = |p: [f32; 3]| [0, 1, 2].map(|axis| p[axis] + BY[axis]);
    scene
        .mesh
        .vertices
        .iter_mut()
        .for_each(|vertex| *vertex = moved(*vertex));
    for camera in &mut scene.cameras {
        (camera.eye, camera.target) = (moved(camera.eye), moved(camera.target));
    }
    for light in &mut scene.lights {
        if let Light::Point { position, .. } = light {
            *position = moved(*position);
        }
    }
    scene
}
