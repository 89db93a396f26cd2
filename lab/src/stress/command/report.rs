//! The report as text and as JSON.

use super::StressArguments;
use super::tables::tables;
use crate::measure::machine::processor;
use crate::measure::table::wrap;
use crate::stress::{BOUND_ULPS, Row};
use anyhow::{Context, Result};
use serde::{Deserialize, Serialize};
use slimbvh_cli::output::{count, things};
use std::path::Path;

/// All measurements, and the facts needed to read them.
#[derive(Serialize)]
pub struct Report {
    /// The command that reproduces the report.
    command: String,
    quick: bool,
    /// Which scenes: the built-in families, or meshes of one's own.
    scenes: String,
    machine: String,
    threads: usize,
    /// The bound that slimbvh is judged by, in ulps of the largest coordinate of origin and triangle.
    bound_ulps: f64,
    /// One row per tracer, family, magnitude, backend, codec and reduction.
    rows: Vec<Row>,
}

/// The part of another report that is read.
#[derive(Deserialize)]
pub struct Others {
    pub rows: Vec<Row>,
}

impl Others {
    pub fn read(path: &Path) -> Result<Self> {
        let shown = path.display().to_string();
        let text =
            std::fs::read_to_string(path).with_context(|| format!("cannot read {shown:?}"))?;
        let rows = serde_json::from_str(&text);
        rows.with_context(|| format!("{shown:?} has no rows in the format of --json"))
    }
}

impl Report {
    pub fn new(arguments: &StressArguments, rows: Vec<Row>) -> Self {
        let threads = rayon::current_num_threads();
        Self {
            command: arguments.command(),
            quick: arguments.quick,
            scenes: arguments.scenes(),
            machine: format!("{}, {}", processor(), things(threads, "thread")),
            threads,
            bound_ulps: BOUND_ULPS,
            rows,
        }
    }

    fn own(&self) -> impl Iterator<Item = &Row> {
        self.rows.iter().filter(|row| row.tracer == "slimbvh")
    }

    /// Whether all answers of slimbvh are right, and all vertices kept to their bounds.
    pub fn is_clean(&self) -> bool {
        self.own()
            .all(|row| row.faults() == 0 && row.keeps_its_bound())
    }

    fn verdict(&self) -> String {
        let rays: u64 = self.own().map(|row| row.rays).sum();
        let faults: u64 = self.own().map(Row::faults).sum();
        let moved = self.own().filter(|row| !row.keeps_its_bound()).count();
        let moved = match moved {
            0 => String::new(),
            _ => format!(
                "; vertices moved beyond their bound in {}",
                things(moved, "tree")
            ),
        };
        match faults {
            0 => format!(
                "{} of slimbvh: none missed, false or wrong{moved}",
                things(rays, "answer")
            ),
            _ => format!(
                "{} of slimbvh: {} at fault{moved}",
                things(rays, "answer"),
                count(faults)
            ),
        }
    }

    /// The report as text.
    pub fn text(&self) -> String {
        let mut text = String::from("Rays that are hard for tracers, judged by exact answers\n");
        let bound = format!(
            "a ray that passes farther than {BOUND_ULPS} ulps of the largest coordinate of its origin and the triangle from every border and \
             silhouette must hit what the exact ray hits, and a reported hit must be no farther off its triangle. From inside a closed \
             surface every ray must hit something, without tolerance. Codecs are judged by the triangles that they store"
        );
        let head = [
            ("command", format!("`{}`", self.command)),
            ("scenes", self.scenes.clone()),
            ("machine", self.machine.clone()),
            ("judged by", bound),
            ("verdict", self.verdict()),
        ];
        for (name, value) in head {
            let mut lines = String::new();
            wrap(&mut lines, &value, 100);
            for (i, line) in lines.lines().enumerate() {
                let name = if i == 0 { name } else { "" };
                text += format!("{name:<10} {line}").trim_end();
                text.push('\n');
            }
        }
        for table in tables(&self.rows) {
            text.push('\n');
            text += &table.text();
        }
        text
    }
}
