//! Each algorithm is written once, in core; entry points and passes unpack and call it. The table of ARCHITECTURE.md shows
//! files and lines. These tests keep the table true; `UPDATE_GOLDEN=1` rewrites it.

use slimbvh::gpu::Kernel;
use std::collections::BTreeSet;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// A stage: a description, and its files in core, in the shaders, and in both backends.
struct Stage {
    name: &'static str,
    what: &'static str,
    core: &'static [&'static str],
    shaders: &'static [&'static str],
    cpu: &'static [&'static str],
    gpu: &'static [&'static str],
}

const STAGES: &[Stage] = &[
    Stage {
        name: "gather",
        what: "positions and indices out of the caller's buffers of any layout (on the GPU)",
        core: &["build/gather"],
        shaders: &["gather"],
        cpu: &[],
        gpu: &["gather", "mesh"],
    },
    Stage {
        name: "bounds",
        what: "box of all triangles, the scene's power of two",
        core: &["build/bounds", "geometry/aabb"],
        shaders: &["bounds"],
        cpu: &["bounds"],
        gpu: &["bounds"],
    },
    Stage {
        name: "morton",
        what: "cell of each triangle's box centre, 30 or 63 bits, integers only",
        core: &["build/morton", "geometry/lattice"],
        shaders: &["morton"],
        cpu: &["morton", "order"],
        gpu: &["morton", "build/record"],
    },
    Stage {
        name: "sort",
        what: "stable radix sort of (code, index)",
        core: &["build/sort"],
        shaders: &["sort"],
        cpu: &["sort"],
        gpu: &["sort"],
    },
    Stage {
        name: "scan",
        what: "exclusive prefix sums",
        core: &["build/scan"],
        shaders: &["scan"],
        cpu: &["scan"],
        gpu: &["scan"],
    },
    Stage {
        name: "decide",
        what: "outer sides of components where the vertices are now, the smaller of L+ and L−",
        core: &[
            "reduce/decide",
            "reduce/decide/measure",
            "reduce/decide/clear",
            "reduce/decide/counts",
        ],
        shaders: &["decide"],
        cpu: &["decide"],
        gpu: &["decide", "decisions"],
    },
    Stage {
        name: "classify",
        what: "which triangles rays of one origin may hit",
        core: &[
            "reduce/classify",
            "geometry/orientation",
            "geometry/frustum",
        ],
        shaders: &["classify"],
        cpu: &["classify"],
        gpu: &["classify", "sides"],
    },
    Stage {
        name: "compact",
        what: "the items whose bit is set",
        core: &["build/compact"],
        shaders: &["compact"],
        cpu: &["compact"],
        gpu: &["compact"],
    },
    Stage {
        name: "fit",
        what: "whether a set fits into memory for less than all triangles (on the GPU)",
        core: &["build/fit", "trace/based"],
        shaders: &["fit"],
        cpu: &[],
        gpu: &["fit", "fit/recent"],
    },
    Stage {
        name: "snap",
        what: "triangles in leaf order, scaled to magnitude 1",
        core: &["build/snap", "geometry/triangle"],
        shaders: &["snap"],
        cpu: &["snap"],
        gpu: &["snap"],
    },
    Stage {
        name: "cluster",
        what: "a tree from the leaves up, where one is asked for; its places (on the CPU)",
        core: &[
            "build/cluster",
            "build/cluster/merge",
            "build/cluster/place",
        ],
        shaders: &[],
        cpu: &["cluster"],
        gpu: &[],
    },
    Stage {
        name: "topology",
        what: "nodes that cover more than `LEAF_SIZE` triangles, Karras' or those of `cluster`; on the CPU Karras' with their boxes",
        core: &["build/topology", "build/node", "build/sweep"],
        shaders: &["topology"],
        cpu: &["topology", "cluster", "sweep"],
        gpu: &["topology"],
    },
    Stage {
        name: "refit",
        what: "both children's boxes of each node, on a GPU and of moved or clustered trees",
        core: &["build/refit"],
        shaders: &["refit"],
        cpu: &["refit"],
        gpu: &["refit"],
    },
    Stage {
        name: "wide",
        what: "nodes of up to four children, where they are asked for: which binary nodes they take in, and their places",
        core: &[
            "build/wide",
            "build/wide/children",
            "build/wide/collapse",
            "build/wide/origin",
        ],
        shaders: &["wide"],
        cpu: &["wide", "wide/collapse"],
        gpu: &["wide"],
    },
    Stage {
        name: "encode",
        what: "nodes and triangles in codecs: from the root down, wide ones each on its own",
        core: &[
            "codec",
            "codec/encode",
            "codec/links",
            "codec/lattice_node",
            "codec/lattice_nodes",
            "codec/leaf_width",
            "codec/lattice_leaf",
            "codec/paper10",
            "codec/root",
            "codec/rounded",
            "codec/frame",
            "codec/wide_axis",
            "codec/wide_node",
            "codec/packed_links",
            "codec/shared_leaf",
            "codec/packed_wide_node",
            "codec/full_wide_node",
            "codec/rounded_children",
            "codec/mixed_wide_node",
        ],
        shaders: &["encode", "encode/wide"],
        cpu: &[
            "encode",
            "encode/tree",
            "encode/parent_frame",
            "encode/parent_frame/nodes",
            "encode/parent_frame/mesh",
            "encode/paper10",
            "encode/leaf_words",
            "wide/place",
            "wide/store",
            "tree/decode",
        ],
        gpu: &["encode", "coding"],
    },
    Stage {
        name: "camera",
        what: "from samples to rays, and to pixels",
        core: &["shade/camera", "shade/sampling", "shade/color"],
        shaders: &["camera"],
        cpu: &["camera"],
        gpu: &["camera"],
    },
    Stage {
        name: "trace",
        what: "closest hit, any hit, nearest hits, of one ray or of several together",
        core: &[
            "trace",
            "trace/bundle",
            "trace/collect",
            "trace/filter",
            "trace/interval",
            "trace/packet",
            "trace/prepare",
            "trace/query",
            "trace/sources",
            "trace/stack",
            "trace/wide",
            "trace/wide_rows",
            "trace/wide_stack",
            "codec/wide_sources",
            "geometry/lanes",
            "geometry/lanes/each",
            "geometry/ray",
            "geometry/planes",
            "geometry/slab",
            "geometry/watertight",
        ],
        shaders: &[
            "trace",
            "trace/kernels",
            "trace/store",
            "trace/plain",
            "trace/paper10",
            "trace/called",
            "trace/overflow",
            "trace/wide",
        ],
        cpu: &["trace", "tree/lanes", "tree/packets"],
        gpu: &["trace", "trace/paths"],
    },
    Stage {
        name: "shade",
        what: "light, shadow rays, mirrors, glass",
        core: &["shade", "shade/light", "shade/surface", "shade/material"],
        shaders: &["shade"],
        cpu: &["shade", "render"],
        gpu: &["shade", "render/wave"],
    },
    Stage {
        name: "view",
        what: "normals, primitives, depth, heat",
        core: &["shade/view"],
        shaders: &["view"],
        cpu: &["view"],
        gpu: &["view"],
    },
];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The folder of a file: files of the tree's room are listed with their folder.
fn home<'a>(folder: &'a str, file: &str) -> &'a str {
    if file.starts_with("tree/") {
        "host/src"
    } else {
        folder
    }
}

/// The code of some files, without tests, comments and blank lines.
fn code(folder: &str, files: &[&str]) -> Vec<String> {
    let mut lines = Vec::new();
    for file in files {
        let path = root().join(home(folder, file)).join(file);
        let path = path.with_extension("rs");
        let text = std::fs::read_to_string(&path)
            .unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let code = text.lines().map(str::trim);
        let code = code.take_while(|line| *line != "#[cfg(test)]");
        let code = code.filter(|line| !line.is_empty() && !line.starts_with("//"));
        lines.extend(code.map(String::from));
    }
    lines
}

/// The entry points of some files, in order. A macro's entry points are named in its call: `pub fn name;`.
fn entry_points(files: &[&str]) -> Vec<String> {
    let lines = code("gpu-shaders/src", files);
    let pairs = lines.windows(2);
    let names = pairs.filter_map(|pair| {
        let name = pair[1].strip_prefix("pub fn ")?;
        if pair[0].starts_with("#[spirv(compute") {
            name.split('(').next()
        } else {
            name.strip_suffix(';')
        }
    });
    names
        .filter(|name| !name.starts_with('$'))
        .map(String::from)
        .collect()
}

fn table() -> String {
    let mut table = String::new();
    let mut line = |text: String| {
        // Writing to a string cannot fail.
        let _ = writeln!(table, "{text}");
    };
    let list = |folder: &str, files: &[&str]| {
        let files = files.iter().map(|file| format!("`{folder}{file}.rs`"));
        files.collect::<Vec<_>>().join(", ")
    };
    line(
        "| stage | what happens | core | lines | entry points | lines | CPU pass | GPU pass |"
            .into(),
    );
    line("|---|---|---|--:|---|--:|---|---|".into());
    for stage in STAGES {
        let entries = entry_points(stage.shaders);
        let entries: Vec<String> = entries.iter().map(|name| format!("`{name}`")).collect();
        line(format!(
            "| {} | {} | {} | {} | {} | {} | {} | {} |",
            stage.name,
            stage.what,
            list("", stage.core),
            code("core/src", stage.core).len(),
            entries.join(", "),
            code("gpu-shaders/src", stage.shaders).len(),
            list("", stage.cpu),
            list("", stage.gpu),
        ));
    }
    let all = |folder: &str, files: fn(&Stage) -> &'static [&'static str]| {
        let files: BTreeSet<&str> = STAGES.iter().flat_map(files).copied().collect();
        code(folder, &files.into_iter().collect::<Vec<_>>()).len()
    };
    line(format!(
        "| all | | | {} | | {} | {} lines | {} lines |",
        all("core/src", |stage| stage.core),
        all("gpu-shaders/src", |stage| stage.shaders),
        all("host/src/cpu", |stage| stage.cpu),
        all("host/src/gpu", |stage| stage.gpu),
    ));
    table
}

#[test]
fn the_table_of_stages_is_that_of_the_code() {
    const BEGIN: &str = "<!-- stages: begin -->\n";
    const END: &str = "<!-- stages: end -->";
    let path = root().join("ARCHITECTURE.md");
    let text = std::fs::read_to_string(&path).expect("it is there");
    let (before, rest) = text.split_once(BEGIN).expect("the table begins");
    let (found, after) = rest.split_once(END).expect("the table ends");
    let expected = table();
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        let text = format!("{before}{BEGIN}{expected}{END}{after}");
        std::fs::write(&path, text).expect("the repository is ours");
        return;
    }
    assert!(
        found == expected,
        "the table of stages is out of date; UPDATE_GOLDEN=1 rewrites it:\n{expected}"
    );
}

/// The pass of a stage is in the file of its name, on the CPU and on the GPU. Stage `cluster` exists on the CPU only, `gather` and
/// `fit` on the GPU only.
#[test]
fn passes_bear_the_name_of_their_stage() {
    for stage in STAGES {
        for (folder, files) in [("cpu", stage.cpu), ("gpu", stage.gpu)] {
            if [("cluster", "gpu"), ("gather", "cpu"), ("fit", "cpu")]
                .contains(&(stage.name, folder))
            {
                assert!(files.is_empty());
                continue;
            }
            assert_eq!(files.first(), Some(&stage.name), "{folder}");
            let code = code(&format!("host/src/{folder}"), &[stage.name]);
            assert!(!code.is_empty(), "{folder}/{}.rs is empty", stage.name);
        }
    }
}

/// The table lists exactly the entry points that exist.
#[test]
fn every_kernel_belongs_to_a_stage() {
    let listed: BTreeSet<String> = STAGES
        .iter()
        .flat_map(|stage| entry_points(stage.shaders))
        // These become WGSL functions, and are no kernels.
        .filter(|name| !name.starts_with("call_"))
        .collect();
    let kernels = Kernel::ALL.iter().map(|kernel| kernel.name().to_owned());
    assert_eq!(listed, kernels.collect());
}
