//! Stage `encode`: nodes and triangles in codecs, in one dispatch, or in three, with a scan in between.

use super::buffer::{Range, Slot};
use super::bvh::{Built, Coded, full_triangles};
use super::coding::Encodes;
use super::program::{Groups, Recorder, Uniform, threads};
use super::scan::Scan;
use super::{Gpu, Kernel};
use slimbvh_core::encode::LeafCorner;
use wgpu::BufferUsages;

/// Encodes hierarchies. Keeps its buffers and the plain nodes and triangles.
#[derive(Debug)]
pub struct Encoder {
    nodes: Slot,
    triangles: Slot,
    corners: Slot,
    sizes: Slot,
    scan: Scan,
}

impl Encoder {
    /// An encoder with empty buffers.
    pub const fn new() -> Self {
        let copied = BufferUsages::STORAGE.union(BufferUsages::COPY_DST);
        Self {
            nodes: Slot::storage("slimbvh plain nodes"),
            triangles: Slot::new("slimbvh plain leaf triangles", copied),
            corners: Slot::storage("slimbvh leaf corners"),
            sizes: Slot::new("slimbvh triangle sizes", copied),
            scan: Scan::new(),
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

    /// Records the encoding of a plain hierarchy. `each_node` gives every node a thread; `step` is the lattice's step in
    /// the kernels' form.
    pub fn record(
        &mut self,
        gpu: &Gpu,
        recorder: &mut Recorder,
        bvh: &Built,
        coded: &Coded,
        step: [u32; 4],
        each_node: impl Fn() -> Groups,
    ) {
        recorder.stage("encode");
        let total = Uniform::Stored(&bvh.total);
        // Always 0, hidden from the compiler so that it cannot fuse the product.
        let zero = Uniform::Params([0; 4]);
        let (plain, leaves) = (&bvh.nodes, &bvh.triangles);
        let (nodes, root) = (&coded.nodes, &coded.root);
        let (sizes_kernel, links_kernel) = match coded.coding.encodes() {
            Encodes::Nodes(kernel) => {
                return recorder.dispatch(kernel, &[total], &[plain], &[nodes, root], each_node());
            }
            Encodes::NodesInFloats(kernel) => {
                let to = &[nodes, root];
                return recorder.dispatch(kernel, &[total, zero], &[plain], to, each_node());
            }
            Encodes::AllInFloats(kernel) => {
                let to = &[nodes, &coded.triangles, root];
                let from = &[plain, leaves];
                return recorder.dispatch(kernel, &[total, zero], from, to, each_node());
            }
            Encodes::Mixed { sizes, links } => (sizes, links),
        };

        // The leaf's box determines each triangle's size; a prefix sum of the sizes gives its place.
        const CORNER_BYTES: u64 = size_of::<LeafCorner>() as u64;
        let count = u64::from(bvh.triangle_count.max(1));
        let corners = &self.corners.range(gpu, CORNER_BYTES * count);
        let sizes = &self.sizes.range(gpu, 4 * count);
        // A reduced hierarchy fills fewer sizes than the scan sums.
        recorder.clear(sizes);
        recorder.dispatch(
            sizes_kernel,
            &[total, Uniform::Stored(&bvh.exponent), Uniform::Params(step)],
            &[plain],
            &[nodes, corners, sizes, root],
            each_node(),
        );
        self.scan.record(gpu, recorder, sizes, &coded.word_total);
        recorder.read(nodes);
        recorder.dispatch(
            Kernel::encode_triangles,
            &[Uniform::Stored(&bvh.count), Uniform::Stored(root)],
            &[leaves, corners, sizes],
            &[&coded.triangles],
            threads(bvh.triangle_count),
        );
        recorder.update(
            links_kernel,
            &[total],
            &[plain, sizes],
            &[nodes],
            each_node(),
        );
    }

    pub fn bytes(&self) -> u64 {
        let slots = [&self.nodes, &self.triangles, &self.corners, &self.sizes];
        let slots = slots.iter().map(|slot| slot.bytes()).sum::<u64>();
        slots + self.scan.bytes()
    }
}
