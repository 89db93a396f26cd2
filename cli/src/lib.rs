//! The command line of slimbvh. Other command lines over the library share its options, backends and output.
#![forbid(unsafe_code)]

#[cfg(feature = "gpu")]
mod adapters;
mod animate;
pub mod backend;
mod build;
mod info;
mod input;
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
mod told;

pub use median::median;

use anyhow::{Context, Result, anyhow};
use clap::{Args, Parser, Subcommand};
use input::Input;
use slimbvh::scene::{Format, LoadError, LoadOptions, load, load_bytes, slim};
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

impl Arguments {
    /// The arguments of this process. Wrong ones end it, with exit code 2 and a message on standard error; for a file in place of
    /// a command the message names the command that renders it.
    #[must_use]
    pub fn read() -> Self {
        Self::try_parse().unwrap_or_else(|error| with_tip(error).exit())
    }
}

/// The error, with a tip if a file stands in place of a command.
fn with_tip(mut error: clap::Error) -> clap::Error {
    use clap::error::{ContextKind, ContextValue, ErrorKind};
    let tip = match error.get(ContextKind::InvalidSubcommand) {
        Some(ContextValue::String(word)) if error.kind() == ErrorKind::InvalidSubcommand => {
            let path = Path::new(word);
            let is_file = path.extension().is_some() || path.is_file();
            is_file.then(|| format!("to render this file: slimbvh render {word}"))
        }
        _ => None,
    };
    if let Some(tip) = tip {
        error.insert(
            ContextKind::Suggested,
            ContextValue::StyledStrs(vec![tip.into()]),
        );
    }
    error
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Render a scene to a PNG picture
    Render(render::RenderArguments),
    /// Render a scene that moves, frame by frame, to pictures or a looping GIF
    Animate(animate::AnimateArguments),
    /// Build the hierarchy of a scene and save both, so that `render` skips the build
    Build(build::BuildArguments),
    /// Describe a scene: counts, extents, closed components
    Info(info::InfoArguments),
}

/// The scene to load.
#[derive(Debug, Args)]
struct SceneArguments {
    /// Scene file: gltf, glb, obj, ply, stl, off or slim; "-" is standard input. Without a file: the built-in default scene
    scene: Option<PathBuf>,

    /// Format of the scene file; default: that of its extension, and for "-" what its content looks like
    #[arg(long, value_name = "FORMAT", value_enum, requires = "scene")]
    format: Option<Format>,

    /// Drop and count faces with invalid numbers or indices instead of rejecting the file
    #[arg(long)]
    lenient: bool,

    /// Standard input, if it was read.
    #[arg(skip)]
    input: Input,
}

impl SceneArguments {
    /// The scene's file, if it has one.
    fn file(&self) -> Option<&Path> {
        self.scene.as_deref().filter(|path| !is_dash(path))
    }

    /// Reads standard input, if that is the scene.
    fn read_input(&self) -> Result<()> {
        match &self.scene {
            Some(path) if is_dash(path) => {
                let _progress = output::spinner("reading standard input".into());
                self.input.read(LoadOptions::default().max_file_bytes)
            }
            _ => Ok(()),
        }
    }

    /// The format by the option, by standard input's content, or by the extension.
    fn format(&self) -> Option<Format> {
        let by_path = || Format::of_path(self.file()?);
        self.format.or_else(|| self.input.format()).or_else(by_path)
    }

    fn load(&self) -> Result<Scene> {
        let Some(path) = &self.scene else {
            return Ok(slimbvh::generate::default_scene());
        };
        self.read_input()?;
        let options = LoadOptions {
            lenient: self.lenient,
            format: self.format(),
            ..LoadOptions::default()
        };
        let name = self.name();
        let _progress = output::spinner(format!("reading {name}"));
        match self.input.take() {
            Some(bytes) => {
                load_bytes(name.as_ref(), bytes, &options).map_err(|error| self.with_guess(error))
            }
            None => Ok(load(path, &options)?),
        }
    }

    /// The error, with the format that standard input was taken for.
    fn with_guess(&self, error: LoadError) -> anyhow::Error {
        match (self.format, self.input.format()) {
            (None, Some(guess)) => {
                let guess = guess.name();
                anyhow!("{error}; its content looks like {guess}, and --format names another")
            }
            _ => error.into(),
        }
    }

    /// Whether the scene is a slim file, which holds a hierarchy. Standard input must have been read.
    fn is_saved(&self) -> bool {
        self.format() == Some(Format::Slim)
    }

    /// Loads the scene and, from a slim file, its hierarchy and framing.
    fn open(&self) -> Result<(Scene, Option<Kept>)> {
        self.read_input()?;
        match &self.scene {
            Some(path) if self.is_saved() => {
                let name = self.name();
                let _progress = output::spinner(format!("reading {name}"));
                let saved = match self.input.take() {
                    Some(bytes) => slim::read(&bytes)
                        .map_err(|error| self.with_guess(LoadError::Saved { file: name, error }))?,
                    None => slim::load(path, LoadOptions::default().max_file_bytes)?,
                };
                let (bvh, framing) = (saved.bvh, saved.framing);
                Ok((saved.scene, Some(Kept { bvh, framing })))
            }
            _ => Ok((self.load()?, None)),
        }
    }

    fn name(&self) -> String {
        match &self.scene {
            Some(path) if is_dash(path) => "standard input".into(),
            Some(path) => path.display().to_string(),
            None => "default scene".into(),
        }
    }
}

/// Whether a path is `-`, for standard input or output.
fn is_dash(path: &Path) -> bool {
    path == Path::new("-")
}

/// The contents of a slim file other than the scene.
struct Kept {
    bvh: Bvh,
    framing: Option<Aabb>,
}

/// The number of threads.
#[derive(Debug, Args)]
pub struct ThreadArguments {
    /// Number of threads; default: all cores. The result does not depend on it
    #[arg(long, value_name = "N", value_parser = |text: &str| options::whole(text, 1..=1024))]
    threads: Option<u32>,
}

impl ThreadArguments {
    /// The option as written on the command line.
    #[must_use]
    pub fn words(&self) -> Vec<String> {
        let threads = self.threads.map(|threads| format!("--threads {threads}"));
        threads.into_iter().collect()
    }

    /// Runs `work` on that many threads.
    ///
    /// # Errors
    /// If the threads cannot be started.
    pub fn run<R: Send>(&self, work: impl FnOnce() -> R + Send) -> Result<R> {
        // 0 selects rayon's default.
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

/// The exit code of a command: its own on success, 0 after a broken pipe, else 2 with one sentence on standard error.
#[must_use]
pub fn exit_code(outcome: Result<ExitCode>) -> ExitCode {
    match outcome {
        Ok(code) => code,
        Err(error) if is_broken_pipe(&error) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {}", printable(&output::sentence(&error)));
            ExitCode::from(2)
        }
    }
}

/// Whether the reader of standard output closed the pipe, which counts as success.
fn is_broken_pipe(error: &anyhow::Error) -> bool {
    error.chain().any(|cause| {
        cause
            .downcast_ref::<std::io::Error>()
            .is_some_and(|error| error.kind() == std::io::ErrorKind::BrokenPipe)
    })
}

/// The sentence on one line, with control characters escaped so that a terminal does not interpret them.
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
