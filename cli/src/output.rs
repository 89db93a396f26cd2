//! Output of the commands: text, JSON, pictures and progress.

use anyhow::{Context, Result, bail};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use serde::Serialize;
use slimbvh::Picture;
use slimbvh::scene::Format;
use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::time::Duration;

/// Writes text to standard output.
///
/// # Errors
/// If standard output cannot be written.
pub fn print(text: &str) -> Result<()> {
    let mut out = std::io::stdout().lock();
    let written = out.write_all(text.as_bytes()).and_then(|()| out.flush());
    written.context("cannot write to standard output")
}

/// Writes text to standard output, unless one of the outputs goes there.
///
/// # Errors
/// If standard output cannot be written.
pub fn print_beside(outputs: &[Option<&Path>], text: &str) -> Result<()> {
    match outputs.iter().any(|path| is_stdout(*path)) {
        true => Ok(()),
        false => print(text),
    }
}

/// Prints a note to standard error.
pub fn warn(text: &str) {
    eprintln!("note: {text}");
}

/// Whether an output goes to standard output.
#[must_use]
pub fn is_stdout(path: Option<&Path>) -> bool {
    path == Some(Path::new("-"))
}

/// Checks before the work starts that a file can be written. `taken` lists the files that it must not replace.
///
/// # Errors
/// Names the missing folder, or the file that cannot be written or has another use.
pub fn check_place(path: &Path, taken: &[&Path]) -> Result<()> {
    let shown = path.display().to_string();
    let folder = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    if !folder.is_dir() {
        bail!("there is no folder {:?}", folder.display().to_string());
    }
    if path.is_dir() {
        bail!("{shown:?} is a folder; name a file");
    }
    if taken.iter().any(|other| is_same(path, other)) {
        bail!("{shown:?} has another use already; name another file");
    }
    if is_special(path) {
        return Ok(());
    }
    // Only an attempt shows whether the file can be written.
    let part = part(path);
    std::fs::write(&part, [])
        .and_then(|()| std::fs::remove_file(&part))
        .with_context(|| format!("cannot write {shown:?}"))
}

fn is_same(a: &Path, b: &Path) -> bool {
    resolved(a) == resolved(b)
}

/// The canonical path, also of a file that does not exist yet.
fn resolved(path: &Path) -> PathBuf {
    let folder = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    let beside = || Some(folder.canonicalize().ok()?.join(path.file_name()?));
    let whole = path.canonicalize().ok();
    whole.or_else(beside).unwrap_or_else(|| path.into())
}

/// Whether a path names a device or a pipe, which is written in place and never replaced.
fn is_special(path: &Path) -> bool {
    std::fs::metadata(path).is_ok_and(|metadata| !metadata.is_file() && !metadata.is_dir())
}

/// The temporary path beside `path`, which a file is written to before it is renamed.
fn part(path: &Path) -> PathBuf {
    path.with_file_name(format!(".slimbvh-{}.part", std::process::id()))
}

/// Writes JSON to a file, or to standard output for `-`.
///
/// # Errors
/// If the file cannot be written.
pub fn write_json(path: &Path, value: &impl Serialize) -> Result<()> {
    let mut text = serde_json::to_string_pretty(value)?;
    text.push('\n');
    write_whole(path, text.as_bytes())
}

/// Writes a picture as an 8-bit sRGB PNG, to a file, or to standard output for `-`.
///
/// # Errors
/// If the file cannot be written.
pub fn write_png(path: &Path, picture: &Picture) -> Result<()> {
    let size = [picture.width, picture.height];
    write_whole(path, &png_bytes(size, &picture.to_srgb())?)
}

/// Encodes `width` × `height` pixels of three bytes each as an 8-bit sRGB PNG.
///
/// # Errors
/// If the number of pixels does not match the size.
pub fn png_bytes([width, height]: [u32; 2], pixels: &[u8]) -> Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(pixels)?;
    writer.finish()?;
    Ok(bytes)
}

/// Writes a file atomically: the path holds the whole new file, or what it held before. `-` is standard output.
///
/// # Errors
/// If the file cannot be written.
pub fn write_whole(path: &Path, bytes: &[u8]) -> Result<()> {
    write_with(path, |file| Ok(file.write_all(bytes)?))
}

/// [`write_whole`] for streamed content: writes a temporary file beside the path, then renames it.
///
/// # Errors
/// If the file cannot be written, or if `write` fails.
pub fn write_with<T>(path: &Path, write: impl FnOnce(&mut dyn Write) -> Result<T>) -> Result<T> {
    if is_stdout(Some(path)) {
        // Not through its buffer of lines.
        let mut out = BufWriter::with_capacity(1 << 16, std::io::stdout().lock());
        let written = write(&mut out).and_then(|done| {
            out.flush()?;
            Ok(done)
        });
        return written.context("cannot write to standard output");
    }
    let create = |path: &Path| write(&mut File::create(path)?);
    let written = if is_special(path) {
        create(path)
    } else {
        let part = part(path);
        let moved = create(&part).and_then(|done| {
            std::fs::rename(&part, path)?;
            Ok(done)
        });
        moved.inspect_err(|_| drop(std::fs::remove_file(&part)))
    };
    written.with_context(|| format!("cannot write {:?}", path.display().to_string()))
}

/// [`check_place`] for an output file and its JSON report. Neither may replace the scene, nor the report the output file, nor may both
/// go to standard output.
///
/// # Errors
/// Those of [`check_place`], and for two outputs to standard output.
pub fn check_places(file: &Path, scene: Option<&Path>, json: Option<&Path>) -> Result<()> {
    check_one_on_stdout(file, json)?;
    if !is_stdout(Some(file)) {
        check_place(file, scene.as_slice())?;
    }
    let taken: Vec<_> = scene.into_iter().chain([file]).collect();
    check_report(json, &taken)
}

/// [`check_place`] for a JSON report, if one is asked for and does not go to standard output. It may not be named as a scene: in
/// `--json model.ply` the name of the report is missing.
///
/// # Errors
/// Those of [`check_place`], and for the name of a scene.
pub fn check_report(json: Option<&Path>, taken: &[&Path]) -> Result<()> {
    let Some(json) = json.filter(|json| !is_stdout(Some(json))) else {
        return Ok(());
    };
    check_place(json, taken)?;
    if Format::of_path(json).is_some() {
        bail!(
            "--json writes a report, and {:?} is named as a scene; name a file such as report.json, or - for standard output",
            json.display().to_string()
        );
    }
    Ok(())
}

/// Checks that no more than one of an output and its JSON report goes to standard output.
///
/// # Errors
/// If both do.
pub fn check_one_on_stdout(output: &Path, json: Option<&Path>) -> Result<()> {
    if is_stdout(Some(output)) && is_stdout(json) {
        bail!(
            "the output and the JSON report cannot both go to standard output; write one of them to a file"
        );
    }
    Ok(())
}

/// A progress display on the terminal, shown from one second after its creation until it is dropped.
pub struct Progress {
    bar: ProgressBar,
    _waits: Sender<()>,
}

/// Progress of unknown length.
#[must_use]
pub fn spinner(message: String) -> Progress {
    Progress::new(
        ProgressBar::no_length(),
        "{spinner} {msg} {elapsed}",
        message,
    )
}

/// Progress from 0 to 1.
#[must_use]
pub fn bar(message: &str) -> Progress {
    let template = "{msg} [{bar:40}] {percent:>3} % {eta}";
    Progress::new(ProgressBar::new(1000), template, message.into())
}

impl Progress {
    fn new(bar: ProgressBar, template: &str, message: String) -> Self {
        bar.set_draw_target(ProgressDrawTarget::hidden());
        if let Ok(style) = ProgressStyle::with_template(template) {
            bar.set_style(style.progress_chars("=> "));
        }
        bar.set_message(message);

        // Dropping the sender ends the wait.
        let (waits, dropped) = channel();
        let shown = bar.clone();
        std::thread::spawn(move || {
            let second = Duration::from_secs(1);
            if dropped.recv_timeout(second) == Err(RecvTimeoutError::Timeout) {
                shown.set_draw_target(ProgressDrawTarget::stderr());
                shown.enable_steady_tick(second / 10);
            }
        });
        Self { bar, _waits: waits }
    }

    /// Sets the progress, from 0 to 1.
    pub fn set(&self, share: f64) {
        self.bar.set_position((share * 1000.0) as u64);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

/// An error and its causes, each once: some errors include the sentence of their cause.
#[must_use]
pub fn sentence(error: &anyhow::Error) -> String {
    let mut sentence = error.to_string();
    for cause in error.chain().skip(1).map(ToString::to_string) {
        if !sentence.contains(&cause) {
            sentence = format!("{sentence}: {cause}");
        }
    }
    sentence
}

/// A count with thousands separators: 871,414.
pub fn count(n: impl TryInto<u64>) -> String {
    let digits = n.try_into().unwrap_or(u64::MAX).to_string();
    let mut grouped = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i) % 3 == 0 {
            grouped.push(',');
        }
        grouped.push(digit);
    }
    grouped
}

/// A count with its noun in singular or plural: 1 camera, 1,200 cameras.
pub fn things(n: impl TryInto<u64>, thing: &str) -> String {
    let n = n.try_into().unwrap_or(u64::MAX);
    let plural = if n == 1 { "" } else { "s" };
    format!("{} {thing}{plural}", count(n))
}

/// Bytes in binary units: 19.5 MiB.
pub fn bytes(n: impl TryInto<u64>) -> String {
    indicatif::BinaryBytes(n.try_into().unwrap_or(u64::MAX)).to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thousands_are_set_apart() {
        assert_eq!(count(0u32), "0");
        assert_eq!(count(999u32), "999");
        assert_eq!(count(1000u32), "1,000");
        assert_eq!(count(871_414u32), "871,414");
        assert_eq!(things(1u32, "camera"), "1 camera");
        assert_eq!(things(1200u32, "camera"), "1,200 cameras");
    }

    #[test]
    fn causes_are_said_once() {
        let cause = || std::io::Error::other("disk full");
        let included = anyhow::anyhow!(cause()).context("cannot write: disk full");
        assert_eq!(sentence(&included), "cannot write: disk full");
        let added = anyhow::anyhow!(cause()).context("cannot write");
        assert_eq!(sentence(&added), "cannot write: disk full");
    }
}
