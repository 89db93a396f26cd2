//! Header, sections, and the byte form of numbers.

use bytemuck::{Pod, Zeroable};
use std::borrow::Cow;
use std::fmt;

/// The first bytes of every file.
pub const MAGIC: [u8; 8] = *b"\x89SLIM\r\n\x1a";

/// The mark of the byte order, as a machine of the right order reads it.
pub const ORDER: u32 = 0x0102_0304;

/// The version that is written, and the only one that can be read.
pub const VERSION: u32 = 2;

/// Sections begin at multiples of this.
pub const ALIGNMENT: u64 = 256;

/// The bytes of the checksum.
pub const CHECKSUM: std::ops::Range<usize> = 16..20;

/// The number of sections.
pub const SECTION_COUNT: usize = Section::ALL.len();

/// Bytes of the header and of the section records after it.
pub const TABLE_END: usize = size_of::<Header>() + SECTION_COUNT * size_of::<SectionRecord>();

/// The content of a section.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum Section {
    /// Positions.
    Vertices = 1,
    /// Three vertices of each triangle.
    Indices,
    /// One for each vertex, or none.
    Normals,
    /// One for each triangle, or none.
    MaterialIndices,
    /// Runs of triangles.
    Parts,
    /// The parts' names.
    Names,
    /// The materials that triangles refer to.
    Materials,
    /// Cameras.
    Cameras,
    /// Lights.
    Lights,
    /// Other facts of the scene.
    Scene,
    /// The hierarchy, without its lists.
    Hierarchy,
    /// Inner nodes.
    Nodes,
    /// Triangles in leaves.
    Triangles,
}

impl Section {
    /// In the order of the file.
    pub const ALL: [Self; 13] = [
        Self::Vertices,
        Self::Indices,
        Self::Normals,
        Self::MaterialIndices,
        Self::Parts,
        Self::Names,
        Self::Materials,
        Self::Cameras,
        Self::Lights,
        Self::Scene,
        Self::Hierarchy,
        Self::Nodes,
        Self::Triangles,
    ];
}

impl fmt::Display for Section {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Vertices => "vertices",
            Self::Indices => "indices",
            Self::Normals => "normals",
            Self::MaterialIndices => "triangles' materials",
            Self::Parts => "parts",
            Self::Names => "names",
            Self::Materials => "materials",
            Self::Cameras => "cameras",
            Self::Lights => "lights",
            Self::Scene => "scene",
            Self::Hierarchy => "hierarchy",
            Self::Nodes => "nodes",
            Self::Triangles => "triangles",
        })
    }
}

/// The first 64 bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct Header {
    /// Bytes 0–7: [`MAGIC`].
    pub magic: [u32; 2],
    /// Bytes 8–11: [`ORDER`].
    pub order: u32,
    /// Bytes 12–15: [`VERSION`].
    pub version: u32,
    /// Bytes 16–19: the checksum of all other bytes.
    pub checksum: u32,
    /// Bytes 20–23: [`SECTION_COUNT`].
    pub section_count: u32,
    /// Bytes 24–31: the file's length, lower half first.
    pub length: [u32; 2],
    /// Bytes 32–63: zeros.
    pub zeros: [u32; 8],
}

const _: () = assert!(size_of::<Header>() == 64);

/// The position of a section. 32 bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct SectionRecord {
    /// Bytes 0–3: [`Section`], from 1.
    pub kind: u32,
    /// Bytes 4–7: bytes of an item.
    pub item_bytes: u32,
    /// Bytes 8–15: the begin, lower half first.
    pub begin: [u32; 2],
    /// Bytes 16–23: the length in bytes, lower half first.
    pub length: [u32; 2],
    /// Bytes 24–31: zeros.
    pub zeros: [u32; 2],
}

const _: () = assert!(size_of::<SectionRecord>() == 32);

/// [`MAGIC`] in words.
pub fn magic() -> [u32; 2] {
    let [a, b, c, d, e, f, g, h] = MAGIC;
    [
        u32::from_le_bytes([a, b, c, d]),
        u32::from_le_bytes([e, f, g, h]),
    ]
}

/// A 64-bit number as it is stored.
pub const fn halves(number: u64) -> [u32; 2] {
    [number as u32, (number >> 32) as u32]
}

/// A stored 64-bit number.
pub fn whole([low, high]: [u32; 2]) -> u64 {
    u64::from(low) | u64::from(high) << 32
}

/// Items of whole words in the file's byte order; borrowed if memory has the same order.
pub fn to_bytes<T: Pod>(items: &[T]) -> Cow<'_, [u8]> {
    if cfg!(target_endian = "little") {
        Cow::Borrowed(bytemuck::cast_slice(items))
    } else {
        let words: &[u32] = bytemuck::cast_slice(items);
        Cow::Owned(words.iter().flat_map(|word| word.to_le_bytes()).collect())
    }
}

/// Items of whole words from the file's byte order. An incomplete last item is dropped.
pub fn from_bytes<T: Pod>(bytes: &[u8]) -> Vec<T> {
    let item = |bytes: &[u8]| {
        let mut item: T = bytemuck::pod_read_unaligned(bytes);
        for word in bytemuck::cast_slice_mut::<T, u32>(std::slice::from_mut(&mut item)) {
            *word = u32::from_le(*word);
        }
        item
    };
    bytes.chunks_exact(size_of::<T>()).map(item).collect()
}

/// The checksum of a file that is passed in pieces, in order.
#[derive(Debug, Default)]
pub struct Checksum(crc32fast::Hasher);

impl Checksum {
    /// Adds the next piece.
    pub fn take(&mut self, bytes: &[u8]) {
        self.0.update(bytes);
    }

    /// The checksum for the header.
    pub fn finish(self) -> u32 {
        self.0.finalize()
    }
}

/// The checksum of a whole file.
pub fn checksum(bytes: &[u8]) -> u32 {
    let mut checksum = Checksum::default();
    checksum.take(&bytes[..CHECKSUM.start]);
    checksum.take(&bytes[CHECKSUM.end..]);
    checksum.finish()
}
