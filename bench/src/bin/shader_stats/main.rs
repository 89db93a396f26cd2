//! What a GPU's compiler makes of each committed shader module: instructions, registers, scratch and workgroup memory.
//! Mesa's RADV compiles for an AMD GPU that need not be there; the counts are compared with `record/shaders.csv`.
//! With `--ray` it splits trace kernels by their loops and sums the instructions of a primary ray.
//! Exit codes: 0 done or skipped, 1 a module differs from the record, 2 usage or input.

mod aco;
mod child;
mod cpp;
mod flow;
mod modules;
mod nvrtc;
mod options;
mod radv;
mod ray;
mod record;
mod sass;
mod split;
mod translate;

use anyhow::{Context, Result};
use options::{Options, Task};
use record::Record;
use slimbvh_bench::exit;
use std::process::ExitCode;

/// The environment variable that makes a skip a failure.
const REQUIRED: &str = "REQUIRE_RADV";

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1).peekable();
    let result = match arguments.peek().map(String::as_str) {
        Some(child::WORD) => child::run(arguments.skip(1)).map(|()| None),
        _ => run(arguments),
    };
    exit::code(result)
}

/// Returns what is wrong, if anything.
fn run(arguments: impl Iterator<Item = String>) -> Result<Option<String>> {
    let options = Options::parse(arguments)?;
    match options.task {
        Task::Help => {
            println!("{}", options::USAGE);
            Ok(None)
        }
        Task::Ray => ray::run(&options).map(|()| None),
        Task::List => {
            if child::driver_file().is_none() {
                return absent();
            }
            print!("{}", child::statistics(&options.family, &options.files)?);
            Ok(None)
        }
        Task::Compare | Task::Write => guard(&options),
    }
}

/// Compares all committed modules with the record, or renews it.
fn guard(options: &Options) -> Result<Option<String>> {
    if child::driver_file().is_none() {
        return absent();
    }
    let path = options.record.clone().unwrap_or_else(modules::record);
    let files = if options.files.is_empty() {
        modules::committed()?
    } else {
        options.files.clone()
    };
    let now = child::statistics(&options.family, &files)?;
    if options.task == Task::Write {
        std::fs::write(&path, now.to_string()).with_context(|| format!("cannot write {path:?}"))?;
        println!("{} modules, {}", now.rows.len(), now.compiler);
        return Ok(None);
    }
    let text = std::fs::read_to_string(&path)
        .with_context(|| format!("cannot read {path:?}; --write makes it"))?;
    let mut recorded: Record = text.parse().with_context(|| format!("{path:?}"))?;
    if recorded.compiler != now.compiler {
        return skipped(&format!(
            "SHADERS ARE NOT COMPARED: the record is of {}, this is {}",
            recorded.compiler, now.compiler
        ));
    }
    if !options.files.is_empty() {
        let names: Vec<String> = files.iter().map(|file| modules::name(file)).collect();
        recorded.rows.retain(|row| names.contains(&row.module));
    }
    let differences = recorded.compare(&now);
    for difference in &differences {
        println!("{difference}");
    }
    println!(
        "{} modules, {}: {} differ from the record",
        now.rows.len(),
        now.compiler,
        differences.len()
    );
    Ok(record::verdict(&differences).map(str::to_owned))
}

/// Says that there is no RADV.
fn absent() -> Result<Option<String>> {
    skipped("SHADERS ARE NOT COMPILED: Mesa's RADV is not installed (Debian: mesa-vulkan-drivers)")
}

/// Prints why nothing is compared. That is a fault where it is forbidden.
fn skipped(why: &str) -> Result<Option<String>> {
    println!("{why}");
    if std::env::var_os(REQUIRED).is_some_and(|value| value == "1") {
        return Ok(Some(format!("{REQUIRED} is set, so this is a failure")));
    }
    Ok(None)
}
