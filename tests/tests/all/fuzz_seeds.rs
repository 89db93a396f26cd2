//! Replays the seeds of the fuzz targets, and the crashes that fuzzing has found, through the functions of `fuzz/`.

use slimbvh_tests::fuzz::TARGETS;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// Files of a folder, in the order of their names.
fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder);
    let entries = entries.unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let paths: BTreeSet<PathBuf> = entries
        .map(|entry| entry.expect("an entry").path())
        .collect();
    paths.into_iter().collect()
}

fn name(path: &Path) -> String {
    let name = path.file_stem().expect("entries have names");
    name.to_string_lossy().into_owned()
}

#[test]
fn every_seed_of_every_fuzz_target_passes() {
    let fuzz = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fuzz");
    for (target, check) in TARGETS {
        let seeds = files(&fuzz.join("corpus").join(target));
        assert!(seeds.len() >= 2, "{target} has {} seeds", seeds.len());
        for seed in seeds {
            // Name the seed, in case it fails.
            println!("{}", seed.display());
            check(&std::fs::read(&seed).expect("a seed"));
        }
    }
}

/// The list of targets and the folder have the same targets.
#[test]
fn every_fuzz_target_is_replayed() {
    let fuzz = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fuzz");
    let expected = TARGETS.map(|(target, _)| target.to_owned());
    for folder in ["fuzz_targets", "corpus"] {
        let found: Vec<String> = files(&fuzz.join(folder))
            .iter()
            .map(|path| name(path))
            .collect();
        assert_eq!(found, expected, "{folder}");
    }
}

/// No seed of a hierarchy alone is refused.
#[test]
fn the_seeds_of_hierarchies_alone_are_read() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fuzz/corpus/saved_file");
    for codec in ["alone", "alone-w4-48"] {
        let seed = std::fs::read(folder.join(codec)).expect("a seed");
        let read = slimbvh::scene::slim::read_hierarchy(&seed);
        let count = read.map(|bvh| bvh.node_count());
        assert!(
            count.as_ref().is_ok_and(|&count| count > 1),
            "{codec}: {count:?}"
        );
    }
}

/// No seed of a saved file is refused, as such a seed would test nothing.
#[test]
fn the_seeds_of_saved_hierarchies_are_read() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fuzz/corpus/saved_file");
    for codec in [
        "f32", "lattice", "leaf10", "paper10", "q10", "q4", "w4", "w4-48", "w4-64",
    ] {
        let seed = std::fs::read(folder.join(codec)).expect("a seed");
        let read = slimbvh::scene::slim::read(&seed);
        let count = read.map(|saved| saved.bvh.node_count());
        assert!(
            count.as_ref().is_ok_and(|&count| count > 1),
            "{codec}: {count:?}"
        );
    }
}
