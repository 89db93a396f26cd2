//! Copies of a hierarchy, or of its counts, to the host.

use super::{Built, Bvh, Coded, Coding, Counts};
use crate::gpu::buffer::{Download, Mapped};
use crate::gpu::{Frame, Gpu, GpuError, Misfit};
use crate::tree::{ListReader, StoredTree};
use bytemuck::Pod;
use slimbvh_core::encode::RootWords;
use slimbvh_core::fit::Fit;
use slimbvh_core::{Aabb, LeafTriangle, Node};

impl Bvh {
    /// Reads the numbers of inner nodes, as they are stored, and of triangles. Waits for the GPU.
    ///
    /// # Errors
    /// If it is not built yet, or a set that did not fit, or the device was lost.
    pub fn read_counts(&self, gpu: &Gpu) -> Result<[u32; 2], GpuError> {
        gpu.block_on(self.read_counts_async(gpu))
    }

    /// [`Self::read_counts`], without blocking.
    ///
    /// # Errors
    /// If it is not built yet, or a set that did not fit, or the device was lost; in a browser, also the errors of earlier calls.
    pub async fn read_counts_async(&self, gpu: &Gpu) -> Result<[u32; 2], GpuError> {
        let counts = self.read_all_counts(gpu).await?;
        Ok([counts.nodes, counts.triangles])
    }

    /// The counts, by one submission.
    async fn read_all_counts(&self, gpu: &Gpu) -> Result<Counts, GpuError> {
        let built = self.built()?;
        let mut frame = gpu.frame();
        let counts = gpu.checked(|| Ok(built.counts_later(&mut frame)))?;
        frame.submit()?;
        counts.read(built, gpu).await
    }

    /// The counts, and the bytes of nodes and triangles. Waits for the GPU.
    pub(in crate::gpu) fn read_size(&self, gpu: &Gpu) -> Result<(Counts, [u64; 2]), GpuError> {
        let counts = gpu.block_on(self.read_all_counts(gpu))?;
        Ok((counts, self.built()?.bytes(counts)))
    }

    /// Reads the bytes that the nodes and the triangles in leaves use. Waits for the GPU. The buffers have room for more.
    ///
    /// # Errors
    /// If it is not built yet, or a set that did not fit, or the device was lost.
    pub fn read_bytes(&self, gpu: &Gpu) -> Result<[u64; 2], GpuError> {
        gpu.block_on(self.read_bytes_async(gpu))
    }

    /// [`Self::read_bytes`], without blocking.
    ///
    /// # Errors
    /// If it is not built yet, or a set that did not fit, or the device was lost; in a browser, also the errors of earlier calls.
    pub async fn read_bytes_async(&self, gpu: &Gpu) -> Result<[u64; 2], GpuError> {
        let counts = self.read_all_counts(gpu).await?;
        Ok(self.built()?.bytes(counts))
    }

    /// Copies the hierarchy to the host. Waits for the GPU.
    ///
    /// # Errors
    /// If it is not built yet, or a set that did not fit, or the device was lost.
    pub fn download(&self, gpu: &Gpu) -> Result<crate::Bvh, GpuError> {
        gpu.block_on(self.download_async(gpu))
    }

    /// [`Self::download`], without blocking.
    ///
    /// # Errors
    /// If it is not built yet, or a set that did not fit, or the device was lost; in a browser, also the errors of earlier calls.
    pub async fn download_async(&self, gpu: &Gpu) -> Result<crate::Bvh, GpuError> {
        let built = self.built()?;
        let mut frame = gpu.frame();
        let [nodes, triangles] = built.stored();
        let ranges = [&built.exponent, &built.bounds, nodes, triangles];
        let counts = gpu.checked(|| Ok(built.counts_later(&mut frame)))?;
        let [exponent, bounds, nodes, triangles] =
            gpu.checked(|| Ok(ranges.map(|range| frame.download(range))))?;
        let coded = built.coded.as_ref();
        let root = gpu.checked(|| {
            let root = |coded: &Coded| frame.download(&coded.root);
            Ok(coded.map(root))
        })?;
        frame.submit()?;
        let counts = counts.read(built, gpu).await?;
        let triangle_count = counts.triangles as usize;
        let exponent: Vec<i32> = exponent.read_async(gpu).await?;
        let corners: Vec<[f32; 3]> = bounds.read_async(gpu).await?;
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
        let root: Vec<RootWords> = match root {
            Some(root) => root.read_async(gpu).await?,
            None => Vec::new(),
        };
        let root = root.first().copied().unwrap_or_default();
        let is_mixed = coded.is_some_and(|coded| coded.coding.is_mixed());
        let mut lists = Lists {
            nodes: Some(nodes.map(gpu).await?),
            node_count: counts.nodes as usize,
            triangles: Some(triangles.map(gpu).await?),
            triangle_items: if is_mixed {
                counts.words as usize
            } else {
                triangle_count
            },
        };
        bvh.stored = StoredTree::read(built.codecs, &root, triangle_count, &mut lists)?;
        Ok(bvh)
    }
}

impl Built {
    /// Copies the counts.
    fn counts_later(&self, frame: &mut Frame<'_>) -> CountsLater {
        let fallback = self.fallback.as_ref();
        CountsLater {
            fit: fallback.map(|fallback| frame.download(&fallback.fit)),
            totals: self.totals().map(|range| frame.download(range)),
        }
    }

    /// The bytes that the nodes and the triangles in leaves use.
    fn bytes(&self, counts: Counts) -> [u64; 2] {
        let coding = self.coding();
        let node_bytes = coding.map_or(size_of::<Node>() as u64, Coding::node_bytes);
        let triangle_bytes = if coding.is_some_and(Coding::is_mixed) {
            4 * u64::from(counts.words)
        } else {
            let count = u64::from(counts.triangles);
            let coded = coding.and_then(|coding| coding.most_triangle_bytes(count));
            coded.unwrap_or(count * size_of::<LeafTriangle>() as u64)
        };
        [u64::from(counts.nodes) * node_bytes, triangle_bytes]
    }
}

/// A copy of counts.
struct CountsLater {
    /// What is known of a set that may not fit.
    fit: Option<Download>,
    totals: [Download; 4],
}

impl CountsLater {
    /// Refuses a set that did not fit.
    async fn read(self, built: &Built, gpu: &Gpu) -> Result<Counts, GpuError> {
        if let Some(fit) = self.fit {
            let fit: Vec<Fit> = fit.read_async(gpu).await?;
            if let Some(&Fit { count, limit, .. }) = fit.first().filter(|fit| !fit.fits()) {
                return Err(Misfit::DoesNotFit { count, limit }.of("the hierarchy of a set"));
            }
        }
        Ok(built.counts(firsts(gpu, self.totals).await?))
    }
}

/// Copies of both lists. Each is read once.
struct Lists<'g> {
    nodes: Option<Mapped<'g>>,
    node_count: usize,
    triangles: Option<Mapped<'g>>,
    triangle_items: usize,
}

impl ListReader for Lists<'_> {
    type Error = GpuError;

    fn nodes<T: Pod>(&mut self, per_node: usize) -> Result<Vec<T>, GpuError> {
        take(self.nodes.take(), self.node_count * per_node)
    }

    fn triangles<T: Pod>(&mut self) -> Result<Vec<T>, GpuError> {
        take(self.triangles.take(), self.triangle_items)
    }
}

/// The first elements of a buffer.
fn take<T: Pod>(from: Option<Mapped>, count: usize) -> Result<Vec<T>, GpuError> {
    let Some(from) = from else {
        return Ok(Vec::new());
    };
    let mut all = from.read()?;
    all.truncate(count);
    Ok(all)
}

/// The first words of copies.
async fn firsts<const N: usize>(gpu: &Gpu, downloads: [Download; N]) -> Result<[u32; N], GpuError> {
    let mut firsts = [0; N];
    for (first, download) in firsts.iter_mut().zip(downloads) {
        let words: Vec<u32> = download.read_async(gpu).await?;
        *first = words.first().copied().unwrap_or(0);
    }
    Ok(firsts)
}
