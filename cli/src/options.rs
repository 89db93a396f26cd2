//! Parsers of structured option values. Public so that fuzz targets can call them.

mod light;

pub use light::{LightOption, light};

use slimbvh::{Camera, Projection, Scene, Tolerance};
use std::str::FromStr;

/// Parses `WIDTHxHEIGHT`.
///
/// # Errors
/// For any other text, for a side of 0, and for too many pixels.
pub fn size(text: &str) -> Result<[u32; 2], String> {
    const MOST: u32 = 1 << 16;
    // A picture of this size takes two gigabytes, including the buffers that write it.
    const MOST_PIXELS: u64 = 1 << 27;
    let parts = text.split_once(['x', 'X']);
    let sides = parts.and_then(|(w, h)| Some([w.trim().parse().ok()?, h.trim().parse().ok()?]));
    match sides {
        Some([0, _] | [_, 0]) => Err("both sides must be at least 1 pixel".into()),
        Some([width, height]) if width > MOST || height > MOST => {
            Err(format!("a side may have at most {MOST} pixels"))
        }
        Some([width, height]) if u64::from(width) * u64::from(height) > MOST_PIXELS => {
            Err(format!("a picture may have at most {MOST_PIXELS} pixels"))
        }
        Some(sides) => Ok(sides),
        None => Err("write it as WIDTHxHEIGHT, for example 1280x720".into()),
    }
}

/// Parses a whole number within a range.
///
/// # Errors
/// For any other text, and for numbers outside the range.
pub fn whole(text: &str, range: std::ops::RangeInclusive<u32>) -> Result<u32, String> {
    match text.parse() {
        Ok(number) if range.contains(&number) => Ok(number),
        _ => Err(format!(
            "it must be a whole number from {} to {}",
            range.start(),
            range.end()
        )),
    }
}

/// Parses a number from 0 to 1.
///
/// # Errors
/// For any other text or number.
pub fn share(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(share) if (0.0..=1.0).contains(&share) => Ok(share),
        _ => Err("it must be a number from 0 to 1".into()),
    }
}

/// Parses a length above 0, or pixels as in `0.5px`.
///
/// # Errors
/// For any other text or number.
pub fn tolerance(text: &str) -> Result<Tolerance, String> {
    let (number, is_pixels) = match text.strip_suffix("px") {
        Some(number) => (number, true),
        None => (text, false),
    };
    match number.trim().parse::<f32>() {
        Ok(number) if number > 0.0 && number.is_finite() => Ok(if is_pixels {
            Tolerance::Pixels(number)
        } else {
            Tolerance::Length(number)
        }),
        _ => Err("it must be a length above 0, or pixels as in 0.5px".into()),
    }
}

/// The parts that `--camera` gives. The scene's camera or the default one supplies the rest.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CameraOption {
    /// In the file's own coordinates.
    eye: Option<[f64; 3]>,
    target: Option<[f64; 3]>,
    up: Option<[f32; 3]>,
    projection: Option<Projection>,
    lens: Option<f32>,
    focus: Option<f32>,
}

impl CameraOption {
    /// Replaces the given parts of the scene's first camera, which is there. A lens without a focus distance focuses on the target.
    ///
    /// # Errors
    /// For a lens on a camera with parallel rays, and without a camera.
    pub fn apply(&self, scene: &mut Scene) -> Result<(), String> {
        let [eye, target] = [self.eye, self.target].map(|at| at.map(|at| scene.to_local(at)));
        let camera = scene.cameras.first_mut().ok_or("there is no camera")?;
        camera.eye = eye.unwrap_or(camera.eye);
        camera.target = target.unwrap_or(camera.target);
        camera.up = self.up.unwrap_or(camera.up);
        camera.projection = self.projection.unwrap_or(camera.projection);
        let Some(radius) = self.lens else {
            return Ok(());
        };
        match camera.projection {
            Projection::Perspective { vertical_fov }
            | Projection::ThinLens { vertical_fov, .. } => {
                camera.projection = Projection::ThinLens {
                    vertical_fov,
                    radius,
                    focus_distance: self.focus.unwrap_or_else(|| distance(camera)),
                };
                Ok(())
            }
            Projection::Orthographic { .. } => Err(
                "a camera with parallel rays has no lens; add fov=DEGREES, or leave out lens"
                    .into(),
            ),
        }
    }
}

/// The distance from the eye to the target.
fn distance(camera: &Camera) -> f32 {
    let squares = (0..3).map(|axis| {
        let way = f64::from(camera.target[axis]) - f64::from(camera.eye[axis]);
        way * way
    });
    squares.sum::<f64>().sqrt() as f32
}

impl FromStr for CameraOption {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let mut camera = Self::default();
        for (key, value) in pairs(text)? {
            match key {
                "eye" => camera.eye = Some(place(value)?),
                "target" => camera.target = Some(place(value)?),
                "up" => camera.up = Some(vector(value)?),
                "fov" => {
                    camera.projection = Some(Projection::Perspective {
                        vertical_fov: number(value)?,
                    });
                }
                "height" => {
                    camera.projection = Some(Projection::Orthographic {
                        height: number(value)?,
                    });
                }
                "lens" => camera.lens = Some(number(value)?),
                "focus" => camera.focus = Some(number(value)?),
                _ => {
                    return Err(format!(
                        "unknown camera part {key:?}; the parts are eye, target, up, fov or height, lens, and focus"
                    ));
                }
            }
        }
        let is_parallel = matches!(camera.projection, Some(Projection::Orthographic { .. }));
        if camera.lens.is_some() && is_parallel {
            return Err(
                "a camera with parallel rays has no lens; give fov=DEGREES instead of height"
                    .into(),
            );
        }
        if camera.focus.is_some() && camera.lens.is_none() {
            return Err("focus needs lens=RADIUS as well".into());
        }
        Ok(camera)
    }
}

/// Splits `key=value key=value …` at spaces and semicolons.
fn pairs(text: &str) -> Result<Vec<(&str, &str)>, String> {
    text.split(|c: char| c.is_whitespace() || c == ';')
        .filter(|pair| !pair.is_empty())
        .map(|pair| {
            pair.split_once('=')
                .ok_or_else(|| format!("{pair:?} is not of the form key=value"))
        })
        .collect()
}

fn vector(text: &str) -> Result<[f32; 3], String> {
    let numbers: Vec<f32> = text.split(',').map(number).collect::<Result<_, _>>()?;
    numbers
        .try_into()
        .map_err(|_| format!("{text:?} is not three numbers X,Y,Z"))
}

/// A position in the file's own coordinates.
fn place(text: &str) -> Result<[f64; 3], String> {
    // What a scene holds is finite in `f32`.
    vector(text)?;
    let numbers: Vec<f64> = text
        .split(',')
        .map_while(|word| word.parse().ok())
        .collect();
    numbers
        .try_into()
        .map_err(|_| format!("{text:?} is not three numbers X,Y,Z"))
}

fn number(text: &str) -> Result<f32, String> {
    match text.parse::<f32>() {
        Ok(x) if x.is_finite() => Ok(x),
        _ => Err(format!("{text:?} is not a finite number")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes() {
        assert_eq!(size("1280x720"), Ok([1280, 720]));
        for bad in [
            "0x5",
            "5",
            "5x",
            "x",
            "-1x4",
            "99999x1",
            "1e3x4",
            "65535x65535",
        ] {
            assert!(size(bad).is_err(), "{bad}");
        }
    }

    fn with_camera(camera: Camera) -> Scene {
        Scene {
            cameras: vec![camera],
            ..Scene::default()
        }
    }

    const PARALLEL: Camera = Camera {
        eye: [0.0; 3],
        target: [4.0, 5.0, 6.0],
        up: [0.0, 0.0, 1.0],
        projection: Projection::Orthographic { height: 2.0 },
    };

    /// Positions are those of the file, however far away its local origin is.
    #[test]
    fn cameras_are_in_the_files_coordinates() {
        let mut scene = Scene {
            origin: [500_000.0, 4_649_776.0, 0.0],
            ..with_camera(PARALLEL)
        };
        let option: CameraOption = "eye=500123.5,4649776.25,3 up=0,1,0".parse().unwrap();
        assert_eq!(option.apply(&mut scene), Ok(()));
        let camera = scene.cameras[0];
        assert_eq!(camera.eye, [123.5, 0.25, 3.0]);
        assert_eq!(camera.target, [4.0, 5.0, 6.0]);
        assert_eq!(camera.up, [0.0, 1.0, 0.0]);
    }

    #[test]
    fn cameras_keep_what_is_not_given() {
        let option: CameraOption = "eye=1,2,3; fov=50".parse().unwrap();
        let mut scene = with_camera(PARALLEL);
        assert_eq!(option.apply(&mut scene), Ok(()));
        let camera = scene.cameras[0];
        assert_eq!(
            (camera.eye, camera.target),
            ([1.0, 2.0, 3.0], [4.0, 5.0, 6.0])
        );
        assert_eq!(
            camera.projection,
            Projection::Perspective { vertical_fov: 50.0 }
        );
        for bad in [
            "eye=1,2",
            "eye=1,2,x",
            "nose=1,2,3",
            "eye",
            "fov=nan",
            "focus=3",
            "height=2 lens=0.5",
            "lens=wide",
        ] {
            assert!(bad.parse::<CameraOption>().is_err(), "{bad}");
        }
    }

    #[test]
    fn lenses() {
        let parallel = Camera {
            eye: [1.0, 2.0, 3.0],
            target: [1.0, 5.0, 7.0],
            up: [0.0, 1.0, 0.0],
            projection: Projection::Orthographic { height: 2.0 },
        };
        let mut scene = with_camera(parallel);
        let option: CameraOption = "lens=0.25 fov=50".parse().unwrap();
        assert_eq!(option.apply(&mut scene), Ok(()));
        // The distance to the target is 5.
        let expected = |radius, focus_distance| Projection::ThinLens {
            vertical_fov: 50.0,
            radius,
            focus_distance,
        };
        assert_eq!(scene.cameras[0].projection, expected(0.25, 5.0));
        let option: CameraOption = "lens=0.5;focus=2".parse().unwrap();
        assert_eq!(option.apply(&mut scene), Ok(()));
        assert_eq!(scene.cameras[0].projection, expected(0.5, 2.0));
        assert!(option.apply(&mut with_camera(parallel)).is_err());
    }
}
