//! A tree in the paper10 codec, from the paper on compressed hierarchies and meshes: 10 bits a plane, and optionally 10
//! bits a coordinate.

use super::codec::{MeshCodec, NodeCodec};
use super::error::TreeError;
use super::lanes::Numbers;
use super::sources::{LeafPlace, Opened, StoredNodes, StoredTriangles, is_in_scene, triangle_in};
use super::stored::{List, ListReader, Lists, Stacks, StoredTree};
use super::visitor::TreeVisitor;
use slimbvh_core::encode::{
    Paper10Box, Paper10Node, Paper10Nodes, Paper10Triangle, Paper10Triangles, RootWords,
    decode_paper10_node, encode_paper10_triangle,
};
use slimbvh_core::trace::{LeafSlot, LeafTriangles, PacketStacks};
use slimbvh_core::{Aabb, LeafTriangle, Vec3};

/// Nodes of the codec, the root's box, and triangles.
#[derive(Clone, Debug)]
pub struct Paper10Tree {
    pub root: Paper10Box,
    pub nodes: Vec<Paper10Node>,
    pub triangles: Paper10Mesh,
}

/// Triangles in leaves.
#[derive(Clone, Debug)]
pub enum Paper10Mesh {
    /// In full.
    Full(Vec<LeafTriangle>),
    /// 10 bits a coordinate, in the leaf's box.
    Leaf10(Vec<Paper10Triangle>),
}

impl Paper10Mesh {
    /// The buffer of coded triangles; empty for triangles in full.
    pub fn into_coded(self) -> Vec<Paper10Triangle> {
        match self {
            Self::Leaf10(triangles) => triangles,
            Self::Full(_) => Vec::new(),
        }
    }
}

impl Paper10Tree {
    /// The buffers of a tree to be replaced, if it uses this codec.
    pub fn reuse(tree: StoredTree) -> Self {
        match tree {
            StoredTree::Paper10(tree) => tree,
            _ => Self {
                root: Paper10Box::ZERO,
                nodes: Vec::new(),
                triangles: Paper10Mesh::Full(Vec::new()),
            },
        }
    }

    /// Calls a visitor with the sources.
    // A separate function: one for all codecs would be too large to optimise well.
    #[inline(never)]
    pub fn visit<V: TreeVisitor>(&self, visitor: V) -> V::Output {
        let nodes = Paper10Nodes {
            nodes: &self.nodes,
            root: self.root,
            opaque_zero: 0,
        };
        match &self.triangles {
            Paper10Mesh::Full(triangles) => visitor.visit(&nodes, &LeafTriangles(triangles)),
            Paper10Mesh::Leaf10(triangles) => visitor.visit(
                &nodes,
                &Paper10Triangles {
                    triangles,
                    opaque_zero: 0,
                },
            ),
        }
    }

    /// A tree with this root, its lists read by a reader.
    pub fn read<R: ListReader>(
        mesh: MeshCodec,
        root: &RootWords,
        reader: &mut R,
    ) -> Result<Self, R::Error> {
        Ok(Self {
            root: root.paper10(),
            nodes: reader.nodes(1)?,
            triangles: if mesh == MeshCodec::Leaf10 {
                Paper10Mesh::Leaf10(reader.triangles()?)
            } else {
                Paper10Mesh::Full(reader.triangles()?)
            },
        })
    }
}

impl Lists for Paper10Tree {
    fn codecs(&self, _: i32) -> (NodeCodec, MeshCodec) {
        let mesh = match &self.triangles {
            Paper10Mesh::Full(_) => MeshCodec::F32,
            Paper10Mesh::Leaf10(_) => MeshCodec::Leaf10,
        };
        (NodeCodec::Paper10, mesh)
    }

    fn triangle_count(&self) -> usize {
        match &self.triangles {
            Paper10Mesh::Full(triangles) => triangles.len(),
            Paper10Mesh::Leaf10(triangles) => triangles.len(),
        }
    }

    fn lists(&self) -> [List<'_>; 2] {
        let triangles = match &self.triangles {
            Paper10Mesh::Full(triangles) => List::of(triangles),
            Paper10Mesh::Leaf10(triangles) => List::of(triangles),
        };
        [List::of(&self.nodes), triangles]
    }

    fn held_bytes(&self) -> usize {
        let triangles = match &self.triangles {
            Paper10Mesh::Full(triangles) => triangles.capacity() * size_of::<LeafTriangle>(),
            Paper10Mesh::Leaf10(triangles) => triangles.capacity() * size_of::<Paper10Triangle>(),
        };
        self.nodes.capacity() * size_of::<Paper10Node>() + triangles
    }

    fn root_words(&self) -> Option<RootWords> {
        Some(RootWords::of_paper10(&self.root))
    }

    fn check_root(&self) -> Result<(), TreeError> {
        if is_in_scene(&aabb(&self.root)) {
            Ok(())
        } else {
            Err(TreeError::RootBox)
        }
    }

    fn full_triangles(&self) -> Option<&Vec<LeafTriangle>> {
        match &self.triangles {
            Paper10Mesh::Full(triangles) => Some(triangles),
            Paper10Mesh::Leaf10(_) => None,
        }
    }

    fn full_triangles_mut(&mut self) -> Option<&mut Vec<LeafTriangle>> {
        match &mut self.triangles {
            Paper10Mesh::Full(triangles) => Some(triangles),
            Paper10Mesh::Leaf10(_) => None,
        }
    }
}

fn aabb(bounds: &Paper10Box) -> Aabb {
    Aabb {
        min: Vec3::from_array(bounds.min),
        max: Vec3::from_array(bounds.max),
    }
}

impl StoredNodes for Paper10Nodes<'_> {
    type Box = Paper10Box;

    #[inline(always)]
    fn stacks(stacks: &mut Stacks) -> &mut PacketStacks<Self::Node, Numbers> {
        &mut stacks.paper10
    }

    fn count(&self) -> usize {
        self.nodes.len()
    }

    fn root_box(&self) -> Paper10Box {
        self.root
    }

    fn open(&self, node: u32, bounds: &Paper10Box) -> Opened<Paper10Box> {
        let node = &self.nodes[node as usize];
        let boxes = decode_paper10_node(node, bounds, 0);
        Opened::pair([node.left, node.right], boxes)
    }

    fn aabb(&self, bounds: &Paper10Box) -> Aabb {
        aabb(bounds)
    }
}

impl StoredTriangles<Paper10Nodes<'_>> for Paper10Triangles<'_> {
    fn place_count(&self) -> usize {
        self.triangles.len()
    }

    fn bytes(&self, _: &LeafSlot<Paper10Box>) -> usize {
        size_of::<Paper10Triangle>()
    }

    fn triangle(&self, at: LeafPlace, bounds: &Paper10Box) -> LeafTriangle {
        triangle_in(self, at, *bounds)
    }

    /// Encoding moved its vertices; encoding is deterministic.
    fn stores(&self, at: LeafPlace, bounds: &Paper10Box, triangle: &LeafTriangle) -> bool {
        let stored = self.triangles.get((at.leaf.first() + at.number) as usize);
        stored == Some(&encode_paper10_triangle(triangle, bounds, 0))
    }
}
