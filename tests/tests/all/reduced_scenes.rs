//! Plans for awkward scenes: reduced trees give the picture of the whole tree with the rule, byte for byte, on both
//! backends, and the rule changes only rays within rounding of a silhouette.

mod awkward;
pub mod scenes;

use scenes::{SUN, ball, lights, room, scenes};
use slimbvh::gpu;
use slimbvh::reduce::{
    Cull, Plan, PlanRequest, Reduce, Saving, Savings, Seams, Switches, TreeChoice, survey,
};
use slimbvh::topology::Topology;
use slimbvh::{
    Backend, BuildConfig, Change, Cpu, FrameConfig, FrameReport, FrameRequest, Frames, Light,
    Output, Picture, RenderSettings, Scene,
};
use slimbvh_tests::gpu::{done, gpu};
use std::sync::Arc;

const SETTINGS: RenderSettings = RenderSettings {
    size: [96, 64],
    sample_count: 1,
    view: slimbvh::View::Color,
    mirror_depth: 2,
    dark_rays: false,
};

/// Pixels in a thousand that may differ from a picture without the rule.
const PER_MILLE: usize = 3;

fn asked(scene: &Scene, cull: Cull, reduce: Reduce) -> PlanRequest {
    let switches = Switches {
        cull: Some(cull),
        reduce,
        seams: Seams::Find,
        savings: Savings::ALL,
    };
    done(PlanRequest::of_picture(scene, &SETTINGS, switches))
}

fn topology(scene: &Scene) -> Arc<Topology> {
    done(survey(&scene.mesh, BuildConfig::default(), Seams::Find)).topology
}

/// The plans: a whole tree with the rule, sets, and the cheaper choice.
fn plans(scene: &Scene, topology: &Arc<Topology>) -> [Plan; 3] {
    [Reduce::Off, Reduce::On, Reduce::Auto]
        .map(|reduce| Plan::new(topology, &scene.mesh, &asked(scene, Cull::On, reduce)))
}

fn plain(scene: &Scene) -> Plan {
    let plan = Plan::without_survey(&asked(scene, Cull::Off, Reduce::Off));
    plan.unwrap_or_else(|| panic!("nothing is to be left out"))
}

/// A frame of a plan, with the state that made it.
fn frame<B: Backend>(
    backend: B,
    scene: &Scene,
    plan: &Plan,
) -> (Frames<B>, FrameReport<B>, Picture) {
    let mut frames = Frames::new(backend, FrameConfig::default());
    let mut picture = Picture::default();
    let request = FrameRequest {
        scene,
        plan,
        settings: &SETTINGS,
        change: Change::Scene,
    };
    let report = done(frames.render_planned(&request, Output::new(&mut picture)));
    (frames, report, picture)
}

fn on_cpu(scene: &Scene, plan: &Plan) -> Picture {
    frame(Cpu, scene, plan).2
}

fn on_gpu(gpu: &gpu::Gpu, scene: &Scene, plan: &Plan) -> Picture {
    frame(gpu, scene, plan).2
}

/// Checks every scene on one backend.
fn check(backend: &str, picture: impl Fn(&Scene, &Plan) -> Picture) {
    for (name, scene) in scenes() {
        let topology = topology(&scene);
        let [whole, reduced, auto] = plans(&scene, &topology);
        assert!(whole.sets.iter().all(|aim| aim.choice == TreeChoice::Whole));
        assert!(reduced.sets.iter().any(|aim| aim.choice == TreeChoice::Set));
        let expected = picture(&scene, &whole);
        assert!(picture(&scene, &reduced) == expected, "{name}");
        assert!(picture(&scene, &auto) == expected, "{name}");

        let without_rule = picture(&scene, &plain(&scene));
        let both = || expected.pixels.iter().zip(&without_rule.pixels).enumerate();
        let differ: Vec<_> = both().filter(|(_, (a, b))| a != b).collect();
        println!(
            "{backend}, {name}: {} of {} pixels differ from all that counts",
            differ.len(),
            expected.pixels.len()
        );
        for (place, (with, without)) in &differ {
            let [x, y] = [
                place % SETTINGS.size[0] as usize,
                place / SETTINGS.size[0] as usize,
            ];
            println!("  ({x}, {y}): {with:?}, without the rule {without:?}");
        }
        assert!(
            differ.len() <= expected.pixels.len() * PER_MILLE / 1000,
            "{name}"
        );
    }
}

#[test]
fn sets_give_the_picture_of_the_rule() {
    check("CPU", on_cpu);
}

#[test]
fn sets_give_the_picture_of_the_rule_on_the_gpu() {
    let Some(gpu) = gpu() else { return };
    check("GPU", |scene, plan| on_gpu(gpu, scene, plan));
}

/// No saving changes the picture of the rule: neither leaving out what is outside of the picture, nor the way to sort trees,
/// nor the grouping of lights, nor L−.
#[test]
fn each_saving_leaves_the_picture_as_it_is() {
    for (name, scene) in scenes() {
        let topology = topology(&scene);
        for left_out in Saving::ALL {
            let [whole, reduced] = [Reduce::Off, Reduce::On].map(|reduce| {
                let mut asked = asked(&scene, Cull::On, reduce);
                asked.switches.savings = Savings::ALL.without(left_out);
                on_cpu(&scene, &Plan::new(&topology, &scene.mesh, &asked))
            });
            assert!(reduced == whole, "{name} without {left_out:?}");
        }
    }
}

/// Sets of lights are built in turn, one for lights that share it. A light that reaches nothing gets no set, or on a GPU,
/// which cannot know it in advance, an empty one.
#[test]
fn sets_in_turn_are_built_once_and_only_where_needed() {
    let mut scene = lights();
    let far_away = Light::Point {
        position: [0.0, -90.0, 0.0],
        color: [1.0; 3],
        range: 1.0,
    };
    scene.lights.push(far_away);
    let last = scene.lights.len() - 1;
    let topology = topology(&scene);
    let plan = |left_out: &[Saving]| {
        let mut asked = asked(&scene, Cull::On, Reduce::On);
        let savings = left_out.iter().copied();
        asked.switches.savings = savings.fold(Savings::ALL, Savings::without);
        Plan::new(&topology, &scene.mesh, &asked)
    };
    let [usual, careless, held] = [&[][..], &[Saving::Unseen], &[Saving::Turns]].map(plan);
    assert!(usual.defers_lights && careless.defers_lights && !held.defers_lights);
    let place = usual.set_of_target()[last + 1].expect("a light has a set");
    assert_eq!(usual.sets[place].targets, [last + 1]);
    let all: Vec<usize> = (1..usual.sets.len()).collect();
    let needed: Vec<usize> = all.iter().copied().filter(|aim| *aim != place).collect();

    let expected = on_cpu(&scene, &held);
    let mut held_bytes = Vec::new();
    for (plan, built) in [(&usual, needed), (&careless, all.clone()), (&held, vec![])] {
        let (frames, report, picture) = frame(Cpu, &scene, plan);
        let sets = report.deferred;
        assert_eq!(sets.iter().map(|set| set.0).collect::<Vec<_>>(), built);
        assert!(picture == expected);
        held_bytes.push(frames.views().hierarchies().held_bytes());
    }
    assert!(held_bytes[0] * 2 < held_bytes[2], "{held_bytes:?}");

    let Some(gpu) = gpu() else { return };
    let expected = on_gpu(gpu, &scene, &held);
    for plan in [&usual, &careless] {
        let (_, report, picture) = frame(gpu, &scene, plan);
        assert!(picture == expected);
        let built = report.deferred.iter();
        assert!(
            built
                .clone()
                .map(|(place, _)| *place)
                .eq(all.iter().copied())
        );
        for (aim, size) in built {
            let is_over_nothing = *aim == place && std::ptr::eq(plan, &usual);
            assert_eq!(size.triangle_count == 0, is_over_nothing, "{aim}");
        }
    }
}

/// The negative control: with negated sides, for the camera or for a light, the picture changes.
#[test]
fn wrong_sides_give_another_picture() {
    for (name, scene) in scenes() {
        let topology = topology(&scene);
        let [whole, mut reduced, _] = plans(&scene, &topology);
        let expected = on_cpu(&scene, &whole);
        for aim in &mut reduced.sets {
            for side in &mut aim.sides {
                *side = -*side;
            }
        }
        assert!(on_cpu(&scene, &reduced) != expected, "{name}");
    }
}

/// A closed room with a sun outside, seen from inside, is as dark as without a sun.
#[test]
fn no_sun_shines_into_a_closed_room() {
    let lit = room(SUN);
    let dark = on_cpu(
        &room(Light::Directional {
            direction: [0.0, -1.0, 0.0],
            color: [0.0; 3],
        }),
        &plain(&lit),
    );
    let topology = topology(&lit);
    for plan in plans(&lit, &topology) {
        assert!(on_cpu(&lit, &plan) == dark);
        if let Some(gpu) = gpu() {
            let brightest = |picture: &Picture| {
                let values = picture.pixels.iter().flatten();
                values.fold(0.0, |most: f32, &value| most.max(value))
            };
            let brightest = brightest(&on_gpu(gpu, &lit, &plan)) / brightest(&dark);
            assert!((0.999..1.001).contains(&brightest));
        }
    }
    // The walls block the sun.
    let open = Scene {
        mesh: ball([0.0; 3], 0.6),
        ..room(SUN)
    };
    assert!(on_cpu(&open, &plain(&open)) != dark);
}
