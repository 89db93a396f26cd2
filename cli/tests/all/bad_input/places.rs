//! Pictures and reports that cannot be written.

use super::{folder, refuses};

#[test]
fn pictures_without_a_place() {
    let folder = folder();
    std::fs::create_dir(folder.path().join("folder.png")).unwrap();
    for (output, expected) in [
        ("no folder/new.png", "\"no folder\""),
        ("sound.obj/new.png", "\"sound.obj\""),
        ("folder.png", "\"folder.png\" is a folder"),
        ("new.jpg", "\"new.jpg\" does not end in .png"),
        ("new", "\"new\" does not end in .png"),
        (".png", "\".png\" does not end in .png"),
        ("png", "\"png\" does not end in .png"),
        ("folder.png/", "\"folder.png/\" is a folder"),
        ("two\nlines/new.png", "lines"),
    ] {
        refuses(&folder, &["render", "sound.obj", "-o", output], &[expected]);
    }
}

/// The path of the picture is checked before the scene is read.
#[test]
fn the_place_is_looked_at_before_the_scene() {
    let folder = folder();
    refuses(
        &folder,
        &["render", "gone.obj", "-o", "no folder/new.png"],
        &["\"no folder\""],
    );
}

#[cfg(target_os = "linux")]
#[test]
fn folders_that_take_no_files() {
    let folder = folder();
    // Not even the superuser may write there.
    refuses(
        &folder,
        &["render", "sound.obj", "-o", "/proc/new.png"],
        &["\"/proc/new.png\""],
    );
    let arguments = [
        "render",
        "sound.obj",
        "-o",
        "new.png",
        "--json",
        "/proc/new.json",
    ];
    refuses(&folder, &arguments, &["\"/proc/new.json\""]);
}

#[test]
fn reports_without_a_place() {
    let folder = folder();
    std::fs::create_dir(folder.path().join("folder")).unwrap();
    for (json, expected) in [
        ("no folder/new.json", "no folder"),
        ("folder", "\"folder\""),
    ] {
        refuses(&folder, &["info", "sound.obj", "--json", json], &[expected]);
        let arguments = ["render", "sound.obj", "-o", "new.png", "--json", json];
        refuses(&folder, &arguments, &[expected]);
    }
}

/// The report may replace neither the picture nor the scene.
#[test]
fn reports_in_the_place_of_something_else() {
    let folder = folder();
    let both = ["render", "sound.obj", "-o", "new.png", "--json", "new.png"];
    refuses(&folder, &both, &["\"new.png\""]);
    let render = [
        "render",
        "sound.obj",
        "-o",
        "new.png",
        "--json",
        "sound.obj",
    ];
    refuses(&folder, &render, &["\"sound.obj\""]);
    refuses(
        &folder,
        &["info", "sound.obj", "--json", "sound.obj"],
        &["\"sound.obj\""],
    );
}

#[cfg(target_os = "linux")]
#[test]
fn standard_output_that_is_full() {
    use std::process::Stdio;
    let folder = folder();
    for arguments in [
        &["info", "sound.obj"][..],
        &["info", "sound.obj", "--json", "-"],
    ] {
        let full = std::fs::File::create("/dev/full").unwrap();
        let mut command = crate::process::command();
        command.args(arguments).current_dir(folder.path());
        let output = command
            .stdout(full)
            .stderr(Stdio::piped())
            .output()
            .unwrap();
        let stderr = String::from_utf8(output.stderr).unwrap();
        println!("{arguments:?} {stderr}");
        assert_eq!(output.status.code(), Some(2));
        assert!(
            stderr.starts_with("error: ") && stderr.contains("standard output"),
            "{stderr}"
        );
        assert_eq!(stderr.lines().count(), 1, "{stderr}");
    }
}

#[test]
fn one_file_under_two_names() {
    let folder = folder();
    let arguments = [
        "render",
        "sound.obj",
        "-o",
        "new.png",
        "--json",
        "./new.png",
    ];
    refuses(&folder, &arguments, &["\"./new.png\" has another use"]);
}

/// Without a name of its own, the report would replace the scene, and tell of the built-in one.
#[test]
fn a_scene_in_place_of_a_report() {
    let folder = folder();
    let before = std::fs::read(folder.path().join("sound.obj")).unwrap();
    for command in ["info", "render", "build"] {
        let said = ["--json writes a report, and \"sound.obj\" is named as a scene"];
        refuses(&folder, &[command, "--json", "sound.obj"], &said);
    }
    assert_eq!(
        std::fs::read(folder.path().join("sound.obj")).unwrap(),
        before
    );
}

/// A pipe is written to, not replaced by a file.
#[cfg(unix)]
#[test]
fn pipes_stay_pipes() {
    use std::os::unix::fs::FileTypeExt;
    use std::process::{Command, Stdio};

    let folder = folder();
    let pipe = folder.path().join("pipe");
    let made = Command::new("mkfifo").arg(&pipe).status().unwrap();
    assert!(made.success());
    let reader = Command::new("cat")
        .arg(&pipe)
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    folder.succeed(["info", "sound.obj", "--json", "pipe"]);
    let read = reader.wait_with_output().unwrap().stdout;
    assert!(serde_json::from_slice::<serde_json::Value>(&read).is_ok());
    assert!(std::fs::metadata(&pipe).unwrap().file_type().is_fifo());
}
