//! What all trees on a lattice share: their triangles, and the root's box. The lattice's step is a power of two.

use super::codec::MeshCodec;
use super::error::TreeError;
use super::sources::is_in_scene;
use super::stored::{List, ListReader};
use slimbvh_core::float::power_of_two;
use slimbvh_core::lattice::LatticeBox;
use slimbvh_core::{Aabb, LeafTriangle, Vec3};

/// Triangles in leaves.
#[derive(Clone, Debug)]
pub enum LatticeMesh {
    /// In full.
    Full(Vec<LeafTriangle>),
    /// On the lattice, in the words that their leaves need.
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

    /// The triangles of a tree: these words, if it has them on the lattice; a buffer then keeps the list. Else the list itself.
    pub fn over(
        words: Option<Vec<u32>>,
        leaves: Vec<LeafTriangle>,
        kept: &mut Vec<LeafTriangle>,
    ) -> Self {
        let Some(words) = words else {
            return Self::Full(leaves);
        };
        let count = leaves.len();
        *kept = leaves;
        Self::Lattice { words, count }
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
