//! Stage `encode`: nodes and triangles in codecs, in one dispatch; wide nodes at places that stage `wide` finds before, and then, on a
//! lattice, their triangles in another.

use super::buffer::{Range, Slot};
use super::bvh::{Built, Coded, full_triangles};
use super::coding::Encodes;
use super::program::{Groups, Recorder, Uniform, threads};
use super::wide::{Topology, Wide};
use super::{Gpu, Kernel};
use slimbvh_core::encode::LeafCorner;
use wgpu::BufferUsages;

/// Encodes hierarchies. Keeps its buffers and the plain nodes and triangles.
#[derive(Debug)]
pub struct Encoder {
    nodes: Slot,
    triangles: Slot,
    corners: Slot,
    begins: Slot,
    wide: Wide,
}

impl Encoder {
    /// An encoder with empty buffers.
    pub const fn new() -> Self {
        let copied = BufferUsages::STORAGE.union(BufferUsages::COPY_DST);
        Self {
            nodes: Slot::storage("slimbvh plain nodes"),
            triangles: Slot::new("slimbvh plain leaf triangles", copied),
            corners: Slot::storage("slimbvh leaf corners"),
            begins: Slot::storage("slimbvh begins of triangle words"),
            wide: Wide::new(),
        }
    }

    /// A range for plain nodes, before they are coded.
    pub fn plain_nodes(&mut self, gpu: &Gpu, bytes: u64) -> Range {
        self.nodes.range(gpu, bytes)
    }

    /// A range for plain triangles, before they are coded.
    pub fn plain_triangles(&mut self, gpu: &Gpu, bytes: u64) -> Range {
        full_triangles(gpu, &mut self.triangles, bytes)
    }

    /// Records the encoding of a plain hierarchy, whose topology is new or that of the latest encoding. `each_node` gives every
    /// node a thread; `step` is the lattice's step in the kernels' form.
    pub fn record(
        &mut self,
        gpu: &Gpu,
        recorder: &mut Recorder,
        (bvh, coded): (&Built, &Coded),
        step: [u32; 4],
        topology: Topology,
        each_node: &dyn Fn() -> Groups,
    ) {
        if coded.coding.is_wide() {
            return self.record_wide(gpu, recorder, (bvh, coded), step, topology, each_node);
        }
        recorder.stage("encode");
        let total = Uniform::Stored(&bvh.total);
        // Always 0, hidden from the compiler so that it cannot fuse the product.
        let zero = Uniform::Params([0; 4]);
        let (plain, leaves) = (&bvh.nodes, &bvh.triangles);
        let (nodes, root) = (&coded.nodes, &coded.root);
        match coded.coding.encodes() {
            Encodes::NodesInFloats(kernel) => {
                let to = &[nodes, root];
                recorder.dispatch(kernel, &[total, zero], &[plain], to, each_node());
            }
            Encodes::AllInFloats(kernel) => {
                let to = &[nodes, &coded.triangles, root];
                let from = &[plain, leaves];
                recorder.dispatch(kernel, &[total, zero], from, to, each_node());
            }
            Encodes::Wide(_) | Encodes::WideInFull(_) | Encodes::MixedWide { .. } => {}
        }
    }

    /// Records the encoding of wide nodes at their places.
    fn record_wide(
        &mut self,
        gpu: &Gpu,
        recorder: &mut Recorder,
        (bvh, coded): (&Built, &Coded),
        step: [u32; 4],
        topology: Topology,
        each_node: &dyn Fn() -> Groups,
    ) {
        let places = self
            .wide
            .record(gpu, recorder, (bvh, coded), step, topology, each_node);
        recorder.stage("encode");
        let total = Uniform::Stored(&bvh.total);
        let [collapses, origins, begins] = places.all();
        let from = &[&bvh.nodes, collapses, origins, begins];
        let (nodes, root) = (&coded.nodes, &coded.root);
        match coded.coding.encodes() {
            Encodes::WideInFull(kernel) => {
                recorder.clear(root);
                recorder.dispatch(kernel, &[total], from, &[nodes], each_node());
            }
            Encodes::Wide(kernel) => {
                recorder.dispatch(kernel, &[total], from, &[nodes, root], each_node());
            }
            Encodes::MixedWide { nodes: kernel, .. } => {
                let [frames, words] = &self.leaves(gpu, bvh);
                let uniforms = &[total, Uniform::Stored(&bvh.exponent), Uniform::Params(step)];
                let corners = places.corners.as_ref();
                let nodes_from: Vec<&Range> = from.iter().copied().chain(corners).collect();
                let to = &[nodes, frames, words];
                recorder.dispatch(kernel, uniforms, &nodes_from, to, each_node());
                let kernel = match corners {
                    Some(_) => Kernel::encode_shared_triangles,
                    None => Kernel::encode_triangles,
                };
                let from = [&bvh.triangles, frames, words].into_iter().chain(corners);
                recorder.dispatch(
                    kernel,
                    &[Uniform::Stored(&bvh.count), Uniform::Stored(root)],
                    &from.collect::<Vec<_>>(),
                    &[&coded.triangles],
                    threads(bvh.room),
                );
            }
            _ => {}
        }
    }

    /// Ranges for each triangle's corner, and for where its words begin.
    fn leaves(&mut self, gpu: &Gpu, bvh: &Built) -> [Range; 2] {
        const CORNER_BYTES: u64 = size_of::<LeafCorner>() as u64;
        let count = u64::from(bvh.room.max(1));
        [
            self.corners.range(gpu, CORNER_BYTES * count),
            self.begins.range(gpu, 4 * count),
        ]
    }

    pub fn bytes(&self) -> u64 {
        let slots = [&self.nodes, &self.triangles, &self.corners, &self.begins];
        let slots = slots.iter().map(|slot| slot.bytes()).sum::<u64>();
        slots + self.wide.bytes()
    }
}
