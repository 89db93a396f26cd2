//! PLY: elements with declared properties, as text or binary in either byte order.

mod header;
mod notes;
mod rows;

use super::LoadError;
use super::error::excerpt;
use super::faces::{FaceSite, Faces, Run, unit_or_zero};
use super::load::{Found, Source};
use super::vertices::Vertices;
use super::words::{self, without_mark};
use header::{Element, Encoding, Header, Kind, Scalar};
use rows::{Fault, Rows, RowsIn, Spare};

/// The vertex properties that are used.
const KEPT: [&str; 6] = ["x", "y", "z", "nx", "ny", "nz"];

/// Reads the elements `vertex`, `face` and `tristrips`, in any order.
pub(super) fn read(source: &Source<'_>, bytes: Vec<u8>) -> Result<Found, LoadError> {
    let bytes = without_mark(bytes);
    let header = Header::read(&bytes, source)?;
    if !header.elements.iter().any(|e| e.name == "vertex") {
        return Err(missing("element \"vertex\"".into(), source));
    }

    let (faces, spare) = read_rows(&header, source)?;
    let found = faces.into_found();
    notes::note(&header, &spare, source);
    Ok(found)
}

/// Reads all rows, and what stands behind and between them.
fn read_rows<'a>(
    header: &Header<'_>,
    source: &'a Source<'a>,
) -> Result<(Faces<'a>, Spare), LoadError> {
    let attempt = |rows_in| {
        let mut rows = header.rows(rows_in);
        let faces = read_elements(header, &mut rows, source)?;
        Ok((faces, rows.spare()))
    };
    let by_lines = attempt(RowsIn::Lines);
    if header.encoding != Encoding::Text || matches!(&by_lines, Ok((_, spare)) if spare.is_none()) {
        return by_lines;
    }
    // Rows that are not each a line are rare, and known by a line with too few or too many words.
    let by_words = attempt(RowsIn::Words);
    if matches!(&by_words, Ok((_, spare)) if spare.is_none()) {
        return by_words;
    }
    match source.options.lenient && by_lines.is_err() {
        true => attempt(RowsIn::SoundLines),
        false => by_lines,
    }
}

fn read_elements<'a>(
    header: &Header<'_>,
    rows: &mut Rows<'_>,
    source: &'a Source<'a>,
) -> Result<Faces<'a>, LoadError> {
    let mut faces = Faces::new(source);
    let vertex_count = header.count("vertex");
    // Faces before the vertices wait for these.
    let mut waiting = Vec::new();
    for element in &header.elements {
        let corners = Corners::of(element, source)?;
        match corners {
            Some(corners) if faces.vertices.len() == vertex_count => {
                read_faces(rows, element, corners, &mut faces, source)?;
            }
            Some(corners) => {
                waiting.push((rows.clone(), element, corners));
                skip(rows, element, source)?;
            }
            None if element.name == "vertex" => read_vertices(rows, element, &mut faces, source)?,
            None => skip(rows, element, source)?,
        }
    }
    for (mut rows, element, corners) in waiting {
        read_faces(&mut rows, element, corners, &mut faces, source)?;
    }
    Ok(faces)
}

fn read_vertices(
    rows: &mut Rows<'_>,
    element: &Element,
    faces: &mut Faces<'_>,
    source: &Source<'_>,
) -> Result<(), LoadError> {
    // For each used value, the property that holds it.
    let places = KEPT.map(|name| element.scalar(name));
    if let Some(i) = places[..3].iter().position(Option::is_none) {
        return Err(missing(
            format!("property \"{}\" of element \"vertex\"", KEPT[i]),
            source,
        ));
    }
    let has_normals = places[3..].iter().all(Option::is_some);
    let plan = (0..).zip(&element.properties).map(|(i, property)| {
        let kept = places.iter().position(|p| p.is_some_and(|(at, _)| at == i));
        (kept, property.kind)
    });
    let plan: Vec<(Option<usize>, Kind)> = plan.collect();

    // A row has at least a byte a property, so a false count reserves no more memory than the file has bytes.
    let least = rows.byte_count() / element.properties.len().max(1);
    let believed = element.count.min(least);
    let is_f32 = |place: &Option<(usize, Scalar)>| place.is_some_and(|(_, s)| s == Scalar::F32);
    if rows.line().is_none() && faces.vertices.len() == 0 && places[..3].iter().all(is_f32) {
        faces.vertices = Vertices::narrow();
    }
    // A second list of vertices may have normals, or none, where the first differs.
    let first = faces.vertices.len();
    if has_normals {
        faces.mesh.normals.resize(first, [0.0; 3]);
    }
    faces.vertices.reserve(believed);
    for row in 0..element.count {
        let fault = |fault| row_error(fault, element, row, source);
        rows.start(element.properties.len()).map_err(fault)?;
        let [x, y, z, nx, ny, nz] = match kept_numbers(rows, &plan) {
            Ok(kept) => kept,
            // Faces with this vertex are dropped.
            Err(broken) if rows.drop_row(&broken) => [f64::NAN; KEPT.len()],
            Err(broken) => return Err(fault(broken)),
        };
        if let Some(&value) = [x, y, z].iter().find(|x| words::is_too_large(**x))
            && !source.options.lenient
        {
            return Err(fault(rows.unexpected(value, words::COORDINATE)));
        }
        faces.vertices.push([x, y, z]);
        if has_normals {
            let normal = [nx, ny, nz].map(|x| x as f32);
            faces.mesh.normals.push(unit_or_zero(normal));
        }
    }
    if !faces.mesh.normals.is_empty() {
        faces.mesh.normals.resize(faces.vertices.len(), [0.0; 3]);
    }
    Ok(())
}

/// The used values of a row. The plan has a place among them, or none, for each property.
#[inline]
fn kept_numbers(
    rows: &mut Rows<'_>,
    plan: &[(Option<usize>, Kind)],
) -> Result<[f64; KEPT.len()], Fault> {
    let mut kept = [0.0; KEPT.len()];
    for (place, kind) in plan {
        match (place, kind) {
            (Some(place), Kind::Scalar(kind)) => kept[*place] = rows.number(*kind)?,
            _ => rows.skip(*kind)?,
        }
    }
    Ok(kept)
}

/// The list that has the corners of an element's faces.
#[derive(Clone, Copy)]
struct Corners {
    /// Among the properties.
    place: usize,
    are_strips: bool,
}

impl Corners {
    /// `None` for an element that has no faces.
    fn of(element: &Element, source: &Source<'_>) -> Result<Option<Self>, LoadError> {
        let are_strips = match element.name.as_str() {
            "face" => false,
            "tristrips" => true,
            _ => return Ok(None),
        };
        match element.corners() {
            Some(place) => Ok(Some(Self { place, are_strips })),
            // An element without rows needs none.
            None if element.count == 0 => Ok(None),
            None => Err(missing(
                format!("list \"vertex_indices\" of element \"{}\"", element.name),
                source,
            )),
        }
    }
}

fn read_faces(
    rows: &mut Rows<'_>,
    element: &Element,
    list: Corners,
    faces: &mut Faces<'_>,
    source: &Source<'_>,
) -> Result<(), LoadError> {
    let run = Run {
        first: 0,
        count: faces.vertices.len(),
    };
    let mut corners: Vec<i64> = Vec::new();
    for row in 0..element.count {
        let fault = |fault| row_error(fault, element, row, source);
        rows.start(element.properties.len()).map_err(fault)?;
        match read_corners(rows, element, list.place, &mut corners) {
            Ok(()) => {}
            Err(broken) if rows.drop_row(&broken) => {
                faces.dropped_count += 1;
                continue;
            }
            Err(broken) => return Err(fault(broken)),
        }
        let site = FaceSite {
            line: rows.line(),
            part: None,
            face: row,
        };
        if list.are_strips {
            read_strips(&corners, run, site, faces)?;
        } else {
            faces.polygon(&corners, run, site)?;
        }
    }
    Ok(())
}

/// Reads the row of a face, whose corners are in the list at this place.
#[inline]
fn read_corners(
    rows: &mut Rows<'_>,
    element: &Element,
    place: usize,
    corners: &mut Vec<i64>,
) -> Result<(), Fault> {
    for (at, property) in element.properties.iter().enumerate() {
        match property.kind {
            Kind::List { count, item } if at == place => rows.indices(count, item, corners)?,
            other => rows.skip(other)?,
        }
    }
    Ok(())
}

/// Adds strips of triangles, which -1 separates. Every other triangle is turned, and those with a corner twice are seams.
fn read_strips(
    corners: &[i64],
    run: Run,
    site: FaceSite<'_>,
    faces: &mut Faces<'_>,
) -> Result<(), LoadError> {
    let is_end = |corner: &i64| *corner == -1 || *corner == i64::from(u32::MAX);
    for strip in corners.split(is_end) {
        for (i, triangle) in strip.windows(3).enumerate() {
            let [a, b, c] = [triangle[0], triangle[1], triangle[2]];
            if a == b || b == c || c == a {
                continue;
            }
            let triangle = if i % 2 == 0 { [a, b, c] } else { [b, a, c] };
            faces.polygon(&triangle, run, site)?;
        }
    }
    Ok(())
}

/// Skips an element's rows.
fn skip(rows: &mut Rows<'_>, element: &Element, source: &Source<'_>) -> Result<(), LoadError> {
    // Rows without properties take no bytes, whatever their number.
    if element.properties.is_empty() {
        return Ok(());
    }
    for row in 0..element.count {
        let fault = |fault| row_error(fault, element, row, source);
        rows.start(element.properties.len()).map_err(fault)?;
        let skipped = element
            .properties
            .iter()
            .try_for_each(|p| rows.skip(p.kind));
        match skipped {
            Err(broken) if !rows.drop_row(&broken) => return Err(fault(broken)),
            _ => {}
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

/// Adds the element and the row of a fault.
fn row_error(fault: Fault, element: &Element, row: usize, source: &Source<'_>) -> LoadError {
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
        "tristrips" => "strips".into(),
        other => format!("rows of \"{}\"", excerpt(other)),
    }
}
