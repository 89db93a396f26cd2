//! The formats of scene files.

use super::stl;
use std::path::Path;

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
        let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        let text = text.trim_ascii_start();
        let begins = |mark: &[u8]| bytes.starts_with(mark);
        let word_end = text.iter().position(u8::is_ascii_whitespace);
        let word = &text[..word_end.unwrap_or(text.len())];
        if begins(b"\x89SLIM") {
            Self::Slim
        } else if begins(b"glTF") || text.starts_with(b"{") {
            Self::Gltf
        } else if word == b"ply" {
            Self::Ply
        } else if stl::is_stl(bytes) {
            Self::Stl
        } else if is_off(word) {
            Self::Off
        } else if bytes.iter().take(512).any(|&byte| byte == 0) && !is_utf_16(bytes) {
            Self::Stl
        } else {
            Self::Obj
        }
    }

    /// The name in messages.
    pub(super) const fn name(self) -> &'static str {
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

/// Whether a word is the keyword of OFF with its prefixes, and maybe a count right behind.
fn is_off(word: &[u8]) -> bool {
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
        let cases: [(&[u8], Format); 14] = [
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
