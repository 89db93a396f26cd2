//! The tables that compare slimbvh with each library's best tree.

use crate::measure::{MeshRecord, Run, TracerRecord};
use anyhow::Result;
use std::fmt::Write;

/// The table of whole frames.
pub fn frames(out: &mut String, records: &[MeshRecord]) -> Result<()> {
    writeln!(out, "## Frames beside each peer's best\n")?;
    writeln!(
        out,
        "Build with buffers kept, primary and shadow rays, in milliseconds: of every library the tree with the shortest \
         frame, picked after the run for each mesh and number of threads. After the colon slimbvh's time as a multiple of \
         the peer's: below 1 slimbvh is faster.\n"
    )?;
    table(out, records, Run::frame_ms)
}

/// The table of tracing alone.
pub fn traces(out: &mut String, records: &[MeshRecord]) -> Result<()> {
    writeln!(out, "## Tracing alone beside each peer's best tree\n")?;
    writeln!(
        out,
        "As above, of primary and shadow rays alone, as if trees cost nothing: of every library the tree that traces \
         fastest.\n"
    )?;
    table(out, records, Run::trace_ms)
}

fn table(out: &mut String, records: &[MeshRecord], time: fn(&Run) -> f64) -> Result<()> {
    let libraries = libraries(records);
    writeln!(out, "| mesh | threads | {} |", libraries.join(" | "))?;
    writeln!(out, "|---|--:|{}", "--:|".repeat(libraries.len()))?;
    for record in records {
        let run_count = record.tracers.first().map_or(0, |first| first.runs.len());
        for run in 0..run_count {
            let ours = best(record, libraries[0], run, time);
            let cells = libraries.iter().enumerate().map(|(i, library)| {
                let Some((tree, ms)) = best(record, library, run, time) else {
                    return "–".into();
                };
                let ratio = ours.map_or(f64::NAN, |(_, ours)| ours / ms);
                match (i, tree) {
                    (0, _) => format!("{ms:.1} {tree}"),
                    (_, "") => format!("{ms:.1}: {ratio:.2}"),
                    _ => format!("{ms:.1} {tree}: {ratio:.2}"),
                }
            });
            let cells: Vec<String> = cells.collect();
            let threads = record.tracers[0].runs[run].threads;
            writeln!(
                out,
                "| {} | {threads} | {} |",
                record.name,
                cells.join(" | ")
            )?;
        }
    }
    writeln!(out)?;
    Ok(())
}

/// The libraries, slimbvh first.
fn libraries(records: &[MeshRecord]) -> Vec<&str> {
    let mut libraries = Vec::new();
    for tracer in records.iter().flat_map(|record| &record.tracers) {
        let (library, _) = tracer.library_and_tree();
        if !libraries.contains(&library) {
            libraries.push(library);
        }
    }
    libraries
}

/// The fastest tree of a library, and its time.
fn best<'a>(
    record: &'a MeshRecord,
    library: &str,
    run: usize,
    time: fn(&Run) -> f64,
) -> Option<(&'a str, f64)> {
    let own = |tracer: &'a TracerRecord| {
        let (name, tree) = tracer.library_and_tree();
        (name == library).then(|| (tree, time(&tracer.runs[run])))
    };
    let trees = record.tracers.iter().filter_map(own);
    trees.min_by(|a, b| a.1.total_cmp(&b.1))
}

/// The table of pixels that differ from slimbvh's.
pub fn missed(out: &mut String, records: &[MeshRecord]) -> Result<()> {
    writeln!(out, "## Missed pixels\n")?;
    writeln!(
        out,
        "Primary rays that hit for slimbvh, whose test of a triangle is watertight, and miss for the tracer + those that \
         only hit for the tracer.\n"
    )?;
    let meshes: Vec<&str> = records.iter().map(|record| record.name).collect();
    writeln!(out, "| tracer | {} |", meshes.join(" | "))?;
    writeln!(out, "|---|{}", "--:|".repeat(meshes.len()))?;
    for (i, tracer) in records[0].tracers.iter().enumerate() {
        let cells = records.iter().map(|record| {
            let seen = &record.tracers[i].primary;
            format!("{} + {}", seen.missed, seen.extra)
        });
        let cells: Vec<String> = cells.collect();
        writeln!(out, "| {} | {} |", tracer.name, cells.join(" | "))?;
    }
    writeln!(out)?;
    Ok(())
}
