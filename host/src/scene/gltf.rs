//! glTF 2.0: JSON with buffers in other files, or one GLB file.
//!
//! The crate `gltf` reads and checks the JSON; [`document`] adds checks that it lacks. Buffers and accessors are read here,
//! because the crate's iterators panic at accessors that do not fit, or skip them.

mod accessor;
mod buffers;
mod document;
mod error;
mod primitive;
mod view;

pub use error::GltfError;

use super::faces::{Faces, share};
use super::load::{Found, Source};
use super::{Camera, Light, LoadError, Material};
use crate::Part;
use ::gltf::{Document, Node};
use buffers::Buffers;
use glam::Mat4;

/// Reads the default scene, flattened: a part for each node with a mesh.
pub(super) fn read(source: &Source<'_>, bytes: Vec<u8>) -> Result<Found, LoadError> {
    let (document, blob) = document::parse(&bytes, source)?;
    let buffers = Buffers::read(&document, blob, source)?;
    let mut flat = Flat {
        source,
        buffers: &buffers,
        faces: Faces::new(source),
        cameras: Vec::new(),
        lights: Vec::new(),
        default_material: document.materials().len() as u32,
    };
    flat.walk(&document)?;

    let Flat {
        faces,
        cameras,
        lights,
        default_material,
        ..
    } = flat;
    let mut found = faces.into_found();
    let scene = &mut found.scene;
    scene.materials = document.materials().map(|m| convert(&m)).collect();
    scene.cameras = cameras;
    scene.lights = lights;
    // Without materials, the list of indices has no meaning.
    if scene.materials.is_empty() {
        scene.mesh.materials.clear();
    } else if scene.mesh.materials.contains(&default_material) {
        scene.materials.push(Material::default());
    }
    Ok(found)
}

/// A scene under construction.
struct Flat<'a> {
    source: &'a Source<'a>,
    buffers: &'a Buffers<'a>,
    faces: Faces<'a>,
    cameras: Vec<Camera>,
    lights: Vec<Light>,
    /// The index of the default material.
    default_material: u32,
}

impl Flat<'_> {
    /// Visits every node below the roots once, parents first. Iterative, so depth cannot overflow the stack.
    fn walk(&mut self, document: &Document) -> Result<(), LoadError> {
        let mut is_visited = vec![false; document.nodes().len()];
        let mut stack: Vec<(Node<'_>, Mat4)> = document::roots(document)
            .map(|node| (node, Mat4::IDENTITY))
            .collect();
        stack.reverse();
        while let Some((node, parent)) = stack.pop() {
            if std::mem::replace(&mut is_visited[node.index()], true) {
                let node = node.index();
                return Err(self.error(GltfError::NotATree { node }));
            }
            let transform = parent * Mat4::from_cols_array_2d(&node.transform().matrix());
            self.visit(&node, transform)?;
            let children: Vec<_> = node.children().map(|child| (child, transform)).collect();
            stack.extend(children.into_iter().rev());
        }
        Ok(())
    }

    fn visit(&mut self, node: &Node<'_>, transform: Mat4) -> Result<(), LoadError> {
        if let Some(mesh) = node.mesh() {
            let name = match node.name().or(mesh.name()) {
                Some(name) => name.to_owned(),
                None => format!("node {}", node.index()),
            };
            self.append_part(&mesh, name, transform)?;
        }
        if let Some(camera) = node.camera() {
            let camera = view::camera(&camera, transform);
            self.cameras.extend(self.or_refuse(camera, node)?);
        }
        if let Some(light) = node.light() {
            let light = view::light(&light, transform);
            self.lights.extend(self.or_refuse(light, node)?);
        }
        Ok(())
    }

    /// Rejects a camera or a light without a direction; with lenient options, leaves it out.
    fn or_refuse<T>(&self, found: Option<T>, node: &Node<'_>) -> Result<Option<T>, LoadError> {
        match found {
            None if !self.source.options.lenient => {
                Err(self.error(GltfError::Degenerate { node: node.index() }))
            }
            found => Ok(found),
        }
    }

    fn append_part(
        &mut self,
        mesh: &::gltf::Mesh<'_>,
        name: String,
        transform: Mat4,
    ) -> Result<(), LoadError> {
        let first = self.faces.mesh.indices.len();
        for primitive in mesh.primitives() {
            let material = primitive.material().index();
            primitive::append(&primitive, &name, transform, self)?;
            let triangle_count = self.faces.mesh.indices.len();
            let material = material.map_or(self.default_material, |index| index as u32);
            self.faces.mesh.materials.resize(triangle_count, material);
        }
        self.faces.mesh.parts.push(Part {
            name,
            first_triangle: first as u32,
            triangle_count: (self.faces.mesh.indices.len() - first) as u32,
        });
        Ok(())
    }

    fn error(&self, error: GltfError) -> LoadError {
        LoadError::Gltf {
            file: self.source.file.clone(),
            error,
        }
    }
}

/// The base color; a smooth metal as a mirror; a transmitting material as glass, rough or not.
fn convert(material: &::gltf::Material<'_>) -> Material {
    const LEAST_METALLIC: f32 = 0.5;
    const MOST_ROUGH: f32 = 0.2;
    let pbr = material.pbr_metallic_roughness();
    let [r, g, b, _] = pbr.base_color_factor();
    let is_mirror = pbr.metallic_factor() >= LEAST_METALLIC && pbr.roughness_factor() <= MOST_ROUGH;
    Material {
        base_color: [r, g, b].map(share),
        mirror: match is_mirror {
            true => share(pbr.metallic_factor()),
            false => 0.0,
        },
        transmission: match material.transmission() {
            Some(glass) => share(glass.transmission_factor()),
            None => 0.0,
        },
        ior: material.ior().unwrap_or(Material::default().ior),
    }
}
