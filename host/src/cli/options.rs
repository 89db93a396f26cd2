//! Values of options that have parts.

use slimbvh::{Camera, Light, Projection};
use std::str::FromStr;

/// Parses `WIDTHxHEIGHT`.
pub fn size(text: &str) -> Result<[u32; 2], String> {
    const MOST: u32 = 1 << 16;
    // Two gigabytes, with what it takes to write it.
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

/// What `--camera` gives; the rest is filled in from the scene's camera or the default one.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CameraOption {
    eye: Option<[f32; 3]>,
    target: Option<[f32; 3]>,
    up: Option<[f32; 3]>,
    projection: Option<Projection>,
}

impl CameraOption {
    /// Replaces what is given.
    pub fn apply(&self, camera: &mut Camera) {
        camera.eye = self.eye.unwrap_or(camera.eye);
        camera.target = self.target.unwrap_or(camera.target);
        camera.up = self.up.unwrap_or(camera.up);
        camera.projection = self.projection.unwrap_or(camera.projection);
    }
}

impl FromStr for CameraOption {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let mut camera = Self::default();
        for (key, value) in pairs(text)? {
            match key {
                "eye" => camera.eye = Some(vector(value)?),
                "target" => camera.target = Some(vector(value)?),
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
                _ => {
                    return Err(format!(
                        "a camera has no {key:?}; it has eye, target, up, fov or height"
                    ));
                }
            }
        }
        Ok(camera)
    }
}

/// Parses a light.
pub fn light(text: &str) -> Result<Light, String> {
    let (mut sun, mut point, mut color, mut range) = (None, None, None, None);
    for (key, value) in pairs(text)? {
        match key {
            "sun" => sun = Some(vector(value)?),
            "point" => point = Some(vector(value)?),
            "color" => color = Some(vector(value)?),
            "range" => range = Some(number(value)?),
            _ => {
                return Err(format!(
                    "a light has no {key:?}; it has sun or point, color, and range"
                ));
            }
        }
    }
    match (sun, point) {
        (Some(direction), None) if range.is_none() => Ok(Light::Directional {
            direction,
            color: color.unwrap_or([3.0; 3]),
        }),
        (Some(_), None) => Err("a sun has no range".into()),
        (None, Some(position)) => Ok(Light::Point {
            position,
            color: color.unwrap_or([10.0; 3]),
            range: range.unwrap_or(f32::INFINITY),
        }),
        _ => Err("give either sun=X,Y,Z, where its light goes, or point=X,Y,Z, where it is".into()),
    }
}

/// Splits `key=value key=value …`; semicolons serve as well as spaces.
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

    #[test]
    fn cameras_keep_what_is_not_given() {
        let option: CameraOption = "eye=1,2,3; fov=50".parse().unwrap();
        let mut camera = Camera {
            eye: [0.0; 3],
            target: [4.0, 5.0, 6.0],
            up: [0.0, 0.0, 1.0],
            projection: Projection::Orthographic { height: 2.0 },
        };
        option.apply(&mut camera);
        assert_eq!(
            (camera.eye, camera.target),
            ([1.0, 2.0, 3.0], [4.0, 5.0, 6.0])
        );
        assert_eq!(
            camera.projection,
            Projection::Perspective { vertical_fov: 50.0 }
        );
        for bad in ["eye=1,2", "eye=1,2,x", "nose=1,2,3", "eye", "fov=nan"] {
            assert!(bad.parse::<CameraOption>().is_err(), "{bad}");
        }
    }

    #[test]
    fn lights() {
        assert_eq!(
            light("sun=0,-1,0.5"),
            Ok(Light::Directional {
                direction: [0.0, -1.0, 0.5],
                color: [3.0; 3]
            })
        );
        assert_eq!(
            light("point=1,2,3 color=4,5,6 range=7"),
            Ok(Light::Point {
                position: [1.0, 2.0, 3.0],
                color: [4.0, 5.0, 6.0],
                range: 7.0
            })
        );
        for bad in [
            "",
            "color=1,1,1",
            "sun=0,1,0 point=0,1,0",
            "sun=0,1,0 range=2",
        ] {
            assert!(light(bad).is_err(), "{bad}");
        }
    }
}
