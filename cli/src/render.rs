//! `slimbvh render`.

mod saved;

use super::backend::{BackendArguments, Chosen, choose};
use super::output::{self, count, things};
use super::picture::PictureArguments;
use super::reduce::{self, PlanSummary, ReduceArguments};
use super::storage::{Sizes, StorageArguments, mesh_bytes};
use super::told::{self, LeftOutSummary};
use super::{SceneArguments, ThreadArguments};
use anyhow::{Context, Result, bail};
use clap::Args;
use serde::Serialize;
use slimbvh::reduce::{Plan, Survey};
use slimbvh::{
    Backend, Change, Cpu, FrameConfig, FrameSizes, Frames, Output, Picture, RenderReport,
    RenderSettings, Scene, Stages, View,
};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  slimbvh render
  slimbvh render model.glb -o model.png --spp 16
  slimbvh render model.slim --backend gpu
  curl https://example.org/model.glb | slimbvh render - -o - > model.png
  slimbvh render model.ply --view heatmap --camera \"eye=0,1,5 target=0,0,0\" --light \"sun=-1,-2,-1\"
  slimbvh render --spp 64 --light \"disc=-4,5,3 normal=4,-5,-3 radius=1 color=130,120,100\"
  slimbvh render --spp 64 --camera \"lens=0.15 focus=8\"";

const NOTES: &str = "\
Soft shadows and blur are drawn at random for each sample: 16 samples a pixel are grainy, 64 and more are smooth. A disc's or
a rectangle's color is its irradiance at distance 1 straight ahead, whatever its size; it shines to one side, and is not seen
itself.";

#[derive(Debug, Args)]
#[command(after_help = EXAMPLES, after_long_help = format!("{NOTES}\n\n{EXAMPLES}"))]
pub struct RenderArguments {
    #[command(flatten)]
    scene: SceneArguments,

    /// The file to write the picture to; "-" is standard output
    #[arg(short, long, value_name = "FILE.png", default_value = "slimbvh.png")]
    output: PathBuf,

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

    /// Write a summary as JSON; "-" is standard output
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

/// The summary of a picture, for `--json`.
#[derive(Debug, Serialize)]
struct Summary {
    scene: String,
    picture: String,
    width: u32,
    height: u32,
    samples_per_pixel: u32,
    backend: &'static str,
    adapter: Option<String>,
    threads: usize,
    triangles: usize,
    dropped_faces: usize,
    left_out: Vec<LeftOutSummary>,
    #[serde(skip_serializing_if = "Option::is_none")]
    origin: Option<[f64; 3]>,
    nodes: usize,
    build_ms: BTreeMap<&'static str, f64>,
    render_ms: BTreeMap<&'static str, f64>,
    primary_rays: u64,
    primary_hits: u64,
    shadow_rays: u64,
    mirror_rays: u64,
    mrays_per_second: f64,
    node_visits: Option<u64>,
    node_bytes: usize,
    triangle_bytes: usize,
    mesh_bytes: usize,
    scratch_bytes: usize,
    plan: PlanSummary,
    #[serde(skip)]
    loaded: bool,
}

pub fn run(arguments: &RenderArguments) -> Result<()> {
    arguments.reduce.check()?;
    arguments.storage.check()?;
    arguments.storage.check_reduction(&arguments.reduce)?;
    check_places(arguments)?;
    // The file is read before an adapter is opened, so that a missing one is told at once.
    arguments.backend.check()?;
    arguments.scene.read_input()?;
    let (summary, text, picture) = if arguments.scene.is_saved() {
        saved::check(arguments)?;
        let opened = arguments.threads.run(|| saved::open(arguments))??;
        let chosen = choose(&arguments.backend)?;
        let work = || saved::render(arguments, opened, &chosen);
        arguments.threads.run(work)??
    } else {
        let mut scene = arguments.scene.load()?;
        told::note(&scene);
        let chosen = choose(&arguments.backend)?;
        let work = || render(arguments, &chosen, &mut scene);
        arguments.threads.run(work)??
    };
    output::write_png(&arguments.output, &picture)?;
    let outputs = [Some(&*arguments.output), arguments.json.as_deref()];
    output::print_beside(&outputs, &text)?;
    if let Some(path) = &arguments.json {
        output::write_json(path, &summary)?;
    }
    Ok(())
}

/// Checks the paths of all output files before any work starts.
fn check_places(arguments: &RenderArguments) -> Result<()> {
    let picture = arguments.output.as_path();
    let is_png = picture
        .extension()
        .is_some_and(|e| e.eq_ignore_ascii_case("png"));
    if !is_png && !output::is_stdout(Some(picture)) {
        bail!(
            "{:?} does not end in .png; pictures are written as PNG",
            picture.display().to_string()
        );
    }
    let scene = arguments.scene.file();
    output::check_places(picture, scene, arguments.json.as_deref())
}

fn render(
    arguments: &RenderArguments,
    chosen: &Chosen,
    scene: &mut Scene,
) -> Result<(Summary, String, Picture)> {
    let settings = arguments.picture.settings();
    arguments.picture.prepare(scene, &arguments.scene.name())?;
    let storage = arguments
        .storage
        .apply(scene, &settings, chosen.processor())?;
    let codes = &arguments.picture.codes;
    let config = FrameConfig {
        build: storage.config(codes.bits(), codes.tree()),
        plan: arguments.reduce.config(),
        ..FrameConfig::default()
    };
    let job = Job {
        scene,
        config,
        settings: &settings,
    };
    let mut picture = Picture::default();
    let outcome = match chosen {
        Chosen::Cpu => job.render_on(Cpu, &mut picture)?,
        #[cfg(feature = "gpu")]
        Chosen::Gpu(gpu) => job.render_on(gpu, &mut picture)?,
        #[cfg(feature = "gpu")]
        Chosen::GpuIfItFits(gpu) => match job.render_on(gpu, &mut picture) {
            Err(error) if super::backend::is_the_gpus_fault(&error) => {
                output::warn(&format!(
                    "{}; using the CPU instead",
                    output::sentence(&error)
                ));
                let build = arguments
                    .storage
                    .moved(config.build, slimbvh::Processor::Cpu);
                let config = FrameConfig { build, ..config };
                Job { config, ..job }.render_on(Cpu, &mut picture)?
            }
            outcome => outcome?,
        },
    };
    Ok(tell(arguments, scene, outcome, picture))
}

/// The summary and the text of a finished picture.
fn tell(
    arguments: &RenderArguments,
    scene: &Scene,
    outcome: Outcome,
    picture: Picture,
) -> (Summary, String, Picture) {
    let (plan, survey, sets) = (&outcome.plan, outcome.survey.as_ref(), &outcome.sizes.sets);
    let planned = reduce::summarize(plan, survey, sets);
    let summary = summarize(arguments, scene, &outcome, planned);
    let mut text = describe(&summary, &outcome);
    if arguments.reduce.explain {
        let stages = (&outcome.build, &outcome.report.stages);
        text += &reduce::explain(plan, survey, sets, stages);
    }
    (summary, text, picture)
}

/// The inputs of a picture.
struct Job<'a> {
    scene: &'a Scene,
    config: FrameConfig,
    settings: &'a RenderSettings,
}

/// Times, counts and sizes of a finished picture.
struct Outcome {
    backend: &'static str,
    adapter: Option<String>,
    build: Stages,
    report: RenderReport,
    sizes: FrameSizes,
    scratch_bytes: usize,
    plan: Plan,
    survey: Option<Survey>,
}

impl Job<'_> {
    /// Builds the trees and renders the picture on one backend.
    fn render_on<B: Backend>(&self, backend: B, picture: &mut Picture) -> Result<Outcome> {
        let mut frames = Frames::new(backend, self.config);
        let progress = output::bar("rendering");
        let mut show = |share| progress.set(share);
        let output = Output {
            picture,
            progress: Some(&mut show),
        };
        let report = frames.render(self.scene, self.settings, Change::Scene, output)?;
        let views = frames.views();
        let plan = views.plan().cloned().context("there is no plan")?;
        Ok(Outcome {
            backend: B::NAME,
            adapter: backend.adapter(),
            build: report.build,
            report: report.render,
            sizes: frames.sizes(&plan)?,
            scratch_bytes: frames.scratch_bytes(),
            survey: views.survey().cloned(),
            plan,
        })
    }
}

fn summarize(
    arguments: &RenderArguments,
    scene: &Scene,
    outcome: &Outcome,
    plan: PlanSummary,
) -> Summary {
    let times = |stages: &Stages| {
        stages
            .iter()
            .map(|(stage, time)| (stage, time.as_secs_f64() * 1e3))
            .collect()
    };
    let [width, height] = arguments.picture.sight.size;
    let mesh = &scene.mesh;
    let report = &outcome.report;
    Summary {
        scene: arguments.scene.name(),
        picture: arguments.output.display().to_string(),
        width,
        height,
        samples_per_pixel: arguments.picture.spp,
        backend: outcome.backend,
        adapter: outcome.adapter.clone(),
        threads: rayon::current_num_threads(),
        triangles: mesh.indices.len(),
        dropped_faces: scene.dropped_face_count,
        left_out: told::left_out(scene),
        origin: told::origin(scene),
        nodes: outcome.sizes.total.node_count,
        build_ms: times(&outcome.build),
        render_ms: times(&report.stages),
        primary_rays: report.primary_ray_count,
        primary_hits: report.primary_hit_count,
        shadow_rays: report.shadow_ray_count,
        mirror_rays: report.mirror_ray_count,
        mrays_per_second: report.ray_count() as f64 / report.stages.total().as_secs_f64() / 1e6,
        node_visits: (arguments.picture.view == View::Heatmap).then_some(report.node_visit_count),
        node_bytes: outcome.sizes.total.node_bytes,
        triangle_bytes: outcome.sizes.total.triangle_bytes,
        mesh_bytes: mesh_bytes(mesh),
        scratch_bytes: outcome.scratch_bytes,
        plan,
        loaded: arguments.scene.is_saved(),
    }
}

/// The summary as text.
fn describe(s: &Summary, outcome: &Outcome) -> String {
    let Outcome { build, report, .. } = outcome;
    let mut text = String::new();
    let mut line = |name: &str, value: String| {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{name:<10} {value}");
    };
    line(
        "scene",
        format!("{}, {}", s.scene, things(s.triangles, "triangle")),
    );
    if s.dropped_faces > 0 {
        line("dropped", things(s.dropped_faces, "broken face"));
    }
    line(
        "picture",
        format!(
            "{}, {}x{}, {} a pixel, {}",
            s.picture,
            s.width,
            s.height,
            things(s.samples_per_pixel, "sample"),
            match &s.adapter {
                Some(adapter) => adapter.clone(),
                None => things(s.threads, "thread"),
            }
        ),
    );
    let ms = |stages: &Stages| stages.total().as_secs_f64() * 1e3;
    let before = if s.loaded { "load" } else { "build" };
    line(before, format!("{:.2} ms: {build}", ms(build)));
    line(
        "render",
        format!("{:.2} ms: {}", ms(&report.stages), report.stages),
    );
    line(
        "rays",
        format!(
            "{} primary ({} hit), {} shadow, {} mirror: {:.2} Mrays/s",
            count(s.primary_rays),
            count(s.primary_hits),
            count(s.shadow_rays),
            count(s.mirror_rays),
            s.mrays_per_second
        ),
    );
    if let Some(visits) = s.node_visits {
        let mean = visits as f64 / s.primary_rays as f64;
        line(
            "visits",
            format!("{} nodes, {mean:.1} a ray", count(visits)),
        );
    }
    let sizes = Sizes {
        triangle_count: s.triangles,
        node_bytes: s.node_bytes,
        triangle_bytes: s.triangle_bytes,
        mesh_bytes: s.mesh_bytes,
        scratch_bytes: s.scratch_bytes,
    };
    line("bytes", sizes.describe());
    text
}
