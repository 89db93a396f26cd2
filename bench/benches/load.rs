//! Reading the scene files of the folder that `SLIMBVH_SCENES` names, from its first byte to a valid mesh.

mod settings;

use anyhow::{Context, Result, bail};
use criterion::Throughput;
use slimbvh::scene::{Format, LoadOptions, load};
use slimbvh_bench::meshes::SCENES_VARIABLE;
use std::path::PathBuf;

fn main() -> Result<()> {
    let mut criterion = settings::criterion();
    let mut group = criterion.benchmark_group("load");
    for file in files()? {
        let options = LoadOptions::default();
        let metadata = file.metadata();
        let metadata = metadata.with_context(|| format!("cannot read {}", file.display()))?;
        group.throughput(Throughput::Bytes(metadata.len()));
        let mut outcome = None;
        let name = file.file_name().unwrap_or_default().to_string_lossy();
        group.bench_function(name, |bencher| {
            bencher.iter(|| outcome = Some(load(&file, &options)));
        });
        outcome.transpose()?;
    }
    group.finish();
    criterion.final_summary();
    Ok(())
}

/// The scene files, by name.
fn files() -> Result<Vec<PathBuf>> {
    let Some(folder) = std::env::var_os(SCENES_VARIABLE) else {
        bail!("{SCENES_VARIABLE} does not name a folder of scene files");
    };
    let folder = PathBuf::from(folder);
    let entries = folder.read_dir();
    let entries = entries.with_context(|| format!("cannot read {}", folder.display()))?;
    let mut files = Vec::new();
    for entry in entries {
        let file = entry?.path();
        if Format::of_path(&file).is_some() {
            files.push(file);
        }
    }
    files.sort();
    Ok(files)
}
