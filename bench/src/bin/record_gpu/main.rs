//! Measures the GPU backend and writes a record: the work and the time of each stage. Exit codes: 0 done, 1 an answer
//! differs from the CPU's, 2 usage or input.

mod decide;
mod measure;
mod report;

use anyhow::{Context, Result, bail};
use measure::MeshRecord;
use slimbvh::gpu::{AdapterChoice, Gpu};
use slimbvh::{Mesh, generate};
use slimbvh_bench::meshes::SUBJECTS;
use slimbvh_bench::rays::ROWS_OPTION;
use slimbvh_bench::{RayOrder, exit};
use std::process::ExitCode;

const USAGE: &str = "\
record-gpu [--out FILE] [--rounds N] [--rows] [--adapter NAME] [MESH...]
  --out FILE      also write the tables to FILE
  --rounds N      measure N times (default 9)
  --rows          hand rays over row by row (default in tiles of 8x8 pixels)
  --adapter NAME  the GPU with this in its name (default the strongest, software if nothing else)
  MESH...         these meshes (default dragon, and large: a terrain of 10 million triangles)";

fn main() -> ExitCode {
    exit::code(run().map(exit::wrong_answers))
}

/// Returns the number of wrong answers.
fn run() -> Result<u64> {
    let (mut out, mut rounds, mut choice) = (None, 9, AdapterChoice::Any);
    let mut order = RayOrder::default();
    let mut names = Vec::new();
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        let mut value = || {
            arguments
                .next()
                .with_context(|| format!("{argument} needs a value"))
        };
        match argument.as_str() {
            "--help" | "-h" => {
                println!("{USAGE}");
                return Ok(0);
            }
            "--out" => out = Some(value()?),
            "--rounds" => rounds = value()?.parse().context("--rounds needs a number")?,
            ROWS_OPTION => order = RayOrder::Rows,
            "--adapter" => choice = AdapterChoice::Named(value()?),
            name if name.starts_with('-') => bail!("there is no option {name:?}\n{USAGE}"),
            _ => names.push(argument),
        }
    }
    if names.is_empty() {
        names = vec!["dragon".into(), "large".into()];
    }
    let gpu = Gpu::open(&choice)?;
    let mut records: Vec<MeshRecord> = Vec::new();
    for name in &names {
        if let Some(mesh) = mesh(name)? {
            eprintln!("{name}: {} triangles", mesh.indices.len());
            records.push(measure::measure(&gpu, name, &mesh, (rounds, order))?);
        }
    }
    let text = report::report(&gpu, &records, (rounds, order), &names)?;
    print!("{text}");
    if let Some(path) = &out {
        std::fs::write(path, &text).with_context(|| format!("cannot write {path:?}"))?;
    }
    let wrong: usize = records.iter().map(|record| record.wrong_answers).sum();
    Ok(wrong as u64)
}

/// A mesh by name; `None` if its file is missing.
fn mesh(name: &str) -> Result<Option<Mesh>> {
    if name == "large" {
        return Ok(Some(generate::terrain(10.0, 2237, 7)));
    }
    let subject = SUBJECTS.iter().find(|subject| subject.name == name);
    let subject = subject.with_context(|| format!("there is no mesh {name:?}"))?;
    subject.mesh()
}
