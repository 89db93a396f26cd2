//! Invalid options.

use super::{folder, refuses, refuses_usage};
use crate::refusal::refusal;

/// A new picture, and one that already exists.
const OUTPUTS: [&str; 2] = ["new.png", "kept.png"];

#[test]
fn pictures_of_impossible_size() {
    let folder = folder();
    for size in [
        "0x0",
        "0x90",
        "160x0",
        "5x",
        "x5",
        "5",
        "x",
        "",
        "-5x5",
        "5x5x5",
        "1e3x4",
        "axb",
        "99999999999x1",
    ] {
        for output in OUTPUTS {
            let size = format!("--size={size}");
            refuses_usage(
                &folder,
                &["render", "sound.obj", "-o", output, &size],
                &["--size", "WIDTHxHEIGHT"],
            );
        }
    }
}

/// A file in place of a command: the message names the command that renders it. Another word has no such tip.
#[test]
fn files_in_place_of_commands() {
    let folder = folder();
    folder.write("bare", "");
    for name in ["sound.obj", "gone.glb", "bare"] {
        let tip = format!("tip: to render this file: slimbvh render {name}");
        refuses_usage(&folder, &[name], &["unrecognized subcommand", &tip]);
    }
    let other = refusal(&folder, &["rende"]);
    assert!(
        other.contains("'render'") && !other.contains("this file"),
        "{other}"
    );
}

/// Sizes that parse as numbers but exceed any memory.
#[test]
fn pictures_of_absurd_size() {
    let folder = folder();
    for size in [
        "65536x65536",
        "65535x65535",
        "65536x16384",
        "4294967295x4294967295",
    ] {
        let arguments = ["render", "sound.obj", "-o", "new.png", "--size", size];
        let stderr = refusal(&folder, &arguments);
        assert!(
            stderr.starts_with("error: ") && stderr.len() < 400,
            "{stderr}"
        );
        assert!(stderr.contains(size), "{stderr}");
    }
}

#[test]
fn counts_out_of_range() {
    let folder = folder();
    let render = |option: &str| ["render", "sound.obj", "-o", "new.png", option].map(String::from);
    for (option, numbers) in [
        (
            "--spp",
            &["0", "-1", "1.5", "many", "", "65537", "99999999999"][..],
        ),
        ("--mirror-depth", &["-1", "65", "deep"]),
        (
            "--threads",
            &["-1", "two", "0", "1025", "99999999999999999999"],
        ),
    ] {
        for number in numbers {
            let arguments = render(&format!("{option}={number}"));
            let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
            refuses_usage(&folder, &arguments, &[option]);
        }
    }
    let most = [
        "render",
        "sound.obj",
        "-o",
        "new.png",
        "--size",
        "65536x2",
        "--spp",
        "65536",
    ];
    refuses(&folder, &most, &["65536x2", "65536 samples", "4294967295"]);
}

#[test]
fn cameras_that_see_nothing() {
    let folder = folder();
    for (camera, expected) in [
        ("eye=1,2,3 target=1,2,3", ["look-at point", "(1, 2, 3)"]),
        ("fov=0", ["angle of view", "0 degrees"]),
        ("fov=-10", ["angle of view", "-10 degrees"]),
        ("fov=180", ["angle of view", "180 degrees"]),
        ("fov=1e9", ["angle of view", "1000000000 degrees"]),
        ("height=0", ["height", "0 high"]),
        ("height=-2", ["height", "-2 high"]),
        ("lens=-1", ["radius -1", "0 or more"]),
        ("lens=1 focus=0", ["distance 0", "above 0"]),
        ("lens=1 focus=-2", ["distance -2", "above 0"]),
        ("lens=3e38 focus=1e-30", ["radius", "above 0"]),
    ] {
        for scene in ["sound.obj", ""] {
            let scene = if scene.is_empty() { &[][..] } else { &[scene] };
            for output in OUTPUTS {
                let options = ["render", "-o", output, "--camera", camera];
                refuses(&folder, &[&options, scene].concat(), &expected);
            }
        }
    }
    for camera in [
        "eye=1,nan,3",
        "eye=inf,0,0",
        "target=0,0,1e99",
        "fov=nan",
        "fov=",
        "eye=1,2",
        "eye=1,2,3,4",
        "eye 1,2,3",
        "nose=1,2,3",
        "eye=1, 2, 3",
        "focus=2",
        "lens=",
        "lens=0.1 height=2",
    ] {
        refuses_usage(
            &folder,
            &["render", "sound.obj", "-o", "new.png", "--camera", camera],
            &["--camera"],
        );
    }
}

#[test]
fn lights_that_do_not_shine() {
    let folder = folder();
    for (light, expected) in [
        ("sun=0,0,0", "direction"),
        ("sun=0,-1,0 color=-1,0,0", "color"),
        ("point=0,1,0 color=0,0,-1e-30", "color"),
        ("point=0,1,0 range=0", "range"),
        ("point=0,1,0 range=-3", "range"),
        ("disc=0,1,0 normal=0,0,0 radius=1", "no area"),
        ("disc=0,1,0 normal=0,1,0 radius=1 range=0", "range"),
        ("disc=0,1,0 normal=0,1,0 radius=1 color=-1,1,1", "color"),
        ("rectangle=0,1,0 edge1=1,0,0 edge2=-2,0,0", "no area"),
        ("rectangle=0,1,0 edge1=0,0,0 edge2=0,0,1", "no area"),
    ] {
        for output in OUTPUTS {
            // The second light is invalid.
            let lights = ["--light", "sun=0,-1,0", "--light", light];
            let arguments = [&["render", "sound.obj", "-o", output], &lights[..]].concat();
            refuses(&folder, &arguments, &["light 2", expected]);
        }
    }
    for light in [
        "",
        "color=1,1,1",
        "sun=0,-1",
        "sun=0,nan,0",
        "point=inf,0,0",
        "sun=0,1,0 point=0,1,0",
        "sun=0,1,0 range=2",
        "sun=0,1,0 colour=1,1,1",
        "lamp",
        "disc=0,1,0",
        "disc=0,1,0 normal=0,1,0 radius=0",
        "rectangle=0,1,0 edge1=1,0,0",
        "rectangle=0,1,0 edge1=1,0,0 edge2=0,0,inf",
        "point=0,1,0 radius=1",
    ] {
        refuses_usage(
            &folder,
            &["render", "sound.obj", "-o", "new.png", "--light", light],
            &["--light"],
        );
    }
}

#[test]
fn words_that_mean_nothing() {
    let folder = folder();
    for (arguments, expected) in [
        (&["paint"][..], "'paint'"),
        (&["--paint"], "'--paint'"),
        (
            &["render", "sound.obj", "-o", "new.png", "--paint"],
            "'--paint'",
        ),
        (&["info", "sound.obj", "--size", "4x4"], "'--size'"),
        (
            &["render", "sound.obj", "-o", "new.png", "other.obj"],
            "'other.obj'",
        ),
        (&["render", "-o"], "--output"),
        (&["render", "sound.obj", "-o", ""], "--output"),
        (&["render", ""], "[SCENE]"),
        (&["info", ""], "[SCENE]"),
        (&["info", "--json", ""], "--json"),
        (
            &["render", "-o", "new.png", "--view", "smell"],
            "primitives",
        ),
        (&["render", "-o", "new.png", "--backend", "abacus"], "cpu"),
        (&["render", "-o", "new.png", "--codes", "31"], "63"),
        (
            &["render", "-o", "new.png", "--size", "4x4", "--size", "5x5"],
            "--size",
        ),
    ] {
        refuses_usage(&folder, arguments, &[expected]);
    }
    // Without arguments the binary prints its help.
    let help = refusal(&folder, &[]);
    assert!(help.contains("Usage: slimbvh <COMMAND>"), "{help}");
}

#[cfg(feature = "gpu")]
#[test]
fn a_gpu_on_a_machine_without_one() {
    let folder = folder();
    for output in OUTPUTS {
        let arguments = ["render", "sound.obj", "-o", output, "--backend", "gpu"];
        refuses(&folder, &arguments, &["there is no GPU", "use the CPU"]);
        let arguments = ["render", "sound.obj", "-o", output, "--adapter", "nothing"];
        refuses(&folder, &arguments, &["there is no GPU", "use the CPU"]);
    }
}

#[cfg(feature = "gpu")]
#[test]
fn a_gpu_for_the_cpu() {
    let folder = folder();
    let arguments = ["render", "sound.obj", "--backend=cpu", "--adapter=llvm"];
    refuses(
        &folder,
        &arguments,
        &["--adapter \"llvm\"", "--backend cpu"],
    );
}

#[cfg(feature = "gpu")]
#[test]
fn adapters_of_a_scene() {
    let folder = folder();
    let arguments = ["info", "sound.obj", "--adapters"];
    refuses_usage(&folder, &arguments, &["--adapters", "cannot be used with"]);
}

#[test]
fn codecs_that_do_not_go_together() {
    let folder = folder();
    for (options, expected) in [
        (
            &["--mesh=leaf10", "--nodes=q10"][..],
            &["--mesh leaf10", "--nodes paper10"][..],
        ),
        (
            &["--mesh=leaf10", "--nodes=f32"],
            &["--mesh leaf10", "--nodes paper10"],
        ),
        (
            &["--mesh=lattice", "--nodes=f32"],
            &["--mesh lattice", "--nodes w4-64, w4-48"],
        ),
        (
            &["--mesh=lattice", "--nodes=w4"],
            &["w4 nodes", "triangles in full", "w4-64, w4-48"],
        ),
        (
            &["--mesh=f32", "--nodes=w4-48"],
            &["w4-48 nodes require triangles on a lattice", "w4, w4-64"],
        ),
        (&["--nodes=w4-48"], &["--mesh f32", "w4-64"]),
        (
            &["--tolerance=1", "--nodes=paper10"],
            &["--mesh lattice", "--nodes w4-64, w4-48"],
        ),
        (
            &["--tolerance=1", "--mesh=f32"],
            &["--tolerance", "--mesh lattice"],
        ),
        (
            &["--mesh=leaf10", "--reduce=on"],
            &["--mesh leaf10", "--reduce on"],
        ),
        (
            &["--mesh=leaf10", "--cull=on"],
            &["--mesh leaf10", "--cull on"],
        ),
    ] {
        for output in OUTPUTS {
            let arguments = [&["render", "sound.obj", "-o", output], options].concat();
            refuses(&folder, &arguments, expected);
        }
        let animate = [&["animate", "sound.obj", "--frames=2"], options].concat();
        refuses(&folder, &animate, expected);
    }
    for tolerance in ["0", "-1", "px", "1pt", "nan", "inf", ""] {
        let option = format!("--tolerance={tolerance}");
        let arguments = ["render", "sound.obj", "-o", "new.png", &option];
        refuses_usage(&folder, &arguments, &["--tolerance", "0.5px"]);
    }
}
