//! Peers on the scenes and rays of `slimbvh-lab stress`, judged as slimbvh is. Exit codes: 0 done, 2 usage or input.

mod child;
mod contain;
mod options;
mod peers;
mod table;

use anyhow::{Context, Result, anyhow};
use options::Options;
use peers::Peers;
use serde::Serialize;
use slimbvh_lab::stress::{Row, cases, run as ask};
use std::process::ExitCode;

/// The file for `slimbvh-lab stress --with FILE`: rows, and the command that made them.
#[derive(Serialize)]
struct Report {
    command: String,
    rows: Vec<Row>,
}

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1).peekable();
    let result = if arguments.peek().is_some_and(|first| first == child::WORD) {
        child::run(arguments.skip(1))
    } else {
        run(arguments)
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::from(2)
        }
    }
}

fn run(arguments: impl Iterator<Item = String>) -> Result<()> {
    let options = Options::parse(arguments)?;
    if options.help {
        println!("{}", options::USAGE);
        return Ok(());
    }
    let rows = measure(&options)?;
    let json = options.json.as_deref();
    if json != Some("-") {
        print!("{}", table::text(&rows));
    }
    if let Some(path) = json {
        let report = Report {
            command: options.command(),
            rows,
        };
        let text = serde_json::to_string_pretty(&report)?;
        if path == "-" {
            println!("{text}");
        } else {
            std::fs::write(path, text).with_context(|| format!("cannot write {path:?}"))?;
        }
    }
    Ok(())
}

/// Traces every case with every peer.
fn measure(options: &Options) -> Result<Vec<Row>> {
    let mut peers = Peers::new(options)?;
    let mut rows = Vec::new();
    for (number, case) in cases(options.effort).iter().enumerate() {
        if !options.wants_family(&case.family) {
            continue;
        }
        eprintln!("{}, {}", case.family, case.magnitude);
        peers.number = number;
        let asked = ask(&mut peers, case).map_err(|error| anyhow!(error));
        let asked = asked.with_context(|| format!("{}, {}", case.family, case.magnitude))?;
        rows.extend(asked.into_iter().map(|row| peers.named(row)));
    }
    Ok(rows)
}
