//! Generators and oracles for the tests of slimbvh.
//!
//! Meshes and rays come as proptest [`strategies`] and as [`closed`] solids for stress; answers are compared with those of
//! an [`oracle`]; [`validate`] walks a tree; [`parity`] is what the GPU and the CPU must have; [`fuzz`] checks any bytes.

pub mod closed;
pub mod fuzz;
#[cfg(feature = "gpu")]
pub mod gpu;
pub mod oracle;
pub mod parity;
pub mod random;
pub mod rays;
pub mod scenes;
pub mod strategies;
pub mod validate;

use proptest::test_runner::Config;
use slimbvh::{BuildConfig, Builder, Bvh, CodeBits, Mesh};

/// A proptest configuration with this many cases, or more where `PROPTEST_CASES` asks for it.
#[must_use]
pub fn cases(count: u32) -> Config {
    let config = Config::default();
    let is_asked = std::env::var_os("PROPTEST_CASES").is_some();
    Config {
        cases: if is_asked {
            config.cases.max(count)
        } else {
            count
        },
        ..config
    }
}

/// Both lengths of codes.
pub const CODE_BITS: [CodeBits; 2] = [CodeBits::Bits30, CodeBits::Bits63];

/// Builds from a mesh that must be sound.
///
/// # Panics
/// If the mesh is refused.
#[must_use]
pub fn build(mesh: &Mesh, code_bits: CodeBits) -> Bvh {
    build_as(mesh, code_bits.into())
}

/// Builds from a mesh that must be sound, as configured.
///
/// # Panics
/// If the mesh is refused.
#[must_use]
pub fn build_as(mesh: &Mesh, config: BuildConfig) -> Bvh {
    match Builder::new(config).build(mesh) {
        Ok(bvh) => bvh,
        Err(error) => panic!("a sound mesh was refused: {error}"),
    }
}
