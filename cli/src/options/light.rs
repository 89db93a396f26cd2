//! The parser of `--light`.

use super::{number, pairs, place, vector};
use slimbvh::{AreaShape, Light, Scene};

const KINDS: &str = "give one of sun=X,Y,Z, the direction of its light, or point=X,Y,Z, disc=X,Y,Z, rectangle=X,Y,Z, \
    the position of the light";

/// The given parts of a light.
#[derive(Debug, Default)]
struct Parts {
    sun: Option<[f32; 3]>,
    /// In the file's own coordinates, as the next two.
    point: Option<[f64; 3]>,
    disc: Option<[f64; 3]>,
    rectangle: Option<[f64; 3]>,
    normal: Option<[f32; 3]>,
    radius: Option<f32>,
    edge1: Option<[f32; 3]>,
    edge2: Option<[f32; 3]>,
    color: Option<[f32; 3]>,
    range: Option<f32>,
}

/// A light that is given on the command line.
#[derive(Clone, Debug, PartialEq)]
pub struct LightOption {
    light: Light,
    /// Where it is in the file's own coordinates, if it is anywhere.
    place: Option<[f64; 3]>,
}

impl LightOption {
    /// The light in a scene.
    #[must_use]
    pub fn in_scene(&self, scene: &Scene) -> Light {
        let mut light = self.light;
        if let (Light::Point { position: at, .. } | Light::Area { center: at, .. }, Some(place)) =
            (&mut light, self.place)
        {
            *at = scene.to_local(place);
        }
        light
    }
}

/// Parses a light.
///
/// # Errors
/// For unknown, missing or incompatible parts.
pub fn light(text: &str) -> Result<LightOption, String> {
    let parts = Parts::parse(text)?;
    let (
        Parts { sun, point, .. },
        Parts {
            disc, rectangle, ..
        },
    ) = (&parts, &parts);
    let narrow = |place: [f64; 3]| place.map(|x| x as f32);
    let light = match (*sun, *point, *disc, *rectangle) {
        (Some(direction), None, None, None) => parts.sun(direction),
        (None, Some(position), None, None) => parts.point(narrow(position)),
        (None, None, Some(center), None) => parts.disc(narrow(center)),
        (None, None, None, Some(center)) => parts.rectangle(narrow(center)),
        _ => Err(KINDS.into()),
    }?;
    let place = point.or(*disc).or(*rectangle);
    Ok(LightOption { light, place })
}

impl Parts {
    fn parse(text: &str) -> Result<Self, String> {
        let mut parts = Self::default();
        for (key, value) in pairs(text)? {
            let given = match key {
                "point" => {
                    parts.point = Some(place(value)?);
                    continue;
                }
                "disc" => {
                    parts.disc = Some(place(value)?);
                    continue;
                }
                "rectangle" => {
                    parts.rectangle = Some(place(value)?);
                    continue;
                }
                "sun" => &mut parts.sun,
                "normal" => &mut parts.normal,
                "edge1" => &mut parts.edge1,
                "edge2" => &mut parts.edge2,
                "color" => &mut parts.color,
                "radius" => {
                    parts.radius = Some(number(value)?);
                    continue;
                }
                "range" => {
                    parts.range = Some(number(value)?);
                    continue;
                }
                _ => {
                    return Err(format!(
                        "unknown light part {key:?}; the parts are sun, point, disc with normal and radius, or rectangle with edge1 \
                         and edge2, and also color and range"
                    ));
                }
            };
            *given = Some(vector(value)?);
        }
        Ok(parts)
    }

    fn sun(&self, direction: [f32; 3]) -> Result<Light, String> {
        self.has_no_disc("a sun")?;
        self.has_no_edges("a sun")?;
        if self.range.is_some() {
            return Err("a sun has no range".into());
        }
        Ok(Light::Directional {
            direction,
            color: self.color.unwrap_or([3.0; 3]),
        })
    }

    fn point(&self, position: [f32; 3]) -> Result<Light, String> {
        self.has_no_disc("a point")?;
        self.has_no_edges("a point")?;
        Ok(Light::Point {
            position,
            color: self.area_color(),
            range: self.reach(),
        })
    }

    fn disc(&self, center: [f32; 3]) -> Result<Light, String> {
        self.has_no_edges("a disc")?;
        let (Some(normal), Some(radius)) = (self.normal, self.radius) else {
            return Err(
                "a disc needs normal=X,Y,Z, the direction in which it shines, and radius=R".into(),
            );
        };
        if radius <= 0.0 {
            return Err("the radius of a disc must be above 0".into());
        }
        let mut light = Light::disc(center, normal, radius, self.area_color());
        if let Light::Area { range, .. } = &mut light {
            *range = self.reach();
        }
        Ok(light)
    }

    fn rectangle(&self, center: [f32; 3]) -> Result<Light, String> {
        self.has_no_disc("a rectangle")?;
        let (Some(edge1), Some(edge2)) = (self.edge1, self.edge2) else {
            return Err(
                "a rectangle needs edge1=X,Y,Z and edge2=X,Y,Z, the vectors from its center to the middles of two sides"
                    .into(),
            );
        };
        Ok(Light::Area {
            center,
            half_edges: [edge1, edge2],
            shape: AreaShape::Rectangle,
            color: self.area_color(),
            range: self.reach(),
        })
    }

    fn area_color(&self) -> [f32; 3] {
        self.color.unwrap_or([10.0; 3])
    }

    fn reach(&self) -> f32 {
        self.range.unwrap_or(f32::INFINITY)
    }

    fn has_no_disc(&self, what: &str) -> Result<(), String> {
        match (self.normal, self.radius) {
            (None, None) => Ok(()),
            _ => Err(format!(
                "{what} has no normal and no radius; only a disc does"
            )),
        }
    }

    fn has_no_edges(&self, what: &str) -> Result<(), String> {
        match (self.edge1, self.edge2) {
            (None, None) => Ok(()),
            _ => Err(format!("{what} has no edges; only a rectangle does")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lights() {
        let scene = Scene::default();
        let read = |text: &str| light(text).map(|option| option.in_scene(&scene));
        assert_eq!(
            read("sun=0,-1,0.5"),
            Ok(Light::Directional {
                direction: [0.0, -1.0, 0.5],
                color: [3.0; 3]
            })
        );
        assert_eq!(
            read("point=1,2,3 color=4,5,6 range=7"),
            Ok(Light::Point {
                position: [1.0, 2.0, 3.0],
                color: [4.0, 5.0, 6.0],
                range: 7.0
            })
        );
        assert_eq!(
            read("rectangle=1,2,3 edge1=4,0,0;edge2=0,0,5 range=7"),
            Ok(Light::Area {
                center: [1.0, 2.0, 3.0],
                half_edges: [[4.0, 0.0, 0.0], [0.0, 0.0, 5.0]],
                shape: AreaShape::Rectangle,
                color: [10.0; 3],
                range: 7.0
            })
        );
        assert_eq!(
            read("disc=1,2,3 normal=0,-1,0 radius=0.5 color=4,5,6"),
            Ok(Light::disc(
                [1.0, 2.0, 3.0],
                [0.0, -1.0, 0.0],
                0.5,
                [4.0, 5.0, 6.0]
            ))
        );
        let far = Scene {
            origin: [4_649_776.0; 3],
            ..Scene::default()
        };
        let point = light("point=4649776.25,4649777,0").map(|option| option.in_scene(&far));
        assert!(matches!(
            point,
            Ok(Light::Point {
                position: [0.25, 1.0, _],
                ..
            })
        ));
        for bad in [
            "",
            "color=1,1,1",
            "sun=0,1,0 point=0,1,0",
            "sun=0,1,0 range=2",
            "sun=0,1,0 radius=2",
            "point=0,1,0 edge1=2,0,0",
            "disc=0,1,0",
            "disc=0,1,0 radius=2",
            "disc=0,1,0 normal=0,1,0",
            "disc=0,1,0 normal=0,1,0 radius=0",
            "disc=0,1,0 normal=0,1,0 radius=1 edge1=1,0,0",
            "disc=0,1,0 rectangle=0,1,0 normal=0,1,0 radius=1",
            "rectangle=0,1,0 edge1=1,0,0",
            "rectangle=0,1,0 edge1=1,0,0 edge2=0,0,1 radius=1",
            "disc=0,1,0 normal=0,1 radius=1",
        ] {
            assert!(light(bad).is_err(), "{bad}");
        }
    }
}
