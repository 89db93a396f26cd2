//! What the hash of the shaders' sources covers.

use super::contract::source_hash::source_hash;
use std::fs::{copy, create_dir_all, read_dir, write};
use std::path::Path;

/// A core with code for both processors, for the CPU, for shaders, and a test.
const CORE: &str = r#"
//! Docs.
pub struct Boxes {
    pub low: f32,
    #[cfg(not(target_arch = "spirv"))]
    pub met: u32,
}
impl Boxes {
    pub fn shared(self) -> f32 { self.low + 1.0 }
    #[cfg(not(target_arch = "spirv"))]
    pub fn host(self) -> u32 { self.met + 2 }
}
#[cfg(not(target_arch = "spirv"))]
pub fn made() -> u32 { 3 }
#[cfg(target_arch = "spirv")]
pub fn shader() -> u32 { 4 }
#[cfg(not(target_arch = "spirv"))]
mod lanes;
mod both;
#[cfg(test)]
mod tests { const FIVE: u32 = 5; }
"#;

/// The hash of a copy of this repository whose core and shader crate are these texts.
fn hash([core, lanes, both]: [&str; 3]) -> String {
    let repository = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let folder = tempfile::tempdir().expect("the system has a place for temporary files");
    let root = folder.path();
    let builder = "gpu-shaders/builder";
    for folder in ["core/src", "shader/src", "gpu-shaders/builder/src"] {
        create_dir_all(root.join(folder)).expect("the folder is ours");
    }
    for (file, text) in [
        ("core/src/lib.rs", core),
        ("core/src/lanes.rs", lanes),
        ("core/src/both.rs", both),
        ("shader/src/lib.rs", "pub fn entry() {}"),
    ] {
        write(root.join(file), text).expect("the folder is ours");
    }
    for lock in ["Cargo.lock", "gpu-shaders/builder/Cargo.lock"] {
        copy(repository.join(lock), root.join(lock)).expect("a lock file");
    }
    let sources = read_dir(repository.join(builder).join("src")).expect("the builder");
    for source in sources {
        let path = source.expect("an entry").path();
        if let Some(name) = path.file_name().filter(|_| path.is_file()) {
            let to = root.join(builder).join("src").join(name);
            copy(&path, to).expect("a file of the builder");
        }
    }
    source_hash(root, &["shader"]).expect("it can be read")
}

const LANES: &str = "pub const SIX: u32 = 6;";
const BOTH: &str = "pub const SEVEN: u32 = 7;";

#[test]
fn code_for_the_cpu_and_tests_do_not_count() {
    let before = hash([CORE, LANES, BOTH]);
    for (old, new) in [
        ("self.met + 2", "self.met + 20"),
        ("-> u32 { 3 }", "-> u32 { 30 }"),
        ("pub met: u32", "pub met: [u32; 3]"),
        ("FIVE: u32 = 5", "FIVE: u32 = 50"),
        ("//! Docs.", "//! More docs."),
        ("pub fn made()", "pub  fn  made ( )"),
    ] {
        let changed = CORE.replace(old, new);
        assert_ne!(changed, CORE, "{old}");
        assert_eq!(hash([&changed, LANES, BOTH]), before, "{new}");
    }
    assert_eq!(hash([CORE, "pub const SIX: u32 = 60;", BOTH]), before);
    // A new function for the CPU.
    let more = format!("{CORE}\n#[cfg(not(target_arch = \"spirv\"))]\npub fn more() {{}}");
    assert_eq!(hash([&more, LANES, BOTH]), before);
}

/// The control: what shaders have counts.
#[test]
fn code_that_shaders_have_counts() {
    let before = hash([CORE, LANES, BOTH]);
    for (old, new) in [
        ("self.low + 1.0", "self.low + 1.5"),
        ("-> u32 { 4 }", "-> u32 { 40 }"),
        ("pub low: f32", "pub low: u32"),
        (
            "#[cfg(not(target_arch = \"spirv\"))]\npub fn made",
            "pub fn made",
        ),
        ("mod both;", "pub mod both;"),
    ] {
        let changed = CORE.replace(old, new);
        assert_ne!(changed, CORE, "{old}");
        assert_ne!(hash([&changed, LANES, BOTH]), before, "{new}");
    }
    assert_ne!(hash([CORE, LANES, "pub const SEVEN: u32 = 70;"]), before);
    let more = format!("{CORE}\npub fn more() {{}}");
    assert_ne!(hash([&more, LANES, BOTH]), before);
}
