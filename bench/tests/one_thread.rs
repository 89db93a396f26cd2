//! In a pool of one thread peers use one thread, too. This is a binary of its own, as it watches the process' threads.
#![cfg(target_os = "linux")]

use anyhow::{Context, Result, ensure};
use slimbvh::generate::icosphere;
use slimbvh_bench::tracers::tracers;
use slimbvh_bench::{Input, RayOrder, Reference, pool};
use std::fs;

/// Each thread of this process, with its processor time so far in clock ticks.
fn threads() -> Result<Vec<(String, u64)>> {
    fs::read_dir("/proc/self/task")?
        .map(|entry| {
            let entry = entry?;
            let stat = fs::read_to_string(entry.path().join("stat"))?;
            // After the name, which ends with the last parenthesis, come user and system time as 12th and 13th field.
            let (_, fields) = stat.rsplit_once(')').context("a thread has a name")?;
            let fields = fields.split_whitespace().skip(11).take(2);
            let ticks: Vec<u64> = fields.map(str::parse).collect::<Result<_, _>>()?;
            let thread = entry.file_name().to_string_lossy().into_owned();
            Ok((thread, ticks.iter().sum()))
        })
        .collect()
}

#[test]
fn no_other_thread_works_in_a_pool_of_one() -> Result<()> {
    // Large enough for every parallel path of obvhs; the last begins at 500 000 triangles.
    let mesh = icosphere(glam::Vec3::ZERO, 1.0, 8);
    let input = Input::new(&mesh);
    let reference = Reference::new(&mesh, RayOrder::default())?;
    let one = pool(1)?;
    let worker = one.install(|| fs::read_link("/proc/thread-self"))?;
    for mut tracer in tracers(&input) {
        // tinybvh uses all processors for large meshes.
        if tracer.name().starts_with("tinybvh") {
            continue;
        }
        let before = threads()?;
        one.install(|| {
            tracer.build()?;
            reference.check(&*tracer)
        })?;
        let after = threads()?;
        assert_eq!(after.len(), before.len(), "{}", tracer.name());
        for ((thread, begin), (same, end)) in before.into_iter().zip(after) {
            assert_eq!(thread, same);
            let is_worker = worker.ends_with(&thread);
            let worked = end > begin + 1;
            ensure!(worked == is_worker, "{}: thread {thread}", tracer.name());
        }
    }
    Ok(())
}
