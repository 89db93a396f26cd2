//! The header of a PLY file. After <https://paulbourke.net/dataformats/ply/>.

use super::super::LoadError;
use super::super::error::excerpt;
use super::super::load::Source;
use super::super::words::{self, Lines, Words};
use super::missing;
use super::rows::{Rows, RowsIn};

/// The elements of a file, in their order.
pub(super) struct Header<'a> {
    pub encoding: Encoding,
    pub elements: Vec<Element>,
    /// Files that comments name as textures.
    pub texture_count: usize,
    /// The bytes behind the header, and the number of their first line.
    rest: &'a [u8],
    first_line: usize,
}

/// How rows are stored.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Encoding {
    Text,
    LittleEndian,
    BigEndian,
}

/// A list of rows with the same properties.
pub(super) struct Element {
    pub name: String,
    pub count: usize,
    pub properties: Vec<Property>,
}

/// A number in a row, or a list of them. Two properties may have one name: the first has the value.
pub(super) struct Property {
    pub name: String,
    pub kind: Kind,
}

#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Scalar(Scalar),
    List { count: Scalar, item: Scalar },
}

#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    I64,
    U64,
    F32,
    F64,
}

impl<'a> Header<'a> {
    /// Reads the lines up to `end_header`.
    pub fn read(bytes: &'a [u8], source: &Source<'_>) -> Result<Self, LoadError> {
        let cut = || LoadError::HeaderCut {
            file: source.file.clone(),
        };
        let ends_with_cr = has_cr_alone(bytes);
        let mut lines = Lines::new(bytes);
        let mut encoding = None;
        let (mut elements, mut texture_count) = (Vec::new(), 0);
        loop {
            let begin = lines.rest();
            let (line, text) = lines.next().ok_or_else(cut)?;
            let read = match text.trim_ascii() {
                b"ply" if line == 1 => Some(()),
                _ if line == 1 => None,
                b"end_header" => {
                    // The byte behind a lone CR may be a line feed, and the first of the rows.
                    let behind = text.len() + usize::from(begin.len() > text.len());
                    let rest = match ends_with_cr {
                        true => &begin[behind..],
                        false => lines.rest(),
                    };
                    return Ok(Self {
                        encoding: encoding.ok_or_else(|| missing("format line".into(), source))?,
                        elements,
                        texture_count,
                        rest,
                        first_line: line + 1,
                    });
                }
                text => statement(text, &mut encoding, &mut elements, &mut texture_count),
            };
            if read.is_none() {
                // A line without an end is the last one, but the header should have more.
                if line > 1 && begin.len() == text.len() {
                    return Err(cut());
                }
                return Err(LoadError::HeaderLine {
                    file: source.file.clone(),
                    line,
                    text: excerpt(&String::from_utf8_lossy(text)),
                });
            }
        }
    }

    /// The number of rows of all elements with a name.
    pub fn count(&self, name: &str) -> usize {
        let named = self.elements.iter().filter(|element| element.name == name);
        named.fold(0, |sum, element| sum.saturating_add(element.count))
    }

    /// All rows, from the first.
    pub fn rows(&self, rows_in: RowsIn) -> Rows<'a> {
        Rows::new(self.rest, self.encoding, self.first_line, rows_in)
    }
}

impl Element {
    /// The first property with a name, and its kind, if it is a number.
    pub fn scalar(&self, name: &str) -> Option<(usize, Scalar)> {
        let place = self.properties.iter().position(|p| p.name == name)?;
        match self.properties[place].kind {
            Kind::Scalar(scalar) => Some((place, scalar)),
            Kind::List { .. } => None,
        }
    }

    /// The list with the corners of faces: of either name, or the only one of whole numbers.
    pub fn corners(&self) -> Option<usize> {
        let properties = self.properties.iter().enumerate();
        let lists: Vec<(usize, &Property)> = properties
            .filter(|(_, property)| property.kind.is_index_list())
            .collect();
        let named = |name| lists.iter().find(|(_, property)| property.name == name);
        let only = match &lists[..] {
            [only] => Some(only),
            _ => None,
        };
        let found = named("vertex_indices").or_else(|| named("vertex_index"));
        found.or(only).map(|(place, _)| *place)
    }
}

impl Kind {
    const fn is_index_list(self) -> bool {
        match self {
            Self::Scalar(_) => false,
            Self::List { item, .. } => !matches!(item, Scalar::F32 | Scalar::F64),
        }
    }
}

/// Whether the first line ends with CR, and no LF behind.
fn has_cr_alone(bytes: &[u8]) -> bool {
    let end = bytes.iter().position(|byte| matches!(byte, b'\r' | b'\n'));
    end.is_some_and(|end| bytes[end] == b'\r' && bytes.get(end + 1) != Some(&b'\n'))
}

/// Reads a line between the first and the last, or returns `None`.
fn statement(
    text: &[u8],
    encoding: &mut Option<Encoding>,
    elements: &mut Vec<Element>,
    texture_count: &mut usize,
) -> Option<()> {
    let mut words = Words::new(text);
    match words.next().unwrap_or_default() {
        b"" | b"obj_info" => {}
        b"comment" => *texture_count += usize::from(words.next() == Some(b"TextureFile")),
        b"format" => {
            *encoding = Some(match words.next()? {
                b"ascii" => Encoding::Text,
                b"binary_little_endian" => Encoding::LittleEndian,
                b"binary_big_endian" => Encoding::BigEndian,
                _ => return None,
            });
        }
        b"element" => {
            let (name, count) = (words.next()?, words.next()?);
            let count: u64 = std::str::from_utf8(count).ok()?.parse().ok()?;
            elements.push(Element {
                name: words::name(name),
                count: usize::try_from(count).unwrap_or(usize::MAX),
                properties: Vec::new(),
            });
        }
        b"property" => {
            let kind = match words.next()? {
                b"list" => Kind::List {
                    count: scalar(words.next()?)?,
                    item: scalar(words.next()?)?,
                },
                word => Kind::Scalar(scalar(word)?),
            };
            elements.last_mut()?.properties.push(Property {
                name: words::name(words.next()?),
                kind,
            });
        }
        _ => return None,
    }
    Some(())
}

fn scalar(word: &[u8]) -> Option<Scalar> {
    Some(match word {
        b"char" | b"int8" => Scalar::I8,
        b"uchar" | b"uint8" => Scalar::U8,
        b"short" | b"int16" => Scalar::I16,
        b"ushort" | b"uint16" => Scalar::U16,
        b"int" | b"int32" => Scalar::I32,
        b"uint" | b"uint32" => Scalar::U32,
        b"long" | b"int64" => Scalar::I64,
        b"ulong" | b"uint64" => Scalar::U64,
        b"float" | b"float32" => Scalar::F32,
        b"double" | b"float64" => Scalar::F64,
        _ => return None,
    })
}
