//! OBJ: groups of polygons, with materials in other files.
//!
//! [`lines`] and [`materials`] filter the text that `tobj` reads.

mod lines;
mod materials;

use super::faces::unit_or_zero;
use super::load::{Found, Source};
use super::{LoadError, Material, Scene};
use crate::{Mesh, Part};
use lines::{BrokenFace, Fault, Lines};
use std::cell::RefCell;

/// `tobj`'s name for faces outside of any group.
const NO_NAME: &str = "unnamed_object";

/// Reads all polygons, with a part for each named group or object. Lines and points are skipped.
pub(super) fn read(source: &Source<'_>, bytes: Vec<u8>) -> Result<Found, LoadError> {
    let text = String::from_utf8_lossy(&bytes);
    // `tobj` reports such faces late and without their line, or overflows at their indices.
    let mut broken = Vec::new();
    for face in lines::broken_faces(&text) {
        if !source.options.lenient {
            return Err(refuse(&face, source));
        }
        broken.push(face);
    }

    let options = tobj::LoadOptions {
        single_index: true,
        triangulate: true,
        ignore_points: true,
        ignore_lines: true,
    };
    // A library that cannot be read stops the loading; `tobj` alone would continue.
    let library_error = RefCell::new(None);
    let mut lines = Lines::new(&text, &broken);
    let read = tobj::load_obj_buf(&mut lines, &options, |library| {
        materials::read(library, source).map_err(|error| {
            library_error.replace(Some(error));
            tobj::LoadError::ReadError
        })
    });
    if let Some(error) = library_error.into_inner() {
        return Err(error);
    }
    let (models, library) = read.map_err(|error| LoadError::Obj {
        file: source.file.clone(),
        line: is_of_a_line(error).then_some(lines.line()),
        error,
    })?;

    let mut scene = Scene {
        materials: library
            .unwrap_or_default()
            .iter()
            .map(materials::convert)
            .collect(),
        dropped_face_count: broken.len(),
        ..Scene::default()
    };
    for model in models {
        append(&mut scene.mesh, model, scene.materials.len());
    }
    tidy(&mut scene);
    Ok(scene.into())
}

/// Adds a model's triangles, with `default_material` if the model has none.
fn append(mesh: &mut Mesh, model: tobj::Model, default_material: usize) {
    let tobj::Model { mesh: added, name } = model;
    let first_vertex = mesh.vertices.len() as u32;
    let first_triangle = mesh.indices.len() as u32;
    let triangle_count = (added.indices.len() / 3) as u32;
    if triangle_count == 0 {
        return;
    }

    // `tobj` lists normals only for vertices that have one, without saying which.
    let (vertices, _) = added.positions.as_chunks::<3>();
    let (normals, _) = added.normals.as_chunks::<3>();
    mesh.vertices.extend(vertices);
    if normals.len() == vertices.len() {
        mesh.normals
            .extend(normals.iter().map(|&normal| unit_or_zero(normal)));
    } else {
        mesh.normals.resize(mesh.vertices.len(), [0.0; 3]);
    }
    let (triangles, _) = added.indices.as_chunks::<3>();
    mesh.indices.extend(
        triangles
            .iter()
            .map(|t| t.map(|vertex| first_vertex + vertex)),
    );
    let material = added.material_id.unwrap_or(default_material) as u32;
    mesh.materials.resize(mesh.indices.len(), material);

    // A change of material starts a new model, but not a new part.
    match mesh.parts.last_mut() {
        Some(part) if part.name == name => part.triangle_count += triangle_count,
        _ => mesh.parts.push(Part {
            name,
            first_triangle,
            triangle_count,
        }),
    }
}

/// Removes lists without information, and adds the default material if a triangle uses it.
fn tidy(scene: &mut Scene) {
    let mesh = &mut scene.mesh;
    if mesh.normals.iter().all(|normal| *normal == [0.0; 3]) {
        mesh.normals.clear();
    }
    if matches!(&mesh.parts[..], [part] if part.name == NO_NAME) {
        mesh.parts.clear();
    }
    if scene.materials.is_empty() {
        mesh.materials.clear();
    } else if mesh.materials.contains(&(scene.materials.len() as u32)) {
        scene.materials.push(Material::default());
    }
}

/// Whether the reader reports the fault at the line just read, and not at the end of a group.
fn is_of_a_line(error: tobj::LoadError) -> bool {
    use tobj::LoadError as E;
    !matches!(
        error,
        E::FaceVertexOutOfBounds
            | E::FaceNormalOutOfBounds
            | E::FaceTexCoordOutOfBounds
            | E::FaceColorOutOfBounds
            | E::InvalidPolygon
    )
}

fn refuse(broken: &BrokenFace, source: &Source<'_>) -> LoadError {
    let (file, line) = (source.file.clone(), Some(broken.line));
    match broken.fault {
        Fault::Unreadable => LoadError::Obj {
            file,
            line,
            error: tobj::LoadError::FaceParseError,
        },
        Fault::Outside { list, index, count } => LoadError::IndexOutOfRange {
            file,
            line,
            part: String::new(),
            face: broken.face,
            list,
            index,
            count,
        },
    }
}
