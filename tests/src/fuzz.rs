//! The check of each fuzz target, for arbitrary bytes. The targets in `fuzz/` and the test that replays the seeds call these
//! functions, which panic if a law does not hold.

mod build_and_trace;
mod classification;
mod input;
mod loaders;
mod node_codec;
mod options;
mod saved_file;
mod shared_leaf;
mod triangle_codec;
mod wide_codec;

pub use build_and_trace::build_and_trace;
pub use classification::classification;
pub use loaders::{load_gltf, load_obj, load_off, load_ply, load_stl};
pub use node_codec::node_codec;
pub use options::options;
pub use saved_file::saved_file;
pub use triangle_codec::triangle_codec;
pub use wide_codec::wide_codec;

/// A target's check of some bytes.
pub type Check = fn(&[u8]);

/// All targets, by the names that they have in `fuzz/`.
pub const TARGETS: [(&str, Check); 12] = [
    ("build_and_trace", build_and_trace),
    ("classification", classification),
    ("load_gltf", load_gltf),
    ("load_obj", load_obj),
    ("load_off", load_off),
    ("load_ply", load_ply),
    ("load_stl", load_stl),
    ("node_codec", node_codec),
    ("options", options),
    ("saved_file", saved_file),
    ("triangle_codec", triangle_codec),
    ("wide_codec", wide_codec),
];
