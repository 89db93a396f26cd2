//! Checks the triangles' order along the curve, and the division of nodes by it.

use super::Fault;
use slimbvh::{CodeBits, Mesh};
use slimbvh_core::bounds::{run_bounds, scene_exponent};
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::morton::{MortonGrid, morton_code_30, morton_code_63};
use slimbvh_core::node::LEAF_SIZE;
use slimbvh_core::snap::leaf_triangle;
use slimbvh_core::{Aabb, IndexedTriangles, LeafTriangle, Node};

/// Checks that the leaves hold each of the mesh's triangles once, at the scene's magnitude, sorted by Morton code and, among
/// equal codes, by index; and that each node is divided at the first differing bit of its codes (of its places, if all codes
/// are equal).
///
/// # Errors
/// The first fault found.
pub fn validate_order(
    nodes: &[Node],
    triangles: &[LeafTriangle],
    mesh: &Mesh,
    code_bits: CodeBits,
) -> Result<(), Fault> {
    let indexed = IndexedTriangles {
        vertices: &mesh.vertices,
        indices: &mesh.indices,
    };
    let count = mesh.indices.len() as u32;
    let bounds = run_bounds(0, count, &indexed);

    // Every primitive occurs once, with its own corners.
    let scale = PowerOfTwo::new(scene_exponent(&bounds));
    let mut is_there = vec![false; count as usize];
    for (leaf, place) in triangles.iter().zip(0..) {
        let primitive = leaf.primitive;
        match is_there.get_mut(primitive as usize) {
            Some(there) if !*there => *there = true,
            _ => return Err(Fault::NotAPermutation { place, primitive }),
        }
        let exact = leaf_triangle(primitive, &indexed, &scale);
        if bytemuck::bytes_of(leaf) != bytemuck::bytes_of(&exact) {
            return Err(Fault::WrongCorners { place });
        }
    }
    if triangles.len() < count as usize {
        let place = triangles.len() as u32;
        let primitive = is_there.iter().position(|there| !there).unwrap_or(0) as u32;
        return Err(Fault::NotAPermutation { place, primitive });
    }

    let grid = match code_bits {
        CodeBits::Bits30 => MortonGrid::new(&bounds, 10),
        CodeBits::Bits63 => MortonGrid::new(&bounds, 21),
    };
    let bounds_of = |leaf: &LeafTriangle| indexed.triangle(leaf.primitive).bounds();
    let codes: Vec<u64> = triangles
        .iter()
        .map(|leaf| code(&bounds_of(leaf), &grid, code_bits))
        .collect();
    for place in 1..codes.len() {
        let before = (codes[place - 1], triangles[place - 1].primitive);
        if before >= (codes[place], triangles[place].primitive) {
            let place = place as u32;
            return Err(Fault::OutOfOrder { place });
        }
    }
    if count > LEAF_SIZE {
        for (node, index) in nodes.iter().zip(0..) {
            validate_split(node, index, nodes, &codes)?;
        }
    }
    Ok(())
}

fn code(bounds: &Aabb, grid: &MortonGrid, code_bits: CodeBits) -> u64 {
    match code_bits {
        CodeBits::Bits30 => morton_code_30(bounds, grid).into(),
        CodeBits::Bits63 => {
            let [high, low] = morton_code_63(bounds, grid);
            u64::from(high) << 32 | u64::from(low)
        }
    }
}

/// The naive split: the last place whose key has a 0 at the highest bit in which the run's ends differ.
fn validate_split(node: &Node, index: u32, nodes: &[Node], codes: &[u64]) -> Result<(), Fault> {
    let key = |place: u32| (codes[place as usize], place);
    let (low, high) = (key(node.first), key(node.last));
    let bit = |place: u32| {
        if low.0 == high.0 {
            place >> (31 - (low.1 ^ high.1).leading_zeros()) & 1
        } else {
            (codes[place as usize] >> (63 - (low.0 ^ high.0).leading_zeros()) & 1) as u32
        }
    };
    let expected = (node.first..=node.last)
        .take_while(|&place| bit(place) == 0)
        .last();
    let split = if node.left.is_leaf() {
        Some((node.left.first() + node.left.count()).wrapping_sub(1))
    } else {
        nodes.get(node.left.index() as usize).map(|left| left.last)
    };
    if split == expected {
        Ok(())
    } else {
        Err(Fault::WrongSplit { node: index })
    }
}
