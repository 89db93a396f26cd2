//! The help texts.

use crate::output::options_in;
use crate::process::Folder;

/// Options that `animate` does not have.
const ONLY_RENDER: [&str; 1] = ["--output"];

#[test]
fn help_has_every_option() {
    let folder = Folder::new();
    let render = folder.succeed(["render", "--help"]);
    let expected = [
        "--adapter",
        "--backend",
        "--camera",
        "--codes",
        "--cull",
        "--dark-rays",
        "--explain",
        "--format",
        "--help",
        "--json",
        "--lenient",
        "--light",
        "--mesh",
        "--mirror-depth",
        "--nodes",
        "--output",
        "--reduce",
        "--size",
        "--solid",
        "--spp",
        "--threads",
        "--tolerance",
        "--tree",
        "--up",
        "--view",
        "--without",
    ];
    assert_eq!(options_in(&render), expected, "{render}");
    for word in [
        "color",
        "normals",
        "depth",
        "primitives",
        "heatmap",
        "1280x720",
        "slimbvh.png",
        "eye=",
        "sun=",
        "point=",
        "disc=",
        "rectangle=",
        "lens=",
        "fov=",
        "range=",
        "gltf, glb, obj, ply, stl, off or slim",
    ] {
        assert!(render.contains(word), "{word} is not in {render}");
    }
    let animate = folder.succeed(["animate", "--help"]);
    let mut expected_too = vec![
        "--deform",
        "--fps",
        "--frames",
        "--orbit",
        "--orbit-light",
        "--out",
        "--shutter",
        "--shutter-times",
        "--update",
    ];
    expected_too.extend(
        expected
            .iter()
            .filter(|option| !ONLY_RENDER.contains(option)),
    );
    expected_too.sort_unstable();
    assert_eq!(options_in(&animate), expected_too, "{animate}");
    for word in ["wave", "twist", "rebuild", "refit", "auto", "FILE.gif"] {
        assert!(animate.contains(word), "{word} is not in {animate}");
    }
    let info = folder.succeed(["info", "--help"]);
    assert_eq!(
        options_in(&info),
        [
            "--adapters",
            "--all",
            "--format",
            "--help",
            "--json",
            "--lenient"
        ],
        "{info}"
    );
    let build = folder.succeed(["build", "--help"]);
    let expected = [
        "--camera",
        "--codes",
        "--format",
        "--help",
        "--json",
        "--lenient",
        "--light",
        "--mesh",
        "--nodes",
        "--output",
        "--size",
        "--threads",
        "--tolerance",
        "--tree",
        "--up",
    ];
    assert_eq!(options_in(&build), expected, "{build}");
    for word in ["slimbvh.slim", "w4-48", "0.5px", "Examples:"] {
        assert!(build.contains(word), "{word} is not in {build}");
    }
    let top = folder.succeed(["--help"]);
    for command in ["render", "animate", "build", "info"] {
        assert!(top.contains(&format!("  {command} ")), "{top}");
    }
    assert_eq!(options_in(&top), ["--help", "--version"], "{top}");
    assert_eq!(
        folder.succeed(["--version"]),
        concat!("slimbvh ", env!("CARGO_PKG_VERSION"), "\n")
    );
    assert_eq!(folder.succeed(["help", "render"]), render);
}
