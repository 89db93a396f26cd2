//! The JSON of a glTF scene, and the chunks of a GLB file.

use super::super::LoadError;
use super::super::error::excerpt;
use super::super::load::Source;
use super::GltfError;
use super::extensions::{Effect, effect};
use super::json::{Asset, Root};
use crate::text::shorten;
use serde::Deserialize;
use serde_json::Value;

/// A document, and a GLB file's binary chunk.
type WithBlob<'a> = (Root, Option<&'a [u8]>);

/// Splits the file into chunks, and reads the JSON.
pub(super) fn parse<'a>(bytes: &'a [u8], source: &Source<'_>) -> Result<WithBlob<'a>, LoadError> {
    let (json, blob) = match bytes.starts_with(b"glTF") {
        true => split(bytes, source)?,
        false => (bytes, None),
    };
    let in_file = |error| LoadError::Gltf {
        file: source.file.clone(),
        error,
    };
    // Bytes that are not UTF-8 are replaced: most stand in texts that are not read.
    let root = root(&String::from_utf8_lossy(trim(json))).map_err(in_file)?;
    let required = root.extensions_required.iter().map(|(_, name)| name);
    let unknown = required
        .into_iter()
        .find(|name| effect(name) == Effect::Unknown);
    match unknown.map(|name| excerpt(name)) {
        Some(name) => Err(in_file(GltfError::UnknownExtension { name })),
        None => Ok((root, blob)),
    }
}

/// Reads the JSON. Another version is the first fault to be named.
fn root(json: &str) -> Result<Root, GltfError> {
    #[derive(Deserialize)]
    struct Head {
        asset: Asset,
    }

    // serde takes a list for an object, too.
    if json.trim_start().starts_with('[') {
        return Err(GltfError::Json {
            message: "it is a list, not an object".into(),
        });
    }
    let root = serde_json::from_str::<Root>(json);
    let version = match &root {
        Ok(root) => version(&root.asset),
        Err(_) => serde_json::from_str::<Head>(json)
            .ok()
            .and_then(|head| version(&head.asset)),
    };
    if let Some(version) = version.filter(|version| version.split('.').next() != Some("2")) {
        return Err(GltfError::Version {
            version: excerpt(&version),
        });
    }
    root.map_err(|error| GltfError::Json {
        message: shorten(&error.to_string(), 120),
    })
}

fn version(asset: &Asset) -> Option<String> {
    match &asset.version {
        Value::String(text) => Some(text.clone()),
        Value::Number(number) => Some(number.to_string()),
        _ => None,
    }
}

/// Takes off a byte order mark, and the zeros with which some writers fill a chunk.
fn trim(json: &[u8]) -> &[u8] {
    let json = json.strip_prefix(b"\xef\xbb\xbf").unwrap_or(json);
    let end = json.iter().rposition(|&byte| byte != 0);
    &json[..end.map_or(0, |end| end + 1)]
}

/// The JSON and the binary chunk of a GLB file; glTF 2.0, section 4.4. Other chunks are noted.
fn split<'a>(
    bytes: &'a [u8],
    source: &Source<'_>,
) -> Result<(&'a [u8], Option<&'a [u8]>), LoadError> {
    let fault = |error| LoadError::Gltf {
        file: source.file.clone(),
        error,
    };
    let broken = |message| fault(GltfError::Glb { message });
    let [_, version, length] = words(bytes).ok_or_else(|| LoadError::HeaderCut {
        file: source.file.clone(),
    })?;
    if version != 2 {
        return Err(fault(GltfError::Version {
            version: version.to_string(),
        }));
    }
    let length = length as usize;
    if length < HEADER_BYTES {
        return Err(broken(format!("its header announces {length} bytes")));
    }
    if length > bytes.len() {
        return Err(LoadError::EndsEarly {
            file: source.file.clone(),
            what: "bytes".into(),
            announced: length as u64,
            found: bytes.len() as u64,
        });
    }

    source.leave_out("bytes behind the end", bytes.len() - length);

    let mut rest = &bytes[HEADER_BYTES..length];
    let (mut json, mut blob) = (None, None);
    while let Some([length, kind]) = words(rest) {
        let behind = &rest[CHUNK_HEADER_BYTES..];
        let Some(chunk) = behind.get(..length as usize) else {
            return Err(broken(format!(
                "a chunk announces {length} bytes, {} are there",
                behind.len()
            )));
        };
        match &kind.to_le_bytes() {
            b"JSON" if json.is_none() => json = Some(chunk),
            b"BIN\0" if blob.is_none() => blob = Some(chunk),
            b"JSON" | b"BIN\0" => source.leave_out("chunks after the first of their type", 1),
            _ => source.leave_out("chunks of unknown types", 1),
        }
        // Chunks begin at multiples of four bytes.
        rest = &behind[chunk.len().next_multiple_of(4).min(behind.len())..];
    }
    let json = json.ok_or_else(|| broken("it has no JSON".into()))?;
    // Too few for another chunk.
    source.leave_out("bytes behind the end", rest.len());
    Ok((json, blob))
}

const HEADER_BYTES: usize = 12;
const CHUNK_HEADER_BYTES: usize = 8;

/// The first little-endian words.
fn words<const N: usize>(bytes: &[u8]) -> Option<[u32; N]> {
    let (words, _) = bytes.get(..4 * N)?.as_chunks::<4>();
    let mut numbers = [0; N];
    for (number, word) in numbers.iter_mut().zip(words) {
        *number = u32::from_le_bytes(*word);
    }
    Some(numbers)
}
