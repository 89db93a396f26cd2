//! `slimbvh-lab stress`.

mod report;
mod tables;
#[cfg(test)]
mod tests;
mod tracers;

use super::{Case, Effort, Row, cases, run as ask};
use crate::own::{self, Own};
use anyhow::{Context, Result, anyhow, bail};
use clap::{Args, ValueEnum};
use report::{Others, Report};
use slimbvh_cli::{ThreadArguments, output};
use std::path::PathBuf;
use std::process::ExitCode;
use tracers::tracers;

const EXAMPLES: &str = "\
Examples:
  slimbvh-lab stress --quick
  slimbvh-lab stress --backend cpu,gpu --adapter llvmpipe
  slimbvh-lab stress --only slivers flat --json -
  slimbvh-lab stress model.glb scan.ply
  slimbvh-lab stress model.glb --built-in --quick
  slimbvh-lab stress --with peers.json

Exit codes: 0 slimbvh passed, 1 slimbvh missed a hit, reported a false or wrong one, or moved a vertex too far, 2 bad
input.";

#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub struct StressArguments {
    /// Meshes of one's own, in any format that slimbvh reads, in place of the built-in families
    #[arg(value_name = "FILE")]
    files: Vec<PathBuf>,

    /// The built-in families beside the files
    #[arg(long)]
    built_in: bool,

    /// Smaller scenes, fewer rays and fewer codecs: half a minute on two cores
    #[arg(long)]
    quick: bool,

    /// Backends to test, separated by a comma
    #[arg(long, value_enum, value_delimiter = ',', default_value = "cpu")]
    backend: Vec<Backend>,

    /// GPU whose name contains NAME, software adapters included; `slimbvh info --adapters` lists them
    #[arg(long, value_name = "NAME")]
    adapter: Option<String>,

    /// Only families whose name contains FAMILY; with files, these beside them
    #[arg(long, value_name = "FAMILY", num_args = 1..)]
    only: Vec<String>,

    /// Rows of other tracers to show beside slimbvh's, as JSON that --json wrote; they do not change the exit code
    #[arg(long, value_name = "FILE")]
    with: Vec<PathBuf>,

    #[command(flatten)]
    threads: ThreadArguments,

    /// Write all rows as JSON; "-" is standard output
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Backend {
    /// The CPU
    Cpu,
    /// A GPU
    Gpu,
}

pub fn run(arguments: &StressArguments) -> Result<ExitCode> {
    let taken: Vec<_> = arguments.with.iter().map(PathBuf::as_path).collect();
    output::check_report(arguments.json.as_deref(), &taken)?;
    let others = arguments.with.iter().map(|path| Others::read(path));
    let others = others.collect::<Result<Vec<_>>>()?;
    let report = arguments.threads.run(|| -> Result<Report> {
        let mut rows = measure(arguments)?;
        rows.extend(others.into_iter().flat_map(|others| others.rows));
        Ok(Report::new(arguments, rows))
    })??;
    if !output::is_stdout(arguments.json.as_deref()) {
        output::print(&report.text())?;
    }
    if let Some(json) = &arguments.json {
        output::write_json(json, &report)?;
    }
    Ok(ExitCode::from(u8::from(!report.is_clean())))
}

/// Traces every case with every tracer.
fn measure(arguments: &StressArguments) -> Result<Vec<Row>> {
    // Read all files before the first measurement and before any adapter is opened, so that a bad one is reported at once.
    let own = arguments.files.iter().map(|path| {
        let Own { name, scene } = Own::load(path)?;
        Ok(Case::own(name, scene.mesh, arguments.effort())?)
    });
    let mut all = own.collect::<Result<Vec<Case>>>()?;
    let built_in = cases(arguments.effort()).into_iter();
    all.extend(built_in.filter(|case| arguments.wants(&case.family)));
    let cases = all;
    if cases.is_empty() {
        bail!(
            "there is no family whose name contains {:?}",
            arguments.only
        );
    }
    let mut tracers = tracers(arguments)?;
    let bar = output::bar("tracing");
    let mut rows = Vec::new();
    for (number, case) in cases.iter().enumerate() {
        bar.set(number as f64 / cases.len() as f64);
        for tracer in &mut tracers {
            let asked = ask(tracer.as_mut(), case).map_err(|error| anyhow!(error));
            rows.extend(asked.with_context(|| format!("{} {}", case.family, case.magnitude))?);
        }
    }
    Ok(rows)
}

impl StressArguments {
    fn effort(&self) -> Effort {
        match self.quick {
            true => Effort::Quick,
            false => Effort::Full,
        }
    }

    fn wants(&self, family: &str) -> bool {
        let is_in = |part: &String| family.contains(part.as_str());
        match self.only.is_empty() {
            true => self.files.is_empty() || self.built_in,
            false => self.only.iter().any(is_in),
        }
    }

    /// What is traced, for the head of the report.
    fn scenes(&self) -> String {
        let names: Vec<String> = self.files.iter().map(|path| own::name(path)).collect();
        let families = match (self.only.is_empty(), self.files.is_empty() || self.built_in) {
            (false, _) => format!(
                "built-in families with {} in their names",
                quoted(&self.only)
            ),
            (true, true) => "all built-in families".to_owned(),
            (true, false) => return format!("meshes of one's own only: {}", names.join(", ")),
        };
        match names.is_empty() {
            true => families,
            false => format!("meshes of one's own ({}), and {families}", names.join(", ")),
        }
    }

    /// The command that reproduces the report, without the folders of meshes and the names of other files.
    fn command(&self) -> String {
        let mut words = vec!["slimbvh-lab stress".to_owned()];
        words.extend(self.files.iter().map(|path| own::name(path)));
        if self.built_in {
            words.push("--built-in".into());
        }
        if self.quick {
            words.push("--quick".into());
        }
        let backends = self.backend.iter().filter_map(Backend::to_possible_value);
        let backends: Vec<_> = backends.map(|value| value.get_name().to_owned()).collect();
        words.push(format!("--backend {}", backends.join(",")));
        words.extend(
            self.adapter
                .iter()
                .map(|name| format!("--adapter {name:?}")),
        );
        if !self.only.is_empty() {
            words.push("--only".into());
            words.extend(self.only.iter().map(|part| format!("{part:?}")));
        }
        words.extend(self.threads.words());
        words.join(" ")
    }
}

/// Words in quotes, separated by commas.
fn quoted(words: &[String]) -> String {
    let words: Vec<String> = words.iter().map(|word| format!("{word:?}")).collect();
    words.join(", ")
}
