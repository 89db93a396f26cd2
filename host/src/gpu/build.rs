//! Builds and refits on the GPU.

mod record;
mod scratch;

use self::scratch::Scratch;
pub(super) use self::scratch::pyramid_bytes;
use super::buffer::Range;
use super::bvh::{self, Built};
use super::coding::Coding;
use super::program::{Program, Recorder};
use super::sides::{Components, Subset, TargetRanges};
use super::sort::Keys;
use super::work::Work;
use super::{Bvh, Frame, Gpu, GpuError, Mesh, Misfit};
use crate::tree::most_triangles;
use crate::{BuildConfig, CodeBits, MeshError, RefitError};
use slimbvh_core::topology::depth_bound;
use std::sync::atomic::{AtomicU64, Ordering};

/// Programs kept: some meshes in turn, and some targets for each.
const KEPT_PROGRAMS: usize = 16;

/// What to do about a mesh that is too large.
const TOO_LARGE: &str = "take a smaller mesh, or the CPU";

/// Builds hierarchies on the GPU, and keeps its buffers and programs from one to the next.
///
/// In a codec, nodes and triangles are written in full first, into buffers of the builder's, and coded in the same frame. Of a
/// mesh on a lattice ([`BuildConfig::mesh`]) the vertices must lie on it, as [`crate::Mesh::snap`] leaves them: any other counts
/// as a point of the lattice next to it.
#[derive(Debug)]
pub struct Builder {
    pub(super) config: BuildConfig,
    /// The build whose plain nodes the encoder has: none, or a hierarchy's stamp.
    plain_of: Option<u64>,
    /// The most triangles so far.
    largest: u32,
    pub(super) scratch: Scratch,
    programs: Vec<(Key, Program)>,
}

/// What a program does.
#[derive(Clone, Debug, PartialEq)]
enum Task {
    /// Puts triangles in the order of the curve.
    Sort,
    /// Builds over all of them.
    Build(Built),
    /// Builds over those that face a target.
    BuildSet(Built, Components, Box<TargetRanges>),
    /// Moves boxes to where the triangles are now.
    Refit(Built),
}

/// What a program was made for.
#[derive(Clone, Debug, PartialEq)]
struct Key {
    task: Task,
    mesh: Mesh,
    scratch_bytes: u64,
}

impl Builder {
    /// The stages that a build may have.
    pub const STAGES: [&str; 11] = [
        "bounds", "morton", "sort", "decide", "classify", "scan", "compact", "snap", "topology",
        "refit", "encode",
    ];

    /// A builder without buffers yet. Codecs that only the CPU has are refused when it builds.
    ///
    /// # Panics
    /// If the codecs of nodes and triangles do not go together ([`crate::check_codecs`]).
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

    /// Records the build of a hierarchy over a mesh, in place of an earlier one, whose memory is used again. Nothing is
    /// read back, and all later commands of the frame may use the hierarchy.
    ///
    /// # Errors
    /// For a codec that only the CPU has, and where the mesh is larger than the GPU takes, before anything is allocated; the
    /// earlier hierarchy stays as it was.
    pub fn build(&mut self, frame: &mut Frame, mesh: &Mesh, bvh: &mut Bvh) -> Result<(), GpuError> {
        self.sort(frame, mesh)?;
        self.build_sorted(frame, mesh, Subset::All, bvh)
    }

    /// Records that a mesh's triangles be put in the order of the curve, once for all hierarchies over subsets of them.
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

    /// Records the build of a hierarchy over the mesh that was sorted last, or over a subset of it, in place of an earlier
    /// one.
    ///
    /// # Errors
    /// Those of [`Self::build`], and for a target that was not set.
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
            Subset::All => None,
            Subset::Of { components, sides } => {
                Some((components.clone(), Box::new(sides.ranges()?.clone())))
            }
        };
        self.make_room(count);
        self.plain_of = None;
        let recorded = gpu.checked(|| {
            let is_reduced = target.is_some() && count > 0;
            let built = self.reserve_for(gpu, count, is_reduced, bvh)?;
            let task = match target {
                None => Task::Build(built),
                Some((components, ranges)) => Task::BuildSet(built, components, ranges),
            };
            self.encode(frame, task, mesh)?;
            bvh.stamp = next_stamp();
            self.plain_of = Some(bvh.stamp);
            Ok(())
        });
        recorded.inspect_err(|_| {
            self.forget();
            *bvh = Bvh::new();
        })
    }

    /// Makes room in a hierarchy, and for what is plain of it.
    fn reserve_for(
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

    /// [`Self::build_sorted`], over a subset, of a hierarchy that has its room.
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

    /// Makes room for a hierarchy over a subset of a mesh, which is built later in the frame.
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

    /// Refuses a codec that only the CPU has, and a mesh that is larger than the GPU takes, before anything is allocated.
    pub(super) fn check(&self, gpu: &Gpu, triangle_count: u32) -> Result<(), GpuError> {
        Coding::of(&self.config)?;
        let limit = most_triangles(self.config.mesh);
        if triangle_count as usize > limit {
            return Err(GpuError::Mesh(MeshError::TooManyTriangles {
                triangle_count: triangle_count as usize,
                limit,
            }));
        }
        // What is coded is smaller than what is plain.
        gpu.check_sizes(&self.sizes(triangle_count), TOO_LARGE)
    }

    /// Refuses a mesh on the CPU that this builder would not take there.
    pub(crate) fn check_mesh(&self, mesh: &crate::Mesh) -> Result<(), GpuError> {
        mesh.validate()?;
        if let Some(step_exponent) = self.config.mesh.step_exponent() {
            mesh.check_lattice(step_exponent)?;
        }
        Ok(())
    }

    /// Lets go of programs over buffers that will be too small, so that old and new ones need not fit at once.
    fn make_room(&mut self, triangle_count: u32) {
        if triangle_count > self.largest {
            self.programs.clear();
            self.largest = triangle_count;
        }
    }

    /// Lets go of everything: some of it may not have been made.
    fn forget(&mut self) {
        self.largest = 0;
        self.plain_of = None;
        self.programs.clear();
        self.scratch = Scratch::new();
    }

    /// Records that a hierarchy's boxes be moved to where the mesh's vertices are now; the triangles must be those that it
    /// was built over.
    ///
    /// # Errors
    /// For a mesh with another number of triangles, and a hierarchy that has not been built, is reduced, or is in a codec and not
    /// the one that this builder built last: only of that it has all there is to be moved.
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
        if built.coded.is_some() && self.plain_of != Some(bvh.stamp) {
            return Err(Misfit::NotBuiltLast.of("the hierarchy"));
        }
        self.check(gpu, mesh.triangle_count)?;
        let recorded = gpu.checked(|| self.encode(frame, Task::Refit(built), mesh));
        recorded.inspect_err(|_| self.forget())
    }

    /// Bytes of the buffers between the stages; they are kept for the next build.
    #[must_use]
    pub fn scratch_bytes(&self) -> u64 {
        self.scratch.bytes()
    }

    /// What the programs of the latest frames ask of the GPU, stage by stage: a sort and a build, or a refit.
    pub fn work(&self) -> impl Iterator<Item = &Work> {
        self.programs.iter().flat_map(|(_, program)| program.work())
    }

    /// Where the exponent of the mesh is that was sorted or refitted last.
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

    /// The largest buffers of a build.
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

    /// Encodes the program for these buffers, an earlier one where it fits.
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
                // Programs over buffers that were too small are of no more use.
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

/// A number that no other build has.
fn next_stamp() -> u64 {
    static BUILDS: AtomicU64 = AtomicU64::new(1);
    BUILDS.fetch_add(1, Ordering::Relaxed)
}
