//! RADV reads the environment when it is loaded, so a child process with its own environment compiles.

use super::modules;
use super::radv::{Compiled, Detail, Radv};
use super::record::{Record, Row};
use super::translate::Kernel;
use anyhow::{Context, Result, bail, ensure};
use std::path::{Path, PathBuf};
use std::process::Command;

/// The first argument of a child process.
pub const WORD: &str = "--child";

/// The second argument: print the disassembly, not counts.
const ASSEMBLY: &str = "assembly";

/// The second argument: print counts.
const COUNTS: &str = "counts";

/// Folders in which drivers tell the Vulkan loader of themselves.
const DRIVERS: [&str; 3] = [
    "/usr/share/vulkan/icd.d",
    "/usr/local/share/vulkan/icd.d",
    "/etc/vulkan/icd.d",
];

/// The file that tells the Vulkan loader where RADV is, if it is installed.
pub fn driver_file() -> Option<PathBuf> {
    let entries = DRIVERS
        .iter()
        .filter_map(|folder| std::fs::read_dir(folder).ok());
    let paths = entries.flatten().flatten().map(|entry| entry.path());
    paths
        .filter(|path| {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            name.starts_with("radeon_icd") && name.ends_with(".json")
        })
        .min()
}

/// The counts of modules, compiled for an AMD GPU.
pub fn statistics(family: &str, files: &[PathBuf]) -> Result<Record> {
    start(family, COUNTS, files)?.parse()
}

/// The disassembly of a module, compiled for an AMD GPU.
pub fn assembly(family: &str, file: &Path) -> Result<String> {
    start(family, ASSEMBLY, &[file.to_owned()])
}

fn start(family: &str, what: &str, files: &[PathBuf]) -> Result<String> {
    let driver = driver_file().context("Mesa's RADV is not installed")?;
    let program = std::env::current_exe().context("cannot find this program")?;
    let output = Command::new(program)
        .args([WORD, what])
        .args(files)
        .env("RADV_FORCE_FAMILY", family)
        .env("RADV_DEBUG", "nocache")
        .env("VK_ICD_FILENAMES", driver)
        .env_remove("VK_DRIVER_FILES")
        .env_remove("VK_INSTANCE_LAYERS")
        // Mesa's layer that sorts devices asks each for what the null device lacks.
        .env("NODEVICE_SELECT", "1")
        .output()
        .context("cannot start the child process")?;
    let log = String::from_utf8_lossy(&output.stderr);
    ensure!(output.status.success(), "RADV for {family} failed:\n{log}");
    Ok(String::from_utf8(output.stdout)?)
}

/// The child: compiles modules and prints their counts or disassembly.
pub fn run(mut arguments: impl Iterator<Item = String>) -> Result<()> {
    let detail = match arguments.next().as_deref() {
        Some(COUNTS) => Detail::Counts,
        Some(ASSEMBLY) => Detail::Assembly,
        other => bail!("counts or assembly, not {other:?}"),
    };
    let radv = Radv::open()?;
    let mut record = Record {
        compiler: radv.compiler.clone(),
        rows: Vec::new(),
    };
    for file in arguments.map(PathBuf::from) {
        let compiled = radv.compile(&Kernel::read(&file)?, detail);
        let compiled = compiled.with_context(|| format!("{file:?}"))?;
        match &compiled.assembly {
            Some(assembly) => println!("{assembly}"),
            None => record.rows.push(row(modules::name(&file), &compiled)?),
        }
    }
    if detail == Detail::Counts {
        print!("{record}");
    }
    Ok(())
}

fn row(module: String, compiled: &Compiled) -> Result<Row> {
    let scratch = compiled.statistic("Scratch size")?;
    ensure!(
        scratch % compiled.lanes == 0,
        "scratch memory of a wave is shared evenly by its lanes"
    );
    Ok(Row {
        module,
        instructions: compiled.statistic("Instructions")?,
        vgprs: compiled.statistic("VGPRs")?,
        scratch_bytes: scratch / compiled.lanes,
        workgroup_bytes: compiled.statistic("LDS size")?,
    })
}
