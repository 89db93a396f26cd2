//! The stages of a build, one after the other.

use super::super::buffer::Range;
use super::super::bvh::Built;
use super::super::coding::Coding;
use super::super::program::{Groups, Recorder, Uniform, counted, groups, threads};
use super::super::sides::{Components, TargetRanges};
use super::super::{Gpu, Kernel, Mesh};
use super::Builder;
use super::scratch::pyramid_bytes;
use crate::CodeBits;
use slimbvh_core::aabb::Aabb;
use slimbvh_core::bounds::scene_exponent;
use slimbvh_core::encode::FINEST_STEP;
use slimbvh_core::launch::BLOCK;
use slimbvh_core::refit::{PyramidBox, group_count};

impl Builder {
    /// Stages `bounds`, `morton` and `sort`.
    pub(super) fn record_sort(&mut self, gpu: &Gpu, recorder: &mut Recorder, mesh: &Mesh) {
        let grid = &self.record_bounds(gpu, recorder, mesh);
        recorder.stage("morton");
        let (keys, items) = (self.keys(), self.items(gpu, mesh));
        recorder.dispatch(
            self.of_bits(Kernel::morton_30, Kernel::morton_63),
            &[],
            &[grid, &mesh.vertices, &mesh.indices],
            &[&items],
            threads(mesh.triangle_count),
        );
        recorder.stage("sort");
        self.scratch.sort.record(gpu, recorder, keys, &items);
    }

    pub(super) fn record_build(
        &mut self,
        gpu: &Gpu,
        recorder: &mut Recorder,
        mesh: &Mesh,
        bvh: &Built,
    ) {
        recorder.stage("snap");
        self.copy_state(gpu, recorder, bvh);
        recorder.write(&bvh.count, &counted(mesh.triangle_count));
        let items = self.items(gpu, mesh);
        self.record_tree(gpu, recorder, mesh, bvh, &items);
    }

    /// Stages `classify`, `scan` and `compact`, and the tree over what these leave.
    pub(super) fn record_build_facing(
        &mut self,
        gpu: &Gpu,
        recorder: &mut Recorder,
        mesh: &Mesh,
        bvh: &Built,
        (components, facing): (&Components, &TargetRanges),
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

    pub(super) fn record_refit(
        &mut self,
        gpu: &Gpu,
        recorder: &mut Recorder,
        mesh: &Mesh,
        bvh: &Built,
    ) {
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
        match self.config.mesh.step_exponent() {
            Some(step_exponent) => [step_exponent as u32, 1, 0, 0],
            None => [FINEST_STEP as u32, 0, 0, 0],
        }
    }

    /// A hierarchy over nothing.
    pub(super) fn record_empty(&mut self, gpu: &Gpu, recorder: &mut Recorder, bvh: &Built) {
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

    /// Stage `bounds`. Returns the Morton grid.
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
        let grid = self
            .scratch
            .grid
            .range(gpu, size_of::<slimbvh_core::morton::MortonGrid>() as u64);
        let cell_bits = match self.config.code_bits {
            CodeBits::Bits30 => 10,
            CodeBits::Bits63 => 21,
        };
        recorder.dispatch(
            Kernel::bounds_grid,
            &[Uniform::Params([cell_bits, 0, 0, 0])],
            &[blocks],
            &[
                &grid,
                &self.scratch.exponent.range(gpu, 16),
                &self.scratch.bounds.range(gpu, 24),
            ],
            groups(1),
        );
        grid
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
