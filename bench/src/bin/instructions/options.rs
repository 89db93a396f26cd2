//! The command line.

use super::jobs::SCENES;
use anyhow::{Context, Result, bail};
use slimbvh_bench::meshes::SCENES_VARIABLE;

/// The text of `--help`.
pub const USAGE: &str = "\
instructions [--out FILE] [--growth | SCENE...]
  --out FILE  also write the tables to FILE
  --growth    count builds over terrains of 1,000 to 10,000,000 triangles, not frames
  SCENE...    only these scenes (default all)";

/// The command line, parsed.
pub struct Options {
    /// Print the usage only.
    pub help: bool,
    /// The file to write the record to.
    pub out: Option<String>,
    /// Count builds over growing meshes, not frames.
    pub growth: bool,
    /// Names of the scenes; empty selects all.
    scenes: Vec<String>,
}

impl Options {
    /// Parses the arguments.
    pub fn parse(mut arguments: impl Iterator<Item = String>) -> Result<Self> {
        let mut options = Self {
            help: false,
            out: None,
            growth: false,
            scenes: Vec::new(),
        };
        while let Some(argument) = arguments.next() {
            match argument.as_str() {
                "--help" | "-h" => options.help = true,
                "--out" => options.out = Some(arguments.next().context("--out needs a file")?),
                "--growth" => options.growth = true,
                name if SCENES.iter().any(|scene| scene.name == name) => {
                    options.scenes.push(argument);
                }
                _ => bail!("there is no option or scene {argument:?}\n{USAGE}"),
            }
        }
        if options.growth && !options.scenes.is_empty() {
            bail!("--growth takes no scene\n{USAGE}");
        }
        Ok(options)
    }

    /// Whether the options select a scene.
    pub fn wants(&self, name: &str) -> bool {
        self.scenes.is_empty() || self.scenes.iter().any(|scene| scene == name)
    }

    /// The command that repeats this record, without paths of this machine.
    pub fn command(&self) -> String {
        let mut words = Vec::new();
        if !self.growth && std::env::var_os(SCENES_VARIABLE).is_some() {
            words.push(format!("{SCENES_VARIABLE}=scenes"));
        }
        words.push("cargo run --release --bin instructions --".into());
        words.extend(self.growth.then(|| "--growth".to_owned()));
        words.extend(self.scenes.iter().map(|scene| format!("{scene:?}")));
        if let Some(out) = &self.out {
            let path = std::path::Path::new(out);
            let name = path
                .file_name()
                .map_or(out.as_str().into(), |name| name.to_string_lossy());
            words.push(format!("--out record/{name}"));
        }
        words.join(" ")
    }
}
