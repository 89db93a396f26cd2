//! Stages `bounds` to `refit` on the CPU.

use super::sort::Sorter;
use crate::{Bvh, Mesh, MeshError, Stages};
use rayon::prelude::*;
use slimbvh_core::bounds::{run_bounds, scene_exponent};
use slimbvh_core::morton::{Frame, morton_code_30, morton_code_63};
use slimbvh_core::node::LEAF_SIZE;
use slimbvh_core::refit::{
    PyramidBox, group_bounds, group_count, parent_bounds, refit_node, split_of,
};
use slimbvh_core::scan::run_scan;
use slimbvh_core::snap::{Scale, leaf_triangle};
use slimbvh_core::topology::{
    Codes30, Codes63, SortedCodes, depth_bound, internal_node, kept_nodes, single_node,
};
use slimbvh_core::{Aabb, IndexedTriangles, LeafTriangle, Node};

/// Items that a task takes at once.
const BLOCK: usize = 4096;

/// How finely triangles are told apart along the space-filling curve.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum CodeBits {
    /// 10 bits an axis: 1024 cells along the longest side.
    #[default]
    Bits30,
    /// 21 bits an axis, for scenes with small details: a teapot in a stadium.
    Bits63,
}

/// How to build.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct BuildConfig {
    /// Length of the Morton codes.
    pub code_bits: CodeBits,
}

/// Builds hierarchies, and keeps its buffers from one to the next.
#[derive(Debug, Default)]
pub struct Builder {
    config: BuildConfig,
    sorter_30: Sorter<1>,
    sorter_63: Sorter<2>,
    codes_30: Vec<u32>,
    codes_63: Vec<[u32; 2]>,
    kept: Vec<u32>,
    kept_before: Vec<u32>,
    splits: Vec<u32>,
    pyramid: Vec<PyramidBox>,
}

impl Builder {
    /// A builder without buffers yet.
    #[must_use]
    pub fn new(config: BuildConfig) -> Self {
        Self {
            config,
            ..Self::default()
        }
    }

    /// Builds a hierarchy over a mesh in a new place.
    ///
    /// # Errors
    /// Those of [`Mesh::validate`].
    pub fn build(&mut self, mesh: &Mesh) -> Result<Bvh, MeshError> {
        let mut bvh = Bvh::default();
        self.build_into(mesh, &mut bvh)?;
        Ok(bvh)
    }

    /// Builds a hierarchy over a mesh in place of an earlier one, whose memory is used again. Returns the time of each
    /// stage.
    ///
    /// # Errors
    /// Those of [`Mesh::validate`]; the earlier hierarchy stays as it was.
    pub fn build_into(&mut self, mesh: &Mesh, bvh: &mut Bvh) -> Result<Stages, MeshError> {
        let mut stages = Stages::default();
        stages.time("validate", || mesh.validate())?;
        let triangles = IndexedTriangles {
            vertices: &mesh.vertices,
            indices: &mesh.indices,
        };
        let count = mesh.indices.len() as u32;
        let bounds = stages.time("bounds", || scene_bounds(&triangles));
        bvh.bounds = (!bounds.is_empty()).then_some(bounds);
        bvh.scene_exponent = scene_exponent(&bounds);
        let scale = Scale::new(bvh.scene_exponent);
        match self.config.code_bits {
            CodeBits::Bits30 => {
                let frame = Frame::new(&bounds, 10);
                let code = |bounds: &Aabb| [morton_code_30(bounds, &frame)];
                order(&mut stages, &mut self.sorter_30, [30], &triangles, code);
                let leaves = &mut bvh.triangles;
                stages.time("snap", || {
                    gather(
                        &mut self.sorter_30,
                        &triangles,
                        &scale,
                        leaves,
                        &mut self.codes_30,
                        |[key]| key,
                    );
                });
            }
            CodeBits::Bits63 => {
                let frame = Frame::new(&bounds, 21);
                let code = |bounds: &Aabb| morton_code_63(bounds, &frame);
                order(&mut stages, &mut self.sorter_63, [31, 32], &triangles, code);
                let leaves = &mut bvh.triangles;
                stages.time("snap", || {
                    gather(
                        &mut self.sorter_63,
                        &triangles,
                        &scale,
                        leaves,
                        &mut self.codes_63,
                        |key| key,
                    );
                });
            }
        }
        stages.time("topology", || {
            if count <= LEAF_SIZE {
                bvh.nodes.clear();
                bvh.nodes.push(single_node(count));
                self.splits.clear();
                self.splits.push(split_of(&bvh.nodes[0], 0));
            } else if self.config.code_bits == CodeBits::Bits30 {
                let codes = Codes30(&self.codes_30);
                connect(
                    &codes,
                    &mut self.kept,
                    &mut self.kept_before,
                    &mut bvh.nodes,
                    &mut self.splits,
                );
            } else {
                let codes = Codes63(&self.codes_63);
                connect(
                    &codes,
                    &mut self.kept,
                    &mut self.kept_before,
                    &mut bvh.nodes,
                    &mut self.splits,
                );
            }
        });
        bvh.depth_bound = match self.config.code_bits {
            CodeBits::Bits30 => depth_bound(30, count),
            CodeBits::Bits63 => depth_bound(63, count),
        };
        stages.time("refit", || {
            fill_pyramid(&bvh.triangles, &mut self.pyramid);
            if count > 0 {
                fill_boxes(&bvh.triangles, &self.pyramid, &self.splits, &mut bvh.nodes);
            }
        });
        Ok(stages)
    }

    /// Bytes of all buffers that the builder keeps between builds.
    #[must_use]
    pub fn scratch_bytes(&self) -> usize {
        self.sorter_30.bytes()
            + self.sorter_63.bytes()
            + size_of_val(self.codes_30.as_slice())
            + size_of_val(self.codes_63.as_slice())
            + size_of_val(self.kept.as_slice())
            + size_of_val(self.kept_before.as_slice())
            + size_of_val(self.splits.as_slice())
            + size_of_val(self.pyramid.as_slice())
    }
}

/// Stage `bounds`.
fn scene_bounds(triangles: &IndexedTriangles) -> Aabb {
    let count = triangles.indices.len();
    (0..count.div_ceil(BLOCK))
        .into_par_iter()
        .map(|block| {
            let first = block * BLOCK;
            run_bounds(first as u32, BLOCK.min(count - first) as u32, triangles)
        })
        .reduce(|| Aabb::EMPTY, Aabb::union)
}

/// Stages `morton` and `sort`.
fn order<const W: usize>(
    stages: &mut Stages,
    sorter: &mut Sorter<W>,
    key_bits: [u32; W],
    triangles: &IndexedTriangles,
    code: impl Fn(&Aabb) -> [u32; W] + Sync,
) {
    stages.time("morton", || {
        sorter.resize(triangles.indices.len());
        let blocks = sorter.items().par_chunks(BLOCK).enumerate();
        blocks.for_each(|(block, items)| {
            for (item, i) in items.iter().zip((block * BLOCK) as u32..) {
                item.set(code(&triangles.triangle(i).bounds()), i);
            }
        });
    });
    stages.time("sort", || sorter.sort(key_bits));
}

/// Stage `snap`: triangles in leaf order, and the sorted codes as the topology reads them.
fn gather<const W: usize, C: Clone + Default + Send>(
    sorter: &mut Sorter<W>,
    triangles: &IndexedTriangles,
    scale: &Scale,
    leaves: &mut Vec<LeafTriangle>,
    codes: &mut Vec<C>,
    code: impl Fn([u32; W]) -> C + Sync,
) {
    let items = sorter.items();
    leaves.resize(items.len(), LeafTriangle::default());
    codes.resize(items.len(), C::default());
    let blocks = leaves
        .par_chunks_mut(BLOCK)
        .zip(codes.par_chunks_mut(BLOCK))
        .zip(items.par_chunks(BLOCK));
    blocks.for_each(|((leaves, codes), items)| {
        for ((leaf, to), item) in leaves.iter_mut().zip(codes).zip(items) {
            *leaf = leaf_triangle(item.index(), triangles, scale);
            *to = code(item.key());
        }
    });
}

/// Stage `topology`: which nodes are kept, where each comes, and its children.
fn connect<C: SortedCodes + Sync>(
    codes: &C,
    kept: &mut Vec<u32>,
    kept_before: &mut Vec<u32>,
    nodes: &mut Vec<Node>,
    splits: &mut Vec<u32>,
) {
    const WORDS: usize = BLOCK / 32;
    let word_count = (codes.count() as usize - 1).div_ceil(32);
    kept.resize(word_count, 0);
    kept_before.resize(word_count, 0);
    let blocks = kept
        .par_chunks_mut(WORDS)
        .zip(kept_before.par_chunks_mut(WORDS))
        .enumerate();
    blocks.for_each(|(block, (kept, counts))| {
        for ((bits, count), word) in kept.iter_mut().zip(counts).zip((block * WORDS) as u32..) {
            *bits = kept_nodes(word, codes);
            *count = bits.count_ones();
        }
    });
    let node_count = run_scan(kept_before, 0, word_count as u32, 0) as usize;

    // Each block of words writes the run of kept nodes that begins where the counts say.
    nodes.resize(node_count, Node::EMPTY);
    splits.resize(node_count, 0);
    let mut blocks = Vec::with_capacity(word_count.div_ceil(WORDS));
    let (mut rest, mut split_rest) = (nodes.as_mut_slice(), splits.as_mut_slice());
    for block in 0..word_count.div_ceil(WORDS) {
        let begin = kept_before[block * WORDS] as usize;
        let end = kept_before
            .get((block + 1) * WORDS)
            .map_or(node_count, |&next| next as usize);
        let (run, after) = rest.split_at_mut(end - begin);
        let (split_run, split_after) = split_rest.split_at_mut(end - begin);
        (rest, split_rest) = (after, split_after);
        blocks.push((block * WORDS, run, split_run));
    }
    let (kept, kept_before) = (kept.as_slice(), kept_before.as_slice());
    blocks
        .into_par_iter()
        .for_each(|(first_word, run, split_run)| {
            let mut places = run.iter_mut().zip(split_run);
            for (word, &bits) in kept.iter().enumerate().skip(first_word).take(WORDS) {
                let mut left = bits;
                while left != 0 {
                    let i = (word * 32) as u32 + left.trailing_zeros();
                    left &= left - 1;
                    if let Some((node, split)) = places.next() {
                        (*node, *split) = internal_node(i, codes, kept, kept_before);
                    }
                }
            }
        });
}

/// Stage `refit`, first half: boxes of groups, of pairs of groups, and so on to one.
fn fill_pyramid(triangles: &[LeafTriangle], pyramid: &mut Vec<PyramidBox>) {
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

/// Entries of all levels above and including one of this size.
fn pyramid_size(level_count: usize) -> usize {
    let mut size = level_count;
    let mut level = level_count;
    while level > 1 {
        level = level.div_ceil(2);
        size += level;
    }
    size
}

/// Stage `refit`, second half.
fn fill_boxes(
    triangles: &[LeafTriangle],
    pyramid: &[PyramidBox],
    splits: &[u32],
    nodes: &mut [Node],
) {
    let blocks = nodes.par_chunks_mut(BLOCK).zip(splits.par_chunks(BLOCK));
    blocks.for_each(|(nodes, splits)| {
        for (node, &split) in nodes.iter_mut().zip(splits) {
            *node = refit_node(*node, split, triangles, pyramid);
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
