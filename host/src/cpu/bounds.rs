//! Stage `bounds` on the CPU.

use super::BLOCK;
use rayon::prelude::*;
use slimbvh_core::bounds::run_bounds;
use slimbvh_core::{Aabb, IndexedTriangles};

/// The box of all triangles.
pub fn scene_bounds(triangles: &IndexedTriangles) -> Aabb {
    let count = triangles.indices.len();
    (0..count.div_ceil(BLOCK))
        .into_par_iter()
        .map(|block| {
            let first = block * BLOCK;
            run_bounds(first as u32, BLOCK.min(count - first) as u32, triangles)
        })
        .reduce(|| Aabb::EMPTY, Aabb::union)
}
