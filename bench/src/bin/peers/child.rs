//! The child process that traces one case with one peer, so that a crash ends only this process.

use crate::peers::asked;
use anyhow::{Context, Result, ensure};
use serde::{Deserialize, Serialize};
use slimbvh::Ray;
use slimbvh_bench::tracers::tracers;
use slimbvh_bench::{Answer, Input, Tracer};
use slimbvh_lab::stress::{Effort, cases, rays};
use std::any::Any;
use std::io::{Write, stdout};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Instant;

/// The first argument of a child process.
pub const WORD: &str = "--child";

/// Rays in one call: as many as Embree's packets hold.
pub const AT_ONCE: usize = 16;

/// Bytes of a thread's stack: Linux' default for a process' first thread.
const STACK: usize = 8 << 20;

/// The job of a child process.
pub struct Task<'a> {
    /// The peer's name among the tracers.
    pub peer: &'a str,
    /// The case's place in the list of all cases.
    pub case: usize,
    pub effort: Effort,
    /// The first ray to trace.
    pub first: usize,
    /// Rays before this one are traced one by one.
    pub careful_until: usize,
}

/// A line of a child's output, as JSON: one after the build, then one for each ray, in order.
#[derive(Deserialize, Serialize)]
pub enum Line {
    /// The build is done.
    Built,
    /// The build was refused or panicked.
    Failed { word: String, reason: String },
    /// An answer: the bits of t, the triangle or `u32::MAX`, and whether there is any hit.
    Answer(u32, u32, bool),
    /// The peer panicked on this ray.
    Panicked(String),
    /// The peer does not accept this ray.
    Refused,
    /// All rays are answered. The time to build and to trace together, in milliseconds.
    Done(f64),
}

impl Line {
    /// The answer to an invalid ray, which no tracer is given.
    const MISS: Self = Self::Answer(0, u32::MAX, false);

    fn print(&self) -> Result<()> {
        let mut out = stdout().lock();
        serde_json::to_writer(&mut out, self)?;
        writeln!(out)?;
        Ok(out.flush()?)
    }
}

impl Task<'_> {
    /// The child's arguments.
    pub fn arguments(&self) -> [String; 6] {
        let effort = match self.effort {
            Effort::Quick => "quick",
            Effort::Full => "full",
        };
        let numbers = [self.case, self.first, self.careful_until].map(|x| x.to_string());
        let [case, first, careful_until] = numbers.each_ref().map(String::as_str);
        [WORD, self.peer, effort, case, first, careful_until].map(str::to_owned)
    }
}

/// Runs the child's job.
pub fn run(arguments: impl Iterator<Item = String>) -> Result<()> {
    let arguments: Vec<String> = arguments.collect();
    let [peer, effort, numbers @ ..] = &arguments[..] else {
        anyhow::bail!("a peer, an effort and numbers are expected");
    };
    let numbers: Result<Vec<usize>, _> = numbers.iter().map(|word| word.parse()).collect();
    let numbers = numbers.context("numbers are expected")?;
    let [case, first, careful_until] = numbers[..] else {
        anyhow::bail!("three numbers are expected");
    };
    let effort = match effort.as_str() {
        "quick" => Effort::Quick,
        _ => Effort::Full,
    };
    let is_known = asked().any(|asked| asked.tracer == peer);
    ensure!(is_known, "there is no peer {peer:?}");
    let cases = cases(effort);
    let case = cases.get(case).context("there is no such case")?;
    let shots = rays(case).shots;
    let rays: Vec<Ray> = shots.iter().map(|shot| shot.ray).collect();
    ensure!(first <= rays.len(), "there are not so many rays");

    // Panics are reported in the output.
    std::panic::set_hook(Box::new(|_| {}));
    let pool = rayon::ThreadPoolBuilder::new().stack_size(STACK).build()?;
    pool.install(|| {
        let input = Input::new(&case.mesh);
        let mut tracers = tracers(&input);
        tracers.retain(|tracer| tracer.name() == peer);
        let tracer = tracers.first_mut().context("the peer is there")?;
        let careful = careful_until.saturating_sub(first);
        ask(&mut **tracer, &rays[first..], careful)
    })
}

/// Builds and traces all rays, the first `careful` of them one by one.
fn ask(tracer: &mut dyn Tracer, rays: &[Ray], careful: usize) -> Result<()> {
    let start = Instant::now();
    let failed = match catch_unwind(AssertUnwindSafe(|| tracer.build())) {
        Ok(Ok(_)) => None,
        Ok(Err(error)) => Some(("refused", format!("{error:#}"))),
        Err(panic) => Some(("panicked", message(&*panic))),
    };
    if let Some((word, reason)) = failed {
        let word = word.into();
        return Line::Failed { word, reason }.print();
    }
    Line::Built.print()?;
    let (careful, others) = rays.split_at(careful.min(rays.len()));
    let chunks = careful.chunks(1).chain(others.chunks(AT_ONCE));
    for line in chunks.flat_map(|chunk| answer(tracer, chunk)) {
        line.print()?;
    }
    Line::Done(start.elapsed().as_secs_f64() * 1e3).print()
}

/// Prints a line for each ray.
fn answer(tracer: &dyn Tracer, rays: &[Ray]) -> Vec<Line> {
    let taken: Vec<Ray> = rays
        .iter()
        .copied()
        .filter(|ray| is_sane(ray) && tracer.takes(ray))
        .collect();
    let mut answers = match all(tracer, &taken) {
        Ok(answers) => answers,
        // Trace them one by one to find the ray that panics.
        Err(_) if taken.len() > 1 => {
            return rays.chunks(1).flat_map(|ray| answer(tracer, ray)).collect();
        }
        Err(message) => vec![Line::Panicked(message)],
    }
    .into_iter();
    let line = |ray: &Ray| match (is_sane(ray), tracer.takes(ray)) {
        (true, true) => answers.next().unwrap_or(Line::MISS),
        (true, false) => Line::Refused,
        (false, _) => Line::MISS,
    };
    rays.iter().map(line).collect()
}

/// Whether slimbvh accepts this as a ray.
fn is_sane(ray: &Ray) -> bool {
    let mut numbers = ray.origin.iter().chain(&ray.direction).chain([&ray.t_min]);
    numbers.all(|x| x.is_finite()) && ray.direction != [0.0; 3] && ray.t_min <= ray.t_max
}

/// The answers to these rays in one call, or the message of its panic.
fn all(tracer: &dyn Tracer, rays: &[Ray]) -> Result<Vec<Line>, String> {
    let ask = || {
        let mut closest = vec![Answer::MISS; rays.len()];
        let mut any = vec![false; rays.len()];
        tracer.closest_hits(rays, &mut closest);
        tracer.any_hits(rays, &mut any);
        let both = closest.into_iter().zip(any);
        both.map(|(closest, any)| Line::Answer(closest.t.to_bits(), closest.primitive, any))
            .collect()
    };
    catch_unwind(AssertUnwindSafe(ask)).map_err(|panic| message(&*panic))
}

/// The message of a panic.
fn message(panic: &(dyn Any + Send)) -> String {
    let text = panic.downcast_ref::<&str>().copied();
    let text = text.or_else(|| panic.downcast_ref::<String>().map(String::as_str));
    text.unwrap_or("no message").to_owned()
}
