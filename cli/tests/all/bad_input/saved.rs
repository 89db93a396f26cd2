//! Saved hierarchies that are damaged, of another format, or do not match the options.

use super::{folder, refuses, refuses_scene, refuses_usage};
use crate::process::Folder;

/// A folder with a saved hierarchy, and the bytes of that file.
fn saved() -> (Folder, Vec<u8>) {
    let folder = folder();
    folder.succeed(["build", "sound.obj", "-o", "sound.slim", "--nodes", "q10"]);
    let bytes = folder.read("sound.slim");
    (folder, bytes)
}

#[test]
fn damaged_files() {
    let (folder, sound) = saved();
    for at in [17, 21, 70, 481, 515, 777, sound.len() / 2, sound.len() - 1] {
        let mut bytes = sound.clone();
        bytes[at] ^= 0x10;
        folder.write("bad.slim", bytes);
        refuses_scene(
            &folder,
            &["bad.slim"],
            &["\"bad.slim\"", "is damaged", "copy or build it again"],
        );
    }
    for length in [1, 8, 63, 64, 479, 480, 481, 1024, sound.len() - 1] {
        folder.write("bad.slim", &sound[..length]);
        refuses_scene(&folder, &["bad.slim"], &["\"bad.slim\"", "ends"]);
    }
    folder.write("bad.slim", [&sound[..], b"\n"].concat());
    refuses_scene(&folder, &["bad.slim"], &["continues past its end"]);
    // Text tools drop carriage returns.
    let spoilt: Vec<u8> = sound
        .iter()
        .copied()
        .filter(|&byte| byte != b'\r')
        .collect();
    folder.write("bad.slim", spoilt);
    refuses_scene(&folder, &["bad.slim"], &["is not a slim file"]);
}

/// A hierarchy alone has no scene to describe or render.
#[test]
fn hierarchies_without_their_scene() {
    let folder = folder();
    let mesh = slimbvh::generate::terrain(1.0, 4, 1);
    let bvh = slimbvh::Builder::default().build(&mesh).unwrap();
    let mut bytes = Vec::new();
    slimbvh::scene::slim::write_hierarchy(&bvh, &mut bytes).unwrap();
    folder.write("alone.slim", bytes);
    refuses_scene(
        &folder,
        &["alone.slim"],
        &[
            "\"alone.slim\"",
            "holds a hierarchy without its scene",
            "slim::read_hierarchy",
            "slimbvh build",
        ],
    );
}

#[test]
fn foreign_files() {
    let (folder, sound) = saved();
    folder.succeed(["render", "sound.obj", "--size", "16x9", "-o", "picture.png"]);
    for (name, bytes) in [
        ("picture.slim", folder.read("picture.png")),
        ("text.slim", folder.read("sound.obj")),
        ("empty.slim", Vec::new()),
    ] {
        folder.write(name, bytes);
        let expected = match name {
            "empty.slim" => "ends within its header",
            _ => "is not a slim file: it begins with",
        };
        refuses_scene(&folder, &[name], &[&format!("\"{name}\""), expected]);
    }
    let with = |at: usize, words: &[u8]| {
        let mut bytes = sound.clone();
        bytes[at..at + words.len()].copy_from_slice(words);
        folder.write("other.slim", bytes);
    };
    with(12, &1u32.to_le_bytes());
    refuses_scene(&folder, &["other.slim"], &["version 1", "reads version 2"]);
    with(12, &u32::MAX.to_le_bytes());
    refuses_scene(&folder, &["other.slim"], &["version 4294967295"]);
    with(8, &[1, 2, 3, 4]);
    refuses_scene(&folder, &["other.slim"], &["big-endian"]);
    // A slim file with the extension of another format.
    folder.write("sound.ply", &sound);
    refuses_scene(&folder, &["sound.ply"], &["\"sound.ply\""]);
}

#[test]
fn other_trees_than_the_file_has() {
    let (folder, _) = saved();
    for (options, expected) in [
        (&["--nodes", "f32"][..], &["--nodes", "q10"][..]),
        (&["--nodes", "q12"], &["--nodes", "q10"]),
        (
            &["--mesh", "leaf10", "--nodes", "paper10"],
            &["--nodes", "q10"],
        ),
        (&["--mesh", "lattice", "--nodes", "q10"], &["--mesh", "f32"]),
        (&["--tolerance", "0.1px"], &["--tolerance", "built already"]),
        (&["--codes", "30"], &["--codes", "built already"]),
        (&["--codes", "63"], &["--codes", "built already"]),
        (&["--reduce", "on"], &["--reduce on", "one tree"]),
        (&["--cull", "on"], &["--cull on", "one tree"]),
    ] {
        for output in ["new.png", "kept.png"] {
            let render = ["render", "sound.slim", "-o", output];
            let expected = [&["\"sound.slim\""], expected].concat();
            refuses(&folder, &[&render, options].concat(), &expected);
        }
    }
}

/// `render` traces a saved hierarchy on the requested GPU, or fails.
#[test]
fn gpus_that_are_not_there() {
    let (folder, _) = saved();
    for output in ["new.png", "kept.png"] {
        let render = ["render", "sound.slim", "-o", output];
        for options in [&["--backend", "gpu"][..], &["--adapter", "no such GPU"]] {
            refuses(&folder, &[&render, options].concat(), &["GPU"]);
        }
        let both = ["--adapter", "x", "--backend", "cpu"];
        let expected = ["--adapter", "leave one out"];
        refuses(&folder, &[&render[..], &both].concat(), &expected);
    }
}

#[test]
fn builds_that_cannot_be() {
    let folder = folder();
    folder.write("kept.slim", "an older file");
    for output in ["new.slim", "kept.slim"] {
        let build = ["build", "sound.obj", "-o", output];
        for (options, expected) in [
            (
                &["--mesh", "lattice", "--nodes", "f32"][..],
                "--nodes w4-64, w4-48",
            ),
            (&["--mesh", "f32", "--tolerance", "1"], "--mesh lattice"),
            (&["--camera", "fov=0"], "angle of view"),
            (&["--light", "sun=0,0,0"], "light 1 has no direction"),
            (&["--json", output], "another use"),
        ] {
            refuses(&folder, &[&build, options].concat(), &[expected]);
        }
        refuses(
            &folder,
            &["build", "gone.obj", "-o", output],
            &["\"gone.obj\""],
        );
        refuses(
            &folder,
            &["build", "kept.slim", "-o", output],
            &["kept.slim"],
        );
    }
    for (output, expected) in [
        ("new.png", "\"new.png\" does not end in .slim"),
        ("new", "\"new\" does not end in .slim"),
        ("no folder/new.slim", "\"no folder\""),
    ] {
        refuses(&folder, &["build", "sound.obj", "-o", output], &[expected]);
    }
    for (options, expected) in [
        (["--view", "depth"], "--view"),
        (["--backend", "cpu"], "--backend"),
        (["--nodes", "q11"], "--nodes"),
    ] {
        let build = ["build", "sound.obj", "-o", "new.slim"];
        refuses_usage(&folder, &[&build, &options[..]].concat(), &[expected]);
    }
}

/// A full disk is an error, and no half-written file remains.
#[cfg(target_os = "linux")]
#[test]
fn disks_that_are_full() {
    use std::process::Command;
    let folder = folder();
    folder.write("kept.slim", "an older file");
    let before = folder.contents();
    // Limit the size of files to one block.
    let binary = env!("CARGO_BIN_EXE_slimbvh");
    for output in ["new.slim", "kept.slim"] {
        let mut command = Command::new("sh");
        let limited = "trap '' XFSZ; ulimit -f 1; exec \"$@\"";
        command.args([
            "-c",
            limited,
            "sh",
            binary,
            "build",
            "sound.obj",
            "-o",
            output,
        ]);
        let done = command.current_dir(folder.path()).output().unwrap();
        let stderr = String::from_utf8(done.stderr).unwrap();
        assert_eq!(done.status.code(), Some(2), "{stderr}");
        assert!(
            stderr.contains(&format!("cannot write {output:?}")),
            "{stderr}"
        );
        assert_eq!(stderr.lines().count(), 1, "{stderr}");
        assert!(folder.contents() == before);
    }
}
