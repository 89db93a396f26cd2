//! The size of a scene by the counts of its accessors, before any triangle is placed. A small file can describe a scene that no memory
//! holds: nodes share meshes, and each can have many instances.

use super::super::LoadError;
use super::super::load::Source;
use super::buffers::Buffers;
use super::instances::counting;
use super::json::{Index, Mesh, Primitive, Root};
use super::materials::is_invisible;
use super::nodes::Visited;
use super::primitive::{Mode, triangle_count};
use crate::{MeshError, Part};

/// The size of a scene, or more.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Size {
    pub triangle_count: usize,
    pub vertex_count: usize,
    /// Nodes and instances with triangles.
    pub part_count: usize,
}

impl Size {
    /// The size of the visited nodes. Faults count as nothing: placing names them.
    pub fn of(root: &Root, visited: &[Visited<'_>], buffers: &Buffers<'_>) -> Self {
        let mut all = Self::default();
        for it in visited.iter().filter(|it| !it.is_hidden) {
            let mesh = it.node.mesh.and_then(|mesh| root.meshes.get(mesh.0));
            let mut once = Self::default();
            for primitive in mesh.iter().flat_map(|mesh| &mesh.primitives) {
                once.add_primitive(primitive, root, buffers);
            }
            if once.triangle_count == 0 {
                continue;
            }
            let instancing = it.node.extensions.instancing.as_ref();
            let accessor = instancing.and_then(counting);
            let instances = accessor.and_then(|accessor| count(accessor, root, buffers));
            let is_skinned = it.node.skin.is_some() && mesh.is_some_and(has_joints);
            let count = instances.filter(|_| !is_skinned).unwrap_or(1);
            let add = |sum: &mut usize, once: usize| {
                *sum = sum.saturating_add(once.saturating_mul(count));
            };
            add(&mut all.triangle_count, once.triangle_count);
            add(&mut all.vertex_count, once.vertex_count);
            add(&mut all.part_count, 1);
        }
        all
    }

    fn add_primitive(&mut self, primitive: &Primitive, root: &Root, buffers: &Buffers<'_>) {
        let count = |index: Index| count(index, root, buffers);
        let material = primitive
            .material
            .and_then(|index| root.materials.get(index.0));
        let positions = primitive.attributes.get("POSITION").copied();
        let (Some(mode), Some(positions), false) = (
            Mode::of(primitive.mode),
            positions.and_then(count),
            material.is_some_and(is_invisible),
        ) else {
            return;
        };
        let corners = primitive.indices.map_or(Some(positions), count);
        let faces = triangle_count(mode, corners.unwrap_or(0));
        self.triangle_count = self.triangle_count.saturating_add(faces);
        // Positions that no triangle uses are not placed.
        let vertices = positions.min(faces.saturating_mul(3));
        self.vertex_count = self.vertex_count.saturating_add(vertices);
    }

    /// Refuses more triangles than a tree can hold, and a mesh that the memory cannot hold.
    pub fn check(self, source: &Source<'_>) -> Result<(), LoadError> {
        let (file, limit) = (source.file.clone(), slimbvh_core::MAX_TRIANGLES as usize);
        let triangle_count = self.triangle_count;
        if triangle_count > limit {
            let error = MeshError::TooManyTriangles {
                triangle_count,
                limit,
            };
            return Err(LoadError::Mesh { file, error });
        }
        match self.is_room() {
            true => Ok(()),
            false => Err(LoadError::NoMemory {
                file,
                triangle_count,
            }),
        }
    }

    /// Whether a block of the mesh's size, with a name of 24 bytes for each part, can be taken. It is given back at once.
    fn is_room(self) -> bool {
        const TRIANGLE_BYTES: usize = size_of::<[u32; 3]>() + size_of::<u32>();
        const VERTEX_BYTES: usize = size_of::<[f32; 3]>();
        const PART_BYTES: usize = size_of::<Part>() + 24;
        let triangles = self.triangle_count.saturating_mul(TRIANGLE_BYTES);
        let vertices = self.vertex_count.saturating_mul(VERTEX_BYTES);
        let parts = self.part_count.saturating_mul(PART_BYTES);
        let all = triangles.saturating_add(vertices).saturating_add(parts);
        Vec::<u8>::new().try_reserve_exact(all).is_ok()
    }
}

/// Whether joints place the mesh, and not instances.
fn has_joints(mesh: &Mesh) -> bool {
    let mut primitives = mesh.primitives.iter();
    primitives.any(|it| {
        let mut names = ["JOINTS_0", "WEIGHTS_0"].iter();
        names.all(|name| it.attributes.contains_key(*name))
    })
}

/// The elements of an accessor, if its data can hold so many.
fn count(Index(index): Index, root: &Root, buffers: &Buffers<'_>) -> Option<usize> {
    let accessor = root.accessors.get(index)?;
    let most = match accessor.buffer_view {
        Some(view) => buffers.view(view, String::new).ok()?.1.len(),
        None => buffers.most_zeros(),
    };
    Some(accessor.count.0).filter(|count| *count <= most)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn meshes_larger_than_the_memory_have_no_room() {
        let small = Size {
            triangle_count: 7,
            vertex_count: 9,
            part_count: 2,
        };
        assert!(small.is_room());
        for large in [
            Size {
                triangle_count: usize::MAX / 16,
                ..small
            },
            Size {
                vertex_count: usize::MAX / 12,
                ..small
            },
            Size {
                part_count: usize::MAX / 56,
                ..small
            },
            Size {
                part_count: usize::MAX,
                ..small
            },
        ] {
            assert!(!large.is_room(), "{large:?}");
        }
    }
}
