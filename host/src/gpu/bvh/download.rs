//! Copies of a hierarchy, or of its counts, to the host.

use super::{Bvh, Coded, Coding};
use crate::gpu::buffer::Download;
use crate::gpu::{Gpu, GpuError};
use crate::tree::{ListReader, StoredTree};
use bytemuck::Pod;
use slimbvh_core::encode::RootWords;
use slimbvh_core::{Aabb, LeafTriangle, Node};

impl Bvh {
    /// Reads the numbers of inner nodes and triangles. Waits for the GPU.
    ///
    /// # Errors
    /// If it is not built yet, or the device was lost.
    pub fn read_counts(&self, gpu: &Gpu) -> Result<[u32; 2], GpuError> {
        let built = self.built()?;
        let [total, count] = read_firsts(gpu, [&built.total, &built.count])?;
        Ok([total, count])
    }

    /// Reads the bytes that the nodes and the triangles in leaves use. Waits for the GPU. The buffers have room for more.
    ///
    /// # Errors
    /// If it is not built yet, or the device was lost.
    pub fn read_bytes(&self, gpu: &Gpu) -> Result<[u64; 2], GpuError> {
        let built = self.built()?;
        let [node_count, triangle_count] = self.read_counts(gpu)?.map(u64::from);
        let coding = built.coding();
        let node_bytes = coding.map_or(size_of::<Node>() as u64, Coding::node_bytes);
        let triangle_bytes = match &built.coded {
            Some(coded) if coded.coding.is_mixed() => {
                let [words] = read_firsts(gpu, [&coded.word_total])?;
                4 * u64::from(words)
            }
            _ => {
                let each = coding.and_then(Coding::most_triangle_bytes);
                triangle_count * each.unwrap_or(size_of::<LeafTriangle>() as u64)
            }
        };
        Ok([node_count * node_bytes, triangle_bytes])
    }

    /// Copies the hierarchy to the host. Waits for the GPU.
    ///
    /// # Errors
    /// If it is not built yet, or the device was lost.
    pub fn download(&self, gpu: &Gpu) -> Result<crate::Bvh, GpuError> {
        let built = self.built()?;
        let mut frame = gpu.frame();
        let [nodes, triangles] = built.stored();
        let ranges = [
            &built.total,
            &built.count,
            &built.exponent,
            &built.bounds,
            nodes,
            triangles,
        ];
        let [total, count, exponent, bounds, nodes, triangles] =
            gpu.checked(|| Ok(ranges.map(|range| frame.download(range))))?;
        let coded = built.coded.as_ref();
        let root = gpu.checked(|| {
            let root = |coded: &Coded| [&coded.root, &coded.word_total].map(|r| frame.download(r));
            Ok(coded.map(root))
        })?;
        frame.submit()?.wait()?;
        let first = |words: Vec<u32>| words.first().map_or(0, |&word| word as usize);
        let (node_count, triangle_count) = (first(total.read(gpu)?), first(count.read(gpu)?));
        let exponent: Vec<i32> = exponent.read(gpu)?;
        let corners: Vec<[f32; 3]> = bounds.read(gpu)?;
        let mut bvh = crate::Bvh {
            mesh_triangle_count: built.triangle_count as usize,
            depth_bound: built.depth_bound,
            ..crate::Bvh::default()
        };
        let corner = |i: usize| corners.get(i).copied().unwrap_or_default().into();
        bvh.set_bounds(Aabb {
            min: corner(0),
            max: corner(1),
        });
        bvh.scene_exponent = exponent.first().copied().unwrap_or(0);
        let (root, word_count) = match root {
            Some([root, words]) => {
                let root: Vec<RootWords> = root.read(gpu)?;
                (
                    root.first().copied().unwrap_or_default(),
                    first(words.read(gpu)?),
                )
            }
            None => Default::default(),
        };
        let is_mixed = coded.is_some_and(|coded| coded.coding.is_mixed());
        let mut lists = Lists {
            gpu,
            nodes: Some(nodes),
            node_count,
            triangles: Some(triangles),
            triangle_items: if is_mixed { word_count } else { triangle_count },
        };
        bvh.stored = StoredTree::read(built.codecs, &root, triangle_count, &mut lists)?;
        Ok(bvh)
    }
}

/// Copies of both lists. Each is read once.
struct Lists<'a> {
    gpu: &'a Gpu,
    nodes: Option<Download>,
    node_count: usize,
    triangles: Option<Download>,
    triangle_items: usize,
}

impl ListReader for Lists<'_> {
    type Error = GpuError;

    fn nodes<T: Pod>(&mut self, per_node: usize) -> Result<Vec<T>, GpuError> {
        take(self.gpu, self.nodes.take(), self.node_count * per_node)
    }

    fn triangles<T: Pod>(&mut self) -> Result<Vec<T>, GpuError> {
        take(self.gpu, self.triangles.take(), self.triangle_items)
    }
}

/// The first elements of a buffer.
fn take<T: Pod>(gpu: &Gpu, from: Option<Download>, count: usize) -> Result<Vec<T>, GpuError> {
    let Some(from) = from else {
        return Ok(Vec::new());
    };
    let mut all = from.read(gpu)?;
    all.truncate(count);
    Ok(all)
}

/// The first word of each range.
fn read_firsts<const N: usize>(
    gpu: &Gpu,
    ranges: [&super::Range; N],
) -> Result<[u32; N], GpuError> {
    let mut frame = gpu.frame();
    let downloads = gpu.checked(|| Ok(ranges.map(|range| frame.download(range))))?;
    frame.submit()?.wait()?;
    let mut firsts = [0; N];
    for (first, download) in firsts.iter_mut().zip(downloads) {
        let words: Vec<u32> = download.read(gpu)?;
        *first = words.first().copied().unwrap_or(0);
    }
    Ok(firsts)
}
