//! Traces: closest hits of primary rays, any hits of shadow rays.

mod settings;

use anyhow::Result;
use criterion::{BenchmarkId, Throughput};
use slimbvh_bench::meshes::SUBJECTS;
use slimbvh_bench::tracers::tracers;
use slimbvh_bench::{Answer, Input, RayOrder, Reference, pool, thread_counts};

fn main() -> Result<()> {
    let mut criterion = settings::criterion();
    for subject in SUBJECTS {
        let Some(mesh) = subject.mesh()? else {
            continue;
        };
        let input = Input::new(&mesh);
        let reference = Reference::new(&mesh, RayOrder::default())?;
        let (primary, shadow) = (&reference.rays.primary, &reference.rays.shadow);
        let mut tracers = tracers(&input);
        for tracer in &mut tracers {
            tracer.build()?;
        }

        let mut group = criterion.benchmark_group(format!("primary/{}", subject.name));
        group.throughput(Throughput::Elements(primary.len() as u64));
        for threads in thread_counts() {
            let pool = pool(threads)?;
            for tracer in &tracers {
                let mut answers = vec![];
                let id = BenchmarkId::new(tracer.name(), format!("{threads} threads"));
                group.bench_function(id, |bencher| {
                    answers.resize(primary.len(), Answer::MISS);
                    bencher.iter(|| pool.install(|| tracer.closest_hits(primary, &mut answers)));
                });
                // A benchmark that was filtered out has no answers.
                if !answers.is_empty() {
                    reference.check_closest(&**tracer, &answers)?;
                }
            }
        }
        group.finish();

        let mut group = criterion.benchmark_group(format!("shadow/{}", subject.name));
        group.throughput(Throughput::Elements(shadow.len() as u64));
        for threads in thread_counts() {
            let pool = pool(threads)?;
            for tracer in &tracers {
                let mut answers = vec![];
                let id = BenchmarkId::new(tracer.name(), format!("{threads} threads"));
                group.bench_function(id, |bencher| {
                    answers.resize(shadow.len(), false);
                    bencher.iter(|| pool.install(|| tracer.any_hits(shadow, &mut answers)));
                });
                if !answers.is_empty() {
                    reference.check_any(&**tracer, &answers)?;
                }
            }
        }
        group.finish();
    }
    criterion.final_summary();
    Ok(())
}
