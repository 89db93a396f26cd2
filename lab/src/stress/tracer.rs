//! Who is asked.

use super::families::Case;
use super::judge::Answer;
use slimbvh::Ray;

/// Whatever went wrong in a tracer.
pub type Failure = Box<dyn std::error::Error + Send + Sync>;

/// A kind of tree that a tracer builds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Tree {
    /// How nodes and triangles are stored.
    pub codec: String,
    /// Whether only what the case's eye may see is in it; only rays from there are traced.
    pub is_reduced: bool,
}

/// What a tracer says about all rays.
#[derive(Clone, Debug, Default)]
pub struct Outcome {
    /// One a ray.
    pub answers: Vec<Answer>,
    /// The triangles as they are stored, by the caller's index, multiplied by two to the next.
    pub triangles: Vec<[[f32; 3]; 3]>,
    /// See [`Self::triangles`].
    pub exponent: i32,
    /// How far a vertex moved, and how far it might have, in the mesh's unit.
    pub moved: Option<[f64; 2]>,
    /// Levels of the tree.
    pub depth: Option<u32>,
    /// Most nodes that waited for a ray.
    pub stack: Option<u32>,
    /// To build and to trace.
    pub time_ms: f64,
}

/// Something that traces rays.
pub trait Tracer {
    /// In the table.
    fn name(&self) -> &str;

    /// `cpu` or `gpu`.
    fn backend(&self) -> &'static str;

    /// The bound by which it is judged, see [`super::BOUND_ULPS`].
    fn bound_ulps(&self) -> f64;

    /// The trees that are tried on a case.
    fn trees(&self, case: &Case) -> Vec<Tree>;

    /// Builds a tree and traces all rays.
    ///
    /// # Errors
    /// If it refuses the scene, or cannot go on.
    fn trace(&mut self, case: &Case, tree: &Tree, rays: &[Ray]) -> Result<Outcome, Failure>;
}
