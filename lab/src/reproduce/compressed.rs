//! `slimbvh-lab reproduce compressed`.

mod bench;
mod cracks;
mod frames;
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

use super::options::{Options, shown};
use crate::own::Own;
use anyhow::Result;
use clap::{Args, ValueEnum};
use measure::{SceneRecord, measure};
use protocol::Protocol;
use report::{LeftOut, Report};
use scenes::Subject;
use slimbvh_cli::backend::{Chosen, is_too_large};
use slimbvh_cli::output;

const EXAMPLES: &str = "\
Examples:
  slimbvh-lab reproduce compressed --quick
  slimbvh-lab reproduce compressed --only shiny bunny --json -
  slimbvh-lab reproduce compressed --mesh model.glb scan.ply
  slimbvh-lab reproduce compressed --scenes models --threads 2 --out compressed-cpu.md
  slimbvh-lab reproduce compressed --quick --backend gpu";

#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub struct CompressedArguments {
    #[command(flatten)]
    options: Options<SceneName>,
}

/// The scenes of the paper or their stand-ins, and one more.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum SceneName {
    Shiny,
    Bunny,
    Dragon,
    AsianDragon,
}

pub fn run(CompressedArguments { options }: &CompressedArguments) -> Result<()> {
    options.run(|chosen, own| make(options, chosen, own), Report::sheet)
}

/// Measures on the chosen backend.
fn make(options: &Options<SceneName>, chosen: &Chosen, own: &[Own]) -> Result<Report> {
    let protocol = match options.quick {
        true => Protocol::QUICK,
        false => Protocol::FULL,
    };
    let scenes = measure_all(options, chosen, &protocol, own)?;
    Ok(Report::new(options, chosen, protocol, scenes))
}

/// Measures all requested scenes. A scene that was not requested by name is left out if the GPU cannot hold it.
fn measure_all(
    options: &Options<SceneName>,
    chosen: &Chosen,
    protocol: &Protocol,
    own: &[Own],
) -> Result<(Vec<SceneRecord>, Vec<LeftOut>)> {
    let folder = options.folder();
    let (mut records, mut left_out) = (Vec::new(), Vec::new());
    for own in own {
        let _progress = output::spinner(format!("measuring {}", own.name));
        records.push(measure(Subject::own(own, protocol.size), chosen, protocol)?);
    }
    for name in options.names(&SceneName::AsianDragon) {
        let _progress = output::spinner(format!("measuring {}", shown(&name)));
        let subject = Subject::new(name, folder.as_deref(), protocol.size)?;
        let scene = subject.name.clone();
        match measure(subject, chosen, protocol) {
            Ok(record) => records.push(record),
            Err(error) if options.only.is_empty() && is_too_large(&error) => {
                let why = output::sentence(&error);
                left_out.push(LeftOut { scene, why });
            }
            Err(error) => return Err(error),
        }
    }
    Ok((records, left_out))
}
