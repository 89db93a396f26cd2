//! Counts the instructions of frames with `--reduce auto`, `off` and `on`, to show that `auto` is never slower than `off`.
//! With `--growth` it counts builds, to show that their instructions grow linearly with the mesh.
//! Exit codes: 0 done, 1 the median of auto against off, or an exponent, is above the limit, 2 usage or input.

mod child;
mod count;
mod growth;
mod jobs;
mod options;
mod report;

use anyhow::{Context, Result, ensure};
use jobs::{Job, MODES};
use options::Options;
use rayon::prelude::*;
use report::Row;
use slimbvh_bench::exit;
use std::process::ExitCode;

/// The largest allowed median of the ratios of auto to off.
const LIMIT: f64 = 1.03;

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1).peekable();
    let result = match arguments.peek().map(String::as_str) {
        Some(child::WORD) => child::run(arguments.skip(1)).map(|()| None),
        Some(growth::WORD) => growth::run(arguments.skip(1)).map(|()| None),
        _ => run(arguments),
    };
    exit::code(result)
}

/// Returns the figure that is above its limit, as a sentence, if any.
fn run(arguments: impl Iterator<Item = String>) -> Result<Option<String>> {
    let options = Options::parse(arguments)?;
    if options.help {
        println!("{}", options::USAGE);
        return Ok(None);
    }
    count::check()?;
    let (text, fault) = if options.growth {
        let (text, is_within) = growth::record(&options)?;
        let fault = format!(
            "GROWS FASTER THAN THE MESH: an exponent is above {}",
            growth::LIMIT
        );
        (text, (!is_within).then_some(fault))
    } else {
        let (text, median) = frames(&options)?;
        let fault = format!("SLOWER: the median is above {LIMIT}");
        (text, (median > LIMIT).then_some(fault))
    };
    print!("{text}");
    if let Some(path) = &options.out {
        std::fs::write(path, &text).with_context(|| format!("cannot write {path:?}"))?;
    }
    Ok(fault)
}

/// Counts the frames of all jobs. Returns the record and the median ratio.
fn frames(options: &Options) -> Result<(String, f64)> {
    let jobs = jobs::jobs(options)?;
    ensure!(!jobs.is_empty(), "no scene to measure with");
    let rows: Vec<Row> = jobs.par_iter().map(measure).collect::<Result<_>>()?;
    report::report(&rows, options)
}

/// Counts a job in all modes.
fn measure(job: &Job) -> Result<Row> {
    let what = format!("{}, {}", job.scene.name, job.view.name);
    let counted = |mode, made| count::instructions(&child::arguments(job, mode, made), &what);
    let loading = counted(None, 0)?.instructions;
    let mut row = Row {
        job: *job,
        counts: [0; 3],
        said: String::new(),
    };
    for (mode, count) in MODES.iter().zip(&mut row.counts) {
        let first = counted(Some(*mode), 1)?;
        *count = first.instructions - loading;
        // All further frames take the same, so one is enough.
        if job.view.frame_count > 1 {
            let both = counted(Some(*mode), 2)?;
            let further = both.instructions - first.instructions;
            *count += u64::from(job.view.frame_count - 1) * further;
        }
        if *mode == slimbvh::reduce::Reduce::Auto {
            row.said = first.said;
        }
    }
    eprintln!("{what}: {:.4}", row.ratio());
    Ok(row)
}
