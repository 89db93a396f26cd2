//! What a scene's file holds and its picture does not, and where its positions are.

use super::output;
use serde::Serialize;
use slimbvh::Scene;

/// Something left out, for `--json`.
#[derive(Debug, Serialize)]
pub struct LeftOutSummary {
    what: String,
    count: usize,
}

/// For `--json`.
pub fn left_out(scene: &Scene) -> Vec<LeftOutSummary> {
    let all = scene.left_out.iter();
    all.map(|left_out| LeftOutSummary {
        what: left_out.what.clone(),
        count: left_out.count,
    })
    .collect()
}

/// All that is left out, in words; `None` if nothing is.
pub fn left_out_words(scene: &Scene) -> Option<String> {
    let words: Vec<String> = scene.left_out.iter().map(ToString::to_string).collect();
    (!words.is_empty()).then(|| words.join(", "))
}

/// The local origin, for `--json`; `None` if it is zero.
pub fn origin(scene: &Scene) -> Option<[f64; 3]> {
    (scene.origin != [0.0; 3]).then_some(scene.origin)
}

/// The same in words.
pub fn origin_words(scene: &Scene) -> Option<String> {
    let [x, y, z] = origin(scene)?;
    Some(format!("{x}, {y}, {z}"))
}

/// Notes on standard error, before a picture or a tree is made.
pub fn note(scene: &Scene) {
    if let Some(words) = left_out_words(scene) {
        output::warn(&format!("left out: {words}"));
    }
    if let Some(words) = origin_words(scene) {
        output::warn(&format!(
            "the scene is far from zero: {words} is taken off all positions; those on the command line are the file's"
        ));
    }
}
