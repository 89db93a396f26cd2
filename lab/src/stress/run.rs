//! Runs a tracer on a case, and judges its answers.

use super::families::Case;
use super::judge::{Answer, Judge, Shot, Verdict};
use super::rays::rays;
use super::row::Row;
use super::subject::Subject;
use super::tracer::{Failure, Outcome, Tracer, Tree};
use crate::oracle::Crossing;
use rayon::prelude::*;
use slimbvh::Ray;

/// Judges all trees of a tracer on a case, one row each.
///
/// # Errors
/// If the tracer fails.
pub fn run(tracer: &mut dyn Tracer, case: &Case) -> Result<Vec<Row>, Failure> {
    let rays = rays(case);
    let all: Vec<Ray> = rays.shots.iter().map(|shot| shot.ray).collect();
    let mut known: Option<Known> = None;
    let mut rows = Vec::new();
    for tree in tracer.trees(case) {
        let first = if tree.is_reduced { rays.from_eye } else { 0 };
        let outcome = tracer.trace(case, &tree, &all[first..])?;
        let known = match &mut known {
            Some(known) if known.is_of(&outcome) => known,
            known => known.insert(Known::new(&outcome, &rays.shots, case)),
        };
        let judge = Judge {
            subject: &known.subject,
            ulps: tracer.bound_ulps(),
        };
        let mut row = new_row(tracer, case, &tree, &outcome);
        let judged = known.judge(&judge, first, &outcome.answers);
        for ((shot, answer), verdict) in known.shots[first..]
            .iter()
            .zip(&outcome.answers)
            .zip(judged)
        {
            row.count(&verdict, || example(shot, answer));
        }
        rows.push(row);
    }
    Ok(rows)
}

/// Results that trees over the same triangles share.
struct Known {
    subject: Subject,
    /// The exact hits of each ray.
    crossings: Vec<Vec<Crossing>>,
    shots: Vec<Shot>,
}

impl Known {
    fn new(outcome: &Outcome, shots: &[Shot], case: &Case) -> Self {
        let subject = Subject::new(outcome.triangles.clone(), outcome.exponent);
        let is_closed = case.inside.is_some_and(|inside| subject.is_around(inside));
        let shots: Vec<Shot> = shots
            .iter()
            .map(|shot| Shot {
                is_inside: shot.is_inside && is_closed,
                ..*shot
            })
            .collect();
        let met = |shot: &Shot| {
            let line = subject.line(&shot.ray);
            line.map_or_else(Vec::new, |line| {
                subject.scene.crossings(&line.ray, u32::MAX)
            })
        };
        let crossings = shots.par_iter().map(met).collect();
        Self {
            subject,
            crossings,
            shots,
        }
    }

    fn is_of(&self, outcome: &Outcome) -> bool {
        self.subject.exponent == outcome.exponent
            && self.subject.scene.triangles() == outcome.triangles
    }

    fn judge(&self, judge: &Judge, first: usize, answers: &[Answer]) -> Vec<Verdict> {
        let asked = self.shots[first..].par_iter().zip(&self.crossings[first..]);
        let judged = asked
            .zip(answers)
            .map(|((shot, crossings), answer)| judge.judge(shot, crossings, answer));
        judged.collect()
    }
}

fn new_row(tracer: &dyn Tracer, case: &Case, tree: &Tree, outcome: &Outcome) -> Row {
    Row {
        tracer: tracer.name().into(),
        family: case.family.clone().into_owned(),
        magnitude: case.magnitude.clone(),
        backend: tracer.backend().into(),
        codec: tree.codec.clone(),
        reduction: if tree.is_reduced { "reduced" } else { "whole" }.into(),
        moved: outcome.moved.map(|[moved, _]| moved),
        moved_bound: outcome.moved.map(|[_, bound]| bound),
        depth: outcome.depth,
        stack: outcome.stack,
        time_ms: outcome.time_ms,
        ..Row::default()
    }
}

/// The bits of a ray, and the answer.
fn example(shot: &Shot, answer: &Answer) -> String {
    let numbers: [f32; 8] = bytemuck::cast(shot.ray);
    let bits = numbers.map(|x| format!("{:08x}", x.to_bits())).join(" ");
    let Answer { closest, any } = answer;
    format!(
        "{bits}, inside {}, closest {closest:?}, any {any}",
        shot.is_inside
    )
}
