//! The help texts name all options.

use crate::output::options_in;
use crate::process::Folder;

#[test]
fn help_for_reduced_trees() {
    let folder = Folder::new();
    let reduced = folder.succeed(["reproduce", "reduced", "--help"]);
    let expected = [
        "--adapter",
        "--backend",
        "--built-in",
        "--help",
        "--json",
        "--mesh",
        "--only",
        "--out",
        "--quick",
        "--scenes",
        "--threads",
    ];
    assert_eq!(options_in(&reduced), expected, "{reduced}");
    for word in [
        "24-cell",
        "armadillo",
        "SLIMBVH_SCENES",
        "FILE.md",
        "Examples:",
    ] {
        assert!(reduced.contains(word), "{word} is not in {reduced}");
    }
    let papers = folder.succeed(["reproduce", "--help"]);
    assert!(papers.contains("Wong, Cheng and Lii"), "{papers}");
    let top = folder.succeed(["--help"]);
    for command in ["reproduce", "stress"] {
        assert!(top.contains(&format!("  {command} ")), "{top}");
    }
    assert_eq!(options_in(&top), ["--help", "--version"], "{top}");
    assert_eq!(
        folder.succeed(["--version"]),
        concat!("slimbvh-lab ", env!("CARGO_PKG_VERSION"), "\n")
    );
}

#[test]
fn help_for_compressed_trees() {
    let folder = Folder::new();
    let compressed = folder.succeed(["reproduce", "compressed", "--help"]);
    let expected = [
        "--adapter",
        "--backend",
        "--built-in",
        "--help",
        "--json",
        "--mesh",
        "--only",
        "--out",
        "--quick",
        "--scenes",
        "--threads",
    ];
    assert_eq!(options_in(&compressed), expected, "{compressed}");
    for word in ["asian-dragon", "SLIMBVH_SCENES", "FILE.md", "Examples:"] {
        assert!(compressed.contains(word), "{word} is not in {compressed}");
    }
    let papers = folder.succeed(["reproduce", "--help"]);
    assert!(papers.contains("compressed"), "{papers}");
}

#[test]
fn help_for_bench() {
    let folder = Folder::new();
    let bench = folder.succeed(["bench", "--help"]);
    let expected = [
        "--adapter",
        "--backend",
        "--camera",
        "--help",
        "--only",
        "--out",
        "--quick",
        "--rounds",
        "--scaling",
        "--size",
        "--threads",
    ];
    assert_eq!(options_in(&bench), expected, "{bench}");
    for word in ["SCENE", "24-cell", "index.html", "Examples:"] {
        assert!(bench.contains(word), "{word} is not in {bench}");
    }
    let top = folder.succeed(["--help"]);
    assert!(top.contains("  bench "), "{top}");
}
