//! Stage `classify` on the CPU: the triangles of a set.

use super::compact::Selection;
use crate::{Mesh, Stages};
use slimbvh_core::bounds::scene_exponent;
use slimbvh_core::classify::{VisibleSet, word_of_set};
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::{Aabb, IndexedTriangles};

/// A bit for each triangle, set if it belongs to the set, and the number of set bits before each word. Triangles are read
/// in the mesh's order, which is sequential in memory.
pub fn classify(
    members: &mut Selection,
    triangles: &IndexedTriangles,
    scale: &PowerOfTwo,
    reach: &VisibleSet,
) {
    mark(members, triangles, scale, reach);
    members.scan();
}

/// The bits, and the number set in each word.
fn mark(
    members: &mut Selection,
    triangles: &IndexedTriangles,
    scale: &PowerOfTwo,
    reach: &VisibleSet,
) {
    let reach = reach.scaled(scale);
    let word = |word| word_of_set(word, triangles, scale, &reach);
    members.mark_words(triangles.indices.len().div_ceil(32), word);
}

/// Finds the triangles that rays from or to a target may hit. Keeps its buffers from one target to the next.
///
/// Builds divide the mesh themselves and need no list. This type serves callers who want the set without a hierarchy, or
/// the time of each step of the division.
#[derive(Debug, Default)]
pub struct Division {
    selection: Selection,
    primitives: Vec<u32>,
}

impl Division {
    /// Empty buffers and no set.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Finds the set of triangles that rays may hit, in the mesh's unit. The mesh must be [sound](Mesh::validate). Returns
    /// the times of `classify` (a bit for each triangle, and the number set in each word), `scan` (prefix sums of these
    /// counts) and `compact` (the list).
    pub fn divide(&mut self, mesh: &Mesh, reach: &VisibleSet) -> Stages {
        let bounds = mesh.bounds().unwrap_or(Aabb::EMPTY);
        let scale = PowerOfTwo::new(scene_exponent(&bounds));
        let triangles = mesh.triangles();
        let (selection, primitives) = (&mut self.selection, &mut self.primitives);
        let mut stages = Stages::default();
        stages.time("classify", || mark(selection, &triangles, &scale, reach));
        let count = stages.time("scan", || selection.scan());
        stages.time("compact", || {
            primitives.resize(count, 0);
            selection.for_each(primitives, &mut vec![(); count], |i, primitive, ()| {
                *primitive = i as u32;
            });
        });
        stages
    }

    /// The latest set, in the mesh's order.
    #[must_use]
    pub fn primitives(&self) -> &[u32] {
        &self.primitives
    }
}

#[cfg(all(test, feature = "scenes"))]
mod tests {
    use super::*;
    use crate::generate::icosphere;
    use crate::{BuildConfig, Builder, Bvh, CodeBits, Subset};
    use glam::Vec3;
    use slimbvh_core::classify::Sides;
    use slimbvh_core::frustum::Frustum;
    use slimbvh_core::orientation::Target;

    /// An eye's set of a ball is what lies above the horizon and a little more; a tree over the set holds the same
    /// triangles.
    #[test]
    fn the_set_of_a_ball_is_what_an_eye_may_see() {
        let mesh = icosphere(Vec3::new(5.0, 0.0, 0.0), 2.0, 4);
        let components = vec![0; mesh.indices.len()];
        let eye = Vec3::new(5.0, 10.0, 0.0);
        let target = Target::position(eye.to_array());
        let mut division = Division::new();
        for (side, is_seen) in [(1, true), (-1, false)] {
            let sides = [side];
            let sides = Sides {
                components: &components,
                sides: &sides,
            };
            let reach = VisibleSet {
                sides,
                target,
                frustum: Frustum::EVERYWHERE,
            };
            let stages = division.divide(&mesh, &reach);
            let names: Vec<&str> = stages.iter().map(|(stage, _)| stage).collect();
            assert_eq!(names, ["classify", "scan", "compact"]);
            let expected = (0..mesh.indices.len() as u32).filter(|&i| {
                let corners =
                    mesh.indices[i as usize].map(|v| Vec3::from(mesh.vertices[v as usize]));
                let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
                (normal.dot(eye - corners[0]) > 0.0) == is_seen
            });
            assert!(expected.eq(division.primitives().iter().copied()), "{side}");

            // The two ways to build over the set sort differently, with the same result.
            for code_bits in [CodeBits::Bits30, CodeBits::Bits63] {
                let mut builder = Builder::new(BuildConfig::from(code_bits));
                let (mut alone, mut shared) = (Bvh::default(), Bvh::default());
                let subset = Subset::Of(reach);
                builder.build_subset(&mesh, subset, &mut alone).unwrap();
                builder.sort(&mesh).unwrap();
                builder.build_sorted(&mesh, subset, &mut shared);
                assert_eq!(alone.leaf_triangles(), shared.leaf_triangles());
                assert_eq!(alone.nodes(), shared.nodes());
                assert_eq!(alone.mesh_triangle_count(), mesh.indices.len());
                let leaves = alone.leaf_triangles().iter().map(|leaf| leaf.primitive);
                let mut leaves: Vec<u32> = leaves.collect();
                leaves.sort_unstable();
                assert_eq!(leaves, division.primitives());
            }
        }
    }
}
