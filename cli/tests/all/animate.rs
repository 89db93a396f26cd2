//! The command `animate`.

#[cfg(feature = "gpu")]
mod on_gpu;
mod refusals;

use crate::process::Folder;
use serde_json::Value;

/// Arguments of an animation of small pictures.
const SMALL: [&str; 3] = ["animate", "--size", "64x36"];

/// Runs an animation and parses its report.
fn report(folder: &Folder, options: &[&str]) -> Value {
    let text = folder.succeed([&SMALL[..], options, &["--json=-"]].concat());
    serde_json::from_str(&text).expect("it is JSON")
}

/// A temporary folder with these subfolders.
fn folder(names: &[&str]) -> Folder {
    let folder = Folder::new();
    for name in names {
        std::fs::create_dir(folder.path().join(name)).expect("the folder is ours");
    }
    folder
}

/// The PNG frames of a folder, in order. Fails if the folder holds anything else.
fn frames(folder: &Folder, name: &str, count: usize) -> Vec<Vec<u8>> {
    let entries = std::fs::read_dir(folder.path().join(name)).expect("the folder is ours");
    let mut names: Vec<String> = entries
        .map(|entry| {
            let name = entry.expect("the folder is ours").file_name();
            name.into_string().expect("names are plain")
        })
        .collect();
    names.sort_unstable();
    let expected: Vec<String> = (0..count).map(|i| format!("frame-{i:04}.png")).collect();
    assert_eq!(names, expected);
    let read = |frame: &String| folder.read(format!("{name}/{frame}"));
    expected.iter().map(read).collect()
}

fn actions(report: &Value) -> Vec<&str> {
    let frames = report["frames"].as_array().expect("it is a list");
    let action = |frame: &Value| match frame["tree"].as_str() {
        Some("rebuilt") => "rebuilt",
        Some("refitted") => "refitted",
        Some("kept") => "kept",
        other => panic!("{other:?}"),
    };
    frames.iter().map(action).collect()
}

#[test]
fn the_answer_does_not_depend_on_the_tree() {
    let folder = folder(&["rebuild", "refit", "auto"]);
    for deform in ["wave", "twist"] {
        let common = ["--frames=5", "--orbit", "--deform", deform, "--spp=2"];
        let pictures = ["rebuild", "refit", "auto"].map(|update| {
            let options = ["--update", update, "--out", update];
            let report = report(&folder, &[&common[..], &options].concat());
            let rest = if update == "rebuild" {
                "rebuilt"
            } else {
                "refitted"
            };
            assert_eq!(actions(&report), ["rebuilt", rest, rest, rest, rest]);
            frames(&folder, update, 5)
        });
        assert_eq!(pictures[0], pictures[1], "{deform}");
        assert_eq!(pictures[0], pictures[2], "{deform}");
        // Negative control: the frames differ from each other.
        for (i, picture) in pictures[0].iter().enumerate() {
            assert!(!pictures[0][..i].contains(picture), "{deform}: {i}");
        }
    }
}

#[test]
fn a_static_scene_is_built_once() {
    let folder = Folder::new();
    for options in [&["--orbit"][..], &["--orbit-light"], &[]] {
        let report = report(&folder, &[&["--frames=4"], options].concat());
        assert_eq!(actions(&report), ["rebuilt", "kept", "kept", "kept"]);
        let kept = &report["frames"][3];
        assert_eq!(kept["build_ms"], serde_json::json!({}));
        assert_eq!(kept["sah_cost"], report["frames"][0]["sah_cost"]);
        assert_eq!(report["totals"]["rebuilt"], 1);
    }
    let report = report(&folder, &["--frames=2", "--update=rebuild"]);
    assert_eq!(actions(&report), ["rebuilt", "rebuilt"]);
    assert!(folder.contents().is_empty(), "no output was requested");
}

/// The first frame equals the picture of `render`, and a round of four frames contains the frames of a round of two.
#[test]
fn rounds_begin_alike_and_pass_through_the_same_places() {
    let folder = folder(&["two", "four"]);
    folder.succeed(["render", "--size=64x36", "-o", "still.png"]);
    for options in [
        &["--orbit"][..],
        &["--orbit", "--orbit-light", "--deform=twist"],
    ] {
        for (count, name) in [("2", "two"), ("4", "four")] {
            folder.succeed([&SMALL[..], &["--frames", count, "--out", name], options].concat());
        }
        let (two, four) = (frames(&folder, "two", 2), frames(&folder, "four", 4));
        assert_eq!([&two[0], &two[1]], [&four[0], &four[2]]);
        assert_eq!(two[0], folder.read("still.png"));
        assert!(two[0] != two[1] && four[1] != four[3]);
    }
}

/// A light from `--light` stays in place. The default light stands beside the camera and moves with it.
#[test]
fn the_given_light_goes_with_the_camera() {
    let folder = folder(&["both", "orbit", "fixed"]);
    folder.write("box.obj", crate::files::box_obj());
    let run = |name: &str, options: &[&str]| {
        let common = ["box.obj", "--frames=2", "--orbit", "--out", name];
        folder.succeed([&SMALL[..], &common, options].concat());
        frames(&folder, name, 2)
    };
    let orbit = run("orbit", &[]);
    assert_eq!(orbit, run("both", &["--orbit-light"]));
    let fixed = run("fixed", &["--light", "sun=-0.3,-1,-0.8"]);
    let both = run("both", &["--orbit-light", "--light", "sun=-0.3,-1,-0.8"]);
    assert!(fixed[0] == both[0] && fixed[1] != both[1]);
}

#[test]
fn a_gif_has_every_frame_and_loops() {
    let folder = Folder::new();
    let options = ["--frames=6", "--deform=wave", "--fps=25", "--out=wave.gif"];
    let text = folder.succeed([&SMALL[..], &options].concat());
    assert!(
        text.contains("wave.gif") && text.contains("1 rebuilt, 5 refitted, 0 kept"),
        "{text}"
    );
    assert_eq!(folder.contents().len(), 1);

    let mut decoding = gif::DecodeOptions::new();
    decoding.set_color_output(gif::ColorOutput::RGBA);
    let bytes = folder.read("wave.gif");
    let mut decoder = decoding.read_info(&bytes[..]).expect("it is a GIF");
    assert_eq!((decoder.width(), decoder.height()), (64, 36));
    let mut pictures = Vec::new();
    while let Some(frame) = decoder.read_next_frame().expect("it is whole") {
        assert_eq!((frame.delay, frame.width, frame.height), (4, 64, 36));
        pictures.push(frame.buffer.to_vec());
    }
    assert_eq!(decoder.repeat(), gif::Repeat::Infinite);
    assert_eq!(pictures.len(), 6);

    // The colors of the GIF are close to those of the PNG frames.
    let frames_folder = self::folder(&["frames"]);
    frames_folder.succeed([&SMALL[..], &options[..2], &["--out=frames"]].concat());
    let frames = frames(&frames_folder, "frames", 6);
    for (indexed, png) in pictures.iter().zip(&frames) {
        let exact = decode(png);
        let pairs = indexed.chunks(4).zip(exact.chunks(3));
        let far = pairs.filter(|(a, b)| (0..3).any(|i| a[i].abs_diff(b[i]) > 24));
        let far = far.count();
        assert!(far < exact.len() / 3 / 50, "{far}");
    }
}

fn decode(png: &[u8]) -> Vec<u8> {
    let decoder = png::Decoder::new(std::io::Cursor::new(png));
    let mut reader = decoder.read_info().expect("it is a PNG");
    let mut bytes = vec![0; reader.output_buffer_size().expect("it has a size")];
    reader.next_frame(&mut bytes).expect("it is whole");
    bytes
}

/// A closed shutter gives the sharp picture at any number of times. An open shutter blurs, and the report sums its times.
#[test]
fn an_open_shutter_blurs_and_sums_up() {
    let folder = folder(&["sharp", "closed", "open", "once"]);
    let common = ["--frames=3", "--orbit", "--deform=wave"];
    let run = |name: &str, options: &[&str]| {
        let report = report(&folder, &[&common[..], &["--out", name], options].concat());
        (frames(&folder, name, 3), report)
    };
    let (sharp, plain) = run("sharp", &[]);
    assert_eq!(plain["shutter_times"], 1);
    let (closed, report) = run("closed", &["--shutter-times=3"]);
    assert_eq!(closed, sharp);
    assert_eq!(actions(&report), ["rebuilt", "refitted", "refitted"]);
    let (open, report) = run("open", &["--shutter=0.5", "--shutter-times=4"]);
    let (once, _) = run("once", &["--shutter=0.5"]);
    for frame in 0..3 {
        assert!(open[frame] != sharp[frame] && once[frame] != sharp[frame]);
        assert!(open[frame] != once[frame]);
        assert_eq!(report["frames"][frame]["primary_rays"], 4 * 64 * 36);
    }
    let totals = &report["totals"];
    assert_eq!(
        (&totals["rebuilt"], &totals["refitted"]),
        (&1.into(), &11.into())
    );
    assert_eq!(
        (&report["shutter"], &report["shutter_times"]),
        (&0.5.into(), &4.into())
    );
    let text =
        folder.succeed([&SMALL[..], &common, &["--shutter=0.5", "--shutter-times=4"]].concat());
    assert!(
        text.contains("open for 0.5 of a frame, seen at 4 times"),
        "{text}"
    );
}

#[test]
fn reports_have_every_frame() {
    let folder = Folder::new();
    let options = ["--frames=3", "--orbit", "--deform=wave", "--threads=2"];
    let report = report(&folder, &options);
    let keys = |value: &Value| -> Vec<String> {
        let mut keys: Vec<String> = value.as_object().unwrap().keys().cloned().collect();
        keys.sort_unstable();
        keys
    };
    let rays = ["mirror_rays", "primary_hits", "primary_rays", "shadow_rays"];
    let times = ["build_ms", "pose_ms", "render_ms", "total_ms", "write_ms"];
    let with = |more: &[&str]| {
        let mut keys: Vec<String> = [&rays[..], &times, more]
            .concat()
            .iter()
            .map(ToString::to_string)
            .collect();
        keys.sort_unstable();
        keys
    };
    let frames = report["frames"].as_array().unwrap();
    assert_eq!(frames.len(), 3);
    let mut sums = [0.0; 2];
    for frame in frames {
        assert_eq!(keys(frame), with(&["sah_cost", "tree"]));
        assert_eq!(frame["primary_rays"], 64 * 36);
        let number = |key: &str| frame[key].as_f64().unwrap();
        assert!(number("sah_cost") > 1.0 && number("total_ms") > 0.0);
        // A build has all boxes from the sweep.
        let stage = match frame["tree"] == "rebuilt" {
            true => "topology",
            false => "refit",
        };
        assert!(frame["build_ms"][stage].as_f64().unwrap() > 0.0, "{frame}");
        assert!(frame["render_ms"]["trace primary"].as_f64().unwrap() > 0.0);
        sums[0] += number("total_ms");
        sums[1] += number("shadow_rays");
    }
    let totals = &report["totals"];
    let counts = ["frames_per_second", "kept", "rebuilt", "refitted"];
    assert_eq!(keys(totals), with(&counts));
    assert!((totals["total_ms"].as_f64().unwrap() - sums[0]).abs() < 1e-3);
    assert_eq!(totals["shadow_rays"].as_f64(), Some(sums[1]));
    for (key, expected) in [
        ("scene", Value::from("default scene")),
        ("out", Value::Null),
        ("backend", "cpu".into()),
        ("threads", 2.into()),
        ("orbit", true.into()),
        ("deform", "wave".into()),
        ("update", "auto".into()),
    ] {
        assert_eq!(report[key], expected, "{key}");
    }

    // The text lists every frame of up to 24, and only the median and the worst frame of more.
    let rows = |frames: &str| {
        let text = folder.succeed(["animate", "--size=8x4", "--frames", frames]);
        assert!(text.contains("frames a second"), "{text}");
        let table = text.lines().skip_while(|line| !line.starts_with("frame "));
        table
            .skip(1)
            .take_while(|line| !line.starts_with("tree"))
            .count()
    };
    assert_eq!((rows("24"), rows("25")), (24, 2));
}

#[test]
fn any_number_of_threads_makes_the_same_frames() {
    let folder = folder(&["frames"]);
    let mut first = None;
    for threads in ["1", "3"] {
        let options = [
            "--frames=3",
            "--deform=wave",
            "--out=frames",
            "--threads",
            threads,
        ];
        folder.succeed([&SMALL[..], &options].concat());
        let frames = frames(&folder, "frames", 3);
        assert_eq!(*first.get_or_insert_with(|| frames.clone()), frames);
    }
}
