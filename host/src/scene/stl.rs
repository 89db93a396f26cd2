//! STL: triangles with separate corners, as text or binary. Equal corners weld to one vertex.
//!
//! `stl_io` reads the triangles. It takes any file that starts with `solid ` for text, stops at the first `endsolid`, and
//! trusts a binary file's count; this module checks all three first.

use super::load::{Found, Source};
use super::{LoadError, Scene};
use crate::{Mesh, Part};
use std::collections::HashMap;
use std::io::{Cursor, ErrorKind};

/// Bytes before the first triangle of a binary file: 80 arbitrary ones, then the count.
const HEADER_BYTES: usize = 84;
/// Bytes of a binary triangle.
const TRIANGLE_BYTES: usize = 50;

/// Reads text, with a part for each solid, or binary.
pub(super) fn read(source: &Source<'_>, mut bytes: Vec<u8>) -> Result<Found, LoadError> {
    let mut weld = Weld::new(source);
    if is_text(&bytes) {
        // The reader knows lower case only.
        let names: Vec<String> = solids(&bytes).map(name).collect();
        bytes.make_ascii_lowercase();
        for (solid, name) in solids(&bytes).zip(names) {
            let first = weld.mesh.indices.len();
            weld.triangles(&text_for_reader(solid))?;
            weld.mesh.parts.push(Part {
                name,
                first_triangle: first as u32,
                triangle_count: (weld.mesh.indices.len() - first) as u32,
            });
        }
        // A single unnamed solid needs no part.
        if matches!(&weld.mesh.parts[..], [part] if part.name.is_empty()) {
            weld.mesh.parts.clear();
        }
    } else {
        check_length(&bytes, source)?;
        // The file is binary, whatever its header says.
        bytes[..HEADER_BYTES - 4].fill(0);
        weld.triangles(&bytes)?;
    }
    let scene = Scene {
        mesh: weld.mesh,
        dropped_face_count: weld.dropped_count,
        ..Scene::default()
    };
    Ok(scene.into())
}

/// Whether the file starts with `solid` and is not binary; length and zero bytes reveal a binary file that starts so.
fn is_text(bytes: &[u8]) -> bool {
    let begins = |bytes: &[u8]| {
        let word = bytes.trim_ascii_start().get(..5);
        word.is_some_and(|word| word.eq_ignore_ascii_case(b"solid"))
    };
    let exact = announced(bytes).is_some_and(|count| expected_bytes(count) == bytes.len() as u64);
    begins(bytes) && !exact && !bytes.iter().take(512).any(|&byte| byte == 0)
}

/// The count in a binary file's header.
fn announced(bytes: &[u8]) -> Option<u32> {
    let count = bytes.get(HEADER_BYTES - 4..)?.first_chunk()?;
    Some(u32::from_le_bytes(*count))
}

fn expected_bytes(count: u32) -> u64 {
    HEADER_BYTES as u64 + u64::from(count) * TRIANGLE_BYTES as u64
}

fn check_length(bytes: &[u8], source: &Source<'_>) -> Result<(), LoadError> {
    let file = source.file.clone();
    let Some(count) = announced(bytes) else {
        return Err(LoadError::HeaderCut { file });
    };
    if expected_bytes(count) <= bytes.len() as u64 {
        return Ok(());
    }
    Err(LoadError::EndsEarly {
        file,
        what: "triangles".into(),
        announced: u64::from(count),
        found: ((bytes.len() - HEADER_BYTES) / TRIANGLE_BYTES) as u64,
    })
}

/// The solids of a text file, each up to and including its `endsolid` line; the last may lack that.
fn solids(bytes: &[u8]) -> impl Iterator<Item = &[u8]> {
    let mut lines = bytes.split_inclusive(|&byte| byte == b'\n');
    let mut rest = bytes;
    std::iter::from_fn(move || {
        let mut length = 0;
        for line in lines.by_ref() {
            length += line.len();
            let word = line.trim_ascii_start().get(..8);
            if word.is_some_and(|word| word.eq_ignore_ascii_case(b"endsolid")) {
                break;
            }
        }
        let (solid, behind) = rest.split_at(length);
        rest = behind;
        (!solid.trim_ascii().is_empty()).then_some(solid)
    })
}

/// The text after the word `solid`.
fn name(solid: &[u8]) -> String {
    let line = solid.trim_ascii_start().split(|&byte| byte == b'\n').next();
    let name = line.and_then(|line| line.get(5..)).unwrap_or_default();
    String::from_utf8_lossy(name.trim_ascii()).into_owned()
}

/// The solid with a first line that the reader accepts: a space after `solid`, and UTF-8.
fn text_for_reader(solid: &[u8]) -> Vec<u8> {
    let solid = solid.trim_ascii_start();
    let end_of_line = solid.iter().position(|&byte| byte == b'\n');
    let facets = &solid[end_of_line.unwrap_or(solid.len())..];
    [b"solid ", facets].concat()
}

/// The number of faces that a text starts.
fn facet_count(text: &[u8]) -> usize {
    text.split(|&byte| byte == b'\n')
        .filter(|line| line.trim_ascii_start().starts_with(b"facet"))
        .count()
}

/// A mesh under construction, with the vertex of every corner so far.
struct Weld<'a> {
    source: &'a Source<'a>,
    mesh: Mesh,
    dropped_count: usize,
    /// By the bits of the coordinates.
    vertices: HashMap<[u32; 3], u32>,
}

impl<'a> Weld<'a> {
    fn new(source: &'a Source<'a>) -> Self {
        Self {
            source,
            mesh: Mesh::default(),
            dropped_count: 0,
            vertices: HashMap::new(),
        }
    }

    /// Adds all triangles of a file as `stl_io` knows it.
    fn triangles(&mut self, bytes: &[u8]) -> Result<(), LoadError> {
        let first = self.mesh.indices.len();
        let mut cursor = Cursor::new(bytes);
        let reader = stl_io::create_stl_reader(&mut cursor).map_err(|e| self.error(e))?;
        let mut has_bad_face = false;
        for triangle in reader {
            match triangle {
                Ok(triangle) => {
                    let corners = triangle.vertices.map(|corner| self.vertex(corner.into()));
                    self.mesh.indices.push(corners);
                }
                // The reader resumes at the next line, and so at the next face.
                Err(e) if self.source.options.lenient && e.kind() == ErrorKind::InvalidData => {
                    has_bad_face = true;
                }
                Err(e) => return Err(self.error(e)),
            }
        }
        if has_bad_face {
            let sound = self.mesh.indices.len() - first;
            self.dropped_count += facet_count(bytes).saturating_sub(sound);
        }
        Ok(())
    }

    /// The error at the face after those read.
    fn error(&self, error: std::io::Error) -> LoadError {
        let (file, face) = (self.source.file.clone(), self.mesh.indices.len());
        match error.kind() {
            ErrorKind::UnexpectedEof => LoadError::StlCut { file, face },
            _ => LoadError::Stl { file, face, error },
        }
    }

    fn vertex(&mut self, corner: [f32; 3]) -> u32 {
        let next = self.mesh.vertices.len() as u32;
        let vertex = *self
            .vertices
            .entry(corner.map(f32::to_bits))
            .or_insert(next);
        if vertex == next {
            self.mesh.vertices.push(corner);
        }
        vertex
    }
}
