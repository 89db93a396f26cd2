//! A hierarchy in the GPU's memory.

mod compact;
mod download;
mod lists;
mod upload;

use super::buffer::{Download, Range, Slot};
use super::coding::Coding;
use super::encode::Encoder;
use super::fit::{Fallback, Place, Recent};
use super::program::Uniform;
use super::sides::TargetRanges;
use super::{Frame, Gpu, GpuError, Misfit};
use crate::{BuildConfig, MeshCodec, NodeCodec};
pub use lists::Lists;
use slimbvh_core::encode::RootWords;
use slimbvh_core::fit::Fit;
use slimbvh_core::node::LEAF_SIZE;
use slimbvh_core::trace::TrianglePair;
use slimbvh_core::{LeafTriangle, Node};
use wgpu::BufferUsages;

/// Bytes of each small buffer: the root, the scene's exponent, the counts.
const STATE_BYTES: u64 = 16;

/// Bytes of a placeholder for a target, and for components and sides.
const PLACEHOLDER_BYTES: u64 = 32;

/// A bounding volume hierarchy in the GPU's memory. A [`super::Builder`] fills it, and can fill it again without
/// allocating; or [`Self::upload`] does.
///
/// Only the GPU knows the number of nodes, so the buffers have room for the most possible: 64 bytes a triangle in full, of
/// which about 17 are used, and 16 to 43 in a codec, of which 6 to 15 are used. Triangles on a lattice have room for 40
/// bytes each, 42 where they share corners, and use what their leaves need. [`Self::compact`] frees the rest. Sets of
/// [`crate::ViewSets`] have room for what recent frames needed ([`crate::reduce::SetMemory`]).
#[derive(Debug)]
pub struct Bvh {
    nodes: Slot,
    triangles: Slot,
    root: Slot,
    word_total: Slot,
    inner_total: Slot,
    placeholder: Slot,
    /// The stamp of the build, if the hierarchy is in a codec; else 0.
    pub(super) stamp: u64,
    exponent: Slot,
    bounds: Slot,
    total: Slot,
    count: Slot,
    pub(super) built: Option<Built>,
    /// Of a set with memory for less than all triangles.
    pub(super) place: Option<Place>,
    pub(super) fit: Slot,
    pub(super) recent: Recent,
}

/// The ranges of a built hierarchy, and what the host knows of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Built {
    /// Nodes in full, with room for the most possible. In a codec, the builder's buffer; after an upload in a codec, the
    /// coded nodes with no build's stamp, so that no builder refits them.
    pub nodes: Range,
    /// Triangles in full, in leaf order. In a codec, the builder's buffer; after an upload, as for the nodes.
    pub triangles: Range,
    /// How nodes and triangles are stored.
    pub codecs: (NodeCodec, MeshCodec),
    /// The coded lists, if a codec is used.
    pub coded: Option<Coded>,
    /// The scene's exponent.
    pub exponent: Range,
    /// The scene's box.
    pub bounds: Range,
    /// The node count, and the dispatch with a thread for each.
    pub total: Range,
    /// The triangle count, and the dispatch with a thread for each.
    pub count: Range,
    /// Zeros, bound where a kernel requires sides or a target and there are none.
    pub placeholder: Range,
    /// Triangles of the mesh.
    pub triangle_count: u32,
    /// Triangles that there is memory for.
    pub room: u32,
    /// For a set with memory for less than all triangles.
    pub fallback: Option<Box<Fallback>>,
    /// Whether the hierarchy leaves some of these out.
    pub is_reduced: bool,
    pub depth_bound: u32,
}

/// The coded lists of a hierarchy.
#[derive(Clone, Debug, PartialEq)]
pub struct Coded {
    pub coding: Coding,
    pub nodes: Range,
    /// In the codec, or in full.
    pub triangles: Range,
    /// [`RootWords`].
    pub root: Range,
    /// The number of words of all triangles, the first of four numbers, if triangles vary in size. Of wide nodes, with
    /// [`Self::inner_total`] added.
    pub word_total: Range,
    /// The number of wide nodes but for the root, the first of four numbers, if nodes are wide. The same range as
    /// [`Self::word_total`] where triangles are in full.
    pub inner_total: Range,
}

/// How much of a hierarchy there is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Counts {
    /// Stored nodes.
    pub nodes: u32,
    /// Triangles.
    pub triangles: u32,
    /// Words of triangles that vary in size.
    pub words: u32,
}

impl Built {
    /// The codecs; `None` if everything is in full.
    pub fn coding(&self) -> Option<Coding> {
        self.coded.as_ref().map(|coded| coded.coding)
    }

    /// The root's box for kernels of stage `trace`, if they read it.
    pub fn root(&self) -> Option<Uniform<'_>> {
        let coded = self.coded.as_ref()?;
        coded
            .coding
            .has_root()
            .then_some(Uniform::Stored(&coded.root))
    }

    /// The root's box, or zeros in full.
    pub fn root_or_zeros(&self) -> &Range {
        let coded = self.coded.as_ref();
        coded.map_or(&self.placeholder, |coded| &coded.root)
    }

    /// The ranges whose first words are what [`Self::counts`] takes.
    fn totals(&self) -> [&Range; 4] {
        let (words, inner) = match &self.coded {
            Some(coded) => (&coded.word_total, &coded.inner_total),
            None => (&self.placeholder, &self.placeholder),
        };
        [&self.total, &self.count, words, inner]
    }

    /// The counts that the first words of [`Self::totals`] mean.
    fn counts(&self, [nodes, triangles, words, inner]: [u32; 4]) -> Counts {
        match self.coding() {
            Some(coding) if coding.is_wide() => Counts {
                nodes: inner + 1,
                triangles,
                words: words.saturating_sub(inner),
            },
            _ => Counts {
                nodes,
                triangles,
                words,
            },
        }
    }

    /// Nodes and triangles as they are stored.
    pub fn stored(&self) -> [&Range; 2] {
        match &self.coded {
            None => [&self.nodes, &self.triangles],
            Some(coded) => [&coded.nodes, &coded.triangles],
        }
    }

    /// Whether the stored triangles are in full.
    pub fn has_full_triangles(&self) -> bool {
        let coding = self.coding();
        coding.is_none_or(Coding::has_full_triangles)
    }

    /// Nodes and triangles as kernels of stage `trace` bind them: triangles in full by pairs.
    pub fn traced(&self) -> [Range; 2] {
        let [nodes, triangles] = self.stored();
        let triangles = if self.has_full_triangles() {
            Range {
                size: paired(triangles.size),
                ..triangles.clone()
            }
        } else {
            triangles.clone()
        };
        [nodes.clone(), triangles]
    }
}

/// Bytes of triangles in full with the padding of their last pair.
const fn paired(triangle_bytes: u64) -> u64 {
    triangle_bytes.next_multiple_of(size_of::<TrianglePair>() as u64)
}

/// A range of a slot for triangles in full, padded to a whole pair behind it.
pub fn full_triangles(gpu: &Gpu, slot: &mut Slot, bytes: u64) -> Range {
    slot.range(gpu, paired(bytes)).part(0, bytes)
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
            inner_total: Slot::new("slimbvh wide node count", state),
            placeholder: Slot::new("slimbvh no sides", state),
            stamp: 0,
            exponent: Slot::new("slimbvh scene exponent", state),
            bounds: Slot::new("slimbvh scene bounds", state),
            total: Slot::new("slimbvh node count", state),
            count: Slot::new("slimbvh triangle count", state),
            built: None,
            place: None,
            fit: Slot::storage("slimbvh set fit"),
            recent: Recent::default(),
        }
    }
}

impl Bvh {
    /// A hierarchy with empty buffers.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Makes room for this many triangles, or for as many as its place has; in a codec, also for plain ones in the encoder. Refuses a
    /// codec without GPU kernels.
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
        let place = self.place.as_ref();
        let room = place.map_or(triangle_count, |place| place.limit);
        let lists = Lists { coding };
        let [node_bytes, list_bytes] = lists.bytes(lists.counts(room));
        let (nodes, list) = match place {
            Some(place) => (place.nodes().clone(), place.triangles().clone()),
            None => (
                self.nodes.range(gpu, node_bytes),
                self.triangles.range(gpu, list_bytes),
            ),
        };
        let triangle_bytes = triangle_bytes(room);
        let has_full_triangles = coding.is_none_or(Coding::has_full_triangles);
        let list = if has_full_triangles {
            list.part(0, triangle_bytes)
        } else {
            list
        };
        let coded = coding.map(|coding| self.coded(gpu, coding, [nodes.clone(), list.clone()]));
        let nodes = match coding {
            Some(_) => encoder.plain_nodes(gpu, self::node_bytes(room)),
            None => nodes,
        };
        let triangles = if has_full_triangles {
            list
        } else {
            encoder.plain_triangles(gpu, triangle_bytes)
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
            placeholder: self.placeholder.range(gpu, PLACEHOLDER_BYTES),
            triangle_count,
            room,
            fallback: None,
            is_reduced,
            depth_bound,
        };
        self.built = Some(built.clone());
        Ok(built)
    }

    /// The lists of a coding, with room for what is known of them.
    fn coded(&mut self, gpu: &Gpu, coding: Coding, [nodes, triangles]: [Range; 2]) -> Coded {
        let word_total = self.word_total.range(gpu, STATE_BYTES);
        Coded {
            coding,
            nodes: nodes.touching_nodes(coding.node_bytes()),
            triangles,
            root: self.root.range(gpu, size_of::<RootWords>() as u64),
            inner_total: if coding.is_wide() && coding.is_mixed() {
                self.inner_total.range(gpu, STATE_BYTES)
            } else {
                word_total.clone()
            },
            word_total,
        }
    }

    /// The buffers of nodes and triangles.
    pub(super) const fn list_buffers(&self) -> [Option<&wgpu::Buffer>; 2] {
        [self.nodes.buffer(), self.triangles.buffer()]
    }

    /// The latest count that is known of a set with memory for less than all triangles.
    pub(crate) fn latest_fit(&self) -> Option<&Fit> {
        self.place.as_ref().and(self.recent.latest())
    }

    /// Frees the lists of nodes and triangles, and what says where the tree is in them: who still binds the old ones finds the old tree.
    pub(super) fn free_lists(&mut self) {
        self.built = None;
        for slot in [
            &mut self.nodes,
            &mut self.triangles,
            &mut self.exponent,
            &mut self.root,
        ] {
            slot.free();
        }
    }

    /// Replaces the lists of nodes and triangles by new ones of so many bytes.
    pub(super) fn renew_lists(
        &mut self,
        gpu: &Gpu,
        [node_bytes, triangle_bytes]: [u64; 2],
    ) -> [Range; 2] {
        self.free_lists();
        [
            self.nodes.range(gpu, node_bytes),
            self.triangles.range(gpu, triangle_bytes),
        ]
    }

    /// The built hierarchy.
    pub(super) fn built(&self) -> Result<&Built, GpuError> {
        self.built
            .as_ref()
            .ok_or_else(|| Misfit::NotBuilt.of("the hierarchy"))
    }

    /// Copies the present triangle count, to be read when the frame is done.
    pub(crate) fn count_later(&self, frame: &mut Frame) -> Result<Download, GpuError> {
        let count = self.built()?.count.clone();
        frame.gpu().checked(|| Ok(frame.download(&count)))
    }

    /// The number of triangles in the mesh it was built over. A reduced hierarchy holds fewer.
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
            &self.inner_total,
            &self.placeholder,
            &self.exponent,
            &self.bounds,
            &self.total,
            &self.count,
            &self.fit,
        ];
        slots.iter().map(|slot| slot.bytes()).sum()
    }

    /// How nodes and triangles are stored: [`super::wgsl_for`] returns the text for them.
    ///
    /// # Errors
    /// If it is not built yet.
    pub fn codecs(&self) -> Result<(NodeCodec, MeshCodec), GpuError> {
        Ok(self.built()?.codecs)
    }

    /// [`super::Tree::bindings`] of all triangles.
    ///
    /// # Errors
    /// If it is not built yet, or is stored in a codec without such a text.
    pub fn bindings(&self) -> Result<Vec<wgpu::BindGroupEntry<'_>>, GpuError> {
        self.bindings_with(None)
    }

    /// The bindings with this rule.
    pub(super) fn bindings_with<'a>(
        &'a self,
        rule: Option<&'a TargetRanges>,
    ) -> Result<Vec<wgpu::BindGroupEntry<'a>>, GpuError> {
        let built = self.built()?;
        if built.coding().is_some_and(|coding| !coding.is_wide()) {
            return Err(Misfit::InCodec.of("the hierarchy"));
        }
        let fallback = built.fallback.as_deref();
        let [nodes, triangles] = match fallback {
            Some(fallback) => fallback.lists(),
            None => built.stored(),
        };
        let triangles = if built.has_full_triangles() {
            wgpu::BufferBinding {
                size: wgpu::BufferSize::new(paired(triangles.size)),
                ..triangles.binding()
            }
        } else {
            triangles.binding()
        };
        let mut ranges = vec![built.exponent.binding(), nodes.binding(), triangles];
        if let Some(coded) = built.coded.as_ref().filter(|coded| coded.coding.has_root()) {
            ranges.push(coded.root.binding());
        }
        let none = [&built.placeholder; 2];
        let rule = rule.or(fallback.map(|fallback| &fallback.rule));
        let rule = rule.map_or(none, |rule| [&rule.packed, &rule.target]);
        ranges.extend(rule.map(Range::binding));
        let entries = (0..)
            .zip(ranges)
            .map(|(binding, range)| wgpu::BindGroupEntry {
                binding,
                resource: wgpu::BindingResource::Buffer(range),
            });
        Ok(entries.collect())
    }
}

/// The largest number of nodes over this many triangles: each node has more than [`LEAF_SIZE`] below it.
pub fn most_nodes(triangle_count: u32) -> u64 {
    u64::from(triangle_count.saturating_sub(LEAF_SIZE).max(1))
}

/// Bytes of the largest number of plain nodes over this many triangles.
pub fn node_bytes(triangle_count: u32) -> u64 {
    most_nodes(triangle_count) * size_of::<Node>() as u64
}

/// Bytes of this many plain leaf triangles, at least one.
pub fn triangle_bytes(triangle_count: u32) -> u64 {
    u64::from(triangle_count.max(1)) * size_of::<LeafTriangle>() as u64
}
