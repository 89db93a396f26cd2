//! `slimbvh-lab bench`.

mod cross;
mod equal;
mod facts;
mod findings;
mod likeness;
mod measure;
mod only;
mod page;
mod pareto;
mod prepared;
mod protocol;
mod report;
mod row;
mod scaling;
mod scenes;
mod setup;
mod spread;
#[cfg(test)]
mod tests;
mod times;
mod trial;

use crate::measure::machine::describe;
use anyhow::{Result, bail};
use clap::{Args, ValueEnum};
use measure::{Conditions, measure};
use only::Only;
use protocol::Protocol;
use report::{Measured, Report, check_folder};
use scenes::Subject;
use slimbvh_cli::backend::{BackendArguments, Chosen, choose};
use slimbvh_cli::options::{self, CameraOption};
use slimbvh_cli::{ThreadArguments, output};
use std::path::PathBuf;
use std::str::FromStr;

const EXAMPLES: &str = "\
Examples:
  slimbvh-lab bench --quick
  slimbvh-lab bench --quick --out report
  slimbvh-lab bench model.glb terrain --out report --threads 4
  slimbvh-lab bench --quick --backend cpu,gpu --out report
  slimbvh-lab bench model.glb --only reduce,refit,\"nodes w4-48\" --rounds 9
  slimbvh-lab bench model.glb --camera \"eye=0,1,5 target=0,0,0\" --size 640x360
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

    /// Only these setups besides the default, separated by commas: knobs (reduce, lights, nodes, mesh, codes, tree, update, threads,
    /// crossed), or parts of a setup's name as the table prints it ("nodes q10", "mesh lattice 0.5px", refit)
    #[arg(long, value_delimiter = ',', value_name = "SETUP")]
    only: Vec<String>,

    /// Camera of every scene, any of the parts "eye=X,Y,Z target=X,Y,Z up=X,Y,Z fov=DEGREES lens=RADIUS focus=DISTANCE", or
    /// height=H in place of fov for parallel rays; default: the scene's own camera, or one that frames it
    #[arg(long, value_name = "PARTS")]
    camera: Option<Camera>,

    /// Size of the pictures in pixels; default: 1280x720, and 320x180 with --quick
    #[arg(long, value_name = "WIDTHxHEIGHT", value_parser = options::size)]
    size: Option<[u32; 2]>,

    /// Timed pictures of each setup, beside as many of the default; default: 5, and 3 with --quick. Fewer than 3 show no spread
    #[arg(long, value_name = "N", value_parser = |text: &str| options::whole(text, 1..=1000))]
    rounds: Option<u32>,

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

/// A camera, with the text that gave it.
#[derive(Clone, Debug)]
struct Camera {
    text: String,
    option: CameraOption,
}

impl FromStr for Camera {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        Ok(Self {
            text: text.to_owned(),
            option: text.parse()?,
        })
    }
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
    let protocol = arguments.protocol();
    arguments.check_backends()?;
    // Read all scenes before the first measurement and before any adapter is opened, so that a bad scene is reported at once.
    let camera = arguments.camera.as_ref().map(|camera| &camera.option);
    let subjects = arguments.scenes.iter();
    let subjects = subjects.map(|name| Subject::new(name, protocol.size, camera));
    let subjects: Vec<Subject> = subjects.collect::<Result<_>>()?;
    let backends = arguments.backends()?;
    if let Some(folder) = &arguments.out {
        check_folder(folder)?;
    }
    let work = || -> Result<Report> {
        let threads = rayon::current_num_threads();
        let pairs = subjects
            .iter()
            .flat_map(|subject| backends.iter().map(move |backend| (subject, backend)));
        let lights = subjects.iter().map(|subject| subject.scene.lights.len());
        let only = Only::new(&arguments.only, threads, lights.max().unwrap_or(0))?;
        let conditions = Conditions {
            protocol: &protocol,
            threads,
            only: &only,
        };
        let records = pairs.map(|(subject, backend)| measure(subject, backend, &conditions));
        let records = records.collect::<Result<_>>()?;
        let mut scaling = Vec::new();
        for backend in backends.iter().filter(|_| arguments.scaling) {
            scaling.extend(scaling::measure(backend, &protocol, threads)?);
        }
        let measured = Measured { records, scaling };
        let machines = backends.iter().map(describe);
        let (command, machines) = (arguments.command(&only), machines.collect());
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
    /// The sizes and repeats.
    fn protocol(&self) -> Protocol {
        let usual = match self.quick {
            true => Protocol::QUICK,
            false => Protocol::FULL,
        };
        Protocol {
            size: self.size.unwrap_or(usual.size),
            rounds: self.rounds.unwrap_or(usual.rounds),
            ..usual
        }
    }

    /// Rejects a name of a GPU that no backend is for.
    fn check_backends(&self) -> Result<()> {
        if let (Some(name), false) = (&self.adapter, self.backend.contains(&Backend::Gpu)) {
            bail!("--adapter {name:?} needs a GPU, but --backend names none; add gpu to --backend");
        }
        Ok(())
    }

    /// Opens every requested backend once.
    fn backends(&self) -> Result<Vec<Chosen>> {
        let mut backends = self.backend.clone();
        backends.dedup();
        let open = |backend: &Backend| match backend {
            Backend::Cpu => Ok(Chosen::Cpu),
            Backend::Gpu => choose(&BackendArguments::gpu(self.adapter.clone())),
        };
        backends.iter().map(open).collect()
    }

    /// The command that reproduces the report, without the folders of scene files.
    fn command(&self, only: &Only) -> String {
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
        words.extend(only.words());
        let camera = self.camera.iter();
        words.extend(camera.map(|camera| format!("--camera {:?}", camera.text)));
        if let Some([width, height]) = self.size {
            words.push(format!("--size {width}x{height}"));
        }
        words.extend(self.rounds.map(|rounds| format!("--rounds {rounds}")));
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
