//! The command line.

use anyhow::{Context, Result, bail};
use std::path::PathBuf;

/// The text of `--help`.
pub const USAGE: &str = "\
shader-stats [--write] [--record FILE] [--family NAME] [FILE.spv...]
shader-stats --list [--family NAME] FILE.spv...
shader-stats --ray [--nodes N] [--triangles N] [--family NAME] [FILE.spv...]
  --write        renew the record instead of comparing with it
  --record FILE  this record (default bench/record/shaders.csv)
  --list         print the counts of these modules only
  --ray          split trace kernels by their loops and sum a primary ray (default trace_closest and trace_any);
                 also by NVIDIA's NVRTC where NVRTC_HOME names its folder
  --nodes N      node steps of the ray (default 8.4, the mean of primary rays of the dragon)
  --triangles N  triangle tests of the ray (default 1.26)
  --family NAME  the AMD GPU to compile for (default navi21)
  FILE.spv...    these modules (default all committed ones)";

/// What to do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Task {
    /// Print the usage.
    Help,
    /// Compare with the record.
    Compare,
    /// Renew the record.
    Write,
    /// Print counts only.
    List,
    /// Sum the instructions of a ray.
    Ray,
}

/// The command line, parsed.
pub struct Options {
    /// What to do.
    pub task: Task,
    /// The record's file, if not the committed one.
    pub record: Option<PathBuf>,
    /// RADV's name of the GPU.
    pub family: String,
    /// Node steps and triangle tests of a ray.
    pub ray: [f64; 2],
    /// Modules; empty selects the default.
    pub files: Vec<PathBuf>,
}

impl Options {
    /// Parses the arguments.
    pub fn parse(mut arguments: impl Iterator<Item = String>) -> Result<Self> {
        let mut options = Self {
            task: Task::Compare,
            record: None,
            family: "navi21".into(),
            ray: [8.4, 1.26],
            files: Vec::new(),
        };
        while let Some(argument) = arguments.next() {
            let mut value = || {
                let value = arguments.next();
                value.with_context(|| format!("{argument} needs a value"))
            };
            match argument.as_str() {
                "--help" | "-h" => options.task = Task::Help,
                "--write" => options.task = Task::Write,
                "--list" => options.task = Task::List,
                "--ray" => options.task = Task::Ray,
                "--record" => options.record = Some(value()?.into()),
                "--family" => options.family = value()?,
                "--nodes" => options.ray[0] = value()?.parse().context("--nodes needs a number")?,
                "--triangles" => {
                    options.ray[1] = value()?.parse().context("--triangles needs a number")?;
                }
                _ if !argument.starts_with('-') => options.files.push(argument.into()),
                _ => bail!("there is no option {argument:?}\n{USAGE}"),
            }
        }
        if options.task == Task::List && options.files.is_empty() {
            bail!("--list needs a module\n{USAGE}");
        }
        if options.task == Task::Write && options.record.is_none() && !options.files.is_empty() {
            bail!("the committed record holds all modules: name no file with --write\n{USAGE}");
        }
        Ok(options)
    }
}
