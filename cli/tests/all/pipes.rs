//! `-` is standard input and standard output.

use crate::files::box_obj;
use crate::process::Folder;

const OFF: &str = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 2 0\n3 0 1 2\n";

/// Runs the binary, which must succeed and print nothing to standard error. Returns its standard output.
fn pipe(folder: &Folder, input: &[u8], arguments: &[&str]) -> Vec<u8> {
    let (code, stdout, stderr) = folder.pipe(input, arguments);
    assert_eq!((code, stderr.as_str()), (Some(0), ""), "{arguments:?}");
    stdout
}

fn refusal(folder: &Folder, input: &[u8], arguments: &[&str]) -> String {
    let (code, stdout, stderr) = folder.pipe(input, arguments);
    assert_eq!((code, stdout.len()), (Some(2), 0), "{arguments:?}");
    assert_eq!(stderr.lines().count(), 1, "{stderr}");
    stderr
}

#[test]
fn a_scene_comes_from_standard_input_by_its_content() {
    let folder = Folder::new();
    let triangles = |input: &[u8], options: &[&str]| {
        let arguments = [&["info", "-", "--json", "-"], options].concat();
        let text = pipe(&folder, input, &arguments);
        let report: serde_json::Value = serde_json::from_slice(&text).expect("JSON alone");
        assert_eq!(report["scene"], "standard input");
        report["triangles"].as_u64()
    };
    assert_eq!(triangles(box_obj().as_bytes(), &[]), Some(12));
    assert_eq!(triangles(OFF.as_bytes(), &[]), Some(1));
    assert_eq!(triangles(OFF.as_bytes(), &["--format", "off"]), Some(1));
    let stl = "solid\nfacet\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendfacet\nendsolid\n";
    assert_eq!(triangles(stl.as_bytes(), &[]), Some(1));
}

#[test]
fn pictures_and_hierarchies_go_through_pipes() {
    let folder = Folder::new();
    let obj = box_obj();
    folder.write("box.obj", &obj);
    folder.succeed(["render", "box.obj", "-o", "box.png", "--size", "32x24"]);
    let png = folder.read("box.png");
    let render = ["render", "-", "-o", "-", "--size", "32x24"];
    assert_eq!(pipe(&folder, obj.as_bytes(), &render), png);

    folder.succeed(["build", "box.obj", "-o", "box.slim"]);
    let slim = pipe(&folder, obj.as_bytes(), &["build", "-", "-o", "-"]);
    assert_eq!(slim, folder.read("box.slim"));
    assert_eq!(pipe(&folder, &slim, &render), png);
    let info = pipe(&folder, &slim, &["info", "-", "--json", "-"]);
    let info: serde_json::Value = serde_json::from_slice(&info).expect("JSON alone");
    assert!(info["hierarchy"].is_object());

    let gif = [
        "animate", "-", "--frames", "2", "--orbit", "--size", "32x24", "--out", "-",
    ];
    assert!(pipe(&folder, obj.as_bytes(), &gif).starts_with(b"GIF89a"));
    // The report goes to a file beside.
    let report = [
        "render",
        "-",
        "-o",
        "-",
        "--size",
        "32x24",
        "--json",
        "report.json",
    ];
    assert_eq!(pipe(&folder, obj.as_bytes(), &report), png);
    assert!(folder.read("report.json").starts_with(b"{"));
}

#[test]
fn a_format_goes_before_the_extension() {
    let folder = Folder::new();
    folder.write("box.txt", OFF);
    folder.write("wrong.obj", OFF);
    folder.succeed(["info", "box.txt", "--format", "off"]);
    folder.succeed(["info", "wrong.obj", "--format", "off"]);
    // Without it the extension counts, whatever the content.
    let error = refusal(&folder, b"", &["info", "wrong.obj"]);
    assert!(
        error.contains("\"wrong.obj\" is not OBJ: it looks like OFF"),
        "{error}"
    );
    let error = refusal(&folder, OFF.as_bytes(), &["info", "-", "--format", "ply"]);
    assert!(
        error.contains("\"standard input\" is not PLY: it looks like OFF"),
        "{error}"
    );
}

#[test]
fn a_guessed_format_is_told_with_the_error() {
    let folder = Folder::new();
    for (bytes, guess) in [
        (&b"no scene at all"[..], "OBJ"),
        (b"\xef\xbb\xbfsolid x\nfacet\nvertex 1 2", "STL"),
        (b"OFF 1", "OFF"),
        (b"\x89SLIM", "slim"),
    ] {
        let error = refusal(&folder, bytes, &["info", "-"]);
        let end = format!("; its content looks like {guess}, and --format names another\n");
        assert!(error.ends_with(&end), "{error}");
    }
    let error = refusal(&folder, b"no scene", &["info", "-", "--format", "obj"]);
    assert!(!error.contains("--format"), "{error}");
    // Without a keyword, and behind a comment.
    let numbers = OFF.trim_start().strip_prefix("OFF").expect("a keyword");
    for text in [numbers.to_owned(), format!("# a box\n{OFF}")] {
        pipe(&folder, text.as_bytes(), &["info", "-"]);
    }
}

#[test]
fn two_outputs_do_not_share_standard_output() {
    let folder = Folder::new();
    for arguments in [
        &["render", "-", "-o", "-", "--json", "-"][..],
        &["build", "-", "-o", "-", "--json", "-"],
        &["animate", "-", "--frames", "2", "--out", "-", "--json", "-"],
    ] {
        let error = refusal(&folder, OFF.as_bytes(), arguments);
        assert!(
            error.contains("cannot both go to standard output"),
            "{error}"
        );
    }
    let error = refusal(&folder, b"", &["info", "-"]);
    assert!(error.contains("standard input is empty"), "{error}");
    assert!(folder.contents().is_empty(), "{:?}", folder.contents());
}
