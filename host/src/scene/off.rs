//! OFF: counts, vertices and polygons, one a line of text. After <http://www.geomview.org/docs/html/OFF.html>.

use super::LoadError;
use super::error::excerpt;
use super::faces::{FaceSite, Faces, unit_or_zero};
use super::load::{Found, Source};
use std::str::FromStr;

/// Reads OFF with the prefixes C, N and ST. Colors and texture coordinates are skipped.
pub(super) fn read(source: &Source<'_>, bytes: Vec<u8>) -> Result<Found, LoadError> {
    let text = String::from_utf8_lossy(&bytes);
    let mut lines = Lines::new(text.trim_start_matches('\u{feff}'));
    let cut = || LoadError::HeaderCut {
        file: source.file.clone(),
    };

    // The counts follow the keyword, or are in the next line.
    let mut header = lines.next().ok_or_else(cut)?;
    let has_normals = vertices_have_normals(&header, source)?;
    header.words.next();
    let mut counts = if header.words.clone().next().is_some() {
        header
    } else {
        lines.next().ok_or_else(cut)?
    };
    counts.needed = 2;
    let vertex_count: u64 = counts.number("a count", source)?;
    let face_count: u64 = counts.number("a count", source)?;

    let mut faces = Faces::new(source);
    let early = |what: &str, announced, found| LoadError::EndsEarly {
        file: source.file.clone(),
        what: what.into(),
        announced,
        found,
    };

    // The header's count reserves no more than the text can hold: a vertex takes 6 bytes at least.
    let believed = vertex_count.min(bytes.len() as u64 / 6) as usize;
    faces.vertices.reserve(believed);
    for found in 0..vertex_count {
        let mut line = lines
            .next()
            .ok_or_else(|| early("vertices", vertex_count, found))?;
        line.needed = if has_normals { 6 } else { 3 };
        faces.vertices.push(line.vector(source)?);
        if has_normals {
            let normal: [f64; 3] = line.vector(source)?;
            faces
                .mesh
                .normals
                .push(unit_or_zero(normal.map(|x| x as f32)));
        }
    }

    // Every vertex was read, so the count fits into memory.
    let run = super::faces::Run {
        first: 0,
        count: vertex_count as usize,
    };
    let mut corners: Vec<i64> = Vec::new();
    for face in 0..face_count {
        let mut line = lines
            .next()
            .ok_or_else(|| early("faces", face_count, face))?;
        let corner_count: u64 = line.number("a count", source)?;
        line.needed = corner_count.saturating_add(1);
        corners.clear();
        for _ in 0..corner_count {
            corners.push(line.number("an index", source)?);
        }
        let place = FaceSite {
            line: Some(line.line),
            part: None,
            face: face as usize,
        };
        faces.polygon(&corners, run, place)?;
    }
    Ok(faces.into_found())
}

/// Whether the keyword says that vertices have normals.
fn vertices_have_normals(header: &Line<'_>, source: &Source<'_>) -> Result<bool, LoadError> {
    let mut words = header.words.clone();
    let keyword = words.next().unwrap_or_default();
    let prefix = keyword.strip_suffix("OFF");
    let is_binary = words.next() == Some("BINARY");
    match prefix {
        Some(prefix) if !is_binary && prefix.chars().all(|c| "STCN".contains(c)) => {
            Ok(prefix.contains('N'))
        }
        _ => Err(LoadError::OffKind {
            file: source.file.clone(),
            header: excerpt(if is_binary { "OFF BINARY" } else { keyword }),
        }),
    }
}

/// The lines, without comments and blank lines.
struct Lines<'a> {
    rest: std::iter::Enumerate<std::str::Lines<'a>>,
}

/// One line.
struct Line<'a> {
    /// Counted from 1.
    line: usize,
    words: std::str::SplitWhitespace<'a>,
    /// The number of numbers read.
    found: u64,
    /// The number of numbers required, for messages.
    needed: u64,
}

impl<'a> Lines<'a> {
    fn new(text: &'a str) -> Self {
        Self {
            rest: text.lines().enumerate(),
        }
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = Line<'a>;

    fn next(&mut self) -> Option<Line<'a>> {
        self.rest.find_map(|(index, text)| {
            let words = text.split('#').next()?.split_whitespace();
            words.clone().next()?;
            Some(Line {
                line: index + 1,
                words,
                found: 0,
                needed: 1,
            })
        })
    }
}

impl Line<'_> {
    /// The next number.
    fn number<T: FromStr>(
        &mut self,
        expected: &'static str,
        source: &Source<'_>,
    ) -> Result<T, LoadError> {
        let Some(word) = self.words.next() else {
            return Err(LoadError::TooFewNumbers {
                file: source.file.clone(),
                line: self.line,
                needed: self.needed,
                found: self.found,
            });
        };
        self.found += 1;
        word.parse().map_err(|_| LoadError::BadNumber {
            file: source.file.clone(),
            line: self.line,
            text: excerpt(word),
            expected,
        })
    }

    fn vector(&mut self, source: &Source<'_>) -> Result<[f64; 3], LoadError> {
        Ok([
            self.number("a number", source)?,
            self.number("a number", source)?,
            self.number("a number", source)?,
        ])
    }
}
