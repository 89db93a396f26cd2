//! Why a file cannot be read or written.

use super::layout::{SECTION_COUNT, Section, VERSION};
use crate::{MeshError, TreeError, ViewError};
use std::io;
use thiserror::Error;

/// Why a file is refused: one sentence about it, without its name.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum FileError {
    /// It is of another kind.
    #[error("it is not a slim file: it begins with \"{found}\"")]
    NotSlim {
        /// Its first characters.
        found: String,
    },
    /// It stops before its header is complete.
    #[error("it ends within its header: it has {found} bytes of {expected}")]
    HeaderCut {
        /// Bytes that are there.
        found: usize,
        /// Bytes of a header and its records of sections.
        expected: usize,
    },
    /// Its numbers have their highest byte first.
    #[error("it is big-endian; slim files are little-endian: build it again")]
    BigEndian,
    /// Neither byte order.
    #[error("its mark of the byte order is {mark:08x}; it is damaged: copy or build it again")]
    ByteOrder {
        /// What is there.
        mark: u32,
    },
    /// It is of another version.
    #[error(
        "it is of version {version}, and this slimbvh reads version {VERSION}: build it again, or take the slimbvh that wrote it"
    )]
    Version {
        /// Its version.
        version: u32,
    },
    /// It is not as long as it says.
    #[error("it {}: {announced} bytes are announced, {found} are there", if found < announced { "ends early" } else { "goes on behind its end" })]
    Length {
        /// Its length, as it says.
        announced: u64,
        /// Its length.
        found: u64,
    },
    /// Some byte was changed.
    #[error(
        "it is damaged: its checksum is {stored:08x}, and that of its bytes {computed:08x}; copy or build it again"
    )]
    Checksum {
        /// What is there.
        stored: u32,
        /// What should be there.
        computed: u32,
    },
    /// It has more sections, or fewer.
    #[error("it has {count} sections; there must be {SECTION_COUNT}")]
    SectionCount {
        /// How many are announced.
        count: u32,
    },
    /// A section is not the one that comes there.
    #[error("the section in place of the {section} is of kind {kind}")]
    Kind {
        /// Which should be there.
        section: Section,
        /// Which is there.
        kind: u32,
    },
    /// A section does not follow the one before it.
    #[error("the {section} begin at byte {begin}; they must at byte {expected}")]
    Place {
        /// Which.
        section: Section,
        /// Where it begins.
        begin: u64,
        /// Where it must.
        expected: u64,
    },
    /// A section reaches beyond the file, or the last one does not end with it.
    #[error("the {section} end at byte {end}, the file at byte {length}")]
    End {
        /// Which.
        section: Section,
        /// Where it ends.
        end: u64,
        /// The file's length.
        length: u64,
    },
    /// A section has items of another size than its kind.
    #[error("the {section} have {item_bytes} bytes each; they must have {expected}")]
    ItemBytes {
        /// Which.
        section: Section,
        /// Bytes of an item.
        item_bytes: u32,
        /// What they must be.
        expected: usize,
    },
    /// A section's last item is not complete.
    #[error("the {section} have {length} bytes, which are not whole items of {item_bytes}")]
    CutItem {
        /// Which.
        section: Section,
        /// Bytes of the section.
        length: u64,
        /// Bytes of an item.
        item_bytes: usize,
    },
    /// A section must have one item.
    #[error("the {section} has {count} records; it must have one")]
    Count {
        /// Which.
        section: Section,
        /// How many there are.
        count: usize,
    },
    /// A byte that is never used is.
    #[error("byte {at} is not 0, as all between the sections are")]
    NotZero {
        /// Where.
        at: u64,
    },
    /// A record has a kind that is not there, or says something where there is nothing to say.
    #[error("record {item} of the {section} is not one that slimbvh writes")]
    Record {
        /// Which section.
        section: Section,
        /// Which record, counted from 0.
        item: usize,
    },
    /// Names do not fill their section, or are no text.
    #[error("the name of part {part} is not UTF-8, or not as long as is announced")]
    Name {
        /// Which, counted from 0.
        part: usize,
    },
    /// What is in it does not belong together.
    #[error(transparent)]
    Content(#[from] ContentError),
}

/// What a scene or a hierarchy has that no file may.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum ContentError {
    /// The mesh is not sound.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The hierarchy is not sound, or not over this mesh.
    #[error(transparent)]
    Tree(#[from] TreeError),
    /// A normal is NaN or infinite.
    #[error("the normal of vertex {vertex} is not finite")]
    Normal {
        /// Which.
        vertex: usize,
    },
    /// A triangle has a material that is not there.
    #[error("triangle {triangle} has material {material}, but there are only {count}")]
    NoSuchMaterial {
        /// Which triangle.
        triangle: usize,
        /// Its material.
        material: u32,
        /// How many there are.
        count: usize,
    },
    /// A material has a number that is no share.
    #[error(
        "material {material} has a color, a mirror's share or a share that passes that is not from 0 to 1, or no index of refraction"
    )]
    Material {
        /// Which, counted from 0.
        material: usize,
    },
    /// A part's name is longer than a file can say.
    #[error("the name of part {part} has {length} bytes; at most 4294967295 can be saved")]
    LongName {
        /// Which, counted from 0.
        part: usize,
        /// Bytes of the name.
        length: usize,
    },
    /// A camera makes no picture.
    #[error("camera {}: {error}", camera + 1)]
    Camera {
        /// Which, counted from 0; the message counts from 1.
        camera: usize,
        /// What is wrong with it.
        #[source]
        error: ViewError,
    },
    /// A light gives no light.
    #[error(transparent)]
    Light(ViewError),
    /// What a camera is to see is no box.
    #[error("the box to be framed is not finite, or inverted")]
    Framing,
}

/// Why a file cannot be written.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum WriteError {
    /// What is to be in it is not sound.
    #[error(transparent)]
    Content(#[from] ContentError),
    /// The operating system refuses.
    #[error(transparent)]
    Io(#[from] io::Error),
}
