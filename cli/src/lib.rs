//! The command line of slimbvh, and what other command lines over the library share with it: options, backends, output.
#![forbid(unsafe_code)]

#[cfg(feature = "gpu")]
mod adapters;
mod animate;
pub mod backend;
mod build;
mod info;
mod median;
pub mod options;
pub mod output;
mod picture;
#[doc(hidden)]
pub mod reduce;
#[doc(hidden)]
pub mod render;
#[doc(hidden)]
pub mod storage;

pub use median::median;

use anyhow::{Context, Result};
use clap::{Args, Parser, Subcommand};
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
                let saved =
                    slimbvh::scene::slim::load(path, LoadOptions::default().max_file_bytes)?;
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
pub struct ThreadArguments {
    /// Threads to use; all cores by default. The result is the same for any number
    #[arg(long, value_name = "N", value_parser = |text: &str| options::whole(text, 1..=1024))]
    threads: Option<u32>,
}

impl ThreadArguments {
    /// As they are written on the command line.
    #[must_use]
    pub fn words(&self) -> Vec<String> {
        let threads = self.threads.map(|threads| format!("--threads {threads}"));
        threads.into_iter().collect()
    }

    /// Runs work on that many threads.
    ///
    /// # Errors
    /// If there can be no such threads.
    pub fn run<R: Send>(&self, work: impl FnOnce() -> R + Send) -> Result<R> {
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
///
/// # Errors
/// For bad input, and for files that cannot be written.
pub fn run(arguments: Arguments) -> Result<ExitCode> {
    match arguments.command {
        Command::Render(arguments) => render::run(&arguments)?,
        Command::Animate(arguments) => animate::run(&arguments)?,
        Command::Build(arguments) => build::run(&arguments)?,
        Command::Info(arguments) => info::run(&arguments)?,
    }
    Ok(ExitCode::SUCCESS)
}

/// The exit code of a command: its own, 0 where the reader of its output went away, 2 with one sentence for bad usage or input.
#[must_use]
pub fn exit_code(outcome: Result<ExitCode>) -> ExitCode {
    match outcome {
        Ok(code) => code,
        Err(error) if is_broken_pipe(&error) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {}", printable(&format!("{error:#}")));
            ExitCode::from(2)
        }
    }
}

/// Whether the reader of our output went away: that is success.
fn is_broken_pipe(error: &anyhow::Error) -> bool {
    error.chain().any(|cause| {
        cause
            .downcast_ref::<std::io::Error>()
            .is_some_and(|error| error.kind() == std::io::ErrorKind::BrokenPipe)
    })
}

/// A sentence in one line that no terminal takes for a command, whatever the names in it hold.
fn printable(sentence: &str) -> String {
    let mut line = String::new();
    for c in sentence.chars() {
        if c.is_control() {
            line.extend(c.escape_default());
        } else {
            line.push(c);
        }
    }
    line
}
