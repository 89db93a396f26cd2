//! Measures slimbvh and its peers side by side and writes a record. Exit codes: 0 done, 1 a tracer's answers are wrong,
//! 2 usage or input.

mod measure;
mod options;
mod report;
mod summary;

use anyhow::{Context, Result, ensure};
use measure::MeshRecord;
use options::Options;
use slimbvh_bench::meshes::SUBJECTS;
use std::process::ExitCode;

fn main() -> ExitCode {
    match run() {
        Ok(complaints) if complaints.is_empty() => ExitCode::SUCCESS,
        Ok(complaints) => {
            for complaint in complaints {
                eprintln!("WRONG {complaint}");
            }
            ExitCode::from(1)
        }
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::from(2)
        }
    }
}

/// Returns the faults of the answers, as sentences.
fn run() -> Result<Vec<String>> {
    let options = Options::parse(std::env::args().skip(1))?;
    if options.help {
        println!("{}", options::USAGE);
        return Ok(Vec::new());
    }
    let mut records: Vec<MeshRecord> = Vec::new();
    for subject in SUBJECTS {
        if !options.wants(subject.name) {
            continue;
        }
        if let Some(mesh) = subject.mesh()? {
            eprintln!("{}: {} triangles", subject.name, mesh.indices.len());
            records.push(measure::measure(subject.name, &mesh, &options)?);
        }
    }
    ensure!(!records.is_empty(), "no mesh to measure with");

    let text = report::report(&records, &options)?;
    print!("{text}");
    if let Some(path) = &options.out {
        std::fs::write(path, &text).with_context(|| format!("cannot write {path:?}"))?;
    }
    Ok(records
        .into_iter()
        .flat_map(|record| record.complaints)
        .collect())
}
