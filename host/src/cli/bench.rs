//! `slimbvh bench`.

mod cross;
mod facts;
mod findings;
mod likeness;
mod machine;
mod measure;
mod page;
mod pareto;
mod prepared;
mod protocol;
mod report;
mod row;
mod scenes;
mod setup;
#[cfg(test)]
mod tests;
mod times;

use super::measure::machine::processor;
use super::{ThreadArguments, output};
use anyhow::Result;
use clap::Args;
use measure::measure;
use protocol::Protocol;
use report::{Report, check_folder};
use scenes::Subject;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  slimbvh bench --quick
  slimbvh bench --quick --out report
  slimbvh bench model.glb terrain --out report --threads 4";

#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub struct BenchArguments {
    /// Scene files, or names: default, shiny, doll, toasters, 24-cell, teapot, knot, sphere, flake, terrain, grid, soup, slivers
    #[arg(value_name = "SCENE", default_value = "default")]
    scenes: Vec<String>,

    /// Half a minute for the default scene on two cores: small pictures, few repeats
    #[arg(long)]
    quick: bool,

    /// Write a page with plots (index.html), bench.csv and bench.json into this folder, which is made if it is not there
    #[arg(long, value_name = "FOLDER")]
    out: Option<PathBuf>,

    #[command(flatten)]
    threads: ThreadArguments,
}

pub fn run(arguments: &BenchArguments) -> Result<()> {
    let protocol = match arguments.quick {
        true => Protocol::QUICK,
        false => Protocol::FULL,
    };
    // All are read before the first is measured, so that what is wrong with one is told at once.
    let subjects = arguments.scenes.iter();
    let subjects = subjects.map(|name| Subject::new(name, protocol.size));
    let subjects: Vec<Subject> = subjects.collect::<Result<_>>()?;
    if let Some(folder) = &arguments.out {
        check_folder(folder)?;
    }
    let work = || -> Result<Report> {
        let threads = rayon::current_num_threads();
        let records = subjects.into_iter();
        let records = records.map(|subject| measure(subject, &protocol, threads));
        let records = records.collect::<Result<_>>()?;
        let cores = format!("{}, {}", processor(), output::things(threads, "thread"));
        let machines = vec![("cpu", cores)];
        let command = arguments.command();
        Ok(Report::new(command, machines, protocol, threads, records))
    };
    let report = arguments.threads.run(work)??;
    output::print(&report.text())?;
    match &arguments.out {
        Some(folder) => report.write(folder),
        None => Ok(()),
    }
}

impl BenchArguments {
    /// The command that makes the same report again, without the names of folders.
    fn command(&self) -> String {
        let mut words = vec!["slimbvh bench".to_owned()];
        let name = |scene: &String| {
            let path = std::path::Path::new(scene);
            path.file_name()
                .map_or(scene.clone(), |name| name.to_string_lossy().into_owned())
        };
        words.extend(self.scenes.iter().map(name));
        if self.quick {
            words.push("--quick".into());
        }
        words.extend(self.threads.words());
        words.join(" ")
    }
}
