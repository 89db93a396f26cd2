//! A mesh in the GPU's memory.

use super::buffer::{Range, upload};
use super::{Gpu, GpuError, Misfit};
use crate::MeshError;
use slimbvh_core::MAX_TRIANGLES;
use wgpu::BufferUsages;

/// Bytes of a vertex, and of a triangle's three indices.
const ELEMENT_BYTES: u64 = 12;

/// Triangles as indices into shared vertices, in buffers.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    pub(super) vertices: Range,
    pub(super) indices: Range,
    pub(super) triangle_count: u32,
}

impl Mesh {
    /// Copies a mesh to the GPU.
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
            })
        })
    }

    /// Uses the caller's buffers: three `f32` a vertex and three `u32` a triangle, without gaps. The lengths of the slices
    /// give the counts.
    ///
    /// Nothing is read back, so the contents are unchecked: coordinates must be finite. A corner whose index is out of
    /// range counts as a vertex at the origin.
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
        if triangle_count > u64::from(MAX_TRIANGLES) {
            return Err(GpuError::Mesh(MeshError::TooManyTriangles {
                triangle_count: triangle_count as usize,
                limit: MAX_TRIANGLES as usize,
            }));
        }
        Ok(Self {
            vertices,
            indices,
            triangle_count: triangle_count as u32,
        })
    }

    /// Copies vertices that have moved.
    pub(super) fn move_vertices(&self, gpu: &Gpu, mesh: &crate::Mesh) {
        let (to, bytes) = (&self.vertices, bytemuck::cast_slice(&mesh.vertices));
        if !mesh.vertices.is_empty() {
            gpu.queue().write_buffer(&to.buffer, to.offset, bytes);
        }
    }

    /// Reads the mesh back: positions and indices. Waits for all work that was submitted before.
    ///
    /// # Errors
    /// For a buffer without the usage `COPY_SRC`, and if the device was lost.
    pub fn download(&self, gpu: &Gpu) -> Result<crate::Mesh, GpuError> {
        let mut frame = gpu.frame();
        let vertices = frame.read_range("the buffer of vertices", &self.vertices)?;
        let indices = frame.read_range("the buffer of indices", &self.indices)?;
        frame.submit()?;
        Ok(crate::Mesh {
            vertices: vertices.read(gpu)?,
            indices: indices.read(gpu)?,
            ..crate::Mesh::default()
        })
    }

    /// The number of triangles.
    #[must_use]
    pub fn triangle_count(&self) -> u32 {
        self.triangle_count
    }

    /// The buffer of vertices, to move them.
    #[must_use]
    pub fn vertex_buffer(&self) -> &wgpu::Buffer {
        &self.vertices.buffer
    }

    /// Bytes of both buffers.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        self.vertices.size + self.indices.size
    }
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
