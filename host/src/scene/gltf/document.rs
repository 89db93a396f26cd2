//! The JSON of a glTF scene, checked.

use super::super::LoadError;
use super::super::load::Source;
use super::GltfError;
use crate::text::shorten;
use gltf::json::camera::Type;
use gltf::json::mesh::Semantic;
use gltf::json::validation::Checked;
use gltf::json::{Index, Root};
use gltf::{Document, Glb, Node};
use std::borrow::Cow;

/// A document, and a GLB file's binary chunk.
type WithBlob<'a> = (Document, Option<Cow<'a, [u8]>>);

/// Splits the file into chunks, and checks the JSON.
pub(super) fn parse<'a>(bytes: &'a [u8], source: &Source<'_>) -> Result<WithBlob<'a>, LoadError> {
    let in_file = |error| LoadError::Gltf {
        file: source.file.clone(),
        error,
    };
    let (json, blob) = match bytes.starts_with(b"glTF") {
        true => {
            let glb = split(bytes, source)?;
            (glb.json, glb.bin)
        }
        false => (bytes.into(), None),
    };
    let mut root = Root::from_slice(&json).map_err(|error| {
        in_file(GltfError::Json {
            message: shorten(&error.to_string(), 120),
        })
    })?;
    root.extensions_required.retain(|name| !is_harmless(name));
    check(&root).map_err(in_file)?;
    let document = Document::from_json(root).map_err(|error| in_file(invalid(error)))?;
    Ok((document, blob))
}

/// The chunks of a GLB file.
fn split<'a>(bytes: &'a [u8], source: &Source<'_>) -> Result<Glb<'a>, LoadError> {
    const HEADER_BYTES: usize = 12;
    let glb_error = |message| LoadError::Gltf {
        file: source.file.clone(),
        error: GltfError::Glb { message },
    };
    // The crate subtracts the header from the length unchecked.
    let Some(length) = bytes.get(HEADER_BYTES - 4..).and_then(<[u8]>::first_chunk) else {
        return Err(LoadError::HeaderCut {
            file: source.file.clone(),
        });
    };
    let length = u32::from_le_bytes(*length);
    if (length as usize) < HEADER_BYTES {
        return Err(glb_error(format!("its header announces {length} bytes")));
    }
    if length as usize > bytes.len() {
        return Err(LoadError::EndsEarly {
            file: source.file.clone(),
            what: "bytes".into(),
            announced: u64::from(length),
            found: bytes.len() as u64,
        });
    }
    Glb::from_slice(bytes).map_err(|error| glb_error(error.to_string()))
}

/// Whether a required extension is supported, or affects nothing that is read.
fn is_harmless(extension: &str) -> bool {
    const LOOKS: [&str; 4] = [
        "KHR_materials_",
        "KHR_texture_",
        "EXT_texture_",
        "MSFT_texture_",
    ];
    extension == "KHR_mesh_quantization" || LOOKS.iter().any(|look| extension.starts_with(look))
}

/// Finds faults that make the crate panic: its check looks up the accessor of positions before it knows that there is one,
/// and does not compare a camera's type with its values.
fn check(root: &Root) -> Result<(), GltfError> {
    for (mesh, primitives) in root.meshes.iter().enumerate() {
        for primitive in &primitives.primitives {
            let positions = primitive
                .attributes
                .get(&Checked::Valid(Semantic::Positions));
            let accessor = positions.map_or(0, Index::value);
            if positions.is_some() && accessor >= root.accessors.len() {
                return Err(GltfError::NoAccessor {
                    mesh,
                    accessor,
                    accessor_count: root.accessors.len(),
                });
            }
        }
    }
    let lacks_values = root.cameras.iter().position(|camera| match camera.type_ {
        Checked::Valid(Type::Perspective) => camera.perspective.is_none(),
        Checked::Valid(Type::Orthographic) => camera.orthographic.is_none(),
        Checked::Invalid => false,
    });
    match lacks_values {
        Some(camera) => Err(GltfError::CameraWithoutValues { camera }),
        None => Ok(()),
    }
}

/// The first fault found by the crate's check.
fn invalid(error: gltf::Error) -> GltfError {
    match error {
        gltf::Error::Validation(faults) => match faults.into_iter().next() {
            Some((path, fault)) => GltfError::Invalid {
                path: path.to_string(),
                fault,
            },
            None => unreachable!("an invalid document has a fault"),
        },
        other => GltfError::Json {
            message: other.to_string(),
        },
    }
}

/// The default scene's roots, or the first scene's. Without scenes, all nodes without a parent.
pub(super) fn roots(document: &Document) -> Box<dyn Iterator<Item = Node<'_>> + '_> {
    if let Some(scene) = document.default_scene().or(document.scenes().next()) {
        return Box::new(scene.nodes());
    }
    let mut has_parent = vec![false; document.nodes().len()];
    for child in document.nodes().flat_map(|node| node.children()) {
        has_parent[child.index()] = true;
    }
    Box::new(
        document
            .nodes()
            .filter(move |node| !has_parent[node.index()]),
    )
}
