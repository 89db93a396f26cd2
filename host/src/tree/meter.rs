//! What one ray reads of a stored tree.

use super::packets::filter_of;
use super::sources::{LeafOrder, StoredNodes, StoredTriangles};
use super::visitor::{Shared, TreeVisitor};
use slimbvh_core::RayEnds;
use slimbvh_core::classify::Sides;
use slimbvh_core::orientation::Target;
use slimbvh_core::ray::PreparedRay;
use slimbvh_core::trace::{
    Collector, EndsAnd, EndsFilter, LeafSlot, PreparedEnds, TriangleSource, traverse,
};
use std::cell::Cell;
use std::marker::PhantomData;

/// What a ray tests and reads beside the nodes that it opens, each as often as it does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Reads {
    /// Boxes that no node holds: the root's own, where rays are tested against it first.
    pub boxes: u64,
    /// Bytes of the triangles that are tested.
    pub triangle_bytes: u64,
    /// Nodes that are read again, as leaves below them are decoded from them.
    pub nodes_again: u64,
}

/// Traces one ray for any collector, and meters it.
pub struct Meter<'a> {
    pub ray: &'a PreparedRay,
    pub skip: u32,
    /// Accepts only triangles that face the target. `None` for all.
    pub rule: Option<(Sides<'a>, Target)>,
    pub collector: &'a mut dyn Collector,
}

impl TreeVisitor for Meter<'_> {
    type Output = Reads;

    fn visit<N: StoredNodes, T: StoredTriangles<N>>(self, nodes: &N, triangles: &T) -> Reads {
        let rule = filter_of(self.rule);
        let ends = PreparedEnds {
            ray: self.ray,
            ends: &RayEnds::skipping(self.skip),
            // Of errors, and there are none.
            scene_exponent: 0,
        };
        let filter = EndsAnd {
            ends: EndsFilter(ends),
            filter: &rule,
        };
        let metered = Metered {
            triangles,
            reads: Cell::new(Reads {
                boxes: u64::from(N::TESTS_ROOT),
                ..Reads::default()
            }),
            nodes: PhantomData::<N>,
        };
        let collector = &mut Shared(self.collector);
        // With a stack of its own: the collector may use this thread's.
        traverse(nodes, &metered, self.ray, &filter, collector);
        metered.reads.get()
    }
}

/// Triangles that sum what is read of them.
struct Metered<'a, N, T> {
    triangles: &'a T,
    reads: Cell<Reads>,
    nodes: PhantomData<N>,
}

impl<N: StoredNodes, T: StoredTriangles<N>> TriangleSource<N::Bounds> for Metered<'_, N, T> {
    fn corners(&self, slot: &LeafSlot<N::Bounds>, axes: [u32; 3]) -> [[f32; 3]; 3] {
        let is_again = N::LEAVES == LeafOrder::Runs && slot.number == 0;
        let mut reads = self.reads.get();
        reads.triangle_bytes += self.triangles.bytes(slot) as u64;
        reads.nodes_again += u64::from(is_again);
        self.reads.set(reads);
        self.triangles.corners(slot, axes)
    }

    fn primitive(&self, slot: &LeafSlot<N::Bounds>) -> u32 {
        self.triangles.primitive(slot)
    }
}

#[cfg(test)]
mod tests {
    use crate::tree::{MeshCodec, check_codecs};
    use crate::{BuildConfig, Builder, Bvh, Mesh, NodeCodec};
    use slimbvh_core::RayEnds;
    use slimbvh_core::ray::{NO_PRIMITIVE, PreparedRay, Ray};
    use slimbvh_core::trace::{ClosestOrAny, Counted, NearestHits};

    /// Triangles behind each other.
    fn layers(count: u32) -> Mesh {
        let mut mesh = Mesh::default();
        for i in 0..count {
            let (z, first) = (-(i as f32), 3 * i);
            let corners = [[0.0, 0.0, z], [4.0, 0.0, z], [0.0, 4.0, z]];
            mesh.vertices.extend(corners);
            mesh.indices.push([first, first + 1, first + 2]);
        }
        mesh
    }

    fn build(nodes: NodeCodec, mesh_codec: MeshCodec, mesh: &Mesh) -> Bvh {
        let mut builder = Builder::new(BuildConfig {
            nodes,
            mesh: mesh_codec,
            ..BuildConfig::default()
        });
        builder.build(mesh).unwrap()
    }

    /// A ray that meets everything reads all triangles once, in all codecs. Negative control: a ray that misses reads none.
    #[test]
    fn a_ray_through_all_triangles_reads_their_bytes() {
        let mesh = layers(60);
        let mut sizes = Vec::new();
        for nodes in NodeCodec::all() {
            for mesh_codec in MeshCodec::ALL {
                if check_codecs(nodes, mesh_codec).is_err() {
                    continue;
                }
                let bvh = build(nodes, mesh_codec, &mesh);
                let read = |direction| {
                    let ray = Ray::new([1.0, 1.0, 2.0], direction);
                    let ray = PreparedRay::new(&ray, bvh.scene_exponent());
                    let mut found = Counted::new(NearestHits::<61>::new(ray.t_max));
                    let reads = bvh.meter(&ray, NO_PRIMITIVE, None, &mut found);
                    (reads, found)
                };
                let (through, found) = read([0.0, 0.0, -1.0]);
                assert_eq!(through.triangle_bytes, bvh.triangle_bytes() as u64);
                assert_eq!(found.triangle_count, 60);
                assert!(u64::from(found.node_count) * 2 <= u64::from(found.box_count));
                let (past, found) = read([0.0, 0.0, 1.0]);
                assert_eq!((past.triangle_bytes, found.triangle_count), (0, 0));
                let is_again = nodes.is_collapsed() && mesh_codec != MeshCodec::F32;
                assert_eq!(
                    through.nodes_again > 0,
                    is_again,
                    "{nodes:?} {mesh_codec:?}"
                );
                let tests_root = nodes.is_collapsed() && bvh.root_words().is_some();
                assert_eq!(through.boxes, u64::from(tests_root));
                sizes.push(through.triangle_bytes / 60);
            }
        }
        assert!(sizes.contains(&40) && sizes.contains(&16), "{sizes:?}");
    }

    /// A metered ray opens the same nodes, tests the same triangles and hits the same one.
    #[test]
    fn a_meter_changes_no_answer() {
        let mesh = layers(20);
        for nodes in NodeCodec::all() {
            if check_codecs(nodes, MeshCodec::F32).is_err() {
                continue;
            }
            let bvh = build(nodes, MeshCodec::F32, &mesh);
            let ray = Ray::new([1.0, 1.0, 2.0], [0.0, 0.0, -1.0]);
            let ray = PreparedRay::new(&ray, bvh.scene_exponent());
            let new = || Counted::new(ClosestOrAny::closest(ray.t_max));
            let (mut plain, mut metered) = (new(), new());
            bvh.collect(&ray, &RayEnds::skipping(0), &mut plain);
            bvh.meter(&ray, 0, None, &mut metered);
            let of = |it: &Counted<ClosestOrAny>| {
                let hit = it.inner.closest.hit;
                (
                    hit.primitive,
                    it.node_count,
                    it.box_count,
                    it.triangle_count,
                )
            };
            assert_eq!(of(&plain), of(&metered), "{nodes:?}");
            assert_eq!(plain.inner.closest.hit.primitive, 1);
        }
    }
}
