//! PLY: elements with declared properties, as text or binary in either byte order.
//!
//! `ply-rs-bw` reads the header. The rows are read here, because its grammar rejects numbers such as `nan`, `.5` and `1.`,
//! which occur in files, and it allocates a list for every face.

mod rows;

use super::LoadError;
use super::error::excerpt;
use super::faces::{FaceSite, Faces, unit_or_zero};
use super::load::{Found, Source};
use super::vertices::Vertices;
use ply_rs_bw::parser::{ParseError, Parser, Reader};
use ply_rs_bw::ply::{DefaultElement, ElementDef, PropertyType, ScalarType};
use rows::{Fault, Rows};
use std::io::ErrorKind;

/// The vertex properties that are used.
const KEPT: [&str; 6] = ["x", "y", "z", "nx", "ny", "nz"];

/// Reads the elements `vertex` and `face`, and skips all others.
pub(super) fn read(source: &Source<'_>, bytes: Vec<u8>) -> Result<Found, LoadError> {
    // Read the header; the rest are the rows.
    let mut reader = Reader::new(bytes.as_slice());
    let header = Parser::<DefaultElement>::new()
        .read_header(&mut reader)
        .map_err(|error| header_error(&error, source, &bytes))?;
    let first_line = reader.line();
    let mut rows = Rows::new(reader.into_inner(), &header.encoding, first_line);

    let mut faces = Faces::new(source);
    let vertices = header.elements.get("vertex");
    let vertex_count = vertices
        .ok_or_else(|| missing("element \"vertex\"".into(), source))?
        .count;
    for element in header.elements.values() {
        match element.name.as_str() {
            "vertex" => read_vertices(&mut rows, element, &mut faces, source)?,
            "face" => read_faces(&mut rows, element, vertex_count, &mut faces, source)?,
            _ => skip(&mut rows, element, source)?,
        }
    }
    Ok(faces.into_found())
}

fn read_vertices(
    rows: &mut Rows<'_>,
    element: &ElementDef,
    faces: &mut Faces<'_>,
    source: &Source<'_>,
) -> Result<(), LoadError> {
    // For each property, the used value that it holds.
    let plan: Vec<(Option<usize>, &PropertyType)> = element
        .properties
        .values()
        .map(|p| (KEPT.iter().position(|kept| *kept == p.name), &p.data_type))
        .collect();
    let is_scalar = |name: &str| {
        let property = element.properties.get(name);
        property.is_some_and(|p| matches!(p.data_type, PropertyType::Scalar(_)))
    };
    if let Some(name) = KEPT[..3].iter().find(|name| !is_scalar(name)) {
        return Err(missing(
            format!("property \"{name}\" of element \"vertex\""),
            source,
        ));
    }
    let has_normals = KEPT[3..].iter().all(|name| is_scalar(name));

    // A row has at least a byte a property, so a false count reserves no more memory than the file has bytes.
    let believed = element
        .count
        .min(rows.byte_count() / element.properties.len().max(1));
    let is_float = |name: &str| {
        let property = element.properties.get(name);
        let float = PropertyType::Scalar(ScalarType::Float);
        property.is_some_and(|p| p.data_type == float)
    };
    if !rows.is_text() && KEPT[..3].iter().all(|name| is_float(name)) {
        faces.vertices = Vertices::Narrow(Vec::new());
    }
    faces.vertices.reserve(believed);
    for row in 0..element.count {
        let fault = |fault| row_error(fault, element, row, source);
        rows.start(element.properties.len()).map_err(fault)?;
        let mut kept = [0.0_f64; KEPT.len()];
        for (place, data_type) in &plan {
            match (place, data_type) {
                (Some(place), PropertyType::Scalar(kind)) => {
                    kept[*place] = rows.number(kind).map_err(fault)?;
                }
                _ => rows.skip(data_type).map_err(fault)?,
            }
        }
        let [x, y, z, nx, ny, nz] = kept;
        faces.vertices.push([x, y, z]);
        if has_normals {
            let normal = [nx, ny, nz].map(|x| x as f32);
            faces.mesh.normals.push(unit_or_zero(normal));
        }
    }
    Ok(())
}

fn read_faces(
    rows: &mut Rows<'_>,
    element: &ElementDef,
    vertex_count: usize,
    faces: &mut Faces<'_>,
    source: &Source<'_>,
) -> Result<(), LoadError> {
    // Find the list, which has either name.
    let list = ["vertex_indices", "vertex_index"]
        .iter()
        .find_map(|name| match element.properties.get(*name)?.data_type {
            PropertyType::List(_, _) => Some(*name),
            PropertyType::Scalar(_) => None,
        })
        .ok_or_else(|| missing("list \"vertex_indices\" of element \"face\"".into(), source))?;

    let run = super::faces::Run {
        first: 0,
        count: vertex_count,
    };
    let mut corners: Vec<i64> = Vec::new();
    for row in 0..element.count {
        let fault = |fault| row_error(fault, element, row, source);
        rows.start(element.properties.len()).map_err(fault)?;
        for property in element.properties.values() {
            match &property.data_type {
                PropertyType::List(count, kind) if property.name == list => {
                    rows.indices(count, kind, &mut corners).map_err(fault)?;
                }
                other => rows.skip(other).map_err(fault)?,
            }
        }
        let place = FaceSite {
            line: rows.line(),
            part: None,
            face: row,
        };
        faces.polygon(&corners, run, place)?;
    }
    Ok(())
}

/// Skips an element's rows.
fn skip(rows: &mut Rows<'_>, element: &ElementDef, source: &Source<'_>) -> Result<(), LoadError> {
    // Rows without properties take no bytes, whatever their number.
    if element.properties.is_empty() {
        return Ok(());
    }
    for row in 0..element.count {
        let fault = |fault| row_error(fault, element, row, source);
        rows.start(element.properties.len()).map_err(fault)?;
        for property in element.properties.values() {
            rows.skip(&property.data_type).map_err(fault)?;
        }
    }
    Ok(())
}

fn missing(what: String, source: &Source<'_>) -> LoadError {
    LoadError::Missing {
        file: source.file.clone(),
        what,
    }
}

fn header_error(error: &ParseError, source: &Source<'_>, bytes: &[u8]) -> LoadError {
    let file = source.file.clone();
    if error.kind() == ErrorKind::UnexpectedEof {
        return LoadError::HeaderCut { file };
    }
    let Some(line) = error.line() else {
        let message = error.to_string();
        return LoadError::PlyHeader {
            file,
            message: message.lines().next().unwrap_or_default().into(),
        };
    };
    let mut lines = bytes.split_inclusive(|&byte| byte == b'\n');
    let text = lines.nth(line.saturating_sub(1)).unwrap_or_default();
    // A line without an end is the last one, but the header should have more.
    if line > 1 && !text.ends_with(b"\n") {
        return LoadError::HeaderCut { file };
    }
    LoadError::HeaderLine {
        file,
        line,
        text: excerpt(&String::from_utf8_lossy(text)),
    }
}

/// Adds the element and the row of a fault.
fn row_error(fault: Fault, element: &ElementDef, row: usize, source: &Source<'_>) -> LoadError {
    let file = source.file.clone();
    match fault {
        Fault::End => LoadError::EndsEarly {
            file,
            what: plural(&element.name),
            announced: element.count as u64,
            found: row as u64,
        },
        Fault::TooFew {
            line,
            needed,
            found,
        } => LoadError::TooFewNumbers {
            file,
            line,
            needed,
            found,
        },
        Fault::Word {
            line,
            text,
            expected,
        } => LoadError::BadNumber {
            file,
            line,
            text,
            expected,
        },
        Fault::Value { value, expected } => LoadError::BadValue {
            file,
            what: element.name.clone(),
            item: row as u64,
            value,
            expected,
        },
    }
}

fn plural(element: &str) -> String {
    match element {
        "vertex" => "vertices".into(),
        "face" => "faces".into(),
        other => format!("rows of \"{other}\""),
    }
}
