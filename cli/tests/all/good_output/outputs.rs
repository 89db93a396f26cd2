//! Files and streams.

use super::{SMALL, decode, parse};
use crate::files::box_obj;
use crate::process::{Folder, command};
use std::process::Stdio;

#[test]
fn reports_go_where_they_are_asked_to() {
    let folder = Folder::new();
    let text = folder.succeed([&SMALL[..], &["report.json"]].concat());
    let report = parse(&String::from_utf8(folder.read("report.json")).unwrap());
    assert!(
        text.contains("160x90") && text.contains("121,") && !text.contains('{'),
        "{text}"
    );
    assert_eq!(report["picture"], "slimbvh.png");
    assert_eq!(folder.contents().len(), 2, "{:?}", folder.contents().keys());
    let text = folder.succeed(["info", "--json", "info.json"]);
    let info = parse(&String::from_utf8(folder.read("info.json")).unwrap());
    assert!(text.contains("closed") && !text.contains('{'), "{text}");
    assert_eq!(info["triangles"], report["triangles"]);
    // Writing again replaces the files.
    folder.succeed(["info", "--json", "info.json"]);
    folder.succeed([&SMALL[..], &["report.json"]].concat());
    assert_eq!(folder.contents().len(), 3, "{:?}", folder.contents().keys());
}

#[test]
fn any_number_of_threads_makes_the_same_picture() {
    let folder = Folder::new();
    for options in [
        &["--spp", "3"][..],
        &["--view", "heatmap"],
        &["--view", "depth", "--codes", "63"],
    ] {
        let pictures = ["1", "2", "3", "7", "3"].map(|threads| {
            folder.succeed([&SMALL[..], &["-", "--threads", threads], options].concat());
            folder.read("slimbvh.png")
        });
        assert!(
            pictures.iter().all(|picture| *picture == pictures[0]),
            "{options:?}"
        );
    }
}

#[test]
fn a_reader_that_goes_away_is_no_failure() {
    let folder = Folder::new();
    for arguments in [
        &["render", "--size", "160x90"][..],
        &["render", "--size", "160x90", "--json", "-"],
        &["info"],
        &["info", "--json", "-"],
        &["--help"],
        &["render", "--help"],
        &["--version"],
    ] {
        let mut command = command();
        command.args(arguments).current_dir(folder.path());
        let mut child = command
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        drop(child.stdout.take());
        let output = child.wait_with_output().unwrap();
        let stderr = String::from_utf8(output.stderr).unwrap();
        assert_eq!(
            (output.status.code(), stderr.as_str()),
            (Some(0), ""),
            "{arguments:?}"
        );
    }
    // The picture was written nevertheless.
    assert_eq!(decode(&folder.read("slimbvh.png")).0, [160, 90]);
}

/// The name of a picture may be as long as the system allows.
#[test]
fn long_names() {
    let folder = Folder::new();
    folder.write("box.obj", box_obj());
    let name = format!("{}.png", "n".repeat(251));
    folder.succeed(["render", "box.obj", "--size", "16x9", "-o", &name]);
    assert_eq!(decode(&folder.read(name)).0, [16, 9]);
}

/// A new picture replaces an older one whole.
#[test]
fn pictures_replace_pictures() {
    let folder = Folder::new();
    folder.write("box.obj", box_obj());
    folder.write("box.png", vec![1; 1 << 20]);
    folder.succeed(["render", "box.obj", "--size", "16x9", "-o", "box.png"]);
    assert_eq!(decode(&folder.read("box.png")).0, [16, 9]);
    assert_eq!(folder.contents().len(), 2);
}
