//! The buffers of a glTF scene, each read when it is first needed.

use super::super::LoadError;
use super::super::error::excerpt;
use super::super::load::{Source, read_file};
use super::GltfError;
use super::json::{Buffer, BufferView, Index, Root};
use std::borrow::Cow;
use std::cell::{Cell, OnceCell};

/// Compressions of buffer views that cannot be decoded.
const COMPRESSIONS: [&str; 2] = ["EXT_meshopt_compression", "KHR_meshopt_compression"];

/// All buffers of a scene.
pub(super) struct Buffers<'a> {
    root: &'a Root,
    source: &'a Source<'a>,
    /// A GLB file's binary chunk.
    blob: Option<&'a [u8]>,
    bytes: Vec<OnceCell<Cow<'a, [u8]>>>,
    /// Bytes that may still be read. The buffers' total size has the limit of a file.
    budget: Cell<u64>,
    /// Bytes of the file, and of the buffers so far.
    known_bytes: Cell<usize>,
}

impl<'a> Buffers<'a> {
    pub fn new(
        root: &'a Root,
        blob: Option<&'a [u8]>,
        file_bytes: usize,
        source: &'a Source<'a>,
    ) -> Self {
        Self {
            root,
            source,
            blob,
            bytes: (0..root.buffers.len()).map(|_| OnceCell::new()).collect(),
            budget: Cell::new(source.options.max_file_bytes),
            known_bytes: Cell::new(file_bytes),
        }
    }

    /// Elements that an accessor without data may have.
    pub fn most_zeros(&self) -> usize {
        self.known_bytes.get().max(1 << 16)
    }

    /// The view and its bytes. The place in the JSON refers to it.
    pub fn view(
        &self,
        index: Index,
        place: impl FnOnce() -> String,
    ) -> Result<(&'a BufferView, &[u8]), LoadError> {
        let view = self.root.buffer_views.item("buffer views", index, place);
        let view = view.map_err(|error| self.fault(error))?;
        let Index(buffer) = view.buffer;
        let place = || format!("bufferViews[{}].buffer", index.0);
        let found = self.root.buffers.item("buffers", view.buffer, place);
        let found = found.map_err(|error| self.fault(error))?;

        // A fallback without data is a placeholder for what a decoder writes.
        let mut compressions = COMPRESSIONS.iter();
        let compression = compressions.find(|name| view.extensions.contains_key(**name));
        if let (Some(name), None) = (compression, &found.uri) {
            let is_fallback = COMPRESSIONS
                .iter()
                .any(|name| found.extensions.contains_key(*name));
            if is_fallback || buffer > 0 || self.blob.is_none() {
                return Err(self.fault(GltfError::Compressed {
                    place: format!("bufferViews[{}]", index.0),
                    extension: (*name).into(),
                }));
            }
        }

        let bytes = match self.bytes[buffer].get() {
            Some(bytes) => bytes,
            None => {
                let read = self.read(buffer, found)?;
                self.bytes[buffer].get_or_init(|| read)
            }
        };
        let end = view.byte_offset.0.saturating_add(view.byte_length.0);
        match bytes.get(view.byte_offset.0..end) {
            Some(bytes) => Ok((view, bytes)),
            None => Err(self.fault(GltfError::ViewBeyondBuffer {
                view: index.0,
                end: end as u64,
                buffer,
                length: bytes.len() as u64,
            })),
        }
    }

    /// Reads a buffer.
    fn read(&self, index: usize, buffer: &'a Buffer) -> Result<Cow<'a, [u8]>, LoadError> {
        let read: Cow<'a, [u8]> = match &buffer.uri {
            // Only the first buffer can be the binary chunk.
            None => match self.blob.filter(|_| index == 0) {
                Some(blob) => blob.into(),
                None => return Err(self.fault(GltfError::NoBlob { buffer: index })),
            },
            Some(uri) => match place(uri) {
                Some(BufferSource::Data(text)) => {
                    let decoded = match text.contains('%') {
                        true => decode_base64(&unescape(text)),
                        false => decode_base64(text),
                    };
                    let base64 = |character| GltfError::Base64 {
                        buffer: index,
                        character,
                    };
                    decoded.map_err(|place| self.fault(base64(place)))?.into()
                }
                Some(BufferSource::Beside(path)) => {
                    let bytes = read_file(&self.source.beside(path), self.budget.get())?;
                    self.known_bytes
                        .set(self.known_bytes.get().saturating_add(bytes.len()));
                    bytes.into()
                }
                None => {
                    return Err(self.fault(GltfError::BufferElsewhere {
                        buffer: index,
                        uri: excerpt(uri),
                    }));
                }
            },
        };
        if read.len() < buffer.byte_length.0 {
            return Err(self.fault(GltfError::BufferCut {
                buffer: index,
                announced: buffer.byte_length.0 as u64,
                found: read.len() as u64,
            }));
        }
        self.budget
            .set(self.budget.get().saturating_sub(read.len() as u64));
        Ok(read)
    }

    pub fn fault(&self, error: GltfError) -> LoadError {
        LoadError::Gltf {
            file: self.source.file.clone(),
            error,
        }
    }
}

/// The place of a buffer.
enum BufferSource<'a> {
    /// In the URI itself, as base64.
    Data(&'a str),
    /// In a file, relative to the scene's.
    Beside(String),
}

/// `None` if the URI is neither.
fn place(uri: &str) -> Option<BufferSource<'_>> {
    if let Some(data) = uri.strip_prefix("data:") {
        let (_, text) = data.split_once(";base64,")?;
        return Some(BufferSource::Data(text));
    }
    // A colon ends a scheme; in a path it would be escaped.
    (!uri.contains(':')).then(|| BufferSource::Beside(unescape(uri)))
}

/// Replaces escapes such as `%20`.
fn unescape(uri: &str) -> String {
    let mut bytes = Vec::with_capacity(uri.len());
    let mut rest = uri.as_bytes();
    while let [first, behind @ ..] = rest {
        let escaped = match behind {
            [high, low, ..] if *first == b'%' => hex(*high).zip(hex(*low)),
            _ => None,
        };
        if let Some((high, low)) = escaped {
            bytes.push(high << 4 | low);
            rest = &behind[2..];
        } else {
            bytes.push(*first);
            rest = behind;
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

fn hex(digit: u8) -> Option<u8> {
    char::from(digit).to_digit(16).map(|value| value as u8)
}

/// The bytes, or the position of the first character that is not base64. Stops at the padding.
fn decode_base64(text: &str) -> Result<Vec<u8>, usize> {
    let mut bytes = Vec::with_capacity(text.len() / 4 * 3);
    let (mut bits, mut bit_count) = (0_u32, 0);
    for (place, character) in text.bytes().enumerate() {
        let sextet = match character {
            b'A'..=b'Z' => character - b'A',
            b'a'..=b'z' => character - b'a' + 26,
            b'0'..=b'9' => character - b'0' + 52,
            b'+' | b'-' => 62,
            b'/' | b'_' => 63,
            b'=' => break,
            _ if character.is_ascii_whitespace() => continue,
            _ => return Err(place),
        };
        bits = bits << 6 | u32::from(sextet);
        bit_count += 6;
        if bit_count >= 8 {
            bit_count -= 8;
            bytes.push((bits >> bit_count) as u8);
        }
    }
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base64_of_every_remainder() {
        assert_eq!(decode_base64("").as_deref(), Ok(&b""[..]));
        assert_eq!(decode_base64("Zg==").as_deref(), Ok(&b"f"[..]));
        assert_eq!(decode_base64("Zm8=").as_deref(), Ok(&b"fo"[..]));
        assert_eq!(decode_base64("Zm9v").as_deref(), Ok(&b"foo"[..]));
        assert_eq!(decode_base64("Zm9v\nYg").as_deref(), Ok(&b"foob"[..]));
        assert_eq!(decode_base64("+/8A").as_deref(), Ok(&[0xfb, 0xff, 0][..]));
        assert_eq!(decode_base64("Zm*v"), Err(2));
    }

    #[test]
    fn escapes_are_replaced_where_they_are_complete() {
        assert_eq!(unescape("a%20b%C3%A4.bin"), "a bä.bin");
        assert_eq!(unescape("100%"), "100%");
        assert_eq!(unescape("%zz%4"), "%zz%4");
        assert_eq!(unescape("%+1"), "%+1");
    }

    #[test]
    fn only_files_beside_and_base64_are_read() {
        assert!(matches!(place("a.bin"), Some(BufferSource::Beside(path)) if path == "a.bin"));
        assert!(matches!(
            place("data:application/octet-stream;base64,AA=="),
            Some(BufferSource::Data("AA=="))
        ));
        assert!(place("data:text/plain,hello").is_none());
        assert!(place("https://example.org/a.bin").is_none());
    }
}
