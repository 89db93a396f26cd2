//! Which triangles a view needs: the stages `decide` and `classify`. Stage `compact` lists what they keep.

pub mod classify;
pub mod decide;
