//! A hierarchy in buffers.

use super::buffer::{Download, Range, Slot};
use super::{Frame, Gpu, GpuError};
use slimbvh_core::aabb::Aabb;
use slimbvh_core::node::LEAF_SIZE;
use slimbvh_core::{LeafTriangle, Node};
use wgpu::BufferUsages;

/// Bytes of the root, of the scene's exponent, and of the counts, as kernels want them.
const STATE_BYTES: u64 = 16;

/// A bounding volume hierarchy in the GPU's memory. Filled by a [`super::Builder`], which can fill it again without
/// allocating.
///
/// How many nodes there are is known on the GPU only, so there is room for as many as there could be: 64 bytes a
/// triangle. About 24 of these are used.
#[derive(Debug)]
pub struct Bvh {
    nodes: Slot,
    triangles: Slot,
    exponent: Slot,
    bounds: Slot,
    total: Slot,
    count: Slot,
    pub(super) built: Option<Built>,
}

/// The ranges of a hierarchy that was built, and what is known of it here.
#[derive(Clone, Debug, PartialEq)]
pub struct Built {
    /// As many as there could be.
    pub nodes: Range,
    /// In leaf order.
    pub triangles: Range,
    /// The scene's exponent.
    pub exponent: Range,
    /// The scene's box.
    pub bounds: Range,
    /// How many nodes there are, and the dispatch of a thread for each.
    pub total: Range,
    /// How many triangles there are in it, and the dispatch of a thread for each.
    pub count: Range,
    /// Triangles of the mesh.
    pub triangle_count: u32,
    /// Whether some of these are left out.
    pub is_reduced: bool,
    pub depth_bound: u32,
}

impl Default for Bvh {
    fn default() -> Self {
        let state = BufferUsages::STORAGE
            .union(BufferUsages::UNIFORM)
            .union(BufferUsages::COPY_DST);
        Self {
            nodes: Slot::storage("slimbvh nodes"),
            triangles: Slot::new(
                "slimbvh leaf triangles",
                BufferUsages::STORAGE.union(BufferUsages::COPY_DST),
            ),
            exponent: Slot::new("slimbvh scene exponent", state),
            bounds: Slot::new("slimbvh scene bounds", state),
            total: Slot::new("slimbvh node count", state),
            count: Slot::new("slimbvh triangle count", state),
            built: None,
        }
    }
}

impl Bvh {
    /// A hierarchy without buffers yet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Makes room for so many triangles.
    pub(super) fn reserve(
        &mut self,
        gpu: &Gpu,
        triangle_count: u32,
        depth_bound: u32,
        is_reduced: bool,
    ) -> Built {
        self.built = None;
        let nodes = self.nodes.range(gpu, node_bytes(triangle_count));
        let built = Built {
            nodes: nodes.touching_nodes(size_of::<Node>() as u64),
            triangles: self.triangles.range(gpu, triangle_bytes(triangle_count)),
            exponent: self.exponent.range(gpu, STATE_BYTES),
            bounds: self.bounds.range(gpu, 24),
            total: self.total.range(gpu, STATE_BYTES),
            count: self.count.range(gpu, STATE_BYTES),
            triangle_count,
            is_reduced,
            depth_bound,
        };
        self.built = Some(built.clone());
        built
    }

    /// What was built.
    pub(super) fn built(&self) -> Result<&Built, GpuError> {
        self.built.as_ref().ok_or_else(|| GpuError::Unfit {
            what: "the hierarchy",
            fault: "is empty; build it first".into(),
        })
    }

    /// Copies how many triangles it has now, for the caller to read when the frame is done.
    pub(crate) fn count_later(&self, frame: &mut Frame) -> Result<Download, GpuError> {
        let count = self.built()?.count.clone();
        frame.gpu().checked(|| Ok(frame.download(&count)))
    }

    /// How many triangles the mesh has that it was built over. A reduced hierarchy leaves out some.
    #[must_use]
    pub fn mesh_triangle_count(&self) -> u32 {
        self.built.as_ref().map_or(0, |built| built.triangle_count)
    }

    /// Bytes of the buffers.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        let slots = [
            &self.nodes,
            &self.triangles,
            &self.exponent,
            &self.bounds,
            &self.total,
            &self.count,
        ];
        slots.iter().map(|slot| slot.bytes()).sum()
    }

    /// The bindings that the functions of [`super::wgsl`] want, 0 to 2: the scene's exponent, the nodes, the triangles.
    ///
    /// # Errors
    /// If it has not been built yet.
    pub fn bindings(&self) -> Result<[wgpu::BindGroupEntry<'_>; 3], GpuError> {
        let built = self.built()?;
        let mut binding = 0;
        Ok(
            [&built.exponent, &built.nodes, &built.triangles].map(|range| {
                let entry = wgpu::BindGroupEntry {
                    binding,
                    resource: wgpu::BindingResource::Buffer(range.binding()),
                };
                binding += 1;
                entry
            }),
        )
    }

    /// Reads how many inner nodes and triangles there are, and waits for it.
    ///
    /// # Errors
    /// If it has not been built yet, or the device was lost.
    pub fn read_counts(&self, gpu: &Gpu) -> Result<[u32; 2], GpuError> {
        let built = self.built()?;
        let mut frame = gpu.frame();
        let ranges = [&built.total, &built.count];
        let downloads = gpu.checked(|| Ok(ranges.map(|range| frame.download(range))))?;
        frame.submit()?.wait()?;
        let mut counts = [0; 2];
        for (count, download) in counts.iter_mut().zip(downloads) {
            let words: Vec<u32> = download.read(gpu)?;
            *count = words.first().copied().unwrap_or(0);
        }
        Ok(counts)
    }

    /// Copies the hierarchy from the GPU, and waits for it.
    ///
    /// # Errors
    /// If it has not been built yet, or the device was lost.
    pub fn download(&self, gpu: &Gpu) -> Result<crate::Bvh, GpuError> {
        let built = self.built()?;
        let mut frame: Frame = gpu.frame();
        let ranges = [
            &built.total,
            &built.count,
            &built.exponent,
            &built.bounds,
            &built.nodes,
            &built.triangles,
        ];
        let [total, count, exponent, bounds, nodes, triangles] =
            gpu.checked(|| Ok(ranges.map(|range| frame.download(range))))?;
        frame.submit()?.wait()?;
        let total: Vec<u32> = total.read(gpu)?;
        let count: Vec<u32> = count.read(gpu)?;
        let exponent: Vec<i32> = exponent.read(gpu)?;
        let corners: Vec<[f32; 3]> = bounds.read(gpu)?;
        let mut nodes: Vec<Node> = nodes.read(gpu)?;
        let mut triangles: Vec<LeafTriangle> = triangles.read(gpu)?;
        nodes.truncate(total.first().map_or(0, |&count| count as usize));
        triangles.truncate(count.first().map_or(0, |&count| count as usize));
        let mut bvh = crate::Bvh {
            nodes,
            mesh_triangle_count: built.triangle_count as usize,
            triangles,
            depth_bound: built.depth_bound,
            ..crate::Bvh::default()
        };
        let corner = |i: usize| corners.get(i).copied().unwrap_or_default().into();
        bvh.set_bounds(Aabb {
            min: corner(0),
            max: corner(1),
        });
        bvh.scene_exponent = exponent.first().copied().unwrap_or(0);
        Ok(bvh)
    }
}

/// Bytes of as many nodes as there could be over so many triangles: nodes hold more than [`LEAF_SIZE`].
pub fn node_bytes(triangle_count: u32) -> u64 {
    let most = triangle_count.saturating_sub(LEAF_SIZE).max(1);
    u64::from(most) * size_of::<Node>() as u64
}

/// Bytes of so many leaf triangles, at least one.
pub fn triangle_bytes(triangle_count: u32) -> u64 {
    u64::from(triangle_count.max(1)) * size_of::<LeafTriangle>() as u64
}
