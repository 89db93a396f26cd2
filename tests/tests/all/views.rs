//! View sets: what they leave out, keep or refit changes no answer to the rays that they are for.

mod frames;
pub mod rays;

use glam::{Quat, Vec3};
use rays::{answers, rays_of};
use slimbvh::reduce::{PlanConfig, Reduce, Seams, Still, Switches, TreeChoice};
use slimbvh::{
    Camera, Change, Cpu, FrameConfig, Light, Mesh, Projection, ViewSets, ViewTarget, generate,
};
use slimbvh_tests::closed::{dented_sphere, small_torus_knot};
use slimbvh_tests::gpu::done;

/// The picture that the camera's rays go through, in pixels.
pub const SIZE: [u32; 2] = [40, 30];

pub const EYE: [f32; 3] = [0.5, 0.7, 3.5];
pub const LAMP: [f32; 3] = [2.5, 2.0, 1.5];
pub const PROBE: [f32; 3] = [-2.0, 0.4, 1.0];
pub const PROBE_RADIUS: f32 = 0.3;
pub const SUN: [f32; 3] = [-0.3, -1.0, -0.4];

pub fn camera() -> Camera {
    Camera {
        eye: EYE,
        target: [0.0; 3],
        up: [0.0, 1.0, 0.0],
        projection: Projection::Perspective { vertical_fov: 30.0 },
    }
}

/// A camera, the sun, a lamp, a ball that rays come from, and all others.
pub fn targets() -> Vec<ViewTarget> {
    let sun = Light::Directional {
        direction: SUN,
        color: [1.0; 3],
    };
    vec![
        done(ViewTarget::camera(&camera(), SIZE)),
        done(ViewTarget::light(&sun)),
        done(ViewTarget::rays_to(LAMP, 0.0)),
        done(ViewTarget::rays_from(PROBE, PROBE_RADIUS)).named("a probe"),
        ViewTarget::other_rays(),
    ]
}

/// Closed surfaces beside one that is not closed.
pub fn meshes() -> Vec<Mesh> {
    let closed = [
        generate::icosphere(Vec3::ZERO, 1.0, 4),
        dented_sphere(4, 0.3, 7),
        small_torus_knot(),
    ];
    let beside = |mut mesh: Mesh| {
        let ground = generate::ground(4.0, 6);
        let ground = generate::transformed(ground, 1.0, Quat::IDENTITY, 1.2 * Vec3::NEG_Y);
        mesh.normals.clear();
        generate::append(&mut mesh, ground, "ground", 0);
        mesh.normals.clear();
        mesh
    };
    closed.into_iter().map(beside).collect()
}

pub fn config(reduce: Reduce) -> FrameConfig {
    FrameConfig {
        plan: PlanConfig {
            switches: Switches {
                cull: Some(slimbvh::reduce::Cull::On),
                reduce,
                seams: Seams::None,
                ..Switches::default()
            },
            frame_count: 100,
            still: Some(Still {
                vertices: true,
                lights: false,
            }),
        },
        ..FrameConfig::default()
    }
}

/// The mesh turned about the vertical, each height by its own angle.
pub fn twisted(mesh: &Mesh, angle: f32) -> Mesh {
    let mut mesh = mesh.clone();
    for [x, y, z] in &mut mesh.vertices {
        let (sin, cos) = (angle * *y).sin_cos();
        (*x, *z) = (cos * *x - sin * *z, sin * *x + cos * *z);
    }
    mesh
}

fn views_of(mesh: &Mesh, targets: &[ViewTarget], reduce: Reduce) -> ViewSets<Cpu> {
    let mut views = ViewSets::new(Cpu, config(reduce));
    done(views.update(mesh, targets, Change::Scene));
    views
}

/// Whatever is left out, each target's rays have the answers of the whole tree with the rule, to the bit.
#[test]
fn a_targets_rays_have_the_same_answers_whatever_its_tree_leaves_out() {
    for mesh in meshes() {
        let targets = targets();
        let whole = views_of(&mesh, &targets, Reduce::Off);
        let rays = rays_of(&mesh, &whole);
        let expected = answers(&whole, &rays);
        for reduce in [Reduce::On, Reduce::Auto] {
            let views = views_of(&mesh, &targets, reduce);
            assert_eq!(
                answers(&views, &rays),
                expected,
                "{reduce:?}\n{}",
                views.explain()
            );
        }
        let sets = views_of(&mesh, &targets, Reduce::On);
        let plan = sets.plan().expect("it was updated");
        assert!(
            plan.sets.iter().all(|set| set.choice == TreeChoice::Set),
            "{plan}"
        );
        let counts: Vec<usize> = sets
            .trees()
            .iter()
            .map(|tree| tree.bvh.triangle_count())
            .collect();
        let (others, own) = counts.split_last().expect("there are five");
        assert_eq!(*others, mesh.indices.len());
        assert!(own.iter().all(|count| count < others), "{counts:?}");
    }
}

/// The negative control: a tree is for the rays of its target alone.
#[test]
fn another_targets_tree_misses_hits() {
    let mesh = &meshes()[0];
    let targets = targets();
    let sets = views_of(mesh, &targets, Reduce::On);
    let rays = rays_of(mesh, &sets);
    let trees = sets.trees();
    let [camera, probe] = [0, 3].map(|i| &trees[i]);
    let differ = rays.from[1]
        .iter()
        .filter(|ray| camera.closest_hit(*ray).primitive != probe.closest_hit(*ray).primitive);
    assert!(differ.count() > 20);
}

/// Answers with the rule differ from those with all triangles only where rays pass silhouettes; here nowhere.
#[test]
fn the_first_hit_is_that_of_all_triangles() {
    let mesh = &meshes()[0];
    let sets = views_of(mesh, &targets(), Reduce::On);
    let rays = rays_of(mesh, &sets);
    let trees = sets.trees();
    for (i, ray) in rays.from[0].iter().enumerate() {
        assert_eq!(trees[0].closest_hit(ray), trees[4].closest_hit(ray), "{i}");
    }
    for (i, ray) in rays.to[1].iter().enumerate() {
        assert_eq!(trees[2].any_hit(ray), trees[4].any_hit(ray), "{i}");
    }
}

#[test]
fn a_plan_says_what_is_left_out_and_why() {
    let mesh = &meshes()[0];
    let sets = views_of(mesh, &targets(), Reduce::On);
    let said = sets.explain();
    println!("{said}");
    for part in [
        "1 of 2 components",
        "camera: a set of its own: keeps about",
        "light 1: a set of its own",
        "a probe: a set of its own",
        "whole tree: is built, for other rays",
    ] {
        assert!(said.contains(part), "{part}\n{said}");
    }
    let mut off = FrameConfig::default();
    off.plan.switches.reduce = Reduce::Off;
    let mut plain = ViewSets::new(Cpu, off);
    assert_eq!(plain.explain(), "nothing was built yet");
    assert!(plain.trees().is_empty());
    done(plain.update(mesh, &targets(), Change::Scene));
    assert!(
        plain
            .explain()
            .contains("nothing: is left out: reduction is off"),
        "{}",
        plain.explain()
    );
}
