//! `slimbvh reproduce compressed`.

mod counts;
mod cracks;
mod machine;
mod measure;
mod methods;
mod paths;
mod printed;
mod protocol;
mod report;
mod scenes;
mod tables;
mod targets;
#[cfg(test)]
mod tests;

use super::{check_places, hand_out, scenes_folder};
use crate::cli::{ThreadArguments, output};
use anyhow::Result;
use clap::{Args, ValueEnum};
use measure::{SceneRecord, measure};
use protocol::Protocol;
use report::Report;
use scenes::Subject;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  slimbvh reproduce compressed --quick
  slimbvh reproduce compressed --only shiny bunny --json -
  slimbvh reproduce compressed --scenes models --threads 2 --out compressed-cpu.md";

#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub struct CompressedArguments {
    /// Half a minute on two cores: small pictures, few repeats, nothing of 7.2 million triangles
    #[arg(long)]
    quick: bool,

    /// Only these scenes; of the dragon nothing is printed
    #[arg(long, value_enum, value_name = "NAME", num_args = 1..)]
    only: Vec<SceneName>,

    /// Folder with bunny00.off and dragon.ply; else that which SLIMBVH_SCENES names. What is missing is stood in for
    #[arg(long, value_name = "FOLDER")]
    scenes: Option<PathBuf>,

    /// Write the report as a Markdown file as well
    #[arg(long, value_name = "FILE.md")]
    out: Option<PathBuf>,

    #[command(flatten)]
    threads: ThreadArguments,

    /// Write all that was measured as JSON, to standard output for "-"
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

/// The scenes of the paper, or what comes near them, and one more.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum SceneName {
    Shiny,
    Bunny,
    Dragon,
    AsianDragon,
}

pub fn run(arguments: &CompressedArguments) -> Result<()> {
    let (out, json) = (arguments.out.as_deref(), arguments.json.as_deref());
    check_places(arguments.scenes.as_deref(), out, json)?;
    let report = arguments.threads.run(|| make(arguments))??;
    hand_out(&report, &report.sheet(), out, json)
}

fn make(arguments: &CompressedArguments) -> Result<Report> {
    let protocol = match arguments.quick {
        true => Protocol::QUICK,
        false => Protocol::FULL,
    };
    let folder = scenes_folder(arguments.scenes.as_deref());
    let measure_one = |name: SceneName| -> Result<SceneRecord> {
        let _progress = output::spinner(format!("measuring {}", name.shown()));
        let subject = Subject::new(name, folder.as_deref(), protocol.size)?;
        measure(subject, &protocol)
    };
    let records = arguments.names().into_iter().map(measure_one);
    let records = records.collect::<Result<_>>()?;
    Ok(Report::new(arguments, protocol, records))
}

impl SceneName {
    fn shown(self) -> String {
        let value = self.to_possible_value();
        value.map_or("scene".into(), |value| value.get_name().to_owned())
    }
}

impl CompressedArguments {
    /// The scenes that are asked for, the smallest first.
    fn names(&self) -> Vec<SceneName> {
        let all = SceneName::value_variants().iter().copied();
        let is_wanted = |name: &SceneName| match self.only.is_empty() {
            true => !(self.quick && *name == SceneName::AsianDragon),
            false => self.only.contains(name),
        };
        all.filter(is_wanted).collect()
    }

    /// The command that makes the same report again, without the names of folders and files.
    fn command(&self) -> String {
        let mut words = vec!["slimbvh reproduce compressed".to_owned()];
        if self.quick {
            words.push("--quick".into());
        }
        if !self.only.is_empty() {
            words.push("--only".into());
            words.extend(self.names().into_iter().map(SceneName::shown));
        }
        words.extend(self.threads.words());
        words.join(" ")
    }
}
