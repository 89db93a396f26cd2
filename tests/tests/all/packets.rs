//! Rays in a packet answer as each does alone, bit for bit.

use crate::wide::wide_codecs;
use bytemuck::Zeroable;
use glam::Vec3;
use proptest::collection::vec;
use proptest::prelude::*;
use slimbvh::generate::{icosphere, terrain};
use slimbvh::{BuildConfig, Bvh, CodeBits, LatticeBits, Mesh, MeshCodec, NodeCodec, TreeKind};
use slimbvh_core::RayEnds;
use slimbvh_core::lanes::Each;
use slimbvh_core::ray::PreparedRay;
use slimbvh_core::trace::{
    Children, ClosestHit, Collector, Lane, LeafRun, LeafTriangles, NodeSource, Order, PacketStacks,
    PlainNodes, PreparedRays, Skip, trace_alone, trace_packet,
};
use slimbvh_core::{Hit, Node, NodeRef, Ray};
use slimbvh_tests::parity::same_bits;
use slimbvh_tests::random::Random;
use slimbvh_tests::rays::{RayRecipe, any_ray};
use slimbvh_tests::scenes::real_meshes;
use slimbvh_tests::strategies::any_mesh;
use slimbvh_tests::{build, build_as, cases};
use std::cell::Cell;

/// A ray and its neighbours, if any.
#[derive(Clone, Debug)]
struct Bundle {
    recipe: RayRecipe,
    /// Distances between the rays, relative to the scene's size and to the direction's length.
    apart: [f32; 2],
    /// Offsets of each ray's origin and direction.
    others: Vec<[[f32; 3]; 2]>,
    /// Directions with two or three components of about the same size.
    is_diagonal: bool,
}

impl Bundle {
    fn cook(&self, mesh: &Mesh) -> Vec<Ray> {
        let mut first = self.recipe.cook(mesh);
        if self.is_diagonal {
            let size = first.direction.iter().fold(0.0f32, |a, x| a.max(x.abs()));
            first.direction = first.direction.map(|x| size.copysign(x));
        }
        let size = mesh.vertices.as_flattened().iter();
        let size = size.fold(0.0f32, |a, x| a.max(x.abs()));
        let length = first.direction.iter().fold(0.0f32, |a, x| a.max(x.abs()));
        let beside = |[origin, direction]: &[[f32; 3]; 2]| {
            let off = |from: [f32; 3], by: &[f32; 3], unit: f32| {
                [0, 1, 2].map(|axis| from[axis] + by[axis] * unit)
            };
            Ray {
                origin: off(first.origin, origin, size * self.apart[0]),
                direction: off(first.direction, direction, length * self.apart[1]),
                ..first
            }
        };
        let others = self.others.iter().map(beside);
        std::iter::once(first).chain(others).collect()
    }
}

fn bundle() -> impl Strategy<Value = Bundle> {
    let apart = || prop_oneof![Just(0.0f32), Just(1e-6), Just(1e-3), Just(0.03), Just(0.5)];
    let vector = || proptest::array::uniform3(-1.0f32..1.0);
    let others = vec([vector(), vector()], 0..14);
    (any_ray(), [apart(), apart()], others, any::<bool>()).prop_map(
        |(recipe, apart, others, is_diagonal)| Bundle {
            recipe,
            apart,
            others,
            is_diagonal,
        },
    )
}

/// Closest and any hit.
fn together(bvh: &Bvh, rays: &[Ray]) -> (Vec<Hit>, Vec<u32>) {
    let mut hits = vec![Hit::MISS; rays.len()];
    let mut found = vec![false; rays.len()];
    bvh.closest_hits_of_block(rays, &mut hits);
    bvh.any_hits_of_block(rays, &mut found);
    (hits, found.into_iter().map(u32::from).collect())
}

fn alone(bvh: &Bvh, rays: &[Ray]) -> (Vec<Hit>, Vec<u32>) {
    let hits = rays.iter().map(|ray| bvh.closest_hit(ray)).collect();
    let found = rays.iter().map(|ray| u32::from(bvh.any_hit(ray))).collect();
    (hits, found)
}

fn check(bvh: &Bvh, rays: &[Ray]) -> Result<(), String> {
    let ((hits, found), (own_hits, own_found)) = (together(bvh, rays), alone(bvh, rays));
    same_bits(&hits, &own_hits)
        .and_then(|()| same_bits(&found, &own_found))
        .map_err(|difference| format!("{:?}: {difference}", bvh.codecs()))
}

fn codecs() -> Vec<BuildConfig> {
    let lattice = |bits| NodeCodec::Lattice(bits);
    let nodes = [
        NodeCodec::F32,
        NodeCodec::Paper10,
        lattice(LatticeBits::Q10),
        lattice(LatticeBits::Q21),
    ];
    let mut all: Vec<_> = nodes
        .into_iter()
        .map(|nodes| BuildConfig {
            nodes,
            ..BuildConfig::default()
        })
        .collect();
    all.push(BuildConfig {
        tree: TreeKind::Clustered,
        ..BuildConfig::default()
    });
    all.push(BuildConfig {
        nodes: NodeCodec::Paper10,
        mesh: MeshCodec::Leaf10,
        ..BuildConfig::default()
    });
    all.extend(wide(0, false));
    all
}

/// Wide trees, with triangles in full or on a lattice.
fn wide(step_exponent: i32, is_on_lattice: bool) -> impl Iterator<Item = BuildConfig> {
    let codecs = wide_codecs(step_exponent).into_iter();
    let codecs = codecs.filter(move |(_, mesh)| mesh.step_exponent().is_some() == is_on_lattice);
    codecs.map(|(nodes, mesh)| BuildConfig {
        nodes,
        mesh,
        ..BuildConfig::default()
    })
}

proptest! {
    #![proptest_config(cases(400))]

    #[test]
    fn rays_together_answer_as_each_alone(mesh in any_mesh(), bundles in vec(bundle(), 1..6)) {
        let rays: Vec<Ray> = bundles.iter().flat_map(|bundle| bundle.cook(&mesh)).collect();
        for config in codecs() {
            let result = check(&build_as(&mesh, config), &rays);
            prop_assert!(result.is_ok(), "{:?}", result);
        }
        let mut snapped = mesh;
        let step_exponent = snapped.finest_step();
        snapped.snap(step_exponent);
        for bits in [LatticeBits::Q10, LatticeBits::Q21] {
            let config = BuildConfig {
                nodes: NodeCodec::Lattice(bits),
                mesh: MeshCodec::Lattice { step_exponent },
                ..BuildConfig::default()
            };
            let result = check(&build_as(&snapped, config), &rays);
            prop_assert!(result.is_ok(), "{:?}", result);
        }
        for config in wide(step_exponent, true) {
            let result = check(&build_as(&snapped, config), &rays);
            prop_assert!(result.is_ok(), "{:?}", result);
        }
    }
}

/// A former bug: rays whose axes have another order than the first ray's walked alone and then once more in the packet, with
/// the first ray's order.
#[test]
fn rays_that_went_alone_do_not_walk_along() {
    let mut random = Random::new(7);
    let solid = icosphere(Vec3::ZERO, 1.0, 5);
    let meshes = [
        ("sphere".into(), solid),
        ("terrain".into(), terrain(8.0, 128, 7)),
    ];
    for (name, mesh) in meshes.into_iter().chain(real_meshes(&["sponza.obj"])) {
        let bvh = build(&mesh, CodeBits::Bits30);
        let bounds = bvh.bounds().expect("there are triangles");
        let (center, size) = ((bounds.min + bounds.max) * 0.5, bounds.max - bounds.min);
        // Along a diagonal of the axes the longest axis changes from ray to ray.
        let eye = center + Vec3::ONE * size.max_element();
        let ray = |_| {
            let to = [0; 3].map(|_| random.unit() - 0.5);
            let direction = center - eye + Vec3::from(to) * size * 0.02;
            Ray::new(eye.to_array(), direction.to_array())
        };
        let rays: Vec<Ray> = (0..512).map(ray).collect();
        assert_eq!(check(&bvh, &rays), Ok(()), "{name}");
    }
}

/// Rays through the middle of a triangle on either side of a sphere, so that codecs that move vertices lose no hit.
fn across() -> Ray {
    Ray::new([0.05, 0.13, 3.0], [0.0, 0.0, -1.0])
}

/// The library holds no lock while it calls the caller's collector, so a collector may trace another ray, for example behind
/// glass.
#[test]
fn a_collector_may_ask_the_same_tree() {
    struct Asking<'a>(&'a Bvh, usize);
    impl Collector for Asking<'_> {
        fn limit(&self) -> f32 {
            f32::MAX
        }

        fn offer(&mut self, _: Hit) {
            self.1 += usize::from(self.0.any_hit(across()));
        }
    }
    let mesh = icosphere(Vec3::ZERO, 1.0, 2);
    for config in codecs() {
        let bvh = build_as(&mesh, config);
        let ask = |ray: &Ray| {
            let mut asking = Asking(&bvh, 0);
            let ray = PreparedRay::new(ray, bvh.scene_exponent());
            bvh.collect(&ray, &RayEnds::NONE, &mut asking);
            asking.1
        };
        assert!(ask(&across()) >= 2);
        // A ray that misses offers no hit, whatever limit the collector returns.
        assert_eq!(
            ask(&Ray {
                t_max: -1.0,
                ..across()
            }),
            0
        );
        assert_eq!(
            ask(&Ray {
                origin: [2f32.powi(50), 0.1, 3.0],
                ..across()
            }),
            0
        );
    }
}

/// A node source that counts opened nodes.
struct Opened<'a>(PlainNodes<'a>, Cell<u32>);

impl NodeSource for Opened<'_> {
    type Cursor = NodeRef;
    type Node = Children<NodeRef>;
    type Bounds = ();

    const NOTHING: NodeRef = NodeRef::EMPTY_LEAF;

    fn root(&self, axes: [u32; 3]) -> NodeRef {
        self.0.root(axes)
    }

    fn is_leaf(&self, cursor: NodeRef) -> bool {
        self.0.is_leaf(cursor)
    }

    fn leaf(&self, cursor: NodeRef, axes: [u32; 3]) -> LeafRun<()> {
        self.0.leaf(cursor, axes)
    }

    fn resume(&self, waited: NodeRef) -> NodeRef {
        waited
    }

    fn children(&self, cursor: NodeRef, order: Order) -> Children<NodeRef> {
        self.1.set(self.1.get() + 1);
        self.0.children(cursor, order)
    }

    fn step_limit(&self) -> u32 {
        self.0.step_limit()
    }
}

/// With nodes in a circle, the walk of a ray and of a packet ends after the largest possible number of steps.
#[test]
fn a_tree_with_circles_is_left() {
    let node = Node {
        planes: [[-1.0, -1.0, 1.0, 1.0]; 3],
        left: NodeRef::inner(1),
        right: NodeRef::inner(1),
        ..Node::zeroed()
    };
    let nodes = vec![node; 3000];
    let (nodes, triangles) = (PlainNodes(&nodes), LeafTriangles(&[]));
    let limit = nodes.step_limit();
    let ray = |i: u8| Ray::new([f32::from(i) * 0.005, 0.0, 0.9], [0.0, 0.0, -1.0]);
    let rays = [0, 1, 2, 3, 4, 5, 6, 7].map(ray);
    let first = PreparedRay::new(&rays[0], 0);
    let lane = Lane {
        filter: Skip::NONE,
        collector: ClosestHit::new(first.t_max),
    };
    let mut stacks: PacketStacks<Children<NodeRef>, Each<8>> = PacketStacks::EMPTY;
    let counted = Opened(nodes, Cell::new(0));
    let mut alone = lane;
    trace_alone(&mut stacks.alone, &counted, &triangles, &first, &mut alone);
    assert_eq!(counted.1.replace(0), limit);
    let mut prepared = PreparedRays::EMPTY;
    prepared.prepare(&rays, 0);
    let mut packet = [lane; 8];
    trace_packet(
        &mut stacks,
        &counted,
        &triangles,
        &mut prepared,
        &mut packet,
    );
    assert_eq!(counted.1.get(), limit);
}

/// The negative control: the comparison notices the hits of a neighbour's ray.
#[test]
fn an_answer_of_another_ray_is_found() {
    let mesh = icosphere(Vec3::ZERO, 1.0, 2);
    let bvh = build(&mesh, CodeBits::Bits30);
    let ray = |i: u8| Ray::new([f32::from(i) * 0.01, 0.1, 3.0], [0.0, 0.0, -1.0]);
    let rays: Vec<Ray> = (0..8).map(ray).collect();
    assert_eq!(check(&bvh, &rays), Ok(()));
    let (mut hits, _) = together(&bvh, &rays);
    hits.swap(2, 3);
    assert!(same_bits(&hits, &alone(&bvh, &rays).0).is_err());
}
