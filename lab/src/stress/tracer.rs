//! The interface of a tracer.

use super::families::Case;
use super::judge::Answer;
use slimbvh::Ray;

/// An error of a tracer.
pub type Failure = Box<dyn std::error::Error + Send + Sync>;

/// A kind of tree that a tracer builds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Tree {
    /// The storage of nodes and triangles.
    pub codec: String,
    /// Whether the tree holds only what the case's eye may see. Then only rays from the eye are traced.
    pub is_reduced: bool,
}

/// A tracer's results for all rays.
#[derive(Clone, Debug, Default)]
pub struct Outcome {
    /// One answer per ray.
    pub answers: Vec<Answer>,
    /// The stored triangles by the caller's index, scaled by two to the power of `exponent`.
    pub triangles: Vec<[[f32; 3]; 3]>,
    /// See [`Self::triangles`].
    pub exponent: i32,
    /// The largest move of a vertex and its bound, in the mesh's unit.
    pub moved: Option<[f64; 2]>,
    /// Levels of the tree.
    pub depth: Option<u32>,
    /// The most nodes on the stack of a ray.
    pub stack: Option<u32>,
    /// The time to build and to trace.
    pub time_ms: f64,
}

/// A tracer of rays.
pub trait Tracer {
    /// The name in tables.
    fn name(&self) -> &str;

    /// `cpu` or `gpu`.
    fn backend(&self) -> &'static str;

    /// The bound that its answers are judged by, see [`super::BOUND_ULPS`].
    fn bound_ulps(&self) -> f64;

    /// The trees to test on a case.
    fn trees(&self, case: &Case) -> Vec<Tree>;

    /// Builds a tree and traces all rays.
    ///
    /// # Errors
    /// If the tracer refuses the scene, or fails.
    fn trace(&mut self, case: &Case, tree: &Tree, rays: &[Ray]) -> Result<Outcome, Failure>;
}
