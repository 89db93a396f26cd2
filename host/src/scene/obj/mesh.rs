//! The mesh of an OBJ file.

use super::super::faces::Faces;
use super::super::load::{Found, Source};
use super::super::{LoadError, Material};
use super::corner::Corner;
use super::statement::File;
use crate::{Mesh, Part};
use std::collections::HashMap;

/// The name of faces outside of any group.
const NO_NAME: &str = "unnamed_object";

/// The scene. A vertex is a position with a normal; those of no face are left out.
pub(super) fn convert(source: &Source<'_>, file: File) -> Result<Found, LoadError> {
    let mut faces = Faces::new(source);
    faces.dropped_count = file.dropped_count;
    if file.ends.is_empty() {
        // The positions are told in the error.
        faces.vertices = super::super::vertices::Vertices::Wide(file.vertices);
        return Ok(faces.into_found());
    }

    let default_material = file.libraries.materials.len() as u32;
    let names = file.libraries.find(&file.names, source);
    let mut parts = file.parts.into_iter().peekable();
    let mut materials = file.materials.iter().peekable();
    let mut material = default_material;
    begin_part(&mut faces.mesh, NO_NAME.into());
    let mut lookup = Lookup::new(&file.vertices, &file.normals);
    let mut corners = Vec::new();
    let mut begin = 0;
    for (face, &end) in file.ends.iter().enumerate() {
        while let Some((name, _)) = parts.next_if(|(_, first)| *first <= face) {
            begin_part(&mut faces.mesh, name);
        }
        while let Some((name, _)) = materials.next_if(|(_, first)| *first <= face) {
            material = names[*name as usize].unwrap_or(default_material);
        }
        corners.clear();
        for &corner in &file.corners[begin..end as usize] {
            corners.push(lookup.vertex(corner, &mut faces));
        }
        begin = end as usize;
        faces.cut(corners.len(), |i| corners[i])?;
        if default_material > 0 {
            let count = faces.mesh.indices.len();
            faces.mesh.materials.resize(count, material);
        }
    }
    end_part(&mut faces.mesh);
    let mut found = faces.into_found();
    found.scene.materials = file.libraries.materials;
    tidy(&mut found);
    Ok(found)
}

/// The mesh's vertices by corner.
struct Lookup<'a> {
    positions: &'a [[f64; 3]],
    normals: &'a [[f32; 3]],
    /// For each position, the normal that it had first, and the vertex.
    first: Vec<[u32; 2]>,
    /// Vertices with further normals.
    more: HashMap<Corner, u32>,
}

impl<'a> Lookup<'a> {
    fn new(positions: &'a [[f64; 3]], normals: &'a [[f32; 3]]) -> Self {
        Self {
            positions,
            normals,
            first: vec![[Corner::NONE; 2]; positions.len()],
            more: HashMap::new(),
        }
    }

    #[inline]
    fn vertex(&mut self, corner: Corner, faces: &mut Faces<'_>) -> u32 {
        let next = faces.vertices.len() as u32;
        let known = &mut self.first[corner.vertex as usize];
        let vertex = match *known {
            [_, Corner::NONE] => {
                *known = [corner.normal, next];
                next
            }
            [normal, vertex] if normal == corner.normal => return vertex,
            _ => *self.more.entry(corner).or_insert(next),
        };
        if vertex == next {
            faces.vertices.push(self.positions[corner.vertex as usize]);
            if !self.normals.is_empty() {
                let normal = self.normals.get(corner.normal as usize);
                let normal = normal.copied().unwrap_or_default();
                faces.mesh.normals.push(normal);
            }
        }
        vertex
    }
}

/// Begins a part, which goes on with the last one if that has the same name.
fn begin_part(mesh: &mut Mesh, name: String) {
    end_part(mesh);
    let name = if name.is_empty() {
        NO_NAME.into()
    } else {
        name
    };
    if mesh.parts.last().is_none_or(|part| part.name != name) {
        mesh.parts.push(Part {
            name,
            first_triangle: mesh.indices.len() as u32,
            triangle_count: 0,
        });
    }
}

/// Ends the last part, which goes if it is empty.
fn end_part(mesh: &mut Mesh) {
    let count = mesh.indices.len() as u32;
    if let Some(part) = mesh.parts.last_mut() {
        part.triangle_count = count - part.first_triangle;
        if part.triangle_count == 0 {
            mesh.parts.pop();
        }
    }
}

/// Removes lists without information, and adds the default material if a triangle has it.
fn tidy(found: &mut Found) {
    let scene = &mut found.scene;
    let mesh = &mut scene.mesh;
    if mesh.normals.iter().all(|normal| *normal == [0.0; 3]) {
        mesh.normals.clear();
    }
    if matches!(&mesh.parts[..], [part] if part.name == NO_NAME) {
        mesh.parts.clear();
    }
    let count = scene.materials.len() as u32;
    if count > 0 && mesh.materials.contains(&count) {
        scene.materials.push(Material::default());
    }
}
