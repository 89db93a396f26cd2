//! What the CPU and a GPU have in common above their passes.
//!
//! [`crate::reduce::Hierarchies`] and [`crate::Frames`] stand once, for any [`Backend`]. The passes below differ: the CPU
//! runs each at once, a GPU records them and runs them when the frame is submitted.

use crate::topology::Topology;
use crate::{
    BuildConfig, Mesh, MeshError, Picture, RenderReport, RenderSettings, Scene, Stages, ViewError,
};
use slimbvh_core::frustum::Frustum;
use slimbvh_core::orientation::Target;
use std::fmt::Debug;
use std::time::Instant;

/// A hierarchy for rays of one kind.
#[derive(Debug)]
pub struct Tree<'a, T, R> {
    /// The hierarchy, whole or reduced.
    pub bvh: &'a T,
    /// In a whole hierarchy: only triangles that face the target count. None where all count that are in it.
    pub rule: Option<R>,
}

// A derive would ask for trees that can be copied.
impl<T, R: Copy> Clone for Tree<'_, T, R> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T, R: Copy> Copy for Tree<'_, T, R> {}

impl<'a, T, R> Tree<'a, T, R> {
    /// All triangles of a hierarchy.
    #[must_use]
    pub const fn all(bvh: &'a T) -> Self {
        Self { bvh, rule: None }
    }
}

/// The hierarchies of a picture, all over the same mesh.
#[derive(Debug)]
pub struct Trees<'a, T, R> {
    /// For rays from the camera.
    pub primary: Tree<'a, T, R>,
    /// For shadow rays, one for each light.
    pub lights: Vec<Tree<'a, T, R>>,
    /// For rays from mirrors and glass: all triangles count. None where the scene has none.
    pub mirrors: Option<&'a T>,
}

impl<'a, T, R: Copy> Trees<'a, T, R> {
    /// One hierarchy for everything.
    #[must_use]
    pub fn all(bvh: &'a T, light_count: usize) -> Self {
        Self {
            primary: Tree::all(bvh),
            lights: (0..light_count).map(|_| Tree::all(bvh)).collect(),
            mirrors: Some(bvh),
        }
    }
}

/// The trees of a backend.
pub type TreesOf<'a, B> = Trees<'a, <B as Backend>::Bvh, <B as Backend>::Rule<'a>>;

/// Trees for shadow rays that are built during the picture, each in place of the one before.
pub trait DeferredTrees<B: Backend> {
    /// How this light's tree comes to be.
    fn deferral(&self, light: usize) -> Deferral<'_, B>;

    /// Builds this light's tree where it is not there yet, and returns it.
    ///
    /// # Errors
    /// Those of the build.
    fn build(&mut self, recording: &mut B::Recording, light: usize) -> Result<&B::Bvh, B::Error>;
}

/// How a light's tree comes to be.
#[derive(Debug)]
pub enum Deferral<'a, B: Backend> {
    /// It is among [`Trees::lights`].
    Ready,
    /// It is built here before the light's rays are traced.
    Always(&'a B::Bvh),
    /// As [`Self::Always`], unless the light reaches nothing: then nothing is built, or a tree over nothing.
    IfReached(&'a B::Bvh, &'a B::TargetSides),
}

/// A target of rays, and the side of each component that counts for it.
#[derive(Clone, Debug, PartialEq)]
pub struct TargetSides {
    /// Where rays come from or lead to, in the mesh's unit.
    pub target: Target,
    /// Where they go. It bounds sets only.
    pub frustum: Frustum,
    /// Of each component: 1 where the front counts, −1 where the back does, 0 where both do.
    pub sides: Vec<i32>,
}

impl Default for TargetSides {
    fn default() -> Self {
        Self {
            target: Target::position([0.0; 3]),
            frustum: Frustum::EVERYWHERE,
            sides: Vec::new(),
        }
    }
}

/// The triangles that rays from or to a target may hit.
#[derive(Debug)]
pub struct TargetSet<'a, 's, B: Backend> {
    /// The component of each triangle.
    pub components: B::Components<'a>,
    /// The target, and which sides count.
    pub sides: &'s B::TargetSides,
}

/// The mesh that trees are built over.
#[derive(Debug)]
pub struct Source<'a, B: Backend> {
    /// What the backend holds of the scene.
    pub held: &'a B::Scene,
    /// On the host.
    pub mesh: &'a Mesh,
}

impl<B: Backend> Clone for Source<'_, B> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<B: Backend> Copy for Source<'_, B> {}

/// What changed in a scene since the frame before.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Change {
    /// It is another scene.
    Scene,
    /// Vertices moved, with their normals, and cameras and lights may have.
    Vertices,
    /// No vertex moved; cameras and lights may have.
    View,
}

/// What a backend needs to know of a scene before a frame.
#[derive(Clone, Copy, Debug)]
pub struct Load<'a> {
    /// As it is now.
    pub scene: &'a Scene,
    /// What changed since the frame before.
    pub change: Change,
    /// How the picture is made; none where only trees are built.
    pub settings: Option<&'a RenderSettings>,
    /// The surfaces, where triangles are left out.
    pub topology: Option<&'a Topology>,
    /// Whether sets for lights may hold what faces away from them.
    pub may_turn_away: bool,
}

/// A picture to be made.
#[derive(Debug)]
pub struct Shot<'a, 't, B: Backend> {
    /// Camera, lights and materials.
    pub scene: &'a Scene,
    /// What the backend holds of the scene.
    pub held: &'a B::Scene,
    /// The trees that are there.
    pub trees: &'a TreesOf<'t, B>,
    /// How the picture is made.
    pub settings: &'a RenderSettings,
    /// When the frame began.
    pub begin: Instant,
}

/// Where a picture goes.
pub struct Output<'a> {
    /// The picture.
    pub picture: &'a mut Picture,
    /// Is told the share done, 0 to 1. On a GPU each of its calls costs a wait.
    pub progress: Option<&'a mut dyn FnMut(f64)>,
}

/// How large a tree is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct TreeSize {
    /// Inner nodes.
    pub node_count: usize,
    /// Triangles in its leaves.
    pub triangle_count: usize,
    /// Bytes of all nodes.
    pub node_bytes: usize,
    /// Bytes of all triangles in leaves.
    pub triangle_bytes: usize,
}

impl TreeSize {
    /// Adds another tree.
    pub(crate) fn add(&mut self, other: &Self) {
        self.node_count += other.node_count;
        self.triangle_count += other.triangle_count;
        self.node_bytes += other.node_bytes;
        self.triangle_bytes += other.triangle_bytes;
    }

    /// The larger number of each.
    pub(crate) fn larger(self, other: Self) -> Self {
        Self {
            node_count: self.node_count.max(other.node_count),
            triangle_count: self.triangle_count.max(other.triangle_count),
            node_bytes: self.node_bytes.max(other.node_bytes),
            triangle_bytes: self.triangle_bytes.max(other.triangle_bytes),
        }
    }
}

impl<'a> Output<'a> {
    /// Only the picture.
    #[must_use]
    pub fn new(picture: &'a mut Picture) -> Self {
        Self {
            picture,
            progress: None,
        }
    }
}

/// What builds trees and renders. Frames are made by steps of these: where a backend records, a step costs nothing yet, and
/// its errors are those of recording.
pub trait Backend: Copy + Debug {
    /// `cpu` or `gpu`.
    const NAME: &'static str;
    /// Whether a set's triangles can be put in order without all others.
    const SORTS_SETS_ALONE: bool;
    /// Whether the order of triangles is kept where vertices moved a little. Else they are sorted again, for less than looser
    /// boxes cost.
    const KEEPS_ORDER: bool;
    /// Whether passes are recorded before any of them runs, so that no step depends on what an earlier one found.
    const RECORDS: bool;

    /// Why a step failed.
    type Error: std::error::Error + From<MeshError> + From<ViewError> + Send + Sync + 'static;
    /// The passes of one frame: their commands, or the times that they took.
    type Recording;
    /// What it holds of a scene from frame to frame.
    type Scene: Debug + Default;
    /// A hierarchy.
    type Bvh: Debug + Default;
    /// What builds.
    type Builder: Debug;
    /// What renders.
    type Renderer: Debug + Default;
    /// A target with the sides that count, as passes read them.
    type TargetSides: Debug + Default;
    /// The component of each triangle.
    type Components<'a>: Copy + Debug;
    /// Which triangles of a whole tree count for a target.
    type Rule<'a>: Copy + Debug;
    /// The size of a tree, known at the end of the frame.
    type PendingSize;
    /// What the backend decided by itself, known at the end of the frame.
    type PendingDecisions;
    /// What the backend decided by itself.
    type Decisions: Debug;

    /// The name of the GPU; none for the CPU.
    fn adapter(self) -> Option<String>;

    /// A builder without buffers yet.
    fn builder(self, config: BuildConfig) -> Self::Builder;

    /// Begins a frame.
    fn begin(self) -> Self::Recording;

    /// Ends a frame without a picture. Returns the time of each stage.
    ///
    /// # Errors
    /// If the device was lost, or a command is refused.
    fn submit(self, recording: Self::Recording) -> Result<Stages, Self::Error>;

    /// Makes what is held of a scene that of the scene as it is now.
    ///
    /// # Errors
    /// For a scene or a picture larger than the backend takes, before anything is allocated.
    fn load(
        self,
        held: &mut Self::Scene,
        builder: &Self::Builder,
        load: &Load,
    ) -> Result<(), Self::Error>;

    /// The component of each triangle, of which the host has a list; none where nothing is left out.
    fn components<'a>(
        held: &'a Self::Scene,
        host: Option<&'a [u32]>,
    ) -> Option<Self::Components<'a>>;

    /// Puts all triangles in the order of the curve.
    ///
    /// # Errors
    /// For an unfit mesh.
    fn sort(
        recording: &mut Self::Recording,
        builder: &mut Self::Builder,
        source: Source<Self>,
    ) -> Result<(), Self::Error>;

    /// Takes vertices that moved a little since the mesh was sorted, in the order that there is.
    ///
    /// # Errors
    /// For an unfit mesh, or another one.
    fn follow(
        recording: &mut Self::Recording,
        builder: &mut Self::Builder,
        source: Source<Self>,
    ) -> Result<(), Self::Error>;

    /// Moves a whole tree's boxes to where the vertices are now.
    ///
    /// # Errors
    /// For an unfit mesh, or another one than that of the tree.
    fn refit(
        recording: &mut Self::Recording,
        builder: &mut Self::Builder,
        source: Source<Self>,
        bvh: &mut Self::Bvh,
    ) -> Result<(), Self::Error>;

    /// Builds a tree over sorted triangles: a set, or all.
    ///
    /// # Errors
    /// Those of recording.
    fn build_sorted(
        recording: &mut Self::Recording,
        builder: &mut Self::Builder,
        source: Source<Self>,
        set: Option<&TargetSet<Self>>,
        bvh: &mut Self::Bvh,
    ) -> Result<(), Self::Error>;

    /// Builds a tree over a set that is the only one: its triangles are sorted alone where the backend can.
    ///
    /// # Errors
    /// For an unfit mesh.
    fn build_alone(
        recording: &mut Self::Recording,
        builder: &mut Self::Builder,
        source: Source<Self>,
        set: &TargetSet<Self>,
        bvh: &mut Self::Bvh,
    ) -> Result<(), Self::Error>;

    /// Makes room for a tree that [`Self::build_deferred`] builds later in the frame, several times.
    ///
    /// # Errors
    /// If memory is exhausted.
    fn reserve(
        recording: &mut Self::Recording,
        builder: &mut Self::Builder,
        source: Source<Self>,
        bvh: &mut Self::Bvh,
    ) -> Result<(), Self::Error>;

    /// [`Self::build_sorted`] of a set, in reserved room.
    ///
    /// # Errors
    /// Those of recording.
    fn build_deferred(
        recording: &mut Self::Recording,
        builder: &mut Self::Builder,
        source: Source<Self>,
        set: &TargetSet<Self>,
        bvh: &mut Self::Bvh,
    ) -> Result<(), Self::Error>;

    /// The division alone: finds a set. Times are those of the stages `classify`, `scan` and `compact`; others do not count. A
    /// GPU, which has no such step alone, builds a tree in the spare one.
    ///
    /// # Errors
    /// Those of [`Self::build_sorted`].
    fn divide(
        recording: &mut Self::Recording,
        builder: &mut Self::Builder,
        source: Source<Self>,
        set: &TargetSet<Self>,
        spare: &mut Self::Bvh,
    ) -> Result<(), Self::Error>;

    /// Whether the backend finds sides by itself, where only it knows the vertices.
    fn decides(held: &Self::Scene) -> bool;

    /// Measures components where the vertices are now, if it [decides](Self::decides). The mesh must be sorted.
    ///
    /// # Errors
    /// Those of recording.
    fn measure(
        recording: &mut Self::Recording,
        builder: &Self::Builder,
        held: &mut Self::Scene,
    ) -> Result<(), Self::Error>;

    /// Fills in a target's sides: those that the host found, or where it [decides](Self::decides) its own, for a light after
    /// those of the eye.
    ///
    /// # Errors
    /// Those of recording.
    fn set_sides(
        recording: &mut Self::Recording,
        held: &Self::Scene,
        host: &TargetSides,
        eye: Option<&Self::TargetSides>,
        to: &mut Self::TargetSides,
    ) -> Result<(), Self::Error>;

    /// What was decided by this point of the frame for some targets; none where nothing was.
    ///
    /// # Errors
    /// If memory is exhausted.
    fn decisions_later(
        recording: &mut Self::Recording,
        held: &Self::Scene,
        targets: &[(String, &Self::TargetSides)],
    ) -> Result<Option<Self::PendingDecisions>, Self::Error>;

    /// Waits for what was decided.
    ///
    /// # Errors
    /// If the device was lost.
    fn decisions(self, pending: Self::PendingDecisions) -> Result<Self::Decisions, Self::Error>;

    /// What was decided in words: what it is about, and the decision with figures.
    fn explain(decisions: &Self::Decisions) -> Vec<(String, String)>;

    /// The rule by which triangles of a whole tree count.
    fn rule<'a>(components: Self::Components<'a>, sides: &'a Self::TargetSides) -> Self::Rule<'a>;

    /// Renders, and ends the frame. Returns the times of all builds in it, and what the render did.
    ///
    /// # Errors
    /// For cameras and lights that make no picture, a tree over another mesh, and what is too large.
    fn render(
        self,
        recording: Self::Recording,
        renderer: &mut Self::Renderer,
        shot: &Shot<Self>,
        deferred: Option<&mut dyn DeferredTrees<Self>>,
        output: Output,
    ) -> Result<(Stages, RenderReport), Self::Error>;

    /// A tree's surface area cost, where it can be known without a wait.
    fn sah_cost(recording: &mut Self::Recording, bvh: &Self::Bvh) -> Option<f64>;

    /// A tree's size at this point of the frame.
    ///
    /// # Errors
    /// If memory is exhausted.
    fn size_later(
        recording: &mut Self::Recording,
        bvh: &Self::Bvh,
    ) -> Result<Self::PendingSize, Self::Error>;

    /// Waits for a tree's size. A GPU knows only the triangles.
    ///
    /// # Errors
    /// If the device was lost.
    fn pending_size(self, pending: Self::PendingSize) -> Result<TreeSize, Self::Error>;

    /// A tree's size, for which a GPU is waited for.
    ///
    /// # Errors
    /// If the device was lost.
    fn size(self, bvh: &Self::Bvh) -> Result<TreeSize, Self::Error>;

    /// Bytes of the memory that a tree holds.
    fn held_bytes(bvh: &Self::Bvh) -> usize;

    /// Bytes of the memory that builds and pictures need besides trees.
    fn scratch_bytes(builder: &Self::Builder, renderer: &Self::Renderer) -> usize;
}
