//! A filter of the lines of an OBJ file for `tobj`.

use super::super::error::Indexed;
use std::io::{BufRead, Read, Result};

/// Passes lines on without their leading space, except:
/// - `l` and `p`, because `tobj` reads a polyline as a polygon;
/// - `vt`, because texture coordinates are unused, and a face whose index to one is out of range is still valid;
/// - lines of faces known to be broken.
pub(super) struct Lines<'a> {
    rest: std::str::SplitInclusive<'a, char>,
    /// The unread rest of the current line.
    current: &'a [u8],
    line: usize,
    /// Ordered by line.
    broken: &'a [BrokenFace],
}

/// A face that refers to a missing vertex or normal, or cannot be read.
pub(super) struct BrokenFace {
    /// Counted from 1.
    pub line: usize,
    /// Counted from 0 in the file.
    pub face: usize,
    pub fault: Fault,
}

/// The fault of a face.
#[derive(Clone, Copy)]
pub(super) enum Fault {
    /// It has no corners, or a corner cannot be read.
    Unreadable,
    /// An index is outside of a list.
    Outside {
        list: Indexed,
        /// As written.
        index: i64,
        /// The list's length.
        count: usize,
    },
}

impl<'a> Lines<'a> {
    pub fn new(text: &'a str, broken: &'a [BrokenFace]) -> Self {
        Self {
            rest: text.trim_start_matches('\u{feff}').split_inclusive('\n'),
            current: &[],
            line: 0,
            broken,
        }
    }

    /// The line passed on last, counted from 1.
    pub fn line(&self) -> usize {
        self.line
    }

    fn is_broken(&self) -> bool {
        self.broken
            .binary_search_by_key(&self.line, |face| face.line)
            .is_ok()
    }
}

impl BufRead for Lines<'_> {
    fn fill_buf(&mut self) -> Result<&[u8]> {
        while self.current.is_empty() {
            let Some(line) = self.rest.next() else {
                break;
            };
            self.line += 1;
            let word = line.split_whitespace().next().unwrap_or_default();
            if !matches!(word, "" | "l" | "p" | "vt") && !self.is_broken() {
                self.current = line.trim_start().as_bytes();
            }
        }
        Ok(self.current)
    }

    fn consume(&mut self, count: usize) {
        self.current = &self.current[count..];
    }
}

impl Read for Lines<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> Result<usize> {
        let count = self.fill_buf()?.read(buffer)?;
        self.consume(count);
        Ok(count)
    }
}

/// All broken faces: those that refer to a missing vertex or normal, or cannot be read. Indices count from 1; negative ones
/// count back from the last vertex above the face.
pub(super) fn broken_faces(text: &str) -> impl Iterator<Item = BrokenFace> + '_ {
    let total = |keyword| {
        let lines = text.lines();
        lines
            .filter(|line| line.split_whitespace().next() == Some(keyword))
            .count()
    };
    let totals = (total("v"), total("vn"));
    let (mut vertices, mut normals, mut faces) = (0, 0, 0);
    text.lines().enumerate().filter_map(move |(index, line)| {
        let mut words = line.split_whitespace();
        match words.next()? {
            "v" => vertices += 1,
            "vn" => normals += 1,
            "f" => {
                let face = faces;
                faces += 1;
                let fault = match words.clone().next() {
                    Some(_) => words.find_map(|corner| fault(corner, (vertices, normals), totals)),
                    None => Some(Fault::Unreadable),
                };
                let line = index + 1;
                return fault.map(|fault| BrokenFace { line, face, fault });
            }
            _ => {}
        }
        None
    })
}

/// The fault of a corner such as `3`, `3/1`, `3//2` or `3/1/2`, given the numbers of vertices and normals above it and in
/// the whole file.
fn fault(corner: &str, above: (usize, usize), totals: (usize, usize)) -> Option<Fault> {
    let mut indices = [None; 3];
    for (place, word) in corner.split('/').enumerate() {
        match (indices.get_mut(place), word.parse::<i64>()) {
            (Some(index), Ok(number)) => *index = Some(number),
            (_, Err(_)) if word.is_empty() => {}
            _ => return Some(Fault::Unreadable),
        }
    }
    let [vertex, _, normal] = indices;
    // A corner without a vertex refers to vertex 0, which does not exist. Normal 0 means no normal.
    let vertex = vertex.unwrap_or(0);
    if is_outside(vertex, above.0, totals.0) {
        return Some(Fault::Outside {
            list: Indexed::Vertices,
            index: vertex,
            count: totals.0,
        });
    }
    let normal = normal.filter(|&index| index != 0 && is_outside(index, above.1, totals.1))?;
    Some(Fault::Outside {
        list: Indexed::Normals,
        index: normal,
        count: totals.1,
    })
}

/// Whether the index is outside of the list.
fn is_outside(index: i64, above: usize, total: usize) -> bool {
    let place = match index {
        ..0 => index.saturating_add_unsigned(above as u64),
        _ => index - 1,
    };
    !usize::try_from(place).is_ok_and(|place| place < total)
}
