//! The data between the stages of a build, computed with core's functions in plain loops: the expected inputs and outputs of
//! each kernel.

use slimbvh::{CodeBits, Mesh};
use slimbvh_core::bounds::{run_bounds, scene_exponent};
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::launch::BLOCK;
use slimbvh_core::morton::{MortonGrid, morton_code_30, morton_code_63};
use slimbvh_core::node::LEAF_SIZE;
use slimbvh_core::refit::{GROUP_SIZE, PyramidBox, refit_node};
use slimbvh_core::snap::leaf_triangle;
use slimbvh_core::topology::{Codes30, Codes63, SortedCodes, internal_node, kept_nodes};
use slimbvh_core::{Aabb, LeafTriangle, Node};

/// The stages of one build over more triangles than a leaf holds.
pub struct Chain {
    /// The box of each block of triangles, then the scene's.
    pub blocks: Vec<[f32; 6]>,
    pub scene: [f32; 6],
    pub exponent: i32,
    pub grid: MortonGrid,
    /// The sort's input and output: the words of a key, then the primitive.
    pub items: Vec<u32>,
    pub sorted: Vec<u32>,
    /// Sorted keys.
    pub codes: Vec<u32>,
    pub triangles: Vec<LeafTriangle>,
    /// A bit for each kept node, the number of bits in each word, and in all words before.
    pub kept: Vec<u32>,
    pub counts: Vec<u32>,
    pub before: Vec<u32>,
    /// Nodes without boxes, and the last triangle of each left child.
    pub bare_nodes: Vec<Node>,
    pub splits: Vec<u32>,
    /// All levels of the pyramid.
    pub pyramid: Vec<PyramidBox>,
    pub nodes: Vec<Node>,
}

impl Chain {
    /// `None` if the mesh is a single leaf.
    pub fn new(mesh: &Mesh, code_bits: CodeBits) -> Option<Self> {
        let triangles = mesh.triangles();
        let count = mesh.indices.len() as u32;
        if count <= LEAF_SIZE {
            return None;
        }
        let block = |first| run_bounds(first, BLOCK.min(count - first), &triangles);
        let firsts = (0..count).step_by(BLOCK as usize);
        let bounds = run_bounds(0, count, &triangles);
        let exponent = scene_exponent(&bounds);
        let grid = MortonGrid::new(&bounds, if is_short(code_bits) { 10 } else { 21 });

        // A stable sort by the key alone.
        let key = |i: u32| {
            let bounds = triangles.triangle(i).bounds();
            match code_bits {
                CodeBits::Bits30 => vec![morton_code_30(&bounds, &grid)],
                CodeBits::Bits63 => morton_code_63(&bounds, &grid).to_vec(),
            }
        };
        let items: Vec<(Vec<u32>, u32)> = (0..count).map(|i| (key(i), i)).collect();
        let mut sorted = items.clone();
        sorted.sort_by(|a, b| a.0.cmp(&b.0));
        let words = |items: &[(Vec<u32>, u32)]| -> Vec<u32> {
            let item = |(key, i): &(Vec<u32>, u32)| [key.as_slice(), &[*i]].concat();
            items.iter().flat_map(item).collect()
        };
        let codes: Vec<u32> = sorted.iter().flat_map(|(key, _)| key.clone()).collect();
        let scale = PowerOfTwo::new(exponent);
        let leaf = |(_, i): &(Vec<u32>, u32)| leaf_triangle(*i, &triangles, &scale);

        let mut chain = Self {
            blocks: firsts.map(|first| numbers(&block(first))).collect(),
            scene: numbers(&bounds),
            exponent,
            grid,
            items: words(&items),
            sorted: words(&sorted),
            triangles: sorted.iter().map(leaf).collect(),
            codes,
            kept: Vec::new(),
            counts: Vec::new(),
            before: Vec::new(),
            bare_nodes: Vec::new(),
            splits: Vec::new(),
            pyramid: Vec::new(),
            nodes: Vec::new(),
        };
        let codes = chain.codes.clone();
        match code_bits {
            CodeBits::Bits30 => chain.connect(&Codes30::all(&codes)),
            CodeBits::Bits63 => chain.connect(&Codes63::all(bytemuck::cast_slice(&codes))),
        }
        chain.fit();
        Some(chain)
    }

    fn connect<C: SortedCodes>(&mut self, codes: &C) {
        let words = (codes.count() - 1).div_ceil(32);
        self.kept = (0..words).map(|word| kept_nodes(word, codes)).collect();
        self.counts = self.kept.iter().map(|word| word.count_ones()).collect();
        let sums = self.counts.iter().scan(0, |sum, &count| {
            *sum += count;
            Some(*sum - count)
        });
        self.before = sums.collect();
        let is_kept = |i: &u32| self.kept[*i as usize / 32] >> (i % 32) & 1 == 1;
        let nodes = (0..codes.count() - 1).filter(is_kept);
        (self.bare_nodes, self.splits) = nodes
            .map(|i| internal_node(i, codes, &self.kept, &self.before))
            .unzip();
    }

    fn fit(&mut self) {
        self.pyramid = pyramid(&self.triangles);
        let nodes = self.bare_nodes.iter().zip(&self.splits);
        self.nodes = nodes
            .map(|(&node, &split)| refit_node(node, split, &self.triangles, &self.pyramid))
            .collect();
    }

    /// The uniforms of the kernels.
    pub fn exponent_uniform(&self) -> [u32; 4] {
        [self.exponent as u32, 0, 0, 0]
    }

    /// The number of nodes with the dispatch that `scan_apply` stores beside it.
    pub fn total_uniform(&self) -> [u32; 4] {
        let count = self.nodes.len() as u32;
        let [x, y, z] = slimbvh_core::launch::dispatch(count.div_ceil(64));
        [count, x, y, z]
    }
}

/// All levels of the pyramid, each entry from its triangles alone, in plain loops.
pub fn pyramid(triangles: &[LeafTriangle]) -> Vec<PyramidBox> {
    let corners = |leaf: &LeafTriangle| {
        let v = leaf.vertices;
        [[v[0], v[1], v[2]], [v[3], v[4], v[5]], [v[6], v[7], v[8]]]
    };
    let bounds = |run: &[LeafTriangle]| {
        let mut bounds = PyramidBox::EMPTY;
        for corner in run.iter().flat_map(corners) {
            for (axis, x) in corner.into_iter().enumerate() {
                bounds.0[axis] = bounds.0[axis].min(x);
                bounds.0[4 + axis] = bounds.0[4 + axis].max(x);
            }
        }
        bounds
    };
    let mut pyramid = Vec::new();
    let mut run = GROUP_SIZE as usize;
    loop {
        pyramid.extend(triangles.chunks(run).map(bounds));
        if run >= triangles.len() {
            return pyramid;
        }
        run *= 2;
    }
}

/// Min, then max.
pub fn numbers(bounds: &Aabb) -> [f32; 6] {
    let ([a, b, c], [d, e, f]) = (bounds.min.to_array(), bounds.max.to_array());
    [a, b, c, d, e, f]
}

/// Whether a key has one word.
pub fn is_short(code_bits: CodeBits) -> bool {
    code_bits == CodeBits::Bits30
}
