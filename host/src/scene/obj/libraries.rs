//! The material libraries that an OBJ file names.

use super::super::error::excerpt;
use super::super::load::{Source, read_file};
use super::super::{LoadError, Material};
use super::materials::{self, LeftOut};
use std::collections::{HashMap, HashSet};
use std::io::ErrorKind;
use std::path::PathBuf;

/// All materials so far.
#[derive(Default)]
pub(super) struct Libraries {
    pub materials: Vec<Material>,
    /// The last material of each name.
    names: HashMap<String, u32>,
    left_out: LeftOut,
    /// Names that were looked for.
    known: HashSet<String>,
}

impl Libraries {
    /// Reads the libraries of an `mtllib` line: one name, which may have spaces, or several.
    pub fn read(&mut self, line: &[u8], source: &Source<'_>) -> Result<(), LoadError> {
        let line = String::from_utf8_lossy(line);
        let line = line.trim().trim_matches('"').trim();
        if self.open(line, source)? {
            return Ok(());
        }
        for name in names(line) {
            if self.open(name, source)? {
                continue;
            }
            for word in name.split_whitespace() {
                if !self.open(word, source)? {
                    self.miss(word, source);
                }
            }
        }
        Ok(())
    }

    /// Reads a library, or returns that it is not there.
    fn open(&mut self, name: &str, source: &Source<'_>) -> Result<bool, LoadError> {
        if name.is_empty() || self.known.contains(name) {
            return Ok(true);
        }
        let Some(path) = find(name, source)? else {
            return Ok(false);
        };
        self.known.insert(name.into());
        let bytes = read_file(&path, source.options.max_file_bytes)?;
        let first = self.materials.len() as u32;
        let read = materials::read(bytes, &mut self.left_out);
        for (index, (name, material)) in (first..).zip(read) {
            self.names.insert(name, index);
            self.materials.push(material);
        }
        Ok(true)
    }

    fn miss(&mut self, name: &str, source: &Source<'_>) {
        if !self.known.insert(name.into()) {
            return;
        }
        let what = format!("missing material library \"{}\"", excerpt(name));
        source.leave_out(&what, 1);
    }

    /// The material of each name, where a library has it. Notes what libraries hold and what they lack.
    pub fn find(&self, names: &[String], source: &Source<'_>) -> Vec<Option<u32>> {
        self.left_out.note(source);
        let found: Vec<Option<u32>> = names.iter().map(|name| self.material(name)).collect();
        // Programs write these for faces without a material.
        let is_none = |name: &str| ["", "None", "(null)"].contains(&name);
        let missing = names.iter().zip(&found);
        let missing = missing.filter(|(name, found)| found.is_none() && !is_none(name));
        source.leave_out("materials that no library has", missing.count());
        found
    }

    /// A material by its name, which a comment may follow.
    fn material(&self, name: &str) -> Option<u32> {
        let without_comment = || self.names.get(name.split_once(" #")?.0.trim_end());
        self.names.get(name).or_else(without_comment).copied()
    }
}

/// The names on a line: each up to its extension, so that names may have spaces.
fn names(line: &str) -> impl Iterator<Item = &str> {
    let mut rest = line;
    std::iter::from_fn(move || {
        let text = rest.trim_start();
        let mut end = 0;
        for word in text.split_inclusive(char::is_whitespace) {
            end += word.len();
            let word = word.trim_end().trim_end_matches('"');
            if word.to_ascii_lowercase().ends_with(".mtl") {
                break;
            }
        }
        rest = &text[end..];
        let name = text[..end].trim().trim_matches('"');
        (end > 0).then_some(name)
    })
}

/// The library's path, if it is there: as written, with slashes for backslashes, or beside the file whatever its folder.
fn find(name: &str, source: &Source<'_>) -> Result<Option<PathBuf>, LoadError> {
    let slashes = name.replace('\\', "/");
    let last = slashes.rsplit('/').next().unwrap_or_default();
    for name in [name, &slashes, last] {
        if name.is_empty() {
            continue;
        }
        let path = source.beside(name);
        match std::fs::metadata(&path) {
            Ok(_) => return Ok(Some(path)),
            Err(error) if error.kind() == ErrorKind::PermissionDenied => {
                return Err(LoadError::Read {
                    file: path.display().to_string(),
                    error,
                });
            }
            Err(_) => {}
        }
    }
    Ok(None)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_end_with_their_extension() {
        let all = |line: &'static str| names(line).collect::<Vec<_>>();
        assert_eq!(all("a.mtl b.MTL"), ["a.mtl", "b.MTL"]);
        assert_eq!(all("my house.mtl  c.mtl"), ["my house.mtl", "c.mtl"]);
        assert_eq!(all("\"my house.mtl\" c.mtl"), ["my house.mtl", "c.mtl"]);
        assert_eq!(all("a b"), ["a b"]);
        assert!(all("").is_empty());
    }
}
