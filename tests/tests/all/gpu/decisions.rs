//! The GPU's decisions equal the CPU's, in the frame in which the vertices move; pictures with the GPU's sides equal those of
//! the rule.

use crate::decisions::{check_sides, counted, dome, known, mixed, surveyed, targets, unwelded};
use crate::reduced_scenes::scenes::{SUN, ball, scenes};
use glam::Vec3;
use proptest::prelude::*;
use slimbvh::generate::append;
use slimbvh::gpu::{self, Answer, Builder, DecisionsReport, Frame, Gpu, LightSets, TargetSides};
use slimbvh::reduce::{
    Cull, Plan, PlanRequest, Reduce, Saving, Savings, Seams, Switches, TreeChoice,
};
use slimbvh::topology::Topology;
use slimbvh::{
    BuildConfig, Change, Decisions, FrameConfig, FrameRequest, Frames, Mesh, Output, Picture,
    RenderSettings, Scene,
};
use slimbvh_core::frustum::Frustum;
use slimbvh_core::orientation::Target;
use slimbvh_tests::cases;
use slimbvh_tests::closed::placed;
use slimbvh_tests::gpu::{done, gpu, is_software, storage};
use slimbvh_tests::parity::same_bits;
use slimbvh_tests::strategies::any_mesh;
use std::sync::Arc;

const SETTINGS: RenderSettings = RenderSettings {
    size: [96, 64],
    sample_count: 1,
    view: slimbvh::View::Color,
    mirror_depth: 2,
    dark_rays: false,
};

/// Decides all targets in one frame. The first target is the eye; the others take the smaller sets.
fn decide(
    gpu: &Gpu,
    topology: &Topology,
    mesh: &Mesh,
    targets: &[Target],
) -> (Vec<gpu::Measured>, Vec<gpu::Decided>) {
    let mut builder = Builder::new(BuildConfig::default());
    let mut decisions = done(gpu::Decisions::new(gpu, topology));
    let uploaded = done(gpu::Mesh::upload(gpu, mesh));
    let mut frame = gpu.frame();
    done(builder.sort(&mut frame, &uploaded));
    done(decisions.measure(&mut frame, &builder, &uploaded));
    let mut eye = TargetSides::new();
    let mut downloads = Vec::new();
    for (i, target) in targets.iter().enumerate() {
        let mut facing = TargetSides::new();
        let answer = if i == 0 {
            done(eye.decide(
                &mut frame,
                &decisions,
                (target, &Frustum::EVERYWHERE),
                Answer::Facing,
            ));
            Answer::Facing
        } else {
            Answer::Smaller { eye: &eye }
        };
        done(facing.decide(
            &mut frame,
            &decisions,
            (target, &Frustum::EVERYWHERE),
            answer,
        ));
        downloads.push(done(facing.read_later(&mut frame)));
    }
    let measures = done(decisions.read_later(&mut frame));
    done(frame.submit());
    let read = |download: gpu::SidesDownload| done(download.read(gpu));
    let decided = downloads.into_iter().map(read).collect();
    (done(measures.read(gpu)), decided)
}

/// Compares all decisions for a mesh with the CPU's.
fn check(gpu: &Gpu, topology: &Topology, mesh: &Mesh, targets: &[Target]) -> Result<(), String> {
    let mut decisions = Decisions::new(topology);
    decisions.measure(mesh);
    let (measured, decided) = decide(gpu, topology, mesh, targets);
    let expected: Vec<_> = decisions.measures().collect();
    if measured.len() != expected.len() {
        return Err(format!("{} instead of {}", measured.len(), expected.len()));
    }
    for (measured, (number, measure)) in measured.iter().zip(expected) {
        let sides = [&measured.measure, measure].map(|of| (of.low, of.high, of.outer_side()));
        if measured.component != number || sides[0] != sides[1] {
            return Err(format!("{measured:?} instead of {number} {measure:?}"));
        }
        if is_software(gpu) {
            same_bits(&[measured.measure], &[*measure])?;
        }
    }
    let eye_sides = decisions.sides(&targets[0]);
    for (i, (target, decided)) in targets.iter().zip(&decided).enumerate() {
        let mut sides = decisions.sides(target);
        let counts = (i > 0).then(|| decisions.take_smaller(mesh, target, &eye_sides, &mut sides));
        same_bits(&decided.sides, &sides)?;
        if decided.counts != counts {
            return Err(format!("{:?} instead of {counts:?}", decided.counts));
        }
        let known_sides = topology.sides(&known(target));
        if let Some(counts) = counts.filter(|counts| counts.is_minus == 0 && known_sides == sides) {
            let expected = counted(mesh, topology.components(), &known_sides, target);
            if [counts.plus, counts.minus] != expected {
                return Err(format!("{counts:?} instead of {expected:?}"));
            }
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(cases(24))]

    #[test]
    fn any_mesh_is_decided_as_by_the_cpu(mesh in any_mesh()) {
        let Some(gpu) = gpu() else { return Ok(()) };
        let mut mesh = mesh;
        append(&mut mesh, unwelded(&dome(9)), "dome", 0);
        let topology = surveyed(&mesh);
        prop_assert_eq!(check(gpu, &topology, &mesh, &targets(&mesh, 8, 3)), Ok(()));
    }
}

#[test]
fn scenes_are_decided_as_by_the_cpu_and_no_more_than_the_host_knows() {
    let Some(gpu) = gpu() else { return };
    for (name, scene) in scenes() {
        let topology = surveyed(&scene.mesh);
        let targets = targets(&scene.mesh, 12, 8);
        assert_eq!(
            check(gpu, &topology, &scene.mesh, &targets),
            Ok(()),
            "{name}"
        );
    }
}

#[test]
fn generated_meshes_are_decided_as_by_the_cpu() {
    let Some(gpu) = gpu() else { return };
    let mut meshes = crate::meshes::generated();
    // A mesh with several spans with links, and with many components.
    meshes.push(("apart", unwelded(&ball([1.0, 2.0, 3.0], 2.0))));
    meshes.push(("mixed", mixed()));
    for (name, mesh) in meshes {
        let topology = surveyed(&mesh);
        let result = check(gpu, &topology, &mesh, &targets(&mesh, 6, 4));
        assert_eq!(result, Ok(()), "{name}");
    }
}

#[test]
fn nothing_is_decided_of_nothing() {
    let Some(gpu) = gpu() else { return };
    let topology = Topology::new(&Mesh::default());
    let place = Target::position([1.0, 2.0, 3.0]);
    let (measured, decided) = decide(gpu, &topology, &Mesh::default(), &[place, place]);
    assert!(measured.is_empty() && decided.iter().all(|decided| decided.sides == [0]));

    // Deciding fails before the measurement, and for another mesh.
    let mesh = ball([0.0; 3], 1.0);
    let topology = Topology::new(&mesh);
    let mut decisions = done(gpu::Decisions::new(gpu, &topology));
    let mut builder = Builder::new(BuildConfig::default());
    let uploaded = done(gpu::Mesh::upload(gpu, &mesh));
    let other = done(gpu::Mesh::upload(gpu, &dome(9)));
    let mut frame = gpu.frame();
    let mut facing = TargetSides::new();
    let early = facing.decide(
        &mut frame,
        &decisions,
        (&place, &Frustum::EVERYWHERE),
        Answer::Facing,
    );
    assert!(early.is_err_and(|error| error.to_string().contains("measure")));
    let unseen = decisions.measure(&mut frame, &builder, &uploaded);
    assert!(unseen.is_err_and(|error| error.to_string().contains("sort")));
    done(builder.sort(&mut frame, &other));
    let wrong = decisions.measure(&mut frame, &builder, &other);
    assert!(wrong.is_err_and(|error| error.to_string().contains("triangles")));
    done(builder.sort(&mut frame, &uploaded));
    done(decisions.measure(&mut frame, &builder, &uploaded));
    // An eye that was decided for other components is an error.
    let mut eye = TargetSides::new();
    done(eye.set(
        &mut frame,
        decisions.components(),
        (&place, &Frustum::EVERYWHERE),
        &[1, 1, 1, 0],
    ));
    let answer = Answer::Smaller { eye: &eye };
    let wrong = facing.decide(
        &mut frame,
        &decisions,
        (&place, &Frustum::EVERYWHERE),
        answer,
    );
    assert!(wrong.is_err_and(|error| error.to_string().contains("components")));
}

/// Copies other positions into a mesh's buffer, as a kernel that moves vertices would.
fn move_to(gpu: &Gpu, frame: &mut Frame, mesh: &gpu::Mesh, vertices: &[[f32; 3]]) {
    let from = storage(gpu, vertices);
    let encoder = frame.encoder();
    encoder.copy_buffer_to_buffer(&from, 0, mesh.vertex_buffer(), 0, from.size());
}

#[test]
fn what_moves_in_a_frame_is_decided_in_it() {
    let Some(gpu) = gpu() else { return };
    let mesh = mixed();
    let mut topology = surveyed(&mesh);
    let mirrored: Vec<[f32; 3]> = mesh.vertices.iter().map(|&[x, y, z]| [-x, y, z]).collect();
    let mut torn = mesh.vertices.clone();
    let dome = topology
        .components()
        .iter()
        .position(|&component| component == 4);
    torn[mesh.indices[dome.expect("there is a dome")][1] as usize][1] += 1e-3;
    let poses = [&mesh.vertices, &mirrored, &torn, &mesh.vertices];

    let eye = Target::position([30.0, 20.0, 10.0]);
    let mut builder = Builder::new(BuildConfig::default());
    let mut decisions = done(gpu::Decisions::new(gpu, &topology));
    let uploaded = done(gpu::Mesh::upload(gpu, &mesh));
    // One frame decides the same target in the same buffers, pose after pose.
    let mut facing = TargetSides::new();
    let mut frame = gpu.frame();
    let downloads = poses.map(|vertices| {
        move_to(gpu, &mut frame, &uploaded, vertices);
        done(builder.sort(&mut frame, &uploaded));
        done(decisions.measure(&mut frame, &builder, &uploaded));
        done(facing.decide(
            &mut frame,
            &decisions,
            (&eye, &Frustum::EVERYWHERE),
            Answer::Facing,
        ));
        done(facing.read_later(&mut frame))
    });
    done(frame.submit());
    let found = downloads.map(|download| done(download.read(gpu)).sides);
    let expected = [
        [1, 0, -1, 1, 1, 1, 0],
        [-1, 0, 1, -1, -1, -1, 0],
        [1, 0, -1, 1, 0, 1, 0],
        [1, 0, -1, 1, 1, 1, 0],
    ];
    for ((found, expected), vertices) in found.iter().zip(expected).zip(poses) {
        assert_eq!(*found, expected);
        let moved = Mesh {
            vertices: vertices.clone(),
            ..mesh.clone()
        };
        Arc::make_mut(&mut topology).update(&moved);
        let mut decisions = Decisions::new(&topology);
        decisions.measure(&moved);
        done(check_sides(&topology, &decisions, &eye, found));
    }
    // The negative control: the sides of one pose are wrong for the next.
    let mut decisions = Decisions::new(&topology);
    decisions.measure(&mesh);
    assert!(check_sides(&topology, &decisions, &eye, &found[1]).is_err());
}

fn plan(scene: &Scene, topology: &Arc<Topology>, reduce: Reduce) -> Plan {
    let switches = Switches {
        cull: Some(Cull::On),
        reduce,
        seams: Seams::Find,
        // The GPU chooses the set.
        savings: Savings::ALL.without(Saving::Away).without(Saving::Turns),
    };
    let asked = done(PlanRequest::of_picture(scene, &SETTINGS, switches));
    Plan::new(topology, &scene.mesh, &asked)
}

/// A picture with a plan's trees and the sides that the GPU decides; returns both.
fn deciding(
    gpu: &Gpu,
    scene: &Scene,
    plan: &Plan,
    lights: LightSets,
) -> (Picture, DecisionsReport) {
    // Only the GPU knows the vertices.
    let mut plan = plan.clone();
    plan.may_turn_away = lights == LightSets::Smaller;
    let (picture, decisions) = frame(gpu, scene, &plan, Change::Vertices);
    let Some(decisions) = decisions else {
        unreachable!("it decides")
    };
    (picture, decisions)
}

fn frame(
    gpu: &Gpu,
    scene: &Scene,
    plan: &Plan,
    change: Change,
) -> (Picture, Option<DecisionsReport>) {
    let mut picture = Picture::default();
    let mut frames = Frames::new(gpu, FrameConfig::default());
    let request = FrameRequest {
        scene,
        plan,
        settings: &SETTINGS,
        change,
    };
    let report = done(frames.render_planned(&request, Output::new(&mut picture)));
    (picture, report.decisions)
}

/// Also with sides from the GPU the camera's set leaves out what is outside of the picture, and no other set does.
#[test]
fn the_frustum_bounds_sets_whose_sides_the_gpu_decides() {
    let Some(gpu) = gpu() else { return };
    let mut scene = all_scenes().swap_remove(0).1;
    let topology = Arc::new(Topology::new(&scene.mesh));
    let Some(bounds) = scene.mesh.bounds() else {
        unreachable!("there are triangles")
    };
    let middle = 0.5 * bounds.min + 0.5 * bounds.max;
    scene.cameras[0].target = (middle + 0.4 * (bounds.max - middle)).to_array();
    scene.cameras[0].projection = slimbvh::Projection::Perspective { vertical_fov: 9.0 };
    let plan = plan(&scene, &topology, Reduce::On);
    let counts = [true, false].map(|is_bounded| {
        let mut plan = plan.clone();
        if !is_bounded {
            plan.sets[0].frustum = Frustum::EVERYWHERE;
        }
        let (picture, _) = deciding(gpu, &scene, &plan, LightSets::Facing);
        (picture, set_count(gpu, &scene, &plan, &topology))
    });
    let [(with, bounded), (without, whole)] = &counts;
    assert!(plan.sets[0].frustum.is_bounded == 1);
    assert!(with == without);
    assert!(2 * bounded < *whole, "{bounded} {whole}");
}

/// The number of triangles in the camera's set, with the sides that the GPU decides.
fn set_count(gpu: &Gpu, scene: &Scene, plan: &Plan, topology: &Topology) -> usize {
    let mut decisions = done(gpu::Decisions::new(gpu, topology));
    let uploaded = done(gpu::Mesh::upload(gpu, &scene.mesh));
    let components = done(gpu::Components::upload(gpu, topology.components()));
    let mut builder = Builder::new(BuildConfig::default());
    let (mut facing, mut bvh) = (TargetSides::new(), gpu::Bvh::new());
    let mut frame = gpu.frame();
    done(builder.sort(&mut frame, &uploaded));
    done(decisions.measure(&mut frame, &builder, &uploaded));
    let aim = &plan.sets[0];
    done(facing.decide(
        &mut frame,
        &decisions,
        (&aim.target, &aim.frustum),
        Answer::Facing,
    ));
    let subset = gpu::Subset::Of {
        components: &components,
        sides: &facing,
    };
    done(builder.build_sorted(&mut frame, &uploaded, subset, &mut bvh));
    done(frame.submit());
    done(bvh.download(gpu)).triangle_count()
}

/// A picture with the sides that the host decides.
fn planned(gpu: &Gpu, scene: &Scene, plan: &Plan) -> Picture {
    frame(gpu, scene, plan, Change::Scene).0
}

/// The scenes of the plans, and one in which the smaller set is L−.
fn all_scenes() -> Vec<(&'static str, Scene)> {
    let mut all = scenes();
    let mut mesh = dome(40);
    for part in [
        placed(dome(30), 0.5, Vec3::new(1.6, 0.2, 0.4)),
        placed(unwelded(&dome(50)), 0.7, Vec3::new(-1.8, -0.3, 0.2)),
    ] {
        append(&mut mesh, part, "dome", 0);
    }
    mesh.normals.clear();
    let like = all.iter().find(|(name, _)| *name == "cavity");
    let (_, like) = like.expect("it is there").clone();
    let lights = vec![SUN, like.lights[1]];
    all.push((
        "domes",
        Scene {
            mesh,
            lights,
            ..like
        },
    ));
    all
}

#[test]
fn pictures_by_decided_sides_are_those_of_the_rule() {
    let Some(gpu) = gpu() else { return };
    let (mut equal_count, mut minus_count) = (0, 0);
    for (name, scene) in all_scenes() {
        let topology = surveyed(&scene.mesh);
        let [whole, reduced] = [Reduce::Off, Reduce::On].map(|how| plan(&scene, &topology, how));
        assert!(reduced.sets.iter().any(|aim| aim.choice == TreeChoice::Set));
        let mut pictures = Vec::new();
        for lights in [LightSets::Facing, LightSets::Smaller] {
            let (expected, report) = deciding(gpu, &scene, &whole, lights);
            let (picture, again) = deciding(gpu, &scene, &reduced, lights);
            assert!(picture == expected, "{name}");
            assert_eq!(report.targets, again.targets, "{name}");
            pictures.push((picture, report));
        }

        // With equal decisions of the host the pictures are equal.
        let used = reduced
            .sets
            .iter()
            .filter(|aim| aim.choice != TreeChoice::Unused);
        let host: Vec<&Vec<i32>> = used.map(|aim| &aim.sides).collect();
        let same_as_host = |report: &DecisionsReport| {
            host.iter()
                .zip(&report.targets)
                .all(|(host, (_, of))| **host == of.sides)
        };
        let by_host = planned(gpu, &scene, &reduced);
        if same_as_host(&pictures[0].1) {
            equal_count += 1;
            assert!(pictures[0].0 == by_host, "{name}");
        }

        // L− gives the same shadows, except for rays within rounding of a silhouette.
        let (smaller, report) = &pictures[1];
        let counts = report
            .targets
            .iter()
            .filter_map(|(_, decided)| decided.counts);
        minus_count += counts.filter(|counts| counts.is_minus == 1).count();
        let pixels = smaller.pixels.iter().zip(&pictures[0].0.pixels);
        let differing = pixels.filter(|(a, b)| a != b).count();
        assert!(
            differing * 1000 <= 3 * smaller.pixels.len(),
            "{name}: {differing}"
        );
        assert!(report.explain().len() > report.targets.len(), "{name}");
    }
    assert!(
        equal_count >= 8 && minus_count >= 2,
        "{equal_count} {minus_count}"
    );
}

/// The negative control: with an eye that is not outside, L− changes the picture.
#[test]
fn sides_that_are_wrong_give_another_picture() {
    let Some(gpu) = gpu() else { return };
    let (_, scene) = all_scenes().pop().expect("there are scenes");
    let topology = surveyed(&scene.mesh);
    let reduced = plan(&scene, &topology, Reduce::On);
    let (expected, _) = deciding(gpu, &scene, &reduced, LightSets::Facing);
    // A plan of the host with the camera's sides negated.
    let mut wrong = reduced.clone();
    for side in &mut wrong.sets[0].sides {
        *side = -*side;
    }
    assert!(planned(gpu, &scene, &wrong) != expected);
    // If the GPU decides, a plan's sides do not matter.
    let (picture, _) = deciding(gpu, &scene, &wrong, LightSets::Facing);
    assert!(picture == expected);
}
