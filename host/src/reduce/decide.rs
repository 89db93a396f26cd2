//! Which rays get a tree of their own.

use super::target::TargetKind;
use super::{Costs, PlanRequest, Reduce};

const COSTS: Costs = Costs::MEASURED;

/// How many times what it takes a survey must promise to save: that half can be left out is a hope.
const CAUTION: f64 = 2.0;

/// What a set keeps of a closed surface, before anything is known of it.
const LIKELY_SHARE: f64 = 0.5;

/// Rays of one kind, as the model of costs sees them.
#[derive(Clone, Copy, Debug)]
pub struct Candidate {
    /// Which rays.
    pub kind: TargetKind,
    /// How long a ray takes in the set, against one in what faces the target.
    pub effort: f64,
    /// How many lights they go to.
    pub light_count: usize,
    /// Whether there are any.
    pub is_used: bool,
    /// Whether anything may be left out.
    pub may_be_set: bool,
    /// The share of the triangles that a set keeps.
    pub share: f64,
    /// What a set saves in tracing, less what it takes to build.
    pub saving_ms: f64,
}

/// Fills in what each set saves.
pub fn estimate(candidates: &mut [Candidate], request: &PlanRequest) {
    let count = request.scene.mesh.indices.len() as f64;
    let rays = primary_rays(request);
    for candidate in candidates.iter_mut().filter(|candidate| candidate.is_used) {
        let rays = rays * candidate.light_count.max(1) as f64;
        let whole = COSTS.trace_ms(candidate.kind, rays, count) * COSTS.rule;
        candidate.saving_ms = whole - set_cost_ms(candidate, request);
    }
}

/// What a set takes to build and to trace, sorted triangles given.
pub fn set_cost_ms(candidate: &Candidate, request: &PlanRequest) -> f64 {
    let count = request.scene.mesh.indices.len() as f64;
    let rays = primary_rays(request) * rays_per_sample(candidate);
    let set = COSTS.trace_ms(candidate.kind, rays, count * candidate.share);
    set + COSTS.set_ms(count, candidate.share)
}

/// How often the rays of a sample go this way, by what they take against rays in what faces the target.
fn rays_per_sample(candidate: &Candidate) -> f64 {
    candidate.light_count.max(1) as f64 * candidate.effort
}

/// Which rays get a set. `auto` takes what is cheapest: those that pay by themselves, or all, where then no whole tree is
/// built.
pub fn choose(candidates: &[Candidate], request: &PlanRequest, has_mirrors: bool) -> Vec<bool> {
    let may_be_set = |candidate: &Candidate| candidate.is_used && candidate.may_be_set;
    let pays = |candidate: &Candidate| may_be_set(candidate) && candidate.saving_ms > 0.0;
    let all = |which: &dyn Fn(&Candidate) -> bool| candidates.iter().map(which).collect();
    match request.switches.reduce {
        Reduce::Off => vec![false; candidates.len()],
        Reduce::On => all(&may_be_set),
        Reduce::Auto if best_saving(candidates, request, has_mirrors).1 => all(&may_be_set),
        Reduce::Auto => all(&pays),
    }
}

/// Milliseconds a frame that the cheapest choice saves against one whole tree, and whether it is a set for all.
fn best_saving(candidates: &[Candidate], request: &PlanRequest, has_mirrors: bool) -> (f64, bool) {
    let count = request.scene.mesh.indices.len() as f64;
    let used = || candidates.iter().filter(|candidate| candidate.is_used);
    let possible = used().filter(|candidate| candidate.may_be_set);
    let one_by_one: f64 = possible.map(|candidate| candidate.saving_ms.max(0.0)).sum();
    if has_mirrors || used().any(|candidate| !candidate.may_be_set) {
        return (one_by_one, false);
    }
    let sum: f64 = used().map(|candidate| candidate.saving_ms).sum();
    let all = sum + COSTS.tree_ms(count);
    let are_all_better = used().count() > 0 && all > one_by_one;
    (one_by_one.max(all), are_all_better)
}

/// Why a survey is not likely to pay, if so: when half of all triangles could be left out for the camera and each light.
pub fn decline(
    request: &PlanRequest,
    candidates: &[Candidate],
    has_mirrors: bool,
) -> Option<String> {
    let count = request.scene.mesh.indices.len() as f64;
    let mut hoped: Vec<Candidate> = candidates.to_vec();
    for candidate in &mut hoped {
        candidate.may_be_set = true;
        candidate.share = LIKELY_SHARE;
    }
    estimate(&mut hoped, request);
    let (saving, _) = best_saving(&hoped, request, has_mirrors);
    let survey = COSTS.survey_ms(count, request.switches.seams);
    let frame_count = f64::from(request.frame_count);
    (saving * frame_count <= CAUTION * survey).then(|| {
        let frames = match request.frame_count {
            1 => "the one frame".to_owned(),
            count => format!("{count} frames"),
        };
        format!(
            "finding out what may be left out takes about {survey:.1} ms; it should save {CAUTION} times as much, and hardly saves more than {:.1} ms in {frames}",
            saving * frame_count
        )
    })
}

fn primary_rays(request: &PlanRequest) -> f64 {
    let [width, height] = request.settings.size.map(f64::from);
    width * height * f64::from(request.settings.sample_count)
}
