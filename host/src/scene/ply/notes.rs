//! What a PLY file holds and the scene does not.

use super::super::error::excerpt;
use super::super::load::Source;
use super::header::{Element, Header};
use super::rows::Spare;
use super::{KEPT, plural};

/// Names of properties with a color or its opacity.
const COLOURS: [&str; 16] = [
    "red",
    "green",
    "blue",
    "alpha",
    "r",
    "g",
    "b",
    "a",
    "diffuse_red",
    "diffuse_green",
    "diffuse_blue",
    "diffuse_alpha",
    "ambient_red",
    "ambient_green",
    "ambient_blue",
    "ambient_coeff",
];

/// Names of properties with a place in a texture, or the texture.
const TEXTURE_COORDINATES: [&str; 8] = [
    "s",
    "t",
    "u",
    "v",
    "texture_u",
    "texture_v",
    "texcoord",
    "texnumber",
];

/// Names of other properties that a note has, at most.
const MOST_NAMES: usize = 4;

/// Notes what no reader wants.
pub(super) fn note(header: &Header<'_>, spare: &Spare, source: &Source<'_>) {
    source.leave_out("textures", header.texture_count);
    for element in header.elements.iter().filter(|element| element.count > 0) {
        match element.name.as_str() {
            "vertex" => note_properties(element, &kept(element), "vertex", source),
            "face" => note_properties(element, &corners(element), "face", source),
            "tristrips" => note_properties(element, &corners(element), "strip", source),
            "edge" => source.leave_out("edges", element.count),
            other => source.leave_out(&plural(other), element.count),
        }
    }
    source.leave_out("rows with spare words", spare.rows);
    source.leave_out("lines behind the end", spare.lines);
    source.leave_out("bytes behind the end", spare.bytes);
}

/// The places of the vertex properties that are used. Two parts of a normal are none.
fn kept(element: &Element) -> Vec<usize> {
    let place = |name: &&str| Some(element.scalar(name)?.0);
    let normal: Option<Vec<usize>> = KEPT[3..].iter().map(place).collect();
    let position = KEPT[..3].iter().filter_map(place);
    position.chain(normal.unwrap_or_default()).collect()
}

fn corners(element: &Element) -> Vec<usize> {
    element.corners().into_iter().collect()
}

/// Notes the properties of an element that are not read: colors and texture coordinates as such, others by their names.
fn note_properties(element: &Element, read: &[usize], row: &str, source: &Source<'_>) {
    let (mut is_coloured, mut is_textured, mut others) = (false, false, Vec::new());
    for (place, property) in element.properties.iter().enumerate() {
        match property.name.as_str() {
            _ if read.contains(&place) => {}
            name if COLOURS.contains(&name) => is_coloured = true,
            name if TEXTURE_COORDINATES.contains(&name) => is_textured = true,
            name => others.push(excerpt(name)),
        }
    }
    if is_coloured {
        source.leave_out(&format!("{row} colours"), element.count);
    }
    if is_textured {
        source.leave_out("texture coordinates", element.count);
    }
    if !others.is_empty() {
        let more = if others.len() > MOST_NAMES {
            ", …"
        } else {
            ""
        };
        let names = others[..others.len().min(MOST_NAMES)].join(", ");
        let what = format!("{row} properties ({names}{more})");
        source.leave_out(&what, others.len());
    }
}
