//! Negative controls: the checks must find planted faults.

use glam::Vec3;
use slimbvh::generate::icosphere;
use slimbvh::{CodeBits, Mesh};
use slimbvh_core::{Aabb, LeafTriangle, Node, NodeRef, Ray};
use slimbvh_tests::build;
use slimbvh_tests::oracle::brute::Parts;
use slimbvh_tests::validate::{Fault, validate_order, validate_shape};

/// A tree in which faults can be planted.
struct Tree {
    mesh: Mesh,
    nodes: Vec<Node>,
    triangles: Vec<LeafTriangle>,
    scene_exponent: i32,
    depth_bound: u32,
}

impl Tree {
    fn new() -> Self {
        let mesh = icosphere(Vec3::new(0.1, 0.2, 0.3), 1.0, 2);
        let bvh = build(&mesh, CodeBits::Bits30);
        let tree = Self {
            nodes: bvh.nodes().to_vec(),
            triangles: bvh.leaf_triangles().to_vec(),
            scene_exponent: bvh.scene_exponent(),
            depth_bound: bvh.depth_bound(),
            mesh,
        };
        assert_eq!(tree.fault(), None);
        assert!(tree.agrees_with_brute_force());
        tree
    }

    fn fault(&self) -> Option<Fault> {
        validate_shape(&self.nodes, &self.triangles, self.depth_bound)
            .err()
            .or_else(|| {
                validate_order(&self.nodes, &self.triangles, &self.mesh, CodeBits::Bits30).err()
            })
    }

    /// Rays along each triangle's normal at its corners and its middle, with a short range around the surface.
    fn agrees_with_brute_force(&self) -> bool {
        let rays: Vec<Ray> = self
            .mesh
            .indices
            .iter()
            .flat_map(|face| {
                let [a, b, c] = face.map(|v| Vec3::from(self.mesh.vertices[v as usize]));
                let normal = (b - a).cross(c - a).normalize();
                [a, b, c, (a + b + c) / 3.0].map(|target| Ray {
                    t_min: 0.999,
                    t_max: 1.001,
                    ..Ray::new((target + normal).to_array(), (-normal).to_array())
                })
            })
            .collect();
        let parts = Parts {
            nodes: &self.nodes,
            triangles: &self.triangles,
            scene_exponent: self.scene_exponent,
        };
        parts.compare(&rays).is_ok()
    }

    /// The first node with an inner node as its left child.
    fn with_inner_left(&self) -> usize {
        let found = self.nodes.iter().position(|node| !node.left.is_leaf());
        found.unwrap_or_else(|| panic!("the tree has inner nodes"))
    }

    /// The first node with a leaf as its left child.
    fn with_leaf_left(&self) -> usize {
        let found = self.nodes.iter().position(|node| node.left.is_leaf());
        found.unwrap_or_else(|| panic!("the tree has leaves"))
    }
}

fn shrunk(bounds: Aabb) -> Aabb {
    Aabb {
        max: bounds.min.lerp(bounds.max, 0.5),
        ..bounds
    }
}

#[test]
fn a_shrunk_box_changes_answers_and_is_found() {
    let sound = Tree::new();
    for node in 0..sound.nodes.len() {
        for shrink_left in [true, false] {
            let mut tree = Tree::new();
            let (left, right) = (tree.nodes[node].left_box(), tree.nodes[node].right_box());
            tree.nodes[node] = if shrink_left {
                tree.nodes[node].with_boxes(shrunk(left), right)
            } else {
                tree.nodes[node].with_boxes(left, shrunk(right))
            };
            let node = node as u32;
            assert_eq!(tree.fault(), Some(Fault::BoxTooSmall { node }));
            assert!(!tree.agrees_with_brute_force(), "node {node}");
        }
    }
}

#[test]
fn a_grown_box_changes_no_answer_and_is_found() {
    let mut tree = Tree::new();
    let (left, mut right) = (tree.nodes[3].left_box(), tree.nodes[3].right_box());
    right.max.y = slimbvh_core::float::next_up(right.max.y);
    tree.nodes[3] = tree.nodes[3].with_boxes(left, right);
    assert_eq!(tree.fault(), Some(Fault::BoxTooLarge { node: 3 }));
    assert!(tree.agrees_with_brute_force());
}

#[test]
fn faults_of_structure_are_found() {
    let sound = Tree::new();
    let (inner, leafy) = (sound.with_inner_left(), sound.with_leaf_left());
    let node_count = sound.nodes.len() as u32;
    let plant = |spoil: &dyn Fn(&mut Tree)| {
        let mut tree = Tree::new();
        spoil(&mut tree);
        tree.fault()
    };

    let beyond = plant(&|tree| tree.nodes[inner].left = NodeRef::inner(node_count));
    assert!(matches!(beyond, Some(Fault::NoSuchNode { .. })));

    let twice = plant(&|tree| {
        tree.nodes[inner].left = NodeRef::inner(0);
        tree.nodes[inner].right = NodeRef::inner(0);
    });
    assert!(twice.is_some());

    let orphan = plant(&|tree| tree.nodes.push(Node::EMPTY));
    assert_eq!(orphan, Some(Fault::NoParent { node: node_count }));

    let short_run = plant(&|tree| tree.nodes[leafy].last -= 1);
    assert!(matches!(short_run, Some(Fault::WrongRun { .. })));

    let lost = plant(&|tree| {
        let left = tree.nodes[leafy].left;
        tree.nodes[leafy].left = NodeRef::leaf(left.first(), left.count() - 1);
    });
    assert!(matches!(
        lost,
        Some(Fault::WrongRun { .. } | Fault::WrongCount { .. })
    ));

    let swapped = plant(&|tree| {
        let node = tree.nodes[inner];
        (tree.nodes[inner].left, tree.nodes[inner].right) = (node.right, node.left);
    });
    assert!(matches!(swapped, Some(Fault::WrongRun { .. })));

    let shallow = plant(&|tree| tree.depth_bound = 3);
    assert_eq!(shallow, Some(Fault::TooDeep { bound: 3 }));
}

#[test]
fn faults_of_order_are_found() {
    let plant = |spoil: &dyn Fn(&mut Vec<LeafTriangle>)| {
        let tree = Tree::new();
        let mut triangles = tree.triangles.clone();
        spoil(&mut triangles);
        validate_order(&tree.nodes, &triangles, &tree.mesh, CodeBits::Bits30).err()
    };
    let swapped = plant(&|triangles| triangles.swap(10, 11));
    assert_eq!(swapped, Some(Fault::OutOfOrder { place: 11 }));

    let twice = plant(&|triangles| triangles[5] = triangles[4]);
    assert!(matches!(
        twice,
        Some(Fault::NotAPermutation { place: 5, .. })
    ));

    let beyond = plant(&|triangles| triangles[5].primitive = u32::MAX);
    assert!(matches!(
        beyond,
        Some(Fault::NotAPermutation { place: 5, .. })
    ));

    let missing = plant(&|triangles| {
        triangles.pop();
    });
    assert!(matches!(missing, Some(Fault::NotAPermutation { .. })));

    let moved = plant(&|triangles| triangles[7].vertices[4] += 0.25);
    assert_eq!(moved, Some(Fault::WrongCorners { place: 7 }));
}

#[test]
fn a_node_divided_elsewhere_is_found() {
    // Moving the border between two leaves breaks only the split; the shape stays sound.
    let tree = Tree::new();
    let small = tree.nodes.iter().position(|node| {
        node.left.is_leaf()
            && node.right.is_leaf()
            && node.left.count() > 1
            && node.right.count() < 4
    });
    let index = small.unwrap_or_else(|| panic!("the tree has a node of two small leaves"));
    let mut nodes = tree.nodes.clone();
    let (left, right) = (nodes[index].left, nodes[index].right);
    nodes[index].left = NodeRef::leaf(left.first(), left.count() - 1);
    nodes[index].right = NodeRef::leaf(right.first() - 1, right.count() + 1);
    let fault = validate_order(&nodes, &tree.triangles, &tree.mesh, CodeBits::Bits30);
    assert_eq!(fault, Err(Fault::WrongSplit { node: index as u32 }));
}
