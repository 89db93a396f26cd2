//! `slimbvh animate`.

mod destination;
mod record;
mod report;

use super::backend::{BackendArguments, Chosen, choose};
use super::picture::PictureArguments;
use super::reduce::ReduceArguments;
use super::storage::{Storage, StorageArguments};
use super::{SceneArguments, ThreadArguments, output, told};
use crate::options;
use anyhow::{Result, bail};
use clap::Args;
use destination::Destination;
use record::Record;
use report::Run;
use slimbvh::animate::{Animation, Deform, Motion, Shutter, Update};
use slimbvh::reduce::{Plan, PlanConfig, Still};
use slimbvh::{Backend, Change, Cpu, FrameConfig, Frames, Output, Picture, PictureMean, Scene};
use std::path::PathBuf;
use std::time::Instant;

/// File names number frames with four digits.
const MOST_FRAMES: u32 = 9999;

/// With more times a frame, the mean changes by less than a screen shows.
const MOST_TIMES: u32 = 1024;

const EXAMPLES: &str = "\
Examples:
  slimbvh animate --frames 48 --orbit --out turn.gif --size 480x270
  slimbvh animate model.ply --frames 100 --deform wave --out frames
  slimbvh animate model.glb --frames 24 --deform twist --update rebuild --json -
  slimbvh animate --frames 48 --orbit --shutter 0.5 --shutter-times 8 --out blurred.gif --size 480x270";

const NOTES: &str = "\
The vertical is the axis nearest to the camera's up. What lies on the scene's floor is not deformed. The picture does not
depend on --update; the heat map aside. Each time of an open shutter is a picture and a tree of its own: 8 times take 8 times
as long, and their samples add up.";

#[derive(Debug, Args)]
#[command(after_help = EXAMPLES, after_long_help = format!("{NOTES}\n\n{EXAMPLES}"))]
pub struct AnimateArguments {
    #[command(flatten)]
    scene: SceneArguments,

    /// Frames of one loop; the frame after the last equals the first
    #[arg(long, value_name = "N", value_parser = |text: &str| options::whole(text, 1..=MOST_FRAMES))]
    frames: u32,

    /// Move the camera once around the scene's middle; a light that was added to the scene moves with it
    #[arg(long)]
    orbit: bool,

    /// Move all lights once around the scene's middle
    #[arg(long)]
    orbit_light: bool,

    /// Deform the scene's vertices
    #[arg(long, value_enum)]
    deform: Option<Deform>,

    /// How the tree follows from frame to frame
    #[arg(long, value_enum, default_value_t = Update::Auto)]
    update: Update,

    /// Motion blur: the share of the time between two frames that the shutter is open, 0 to 1
    #[arg(long, value_name = "SHARE", default_value_t = 0.0, value_parser = options::share)]
    shutter: f64,

    /// Pictures a frame while the shutter is open, at even intervals; a frame is their mean, in linear light
    #[arg(long, value_name = "K", default_value_t = 1, value_parser = |text: &str| options::whole(text, 1..=MOST_TIMES))]
    shutter_times: u32,

    /// The output: a folder for frame-0000.png and so on, or one looping GIF; "-" is a GIF to standard output. Without it no frame is kept
    #[arg(long, value_name = "FOLDER|FILE.gif")]
    out: Option<PathBuf>,

    /// Frames a second of the GIF, rounded to delays of whole hundredths of a second
    #[arg(long, value_name = "N", default_value_t = 20, value_parser = |text: &str| options::whole(text, 1..=50))]
    fps: u32,

    #[command(flatten)]
    picture: PictureArguments,

    #[command(flatten)]
    storage: StorageArguments,

    #[command(flatten)]
    reduce: ReduceArguments,

    #[command(flatten)]
    threads: ThreadArguments,

    #[command(flatten)]
    backend: BackendArguments,

    /// Write a summary with each frame as JSON; "-" is standard output
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

impl AnimateArguments {
    fn shutter(&self) -> Shutter {
        Shutter {
            share: self.shutter,
            time_count: self.shutter_times,
        }
    }
}

pub fn run(arguments: &AnimateArguments) -> Result<()> {
    arguments.reduce.check()?;
    arguments.storage.check()?;
    arguments.storage.check_reduction(&arguments.reduce)?;
    let place = Destination::check(arguments)?;
    // The file is read before an adapter is opened, so that a missing one is told at once.
    arguments.backend.check()?;
    let mut scene = arguments.scene.load()?;
    told::note(&scene);
    let chosen = choose(&arguments.backend)?;
    let work = || animate(arguments, &chosen, &mut scene, &place);
    let run = arguments.threads.run(work)??;
    let outputs = [arguments.out.as_deref(), arguments.json.as_deref()];
    output::print_beside(&outputs, &report::describe(arguments, &scene, &run))?;
    if let Some(path) = &arguments.json {
        output::write_json(path, &report::summarize(arguments, &scene, &run))?;
    }
    Ok(())
}

/// Renders all frames on the chosen backend.
fn animate(
    arguments: &AnimateArguments,
    chosen: &Chosen,
    scene: &mut Scene,
    place: &Destination,
) -> Result<Run> {
    let needs_light = arguments.picture.needs_light(scene);
    arguments.picture.prepare(scene, &arguments.scene.name())?;
    let motion = Motion {
        frame_count: arguments.frames,
        orbit: arguments.orbit,
        orbit_light: arguments.orbit_light || (arguments.orbit && needs_light),
        deform: arguments.deform,
    };
    let animation = Animation::new(scene, motion);
    let times = (0..arguments.frames).flat_map(|frame| arguments.shutter().times(frame));
    animation.check_at(times, &arguments.picture.settings())?;
    let times = (0..arguments.frames).flat_map(|frame| arguments.shutter().times(frame));
    let pose = |time: f64, scene: &mut Scene| {
        animation.pose_at(time, scene);
    };
    let settings = arguments.picture.settings();
    let processor = chosen.processor();
    let storage = arguments
        .storage
        .for_all(&settings, times, pose, scene, processor)?;
    if motion.deform.is_none() {
        storage.snap(scene);
    }
    let codes = &arguments.picture.codes;
    let config = storage.config(codes.bits(), codes.tree());
    let config = FrameConfig {
        build: config,
        plan: PlanConfig {
            frame_count: arguments.frames * arguments.shutter_times,
            still: Some(Still {
                vertices: motion.deform.is_none(),
                lights: !motion.orbit_light,
            }),
            ..arguments.reduce.config()
        },
        update: arguments.update,
        finds_cost: true,
        ..FrameConfig::default()
    };
    if config.plan.is_refused() {
        bail!("--reduce on with --deform needs --solid: a deformed surface may cut itself");
    }
    let work = Work {
        arguments,
        animation: &animation,
        storage,
        place,
        config,
    };
    match chosen {
        Chosen::Cpu => work.frames(Cpu, scene),
        #[cfg(feature = "gpu")]
        Chosen::Gpu(gpu) => work.frames(gpu, scene),
        #[cfg(feature = "gpu")]
        Chosen::GpuIfItFits(gpu) => match work.frames(gpu, scene) {
            Err(error) if super::backend::is_the_gpus_fault(&error) => {
                output::warn(&format!(
                    "{}; using the CPU instead",
                    output::sentence(&error)
                ));
                let build = arguments
                    .storage
                    .moved(config.build, slimbvh::Processor::Cpu);
                let config = FrameConfig { build, ..config };
                Work { config, ..work }.frames(Cpu, scene)
            }
            done => done,
        },
    }
}

/// The inputs of an animation.
struct Work<'a> {
    arguments: &'a AnimateArguments,
    animation: &'a Animation,
    storage: Storage,
    place: &'a Destination,
    config: FrameConfig,
}

impl Work<'_> {
    /// Renders all frames on one backend.
    fn frames<B: Backend>(&self, backend: B, scene: &mut Scene) -> Result<Run> {
        let Self {
            arguments,
            animation,
            storage,
            place,
            config,
        } = *self;
        let settings = arguments.picture.settings();
        let mut sink = place.open(settings.size, arguments.fps)?;
        let mut frames = Frames::new(backend, config);
        let (mut plan, mut decisions) = (None, None);
        let is_blurred = arguments.shutter_times > 1;
        let (mut picture, mut mean) = (Picture::default(), PictureMean::new());
        let mut records = Vec::with_capacity(arguments.frames as usize);
        let progress = output::bar("animating");
        for frame in 0..arguments.frames {
            let mut record = Record::default();
            for time in arguments.shutter().times(frame) {
                let begin = Instant::now();
                let vertices_moved = animation.pose_at(time, scene);
                if vertices_moved {
                    storage.snap(scene);
                }
                let pose = begin.elapsed();
                let change = if vertices_moved {
                    Change::Vertices
                } else {
                    Change::View
                };
                let report = frames.render(scene, &settings, change, Output::new(&mut picture))?;
                if is_blurred {
                    mean.add(&picture);
                }
                record.add(pose, &report);
                record.total += begin.elapsed();
                if plan.is_none() {
                    plan = frames.views().plan().map(Plan::explain);
                }
                decisions = report.decisions;
            }

            let begin = Instant::now();
            let blurred = is_blurred.then(|| mean.take());
            record.total += begin.elapsed();
            let begin = Instant::now();
            sink.add(frame, blurred.as_ref().unwrap_or(&picture))?;
            record.write = begin.elapsed();
            records.push(record);
            progress.set(f64::from(frame + 1) / f64::from(arguments.frames));
        }
        sink.finish()?;
        let decided = decisions.as_ref().map(B::explain);
        Ok(Run {
            backend: B::NAME,
            adapter: backend.adapter(),
            threads: rayon::current_num_threads(),
            records,
            survey: frames.survey_time(),
            plan: plan.unwrap_or_default(),
            decided: decided.unwrap_or_default(),
        })
    }
}
