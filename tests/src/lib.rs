//! Generators and oracles for the tests of slimbvh.
//!
//! Meshes and rays come from proptest [`strategies`] and as [`closed`] solids. An [`oracle`] gives reference answers,
//! [`validate`] checks a tree, [`parity`] compares GPU and CPU, and [`fuzz`] has the checks of the fuzz targets.

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

/// A proptest configuration with this number of cases, or more if `PROPTEST_CASES` is larger.
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

/// Builds a tree from a mesh that must be valid.
///
/// # Panics
/// If the mesh is refused.
#[must_use]
pub fn build(mesh: &Mesh, code_bits: CodeBits) -> Bvh {
    build_as(mesh, code_bits.into())
}

/// Builds a tree with a configuration from a mesh that must be valid.
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
