//! Why a scene cannot be loaded.

use super::LeftOut;
use super::gltf::GltfError;
use super::left_out::POINTS;
use super::slim::FileError;
use crate::MeshError;
pub(super) use crate::text::excerpt;
use crate::text::{are, grouped, noun, number, only, things};
use std::io;
use thiserror::Error;

/// Why a scene cannot be loaded: one sentence that names the file, the place and the numbers. It includes the cause's
/// sentence; [`source`](std::error::Error::source) returns the cause itself.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum LoadError {
    /// The operating system refuses the file.
    #[error("cannot read \"{file}\": {error}")]
    Read {
        /// The path as given.
        file: String,
        /// The operating system's error.
        #[source]
        error: io::Error,
    },
    /// The path names a directory, a device or a pipe.
    #[error("\"{file}\" is a folder or a device; name a file")]
    NotAFile {
        /// The path as given.
        file: String,
    },
    /// The file is larger than [`LoadOptions::max_file_bytes`](super::LoadOptions::max_file_bytes).
    #[error("\"{file}\" has {}; at most {} are read", Size(*size_bytes), Size(*limit_bytes))]
    TooLarge {
        /// The path as given.
        file: String,
        /// The file's size.
        size_bytes: u64,
        /// The largest size that is read.
        limit_bytes: u64,
    },
    /// The extension belongs to no known format.
    #[error(
        "\"{file}\" has the extension \"{extension}\"; slimbvh reads gltf, glb, obj, ply, stl, off and slim"
    )]
    UnknownExtension {
        /// The path as given.
        file: String,
        /// The text after its last dot.
        extension: String,
    },
    /// The path has no extension, so the format is unknown.
    #[error("\"{file}\" has no extension; slimbvh reads gltf, glb, obj, ply, stl, off and slim")]
    NoExtension {
        /// The path as given.
        file: String,
    },
    /// The file has no bytes.
    #[error("\"{file}\" is empty")]
    Empty {
        /// The path as given.
        file: String,
    },
    /// The file begins as one of another format does.
    #[error("\"{file}\" is not {format}: it looks like {like}")]
    OtherFormat {
        /// The path as given.
        file: String,
        /// The format by the extension or the options.
        format: &'static str,
        /// The format by the content.
        like: &'static str,
    },
    /// The file is neither text of STL nor binary.
    #[error("\"{file}\" is not STL: it is text that does not begin with \"solid\" or \"facet\"")]
    NotStl {
        /// The path as given.
        file: String,
    },
    /// A binary STL file is shorter than its count of triangles needs.
    #[error("\"{file}\" ends early, or is not STL: {announced} {} {} announced, {found} {} there", noun((*announced).into(), "triangles"), are((*announced).into()), are(*found))]
    StlShort {
        /// The path as given.
        file: String,
        /// The count in the header.
        announced: u32,
        /// The number of complete triangles.
        found: u64,
    },
    /// The file ends before everything that its header states.
    #[error("\"{file}\" ends early: {announced} {} {} announced, {found} {} there", noun(*announced, what), are(*announced), are(*found))]
    EndsEarly {
        /// The path as given.
        file: String,
        /// The counted items, in the plural.
        what: String,
        /// The count in the header.
        announced: u64,
        /// The number of complete items.
        found: u64,
    },
    /// The file stops before its header is complete.
    #[error("\"{file}\" ends within its header")]
    HeaderCut {
        /// The path as given.
        file: String,
    },
    /// A header line does not follow the format.
    #[error("\"{file}\", line {line}: the header line \"{text}\" is not understood")]
    HeaderLine {
        /// The path as given.
        file: String,
        /// The line, counted from 1.
        line: usize,
        /// The line's first characters.
        text: String,
    },
    /// A required item is missing.
    #[error("\"{file}\" has no {what}")]
    Missing {
        /// The path as given.
        file: String,
        /// The missing item.
        what: String,
    },
    /// An OFF file of an unsupported kind.
    #[error(
        "\"{file}\" begins with \"{header}\"; slimbvh reads OFF text with the prefixes C, N and ST"
    )]
    OffKind {
        /// The path as given.
        file: String,
        /// Its first word.
        header: String,
    },
    /// A word in place of a number, or of a keyword.
    #[error("\"{file}\", line {line}: \"{text}\" is not {expected}")]
    BadNumber {
        /// The path as given.
        file: String,
        /// The line, counted from 1.
        line: usize,
        /// The word's first characters.
        text: String,
        /// What is expected, such as `a number`, `a count` or `an index`.
        expected: &'static str,
    },
    /// A binary file has an impossible list length or index.
    #[error("\"{file}\": {what} {item} holds {}, which is not {expected}", number(*value))]
    BadValue {
        /// The path as given.
        file: String,
        /// The kind of item.
        what: String,
        /// The item, counted from 0.
        item: u64,
        /// The number that is there.
        value: f64,
        /// `a count` or `an index`.
        expected: &'static str,
    },
    /// A line ends before all its numbers.
    #[error("\"{file}\", line {line}: {needed} {} {} needed, {found} {} there", noun(*needed, "numbers"), are(*needed), are(*found))]
    TooFewNumbers {
        /// The path as given.
        file: String,
        /// The line, counted from 1.
        line: usize,
        /// The number of numbers required.
        needed: u64,
        /// The number of numbers found.
        found: u64,
    },
    /// A face refers to a vertex or a normal that does not exist.
    #[error("\"{file}\"{}: {part}face {face} names {} {index}, but {}", at(*line), list.one(), only(*count, list.many()))]
    IndexOutOfRange {
        /// The path as given.
        file: String,
        /// The line, counted from 1, where the format has lines.
        line: Option<usize>,
        /// `mesh "name", `, or empty.
        part: String,
        /// The face, counted from 0 in the file or the part.
        face: usize,
        /// The list that the face refers to.
        list: Indexed,
        /// The index as the file writes it.
        index: i64,
        /// The length of the list.
        count: usize,
    },
    /// A face of an OBJ file refers to item 0, but indices count from 1.
    #[error("\"{file}\", line {line}: face {face} names {} 0, but {} count from 1", list.one(), list.many())]
    IndexZero {
        /// The path as given.
        file: String,
        /// The line, counted from 1.
        line: usize,
        /// The face, counted from 0 in the file.
        face: usize,
        /// The list that the face refers to.
        list: Indexed,
    },
    /// An STL text ends before `endsolid`.
    #[error("\"{file}\" ends early: face {face} is not complete, or \"endsolid\" is missing")]
    StlCut {
        /// The path as given.
        file: String,
        /// The face, counted from 0.
        face: usize,
    },
    /// The glTF scene contradicts itself or its buffers.
    #[error("\"{file}\": {error}")]
    Gltf {
        /// The path as given.
        file: String,
        /// The fault.
        #[source]
        error: GltfError,
    },
    /// A saved hierarchy is damaged, of another format, or invalid.
    #[error("\"{file}\": {error}")]
    Saved {
        /// The path as given.
        file: String,
        /// The fault.
        #[source]
        error: FileError,
    },
    /// The mesh is invalid.
    #[error("\"{file}\": {error}")]
    Mesh {
        /// The path as given.
        file: String,
        /// The fault.
        #[source]
        error: MeshError,
    },
    /// The memory does not suffice for the triangles.
    #[error("\"{file}\" holds {} triangles or more, for which the memory does not suffice", grouped(*triangle_count))]
    NoMemory {
        /// The path as given.
        file: String,
        /// The number of triangles so far.
        triangle_count: usize,
    },
    /// The file holds no triangles.
    #[error("\"{file}\" holds no triangles{}", instead(*dropped_face_count, *point_count, left_out))]
    NoTriangles {
        /// The path as given.
        file: String,
        /// The number of broken faces that were dropped.
        dropped_face_count: usize,
        /// The number of points.
        point_count: usize,
        /// What else the file holds.
        left_out: Vec<LeftOut>,
    },
    /// A reader panicked on the file.
    #[error("the {format} reader failed on \"{file}\": {message}; please report it with the file")]
    Panicked {
        /// The path as given.
        file: String,
        /// The format's name.
        format: &'static str,
        /// The panic's message.
        message: String,
    },
}

/// The lists that a face's corner can refer to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Indexed {
    /// Positions.
    Vertices,
    /// Shading normals.
    Normals,
}

impl Indexed {
    fn one(self) -> &'static str {
        match self {
            Self::Vertices => "vertex",
            Self::Normals => "normal",
        }
    }

    fn many(self) -> &'static str {
        match self {
            Self::Vertices => "vertices",
            Self::Normals => "normals",
        }
    }
}

/// `, line 12`, or empty if the line is unknown.
fn at(line: Option<usize>) -> String {
    line.map_or_else(String::new, |line| format!(", line {line}"))
}

/// What a file without triangles holds.
fn instead(dropped_face_count: usize, point_count: usize, left_out: &[LeftOut]) -> String {
    let mut all: Vec<String> = left_out.iter().map(ToString::to_string).collect();
    match (dropped_face_count, point_count) {
        (0, 0) => {}
        // Points that the file draws are told already.
        (0, _) if left_out.iter().any(|left_out| left_out.what == POINTS) => {}
        (0, count) => all.insert(0, things(count, "point")),
        (1, _) => return "; 1 broken face was left out".into(),
        (count, _) => return format!("; {} broken faces were left out", grouped(count)),
    }
    match &all[..] {
        [] => String::new(),
        all => format!(", only {}", all.join(", ")),
    }
}

/// A size in bytes, printed in the largest unit below it.
struct Size(u64);

impl std::fmt::Display for Size {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        const UNITS: [(&str, u32); 3] = [("GiB", 30), ("MiB", 20), ("KiB", 10)];
        match UNITS.iter().find(|(_, shift)| self.0 >> shift > 0) {
            Some((unit, shift)) => {
                write!(f, "{:.1} {unit}", self.0 as f64 / (1_u64 << shift) as f64)
            }
            None => write!(f, "{} bytes", self.0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_read_well() {
        assert_eq!(Size(5_476_083_302).to_string(), "5.1 GiB");
        assert_eq!(Size(4 << 30).to_string(), "4.0 GiB");
        assert_eq!(Size(1536).to_string(), "1.5 KiB");
        assert_eq!(Size(1023).to_string(), "1023 bytes");
    }

    #[test]
    fn a_fault_of_a_reader_asks_for_a_report() {
        let error = LoadError::Panicked {
            file: "x.ply".into(),
            format: "PLY",
            message: "index out of bounds".into(),
        };
        assert_eq!(
            error.to_string(),
            "the PLY reader failed on \"x.ply\": index out of bounds; please report it with the file"
        );
    }
}
