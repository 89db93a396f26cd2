//! A hierarchy in buffers.

mod compact;
mod download;
mod upload;

use super::buffer::{Download, Range, Slot};
use super::coding::Coding;
use super::encode::Encoder;
use super::{Frame, Gpu, GpuError, Misfit};
use crate::{BuildConfig, MeshCodec, NodeCodec};
use slimbvh_core::encode::RootWords;
use slimbvh_core::node::LEAF_SIZE;
use slimbvh_core::{LeafTriangle, Node};
use wgpu::BufferUsages;

/// Bytes of the root, of the scene's exponent, and of the counts, as kernels want them.
const STATE_BYTES: u64 = 16;

/// Bytes of a target, and of as many components and sides.
const NOTHING_BYTES: u64 = 32;

/// A bounding volume hierarchy in the GPU's memory. Filled by a [`super::Builder`], which can fill it again without
/// allocating, or by [`Self::upload`].
///
/// How many nodes a build makes is known on the GPU only, so there is room for as many as there could be: 64 bytes a
/// triangle in full, of which about 24 are used, and 16 to 28 in a codec, of which 6 to 11 are. Triangles on a lattice have room
/// for 40 bytes each, and use as many as their leaves need. [`Self::compact`] gives back what is not used.
#[derive(Debug)]
pub struct Bvh {
    nodes: Slot,
    triangles: Slot,
    root: Slot,
    word_total: Slot,
    nothing: Slot,
    /// Which build it is of, where it is in a codec: 0 for none.
    pub(super) stamp: u64,
    exponent: Slot,
    bounds: Slot,
    total: Slot,
    count: Slot,
    pub(super) built: Option<Built>,
}

/// The ranges of a hierarchy that was built, and what is known of it here.
#[derive(Clone, Debug, PartialEq)]
pub struct Built {
    /// In full, as many as there could be: the builder's, where the hierarchy is in a codec. Of one in a codec that was uploaded
    /// nothing is in full: these are what is in the codec, and no build's, so that nobody refits it.
    pub nodes: Range,
    /// In full, in leaf order: the builder's, where the hierarchy has them in a codec. As the nodes, where it was uploaded.
    pub triangles: Range,
    /// How nodes and triangles are stored.
    pub codecs: (NodeCodec, MeshCodec),
    /// What is in a codec.
    pub coded: Option<Coded>,
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

/// What is stored in a codec.
#[derive(Clone, Debug, PartialEq)]
pub struct Coded {
    pub coding: Coding,
    pub nodes: Range,
    /// In the codec, or in full.
    pub triangles: Range,
    /// [`RootWords`].
    pub root: Range,
    /// How many words the triangles take, first of four numbers, where they are as long as their leaves need.
    pub word_total: Range,
    /// Zeros, for kernels that ask for sides or a target where there is none.
    pub nothing: Range,
}

impl Built {
    /// How it is stored, if not in full.
    pub fn coding(&self) -> Option<Coding> {
        self.coded.as_ref().map(|coded| coded.coding)
    }

    /// Nodes and triangles as they are stored.
    pub fn stored(&self) -> [&Range; 2] {
        match &self.coded {
            None => [&self.nodes, &self.triangles],
            Some(coded) => [&coded.nodes, &coded.triangles],
        }
    }
}

impl Default for Bvh {
    fn default() -> Self {
        let copied_to = BufferUsages::STORAGE.union(BufferUsages::COPY_DST);
        let state = copied_to.union(BufferUsages::UNIFORM);
        Self {
            nodes: Slot::new("slimbvh nodes", copied_to),
            triangles: Slot::new("slimbvh leaf triangles", copied_to),
            root: Slot::new("slimbvh root", state),
            word_total: Slot::new("slimbvh triangle word count", state),
            nothing: Slot::new("slimbvh no sides", state),
            stamp: 0,
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

    /// Makes room for so many triangles; for plain ones with the encoder, where they are to be coded. Refuses a codec that only the CPU
    /// has.
    pub(super) fn reserve(
        &mut self,
        gpu: &Gpu,
        triangle_count: u32,
        depth_bound: u32,
        is_reduced: bool,
        (config, encoder): (&BuildConfig, &mut Encoder),
    ) -> Result<Built, GpuError> {
        let coding = Coding::of(config)?;
        self.built = None;
        self.stamp = 0;
        let (node_bytes, triangle_bytes) =
            (node_bytes(triangle_count), triangle_bytes(triangle_count));
        let coded = coding.map(|coding| {
            let bytes = coding.node_bytes() * most_nodes(triangle_count);
            let nodes = self.nodes.range(gpu, bytes);
            let each = coding.most_triangle_bytes();
            let bytes = each.map(|each| each * u64::from(triangle_count.max(1)));
            Coded {
                coding,
                nodes: nodes.touching_nodes(coding.node_bytes()),
                triangles: self.triangles.range(gpu, bytes.unwrap_or(triangle_bytes)),
                root: self.root.range(gpu, size_of::<RootWords>() as u64),
                word_total: self.word_total.range(gpu, STATE_BYTES),
                nothing: self.nothing.range(gpu, NOTHING_BYTES),
            }
        });
        let nodes = match coding {
            Some(_) => encoder.plain_nodes(gpu, node_bytes),
            None => self.nodes.range(gpu, node_bytes),
        };
        let triangles = match coding.and_then(Coding::most_triangle_bytes) {
            Some(_) => encoder.plain_triangles(gpu, triangle_bytes),
            None => self.triangles.range(gpu, triangle_bytes),
        };
        let built = Built {
            nodes: nodes.touching_nodes(size_of::<Node>() as u64),
            triangles,
            codecs: (config.nodes, config.mesh),
            coded,
            exponent: self.exponent.range(gpu, STATE_BYTES),
            bounds: self.bounds.range(gpu, 24),
            total: self.total.range(gpu, STATE_BYTES),
            count: self.count.range(gpu, STATE_BYTES),
            triangle_count,
            is_reduced,
            depth_bound,
        };
        self.built = Some(built.clone());
        Ok(built)
    }

    /// What was built.
    pub(super) fn built(&self) -> Result<&Built, GpuError> {
        self.built
            .as_ref()
            .ok_or_else(|| Misfit::NotBuilt.of("the hierarchy"))
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
            &self.root,
            &self.word_total,
            &self.nothing,
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
    /// If it has not been built yet, or is stored in a codec.
    pub fn bindings(&self) -> Result<[wgpu::BindGroupEntry<'_>; 3], GpuError> {
        let built = self.built()?;
        if built.coded.is_some() {
            return Err(Misfit::InCodec.of("the hierarchy"));
        }
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
}

/// As many nodes as there could be over so many triangles: nodes hold more than [`LEAF_SIZE`].
fn most_nodes(triangle_count: u32) -> u64 {
    u64::from(triangle_count.saturating_sub(LEAF_SIZE).max(1))
}

/// Bytes of as many plain nodes as there could be over so many triangles.
pub fn node_bytes(triangle_count: u32) -> u64 {
    most_nodes(triangle_count) * size_of::<Node>() as u64
}

/// Bytes of so many plain leaf triangles, at least one.
pub fn triangle_bytes(triangle_count: u32) -> u64 {
    u64::from(triangle_count.max(1)) * size_of::<LeafTriangle>() as u64
}
