//! Ctrl-C: every output file is whole, or as it was before.

use crate::process::Folder;
use std::io::Cursor;
use std::os::unix::process::ExitStatusExt;
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

const SIGINT: i32 = 2;
const PATIENCE: Duration = Duration::from_secs(60);

/// Starts the binary with the default action for SIGINT, as a background shell may have made it ignore the signal.
fn start(folder: &Folder, arguments: &str) -> Child {
    let mut command = Command::new("env");
    command.args(["--default-signal=INT", env!("CARGO_BIN_EXE_slimbvh")]);
    command
        .args(arguments.split(' '))
        .current_dir(folder.path());
    command.env("RAYON_NUM_THREADS", "2");
    let [none, out, err] = [Stdio::null(), Stdio::null(), Stdio::null()];
    let spawned = command.stdin(none).stdout(out).stderr(err).spawn();
    spawned.expect("the binary was built")
}

/// Sends SIGINT and waits for the end. Returns the signal that ended the binary.
fn interrupt(mut child: Child) -> Option<i32> {
    let id = child.id().to_string();
    let sent = Command::new("kill").args(["-INT", &id]).status();
    assert!(sent.is_ok_and(|status| status.success()));
    let begin = Instant::now();
    while begin.elapsed() < PATIENCE {
        if let Some(status) = child.try_wait().expect("the child is ours") {
            return status.signal();
        }
        std::thread::sleep(Duration::from_millis(5));
    }
    let _ = child.kill();
    panic!("the binary still runs {PATIENCE:?} after the signal");
}

/// The PNG files in a folder, and all other entries.
fn entries(folder: &Folder) -> (Vec<PathBuf>, Vec<PathBuf>) {
    let entries = std::fs::read_dir(folder.path()).expect("the folder is ours");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    paths.partition(|path| path.extension().is_some_and(|extension| extension == "png"))
}

fn assert_whole(path: &PathBuf) {
    let bytes = std::fs::read(path).expect("the folder is ours");
    let mut reader = png::Decoder::new(Cursor::new(bytes))
        .read_info()
        .expect("a header");
    let mut pixels = vec![0; reader.output_buffer_size().expect("a small picture")];
    let frame = reader.next_frame(&mut pixels).and_then(|_| reader.finish());
    assert!(frame.is_ok(), "{}: {frame:?}", path.display());
}

#[test]
fn a_picture_that_is_not_finished_leaves_the_old_one() {
    let folder = Folder::new();
    folder.write("picture.png", "the old one");
    let before = folder.contents();
    let child = start(
        &folder,
        "render --backend cpu --size 4096x4096 --spp 64 -o picture.png",
    );
    // After one second the render has begun and is far from done.
    std::thread::sleep(Duration::from_secs(1));
    assert_eq!(interrupt(child), Some(SIGINT));
    assert_eq!(folder.contents(), before);
}

#[test]
fn frames_before_the_signal_are_whole() {
    for enough in [1, 4, 9, 16] {
        let folder = Folder::new();
        let child = start(
            &folder,
            "animate --backend cpu --frames 500 --size 256x256 --out .",
        );
        let begin = Instant::now();
        while entries(&folder).0.len() < enough {
            assert!(begin.elapsed() < PATIENCE, "there are no frames");
        }
        let part = format!(".slimbvh-{}.part", child.id());
        assert_eq!(interrupt(child), Some(SIGINT));
        let (pictures, others) = entries(&folder);
        assert!(pictures.len() >= enough);
        pictures.iter().for_each(assert_whole);
        // An unfinished frame has not been renamed to its final name.
        assert!(others.len() <= 1);
        assert!(
            others.iter().all(|path| path.ends_with(&part)),
            "{others:?}"
        );
    }
}
