//! Stage `shade`: light on surfaces, shadow rays, mirrors, glass. Everything in the scene's magnitude ([`Light::scaled`]).
//!
//! A sample is a path: it begins at the camera, gathers light where it hits, and goes on at mirrors and through glass
//! ([`Material`]). To shadow rays glass is as any other surface: it stops them.

pub mod camera;
pub mod color;
pub mod light;
pub mod material;
pub mod sampling;
pub mod surface;
pub mod surface_point;
pub mod tile;
pub mod view;

pub use crate::shade::light::Light;
pub use crate::shade::material::Material;

use crate::geometry::float::max;
use crate::geometry::orientation::{Orientation, Target};
use crate::geometry::ray::{NO_PRIMITIVE, Ray};
use crate::shade::surface::{Surface, normalize};
use bytemuck::{Pod, Zeroable};
use core::f32::consts::FRAC_1_PI;
use glam::Vec3;

/// What surrounds the scene. 64 bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Environment {
    /// Bytes 0–11: linear RGB irradiance from everywhere, never shadowed.
    pub ambient: [f32; 3],
    /// Bytes 12–15: unused.
    pub padding_0: u32,
    /// Bytes 16–27: what rays along `up` see.
    pub zenith: [f32; 3],
    /// Bytes 28–31: unused.
    pub padding_1: u32,
    /// Bytes 32–43: what level rays see, and those that point down.
    pub horizon: [f32; 3],
    /// Bytes 44–47: unused.
    pub padding_2: u32,
    /// Bytes 48–59: unit vector.
    pub up: [f32; 3],
    /// Bytes 60–63: unused.
    pub padding_3: u32,
}

const _: () = assert!(size_of::<Environment>() == 64);

impl Environment {
    /// Radiance from a direction that meets nothing.
    #[inline]
    #[must_use]
    pub fn radiance(&self, direction: Vec3) -> Vec3 {
        let height = normalize(direction).dot(Vec3::from_array(self.up));
        let share = max(height, 0.0);
        let (horizon, zenith) = (
            Vec3::from_array(self.horizon),
            Vec3::from_array(self.zenith),
        );
        horizon + (zenith - horizon) * share
    }
}

/// A sample on its way. 64 bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Path {
    /// Bytes 0–31: where it goes next; [`Ray::EMPTY`] when it has ended.
    pub ray: Ray,
    /// Bytes 32–43: how much of what it meets reaches the eye.
    pub throughput: [f32; 3],
    /// Bytes 44–47: the primitive that it starts on.
    pub skip: u32,
    /// Bytes 48–59: linear RGB light gathered so far.
    pub radiance: [f32; 3],
    /// Bytes 60–63: the number of the sample in the picture.
    pub sample: u32,
}

const _: () = assert!(size_of::<Path>() == 64);

impl Path {
    /// A path that leaves the camera.
    #[inline]
    #[must_use]
    pub fn new(ray: Ray, sample: u32) -> Self {
        Self {
            ray,
            throughput: [1.0; 3],
            skip: NO_PRIMITIVE,
            radiance: [0.0; 3],
            sample,
        }
    }

    /// Whether it still goes on.
    #[inline]
    #[must_use]
    pub fn is_alive(&self) -> bool {
        self.ray.t_min <= self.ray.t_max
    }

    /// Adds light of this radiance, seen along the path.
    #[inline]
    #[must_use]
    pub fn with_light(self, radiance: Vec3) -> Self {
        let sum = Vec3::from_array(self.radiance) + radiance * Vec3::from_array(self.throughput);
        Self {
            radiance: sum.to_array(),
            ..self
        }
    }

    /// The path after it met nothing.
    #[inline]
    #[must_use]
    pub fn escaped(self, environment: &Environment) -> Self {
        let radiance = environment.radiance(Vec3::from_array(self.ray.direction));
        Self {
            ray: Ray::EMPTY,
            ..self.with_light(radiance)
        }
    }

    /// The path after it met a surface whose direct light has been added: goes on where that is a mirror or glass, ends
    /// elsewhere.
    #[inline]
    #[must_use]
    pub fn scattered(self, surface: &Surface, material: &Material, primitive: u32) -> Self {
        if material.onward_share() <= 0.0 {
            return Self {
                ray: Ray::EMPTY,
                ..self
            };
        }
        let onward = material.onward(surface, Vec3::from_array(self.ray.direction));
        let throughput = Vec3::from_array(self.throughput) * material.onward_color();
        Self {
            ray: Ray::new(onward.origin.to_array(), onward.direction.to_array()),
            throughput: throughput.to_array(),
            skip: primitive,
            ..self
        }
    }
}

/// What a light would add to a path's hit, and the ray that must meet nothing for it. 48 bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Shadow {
    /// Bytes 0–31: from the surface to the light; [`Ray::EMPTY`] where no ray is needed as there is no light.
    pub ray: Ray,
    /// Bytes 32–43: radiance to the eye.
    pub radiance: [f32; 3],
    /// Bytes 44–47: the primitive that the ray starts on.
    pub skip: u32,
}

const _: () = assert!(size_of::<Shadow>() == 48);

impl Shadow {
    /// No light.
    pub const NONE: Self = Self {
        ray: Ray::EMPTY,
        radiance: [0.0; 3],
        skip: NO_PRIMITIVE,
    };

    /// Whether the light may reach the surface.
    #[inline]
    #[must_use]
    pub fn is_possible(&self) -> bool {
        self.ray.t_min <= self.ray.t_max
    }
}

/// Light from one source on a surface (Lambert), a point of `primitive`. A source with extent must be [sampled](Light::sampled).
/// None where the triangle does not certainly face the source on the side that is seen, where the source is out of range,
/// shines the other way, or is black.
#[must_use]
pub fn direct_light(
    surface: &Surface,
    primitive: u32,
    material: &Material,
    light: &Light,
) -> Shadow {
    let target = Target {
        is_position: light.is_position,
        ..Target::direction(light.point)
    };
    let color = Vec3::from_array(light.color);
    let orientation = Orientation::new(&surface.triangle, &target);
    if color == Vec3::ZERO || !orientation.is_certainly_on(surface.side) {
        return Shadow::NONE;
    }
    let is_position = light.is_position == 1;
    let ray = ray_to(surface, light);
    let to_light = Vec3::from_array(ray.direction);
    let distance = to_light.length();
    let cosine = surface.shading_normal.dot(to_light) / distance;
    let in_range = !is_position || distance <= light.range;
    let falloff = if is_position {
        1.0 / (distance * distance)
    } else {
        1.0
    };
    let share = light.share(-to_light);
    if cosine > 0.0 && in_range && share > 0.0 {
        let radiance = color * diffuse(material) * (cosine * falloff * share);
        Shadow {
            ray,
            radiance: radiance.to_array(),
            skip: primitive,
        }
    } else {
        Shadow::NONE
    }
}

/// As [`direct_light`], with a ray even where there is no light: it adds nothing. What such rays cost can thus be told.
#[must_use]
pub fn direct_light_or_dark(
    surface: &Surface,
    primitive: u32,
    material: &Material,
    light: &Light,
) -> Shadow {
    let shadow = direct_light(surface, primitive, material, light);
    if shadow.is_possible() {
        shadow
    } else {
        Shadow {
            ray: ray_to(surface, light),
            radiance: [0.0; 3],
            skip: primitive,
        }
    }
}

/// From a surface to a light.
#[inline]
fn ray_to(surface: &Surface, light: &Light) -> Ray {
    let origin = surface.leave();
    let source = Vec3::from_array(light.point);
    let is_position = light.is_position == 1;
    let to_light = if is_position { source - origin } else { source };
    Ray {
        t_max: if is_position { 1.0 } else { f32::MAX },
        ..Ray::new(origin.to_array(), to_light.to_array())
    }
}

/// A pixel's color: the mean light of its samples, the paths `first..first + count`, added in order.
#[inline]
#[must_use]
pub fn mean_radiance(paths: &[Path], first: u32, count: u32) -> Vec3 {
    let mut sum = Vec3::ZERO;
    for i in first..first + count {
        if (i as usize) < paths.len() {
            sum += Vec3::from_array(paths[i as usize].radiance);
        }
    }
    sum / count as f32
}

/// Light from everywhere on a surface.
#[inline]
#[must_use]
pub fn ambient_light(material: &Material, environment: &Environment) -> Vec3 {
    Vec3::from_array(environment.ambient) * diffuse(material)
}

/// Radiance for an irradiance of 1, without the share that goes on.
#[inline]
fn diffuse(material: &Material) -> Vec3 {
    Vec3::from_array(material.base_color) * ((1.0 - material.onward_share()) * FRAC_1_PI)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::ray::Hit;
    use crate::geometry::triangle::Triangle;
    use crate::shade::light::RECTANGLE;

    fn floor() -> Surface {
        let triangle = Triangle {
            v0: Vec3::new(0.0, 0.0, 0.0),
            v1: Vec3::new(0.0, 0.0, 1.0),
            v2: Vec3::new(1.0, 0.0, 0.0),
        };
        let hit = Hit {
            t: 1.0,
            u: 0.25,
            v: 0.5,
            primitive: 3,
        };
        Surface::new(triangle, &hit, Vec3::new(1.0, -1.0, 0.0), [Vec3::ZERO; 3])
    }

    const WHITE: Material = Material {
        base_color: [1.0; 3],
        mirror: 0.0,
        transmission: 0.0,
        ior: 1.0,
        padding: [0; 2],
    };

    #[test]
    fn lambert_of_a_slanted_sun_and_of_a_lamp() {
        let sun = Light {
            point: [3.0, 4.0, 0.0],
            is_position: 0,
            color: [2.0, 1.0, 0.0],
            range: f32::MAX,
            ..Light::default()
        };
        let light = direct_light(&floor(), 7, &WHITE, &sun);
        let expected = Vec3::new(2.0, 1.0, 0.0) * (0.8 * FRAC_1_PI);
        assert!((Vec3::from_array(light.radiance) - expected).length() < 1e-6);
        assert_eq!(light.ray.direction, [3.0, 4.0, 0.0]);

        let lamp = Light {
            point: [0.5, 2.0, 0.25],
            is_position: 1,
            color: [1.0; 3],
            range: 2.5,
            ..Light::default()
        };
        let light = direct_light(&floor(), 7, &WHITE, &lamp);
        assert!((light.radiance[0] - 0.25 * FRAC_1_PI).abs() < 1e-6);
        assert_eq!(light.ray.t_max, 1.0);
        assert!(!direct_light(&floor(), 7, &WHITE, &Light { range: 1.5, ..lamp }).is_possible());
    }

    /// Over the floor, 2 × 6, and it shines down.
    const PANEL: Light = Light {
        point: [0.5, 2.0, 0.25],
        is_position: 1,
        color: [4.0, 2.0, 1.0],
        range: f32::MAX,
        edge_1: [1.0, 0.0, 0.0],
        shape: RECTANGLE,
        edge_2: [0.0, 0.0, 3.0],
        number: 2,
        normal: [0.0, -1.0, 0.0],
        padding: 0,
    };

    #[test]
    fn a_panel_shines_ahead_with_lamberts_cosine() {
        // Drawn at its middle, straight above.
        let light = direct_light(&floor(), 7, &WHITE, &PANEL);
        assert!((light.radiance[0] - 4.0 * 0.25 * FRAC_1_PI).abs() < 1e-6);
        let aside = Light {
            point: [2.0, 2.0, 0.25],
            ..PANEL
        };
        // 1.5 across, 2 up: both cosines are 0.8, at a distance of 2.5.
        let light = direct_light(&floor(), 7, &WHITE, &aside);
        assert!((light.radiance[0] - 4.0 * 0.64 / 6.25 * FRAC_1_PI).abs() < 1e-6);
        // From behind there is none.
        let turned = Light {
            normal: [0.0, 1.0, 0.0],
            ..PANEL
        };
        assert!(!direct_light(&floor(), 7, &WHITE, &turned).is_possible());
    }

    #[test]
    fn a_pixel_is_the_mean_of_its_own_samples() {
        let path = |radiance| Path {
            radiance,
            ..Path::default()
        };
        let paths = [[9.0, 9.0, 9.0], [1.0, 2.0, 4.0], [2.0, 4.0, 0.0]].map(path);
        assert_eq!(mean_radiance(&paths, 1, 2), Vec3::new(1.5, 3.0, 2.0));
    }

    #[test]
    fn no_shadow_ray_without_light() {
        let below = Light {
            point: [0.5, -1.0, 0.25],
            is_position: 1,
            color: [1.0; 3],
            range: f32::MAX,
            ..Light::default()
        };
        assert!(!direct_light(&floor(), 7, &WHITE, &below).is_possible());
        let level = Light {
            point: [1.0, 0.0, 0.0],
            is_position: 0,
            ..below
        };
        assert!(!direct_light(&floor(), 7, &WHITE, &level).is_possible());
        let black = Light {
            point: [0.0, 1.0, 0.0],
            color: [0.0; 3],
            ..level
        };
        assert!(!direct_light(&floor(), 7, &WHITE, &black).is_possible());
    }

    #[test]
    fn a_mirror_sends_the_path_on() {
        let path = Path::new(Ray::new([-1.0, 1.0, 0.25], [1.0, -1.0, 0.0]), 5);
        let mirror = Material {
            mirror: 0.75,
            ..WHITE
        };
        let next = path.scattered(&floor(), &mirror, 3);
        assert_eq!(next.ray.direction, [1.0, 1.0, 0.0]);
        assert_eq!((next.throughput, next.skip), ([0.75; 3], 3));
        assert_eq!(next.sample, 5);
        assert!(next.ray.origin[1] > 0.0);
        assert!(!path.scattered(&floor(), &WHITE, 3).is_alive());
    }
}
