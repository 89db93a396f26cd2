//! Accessors: typed lists in the buffers of a glTF scene.

use super::GltfError;
use super::buffers::Buffers;
use gltf::Accessor;
use gltf::accessor::sparse::IndexType;
use gltf::accessor::{DataType, Dimensions};
use gltf::buffer::View;

/// A list of vectors; normalized integers become shares of 1.
pub(super) fn vectors(
    accessor: &Accessor<'_>,
    buffers: &Buffers<'_>,
) -> Result<Vec<[f32; 3]>, GltfError> {
    expect(
        accessor,
        Dimensions::Vec3,
        |_| true,
        "vectors of three numbers",
    )?;
    let (kind, is_share) = (accessor.data_type(), accessor.normalized());
    let size = kind.size();
    elements(accessor, buffers, |bytes| {
        [0, 1, 2].map(|axis| component(&bytes[axis * size..], kind, is_share))
    })
}

/// A list of vertex indices.
pub(super) fn indices(
    accessor: &Accessor<'_>,
    buffers: &Buffers<'_>,
) -> Result<Vec<u32>, GltfError> {
    let is_index = |kind| matches!(kind, DataType::U8 | DataType::U16 | DataType::U32);
    expect(accessor, Dimensions::Scalar, is_index, "unsigned numbers")?;
    elements(accessor, buffers, unsigned)
}

fn expect(
    accessor: &Accessor<'_>,
    dimensions: Dimensions,
    is_fit: impl Fn(DataType) -> bool,
    expected: &'static str,
) -> Result<(), GltfError> {
    if accessor.dimensions() == dimensions && is_fit(accessor.data_type()) {
        return Ok(());
    }
    Err(GltfError::WrongType {
        accessor: accessor.index(),
        found: format!("{:?} of {:?}", accessor.dimensions(), accessor.data_type()),
        expected,
    })
}

/// Reads every element, then the replacements of a sparse accessor. Elements without a buffer view are zero.
fn elements<T: Copy>(
    accessor: &Accessor<'_>,
    buffers: &Buffers<'_>,
    read: impl Fn(&[u8]) -> T,
) -> Result<Vec<T>, GltfError> {
    let (index, size, count) = (accessor.index(), accessor.size(), accessor.count());
    let mut list: Vec<T> = match accessor.view() {
        Some(view) => {
            let span = Span {
                accessor: index,
                offset: accessor.offset(),
                count,
                size,
            };
            span.of(&view, buffers)?.map(&read).collect()
        }
        None if count > buffers.total_bytes() => {
            return Err(GltfError::Hollow {
                accessor: index,
                count: count as u64,
            });
        }
        None => vec![read(&ZEROS[..size]); count],
    };

    let Some(sparse) = accessor.sparse() else {
        return Ok(list);
    };
    let (places, values) = (sparse.indices(), sparse.values());
    let place_size = match places.index_type() {
        IndexType::U8 => 1,
        IndexType::U16 => 2,
        IndexType::U32 => 4,
    };
    let place_span = Span {
        accessor: index,
        offset: places.offset(),
        count: sparse.count(),
        size: place_size,
    };
    let value_span = Span {
        accessor: index,
        offset: values.offset(),
        count: sparse.count(),
        size,
    };
    let (place_view, value_view) = (places.view(), values.view());
    let places = place_span.of(&place_view, buffers)?.map(unsigned);
    for (place, value) in places.zip(value_span.of(&value_view, buffers)?) {
        let element = list.get_mut(place as usize).ok_or(GltfError::SparseIndex {
            accessor: index,
            element: u64::from(place),
            count: count as u64,
        })?;
        *element = read(value);
    }
    Ok(list)
}

/// An element without a buffer view; the largest is a vector of three times four bytes.
const ZEROS: [u8; 12] = [0; 12];

/// The place of the elements in a view.
struct Span {
    accessor: usize,
    offset: usize,
    count: usize,
    /// Bytes of an element.
    size: usize,
}

impl Span {
    /// The bytes of each element.
    fn of<'b>(
        &self,
        view: &View<'_>,
        buffers: &'b Buffers<'_>,
    ) -> Result<impl Iterator<Item = &'b [u8]> + use<'b>, GltfError> {
        let bytes = buffers.view(view)?;
        let (size, count) = (self.size, self.count);
        let stride = view.stride().unwrap_or(size);
        if stride < size {
            return Err(GltfError::Overlap {
                accessor: self.accessor,
                size,
                stride,
            });
        }
        let end = match count {
            0 => 0,
            _ => stride
                .saturating_mul(count - 1)
                .saturating_add(size)
                .saturating_add(self.offset),
        };
        if end > bytes.len() {
            return Err(GltfError::AccessorBeyondView {
                accessor: self.accessor,
                end: end as u64,
                view: view.index(),
                length: bytes.len() as u64,
            });
        }
        let start = self.offset.min(end);
        Ok(bytes[start..end]
            .chunks(stride)
            .map(move |chunk| &chunk[..size]))
    }
}

/// An unsigned integer of 1, 2 or 4 bytes.
fn unsigned(bytes: &[u8]) -> u32 {
    match *bytes {
        [a, b, c, d, ..] => u32::from_le_bytes([a, b, c, d]),
        [a, b, ..] => u32::from(u16::from_le_bytes([a, b])),
        [a] => u32::from(a),
        [] => 0,
    }
}

/// The first number in the bytes.
fn component(bytes: &[u8], kind: DataType, is_share: bool) -> f32 {
    let two = [bytes[0], bytes.get(1).copied().unwrap_or_default()];
    let (value, largest) = match kind {
        DataType::I8 => (f32::from(bytes[0] as i8), 127.0),
        DataType::U8 => (f32::from(bytes[0]), 255.0),
        DataType::I16 => (f32::from(i16::from_le_bytes(two)), 32767.0),
        DataType::U16 => (f32::from(u16::from_le_bytes(two)), 65535.0),
        DataType::U32 => (unsigned(bytes) as f32, u32::MAX as f32),
        DataType::F32 => return f32::from_bits(unsigned(bytes)),
    };
    match is_share {
        true => (value / largest).max(-1.0),
        false => value,
    }
}
