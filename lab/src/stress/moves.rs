//! Moves of vertices by codecs.

use crate::oracle::distance::length;
use serde::Serialize;
use slimbvh::Bvh;
use thiserror::Error;

/// Why the moves of vertices cannot be measured.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum MoveError {
    /// The leaves hold other triangles.
    #[error("the trees hold different triangles")]
    OtherTree,
    /// A vertex moved beyond the bound of its codec.
    #[error("a vertex moved by {distance:e}, beyond its bound {bound:e}")]
    BeyondBound {
        /// In the scene's magnitude.
        distance: f64,
        /// In the scene's magnitude.
        bound: f64,
    },
}

/// Distances that vertices moved, in the mesh's unit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Moves {
    /// The largest distance.
    pub most: f64,
    /// The root mean square over all vertices.
    pub rms: f64,
    /// The largest possible distance.
    pub bound: f64,
}

/// The moves of a mesh's vertices onto a lattice of this step. A vertex may move half a step along each axis.
#[must_use]
pub fn snapped(before: &[[f32; 3]], after: &[[f32; 3]], step_exponent: i32) -> Moves {
    let mut moves = Moves {
        bound: 0.75f64.sqrt() * 2f64.powi(step_exponent),
        ..Moves::default()
    };
    let mut squares = 0.0;
    for (a, b) in before.iter().zip(after) {
        let distance = length([0, 1, 2].map(|axis| f64::from(a[axis]) - f64::from(b[axis])));
        moves.most = moves.most.max(distance);
        squares += distance * distance;
    }
    moves.rms = (squares / before.len().max(1) as f64).sqrt();
    moves
}

/// The moves of triangle corners by the codec with leaves of 10 bits. `decoded` is the decoded tree, `plain` the tree before
/// encoding. A corner may move half a cell of its leaf's grid along each axis.
///
/// # Errors
/// If a corner moved farther than that, or if the trees are not of the same mesh.
pub fn moved(plain: &Bvh, decoded: &Bvh) -> Result<Moves, MoveError> {
    let unit = 2f64.powi(-plain.scene_exponent());
    let mut moves = Moves::default();
    let (mut squares, mut corner_count) = (0.0, 0u64);
    for node in decoded.nodes() {
        for (leaf, bounds) in [(node.left, node.left_box()), (node.right, node.right_box())] {
            if !leaf.is_leaf() || leaf.count() == 0 {
                continue;
            }
            // Half a cell of 1023, plus the roundings of both ends.
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
                    moves.most = moves.most.max(distance);
                    squares += distance * distance;
                    corner_count += 1;
                }
            }
            moves.bound = moves.bound.max(bound);
        }
    }
    Ok(Moves {
        most: moves.most * unit,
        rms: (squares / corner_count.max(1) as f64).sqrt() * unit,
        bound: moves.bound * unit,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use slimbvh::{BuildConfig, Builder, Mesh, MeshCodec, NodeCodec};

    #[test]
    fn of_two_vertices_that_moved_and_one_that_did_not() {
        let before = [[1.0, 2.0, 3.0], [0.0; 3], [5.0, 0.0, -1.0]];
        let after = [[1.0, 2.5, 3.0], [0.0; 3], [5.25, 0.5, -1.5]];
        let moves = snapped(&before, &after, 0);
        // The squared distances are 1/4, 0, and 1/16 + 1/4 + 1/4.
        assert_eq!((moves.most, moves.rms), (0.75, (0.8125f64 / 3.0).sqrt()));
        assert!((moves.bound - 0.866_025_4).abs() < 1e-7);
        let still = snapped(&before, &before, -3);
        assert_eq!((still.most, still.rms), (0.0, 0.0));
    }

    #[test]
    fn leaves_of_ten_bits_move_corners_within_their_bound() {
        let mesh = slimbvh::generate::icosphere([1.0, 2.0, 3.0].into(), 2.0, 2);
        let build = |nodes, mesh_codec, mesh: &Mesh| {
            let mut builder = Builder::new(BuildConfig {
                nodes,
                mesh: mesh_codec,
                ..BuildConfig::default()
            });
            builder.build(mesh).unwrap()
        };
        let plain = build(NodeCodec::F32, MeshCodec::F32, &mesh);
        let printed = build(NodeCodec::Paper10, MeshCodec::Leaf10, &mesh);
        let moves = moved(&plain, &printed.decoded()).unwrap();
        assert!(0.0 < moves.rms && moves.rms < moves.most && moves.most <= moves.bound);
        assert!(moves.bound < 0.01, "{moves:?}");
        assert_eq!(moved(&plain, &plain).unwrap().most, 0.0);
    }
}
