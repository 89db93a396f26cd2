//! `slimbvh-lab reproduce`: the papers' tables, measured again.

mod compressed;
mod facing_target;
mod layout;
mod lights;
mod measure;
mod options;
mod printed;
mod protocol;
mod report;
mod savings;
mod scenes;
mod sheet;
mod steps;
mod tables;
mod times;
mod verdicts;
mod visits;

use crate::own::Own;
use anyhow::Result;
use clap::{Args, Subcommand, ValueEnum};
use measure::{SceneRecord, measure};
use options::{Options, shown};
use protocol::Protocol;
use report::Report;
use scenes::Subject;
use slimbvh_cli::backend::Chosen;
use slimbvh_cli::output;

#[derive(Debug, Args)]
pub struct ReproduceArguments {
    #[command(subcommand)]
    paper: Paper,
}

#[derive(Debug, Subcommand)]
enum Paper {
    /// Reduced trees: tables I to VI of Wong, Cheng and Lii, "Reduced BVHs for GPU Ray Tracing" (2012), measured again and
    /// printed beside the paper's figures
    Reduced(ReducedArguments),
    /// Compressed trees: box tests, triangle tests, bytes and times of a paper on compressed hierarchies (after Karras
    /// 2012), measured again and printed beside the paper's figures
    Compressed(compressed::CompressedArguments),
}

const EXAMPLES: &str = "\
Examples:
  slimbvh-lab reproduce reduced --quick
  slimbvh-lab reproduce reduced --only doll toasters --json -
  slimbvh-lab reproduce reduced --mesh model.glb
  slimbvh-lab reproduce reduced --scenes models --threads 2 --out reduced-cpu.md";

#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub struct ReducedArguments {
    #[command(flatten)]
    options: Options<SceneName>,
}

/// The scenes of the paper or their stand-ins, and one more.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum SceneName {
    Doll,
    Toasters,
    #[value(name = "24-cell")]
    TwentyFourCell,
    Armadillo,
    Dragon,
}

pub fn run(arguments: &ReproduceArguments) -> Result<()> {
    match &arguments.paper {
        Paper::Reduced(arguments) => reduced(arguments),
        Paper::Compressed(arguments) => compressed::run(arguments),
    }
}

fn reduced(ReducedArguments { options }: &ReducedArguments) -> Result<()> {
    options.run(|chosen, own| make(options, chosen, own), Report::sheet)
}

/// Measures on the chosen backend.
fn make(options: &Options<SceneName>, chosen: &Chosen, own: &[Own]) -> Result<Report> {
    let protocol = if options.quick {
        Protocol::quick()
    } else {
        Protocol::full()
    };
    let folder = options.folder();
    let measure_one = |name: SceneName| {
        let _progress = output::spinner(format!("measuring {}", shown(&name)));
        let subject = Subject::new(name, folder.as_deref(), protocol.size)?;
        measure(subject, chosen, &protocol, name == SceneName::Armadillo)
    };
    let measure_own = |own: &Own| {
        let _progress = output::spinner(format!("measuring {}", own.name));
        measure(Subject::own(own, protocol.size)?, chosen, &protocol, true)
    };
    let names = options.names(&SceneName::Dragon).into_iter();
    let scenes = own.iter().map(measure_own).chain(names.map(measure_one));
    let scenes: Vec<SceneRecord> = scenes.collect::<Result<_>>()?;
    Ok(Report::new(options, chosen, protocol, scenes))
}
