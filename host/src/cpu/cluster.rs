//! Stage `cluster` on the CPU, and stage `topology` of the clustered tree.

use super::BLOCK;
use super::compact::Selection;
use super::topology::Connections;
use crate::parallel::prelude::*;
use slimbvh_core::LeafTriangle;
use slimbvh_core::cluster::{
    Active, Change, Merged, Merges, NO_CLUSTER, Place, PlacedNode, Round, Size, merge,
    merging_pairs, open, rotate, triangle_box,
};
use slimbvh_core::compact::{is_set, rank};
use slimbvh_core::node::{Connection, LEAF_SIZE};
use slimbvh_core::refit::PyramidBox;

/// Nodes with fewer triangles are filled on one thread.
const TASK: u32 = 8192;

/// Merges triangles into a tree. Keeps its buffers.
#[derive(Debug, Default)]
pub struct Clustering {
    merges: Vec<Merged>,
    active: Clusters,
    next: Clusters,
    merging: Selection,
    /// For each place in the tree, the index of the triangle in the order of the curve.
    order: Vec<u32>,
    sorted: Vec<LeafTriangle>,
}

/// The clusters of a round, in order. The lists only grow.
#[derive(Debug, Default)]
struct Clusters {
    ids: Vec<u32>,
    boxes: Vec<PyramidBox>,
    count: usize,
}

impl Clusters {
    /// Makes room for `count` clusters.
    fn resize(&mut self, count: usize) {
        if count > self.ids.len() {
            self.ids.resize(count, 0);
            self.boxes.resize(count, PyramidBox::default());
        }
        self.count = count;
    }

    fn as_slices(&self) -> Active<'_> {
        Active {
            ids: &self.ids[..self.count],
            boxes: &self.boxes[..self.count],
        }
    }

    fn as_mut_slices(&mut self) -> (&mut [u32], &mut [PyramidBox]) {
        (&mut self.ids[..self.count], &mut self.boxes[..self.count])
    }

    fn bytes(&self) -> usize {
        size_of_val(self.ids.as_slice()) + size_of_val(self.boxes.as_slice())
    }
}

/// A block of the clusters, and the parts of the lists that its results fill.
struct Block<'a> {
    first: usize,
    next_ids: &'a mut [u32],
    next_boxes: &'a mut [PyramidBox],
    merges: &'a mut [Merged],
}

impl Clustering {
    /// Merges triangles, given in the order of the curve, into one cluster.
    pub fn merge(&mut self, triangles: &[LeafTriangle]) {
        let count = triangles.len();
        self.merges
            .resize(count.saturating_sub(1), Merged::default());
        self.active.resize(count);
        let (ids, boxes) = self.active.as_mut_slices();
        let blocks = ids.par_chunks_mut(BLOCK).zip(boxes.par_chunks_mut(BLOCK));
        blocks.enumerate().for_each(|(block, (ids, boxes))| {
            for ((id, bounds), i) in ids.iter_mut().zip(boxes).zip((block * BLOCK) as u32..) {
                (*id, *bounds) = (i, triangle_box(i, triangles));
            }
        });
        let mut round = Round {
            index: 0,
            count: count as u32,
        };
        while round.count > 1 {
            self.merge_round(round, count as u32);
            round.count = self.active.count as u32;
            round.index += 1;
        }
    }

    fn merge_round(&mut self, round: Round, triangle_count: u32) {
        // This round's merges follow those of earlier rounds.
        let first_merge = round.first_merge(triangle_count);
        let old = (first_merge - triangle_count) as usize;
        let (merges, mut free) = self.merges.split_at_mut(old);
        let merges = Merges {
            merges,
            triangle_count,
        };
        let (active, merging) = (self.active.as_slices(), &mut self.merging);
        let count = round.count as usize;
        let merge_count = merging.fill((round.count - 1).div_ceil(32) as usize, |word| {
            merging_pairs(word, round, active.boxes, 0)
        });
        let (bits, before) = (merging.bits.as_slice(), merging.before.as_slice());

        // The left member of each pair keeps its position, so a block reads one run and writes one.
        let staying = count - merge_count;
        self.next.resize(staying);
        let (mut next_ids, mut next_boxes) = self.next.as_mut_slices();
        // The last cluster starts no pair, so its bit may have no word.
        let merged_before = |i: usize| match i {
            _ if i + 1 >= count => merge_count,
            _ => rank(i as u32, bits, before) as usize,
        };
        let staying_before = |i: usize| match i {
            0 => 0,
            _ if i >= count => staying,
            _ => i - merged_before(i - 1),
        };
        let mut blocks = Vec::with_capacity(count.div_ceil(BLOCK));
        for first in (0..count).step_by(BLOCK) {
            let end = first + BLOCK;
            let made = merged_before(end) - merged_before(first);
            let stays = staying_before(end) - staying_before(first);
            let (block_ids, rest_ids) = next_ids.split_at_mut(stays);
            let (block_boxes, rest_boxes) = next_boxes.split_at_mut(stays);
            let (merges, rest) = free.split_at_mut(made);
            (next_ids, next_boxes, free) = (rest_ids, rest_boxes, rest);
            blocks.push(Block {
                first,
                next_ids: block_ids,
                next_boxes: block_boxes,
                merges,
            });
        }
        let run = |block: Block| {
            let first_id = first_merge + merged_before(block.first) as u32;
            block.run(first_id, bits, (round, &active, &merges))
        };
        let changes: Vec<Vec<Change>> = blocks.into_par_iter().map(run).collect();

        // Rotations are stored only now, because other blocks read the old nodes during the round.
        for change in changes.iter().flatten() {
            self.merges[(change.id - triangle_count) as usize] = change.merged;
        }
        std::mem::swap(&mut self.active, &mut self.next);
    }

    /// Stage `topology`: the nodes of the tree over the triangles merged last, more than [`LEAF_SIZE`]. Reorders the
    /// triangles as the tree does.
    pub fn connect(&mut self, triangles: &mut Vec<LeafTriangle>, connections: &mut Connections) {
        let triangle_count = triangles.len() as u32;
        debug_assert!(triangle_count > LEAF_SIZE && self.merges.len() + 1 == triangles.len());
        let merges = Merges {
            merges: &self.merges,
            triangle_count,
        };
        let root = Place::root(triangle_count);
        let size = merges.size(root.id);
        let node_count = size.nodes as usize;
        connections.nodes.resize(node_count, Connection::default());
        connections.splits.resize(node_count, 0);
        self.order.resize(triangles.len(), 0);
        let part = Part {
            place: root,
            size,
            is_left: false,
            nodes: &mut connections.nodes,
            splits: &mut connections.splits,
            order: &mut self.order,
        };
        part.fill(&merges);

        self.sorted.resize(triangles.len(), LeafTriangle::default());
        let sorted = self.sorted.par_chunks_mut(BLOCK);
        let blocks = sorted.zip(self.order.par_chunks(BLOCK));
        blocks.for_each(|(sorted, order)| {
            for (to, &from) in sorted.iter_mut().zip(order) {
                *to = triangles[from as usize];
            }
        });
        std::mem::swap(triangles, &mut self.sorted);
    }

    /// Bytes of the buffers that the last build used.
    pub fn bytes(&self) -> usize {
        size_of_val(self.merges.as_slice())
            + self.active.bytes()
            + self.next.bytes()
            + self.merging.bytes()
            + size_of_val(self.order.as_slice())
            + size_of_val(self.sorted.as_slice())
    }
}

impl Block<'_> {
    /// Merges the block's pairs. Returns the changes to earlier merges.
    fn run(
        self,
        first_id: u32,
        bits: &[u32],
        (round, active, old): (Round, &Active, &Merges),
    ) -> Vec<Change> {
        let mut changes = Vec::new();
        let mut next = self.next_ids.iter_mut().zip(self.next_boxes);
        let mut made = self.merges.iter_mut().zip(first_id..);
        // A pair that started in the previous block has used this block's first cluster.
        let mut i = self.first + usize::from(self.first > 0 && is_set(self.first as u32 - 1, bits));
        while i < active.ids.len().min(self.first + BLOCK) {
            let Some((next_id, next_box)) = next.next() else {
                break;
            };
            if !is_set(i as u32, bits) {
                (*next_id, *next_box) = (active.ids[i], active.boxes[i]);
                i += 1;
                continue;
            }
            let Some((node, id)) = made.next() else { break };
            let merge = merge(i as u32, round, active, old, 0);
            *node = merge.node;
            if merge.rotation != 0 {
                let rotated = rotate(i as u32, merge.rotation, active, old);
                *node = rotated.node;
                changes.push(rotated.first);
                if rotated.second.id != NO_CLUSTER {
                    changes.push(rotated.second);
                }
            }
            (*next_id, *next_box) = (id, merge.bounds);
            i += 2;
        }
        changes
    }
}

/// A cluster in its place in the tree, and the parts of the lists that it fills.
struct Part<'a> {
    place: Place,
    size: Size,
    is_left: bool,
    nodes: &'a mut [Connection],
    splits: &'a mut [u32],
    order: &'a mut [u32],
}

impl Part<'_> {
    /// Stores the cluster's node and all below it.
    fn fill(self, merges: &Merges) {
        if self.size.nodes == 0 {
            fill_leaf(self.place.id, self.order, merges);
            return;
        }
        let placed = open(self.place, merges);
        // A left child is stored after its descendants, any other node before them.
        let own = if self.is_left {
            self.nodes.len() - 1
        } else {
            0
        };
        self.nodes[own] = Connection::from(&placed.node);
        self.splits[own] = placed.split;
        let below = usize::from(!self.is_left)..self.nodes.len() - usize::from(self.is_left);
        let PlacedNode {
            left,
            right,
            in_left,
            in_right,
            ..
        } = placed;
        let left_count = in_left.nodes as usize;
        let (left_nodes, right_nodes) = self.nodes[below.clone()].split_at_mut(left_count);
        let (left_splits, right_splits) = self.splits[below].split_at_mut(left_count);
        let (left_order, right_order) = self.order.split_at_mut(in_left.triangles as usize);
        let left = Part {
            place: left,
            size: in_left,
            is_left: true,
            nodes: left_nodes,
            splits: left_splits,
            order: left_order,
        };
        let right = Part {
            place: right,
            size: in_right,
            is_left: false,
            nodes: right_nodes,
            splits: right_splits,
            order: right_order,
        };
        if self.size.triangles < TASK {
            left.fill(merges);
            right.fill(merges);
        } else {
            crate::parallel::join(|| left.fill(merges), || right.fill(merges));
        }
    }
}

/// The triangles of a leaf, in order.
fn fill_leaf(id: u32, order: &mut [u32], merges: &Merges) {
    if let [only] = order {
        *only = id;
        return;
    }
    let Merged { left, right, .. } = merges.merged(id);
    let left_count = merges.size(left).triangles as usize;
    let (left_order, right_order) = order.split_at_mut(left_count);
    fill_leaf(left, left_order, merges);
    fill_leaf(right, right_order, merges);
}
