//! The formats of scene files.

use super::stl;
use super::words::{Lines, Words, without_mark};
use std::path::Path;

/// Bytes in which a mark is looked for, behind comments.
const HEAD_BYTES: usize = 1 << 16;

/// The format of a scene file.
///
/// Bytes without a file name, such as those of a pipe:
///
/// ```
/// use slimbvh::scene::{Format, LoadOptions, load_bytes};
/// # fn main() -> Result<(), slimbvh::scene::LoadError> {
/// let bytes = b"OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n".to_vec();
/// let options = LoadOptions {
///     format: Some(Format::of_content(&bytes)),
///     ..LoadOptions::default()
/// };
/// let scene = load_bytes("standard input".as_ref(), bytes, &options)?;
/// assert_eq!(options.format, Some(Format::Off));
/// assert_eq!(scene.mesh.indices, [[0, 1, 2]]);
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
#[non_exhaustive]
pub enum Format {
    /// glTF 2.0, as text or binary
    #[cfg_attr(feature = "clap", value(alias = "glb"))]
    Gltf,
    /// Wavefront OBJ
    Obj,
    /// PLY, as text or binary
    Ply,
    /// STL, as text or binary
    Stl,
    /// Object File Format, as text
    Off,
    /// A scene with its hierarchy, as `slim::write` makes it
    #[cfg_attr(feature = "clap", value(help = "A scene with its hierarchy"))]
    Slim,
}

impl Format {
    /// The format that the extension names, in any case.
    #[must_use]
    pub fn of_path(path: &Path) -> Option<Self> {
        let extension = path.extension()?.to_str()?.to_ascii_lowercase();
        Some(match extension.as_str() {
            "gltf" | "glb" => Self::Gltf,
            "obj" => Self::Obj,
            "ply" => Self::Ply,
            "stl" => Self::Stl,
            "off" => Self::Off,
            "slim" => Self::Slim,
            _ => return None,
        })
    }

    /// The format that the bytes of a file look like. OBJ has no mark of its own: it is any text that no other format begins with; other
    /// bytes are binary STL.
    #[must_use]
    pub fn of_content(bytes: &[u8]) -> Self {
        Self::of_mark(bytes).unwrap_or_else(|| {
            let is_binary = bytes.iter().take(512).any(|&byte| byte == 0);
            match stl::has_exact_length(bytes) || is_binary && !is_utf_16(bytes) {
                true => Self::Stl,
                false => Self::Obj,
            }
        })
    }

    /// The format that the bytes of a file begin as.
    pub(super) fn of_mark(bytes: &[u8]) -> Option<Self> {
        let text = without_mark(bytes[..bytes.len().min(HEAD_BYTES)].to_vec());
        let word = Lines::new(&text).find_map(|(_, line)| Words::new(line).next());
        let word = word.unwrap_or_default();
        Some(match word {
            _ if bytes.starts_with(b"\x89SLIM") => Self::Slim,
            _ if bytes.starts_with(b"glTF") || word.starts_with(b"{") => Self::Gltf,
            // Any bytes may begin a binary file, also these words.
            _ if stl::has_exact_length(bytes) => return None,
            b"ply" => Self::Ply,
            _ if stl::is_text(&text) => Self::Stl,
            word if is_off(word) => Self::Off,
            _ => return None,
        })
    }

    /// The name in text, such as `glTF` or `OBJ`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Gltf => "glTF",
            Self::Obj => "OBJ",
            Self::Ply => "PLY",
            Self::Stl => "STL",
            Self::Off => "OFF",
            Self::Slim => "slim",
        }
    }
}

/// Whether a word is the keyword of OFF with its prefixes, and maybe a count right behind; or a count, as in files without a keyword.
fn is_off(word: &[u8]) -> bool {
    if !word.is_empty() && word.iter().all(u8::is_ascii_digit) {
        return true;
    }
    let end = word.windows(3).position(|letters| letters == b"OFF");
    let prefix = end.map(|end| &word[..end]);
    prefix.is_some_and(|prefix| prefix.iter().all(|byte| b"STCN4n".contains(byte)))
}

fn is_utf_16(bytes: &[u8]) -> bool {
    bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn content_tells_the_format() {
        let binary_stl = [&[b'x'; 80][..], &[0; 4]].concat();
        let named_solid = [b"solid by some program".as_slice(), &[0; 63]].concat();
        let cases: [(&[u8], Format); 19] = [
            (b"  {\"asset\":{}}", Format::Gltf),
            (b"\xef\xbb\xbf{}", Format::Gltf),
            (b"glTF\x02\0\0\0", Format::Gltf),
            (b"ply\nformat ascii 1.0", Format::Ply),
            (b"ply\rformat ascii 1.0", Format::Ply),
            (b"solid x\nfacet", Format::Stl),
            (&binary_stl, Format::Stl),
            (&named_solid, Format::Stl),
            (b"OFF8 6 0", Format::Off),
            (b"COFF\n", Format::Off),
            (b"4OFF\n", Format::Off),
            (b"# a box\n\nOFF\n", Format::Off),
            (b"8 6 0\n", Format::Off),
            (b"\xef\xbb\xbfsolid x\nfacet", Format::Stl),
            (b"\xff\xfeO\0F\0F\0\n\0", Format::Off),
            (b"\xff\xfe#\0\n\0v\0", Format::Obj),
            (b"\x89SLIM\r\n\x1a\n", Format::Slim),
            (b"plywood 1\nv 0 0 0", Format::Obj),
            (b"# a box\nv 0 0 0", Format::Obj),
        ];
        for (bytes, format) in cases {
            let text = String::from_utf8_lossy(bytes);
            assert_eq!(Format::of_content(bytes), format, "{text}");
        }
        assert_eq!(Format::of_content(b""), Format::Obj);
    }
}
