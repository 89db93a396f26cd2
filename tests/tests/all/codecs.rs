//! Trees in codecs: boxes only grow, and answers are those of the plain tree.

use proptest::prelude::*;
use slimbvh::{BuildConfig, Builder, Bvh, LatticeBits, MeshCodec, NodeCodec};
use slimbvh_core::encode::{
    BoxCodec, FINEST_STEP, LatticeCodec, Links, Paper10Codec, RootWords, RoundedNode, node_bounds,
    with_links,
};
use slimbvh_core::{Aabb, Node, NodeRef};
use slimbvh_tests::oracle::brute::{Answers, Parts};
use slimbvh_tests::rays::some_rays;
use slimbvh_tests::strategies::{any_mesh, large_mesh};
use slimbvh_tests::{CODE_BITS, build, build_as, cases};

/// All codecs of nodes, except full precision.
pub fn node_codecs() -> Vec<NodeCodec> {
    let lattice = LatticeBits::ALL.into_iter().map(NodeCodec::Lattice);
    [NodeCodec::Paper10].into_iter().chain(lattice).collect()
}

fn config(nodes: NodeCodec, mesh: MeshCodec) -> BuildConfig {
    BuildConfig {
        nodes,
        mesh,
        ..BuildConfig::default()
    }
}

/// The answers of all queries to a tree in a codec.
fn ask(bvh: &Bvh, ray: &slimbvh::Ray) -> Answers {
    Answers {
        closest: bvh.closest_hit(ray),
        any: bvh.any_hit(ray),
        nearest_1: bvh.nearest_hits(ray),
        nearest_4: bvh.nearest_hits(ray),
        nearest_8: bvh.nearest_hits(ray),
    }
}

/// The first faulty node: its children or its run differ from the plain tree's, or a child's box does not hold the plain
/// tree's box or does not lie in its parent's.
fn fault(plain: &[Node], decoded: &[Node]) -> Option<usize> {
    let parts = |node: &Node| [(node.left, node.left_box()), (node.right, node.right_box())];
    let is_in_parent = |(child, outer): (NodeRef, Aabb)| {
        let grandchildren = decoded
            .get(child.index() as usize)
            .filter(|_| !child.is_leaf());
        let mut inner = grandchildren.into_iter().flat_map(parts);
        inner.all(|(child, inner)| child == NodeRef::EMPTY_LEAF || outer.contains(&inner))
    };
    let is_sound = |(a, b): (&Node, &Node)| {
        let links = |node: &Node| (node.left, node.right, node.first, node.last);
        let mut pairs = parts(a).into_iter().zip(parts(b));
        let holds =
            pairs.all(|((child, a), (_, b))| child == NodeRef::EMPTY_LEAF || b.contains(&a));
        links(a) == links(b) && holds && parts(b).into_iter().all(is_in_parent)
    };
    if plain.len() != decoded.len() {
        return Some(plain.len());
    }
    plain.iter().zip(decoded).position(|pair| !is_sound(pair))
}

/// A vertex of a leaf's triangle that is outside of the leaf's box.
fn stray(bvh: &Bvh) -> Option<usize> {
    let parts = |node: &Node| [(node.left, node.left_box()), (node.right, node.right_box())];
    let mut leaves = bvh
        .nodes()
        .iter()
        .flat_map(parts)
        .filter(|(child, _)| child.is_leaf());
    leaves.find_map(|(leaf, bounds)| {
        let run = leaf.first() as usize..(leaf.first() + leaf.count()) as usize;
        let is_stray = |i: &usize| !bounds.contains(&bvh.leaf_triangles()[*i].triangle().bounds());
        run.clone().find(is_stray)
    })
}

/// The bytes of all nodes, each decoded from the root and encoded by itself.
fn alone<C: BoxCodec>(
    plain: &[C::Node],
    codec: &C,
    bytes_of: impl Fn(&C::Bounds, &C::Node) -> Vec<u8>,
) -> Vec<u8> {
    let node = |(i, node)| bytes_of(&node_bounds(i, plain, codec), node);
    (0..).zip(plain).flat_map(node).collect()
}

/// [`alone`], and the root, on the finest lattice.
fn alone_on_lattice<const BITS: u32, const WORDS: usize>(plain: &[Node]) -> (Vec<u8>, RootWords) {
    let step_exponent = FINEST_STEP;
    let codec = LatticeCodec::<BITS, WORDS>;
    let rounded = |node| RoundedNode::new(node, step_exponent);
    let rounded: Vec<RoundedNode> = plain.iter().map(rounded).collect();
    let nodes = alone(&rounded, &codec, |bounds, node| {
        let triangle = Links::first_triangle(node.left, node.right);
        let links = Links::new(node.left, node.right, triangle);
        let words = with_links::<BITS, WORDS>(codec.encode(bounds, node).words, links);
        bytemuck::cast_slice(&words).to_vec()
    });
    let root = node_bounds(0, &rounded, &codec);
    (nodes, RootWords::of_lattice(&root, step_exponent))
}

proptest! {
    #![proptest_config(cases(100))]

    /// One thread a node, walking from the root, encodes the same bytes as one pass from the root down.
    #[test]
    fn nodes_that_are_coded_alone_are_those_that_are_coded_together(mesh in any_mesh()) {
        for code_bits in CODE_BITS {
            let plain = build(&mesh, code_bits);
            let nodes = plain.nodes();
            let codec = Paper10Codec { opaque_zero: 0 };
            let paper10 = alone(nodes, &codec, |bounds, node| {
                bytemuck::bytes_of(&codec.encode(bounds, node).node).to_vec()
            });
            let root = RootWords::of_paper10(&node_bounds(0, nodes, &codec));
            for (nodes, alone) in [
                (NodeCodec::Paper10, (paper10, root)),
                (NodeCodec::Lattice(LatticeBits::Q4), alone_on_lattice::<4, 3>(nodes)),
                (NodeCodec::Lattice(LatticeBits::Q10), alone_on_lattice::<10, 4>(nodes)),
                (NodeCodec::Lattice(LatticeBits::Q21), alone_on_lattice::<21, 7>(nodes)),
            ] {
                let config = BuildConfig { code_bits, ..config(nodes, MeshCodec::F32) };
                let together = build_as(&mesh, config);
                prop_assert!(alone.0 == together.stored()[0], "{:?}", nodes);
                prop_assert_eq!(Some(alone.1), together.root_words());
            }
        }
    }

    #[test]
    fn coded_nodes_answer_as_plain_ones_do(mesh in any_mesh(), recipes in some_rays(24)) {
        for code_bits in CODE_BITS {
            let plain = build(&mesh, code_bits);
            for nodes in node_codecs() {
                let config = BuildConfig { code_bits, ..config(nodes, MeshCodec::F32) };
                let coded = build_as(&mesh, config);
                prop_assert_eq!(coded.codecs(), (nodes, MeshCodec::F32));
                let decoded = coded.decoded();
                prop_assert_eq!(decoded.leaf_triangles(), plain.leaf_triangles());
                prop_assert_eq!(fault(plain.nodes(), decoded.nodes()), None, "{:?}", nodes);
                for recipe in &recipes {
                    let ray = recipe.cook(&mesh);
                    let (a, b) = (ask(&coded, &ray), Parts::from(&plain).ask_tree(&ray));
                    prop_assert!(a.same_bits(&b), "{nodes:?} {ray:?} {a:#?} {b:#?}");
                }
            }
        }
    }

    /// The lattice stores the snapped mesh exactly: the same answers, from fewer bytes.
    #[test]
    fn a_mesh_on_the_lattice_is_stored_exactly(mesh in any_mesh(), recipes in some_rays(24), coarse in 0i32..24) {
        let mut snapped = mesh.clone();
        let step_exponent = mesh.finest_step() + coarse;
        let moved = f64::from(snapped.snap(step_exponent));
        let bound = 0.866_026 * 2f64.powi(step_exponent);
        prop_assert!(moved <= bound, "{moved} {bound}");
        let plain = build_as(&snapped, BuildConfig::default());
        for bits in LatticeBits::ALL {
            let config = config(NodeCodec::Lattice(bits), MeshCodec::Lattice { step_exponent });
            let coded = build_as(&snapped, config);
            let decoded = coded.decoded();
            prop_assert_eq!(decoded.leaf_triangles(), plain.leaf_triangles());
            prop_assert_eq!(fault(plain.nodes(), decoded.nodes()), None, "{:?}", bits);
            prop_assert_eq!(coded.triangle_count(), plain.triangle_count());
            for recipe in &recipes {
                let ray = recipe.cook(&mesh);
                let (a, b) = (ask(&coded, &ray), Parts::from(&plain).ask_tree(&ray));
                prop_assert!(a.same_bits(&b), "{bits:?} {ray:?} {a:#?} {b:#?}");
            }
        }
    }

    /// The paper10 codec moves vertices leaf by leaf. Its tree answers as brute force over the decoded mesh.
    #[test]
    fn paper10_leaves_answer_as_the_decoded_mesh_does(mesh in any_mesh(), recipes in some_rays(24)) {
        let plain = build_as(&mesh, BuildConfig::default());
        let coded = build_as(&mesh, config(NodeCodec::Paper10, MeshCodec::Leaf10));
        let decoded = coded.decoded();
        prop_assert_eq!(fault(plain.nodes(), decoded.nodes()), None);
        prop_assert_eq!(stray(&decoded), None);
        for recipe in &recipes {
            let ray = recipe.cook(&mesh);
            let (a, b) = (ask(&coded, &ray), Parts::from(&decoded).ask_all(&ray));
            prop_assert!(a.same_bits(&b), "{ray:?} {a:#?} {b:#?}");
        }
    }

    /// A refit keeps the order of the triangles, as a plain refit does, and loses no hit.
    #[test]
    fn refitted_coded_trees_answer_as_plain_ones_do(
        mesh in any_mesh(),
        offsets in proptest::collection::vec(proptest::array::uniform3(-2f32..2.0), 7),
        recipes in some_rays(12),
    ) {
        let mut moved = mesh.clone();
        for (vertex, offset) in moved.vertices.iter_mut().zip(offsets.iter().cycle()) {
            *vertex = [0, 1, 2].map(|axis| vertex[axis] + vertex[axis] * offset[axis]);
        }
        prop_assume!(moved.validate().is_ok());
        let step_exponent = mesh.finest_step().max(moved.finest_step()) + 3;
        let (mut mesh, mut moved) = (mesh, moved);
        mesh.snap(step_exponent);
        moved.snap(step_exponent);
        let mut builder = Builder::new(BuildConfig::default());
        let mut plain = build_as(&mesh, BuildConfig::default());
        prop_assert!(builder.refit(&moved, &mut plain).is_ok());
        let lattice = MeshCodec::Lattice { step_exponent };
        let q10 = NodeCodec::Lattice(LatticeBits::Q10);
        for config in [config(NodeCodec::Paper10, MeshCodec::F32), config(q10, MeshCodec::F32), config(q10, lattice)] {
            let mut builder = Builder::new(config);
            let mut coded = build_as(&mesh, config);
            prop_assert!(builder.refit(&moved, &mut coded).is_ok());
            let decoded = coded.decoded();
            prop_assert_eq!(decoded.leaf_triangles(), plain.leaf_triangles());
            prop_assert_eq!(fault(plain.nodes(), decoded.nodes()), None);
            for recipe in &recipes {
                let ray = recipe.cook(&moved);
                let (a, b) = (ask(&coded, &ray), Parts::from(&plain).ask_tree(&ray));
                prop_assert!(a.same_bits(&b), "{ray:?} {a:#?} {b:#?}");
            }
        }
    }
}

proptest! {
    #![proptest_config(cases(8))]

    /// Enough triangles that several threads encode them.
    #[test]
    fn large_trees_are_coded_like_small_ones(mesh in large_mesh()) {
        let mut snapped = mesh.clone();
        let step_exponent = mesh.finest_step() + 9;
        snapped.snap(step_exponent);
        for (mesh, codec) in [(&mesh, MeshCodec::F32), (&snapped, MeshCodec::Lattice { step_exponent })] {
            let plain = build_as(mesh, BuildConfig::default());
            let q10 = NodeCodec::Lattice(LatticeBits::Q10);
            let decoded = build_as(mesh, config(q10, codec)).decoded();
            prop_assert_eq!(decoded.leaf_triangles(), plain.leaf_triangles());
            prop_assert_eq!(fault(plain.nodes(), decoded.nodes()), None);
        }
    }
}

/// The negative controls: the check of boxes finds a plane moved inward by one bit, and a child that leaves its parent.
#[test]
fn a_box_that_is_too_small_is_found() {
    let mesh = slimbvh::generate::soup(500, 3);
    let plain = build_as(&mesh, BuildConfig::default());
    let q10 = NodeCodec::Lattice(LatticeBits::Q10);
    let decoded = build_as(&mesh, config(q10, MeshCodec::F32)).decoded();
    assert_eq!(fault(plain.nodes(), decoded.nodes()), None);
    let mut found = 0;
    for node in 0..decoded.node_count() {
        let mut nodes = decoded.nodes().to_vec();
        nodes[node].planes[0][2] = f32::from_bits(plain.nodes()[node].planes[0][2].to_bits() - 1);
        found += usize::from(fault(plain.nodes(), &nodes).is_some());
        nodes[node].planes[0][2] = decoded.nodes()[node].planes[0][2] * 4.0;
        let is_inner_root = node > 0;
        found += usize::from(is_inner_root && fault(plain.nodes(), &nodes).is_some());
    }
    assert_eq!(found, 2 * decoded.node_count() - 1);
}

/// A hierarchy that was never built has no triangles, in any codec.
#[test]
fn what_was_never_built_can_be_refitted() {
    for nodes in node_codecs() {
        let mut bvh = Bvh::default();
        let mesh = slimbvh::Mesh::default();
        let mut builder = Builder::new(config(nodes, MeshCodec::F32));
        assert!(builder.refit(&mesh, &mut bvh).is_ok());
        let ray = slimbvh::Ray::new([0.0; 3], [1.0, 0.0, 0.0]);
        assert!(!bvh.closest_hit(ray).is_hit() && bvh.validate().is_ok());
    }
}

/// A builder that encodes narrow, middle, wide and mixed triangles in turn gives the bytes of a new builder.
#[test]
fn what_was_coded_before_changes_no_byte() {
    let step_exponent = -12;
    let wide = |radius: f32, subdivisions| {
        let mut mesh = slimbvh::generate::icosphere(glam::Vec3::ZERO, radius, subdivisions);
        mesh.snap(step_exponent);
        mesh.normals.clear();
        mesh
    };
    let (narrow, middle, wide) = (wide(0.25, 2), wide(30.0, 1), wide(2000.0, 0));
    let mut mixed = narrow.clone();
    let first = mixed.vertices.len() as u32;
    mixed.vertices.extend(&middle.vertices);
    let of_middle = middle.indices.iter();
    mixed
        .indices
        .extend(of_middle.map(|face| face.map(|corner| first + corner)));
    let q10 = NodeCodec::Lattice(LatticeBits::Q10);
    let config = config(q10, MeshCodec::Lattice { step_exponent });
    let mut builder = Builder::new(config);
    let mut bvh = Bvh::default();
    let mut bytes_of_all = Vec::new();
    for mesh in [
        &narrow, &narrow, &middle, &middle, &wide, &wide, &mixed, &mixed, &narrow, &mixed, &middle,
        &narrow,
    ] {
        let built = builder.build_into(mesh, &mut bvh);
        assert!(built.is_ok(), "{built:?}");
        let expected = build_as(mesh, config);
        assert!(bvh.stored() == expected.stored() && bvh.validate().is_ok());
        bytes_of_all.push(bvh.triangle_bytes() / mesh.indices.len());
    }
    // The meshes have the intended widths.
    let mixed = bytes_of_all[6];
    assert!(16 < mixed && mixed < 28, "{mixed}");
    assert_eq!(
        bytes_of_all,
        [16, 16, 28, 28, 40, 40, mixed, mixed, 16, mixed, 28, 16]
    );
}

/// A mesh off the lattice is an error that names the vertex.
#[test]
fn what_is_off_the_lattice_is_refused() {
    let mut mesh = slimbvh::generate::icosphere(glam::Vec3::ONE, 2.0, 2);
    let step_exponent = -8;
    mesh.snap(step_exponent);
    let q10 = NodeCodec::Lattice(LatticeBits::Q10);
    let mut builder = Builder::new(config(q10, MeshCodec::Lattice { step_exponent }));
    assert!(builder.build(&mesh).is_ok());
    mesh.vertices[7][1] += 1e-4;
    let error = builder
        .build(&mesh)
        .map(|_| ())
        .map_err(|error| error.to_string());
    let error = error.err().unwrap_or_default();
    assert!(
        error.contains("vertex 7 at") && error.ends_with("snap the mesh first"),
        "{error}"
    );
}

/// Equal vertices stay equal, so no surface cracks; the tolerance bounds how far vertices move.
#[test]
fn corners_that_are_shared_stay_shared() {
    let mesh = slimbvh::generate::icosphere(glam::Vec3::new(3.0, -2.0, 9.0), 2.0, 4);
    let mut snapped = mesh.clone();
    snapped.snap(-12);
    for (a, b) in mesh.vertices.iter().zip(&snapped.vertices) {
        for axis in 0..3 {
            assert!((f64::from(a[axis]) - f64::from(b[axis])).abs() <= 2f64.powi(-13));
            assert_eq!(b[axis] * 4096.0, (b[axis] * 4096.0).round());
        }
    }
}
