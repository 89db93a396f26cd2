//! What is counted.

use super::judge::{Fault, Verdict};
use serde::{Deserialize, Serialize};

/// A tracer in one family of scenes at one magnitude.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Row {
    /// Who traces.
    pub tracer: String,
    /// What kind of scene.
    pub family: String,
    /// How large, or how extreme.
    pub magnitude: String,
    /// `cpu` or `gpu`.
    pub backend: String,
    /// How nodes and triangles are stored.
    pub codec: String,
    /// `whole`, or `reduced` to what an eye may see.
    pub reduction: String,
    /// How many were traced, each for the closest and for any hit.
    pub rays: u64,
    /// Nothing is reported where something must be met.
    pub missed: u64,
    /// What is reported is not where the ray is.
    pub false_hits: u64,
    /// Something behind what must be met is reported.
    pub wrong_primitive: u64,
    /// Hits whose ray passes their triangle, but at another place: t is off by more than the bound. No fault.
    pub adrift: u64,
    /// The largest error of t along the ray, in ulps of the largest coordinate of origin and triangle.
    pub t_error_ulps: f64,
    /// The same, across the triangle's plane.
    pub plane_error_ulps: f64,
    /// How far a vertex moved, in the mesh's unit.
    pub moved: Option<f64>,
    /// How far it might have.
    pub moved_bound: Option<f64>,
    /// Levels of the tree.
    pub depth: Option<u32>,
    /// Most nodes that waited for a ray.
    pub stack: Option<u32>,
    /// To build and to trace.
    pub time_ms: f64,
    /// One of the rays at fault: bits of origin, `t_min`, direction, `t_max`, and what was reported.
    pub example: Option<String>,
}

impl Row {
    /// Adds what was found about an answer. `example` tells which ray it was.
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

    /// Adds another row: counts and times are added up, of errors the larger is kept, and of moved vertices what comes nearer
    /// to its bound.
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

    /// How far a vertex moved, as a share of what it might; below 0 where none may.
    fn moved_share(&self) -> f64 {
        match (self.moved, self.moved_bound) {
            (Some(moved), Some(bound)) if moved > 0.0 => moved / bound,
            (Some(_), Some(_)) => 0.0,
            _ => -1.0,
        }
    }

    /// All that must be 0.
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
