//! The report as text, as a page, and as tables for programs.

use super::equal::Equal;
use super::findings::{Finding, Verdict, findings};
use super::measure::SceneRecord;
use super::page::page;
use super::protocol::Protocol;
use super::row::{Origin, Row, csv};
use super::scaling::{LONG_MS, LONG_ROUNDS, MOST_COUNTED_SAMPLES, Series};
use super::spread;
use crate::measure::table::{Table, wrap};
use anyhow::{Context, Result};
use serde::Serialize;
use slimbvh_cli::output::{self, things};
use std::fmt::Write;
use std::path::Path;
use std::process::Command;

/// All measurements, and the facts needed to read them.
#[derive(Serialize)]
pub struct Report {
    /// The command that reproduces the report.
    pub command: String,
    pub version: &'static str,
    /// The commit of the sources, if they are still present.
    pub commit: Option<String>,
    /// The name of the machine, by backend.
    pub machines: Vec<(&'static str, String)>,
    pub threads: usize,
    pub protocol: Protocol,
    pub findings: Vec<Finding>,
    pub rows: Vec<Row>,
    /// Setups that were not measured twice.
    pub equal: Vec<Equal>,
    /// The growth of costs, if requested.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub scaling: Vec<Series>,
    #[serde(skip)]
    pub records: Vec<SceneRecord>,
}

/// The measurements of a report.
pub struct Measured {
    pub records: Vec<SceneRecord>,
    pub scaling: Vec<Series>,
}

/// Names of the files in the report's folder.
pub const FILES: [&str; 3] = ["index.html", "bench.csv", "bench.json"];

impl Report {
    pub fn new(
        command: String,
        machines: Vec<(&'static str, String)>,
        protocol: Protocol,
        threads: usize,
        Measured { records, scaling }: Measured,
    ) -> Self {
        let commit = commit();
        let machine = |backend| {
            let mut machines = machines.iter();
            let own = machines.find(|(name, _)| *name == backend);
            own.map_or("", |(_, machine)| machine)
        };
        let rows = records.iter().flat_map(|scene| {
            let origin = Origin {
                machine: machine(scene.backend),
                commit: commit.as_deref(),
            };
            let rows = scene.setups.iter();
            rows.map(move |record| Row::new(scene, record, &origin))
        });
        let rows: Vec<Row> = rows.collect();
        Self {
            command,
            version: env!("CARGO_PKG_VERSION"),
            commit,
            machines,
            threads,
            protocol,
            findings: records.iter().flat_map(findings).collect(),
            rows,
            equal: records.iter().flat_map(|it| it.equal.clone()).collect(),
            scaling,
            records,
        }
    }

    /// The facts needed to read the figures.
    pub fn head(&self) -> Vec<(&'static str, String)> {
        let version = match &self.commit {
            Some(commit) => format!("{}, {commit}", self.version),
            None => self.version.into(),
        };
        let mut head = vec![("command", self.command.clone()), ("version", version)];
        head.extend(self.machines.iter().cloned());
        if !self.records.is_empty() {
            head.extend(self.of_scenes());
        }
        if !self.scaling.is_empty() {
            head.push(("growth", self.of_growth()));
        }
        head
    }

    /// The conditions of the figures of scenes.
    fn of_scenes(&self) -> [(&'static str, String); 5] {
        let [width, height] = self.protocol.size;
        let rounds = things(self.protocol.rounds, "picture");
        [
            (
                "pictures",
                format!("{width}×{height} pixels, one sample each; from the mesh to the picture, trees included"),
            ),
            (
                "times",
                format!(
                    "the default's medians, times the median over {rounds} of each setup's ratio to the default, with which it alternates, \
                     after an untimed one"
                ),
            ),
            ("spread", spread::rule()),
            (
                "counts",
                "box tests, triangle tests and bytes, counted by the traversal over all rays of the picture".into(),
            ),
            (
                "errors",
                "compared with the picture of one tree over all triangles without codecs; tolerances are in pixels of 1280×720".into(),
            ),
        ]
    }

    /// The conditions of the figures of growth.
    fn of_growth(&self) -> String {
        let [width, height] = self.protocol.size;
        let [small_width, small_height] = self.protocol.small_size;
        let rounds = things(self.protocol.rounds, "picture");
        let long = match self.protocol.rounds > LONG_ROUNDS {
            true => format!(
                ", or of {LONG_ROUNDS} if one takes more than {} s",
                LONG_MS / 1e3
            ),
            false => String::new(),
        };
        format!(
            "one whole tree over a terrain, without codecs; pictures of {width}×{height} pixels for triangles and threads, of \
             {small_width}×{small_height} for lights and rays, with more samples per pixel for more rays; medians of {rounds} after \
             an untimed one{long}; bytes a ray over at most \
             {MOST_COUNTED_SAMPLES} samples per pixel"
        )
    }

    pub fn rows_of<'a>(&'a self, scene: &'a SceneRecord) -> impl Iterator<Item = &'a Row> {
        let is_of = |row: &&Row| row.scene == scene.name && row.backend == scene.backend;
        self.rows.iter().filter(is_of)
    }

    pub fn findings_of<'a>(&'a self, scene: &'a SceneRecord) -> impl Iterator<Item = &'a Finding> {
        let is_of = |it: &&Finding| it.scene == scene.name && it.backend == scene.backend;
        self.findings.iter().filter(is_of)
    }

    /// The report as text.
    pub fn text(&self) -> String {
        let mut text = String::new();
        // Writing to a string cannot fail.
        for (name, value) in self.head() {
            let mut lines = String::new();
            wrap(&mut lines, &value, 88);
            for (i, line) in lines.lines().enumerate() {
                let name = if i == 0 { name } else { "" };
                let _ = writeln!(text, "{name:<10} {line}");
            }
        }
        for scene in &self.records {
            let _ = write!(text, "\n{}", self.table(scene).text());
            for finding in self.findings_of(scene) {
                let sign = match finding.verdict {
                    Verdict::Wins => '+',
                    Verdict::Loses => '-',
                    Verdict::Open => '?',
                    Verdict::Holds => '=',
                    Verdict::Fails => '!',
                };
                let mut lines = String::new();
                wrap(&mut lines, &finding.text, 94);
                for (i, line) in lines.lines().enumerate() {
                    let sign = if i == 0 { sign } else { ' ' };
                    let _ = writeln!(text, "  {sign} {line}");
                }
            }
        }
        for series in &self.scaling {
            let _ = write!(text, "\n{}", series.table().text());
        }
        text
    }

    fn table(&self, scene: &SceneRecord) -> Table {
        let cells = |row: &Row| {
            vec![
                row.setup.clone(),
                ms(row.frame_ms),
                format!("{:.0} %", 100.0 * row.frame_spread),
                format!("{:.2}", row.frame_ratio),
                format!("{:.0}", row.resident_bytes as f64 / 1024.0),
                format!("{:.1}", row.box_tests_per_ray),
                format!("{:.0}", row.bytes_per_ray),
                format!("{:.3}", row.image_rmse),
                match (row.on_front, row.front_is_clear) {
                    (true, true) => "*",
                    (true, false) => "?",
                    (false, _) => "",
                }
                .into(),
            ]
        };
        let mut notes = vec![
            "* on the Pareto front of time, bytes and error; ? there by less than the spread of these runs"
                .into(),
        ];
        notes.extend(same_work(scene));
        Table {
            title: format!("{} on the {}", scene.name, scene.backend.to_uppercase()),
            notes,
            word_columns: 1,
            head: vec![
                "setup",
                "ms",
                "spread",
                "x default",
                "KiB",
                "boxes/ray",
                "bytes/ray",
                "RMSE",
                "*",
            ],
            rows: self.rows_of(scene).map(cells).collect(),
        }
    }

    /// Writes the page and the tables into a folder.
    pub fn write(&self, folder: &Path) -> Result<()> {
        let [html, table, json] = FILES.map(|name| folder.join(name));
        output::write_whole(&html, page(self)?.as_bytes())?;
        output::write_whole(&table, &csv(&self.rows)?)?;
        output::write_json(&json, self)
    }
}

/// A time in milliseconds, as tables and bars show it.
pub fn ms(ms: f64) -> String {
    format!("{ms:.2}")
}

/// The setups that were not measured, in a sentence; `None` if all were.
pub fn same_work(scene: &SceneRecord) -> Option<String> {
    let pairs = scene.equal.iter();
    let pairs: Vec<String> = pairs
        .map(|it| format!("\"{}\" ({})", it.setup, it.measured_as))
        .collect();
    (!pairs.is_empty()).then(|| {
        format!(
            "Not measured, as each does the same work as the setup in parentheses: {}.",
            pairs.join(", ")
        )
    })
}

/// Creates the folder if it is missing, and checks before the work that its files can be written.
pub fn check_folder(folder: &Path) -> Result<()> {
    if !folder.is_dir() {
        let shown = folder.display().to_string();
        std::fs::create_dir(folder).with_context(|| format!("cannot make the folder {shown:?}"))?;
    }
    for name in FILES {
        output::check_place(&folder.join(name), &[])?;
    }
    Ok(())
}

/// The current commit of the source folder that this binary was built from, and whether it has changes.
fn commit() -> Option<String> {
    let git = |arguments: &[&str]| {
        let mut git = Command::new("git");
        git.args(["-C", env!("CARGO_MANIFEST_DIR")]).args(arguments);
        let output = git.output().ok().filter(|output| output.status.success())?;
        String::from_utf8(output.stdout).ok()
    };
    // Another repository around a copy of the sources says nothing about them.
    git(&["ls-files", "--error-unmatch", "Cargo.toml"])?;
    let describe = [
        "describe",
        "--always",
        "--dirty=, with changes",
        "--abbrev=10",
    ];
    let text = git(&describe)?;
    Some(text.trim().to_owned()).filter(|text| !text.is_empty())
}
