//! OBJ: groups of polygons, with materials in other files. After <https://paulbourke.net/dataformats/obj/>.

mod corner;
mod libraries;
mod lines;
mod materials;
mod mesh;
mod statement;

use super::LoadError;
use super::load::{Found, Source};
use super::words;

/// Reads all polygons, with a part for each named group or object.
pub(super) fn read(source: &Source<'_>, bytes: Vec<u8>) -> Result<Found, LoadError> {
    let bytes = words::without_mark(bytes);
    let file = statement::read(source, &bytes)?;
    drop(bytes);
    mesh::convert(source, file)
}
