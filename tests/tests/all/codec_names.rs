//! Only the files that a new codec adds or extends name a codec. Elsewhere code calls the codec's methods.

use std::fs;
use std::path::{Path, PathBuf};

/// A codec of the library.
struct Codec {
    /// Words that name it in code.
    words: &'static [&'static str],
    /// Files that name it, at most [`MOST_FILES`].
    files: &'static [&'static str],
}

const MOST_FILES: usize = 6;

const CODECS: [Codec; 4] = [
    Codec {
        words: &["paper10", "leaf10"],
        files: &[
            "host/src/tree/codec.rs",
            "host/src/tree/stored.rs",
            "host/src/tree/paper10.rs",
            "host/src/cpu/encode.rs",
            "host/src/cpu/encode/paper10.rs",
            "host/src/gpu/coding.rs",
        ],
    },
    Codec {
        words: &["meshcodec::lattice"],
        files: &["host/src/tree/codec.rs", "host/src/tree/lattice.rs"],
    },
    Codec {
        words: &[
            "nodecodec::lattice",
            "storedtree::lattice",
            "latticebits::",
            "latticetree",
            "latticenodes",
            "latticecodec",
            "q10",
            "q21",
        ],
        files: &[
            "host/src/tree/codec.rs",
            "host/src/tree/stored.rs",
            "host/src/tree/parent_frame.rs",
            "host/src/cpu/encode.rs",
            "host/src/cpu/encode/parent_frame.rs",
            "host/src/cpu/encode/parent_frame/nodes.rs",
        ],
    },
    Codec {
        words: &[
            "nodecodec::wide",
            "storedtree::wide",
            "widestore::",
            "widetree",
            "w4",
        ],
        files: &[
            "host/src/tree/codec.rs",
            "host/src/tree/stored.rs",
            "host/src/tree/wide.rs",
            "host/src/cpu/encode.rs",
            "host/src/cpu/wide.rs",
            "host/src/gpu/coding.rs",
        ],
    },
];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The files of code in a folder and below, without tests.
fn files_in(folder: &str) -> Vec<String> {
    let mut files = Vec::new();
    let entries = fs::read_dir(root().join(folder)).expect("the folder is there");
    for entry in entries {
        let entry = entry.expect("the folder can be read");
        let name = entry.file_name().into_string().expect("names are UTF-8");
        let path = format!("{folder}/{name}");
        if entry.path().is_dir() {
            if name != "tests" {
                files.extend(files_in(&path));
            }
        } else if name.ends_with(".rs") && name != "tests.rs" {
            files.push(path);
        }
    }
    files.sort();
    files
}

/// Whether code names one of the words: up to its tests, without comments and declarations of modules.
fn names(text: &str, words: &[&str]) -> bool {
    let code = text.lines().map(str::trim);
    let code = code.take_while(|line| *line != "#[cfg(test)]");
    let is_declaration = |line: &str| {
        let line = line.trim_start_matches("pub(crate) ");
        line.trim_start_matches("pub ").starts_with("mod ")
    };
    let mut code = code.filter(|line| !line.starts_with("//") && !is_declaration(line));
    code.any(|line| {
        let line = line.to_lowercase();
        words.iter().any(|word| line.contains(word))
    })
}

#[test]
fn a_codec_is_named_in_few_files() {
    let mut all = files_in("host/src");
    all.extend(files_in("cli/src"));
    assert!(all.len() > 100, "only {} files", all.len());
    for codec in &CODECS {
        assert!(codec.files.len() <= MOST_FILES);
        let is_named = |file: &&String| {
            let text = fs::read_to_string(root().join(file)).expect("a file of code");
            names(&text, codec.words)
        };
        let found: Vec<&String> = all.iter().filter(is_named).collect();
        let mut expected = codec.files.to_vec();
        expected.sort_unstable();
        assert_eq!(found, expected, "{:?}", codec.words);
    }
}

/// The negative control: code that names a codec is found in any context.
#[test]
fn a_codec_is_found_where_it_is_named() {
    let words = CODECS[0].words;
    for text in [
        "use slimbvh_core::codec::Paper10Node;",
        "fn f() {\n    match nodes {\n        NodeCodec::Paper10 => 24,\n    }\n}",
        "let kind = \"leaf10\";",
        "modes.push(paper10);",
    ] {
        assert!(names(text, words), "{text}");
    }
    for text in [
        "// The codec paper10.",
        "/// [`NodeCodec::Paper10`]",
        "pub(crate) mod paper10;",
        "use crate::tree::NodeCodec;",
        "#[cfg(test)]\nmod tests {\n    use NodeCodec::Paper10;\n}",
    ] {
        assert!(!names(text, words), "{text}");
    }
    assert!(names(
        "if let MeshCodec::Lattice { .. } = mesh {",
        CODECS[1].words
    ));
    assert!(!names("mesh.check_lattice(step_exponent)", CODECS[1].words));
}
