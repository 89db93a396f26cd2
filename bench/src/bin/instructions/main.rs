//! Counts the instructions of frames with `--reduce auto`, `off` and `on`: whether the plan is ever slower than no plan.
//! Exit codes: 0 done, 1 the median of auto against off is above the limit, 2 usage or input.

mod child;
mod count;
mod jobs;
mod options;
mod report;

use anyhow::{Context, Result, ensure};
use jobs::{Job, MODES};
use options::Options;
use rayon::prelude::*;
use report::Row;
use std::process::ExitCode;

/// What the median of all ratios of auto to off may be.
const LIMIT: f64 = 1.03;

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1).peekable();
    let result = if arguments.peek().is_some_and(|first| first == child::WORD) {
        child::run(arguments.skip(1)).map(|()| true)
    } else {
        run(arguments)
    };
    match result {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => {
            eprintln!("SLOWER: the median is above {LIMIT}");
            ExitCode::from(1)
        }
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::from(2)
        }
    }
}

/// Returns whether the median is within the limit.
fn run(arguments: impl Iterator<Item = String>) -> Result<bool> {
    let options = Options::parse(arguments)?;
    if options.help {
        println!("{}", options::USAGE);
        return Ok(true);
    }
    count::check()?;
    let jobs = jobs::jobs(&options)?;
    ensure!(!jobs.is_empty(), "no scene to measure with");
    let rows: Vec<Row> = jobs.par_iter().map(measure).collect::<Result<_>>()?;
    let (text, median) = report::report(&rows, &options)?;
    print!("{text}");
    if let Some(path) = &options.out {
        std::fs::write(path, &text).with_context(|| format!("cannot write {path:?}"))?;
    }
    Ok(median <= LIMIT)
}

/// All modes of a job.
fn measure(job: &Job) -> Result<Row> {
    let loading = count::instructions(job, None, 0)?.instructions;
    let mut row = Row {
        job: *job,
        counts: [0; 3],
        said: String::new(),
    };
    for (mode, count) in MODES.iter().zip(&mut row.counts) {
        let first = count::instructions(job, Some(*mode), 1)?;
        *count = first.instructions - loading;
        // Each further frame takes the same: one tells.
        if job.view.frame_count > 1 {
            let both = count::instructions(job, Some(*mode), 2)?;
            let further = both.instructions - first.instructions;
            *count += u64::from(job.view.frame_count - 1) * further;
        }
        if *mode == slimbvh::reduce::Reduce::Auto {
            row.said = first.said;
        }
    }
    eprintln!("{}, {}: {:.4}", job.scene.name, job.view.name, row.ratio());
    Ok(row)
}
