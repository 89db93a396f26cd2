//! Prints the parts of trace kernels and the sum of a primary ray, by RADV and, where it is installed, NVRTC.

use super::aco;
use super::child;
use super::flow::{Graph, Program};
use super::modules;
use super::nvrtc;
use super::options::Options;
use super::sass;
use super::split::{self, Split};
use anyhow::Result;
use std::path::PathBuf;

/// A kernel compiled by one of the compilers.
struct Compiled {
    kernel: String,
    compiler: String,
    registers: String,
    program: Program,
}

/// Prints the table.
pub fn run(options: &Options) -> Result<()> {
    let default = ["trace_closest", "trace_any"].map(modules::kernel);
    let files: &[PathBuf] = if options.files.is_empty() {
        &default
    } else {
        &options.files
    };
    let [nodes, triangles] = options.ray;
    println!(
        "Instructions of a ray with {nodes} node steps and {triangles} triangles; prepare and restore on the straight path, in \
         brackets with all slow paths.\n"
    );
    println!(
        "| kernel | compiler | registers | all | prepare | step | triangle | leaf | restore | ray |\n\
         |---|---|--:|--:|--:|--:|--:|--:|--:|--:|"
    );
    let mut notes = Vec::new();
    for file in files {
        for compiled in compile(options, file)? {
            notes.extend(print(&compiled, options.ray));
        }
    }
    if child::driver_file().is_none() {
        notes.push("Mesa's RADV is not installed".into());
    }
    for note in notes {
        println!("\n{note}");
    }
    Ok(())
}

fn compile(options: &Options, file: &PathBuf) -> Result<Vec<Compiled>> {
    let kernel = modules::name(file);
    let mut all = Vec::new();
    if child::driver_file().is_some() {
        let counts = child::statistics(&options.family, std::slice::from_ref(file))?;
        all.push(Compiled {
            kernel: kernel.clone(),
            compiler: format!("RADV, {}", options.family),
            registers: counts.rows[0].vgprs.to_string(),
            program: aco::parse(&child::assembly(&options.family, file)?),
        });
    }
    if nvrtc::is_there() {
        let (registers, text) = nvrtc::assembly(file)?;
        all.push(Compiled {
            kernel,
            compiler: "NVRTC".into(),
            registers,
            program: sass::parse(&text),
        });
    }
    Ok(all)
}

/// Prints a row. Returns a note if there is more to know.
fn print(compiled: &Compiled, ray: [f64; 2]) -> Option<String> {
    let Compiled {
        kernel,
        compiler,
        registers,
        program,
    } = compiled;
    let all = program.instructions.len();
    print!("| {kernel} | {compiler} | {registers} | {all} | ");
    // Other kernels have loops with and without private memory, too, but no walk.
    let split = Split::new(&Graph::new(program)).ok();
    let Some(split) = split.filter(|_| kernel.starts_with("trace")) else {
        println!("| | | | | |");
        let loops: Vec<String> = split::loops(program).iter().map(u64::to_string).collect();
        let loops = loops.join(", ");
        let note = format!("{kernel}, {compiler}: loops, each without those inside: {loops}");
        return (!loops.is_empty()).then_some(note);
    };
    let [straight, whole] = split.ray(ray);
    println!(
        "{} ({}) | {} | {} | {} | {} ({}) | {straight:.0} ({whole:.0}) |",
        split.prepare,
        split.outside[0],
        split.step,
        split.triangle,
        split.leaf,
        split.restore,
        split.outside[1],
    );
    let others = split.other_loops;
    let note = format!("{kernel}, {compiler}: instructions of {others} other loops count once");
    (others > 0).then_some(note)
}
