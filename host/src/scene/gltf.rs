//! glTF 2.0: JSON with buffers in other files, or one GLB file.
//!
//! Only members that the scene needs are read and checked, so that no fault elsewhere refuses the file.

mod accessor;
mod buffers;
mod document;
mod error;
mod extensions;
mod instances;
mod json;
mod list;
mod materials;
mod nodes;
mod outside;
mod primitive;
mod size;
mod skin;
mod view;

pub use error::GltfError;

use super::faces::Faces;
use super::load::{Found, Source};
use super::vertices::Vertices;
use super::{Camera, Light, LoadError};
use crate::{MeshError, Part};
use buffers::Buffers;
use glam::DAffine3;
use instances::Instances;
use json::{Index, Root};
use nodes::{Nodes, Visited};
use primitive::{PlaceError, Reader, Surface};
use size::Size;
use std::collections::BTreeSet;
use std::rc::Rc;

/// Reads the default scene at the file's pose, flattened: a part for each node or instance with triangles.
pub(super) fn read(source: &Source<'_>, bytes: Vec<u8>) -> Result<Found, LoadError> {
    let (root, blob) = document::parse(&bytes, source)?;
    let buffers = Buffers::new(&root, blob, bytes.len(), source);
    let noted = source.left_out.borrow().clone();
    let found = flatten(source, &root, &buffers, Vertices::narrow())?;
    if !found.vertices.may_lose(&found.scene.mesh.indices) {
        return Ok(found);
    }
    // Few files are far from zero: they are placed again.
    drop(found);
    source.left_out.replace(noted);
    flatten(source, &root, &buffers, Vertices::default())
}

/// The scene, with positions of one of the two kinds.
fn flatten<'a>(
    source: &'a Source<'a>,
    root: &'a Root,
    buffers: &'a Buffers<'a>,
    vertices: Vertices,
) -> Result<Found, LoadError> {
    let mut nodes = Nodes::new(root).map_err(|error| buffers.fault(error))?;
    let visited = std::mem::take(&mut nodes.visited);
    let mut flat = Flat {
        source,
        root,
        buffers,
        nodes,
        joints: vec![None; root.skins.len()],
        faces: Faces::new(source),
        meshes: BTreeSet::new(),
        extensions: BTreeSet::new(),
        cameras: Vec::new(),
        lights: Vec::new(),
    };
    flat.faces.vertices = vertices;
    let size = Size::of(root, &visited, buffers);
    size.check(source)?;
    for it in &visited {
        flat.visit(*it)?;
    }
    flat.note(&visited);
    Ok(flat.finish())
}

/// A scene under construction.
struct Flat<'a> {
    source: &'a Source<'a>,
    root: &'a Root,
    buffers: &'a Buffers<'a>,
    nodes: Nodes<'a>,
    /// The joints' transforms of each skin, as far as it was used.
    joints: Vec<Option<Rc<[DAffine3]>>>,
    faces: Faces<'a>,
    /// Meshes of nodes of the scene.
    meshes: BTreeSet<usize>,
    /// Extensions of nodes and primitives of the scene.
    extensions: BTreeSet<String>,
    cameras: Vec<(Camera, [[f64; 3]; 2])>,
    lights: Vec<(Light, [f64; 3])>,
}

impl Flat<'_> {
    fn visit(&mut self, it: Visited<'_>) -> Result<(), LoadError> {
        let extensions = &it.node.extensions;
        if it.is_hidden {
            let is_seen = it.node.mesh.is_some() || extensions.light.is_some();
            self.source.leave_out("hidden nodes", usize::from(is_seen));
        } else {
            self.append_mesh(it)?;
            self.append_light(it)?;
        }
        let levels = extensions.levels.as_ref().map_or(0, |it| it.ids.len());
        self.source.leave_out("levels of detail", levels);
        self.extensions.extend(extensions.others.keys().cloned());
        self.append_camera(it)
    }

    fn append_mesh(&mut self, it: Visited<'_>) -> Result<(), LoadError> {
        let (root, buffers) = (self.root, self.buffers);
        let node = it.node;
        let Some(index) = node.mesh else {
            return Ok(());
        };
        self.meshes.insert(index.0);
        let place = || format!("nodes[{}].mesh", it.index);
        let mesh = root.meshes.item("meshes", index, place);
        let mesh = mesh.map_err(|error| buffers.fault(error))?;
        let name = match node.name.as_ref().or(mesh.name.as_ref()) {
            Some(name) => name.clone(),
            None => format!("node {}", it.index),
        };

        // Read the primitives.
        let mut primitives = mesh.primitives.iter();
        let has_joints = primitives.any(|it| it.attributes.contains_key("JOINTS_0"));
        let joints = match node.skin.filter(|_| has_joints) {
            Some(skin) => Some((skin.0, self.joints(it.index, skin)?)),
            None => None,
        };
        let reader = Reader {
            root,
            buffers,
            source: self.source,
            part: &name,
            weights: match node.weights.is_empty() {
                true => &mesh.weights,
                false => &node.weights,
            },
            joints: joints.as_ref().map(|(skin, joints)| (*skin, &**joints)),
        };
        let mut surfaces = Vec::new();
        for (i, primitive) in mesh.primitives.iter().enumerate() {
            let place = format!("meshes[{}].primitives[{i}]", index.0);
            surfaces.extend(reader.read(primitive, &place)?);
            self.extensions.extend(primitive.extensions.keys().cloned());
        }

        // Place them.
        let instancing = node.extensions.instancing.as_ref();
        let instances = match instancing.filter(|_| !surfaces.is_empty()) {
            Some(instancing) => Instances::new(root, it.index, instancing, (buffers, self.source))?,
            None => None,
        };
        match instances {
            None => {
                self.reserve(&surfaces, 1)?;
                self.append_part(&surfaces, &name, it.transform)
            }
            // Joints place skinned meshes, not the node.
            Some(instances) if surfaces.iter().any(Surface::is_skinned) => {
                let count = instances.count;
                self.source.leave_out("instances of skinned meshes", count);
                self.append_part(&surfaces, &name, it.transform)
            }
            Some(instances) => {
                self.reserve(&surfaces, instances.count)?;
                for instance in 0..instances.count {
                    let name = format!("{name} {}", instance + 1);
                    let transform = it.transform * instances.transform(instance);
                    self.append_part(&surfaces, &name, transform)?;
                }
                Ok(())
            }
        }
    }

    /// The joints' transforms of a node's skin.
    fn joints(&mut self, node: usize, skin: Index) -> Result<Rc<[DAffine3]>, LoadError> {
        if let Some(Some(known)) = self.joints.get(skin.0) {
            return Ok(known.clone());
        }
        let place = || format!("nodes[{node}].skin");
        let joints = skin::joints(self.root, skin, place, &mut self.nodes, self.buffers)?;
        let joints: Rc<[DAffine3]> = joints.into();
        self.joints[skin.0] = Some(joints.clone());
        Ok(joints)
    }

    /// Makes room for some instances. Refuses more triangles than a tree or the memory can hold, before they fill it.
    fn reserve(&mut self, surfaces: &[Surface<'_>], count: usize) -> Result<(), LoadError> {
        let file = || self.source.file.clone();
        let limit = slimbvh_core::MAX_TRIANGLES as usize;
        let times = |once: usize| once.saturating_mul(count);
        let face_count = times(surfaces.iter().map(|it| it.face_count).sum());
        let vertex_count = times(surfaces.iter().map(Surface::vertex_count).sum());
        let normal_count = times(surfaces.iter().map(Surface::normal_count).sum());
        let mesh = &mut self.faces.mesh;
        let triangle_count = face_count.saturating_add(mesh.indices.len());
        if triangle_count > limit {
            return Err(LoadError::Mesh {
                file: file(),
                error: MeshError::TooManyTriangles {
                    triangle_count,
                    limit,
                },
            });
        }
        let room = mesh.indices.try_reserve(face_count);
        let room = room.and_then(|()| mesh.materials.try_reserve(face_count));
        let room = room.and_then(|()| mesh.normals.try_reserve(normal_count));
        let room = room.and_then(|()| mesh.parts.try_reserve(count));
        let room = room.and_then(|()| self.faces.vertices.try_reserve(vertex_count));
        room.map_err(|_| LoadError::NoMemory {
            file: file(),
            triangle_count,
        })
    }

    fn append_part(
        &mut self,
        surfaces: &[Surface<'_>],
        name: &str,
        transform: DAffine3,
    ) -> Result<(), LoadError> {
        let is_lenient = self.source.options.lenient;
        let first = self.faces.mesh.indices.len();
        for surface in surfaces {
            let placed = surface.place(transform, name, is_lenient, &mut self.faces);
            placed.map_err(|error| match error {
                PlaceError::Gltf(error) => self.buffers.fault(error),
                PlaceError::Load(error) => error,
            })?;
            let material = surface.material.unwrap_or(self.root.materials.len());
            let mesh = &mut self.faces.mesh;
            mesh.materials.resize(mesh.indices.len(), material as u32);
        }
        let mesh = &mut self.faces.mesh;
        if mesh.indices.len() > first {
            mesh.parts.push(Part {
                name: name.to_owned(),
                first_triangle: first as u32,
                triangle_count: (mesh.indices.len() - first) as u32,
            });
        }
        Ok(())
    }

    fn append_camera(&mut self, it: Visited<'_>) -> Result<(), LoadError> {
        let Some(index) = it.node.camera else {
            return Ok(());
        };
        let fault = |error| self.buffers.fault(error);
        let place = || format!("nodes[{}].camera", it.index);
        let camera = self
            .root
            .cameras
            .item("cameras", index, place)
            .map_err(fault)?;
        let projection = match view::projection(camera, index.0) {
            Ok(Some(projection)) => projection,
            Ok(None) => {
                self.source.leave_out("cameras of an unknown type", 1);
                return Ok(());
            }
            Err(_) if self.source.options.lenient => {
                self.source.leave_out("cameras without an extent", 1);
                return Ok(());
            }
            Err(error) => return Err(fault(error)),
        };
        let camera = view::camera(projection, it.transform);
        let camera = self.or_refuse(camera, "camera", it.index)?;
        self.cameras.extend(camera);
        Ok(())
    }

    fn append_light(&mut self, it: Visited<'_>) -> Result<(), LoadError> {
        let Some(light) = &it.node.extensions.light else {
            return Ok(());
        };
        let place = || format!("nodes[{}].extensions.KHR_lights_punctual.light", it.index);
        let lights = &self.root.extensions.lights.lights;
        let light = lights.item("lights", light.light, place);
        let light = light.map_err(|error| self.buffers.fault(error))?;
        match light.kind.as_str() {
            "directional" | "point" => {}
            "spot" => self.source.leave_out("cones of spot lights", 1),
            _ => {
                self.source.leave_out("lights of an unknown type", 1);
                return Ok(());
            }
        }
        let light = self.or_refuse(view::light(light, it.transform), "light", it.index)?;
        self.lights.extend(light);
        Ok(())
    }

    /// Rejects a camera or a light without a direction; with lenient options, leaves it out.
    fn or_refuse<T>(
        &self,
        found: Option<T>,
        what: &'static str,
        node: usize,
    ) -> Result<Option<T>, LoadError> {
        if found.is_none() {
            if !self.source.options.lenient {
                return Err(self.buffers.fault(GltfError::Degenerate { node, what }));
            }
            let what = format!("{what}s that point nowhere");
            self.source.leave_out(&what, 1);
        }
        Ok(found)
    }

    /// Notes what the file has, and the scene does not.
    fn note(&self, visited: &[Visited<'_>]) {
        let root = self.root;
        let used: BTreeSet<u32> = self.faces.mesh.materials.iter().copied().collect();
        let used = used
            .into_iter()
            .filter_map(|index| root.materials.get(index as usize));
        materials::note(used, self.source);
        let unused = root.meshes.len().saturating_sub(self.meshes.len());
        (self.source).leave_out("meshes that no node of the scene has", unused);
        let animation_count = root.animations.as_array().map_or(0, Vec::len);
        self.source.leave_out("animations", animation_count);
        let scene_count = root.scenes.len();
        self.source.leave_out(
            "scenes besides the default one",
            scene_count.saturating_sub(1),
        );
        extensions::note(root, &self.extensions, self.source);
        outside::note(root, visited, self.source);
    }

    fn finish(self) -> Found {
        let materials = &self.root.materials;
        let mut found = self.faces.into_found();
        let scene = &mut found.scene;
        let all = (0..materials.len()).map(|index| materials.get(index));
        let all = all.map(|material| material.map_or_else(materials::without, materials::convert));
        scene.materials = all.collect();
        // One material needs no list of indices.
        if scene.materials.is_empty() {
            scene.mesh.materials.clear();
            scene.materials.push(materials::without());
        } else if scene.mesh.materials.contains(&(materials.len() as u32)) {
            scene.materials.push(materials::without());
        }
        (scene.cameras, found.cameras) = self.cameras.into_iter().unzip();
        (scene.lights, found.lights) = self.lights.into_iter().unzip();
        found
    }
}
