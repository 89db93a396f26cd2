//! The options of reduced trees, and the report on a plan.

use super::output::count;
use anyhow::{Result, bail};
use clap::Args;
use serde::Serialize;
use slimbvh::reduce::{
    Cull, FacingSet, Plan, PlanConfig, Reduce, Saving, Savings, Seams, Survey, Switches,
    TargetKind, TreeChoice, ViewSet,
};
use slimbvh::topology::Topology;
use slimbvh::{SetSize, Stages};
use std::collections::BTreeMap;
use std::fmt::Write;

#[derive(Debug, Args)]
pub struct ReduceArguments {
    /// Whether rays skip triangles that face away, on closed surfaces seen from outside. Default: they do if the plan of
    /// --reduce surveys the surfaces
    #[arg(long, value_enum)]
    cull: Option<Cull>,

    /// Whether the camera and each light get reduced trees, without the triangles that face away
    #[arg(long, value_enum, default_value_t = Reduce::Auto)]
    reduce: Reduce,

    /// Skip the search for seams: promise that no closed part cuts itself or is inside out in places
    #[arg(long)]
    solid: bool,

    /// Savings to turn off, separated by commas; the picture stays the same
    #[arg(long, value_enum, value_delimiter = ',', value_name = "SAVING")]
    without: Vec<Saving>,

    /// Print what was left out, and why
    #[arg(long)]
    pub explain: bool,
}

impl ReduceArguments {
    /// Rejects options that contradict each other.
    pub fn check(&self) -> Result<()> {
        if self.switches().is_contradiction() {
            bail!(
                "--reduce on and --cull off contradict each other: reduced trees leave out what faces away; leave one of them out"
            );
        }
        Ok(())
    }

    /// Whether the options demand reduced trees or culling.
    #[must_use]
    pub fn is_asked_for(&self) -> bool {
        self.reduce == Reduce::On || self.cull == Some(Cull::On)
    }

    fn switches(&self) -> Switches {
        Switches {
            cull: self.cull,
            reduce: self.reduce,
            seams: if self.solid { Seams::None } else { Seams::Find },
            savings: (self.without.iter()).fold(Savings::ALL, |all, &saving| all.without(saving)),
        }
    }

    /// The plan's settings for one picture.
    #[must_use]
    pub fn config(&self) -> PlanConfig {
        PlanConfig {
            switches: self.switches(),
            ..PlanConfig::default()
        }
    }
}

/// The summary of a plan and its trees, for `--json`.
#[derive(Debug, Serialize)]
pub struct PlanSummary {
    surveyed: bool,
    survey_ms: BTreeMap<&'static str, f64>,
    reducible_triangles: usize,
    seams: usize,
    whole_tree: bool,
    targets: Vec<TargetSummary>,
    decisions: Vec<String>,
}

#[derive(Debug, Serialize)]
struct TargetSummary {
    name: String,
    /// Numbers of the lights, from 1.
    lights: Vec<usize>,
    half: &'static str,
    tree: &'static str,
    /// The number of triangles in its tree.
    triangles: Option<usize>,
    /// Whether a set fitted into its memory; else its rays went through the whole tree.
    fits: Option<bool>,
    estimated_share: f64,
    estimated_saving_ms: f64,
}

pub fn summarize(plan: &Plan, survey: Option<&Survey>, sets: &[SetSize]) -> PlanSummary {
    let target = |view: &ViewSet| {
        let name = view.name();
        let set = sets.iter().find(|set| set.name == name);
        let (tree, triangles) = match view.choice {
            TreeChoice::Set => ("set", set.map(|set| set.triangle_count)),
            TreeChoice::Whole => ("whole", Some(plan.triangle_count)),
            TreeChoice::Unused => ("none", None),
        };
        TargetSummary {
            name,
            // The camera is the first target.
            lights: match view.kind {
                TargetKind::From | TargetKind::Other => Vec::new(),
                TargetKind::To => view.targets.clone(),
            },
            half: match view.half {
                FacingSet::Front => "toward",
                FacingSet::Back => "away",
            },
            tree,
            triangles,
            fits: set.map(|set| set.fits),
            estimated_share: view.share,
            estimated_saving_ms: view.saving_ms,
        }
    };
    let times = survey.into_iter().flat_map(|survey| survey.stages.iter());
    let facts = plan.topology.as_deref().map(Topology::facts);
    let reducible = facts.iter().flatten().filter(|facts| facts.reducible);
    let lines = plan.explain();
    PlanSummary {
        surveyed: survey.is_some(),
        survey_ms: times
            .map(|(step, time)| (step, time.as_secs_f64() * 1e3))
            .collect(),
        reducible_triangles: reducible.map(|facts| facts.triangle_count).sum(),
        seams: plan.topology.as_deref().map_or(0, Topology::seam_count),
        whole_tree: plan.needs_whole,
        targets: plan.sets.iter().map(target).collect(),
        decisions: lines
            .into_iter()
            .map(|(about, text)| format!("{about}: {text}"))
            .collect(),
    }
}

/// The decisions, the resulting sets and the times, as text.
#[must_use]
pub fn explain(
    plan: &Plan,
    survey: Option<&Survey>,
    sets: &[SetSize],
    (build, render): (&Stages, &Stages),
) -> String {
    let mut text = String::new();
    let mut line = |about: &str, what: String| {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{about:<10} {what}");
    };
    for (about, what) in plan.explain() {
        line(&about, what);
    }
    if !sets.is_empty() {
        let percent = |kept: usize| 100.0 * kept as f64 / plan.triangle_count.max(1) as f64;
        let set = |set: &SetSize| {
            let kept = set.triangle_count;
            let unfit = if set.fits {
                ""
            } else {
                "; too many for its memory, so its rays went through the whole tree"
            };
            let (name, share) = (&set.name, percent(kept));
            format!("{name} {} ({share:.1} %{unfit})", count(kept))
        };
        let sets: Vec<String> = sets.iter().map(set).collect();
        line("kept", sets.join(", "));
    }
    let ms = |stages: &Stages| stages.total().as_secs_f64() * 1e3;
    let survey = survey.map_or("no survey".to_owned(), |survey| {
        format!("survey {:.2} ms ({})", ms(&survey.stages), survey.stages)
    });
    let (build, render) = (ms(build), ms(render));
    line(
        "took",
        format!("{survey}, build {build:.2} ms, render {render:.2} ms"),
    );
    text
}
