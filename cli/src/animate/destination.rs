//! The output of frames: none, a folder, or one GIF.

use super::AnimateArguments;
use crate::output;
use anyhow::{Context, Result, bail};
use slimbvh::Picture;
use std::path::{Path, PathBuf};

/// The longest side of a GIF: its format stores sides in 16 bits.
const MOST_GIF_SIDE: u32 = 65535;

/// The palette of a GIF's frame is chosen from about this number of its pixels.
const PIXELS_FOR_COLORS: usize = 1 << 14;

/// An output whose paths were checked.
#[derive(Debug)]
pub enum Destination {
    Nowhere,
    Folder(PathBuf),
    Gif(PathBuf),
}

/// An output that accepts frames.
pub enum Sink<'p> {
    Nowhere,
    Folder(&'p Path),
    Gif {
        path: &'p Path,
        encoder: gif::Encoder<Vec<u8>>,
        /// In hundredths of a second.
        delay: u16,
    },
}

impl Destination {
    /// Checks the paths of all output files before any work starts.
    pub fn check(arguments: &AnimateArguments) -> Result<Self> {
        let scene = arguments.scene.file();
        let mut outputs = Vec::new();
        let place = match &arguments.out {
            None => Self::Nowhere,
            Some(path) if output::is_stdout(Some(path)) => {
                output::check_one_on_stdout(path, arguments.json.as_deref())?;
                check_gif_size(arguments)?;
                Self::Gif(path.clone())
            }
            Some(path) if path.is_dir() => {
                let frames = (0..arguments.frames).map(|frame| frame_path(path, frame));
                outputs.extend(frames);
                for frame in &outputs {
                    output::check_place(frame, scene.as_slice())?;
                }
                Self::Folder(path.clone())
            }
            Some(path) if is_gif(path) => {
                output::check_place(path, scene.as_slice())?;
                check_gif_size(arguments)?;
                outputs.push(path.clone());
                Self::Gif(path.clone())
            }
            Some(path) => bail!(
                "{:?} is neither an existing folder nor a file that ends in .gif",
                path.display().to_string()
            ),
        };
        let outputs = outputs.iter().map(PathBuf::as_path);
        let taken: Vec<&Path> = scene.into_iter().chain(outputs).collect();
        output::check_report(arguments.json.as_deref(), &taken)?;
        Ok(place)
    }

    /// Starts the output.
    pub fn open(&self, [width, height]: [u32; 2], frames_per_second: u32) -> Result<Sink<'_>> {
        match self {
            Self::Nowhere => Ok(Sink::Nowhere),
            Self::Folder(path) => Ok(Sink::Folder(path)),
            Self::Gif(path) => {
                let (width, height) = (u16::try_from(width)?, u16::try_from(height)?);
                let mut encoder = gif::Encoder::new(Vec::new(), width, height, &[])?;
                encoder.set_repeat(gif::Repeat::Infinite)?;
                let delay = 100.0 / f64::from(frames_per_second);
                Ok(Sink::Gif {
                    path,
                    encoder,
                    delay: delay.round() as u16,
                })
            }
        }
    }
}

impl Sink<'_> {
    /// Adds the next frame. In a folder it is written at once.
    pub fn add(&mut self, frame: u32, picture: &Picture) -> Result<()> {
        match self {
            Self::Nowhere => Ok(()),
            Self::Folder(folder) => output::write_png(&frame_path(folder, frame), picture),
            Self::Gif { encoder, delay, .. } => {
                let (width, height) = (
                    u16::try_from(picture.width)?,
                    u16::try_from(picture.height)?,
                );
                let bytes = picture.to_srgb();
                let step = (picture.pixels.len() / PIXELS_FOR_COLORS).clamp(1, 30);
                let mut image = gif::Frame::from_rgb_speed(width, height, &bytes, step as i32);
                image.delay = *delay;
                encoder.write_frame(&image).context("cannot make the GIF")
            }
        }
    }

    /// Writes the GIF, if that is the output.
    pub fn finish(self) -> Result<()> {
        match self {
            Self::Nowhere | Self::Folder(_) => Ok(()),
            Self::Gif { path, encoder, .. } => output::write_whole(path, &encoder.into_inner()?),
        }
    }
}

fn check_gif_size(arguments: &AnimateArguments) -> Result<()> {
    let [width, height] = arguments.picture.sight.size;
    if width.max(height) > MOST_GIF_SIDE {
        bail!(
            "--size {width}x{height} is too large for a GIF, whose sides have at most {MOST_GIF_SIDE} \
             pixels; take a folder"
        );
    }
    Ok(())
}

fn frame_path(folder: &Path, frame: u32) -> PathBuf {
    folder.join(format!("frame-{frame:04}.png"))
}

fn is_gif(path: &Path) -> bool {
    let extension = path.extension();
    extension.is_some_and(|extension| extension.eq_ignore_ascii_case("gif"))
}
