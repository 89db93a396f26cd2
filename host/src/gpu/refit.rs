//! Stage `refit` on the GPU: the pyramid, then all boxes.

use super::buffer::Range;
use super::build::pyramid_bytes;
use super::bvh::Built;
use super::program::{Groups, Recorder, Uniform, groups};
use super::{Builder, Gpu, Kernel};
use slimbvh_core::launch::LANES;
use slimbvh_core::refit::{GROUP_LEVELS, Level, PyramidBox};

const BOX_BYTES: u64 = size_of::<PyramidBox>() as u64;

impl Builder {
    /// Records both children's boxes of each node.
    pub(super) fn record_boxes(
        &mut self,
        gpu: &Gpu,
        recorder: &mut Recorder,
        bvh: &Built,
        finds_splits: bool,
    ) {
        let splits = &self.splits(gpu, bvh);
        recorder.stage("refit");
        let node_groups = &self.scratch.node_groups.range(gpu, 12);
        recorder.copy(&bvh.total.part(4, 12), node_groups);
        let each_node = || Groups::Indirect(node_groups.clone());

        let pyramid = &self.record_pyramid(gpu, recorder, bvh);
        let total = Uniform::Stored(&bvh.total);
        if finds_splits {
            let kernel = Kernel::refit_splits;
            recorder.dispatch(kernel, &[total], &[&bvh.nodes], &[splits], each_node());
        }
        let from = &[&bvh.triangles, pyramid, splits];
        let kernel = Kernel::refit_nodes;
        recorder.update(kernel, &[total], from, &[&bvh.nodes], each_node());
    }

    /// Records the boxes of all levels of the pyramid, [`GROUP_LEVELS`] a dispatch.
    fn record_pyramid(&mut self, gpu: &Gpu, recorder: &mut Recorder, bvh: &Built) -> Range {
        let bytes = pyramid_bytes(bvh.room);
        let pyramid = self.scratch.pyramid.range(gpu, bytes);
        let entries = |count: u32| pyramid.touching(u64::from(count) * BOX_BYTES);
        let mut level = Level::lowest(bvh.room);
        let mut below = None;
        while level.count > 0 {
            let groups = groups(level.count.div_ceil(LANES as u32));
            let (begin, mut highest) = (level.begin, level);
            for _ in 0..GROUP_LEVELS {
                (highest, level) = (level, level.above());
            }
            let made = &entries(level.begin - begin);
            match below {
                None => {
                    let kernel = Kernel::refit_groups;
                    recorder.dispatch(kernel, &[], &[&bvh.triangles], &[made], groups);
                }
                Some(Level { begin, count }) => {
                    recorder.read(&entries(count));
                    let params = Uniform::Params([begin, count, 0, 0]);
                    recorder.dispatch(Kernel::refit_parents, &[params], &[], &[made], groups);
                }
            }
            below = Some(highest);
        }
        pyramid
    }

    /// A range for the last triangle of each node's left child.
    pub(super) fn splits(&mut self, gpu: &Gpu, bvh: &Built) -> Range {
        let node_count = bvh.nodes.size / size_of::<slimbvh_core::Node>() as u64;
        let splits = self.scratch.splits.range(gpu, 4 * node_count);
        splits.touching_nodes(4)
    }
}
