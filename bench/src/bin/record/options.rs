//! The command line.

use anyhow::{Context, Result, bail, ensure};
use slimbvh_bench::meshes::{SCENES_VARIABLE, SUBJECTS};
use slimbvh_bench::rays::ROWS_OPTION;
use slimbvh_bench::tracers::{OURS, tracers};
use slimbvh_bench::{Input, RayOrder};
use std::path::Path;

/// The text of `--help`.
pub const USAGE: &str = "\
record [--out FILE] [--rounds N] [--rows] [--only TRACER,...] [MESH...]
  --out FILE         also write the tables to FILE
  --rounds N         measure N times, at least 5 (default 9)
  --rows             hand rays over row by row (default in tiles of 8x8 pixels)
  --only TRACER,...  only tracers with one of these in their names, and slimbvh's tree of 30-bit codes
  MESH...            only these meshes (default all)";

const DEFAULT_ROUNDS: usize = 9;

/// The command line, parsed.
pub struct Options {
    /// Print the usage only.
    pub help: bool,
    /// The file to write the record to.
    pub out: Option<String>,
    /// The number of rounds.
    pub rounds: usize,
    /// The order of the rays.
    pub order: RayOrder,
    /// Parts of the names of tracers; empty selects all.
    only: Vec<String>,
    /// Names of the meshes; empty selects all.
    meshes: Vec<String>,
}

impl Options {
    /// Parses the arguments.
    pub fn parse(mut arguments: impl Iterator<Item = String>) -> Result<Self> {
        let mut options = Self {
            help: false,
            out: None,
            rounds: DEFAULT_ROUNDS,
            order: RayOrder::default(),
            only: Vec::new(),
            meshes: Vec::new(),
        };
        while let Some(argument) = arguments.next() {
            match argument.as_str() {
                "--help" | "-h" => options.help = true,
                "--out" => {
                    let file = arguments.next().context("--out needs a file")?;
                    options.out = Some(file);
                }
                "--rounds" => {
                    let count = arguments.next().and_then(|count| count.parse().ok());
                    options.rounds = count.context("--rounds needs a number")?;
                }
                ROWS_OPTION => options.order = RayOrder::Rows,
                "--only" => {
                    let names = arguments.next().context("--only needs names of tracers")?;
                    options.only = names.split(',').map(str::to_owned).collect();
                }
                name if SUBJECTS.iter().any(|subject| subject.name == name) => {
                    options.meshes.push(argument);
                }
                _ => bail!("there is no option or mesh {argument:?}\n{USAGE}"),
            }
        }
        let mesh = slimbvh::Mesh::default();
        let input = Input::new(&mesh);
        let names: Vec<&str> = tracers(&input).iter().map(|tracer| tracer.name()).collect();
        for part in &options.only {
            ensure!(
                names.iter().any(|name| name.contains(part.as_str())),
                "there is no tracer {part:?} in this build, which has {}",
                names.join(", ")
            );
        }
        ensure!(options.rounds >= 5, "--rounds must be at least 5");
        Ok(options)
    }

    /// Whether the options select a mesh.
    pub fn wants(&self, name: &str) -> bool {
        self.meshes.is_empty() || self.meshes.iter().any(|mesh| mesh == name)
    }

    /// Whether the options select a tracer.
    pub fn wants_tracer(&self, name: &str) -> bool {
        let is_named = |part: &String| name.contains(part.as_str());
        self.only.is_empty() || name == OURS || self.only.iter().any(is_named)
    }

    /// The command that repeats this record, without paths of this machine.
    pub fn command(&self) -> String {
        let mut words = Vec::new();
        if std::env::var_os(SCENES_VARIABLE).is_some() {
            words.push(format!("{SCENES_VARIABLE}=scenes"));
        }
        let flags = env!("BENCH_RUSTFLAGS");
        if !flags.is_empty() {
            words.push(format!("RUSTFLAGS={flags:?}"));
        }
        words.push("cargo run --release --bin record".into());
        if cfg!(not(feature = "parallel")) {
            words.push("--no-default-features".into());
        }
        let features = features();
        if !features.is_empty() {
            words.push(format!("--features {}", features.join(",")));
        }
        words.push("--".into());
        if self.rounds != DEFAULT_ROUNDS {
            words.push(format!("--rounds {}", self.rounds));
        }
        if self.order == RayOrder::Rows {
            words.push(ROWS_OPTION.into());
        }
        if !self.only.is_empty() {
            words.push(format!("--only {:?}", self.only.join(",")));
        }
        if let Some(out) = &self.out {
            let path = Path::new(out);
            let name = path.file_name().unwrap_or(path.as_os_str());
            let shown = if path.is_absolute() {
                Path::new(name)
            } else {
                path
            };
            words.push(format!("--out {}", shown.display()));
        }
        words.extend(self.meshes.iter().map(|mesh| format!("{mesh:?}")));
        words.join(" ")
    }
}

/// Features that are on, without the default one.
fn features() -> Vec<&'static str> {
    let all = [
        ("small-nodes", cfg!(feature = "small-nodes")),
        ("tinybvh", cfg!(feature = "tinybvh")),
        ("embree", cfg!(feature = "embree")),
    ];
    let on = all.into_iter().filter(|(_, is_on)| *is_on);
    on.map(|(name, _)| name).collect()
}
