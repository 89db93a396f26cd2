//! Material libraries (MTL).

use super::super::faces::share;
use super::super::load::{Source, read_file};
use super::super::{LoadError, Material};
use std::io::ErrorKind;
use std::path::Path;

/// The materials of a library, which may be missing. `tobj` reads only the lines that are used and readable: it panics at a
/// color of fewer than three numbers, and rejects the library at one that is not a number.
pub(super) fn read(
    library: &Path,
    source: &Source<'_>,
) -> Result<(Vec<tobj::Material>, Names), LoadError> {
    let path = source.beside(library);
    let bytes = match read_file(&path, source.options.max_file_bytes) {
        Ok(bytes) => bytes,
        Err(LoadError::Read { error, .. }) if error.kind() == ErrorKind::NotFound => {
            return Ok(Default::default());
        }
        Err(error) => return Err(error),
    };
    let text = String::from_utf8_lossy(&bytes);
    let lines: Vec<&str> = text.lines().filter(|line| is_readable(line)).collect();
    tobj::load_mtl_buf(&mut lines.join("\n").as_bytes()).map_err(|error| LoadError::Obj {
        file: path.display().to_string(),
        line: None,
        error,
    })
}

/// Materials by name.
type Names = std::collections::HashMap<String, usize>;

/// Whether the line starts a material, or is a readable value that [`convert`] uses.
fn is_readable(line: &str) -> bool {
    let mut words = line.split_whitespace();
    match words.next() {
        Some("newmtl") => words.next().is_some(),
        Some("Kd" | "Ks" | "Tf") => color(words).is_some(),
        Some("Ni") => words.next().is_some_and(|word| word.parse::<f32>().is_ok()),
        Some("illum") => words.next().is_some_and(|word| word.parse::<u8>().is_ok()),
        _ => false,
    }
}

/// Three numbers.
fn color<'a>(words: impl Iterator<Item = &'a str>) -> Option<[f32; 3]> {
    let numbers: Vec<f32> = words.take(3).map_while(|word| word.parse().ok()).collect();
    numbers.try_into().ok()
}

/// The diffuse color. The specular color as a mirror, if the illumination model has reflection. Glass with the color of the
/// transmission filter, if it has refraction.
pub(super) fn convert(material: &tobj::Material) -> Material {
    const REFLECTION: u8 = 3;
    const REFRACTION: [u8; 2] = [6, 7];
    if REFRACTION.map(Some).contains(&material.illumination_model) {
        let filter = material.unknown_param.get("Tf");
        let filter = filter.and_then(|text| color(text.split_whitespace()));
        return Material {
            base_color: filter.map_or([1.0; 3], |filter| filter.map(share)),
            mirror: 0.0,
            transmission: 1.0,
            ior: material.optical_density.unwrap_or(Material::default().ior),
            ..Material::default()
        };
    }
    let specular = material.specular.unwrap_or_default();
    let is_mirror = material.illumination_model == Some(REFLECTION);
    Material {
        base_color: match material.diffuse {
            Some(diffuse) => diffuse.map(share),
            None => Material::default().base_color,
        },
        mirror: match is_mirror {
            true => share(specular.into_iter().fold(0.0, f32::max)),
            false => 0.0,
        },
        ..Material::default()
    }
}
