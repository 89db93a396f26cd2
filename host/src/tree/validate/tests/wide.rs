//! Planted faults in wide trees.

use super::{STEP, built, wide};
use crate::tree::StoredTree;
use crate::tree::lattice::LatticeMesh;
use crate::tree::wide::{WideList, WideTree};
use crate::{Bvh, MeshCodec, NodeCodec, TreeError, WideStore};
use slimbvh_core::NodeRef;
use slimbvh_core::encode::{FullWideNode, PackedWideNode, WideAxis, WideNode};

fn tree(bvh: &mut Bvh) -> &mut WideTree {
    match &mut bvh.stored {
        StoredTree::Wide(tree) => tree,
        _ => panic!("the tree is wide"),
    }
}

fn full(bvh: &mut Bvh) -> &mut Vec<FullWideNode> {
    match &mut tree(bvh).nodes {
        WideList::Full(nodes) => nodes,
        _ => panic!("nodes are in full"),
    }
}

fn exact(bvh: &mut Bvh) -> &mut Vec<WideNode> {
    match &mut tree(bvh).nodes {
        WideList::Exact(nodes) => nodes,
        _ => panic!("nodes have 64 bytes"),
    }
}

fn packed(bvh: &mut Bvh) -> &mut Vec<PackedWideNode> {
    match &mut tree(bvh).nodes {
        WideList::Packed(nodes) => nodes,
        _ => panic!("nodes have 48 bytes"),
    }
}

/// The references of any node.
fn children(bvh: &mut Bvh, node: usize) -> [NodeRef; 4] {
    match &tree(bvh).nodes {
        WideList::Full(nodes) => nodes[node].children,
        WideList::Exact(nodes) => nodes[node].children,
        WideList::Packed(nodes) => nodes[node].links().children(),
    }
}

/// The axes of a node on the lattice.
fn axes(bvh: &mut Bvh, node: usize) -> &mut [WideAxis; 3] {
    match &mut tree(bvh).nodes {
        WideList::Full(_) => panic!("nodes are on the lattice"),
        WideList::Exact(nodes) => &mut nodes[node].axes,
        WideList::Packed(nodes) => &mut nodes[node].axes,
    }
}

/// The fault found in a tree after this change.
#[track_caller]
fn found(sound: &Bvh, spoil: impl FnOnce(&mut Bvh)) -> TreeError {
    let mut bvh = sound.clone();
    spoil(&mut bvh);
    bvh.validate().expect_err("a fault was planted")
}

/// A node whose children are as a function asks.
fn node_with(bvh: &Bvh, is_asked: impl Fn(&[NodeRef; 4]) -> bool) -> usize {
    let mut bvh = bvh.clone();
    let mut nodes = 0..bvh.node_count();
    let found = nodes.find(|&node| is_asked(&children(&mut bvh, node)));
    found.expect("the tree has all kinds of nodes")
}

/// A node with fewer than four children, and one with an inner child that is not the root.
fn bottom(bvh: &Bvh) -> usize {
    node_with(bvh, |children| children[3] == NodeRef::EMPTY_LEAF)
}

fn inner(bvh: &Bvh) -> usize {
    let two = |children: &[NodeRef; 4]| children.iter().filter(|child| !child.is_leaf()).count();
    node_with(bvh, |children| two(children) >= 2)
}

#[test]
fn faults_of_lists_are_found() {
    for sound in wide() {
        let more = found(&sound, |bvh| match &mut tree(bvh).nodes {
            WideList::Full(nodes) => nodes.push(nodes[1]),
            WideList::Exact(nodes) => nodes.push(nodes[1]),
            WideList::Packed(nodes) => nodes.push(nodes[1]),
        });
        let node = sound.node_count() as u32;
        assert_eq!(more, TreeError::NoParent { node });
        let fewer = found(&sound, |bvh| match &mut tree(bvh).nodes {
            WideList::Full(nodes) => drop(nodes.pop()),
            WideList::Exact(nodes) => drop(nodes.pop()),
            WideList::Packed(nodes) => drop(nodes.pop()),
        });
        assert!(
            matches!(fewer, TreeError::ChildOutOfPlace { .. }),
            "{fewer}"
        );
        let few = found(&sound, |bvh| match &mut tree(bvh).triangles {
            LatticeMesh::Full(triangles) => drop(triangles.pop()),
            LatticeMesh::Lattice { words, .. } => drop(words.pop()),
        });
        assert!(matches!(few, TreeError::PlaceCount { .. }), "{few}");
        let long = found(&sound, |bvh| match &mut tree(bvh).triangles {
            LatticeMesh::Full(triangles) => triangles.push(triangles[0]),
            LatticeMesh::Lattice { words, .. } => words.push(7),
        });
        assert!(
            matches!(
                long,
                TreeError::PlaceCount { .. } | TreeError::TriangleCount { .. }
            ),
            "{long}"
        );
        let height = found(&sound, |bvh| bvh.depth_bound = 3);
        assert!(
            matches!(
                height,
                TreeError::TooDeep { .. } | TreeError::TooHigh { .. }
            ),
            "{height}"
        );
    }
}

/// A wide tree of few levels stands for a binary one of more: decoded, that must not be too deep either.
#[test]
fn a_tree_that_is_too_high_when_decoded_is_found() {
    for sound in wide() {
        let mut levels = 0;
        let mut bound = sound.clone();
        while matches!(bound.validate(), Err(TreeError::TooDeep { .. }) | Ok(())) && levels < 99 {
            bound.depth_bound = levels;
            levels += 1;
        }
        assert!(
            matches!(bound.validate(), Err(TreeError::TooHigh { .. })),
            "{levels}"
        );
        let decoded = sound.decoded();
        let is_sound = |bound: u32| {
            let depth_bound = bound;
            Bvh {
                depth_bound,
                ..decoded.clone()
            }
            .validate()
            .is_ok()
        };
        let height = (0..).find(|&bound| is_sound(bound));
        let lowest = (0..).find(|&depth_bound| {
            let bvh = Bvh {
                depth_bound,
                ..sound.clone()
            };
            bvh.validate().is_ok()
        });
        assert_eq!(height, lowest);
    }
}

#[test]
fn faults_of_children_are_found() {
    for sound in wide() {
        let count = sound.node_count() as u32;
        let node = inner(&sound);
        let own = children(&mut sound.clone(), node);
        let places: Vec<usize> = (0..4).filter(|&i| !own[i].is_leaf()).collect();
        if let WideList::Packed(_) = tree(&mut sound.clone()).nodes {
            continue;
        }
        let with = |place: usize, child: NodeRef| {
            found(&sound, |bvh| match &mut tree(bvh).nodes {
                WideList::Full(nodes) => nodes[node].children[place] = child,
                WideList::Exact(nodes) => nodes[node].children[place] = child,
                WideList::Packed(_) => {}
            })
        };
        for child in [0, node as u32, count - 1, count, u32::MAX >> 1] {
            let child = NodeRef::inner(child);
            if child != own[places[0]] {
                let error = with(places[0], child);
                assert!(
                    matches!(error, TreeError::ChildOutOfPlace { .. }),
                    "{error}"
                );
            }
        }
        let twice = with(places[1], own[places[0]]);
        assert!(
            matches!(twice, TreeError::ChildOutOfPlace { .. }),
            "{twice}"
        );
        let gap = with(1, NodeRef::EMPTY_LEAF);
        assert!(matches!(gap, TreeError::BadLinks { .. }), "{gap}");
        let none = with(0, NodeRef::EMPTY_LEAF);
        assert!(matches!(none, TreeError::BadLinks { .. }), "{none}");
        let seven = with(places[0], NodeRef::leaf(0, 7));
        assert!(
            matches!(
                seven,
                TreeError::LeafSize { count: 7, .. } | TreeError::LeafOutOfPlace { .. }
            ),
            "{seven}"
        );
    }
}

#[test]
fn faults_of_runs_and_padding_are_found() {
    let sound = built(NodeCodec::Wide(WideStore::Full), MeshCodec::F32);
    let (node, bottom) = (inner(&sound), bottom(&sound));
    let run = found(&sound, |bvh| full(bvh)[node].last += 1);
    assert!(matches!(run, TreeError::WrongRun { .. }), "{run}");
    let run = found(&sound, |bvh| full(bvh)[0].first = 1);
    assert!(matches!(run, TreeError::WrongRun { node: 0, .. }), "{run}");
    let padding = found(&sound, |bvh| full(bvh)[node].padding[1] = 1);
    assert!(matches!(padding, TreeError::BadFrame { .. }), "{padding}");
    for (axis, lane) in [(0, 3), (1, 7), (2, 3)] {
        let absent = found(&sound, |bvh| full(bvh)[bottom].planes[axis][lane] = 0.0);
        assert!(matches!(absent, TreeError::BadFrame { .. }), "{absent}");
    }
    for x in [f32::NAN, f32::INFINITY, -2.0, 2.0] {
        let plane = found(&sound, |bvh| full(bvh)[node].planes[1][4] = x);
        assert!(
            matches!(
                plane,
                TreeError::BadBox { .. } | TreeError::BoxTooSmall { .. }
            ),
            "{plane}"
        );
    }
}

#[test]
fn faults_of_frames_are_found() {
    for sound in wide().into_iter().skip(1) {
        let (node, bottom) = (inner(&sound), bottom(&sound));
        let is_packed = sound.codecs().0 == NodeCodec::Wide(WideStore::Packed);
        for axis in 0..3 {
            let spoilt = |node: usize, spoil: &dyn Fn(&mut WideAxis)| {
                found(&sound, |bvh| spoil(&mut axes(bvh, node)[axis]))
            };
            let is_frame = |error: TreeError| matches!(error, TreeError::BadFrame { .. });
            for x in [f32::NAN, f32::INFINITY, 1e-30, -0.0, -1.5] {
                let error = spoilt(node, &|axis| axis.origin = x);
                assert!(is_frame(error), "{x} {error}");
            }
            // Off the lattice, or, on the finest, a step further in.
            let origin = spoilt(node, &|axis| axis.origin = axis.origin.next_up());
            assert!(is_frame(origin) || origin == TreeError::BoxTooSmall { node: node as u32 });
            assert!(is_frame(spoilt(node, &|axis| axis.scale |= 31)));
            if !is_packed {
                let shift = spoilt(node, &|axis| axis.scale += 1);
                assert!(is_frame(shift), "{shift}");
                let extent = spoilt(node, &|axis| axis.scale += axis.extent() << 5);
                assert!(is_frame(extent), "{extent}");
                let extent = spoilt(node, &|axis| axis.scale = 1 | ((1 << 25) + 2) << 5);
                assert!(is_frame(extent), "{extent}");
            }
            // A child that is not there.
            for bit in [0, 7] {
                assert!(is_frame(
                    spoilt(bottom, &|axis| axis.lower ^= 1 << (24 + bit))
                ));
                assert!(is_frame(
                    spoilt(bottom, &|axis| axis.upper ^= 1 << (24 + bit))
                ));
            }
            // A child's planes, exchanged or moved inward.
            let inverted = spoilt(node, &|axis| {
                axis.lower |= 0xff;
                if is_packed {
                    axis.upper &= !0xff;
                } else {
                    axis.upper |= 0xff;
                }
            });
            assert!(
                matches!(
                    inverted,
                    TreeError::BadBox { .. } | TreeError::BoxTooSmall { .. }
                ),
                "{inverted}"
            );
        }
        let root = found(&sound, |bvh| tree(bvh).root.max[1] -= 1);
        assert!(
            matches!(
                root,
                TreeError::BoxTooSmall { .. } | TreeError::BadBox { .. }
            ),
            "{root}"
        );
        let root = found(&sound, |bvh| tree(bvh).root.min[2] += 1);
        assert_eq!(root, TreeError::BadFrame { node: 0 });
        let root = found(&sound, |bvh| tree(bvh).root.max[0] = 1 << 24);
        assert_eq!(root, TreeError::RootBox);
        let step = found(&sound, |bvh| tree(bvh).step_exponent = 128);
        assert_eq!(step, TreeError::Step { step_exponent: 128 });
    }
}

#[test]
fn faults_of_words_are_found() {
    let codec = MeshCodec::Lattice {
        step_exponent: STEP,
    };
    let sound = built(NodeCodec::Wide(WideStore::Exact), codec);
    let node = node_with(&sound, |children| {
        children[1..]
            .iter()
            .any(|child| child.count() > 0 && child.is_leaf())
            && children[0].is_leaf()
    });
    let later = found(&sound, |bvh| {
        let child = &mut exact(bvh)[node].children[0];
        *child = NodeRef::leaf(child.first() + 4, child.count());
    });
    assert!(matches!(later, TreeError::LeafOutOfPlace { .. }), "{later}");
    // All leaves of a node where those of another are.
    let twice = found(&sound, |bvh| {
        for child in &mut exact(bvh)[node].children {
            if child.count() > 0 && child.is_leaf() {
                *child = NodeRef::leaf(child.first() + 4, child.count());
            }
        }
    });
    assert!(
        matches!(
            twice,
            TreeError::TwoLeaves { .. }
                | TreeError::BadPrimitive { .. }
                | TreeError::BoxTooSmall { .. }
                | TreeError::PlaceCount { .. }
        ),
        "{twice}"
    );
}

#[test]
fn faults_of_packed_links_are_found() {
    let codec = MeshCodec::Lattice {
        step_exponent: STEP,
    };
    let sound = built(NodeCodec::Wide(WideStore::Packed), codec);
    let with_both = node_with(&sound, |children| {
        children[0].is_leaf() && children.iter().any(|child| !child.is_leaf())
    });
    let bottom = bottom(&sound);
    let spoilt = |node: usize, axis: usize, change: &dyn Fn(u32) -> u32| {
        found(&sound, |bvh| {
            let scale = &mut packed(bvh)[node].axes[axis].scale;
            *scale = change(*scale);
        })
    };
    // The first child's kind; the axes' bits of z: 5–6 width, 7–19 corners, from 20 kinds.
    let kind = |node: usize, kind: u32| spoilt(node, 2, &|z| z & !(7 << 20) | kind << 20);
    // No child before others, and an inner child in a leaf's place.
    let gap = kind(with_both, 0);
    assert!(matches!(gap, TreeError::BadLinks { .. }), "{gap}");
    let inner = kind(with_both, 7);
    assert!(inner != TreeError::NoRoot, "{inner}");
    // Widths: unknown, of no leaf, or of another width.
    let own = packed(&mut sound.clone())[with_both].links().width;
    for width in (0..=3).filter(|&width| width != own) {
        let error = spoilt(with_both, 2, &|z| z & !(3 << 5) | width << 5);
        assert!(error != TreeError::NoRoot, "{error}");
    }
    let unknown = spoilt(with_both, 2, &|z| z | 3 << 5);
    assert!(matches!(unknown, TreeError::BadLinks { .. }), "{unknown}");
    // Corners: of no child, more than the triangles have, and other ones.
    let of_none = spoilt(bottom, 1, &|y| y ^ 1 << 31);
    assert!(matches!(of_none, TreeError::BadLinks { .. }), "{of_none}");
    let many = spoilt(with_both, 2, &|z| z | 0xf << 7);
    assert!(matches!(many, TreeError::BadLinks { .. }), "{many}");
    let other = spoilt(with_both, 2, &|z| z ^ 1 << 7);
    assert!(other != TreeError::NoRoot, "{other}");
    // Runs elsewhere, and of nothing.
    for (axis, bit) in [(0, 5), (0, 31), (1, 5), (1, 27), (1, 28)] {
        let error = spoilt(with_both, axis, &|word| word ^ 1 << bit);
        assert!(
            matches!(
                error,
                TreeError::ChildOutOfPlace { .. }
                    | TreeError::TwoLeaves { .. }
                    | TreeError::PlaceCount { .. }
                    | TreeError::BoxTooSmall { .. }
                    | TreeError::BadPrimitive { .. }
                    | TreeError::BadCorners { .. }
            ),
            "{error}"
        );
    }
    let no_inner = node_with(&sound, |children| {
        children.iter().all(|child| child.is_leaf())
    });
    let idle = spoilt(no_inner, 1, &|word| word | 1 << 6);
    assert!(matches!(idle, TreeError::BadLinks { .. }), "{idle}");
}

/// A leaf that would be decoded to sound triangles, but that no build stores: every bit of its words counts.
#[test]
fn faults_of_shared_corners_are_found() {
    let codec = MeshCodec::Lattice {
        step_exponent: STEP,
    };
    let sound = built(NodeCodec::Wide(WideStore::Packed), codec);
    let node = node_with(&sound, |children| {
        children[0].is_leaf() && children[0].count() > 1
    });
    let leaf = children(&mut sound.clone(), node)[0];
    let halves = leaf.count() as usize / 2;
    let first = leaf.first() as usize;
    let words = |bvh: &mut Bvh| match &mut tree(bvh).triangles {
        LatticeMesh::Lattice { words, .. } => std::mem::take(words),
        LatticeMesh::Full(_) => panic!("triangles are on the lattice"),
    };
    let whole = words(&mut sound.clone());
    let mut numbered_otherwise = 0;
    for bit in 0..32 * halves {
        let error = found(&sound, |bvh| {
            let mut spoilt = words(bvh);
            spoilt[first + bit / 32] ^= 1 << (bit % 32);
            let count = bvh.triangle_count();
            tree(bvh).triangles = LatticeMesh::Lattice {
                words: spoilt,
                count,
            };
        });
        numbered_otherwise += u32::from(matches!(error, TreeError::BadCorners { .. }));
    }
    assert!(numbered_otherwise > 0, "of {halves} words");
    // A corner above its highest coordinate's bits.
    let at = first + halves + leaf.count() as usize;
    let error = found(&sound, |bvh| {
        let mut spoilt = words(bvh);
        spoilt[at] |= 1 << 31;
        let count = bvh.triangle_count();
        tree(bvh).triangles = LatticeMesh::Lattice {
            words: spoilt,
            count,
        };
    });
    let width = packed(&mut sound.clone())[node].links().width;
    assert!(
        width > 0 || matches!(error, TreeError::BadCorners { .. }),
        "{error}"
    );
    assert!(whole.len() > at);
}
