//! Plans for awkward scenes: reduced trees give the picture of the whole tree with the rule, byte for byte, on both
//! backends, and the rule loses nothing but rays within rounding of a silhouette.

mod awkward;
pub mod scenes;

use scenes::{SUN, ball, lights, room, scenes};
use slimbvh::gpu;
use slimbvh::reduce::{
    self, Asked, Choice, Cull, Hierarchies, Plan, Reduce, Saving, Savings, Seams, Switches, survey,
};
use slimbvh::topology::Topology;
use slimbvh::{BuildConfig, Builder, Light, Picture, RenderSettings, Renderer, Scene, Turns};
use slimbvh_tests::gpu::{done, gpu};

const SETTINGS: RenderSettings = RenderSettings {
    size: [96, 64],
    sample_count: 1,
    view: slimbvh::View::Color,
    mirror_depth: 2,
    dark_rays: false,
};

/// Pixels of a thousand that may differ from a picture without the rule.
const PER_MILLE: usize = 3;

fn asked<'a>(scene: &'a Scene, cull: Cull, reduce: Reduce) -> Asked<'a> {
    Asked {
        scene,
        settings: &SETTINGS,
        switches: Switches {
            cull: Some(cull),
            reduce,
            seams: Seams::Find,
            savings: Savings::ALL,
        },
        frame_count: 1,
    }
}

fn topology(scene: &Scene) -> Topology {
    done(survey(&scene.mesh, BuildConfig::default(), Seams::Find)).topology
}

/// The plans for a whole tree with the rule, for sets, and for what is cheaper.
fn plans<'a>(scene: &Scene, topology: &'a Topology) -> [Plan<'a>; 3] {
    [Reduce::Off, Reduce::On, Reduce::Auto]
        .map(|reduce| done(Plan::new(topology, &asked(scene, Cull::On, reduce))))
}

fn plain(scene: &Scene) -> Plan<'static> {
    let plan = done(Plan::without_survey(&asked(scene, Cull::Off, Reduce::Off)));
    plan.unwrap_or_else(|| panic!("nothing is to be left out"))
}

fn on_cpu(scene: &Scene, plan: &Plan) -> Picture {
    let mut builder = Builder::new(BuildConfig::default());
    let mut hierarchies = Hierarchies::new();
    done(hierarchies.build(&mut builder, &scene.mesh, plan));
    let (trees, mut turns) = hierarchies.split(&mut builder, &scene.mesh, plan);
    let mut picture = Picture::default();
    let both: (_, &mut dyn Turns) = (&trees, &mut turns);
    let render = Renderer::new().render_in_turn(scene, both, &SETTINGS, &mut picture, |_| {});
    done(render);
    picture
}

fn on_gpu(gpu: &gpu::Gpu, scene: &Scene, plan: &Plan) -> Picture {
    let mut picture = Picture::default();
    let mut renderer = reduce::gpu::ImageRenderer::new(BuildConfig::default());
    done(renderer.render(gpu, (scene, plan), &SETTINGS, &mut picture, |_| {}));
    picture
}

/// Checks every scene with one backend.
fn check(backend: &str, picture: impl Fn(&Scene, &Plan) -> Picture) {
    for (name, scene) in scenes() {
        let topology = topology(&scene);
        let [whole, reduced, auto] = plans(&scene, &topology);
        assert!(whole.aims.iter().all(|aim| aim.choice == Choice::Whole));
        assert!(reduced.aims.iter().any(|aim| aim.choice == Choice::Set));
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

/// Whatever is saved, and whatever is not, the picture of the rule stays as it is: what is left out of a set for being out
/// of the picture, which trees are sorted how, and which lights come together for which half.
#[test]
fn each_saving_leaves_the_picture_as_it_is() {
    for (name, scene) in scenes() {
        let topology = topology(&scene);
        for left_out in Saving::ALL {
            let [whole, reduced] = [Reduce::Off, Reduce::On].map(|reduce| {
                let mut asked = asked(&scene, Cull::On, reduce);
                asked.switches.savings = Savings::ALL.without(left_out);
                on_cpu(&scene, &done(Plan::new(&topology, &asked)))
            });
            assert!(reduced == whole, "{name} without {left_out:?}");
        }
    }
}

/// Sets of lights are built in turn, one for lights that share it, and for a light that reaches nothing none, or on a GPU,
/// which cannot know before, one over nothing.
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
        done(Plan::new(&topology, &asked))
    };
    let [usual, careless, held] = [&[][..], &[Saving::Unseen], &[Saving::Turns]].map(plan);
    assert!(usual.in_turn && careless.in_turn && !held.in_turn);
    let place = usual.aim_of_light()[last];
    assert_eq!(usual.aims[place].lights, [last]);
    let all: Vec<usize> = (1..usual.aims.len()).collect();
    let needed: Vec<usize> = all.iter().copied().filter(|aim| *aim != place).collect();

    let expected = on_cpu(&scene, &held);
    let mut held_bytes = Vec::new();
    for (plan, built) in [(&usual, needed), (&careless, all.clone()), (&held, vec![])] {
        let mut builder = Builder::new(BuildConfig::default());
        let mut hierarchies = Hierarchies::new();
        done(hierarchies.build(&mut builder, &scene.mesh, plan));
        let (trees, mut turns) = hierarchies.split(&mut builder, &scene.mesh, plan);
        let mut picture = Picture::default();
        let both: (_, &mut dyn Turns) = (&trees, &mut turns);
        done(Renderer::new().render_in_turn(&scene, both, &SETTINGS, &mut picture, |_| {}));
        let sets = turns.done().sets;
        assert_eq!(sets.iter().map(|set| set.0).collect::<Vec<_>>(), built);
        assert!(picture == expected);
        held_bytes.push(hierarchies.bytes());
    }
    assert!(held_bytes[0] * 2 < held_bytes[2], "{held_bytes:?}");

    let Some(gpu) = gpu() else { return };
    let expected = on_gpu(gpu, &scene, &held);
    for plan in [&usual, &careless] {
        let mut renderer = reduce::gpu::ImageRenderer::new(BuildConfig::default());
        let mut picture = Picture::default();
        done(renderer.render(gpu, (&scene, plan), &SETTINGS, &mut picture, |_| {}));
        assert!(picture == expected);
        let built = renderer.built_in_turn.iter();
        assert!(
            built
                .clone()
                .map(|(place, _)| *place)
                .eq(all.iter().copied())
        );
        for (aim, count) in built {
            let is_over_nothing = *aim == place && std::ptr::eq(plan, &usual);
            assert_eq!(*count == 0, is_over_nothing, "{aim}");
        }
    }
}

/// The control: with sides turned round, for the camera or for a light, the picture is another.
#[test]
fn wrong_sides_give_another_picture() {
    for (name, scene) in scenes() {
        let topology = topology(&scene);
        let [whole, mut reduced, _] = plans(&scene, &topology);
        let expected = on_cpu(&scene, &whole);
        for aim in &mut reduced.aims {
            for side in &mut aim.sides {
                *side = -*side;
            }
        }
        assert!(on_cpu(&scene, &reduced) != expected, "{name}");
    }
}

/// A closed room under a sun outside, seen from inside, is as dark as under no sun.
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
    // The walls are what keeps it out.
    let open = Scene {
        mesh: ball([0.0; 3], 0.6),
        ..room(SUN)
    };
    assert!(on_cpu(&open, &plain(&open)) != dark);
}
