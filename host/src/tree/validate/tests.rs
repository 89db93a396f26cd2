//! Planted faults: every kind is found, in plain trees and in trees in codecs.

use super::*;
use crate::generate::icosphere;
use crate::tree::StoredTree;
use crate::tree::lattice::LatticeMesh;
use crate::tree::paper10::Paper10Mesh;
use crate::tree::plain::PlainTree;
use crate::tree::wide::WideList;
use crate::{BuildConfig, Builder, MeshCodec, NodeCodec, WideStore};
use glam::Vec3;
use slimbvh_core::trace::{BruteForce, LeafTriangles, Skip, closest_hit};
use slimbvh_core::{Hit, Node, Ray};

#[cfg(feature = "lab")]
mod parent_frame;
mod wide;

const STEP: i32 = -12;

fn mesh() -> Mesh {
    let mut mesh = icosphere(Vec3::new(0.1, 0.2, 0.3), 1.0, 2);
    mesh.snap(STEP);
    mesh
}

fn built(nodes: NodeCodec, codec: MeshCodec) -> Bvh {
    let config = BuildConfig {
        nodes,
        mesh: codec,
        ..BuildConfig::default()
    };
    let bvh = Builder::new(config).build(&mesh()).expect("it is sound");
    assert_eq!(bvh.validate(), Ok(()));
    assert_eq!(bvh.validate_over(&mesh()), Ok(()));
    bvh
}

fn plain() -> Bvh {
    built(NodeCodec::F32, MeshCodec::F32)
}

/// Nodes and triangles of a plain tree.
fn lists(bvh: &mut Bvh) -> &mut PlainTree {
    match &mut bvh.stored {
        StoredTree::Plain(plain) => plain,
        _ => panic!("the tree is plain"),
    }
}

/// The fault found in a plain tree after this change.
#[track_caller]
fn found(spoil: impl Fn(&mut Bvh)) -> TreeError {
    let mut bvh = plain();
    spoil(&mut bvh);
    bvh.validate().expect_err("a fault was planted")
}

/// The first node with children of this kind.
fn with_children(bvh: &Bvh, leaves: [bool; 2]) -> usize {
    let is_of_kind = |node: &Node| [node.left.is_leaf(), node.right.is_leaf()] == leaves;
    let place = bvh.nodes().iter().position(is_of_kind);
    place.expect("the tree has all kinds of nodes")
}

#[test]
fn faults_beside_the_nodes_are_found() {
    assert_eq!(Bvh::default().validate(), Err(TreeError::NoRoot));
    assert_eq!(found(|bvh| lists(bvh).nodes.clear()), TreeError::NoRoot);
    assert_eq!(found(|bvh| bvh.bounds = None), TreeError::Bounds);
    let nan = |bvh: &mut Bvh| {
        if let Some(bounds) = &mut bvh.bounds {
            bounds.max.y = f32::NAN;
        }
    };
    assert_eq!(found(nan), TreeError::Bounds);
    let exponent = found(|bvh| bvh.scene_exponent += 1);
    assert!(matches!(exponent, TreeError::SceneExponent { .. }));
    let bound = found(|bvh| bvh.depth_bound = STACK_SIZE as u32);
    assert!(matches!(bound, TreeError::DepthBound { .. }));
    let deep = found(|bvh| bvh.depth_bound = 4);
    assert!(matches!(deep, TreeError::TooDeep { bound: 4, .. }));
    let few = found(|bvh| bvh.mesh_triangle_count = 319);
    assert!(matches!(few, TreeError::TriangleCount { .. }));
    let many = found(|bvh| bvh.mesh_triangle_count = usize::MAX);
    assert!(matches!(many, TreeError::TriangleCount { .. }));
}

#[test]
fn faults_of_links_are_found() {
    let bvh = plain();
    let count = bvh.nodes().len() as u32;
    for leaves in [[false, false], [false, true], [true, false]] {
        let node = with_children(&bvh, leaves);
        for child in [0, 1, count - 1, count, u32::MAX >> 1] {
            let spoil = |bvh: &mut Bvh, is_left: bool| {
                let node = &mut lists(bvh).nodes[node];
                let link = if is_left {
                    &mut node.left
                } else {
                    &mut node.right
                };
                let is_changed = *link != NodeRef::inner(child);
                *link = NodeRef::inner(child);
                is_changed
            };
            for is_left in [true, false] {
                let mut bvh = plain();
                if spoil(&mut bvh, is_left) {
                    let error = bvh.validate().expect_err("a fault was planted");
                    assert!(
                        matches!(
                            error,
                            TreeError::ChildOutOfPlace { .. } | TreeError::NoParent { .. }
                        ),
                        "{error}"
                    );
                }
            }
        }
    }
    // Whole nodes duplicated, exchanged, or unreachable.
    let both = with_children(&bvh, [false, false]);
    let swap = found(|bvh| {
        let node = &mut lists(bvh).nodes[both];
        std::mem::swap(&mut node.left, &mut node.right);
    });
    assert!(matches!(swap, TreeError::ChildOutOfPlace { .. }));
    let orphan = found(|bvh| lists(bvh).nodes.push(Node::EMPTY));
    assert!(matches!(
        orphan,
        TreeError::NoParent { .. } | TreeError::ChildOutOfPlace { .. }
    ));
    let cut = found(|bvh| {
        lists(bvh).nodes.pop();
    });
    assert!(matches!(cut, TreeError::ChildOutOfPlace { .. }));
}

#[test]
fn faults_of_leaves_are_found() {
    let bvh = plain();
    let node = with_children(&bvh, [true, true]);
    let left = bvh.nodes()[node].left;
    let with_left = |leaf| found(|bvh| lists(bvh).nodes[node].left = leaf);
    let (first, count) = (left.first(), left.count());
    for (leaf, is_size) in [
        (NodeRef::leaf(first, 0), true),
        (NodeRef::leaf(first, 7), true),
        (NodeRef::leaf(first + 1, count), false),
        (NodeRef::leaf(MAX_TRIANGLES - 1, count), false),
    ] {
        match with_left(leaf) {
            TreeError::LeafSize { .. } => assert!(is_size),
            TreeError::BoxTooSmall { .. } | TreeError::PlaceCount { .. } => assert!(!is_size),
            other => panic!("{other}"),
        }
    }
    let node_with_two = bvh
        .nodes()
        .iter()
        .position(|node| node.left.is_leaf() && node.left.count() > 1 && !node.right.is_leaf());
    let node_with_two = node_with_two.expect("there is one");
    let short = found(|bvh| {
        let left = &mut lists(bvh).nodes[node_with_two].left;
        *left = NodeRef::leaf(left.first(), left.count() - 1);
    });
    assert!(matches!(short, TreeError::LeafOutOfPlace { .. }), "{short}");
    let late = found(|bvh| {
        // All boxes contain the whole scene.
        for node in &mut lists(bvh).nodes {
            node.planes = [[-1.0, -1.0, 1.0, 1.0]; 3];
        }
        lists(bvh).nodes[node].left = NodeRef::leaf(first + 1, count);
    });
    assert!(
        matches!(
            late,
            TreeError::LeafOutOfPlace { .. } | TreeError::BadPrimitive { .. }
        ),
        "{late}"
    );
    let fewer = found(|bvh| {
        lists(bvh).triangles.pop();
    });
    assert!(matches!(fewer, TreeError::PlaceCount { .. }));
    let more = found(|bvh| {
        let triangles = &mut lists(bvh).triangles;
        triangles.push(triangles[0]);
        bvh.mesh_triangle_count += 1;
    });
    assert!(matches!(more, TreeError::PlaceCount { .. }));
    let run = found(|bvh| lists(bvh).nodes[node].last += 1);
    assert!(matches!(run, TreeError::WrongRun { .. }));
    let run = found(|bvh| lists(bvh).nodes[0].first = 1);
    assert!(matches!(run, TreeError::WrongRun { node: 0, .. }));
}

#[test]
fn faults_of_triangles_are_found() {
    let twice = found(|bvh| {
        let triangles = &mut lists(bvh).triangles;
        triangles[7].primitive = triangles[6].primitive;
    });
    assert!(matches!(twice, TreeError::BadPrimitive { .. }));
    for primitive in [320, 383, u32::MAX] {
        let beyond = found(|bvh| lists(bvh).triangles[7].primitive = primitive);
        assert_eq!(
            beyond,
            TreeError::BadPrimitive {
                place: 7,
                primitive
            }
        );
    }
    for x in [f32::NAN, f32::INFINITY, -f32::INFINITY] {
        let error = found(|bvh| lists(bvh).triangles[9].vertices[4] = x);
        assert_eq!(error, TreeError::NotFinite { place: 9 });
    }
    // Moved within the box: only a comparison with the mesh finds it.
    let mut bvh = plain();
    let vertices = &mut lists(&mut bvh).triangles[9].vertices;
    vertices[0] = 0.5 * (vertices[0] + vertices[3]);
    assert_eq!(bvh.validate(), Ok(()));
    let primitive = bvh.leaf_triangles()[9].primitive;
    let error = TreeError::OtherCorners {
        place: 9,
        primitive,
    };
    assert_eq!(bvh.validate_over(&mesh()), Err(error));
}

#[test]
fn another_mesh_is_found() {
    let bvh = plain();
    let mut other = mesh();
    other.indices.pop();
    assert!(matches!(
        bvh.validate_over(&other),
        Err(TreeError::OtherMesh { .. })
    ));
    let mut other = mesh();
    for vertex in &mut other.vertices {
        vertex[1] += 1.0;
    }
    assert_eq!(bvh.validate_over(&other), Err(TreeError::OtherBounds));
}

/// Each plane of each node, moved by one bit inward and outward, and replaced by invalid numbers.
#[test]
fn faults_of_boxes_are_found() {
    let sound = plain();
    for node in 0..sound.nodes().len() {
        for (axis, lane) in (0..3).flat_map(|axis| (0..4).map(move |lane| (axis, lane))) {
            let with = |change: &dyn Fn(f32) -> f32| {
                let mut bvh = sound.clone();
                let plane = &mut lists(&mut bvh).nodes[node].planes[axis][lane];
                *plane = change(*plane);
                bvh.validate()
            };
            let is_min = lane < 2;
            let inward = |x: f32| if is_min { x.next_up() } else { x.next_down() };
            let outward = |x: f32| if is_min { x.next_down() } else { x.next_up() };
            let node = node as u32;
            let small = with(&inward);
            assert!(
                small == Err(TreeError::BoxTooSmall { node })
                    || small == Err(TreeError::BadBox { node }),
                "{small:?}"
            );
            assert_eq!(with(&outward), Ok(()));
            for x in [f32::NAN, f32::INFINITY, -f32::INFINITY, f32::MAX, -2.0, 2.0] {
                let error = with(&|_| x);
                assert!(error.is_err(), "{x}");
            }
        }
    }
}

/// A tree in each pair of codecs but that in full.
fn coded() -> Vec<Bvh> {
    let mut all = Vec::new();
    for mesh in MeshCodec::ALL.map(|mesh| mesh.with_step(Some(STEP))) {
        let nodes = mesh.nodes().filter(|nodes| *nodes != NodeCodec::F32);
        all.extend(nodes.map(|nodes| built(nodes, mesh)));
    }
    all
}

/// A tree of each store of wide nodes and each codec of triangles that goes with it.
fn wide() -> [Bvh; 4] {
    let on_lattice = MeshCodec::Lattice {
        step_exponent: STEP,
    };
    [
        (WideStore::Full, MeshCodec::F32),
        (WideStore::Exact, MeshCodec::F32),
        (WideStore::Exact, on_lattice),
        (WideStore::Packed, on_lattice),
    ]
    .map(|(store, mesh)| built(NodeCodec::Wide(store), mesh))
}

/// Flips bits of nodes and triangles in codecs. Nothing panics. A tree that passes answers to the bit as before: only
/// planes may lie further out, and unused bits may change. Triangles coded by floats in their leaf's box may move within
/// it; then the tree answers as a brute-force search of its triangles.
#[test]
fn each_bit_of_coded_trees_is_looked_at() {
    let mesh = mesh();
    let eye = [1.5, 2.5, 2.0];
    let rays = mesh.vertices.iter().step_by(5);
    let rays: Vec<Ray> = rays
        .map(|to| Ray::new(eye, [0, 1, 2].map(|axis| to[axis] - eye[axis])))
        .collect();
    let answers = |bvh: &Bvh| -> Vec<Hit> {
        let all = rays.iter().map(|ray| bvh.closest_hit(ray));
        all.collect()
    };
    let all_of = |bvh: &Bvh| -> Vec<Hit> {
        let triangles = bvh.stored.decode().triangles;
        let nodes = BruteForce(triangles.len() as u32);
        let triangles = LeafTriangles(&triangles);
        let all = rays.iter().map(|ray| {
            let exponent = bvh.scene_exponent;
            closest_hit(&nodes, &triangles, ray, exponent, &Skip::NONE)
        });
        all.collect()
    };
    for sound in coded() {
        let (nodes, triangles) = words(&sound);
        let expected = answers(&sound);
        for (is_node, words) in [(true, nodes), (false, triangles)] {
            let bits = (0..32 * words).step_by(if is_node { 1 } else { 7 });
            let mut found = 0;
            for bit in bits.clone() {
                let mut bvh = sound.clone();
                flip(&mut bvh, is_node, bit);
                if bvh.validate_over(&mesh).is_err() {
                    found += 1;
                } else if sound.codecs().1 == MeshCodec::Leaf10 {
                    assert_eq!(answers(&bvh), all_of(&bvh), "{bit}");
                } else {
                    assert_eq!(answers(&bvh), expected, "{:?} {bit}", sound.codecs());
                }
            }
            let all = bits.count();
            let share = if is_node { 4 } else { 2 };
            assert!(found * share >= all, "{:?} {found} {all}", sound.codecs());
        }
    }
}

/// The words of nodes and of coded triangles.
fn words(bvh: &Bvh) -> (usize, usize) {
    let [nodes, triangles] = bvh.stored().map(|bytes| bytes.len() / 4);
    let is_full = bvh.codecs().1 == MeshCodec::F32;
    (nodes, if is_full { 0 } else { triangles })
}

fn flip(bvh: &mut Bvh, is_node: bool, bit: usize) {
    let [nodes, triangles]: [&mut [u32]; 2] = match &mut bvh.stored {
        StoredTree::Plain(_) => [&mut [], &mut []],
        StoredTree::Paper10(tree) => [
            bytemuck::cast_slice_mut(&mut tree.nodes),
            match &mut tree.triangles {
                Paper10Mesh::Leaf10(triangles) => bytemuck::cast_slice_mut(triangles),
                Paper10Mesh::Full(_) => &mut [],
            },
        ],
        StoredTree::Wide(tree) => [
            match &mut tree.nodes {
                WideList::Full(nodes) => bytemuck::cast_slice_mut(nodes),
                WideList::Exact(nodes) => bytemuck::cast_slice_mut(nodes),
                WideList::Packed(nodes) => bytemuck::cast_slice_mut(nodes),
            },
            words_on_lattice(&mut tree.triangles),
        ],
        #[cfg(feature = "lab")]
        StoredTree::Lattice(tree) => [&mut tree.words, words_on_lattice(&mut tree.triangles)],
    };
    let words = if is_node { nodes } else { triangles };
    words[bit / 32] ^= 1 << (bit % 32);
}

fn words_on_lattice(triangles: &mut LatticeMesh) -> &mut [u32] {
    match triangles {
        LatticeMesh::Lattice { words, .. } => words,
        LatticeMesh::Full(_) => &mut [],
    }
}
