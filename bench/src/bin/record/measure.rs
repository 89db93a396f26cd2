//! Measures one mesh with all tracers in turn: all build, all trace primary rays, all trace shadow rays, round after round.

use crate::options::Options;
use anyhow::Result;
use slimbvh::{Mesh, Stages};
use slimbvh_bench::tracers::{Bytes, Question, Visits, tracers, triangles};
use slimbvh_bench::{Agreement, Answer, Input, Reference, Tracer, pool, thread_counts};
use slimbvh_lab::measure::rounds::median;
use std::time::Instant;

/// The measurements of one mesh.
pub struct MeshRecord {
    pub name: &'static str,
    pub triangle_count: usize,
    pub primary_count: usize,
    pub shadow_count: usize,
    /// Time to make obvhs' list of triangles; no other time includes it.
    pub input_ms: f64,
    pub tracers: Vec<TracerRecord>,
    /// Wrong answers, as sentences.
    pub complaints: Vec<String>,
}

/// The measurements of one tracer.
pub struct TracerRecord {
    pub name: &'static str,
    pub bytes: Bytes,
    pub primary_visits: Option<Visits>,
    pub shadow_visits: Option<Visits>,
    /// Compared with slimbvh with 30-bit codes on one thread.
    pub primary: Agreement,
    /// Compared with slimbvh with 30-bit codes on one thread.
    pub shadow: Agreement,
    /// Times for each number of threads.
    pub runs: Vec<Run>,
}

impl TracerRecord {
    /// The library's name, and the kind of its tree.
    pub fn library_and_tree(&self) -> (&str, &str) {
        self.name.split_once(' ').unwrap_or((self.name, ""))
    }
}

/// Times with one number of threads.
#[derive(Default)]
pub struct Run {
    pub threads: usize,
    /// A build into new buffers.
    pub first_build: Samples,
    /// A build into the buffers of the build before.
    pub build: Samples,
    pub primary: Samples,
    pub shadow: Samples,
    /// Sums over all builds.
    pub stages: Stages,
}

impl Run {
    /// Primary and shadow rays.
    pub fn trace_ms(&self) -> f64 {
        self.primary.median() + self.shadow.median()
    }

    /// A frame: a build that keeps its buffers, primary and shadow rays.
    pub fn frame_ms(&self) -> f64 {
        self.build.median() + self.trace_ms()
    }
}

/// Times in milliseconds.
#[derive(Default)]
pub struct Samples(Vec<f64>);

impl Samples {
    fn time<R>(&mut self, run: impl FnOnce() -> R) -> R {
        let begin = Instant::now();
        let result = run();
        self.0.push(begin.elapsed().as_secs_f64() * 1e3);
        result
    }

    /// The median: the middle time, or the mean of the two in the middle; NaN if there are none.
    pub fn median(&self) -> f64 {
        median(&mut self.0.clone())
    }

    /// The median over rounds of the ratios of these times to others of the same rounds. A machine that is slow for a while
    /// slows both.
    pub fn ratio(&self, others: &Self) -> f64 {
        let ratios = self.0.iter().zip(&others.0).map(|(a, b)| a / b);
        median(&mut ratios.collect::<Vec<_>>())
    }

    pub fn min(&self) -> f64 {
        self.0.iter().copied().fold(f64::INFINITY, f64::min)
    }

    pub fn max(&self) -> f64 {
        self.0.iter().copied().fold(0.0, f64::max)
    }
}

/// Measures all tracers on a mesh, with one thread and with all threads.
pub fn measure(name: &'static str, mesh: &Mesh, options: &Options) -> Result<MeshRecord> {
    let reference = Reference::new(mesh, options.order)?;
    let mut input_times = Samples::default();
    for _ in 0..3 {
        pool(1)?.install(|| input_times.time(|| drop(triangles(mesh))));
    }
    let input = Input::new(mesh);
    let mut record = MeshRecord {
        name,
        triangle_count: mesh.indices.len(),
        primary_count: reference.rays.primary.len(),
        shadow_count: reference.rays.shadow.len(),
        input_ms: input_times.median(),
        tracers: Vec::new(),
        complaints: Vec::new(),
    };
    for threads in thread_counts() {
        let mut tracers = tracers(&input);
        tracers.retain(|tracer| options.wants_tracer(tracer.name()));
        let rounds = options.rounds;
        let runs = pool(threads)?.install(|| time_all(&mut tracers, &reference, rounds))?;
        if record.tracers.is_empty() {
            record.tracers = tracers
                .iter()
                .map(|tracer| describe(&**tracer, &reference))
                .collect();
        }
        for ((tracer, run), to) in tracers.iter().zip(runs).zip(&mut record.tracers) {
            to.runs.push(run);
            if let Err(error) = reference.check(&**tracer) {
                let complaint = format!("{name}, {threads} threads: {error}");
                record.complaints.push(complaint);
            }
        }
    }
    Ok(record)
}

/// Times every tracer once a round. The first round does not count.
fn time_all(
    tracers: &mut [Box<dyn Tracer + '_>],
    reference: &Reference,
    rounds: usize,
) -> Result<Vec<Run>> {
    let (primary, shadow) = (&reference.rays.primary, &reference.rays.shadow);
    let mut closest = vec![Answer::MISS; primary.len()];
    let mut any = vec![false; shadow.len()];
    let mut runs: Vec<Run> = Vec::new();
    for round in 0..=rounds {
        if round <= 1 {
            let threads = rayon::current_num_threads();
            runs = tracers
                .iter()
                .map(|_| Run {
                    threads,
                    ..Run::default()
                })
                .collect();
        }
        for (tracer, run) in tracers.iter_mut().zip(&mut runs) {
            tracer.forget();
            run.first_build.time(|| tracer.build())?;
        }
        for (tracer, run) in tracers.iter_mut().zip(&mut runs) {
            let stages = run.build.time(|| tracer.build())?;
            run.stages.merge(&stages);
        }
        for (tracer, run) in tracers.iter().zip(&mut runs) {
            run.primary
                .time(|| tracer.closest_hits(primary, &mut closest));
        }
        for (tracer, run) in tracers.iter().zip(&mut runs) {
            run.shadow.time(|| tracer.any_hits(shadow, &mut any));
        }
    }
    Ok(runs)
}

/// Sizes, answers and counts of a tracer.
fn describe(tracer: &dyn Tracer, reference: &Reference) -> TracerRecord {
    let rays = &reference.rays;
    let mut closest = vec![Answer::MISS; rays.primary.len()];
    let mut any = vec![false; rays.shadow.len()];
    tracer.closest_hits(&rays.primary, &mut closest);
    tracer.any_hits(&rays.shadow, &mut any);
    TracerRecord {
        name: tracer.name(),
        bytes: tracer.bytes(),
        primary_visits: tracer.visits(&rays.primary, Question::Closest),
        shadow_visits: tracer.visits(&rays.shadow, Question::Any),
        primary: Agreement::of_closest(&reference.closest, &closest),
        shadow: Agreement::of_any(&reference.any, &any),
        runs: Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn medians_of_known_samples() {
        assert_eq!(Samples(vec![9.0, 1.0, 4.0]).median(), 4.0);
        let samples = Samples(vec![9.0, 1.0, 4.0, 5.0]);
        assert_eq!(samples.median(), 4.5);
        assert_eq!((samples.min(), samples.max()), (1.0, 9.0));
        assert!(Samples::default().median().is_nan());
    }

    #[test]
    fn ratios_are_taken_round_by_round() {
        let slowed_once = Samples(vec![2.0, 20.0, 3.0]);
        let other = Samples(vec![1.0, 10.0, 2.0]);
        assert_eq!(slowed_once.ratio(&other), 2.0);
    }
}
