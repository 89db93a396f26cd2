//! A tree in the lattice codec: integer planes, and optionally triangles, on a lattice whose step is a power of two.

use super::codec::{LatticeBits, MeshCodec, NodeCodec, by_bits};
use super::error::TreeError;
use super::lanes::Numbers;
use super::sources::{StoredNodes, StoredTriangles, is_in_scene, triangle_in};
use super::stored::{List, ListReader, Lists, Stacks, StoredTree};
use super::visitor::TreeVisitor;
use slimbvh_core::encode::{
    LatticeBounds, LatticeCursor, LatticeNodes, LatticeTriangles, LeafWidth, RootWords,
    decode_node, links_of,
};
use slimbvh_core::float::power_of_two;
use slimbvh_core::lattice::LatticeBox;
use slimbvh_core::trace::{LeafTriangles, PacketStacks};
use slimbvh_core::{Aabb, LeafTriangle, NodeRef, Vec3};

/// Nodes of the codec, the root's box, and triangles.
#[derive(Clone, Debug)]
pub struct LatticeTree {
    pub bits: LatticeBits,
    pub root: LatticeBox,
    /// The step is 2 to this power, at the scene's magnitude.
    pub step_exponent: i32,
    /// The nodes.
    pub words: Vec<u32>,
    pub triangles: LatticeMesh,
}

/// Triangles in leaves.
#[derive(Clone, Debug)]
pub enum LatticeMesh {
    /// In full.
    Full(Vec<LeafTriangle>),
    /// On the lattice, each in the number of words that its leaf needs.
    Lattice { words: Vec<u32>, count: usize },
}

impl LatticeMesh {
    /// The buffer of words; empty for triangles in full.
    pub fn into_words(self) -> Vec<u32> {
        match self {
            Self::Lattice { words, .. } => words,
            Self::Full(_) => Vec::new(),
        }
    }
}

/// Steps below are not normal floats.
const SMALLEST_STEP: i32 = -126;
const LARGEST_STEP: i32 = 127;

/// The largest number of steps for which floats hold all planes exactly, and extents between them have the right exponent.
const MOST_STEPS: u32 = (1 << 24) - 1;

impl LatticeTree {
    /// The buffers of a tree to be replaced, if it uses this codec.
    pub fn reuse(tree: StoredTree) -> Self {
        match tree {
            StoredTree::Lattice(tree) => tree,
            _ => Self {
                bits: LatticeBits::Q10,
                root: LatticeBox {
                    min: [0; 3],
                    max: [0; 3],
                },
                step_exponent: 0,
                words: Vec::new(),
                triangles: LatticeMesh::Full(Vec::new()),
            },
        }
    }

    /// Calls a visitor with the sources.
    #[inline(always)]
    pub fn visit<V: TreeVisitor>(&self, visitor: V) -> V::Output {
        by_bits!(self.bits, visit::<V>(self, visitor))
    }

    /// A tree with this root, its lists read by a reader.
    pub fn read<R: ListReader>(
        (bits, mesh): (LatticeBits, MeshCodec),
        root: &RootWords,
        triangle_count: usize,
        reader: &mut R,
    ) -> Result<Self, R::Error> {
        Ok(Self {
            bits,
            root: root.lattice(),
            step_exponent: root.step_exponent(),
            words: reader.nodes(bits.words())?,
            triangles: if mesh.step_exponent().is_some() {
                LatticeMesh::Lattice {
                    words: reader.triangles()?,
                    count: triangle_count,
                }
            } else {
                LatticeMesh::Full(reader.triangles()?)
            },
        })
    }
}

// Separate functions: one for all widths would be too large to optimise well.
#[inline(never)]
fn visit<const BITS: u32, const WORDS: usize, V: TreeVisitor>(
    tree: &LatticeTree,
    visitor: V,
) -> V::Output {
    let (root, step) = (tree.root, power_of_two(tree.step_exponent));
    let nodes: &[[u32; WORDS]] = bytemuck::cast_slice(&tree.words);
    match &tree.triangles {
        LatticeMesh::Full(triangles) => {
            let nodes = LatticeNodes::<BITS, WORDS, false> { nodes, root, step };
            visitor.visit(&nodes, &LeafTriangles(triangles))
        }
        LatticeMesh::Lattice { words, .. } => {
            let nodes = LatticeNodes::<BITS, WORDS, true> { nodes, root, step };
            visitor.visit(&nodes, &LatticeTriangles { words, step })
        }
    }
}

impl Lists for LatticeTree {
    fn codecs(&self, scene_exponent: i32) -> (NodeCodec, MeshCodec) {
        let mesh = match &self.triangles {
            LatticeMesh::Full(_) => MeshCodec::F32,
            LatticeMesh::Lattice { .. } => MeshCodec::Lattice {
                step_exponent: self.step_exponent.wrapping_sub(scene_exponent),
            },
        };
        (NodeCodec::Lattice(self.bits), mesh)
    }

    fn triangle_count(&self) -> usize {
        match &self.triangles {
            LatticeMesh::Full(triangles) => triangles.len(),
            LatticeMesh::Lattice { count, .. } => *count,
        }
    }

    fn lists(&self) -> [List<'_>; 2] {
        let triangles = match &self.triangles {
            LatticeMesh::Full(triangles) => List::of(triangles),
            LatticeMesh::Lattice { words, .. } => List::of(words),
        };
        let nodes = List {
            item_bytes: self.bits.words() * size_of::<u32>(),
            ..List::of(&self.words)
        };
        [nodes, triangles]
    }

    fn held_bytes(&self) -> usize {
        let triangles = match &self.triangles {
            LatticeMesh::Full(triangles) => triangles.capacity() * size_of::<LeafTriangle>(),
            LatticeMesh::Lattice { words, .. } => words.capacity() * size_of::<u32>(),
        };
        self.words.capacity() * size_of::<u32>() + triangles
    }

    fn root_words(&self) -> Option<RootWords> {
        Some(RootWords::of_lattice(&self.root, self.step_exponent))
    }

    fn check_root(&self) -> Result<(), TreeError> {
        let step_exponent = self.step_exponent;
        if !(SMALLEST_STEP..=LARGEST_STEP).contains(&step_exponent) {
            return Err(TreeError::Step { step_exponent });
        }
        let mut planes = self.root.min.iter().chain(&self.root.max);
        let is_counted = planes.all(|plane| plane.unsigned_abs() <= MOST_STEPS);
        if is_counted && is_in_scene(&aabb(&self.root, power_of_two(step_exponent))) {
            Ok(())
        } else {
            Err(TreeError::RootBox)
        }
    }

    fn full_triangles(&self) -> Option<&Vec<LeafTriangle>> {
        match &self.triangles {
            LatticeMesh::Full(triangles) => Some(triangles),
            LatticeMesh::Lattice { .. } => None,
        }
    }

    fn full_triangles_mut(&mut self) -> Option<&mut Vec<LeafTriangle>> {
        match &mut self.triangles {
            LatticeMesh::Full(triangles) => Some(triangles),
            LatticeMesh::Lattice { .. } => None,
        }
    }
}

fn aabb(bounds: &LatticeBox, step: f32) -> Aabb {
    let point = |v: [i32; 3]| Vec3::from_array(v.map(|x| x as f32 * step));
    Aabb {
        min: point(bounds.min),
        max: point(bounds.max),
    }
}

impl<const BITS: u32, const WORDS: usize, const MIXED: bool> StoredNodes
    for LatticeNodes<'_, BITS, WORDS, MIXED>
{
    type Box = LatticeBox;

    #[inline(always)]
    fn stacks(stacks: &mut Stacks) -> &mut PacketStacks<LatticeCursor, Numbers> {
        &mut stacks.lattice
    }

    fn count(&self) -> usize {
        self.nodes.len()
    }

    fn root_box(&self) -> LatticeBox {
        self.root
    }

    fn open(&self, node: u32, bounds: &LatticeBox) -> ([NodeRef; 2], [LatticeBox; 2]) {
        let words = &self.nodes[node as usize];
        let boxes = decode_node::<BITS, WORDS>(words, bounds);
        let stride = if MIXED {
            LeafWidth::of(&boxes[0]).words()
        } else {
            1
        };
        (links_of::<BITS, WORDS>(words).children(stride), boxes)
    }

    fn aabb(&self, bounds: &LatticeBox) -> Aabb {
        aabb(bounds, self.step)
    }
}

impl<const BITS: u32, const WORDS: usize> StoredTriangles<LatticeNodes<'_, BITS, WORDS, true>>
    for LatticeTriangles<'_>
{
    fn place_count(&self) -> usize {
        self.words.len()
    }

    fn stride(&self, bounds: &LatticeBox) -> u32 {
        LeafWidth::of(bounds).words()
    }

    fn triangle(&self, place: (u32, u32), bounds: &LatticeBox) -> LeafTriangle {
        triangle_in(
            self,
            place,
            LatticeBounds::new(bounds, self.step, [0, 1, 2]),
        )
    }
}
