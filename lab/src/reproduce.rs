//! `slimbvh-lab reproduce`.

mod aim;
mod compressed;
mod layout;
mod lights;
mod machine;
mod measure;
mod printed;
mod protocol;
mod report;
mod savings;
mod scenes;
mod sheet;
mod tables;
mod times;
mod verdicts;
mod visits;

use anyhow::{Result, bail};
use clap::{Args, Subcommand, ValueEnum};
use measure::{SceneRecord, measure};
use protocol::Protocol;
use report::Report;
use scenes::Subject;
use serde::Serialize;
use sheet::Sheet;
use slimbvh_cli::backend::{BackendArguments, Chosen, choose};
use slimbvh_cli::{ThreadArguments, output};
use std::path::{Path, PathBuf};

/// The environment variable that names the folder of scene files.
const SCENES_VARIABLE: &str = "SLIMBVH_SCENES";

#[derive(Debug, Args)]
pub struct ReproduceArguments {
    #[command(subcommand)]
    paper: Paper,
}

#[derive(Debug, Subcommand)]
enum Paper {
    /// Reduced trees: tables I to VI of Wong, Cheng and Lii, "Reduced BVHs for GPU Ray Tracing" (2012), ours beside the
    /// printed ones
    Reduced(ReducedArguments),
    /// Compressed trees: box tests, triangle tests, bytes and times of a paper on compressed hierarchies (after Karras 2012),
    /// ours beside the printed ones
    Compressed(compressed::CompressedArguments),
}

const EXAMPLES: &str = "\
Examples:
  slimbvh-lab reproduce reduced --quick
  slimbvh-lab reproduce reduced --only doll toasters --json -
  slimbvh-lab reproduce reduced --scenes models --threads 2 --out reduced-cpu.md";

#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub struct ReducedArguments {
    /// Half a minute on two cores: small pictures, few repeats, no 16×16 samples, no dragon
    #[arg(long)]
    quick: bool,

    /// Only these scenes; of the dragon nothing is printed
    #[arg(long, value_enum, value_name = "NAME", num_args = 1..)]
    only: Vec<SceneName>,

    /// Folder with armadillo.off and dragon.ply; else that which SLIMBVH_SCENES names. What is missing is stood in for
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

fn reduced(arguments: &ReducedArguments) -> Result<()> {
    let (out, json) = (arguments.out.as_deref(), arguments.json.as_deref());
    check_places(arguments.scenes.as_deref(), out, json)?;
    let chosen = choose(&arguments.backend)?;
    let report = arguments.threads.run(|| make(arguments, chosen))??;
    hand_out(&report, &report.sheet(), out, json)
}

/// Prints a report, unless its JSON is printed, and writes the files that are asked for.
fn hand_out(
    report: &impl Serialize,
    sheet: &Sheet,
    out: Option<&Path>,
    json: Option<&Path>,
) -> Result<()> {
    if !output::is_stdout(json) {
        output::print(&sheet.text())?;
    }
    if let Some(path) = out {
        output::write_whole(path, sheet.markdown().as_bytes())?;
    }
    match json {
        Some(path) => output::write_json(path, report),
        None => Ok(()),
    }
}

/// Tells before the work, not after it, that a file has no place to go, or a folder is not there.
fn check_places(scenes: Option<&Path>, out: Option<&Path>, json: Option<&Path>) -> Result<()> {
    if let Some(folder) = scenes.filter(|folder| !folder.is_dir()) {
        bail!("there is no folder {:?}", folder.display().to_string());
    }
    if let Some(out) = out {
        let is_markdown = out
            .extension()
            .is_some_and(|e| e.eq_ignore_ascii_case("md"));
        if !is_markdown {
            bail!(
                "{:?} does not end in .md; reports are written as Markdown",
                out.display().to_string()
            );
        }
        output::check_place(out, &[])?;
    }
    match json {
        Some(json) if !output::is_stdout(Some(json)) => output::check_place(json, out.as_slice()),
        _ => Ok(()),
    }
}

/// The folder of scene files, if there is one.
fn scenes_folder(asked: Option<&Path>) -> Option<PathBuf> {
    let variable = || std::env::var_os(SCENES_VARIABLE).map(PathBuf::from);
    asked.map(Path::to_path_buf).or_else(variable)
}

/// Measures on what was chosen.
fn make(arguments: &ReducedArguments, chosen: Chosen) -> Result<Report> {
    let protocol = if arguments.quick {
        Protocol::quick()
    } else {
        Protocol::full()
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

fn measure_all(
    arguments: &ReducedArguments,
    chosen: &Chosen,
    protocol: &Protocol,
) -> Result<Vec<SceneRecord>> {
    let folder = scenes_folder(arguments.scenes.as_deref());
    let measure_one = |name: SceneName| {
        let shown = name.to_possible_value();
        let shown = shown.as_ref().map_or("scene", |value| value.get_name());
        let _progress = output::spinner(format!("measuring {shown}"));
        let subject = Subject::new(name, folder.as_deref(), protocol.size)?;
        measure(subject, chosen, protocol, name == SceneName::Armadillo)
    };
    arguments.names().into_iter().map(measure_one).collect()
}

impl ReducedArguments {
    /// The scenes that are asked for, in the paper's order.
    fn names(&self) -> Vec<SceneName> {
        let all = SceneName::value_variants().iter().copied();
        let is_wanted = |name: &SceneName| match self.only.is_empty() {
            true => !(self.quick && *name == SceneName::Dragon),
            false => self.only.contains(name),
        };
        all.filter(is_wanted).collect()
    }

    /// The command that makes the same report again, without the names of folders and files.
    fn command(&self) -> String {
        let mut words = vec!["slimbvh-lab reproduce reduced".to_owned()];
        if self.quick {
            words.push("--quick".into());
        }
        if !self.only.is_empty() {
            let names = self
                .names()
                .into_iter()
                .filter_map(|name| name.to_possible_value());
            words.push("--only".into());
            words.extend(names.map(|name| name.get_name().to_owned()));
        }
        words.extend(self.threads.words());
        words.extend(self.backend.words());
        words.join(" ")
    }
}
