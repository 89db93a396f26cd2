//! Builds: from a mesh to everything that tracing needs, with buffers kept.

mod settings;

use anyhow::Result;
use criterion::{BenchmarkId, Throughput};
use slimbvh_bench::meshes::SUBJECTS;
use slimbvh_bench::tracers::tracers;
use slimbvh_bench::{Input, RayOrder, Reference, pool, thread_counts};

fn main() -> Result<()> {
    let mut criterion = settings::criterion();
    for subject in SUBJECTS {
        let Some(mesh) = subject.mesh()? else {
            continue;
        };
        let input = Input::new(&mesh);
        let mut group = criterion.benchmark_group(format!("build/{}", subject.name));
        group.throughput(Throughput::Elements(mesh.indices.len() as u64));
        let mut reference = None;
        for threads in thread_counts() {
            let pool = pool(threads)?;
            for mut tracer in tracers(&input) {
                let mut outcome = None;
                let id = BenchmarkId::new(tracer.name(), format!("{threads} threads"));
                group.bench_function(id, |bencher| {
                    bencher.iter(|| outcome = Some(pool.install(|| tracer.build())));
                });
                // A benchmark that was filtered out has built nothing.
                if let Some(built) = outcome {
                    built?;
                    if reference.is_none() {
                        reference = Some(Reference::new(&mesh, RayOrder::default())?);
                    }
                    if let Some(reference) = &reference {
                        reference.check(&*tracer)?;
                    }
                }
            }
        }
        group.finish();
    }
    criterion.final_summary();
    Ok(())
}
