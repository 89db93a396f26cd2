//! A mesh in the GPU's memory.

use super::buffer::{Range, Slot, upload};
use super::gather::{ELEMENT_BYTES, IndexLayout, Source, VertexLayout};
use super::program::Recorder;
use super::{Gpu, GpuError, Misfit};
use crate::MeshError;
use slimbvh_core::MAX_TRIANGLES;
use wgpu::BufferUsages;

/// Triangles as indices into shared vertices, in buffers.
///
/// ```no_run
/// use slimbvh::gpu::{Builder, Bvh, Gpu, GpuError, Mesh};
/// # fn run(gpu: &Gpu, mesh: &slimbvh::Mesh) -> Result<(), GpuError> {
/// let mesh = Mesh::upload(gpu, mesh)?;
/// let (mut builder, mut bvh) = (Builder::new(slimbvh::BuildConfig::default()), Bvh::new());
/// let mut frame = gpu.frame();
/// builder.build(&mut frame, &mesh, &mut bvh)?;
/// frame.submit()?;
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    /// Positions without gaps.
    pub(super) vertices: Range,
    /// Three `u32` a triangle without gaps.
    pub(super) indices: Range,
    pub(super) triangle_count: u32,
    /// What vertices and indices are gathered from, where those are not the caller's own buffers.
    pub(super) sources: [Option<Source>; 2],
}

impl Mesh {
    /// Copies a mesh to the GPU.
    ///
    /// ```no_run
    /// # use slimbvh::gpu::{Gpu, GpuError, Mesh};
    /// # fn run(gpu: &Gpu) -> Result<(), GpuError> {
    /// let triangle = slimbvh::Mesh {
    ///     vertices: vec![[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 2.0, 0.0]],
    ///     indices: vec![[0, 1, 2]],
    ///     ..slimbvh::Mesh::default()
    /// };
    /// let mesh = Mesh::upload(gpu, &triangle)?;
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// Those of [`crate::Mesh::validate`], and for a mesh above the GPU's limits.
    pub fn upload(gpu: &Gpu, mesh: &crate::Mesh) -> Result<Self, GpuError> {
        mesh.validate()?;
        gpu.check_sizes(
            &[
                ("the vertices", size_of_val(mesh.vertices.as_slice()) as u64),
                ("the indices", size_of_val(mesh.indices.as_slice()) as u64),
            ],
            "take a smaller mesh, or the CPU",
        )?;
        gpu.checked(|| {
            let usage = BufferUsages::STORAGE;
            let vertices = upload(gpu, "slimbvh vertices", usage, &mesh.vertices);
            let indices = upload(gpu, "slimbvh indices", usage, &mesh.indices);
            Ok(Self {
                vertices: Range::whole(&vertices),
                indices: Range::whole(&indices),
                triangle_count: mesh.indices.len() as u32,
                sources: [None, None],
            })
        })
    }

    /// Uses the caller's buffers in any layout: positions anywhere in interleaved vertices, indices of 16 or 32 bits.
    ///
    /// What kernels cannot read in place is copied into buffers of slimbvh's own, 12 bytes a vertex and 12 bytes a triangle, at the
    /// beginning of each sort, build and refit (stage `gather`): they see what the caller's buffers hold at that point of the frame.
    /// Positions 12 bytes apart and indices of 32 bits are read in place.
    ///
    /// Nothing is read back, so the contents are unchecked: coordinates must be finite. A corner whose index is out of
    /// range counts as a vertex at the origin.
    ///
    /// ```no_run
    /// use slimbvh::gpu::{Gpu, GpuError, IndexLayout, Mesh, VertexLayout, wgpu};
    /// # fn run(gpu: &Gpu, vertices: &wgpu::Buffer, indices: &wgpu::Buffer) -> Result<Mesh, GpuError> {
    /// // Position, normal and texture coordinates in 32 bytes a vertex; two bytes an index.
    /// let vertices = VertexLayout { slice: vertices.slice(..), stride: 32, offset: 0 };
    /// let indices = IndexLayout { slice: indices.slice(..), format: wgpu::IndexFormat::Uint16 };
    /// let mesh = Mesh::from_layout(gpu, vertices, indices)?;
    /// # Ok(mesh)
    /// # }
    /// ```
    ///
    /// # Errors
    /// For numbers and slices that do not fit each other, by name and number; for a buffer without the usage `STORAGE`, more bytes
    /// than a storage binding allows, and more than 2^28 triangles.
    pub fn from_layout(
        gpu: &Gpu,
        vertices: VertexLayout,
        indices: IndexLayout,
    ) -> Result<Self, GpuError> {
        let sources = [vertices.source(gpu)?, indices.source(gpu)?];
        check_triangle_count(sources[1].count)?;
        let are_tight = [
            vertices.is_tight(),
            indices.format == wgpu::IndexFormat::Uint32,
        ];
        let alignment = u64::from(gpu.limits().min_storage_buffer_offset_alignment);
        let triangle_count = sources[1].count as u32;
        let [mut own_vertices, mut own_indices] = [
            Slot::storage("slimbvh gathered vertices"),
            Slot::storage("slimbvh gathered indices"),
        ];
        gpu.check_sizes(
            &[
                ("the vertices without gaps", sources[0].tight_bytes()),
                ("the indices without gaps", sources[1].tight_bytes()),
            ],
            "take a part of them",
        )?;
        gpu.checked(|| {
            let place =
                |slice: wgpu::BufferSlice, is_tight: bool, source: Source, own: &mut Slot| {
                    if is_tight && slice.offset().is_multiple_of(alignment) {
                        (Range::of_slice(slice), None)
                    } else {
                        (own.range(gpu, source.tight_bytes()), Some(source))
                    }
                };
            let [first, second] = sources;
            let (vertices, from) = place(vertices.slice, are_tight[0], first, &mut own_vertices);
            let (indices, and_from) = place(indices.slice, are_tight[1], second, &mut own_indices);
            Ok(Self {
                vertices,
                indices,
                triangle_count,
                sources: [from, and_from],
            })
        })
    }

    /// Uses the caller's buffers in place: three `f32` a vertex and three `u32` a triangle, without gaps. The lengths of the slices
    /// give the counts.
    ///
    /// Any bytes are read as that: interleaved vertices and indices of 16 bits, whose sizes may fit by chance, take
    /// [`Self::from_layout`].
    ///
    /// Nothing is read back, so the contents are unchecked: coordinates must be finite. A corner whose index is out of
    /// range counts as a vertex at the origin.
    ///
    /// ```no_run
    /// # use slimbvh::gpu::{Gpu, GpuError, Mesh, wgpu};
    /// # fn run(gpu: &Gpu, geometry: &wgpu::Buffer, vertex_bytes: u64) -> Result<(), GpuError> {
    /// // Positions, then indices, in one buffer.
    /// let (vertices, indices) = (geometry.slice(..vertex_bytes), geometry.slice(vertex_bytes..));
    /// let mesh = Mesh::from_buffers(gpu, vertices, indices)?;
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// For a buffer without the usage `STORAGE`, a slice at an unaligned offset, more bytes than a storage binding allows,
    /// and more than 2^28 triangles.
    pub fn from_buffers(
        gpu: &Gpu,
        vertices: wgpu::BufferSlice,
        indices: wgpu::BufferSlice,
    ) -> Result<Self, GpuError> {
        let (vertices, indices) = (Range::of_slice(vertices), Range::of_slice(indices));
        for (what, range) in [
            ("the buffer of vertices", &vertices),
            ("the buffer of indices", &indices),
        ] {
            check_storage(gpu, what, range, ELEMENT_BYTES)?;
        }
        let triangle_count = indices.size / ELEMENT_BYTES;
        check_triangle_count(triangle_count)?;
        Ok(Self {
            vertices,
            indices,
            triangle_count: triangle_count as u32,
            sources: [None, None],
        })
    }

    /// Copies the vertices of a mesh that is known to have the same counts.
    pub(super) fn move_vertices(&self, gpu: &Gpu, mesh: &crate::Mesh) {
        let (to, bytes) = (&self.vertices, bytemuck::cast_slice(&mesh.vertices));
        if !mesh.vertices.is_empty() {
            gpu.queue().write_buffer(&to.buffer, to.offset, bytes);
        }
    }

    /// The numbers of triangles and of vertices.
    pub(super) fn counts(&self) -> [u64; 2] {
        [
            u64::from(self.triangle_count),
            self.vertices.size / ELEMENT_BYTES,
        ]
    }

    /// Refuses a mesh on the host that has other counts.
    pub(super) fn check_counts(&self, rest: &crate::Mesh) -> Result<(), GpuError> {
        let own = self.counts();
        let surfaces = [rest.indices.len(), rest.vertices.len()].map(|count| count as u64);
        if own == surfaces {
            return Ok(());
        }
        let fault = Misfit::OtherMesh {
            triangle_count: own[0],
            vertex_count: own[1],
            surfaces,
        };
        Err(fault.of("the mesh in buffers"))
    }

    /// Reads the mesh back: positions and indices, as they are once all work submitted before is done. Waits for that.
    ///
    /// ```no_run
    /// # use slimbvh::gpu::{Gpu, GpuError, Mesh};
    /// # fn run(gpu: &Gpu, mesh: &Mesh) -> Result<(), GpuError> {
    /// // The caller's shaders moved the vertices: is what they made still sound?
    /// mesh.download(gpu)?.validate()?;
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// If memory is exhausted, or the device was lost.
    pub fn download(&self, gpu: &Gpu) -> Result<crate::Mesh, GpuError> {
        let mut frame = gpu.frame();
        let (vertices, indices) = gpu.checked(|| {
            let mesh = self.readable(gpu);
            let mut recorder = Recorder::default();
            mesh.record_gather(&mut recorder);
            recorder.finish(gpu)?.encode(&mut frame);
            Ok((
                frame.download(&mesh.vertices),
                frame.download(&mesh.indices),
            ))
        })?;
        frame.submit()?;
        Ok(crate::Mesh {
            vertices: vertices.read(gpu)?,
            indices: indices.read(gpu)?,
            ..crate::Mesh::default()
        })
    }

    /// The number of triangles.
    ///
    /// ```no_run
    /// # use slimbvh::gpu::Mesh;
    /// # fn run(mesh: &Mesh) {
    /// println!("{:.1} bytes a triangle", mesh.bytes() as f64 / f64::from(mesh.triangle_count()));
    /// # }
    /// ```
    #[must_use]
    pub fn triangle_count(&self) -> u32 {
        self.triangle_count
    }

    /// The buffer of vertices, to move them: the caller's where there is one.
    ///
    /// ```no_run
    /// # use slimbvh::gpu::{Gpu, Mesh};
    /// # fn run(gpu: &Gpu, mesh: &Mesh, moved: &[[f32; 3]]) {
    /// // The frame that is submitted next refits its tree to these positions.
    /// gpu.queue().write_buffer(mesh.vertex_buffer(), 0, bytemuck::cast_slice(moved));
    /// # }
    /// ```
    #[must_use]
    pub fn vertex_buffer(&self) -> &wgpu::Buffer {
        let [source, _] = &self.sources;
        let range = source.as_ref().map_or(&self.vertices, |from| &from.words);
        &range.buffer
    }

    /// Bytes of the vertices and indices that kernels read, without gaps.
    ///
    /// ```no_run
    /// # use slimbvh::gpu::{Bvh, Mesh};
    /// # fn run(mesh: &Mesh, bvh: &Bvh) {
    /// println!("mesh {} bytes, tree {} bytes", mesh.bytes(), bvh.bytes());
    /// # }
    /// ```
    #[must_use]
    pub fn bytes(&self) -> u64 {
        self.vertices.size + self.indices.size
    }
}

/// Refuses more triangles than a hierarchy can number.
fn check_triangle_count(triangle_count: u64) -> Result<(), GpuError> {
    if triangle_count > u64::from(MAX_TRIANGLES) {
        return Err(GpuError::Mesh(MeshError::TooManyTriangles {
            triangle_count: triangle_count as usize,
            limit: MAX_TRIANGLES as usize,
        }));
    }
    Ok(())
}

/// Refuses a range of the caller's that cannot be bound.
pub fn check_storage(
    gpu: &Gpu,
    what: &'static str,
    range: &Range,
    element_bytes: u64,
) -> Result<(), GpuError> {
    check_parts(gpu, what, range, element_bytes)?;
    gpu.check_sizes(&[(what, range.size)], "take a part of it")
}

/// Refuses a range of the caller's that cannot be bound even in parts.
pub fn check_parts(
    gpu: &Gpu,
    what: &'static str,
    range: &Range,
    element_bytes: u64,
) -> Result<(), GpuError> {
    let unfit = |fault: Misfit| Err(fault.of(what));
    if !range.buffer.usage().contains(BufferUsages::STORAGE) {
        return unfit(Misfit::MissingUsage { usage: "STORAGE" });
    }
    let alignment = u64::from(gpu.limits().min_storage_buffer_offset_alignment);
    if !range.offset.is_multiple_of(alignment) {
        return unfit(Misfit::MisalignedOffset {
            offset: range.offset,
            alignment,
        });
    }
    if range.size == 0 || !range.size.is_multiple_of(element_bytes) {
        return unfit(Misfit::PartialElement {
            bytes: range.size,
            element_bytes,
        });
    }
    Ok(())
}

/// Refuses a range of the caller's whose words cannot be bound. Returns a range of words that can be and holds it, and how many bytes
/// of that are before the given one, which begins at any multiple of `unit_bytes`.
pub fn check_words(
    gpu: &Gpu,
    what: &'static str,
    range: &Range,
    unit_bytes: u64,
) -> Result<(Range, u64), GpuError> {
    if !range.buffer.usage().contains(BufferUsages::STORAGE) {
        return Err(Misfit::MissingUsage { usage: "STORAGE" }.of(what));
    }
    if !range.offset.is_multiple_of(unit_bytes) {
        let fault = Misfit::MisalignedOffset {
            offset: range.offset,
            alignment: unit_bytes,
        };
        return Err(fault.of(what));
    }
    let end = range.offset + range.size;
    let whole_end = end.next_multiple_of(4);
    if whole_end > range.buffer.size() {
        return Err(Misfit::EndsWithinWord { end }.of(what));
    }
    let alignment = u64::from(gpu.limits().min_storage_buffer_offset_alignment).max(4);
    let begin = range.offset / alignment * alignment;
    let words = Range::whole(&range.buffer).part(begin, whole_end - begin);
    gpu.check_sizes(&[(what, words.size)], "take a part of it")?;
    Ok((words, range.offset - begin))
}
