//! The options of both papers.

use super::sheet::Sheet;
use crate::own::{self, Own};
use anyhow::{Result, bail};
use clap::{Args, ValueEnum};
use serde::Serialize;
use slimbvh_cli::backend::{BackendArguments, Chosen, choose};
use slimbvh_cli::{ThreadArguments, output};
use std::path::{Path, PathBuf};

/// The environment variable that names the folder of scene files.
const SCENES_VARIABLE: &str = "SLIMBVH_SCENES";

/// What to measure, on which backend, and where the report goes. `S` are the paper's scenes.
#[derive(Debug, Args)]
pub struct Options<S: ValueEnum + Send + Sync + 'static> {
    /// Small pictures, few repeats and no largest scene: half a minute on two cores
    #[arg(long)]
    pub quick: bool,

    /// Only these scenes, with --mesh beside its meshes; the papers have no figures of the dragon
    #[arg(long, value_enum, value_name = "NAME", num_args = 1..)]
    pub only: Vec<S>,

    /// Meshes of one's own, in any format that slimbvh reads, in place of the built-in scenes; the papers have no figures of them
    #[arg(long, value_name = "FILE", num_args = 1..)]
    mesh: Vec<PathBuf>,

    /// The built-in scenes beside the meshes of --mesh
    #[arg(long)]
    built_in: bool,

    /// Folder with armadillo.off, bunny00.off and dragon.ply; default: the folder in SLIMBVH_SCENES. A generated mesh stands
    /// in for a missing file
    #[arg(long, value_name = "FOLDER")]
    scenes: Option<PathBuf>,

    /// Write the report as a Markdown file as well
    #[arg(long, value_name = "FILE.md")]
    out: Option<PathBuf>,

    #[command(flatten)]
    threads: ThreadArguments,

    #[command(flatten)]
    backend: BackendArguments,

    /// Write all measurements as JSON; "-" is standard output
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

/// What reports say of a mesh of one's own.
pub const OWN: &str = "given by --mesh: the paper has no figures of it";

/// The name of a scene on the command line.
pub fn shown(scene: &impl ValueEnum) -> String {
    let value = scene.to_possible_value();
    value.map_or("scene".into(), |value| value.get_name().to_owned())
}

impl<S: ValueEnum + PartialEq + Send + Sync + 'static> Options<S> {
    /// Makes a report on the chosen backend, prints it and writes it. If a GPU that `auto` found fails, the CPU takes over.
    pub fn run<R: Serialize + Send>(
        &self,
        make: impl Fn(&Chosen, &[Own]) -> Result<R> + Sync,
        sheet: impl Fn(&R) -> Sheet<'_>,
    ) -> Result<()> {
        self.check_places()?;
        // Read all meshes before an adapter is opened, so that a bad one is reported at once.
        let own = Own::load_all(&self.mesh)?;
        let chosen = choose(&self.backend)?;
        let work = || or_on_cpu(&chosen, |chosen| make(chosen, &own));
        let report = self.threads.run(work)??;
        let json = self.json.as_deref();
        if !output::is_stdout(json) {
            output::print(&sheet(&report).text())?;
        }
        if let Some(path) = &self.out {
            output::write_whole(path, sheet(&report).markdown().as_bytes())?;
        }
        match json {
            Some(path) => output::write_json(path, &report),
            None => Ok(()),
        }
    }

    /// Checks before the work that the folder exists and that the files can be written.
    fn check_places(&self) -> Result<()> {
        if let Some(folder) = self.scenes.as_deref().filter(|folder| !folder.is_dir()) {
            bail!("there is no folder {:?}", folder.display().to_string());
        }
        let out = self.out.as_deref();
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
        output::check_report(self.json.as_deref(), out.as_slice())
    }

    /// The folder of scene files, if there is one.
    pub fn folder(&self) -> Option<PathBuf> {
        let variable = || std::env::var_os(SCENES_VARIABLE).map(PathBuf::from);
        self.scenes
            .as_deref()
            .map(Path::to_path_buf)
            .or_else(variable)
    }

    /// The requested built-in scenes, in the order of their declaration: without `--only` none beside `--mesh`, unless `--built-in`
    /// asks for them, and `--quick` leaves out the largest.
    pub fn names(&self, largest: &S) -> Vec<S> {
        let all = S::value_variants().iter().cloned();
        let is_asked = self.mesh.is_empty() || self.built_in;
        let is_wanted = |name: &S| match self.only.is_empty() {
            true => is_asked && !(self.quick && name == largest),
            false => self.only.contains(name),
        };
        all.filter(is_wanted).collect()
    }

    /// The command that reproduces the report, without folders and the names of files other than meshes.
    pub fn command(&self, paper: &str) -> String {
        let mut words = vec![format!("slimbvh-lab reproduce {paper}")];
        if self.quick {
            words.push("--quick".into());
        }
        if !self.only.is_empty() {
            words.push("--only".into());
            let all = S::value_variants().iter();
            words.extend(all.filter(|name| self.only.contains(name)).map(shown));
        }
        if !self.mesh.is_empty() {
            words.push("--mesh".into());
            words.extend(self.mesh.iter().map(|path| own::name(path)));
        }
        if self.built_in {
            words.push("--built-in".into());
        }
        words.extend(self.threads.words());
        words.extend(self.backend.words());
        words.join(" ")
    }
}

/// Works on the chosen backend, or on the CPU if a GPU that `auto` found cannot do it.
fn or_on_cpu<R>(chosen: &Chosen, work: impl Fn(&Chosen) -> Result<R>) -> Result<R> {
    let done = work(chosen);
    #[cfg(feature = "gpu")]
    if let (Chosen::GpuIfItFits(_), Err(error)) = (chosen, &done)
        && slimbvh_cli::backend::is_the_gpus_fault(error)
    {
        output::warn(&format!(
            "{}; using the CPU instead",
            output::sentence(error)
        ));
        return work(&Chosen::Cpu);
    }
    done
}
