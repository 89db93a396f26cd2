//! The kernels of stage `decide` against the host's facts about components (64-bit arithmetic, solid angles): the kernels never
//! decide more, and decide less only where a target touches a component's box.

use crate::reduced_scenes::scenes::{ball, scenes};
use glam::Vec3;
use proptest::prelude::*;
use slimbvh::generate::{append, cuboid};
use slimbvh::reduce::{Seams, survey};
use slimbvh::topology::{self, Topology};
use slimbvh::{BuildConfig, Decisions, Mesh};
use slimbvh_core::classify::{SideSource, Sides, faces};
use slimbvh_core::decide::is_clear_of_box;
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::orientation::Target;
use slimbvh_core::snap::leaf_triangle;
use slimbvh_tests::cases;
use slimbvh_tests::closed::{long_prism, placed, small_torus_knot};
use slimbvh_tests::gpu::done;
use slimbvh_tests::random::Random;
use slimbvh_tests::strategies::any_mesh;
use std::sync::Arc;

/// The topology of a mesh, with its seams.
pub fn surveyed(mesh: &Mesh) -> Arc<Topology> {
    done(survey(mesh, BuildConfig::default(), Seams::Find)).topology
}

/// The target in the form of [`Topology`].
pub fn known(target: &Target) -> topology::Target {
    match (target.is_position, target.radius) {
        (0, _) => topology::Target::Direction(target.point),
        (_, 0.0) => topology::Target::Point(target.point),
        (_, radius) => topology::Target::Ball {
            center: target.point,
            radius,
        },
    }
}

/// Eyes, lamps, suns and balls, inside and outside of a mesh.
pub fn targets(mesh: &Mesh, count: usize, seed: u64) -> Vec<Target> {
    let mut random = Random::new(seed);
    let Some(bounds) = mesh.bounds() else {
        return vec![Target::position([1.0, 2.0, 3.0])];
    };
    let size = (bounds.max * 0.5 - bounds.min * 0.5).length().max(1e-30);
    (0..count)
        .map(|kind| {
            let mut within = || {
                let [x, y, z] = [0, 1, 2].map(|_| random.unit());
                let along = Vec3::new(x, y, z);
                let middle = bounds.min * 0.5 + bounds.max * 0.5;
                middle + (along - 0.5) * (bounds.max * 0.5 - bounds.min * 0.5) * 3.0
            };
            let point = within().to_array();
            let on_mesh = mesh.vertices[kind * 7919 % mesh.vertices.len()];
            match kind % 5 {
                0 | 1 => Target::position(point),
                2 => Target::direction(within().to_array()),
                3 => Target::ball(point, size * random.unit()),
                _ => Target::position(on_mesh),
            }
        })
        .collect()
}

/// Checks a target's sides. Returns the number of components with a certain side.
pub fn check_sides(
    topology: &Topology,
    decisions: &Decisions,
    target: &Target,
    sides: &[i32],
) -> Result<usize, String> {
    let expected = topology.sides(&known(target));
    if sides.len() != expected.len() {
        return Err(format!("{} sides of {}", sides.len(), expected.len()));
    }
    for (component, (&side, &expected)) in sides.iter().zip(&expected).enumerate() {
        let touches = || {
            let mut measures = decisions.measures();
            let measure = measures.find(|(number, _)| *number as usize == component);
            measure.is_some_and(|(_, of)| !is_clear_of_box(of.low, of.high, target))
        };
        if side != expected && (side != 0 || !touches()) {
            return Err(format!(
                "component {component} has side {side} instead of {expected} for {target:?}"
            ));
        }
    }
    Ok(sides.iter().filter(|side| **side != 0).count())
}

/// Checks many targets of a mesh. Returns the number of certain sides.
fn check(mesh: &Mesh, topology: &Topology, count: usize) -> Result<usize, String> {
    let mut decisions = Decisions::new(topology);
    decisions.measure(mesh);
    let mut certain_count = 0;
    for target in targets(mesh, count, 5) {
        let sides = decisions.sides(&target);
        certain_count += check_sides(topology, &decisions, &target, &sides)?;
    }
    Ok(certain_count)
}

/// Gives every triangle its own three vertices.
pub fn unwelded(mesh: &Mesh) -> Mesh {
    let corners = mesh.indices.as_flattened().iter();
    Mesh {
        vertices: corners.map(|&v| mesh.vertices[v as usize]).collect(),
        indices: (0..mesh.indices.len() as u32)
            .map(|t| [3 * t, 3 * t + 1, 3 * t + 2])
            .collect(),
        ..Mesh::default()
    }
}

/// A dome whose upper side has more triangles than its floor, around the y axis.
pub fn dome(sides: u32) -> Mesh {
    let mut vertices = vec![[0.0, 1.0, 0.0]];
    for (radius, height) in [(0.7, 0.75), (1.0, 0.0)] {
        for side in 0..sides {
            let (sin, cos) = (std::f32::consts::TAU * side as f32 / sides as f32).sin_cos();
            vertices.push([radius * cos, height, radius * sin]);
        }
    }
    let mut indices = Vec::new();
    for side in 0..sides {
        let next = (side + 1) % sides;
        let [a, b] = [1 + side, 1 + next];
        let [c, d] = [a + sides, b + sides];
        indices.extend([[0, b, a], [a, b, c], [b, d, c]]);
        if side > 0 && next > 0 {
            indices.push([1 + sides, c, d]);
        }
    }
    Mesh {
        vertices,
        indices,
        ..Mesh::default()
    }
}

/// A mesh of parts: closed, inside out, open, nested, and with several spans.
pub fn mixed() -> Mesh {
    let mut open = ball([-6.0, 0.0, 0.0], 1.0);
    open.indices.pop();
    let mut averted = small_torus_knot();
    for triangle in &mut averted.indices {
        triangle.swap(1, 2);
    }
    let parts = [
        ball([0.0; 3], 1.0),
        open,
        placed(averted, 1.0, Vec3::new(5.0, 1.0, 0.0)),
        cuboid(Vec3::splat(-9.0), Vec3::new(7.0, 9.0, 9.5)),
        placed(unwelded(&dome(40)), 1.0, Vec3::new(2.0, -4.0, 3.0)),
        placed(long_prism(3.0, 0.5, 9), 1.0, Vec3::new(0.0, 4.0, 0.0)),
    ];
    let mut mesh = Mesh::default();
    for part in parts {
        append(&mut mesh, part, "part", 0);
    }
    mesh.normals.clear();
    mesh
}

#[test]
fn scenes_have_the_sides_that_the_host_knows() {
    for (name, scene) in scenes() {
        let topology = surveyed(&scene.mesh);
        let certain_count = done(check(&scene.mesh, &topology, 60));
        assert!(certain_count > 30, "{name}: {certain_count}");
    }
}

#[test]
fn generated_meshes_have_the_sides_that_the_host_knows() {
    let mut certain_count = 0;
    for (name, mesh) in crate::meshes::generated() {
        let checked = check(&mesh, &surveyed(&mesh), 40);
        certain_count += checked.unwrap_or_else(|fault| panic!("{name}: {fault}"));
    }
    assert!(certain_count > 1000, "{certain_count}");
}

proptest! {
    #![proptest_config(cases(200))]

    #[test]
    fn no_mesh_has_a_side_that_the_host_does_not_know(mesh in any_mesh(), turn in 0usize..3) {
        let topology = surveyed(&mesh);
        let mut decisions = Decisions::new(&topology);
        // The same with the vertices at other places.
        let mut moved = mesh.clone();
        for vertex in &mut moved.vertices {
            vertex.rotate_left(turn);
            vertex[turn] *= -1.0;
        }
        let mut followed = Topology::clone(&topology);
        followed.update(&moved);
        for (mesh, topology) in [(&mesh, &*topology), (&moved, &followed)] {
            decisions.measure(mesh);
            for target in targets(mesh, 20, 9) {
                let sides = decisions.sides(&target);
                let expected = topology.sides(&known(&target));
                let more = sides.iter().zip(&expected).position(|(side, expected)| *side != 0 && side != expected);
                prop_assert_eq!(more, None, "{:?}", target);
            }
        }
    }
}

/// The same for a mesh that moves. The negative control: without measuring again the sides are wrong.
#[test]
fn what_moves_is_decided_anew() {
    let mesh = mixed();
    let mut topology = surveyed(&mesh);
    let mut decisions = Decisions::new(&topology);
    decisions.measure(&mesh);
    let far = Target::position([30.0, 20.0, 10.0]);
    let before = decisions.sides(&far);
    assert_eq!(before, [1, 0, -1, 1, 1, 1, 0]);
    assert_eq!(done(check_sides(&topology, &decisions, &far, &before)), 5);

    // Turn the ball inside out, and tear the dome at one corner.
    let mut moved = mesh.clone();
    let ball_vertices = ball([0.0; 3], 1.0).vertices.len();
    for vertex in &mut moved.vertices[..ball_vertices] {
        vertex[0] = -vertex[0];
    }
    let dome_triangle = topology
        .components()
        .iter()
        .position(|&component| component == 4);
    let torn = mesh.indices[dome_triangle.expect("there is a dome")][1];
    moved.vertices[torn as usize][1] += 1e-3;
    Arc::make_mut(&mut topology).update(&moved);
    assert!(check_sides(&topology, &decisions, &far, &before).is_err());
    decisions.measure(&moved);
    let after = decisions.sides(&far);
    assert_eq!(after, [-1, 0, -1, 1, 0, 1, 0]);
    assert_eq!(done(check_sides(&topology, &decisions, &far, &after)), 4);
}

/// Numbers of triangles that face a target and that face away from it; only certain triangles are left out.
pub fn counted(mesh: &Mesh, components: &[u32], sides: &[i32], target: &Target) -> [u32; 2] {
    let bounds = mesh.bounds().expect("there are triangles");
    let scale = PowerOfTwo::new(slimbvh_core::bounds::scene_exponent(&bounds));
    let (target, sides) = (target.scaled(&scale), Sides { components, sides });
    [1, -1].map(|sign| {
        let kept = (0..mesh.indices.len() as u32).filter(|&i| {
            let triangle = leaf_triangle(i, &mesh.triangles(), &scale).triangle();
            faces(&triangle, sign * sides.side(i), &target)
        });
        kept.count() as u32
    })
}

#[test]
fn the_smaller_set_is_taken_where_the_eye_is_outside() {
    let mesh = dome(40);
    let topology = surveyed(&mesh);
    let mut decisions = Decisions::new(&topology);
    decisions.measure(&mesh);
    let above = Target::direction([0.1, 1.0, 0.05]);
    let below = Target::direction([0.1, -1.0, 0.05]);
    for (sun, eye, is_smaller) in [
        (above, [0.0, 2.0, 3.0], true),
        (above, [0.0, 0.2, 0.1], false),
        (above, [1.0, 0.9, 0.9], false),
        (below, [0.0, 2.0, 3.0], false),
    ] {
        let eye_sides = decisions.sides(&Target::position(eye));
        let mut sides = decisions.sides(&sun);
        assert_eq!(sides, [1, 0]);
        let counts = decisions.take_smaller(&mesh, &sun, &eye_sides, &mut sides);
        assert_eq!(counts.is_minus == 1, is_smaller);
        assert_eq!(sides, [if is_smaller { -1 } else { 1 }, 0]);
        let expected = counted(&mesh, topology.components(), &[1, 0], &sun);
        assert_eq!([counts.plus, counts.minus], expected);
        let barred = if eye_sides[0] == 0 {
            mesh.indices.len()
        } else {
            0
        };
        assert_eq!(counts.barred as usize, barred);
    }
}
