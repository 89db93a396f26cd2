//! Accessors: typed lists in the buffers of a glTF scene.

use super::super::LoadError;
use super::GltfError;
use super::buffers::Buffers;
use super::json::{Accessor, Index, Root, Sparse};
use std::borrow::Cow;

/// The type of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Component {
    I8,
    U8,
    I16,
    U16,
    U32,
    F32,
    F64,
}

impl Component {
    fn of(code: Index) -> Option<Self> {
        Some(match code.0 {
            5120 => Self::I8,
            5121 => Self::U8,
            5122 => Self::I16,
            5123 => Self::U16,
            5125 => Self::U32,
            5126 => Self::F32,
            5130 => Self::F64,
            _ => return None,
        })
    }

    const fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    const fn name(self) -> &'static str {
        match self {
            Self::I8 => "BYTE",
            Self::U8 => "UNSIGNED_BYTE",
            Self::I16 => "SHORT",
            Self::U16 => "UNSIGNED_SHORT",
            Self::U32 => "UNSIGNED_INT",
            Self::F32 => "FLOAT",
            Self::F64 => "DOUBLE",
        }
    }

    pub const fn is_unsigned(self) -> bool {
        matches!(self, Self::U8 | Self::U16 | Self::U32)
    }

    pub const fn is_float(self) -> bool {
        matches!(self, Self::F32 | Self::F64)
    }

    /// The first number in the bytes.
    fn number(self, bytes: &[u8]) -> f64 {
        match *bytes {
            [a, ..] if self == Self::I8 => f64::from(a as i8),
            [a, ..] if self == Self::U8 => f64::from(a),
            [a, b, ..] if self == Self::I16 => f64::from(i16::from_le_bytes([a, b])),
            [a, b, ..] if self == Self::U16 => f64::from(u16::from_le_bytes([a, b])),
            [a, b, c, d, ..] if self == Self::U32 => f64::from(u32::from_le_bytes([a, b, c, d])),
            [a, b, c, d, ..] if self == Self::F32 => f64::from(f32::from_le_bytes([a, b, c, d])),
            [a, b, c, d, e, f, g, h, ..] => f64::from_le_bytes([a, b, c, d, e, f, g, h]),
            _ => 0.0,
        }
    }

    /// The number that stands for 1, if integers are shares.
    const fn one(self) -> f64 {
        match self {
            Self::I8 => i8::MAX as f64,
            Self::U8 => u8::MAX as f64,
            Self::I16 => i16::MAX as f64,
            Self::U16 => u16::MAX as f64,
            Self::U32 => u32::MAX as f64,
            Self::F32 | Self::F64 => 1.0,
        }
    }
}

/// The type that a use needs.
pub(super) struct Expected {
    /// As in the JSON: `VEC3`.
    pub shape: &'static str,
    /// Numbers of an element.
    pub width: usize,
    pub is_fit: fn(Component) -> bool,
    /// For the message, in the plural.
    pub name: &'static str,
}

pub(super) const VECTORS: Expected = Expected {
    shape: "VEC3",
    width: 3,
    is_fit: |_| true,
    name: "vectors of three numbers",
};

pub(super) const INDICES: Expected = Expected {
    shape: "SCALAR",
    width: 1,
    is_fit: Component::is_unsigned,
    name: "unsigned numbers",
};

/// The elements of an accessor.
pub(super) struct Elements<'b> {
    bytes: Cow<'b, [u8]>,
    /// Bytes from one element to the next.
    stride: usize,
    count: usize,
    kind: Component,
    /// Whether integers are shares of 1.
    is_share: bool,
}

impl<'b> Elements<'b> {
    pub const fn len(&self) -> usize {
        self.count
    }

    #[inline]
    fn element(&self, i: usize, size: usize) -> &[u8] {
        &self.bytes[i * self.stride..][..size]
    }

    /// An element of the expected width.
    #[inline]
    pub fn numbers<const N: usize>(&self, i: usize) -> [f64; N] {
        let (kind, size) = (self.kind, self.kind.size());
        let bytes = self.element(i, N * size);
        if kind == Component::F32 {
            let (words, _) = bytes.as_chunks::<4>();
            return std::array::from_fn(|axis| f64::from(f32::from_le_bytes(words[axis])));
        }
        let one = match self.is_share {
            true => kind.one(),
            false => 1.0,
        };
        let number = |axis: usize| kind.number(&bytes[axis * size..]) / one;
        std::array::from_fn(|axis| match self.is_share {
            true => number(axis).max(-1.0),
            false => number(axis),
        })
    }

    /// An element of unsigned numbers.
    pub fn unsigned<const N: usize>(&self, i: usize) -> [u32; N] {
        let size = self.kind.size();
        let bytes = self.element(i, N * size);
        std::array::from_fn(|axis| unsigned(&bytes[axis * size..][..size]))
    }

    /// All elements, each an unsigned number; where they stand in the file, if they stand there as in memory.
    pub fn into_unsigned(self) -> Cow<'b, [u32]> {
        let size = self.kind.size();
        if let Cow::Borrowed(bytes) = self.bytes
            && (self.kind, self.stride) == (Component::U32, size)
            && cfg!(target_endian = "little")
            && let Ok(words) = bytemuck::try_cast_slice(&bytes[..size * self.count])
        {
            return Cow::Borrowed(words);
        }
        let elements = self.bytes.chunks(self.stride).take(self.count);
        elements.map(|element| unsigned(&element[..size])).collect()
    }

    /// All elements in order, if they are vectors of `f32`: [`Self::numbers`], faster.
    pub fn floats(&self) -> Option<impl Iterator<Item = [f32; 3]>> {
        let size = 3 * self.kind.size();
        let elements = self.bytes.chunks(self.stride).take(self.count);
        (self.kind == Component::F32).then(|| {
            elements.map(move |element| {
                let (words, _) = element[..size].as_chunks::<4>();
                [0, 1, 2].map(|axis| f32::from_le_bytes(words[axis]))
            })
        })
    }
}

/// The elements of the accessor with this index, which stands at a place in the JSON. Those without a buffer view are zero; then the
/// replacements of a sparse accessor follow.
pub(super) fn elements<'b>(
    root: &Root,
    index: Index,
    place: impl FnOnce() -> String,
    expected: &Expected,
    buffers: &'b Buffers<'_>,
) -> Result<Elements<'b>, LoadError> {
    let fault = |error| buffers.fault(error);
    let accessor = root
        .accessors
        .item("accessors", index, place)
        .map_err(fault)?;
    let index = index.0;
    let kind = component(accessor.component_type, || {
        format!("accessors[{index}].componentType")
    });
    let kind = kind.map_err(fault)?;
    if accessor.shape != expected.shape || !(expected.is_fit)(kind) {
        return Err(fault(GltfError::WrongType {
            accessor: index,
            found: format!(
                "{} of {}",
                crate::text::excerpt(&accessor.shape),
                kind.name()
            ),
            expected: expected.name,
        }));
    }
    let size = expected.width * kind.size();
    let count = accessor.count.0;
    let mut elements = Elements {
        bytes: Cow::Borrowed(&[]),
        stride: size,
        count,
        kind,
        is_share: accessor.normalized && !kind.is_float(),
    };
    if let Some(view) = accessor.buffer_view {
        let place = || format!("accessors[{index}].bufferView");
        let span = Span {
            accessor: index,
            view,
            offset: accessor.byte_offset.0,
            count,
            size,
        };
        let (bytes, stride) = span.of(place, buffers)?;
        (elements.bytes, elements.stride) = (bytes.into(), stride);
    } else if count > buffers.most_zeros() {
        return Err(fault(GltfError::Hollow {
            accessor: index,
            count: count as u64,
        }));
    } else {
        elements.bytes = vec![0; count * size].into();
    }
    if let Some(sparse) = &accessor.sparse {
        replace(&mut elements, sparse, accessor, index, size, buffers)?;
    }
    Ok(elements)
}

/// Puts the replacements of a sparse accessor in place.
fn replace<'b>(
    elements: &mut Elements<'b>,
    sparse: &Sparse,
    accessor: &Accessor,
    index: usize,
    size: usize,
    buffers: &'b Buffers<'_>,
) -> Result<(), LoadError> {
    let (indices, values) = (&sparse.indices, &sparse.values);
    let place = || format!("accessors[{index}].sparse.indices.componentType");
    let kind = component(indices.component_type, place).and_then(|kind| match kind.is_unsigned() {
        true => Ok(kind),
        false => Err(GltfError::WrongType {
            accessor: index,
            found: format!("sparse indices of {}", kind.name()),
            expected: INDICES.name,
        }),
    });
    let kind = kind.map_err(|error| buffers.fault(error))?;
    let span = |view, offset: Index, size| Span {
        accessor: index,
        view,
        offset: offset.0,
        count: sparse.count.0,
        size,
    };
    let (places, place_stride) = span(indices.buffer_view, indices.byte_offset, kind.size()).of(
        || format!("accessors[{index}].sparse.indices.bufferView"),
        buffers,
    )?;
    let (values, value_stride) = span(values.buffer_view, values.byte_offset, size).of(
        || format!("accessors[{index}].sparse.values.bufferView"),
        buffers,
    )?;
    if sparse.count.0 == 0 {
        return Ok(());
    }
    let (stride, bytes) = (elements.stride, elements.bytes.to_mut());
    for (place, value) in places.chunks(place_stride).zip(values.chunks(value_stride)) {
        let place = unsigned(&place[..kind.size()]);
        if place as usize >= accessor.count.0 {
            return Err(buffers.fault(GltfError::SparseIndex {
                accessor: index,
                element: u64::from(place),
                count: accessor.count.0 as u64,
            }));
        }
        bytes[place as usize * stride..][..size].copy_from_slice(&value[..size]);
    }
    Ok(())
}

fn component(code: Index, place: impl FnOnce() -> String) -> Result<Component, GltfError> {
    Component::of(code).ok_or_else(|| GltfError::UnknownValue {
        place: place(),
        value: code.0,
        expected: "a component type",
    })
}

/// The place of elements in a view.
struct Span {
    accessor: usize,
    view: Index,
    offset: usize,
    count: usize,
    /// Bytes of an element.
    size: usize,
}

impl Span {
    /// The bytes from the first element to the end of the last, and those from one to the next.
    fn of<'b>(
        &self,
        place: impl FnOnce() -> String,
        buffers: &'b Buffers<'_>,
    ) -> Result<(&'b [u8], usize), LoadError> {
        let (view, bytes) = buffers.view(self.view, place)?;
        let (size, count) = (self.size, self.count);
        // Some writers state a stride of 0 for none.
        let stride = view.byte_stride.filter(|stride| stride.0 > 0);
        let stride = stride.map_or(size, |stride| stride.0);
        if stride < size {
            return Err(buffers.fault(GltfError::Overlap {
                accessor: self.accessor,
                size,
                stride,
            }));
        }
        let end = match count {
            0 => 0,
            _ => stride
                .saturating_mul(count - 1)
                .saturating_add(size)
                .saturating_add(self.offset),
        };
        if end > bytes.len() {
            return Err(buffers.fault(GltfError::AccessorBeyondView {
                accessor: self.accessor,
                end: end as u64,
                view: self.view.0,
                length: bytes.len() as u64,
            }));
        }
        Ok((&bytes[self.offset.min(end)..end], stride))
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_every_type() {
        let bytes = [0x81, 0xff, 0, 0x80, 0, 0, 0, 0];
        assert_eq!(Component::I8.number(&bytes), -127.0);
        assert_eq!(Component::U8.number(&bytes), 129.0);
        assert_eq!(Component::I16.number(&bytes), -127.0);
        assert_eq!(Component::U16.number(&bytes), 65409.0);
        assert_eq!(Component::U32.number(&bytes), 2_147_549_057.0);
        assert_eq!(Component::F32.number(&1.5_f32.to_le_bytes()), 1.5);
        assert_eq!(Component::F64.number(&0.1_f64.to_le_bytes()), 0.1);
        let codes =
            [5120, 5121, 5122, 5123, 5125, 5126, 5130].map(|code| Component::of(Index(code)));
        assert!(codes.iter().all(Option::is_some));
        assert_eq!(Component::of(Index(5124)), None);
    }

    #[test]
    fn shares_end_at_minus_one() {
        let elements = Elements {
            bytes: Cow::Borrowed(&[0x80, 0x81, 0x7f]),
            stride: 3,
            count: 1,
            kind: Component::I8,
            is_share: true,
        };
        assert_eq!(elements.numbers(0), [-1.0, -1.0, 1.0]);
    }
}
