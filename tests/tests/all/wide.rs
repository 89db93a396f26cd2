//! Wide trees: nodes of up to four children hold what the binary tree holds, and answer as it does.

use bytemuck::Pod;
use proptest::prelude::*;
use slimbvh::generate::{icosphere, soup};
use slimbvh::{
    BuildConfig, Builder, Bvh, CodeBits, Mesh, MeshCodec, NodeCodec, TreeKind, WideStore,
};
use slimbvh_core::encode::{
    FINEST_STEP, FullWideNode, MixedWideNode, PackedWideNode, RootWords, RoundedChildren,
    TriangleCorners, WideNode, corner_counts, encode_triangle, number_corners, scaled_step,
    store_shared_triangle,
};
use slimbvh_core::float::power_of_two;
use slimbvh_core::lattice::LatticeBox;
use slimbvh_core::wide::{
    Begins, Collapse, Origin, WideChildren, collapse, most_wide_nodes, wide_children, wide_origin,
};
use slimbvh_core::{Aabb, LeafTriangle, Node, NodeRef};
use slimbvh_tests::oracle::brute::{Answers, Parts};
use slimbvh_tests::rays::some_rays;
use slimbvh_tests::strategies::{any_mesh, large_mesh};
use slimbvh_tests::{build_as, cases};
use std::collections::HashMap;

/// All stores with the triangles that go with them, on a lattice of this step.
pub fn wide_codecs(step_exponent: i32) -> [(NodeCodec, MeshCodec); 4] {
    let on_lattice = MeshCodec::Lattice { step_exponent };
    [
        (WideStore::Full, MeshCodec::F32),
        (WideStore::Exact, MeshCodec::F32),
        (WideStore::Exact, on_lattice),
        (WideStore::Packed, on_lattice),
    ]
    .map(|(store, mesh)| (NodeCodec::Wide(store), mesh))
}

/// All orders of triangles and kinds of trees.
fn trees() -> [BuildConfig; 3] {
    let clustered = BuildConfig {
        tree: TreeKind::Clustered,
        ..BuildConfig::default()
    };
    [CodeBits::Bits30.into(), CodeBits::Bits63.into(), clustered]
}

/// A tree as it is stored.
#[derive(Debug, PartialEq)]
struct Bytes {
    nodes: Vec<u8>,
    triangles: Vec<u8>,
    root: Option<RootWords>,
}

impl Bytes {
    fn of(bvh: &Bvh) -> Self {
        let [nodes, triangles] = bvh.stored().map(<[u8]>::to_vec);
        let root = bvh.root_words();
        Self {
            nodes,
            triangles,
            root,
        }
    }
}

/// A wide tree in which each binary node finds its place alone, as a thread does on a GPU.
struct Alone<'a> {
    nodes: &'a [Node],
    leaves: &'a [LeafTriangle],
    collapses: Vec<u32>,
    origins: Vec<Origin>,
    begins: Vec<u32>,
    step_exponent: i32,
}

fn exclusive_sums(numbers: impl Iterator<Item = u32>) -> Vec<u32> {
    let before = numbers.scan(0, |sum, number| {
        let before = *sum;
        *sum += number;
        Some(before)
    });
    before.collect()
}

impl<'a> Alone<'a> {
    /// Of these nodes and their triangles. What is taken in follows from the boxes of other nodes: those of the build, before a
    /// refit.
    fn new(built: &Bvh, moved: &'a Bvh, mesh: MeshCodec) -> Self {
        let (from, nodes) = (built.nodes(), moved.nodes());
        let collapses = from.iter().map(|node| collapse(node, from, 0).0);
        let collapses: Vec<u32> = collapses.collect();
        let origin = |i| wide_origin(i, from, &collapses);
        let origins: Vec<Origin> = (0..from.len() as u32).map(origin).collect();
        let counts = origins.iter().zip(&collapses);
        let counts = counts.map(|(origin, &collapse)| origin.inner_count(Collapse(collapse)));
        let step_exponent = match mesh.step_exponent() {
            Some(step_exponent) => scaled_step(step_exponent, moved.scene_exponent()),
            None => FINEST_STEP,
        };
        Self {
            begins: exclusive_sums(counts),
            nodes,
            leaves: moved.leaf_triangles(),
            collapses,
            origins,
            step_exponent,
        }
    }

    fn children(&self, i: usize) -> WideChildren {
        wide_children(&self.nodes[i], Collapse(self.collapses[i]), self.nodes)
    }

    fn rounded(&self, i: usize) -> RoundedChildren {
        RoundedChildren::new(&self.children(i), self.step_exponent)
    }

    /// Each wide node at its place. A function makes it from its binary node and its first inner child's place.
    fn placed<T: Copy + Default>(&self, node: impl Fn(usize, u32) -> T) -> Vec<T> {
        let begins = Begins(&self.begins);
        let count = self.origins.iter().filter(|origin| origin.is_there());
        let count = count.count();
        assert!(count as u32 <= most_wide_nodes(self.leaves.len() as u32));
        let mut nodes = vec![None; count];
        for (i, origin) in self.origins.iter().enumerate() {
            if origin.is_there() {
                let place = begins.place(*origin) as usize;
                assert!(nodes[place].is_none(), "{i} {place}");
                nodes[place] = Some(node(i, begins.first_child(i as u32)));
            }
        }
        let nodes = nodes.into_iter().map(|node| node.expect("no gaps"));
        nodes.collect()
    }

    /// All nodes over triangles on the lattice, and the words of these.
    fn mixed<N: MixedWideNode + Pod + Default>(&self) -> Bytes {
        let step = power_of_two(self.step_exponent);
        let mut corners = vec![0; self.leaves.len()];
        let mut words: Vec<u32> = Vec::new();
        let mut coded = vec![(N::default(), 0, 0); self.nodes.len()];
        for (i, origin) in self.origins.iter().enumerate() {
            if !origin.is_there() {
                continue;
            }
            let from = self.rounded(i);
            for child in from.nodes {
                let count = if child.is_leaf() { child.count() } else { 0 };
                number_corners(child.first(), count, self.leaves, &mut corners);
            }
            let counts = corner_counts(from.nodes, 0, &corners);
            let (node, word_count) = N::encode(&from, counts);
            let first_word = words.len() as u32;
            coded[i] = (node, from.count, first_word);
            words.resize((first_word + word_count) as usize, 0);
            for (number, child) in (0..from.count).zip(from.nodes) {
                let count = if child.is_leaf() { child.count() } else { 0 };
                let corner = node.corner(number, self.step_exponent);
                let first = first_word + node.first_word(number);
                for triangle in 0..count {
                    let i = (child.first() + triangle) as usize;
                    if N::SHARES_CORNERS {
                        let next = corners.get(i + 1).copied().unwrap_or(u32::MAX);
                        let own = [corners[i], next].map(TriangleCorners);
                        store_shared_triangle::<false>(
                            &self.leaves[i],
                            &corner,
                            own,
                            step,
                            first,
                            &mut words,
                        );
                    } else {
                        let all = encode_triangle(&self.leaves[i], &corner, step);
                        let at = (first + triangle * corner.words) as usize;
                        let end = at + corner.words as usize;
                        words[at..end].copy_from_slice(&all[..corner.words as usize]);
                    }
                }
            }
        }
        let node = |i: usize, first_child| {
            let (node, count, first_word) = coded[i];
            node.placed(count, first_child, first_word)
        };
        Bytes {
            nodes: bytemuck::cast_slice(&self.placed(node)).to_vec(),
            triangles: bytemuck::cast_slice(&words).to_vec(),
            root: Some(self.root()),
        }
    }

    fn root(&self) -> RootWords {
        let rounded = self.rounded(0);
        let boxes = rounded.boxes[..rounded.count as usize].iter().copied();
        let root = boxes.reduce(|a, b| a.union(&b)).unwrap_or(LatticeBox::ZERO);
        RootWords::of_lattice(&root, self.step_exponent)
    }

    fn bytes(&self, (nodes, mesh): (NodeCodec, MeshCodec)) -> Bytes {
        let is_mixed = mesh.step_exponent().is_some();
        let full = bytemuck::cast_slice(self.leaves).to_vec();
        match nodes {
            NodeCodec::Wide(WideStore::Full) => {
                let node = |i: usize, first_child| {
                    let run = [self.nodes[i].first, self.nodes[i].last];
                    FullWideNode::new(&self.children(i), run, first_child)
                };
                Bytes {
                    nodes: bytemuck::cast_slice(&self.placed(node)).to_vec(),
                    triangles: full,
                    root: None,
                }
            }
            NodeCodec::Wide(WideStore::Exact) if is_mixed => self.mixed::<WideNode>(),
            NodeCodec::Wide(WideStore::Exact) => {
                let node = |i, first_child| WideNode::new(&self.rounded(i), first_child);
                Bytes {
                    nodes: bytemuck::cast_slice(&self.placed(node)).to_vec(),
                    triangles: full,
                    root: Some(self.root()),
                }
            }
            NodeCodec::Wide(WideStore::Packed) => self.mixed::<PackedWideNode>(),
            _ => panic!("nodes are wide"),
        }
    }
}

/// The run of triangles below a child.
fn run(child: NodeRef, nodes: &[Node]) -> [u32; 2] {
    if child.is_leaf() {
        [child.first(), child.first() + child.count()]
    } else {
        let node = &nodes[child.index() as usize];
        [node.first, node.last + 1]
    }
}

/// All children of a tree's nodes with their boxes, those that are there.
fn children(nodes: &[Node]) -> impl Iterator<Item = (NodeRef, Aabb)> {
    let all = nodes
        .iter()
        .flat_map(|node| [(node.left, node.left_box()), (node.right, node.right_box())]);
    all.filter(|(child, _)| *child != NodeRef::EMPTY_LEAF)
}

/// The first fault of a decoded wide tree: its leaves are not the plain tree's, a child's box does not hold that of the plain tree's
/// child with the same triangles, or does not lie in its parent's.
fn fault(plain: &[Node], decoded: &[Node]) -> Option<String> {
    let leaves = |nodes| {
        let mut leaves: Vec<u32> = children(nodes)
            .filter(|(child, _)| child.is_leaf())
            .map(|(child, _)| child.0)
            .collect();
        leaves.sort_unstable();
        leaves
    };
    if leaves(plain) != leaves(decoded) {
        return Some("other leaves".into());
    }
    let exact: HashMap<[u32; 2], Aabb> = children(plain)
        .map(|(child, bounds)| (run(child, plain), bounds))
        .collect();
    for (child, bounds) in children(decoded) {
        let run = run(child, decoded);
        if let Some(exact) = exact.get(&run)
            && !bounds.contains(exact)
        {
            return Some(format!("{run:?} {bounds:?} {exact:?}"));
        }
        if child.is_leaf() {
            continue;
        }
        let below = &decoded[child.index() as usize..=child.index() as usize];
        if let Some((_, inner)) = children(below).find(|(_, inner)| !bounds.contains(inner)) {
            return Some(format!("{run:?} {bounds:?} {inner:?}"));
        }
    }
    None
}

fn ask(bvh: &Bvh, ray: &slimbvh::Ray) -> Answers {
    Answers {
        closest: bvh.closest_hit(ray),
        any: bvh.any_hit(ray),
        nearest_1: bvh.nearest_hits(ray),
        nearest_4: bvh.nearest_hits(ray),
        nearest_8: bvh.nearest_hits(ray),
    }
}

fn snapped(mesh: &Mesh, step_exponent: i32) -> Mesh {
    let mut mesh = mesh.clone();
    mesh.snap(step_exponent);
    mesh
}

proptest! {
    #![proptest_config(cases(100))]

    /// Nodes that each find their place alone have the bytes of those that are collapsed in one walk.
    #[test]
    fn nodes_that_are_placed_alone_are_those_that_are_placed_together(mesh in any_mesh(), coarse in 0i32..24) {
        let step_exponent = mesh.finest_step() + coarse;
        let snapped = snapped(&mesh, step_exponent);
        for config in trees() {
            let plain = build_as(&snapped, config);
            for (nodes, mesh) in wide_codecs(step_exponent) {
                let together = build_as(&snapped, BuildConfig { nodes, mesh, ..config });
                let alone = Alone::new(&plain, &plain, mesh).bytes((nodes, mesh));
                prop_assert!(Bytes::of(&together) == alone, "{:?} {:?}", nodes, mesh);
                prop_assert_eq!(together.validate_over(&snapped), Ok(()));
            }
        }
    }

    #[test]
    fn wide_nodes_answer_as_plain_ones_do(mesh in any_mesh(), recipes in some_rays(24), coarse in 0i32..24) {
        let step_exponent = mesh.finest_step() + coarse;
        let snapped = snapped(&mesh, step_exponent);
        for config in trees() {
            for (nodes, codec) in wide_codecs(step_exponent) {
                let stored = if codec == MeshCodec::F32 { &mesh } else { &snapped };
                let plain = build_as(stored, config);
                let wide = build_as(stored, BuildConfig { nodes, mesh: codec, ..config });
                prop_assert_eq!(wide.codecs(), (nodes, codec));
                let decoded = wide.decoded();
                prop_assert_eq!(decoded.validate(), Ok(()));
                prop_assert_eq!(decoded.leaf_triangles(), plain.leaf_triangles());
                prop_assert_eq!(fault(plain.nodes(), decoded.nodes()), None, "{:?}", nodes);
                for recipe in &recipes {
                    let ray = recipe.cook(stored);
                    let (a, b) = (ask(&wide, &ray), Parts::from(&plain).ask_tree(&ray));
                    prop_assert!(a.same_bits(&b), "{nodes:?} {codec:?} {ray:?} {a:#?} {b:#?}");
                }
            }
        }
    }

    /// A refit keeps which children nodes have, and where nodes and triangles lie; only boxes and the width of leaves change.
    #[test]
    fn refitted_wide_trees_answer_as_plain_ones_do(
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
        let (mesh, moved) = (snapped(&mesh, step_exponent), snapped(&moved, step_exponent));
        for config in trees() {
            let built = build_as(&mesh, config);
            let mut plain = built.clone();
            prop_assert!(Builder::new(config).refit(&moved, &mut plain).is_ok());
            for (nodes, codec) in wide_codecs(step_exponent) {
                let config = BuildConfig { nodes, mesh: codec, ..config };
                let mut builder = Builder::new(config);
                let before = build_as(&mesh, config);
                let mut wide = before.clone();
                prop_assert!(builder.refit(&mesh, &mut wide).is_ok());
                prop_assert!(Bytes::of(&wide) == Bytes::of(&before), "a refit to the same mesh");
                prop_assert!(builder.refit(&moved, &mut wide).is_ok());
                prop_assert_eq!(wide.validate_over(&moved), Ok(()));
                let alone = Alone::new(&built, &plain, codec).bytes((nodes, codec));
                prop_assert!(Bytes::of(&wide) == alone, "{:?} {:?}", nodes, codec);
                let decoded = wide.decoded();
                prop_assert_eq!(decoded.leaf_triangles(), plain.leaf_triangles());
                prop_assert_eq!(fault(plain.nodes(), decoded.nodes()), None);
                for recipe in &recipes {
                    let ray = recipe.cook(&moved);
                    let (a, b) = (ask(&wide, &ray), Parts::from(&plain).ask_tree(&ray));
                    prop_assert!(a.same_bits(&b), "{ray:?} {a:#?} {b:#?}");
                }
            }
        }
    }
}

proptest! {
    #![proptest_config(cases(8))]

    /// Enough triangles that several threads collapse and encode them.
    #[test]
    fn large_trees_are_collapsed_like_small_ones(mesh in large_mesh()) {
        let step_exponent = mesh.finest_step() + 9;
        let mesh = snapped(&mesh, step_exponent);
        for config in trees() {
            let plain = build_as(&mesh, config);
            for (nodes, codec) in wide_codecs(step_exponent) {
                let config = BuildConfig { nodes, mesh: codec, ..config };
                let together = build_as(&mesh, config);
                let alone = Alone::new(&plain, &plain, codec).bytes((nodes, codec));
                prop_assert!(Bytes::of(&together) == alone, "{:?} {:?}", nodes, codec);
                let mut refitted = together.clone();
                prop_assert!(Builder::new(config).refit(&mesh, &mut refitted).is_ok());
                prop_assert!(Bytes::of(&refitted) == alone, "{:?} {:?}", nodes, codec);
            }
        }
    }
}

/// The negative controls: the check of decoded boxes finds a plane moved inward by one bit, a child that leaves its parent and a
/// leaf with another triangle; the comparison of bytes, a child that was not opened.
#[test]
fn a_wide_tree_that_is_wrong_is_found() {
    let mesh = soup(500, 3);
    let plain = build_as(&mesh, BuildConfig::default());
    let (nodes, codec) = wide_codecs(0)[0];
    let config = BuildConfig {
        nodes,
        mesh: codec,
        ..BuildConfig::default()
    };
    let wide = build_as(&mesh, config);
    let decoded = wide.decoded();
    assert_eq!(fault(plain.nodes(), decoded.nodes()), None);
    let (mut moved, mut left, mut other) = (0, 0, 0);
    let count = decoded.node_count();
    for node in 0..count {
        let mut nodes = decoded.nodes().to_vec();
        let plane = &mut nodes[node].planes[0][2];
        *plane = plane.next_down();
        moved += usize::from(fault(plain.nodes(), &nodes).is_some());
        let mut nodes = decoded.nodes().to_vec();
        nodes[node].planes[1][1] -= 4.0;
        left += usize::from(fault(plain.nodes(), &nodes).is_some());
        let mut nodes = decoded.nodes().to_vec();
        if nodes[node].left.is_leaf() {
            nodes[node].left.0 += 1;
            other += usize::from(fault(plain.nodes(), &nodes).is_none());
        }
    }
    assert!(moved > count / 2 && moved <= count, "{moved} of {count}");
    assert!(left >= count - 1, "{left} of {count}");
    assert_eq!(other, 0);
    let mut alone = Alone::new(&plain, &plain, codec);
    assert!(alone.bytes((nodes, codec)) == Bytes::of(&wide));
    let mut words = alone.collapses.iter().zip(&alone.origins);
    let which = words.position(|(&word, origin)| origin.is_there() && word & 0b1100 != 0);
    alone.collapses[which.expect("a node takes in two")] &= !0b1100;
    assert!(alone.bytes((nodes, codec)) != Bytes::of(&wide));
}

/// A builder that stored anything else before gives the bytes of a new builder, and a hierarchy that was anything else, too.
#[test]
fn what_was_stored_before_changes_no_byte() {
    let step_exponent = -12;
    let ball = |radius: f32, subdivisions| {
        let mut mesh = icosphere(glam::Vec3::ZERO, radius, subdivisions);
        mesh.snap(step_exponent);
        mesh.normals.clear();
        mesh
    };
    let (narrow, middle, wide) = (ball(0.25, 3), ball(30.0, 2), ball(2000.0, 1));
    let mut bvh = Bvh::default();
    for (nodes, mesh) in wide_codecs(step_exponent) {
        let config = BuildConfig {
            nodes,
            mesh,
            ..BuildConfig::default()
        };
        let mut builder = Builder::new(config);
        let mut bytes_of_all = Vec::new();
        for mesh in [
            &narrow,
            &middle,
            &narrow,
            &wide,
            &middle,
            &Mesh::default(),
            &narrow,
        ] {
            assert!(builder.build_into(mesh, &mut bvh).is_ok());
            assert!(Bytes::of(&bvh) == Bytes::of(&build_as(mesh, config)));
            assert_eq!(bvh.validate_over(mesh), Ok(()));
            bytes_of_all.push(bvh.triangle_bytes() / mesh.indices.len().max(1));
        }
        let expected = match (nodes, mesh) {
            (_, MeshCodec::F32) => [40, 40, 40, 40, 40, 0, 40],
            (NodeCodec::Wide(WideStore::Packed), _) => [11, 17, 11, 23, 17, 0, 11],
            _ => [16, 28, 16, 40, 28, 0, 16],
        };
        assert_eq!(bytes_of_all, expected, "{nodes:?}");
    }
}

/// A refit into another store or of another tree builds nodes anew, and loses no hit.
#[test]
fn every_tree_can_be_refitted_into_every_store() {
    let step_exponent = -12;
    let mut mesh = icosphere(glam::Vec3::new(0.5, -1.0, 2.0), 2.0, 3);
    mesh.snap(step_exponent);
    let all: Vec<BuildConfig> = wide_codecs(step_exponent)
        .into_iter()
        .chain([(NodeCodec::F32, MeshCodec::F32)])
        .map(|(nodes, mesh)| BuildConfig {
            nodes,
            mesh,
            ..BuildConfig::default()
        })
        .collect();
    for from in &all {
        for to in &all {
            let mut bvh = build_as(&mesh, *from);
            assert!(Builder::new(*to).refit(&mesh, &mut bvh).is_ok());
            assert_eq!(bvh.codecs(), (to.nodes, to.mesh));
            assert_eq!(bvh.validate_over(&mesh), Ok(()), "{from:?} {to:?}");
            for to in mesh.vertices.iter().step_by(7) {
                let ray = slimbvh::Ray::new([0.5, -1.0, 2.0], [0, 1, 2].map(|i| to[i] - 0.3));
                let expected = build_as(&mesh, *from).closest_hit(ray);
                assert_eq!(bvh.closest_hit(ray), expected);
            }
        }
    }
}

/// A hierarchy that was never built has no triangles, in any store.
#[test]
fn what_was_never_built_can_be_refitted() {
    for (nodes, mesh) in wide_codecs(0) {
        let mut bvh = Bvh::default();
        let mut builder = Builder::new(BuildConfig {
            nodes,
            mesh,
            ..BuildConfig::default()
        });
        for _ in 0..2 {
            assert!(builder.refit(&Mesh::default(), &mut bvh).is_ok());
            let ray = slimbvh::Ray::new([0.0; 3], [1.0, 0.0, 0.0]);
            assert!(!bvh.closest_hit(ray).is_hit() && bvh.validate().is_ok());
        }
    }
}

/// Every size of tree around one leaf, in every store.
#[test]
fn trees_of_every_small_size_are_stored() {
    for count in 0..=40 {
        let mesh = snapped(&soup(count, 5), -12);
        for config in trees() {
            for (nodes, codec) in wide_codecs(-12) {
                let config = BuildConfig {
                    nodes,
                    mesh: codec,
                    ..config
                };
                let bvh = build_as(&mesh, config);
                assert_eq!(bvh.validate_over(&mesh), Ok(()), "{count} {nodes:?}");
                let plain = build_as(
                    &mesh,
                    BuildConfig {
                        nodes: NodeCodec::F32,
                        mesh: MeshCodec::F32,
                        ..config
                    },
                );
                let alone = Alone::new(&plain, &plain, codec);
                assert!(
                    alone.bytes((nodes, codec)) == Bytes::of(&bvh),
                    "{count} {nodes:?}"
                );
            }
        }
    }
}
