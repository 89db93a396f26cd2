//! STL: triangles with separate corners, as text or binary. Equal corners weld to one vertex. Normals are not read.

use super::LoadError;
use super::faces::Faces;
use super::load::{Found, Source};
use super::words::{self, Lines, Words, bad_word};
use crate::Part;
use std::collections::HashMap;
use std::hash::Hash;

/// Bytes before the first triangle of a binary file: 80 arbitrary ones, then the count.
const HEADER_BYTES: usize = 84;
/// Bytes of a binary triangle: its normal, three corners, and a word that some programs keep a color in.
const TRIANGLE_BYTES: usize = 50;

/// Reads text, with a part for each solid, or binary.
pub(super) fn read(source: &Source<'_>, bytes: Vec<u8>) -> Result<Found, LoadError> {
    if !has_exact_length(&bytes) {
        let bytes = words::without_mark(bytes);
        return match is_text(&bytes) {
            true => read_text(source, &bytes),
            false => read_binary(source, &bytes),
        };
    }
    read_binary(source, &bytes)
}

/// Whether the length is that of a binary file with its count of triangles: then it is one, even if it begins with `solid`.
pub(super) fn has_exact_length(bytes: &[u8]) -> bool {
    announced(bytes).is_some_and(|count| expected_bytes(count) == bytes.len() as u64)
}

/// Whether a file begins as text does, and has no zero bytes.
pub(super) fn is_text(bytes: &[u8]) -> bool {
    let word = Words::new(bytes).next().unwrap_or_default();
    let begins = ["solid", "facet"].iter().any(|begin| is(word, begin));
    begins && has_no_zero(bytes)
}

/// Whether the first bytes are those of a text.
fn has_no_zero(bytes: &[u8]) -> bool {
    !bytes.iter().take(512).any(|&byte| byte == 0)
}

/// The count in a binary file's header.
fn announced(bytes: &[u8]) -> Option<u32> {
    let count = bytes.get(HEADER_BYTES - 4..)?.first_chunk()?;
    Some(u32::from_le_bytes(*count))
}

fn expected_bytes(count: u32) -> u64 {
    HEADER_BYTES as u64 + u64::from(count) * TRIANGLE_BYTES as u64
}

/// Reads binary. If its count does not fit its length, the length is right where it is that of whole triangles; bytes behind the last
/// triangle are skipped.
fn read_binary(source: &Source<'_>, bytes: &[u8]) -> Result<Found, LoadError> {
    let file = || source.file.clone();
    if has_no_zero(bytes) {
        return Err(LoadError::NotStl { file: file() });
    }
    let count = announced(bytes).ok_or_else(|| LoadError::HeaderCut { file: file() })? as usize;
    let (triangles, rest) = bytes[HEADER_BYTES..].as_chunks::<TRIANGLE_BYTES>();
    let held = triangles.len();
    if count > held && (held == 0 || !rest.is_empty()) {
        return Err(LoadError::StlShort {
            file: file(),
            announced: count as u32,
            found: held as u64,
        });
    }
    // A file of zeros holds nothing.
    let is_blank = || triangles.as_flattened().iter().all(|&byte| byte == 0);
    let read = match count {
        0 if is_blank() => 0,
        0 => held,
        _ if rest.is_empty() => held,
        count => count,
    };
    source.leave_out("triangles announced, but missing", {
        count.saturating_sub(held)
    });
    let behind = (held - read) * TRIANGLE_BYTES + rest.len();
    source.leave_out("bytes behind the last triangle", behind);
    // Some programs write the color of all facets here.
    let header = &bytes[..HEADER_BYTES - 4];
    let is_coloured = memchr::memmem::find(header, b"COLOR=").is_some();
    source.leave_out("colours in the header", usize::from(is_coloured));

    let mut weld = Weld::new(source);
    weld.faces.vertices = super::vertices::Vertices::narrow();
    weld.faces.mesh.indices.reserve(read);
    let mut colored = 0;
    for triangle in &triangles[..read] {
        let (numbers, rest) = triangle.as_chunks::<4>();
        let [_, a, b, c, ..] = numbers.as_chunks::<3>().0 else {
            continue;
        };
        colored += usize::from(rest != [0, 0]);
        for corner in [a, b, c] {
            let corner = corner.map(f32::from_le_bytes);
            weld.corner(corner.map(|x| (x + 0.0).to_bits()), corner.map(f64::from));
        }
        weld.close()?;
    }
    source.leave_out("facet colours", colored);
    Ok(weld.faces.into_found())
}

/// Reads text.
fn read_text(source: &Source<'_>, bytes: &[u8]) -> Result<Found, LoadError> {
    let mut text = Text::new(bytes);
    let mut weld = Weld::new(source);
    // Facets that have ended; whether a solid has begun, and whether the current facet is sound.
    let (mut face, mut is_open, mut is_sound, mut colors) = (0, false, true, 0);
    let mut has_part = false;
    let cut = |face| LoadError::StlCut {
        file: source.file.clone(),
        face,
    };
    while let Some(word) = text.next() {
        if is(word, "solid") {
            weld.part(text.solid_name());
            (is_open, has_part) = (true, true);
        } else if is(word, "endsolid") {
            text.skip_line();
            (is_open, has_part) = (false, false);
        } else if is(word, "facet") {
            if !has_part {
                weld.part(String::new());
                has_part = true;
            }
            weld.corners.clear();
            is_sound = true;
            // A normal may be anything.
            while text.peek().is_some_and(|word| !begins_loop(word)) {
                text.next();
            }
        } else if is(word, "vertex") {
            let mut corner = [0.0; 3];
            for x in &mut corner {
                let word = text.next().ok_or_else(|| cut(face))?;
                *x = words::coordinate(source, text.line, word)?;
            }
            weld.corner(corner.map(|x| (x + 0.0).to_bits()), corner);
        } else if is(word, "endfacet") {
            face += 1;
            match is_sound {
                true => weld.close()?,
                false => {
                    weld.faces.dropped_count += 1;
                    weld.corners.clear();
                }
            }
        } else if is(word, "color") {
            colors += 1;
            text.skip_line();
        } else if !["outer", "loop", "endloop"].iter().any(|w| is(word, w)) {
            if !source.options.lenient {
                return Err(bad_word(source, text.line, word, "a word of STL"));
            }
            is_sound = false;
        }
    }
    if is_open || !weld.corners.is_empty() {
        return Err(cut(face));
    }
    weld.end_part();
    source.leave_out("facet colours", colors);
    // A single unnamed solid needs no part.
    let parts = &mut weld.faces.mesh.parts;
    if matches!(&parts[..], [part] if part.name.is_empty()) {
        parts.clear();
    }
    Ok(weld.faces.into_found())
}

fn is(word: &[u8], keyword: &str) -> bool {
    word.eq_ignore_ascii_case(keyword.as_bytes())
}

/// Whether the word ends what stands behind `facet`.
fn begins_loop(word: &[u8]) -> bool {
    ["outer", "loop", "vertex", "endfacet"]
        .iter()
        .any(|begin| is(word, begin))
}

/// The words of a text, over all its lines.
#[derive(Clone)]
struct Text<'a> {
    lines: Lines<'a>,
    words: Words<'a>,
    line: usize,
}

impl<'a> Text<'a> {
    const fn new(text: &'a [u8]) -> Self {
        Self {
            lines: Lines::new(text),
            words: Words::new(&[]),
            line: 0,
        }
    }

    fn next(&mut self) -> Option<&'a [u8]> {
        loop {
            if let Some(word) = self.words.next() {
                return Some(word);
            }
            let (line, text) = self.lines.next()?;
            (self.line, self.words) = (line, Words::new(text));
        }
    }

    fn peek(&self) -> Option<&'a [u8]> {
        self.clone().next()
    }

    fn skip_line(&mut self) {
        self.words = Words::new(&[]);
    }

    /// The rest of the line, or up to a facet if one begins in it.
    fn solid_name(&mut self) -> String {
        let name = self.words.rest();
        let mut ahead = self.words.clone();
        loop {
            let rest = ahead.rest();
            match ahead.next() {
                Some(word) if is(word, "facet") => {
                    if ahead.clone().next().is_some_and(|word| is(word, "normal")) {
                        self.words = Words::new(rest);
                        return words::name(&name[..name.len() - rest.len()]);
                    }
                }
                Some(_) => {}
                None => {
                    self.skip_line();
                    return words::name(name);
                }
            }
        }
    }
}

/// A mesh under construction, with the vertex of every corner so far.
struct Weld<'a, K> {
    faces: Faces<'a>,
    /// By the bits of the coordinates; both zeros are one.
    vertices: HashMap<[K; 3], u32>,
    /// Those of the current facet.
    corners: Vec<u32>,
}

impl<'a, K: Eq + Hash> Weld<'a, K> {
    fn new(source: &'a Source<'a>) -> Self {
        Self {
            faces: Faces::new(source),
            vertices: HashMap::new(),
            corners: Vec::new(),
        }
    }

    fn corner(&mut self, bits: [K; 3], position: [f64; 3]) {
        let next = self.faces.vertices.len() as u32;
        let vertex = *self.vertices.entry(bits).or_insert(next);
        if vertex == next {
            self.faces.vertices.push(position);
        }
        self.corners.push(vertex);
    }

    /// Adds the current facet.
    fn close(&mut self) -> Result<(), LoadError> {
        let corners = &self.corners;
        self.faces.cut(corners.len(), |i| corners[i])?;
        self.corners.clear();
        Ok(())
    }

    /// Begins a part.
    fn part(&mut self, name: String) {
        self.end_part();
        let first_triangle = self.faces.mesh.indices.len() as u32;
        self.faces.mesh.parts.push(Part {
            name,
            first_triangle,
            triangle_count: 0,
        });
    }

    /// Ends the part that began last.
    fn end_part(&mut self) {
        let count = self.faces.mesh.indices.len() as u32;
        if let Some(part) = self.faces.mesh.parts.last_mut() {
            part.triangle_count = count - part.first_triangle;
        }
    }
}
