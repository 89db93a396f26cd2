//! OFF: counts, vertices and polygons, one a line of text. After <http://www.geomview.org/docs/html/OFF.html>.

use super::LoadError;
use super::error::excerpt;
use super::faces::{FaceSite, Faces, Run, unit_or_zero};
use super::load::{Found, Source};
use super::words::{self, Lines, Words, bad_word};

/// Reads OFF with the prefixes C, N and ST, or without a keyword.
pub(super) fn read(source: &Source<'_>, bytes: Vec<u8>) -> Result<Found, LoadError> {
    let bytes = words::without_mark(bytes);
    let mut text = Text::new(&bytes, source);
    let header = Header::read(&mut text)?;
    let mut body = Body::read(text.clone(), &header, bytes.len());
    if body.is_err() {
        // Rows may also take several lines, and lines several rows. Then they have no colors, which only the end of a line would end.
        text.rows_in_lines = false;
        let by_words = Body::read(text, &header, bytes.len());
        if by_words.as_ref().is_ok_and(|body| body.is_whole) {
            body = by_words;
        }
    }
    let body = body?;
    source.leave_out("vertex colours", body.vertex_colours);
    source.leave_out("face colours", body.face_colours);
    Ok(body.faces.into_found())
}

/// What stands before the vertices.
struct Header {
    has_normals: bool,
    has_colours: bool,
    has_texture_coordinates: bool,
    vertex_count: u64,
    face_count: u64,
}

impl Header {
    /// Reads the keyword, if there is one, and the counts, in one line or several.
    fn read(text: &mut Text<'_>) -> Result<Self, LoadError> {
        let source = text.source;
        let cut = || LoadError::HeaderCut {
            file: source.file.clone(),
        };
        text.rows_in_lines = false;
        let first = text.next().ok_or_else(cut)?;
        let mut prefix: &[u8] = b"";
        if first.iter().all(u8::is_ascii_digit) {
            text.ahead = Some(first);
        } else {
            let refuse = |header: &[u8]| LoadError::OffKind {
                file: source.file.clone(),
                header: excerpt(&String::from_utf8_lossy(header)),
            };
            let keyword = first.windows(3).position(|word| word == b"OFF");
            let keyword = keyword.ok_or_else(|| refuse(first))?;
            prefix = &first[..keyword];
            // The number of vertices may stand right behind.
            let count = &first[keyword + 3..];
            let is_known = prefix.iter().all(|letter| b"STCN".contains(letter));
            if !is_known || !count.iter().all(u8::is_ascii_digit) {
                return Err(refuse(first));
            }
            text.ahead = (!count.is_empty()).then_some(count);
            if text.clone().next() == Some(b"BINARY") {
                return Err(refuse(b"OFF BINARY"));
            }
        }
        text.needed = 2;
        let mut count = || match text.clone().next() {
            Some(_) => text.number("a count", count),
            None => Err(cut()),
        };
        let (vertex_count, face_count) = (count()?, count()?);
        text.skip_edge_count();
        Ok(Self {
            has_normals: prefix.contains(&b'N'),
            has_colours: prefix.contains(&b'C'),
            has_texture_coordinates: prefix.contains(&b'T'),
            vertex_count,
            face_count,
        })
    }
}

/// The vertices and faces.
struct Body<'a> {
    faces: Faces<'a>,
    vertex_colours: usize,
    face_colours: usize,
    /// Whether no words are left.
    is_whole: bool,
}

impl<'a> Body<'a> {
    fn read(mut text: Text<'a>, header: &Header, byte_count: usize) -> Result<Self, LoadError> {
        let mut body = Self {
            faces: Faces::new(text.source),
            vertex_colours: 0,
            face_colours: 0,
            is_whole: false,
        };
        // The header's count reserves no more than the text can hold: a vertex takes 6 bytes at least.
        let believed = header.vertex_count.min(byte_count as u64 / 6) as usize;
        body.faces.vertices.reserve(believed);
        body.read_vertices(&mut text, header)?;
        body.read_faces(&mut text, header)?;
        body.is_whole = text.next().is_none();
        Ok(body)
    }

    fn read_vertices(&mut self, text: &mut Text<'_>, header: &Header) -> Result<(), LoadError> {
        for vertex in 0..header.vertex_count {
            text.begin_row("vertices", header.vertex_count, vertex)?;
            text.needed = if header.has_normals { 6 } else { 3 };
            self.faces.vertices.push(text.vector()?);
            if header.has_normals {
                let normal = text.vector()?.map(|x| x as f32);
                self.faces.mesh.normals.push(unit_or_zero(normal));
            }
            let more = text.rest_of_row();
            let is_colour = header.has_colours && more > 0;
            let looks_like_colour = more >= 3 && !header.has_texture_coordinates;
            self.vertex_colours += usize::from(is_colour || looks_like_colour);
        }
        Ok(())
    }

    fn read_faces(&mut self, text: &mut Text<'_>, header: &Header) -> Result<(), LoadError> {
        // Every vertex was read, so the count fits into memory.
        let run = Run {
            first: 0,
            count: header.vertex_count as usize,
        };
        let mut corners: Vec<i64> = Vec::new();
        for face in 0..header.face_count {
            text.begin_row("faces", header.face_count, face)?;
            text.needed = 1;
            let corner_count = text.number("a count", count)?;
            text.needed = corner_count.saturating_add(1);
            corners.clear();
            for _ in 0..corner_count {
                corners.push(text.number("an index", words::whole)?);
            }
            let place = FaceSite {
                line: Some(text.line),
                part: None,
                face: face as usize,
            };
            self.faces.polygon(&corners, run, place)?;
            self.face_colours += usize::from(text.rest_of_row() > 0);
        }
        Ok(())
    }
}

fn count(word: &[u8]) -> Option<u64> {
    std::str::from_utf8(word).ok()?.parse().ok()
}

/// The words of a text.
#[derive(Clone)]
struct Text<'a> {
    source: &'a Source<'a>,
    lines: Lines<'a>,
    /// The current line's number, and the rest of it.
    line: usize,
    words: Words<'a>,
    /// A word before these.
    ahead: Option<&'a [u8]>,
    /// Whether each row is a line.
    rows_in_lines: bool,
    /// The number of numbers read of the row.
    found: u64,
    /// The number of numbers required, for messages.
    needed: u64,
}

impl<'a> Text<'a> {
    const fn new(text: &'a [u8], source: &'a Source<'a>) -> Self {
        Self {
            source,
            lines: Lines::new(text),
            line: 0,
            words: Words::new(&[]),
            ahead: None,
            rows_in_lines: true,
            found: 0,
            needed: 1,
        }
    }

    /// The next word of the row.
    #[inline]
    fn next(&mut self) -> Option<&'a [u8]> {
        if let Some(word) = self.ahead.take() {
            return Some(word);
        }
        loop {
            if let Some(word) = self.words.next() {
                return Some(word);
            }
            if self.rows_in_lines || !self.next_line() {
                return None;
            }
        }
    }

    /// Goes to the next line that is not blank.
    fn next_line(&mut self) -> bool {
        for (line, text) in self.lines.by_ref() {
            (self.line, self.words) = (line, Words::new(text));
            if !self.words.is_empty() {
                return true;
            }
        }
        false
    }

    /// Skips the number of edges. It may be missing: then no word follows in the line, and the next line is a vertex.
    fn skip_edge_count(&mut self) {
        self.rows_in_lines = true;
        if self.next().is_some() {
            return;
        }
        let mut below = self.clone();
        if below.next_line() && below.next().is_some() && below.next().is_none() {
            *self = below;
        }
    }

    fn begin_row(&mut self, what: &str, announced: u64, found: u64) -> Result<(), LoadError> {
        self.found = 0;
        if self.rows_in_lines && !self.next_line() {
            return Err(LoadError::EndsEarly {
                file: self.source.file.clone(),
                what: what.into(),
                announced,
                found,
            });
        }
        Ok(())
    }

    /// The number of words left in the row, if rows are lines.
    fn rest_of_row(&self) -> usize {
        match self.rows_in_lines {
            true => self.words.clone().count(),
            false => 0,
        }
    }

    /// The next number.
    #[inline]
    fn number<T>(
        &mut self,
        expected: &'static str,
        parse: fn(&[u8]) -> Option<T>,
    ) -> Result<T, LoadError> {
        let Some(word) = self.next() else {
            return Err(LoadError::TooFewNumbers {
                file: self.source.file.clone(),
                line: self.line,
                needed: self.needed,
                found: self.found,
            });
        };
        self.found += 1;
        parse(word).ok_or_else(|| bad_word(self.source, self.line, word, expected))
    }

    fn vector(&mut self) -> Result<[f64; 3], LoadError> {
        Ok([
            self.number("a number", words::number)?,
            self.number("a number", words::number)?,
            self.number("a number", words::number)?,
        ])
    }
}
