//! Files of a hierarchy alone.

use super::error::{ContentError, FileError, WriteError};
use super::read::{Sections, hierarchy, scene};
use super::write::write_checked;
use crate::{Bvh, Scene};
use std::io::Write;

/// Writes a hierarchy without the mesh that it was built over, as its leaves hold what rays need. Returns the number of
/// bytes. The mesh is needed for refits, and for [`Bvh::validate_over`].
///
/// ```
/// use slimbvh::scene::slim::{read_hierarchy, write_hierarchy};
/// use slimbvh::{Builder, Ray, generate};
///
/// let mesh = generate::terrain(10.0, 16, 1);
/// let bvh = Builder::default().build(&mesh)?;
/// let mut file = Vec::new();
/// write_hierarchy(&bvh, &mut file)?;
///
/// let loaded = read_hierarchy(&file)?;
/// let ray = Ray::new([0.5, 9.0, 0.25], [0.0, -1.0, 0.0]);
/// assert_eq!(loaded.closest_hit(ray), bvh.closest_hit(ray));
/// // Whoever has the mesh can compare.
/// loaded.validate_over(&mesh)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// If the hierarchy is invalid, before anything is written; [`read_hierarchy`] accepts every written file. If the operating
/// system refuses.
pub fn write_hierarchy(bvh: &Bvh, to: impl Write) -> Result<u64, WriteError> {
    bvh.validate().map_err(ContentError::Tree)?;
    write_checked(&Scene::default(), bvh, None, to)
}

/// The hierarchy in the bytes of a file by [`write_hierarchy`], which may be mapped memory. Allocates at most as many bytes as
/// there are, plus two bits for each triangle, and a bit for each triangle of the mesh, of which a reduced hierarchy holds a part:
/// at most 32 MiB, as a mesh has at most 2^28.
///
/// The result is sound, whatever the bytes are: [`Bvh::validate`] has passed, so that tracing neither panics nor loses a hit
/// of the triangles in its leaves. Whether these are the triangles of a mesh, [`Bvh::validate_over`] checks.
///
/// # Errors
/// The first fault found; [`FileError::HasScene`] for a file by [`write()`](super::write()). Every change of a single byte, or
/// of a run of up to four, is found.
pub fn read_hierarchy(bytes: &[u8]) -> Result<Bvh, FileError> {
    let file = Sections::read(bytes)?;
    if !file.are_without_scene() {
        return Err(FileError::HasScene);
    }
    // Empty sections have sizes of items, too.
    scene(&file)?;
    let bvh = hierarchy(&file)?;
    bvh.validate().map_err(ContentError::Tree)?;
    Ok(bvh)
}
