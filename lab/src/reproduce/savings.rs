//! Measures each saving, in a scene in which it matters.

mod stage;

use super::measure::settings;
use super::protocol::Protocol;
use super::scenes::Subject;
use super::times::ms;
use crate::measure::rounds::Rounds;
use anyhow::{Result, ensure};
use clap::ValueEnum;
use serde::Serialize;
use slimbvh::reduce::{Cull, Plan, PlanRequest, Reduce, Saving, Savings, Switches};
use slimbvh::{
    Change, Cpu, FrameConfig, FrameRequest, Frames, Output, Picture, RenderSettings, Scene,
};
use stage::Stage;

/// A saving that is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Saved {
    /// A saving of the plan.
    Plan(Saving),
    /// No shadow rays where no light arrives.
    DarkRays,
}

/// The measurements of one picture, with a saving and without it.
#[derive(Clone, Debug, Serialize)]
pub struct SavingRecord {
    pub saving: String,
    /// A short description.
    pub scene: &'static str,
    pub with: Way,
    pub without: Way,
}

/// The measurements of a picture.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Way {
    /// Triangles in all sets that a frame builds.
    pub triangles: usize,
    /// Peak bytes of trees that exist at the same time.
    pub tree_bytes: usize,
    pub shadow_rays: u64,
    pub rounds: Rounds<FrameTimes>,
}

/// Milliseconds of a frame.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct FrameTimes {
    /// All trees, deferred ones included.
    pub build: f64,
    /// Rendering, from samples to pixels.
    pub render: f64,
}

impl Saved {
    /// All savings of plans, then [`Self::DarkRays`].
    pub fn all() -> impl Iterator<Item = Self> {
        let plans = Saving::ALL.into_iter().map(Self::Plan);
        plans.chain([Self::DarkRays])
    }

    /// A plan's saving has the name of its value for `slimbvh render --without`.
    pub fn name(self) -> String {
        let value = match self {
            Self::Plan(saving) => saving.to_possible_value(),
            Self::DarkRays => None,
        };
        value.map_or("dark rays".into(), |value| value.get_name().to_owned())
    }

    /// The settings and savings of a picture without this saving.
    fn left_out(self, settings: &RenderSettings) -> (RenderSettings, Savings) {
        match self {
            Self::Plan(saving) => (*settings, Savings::ALL.without(saving)),
            Self::DarkRays => {
                let dark_rays = true;
                let settings = RenderSettings {
                    dark_rays,
                    ..*settings
                };
                (settings, Savings::ALL)
            }
        }
    }
}

impl FrameTimes {
    pub fn total(&self) -> f64 {
        self.build + self.render
    }
}

/// Measures each saving on the CPU.
pub fn measure(subject: &Subject, protocol: &Protocol) -> Result<Vec<SavingRecord>> {
    let measure = |saved| compare(saved, subject, protocol);
    Saved::all().map(measure).collect()
}

/// Renders a picture with a saving and without it, in turn. The first round is not counted.
fn compare(saved: Saved, subject: &Subject, protocol: &Protocol) -> Result<SavingRecord> {
    let Stage { words, scene } = Stage::new(saved, subject);
    let settings = settings(protocol, 1);
    let ways = [(settings, Savings::ALL), saved.left_out(&settings)];
    let [with, without] = &ways;
    let plans = [
        plan(subject, &scene, with)?,
        plan(subject, &scene, without)?,
    ];
    let request = |i: usize| FrameRequest {
        scene: &scene,
        plan: &plans[i],
        settings: &ways[i].0,
        change: Change::Scene,
    };
    let mut trials = [Trial::new(request(0)), Trial::new(request(1))];
    for round in 0..=protocol.saving_rounds {
        for trial in &mut trials {
            trial.take_turn(round > 0)?;
        }
    }
    let [with, without] = trials;
    let saving = saved.name();
    ensure!(
        with.picture == without.picture,
        "the saving {saving:?} changes the picture of the {} ({words})",
        subject.name
    );
    Ok(SavingRecord {
        saving,
        scene: words,
        with: with.way,
        without: without.way,
    })
}

/// The plan with a set for each target that allows one.
fn plan(
    subject: &Subject,
    scene: &Scene,
    (settings, savings): &(RenderSettings, Savings),
) -> Result<Plan> {
    let switches = Switches {
        cull: Some(Cull::On),
        reduce: Reduce::On,
        savings: *savings,
        ..Switches::default()
    };
    let asked = PlanRequest::of_picture(scene, settings, switches)?;
    Ok(Plan::new(&subject.topology, &scene.mesh, &asked))
}

/// A picture that is rendered repeatedly, with its measurements.
struct Trial<'a> {
    request: FrameRequest<'a>,
    frames: Frames<Cpu>,
    picture: Picture,
    way: Way,
}

impl<'a> Trial<'a> {
    fn new(request: FrameRequest<'a>) -> Self {
        Self {
            request,
            frames: Frames::new(Cpu, FrameConfig::default()),
            picture: Picture::default(),
            way: Way::default(),
        }
    }

    fn take_turn(&mut self, counts: bool) -> Result<()> {
        let output = Output::new(&mut self.picture);
        let report = self.frames.render_planned(&self.request, output)?;
        let sizes = self.frames.sizes(self.request.plan)?;
        let way = &mut self.way;
        way.triangles = sizes.sets.iter().map(|set| set.triangle_count).sum();
        way.tree_bytes = sizes.total.node_bytes + sizes.total.triangle_bytes;
        way.shadow_rays = report.render.shadow_ray_count;
        if counts {
            way.rounds.0.push(FrameTimes {
                build: ms(&report.build),
                render: ms(&report.render.stages),
            });
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests;
