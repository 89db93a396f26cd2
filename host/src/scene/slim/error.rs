//! Why a file cannot be read or written.

use super::layout::{SECTION_COUNT, Section, VERSION};
use crate::tree::ON_LATTICE;
use crate::{MeshError, TreeError, ViewError};
use std::io;
use thiserror::Error;

/// Why a file is rejected: one sentence about the file, without its name.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum FileError {
    /// The file has another format.
    #[error("it is not a slim file: it begins with \"{found}\"")]
    NotSlim {
        /// Its first characters.
        found: String,
    },
    /// The file ends before its header is complete.
    #[error("it ends within its header: it has {found} bytes of {expected}")]
    HeaderCut {
        /// Bytes found.
        found: usize,
        /// Bytes of a header and its records of sections.
        expected: usize,
    },
    /// The file is big-endian.
    #[error("it is big-endian; slim files are little-endian: build it again")]
    BigEndian,
    /// The mark is of neither byte order.
    #[error("its mark of the byte order is {mark:08x}; it is damaged: copy or build it again")]
    ByteOrder {
        /// The mark.
        mark: u32,
    },
    /// The file has another version.
    #[error(
        "it is of version {version}, and this slimbvh reads version {VERSION}: build it again, or use the slimbvh that wrote it"
    )]
    Version {
        /// Its version.
        version: u32,
    },
    /// The file's length differs from the one in its header.
    #[error("it {}: {announced} bytes are announced, {found} are there", if found < announced { "ends early" } else { "continues past its end" })]
    Length {
        /// The length in the header.
        announced: u64,
        /// The actual length.
        found: u64,
    },
    /// Bytes of the file have changed.
    #[error(
        "it is damaged: its checksum is {stored:08x}, and that of its bytes {computed:08x}; copy or build it again"
    )]
    Checksum {
        /// The checksum in the header.
        stored: u32,
        /// The checksum of the bytes.
        computed: u32,
    },
    /// The number of sections is wrong.
    #[error("it has {count} sections; there must be {SECTION_COUNT}")]
    SectionCount {
        /// The number in the header.
        count: u32,
    },
    /// A section has the wrong kind for its position.
    #[error("the section in place of the {section} is of kind {kind}")]
    Kind {
        /// The expected section.
        section: Section,
        /// The kind found.
        kind: u32,
    },
    /// A section does not directly follow the one before it.
    #[error("the {section} begin at byte {begin}; they must at byte {expected}")]
    Place {
        /// The section.
        section: Section,
        /// Its position.
        begin: u64,
        /// The expected position.
        expected: u64,
    },
    /// A section ends beyond the file, or the last one before it.
    #[error("the {section} end at byte {end}, the file at byte {length}")]
    End {
        /// The section.
        section: Section,
        /// Its end.
        end: u64,
        /// The file's length.
        length: u64,
    },
    /// A section's item size is not that of its kind.
    #[error("the {section} have {item_bytes} bytes each; they must have {expected}")]
    ItemBytes {
        /// The section.
        section: Section,
        /// Bytes of an item.
        item_bytes: u32,
        /// The size of its kind.
        expected: usize,
    },
    /// A section's last item is incomplete.
    #[error("the {section} have {length} bytes, which are not whole items of {item_bytes}")]
    CutItem {
        /// The section.
        section: Section,
        /// Bytes of the section.
        length: u64,
        /// Bytes of an item.
        item_bytes: usize,
    },
    /// A section does not have exactly one item.
    #[error("the {section} has {count} records; it must have one")]
    Count {
        /// The section.
        section: Section,
        /// The number of items.
        count: usize,
    },
    /// A byte between sections is not zero.
    #[error("byte {at} is not 0, but all bytes between the sections must be")]
    NotZero {
        /// Its position.
        at: u64,
    },
    /// A record has an unknown kind, or a value in an unused field.
    #[error("record {item} of the {section} is invalid")]
    Record {
        /// The section.
        section: Section,
        /// The record, counted from 0.
        item: usize,
    },
    /// The hierarchy's nodes are in a codec that is there with the feature `lab` only.
    #[error(
        "its nodes are in the codec q{bits}, which only the laboratory reads: build it again with other nodes, for example {ON_LATTICE}, or build slimbvh with the feature `lab`"
    )]
    LabCodec {
        /// Bits of a plane.
        bits: u32,
    },
    /// The file holds a hierarchy alone, and the call wants its scene, too.
    #[error(
        "it holds a hierarchy without its scene: read it with `slim::read_hierarchy`, or save both by `slimbvh build` or `slim::write`"
    )]
    NoScene,
    /// The file holds a scene, and the call wants a hierarchy alone.
    #[error("it holds a hierarchy with its scene: read both with `slim::read`")]
    HasScene,
    /// Names do not fill their section, or are not UTF-8.
    #[error("the name of part {part} is not UTF-8, or its length is wrong")]
    Name {
        /// The part, counted from 0.
        part: usize,
    },
    /// The content is invalid or inconsistent.
    #[error(transparent)]
    Content(#[from] ContentError),
}

/// Content that cannot be saved.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum ContentError {
    /// The mesh is invalid.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The hierarchy is invalid, or not over this mesh.
    #[error(transparent)]
    Tree(#[from] TreeError),
    /// A normal is NaN or infinite.
    #[error("the normal of vertex {vertex} is not finite")]
    Normal {
        /// The vertex.
        vertex: usize,
    },
    /// A triangle's material does not exist.
    #[error("triangle {triangle} has material {material}, but there are only {count}")]
    NoSuchMaterial {
        /// The triangle.
        triangle: usize,
        /// Its material.
        material: u32,
        /// The number of materials.
        count: usize,
    },
    /// A material has a number out of range.
    #[error(
        "material {material} has a color, mirror share or transmission outside of 0 to 1, or an invalid index of refraction"
    )]
    Material {
        /// The material, counted from 0.
        material: usize,
    },
    /// A part's name is longer than a file can store.
    #[error("the name of part {part} has {length} bytes; at most 4294967295 can be saved")]
    LongName {
        /// The part, counted from 0.
        part: usize,
        /// Bytes of the name.
        length: usize,
    },
    /// A camera cannot be rendered.
    #[error("camera {}: {error}", camera + 1)]
    Camera {
        /// The camera, counted from 0; the message counts from 1.
        camera: usize,
        /// Its fault.
        #[source]
        error: ViewError,
    },
    /// A light is invalid.
    #[error(transparent)]
    Light(ViewError),
    /// The box for the default camera is invalid.
    #[error("the box to be framed is not finite, or inverted")]
    Framing,
}

/// Why a file cannot be written.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum WriteError {
    /// The content is invalid.
    #[error(transparent)]
    Content(#[from] ContentError),
    /// The operating system's error.
    #[error(transparent)]
    Io(#[from] io::Error),
}
