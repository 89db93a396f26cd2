//! Stage `morton` on the GPU.

use super::buffer::Range;
use super::program::{Recorder, threads};
use super::{Builder, Gpu, Kernel, Mesh};

impl Builder {
    /// Records a code in the grid for each triangle. Returns the items to be sorted.
    pub(super) fn record_morton(
        &mut self,
        gpu: &Gpu,
        recorder: &mut Recorder,
        mesh: &Mesh,
        grid: &Range,
    ) -> Range {
        recorder.stage("morton");
        let items = self.items(gpu, mesh);
        recorder.dispatch(
            self.of_bits(Kernel::morton_30, Kernel::morton_63),
            &[],
            &[grid, &mesh.vertices, &mesh.indices],
            &[&items],
            threads(mesh.triangle_count),
        );
        items
    }
}
