//! Header, sections, and numbers in bytes.

use bytemuck::{Pod, Zeroable};
use std::borrow::Cow;
use std::fmt;

/// What every file begins with.
pub const MAGIC: [u8; 8] = *b"\x89SLIM\r\n\x1a";

/// The byte order, as this machine reads it where it is right.
pub const ORDER: u32 = 0x0102_0304;

/// The version that is written, and the only one that is read.
pub const VERSION: u32 = 1;

/// Sections begin at multiples of this.
pub const ALIGNMENT: u64 = 256;

/// Where the checksum stands.
pub const CHECKSUM: std::ops::Range<usize> = 16..20;

/// How many sections there are.
pub const SECTION_COUNT: usize = Section::ALL.len();

/// Bytes of the header and of the records of sections behind it.
pub const TABLE_END: usize = size_of::<Header>() + SECTION_COUNT * size_of::<SectionRecord>();

/// What is in a section.
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
    /// What the triangles' materials point into.
    Materials,
    /// Cameras.
    Cameras,
    /// Lights.
    Lights,
    /// What else is to be said of the scene.
    Scene,
    /// All of the hierarchy but its lists.
    Hierarchy,
    /// Inner nodes.
    Nodes,
    /// Triangles in leaves.
    Triangles,
}

impl Section {
    /// In the order in which they stand.
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
    /// Bytes 16–19: of all other bytes.
    pub checksum: u32,
    /// Bytes 20–23: [`SECTION_COUNT`].
    pub section_count: u32,
    /// Bytes 24–31: the file's, lower half first.
    pub length: [u32; 2],
    /// Bytes 32–63: zeros.
    pub zeros: [u32; 8],
}

const _: () = assert!(size_of::<Header>() == 64);

/// Where a section lies. 32 bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct SectionRecord {
    /// Bytes 0–3: [`Section`], from 1.
    pub kind: u32,
    /// Bytes 4–7: of an item.
    pub item_bytes: u32,
    /// Bytes 8–15: where it begins, lower half first.
    pub begin: [u32; 2],
    /// Bytes 16–23: in bytes, lower half first.
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

/// A number of 64 bits as it is stored.
pub const fn halves(number: u64) -> [u32; 2] {
    [number as u32, (number >> 32) as u32]
}

/// A number of 64 bits from where it is stored.
pub fn whole([low, high]: [u32; 2]) -> u64 {
    u64::from(low) | u64::from(high) << 32
}

/// Items of whole words in the file's byte order; as they lie in memory, where that is the same.
pub fn to_bytes<T: Pod>(items: &[T]) -> Cow<'_, [u8]> {
    if cfg!(target_endian = "little") {
        Cow::Borrowed(bytemuck::cast_slice(items))
    } else {
        let words: &[u32] = bytemuck::cast_slice(items);
        Cow::Owned(words.iter().flat_map(|word| word.to_le_bytes()).collect())
    }
}

/// Items of whole words from the file's byte order. What does not fill one is left.
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

/// The checksum of a file that is shown in pieces, in order.
#[derive(Debug, Default)]
pub struct Checksum(crc32fast::Hasher);

impl Checksum {
    /// Takes what comes next.
    pub fn take(&mut self, bytes: &[u8]) {
        self.0.update(bytes);
    }

    /// What stands in the header.
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
