//! `slimbvh-lab bench`.

mod cross;
mod facts;
mod findings;
mod likeness;
mod measure;
mod page;
mod pareto;
mod prepared;
mod protocol;
mod report;
mod row;
mod scaling;
mod scenes;
mod setup;
#[cfg(test)]
mod tests;
mod times;
mod trial;

use crate::measure::machine::describe;
use anyhow::{Result, bail};
use clap::{Args, ValueEnum};
use measure::measure;
use protocol::Protocol;
use report::{Measured, Report, check_folder};
use scenes::Subject;
use slimbvh_cli::backend::{BackendArguments, Chosen, choose};
use slimbvh_cli::{ThreadArguments, output};
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  slimbvh-lab bench --quick
  slimbvh-lab bench --quick --out report
  slimbvh-lab bench model.glb terrain --out report --threads 4
  slimbvh-lab bench --quick --backend cpu,gpu --out report
  slimbvh-lab bench --scaling --out growth";

#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub struct BenchArguments {
    /// Scene files, or names: default, shiny, doll, toasters, 24-cell, teapot, knot, sphere, flake, terrain, grid, soup, slivers
    #[arg(
        value_name = "SCENE",
        default_value = "default",
        default_value_if("scaling", "true", None)
    )]
    scenes: Vec<String>,

    /// Small pictures and few repeats: half a minute for the default scene on two cores
    #[arg(long)]
    quick: bool,

    /// Measure how costs grow with triangles (1,000 to 10 million), rays (to 100 million), lights (to 64) and threads on a
    /// generated terrain: two minutes on two cores, some seconds and smaller amounts with --quick. Scenes are measured
    /// only if named
    #[arg(long)]
    scaling: bool,

    /// Folder for a page with plots (index.html), bench.csv and bench.json; created if missing
    #[arg(long, value_name = "FOLDER")]
    out: Option<PathBuf>,

    /// Backends to measure, separated by commas
    #[arg(
        long,
        value_enum,
        value_delimiter = ',',
        value_name = "BACKEND",
        default_value = "cpu"
    )]
    backend: Vec<Backend>,

    /// GPU whose name contains NAME, software adapters included; `slimbvh info --adapters` lists them
    #[arg(long, value_name = "NAME")]
    adapter: Option<String>,

    #[command(flatten)]
    threads: ThreadArguments,
}

/// A backend to measure.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Backend {
    /// The CPU
    Cpu,
    /// A GPU
    Gpu,
}

pub fn run(arguments: &BenchArguments) -> Result<()> {
    let protocol = match arguments.quick {
        true => Protocol::QUICK,
        false => Protocol::FULL,
    };
    let backends = arguments.backends()?;
    // Read all scenes before the first measurement, so that a bad scene is reported at once.
    let subjects = arguments.scenes.iter();
    let subjects = subjects.map(|name| Subject::new(name, protocol.size));
    let subjects: Vec<Subject> = subjects.collect::<Result<_>>()?;
    if let Some(folder) = &arguments.out {
        check_folder(folder)?;
    }
    let work = || -> Result<Report> {
        let threads = rayon::current_num_threads();
        let pairs = subjects
            .iter()
            .flat_map(|subject| backends.iter().map(move |backend| (subject, backend)));
        let records = pairs.map(|(subject, backend)| measure(subject, backend, &protocol, threads));
        let records = records.collect::<Result<_>>()?;
        let mut scaling = Vec::new();
        for backend in backends.iter().filter(|_| arguments.scaling) {
            scaling.extend(scaling::measure(backend, &protocol, threads)?);
        }
        let measured = Measured { records, scaling };
        let machines = backends.iter().map(describe);
        let (command, machines) = (arguments.command(), machines.collect());
        Ok(Report::new(command, machines, protocol, threads, measured))
    };
    let report = arguments.threads.run(work)??;
    output::print(&report.text())?;
    match &arguments.out {
        Some(folder) => report.write(folder),
        None => Ok(()),
    }
}

impl BenchArguments {
    /// Opens every requested backend once.
    fn backends(&self) -> Result<Vec<Chosen>> {
        if let (Some(name), false) = (&self.adapter, self.backend.contains(&Backend::Gpu)) {
            bail!("--adapter {name:?} needs a GPU, but --backend names none; add gpu to --backend");
        }
        let mut backends = self.backend.clone();
        backends.dedup();
        let open = |backend: &Backend| match backend {
            Backend::Cpu => Ok(Chosen::Cpu),
            Backend::Gpu => choose(&BackendArguments::gpu(self.adapter.clone())),
        };
        backends.iter().map(open).collect()
    }

    /// The command that reproduces the report, without the folders of scene files.
    fn command(&self) -> String {
        let mut words = vec!["slimbvh-lab bench".to_owned()];
        let name = |scene: &String| {
            let path = std::path::Path::new(scene);
            path.file_name()
                .map_or(scene.clone(), |name| name.to_string_lossy().into_owned())
        };
        words.extend(self.scenes.iter().map(name));
        for (flag, is_there) in [("--quick", self.quick), ("--scaling", self.scaling)] {
            words.extend(is_there.then(|| flag.to_owned()));
        }
        if self.backend != [Backend::Cpu] {
            let names = self.backend.iter().filter_map(ValueEnum::to_possible_value);
            let names: Vec<String> = names.map(|name| name.get_name().to_owned()).collect();
            words.push(format!("--backend {}", names.join(",")));
        }
        words.extend(
            self.adapter
                .iter()
                .map(|name| format!("--adapter {name:?}")),
        );
        words.extend(self.threads.words());
        words.join(" ")
    }
}
