//! The command line.

use crate::peers::asked;
use anyhow::{Context, Result, bail, ensure};
use slimbvh_lab::stress::{Effort, cases};
use std::time::Duration;

/// The text of `--help`.
pub const USAGE: &str = "\
peers [--quick] [--only PEER,...] [--family NAME] [--limit SECONDS] [--json FILE]
  --quick            smaller scenes and fewer rays
  --only PEER,...    only peers with one of these in their names (default all)
  --family NAME      only families of scenes with this in their name (default all)
  --limit SECONDS    how long a peer may take for a scene (default 60)
  --json FILE        write rows for `slimbvh-lab stress --with FILE`; to standard output, without a table, for \"-\"";

const DEFAULT_LIMIT: u64 = 60;

/// The command line, parsed.
pub struct Options {
    /// Print the usage only.
    pub help: bool,
    /// The number of scenes and rays.
    pub effort: Effort,
    /// The time limit of a peer for a scene.
    pub limit: Duration,
    /// The file to write rows to.
    pub json: Option<String>,
    /// Parts of the names of peers; empty selects all.
    only: Vec<String>,
    /// A part of the names of families.
    family: String,
}

impl Options {
    /// Parses the arguments.
    pub fn parse(mut arguments: impl Iterator<Item = String>) -> Result<Self> {
        let mut options = Self {
            help: false,
            effort: Effort::Full,
            limit: Duration::from_secs(DEFAULT_LIMIT),
            json: None,
            only: Vec::new(),
            family: String::new(),
        };
        while let Some(argument) = arguments.next() {
            let mut value = |what| {
                arguments
                    .next()
                    .with_context(|| format!("{argument} needs {what}"))
            };
            match argument.as_str() {
                "--help" | "-h" => options.help = true,
                "--quick" => options.effort = Effort::Quick,
                "--only" => {
                    let names = value("names of peers")?;
                    options.only = names.split(',').map(str::to_owned).collect();
                }
                "--family" => options.family = value("a name")?,
                "--json" => options.json = Some(value("a file")?),
                "--limit" => {
                    let seconds = value("seconds")?;
                    let seconds: Option<u64> = seconds.parse().ok().filter(|&seconds| seconds > 0);
                    let seconds =
                        seconds.context("--limit needs a whole number of seconds above 0")?;
                    options.limit = Duration::from_secs(seconds);
                }
                _ => bail!("there is no option {argument:?}\n{USAGE}"),
            }
        }
        for name in &options.only {
            let mut all = asked();
            ensure!(
                all.any(|peer| peer.tracer.contains(name.as_str())),
                "there is no peer {name:?} in this build, which has {}",
                asked()
                    .map(|peer| peer.tracer)
                    .collect::<Vec<_>>()
                    .join(", ")
            );
        }
        let cases = cases(Effort::Quick);
        ensure!(
            cases.iter().any(|case| options.wants_family(&case.family)),
            "there is no family with {:?} in its name",
            options.family
        );
        Ok(options)
    }

    /// Whether the options select a peer.
    pub fn wants(&self, name: &str) -> bool {
        self.only.is_empty() || self.only.iter().any(|part| name.contains(part.as_str()))
    }

    /// Whether the options select a family.
    pub fn wants_family(&self, name: &str) -> bool {
        name.contains(&self.family)
    }

    /// The command that repeats these rows, without names of files.
    pub fn command(&self) -> String {
        let mut words = vec!["peers".to_owned()];
        if self.effort == Effort::Quick {
            words.push("--quick".into());
        }
        if !self.only.is_empty() {
            words.push(format!("--only {:?}", self.only.join(",")));
        }
        if !self.family.is_empty() {
            words.push(format!("--family {:?}", self.family));
        }
        if self.limit.as_secs() != DEFAULT_LIMIT {
            words.push(format!("--limit {}", self.limit.as_secs()));
        }
        words.join(" ")
    }
}
