//! Rejecting triangles is right: the tracer's answers under the rule are compared with exact answers over all triangles without
//! culling. Each ray that differs is listed, and rounding must explain it.

mod close_ups;
mod difference;
mod distance;
mod subject;
mod surroundings;
mod wave;

use crate::reduced_scenes::scenes::{SUN, room, scenes};
use difference::Difference;
use rayon::prelude::*;
use slimbvh::reduce::Reduce;
use slimbvh::{RenderSettings, Scene};
use subject::{Rule, Subject, Tally};
use wave::RayKind;

const SETTINGS: RenderSettings = RenderSettings {
    size: [128, 80],
    sample_count: 1,
    view: slimbvh::View::Color,
    mirror_depth: 2,
    dark_rays: false,
};

/// Sizes of pictures for negative controls.
const SMALL: RenderSettings = RenderSettings {
    size: [48, 32],
    ..SETTINGS
};

/// Sizes of close-ups.
const CLOSE: RenderSettings = RenderSettings {
    size: [12, 12],
    ..SETTINGS
};

/// The outcome of some rays: a summary line, and a line for each ray that differs.
fn told(name: &str, rule: Rule, tally: &Tally) -> String {
    let Tally {
        ray_count,
        shadow_ray_count: _,
        tie_count,
        neighbor_count,
        ref differences,
    } = *tally;
    let farthest = differences
        .iter()
        .map(Difference::nearest)
        .fold(0.0, f64::max);
    let count = differences.len();
    let mut text = format!(
        "{name}, {rule:?}: {ray_count} rays, {tie_count} ties, {neighbor_count} neighbors, {count} differ, at most {farthest:.3} d away\n"
    );
    for difference in differences {
        let mark = if difference.is_explained() {
            ""
        } else {
            "NOT EXPLAINED "
        };
        text += &format!("  {mark}{difference}\n");
    }
    text
}

/// Compares the rays of the selected scenes under a rule, of whole pictures and of close-ups. Returns the numbers of scenes and
/// of differences.
fn compare_scenes(rule: Rule, is_wanted: impl Fn(&Subject) -> bool + Sync) -> [usize; 2] {
    let compare = |(name, scene)| {
        let mut subject = Subject::new(scene);
        if !is_wanted(&subject) {
            return None;
        }
        // A larger scene has fewer close-ups.
        let close_up_count = if subject.scene.mesh.indices.len() > 50_000 {
            3
        } else {
            12
        };
        let close_ups = subject.close_ups(&CLOSE, close_up_count);
        assert!(close_ups.len() >= close_up_count, "{name}");
        let mut tally = subject.compare(&SETTINGS, rule);
        tally.add(subject.compare_all(&close_ups, &CLOSE, rule));
        Some((name, tally))
    };
    let tallies: Vec<_> = scenes().into_par_iter().filter_map(compare).collect();
    let mut faults = Vec::new();
    for (name, tally) in &tallies {
        print!("{}", told(name, rule, tally));
        faults.extend(tally.unexplained().map(|fault| format!("{name}: {fault}")));
    }
    assert!(
        faults.is_empty(),
        "rounding does not explain:\n{}",
        faults.join("\n")
    );
    let differences = tallies.iter().map(|(_, tally)| tally.differences.len());
    [tallies.len(), differences.sum()]
}

#[test]
fn what_the_rule_rejects_is_never_missed() {
    let [_, difference_count] = compare_scenes(Rule::Plan, |_| true);
    assert!(difference_count > 0, "the close-ups are not close enough");
}

/// A shadow ray from outside to a light outside enters a closed surface as often as it leaves it.
#[test]
fn what_faces_a_light_is_never_missed_if_all_is_outside() {
    let [scene_count, _] = compare_scenes(Rule::AwayFromLights, Subject::is_all_outside);
    assert!(scene_count > 10, "{scene_count}");
}

/// The number of rays under a rule whose differences rounding does not explain, for the camera and for lights.
fn faults(scene: Scene, rule: Rule) -> [usize; 2] {
    let subject = Subject::new(scene);
    let tally = subject.compare(&SMALL, rule);
    let is_camera = |fault: &&Difference| fault.kind() == RayKind::Camera;
    let camera = tally.unexplained().filter(is_camera).count();
    [camera, tally.unexplained().count() - camera]
}

fn scene(name: &str) -> Scene {
    let scene = scenes().into_iter().find(|scene| scene.0 == name);
    scene
        .unwrap_or_else(|| panic!("there is no scene {name:?}"))
        .1
}

/// The negative control: with negated sides most rays at closed surfaces are wrong, and rounding does not explain it.
#[test]
fn turned_sides_are_found_out() {
    for (name, scene) in scenes() {
        // Skipped, as its many triangles take long.
        if name == "default scene" {
            continue;
        }
        let [camera, lights] = faults(scene, Rule::Turned);
        println!("{name}: {camera} camera rays and {lights} shadow rays are wrong");
        assert!(camera + lights > 20, "{name}");
    }
}

/// The negative control: without the check that the eye and the lights are outside, hits are lost.
#[test]
fn an_eye_or_a_lamp_inside_is_found_out() {
    for (name, in_camera, in_lights) in [
        ("eye inside", true, false),
        ("eye just inside", true, false),
        ("inside a cavity", true, true),
        ("light inside", false, true),
        ("room", true, false),
    ] {
        let [camera, lights] = faults(scene(name), Rule::AsIfOutside);
        println!("{name}: {camera} camera rays and {lights} shadow rays are wrong");
        assert_eq!([camera > 20, lights > 20], [in_camera, in_lights], "{name}");
        assert_eq!(faults(scene(name), Rule::Plan), [0; 2]);
    }
}

/// In a closed room with a sun outside every shadow ray leaves once more than it enters: L− does not block the sun.
#[test]
fn what_faces_away_from_a_light_does_not_darken_a_room() {
    let room = Subject::new(room(SUN));
    assert!(!room.is_all_outside());
    let tally = room.compare(&SMALL, Rule::AwayFromLights);
    let lit = tally
        .unexplained()
        .filter(|fault| fault.is_lit_wrongly())
        .count();
    println!(
        "{lit} of {} shadow rays reach the sun through a wall",
        tally.shadow_ray_count
    );
    assert!(lit > tally.shadow_ray_count / 2);
    assert_eq!(room.compare(&SMALL, Rule::Plan).unexplained().count(), 0);
}

/// With sets each ray has the same hit, to the last bit.
#[test]
fn sets_answer_as_the_rule_does() {
    for (_, scene) in scenes() {
        let subject = Subject::new(scene);
        let [whole, sets] = [Reduce::Off, Reduce::On].map(|reduce| {
            let plan = subject.plan(&SMALL, reduce, Rule::Plan);
            subject.cast(&SMALL, &plan)
        });
        assert!(whole == sets);
    }
}
