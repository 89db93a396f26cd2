//! Command line of the `slimbvh` binary.

#[cfg(feature = "gpu")]
mod adapters;
mod animate;
mod backend;
#[cfg(feature = "report")]
mod bench;
mod build;
mod info;
mod measure;
mod output;
mod picture;
mod reduce;
mod render;
mod reproduce;
mod storage;
mod stress;

use anyhow::{Context, Result};
use clap::{Args, Parser, Subcommand};
use slimbvh::options;
use slimbvh::scene::{LoadOptions, load};
use slimbvh::{Aabb, Bvh, Scene};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Build only the hierarchy that a view needs, store it small, trace it without a missed hit.
#[derive(Debug, Parser)]
#[command(
    name = "slimbvh",
    version,
    arg_required_else_help = true,
    allow_negative_numbers = true
)]
pub struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Render a scene to a PNG picture
    Render(render::RenderArguments),
    /// Render a scene that moves, frame by frame, to pictures or a looping GIF
    Animate(animate::AnimateArguments),
    /// Build the hierarchy of a scene and save both, so that nothing need be built to render it
    Build(build::BuildArguments),
    /// Tell what is in a scene: counts, extents, which parts are closed
    Info(info::InfoArguments),
    /// Measure every knob on scenes of yours: times, bytes, errors, and which settings nothing is better than
    #[cfg(feature = "report")]
    Bench(bench::BenchArguments),
    /// Measure what a paper's tables show, and print ours beside the printed figures
    Reproduce(reproduce::ReproduceArguments),
    /// Trace scenes and rays that break tracers, and judge every answer by exact ones
    Stress(stress::StressArguments),
}

/// Where the scene comes from.
#[derive(Debug, Args)]
struct SceneArguments {
    /// Scene file: gltf, glb, obj, ply, stl, off or slim. Without one, the default scene
    scene: Option<PathBuf>,

    /// Drop faces with broken numbers or indices, and count them, instead of refusing the file
    #[arg(long)]
    lenient: bool,
}

impl SceneArguments {
    fn load(&self) -> Result<Scene> {
        let Some(path) = &self.scene else {
            return Ok(slimbvh::generate::default_scene());
        };
        let options = LoadOptions {
            lenient: self.lenient,
            ..LoadOptions::default()
        };
        let _progress = output::spinner(format!("reading {}", path.display()));
        Ok(load(path, &options)?)
    }

    /// Whether it is a file with a hierarchy.
    fn is_saved(&self) -> bool {
        let extension = self.scene.as_deref().and_then(Path::extension);
        extension.is_some_and(|extension| extension.eq_ignore_ascii_case("slim"))
    }

    /// The scene; and what is saved with it, where it is.
    fn open(&self) -> Result<(Scene, Option<Kept>)> {
        match &self.scene {
            Some(path) if self.is_saved() => {
                let _progress = output::spinner(format!("reading {}", path.display()));
                let saved = slimbvh::file::load(path, LoadOptions::default().max_file_bytes)?;
                let (bvh, framing) = (saved.bvh, saved.framing);
                Ok((saved.scene, Some(Kept { bvh, framing })))
            }
            _ => Ok((self.load()?, None)),
        }
    }

    fn name(&self) -> String {
        match &self.scene {
            Some(path) => path.display().to_string(),
            None => "default scene".into(),
        }
    }
}

/// What a file has beside the scene.
struct Kept {
    bvh: Bvh,
    framing: Option<Aabb>,
}

/// How many threads work.
#[derive(Debug, Args)]
struct ThreadArguments {
    /// Threads to use; all cores by default. The result is the same for any number
    #[arg(long, value_name = "N", value_parser = |text: &str| options::whole(text, 1..=1024))]
    threads: Option<u32>,
}

impl ThreadArguments {
    /// As they are written on the command line.
    fn words(&self) -> Vec<String> {
        let threads = self.threads.map(|threads| format!("--threads {threads}"));
        threads.into_iter().collect()
    }

    /// Runs work on that many threads.
    fn run<R: Send>(&self, work: impl FnOnce() -> R + Send) -> Result<R> {
        // 0 is rayon's own default.
        let threads = self.threads.unwrap_or(0) as usize;
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .context("cannot start the threads")?;
        Ok(pool.install(work))
    }
}

/// Runs the command.
pub fn run(arguments: Arguments) -> Result<ExitCode> {
    match arguments.command {
        Command::Render(arguments) => render::run(&arguments)?,
        Command::Animate(arguments) => animate::run(&arguments)?,
        Command::Build(arguments) => build::run(&arguments)?,
        Command::Info(arguments) => info::run(&arguments)?,
        #[cfg(feature = "report")]
        Command::Bench(arguments) => bench::run(&arguments)?,
        Command::Reproduce(arguments) => reproduce::run(&arguments)?,
        Command::Stress(arguments) => return stress::run(&arguments),
    }
    Ok(ExitCode::SUCCESS)
}
