//! The decisions of plans, and their explanations.

use glam::Vec3;
use slimbvh::generate::{append, ground, icosphere};
use slimbvh::reduce::{
    Cull, FacingSet, Plan, PlanRequest, Reduce, Saving, Savings, Seams, Switches, TargetKind,
    TreeChoice, survey,
};
use slimbvh::{
    BuildConfig, Camera, Light, Material, Mesh, Projection, RenderSettings, Scene, View,
};
use slimbvh_tests::gpu::done;
use std::f32::consts::{FRAC_PI_2, PI};

fn camera() -> Camera {
    Camera {
        eye: [0.0, 0.5, 4.0],
        target: [0.0; 3],
        up: [0.0, 1.0, 0.0],
        projection: Projection::Perspective { vertical_fov: 40.0 },
    }
}

fn sun(color: [f32; 3]) -> Light {
    Light::Directional {
        direction: [-1.0, -2.0, -1.5],
        color,
    }
}

fn lamp(position: [f32; 3]) -> Light {
    Light::Point {
        position,
        color: [5.0; 3],
        range: f32::INFINITY,
    }
}

fn scene(mesh: Mesh, lights: &[Light]) -> Scene {
    Scene {
        mesh,
        cameras: vec![camera()],
        lights: lights.to_vec(),
        ..Scene::default()
    }
}

fn ball() -> Mesh {
    icosphere(Vec3::ZERO, 1.0, 5)
}

fn switches(cull: Option<Cull>, reduce: Reduce) -> Switches {
    Switches {
        cull,
        reduce,
        seams: Seams::Find,
        savings: Savings::ALL,
    }
}

fn asked(
    scene: &Scene,
    settings: &RenderSettings,
    switches: Switches,
    frame_count: u32,
) -> PlanRequest {
    PlanRequest {
        frame_count,
        ..done(PlanRequest::of_picture(scene, settings, switches))
    }
}

/// The plan's choice for the camera and each light, and whether the whole tree is built.
fn decided(mesh: &Mesh, asked: &PlanRequest) -> (Vec<TreeChoice>, bool, String) {
    let survey = done(survey(mesh, BuildConfig::default(), asked.switches.seams));
    let plan = Plan::new(&survey.topology, mesh, asked);
    let said = plan.explain().into_iter();
    let said: Vec<String> = said
        .map(|(about, text)| format!("{about}: {text}"))
        .collect();
    println!("{}\n", said.join("\n"));
    let choices = plan.sets.iter().map(|aim| aim.choice).collect();
    (choices, plan.needs_whole, said.join("\n"))
}

#[test]
fn surveys_are_made_where_asked_for_or_worth_it() {
    let scene = scene(ball(), &[sun([1.0; 3])]);
    let settings = RenderSettings::default();
    let needs_survey = |cull, reduce, frame_count| {
        let asked = asked(&scene, &settings, switches(cull, reduce), frame_count);
        Plan::without_survey(&asked).is_none()
    };
    use Cull::{Off as All, On as Facing};
    use Reduce::{Auto, Off, On};
    for (cull, reduce, one_frame, many_frames) in [
        (None, Auto, false, true),
        (None, On, true, true),
        (None, Off, false, false),
        (Some(Facing), Auto, true, true),
        (Some(Facing), On, true, true),
        (Some(Facing), Off, true, true),
        (Some(All), Auto, false, false),
        (Some(All), Off, false, false),
    ] {
        assert_eq!(
            needs_survey(cull, reduce, 1),
            one_frame,
            "{cull:?} {reduce:?}"
        );
        assert_eq!(
            needs_survey(cull, reduce, 10_000),
            many_frames,
            "{cull:?} {reduce:?}"
        );
    }
    assert!(switches(Some(All), On).is_contradiction());
}

#[test]
fn declining_says_why_with_figures() {
    let scene = scene(ball(), &[]);
    let settings = RenderSettings::default();
    let asked = asked(&scene, &settings, Switches::default(), 1);
    let Some(plan) = Plan::without_survey(&asked) else {
        panic!("one frame cannot pay for a survey");
    };
    assert!(plan.is_plain() && plan.needs_whole);
    let lines = plan.explain();
    assert_eq!(lines[0].0, "nothing");
    let is_figure = |word: &&str| word.parse::<f64>().is_ok();
    let words = lines[0].1.split(' ');
    let sentence: Vec<&str> = words
        .map(|it| if is_figure(&it) { "_" } else { it })
        .collect();
    assert_eq!(
        sentence.join(" "),
        "is left out: a survey of the surfaces takes about _ ms, at most _ ms, and must save more than _ ms; it is expected to save at most _ ms in one frame"
    );
}

#[test]
fn rays_that_do_not_exist_get_no_tree() {
    let scene = scene(ball(), &[sun([0.0; 3]), sun([1.0; 3])]);
    let on = switches(None, Reduce::On);
    for (view, second) in [
        (View::Color, TreeChoice::Set),
        (View::Normals, TreeChoice::Unused),
        (View::Depth, TreeChoice::Unused),
    ] {
        let settings = RenderSettings {
            view,
            ..RenderSettings::default()
        };
        let (choices, needs_whole, said) = decided(&scene.mesh, &asked(&scene, &settings, on, 1));
        assert_eq!(choices, [TreeChoice::Set, TreeChoice::Unused, second]);
        assert!(!needs_whole && said.contains("light 1: no rays, no tree"));
        assert!(said.contains("whole tree: is not built: no rays need it"));
    }
}

#[test]
fn the_whole_tree_is_built_for_what_needs_it() {
    let settings = RenderSettings::default();
    let on = switches(None, Reduce::On);
    // A lamp inside of a component.
    let inside = scene(ball(), &[lamp([0.1, 0.2, 0.0])]);
    let (choices, needs_whole, said) = decided(&inside.mesh, &asked(&inside, &settings, on, 1));
    assert_eq!(
        (choices, needs_whole),
        (vec![TreeChoice::Set, TreeChoice::Whole], true)
    );
    assert!(said.contains("possibly inside 1 closed component, which stays whole"));
    assert!(said.contains("whole tree: is built, for light 1"));
    // With a mirror.
    let mut mirror = scene(ball(), &[]);
    mirror.materials = vec![Material {
        mirror: 0.5,
        ..Material::default()
    }];
    let (choices, needs_whole, said) = decided(&mirror.mesh, &asked(&mirror, &settings, on, 1));
    assert_eq!((choices, needs_whole), (vec![TreeChoice::Set], true));
    assert!(said.contains("whole tree: is built, for mirrors and glass"));
    // With glass, where paths start inside of components.
    let mut glass = mirror.clone();
    glass.materials = vec![Material {
        transmission: 0.5,
        ..Material::default()
    }];
    assert!(decided(&glass.mesh, &asked(&glass, &settings, on, 1)).1);
    let settings = RenderSettings {
        mirror_depth: 0,
        ..settings
    };
    assert!(!decided(&mirror.mesh, &asked(&mirror, &settings, on, 1)).1);
    // No closed component, and an empty mesh.
    for mesh in [ground(2.0, 4), Mesh::default()] {
        let open = scene(mesh, &[lamp([0.0, 3.0, 0.0])]);
        let (choices, needs_whole, _) = decided(&open.mesh, &asked(&open, &settings, on, 1));
        assert_eq!((choices, needs_whole), (vec![TreeChoice::Whole; 2], true));
    }
}

/// One set without a whole tree is always less work; a set beside a whole tree pays only for many rays.
#[test]
fn auto_takes_what_is_cheaper() {
    let auto = switches(Some(Cull::On), Reduce::Auto);
    let tiny = RenderSettings {
        size: [16, 16],
        ..RenderSettings::default()
    };
    let alone = scene(ball(), &[]);
    let (choices, needs_whole, _) = decided(&alone.mesh, &asked(&alone, &tiny, auto, 1));
    assert_eq!((choices, needs_whole), (vec![TreeChoice::Set], false));
    let lit = scene(ball(), &[lamp([0.1, 0.2, 0.0])]);
    let (choices, needs_whole, said) = decided(&lit.mesh, &asked(&lit, &tiny, auto, 1));
    assert_eq!((choices, needs_whole), (vec![TreeChoice::Whole; 2], true));
    assert!(said.contains("more than it saves"), "{said}");
}

/// The lights of each target except the camera, by number from 0.
fn groups(plan: &Plan) -> Vec<Vec<usize>> {
    let lights = plan.sets.iter().skip(1);
    lights
        .map(|aim| aim.targets.iter().map(|target| target - 1).collect())
        .collect()
}

#[test]
fn close_lights_share_a_set_and_lights_on_either_side_do_not() {
    let settings = RenderSettings::default();
    let on = switches(None, Reduce::On);
    let square_of = |step: f32| -> Vec<Light> {
        let place = |i: usize| (i as f32 - 1.0) * step;
        let lamp = |i: usize| lamp([place(i % 3), 3.0, place(i / 3)]);
        (0..9).map(lamp).collect()
    };
    let square = scene(icosphere(Vec3::ZERO, 1.0, 6), &square_of(0.02));
    let loose = scene(icosphere(Vec3::ZERO, 1.0, 6), &square_of(0.5));
    let sides = scene(ball(), &[lamp([-3.0, 0.5, 0.0]), lamp([3.0, 0.0, 0.2])]);
    let suns = scene(ball(), &[sun([1.0; 3]), sun([2.0; 3])]);
    for (scene, expected) in [
        (&square, vec![(0..9).collect()]),
        (&loose, (0..9).map(|light| vec![light]).collect()),
        (&sides, vec![vec![0], vec![1]]),
        (&suns, vec![vec![0], vec![1]]),
    ] {
        let survey = done(survey(&scene.mesh, BuildConfig::default(), Seams::Find));
        for reduce in [Reduce::On, Reduce::Off, Reduce::Auto] {
            let switches = Switches { reduce, ..on };
            let asked = asked(scene, &settings, switches, 1);
            let plan = Plan::new(&survey.topology, &scene.mesh, &asked);
            assert_eq!(groups(&plan), expected, "{reduce:?}");
            let lights = 0..scene.lights.len();
            let places = lights.map(|light| {
                plan.sets
                    .iter()
                    .position(|aim| aim.targets.contains(&(light + 1)))
            });
            let camera = std::iter::once(Some(0));
            assert_eq!(
                plan.set_of_target(),
                camera.chain(places).collect::<Vec<_>>()
            );
        }
        let savings = Savings::ALL.without(Saving::Groups);
        let asked = asked(scene, &settings, Switches { savings, ..on }, 1);
        let plan = Plan::new(&survey.topology, &scene.mesh, &asked);
        assert_eq!(groups(&plan).len(), scene.lights.len());
    }
    let (_, _, said) = decided(&square.mesh, &asked(&square, &settings, on, 1));
    assert!(
        said.contains("lights 1 to 9: one set for all of them"),
        "{said}"
    );
}

/// A ball with nearly all of its triangles on the upper half.
fn fine_above() -> Mesh {
    const EQUATOR: f32 = 2.7;
    let mut mesh = ball();
    for vertex in &mut mesh.vertices {
        let angle = vertex[1].clamp(-1.0, 1.0).acos();
        let moved = if angle < EQUATOR {
            angle * FRAC_PI_2 / EQUATOR
        } else {
            FRAC_PI_2 + (angle - EQUATOR) * FRAC_PI_2 / (PI - EQUATOR)
        };
        let across = moved.sin() / angle.sin().max(1e-6);
        *vertex = [vertex[0] * across, moved.cos(), vertex[2] * across];
    }
    mesh
}

/// For few rays the smaller set costs less; for many rays L− does, as rays do not meet the surface that they leave. L− is
/// allowed only if the eye is outside as well, and if no mirror continues paths from other places.
#[test]
fn the_cheaper_half_counts_where_all_rays_start_outside() {
    let settings = RenderSettings {
        size: [16, 16],
        ..RenderSettings::default()
    };
    let on = switches(None, Reduce::On);
    let half = |scene: &Scene, switches: Switches| {
        let survey = done(survey(&scene.mesh, BuildConfig::default(), Seams::None));
        let asked = asked(scene, &settings, switches, 1);
        let plan = Plan::new(&survey.topology, &scene.mesh, &asked);
        (plan.sets[1].half, plan.sets[1].share)
    };
    let lit_along = |y: f32| {
        let direction = [0.0, y, 0.0];
        let color = [1.0; 3];
        scene(fine_above(), &[Light::Directional { direction, color }])
    };
    let above = lit_along(-1.0);
    for (scene, expected) in [
        (&above, FacingSet::Back),
        (&lit_along(1.0), FacingSet::Front),
    ] {
        let (half, share) = half(scene, on);
        assert!(half == expected && share < 0.1, "{half:?} {share}");
    }
    let many_rays = RenderSettings::default();
    let topology = done(survey(&above.mesh, BuildConfig::default(), Seams::None)).topology;
    for scene in [&above, &lit_along(1.0)] {
        let plan = Plan::new(&topology, &scene.mesh, &asked(scene, &many_rays, on, 1));
        assert_eq!(plan.sets[1].half, FacingSet::Back);
    }
    let savings = Savings::ALL.without(Saving::Away);
    let (kept, share) = half(&above, Switches { savings, ..on });
    assert!(kept == FacingSet::Front && share > 0.9, "{share}");
    let mut inside = above.clone();
    inside.cameras[0].eye = [0.0, 0.5, 0.0];
    assert_eq!(half(&inside, on).0, FacingSet::Front);
    let mut mirror = above;
    mirror.materials = vec![Material {
        mirror: 0.5,
        ..Material::default()
    }];
    assert_eq!(half(&mirror, on).0, FacingSet::Front);
    let mut glass = mirror;
    glass.materials[0].mirror = 0.0;
    glass.materials[0].transmission = 0.5;
    assert_eq!(half(&glass, on).0, FacingSet::Front);
}

#[test]
fn what_is_outside_the_picture_is_left_out_of_the_cameras_set() {
    let settings = RenderSettings::default();
    let on = switches(None, Reduce::On);
    let mut near = scene(ground(4.0, 64), &[]);
    near.cameras[0].eye = [0.0, 1.0, 0.5];
    near.cameras[0].target = [0.0, 0.0, -0.5];
    let (choices, needs_whole, said) = decided(&near.mesh, &asked(&near, &settings, on, 1));
    assert_eq!((choices, needs_whole), (vec![TreeChoice::Set], false));
    assert!(
        said.contains("leaves out triangles outside the picture"),
        "{said}"
    );
    let savings = Savings::ALL.without(Saving::Frustum);
    let (choices, ..) = decided(
        &near.mesh,
        &asked(&near, &settings, Switches { savings, ..on }, 1),
    );
    assert_eq!(choices, [TreeChoice::Whole]);
    // If the whole scene is in the picture, triangles are not tested against it.
    let mut far = near;
    far.cameras[0].eye = [0.0, 30.0, 30.0];
    assert_eq!(
        decided(&far.mesh, &asked(&far, &settings, on, 1)).0,
        [TreeChoice::Whole]
    );
}

#[test]
fn a_set_that_is_the_only_tree_is_sorted_alone() {
    let settings = RenderSettings::default();
    let on = switches(None, Reduce::On);
    let alone = scene(ball(), &[]);
    let lit = scene(ball(), &[sun([1.0; 3])]);
    let survey = done(survey(&alone.mesh, BuildConfig::default(), Seams::Find));
    let sorts_alone = |scene: &Scene, savings: Savings| {
        let switches = Switches { savings, ..on };
        let asked = asked(scene, &settings, switches, 1);
        Plan::new(&survey.topology, &scene.mesh, &asked).sorts_alone
    };
    assert!(sorts_alone(&alone, Savings::ALL));
    assert!(!sorts_alone(&lit, Savings::ALL));
    assert!(!sorts_alone(&alone, Savings::ALL.without(Saving::Alone)));
}

/// Shares are estimated from samples, and figures are of this mesh.
#[test]
fn surfaces_are_summed_up() {
    let mut mesh = ball();
    append(&mut mesh, ground(4.0, 8), "ground", 0);
    let scene = scene(mesh, &[]);
    let settings = RenderSettings::default();
    let survey = done(survey(&scene.mesh, BuildConfig::default(), Seams::None));
    assert!(survey.stages.iter().all(|(step, _)| step == "components"));
    let asked = asked(&scene, &settings, switches(None, Reduce::On), 1);
    let plan = Plan::new(&survey.topology, &scene.mesh, &asked);
    let aim = &plan.sets[0];
    assert_eq!((aim.kind, aim.reducible_count), (TargetKind::From, 20_480));
    assert!((0.35..0.5).contains(&aim.share), "{}", aim.share);
    let lines = plan.explain();
    assert_eq!(lines[0].1, "1 of 2 components, 20,480 triangles");
    assert_eq!(lines[1].1, "1 component, 128 triangles: not closed");
}
