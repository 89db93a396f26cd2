//! The statements of an OBJ file, in lists.

use super::super::LoadError;
use super::super::faces::unit_or_zero;
use super::super::left_out::POINTS;
use super::super::load::Source;
use super::super::words::{self, Words, bad_word, whole};
use super::corner::{Corner, Counts, Outside, Word};
use super::libraries::Libraries;
use super::lines::Lines;
use std::collections::{HashMap, HashSet};

/// What a file states. Faces may come before their vertices, so they are looked up at the end.
#[derive(Default)]
pub(super) struct File {
    pub vertices: Vec<[f64; 3]>,
    pub normals: Vec<[f32; 3]>,
    /// The corners of all faces.
    pub corners: Vec<Corner>,
    /// For each face, where its corners end.
    pub ends: Vec<u32>,
    /// Groups and objects, each with its first face.
    pub parts: Vec<(String, usize)>,
    /// Names of materials, each with its first face.
    pub materials: Vec<(u32, usize)>,
    /// The names, without repetition.
    pub names: Vec<String>,
    pub libraries: Libraries,
    /// Broken faces that were left out.
    pub dropped_count: usize,
}

/// A face that refers to items below it.
struct Forward {
    /// In the list.
    face: usize,
    place: Place,
}

/// Where a face stands.
#[derive(Clone, Copy)]
struct Place {
    line: usize,
    /// Counted from 0 in the file.
    face: usize,
}

/// What is counted, and noted at the end.
#[derive(Default)]
struct Noted {
    vertex_colours: usize,
    texture_coordinates: usize,
    lines: usize,
    points: usize,
    curves: usize,
    surfaces: usize,
    unknown: usize,
    smoothing_groups: HashSet<i64>,
}

struct Statements<'a> {
    source: &'a Source<'a>,
    file: File,
    noted: Noted,
    /// Faces so far, with broken ones.
    face_count: usize,
    forward: Vec<Forward>,
    names: HashMap<Vec<u8>, u32>,
}

/// Reads all statements.
pub(super) fn read(source: &Source<'_>, text: &[u8]) -> Result<File, LoadError> {
    let mut statements = Statements {
        source,
        file: File::default(),
        noted: Noted::default(),
        face_count: 0,
        forward: Vec::new(),
        names: HashMap::new(),
    };
    for (line, text) in Lines::new(text) {
        statements.line(line, &text)?;
    }
    statements.resolve_forward()?;
    statements.note();
    Ok(statements.file)
}

impl Statements<'_> {
    #[inline]
    fn line(&mut self, line: usize, text: &[u8]) -> Result<(), LoadError> {
        let mut words = Words::new(text);
        let Some(keyword) = words.next() else {
            return Ok(());
        };
        match keyword {
            b"v" => {
                let position = self.vector(line, &mut words, words::coordinate)?;
                self.file.vertices.push(position);
                // A weight, or a color.
                self.noted.vertex_colours += usize::from(words.nth(2).is_some());
            }
            b"vn" => {
                let normal = self.vector(line, &mut words, words::normal_part)?;
                let normal = unit_or_zero(normal.map(|x| x as f32));
                self.file.normals.push(normal);
            }
            b"f" | b"fo" => return self.face(line, words),
            b"vt" => self.noted.texture_coordinates += 1,
            // Vertices of curves alone.
            b"vp" => {}
            b"g" | b"o" => {
                let first = self.file.ends.len();
                self.file.parts.push((words::name(words.rest()), first));
            }
            b"usemtl" => self.material(words.rest()),
            b"mtllib" => self.file.libraries.read(words.rest(), self.source)?,
            b"s" => {
                let group = words.next().and_then(whole);
                self.noted
                    .smoothing_groups
                    .extend(group.filter(|group| *group != 0));
            }
            b"l" => self.noted.lines += 1,
            b"p" => self.noted.points += words.count(),
            b"curv" => self.noted.curves += 1,
            b"surf" | b"bzp" | b"bsp" | b"cdc" | b"cdp" => self.noted.surfaces += 1,
            // Parts of curves and surfaces, and options of other programs.
            b"cstype" | b"deg" | b"bmat" | b"step" | b"parm" | b"curv2" | b"trim" | b"hole"
            | b"scrv" | b"sp" | b"end" | b"con" | b"res" | b"mg" | b"bevel" | b"c_interp"
            | b"d_interp" | b"lod" | b"ctech" | b"stech" | b"shadow_obj" | b"trace_obj" => {}
            _ => self.noted.unknown += 1,
        }
        Ok(())
    }

    #[inline]
    fn vector(
        &self,
        line: usize,
        words: &mut Words<'_>,
        read: fn(&Source<'_>, usize, &[u8]) -> Result<f64, LoadError>,
    ) -> Result<[f64; 3], LoadError> {
        let mut vector = [0.0; 3];
        for (found, x) in vector.iter_mut().enumerate() {
            *x = match words.next() {
                Some(word) => read(self.source, line, word)?,
                // Faces with this vertex are dropped.
                None if self.source.options.lenient => f64::NAN,
                None => return Err(self.too_few(line, found)),
            };
        }
        Ok(vector)
    }

    #[cold]
    fn too_few(&self, line: usize, found: usize) -> LoadError {
        LoadError::TooFewNumbers {
            file: self.source.file.clone(),
            line,
            needed: 3,
            found: found as u64,
        }
    }

    fn counts(&self) -> Counts {
        Counts {
            vertices: self.file.vertices.len(),
            normals: self.file.normals.len(),
        }
    }

    #[inline]
    fn face(&mut self, line: usize, words: Words<'_>) -> Result<(), LoadError> {
        let place = Place {
            line,
            face: self.face_count,
        };
        self.face_count += 1;
        let begin = self.file.corners.len();
        let above = self.counts();
        let mut is_forward = false;
        for word in words {
            let error = match Corner::read(word, above) {
                Word::Corner(corner) => {
                    is_forward |= !corner.is_within(above);
                    self.file.corners.push(corner);
                    continue;
                }
                Word::Outside(outside) => {
                    // The number of items is known at the end, but this is none of them.
                    self.outside(outside, place, above)
                }
                Word::Unreadable => {
                    let expected = "a corner such as 3, 3/1, 3//2 or 3/1/2";
                    bad_word(self.source, line, word, expected)
                }
            };
            return self.drop_face(begin, error);
        }
        if self.file.corners.len() == begin {
            return self.drop_face(begin, self.too_few(line, 0));
        }
        // A file of 4 GB holds no more than 2^31 corners; a larger one is allowed by an option.
        let Ok(end) = u32::try_from(self.file.corners.len()) else {
            return Err(LoadError::Mesh {
                file: self.source.file.clone(),
                error: crate::MeshError::TooManyTriangles {
                    triangle_count: self.file.corners.len(),
                    limit: slimbvh_core::MAX_TRIANGLES as usize,
                },
            });
        };
        if is_forward {
            let face = self.file.ends.len();
            self.forward.push(Forward { face, place });
        }
        self.file.ends.push(end);
        Ok(())
    }

    /// Leaves the face whose corners begin here out, with lenient options.
    #[cold]
    fn drop_face(&mut self, begin: usize, error: LoadError) -> Result<(), LoadError> {
        if !self.source.options.lenient {
            return Err(error);
        }
        self.file.corners.truncate(begin);
        self.file.dropped_count += 1;
        Ok(())
    }

    fn outside(&self, outside: Outside, place: Place, counts: Counts) -> LoadError {
        use super::super::error::Indexed;
        let file = self.source.file.clone();
        if outside.index == 0 {
            return LoadError::IndexZero {
                file,
                line: place.line,
                face: place.face,
                list: outside.list,
            };
        }
        LoadError::IndexOutOfRange {
            file,
            line: Some(place.line),
            part: String::new(),
            face: place.face,
            list: outside.list,
            index: outside.index,
            count: match outside.list {
                Indexed::Vertices => counts.vertices,
                Indexed::Normals => counts.normals,
            },
        }
    }

    /// Looks up faces that refer to items below them. A broken one keeps no corners.
    fn resolve_forward(&mut self) -> Result<(), LoadError> {
        let counts = self.counts();
        let file = &mut self.file;
        let mut broken = Vec::new();
        for forward in &self.forward {
            let begin = match forward.face {
                0 => 0,
                face => file.ends[face - 1] as usize,
            };
            let corners = &file.corners[begin..file.ends[forward.face] as usize];
            if let Some(outside) = corners.iter().find_map(|corner| corner.outside(counts)) {
                broken.push((forward.face, outside, forward.place));
            }
        }
        if let Some(&(_, outside, place)) = broken.first()
            && !self.source.options.lenient
        {
            return Err(self.outside(outside, place, counts));
        }
        let file = &mut self.file;
        file.dropped_count += broken.len();
        // Faces are taken out from the last to the first, and what follows moves down once.
        remove_faces(file, broken.iter().map(|(face, ..)| *face));
        Ok(())
    }

    fn material(&mut self, name: &[u8]) {
        let index = match self.names.get(name) {
            Some(index) => *index,
            None => {
                let index = self.file.names.len() as u32;
                self.file.names.push(words::name(name));
                self.names.insert(name.to_vec(), index);
                index
            }
        };
        let first = self.file.ends.len();
        self.file.materials.push((index, first));
    }

    fn note(&self) {
        let noted = &self.noted;
        let groups = match self.file.normals.is_empty() {
            true => noted.smoothing_groups.len(),
            false => 0,
        };
        for (what, count) in [
            ("vertex colours", noted.vertex_colours),
            ("texture coordinates", noted.texture_coordinates),
            ("lines", noted.lines),
            (POINTS, noted.points),
            ("free-form curves", noted.curves),
            ("free-form surfaces", noted.surfaces),
            ("smoothing groups", groups),
            ("unknown statements", noted.unknown),
        ] {
            self.source.leave_out(what, count);
        }
    }
}

/// Takes faces, in order, out of the lists.
fn remove_faces(file: &mut File, removed: impl ExactSizeIterator<Item = usize>) {
    if removed.len() == 0 {
        return;
    }
    let removed: HashSet<usize> = removed.collect();
    let (mut corners, mut ends) = (Vec::new(), Vec::new());
    // For each face, how many before it stay.
    let mut kept = Vec::with_capacity(file.ends.len() + 1);
    let mut begin = 0;
    for (face, &end) in file.ends.iter().enumerate() {
        kept.push(ends.len());
        if !removed.contains(&face) {
            corners.extend(&file.corners[begin..end as usize]);
            ends.push(corners.len() as u32);
        }
        begin = end as usize;
    }
    kept.push(ends.len());
    for first in file.parts.iter_mut().map(|(_, first)| first) {
        *first = kept[*first];
    }
    for first in file.materials.iter_mut().map(|(_, first)| first) {
        *first = kept[*first];
    }
    (file.corners, file.ends) = (corners, ends);
}
