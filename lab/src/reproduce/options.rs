//! The options of either paper, and what follows from them.

use super::sheet::Sheet;
use anyhow::{Result, bail};
use clap::{Args, ValueEnum};
use serde::Serialize;
use slimbvh_cli::backend::{BackendArguments, Chosen, choose};
use slimbvh_cli::{ThreadArguments, output};
use std::path::{Path, PathBuf};

/// The environment variable that names the folder of scene files.
const SCENES_VARIABLE: &str = "SLIMBVH_SCENES";

/// What to measure, on what, and where the report goes. `S` are the paper's scenes.
#[derive(Debug, Args)]
pub struct Options<S: ValueEnum + Send + Sync + 'static> {
    /// Half a minute on two cores: small pictures, few repeats, without the largest scene
    #[arg(long)]
    pub quick: bool,

    /// Only these scenes; the papers print no figures of the dragon
    #[arg(long, value_enum, value_name = "NAME", num_args = 1..)]
    pub only: Vec<S>,

    /// Folder with armadillo.off, bunny00.off and dragon.ply; else that which SLIMBVH_SCENES names. A generated mesh stands in for
    /// a missing one
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

/// A scene's name as the options take it.
pub fn shown(scene: &impl ValueEnum) -> String {
    let value = scene.to_possible_value();
    value.map_or("scene".into(), |value| value.get_name().to_owned())
}

impl<S: ValueEnum + PartialEq + Send + Sync + 'static> Options<S> {
    /// Makes a report on the chosen backend, prints it and writes it. Where `auto` found a GPU that cannot do it, the CPU does.
    pub fn run<R: Serialize + Send>(
        &self,
        make: impl Fn(&Chosen) -> Result<R> + Send,
        sheet: impl Fn(&R) -> Sheet<'_>,
    ) -> Result<()> {
        self.check_places()?;
        let chosen = choose(&self.backend)?;
        let report = self.threads.run(|| or_on_cpu(&chosen, make))??;
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

    /// Refuses, before the work, a folder that is not there and files that have no place to go.
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
        match self.json.as_deref() {
            Some(json) if !output::is_stdout(Some(json)) => {
                output::check_place(json, out.as_slice())
            }
            _ => Ok(()),
        }
    }

    /// The folder of scene files, if there is one.
    pub fn folder(&self) -> Option<PathBuf> {
        let variable = || std::env::var_os(SCENES_VARIABLE).map(PathBuf::from);
        self.scenes
            .as_deref()
            .map(Path::to_path_buf)
            .or_else(variable)
    }

    /// The scenes that are asked for, in the order of their declaration; `--quick` leaves out the largest.
    pub fn names(&self, largest: &S) -> Vec<S> {
        let all = S::value_variants().iter().cloned();
        let is_wanted = |name: &S| match self.only.is_empty() {
            true => !(self.quick && name == largest),
            false => self.only.contains(name),
        };
        all.filter(is_wanted).collect()
    }

    /// The command that makes the same report again, without the names of folders and files.
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
        words.extend(self.threads.words());
        words.extend(self.backend.words());
        words.join(" ")
    }
}

/// Does work on the chosen backend, or on the CPU where nobody asked for the GPU that cannot do it.
fn or_on_cpu<R>(chosen: &Chosen, work: impl Fn(&Chosen) -> Result<R>) -> Result<R> {
    let done = work(chosen);
    #[cfg(feature = "gpu")]
    if let (Chosen::GpuIfItFits(_), Err(error)) = (chosen, &done)
        && slimbvh_cli::backend::is_the_gpus_fault(error)
    {
        output::warn(&format!("{error:#}; the CPU does it"));
        return work(&Chosen::Cpu);
    }
    done
}
