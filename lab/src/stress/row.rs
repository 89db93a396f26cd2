//! Rows of a report.

use super::judge::{Fault, Verdict};
use serde::{Deserialize, Serialize};

/// The results of a tracer in one family of scenes at one magnitude.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Row {
    /// The name of the tracer.
    pub tracer: String,
    /// The kind of scene.
    pub family: String,
    /// How large or how extreme the scenes are.
    pub magnitude: String,
    /// `cpu` or `gpu`.
    pub backend: String,
    /// The storage of nodes and triangles.
    pub codec: String,
    /// `whole`, or `reduced` to what an eye may see.
    pub reduction: String,
    /// The number of rays, each traced for the closest and for any hit.
    pub rays: u64,
    /// Rays without a reported hit where one is certain.
    pub missed: u64,
    /// Reported hits that are not on the ray.
    pub false_hits: u64,
    /// Reported hits behind a certain one.
    pub wrong_primitive: u64,
    /// Rays that hit their triangle, but with t off by more than the bound. This is no fault.
    pub adrift: u64,
    /// The largest error of t along the ray, in ulps of the largest coordinate of origin and triangle.
    pub t_error_ulps: f64,
    /// The same error across the triangle's plane.
    pub plane_error_ulps: f64,
    /// The largest move of a vertex, in the mesh's unit.
    pub moved: Option<f64>,
    /// The largest possible move.
    pub moved_bound: Option<f64>,
    /// Levels of the tree.
    pub depth: Option<u32>,
    /// The most nodes on the stack of a ray.
    pub stack: Option<u32>,
    /// The time to build and to trace.
    pub time_ms: f64,
    /// One of the rays at fault: the bits of origin, `t_min`, direction and `t_max`, and the answer.
    pub example: Option<String>,
}

impl Row {
    /// Counts the verdict on an answer. `example` describes the ray.
    pub fn count(&mut self, verdict: &Verdict, example: impl FnOnce() -> String) {
        self.rays += 1;
        self.adrift += u64::from(verdict.is_adrift);
        let larger = |to: &mut f64, error: Option<f64>| *to = to.max(error.unwrap_or(0.0));
        larger(&mut self.t_error_ulps, verdict.t_error);
        larger(&mut self.plane_error_ulps, verdict.plane_error);
        let Some(fault) = verdict.fault else {
            return;
        };
        *match fault {
            Fault::Missed => &mut self.missed,
            Fault::False => &mut self.false_hits,
            Fault::WrongPrimitive => &mut self.wrong_primitive,
        } += 1;
        if self.example.is_none() {
            self.example = Some(format!("{fault:?}: {}", example()));
        }
    }

    /// Adds another row. Counts and times are summed, the larger errors are kept, and so is the move that is nearer to its
    /// bound.
    pub fn add(&mut self, other: &Self) {
        self.rays += other.rays;
        self.missed += other.missed;
        self.false_hits += other.false_hits;
        self.wrong_primitive += other.wrong_primitive;
        self.adrift += other.adrift;
        self.t_error_ulps = self.t_error_ulps.max(other.t_error_ulps);
        self.plane_error_ulps = self.plane_error_ulps.max(other.plane_error_ulps);
        self.depth = self.depth.max(other.depth);
        self.stack = self.stack.max(other.stack);
        self.time_ms += other.time_ms;
        if other.moved_share() > self.moved_share() {
            (self.moved, self.moved_bound) = (other.moved, other.moved_bound);
        }
    }

    /// The largest move as a share of its bound; below 0 if no vertex may move.
    fn moved_share(&self) -> f64 {
        match (self.moved, self.moved_bound) {
            (Some(moved), Some(bound)) if moved > 0.0 => moved / bound,
            (Some(_), Some(_)) => 0.0,
            _ => -1.0,
        }
    }

    /// The number of faults, which must be 0.
    #[must_use]
    pub fn faults(&self) -> u64 {
        self.missed + self.false_hits + self.wrong_primitive
    }

    /// Whether no vertex moved beyond its bound.
    #[must_use]
    pub fn keeps_its_bound(&self) -> bool {
        match (self.moved, self.moved_bound) {
            (Some(moved), Some(bound)) => moved <= bound,
            _ => true,
        }
    }
}
