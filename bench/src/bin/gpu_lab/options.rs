//! The command line.

use crate::sections::Section;
use crate::table::TableTask;
use anyhow::{Context, Result, bail, ensure};
use slimbvh::gpu::AdapterChoice;
use std::time::Duration;

/// The text of `--help`.
pub const USAGE: &str = "\
gpu-lab SECTION [--quick] [--seed N] [--seconds N] [--adapter NAME]
gpu-lab adapter [--adapter NAME]
gpu-lab table [--out FOLDER] [--fact TEXT]... [--missed TEXT]... NAME=FILE...
  SECTION         parity, rays, stages, builds, peers or large: prints rows
  adapter         prints the adapter's name
  table           puts the rows of several builds side by side, each from FILE under NAME
  --quick         small scenes and few rounds, for a software adapter
  --seed N        of scenes and of bounce rays (default 7)
  --seconds N     begin nothing that would probably end later (default 240)
  --adapter NAME  the GPU with this in its name (default the strongest, software if nothing else)
  --out FOLDER    also write the table to FOLDER/gpu-lab-ADAPTER.md
  --fact TEXT     a line above the table, as KEY=VALUE
  --missed TEXT   what was not reached";

/// What to do.
#[derive(Debug)]
pub enum Task {
    /// Print the usage.
    Help,
    /// Print the adapter's name.
    Adapter,
    /// Measure.
    Section(Section),
    /// Print a table.
    Table(TableTask),
}

/// The command line, parsed.
#[derive(Debug)]
pub struct Options {
    /// What to do.
    pub task: Task,
    /// Whether scenes are small.
    pub is_quick: bool,
    /// Of scenes and of bounce rays.
    pub seed: u64,
    /// The time that the section may take.
    pub budget: Duration,
    /// The GPU.
    pub adapter: AdapterChoice,
}

impl Options {
    /// Parses the arguments.
    pub fn parse(mut arguments: impl Iterator<Item = String>) -> Result<Self> {
        let mut options = Self {
            task: Task::Help,
            is_quick: false,
            seed: 7,
            budget: Duration::from_secs(240),
            adapter: AdapterChoice::Any,
        };
        let (mut words, mut table) = (Vec::new(), TableTask::default());
        while let Some(argument) = arguments.next() {
            let mut value = || {
                let value = arguments.next();
                value.with_context(|| format!("{argument} needs a value"))
            };
            match argument.as_str() {
                "--help" | "-h" => return Ok(options),
                "--quick" => options.is_quick = true,
                "--seed" => options.seed = value()?.parse().context("--seed needs a number")?,
                "--seconds" => {
                    let seconds = value()?.parse().context("--seconds needs a whole number")?;
                    options.budget = Duration::from_secs(seconds);
                }
                "--adapter" => options.adapter = AdapterChoice::Named(value()?),
                "--out" => table.folder = Some(value()?.into()),
                "--fact" => table.facts.push(pair(&value()?)?),
                "--missed" => table.missed.push(value()?),
                name if name.starts_with('-') => bail!("there is no option {name:?}\n{USAGE}"),
                _ => words.push(argument),
            }
        }
        let mut words = words.into_iter();
        let word = words
            .next()
            .with_context(|| format!("a section is missing\n{USAGE}"))?;
        options.task = match word.as_str() {
            "table" => {
                table.inputs = words
                    .by_ref()
                    .map(|word| pair(&word))
                    .collect::<Result<_>>()?;
                ensure!(!table.inputs.is_empty(), "table needs NAME=FILE\n{USAGE}");
                Task::Table(table)
            }
            "adapter" => Task::Adapter,
            name => match Section::named(name) {
                Some(section) => Task::Section(section),
                None => bail!("there is no section {name:?}\n{USAGE}"),
            },
        };
        if let Some(word) = words.next() {
            bail!("{word:?} is one word too many\n{USAGE}");
        }
        Ok(options)
    }
}

/// KEY=VALUE.
fn pair(word: &str) -> Result<(String, String)> {
    let pair = word.split_once('=');
    let (key, value) = pair.with_context(|| format!("{word:?} is not of the form NAME=VALUE"))?;
    Ok((key.into(), value.into()))
}
