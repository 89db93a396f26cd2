//! Stage `cluster` on the CPU, and stage `topology` of the tree that it leaves.

use super::BLOCK;
use super::select::Selection;
use super::topology::Connections;
use rayon::prelude::*;
use slimbvh_core::LeafTriangle;
use slimbvh_core::cluster::{
    Cluster, Clusters, Member, NOTHING, Place, PlacedNode, Round, Size, merge, merging_pairs, open,
    triangle_cluster,
};
use slimbvh_core::compact::{is_set, rank};
use slimbvh_core::node::{Connection, LEAF_SIZE};
use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

/// Below a node with fewer triangles, no more threads are asked.
const TASK: u32 = 8192;

/// Merges triangles to a tree. Keeps its buffers.
#[derive(Debug, Default)]
pub struct Clustering {
    clusters: AtomicClusters,
    active: Vec<u32>,
    next: Vec<u32>,
    merging: Selection,
    /// By place in the tree: which triangle, in the order of the curve.
    order: Vec<u32>,
    sorted: Vec<LeafTriangle>,
}

/// Where a cluster goes depends on data, so tasks store through relaxed atomics, each to clusters of its own: plain moves.
#[derive(Debug, Default)]
struct AtomicClusters {
    clusters: Vec<[AtomicU32; 8]>,
    sizes: Vec<[AtomicU32; 2]>,
    triangle_count: u32,
}

impl Clusters for AtomicClusters {
    #[inline(always)]
    fn cluster(&self, id: u32) -> Cluster {
        let words = &self.clusters[id as usize];
        let word = |i: usize| words[i].load(Relaxed);
        let number = |i: usize| f32::from_bits(word(i));
        Cluster {
            min: [number(0), number(1), number(2)],
            left: word(3),
            max: [number(4), number(5), number(6)],
            right: word(7),
        }
    }

    #[inline(always)]
    fn size(&self, id: u32) -> Size {
        if id < self.triangle_count {
            return Size::TRIANGLE;
        }
        let [triangles, nodes] = &self.sizes[(id - self.triangle_count) as usize];
        Size {
            triangles: triangles.load(Relaxed),
            nodes: nodes.load(Relaxed),
        }
    }
}

impl AtomicClusters {
    /// Makes room for a tree over so many triangles.
    fn resize(&mut self, triangle_count: u32) {
        let merge_count = triangle_count.saturating_sub(1) as usize;
        let cluster_count = triangle_count as usize + merge_count;
        self.clusters.resize_with(cluster_count, Default::default);
        self.sizes.resize_with(merge_count, Default::default);
        self.triangle_count = triangle_count;
    }

    #[inline(always)]
    fn store(words: &[AtomicU32; 8], cluster: &Cluster) {
        let (min, max) = (cluster.min.map(f32::to_bits), cluster.max.map(f32::to_bits));
        for (axis, place) in [0, 1, 2].into_iter().enumerate() {
            words[place].store(min[axis], Relaxed);
            words[place + 4].store(max[axis], Relaxed);
        }
        words[3].store(cluster.left, Relaxed);
        words[7].store(cluster.right, Relaxed);
    }

    #[inline(always)]
    fn put(&self, member: &Member) {
        if member.id == NOTHING {
            return;
        }
        Self::store(&self.clusters[member.id as usize], &member.cluster);
        let [triangles, nodes] = &self.sizes[(member.id - self.triangle_count) as usize];
        triangles.store(member.size.triangles, Relaxed);
        nodes.store(member.size.nodes, Relaxed);
    }
}

impl Clustering {
    /// Merges triangles, which are in the order of the curve, to one cluster.
    pub fn merge(&mut self, triangles: &[LeafTriangle]) {
        let triangle_count = triangles.len() as u32;
        self.clusters.resize(triangle_count);
        self.active.resize(triangles.len(), 0);
        let clusters = self.clusters.clusters.par_chunks(BLOCK);
        let blocks = clusters.zip(self.active.par_chunks_mut(BLOCK)).enumerate();
        blocks.for_each(|(block, (clusters, active))| {
            for ((words, active), i) in clusters.iter().zip(active).zip((block * BLOCK) as u32..) {
                AtomicClusters::store(words, &triangle_cluster(i, triangles));
                *active = i;
            }
        });
        let mut round = Round {
            index: 0,
            count: triangle_count,
        };
        while round.count > 1 {
            self.merge_round(round);
            round.count = self.active.len() as u32;
            round.index += 1;
        }
    }

    fn merge_round(&mut self, round: Round) {
        let (clusters, active) = (&self.clusters, self.active.as_slice());
        let merging = &mut self.merging;
        let merge_count = merging.fill((round.count - 1).div_ceil(32) as usize, |word| {
            merging_pairs(word, round, active, clusters, 0)
        });
        let (bits, before) = (merging.bits.as_slice(), merging.before.as_slice());
        let first_merge = round.first_merge(clusters.triangle_count);

        // The left one of each pair stays, so each block leaves a run.
        self.next.resize(active.len() - merge_count, 0);
        let staying_before = |i: usize| match i {
            0 => 0,
            _ if i >= active.len() => active.len() - merge_count,
            _ => i - rank(i as u32 - 1, bits, before) as usize,
        };
        let mut rest = self.next.as_mut_slice();
        let mut blocks = Vec::with_capacity(active.len().div_ceil(BLOCK));
        for first in (0..active.len()).step_by(BLOCK) {
            let (run, after) =
                rest.split_at_mut(staying_before(first + BLOCK) - staying_before(first));
            rest = after;
            blocks.push((first, run));
        }
        blocks.into_par_iter().for_each(|(first, run)| {
            let mut places = run.iter_mut();
            let mut id = first_merge + rank(first as u32, bits, before);
            let mut is_taken = first > 0 && is_set(first as u32 - 1, bits);
            for i in first..active.len().min(first + BLOCK) {
                if is_taken {
                    is_taken = false;
                    continue;
                }
                is_taken = is_set(i as u32, bits);
                let Some(place) = places.next() else { break };
                if is_taken {
                    let pair = [active[i], active[i + 1]];
                    let made = merge(id, pair, round, clusters, 0);
                    clusters.put(&made.first);
                    clusters.put(&made.second);
                    clusters.put(&made.node);
                    *place = id;
                    id += 1;
                } else {
                    *place = active[i];
                }
            }
        });
        std::mem::swap(&mut self.active, &mut self.next);
    }

    /// Stage `topology`: the nodes of the tree over more than [`LEAF_SIZE`] triangles that were merged last, which are put in
    /// its order.
    pub fn connect(&mut self, triangles: &mut Vec<LeafTriangle>, connections: &mut Connections) {
        let triangle_count = triangles.len() as u32;
        debug_assert!(triangle_count > LEAF_SIZE && triangle_count == self.clusters.triangle_count);
        let root = Place::root(triangle_count);
        let node_count = self.clusters.size(root.id).nodes as usize;
        connections.nodes.resize(node_count, Connection::default());
        connections.splits.resize(node_count, 0);
        self.order.resize(triangles.len(), 0);
        let part = Part {
            place: root,
            size: self.clusters.size(root.id),
            is_left: false,
            nodes: &mut connections.nodes,
            splits: &mut connections.splits,
            order: &mut self.order,
        };
        part.fill(&self.clusters);

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
        size_of_val(self.clusters.clusters.as_slice())
            + size_of_val(self.clusters.sizes.as_slice())
            + 2 * size_of_val(self.order.as_slice())
            + self.merging.bytes()
            + size_of_val(self.order.as_slice())
            + size_of_val(self.sorted.as_slice())
    }
}

/// A cluster in its place, and the parts of the lists that it fills.
struct Part<'a> {
    place: Place,
    size: Size,
    is_left: bool,
    nodes: &'a mut [Connection],
    splits: &'a mut [u32],
    order: &'a mut [u32],
}

impl Part<'_> {
    /// Stores it and all below.
    fn fill(self, clusters: &AtomicClusters) {
        if let [order] = self.order {
            *order = self.place.id;
            return;
        }
        let PlacedNode {
            node,
            split,
            left,
            right,
        } = open(self.place, clusters);
        let (mut nodes, mut splits) = (self.nodes, self.splits);

        // A left child comes after all that is below it, any other node before.
        if self.size.nodes > 0 {
            let own = if self.is_left { nodes.len() - 1 } else { 0 };
            nodes[own] = Connection::from(&node);
            splits[own] = split;
            let below = usize::from(!self.is_left)..nodes.len() - usize::from(self.is_left);
            (nodes, splits) = (&mut nodes[below.clone()], &mut splits[below]);
        }
        let (left_size, right_size) = (clusters.size(left.id), clusters.size(right.id));
        let (left_nodes, right_nodes) = nodes.split_at_mut(left_size.nodes as usize);
        let (left_splits, right_splits) = splits.split_at_mut(left_size.nodes as usize);
        let (left_order, right_order) = self.order.split_at_mut(left_size.triangles as usize);
        let left = Part {
            place: left,
            size: left_size,
            is_left: true,
            nodes: left_nodes,
            splits: left_splits,
            order: left_order,
        };
        let right = Part {
            place: right,
            size: right_size,
            is_left: false,
            nodes: right_nodes,
            splits: right_splits,
            order: right_order,
        };
        if self.size.triangles < TASK {
            left.fill(clusters);
            right.fill(clusters);
        } else {
            rayon::join(|| left.fill(clusters), || right.fill(clusters));
        }
    }
}
