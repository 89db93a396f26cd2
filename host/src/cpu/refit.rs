//! Stage `refit` on the CPU.

use super::BLOCK;
use super::topology::Connections;
use rayon::prelude::*;
use slimbvh_core::refit::{PyramidBox, group_bounds, group_count, parent_bounds, refit_node};
use slimbvh_core::{LeafTriangle, Node};

/// Boxes of groups, of pairs of groups, and so on up to one box.
pub fn fill_pyramid(triangles: &[LeafTriangle], pyramid: &mut Vec<PyramidBox>) {
    let mut level_count = group_count(triangles.len() as u32) as usize;
    pyramid.resize(pyramid_size(level_count), PyramidBox::default());
    let (level, mut rest) = pyramid.split_at_mut(level_count);
    fill(level, |i| group_bounds(i, triangles));
    let mut below = &*level;
    while level_count > 1 {
        level_count = level_count.div_ceil(2);
        let (level, after) = rest.split_at_mut(level_count);
        fill(level, |i| parent_bounds(i, below));
        (below, rest) = (level, after);
    }
}

/// Entries of the level of this size and all above it.
fn pyramid_size(level_count: usize) -> usize {
    let mut size = level_count;
    let mut level = level_count;
    while level > 1 {
        level = level.div_ceil(2);
        size += level;
    }
    size
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
