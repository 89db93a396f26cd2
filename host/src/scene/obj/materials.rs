//! Material libraries (MTL). After <https://paulbourke.net/dataformats/mtl/>.

use super::super::Material;
use super::super::faces::share;
use super::super::load::Source;
use super::super::words::{self, Words, number, whole};
use super::lines::Lines;

/// Illumination models with a reflection, and with a refraction.
const REFLECTION: i64 = 3;
const REFRACTION: [i64; 2] = [6, 7];
/// Models with reflections, glass or shadows of another kind.
const OTHERS: [i64; 5] = [4, 5, 8, 9, 10];

/// What libraries hold and materials have no place for.
#[derive(Default)]
pub(super) struct LeftOut {
    textures: usize,
    transparent: usize,
    emissive: usize,
    /// Materials with another illumination model.
    models: usize,
    /// Roughness, metal, sheen, clear coats and anisotropy.
    physical: usize,
    /// Transmission filters of materials without refraction.
    filters: usize,
    /// Colors by a spectrum, or in CIE XYZ.
    spectral: usize,
}

impl LeftOut {
    pub fn note(&self, source: &Source<'_>) {
        source.leave_out("textures", self.textures);
        source.leave_out("transparent materials", self.transparent);
        source.leave_out("emissive materials", self.emissive);
        source.leave_out(
            "materials with illumination model 4, 5, 8, 9 or 10",
            self.models,
        );
        source.leave_out(
            "materials with roughness, metal, sheen or coats",
            self.physical,
        );
        source.leave_out("transmission filters", self.filters);
        source.leave_out("spectral colours", self.spectral);
    }
}

/// A material as a library describes it.
#[derive(Default)]
struct Lit {
    name: String,
    diffuse: Option<[f32; 3]>,
    specular: [f32; 3],
    /// The transmission filter.
    filter: Option<[f32; 3]>,
    ior: Option<f32>,
    model: i64,
    is_transparent: bool,
    is_emissive: bool,
    is_physical: bool,
}

/// The materials of a library, with their names. Lines that cannot be read count for nothing.
pub(super) fn read(bytes: Vec<u8>, left_out: &mut LeftOut) -> Vec<(String, Material)> {
    let bytes = words::without_mark(bytes);
    let mut all = Vec::new();
    let mut current: Option<Lit> = None;
    for (_, line) in Lines::new(&bytes) {
        let mut words = Words::new(&line);
        let Some(keyword) = words.next() else {
            continue;
        };
        if keyword == b"newmtl" {
            all.extend(current.take().map(|lit| lit.convert(left_out)));
            let name = words::name(words.rest());
            current = (!name.is_empty()).then(|| Lit {
                name,
                ..Lit::default()
            });
            continue;
        }
        let Some(lit) = &mut current else {
            continue;
        };
        if matches!(keyword, b"Kd" | b"Ks" | b"Tf" | b"Ke") {
            let first = words.clone().next();
            left_out.spectral += usize::from(matches!(first, Some(b"spectral" | b"xyz")));
        }
        let mut value = || words.next().and_then(number).map(|x| x as f32);
        match keyword {
            b"Kd" => lit.diffuse = color(words).or(lit.diffuse),
            b"Ks" => lit.specular = color(words).unwrap_or(lit.specular),
            b"Tf" => lit.filter = color(words).or(lit.filter),
            b"Ke" => lit.is_emissive = color(words).is_some_and(|light| light != [0.0; 3]),
            b"Ni" => lit.ior = value().or(lit.ior),
            b"illum" => lit.model = words.next().and_then(whole).unwrap_or(lit.model),
            // Opacity, and its opposite. `d -halo` is that of a rim.
            b"d" => {
                let opacity = words.filter_map(number).next();
                lit.is_transparent |= opacity.is_some_and(|share| share < 1.0);
            }
            b"Tr" => lit.is_transparent |= value().is_some_and(|share| share > 0.0),
            b"Pr" | b"Pm" | b"Ps" | b"Pc" | b"aniso" => {
                lit.is_physical |= value().is_some_and(|share| share != 0.0);
            }
            b"bump" | b"disp" | b"decal" | b"refl" | b"norm" => {
                left_out.textures += usize::from(words.next().is_some());
            }
            // `map_aat` is an option of the next one.
            other if other.starts_with(b"map_") && other != b"map_aat" => {
                left_out.textures += usize::from(words.next().is_some());
            }
            _ => {}
        }
    }
    all.extend(current.map(|lit| lit.convert(left_out)));
    all
}

/// Three numbers, or one for all three.
fn color(words: Words<'_>) -> Option<[f32; 3]> {
    let mut words = words.map(number);
    let [r, g, b] = [words.next(), words.next(), words.next()];
    let color = match (r??, g, b) {
        (grey, None, _) => [grey; 3],
        (r, Some(g), Some(b)) => [r, g?, b?],
        _ => return None,
    };
    Some(color.map(|x| x as f32))
}

impl Lit {
    /// The diffuse color. The specular color as a mirror, if the illumination model has reflection. Glass with the color of the
    /// transmission filter, if it has refraction.
    fn convert(self, left_out: &mut LeftOut) -> (String, Material) {
        left_out.emissive += usize::from(self.is_emissive);
        left_out.physical += usize::from(self.is_physical);
        left_out.models += usize::from(OTHERS.contains(&self.model));
        let default = Material::default();
        if REFRACTION.contains(&self.model) {
            let glass = Material {
                base_color: self.filter.unwrap_or([1.0; 3]).map(share),
                mirror: 0.0,
                transmission: 1.0,
                ior: self.ior.unwrap_or(default.ior),
                ..default
            };
            return (self.name, glass);
        }
        left_out.transparent += usize::from(self.is_transparent);
        // All light, or none, is what programs write for opaque materials.
        let filters = |filter| filter != [1.0; 3] && filter != [0.0; 3];
        left_out.filters += usize::from(self.filter.is_some_and(filters));
        let specular = self.specular.into_iter().fold(0.0, f32::max);
        let material = Material {
            base_color: self.diffuse.map_or(default.base_color, |c| c.map(share)),
            mirror: match self.model {
                REFLECTION => share(specular),
                _ => 0.0,
            },
            ..default
        };
        (self.name, material)
    }
}
