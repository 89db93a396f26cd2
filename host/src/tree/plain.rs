//! A tree with nodes and triangles in full.

use super::codec::{MeshCodec, NodeCodec};
use super::error::TreeError;
use super::stored::{List, ListReader, Lists, Stacks, with_stacks};
use super::visitor::TreeVisitor;
use slimbvh_core::encode::RootWords;
use slimbvh_core::ray::PreparedRay;
use slimbvh_core::trace::{Collector, LeafTriangles, PlainNodes, Skip, traverse_with};
use slimbvh_core::{LeafTriangle, Node};

/// Nodes and triangles in full.
#[derive(Clone, Debug, Default)]
pub struct PlainTree {
    pub nodes: Vec<Node>,
    /// In leaf order.
    pub triangles: Vec<LeafTriangle>,
}

impl PlainTree {
    pub fn node_source(&self) -> PlainNodes<'_> {
        PlainNodes(&self.nodes)
    }

    pub fn triangle_source(&self) -> LeafTriangles<'_> {
        LeafTriangles(&self.triangles)
    }

    /// Calls a visitor with the sources.
    #[inline(always)]
    pub fn visit<V: TreeVisitor>(&self, visitor: V) -> V::Output {
        visitor.visit(&self.node_source(), &self.triangle_source())
    }

    /// Traces one ray, with the thread's own stack.
    #[inline(always)]
    pub fn trace<C: Collector>(&self, ray: &PreparedRay, collector: &mut C) {
        let (nodes, triangles) = (self.node_source(), self.triangle_source());
        with_stacks(|Stacks { plain, .. }| {
            let (stack, rule) = (&mut plain.alone, &Skip::NONE);
            traverse_with(stack, &nodes, &triangles, ray, rule, collector);
        });
    }

    /// A tree whose lists a reader reads.
    pub fn read<R: ListReader>(reader: &mut R) -> Result<Self, R::Error> {
        Ok(Self {
            nodes: reader.nodes(1)?,
            triangles: reader.triangles()?,
        })
    }
}

impl Lists for PlainTree {
    fn codecs(&self, _: i32) -> (NodeCodec, MeshCodec) {
        (NodeCodec::F32, MeshCodec::F32)
    }

    fn triangle_count(&self) -> usize {
        self.triangles.len()
    }

    fn lists(&self) -> [List<'_>; 2] {
        [List::of(&self.nodes), List::of(&self.triangles)]
    }

    fn held_bytes(&self) -> usize {
        self.nodes.capacity() * size_of::<Node>()
            + self.triangles.capacity() * size_of::<LeafTriangle>()
    }

    fn root_words(&self) -> Option<RootWords> {
        None
    }

    fn check_root(&self) -> Result<(), TreeError> {
        Ok(())
    }

    fn full_triangles(&self) -> Option<&Vec<LeafTriangle>> {
        Some(&self.triangles)
    }

    fn full_triangles_mut(&mut self) -> Option<&mut Vec<LeafTriangle>> {
        Some(&mut self.triangles)
    }
}
