//! Builds and refits on the GPU.

use super::buffer::{Range, Slot};
use super::bvh::{self, Built};
use super::coding::Coding;
use super::encode::Encoder;
use super::facing::{Components, FacingRanges, Subset};
use super::program::{Groups, Program, Recorder, Uniform, groups, threads};
use super::scan::Scan;
use super::sort::{Keys, Sort};
use super::work::Work;
use super::{Bvh, Frame, Gpu, GpuError, Kernel, Mesh};
use crate::codec::most_triangles;
use crate::{BuildConfig, CodeBits, MeshCodec, MeshError, RefitError};
use slimbvh_core::aabb::Aabb;
use slimbvh_core::bounds::scene_exponent;
use slimbvh_core::encode::FINEST_STEP;
use slimbvh_core::launch::{BLOCK, LANES, dispatch};
use slimbvh_core::refit::{PyramidBox, group_count};
use slimbvh_core::topology::depth_bound;
use std::sync::atomic::{AtomicU64, Ordering};
use wgpu::BufferUsages;

/// Programs kept: some meshes in turn, and some targets for each.
const KEPT_PROGRAMS: usize = 16;

/// What to do about a mesh that is too large.
const TOO_LARGE: &str = "take a smaller mesh, or the CPU";

/// Builds hierarchies on the GPU, and keeps its buffers and programs from one to the next.
///
/// In a codec, nodes and triangles are written in full first, into buffers of the builder's, and coded in the same frame. Of a
/// mesh on a lattice ([`MeshCodec::Lattice`]) the vertices must lie on it, as [`crate::Mesh::snap`] leaves them: any other counts
/// as a point of the lattice next to it.
#[derive(Debug)]
pub struct Builder {
    config: BuildConfig,
    /// The build whose plain nodes the encoder has: none, or a hierarchy's stamp.
    plain_of: Option<u64>,
    /// The most triangles so far.
    largest: u32,
    scratch: Scratch,
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
    BuildFacing(Built, Components, Box<FacingRanges>),
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

/// Buffers between the stages.
#[derive(Debug)]
struct Scratch {
    blocks: Slot,
    frame: Slot,
    exponent: Slot,
    bounds: Slot,
    items: Slot,
    sort: Sort,
    members: Slot,
    in_set: Slot,
    in_set_before: Slot,
    set: Slot,
    codes: Slot,
    kept: Slot,
    kept_before: Slot,
    scan: Scan,
    splits: Slot,
    pyramid: Slot,
    levels: [Slot; 2],
    node_groups: Slot,
    item_groups: Slot,
    encoder: Encoder,
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
            Subset::Facing { components, facing } => {
                Some((components.clone(), Box::new(facing.ranges()?.clone())))
            }
        };
        self.make_room(count);
        self.plain_of = None;
        let recorded = gpu.checked(|| {
            let is_reduced = target.is_some() && count > 0;
            let built = self.reserve_for(gpu, count, is_reduced, bvh)?;
            let task = match target {
                None => Task::Build(built),
                Some((components, ranges)) => Task::BuildFacing(built, components, ranges),
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
        let room = (Coding::of(&self.config)?, &mut self.scratch.encoder);
        Ok(bvh.reserve(gpu, triangle_count, depth_bound, is_reduced, room))
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
            Subset::Facing { components, facing } => {
                let ranges = Box::new(facing.ranges()?.clone());
                Task::BuildFacing(built, components.clone(), ranges)
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
        if let MeshCodec::Lattice { step_exponent } = self.config.mesh {
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
            return Err(GpuError::Unfit {
                what: "the hierarchy",
                fault: "is in a codec and was not built last by this builder; build it again"
                    .into(),
            });
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
        kept.ok_or_else(|| GpuError::Unfit {
            what: "the builder",
            fault: "has seen no mesh; sort, build or refit one first".into(),
        })
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

    fn keys(&self) -> Keys {
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
                    Task::Build(bvh) | Task::BuildFacing(bvh, ..) | Task::Refit(bvh)
                        if mesh.triangle_count == 0 =>
                    {
                        self.record_empty(gpu, to, bvh);
                    }
                    Task::Build(bvh) => self.record_build(gpu, to, mesh, bvh),
                    Task::BuildFacing(bvh, components, facing) => {
                        self.record_build_facing(gpu, to, mesh, bvh, (components, facing));
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

    /// Stages `bounds`, `morton` and `sort`.
    fn record_sort(&mut self, gpu: &Gpu, recorder: &mut Recorder, mesh: &Mesh) {
        let frame = &self.record_bounds(gpu, recorder, mesh);
        recorder.stage("morton");
        let (keys, items) = (self.keys(), self.items(gpu, mesh));
        recorder.dispatch(
            self.of_bits(Kernel::morton_30, Kernel::morton_63),
            &[],
            &[frame, &mesh.vertices, &mesh.indices],
            &[&items],
            threads(mesh.triangle_count),
        );
        recorder.stage("sort");
        self.scratch.sort.record(gpu, recorder, keys, &items);
    }

    fn record_build(&mut self, gpu: &Gpu, recorder: &mut Recorder, mesh: &Mesh, bvh: &Built) {
        recorder.stage("snap");
        self.copy_state(gpu, recorder, bvh);
        let count = mesh.triangle_count;
        let [x, y, z] = dispatch(count.div_ceil(LANES as u32));
        recorder.write(&bvh.count, &[count, x, y, z]);
        let items = self.items(gpu, mesh);
        self.record_tree(gpu, recorder, mesh, bvh, &items);
    }

    /// Stages `classify`, `scan` and `compact`, and the tree over what these leave.
    fn record_build_facing(
        &mut self,
        gpu: &Gpu,
        recorder: &mut Recorder,
        mesh: &Mesh,
        bvh: &Built,
        (components, facing): (&Components, &FacingRanges),
    ) {
        recorder.stage("classify");
        self.copy_state(gpu, recorder, bvh);
        let items = &self.items(gpu, mesh);
        let word_bytes = 4 * u64::from(mesh.triangle_count.div_ceil(32));
        let bits = &self.scratch.in_set.range(gpu, word_bytes);
        let before = &self.scratch.in_set_before.range(gpu, word_bytes);
        let set = &self.scratch.set.range(gpu, items.size);
        let members = &self.scratch.members.range(gpu, word_bytes);
        let each = || threads(mesh.triangle_count);
        let exponent = Uniform::Stored(&bvh.exponent);
        recorder.dispatch(
            Kernel::classify,
            &[exponent, facing.target(), facing.frustum(), facing.needed()],
            &[&mesh.vertices, &mesh.indices, &components.0, &facing.sides],
            &[members],
            each(),
        );
        recorder.dispatch(
            self.of_bits(Kernel::classify_order_30, Kernel::classify_order_63),
            &[],
            &[items, members],
            &[bits, before],
            each(),
        );
        recorder.stage("scan");
        self.scratch.scan.record(gpu, recorder, before, &bvh.count);
        recorder.stage("compact");
        recorder.dispatch(
            self.of_bits(Kernel::classify_compact_30, Kernel::classify_compact_63),
            &[],
            &[items, bits, before],
            &[set],
            each(),
        );
        recorder.stage("snap");
        self.record_tree(gpu, recorder, mesh, bvh, set);
    }

    /// Stages `snap`, `topology` and `refit`, over as many of the items as `bvh.count` says.
    fn record_tree(
        &mut self,
        gpu: &Gpu,
        recorder: &mut Recorder,
        mesh: &Mesh,
        bvh: &Built,
        items: &Range,
    ) {
        let count = mesh.triangle_count;
        let item_groups = self.scratch.item_groups.range(gpu, 12);
        recorder.copy(&bvh.count.part(4, 12), &item_groups);
        let each_item = || Groups::Indirect(item_groups.clone());
        let code_bytes = self.keys().item_bytes() - 4;
        let codes = &self.scratch.codes.range(gpu, u64::from(count) * code_bytes);
        recorder.dispatch(
            self.of_bits(Kernel::snap_30, Kernel::snap_63),
            &[Uniform::Stored(&bvh.exponent)],
            &[&mesh.vertices, &mesh.indices, items],
            &[&bvh.triangles, codes],
            each_item(),
        );

        recorder.stage("topology");
        let splits = &self.splits(gpu, bvh);
        let word_count = (count - 1).div_ceil(32).max(1);
        let word_bytes = 4 * u64::from(word_count);
        let kept = &self.scratch.kept.range(gpu, word_bytes);
        let before = &self.scratch.kept_before.range(gpu, word_bytes);
        let total = Uniform::Stored(&bvh.count);
        recorder.dispatch(
            self.of_bits(Kernel::topology_kept_30, Kernel::topology_kept_63),
            &[total],
            &[codes],
            &[kept, before],
            threads(word_count),
        );
        self.scratch.scan.record(gpu, recorder, before, &bvh.total);
        recorder.dispatch(
            self.of_bits(Kernel::topology_nodes_30, Kernel::topology_nodes_63),
            &[total],
            &[codes, kept, before],
            &[&bvh.nodes, splits],
            // A tree over nothing has a node, too.
            threads(count),
        );
        self.record_boxes(gpu, recorder, bvh, false);
        self.record_encode(gpu, recorder, bvh);
    }

    fn record_refit(&mut self, gpu: &Gpu, recorder: &mut Recorder, mesh: &Mesh, bvh: &Built) {
        self.record_bounds(gpu, recorder, mesh);
        recorder.stage("snap");
        self.copy_state(gpu, recorder, bvh);
        recorder.update(
            Kernel::snap_again,
            &[Uniform::Stored(&bvh.exponent)],
            &[&mesh.vertices, &mesh.indices],
            &[&bvh.triangles],
            threads(mesh.triangle_count),
        );
        self.record_boxes(gpu, recorder, bvh, true);
        self.record_encode(gpu, recorder, bvh);
    }

    /// Stage `encode`, where a codec is asked for.
    fn record_encode(&mut self, gpu: &Gpu, recorder: &mut Recorder, bvh: &Built) {
        let Some(coded) = &bvh.coded else { return };
        let step = self.lattice_step();
        let node_groups = self.scratch.node_groups.range(gpu, 12);
        let each_node = || {
            if bvh.triangle_count == 0 {
                threads(1)
            } else {
                Groups::Indirect(node_groups.clone())
            }
        };
        let encoder = &mut self.scratch.encoder;
        encoder.record(gpu, recorder, bvh, coded, step, each_node);
    }

    /// The exponent of the lattice's step, and whether that is in the mesh's unit.
    const fn lattice_step(&self) -> [u32; 4] {
        match self.config.mesh {
            MeshCodec::Lattice { step_exponent } => [step_exponent as u32, 1, 0, 0],
            MeshCodec::F32 | MeshCodec::Leaf10 => [FINEST_STEP as u32, 0, 0, 0],
        }
    }

    /// A hierarchy over nothing.
    fn record_empty(&mut self, gpu: &Gpu, recorder: &mut Recorder, bvh: &Built) {
        recorder.stage("topology");
        recorder.clear(&bvh.triangles);
        recorder.write(&bvh.count, &[0, 0, 0, 0]);
        let kept = self.scratch.kept.range(gpu, 4);
        let before = self.scratch.kept_before.range(gpu, 4);
        let codes = self.scratch.codes.range(gpu, 8);
        let splits = self.splits(gpu, bvh);
        let total = Uniform::Stored(&bvh.count);
        let kernel = self.of_bits(Kernel::topology_kept_30, Kernel::topology_kept_63);
        recorder.dispatch(kernel, &[total], &[&codes], &[&kept, &before], threads(1));
        self.scratch.scan.record(gpu, recorder, &before, &bvh.total);
        recorder.dispatch(
            self.of_bits(Kernel::topology_nodes_30, Kernel::topology_nodes_63),
            &[total],
            &[&codes, &kept, &before],
            &[&bvh.nodes, &splits],
            threads(1),
        );
        let exponent = scene_exponent(&Aabb::EMPTY) as u32;
        recorder.write(&bvh.exponent, &[exponent, 0, 0, 0]);
        let [min, max] = [Aabb::EMPTY.min, Aabb::EMPTY.max].map(|corner| corner.to_array());
        recorder.write(&bvh.bounds, bytemuck::cast_slice(&[min, max]));
        self.record_encode(gpu, recorder, bvh);
    }

    /// What `bounds` found goes to the hierarchy.
    fn copy_state(&mut self, gpu: &Gpu, recorder: &mut Recorder, bvh: &Built) {
        recorder.copy(&self.scratch.exponent.range(gpu, 16), &bvh.exponent);
        recorder.copy(&self.scratch.bounds.range(gpu, 24), &bvh.bounds);
    }

    /// The place of the items of the sort.
    fn items(&mut self, gpu: &Gpu, mesh: &Mesh) -> Range {
        let bytes = u64::from(mesh.triangle_count) * self.keys().item_bytes();
        self.scratch.items.range(gpu, bytes)
    }

    const fn of_bits(&self, bits_30: Kernel, bits_63: Kernel) -> Kernel {
        match self.config.code_bits {
            CodeBits::Bits30 => bits_30,
            CodeBits::Bits63 => bits_63,
        }
    }

    /// Stage `bounds`. Returns the frame of the codes.
    fn record_bounds(&mut self, gpu: &Gpu, recorder: &mut Recorder, mesh: &Mesh) -> Range {
        recorder.stage("bounds");
        let block_count = mesh.triangle_count.div_ceil(BLOCK);
        let blocks = &self.scratch.blocks.range(gpu, 24 * u64::from(block_count));
        recorder.dispatch(
            Kernel::bounds,
            &[],
            &[&mesh.vertices, &mesh.indices],
            &[blocks],
            groups(block_count),
        );
        let frame = self
            .scratch
            .frame
            .range(gpu, size_of::<slimbvh_core::morton::Frame>() as u64);
        let cell_bits = match self.config.code_bits {
            CodeBits::Bits30 => 10,
            CodeBits::Bits63 => 21,
        };
        recorder.dispatch(
            Kernel::frame,
            &[Uniform::Params([cell_bits, 0, 0, 0])],
            &[blocks],
            &[
                &frame,
                &self.scratch.exponent.range(gpu, 16),
                &self.scratch.bounds.range(gpu, 24),
            ],
            groups(1),
        );
        frame
    }

    /// Stage `refit`: the pyramid, then all boxes.
    fn record_boxes(
        &mut self,
        gpu: &Gpu,
        recorder: &mut Recorder,
        bvh: &Built,
        finds_splits: bool,
    ) {
        const BOX_BYTES: u64 = size_of::<PyramidBox>() as u64;
        let splits = &self.splits(gpu, bvh);
        let scratch = &mut self.scratch;
        recorder.stage("refit");
        let node_groups = &scratch.node_groups.range(gpu, 12);
        recorder.copy(&bvh.total.part(4, 12), node_groups);
        let each_node = || Groups::Indirect(node_groups.clone());

        let pyramid = &scratch
            .pyramid
            .range(gpu, pyramid_bytes(bvh.triangle_count));
        let mut level_count = group_count(bvh.triangle_count);
        let [even, odd] = &mut scratch.levels;
        let even = even.range(gpu, u64::from(level_count) * BOX_BYTES);
        let odd = odd.range(gpu, u64::from(level_count.div_ceil(2)) * BOX_BYTES);
        recorder.dispatch(
            Kernel::refit_groups,
            &[],
            &[&bvh.triangles],
            &[&even, &pyramid.touching(even.size)],
            threads(level_count),
        );
        let (mut below, mut level) = (even, odd);
        let mut begin = 0;
        while level_count > 1 {
            begin += level_count;
            below = below.part(0, u64::from(level_count) * BOX_BYTES);
            level_count = level_count.div_ceil(2);
            level = level.part(0, u64::from(level_count) * BOX_BYTES);
            recorder.dispatch(
                Kernel::refit_parents,
                &[Uniform::Params([begin, 0, 0, 0])],
                &[&below],
                &[&level, &pyramid.touching(level.size)],
                threads(level_count),
            );
            std::mem::swap(&mut below, &mut level);
        }

        let total = Uniform::Stored(&bvh.total);
        if finds_splits {
            let kernel = Kernel::refit_splits;
            recorder.dispatch(kernel, &[total], &[&bvh.nodes], &[splits], each_node());
        }
        let from = &[&bvh.triangles, pyramid, splits];
        let is_lattice = bvh.coding().is_some_and(Coding::is_lattice);
        if is_lattice {
            let step = Uniform::Params(self.lattice_step());
            let uniforms = &[total, Uniform::Stored(&bvh.exponent), step];
            let kernel = Kernel::refit_rounded;
            recorder.update(kernel, uniforms, from, &[&bvh.nodes], each_node());
        } else {
            let kernel = Kernel::refit_nodes;
            recorder.update(kernel, &[total], from, &[&bvh.nodes], each_node());
        }
    }

    /// A place for the last triangle of each node's left child.
    fn splits(&mut self, gpu: &Gpu, bvh: &Built) -> Range {
        let node_count = bvh.nodes.size / size_of::<slimbvh_core::Node>() as u64;
        let splits = self.scratch.splits.range(gpu, 4 * node_count);
        splits.touching_nodes(4)
    }
}

/// A number that no other build has.
fn next_stamp() -> u64 {
    static BUILDS: AtomicU64 = AtomicU64::new(1);
    BUILDS.fetch_add(1, Ordering::Relaxed)
}

/// Bytes of all levels.
fn pyramid_bytes(triangle_count: u32) -> u64 {
    let mut level = group_count(triangle_count).max(1);
    let mut entries = u64::from(level);
    while level > 1 {
        level = level.div_ceil(2);
        entries += u64::from(level);
    }
    entries * size_of::<PyramidBox>() as u64
}

impl Scratch {
    const fn new() -> Self {
        let state = BufferUsages::INDIRECT.union(BufferUsages::COPY_DST);
        Self {
            blocks: Slot::storage("slimbvh block bounds"),
            frame: Slot::storage("slimbvh code frame"),
            exponent: Slot::storage("slimbvh bounds' exponent"),
            bounds: Slot::storage("slimbvh bounds"),
            items: Slot::storage("slimbvh items"),
            sort: Sort::new(),
            members: Slot::storage("slimbvh members"),
            in_set: Slot::storage("slimbvh set bits"),
            in_set_before: Slot::storage("slimbvh set counts"),
            set: Slot::storage("slimbvh set items"),
            codes: Slot::storage("slimbvh codes"),
            kept: Slot::storage("slimbvh kept nodes"),
            kept_before: Slot::storage("slimbvh kept counts"),
            scan: Scan::new(),
            splits: Slot::storage("slimbvh splits"),
            pyramid: Slot::storage("slimbvh pyramid"),
            levels: [
                Slot::storage("slimbvh even levels"),
                Slot::storage("slimbvh odd levels"),
            ],
            node_groups: Slot::new("slimbvh node dispatch", state),
            item_groups: Slot::new("slimbvh item dispatch", state),
            encoder: Encoder::new(),
        }
    }

    fn bytes(&self) -> u64 {
        let slots = [
            &self.blocks,
            &self.frame,
            &self.items,
            &self.codes,
            &self.kept,
            &self.kept_before,
            &self.splits,
            &self.pyramid,
            &self.levels[0],
            &self.levels[1],
            &self.node_groups,
            &self.item_groups,
            &self.exponent,
            &self.bounds,
            &self.members,
            &self.in_set,
            &self.in_set_before,
            &self.set,
        ];
        let slots = slots.iter().map(|slot| slot.bytes()).sum::<u64>();
        slots + self.sort.bytes() + self.scan.bytes() + self.encoder.bytes()
    }
}
