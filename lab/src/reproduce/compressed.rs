//! `slimbvh-lab reproduce compressed`.

mod bench;
mod cracks;
mod frames;
mod machine;
mod measure;
mod methods;
mod printed;
mod protocol;
mod report;
mod scenes;
mod tables;
mod targets;
#[cfg(test)]
mod tests;

use super::{check_places, hand_out, scenes_folder};
use anyhow::Result;
use clap::{Args, ValueEnum};
use measure::{SceneRecord, measure};
use protocol::Protocol;
use report::{LeftOut, Report};
use scenes::Subject;
use slimbvh_cli::backend::{BackendArguments, Chosen, choose, is_too_large};
use slimbvh_cli::{ThreadArguments, output};
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  slimbvh-lab reproduce compressed --quick
  slimbvh-lab reproduce compressed --only shiny bunny --json -
  slimbvh-lab reproduce compressed --scenes models --threads 2 --out compressed-cpu.md
  slimbvh-lab reproduce compressed --quick --backend gpu";

#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub struct CompressedArguments {
    /// Half a minute on two cores, three times as long with a GPU in software: small pictures, few repeats, nothing of 7.2 million
    /// triangles
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

    #[command(flatten)]
    backend: BackendArguments,

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
    let chosen = choose(&arguments.backend)?;
    let report = arguments.threads.run(|| make(arguments, chosen))??;
    hand_out(&report, &report.sheet(), out, json)
}

/// Measures on what was chosen.
fn make(arguments: &CompressedArguments, chosen: Chosen) -> Result<Report> {
    let protocol = match arguments.quick {
        true => Protocol::QUICK,
        false => Protocol::FULL,
    };
    #[cfg(feature = "gpu")]
    if let Chosen::GpuIfItFits(_) = chosen {
        return match measure_all(arguments, &chosen, &protocol) {
            Err(error) if slimbvh_cli::backend::is_the_gpus_fault(&error) => {
                output::warn(&format!("{error:#}; the CPU does it"));
                let scenes = measure_all(arguments, &Chosen::Cpu, &protocol)?;
                Ok(Report::new(arguments, &Chosen::Cpu, protocol, scenes))
            }
            scenes => Ok(Report::new(arguments, &chosen, protocol, scenes?)),
        };
    }
    let scenes = measure_all(arguments, &chosen, &protocol)?;
    Ok(Report::new(arguments, &chosen, protocol, scenes))
}

/// All scenes that are asked for. Those that nobody named are left out where the GPU does not take them.
fn measure_all(
    arguments: &CompressedArguments,
    chosen: &Chosen,
    protocol: &Protocol,
) -> Result<(Vec<SceneRecord>, Vec<LeftOut>)> {
    let folder = scenes_folder(arguments.scenes.as_deref());
    let (mut records, mut left_out) = (Vec::new(), Vec::new());
    for name in arguments.names() {
        let _progress = output::spinner(format!("measuring {}", name.shown()));
        let subject = Subject::new(name, folder.as_deref(), protocol.size)?;
        let scene = subject.name.to_owned();
        match measure(subject, chosen, protocol) {
            Ok(record) => records.push(record),
            Err(error) if arguments.only.is_empty() && is_too_large(&error) => {
                let why = format!("{error:#}");
                left_out.push(LeftOut { scene, why });
            }
            Err(error) => return Err(error),
        }
    }
    Ok((records, left_out))
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
        let mut words = vec!["slimbvh-lab reproduce compressed".to_owned()];
        if self.quick {
            words.push("--quick".into());
        }
        if !self.only.is_empty() {
            words.push("--only".into());
            words.extend(self.names().into_iter().map(SceneName::shown));
        }
        words.extend(self.threads.words());
        words.extend(self.backend.words());
        words.join(" ")
    }
}
