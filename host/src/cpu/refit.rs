//! Stage `refit` on the CPU.

use super::BLOCK;
use super::topology::Connections;
use crate::parallel::prelude::*;
use slimbvh_core::refit::{
    Level, PyramidBox, group_bounds, parent_bounds, pyramid_size, refit_node,
};
use slimbvh_core::{LeafTriangle, Node};

/// Boxes of groups, of pairs of groups, and so on up to one box.
pub fn fill_pyramid(triangles: &[LeafTriangle], pyramid: &mut Vec<PyramidBox>) {
    let triangle_count = triangles.len() as u32;
    pyramid.resize(pyramid_size(triangle_count) as usize, PyramidBox::default());
    let mut level = Level::lowest(triangle_count);
    fill(&mut pyramid[..level.count as usize], |i| {
        group_bounds(i, triangles)
    });
    while level.count > 1 {
        let below = level;
        level = level.above();
        let (made, rest) = pyramid.split_at_mut(level.begin as usize);
        fill(&mut rest[..level.count as usize], |i| {
            parent_bounds(i, below, made)
        });
    }
}

/// Nodes with the boxes of their children.
pub fn fill_boxes(
    triangles: &[LeafTriangle],
    pyramid: &[PyramidBox],
    connections: &Connections,
    nodes: &mut Vec<Node>,
) {
    nodes.resize(connections.nodes.len(), Node::EMPTY);
    let bare = connections.nodes.par_chunks(BLOCK);
    let bare = bare.zip(connections.splits.par_chunks(BLOCK));
    let blocks = nodes.par_chunks_mut(BLOCK).zip(bare);
    blocks.for_each(|(nodes, (bare, splits))| {
        for (node, (bare, &split)) in nodes.iter_mut().zip(bare.iter().zip(splits)) {
            *node = refit_node(bare.into(), split, triangles, pyramid);
        }
    });
}

/// Stores a kernel's results in parallel.
fn fill<T: Send>(to: &mut [T], kernel: impl Fn(u32) -> T + Sync) {
    to.par_chunks_mut(BLOCK)
        .enumerate()
        .for_each(|(block, to)| {
            for (place, i) in to.iter_mut().zip((block * BLOCK) as u32..) {
                *place = kernel(i);
            }
        });
}
