//! The interface that the CPU and the GPU share.
//!
//! [`crate::reduce::Hierarchies`] and [`crate::Frames`] are generic over a [`Backend`]. The passes below differ: the CPU
//! runs each pass at once, the GPU records passes and runs them when the frame is submitted.

use crate::topology::Topology;
use crate::{
    BuildConfig, Mesh, MeshError, Picture, RenderReport, RenderSettings, Scene, Stages, Stopwatch,
    ViewError,
};
use slimbvh_core::frustum::Frustum;
use slimbvh_core::orientation::Target;
use std::borrow::Cow;
use std::fmt::Debug;

/// A hierarchy for rays of one kind.
#[derive(Debug)]
pub struct Tree<'a, T, R> {
    /// The hierarchy, whole or reduced.
    pub bvh: &'a T,
    /// For a whole hierarchy: the filter that accepts only triangles facing the target. `None` if all triangles in it
    /// count.
    pub rule: Option<R>,
}

// A derive would require `T: Clone`.
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
    /// For rays from mirrors and glass: all triangles count. `None` if the scene has no mirrors or glass.
    pub mirrors: Option<&'a T>,
}

impl<'a, T, R: Copy> Trees<'a, T, R> {
    /// The trees of a picture's targets: the camera, the lights, then mirrors and glass if there are any. `None` without a
    /// camera.
    #[must_use]
    pub fn of_targets(trees: &[Tree<'a, T, R>], light_count: usize) -> Option<Self> {
        let (primary, rest) = trees.split_first()?;
        let (lights, others) = rest.split_at(light_count.min(rest.len()));
        Some(Self {
            primary: *primary,
            lights: lights.to_vec(),
            mirrors: others.first().map(|tree| tree.bvh),
        })
    }

    /// One hierarchy for all rays.
    #[must_use]
    pub fn all(bvh: &'a T, light_count: usize) -> Self {
        Self {
            primary: Tree::all(bvh),
            lights: (0..light_count).map(|_| Tree::all(bvh)).collect(),
            mirrors: Some(bvh),
        }
    }
}

/// A tree of one backend.
pub type TreeOf<'a, B> = Tree<'a, <B as Backend>::Bvh, <B as Backend>::Rule<'a>>;

/// The trees of a picture on one backend.
pub type TreesOf<'a, B> = Trees<'a, <B as Backend>::Bvh, <B as Backend>::Rule<'a>>;

/// Trees for shadow rays that are built during the picture, each in the memory of the one before.
pub trait DeferredTrees<B: Backend> {
    /// When this light's tree is built.
    fn deferral(&self, light: usize) -> Deferral<'_, B>;

    /// Builds this light's tree if it is not the one in memory, and returns it.
    ///
    /// # Errors
    /// Those of the build.
    fn build(&mut self, recording: &mut B::Recording, light: usize) -> Result<&B::Bvh, B::Error>;
}

/// When a light's tree is built.
#[derive(Debug)]
pub enum Deferral<'a, B: Backend> {
    /// Before the picture: it is among [`Trees::lights`].
    Ready,
    /// During the picture, before the light's rays are traced.
    Always(&'a B::Bvh),
    /// As [`Self::Always`], but only if the light reaches a point of the picture. Else no tree is built, or an empty one.
    IfReached(&'a B::Bvh, &'a B::TargetSides),
}

/// A target of rays, and the side of each component that rays may hit.
#[derive(Clone, Debug, PartialEq)]
pub struct TargetSides {
    /// Where rays come from or lead to, in the mesh's unit.
    pub target: Target,
    /// The region that the rays cross. It bounds sets only; filters ignore it.
    pub frustum: Frustum,
    /// One entry a component: 1 if front faces count, −1 if back faces count, 0 if both count.
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

/// The set of triangles that rays from or to a target may hit.
#[derive(Debug)]
pub struct TargetSet<'a, 's, B: Backend> {
    /// The component of each triangle.
    pub components: B::Components<'a>,
    /// The target, and the sides that rays may hit.
    pub sides: &'s B::TargetSides,
}

/// How much memory a set's tree needs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SetNeed {
    /// None now; what it has may stay.
    Nothing,
    /// As much as a tree over all triangles, as there is no whole tree.
    All,
    /// As much as sets of this share of the triangles need, or as recent frames have needed: the whole tree is there, too.
    Share(f64),
}

/// The geometry that trees are built over.
#[derive(Debug)]
pub struct Source<'a, 'm, B: Backend> {
    /// The geometry as the backend holds it.
    pub held: &'a B::Held,
    /// The caller's geometry.
    pub geometry: B::Geometry<'m>,
}

impl<B: Backend> Clone for Source<'_, '_, B> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<B: Backend> Copy for Source<'_, '_, B> {}

/// What changed since the previous frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Change {
    /// The mesh or the scene is another one.
    Scene,
    /// Vertices and normals moved. Cameras and lights may have moved too.
    Vertices,
    /// No vertex moved. Cameras, lights and other targets may have moved.
    View,
}

/// What a backend learns before a frame.
#[derive(Clone, Copy, Debug)]
pub struct Load<'a> {
    /// What changed since the previous frame.
    pub change: Change,
    /// The surfaces; `None` if no triangles are left out.
    pub topology: Option<&'a Topology>,
    /// Whether sets for lights may be L−, the triangles that face away.
    pub may_turn_away: bool,
}

/// The inputs of one picture.
#[derive(Debug)]
pub struct Shot<'a, 't, B: Backend> {
    /// Camera, lights and materials.
    pub scene: &'a Scene,
    /// The scene as the backend holds it.
    pub held: &'a B::Held,
    /// The trees built so far.
    pub trees: &'a TreesOf<'t, B>,
    /// How the picture is made.
    pub settings: &'a RenderSettings,
    /// The start of the frame.
    pub begin: Stopwatch,
}

/// Where the picture and the progress go.
pub struct Output<'a> {
    /// The picture.
    pub picture: &'a mut Picture,
    /// Called with the share done, 0 to 1. On a GPU each call waits for the device.
    pub progress: Option<&'a mut dyn FnMut(f64)>,
}

/// The size of a tree.
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
    /// Triangles of a set that did not fit into its memory on a GPU, so that its rays went through the whole tree.
    pub unfit_count: usize,
}

impl TreeSize {
    /// Adds the size of another tree.
    pub(crate) fn add(&mut self, other: &Self) {
        self.node_count += other.node_count;
        self.triangle_count += other.triangle_count;
        self.node_bytes += other.node_bytes;
        self.triangle_bytes += other.triangle_bytes;
        self.unfit_count += other.unfit_count;
    }

    /// The larger of each count.
    pub(crate) fn larger(self, other: Self) -> Self {
        Self {
            node_count: self.node_count.max(other.node_count),
            triangle_count: self.triangle_count.max(other.triangle_count),
            node_bytes: self.node_bytes.max(other.node_bytes),
            triangle_bytes: self.triangle_bytes.max(other.triangle_bytes),
            unfit_count: self.unfit_count.max(other.unfit_count),
        }
    }
}

impl<'a> Output<'a> {
    /// Output without progress.
    #[must_use]
    pub fn new(picture: &'a mut Picture) -> Self {
        Self {
            picture,
            progress: None,
        }
    }
}

/// A device that builds trees and renders. A frame is a sequence of these steps. On a backend that records, a step costs no
/// device time yet and returns only errors of recording.
pub trait Backend: Copy + Debug {
    /// `cpu` or `gpu`.
    const NAME: &'static str;
    /// Whether the backend can sort a set's triangles without all others.
    const SORTS_SETS_ALONE: bool;
    /// Whether [`Self::follow`] keeps the order of triangles after small movements. Otherwise it sorts again, where that
    /// costs less than looser boxes.
    const KEEPS_ORDER: bool;
    /// Whether passes are recorded before any of them runs. Then no step can depend on a result of an earlier one.
    const RECORDS: bool;

    /// Why a step failed.
    type Error: std::error::Error + From<MeshError> + From<ViewError> + Send + Sync + 'static;
    /// The passes of one frame: recorded commands on a GPU, times of finished passes on the CPU.
    type Recording;
    /// The caller's geometry: a mesh on the host, or on a GPU also buffers.
    type Geometry<'a>: Copy + Debug + From<&'a Mesh>;
    /// The backend's copy of the geometry and of a picture's scene, kept from frame to frame.
    type Held: Debug + Default;
    /// A hierarchy.
    type Bvh: Debug + Default;
    /// Builds trees.
    type Builder: Debug;
    /// Renders pictures.
    type Renderer: Debug + Default;
    /// A target and its sides, in the form that passes read.
    type TargetSides: Debug + Default;
    /// The component of each triangle.
    type Components<'a>: Copy + Debug;
    /// The filter of a whole tree for one target.
    type Rule<'a>: Copy + Debug;
    /// A tree's size, available at the end of the frame.
    type PendingSize;
    /// The backend's own decisions, available at the end of the frame.
    type PendingDecisions;
    /// The backend's own decisions.
    type Decisions: Debug;

    /// The name of the GPU; `None` on the CPU.
    fn adapter(self) -> Option<String>;

    /// A builder with empty buffers.
    fn builder(self, config: BuildConfig) -> Self::Builder;

    /// Begins a frame.
    fn begin(self) -> Self::Recording;

    /// Ends a frame that has no picture. Returns the time of each stage.
    ///
    /// # Errors
    /// If the device was lost or refuses a command.
    fn submit(self, recording: Self::Recording) -> Result<Stages, Self::Error>;

    /// The numbers of triangles and of vertices.
    fn counts(geometry: Self::Geometry<'_>) -> [usize; 2];

    /// Whether this geometry was loaded last, as far as the backend can tell beside its counts.
    fn is_held(held: &Self::Held, geometry: Self::Geometry<'_>) -> bool;

    /// The mesh on the host, for a survey of its surfaces. Waits for a GPU if it is there alone.
    ///
    /// # Errors
    /// If the device was lost.
    fn on_host<'a>(self, geometry: Self::Geometry<'a>) -> Result<Cow<'a, Mesh>, Self::Error>;

    /// Updates the backend's copy of the geometry.
    ///
    /// # Errors
    /// For geometry above the backend's limits. The check precedes every allocation.
    fn load(
        self,
        held: &mut Self::Held,
        builder: &Self::Builder,
        geometry: Self::Geometry<'_>,
        load: &Load,
    ) -> Result<(), Self::Error>;

    /// Checks that a picture of this scene is within the backend's limits, before anything is allocated.
    ///
    /// # Errors
    /// If it is not.
    fn check_picture(self, scene: &Scene, settings: &RenderSettings) -> Result<(), Self::Error>;

    /// Updates the backend's copy of what pictures need besides the geometry, which must be loaded.
    ///
    /// # Errors
    /// For a scene above the backend's limits.
    fn load_picture(
        self,
        held: &mut Self::Held,
        scene: &Scene,
        change: Change,
    ) -> Result<(), Self::Error>;

    /// The component of each triangle, in the form that passes read. `None` if no triangles are left out.
    fn components<'a>(
        held: &'a Self::Held,
        host: Option<&'a [u32]>,
    ) -> Option<Self::Components<'a>>;

    /// Sorts all triangles along the space-filling curve.
    ///
    /// # Errors
    /// For an invalid mesh.
    fn sort(
        recording: &mut Self::Recording,
        builder: &mut Self::Builder,
        source: Source<Self>,
    ) -> Result<(), Self::Error>;

    /// Follows vertices that moved a little since the sort: takes their new positions in the existing order.
    ///
    /// # Errors
    /// For an invalid mesh, or another mesh.
    fn follow(
        recording: &mut Self::Recording,
        builder: &mut Self::Builder,
        source: Source<Self>,
    ) -> Result<(), Self::Error>;

    /// Refits a whole tree's boxes to the present vertices.
    ///
    /// # Errors
    /// For an invalid mesh, or another mesh than the tree's.
    fn refit(
        recording: &mut Self::Recording,
        builder: &mut Self::Builder,
        source: Source<Self>,
        bvh: &mut Self::Bvh,
    ) -> Result<(), Self::Error>;

    /// Lays out the memory of the whole tree and of sets, where the backend reserves it before it knows their sizes. Returns whether trees
    /// have lost theirs: then all are built anew.
    ///
    /// # Errors
    /// If memory is exhausted, or the device was lost.
    fn lay_out(
        _recording: &mut Self::Recording,
        _builder: &mut Self::Builder,
        _source: Source<Self>,
        _whole: &mut Self::Bvh,
        _sets: &mut [(&mut Self::Bvh, SetNeed)],
    ) -> Result<bool, Self::Error> {
        Ok(false)
    }

    /// Whether the builder can refit this whole tree: it may need what it keeps of its latest build alone.
    fn can_refit(builder: &Self::Builder, bvh: &Self::Bvh) -> bool;

    /// Builds a tree over sorted triangles: those of a set, or all.
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

    /// Builds the only set. The backend sorts its triangles alone if it [can](Self::SORTS_SETS_ALONE).
    ///
    /// # Errors
    /// For an invalid mesh.
    fn build_alone(
        recording: &mut Self::Recording,
        builder: &mut Self::Builder,
        source: Source<Self>,
        set: &TargetSet<Self>,
        bvh: &mut Self::Bvh,
    ) -> Result<(), Self::Error>;

    /// Reserves memory for a tree that [`Self::build_deferred`] builds later in the frame, several times.
    ///
    /// # Errors
    /// If memory is exhausted.
    fn reserve(
        recording: &mut Self::Recording,
        builder: &mut Self::Builder,
        source: Source<Self>,
        bvh: &mut Self::Bvh,
    ) -> Result<(), Self::Error>;

    /// Builds a set as [`Self::build_sorted`] does, in reserved memory.
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

    /// Finds a set without building its tree, to time the division. Only the times of stages `classify`, `scan` and
    /// `compact` count: a GPU cannot run them alone and builds a tree in the spare one.
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

    /// Whether the backend finds the sides itself, because only it holds the present vertices.
    fn decides(held: &Self::Held) -> bool;

    /// Whether the backend [decides](Self::decides) but has not measured yet.
    fn must_measure(held: &Self::Held) -> bool;

    /// Measures the components at the present vertices, if the backend [decides](Self::decides). The mesh must be sorted.
    ///
    /// # Errors
    /// Those of recording.
    fn measure(
        recording: &mut Self::Recording,
        builder: &Self::Builder,
        held: &mut Self::Held,
    ) -> Result<(), Self::Error>;

    /// Fills in a target's sides. They come from the host, or from the backend if it [decides](Self::decides). The camera's
    /// sides must precede a light's.
    ///
    /// # Errors
    /// Those of recording.
    fn set_sides(
        recording: &mut Self::Recording,
        held: &Self::Held,
        host: &TargetSides,
        eye: Option<&Self::TargetSides>,
        to: &mut Self::TargetSides,
    ) -> Result<(), Self::Error>;

    /// Requests the decisions made so far for some targets; `None` if there were none.
    ///
    /// # Errors
    /// If memory is exhausted.
    fn decisions_later(
        recording: &mut Self::Recording,
        held: &Self::Held,
        targets: &[(String, &Self::TargetSides)],
    ) -> Result<Option<Self::PendingDecisions>, Self::Error>;

    /// Waits for the decisions.
    ///
    /// # Errors
    /// If the device was lost.
    fn decisions(self, pending: Self::PendingDecisions) -> Result<Self::Decisions, Self::Error>;

    /// The decisions in words: pairs of a subject, and the decision with its figures.
    fn explain(decisions: &Self::Decisions) -> Vec<(String, String)>;

    /// The filter that a whole tree needs for a target.
    fn rule<'a>(components: Self::Components<'a>, sides: &'a Self::TargetSides) -> Self::Rule<'a>;

    /// Renders, and ends the frame. Returns the times of all its builds, and the report of the render.
    ///
    /// # Errors
    /// For cameras and lights that cannot be rendered, a tree over another mesh, and sizes above the backend's limits.
    fn render(
        self,
        recording: Self::Recording,
        renderer: &mut Self::Renderer,
        shot: &Shot<Self>,
        deferred: Option<&mut dyn DeferredTrees<Self>>,
        output: Output,
    ) -> Result<(Stages, RenderReport), Self::Error>;

    /// A tree's surface area cost, if it is available without waiting for a device.
    fn sah_cost(recording: &mut Self::Recording, bvh: &Self::Bvh) -> Option<f64>;

    /// Requests a tree's size at this point of the frame.
    ///
    /// # Errors
    /// If memory is exhausted.
    fn size_later(
        recording: &mut Self::Recording,
        bvh: &Self::Bvh,
    ) -> Result<Self::PendingSize, Self::Error>;

    /// Waits for a tree's size. A GPU reports only the triangle count.
    ///
    /// # Errors
    /// If the device was lost.
    fn pending_size(self, pending: Self::PendingSize) -> Result<TreeSize, Self::Error>;

    /// A tree's size. Waits for a GPU.
    ///
    /// # Errors
    /// If the device was lost.
    fn size(self, bvh: &Self::Bvh) -> Result<TreeSize, Self::Error>;

    /// Bytes of memory that a tree holds.
    fn held_bytes(bvh: &Self::Bvh) -> usize;

    /// Bytes of memory that builds and pictures use besides trees.
    fn scratch_bytes(builder: &Self::Builder, renderer: &Self::Renderer) -> usize;
}
