//! A scene in the GPU's memory.

use super::buffer::{Range, upload};
use super::mesh::check_storage;
use super::{Gpu, GpuError, Mesh};
use crate::Material;
use slimbvh_core::shade::Material as CoreMaterial;
use wgpu::BufferUsages;

/// A mesh in the GPU's memory, with its materials.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The triangles.
    pub mesh: Mesh,
    pub(super) normals: Range,
    pub(super) material_indices: Range,
    pub(super) materials: Range,
    pub(super) has_mirrors: bool,
}

impl Scene {
    /// Copies a scene's mesh and materials to the GPU.
    ///
    /// # Errors
    /// Those of [`Mesh::upload`].
    pub fn upload(gpu: &Gpu, scene: &crate::Scene) -> Result<Self, GpuError> {
        Self::over(gpu, Mesh::upload(gpu, &scene.mesh)?, scene)
    }

    /// A scene whose mesh is on the GPU already.
    pub(super) fn over(gpu: &Gpu, mesh: Mesh, scene: &crate::Scene) -> Result<Self, GpuError> {
        let (normals, indices) = (&scene.mesh.normals, &scene.mesh.materials);
        let materials = scene.core_materials();
        gpu.checked(|| {
            let usage = BufferUsages::STORAGE;
            let normals = upload(gpu, "slimbvh normals", usage, normals);
            let indices = upload(gpu, "slimbvh material indices", usage, indices);
            let buffer = upload(gpu, "slimbvh materials", usage, &materials);
            Ok(Self {
                mesh,
                normals: Range::whole(&normals),
                material_indices: Range::whole(&indices),
                materials: Range::whole(&buffer),
                has_mirrors: has_mirrors(&materials),
            })
        })
    }

    /// Uses a mesh that is on the GPU. Without normals (three `f32` a vertex, unit length) it is shaded flat. Without
    /// material indices (a `u32` a triangle) it has the first material; without materials, a default one.
    ///
    /// # Errors
    /// For a buffer without the usage `STORAGE`.
    pub fn from_buffers(
        gpu: &Gpu,
        mesh: Mesh,
        normals: Option<wgpu::BufferSlice>,
        material_indices: Option<wgpu::BufferSlice>,
        materials: &[Material],
    ) -> Result<Self, GpuError> {
        let normals = normals.map(Range::of_slice);
        let material_indices = material_indices.map(Range::of_slice);
        if let Some(normals) = &normals {
            check_storage(gpu, "the buffer of normals", normals, 12)?;
        }
        if let Some(indices) = &material_indices {
            check_storage(gpu, "the buffer of material indices", indices, 4)?;
        }
        let scene = crate::Scene {
            materials: materials.to_vec(),
            ..crate::Scene::default()
        };
        let materials = scene.core_materials();
        gpu.checked(|| {
            let usage = BufferUsages::STORAGE;
            let empty = || Range::whole(&upload::<[f32; 3]>(gpu, "slimbvh nothing", usage, &[]));
            let buffer = upload(gpu, "slimbvh materials", usage, &materials);
            Ok(Self {
                mesh,
                normals: normals.unwrap_or_else(empty),
                material_indices: material_indices.unwrap_or_else(empty),
                materials: Range::whole(&buffer),
                has_mirrors: has_mirrors(&materials),
            })
        })
    }

    /// Copies the normals of vertices that have moved.
    pub(super) fn move_normals(&self, gpu: &Gpu, mesh: &crate::Mesh) {
        let (to, bytes) = (&self.normals, bytemuck::cast_slice(&mesh.normals));
        if !mesh.normals.is_empty() {
            gpu.queue().write_buffer(&to.buffer, to.offset, bytes);
        }
    }

    /// Bytes of the buffers.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        self.mesh.bytes() + self.normals.size + self.material_indices.size + self.materials.size
    }
}

/// Whether paths may continue at mirrors or through glass.
fn has_mirrors(materials: &[CoreMaterial]) -> bool {
    materials
        .iter()
        .any(|material| material.onward_share() > 0.0)
}
