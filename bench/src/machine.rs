//! The machine and the date of a record.

pub use slimbvh_lab::measure::machine::processor;

/// The widest vector instructions that the compiler was allowed to use.
#[must_use]
pub fn vectors() -> &'static str {
    if cfg!(target_feature = "avx512f") {
        "AVX-512"
    } else if cfg!(target_feature = "avx2") {
        "AVX2"
    } else if cfg!(target_feature = "neon") {
        "NEON"
    } else if cfg!(target_feature = "sse2") {
        "SSE2"
    } else {
        "none"
    }
}

/// Today in UTC, as 2026-11-22.
#[must_use]
pub fn date() -> String {
    jiff::Timestamp::now().strftime("%F").to_string()
}
