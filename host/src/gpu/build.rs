//! Builds and refits on the GPU.

mod record;
mod scratch;

use self::scratch::Scratch;
pub(super) use self::scratch::pyramid_bytes;
use super::buffer::Range;
use super::bvh::{self, Built, Lists};
use super::coding::Coding;
use super::fit::{FIT_BYTES, Fallback};
use super::program::{Program, Recorder};
use super::sides::{Components, Subset, TargetRanges};
use super::sort::Keys;
use super::work::Work;
use super::{Bvh, Frame, Gpu, GpuError, Mesh, Misfit};
use crate::tree::most_triangles;
use crate::{BuildConfig, CodeBits, MeshError, RefitError};
use slimbvh_core::topology::depth_bound;
use std::sync::atomic::{AtomicU64, Ordering};

/// The number of programs kept: a few alternating meshes, with a few targets each.
const KEPT_PROGRAMS: usize = 16;

/// Advice for a mesh that is too large.
const TOO_LARGE: &str = "take a smaller mesh, or the CPU";

/// Builds hierarchies on the GPU. Keeps its buffers and programs from one build to the next.
///
/// For a codec, nodes and triangles are first built in full, in the builder's buffers, and then coded in the same frame.
/// With triangles on a lattice ([`BuildConfig::mesh`]) the vertices must lie on it, as after [`crate::Mesh::snap`]; any
/// other vertex is moved to a neighbouring lattice point.
#[derive(Debug)]
pub struct Builder {
    pub(super) config: BuildConfig,
    /// The stamp of the hierarchy whose plain nodes are in the encoder; `None` if none is.
    plain_of: Option<u64>,
    /// The largest triangle count so far.
    largest: u32,
    pub(super) scratch: Scratch,
    programs: Vec<(Key, Program)>,
}

/// The task of a program.
#[derive(Clone, Debug, PartialEq)]
enum Task {
    /// Sorts triangles along the curve.
    Sort,
    /// Builds over all triangles.
    Build(Built),
    /// Builds over the triangles that face a target.
    BuildSet(Built, Components, Box<TargetRanges>),
    /// Refits boxes to the present triangles.
    Refit(Built),
}

/// The inputs that a program was recorded for.
#[derive(Clone, Debug, PartialEq)]
struct Key {
    task: Task,
    mesh: Mesh,
    scratch_bytes: u64,
}

impl Builder {
    /// The possible stages of a build.
    pub const STAGES: [&str; 14] = [
        "gather", "bounds", "morton", "sort", "decide", "classify", "scan", "fit", "compact",
        "snap", "topology", "refit", "wide", "encode",
    ];

    /// A builder with empty buffers. Codecs without GPU kernels are refused by the build.
    ///
    /// # Panics
    /// If the codecs of nodes and triangles cannot be combined ([`crate::check_codecs`]).
    #[must_use]
    pub fn new(config: BuildConfig) -> Self {
        if let Err(error) = crate::check_codecs(config.nodes, config.mesh) {
            panic!("{error}");
        }
        Self {
            config,
            plain_of: None,
            largest: 0,
            scratch: Scratch::new(),
            programs: Vec::new(),
        }
    }

    /// Records the build of a hierarchy over a mesh, in the memory of an earlier one. Nothing is read back. All later
    /// commands of the frame may use the hierarchy.
    ///
    /// # Errors
    /// For a codec without GPU kernels, and a mesh above the GPU's limits. The check precedes every allocation; the earlier
    /// hierarchy is unchanged.
    pub fn build(&mut self, frame: &mut Frame, mesh: &Mesh, bvh: &mut Bvh) -> Result<(), GpuError> {
        self.sort(frame, mesh)?;
        self.build_sorted(frame, mesh, Subset::All, bvh)
    }

    /// Records the sort of a mesh's triangles along the space-filling curve, once for all hierarchies over subsets of them.
    ///
    /// # Errors
    /// Those of [`Self::build`].
    pub fn sort(&mut self, frame: &mut Frame, mesh: &Mesh) -> Result<(), GpuError> {
        let (gpu, count) = (frame.gpu(), mesh.triangle_count);
        self.check(gpu, count)?;
        if count == 0 {
            return Ok(());
        }
        self.make_room(count);
        let sorted = gpu.checked(|| self.encode(frame, Task::Sort, mesh));
        sorted.inspect_err(|_| self.forget())
    }

    /// Records the build of a hierarchy over the mesh that was sorted last, or a subset of it, in the memory of an earlier
    /// one.
    ///
    /// # Errors
    /// Those of [`Self::build`], and for a target without sides.
    pub fn build_sorted(
        &mut self,
        frame: &mut Frame,
        mesh: &Mesh,
        subset: Subset,
        bvh: &mut Bvh,
    ) -> Result<(), GpuError> {
        let gpu = frame.gpu();
        let count = mesh.triangle_count;
        self.check(gpu, count)?;
        let target = match subset {
            Subset::All => {
                bvh.place = None;
                None
            }
            Subset::Of { components, sides } => {
                Some((components.clone(), Box::new(sides.ranges()?.clone())))
            }
        };
        self.make_room(count);
        self.plain_of = None;
        let recorded = gpu.checked(|| {
            let is_reduced = target.is_some() && count > 0;
            let mut built = self.reserve_for(gpu, count, is_reduced, bvh)?;
            if let (Some((_, rule)), Some(place)) = (&target, &bvh.place) {
                let fallback = Fallback {
                    place: place.clone(),
                    fit: bvh.fit.range(gpu, FIT_BYTES),
                    rule: (**rule).clone(),
                };
                built.fallback = Some(Box::new(fallback));
                bvh.built = Some(built.clone());
            }
            let (counted, limit) = match &built.fallback {
                Some(fallback) => (fallback.fit.clone(), None),
                None => (built.count.clone(), Some(count)),
            };
            let task = match target {
                None => Task::Build(built),
                Some((components, ranges)) => Task::BuildSet(built, components, ranges),
            };
            self.encode(frame, task, mesh)?;
            if is_reduced {
                bvh.recent.read_later(frame, &counted, count, limit);
            }
            bvh.stamp = next_stamp();
            self.plain_of = Some(bvh.stamp);
            Ok(())
        });
        recorded.inspect_err(|_| {
            self.forget();
            *bvh = Bvh::new();
        })
    }

    /// Makes room in a hierarchy, and in the encoder for its plain nodes and triangles.
    pub(super) fn reserve_for(
        &mut self,
        gpu: &Gpu,
        triangle_count: u32,
        is_reduced: bool,
        bvh: &mut Bvh,
    ) -> Result<Built, GpuError> {
        let depth_bound = depth_bound(self.key_bits(), triangle_count);
        let storage = (&self.config, &mut self.scratch.encoder);
        bvh.reserve(gpu, triangle_count, depth_bound, is_reduced, storage)
    }

    /// [`Self::build_sorted`] over a subset, in a hierarchy with reserved memory.
    ///
    /// # Errors
    /// Those of [`Self::build_sorted`].
    pub(crate) fn build_reserved(
        &mut self,
        frame: &mut Frame,
        mesh: &Mesh,
        subset: Subset,
        bvh: &Bvh,
    ) -> Result<(), GpuError> {
        let built = bvh.built()?.clone();
        let task = match subset {
            Subset::All => Task::Build(built),
            Subset::Of { components, sides } => {
                let ranges = Box::new(sides.ranges()?.clone());
                Task::BuildSet(built, components.clone(), ranges)
            }
        };
        self.plain_of = None;
        let recorded = frame.gpu().checked(|| self.encode(frame, task, mesh));
        recorded.inspect_err(|_| self.forget())
    }

    /// Reserves memory for a hierarchy over a subset of a mesh, to be built later in the frame.
    ///
    /// # Errors
    /// Those of [`Self::build`].
    pub(crate) fn reserve(
        &mut self,
        gpu: &Gpu,
        mesh: &Mesh,
        bvh: &mut Bvh,
    ) -> Result<(), GpuError> {
        let count = mesh.triangle_count;
        self.check(gpu, count)?;
        gpu.checked(|| self.reserve_for(gpu, count, count > 0, bvh).map(|_| ()))
            .inspect_err(|_| *bvh = Bvh::new())
    }

    /// Refuses a codec without GPU kernels and a mesh above the GPU's limits, before anything is allocated.
    pub(super) fn check(&self, gpu: &Gpu, triangle_count: u32) -> Result<(), GpuError> {
        Coding::of(&self.config)?;
        let limit = most_triangles(self.config.nodes, self.config.mesh);
        if triangle_count as usize > limit {
            return Err(GpuError::Mesh(MeshError::TooManyTriangles {
                triangle_count: triangle_count as usize,
                limit,
            }));
        }
        // A coded hierarchy is smaller than a plain one.
        gpu.check_sizes(&self.sizes(triangle_count), TOO_LARGE)
    }

    /// Checks a mesh on the host against the builder's lattice.
    pub(crate) fn check_mesh(&self, mesh: &crate::Mesh) -> Result<(), GpuError> {
        mesh.validate()?;
        if let Some(step_exponent) = self.config.mesh.step_exponent() {
            mesh.check_lattice(step_exponent)?;
        }
        Ok(())
    }

    /// Drops programs over buffers that will be too small, so that old and new buffers need not fit together.
    fn make_room(&mut self, triangle_count: u32) {
        if triangle_count > self.largest {
            self.programs.clear();
            self.largest = triangle_count;
        }
    }

    /// Drops programs over buffers that are replaced.
    pub(super) fn drop_programs(&mut self) {
        self.plain_of = None;
        self.programs.clear();
    }

    /// The lists of trees.
    pub(super) fn lists(&self) -> Result<Lists, GpuError> {
        let coding = Coding::of(&self.config)?;
        Ok(Lists { coding })
    }

    /// Drops everything after an error, because some of it may be incomplete.
    fn forget(&mut self) {
        self.largest = 0;
        self.plain_of = None;
        self.programs.clear();
        self.scratch = Scratch::new();
    }

    /// Records a refit of a hierarchy to the present vertices of the mesh that it was built over.
    ///
    /// # Errors
    /// For a mesh with a different number of triangles, and for a hierarchy that is unbuilt, reduced, or in a codec and not
    /// the latest build of this builder. Only the latest build's plain nodes are still there to refit.
    pub fn refit(&mut self, frame: &mut Frame, mesh: &Mesh, bvh: &mut Bvh) -> Result<(), GpuError> {
        let gpu = frame.gpu();
        let built = bvh.built()?.clone();
        if built.triangle_count != mesh.triangle_count {
            return Err(GpuError::Refit(RefitError::TriangleCount {
                triangle_count: mesh.triangle_count as usize,
                expected: built.triangle_count as usize,
            }));
        }
        if built.is_reduced {
            return Err(GpuError::Refit(RefitError::Reduced));
        }
        if !self.can_refit(bvh) {
            return Err(Misfit::NotBuiltLast.of("the hierarchy"));
        }
        self.check(gpu, mesh.triangle_count)?;
        let recorded = gpu.checked(|| self.encode(frame, Task::Refit(built), mesh));
        recorded.inspect_err(|_| self.forget())
    }

    /// Whether what a refit of this hierarchy needs is still there: of one in a codec its plain nodes.
    pub(crate) fn can_refit(&self, bvh: &Bvh) -> bool {
        let is_coded = bvh
            .built
            .as_ref()
            .is_some_and(|built| built.coded.is_some());
        !is_coded || self.plain_of == Some(bvh.stamp)
    }

    /// Bytes of the buffers between the stages. The next build reuses them.
    #[must_use]
    pub fn scratch_bytes(&self) -> u64 {
        self.scratch.bytes()
    }

    /// The work of the latest frame's programs, by stage: of a sort and a build, or of a refit.
    pub fn work(&self) -> impl Iterator<Item = &Work> {
        self.programs.iter().flat_map(|(_, program)| program.work())
    }

    /// The range with the exponent of the mesh that was sorted or refitted last.
    pub(super) fn exponent(&self) -> Result<Range, GpuError> {
        let kept = self.scratch.exponent.kept(16);
        kept.ok_or_else(|| Misfit::NoMesh.of("the builder"))
    }

    fn key_bits(&self) -> u32 {
        match self.config.code_bits {
            CodeBits::Bits30 => 30,
            CodeBits::Bits63 => 63,
        }
    }

    /// The largest buffers of a build. Triangles that share corners may take two bytes more than in full; the nodes then take more.
    fn sizes(&self, count: u32) -> [(&'static str, u64); 4] {
        let keys = self.keys();
        [
            ("the nodes", bvh::node_bytes(count)),
            ("the leaf triangles", bvh::triangle_bytes(count)),
            (
                "the items of the sort",
                u64::from(count) * keys.item_bytes(),
            ),
            ("the pyramid of boxes", pyramid_bytes(count)),
        ]
    }

    pub(super) fn keys(&self) -> Keys {
        match self.config.code_bits {
            CodeBits::Bits30 => Keys::OneWord,
            CodeBits::Bits63 => Keys::TwoWords,
        }
    }

    /// Encodes the program for these buffers. Reuses an earlier program if it matches.
    fn encode(&mut self, frame: &mut Frame, task: Task, mesh: &Mesh) -> Result<(), GpuError> {
        let mut key = Key {
            task,
            mesh: mesh.clone(),
            scratch_bytes: self.scratch.bytes(),
        };
        let kept = self.programs.iter().position(|(other, _)| *other == key);
        match kept {
            Some(place) => self.programs[place..].rotate_left(1),
            None => {
                let gpu = frame.gpu();
                let mut recorder = Recorder::default();
                let to = &mut recorder;
                match &key.task {
                    Task::Sort => self.record_sort(gpu, to, mesh),
                    Task::Build(bvh) | Task::BuildSet(bvh, ..) | Task::Refit(bvh)
                        if mesh.triangle_count == 0 =>
                    {
                        self.record_empty(gpu, to, bvh);
                    }
                    Task::Build(bvh) => self.record_build(gpu, to, mesh, bvh),
                    Task::BuildSet(bvh, components, sides) => {
                        self.record_build_set(gpu, to, mesh, bvh, (components, sides));
                    }
                    Task::Refit(bvh) => self.record_refit(gpu, to, mesh, bvh),
                }
                // Programs over replaced buffers can no longer be used.
                let scratch_bytes = self.scratch.bytes();
                if scratch_bytes != key.scratch_bytes {
                    self.programs.clear();
                    key.scratch_bytes = scratch_bytes;
                }
                if self.programs.len() == KEPT_PROGRAMS {
                    self.programs.remove(0);
                }
                let program = recorder.finish(gpu)?;
                self.programs.push((key, program));
            }
        }
        if let Some((_, program)) = self.programs.last() {
            program.encode(frame);
        }
        Ok(())
    }
}

/// A number unique to a build.
fn next_stamp() -> u64 {
    static BUILDS: AtomicU64 = AtomicU64::new(1);
    BUILDS.fetch_add(1, Ordering::Relaxed)
}
