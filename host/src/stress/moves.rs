//! How far the printed codec moves vertices.

use crate::Bvh;
use crate::oracle::distance::length;
use thiserror::Error;

/// Why it cannot be told how far vertices moved.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum MoveError {
    /// They have other triangles in their leaves.
    #[error("trees are not the same")]
    OtherTree,
    /// The codec does not keep what it promises.
    #[error("a vertex moved by {distance:e}, beyond its bound {bound:e}")]
    BeyondBound {
        /// In the scene's magnitude.
        distance: f64,
        /// In the scene's magnitude.
        bound: f64,
    },
}

/// The farthest that any vertex moved, and the farthest that any might have, in the mesh's unit. `decoded` is the tree out of its
/// codec, `plain` the one that it was made from. A vertex may move half a cell of its leaf's grid along each axis.
///
/// # Errors
/// If one moved farther than that, or the trees are not of the same mesh.
pub fn moved(plain: &Bvh, decoded: &Bvh) -> Result<[f32; 2], MoveError> {
    let unit = 2f64.powi(-plain.scene_exponent());
    let mut most = [0.0f64; 2];
    for node in decoded.nodes() {
        for (leaf, bounds) in [(node.left, node.left_box()), (node.right, node.right_box())] {
            if !leaf.is_leaf() || leaf.count() == 0 {
                continue;
            }
            // Half a cell of 1023, and the roundings of both ends.
            let half = [0, 1, 2].map(|axis| {
                let (low, high) = (f64::from(bounds.min[axis]), f64::from(bounds.max[axis]));
                (high - low) / 2046.0 + low.abs().max(high.abs()) * 2f64.powi(-22)
            });
            let bound = length(half);
            let places = leaf.first() as usize..(leaf.first() + leaf.count()) as usize;
            for place in places {
                let (a, b) = (
                    plain.leaf_triangles()[place],
                    decoded.leaf_triangles()[place],
                );
                if a.primitive != b.primitive {
                    return Err(MoveError::OtherTree);
                }
                for (a, b) in a.vertices.chunks(3).zip(b.vertices.chunks(3)) {
                    let step = [0, 1, 2].map(|axis| f64::from(a[axis]) - f64::from(b[axis]));
                    let distance = length(step);
                    if distance > bound {
                        return Err(MoveError::BeyondBound { distance, bound });
                    }
                    most[0] = most[0].max(distance);
                }
            }
            most[1] = most[1].max(bound);
        }
    }
    Ok(most.map(|distance| (distance * unit) as f32))
}
