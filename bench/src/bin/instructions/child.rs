//! The child process whose instructions are counted: loads a scene and renders frames as `slimbvh render` does.

use super::jobs::{Job, MODES, SCENES, VIEWS};
use anyhow::{Context, Result};
use slimbvh::reduce::{PlanConfig, Planner, Reduce, Switches, TreeChoice, Views};
use slimbvh::{
    BuildConfig, Change, Cpu, FrameConfig, FrameRequest, Frames, Output, Picture, RenderSettings,
};

/// The first argument of a child process.
pub const WORD: &str = "--child";

/// A child's arguments after [`WORD`]: the places of scene and view in their lists, the mode (without one the child only
/// loads), and the number of frames to render.
pub fn arguments(job: &Job, mode: Option<Reduce>, made: u32) -> Vec<String> {
    let scene = SCENES.iter().position(|scene| scene.name == job.scene.name);
    let view = VIEWS.iter().position(|view| view.name == job.view.name);
    let mode = MODES.iter().position(|other| Some(*other) == mode);
    let numbers = [
        scene,
        view,
        Some(mode.unwrap_or(MODES.len())),
        Some(made as usize),
    ];
    let words = numbers.map(|number| number.unwrap_or_default().to_string());
    [&[WORD.to_owned()][..], &words].concat()
}

/// The arguments of a child process.
pub fn numbers<const N: usize>(arguments: impl Iterator<Item = String>) -> Result<[usize; N]> {
    let numbers: Result<Vec<usize>, _> = arguments.map(|word| word.parse()).collect();
    let numbers = numbers.context("numbers are expected")?;
    let count = numbers.len();
    let numbers = numbers.try_into().ok();
    numbers.with_context(|| format!("{N} numbers are expected, not {count}"))
}

/// Runs the child's job. Prints the plan's decisions.
pub fn run(arguments: impl Iterator<Item = String>) -> Result<()> {
    let [scene, view, mode, made] = numbers(arguments)?;
    let job = Job {
        scene: *SCENES.get(scene).context("no such scene")?,
        view: *VIEWS.get(view).context("no such view")?,
    };
    let mode = MODES.get(mode).copied();
    let pool = slimbvh_bench::pool(1)?;
    println!("{}", pool.install(|| frames(&job, mode, made))?);
    Ok(())
}

fn frames(job: &Job, mode: Option<Reduce>, made: usize) -> Result<&'static str> {
    let scene = job.scene()?;
    let Some(reduce) = mode else {
        return Ok("loaded");
    };
    let settings = RenderSettings {
        size: job.view.size,
        ..RenderSettings::default()
    };
    let config = PlanConfig {
        switches: Switches {
            cull: job.view.cull,
            reduce,
            seams: job.view.seams,
            ..Switches::default()
        },
        frame_count: job.view.frame_count,
        ..PlanConfig::default()
    };
    let mut planner = Planner::new(BuildConfig::default(), config);
    let views = Views::of_picture(&scene, &settings)?;
    planner.survey(&scene.mesh, &views)?;
    let plan = planner.plan(&scene.mesh, &views);
    let mut frames = Frames::new(Cpu, FrameConfig::default());
    let mut picture = Picture::default();
    for _ in 0..made {
        let request = FrameRequest {
            scene: &scene,
            plan: &plan,
            settings: &settings,
            change: Change::Scene,
        };
        frames.render_planned(&request, Output::new(&mut picture))?;
    }
    let has_set = plan.sets.iter().any(|set| set.choice == TreeChoice::Set);
    Ok(match (plan.is_plain(), has_set, plan.needs_whole) {
        (true, ..) => "declined a survey",
        (_, false, _) => "whole tree",
        (_, true, true) => "whole tree and sets",
        (_, true, false) => "sets",
    })
}
