//! Stage `bounds` on the CPU.

use super::BLOCK;
use crate::Mesh;
use crate::parallel::prelude::*;
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
        .reduce_with(Aabb::union)
        .unwrap_or(Aabb::EMPTY)
}

impl Mesh {
    /// The box around all triangles; `None` for a mesh without triangles. The mesh must be sound.
    #[must_use]
    pub fn bounds(&self) -> Option<Aabb> {
        let bounds = scene_bounds(&self.triangles());
        (!bounds.is_empty()).then_some(bounds)
    }
}
