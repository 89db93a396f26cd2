//! Stage `refit` on the GPU: the pyramid, then all boxes.

use super::buffer::Range;
use super::build::pyramid_bytes;
use super::bvh::Built;
use super::coding::Coding;
use super::program::{Groups, Recorder, Uniform, threads};
use super::{Builder, Gpu, Kernel};
use slimbvh_core::refit::{PyramidBox, group_count};

impl Builder {
    /// Records both children's boxes of each node.
    pub(super) fn record_boxes(
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

    /// A range for the last triangle of each node's left child.
    pub(super) fn splits(&mut self, gpu: &Gpu, bvh: &Built) -> Range {
        let node_count = bvh.nodes.size / size_of::<slimbvh_core::Node>() as u64;
        let splits = self.scratch.splits.range(gpu, 4 * node_count);
        splits.touching_nodes(4)
    }
}
