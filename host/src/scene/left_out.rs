//! What a file holds and a scene does not.

use crate::text::{grouped, noun};
use std::fmt;

/// Points that a file draws, rather than vertices of no face.
#[cfg(feature = "scenes")]
pub(super) const POINTS: &str = "points";

/// Something that a file holds and its scene does not: it is neither drawn nor traced.
///
/// ```
/// use slimbvh::scene::{LoadOptions, load_bytes};
/// # fn main() -> Result<(), slimbvh::scene::LoadError> {
/// let text = "mtllib colours.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 1 2\nl 2 3\n";
/// let scene = load_bytes("model.obj".as_ref(), text.into(), &LoadOptions::default())?;
/// for left_out in &scene.left_out {
///     println!("left out: {left_out}");
/// }
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LeftOut {
    /// What it is, whatever the count: a plural such as "textures", or one thing with its name in quotes.
    pub what: String,
    /// How many there are.
    pub count: usize,
}

/// The count, and what it is.
impl fmt::Display for LeftOut {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let what = noun(self.count as u64, &self.what);
        write!(f, "{} {what}", grouped(self.count))
    }
}
