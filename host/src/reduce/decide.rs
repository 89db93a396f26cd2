//! The choice of which rays get their own tree.

use super::target::TargetKind;
use super::{Costs, PlanRequest, Reduce};

const COSTS: Costs = Costs::MEASURED;

/// A survey must promise to save this many times its own cost, because the share that can be left out is only a guess.
const CAUTION: f64 = 2.0;

/// The share of the triangles that a set keeps, guessed before a survey: half of a closed surface faces away.
const LIKELY_SHARE: f64 = 0.5;

/// Rays of one kind, as input of the cost model.
#[derive(Clone, Copy, Debug)]
pub struct Candidate {
    /// The kind of the rays.
    pub kind: TargetKind,
    /// Time of a ray in the set, divided by that in a set of the same size that faces the target.
    pub effort: f64,
    /// Rays expected in a frame.
    pub ray_count: f64,
    /// Whether there are such rays.
    pub is_used: bool,
    /// Whether a set could leave anything out.
    pub may_be_set: bool,
    /// The share of the triangles that a set keeps.
    pub share: f64,
    /// Milliseconds that a set saves in tracing, minus its build time.
    pub saving_ms: f64,
}

/// Sets each candidate's `saving_ms`.
pub fn estimate(candidates: &mut [Candidate], request: &PlanRequest) {
    let count = request.triangle_count as f64;
    for candidate in candidates.iter_mut().filter(|candidate| candidate.is_used) {
        let whole = COSTS.trace_ms(candidate.kind, candidate.ray_count, count) * COSTS.rule;
        candidate.saving_ms = whole - set_cost_ms(candidate, request);
    }
}

/// Milliseconds to build and trace a set, sorted triangles given.
pub fn set_cost_ms(candidate: &Candidate, request: &PlanRequest) -> f64 {
    let count = request.triangle_count as f64;
    let rays = candidate.ray_count * candidate.effort;
    let set = COSTS.trace_ms(candidate.kind, rays, count * candidate.share);
    set + COSTS.set_ms(count, candidate.share)
}

/// Which rays get a set. `auto` takes the cheaper of two choices: the sets that pay individually beside a whole tree, or
/// sets for all rays without a whole tree.
pub fn choose(candidates: &[Candidate], request: &PlanRequest) -> Vec<bool> {
    let may_be_set = |candidate: &Candidate| candidate.is_used && candidate.may_be_set;
    let pays = |candidate: &Candidate| may_be_set(candidate) && candidate.saving_ms > 0.0;
    let all = |which: &dyn Fn(&Candidate) -> bool| candidates.iter().map(which).collect();
    match request.switches.reduce {
        Reduce::Off => vec![false; candidates.len()],
        Reduce::On => all(&may_be_set),
        Reduce::Auto if best_saving(candidates, request).1 => all(&may_be_set),
        Reduce::Auto => all(&pays),
    }
}

/// Milliseconds a frame that the cheapest choice saves against one whole tree, and whether that choice is sets for all
/// rays.
fn best_saving(candidates: &[Candidate], request: &PlanRequest) -> (f64, bool) {
    let count = request.triangle_count as f64;
    let used = || candidates.iter().filter(|candidate| candidate.is_used);
    let possible = used().filter(|candidate| candidate.may_be_set);
    let one_by_one: f64 = possible.map(|candidate| candidate.saving_ms.max(0.0)).sum();
    if request.views.has_others() || used().any(|candidate| !candidate.may_be_set) {
        return (one_by_one, false);
    }
    let sum: f64 = used().map(|candidate| candidate.saving_ms).sum();
    let all = sum + COSTS.tree_ms(count);
    let are_all_better = used().count() > 0 && all > one_by_one;
    (one_by_one.max(all), are_all_better)
}

/// The reason not to survey, if a survey is not likely to pay even if half of all triangles could be left out for the
/// camera and each light. What it is expected to save must also outweigh a survey that finds nothing, because its search for
/// seams is given up.
pub fn decline(request: &PlanRequest, candidates: &[Candidate]) -> Option<String> {
    let count = request.triangle_count as f64;
    let mut guessed: Vec<Candidate> = candidates.to_vec();
    for candidate in &mut guessed {
        candidate.may_be_set = true;
        candidate.share = LIKELY_SHARE;
    }
    estimate(&mut guessed, request);
    let (saving, _) = best_saving(&guessed, request);
    let survey = COSTS.survey_ms(count, request.switches.seams);
    let frame_count = f64::from(request.frame_count);
    let longest = COSTS.longest_survey_ms(count, request.switches.seams);
    let needed = (CAUTION * survey).max(longest);
    (saving * frame_count <= needed).then(|| {
        let frames = match request.frame_count {
            1 => "one frame".to_owned(),
            count => format!("{count} frames"),
        };
        format!(
            "a survey of the surfaces takes about {survey:.1} ms, at most {longest:.1} ms, and must save more than {needed:.1} ms; it is expected to save at most {:.1} ms in {frames}",
            saving * frame_count
        )
    })
}
