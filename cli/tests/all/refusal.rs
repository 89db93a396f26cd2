//! Refusals: the binary exits with code 2 and one sentence that names the fault, and writes no file.

use crate::files::TwoTriangles;
use crate::process::Folder;

/// Maximum length of a sentence.
const LONGEST: usize = 300;

/// A folder with a valid scene and a picture that must not change.
pub fn folder() -> Folder {
    let folder = Folder::new();
    folder.write("sound.obj", TwoTriangles::SOUND.obj());
    folder.write("kept.png", "an older picture");
    folder
}

/// Runs the binary, which must refuse with one sentence that contains every expected part, and leave the folder unchanged.
/// `--nocapture` shows the sentences.
#[track_caller]
pub fn refuses(folder: &Folder, arguments: &[&str], expected: &[&str]) {
    let stderr = refusal(folder, arguments);
    let sentence = stderr.strip_suffix('\n').unwrap_or_default();
    assert!(sentence.starts_with("error: "), "{arguments:?}: {stderr}");
    assert!(
        !sentence.contains(char::is_control),
        "{arguments:?}: {stderr:?}"
    );
    assert!(
        !sentence.contains(". "),
        "{arguments:?}: two sentences: {stderr}"
    );
    assert!(
        sentence.chars().count() <= LONGEST,
        "{arguments:?}: {stderr}"
    );
    for part in expected {
        assert!(
            sentence.contains(part),
            "{arguments:?}: {part:?} is not in {stderr}"
        );
    }
}

/// [`refuses`] for errors of the command line parser, which add a pointer to the help.
#[track_caller]
pub fn refuses_usage(folder: &Folder, arguments: &[&str], expected: &[&str]) {
    let stderr = refusal(folder, arguments);
    let (first, rest) = stderr.split_once('\n').unwrap_or_default();
    assert!(
        first.starts_with("error: ") && first.len() <= LONGEST,
        "{arguments:?}: {stderr}"
    );
    assert!(
        rest.ends_with("For more information, try '--help'.\n"),
        "{arguments:?}: {stderr}"
    );
    for part in expected {
        assert!(
            stderr.contains(part),
            "{arguments:?}: {part:?} is not in {stderr}"
        );
    }
}

/// Runs the binary, which must exit with code 2 and change no file. Returns what it wrote to standard error.
#[track_caller]
pub fn refusal(folder: &Folder, arguments: &[&str]) -> String {
    let before = folder.contents();
    let outcome = folder.run(arguments);
    println!("{:<60} {}", arguments.join(" "), outcome.stderr.trim_end());
    assert_eq!(outcome.code, Some(2), "{arguments:?}: {outcome:?}");
    assert_eq!(outcome.stdout, "", "{arguments:?}");
    let after = folder.contents();
    let changed = || {
        after
            .iter()
            .filter(|&(name, bytes)| before.get(name) != Some(bytes))
    };
    assert!(
        before == after,
        "{arguments:?}: changed {:?}",
        changed().map(|c| c.0).collect::<Vec<_>>()
    );
    outcome.stderr
}
