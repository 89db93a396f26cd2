//! What each way to store a hierarchy says of a node, a leaf and a triangle, for walks that visit all of it.

use super::TreeError;
use crate::Bvh;
use crate::codec::by_bits;
use crate::coded::{Coded, CodedNodes, CodedTriangles};
use slimbvh_core::encode::{
    LatticeBounds, LatticeTriangles, LeafWidth, Paper10Box, Paper10Node, Paper10Triangles,
    decode_node, decode_paper10_node, encode_paper10_triangle, links_of,
};
use slimbvh_core::float::power_of_two;
use slimbvh_core::lattice::LatticeBox;
use slimbvh_core::trace::{LeafSlot, TriangleSource};
use slimbvh_core::{Aabb, LeafTriangle, Node, NodeRef, Vec3};

/// A hierarchy as it is stored. Whatever is in it, no question panics as long as nodes and places are in range.
pub trait TreeView: Sync {
    /// A box as it is decoded.
    type Box: Copy + Send;

    /// How many nodes there are.
    fn node_count(&self) -> usize;

    /// How many places the triangles take.
    fn place_count(&self) -> usize;

    /// The root's box.
    fn root(&self) -> Self::Box;

    /// Whether all below the root can be decoded.
    fn check_root(&self) -> Result<(), TreeError>;

    /// A node's children and their boxes.
    fn open(&self, node: u32, bounds: &Self::Box) -> ([NodeRef; 2], [Self::Box; 2]);

    /// The first and the last triangle below a node, where it tells.
    fn run(&self, node: u32) -> Option<[u32; 2]>;

    /// The box at the scene's magnitude.
    fn aabb(&self, bounds: &Self::Box) -> Aabb;

    /// Places that a triangle takes in a leaf with this box.
    fn stride(&self, bounds: &Self::Box) -> u32;

    /// A triangle, by where its leaf's begin and its number among them.
    fn triangle(&self, place: (u32, u32), bounds: &Self::Box) -> LeafTriangle;

    /// Whether a triangle is stored as this one is.
    fn stores(&self, place: (u32, u32), bounds: &Self::Box, triangle: &LeafTriangle) -> bool;
}

/// Something to be done with a hierarchy, however it is stored.
pub trait Visit {
    /// Does it.
    fn visit<V: TreeView>(&mut self, view: &V);
}

impl Bvh {
    /// Shows the hierarchy as it is stored.
    pub(crate) fn show(&self, visit: &mut impl Visit) {
        let Some(coded) = &self.coded else {
            visit.visit(&PlainView {
                nodes: &self.nodes,
                triangles: &self.triangles,
            });
            return;
        };
        show_coded(coded, &self.triangles, visit);
    }
}

/// Shows what is stored in a codec. `full` are the triangles where they are stored in full.
pub fn show_coded(coded: &Coded, full: &[LeafTriangle], visit: &mut impl Visit) {
    match (&coded.nodes, &coded.triangles) {
        (CodedNodes::Paper10 { root, nodes }, triangles) => visit.visit(&Paper10View {
            nodes,
            root: *root,
            full,
            coded: match triangles {
                CodedTriangles::Leaf10(triangles) => Some(Paper10Triangles {
                    triangles,
                    opaque_zero: 0,
                }),
                CodedTriangles::F32 | CodedTriangles::Lattice(_) => None,
            },
        }),
        (CodedNodes::Lattice { bits, .. }, _) => {
            by_bits!(*bits, show_lattice(coded, full, visit));
        }
    }
}

fn show_lattice<const BITS: u32, const WORDS: usize>(
    coded: &Coded,
    full: &[LeafTriangle],
    visit: &mut impl Visit,
) {
    let CodedNodes::Lattice {
        root,
        step_exponent,
        words,
        ..
    } = &coded.nodes
    else {
        return;
    };
    let step = power_of_two((*step_exponent).clamp(SMALLEST_STEP, LARGEST_STEP));
    visit.visit(&LatticeView::<BITS, WORDS> {
        nodes: bytemuck::cast_slice(words),
        root: *root,
        step_exponent: *step_exponent,
        step,
        full,
        coded: match &coded.triangles {
            CodedTriangles::Lattice(words) => Some(LatticeTriangles { words, step }),
            CodedTriangles::F32 | CodedTriangles::Leaf10(_) => None,
        },
    });
}

/// The powers of two that are floats of full precision.
const SMALLEST_STEP: i32 = -126;
const LARGEST_STEP: i32 = 127;

/// The largest number of steps for which floats hold all planes, and the extents between them have the right exponent.
const MOST_STEPS: u32 = (1 << 24) - 1;

fn full_triangle(full: &[LeafTriangle], (first, number): (u32, u32)) -> LeafTriangle {
    let triangle = full.get((first + number) as usize);
    triangle.copied().unwrap_or_default()
}

fn is_same(a: &LeafTriangle, b: &LeafTriangle) -> bool {
    bytemuck::bytes_of(a) == bytemuck::bytes_of(b)
}

/// A triangle as the traversal reads it.
fn coded_triangle<F: Copy>(
    source: &impl TriangleSource<F>,
    (first, number): (u32, u32),
    bounds: F,
) -> LeafTriangle {
    let place = LeafSlot {
        first,
        number,
        bounds,
    };
    let corners = source.corners(&place, [0, 1, 2]);
    let mut vertices = [0.0; 9];
    vertices.copy_from_slice(corners.as_flattened());
    LeafTriangle {
        vertices,
        primitive: source.primitive(&place),
    }
}

/// Everything in full.
struct PlainView<'a> {
    nodes: &'a [Node],
    triangles: &'a [LeafTriangle],
}

impl TreeView for PlainView<'_> {
    type Box = Aabb;

    fn node_count(&self) -> usize {
        self.nodes.len()
    }

    fn place_count(&self) -> usize {
        self.triangles.len()
    }

    fn root(&self) -> Aabb {
        // No node's box is needed to read its children's.
        Aabb::EMPTY
    }

    fn check_root(&self) -> Result<(), TreeError> {
        Ok(())
    }

    fn open(&self, node: u32, _: &Aabb) -> ([NodeRef; 2], [Aabb; 2]) {
        let node = &self.nodes[node as usize];
        ([node.left, node.right], [node.left_box(), node.right_box()])
    }

    fn run(&self, node: u32) -> Option<[u32; 2]> {
        let node = &self.nodes[node as usize];
        Some([node.first, node.last])
    }

    fn aabb(&self, bounds: &Aabb) -> Aabb {
        *bounds
    }

    fn stride(&self, _: &Aabb) -> u32 {
        1
    }

    fn triangle(&self, place: (u32, u32), _: &Aabb) -> LeafTriangle {
        full_triangle(self.triangles, place)
    }

    fn stores(&self, place: (u32, u32), _: &Aabb, triangle: &LeafTriangle) -> bool {
        is_same(&full_triangle(self.triangles, place), triangle)
    }
}

/// Nodes of the paper10 codec.
struct Paper10View<'a> {
    nodes: &'a [Paper10Node],
    root: Paper10Box,
    full: &'a [LeafTriangle],
    coded: Option<Paper10Triangles<'a>>,
}

impl TreeView for Paper10View<'_> {
    type Box = Paper10Box;

    fn node_count(&self) -> usize {
        self.nodes.len()
    }

    fn place_count(&self) -> usize {
        self.coded
            .map_or(self.full.len(), |coded| coded.triangles.len())
    }

    fn root(&self) -> Paper10Box {
        self.root
    }

    fn check_root(&self) -> Result<(), TreeError> {
        if is_in_scene(&self.aabb(&self.root)) {
            Ok(())
        } else {
            Err(TreeError::RootBox)
        }
    }

    fn open(&self, node: u32, bounds: &Paper10Box) -> ([NodeRef; 2], [Paper10Box; 2]) {
        let node = &self.nodes[node as usize];
        (
            [node.left, node.right],
            decode_paper10_node(node, bounds, 0),
        )
    }

    fn run(&self, _: u32) -> Option<[u32; 2]> {
        None
    }

    fn aabb(&self, bounds: &Paper10Box) -> Aabb {
        Aabb {
            min: Vec3::from_array(bounds.min),
            max: Vec3::from_array(bounds.max),
        }
    }

    fn stride(&self, _: &Paper10Box) -> u32 {
        1
    }

    fn triangle(&self, place: (u32, u32), bounds: &Paper10Box) -> LeafTriangle {
        match &self.coded {
            Some(coded) => coded_triangle(coded, place, *bounds),
            None => full_triangle(self.full, place),
        }
    }

    fn stores(&self, place: (u32, u32), bounds: &Paper10Box, triangle: &LeafTriangle) -> bool {
        match &self.coded {
            // Its vertices moved, always in the same way.
            Some(coded) => {
                let stored = coded.triangles.get((place.0 + place.1) as usize);
                stored == Some(&encode_paper10_triangle(triangle, bounds, 0))
            }
            None => is_same(&full_triangle(self.full, place), triangle),
        }
    }
}

/// Nodes of the lattice codec.
struct LatticeView<'a, const BITS: u32, const WORDS: usize> {
    nodes: &'a [[u32; WORDS]],
    root: LatticeBox,
    step_exponent: i32,
    step: f32,
    full: &'a [LeafTriangle],
    coded: Option<LatticeTriangles<'a>>,
}

impl<const BITS: u32, const WORDS: usize> TreeView for LatticeView<'_, BITS, WORDS> {
    type Box = LatticeBox;

    fn node_count(&self) -> usize {
        self.nodes.len()
    }

    fn place_count(&self) -> usize {
        self.coded
            .map_or(self.full.len(), |coded| coded.words.len())
    }

    fn root(&self) -> LatticeBox {
        self.root
    }

    fn check_root(&self) -> Result<(), TreeError> {
        if !(SMALLEST_STEP..=LARGEST_STEP).contains(&self.step_exponent) {
            return Err(TreeError::Step {
                step_exponent: self.step_exponent,
            });
        }
        let mut planes = self.root.min.iter().chain(&self.root.max);
        let is_counted = planes.all(|plane| plane.unsigned_abs() <= MOST_STEPS);
        if is_counted && is_in_scene(&self.aabb(&self.root)) {
            Ok(())
        } else {
            Err(TreeError::RootBox)
        }
    }

    fn open(&self, node: u32, bounds: &LatticeBox) -> ([NodeRef; 2], [LatticeBox; 2]) {
        let words = &self.nodes[node as usize];
        let boxes = decode_node::<BITS, WORDS>(words, bounds);
        let links = links_of::<BITS, WORDS>(words);
        (links.children(self.stride(&boxes[0])), boxes)
    }

    fn run(&self, _: u32) -> Option<[u32; 2]> {
        None
    }

    fn aabb(&self, bounds: &LatticeBox) -> Aabb {
        let point = |v: [i32; 3]| Vec3::from_array(v.map(|x| x as f32 * self.step));
        Aabb {
            min: point(bounds.min),
            max: point(bounds.max),
        }
    }

    fn stride(&self, bounds: &LatticeBox) -> u32 {
        self.coded.map_or(1, |_| LeafWidth::of(bounds).words())
    }

    fn triangle(&self, place: (u32, u32), bounds: &LatticeBox) -> LeafTriangle {
        match &self.coded {
            Some(coded) => {
                let frame = LatticeBounds::new(bounds, self.step, [0, 1, 2]);
                coded_triangle(coded, place, frame)
            }
            None => full_triangle(self.full, place),
        }
    }

    fn stores(&self, place: (u32, u32), bounds: &LatticeBox, triangle: &LeafTriangle) -> bool {
        is_same(&self.triangle(place, bounds), triangle)
    }
}

/// Whether a box is one of the scene, whose coordinates are of magnitude 1 at most.
pub fn is_in_scene(bounds: &Aabb) -> bool {
    let (low, high) = (bounds.min, bounds.max);
    low.cmpge(Vec3::NEG_ONE).all() && high.cmple(Vec3::ONE).all() && low.cmple(high).all()
}
