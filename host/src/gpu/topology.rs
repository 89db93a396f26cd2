//! Stage `topology` on the GPU.

use super::buffer::Range;
use super::bvh::Built;
use super::program::{Recorder, Uniform, threads};
use super::{Builder, Gpu, Kernel};

impl Builder {
    /// Records the nodes over the first `bvh.count` sorted codes.
    pub(super) fn record_topology(
        &mut self,
        gpu: &Gpu,
        recorder: &mut Recorder,
        bvh: &Built,
        codes: &Range,
    ) {
        recorder.stage("topology");
        let count = bvh.room;
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
            threads(count),
        );
        self.scratch.scan.record(gpu, recorder, before, &bvh.total);
        recorder.dispatch(
            self.of_bits(Kernel::topology_nodes_30, Kernel::topology_nodes_63),
            &[total],
            &[codes, kept, before],
            &[&bvh.nodes, splits],
            // An empty tree has a node, too.
            threads(count),
        );
    }
}
