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
    let body = Body::read_any(&text, &header, bytes.len())?;
    body.note(source);
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
        text.rows_in = RowsIn::Words { skipped: 0 };
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
    texture_coordinates: usize,
    /// Vertices with further numbers, which are no color.
    spare: usize,
    /// Lines behind the last face.
    lines_behind: usize,
}

/// What separates rows.
#[derive(Clone, Copy, PartialEq, Eq)]
enum RowsIn {
    /// Each row is a line.
    Lines,
    /// A row may take several lines, and a line several rows. Each vertex has this many numbers behind those that are read, and faces
    /// have no color, which only the end of a line would end.
    Words { skipped: u64 },
    /// Each row is a line, and a broken one is dropped.
    SoundLines,
}

impl<'a> Body<'a> {
    /// Reads rows in lines; if that fails, in words, if these leave no word; else sound lines, with lenient options.
    fn read_any(text: &Text<'a>, header: &Header, byte_count: usize) -> Result<Self, LoadError> {
        let attempt = |rows_in| Self::read(text.clone(), header, byte_count, rows_in);
        let by_lines = attempt(RowsIn::Lines);
        if by_lines.is_ok() {
            return by_lines;
        }
        let texture = if header.has_texture_coordinates { 2 } else { 0 };
        let colours: &[u64] = if header.has_colours { &[4, 3] } else { &[0] };
        for colour in colours {
            let skipped = colour + texture;
            let by_words = attempt(RowsIn::Words { skipped });
            if by_words.as_ref().is_ok_and(|body| body.lines_behind == 0) {
                return by_words;
            }
        }
        match text.source.options.lenient {
            true => attempt(RowsIn::SoundLines),
            false => by_lines,
        }
    }

    fn read(
        mut text: Text<'a>,
        header: &Header,
        byte_count: usize,
        rows_in: RowsIn,
    ) -> Result<Self, LoadError> {
        text.rows_in = rows_in;
        let mut body = Self {
            faces: Faces::new(text.source),
            vertex_colours: 0,
            face_colours: 0,
            texture_coordinates: 0,
            spare: 0,
            lines_behind: 0,
        };
        // The header's count reserves no more than the text can hold: a vertex takes 6 bytes at least.
        let believed = header.vertex_count.min(byte_count as u64 / 6) as usize;
        body.faces.vertices.reserve(believed);
        body.read_vertices(&mut text, header)?;
        body.read_faces(&mut text, header)?;
        body.lines_behind = text.lines_behind();
        Ok(body)
    }

    fn note(&self, source: &Source<'_>) {
        source.leave_out("vertex colours", self.vertex_colours);
        source.leave_out("face colours", self.face_colours);
        source.leave_out("texture coordinates", self.texture_coordinates);
        source.leave_out("vertices with spare numbers", self.spare);
        source.leave_out("lines behind the end", self.lines_behind);
    }

    fn read_vertices(&mut self, text: &mut Text<'_>, header: &Header) -> Result<(), LoadError> {
        for vertex in 0..header.vertex_count {
            text.begin_row("vertices", header.vertex_count, vertex)?;
            text.needed = if header.has_normals { 6 } else { 3 };
            let (position, normal) = match text.vertex(header.has_normals) {
                // Faces with this vertex are dropped.
                Err(_) if text.drop_row() => ([f64::NAN; 3], [0.0; 3]),
                read => read?,
            };
            self.faces.vertices.push(position);
            if header.has_normals {
                self.faces.mesh.normals.push(normal);
            }
            self.count_spare(text, header)?;
        }
        Ok(())
    }

    /// Counts what stands behind a vertex: a color, texture coordinates, or neither.
    #[inline]
    fn count_spare(&mut self, text: &mut Text<'_>, header: &Header) -> Result<(), LoadError> {
        let more = match text.rows_in {
            RowsIn::Words { skipped } => {
                for _ in 0..skipped {
                    text.number("a number", words::number)?;
                }
                skipped as usize
            }
            _ => text.rest_of_row(),
        };
        if more == 0 {
            return Ok(());
        }
        let texture = usize::from(header.has_texture_coordinates && more >= 2) * 2;
        let is_colour = more - texture >= if header.has_colours { 1 } else { 3 };
        self.texture_coordinates += texture / 2;
        self.vertex_colours += usize::from(is_colour);
        self.spare += usize::from(!is_colour && more > texture);
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
            match text.corners(&mut corners) {
                Ok(()) => {}
                Err(_) if text.drop_row() => {
                    self.faces.dropped_count += 1;
                    continue;
                }
                Err(error) => return Err(error),
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
    rows_in: RowsIn,
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
            rows_in: RowsIn::Lines,
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
            if self.are_lines() || !self.next_line() {
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
        self.rows_in = RowsIn::Lines;
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
        if self.are_lines() && !self.next_line() {
            return Err(LoadError::EndsEarly {
                file: self.source.file.clone(),
                what: what.into(),
                announced,
                found,
            });
        }
        Ok(())
    }

    const fn are_lines(&self) -> bool {
        !matches!(self.rows_in, RowsIn::Words { .. })
    }

    /// The number of words left in the row, if rows are lines.
    fn rest_of_row(&self) -> usize {
        match self.are_lines() {
            true => self.words.clone().count(),
            false => 0,
        }
    }

    /// Drops the rest of a broken row, if rows are sound lines.
    fn drop_row(&mut self) -> bool {
        self.words = Words::new(&[]);
        self.rows_in == RowsIn::SoundLines
    }

    /// The number of lines with words left, behind the last row.
    fn lines_behind(mut self) -> usize {
        let begun = !self.are_lines() && !self.words.is_empty();
        std::iter::from_fn(|| self.next_line().then_some(())).count() + usize::from(begun)
    }

    /// The next word of the row, which must be there.
    #[inline]
    fn word(&mut self) -> Result<&'a [u8], LoadError> {
        let Some(word) = self.next() else {
            return Err(LoadError::TooFewNumbers {
                file: self.source.file.clone(),
                line: self.line,
                needed: self.needed,
                found: self.found,
            });
        };
        self.found += 1;
        Ok(word)
    }

    /// The next number.
    #[inline]
    fn number<T>(
        &mut self,
        expected: &'static str,
        parse: fn(&[u8]) -> Option<T>,
    ) -> Result<T, LoadError> {
        let word = self.word()?;
        parse(word).ok_or_else(|| bad_word(self.source, self.line, word, expected))
    }

    /// The position of a vertex, and its normal, or zero.
    #[inline]
    fn vertex(&mut self, has_normals: bool) -> Result<([f64; 3], [f32; 3]), LoadError> {
        let position = self.vector(words::coordinate)?;
        let normal = match has_normals {
            true => self.vector(words::normal_part)?.map(|x| x as f32),
            false => [0.0; 3],
        };
        Ok((position, unit_or_zero(normal)))
    }

    #[inline]
    fn vector(
        &mut self,
        read: fn(&Source<'_>, usize, &[u8]) -> Result<f64, LoadError>,
    ) -> Result<[f64; 3], LoadError> {
        let mut vector = [0.0; 3];
        for x in &mut vector {
            let word = self.word()?;
            *x = read(self.source, self.line, word)?;
        }
        Ok(vector)
    }

    /// The number of corners, and these.
    #[inline]
    fn corners(&mut self, corners: &mut Vec<i64>) -> Result<(), LoadError> {
        self.needed = 1;
        let corner_count = self.number("a count", count)?;
        self.needed = corner_count.saturating_add(1);
        corners.clear();
        for _ in 0..corner_count {
            corners.push(self.number("an index", words::whole)?);
        }
        Ok(())
    }
}
