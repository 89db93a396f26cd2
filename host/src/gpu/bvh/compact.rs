//! Compaction of a hierarchy's buffers to their contents.

use super::super::buffer::{Range, Slot};
use super::super::{Gpu, GpuError};
use super::{Bvh, paired};
use slimbvh_core::{LeafTriangle, Node};

impl Bvh {
    /// Moves the hierarchy into buffers of exactly its size. Waits for the GPU, which knows the size. Before, the buffers
    /// have room for the most that any mesh of as many triangles needs. Without the builder, whose memory is many times as
    /// large, the compact buffers are all that tracing needs. Afterwards a hierarchy in a codec cannot be refitted; any can
    /// be built again.
    ///
    /// # Errors
    /// If it is not built yet, or a set that did not fit, both copies do not fit into memory, or the device was lost.
    pub fn compact(&mut self, gpu: &Gpu) -> Result<(), GpuError> {
        let [node_bytes, triangle_bytes] = self.read_bytes(gpu)?;
        let mut built = self.built()?.clone();
        // No binding can be empty.
        let (node_bytes, triangle_bytes) = (
            node_bytes.max(size_of::<Node>() as u64),
            triangle_bytes.max(size_of::<LeafTriangle>() as u64),
        );
        let [nodes, triangles] = built.stored().map(Range::clone);
        gpu.checked(|| {
            let nodes = tight(gpu, &mut self.nodes, &nodes, [node_bytes, 0]);
            let padding = if built.has_full_triangles() {
                paired(triangle_bytes) - triangle_bytes
            } else {
                0
            };
            let sizes = [triangle_bytes, padding];
            let triangles = tight(gpu, &mut self.triangles, &triangles, sizes);
            // Plain nodes and triangles are in the builder's buffers.
            built.nodes = nodes.clone();
            built.triangles = triangles.clone();
            if let Some(coded) = &mut built.coded {
                coded.nodes = nodes;
                coded.triangles = triangles;
            }
            self.stamp = 0;
            if built.fallback.take().is_some() {
                // The tree begins its own lists.
                let behind_exponent = built.exponent.part(4, 8);
                let (buffer, offset) = (&behind_exponent.buffer, behind_exponent.offset);
                gpu.queue().write_buffer(buffer, offset, &[0; 8]);
            }
            self.place = None;
            self.built = Some(built);
            Ok(())
        })
    }
}

/// Moves the beginning of a slot's buffer into a buffer of exactly that size, with padding behind.
fn tight(gpu: &Gpu, slot: &mut Slot, from: &Range, [bytes, padding]: [u64; 2]) -> Range {
    let bytes = bytes.min(from.size);
    let to = slot.renewed(gpu, bytes + padding).part(0, bytes);
    let mut encoder = gpu.device().create_command_encoder(&Default::default());
    encoder.copy_buffer_to_buffer(&from.buffer, from.offset, &to.buffer, to.offset, bytes);
    gpu.queue().submit([encoder.finish()]);
    Range {
        traffic: from.traffic,
        ..to
    }
}
