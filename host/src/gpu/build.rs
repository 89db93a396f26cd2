//! Builds and refits on the GPU.

use super::buffer::{Range, Slot};
use super::bvh::{self, Built};
use super::program::{Groups, Program, Recorder, Uniform, groups, threads};
use super::scan::Scan;
use super::sort::{Keys, Sort};
use super::work::Work;
use super::{Bvh, Frame, Gpu, GpuError, Kernel, Mesh};
use crate::{BuildConfig, CodeBits, RefitError};
use slimbvh_core::aabb::Aabb;
use slimbvh_core::bounds::scene_exponent;
use slimbvh_core::launch::BLOCK;
use slimbvh_core::node::LEAF_SIZE;
use slimbvh_core::refit::{PyramidBox, group_count};
use slimbvh_core::topology::depth_bound;
use wgpu::BufferUsages;

/// Programs kept: a double buffer of meshes, built and refitted.
const KEPT_PROGRAMS: usize = 4;

/// Builds hierarchies on the GPU, and keeps its buffers and programs from one to the next.
#[derive(Debug)]
pub struct Builder {
    config: BuildConfig,
    scratch: Scratch,
    programs: Vec<(Key, Program)>,
}

/// What a program was made for.
#[derive(Clone, Debug, PartialEq)]
struct Key {
    is_refit: bool,
    mesh: Mesh,
    bvh: Built,
    scratch_bytes: u64,
}

/// Buffers between the stages.
#[derive(Debug)]
struct Scratch {
    blocks: Slot,
    frame: Slot,
    items: Slot,
    sort: Sort,
    codes: Slot,
    kept: Slot,
    kept_before: Slot,
    scan: Scan,
    splits: Slot,
    pyramid: Slot,
    levels: [Slot; 2],
    node_groups: Slot,
}

impl Builder {
    /// A builder without buffers yet.
    #[must_use]
    pub fn new(config: BuildConfig) -> Self {
        Self {
            config,
            scratch: Scratch::new(),
            programs: Vec::new(),
        }
    }

    /// Records the build of a hierarchy over a mesh, in place of an earlier one, whose memory is used again. Nothing is
    /// read back, and all later commands of the frame may use the hierarchy.
    ///
    /// # Errors
    /// Where the mesh is larger than the GPU takes, before anything is allocated; the earlier hierarchy stays as it was.
    pub fn build(&mut self, frame: &mut Frame, mesh: &Mesh, bvh: &mut Bvh) -> Result<(), GpuError> {
        let gpu = frame.gpu();
        let count = mesh.triangle_count;
        gpu.check_sizes(&self.sizes(count), "take a smaller mesh, or the CPU")?;
        gpu.checked(|| {
            let built = bvh.reserve(gpu, count, depth_bound(self.key_bits(), count));
            self.encode(frame, mesh, &built, false)
        })
    }

    /// Records that a hierarchy's boxes be moved to where the mesh's vertices are now; the triangles must be those that it
    /// was built over.
    ///
    /// # Errors
    /// For a mesh with another number of triangles, and a hierarchy that has not been built.
    pub fn refit(&mut self, frame: &mut Frame, mesh: &Mesh, bvh: &mut Bvh) -> Result<(), GpuError> {
        let gpu = frame.gpu();
        let built = bvh.built()?.clone();
        if built.triangle_count != mesh.triangle_count {
            return Err(GpuError::Refit(RefitError::TriangleCount {
                triangle_count: mesh.triangle_count as usize,
                expected: built.triangle_count as usize,
            }));
        }
        gpu.check_sizes(
            &self.sizes(mesh.triangle_count),
            "take a smaller mesh, or the CPU",
        )?;
        gpu.checked(|| self.encode(frame, mesh, &built, true))
    }

    /// Bytes of the buffers between the stages; they are kept for the next build.
    #[must_use]
    pub fn scratch_bytes(&self) -> u64 {
        self.scratch.bytes()
    }

    /// What the latest program asks of the GPU, stage by stage.
    #[must_use]
    pub fn work(&self) -> &[Work] {
        self.programs
            .last()
            .map_or(&[], |(_, program)| program.work())
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

    /// Encodes the program for these buffers, the last one where it fits.
    fn encode(
        &mut self,
        frame: &mut Frame,
        mesh: &Mesh,
        built: &Built,
        is_refit: bool,
    ) -> Result<(), GpuError> {
        let mut key = Key {
            is_refit,
            mesh: mesh.clone(),
            bvh: built.clone(),
            scratch_bytes: self.scratch.bytes(),
        };
        let kept = self.programs.iter().position(|(other, _)| *other == key);
        match kept {
            Some(place) => self.programs[place..].rotate_left(1),
            None => {
                let gpu = frame.gpu();
                let mut recorder = Recorder::default();
                if is_refit {
                    self.record_refit(gpu, &mut recorder, mesh, built);
                } else {
                    self.record_build(gpu, &mut recorder, mesh, built);
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

    fn record_build(&mut self, gpu: &Gpu, recorder: &mut Recorder, mesh: &Mesh, bvh: &Built) {
        let count = mesh.triangle_count;
        if count == 0 {
            self.record_empty(gpu, recorder, bvh);
            return;
        }
        let is_30 = self.config.code_bits == CodeBits::Bits30;
        let of_bits = |bits_30, bits_63| if is_30 { bits_30 } else { bits_63 };
        let Mesh {
            vertices, indices, ..
        } = mesh;
        let frame = &self.record_bounds(gpu, recorder, mesh, bvh);

        recorder.stage("morton");
        let keys = self.keys();
        let items = &self
            .scratch
            .items
            .range(gpu, u64::from(count) * keys.item_bytes());
        recorder.dispatch(
            of_bits(Kernel::morton_30, Kernel::morton_63),
            &[],
            &[frame, vertices, indices],
            &[items],
            threads(count),
        );
        recorder.stage("sort");
        self.scratch.sort.record(gpu, recorder, keys, items);

        recorder.stage("snap");
        let exponent = Uniform::Stored(&bvh.exponent);
        let code_bytes = keys.item_bytes() - 4;
        let codes = &self.scratch.codes.range(gpu, u64::from(count) * code_bytes);
        recorder.dispatch(
            of_bits(Kernel::snap_30, Kernel::snap_63),
            &[exponent],
            &[vertices, indices, items],
            &[&bvh.triangles, codes],
            threads(count),
        );

        recorder.stage("topology");
        let splits = &self.splits(gpu, bvh);
        if count <= LEAF_SIZE {
            record_single(recorder, bvh, splits);
        } else {
            let word_count = (count - 1).div_ceil(32);
            let word_bytes = 4 * u64::from(word_count);
            let kept = &self.scratch.kept.range(gpu, word_bytes);
            let before = &self.scratch.kept_before.range(gpu, word_bytes);
            recorder.dispatch(
                of_bits(Kernel::topology_kept_30, Kernel::topology_kept_63),
                &[],
                &[codes],
                &[kept, before],
                threads(word_count),
            );
            self.scratch.scan.record(gpu, recorder, before, &bvh.total);
            recorder.dispatch(
                of_bits(Kernel::topology_nodes_30, Kernel::topology_nodes_63),
                &[],
                &[codes, kept, before],
                &[&bvh.nodes, splits],
                threads(count),
            );
        }
        self.record_boxes(gpu, recorder, bvh, false);
    }

    fn record_refit(&mut self, gpu: &Gpu, recorder: &mut Recorder, mesh: &Mesh, bvh: &Built) {
        if mesh.triangle_count == 0 {
            self.record_empty(gpu, recorder, bvh);
            return;
        }
        self.record_bounds(gpu, recorder, mesh, bvh);
        recorder.stage("snap");
        recorder.update(
            Kernel::snap_again,
            &[Uniform::Stored(&bvh.exponent)],
            &[&mesh.vertices, &mesh.indices],
            &[&bvh.triangles],
            threads(mesh.triangle_count),
        );
        self.record_boxes(gpu, recorder, bvh, true);
    }

    /// A hierarchy over nothing.
    fn record_empty(&mut self, gpu: &Gpu, recorder: &mut Recorder, bvh: &Built) {
        recorder.stage("topology");
        recorder.clear(&bvh.triangles);
        let splits = self.splits(gpu, bvh);
        record_single(recorder, bvh, &splits);
        let exponent = scene_exponent(&Aabb::EMPTY) as u32;
        recorder.write(&bvh.exponent, &[exponent, 0, 0, 0]);
        let [min, max] = [Aabb::EMPTY.min, Aabb::EMPTY.max].map(|corner| corner.to_array());
        recorder.write(&bvh.bounds, bytemuck::cast_slice(&[min, max]));
    }

    /// Stage `bounds`. Returns the frame of the codes.
    fn record_bounds(
        &mut self,
        gpu: &Gpu,
        recorder: &mut Recorder,
        mesh: &Mesh,
        bvh: &Built,
    ) -> Range {
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
            &[&frame, &bvh.exponent, &bvh.bounds],
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
        recorder.update(
            Kernel::refit_nodes,
            &[total],
            &[&bvh.triangles, pyramid, splits],
            &[&bvh.nodes],
            each_node(),
        );
    }

    /// A place for the last triangle of each node's left child.
    fn splits(&mut self, gpu: &Gpu, bvh: &Built) -> Range {
        let node_count = bvh.nodes.size / size_of::<slimbvh_core::Node>() as u64;
        let splits = self.scratch.splits.range(gpu, 4 * node_count);
        splits.touching_nodes(4)
    }
}

/// The tree over so few triangles that they are a leaf.
fn record_single(recorder: &mut Recorder, bvh: &Built, splits: &Range) {
    recorder.dispatch(
        Kernel::topology_single,
        &[Uniform::Params([bvh.triangle_count, 0, 0, 0])],
        &[],
        &[&bvh.nodes, splits, &bvh.total],
        groups(1),
    );
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
            items: Slot::storage("slimbvh items"),
            sort: Sort::new(),
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
        ];
        let slots = slots.iter().map(|slot| slot.bytes()).sum::<u64>();
        slots + self.sort.bytes() + self.scan.bytes()
    }
}
