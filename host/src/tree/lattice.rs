//! A tree in the lattice codec: integer planes, and optionally triangles, on a lattice whose step is a power of two.

use super::codec::{LatticeBits, MeshCodec, NodeCodec, by_bits};
use super::error::TreeError;
use super::lanes::Numbers;
use super::sources::{LeafPlace, Opened, StoredNodes, StoredTriangles, is_in_scene, triangle_in};
use super::stored::{List, ListReader, Lists, Stacks, StoredTree};
use super::visitor::TreeVisitor;
use slimbvh_core::encode::{
    LatticeBounds, LatticeNodes, LatticeTriangles, LeafFrame, LeafWidth, RootWords, decode_node,
    links_of,
};
use slimbvh_core::float::power_of_two;
use slimbvh_core::lattice::LatticeBox;
use slimbvh_core::trace::{LeafSlot, LeafTriangles, PacketStacks};
use slimbvh_core::{Aabb, LeafTriangle, Vec3};

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

    /// The list that a reader reads.
    pub fn read<R: ListReader>(
        mesh: MeshCodec,
        count: usize,
        reader: &mut R,
    ) -> Result<Self, R::Error> {
        Ok(if mesh.step_exponent().is_some() {
            Self::Lattice {
                words: reader.triangles()?,
                count,
            }
        } else {
            Self::Full(reader.triangles()?)
        })
    }

    /// The codec, of a lattice whose step is 2 to this power in a scene with this exponent.
    pub const fn codec(&self, step_exponent: i32, scene_exponent: i32) -> MeshCodec {
        match self {
            Self::Full(_) => MeshCodec::F32,
            Self::Lattice { .. } => MeshCodec::Lattice {
                step_exponent: step_exponent.wrapping_sub(scene_exponent),
            },
        }
    }

    /// The number of triangles.
    pub const fn count(&self) -> usize {
        match self {
            Self::Full(triangles) => triangles.len(),
            Self::Lattice { count, .. } => *count,
        }
    }

    /// The triangles as a list.
    pub fn list(&self) -> List<'_> {
        match self {
            Self::Full(triangles) => List::of(triangles),
            Self::Lattice { words, .. } => List::of(words),
        }
    }

    /// Bytes of memory held.
    pub const fn held_bytes(&self) -> usize {
        match self {
            Self::Full(triangles) => triangles.capacity() * size_of::<LeafTriangle>(),
            Self::Lattice { words, .. } => words.capacity() * size_of::<u32>(),
        }
    }

    /// The words; none for triangles in full.
    pub fn words(&self) -> &[u32] {
        match self {
            Self::Lattice { words, .. } => words,
            Self::Full(_) => &[],
        }
    }

    /// The triangles in full; none on the lattice.
    pub fn full(&self) -> &[LeafTriangle] {
        self.as_full().map_or(&[], Vec::as_slice)
    }

    /// The triangles, if they are in full.
    pub const fn as_full(&self) -> Option<&Vec<LeafTriangle>> {
        match self {
            Self::Full(triangles) => Some(triangles),
            Self::Lattice { .. } => None,
        }
    }

    /// The triangles, if they are in full.
    pub const fn as_full_mut(&mut self) -> Option<&mut Vec<LeafTriangle>> {
        match self {
            Self::Full(triangles) => Some(triangles),
            Self::Lattice { .. } => None,
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
            triangles: LatticeMesh::read(mesh, triangle_count, reader)?,
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
        let mesh = self.triangles.codec(self.step_exponent, scene_exponent);
        (NodeCodec::Lattice(self.bits), mesh)
    }

    fn triangle_count(&self) -> usize {
        self.triangles.count()
    }

    fn lists(&self) -> [List<'_>; 2] {
        let nodes = List {
            item_bytes: self.bits.words() * size_of::<u32>(),
            ..List::of(&self.words)
        };
        [nodes, self.triangles.list()]
    }

    fn held_bytes(&self) -> usize {
        self.words.capacity() * size_of::<u32>() + self.triangles.held_bytes()
    }

    fn root_words(&self) -> Option<RootWords> {
        Some(RootWords::of_lattice(&self.root, self.step_exponent))
    }

    fn check_root(&self) -> Result<(), TreeError> {
        check_root(&self.root, self.step_exponent)
    }

    fn full_triangles(&self) -> Option<&Vec<LeafTriangle>> {
        self.triangles.as_full()
    }

    fn full_triangles_mut(&mut self) -> Option<&mut Vec<LeafTriangle>> {
        self.triangles.as_full_mut()
    }
}

/// Checks that boxes can be decoded below a root with this box, on a lattice whose step is 2 to this power.
///
/// # Errors
/// For a step that is no normal float, and a box outside the scene or too large to be counted in floats.
pub fn check_root(root: &LatticeBox, step_exponent: i32) -> Result<(), TreeError> {
    if !(SMALLEST_STEP..=LARGEST_STEP).contains(&step_exponent) {
        return Err(TreeError::Step { step_exponent });
    }
    let mut planes = root.min.iter().chain(&root.max);
    let is_counted = planes.all(|plane| plane.unsigned_abs() <= MOST_STEPS);
    if is_counted && is_in_scene(&aabb(root, power_of_two(step_exponent))) {
        Ok(())
    } else {
        Err(TreeError::RootBox)
    }
}

/// A box at the scene's magnitude.
pub fn aabb(bounds: &LatticeBox, step: f32) -> Aabb {
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
    fn stacks(stacks: &mut Stacks) -> &mut PacketStacks<Self::Node, Numbers> {
        &mut stacks.lattice
    }

    fn count(&self) -> usize {
        self.nodes.len()
    }

    fn root_box(&self) -> LatticeBox {
        self.root
    }

    fn open(&self, node: u32, bounds: &LatticeBox) -> Opened<LatticeBox> {
        let words = &self.nodes[node as usize];
        let boxes = decode_node::<BITS, WORDS>(words, bounds);
        let stride = if MIXED {
            LeafWidth::of(&boxes[0]).words()
        } else {
            1
        };
        Opened::pair(links_of::<BITS, WORDS>(words).children(stride), boxes)
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

    fn places(&self, count: u32, bounds: &LatticeBox) -> u32 {
        count * LeafWidth::of(bounds).words()
    }

    fn place(&self, at: LeafPlace, bounds: &LatticeBox) -> u32 {
        at.leaf.first() + at.number * LeafWidth::of(bounds).words()
    }

    fn bytes(&self, slot: &LeafSlot<LeafFrame>) -> usize {
        size_of::<u32>() * slot.bounds.width.words() as usize
    }

    fn triangle(&self, at: LeafPlace, bounds: &LatticeBox) -> LeafTriangle {
        triangle_in(
            self,
            at,
            LeafFrame::of(&LatticeBounds::new(bounds, self.step, [0, 1, 2]), self.step),
        )
    }
}
