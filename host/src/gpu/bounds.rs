//! Stage `bounds` on the GPU.

use super::buffer::Range;
use super::program::{Recorder, Uniform, groups};
use super::{Builder, Gpu, Kernel, Mesh};
use crate::CodeBits;
use slimbvh_core::launch::BLOCK;

impl Builder {
    /// Records the box of all triangles. Returns the grid of the codes.
    pub(super) fn record_bounds(
        &mut self,
        gpu: &Gpu,
        recorder: &mut Recorder,
        mesh: &Mesh,
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
}
