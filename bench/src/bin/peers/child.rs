//! The process that asks one peer about one case, so that what breaks breaks alone.

use crate::peers::asked;
use anyhow::{Context, Result, ensure};
use serde::{Deserialize, Serialize};
use slimbvh::Ray;
use slimbvh::stress::{Effort, cases, rays};
use slimbvh_bench::tracers::tracers;
use slimbvh_bench::{Answer, Input, Tracer};
use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Instant;

/// The first argument of a child process.
pub const WORD: &str = "--child";

/// Bytes of a thread's stack: as much as Linux gives a process' first one.
const STACK: usize = 8 << 20;

/// What the child prints, as JSON.
#[derive(Deserialize, Serialize)]
pub struct Told {
    /// For each ray: the bits of t, the triangle or `u32::MAX`, and whether there is any hit.
    pub answers: Vec<(u32, u32, bool)>,
    /// To build and to trace.
    pub time_ms: f64,
    /// Why the peer does not take the scene.
    pub refused: Option<String>,
    /// Why it has panicked.
    pub panicked: Option<String>,
}

/// What a child is told after [`WORD`].
pub fn arguments(peer: &str, case: usize, effort: Effort) -> [String; 4] {
    let effort = match effort {
        Effort::Quick => "quick",
        Effort::Full => "full",
    };
    [WORD, peer, &case.to_string(), effort].map(str::to_owned)
}

/// Does what it is told.
pub fn run(arguments: impl Iterator<Item = String>) -> Result<()> {
    let arguments: Vec<String> = arguments.collect();
    let [peer, case, effort] = &arguments[..] else {
        anyhow::bail!("a peer, a case and an effort are expected");
    };
    ensure!(
        asked().any(|asked| asked.tracer == peer),
        "there is no peer {peer:?}"
    );
    let effort = if effort == "quick" {
        Effort::Quick
    } else {
        Effort::Full
    };
    let cases = cases(effort);
    let case = cases.get(case.parse::<usize>()?);
    let case = case.context("there is no such case")?;
    let shots = rays(case).shots;
    let rays: Vec<Ray> = shots.iter().map(|shot| shot.ray).collect();

    // Panics are told by what is printed.
    std::panic::set_hook(Box::new(|_| {}));
    let pool = rayon::ThreadPoolBuilder::new().stack_size(STACK).build()?;
    let told = pool.install(|| {
        let input = Input::new(&case.mesh);
        let mut tracers = tracers(&input);
        tracers.retain(|tracer| tracer.name() == peer);
        tracers.first_mut().map(|tracer| ask(&mut **tracer, &rays))
    });
    let told = told.context("the peer is there")?;
    println!("{}", serde_json::to_string(&told)?);
    Ok(())
}

/// Builds, and asks about all rays that are rays. The others are for no tracer to answer.
fn ask(tracer: &mut dyn Tracer, rays: &[Ray]) -> Told {
    let mut told = Told {
        answers: vec![(0, u32::MAX, false); rays.len()],
        time_ms: 0.0,
        refused: None,
        panicked: None,
    };
    let (places, sane): (Vec<usize>, Vec<Ray>) = rays
        .iter()
        .enumerate()
        .filter(|(_, ray)| is_sane(ray))
        .unzip();
    let start = Instant::now();
    match catch_unwind(AssertUnwindSafe(|| tracer.build())) {
        Ok(Ok(_)) => {}
        Ok(Err(error)) => {
            told.refused = Some(format!("{error:#}"));
            return told;
        }
        Err(panic) => {
            told.panicked = Some(format!("while it builds: {}", message(&*panic)));
            return told;
        }
    }
    let answers = match all(tracer, &sane) {
        Ok(answers) => answers,
        Err(message) => {
            let (answers, lost) = one_by_one(tracer, &sane);
            told.panicked = Some(format!("with {lost} of {} rays: {message}", sane.len()));
            answers
        }
    };
    told.time_ms = start.elapsed().as_secs_f64() * 1e3;
    for (place, (closest, any)) in places.into_iter().zip(answers) {
        told.answers[place] = (closest.t.to_bits(), closest.primitive, any);
    }
    told
}

/// What slimbvh takes for a ray.
fn is_sane(ray: &Ray) -> bool {
    let mut numbers = ray.origin.iter().chain(&ray.direction).chain([&ray.t_min]);
    numbers.all(|x| x.is_finite()) && ray.direction != [0.0; 3] && ray.t_min <= ray.t_max
}

/// Answers to all rays at once, or why it has panicked.
fn all(tracer: &dyn Tracer, rays: &[Ray]) -> Result<Vec<(Answer, bool)>, String> {
    let ask = || {
        let mut closest = vec![Answer::MISS; rays.len()];
        let mut any = vec![false; rays.len()];
        tracer.closest_hits(rays, &mut closest);
        tracer.any_hits(rays, &mut any);
        closest.into_iter().zip(any).collect()
    };
    catch_unwind(AssertUnwindSafe(ask)).map_err(|panic| message(&*panic))
}

/// Answers to each ray, those it panics with being misses, and how many these are.
fn one_by_one(tracer: &dyn Tracer, rays: &[Ray]) -> (Vec<(Answer, bool)>, usize) {
    let mut lost = 0;
    let answers = rays.chunks(1).map(|ray| {
        all(tracer, ray).map_or_else(
            |_| {
                lost += 1;
                (Answer::MISS, false)
            },
            |answers| answers[0],
        )
    });
    (answers.collect(), lost)
}

/// What a panic says.
fn message(panic: &(dyn Any + Send)) -> String {
    let text = panic.downcast_ref::<&str>().copied();
    let text = text.or_else(|| panic.downcast_ref::<String>().map(String::as_str));
    text.unwrap_or("no message").to_owned()
}
