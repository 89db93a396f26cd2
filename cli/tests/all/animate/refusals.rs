//! `animate` answers bad input with exit code 2 and one sentence, and writes no file.

use super::folder;
use crate::files::{TwoTriangles, box_obj};
use crate::process::Folder;

/// Runs the binary, which must refuse with a sentence that contains every expected part, and leave the folder unchanged.
#[track_caller]
fn refuses(folder: &Folder, arguments: &[&str], expected: &[&str]) {
    let before = folder.contents();
    let arguments = [&["animate", "--size=16x9"], arguments].concat();
    let outcome = folder.run(&arguments);
    assert_eq!(
        (outcome.code, outcome.stdout.as_str()),
        (Some(2), ""),
        "{arguments:?}: {outcome:?}"
    );
    // Errors of the command line parser have more lines, which point to the help.
    let (sentence, rest) = outcome.stderr.split_once('\n').unwrap_or_default();
    println!("{sentence}");
    assert!(sentence.starts_with("error: "), "{outcome:?}");
    assert!(
        rest.is_empty() || rest.ends_with("try '--help'.\n"),
        "{outcome:?}"
    );
    for part in expected {
        assert!(
            outcome.stderr.contains(part),
            "{arguments:?}: {part:?} is not in {outcome:?}"
        );
    }
    assert!(before == folder.contents(), "{arguments:?}");
}

fn scenes() -> Folder {
    let folder = folder(&["frames"]);
    folder.write("box.obj", box_obj());
    folder.write("empty.obj", "v 0 0 0\n");
    folder.write("kept.gif", "an older animation");
    folder.write("frames/frame-0001.png", "an older frame");
    folder
}

#[test]
fn options_that_make_no_sense() {
    let folder = scenes();
    for (options, expected) in [
        (&["--orbit"][..], "--frames"),
        (&["--frames=0"], "--frames"),
        (&["--frames=-3"], "--frames"),
        (&["--frames=10000"], "9999"),
        (&["--frames=many"], "--frames"),
        (&["--frames=2", "--deform=melt"], "twist"),
        (&["--frames=2", "--update=never"], "refit"),
        (&["--frames=2", "--shutter=1.5"], "from 0 to 1"),
        (&["--frames=2", "--shutter=-0.5"], "from 0 to 1"),
        (&["--frames=2", "--shutter=nan"], "from 0 to 1"),
        (&["--frames=2", "--shutter-times=0"], "from 1 to 1024"),
        (&["--frames=2", "--fps=0"], "--fps"),
        (&["--frames=2", "--fps=51"], "--fps"),
        (&["--frames=2", "--out="], "--out"),
        (&["--frames=2", "--backend=cpu", "--adapter=x"], "--adapter"),
        (&["--frames=2", "--backend=gpu"], "there is no GPU"),
    ] {
        refuses(&folder, &[&["box.obj"], options].concat(), &[expected]);
    }
}

#[test]
fn frames_without_a_place() {
    let folder = scenes();
    for (out, expected) in [
        ("gone", "\"gone\" is neither an existing folder"),
        ("wave.png", "\"wave.png\" is neither"),
        ("box.obj", "\"box.obj\" is neither"),
        (".gif", "\".gif\" is neither"),
        ("gone/wave.gif", "no folder \"gone\""),
    ] {
        refuses(
            &folder,
            &["box.obj", "--frames=2", "--out", out],
            &[expected],
        );
        // The output path is checked before the scene is read.
        refuses(
            &folder,
            &["gone.obj", "--frames=2", "--out", out],
            &[expected],
        );
    }
    std::fs::create_dir(folder.path().join("frames/frame-0002.png")).unwrap();
    let options = ["box.obj", "--frames=3", "--out=frames"];
    refuses(&folder, &options, &["frame-0002.png\" is a folder"]);
    let wide = ["box.obj", "--frames=2", "--out=w.gif"];
    // A side of a GIF has at most 65535 pixels.
    let arguments = [&wide[..], &["--json=frames/j.json"]].concat();
    let outcome = folder.run([&["animate", "--size=65536x1"], &arguments[..]].concat());
    assert!(outcome.stderr.contains("65535"), "{outcome:?}");
}

#[test]
fn reports_in_the_place_of_something_else() {
    let folder = scenes();
    for (out, json) in [
        ("frames", "frames/frame-0001.png"),
        ("kept.gif", "./kept.gif"),
        ("kept.gif", "box.obj"),
        ("kept.gif", "gone/report.json"),
    ] {
        let options = ["box.obj", "--frames=2", "--out", out, "--json", json];
        refuses(&folder, &options, &["\""]);
    }
}

#[test]
fn scenes_that_cannot_be_seen() {
    let folder = scenes();
    for out in ["frames", "kept.gif"] {
        let refuses = |options: &[&str], expected: &[&str]| {
            let common = ["--frames=3", "--orbit", "--out", out];
            refuses(&folder, &[&common[..], options].concat(), expected);
        };
        refuses(&["gone.obj"], &["gone.obj"]);
        refuses(&["empty.obj", "--deform=wave"], &["empty.obj"]);
        refuses(&["box.obj", "--camera=eye=1,1,1 target=1,1,1"], &["camera"]);
        refuses(&["box.obj", "--camera=fov=180"], &["180"]);
        refuses(&["box.obj", "--light=sun=0,0,0"], &["light 1"]);
    }
    let broken = TwoTriangles::with_coordinate(f32::NAN);
    folder.write("broken.ply", broken.ply_binary());
    let options = ["broken.ply", "--frames=2", "--out=frames"];
    refuses(&folder, &options, &["face 1"]);
    folder.succeed([&["animate", "--size=16x9", "--lenient"], &options[..]].concat());
}
