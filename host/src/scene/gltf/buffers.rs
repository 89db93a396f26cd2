//! The bytes that a glTF scene points into.

use super::super::LoadError;
use super::super::error::excerpt;
use super::super::load::{Source, read_file};
use super::GltfError;
use gltf::Document;
use gltf::buffer::{Source as Address, View};
use std::borrow::Cow;

/// All buffers of a scene.
pub(super) struct Buffers<'a> {
    bytes: Vec<Cow<'a, [u8]>>,
}

impl<'a> Buffers<'a> {
    /// Reads the buffers, together no larger than a file may be.
    pub fn read(
        document: &Document,
        blob: Option<Cow<'a, [u8]>>,
        source: &Source<'_>,
    ) -> Result<Self, LoadError> {
        let in_file = |error| LoadError::Gltf {
            file: source.file.clone(),
            error,
        };
        let mut blob = blob;
        let mut budget = source.options.max_file_bytes;
        let mut bytes: Vec<Cow<'a, [u8]>> = Vec::new();
        for buffer in document.buffers() {
            let index = buffer.index();
            let read: Cow<'a, [u8]> = match buffer.source() {
                Address::Bin => match blob.take() {
                    Some(blob) => blob,
                    None => return Err(in_file(GltfError::NoBlob { buffer: index })),
                },
                Address::Uri(uri) => match place(uri) {
                    Some(BufferSource::Data(text)) => decode_base64(text)
                        .map_err(|character| {
                            in_file(GltfError::Base64 {
                                buffer: index,
                                character,
                            })
                        })?
                        .into(),
                    Some(BufferSource::Beside(path)) => {
                        read_file(&source.beside(path), budget)?.into()
                    }
                    None => {
                        return Err(in_file(GltfError::BufferElsewhere {
                            buffer: index,
                            uri: excerpt(uri),
                        }));
                    }
                },
            };
            if read.len() < buffer.length() {
                return Err(in_file(GltfError::BufferCut {
                    buffer: index,
                    announced: buffer.length() as u64,
                    found: read.len() as u64,
                }));
            }
            budget = budget.saturating_sub(read.len() as u64);
            bytes.push(read);
        }
        Ok(Self { bytes })
    }

    /// How many bytes there are in all.
    pub fn total_bytes(&self) -> usize {
        self.bytes.iter().map(|buffer| buffer.len()).sum()
    }

    /// The bytes of a view.
    pub fn view(&self, view: &View<'_>) -> Result<&[u8], GltfError> {
        let buffer = view.buffer().index();
        let bytes = &self.bytes[buffer];
        let end = view.offset().saturating_add(view.length());
        bytes
            .get(view.offset()..end)
            .ok_or(GltfError::ViewBeyondBuffer {
                view: view.index(),
                end: end as u64,
                buffer,
                length: bytes.len() as u64,
            })
    }
}

/// Where a buffer is.
enum BufferSource<'a> {
    /// In the address itself, as base64.
    Data(&'a str),
    /// In a file, as seen from the scene's.
    Beside(String),
}

/// None if the address is neither.
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

/// The bytes, or the place of the first character that is not base64. Ends at the padding.
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
