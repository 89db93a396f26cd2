//! Stage `snap` on the GPU.

use super::buffer::Range;
use super::bvh::Built;
use super::program::{Groups, Recorder, Uniform, threads};
use super::{Builder, Gpu, Kernel, Mesh};

impl Builder {
    /// Records triangles in leaf order, the first `bvh.count` items. Returns their codes.
    pub(super) fn record_snap(
        &mut self,
        gpu: &Gpu,
        recorder: &mut Recorder,
        mesh: &Mesh,
        bvh: &Built,
        items: &Range,
    ) -> Range {
        let item_groups = self.scratch.item_groups.range(gpu, 12);
        recorder.copy(&bvh.count.part(4, 12), &item_groups);
        let each_item = || Groups::Indirect(item_groups.clone());
        let code_bytes = self.keys().item_bytes() - 4;
        let codes = self
            .scratch
            .codes
            .range(gpu, u64::from(bvh.room) * code_bytes);
        recorder.dispatch(
            self.of_bits(Kernel::snap_30, Kernel::snap_63),
            &[Uniform::Stored(&bvh.exponent)],
            &[&mesh.vertices, &mesh.indices, items],
            &[&bvh.triangles, &codes],
            each_item(),
        );
        codes
    }

    /// Records an update of triangles, already in leaf order, to the present vertices.
    pub(super) fn record_snap_again(
        &mut self,
        gpu: &Gpu,
        recorder: &mut Recorder,
        mesh: &Mesh,
        bvh: &Built,
    ) {
        recorder.stage("snap");
        self.copy_state(gpu, recorder, bvh);
        recorder.update(
            Kernel::snap_again,
            &[Uniform::Stored(&bvh.exponent)],
            &[&mesh.vertices, &mesh.indices],
            &[&bvh.triangles],
            threads(mesh.triangle_count),
        );
    }
}
