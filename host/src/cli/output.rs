//! What the commands write: text, JSON, pictures, progress.

use anyhow::{Context, Result};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use serde::Serialize;
use slimbvh::Picture;
use std::io::Write;
use std::path::Path;
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::time::Duration;

/// Writes text to standard output.
pub fn print(text: &str) -> Result<()> {
    let mut out = std::io::stdout().lock();
    out.write_all(text.as_bytes())?;
    out.flush()?;
    Ok(())
}

/// Writes JSON to a file, or to standard output for `-`.
pub fn write_json(path: &Path, value: &impl Serialize) -> Result<()> {
    let mut text = serde_json::to_string_pretty(value)?;
    text.push('\n');
    if path == Path::new("-") {
        print(&text)
    } else {
        write_whole(path, text.as_bytes())
    }
}

/// Writes a picture as an 8-bit sRGB PNG.
pub fn write_png(path: &Path, picture: &Picture) -> Result<()> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, picture.width, picture.height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&picture.to_srgb())?;
    writer.finish()?;
    write_whole(path, &bytes)
}

/// Writes a file so that it is there whole or not at all: beside its place first, then moved.
fn write_whole(path: &Path, bytes: &[u8]) -> Result<()> {
    let mut part = path.as_os_str().to_owned();
    part.push(format!(".{}.part", std::process::id()));
    let part = Path::new(&part);
    let written = std::fs::write(part, bytes).and_then(|()| std::fs::rename(part, path));
    written
        .inspect_err(|_| drop(std::fs::remove_file(part)))
        .with_context(|| format!("cannot write {:?}", path.display().to_string()))
}

/// Something that shows on a terminal, from one second on, until it is dropped.
pub struct Progress {
    bar: ProgressBar,
    _waits: Sender<()>,
}

/// Progress of unknown length.
pub fn spinner(message: String) -> Progress {
    Progress::new(
        ProgressBar::no_length(),
        "{spinner} {msg} {elapsed}",
        message,
    )
}

/// Progress from 0 to 1.
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

    /// Moves on to a share from 0 to 1.
    pub fn set(&self, share: f64) {
        self.bar.set_position((share * 1000.0) as u64);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

/// A count with thousands set apart: 871,414.
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

/// Bytes in binary units: 19.5 MiB.
pub fn bytes(n: usize) -> String {
    indicatif::BinaryBytes(n as u64).to_string()
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
    }
}
