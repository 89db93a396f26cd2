//! `slimbvh build`.

use super::output::{self, bytes, things};
use super::picture::{CodesArguments, SightArguments};
use super::storage::{self, Sizes, StorageArguments, mesh_bytes};
use super::told::{self, LeftOutSummary};
use super::{SceneArguments, ThreadArguments};
use anyhow::{Result, bail};
use clap::Args;
use serde::Serialize;
use slimbvh::scene::slim::{self, WriteError};
use slimbvh::{Builder, Bvh, Processor, RenderSettings, Stages};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  slimbvh build model.glb -o model.slim
  slimbvh build model.ply -o small.slim --tolerance 0.1px --size 1920x1080
  slimbvh render small.slim -o model.png";

#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub struct BuildArguments {
    #[command(flatten)]
    scene: SceneArguments,

    /// File for the scene and its hierarchy; "-" is standard output
    #[arg(short, long, value_name = "FILE.slim", default_value = "slimbvh.slim")]
    output: PathBuf,

    #[command(flatten)]
    storage: StorageArguments,

    #[command(flatten)]
    sight: SightArguments,

    #[command(flatten)]
    codes: CodesArguments,

    #[command(flatten)]
    threads: ThreadArguments,

    /// Write a report as JSON; "-" is standard output
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

/// The report.
#[derive(Debug, Serialize)]
struct Summary {
    scene: String,
    file: String,
    file_bytes: u64,
    threads: usize,
    triangles: usize,
    dropped_faces: usize,
    left_out: Vec<LeftOutSummary>,
    #[serde(skip_serializing_if = "Option::is_none")]
    origin: Option<[f64; 3]>,
    nodes: usize,
    node_codec: &'static str,
    triangle_codec: &'static str,
    step_exponent: Option<i32>,
    build_ms: BTreeMap<&'static str, f64>,
    write_ms: f64,
    node_bytes: usize,
    triangle_bytes: usize,
    mesh_bytes: usize,
    scratch_bytes: usize,
}

pub fn run(arguments: &BuildArguments) -> Result<()> {
    arguments.storage.check()?;
    let file = arguments.output.as_path();
    let extension = file.extension();
    let is_slim = extension.is_some_and(|extension| extension.eq_ignore_ascii_case("slim"));
    if !is_slim && !output::is_stdout(Some(file)) {
        bail!(
            "{:?} does not end in .slim; hierarchies are saved as slim files",
            file.display().to_string()
        );
    }
    let scene = arguments.scene.file();
    output::check_places(file, scene, arguments.json.as_deref())?;
    let (summary, text) = arguments.threads.run(|| build(arguments))??;
    output::print_beside(&[Some(file), arguments.json.as_deref()], &text)?;
    if let Some(path) = &arguments.json {
        output::write_json(path, &summary)?;
    }
    Ok(())
}

fn build(arguments: &BuildArguments) -> Result<(Summary, String)> {
    let name = arguments.scene.name();
    let (mut scene, kept) = arguments.scene.open()?;
    told::note(&scene);
    let (cameras, lights) = (scene.cameras.clone(), scene.lights.clone());
    // Frame the original mesh: storage moves its vertices below.
    let kept = kept.and_then(|kept| kept.framing);
    let framing = kept.or_else(|| scene.mesh.bounds());
    (arguments.sight).prepare(&mut scene, &name, framing)?;
    let settings = RenderSettings {
        size: arguments.sight.size,
        ..RenderSettings::default()
    };
    let storage = arguments
        .storage
        .apply(&mut scene, &settings, Processor::Cpu)?;

    // Without `--camera`, save the scene's own cameras, and without `--light` its own lights: defaults depend on the size of
    // each picture.
    if arguments.sight.camera.is_none() {
        scene.cameras = cameras;
        if arguments.sight.light.is_empty() {
            scene.lights = lights;
        }
    }
    let codes = &arguments.codes;
    let mut builder = Builder::new(storage.config(codes.bits(), codes.tree()));
    let mut bvh = Bvh::default();
    let progress = output::spinner(format!("building {name}"));
    let stages = builder.build_into(&scene.mesh, &mut bvh)?;
    let mut writing = Stages::default();
    let file_bytes = writing.time("write", || {
        output::write_with(&arguments.output, |to| {
            match slim::write(&scene, &bvh, framing, to) {
                Err(WriteError::Io(error)) => Err(error.into()),
                written => Ok(written?),
            }
        })
    })?;
    drop(progress);

    let codecs = bvh.codecs();
    let times = stages.iter();
    let summary = Summary {
        scene: name,
        file: arguments.output.display().to_string(),
        file_bytes,
        threads: rayon::current_num_threads(),
        triangles: scene.mesh.indices.len(),
        dropped_faces: scene.dropped_face_count,
        left_out: told::left_out(&scene),
        origin: told::origin(&scene),
        nodes: bvh.node_count(),
        node_codec: codecs.0.name(),
        triangle_codec: codecs.1.name(),
        step_exponent: codecs.1.step_exponent(),
        build_ms: times
            .map(|(stage, time)| (stage, time.as_secs_f64() * 1e3))
            .collect(),
        write_ms: writing.total().as_secs_f64() * 1e3,
        node_bytes: bvh.node_bytes(),
        triangle_bytes: bvh.triangle_bytes(),
        mesh_bytes: mesh_bytes(&scene.mesh),
        scratch_bytes: builder.scratch_bytes(),
    };
    let text = describe(&summary, &stages, &storage::describe(codecs));
    Ok((summary, text))
}

/// The report as text.
fn describe(s: &Summary, stages: &Stages, codecs: &str) -> String {
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
    line("file", format!("{}, {}", s.file, bytes(s.file_bytes)));
    line(
        "hierarchy",
        format!("{}, {codecs}", things(s.nodes, "node")),
    );
    let total = stages.total().as_secs_f64() * 1e3;
    line(
        "build",
        format!(
            "{total:.2} ms with {}: {stages}",
            things(s.threads, "thread")
        ),
    );
    line(
        "write",
        format!("{:.2} ms, including validation", s.write_ms),
    );
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
