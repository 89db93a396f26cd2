//! Conversion of a scene's camera and lights to core's, in the caller's unit. Core scales them to the scene's magnitude.

use super::area::normal;
use super::{Camera, Light, Material, Projection, Scene, Up};
use crate::dvec3::{cross, dot, normalized};
use glam::Vec3;
use slimbvh_core::float::{abs, exponent, max, scale_by_power_of_two};
use slimbvh_core::shade::Environment;
use slimbvh_core::{Aabb, Ray};
use thiserror::Error;

/// Why a camera or a light cannot be rendered.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum ViewError {
    /// A picture without pixels.
    #[error("the picture would be {width}x{height} pixels; both sides must be at least 1")]
    EmptyPicture {
        /// The width.
        width: u32,
        /// The height.
        height: u32,
    },
    /// More samples than a `u32` can index.
    #[error(
        "{width}x{height} pixels with {sample_count} samples each are too many: at most 4294967295 samples"
    )]
    TooManySamples {
        /// The width.
        width: u32,
        /// The height.
        height: u32,
        /// Samples a pixel.
        sample_count: u32,
    },
    /// The number of samples is 0 or too large.
    #[error("{sample_count} samples a pixel are asked for; it must be from 1 to 65536")]
    SampleCount {
        /// Samples a pixel.
        sample_count: u32,
    },
    /// The scene's mesh is not the one of the hierarchy.
    #[error(
        "the mesh has {triangle_count} triangles, the hierarchy {expected}; build it over this mesh"
    )]
    OtherMesh {
        /// Triangles of the mesh.
        triangle_count: usize,
        /// Triangles of the hierarchy.
        expected: usize,
    },
    /// The camera is too far away for the scene's size.
    #[error("the camera at ({}, {}, {}) is too far away to see a scene this small", .eye[0], .eye[1], .eye[2])]
    TooFar {
        /// The camera's position.
        eye: [f32; 3],
    },
    /// The scene has no camera.
    #[error("the scene has no camera")]
    NoCamera,
    /// The camera has no direction.
    #[error("the camera is at its own look-at point ({}, {}, {}); move one of them", .eye[0], .eye[1], .eye[2])]
    NoDirection {
        /// The camera's position.
        eye: [f32; 3],
    },
    /// A number of the camera is NaN or infinite.
    #[error("the camera has a position or direction that is not finite")]
    CameraNotFinite,
    /// The angle of view is out of range.
    #[error(
        "the camera's vertical angle of view is {degrees} degrees; it must be above 0 and below 180"
    )]
    AngleOfView {
        /// The angle.
        degrees: f32,
    },
    /// The height of a parallel view is out of range.
    #[error("the camera's picture is {height} high; the height must be above 0")]
    PictureHeight {
        /// The height.
        height: f32,
    },
    /// The lens is out of range.
    #[error(
        "the camera's lens has radius {radius} and is sharp at distance {focus_distance}; the radius must be 0 or more, the \
         distance above 0"
    )]
    Lens {
        /// The radius.
        radius: f32,
        /// The distance in focus.
        focus_distance: f32,
    },
    /// A view target whose numbers describe none.
    #[error("a view target's {fault}")]
    Target {
        /// What it needs.
        fault: &'static str,
    },
    /// A light with a NaN, a negative color, a zero direction, or no area.
    #[error("light {} {fault}", .index + 1)]
    Light {
        /// The light, counted from 0; the message counts from 1.
        index: usize,
        /// Its fault.
        fault: &'static str,
    },
}

impl Camera {
    /// A camera in front of a box, a little to the side and above, that sees the whole box in a picture of this aspect
    /// ratio, where this axis points up.
    ///
    /// ```
    /// use slimbvh::{Aabb, Camera, Up};
    /// let bounds = Aabb { min: [-1.0; 3].into(), max: [1.0; 3].into() };
    /// let camera = Camera::facing_up(&bounds, 16.0 / 9.0, Up::Z);
    /// assert_eq!(camera.up, [0.0, 0.0, 1.0]);
    /// assert!(camera.eye[2] > 0.0);
    /// ```
    #[must_use]
    pub fn facing_up(bounds: &Aabb, aspect: f32, up: Up) -> Self {
        match up {
            Up::Y => Self::facing(bounds, aspect),
            Up::Z => {
                // Turned about x, so that z becomes y; then back.
                let turned = Aabb {
                    min: Vec3::new(bounds.min.x, bounds.min.z, -bounds.max.y),
                    max: Vec3::new(bounds.max.x, bounds.max.z, -bounds.min.y),
                };
                let camera = Self::facing(&turned, aspect);
                let back = |[x, y, z]: [f32; 3]| [x, -z, y];
                Self {
                    eye: back(camera.eye),
                    target: back(camera.target),
                    up: back(camera.up),
                    ..camera
                }
            }
        }
    }

    /// [`Self::facing_up`] with y up.
    #[must_use]
    pub fn facing(bounds: &Aabb, aspect: f32) -> Self {
        const VERTICAL_FOV: f32 = 35.0;
        const MARGIN: f64 = 0.94;
        /// 16 steps or more of a coordinate.
        const LEAST_DISTANCE: f64 = 16.0 * f32::EPSILON as f64;
        // In f64, because a box may span all of f32.
        let wide = |v: Vec3| v.to_array().map(f64::from);
        let (low, high) = (wide(bounds.min), wide(bounds.max));
        let center: [f64; 3] = std::array::from_fn(|i| 0.5 * (low[i] + high[i]));
        let half: [f64; 3] = std::array::from_fn(|i| 0.5 * (high[i] - low[i]));

        // Move back until every corner is inside the picture.
        let toward_eye = [0.36, 0.24, 0.9016];
        let right = normalized([toward_eye[2], 0.0, -toward_eye[0]]);
        let up = cross(toward_eye, right);
        let tangent = f64::from(VERTICAL_FOV.to_radians() / 2.0).tan() * MARGIN;
        let corners = (0..8).map(|corner| -> [f64; 3] {
            std::array::from_fn(|i| {
                if corner >> i & 1 == 0 {
                    -half[i]
                } else {
                    half[i]
                }
            })
        });
        let distance = corners.fold(0.0, |distance: f64, corner| {
            let across = dot(corner, right).abs() / (tangent * f64::from(aspect));
            let along = dot(corner, up).abs() / tangent;
            distance.max(dot(corner, toward_eye) + across.max(along))
        });

        // A point or almost: keep the eye some steps of `f32` away from it.
        let largest = center.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
        let distance = distance
            .max(largest * LEAST_DISTANCE)
            .max(f64::from(f32::MIN_POSITIVE));
        Self {
            // A box of all of `f32` is viewed from inside.
            eye: std::array::from_fn(|i| {
                let eye = (center[i] + toward_eye[i] * distance) as f32;
                eye.clamp(-f32::MAX, f32::MAX)
            }),
            target: center.map(|x| x as f32),
            up: [0.0, 1.0, 0.0],
            projection: Projection::Perspective {
                vertical_fov: VERTICAL_FOV,
            },
        }
    }

    /// The camera in core's form, in the caller's unit.
    ///
    /// # Errors
    /// For a camera that cannot be rendered.
    pub fn to_core(
        &self,
        [width, height]: [u32; 2],
        sample_count: u32,
    ) -> Result<slimbvh_core::camera::Camera, ViewError> {
        if width == 0 || height == 0 {
            return Err(ViewError::EmptyPicture { width, height });
        }
        if !(1..=1 << 16).contains(&sample_count) {
            return Err(ViewError::SampleCount { sample_count });
        }
        let samples = u128::from(width) * u128::from(height) * u128::from(sample_count);
        if samples > u128::from(u32::MAX) {
            return Err(ViewError::TooManySamples {
                width,
                height,
                sample_count,
            });
        }
        let numbers = self.eye.iter().chain(&self.target).chain(&self.up);
        if numbers.into_iter().any(|x| !x.is_finite()) {
            return Err(ViewError::CameraNotFinite);
        }

        // At magnitude 1 neither differences nor squares overflow.
        let points = self.eye.iter().chain(&self.target);
        let largest = points.fold(0.0, |largest, &x| max(largest, abs(x)));
        let to_one = -exponent(largest) - 1;
        let scale = |p: [f32; 3]| Vec3::from_array(p.map(|x| scale_by_power_of_two(x, to_one)));
        let toward = unit((scale(self.target) - scale(self.eye)).to_array())
            .ok_or(ViewError::NoDirection { eye: self.eye })?;
        let right = unit(toward.cross(unit(self.up).unwrap_or(Vec3::Y)).to_array())
            .unwrap_or_else(|| toward.any_orthonormal_vector());
        let up = right.cross(toward);
        // A height in the caller's unit is scaled to magnitude 1 and back.
        let (half_height, magnitude, is_parallel) = match self.projection {
            Projection::Perspective { vertical_fov }
            | Projection::ThinLens { vertical_fov, .. } => {
                if !(vertical_fov > 0.0 && vertical_fov < 180.0) {
                    return Err(ViewError::AngleOfView {
                        degrees: vertical_fov,
                    });
                }
                ((vertical_fov.to_radians() / 2.0).tan(), 0, 0)
            }
            Projection::Orthographic { height } => {
                if !(height > 0.0 && height.is_finite()) {
                    return Err(ViewError::PictureHeight { height });
                }
                let magnitude = exponent(height);
                let height = scale_by_power_of_two(height, -magnitude);
                (height / 2.0, magnitude, 1)
            }
        };
        let (lens_radius, lens_slope) = self.lens()?;
        let half_width = half_height * width as f32 / height as f32;
        let edge = |v: Vec3| {
            v.to_array()
                .map(|x| scale_by_power_of_two(x, magnitude).clamp(-f32::MAX, f32::MAX))
        };
        Ok(slimbvh_core::camera::Camera {
            eye: self.eye,
            is_parallel,
            forward: toward.to_array(),
            width,
            right: edge(right * half_width),
            height,
            up: edge(up * half_height),
            sample_count,
            lens_right: right.to_array(),
            lens_radius,
            lens_up: up.to_array(),
            lens_slope,
        })
    }

    /// The ray of a pixel, `[0, 0]` the upper left one: the ray that a picture of this size with one sample a pixel traces.
    ///
    /// Picking: which part and which material a pixel shows.
    ///
    /// ```
    /// use slimbvh::{BuildConfig, Builder, Camera, Material, Mesh, Part, Projection, Scene};
    /// # let scene = Scene {
    /// #     mesh: Mesh {
    /// #         vertices: vec![[-1.0, -1.0, 0.0], [3.0, -1.0, 0.0], [-1.0, 3.0, 0.0]],
    /// #         indices: vec![[0, 1, 2]],
    /// #         parts: vec![Part { name: "door".into(), first_triangle: 0, triangle_count: 1 }],
    /// #         ..Mesh::default()
    /// #     },
    /// #     materials: vec![Material { base_color: [1.0, 0.0, 0.0], ..Material::default() }],
    /// #     ..Scene::default()
    /// # };
    ///
    /// let bvh = Builder::new(BuildConfig::default()).build(&scene.mesh)?;
    /// let camera = Camera {
    ///     eye: [0.0, 0.0, 4.0],
    ///     target: [0.0, 0.0, 0.0],
    ///     up: [0.0, 1.0, 0.0],
    ///     projection: Projection::Perspective { vertical_fov: 30.0 },
    /// };
    /// let hit = bvh.closest_hit(camera.ray([320, 180], [640, 360])?);
    /// if hit.is_hit() {
    ///     let part = scene.mesh.part_of(hit.primitive).map(|part| part.name.as_str());
    ///     let color = scene.material_of(hit.primitive).base_color;
    ///     assert_eq!((part, color), (Some("door"), [1.0, 0.0, 0.0]));
    /// }
    /// # assert!(hit.is_hit());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// For a camera that cannot be rendered, and a picture without pixels.
    pub fn ray(&self, pixel: [u32; 2], size: [u32; 2]) -> Result<Ray, ViewError> {
        Ok(self.to_core(size, 1)?.ray_through(pixel, 0))
    }

    /// The ray at a position in the picture, in pixels from its upper left corner: the middle of pixel `[x, y]` is at
    /// `[x + 0.5, y + 0.5]`. Positions outside continue the picture. A thin lens is passed in its middle.
    ///
    /// ```
    /// # use slimbvh::{Camera, Projection};
    /// # let camera = Camera {
    /// #     eye: [0.0, 0.0, 4.0],
    /// #     target: [0.0, 0.0, 0.0],
    /// #     up: [0.0, 1.0, 0.0],
    /// #     projection: Projection::Perspective { vertical_fov: 30.0 },
    /// # };
    /// let mouse = [320.0, 180.0];
    /// let ray = camera.ray_at(mouse, [640, 360])?;
    /// assert_eq!(ray.direction, [0.0, 0.0, -1.0]);
    /// # Ok::<(), slimbvh::ViewError>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`Self::ray`].
    pub fn ray_at(&self, position: [f32; 2], size: [u32; 2]) -> Result<Ray, ViewError> {
        let camera = slimbvh_core::camera::Camera {
            lens_radius: 0.0,
            ..self.to_core(size, 1)?
        };
        Ok(camera.ray_at(position, 0))
    }

    /// The radius of the lens, and its quotient with the distance in focus; zeros without a lens.
    fn lens(&self) -> Result<(f32, f32), ViewError> {
        let Projection::ThinLens {
            radius,
            focus_distance,
            ..
        } = self.projection
        else {
            return Ok((0.0, 0.0));
        };
        let slope = radius / focus_distance;
        let is_sound = radius >= 0.0 && focus_distance > 0.0 && focus_distance.is_finite();
        if is_sound && slope.is_finite() {
            Ok((radius, slope))
        } else {
            Err(ViewError::Lens {
                radius,
                focus_distance,
            })
        }
    }

    /// Checks that a scene of this exponent can be seen from the camera's position.
    ///
    /// # Errors
    /// [`ViewError::TooFar`] if its distance exceeds the range of numbers at the scene's magnitude.
    pub fn check_reach(&self, scene_exponent: i32) -> Result<(), ViewError> {
        let radius = match self.projection {
            Projection::ThinLens { radius, .. } => radius,
            _ => 0.0,
        };
        let reaches = |&x: &f32| scale_by_power_of_two(abs(x) + radius, scene_exponent).is_finite();
        if self.eye.iter().all(reaches) {
            Ok(())
        } else {
            Err(ViewError::TooFar { eye: self.eye })
        }
    }
}

impl Light {
    /// A directional light from behind the camera, on its left.
    #[must_use]
    pub fn beside(camera: &Camera) -> Self {
        let toward = Vec3::from_array(camera.target) * 0.5 - Vec3::from_array(camera.eye) * 0.5;
        let toward = unit(toward.to_array()).unwrap_or(-Vec3::Z);
        let up = unit(camera.up).unwrap_or(Vec3::Y);
        let right =
            unit(toward.cross(up).to_array()).unwrap_or_else(|| toward.any_orthonormal_vector());
        let direction = toward + right * 0.6 - up * 0.9;
        Self::Directional {
            direction: direction.to_array(),
            color: [2.6, 2.5, 2.4],
        }
    }

    /// The light in core's form, in the caller's unit.
    ///
    /// # Errors
    /// For an invalid light. `index` is for the message, and gives each light different sample points on its surface.
    pub fn to_core(&self, index: usize) -> Result<slimbvh_core::shade::Light, ViewError> {
        let fault = |fault| ViewError::Light { index, fault };
        let (Self::Directional { color, .. }
        | Self::Point { color, .. }
        | Self::Area { color, .. }) = *self;
        if color.iter().any(|x| !x.is_finite() || *x < 0.0) {
            return Err(fault("has a color that is negative or not finite"));
        }
        let reach = |position: [f32; 3], range: f32| {
            if position.iter().any(|x| !x.is_finite()) {
                return Err(fault("has a position that is not finite"));
            }
            if range.is_nan() || range <= 0.0 {
                return Err(fault("has a range that is not above 0"));
            }
            Ok(range.min(f32::MAX))
        };
        match *self {
            Self::Directional { direction, .. } => {
                let toward = unit(direction).ok_or(fault("has no direction"))?;
                Ok(slimbvh_core::shade::Light {
                    point: (-toward).to_array(),
                    is_position: 0,
                    color,
                    range: f32::MAX,
                    ..Default::default()
                })
            }
            Self::Point {
                position, range, ..
            } => Ok(slimbvh_core::shade::Light {
                point: position,
                is_position: 1,
                color,
                range: reach(position, range)?,
                ..Default::default()
            }),
            Self::Area {
                center,
                half_edges,
                shape,
                range,
                ..
            } => {
                if half_edges.as_flattened().iter().any(|x| !x.is_finite()) {
                    return Err(fault("has an edge that is not finite"));
                }
                let normal = normal(half_edges).ok_or(fault("has no area"))?;
                let [edge_1, edge_2] = half_edges;
                Ok(slimbvh_core::shade::Light {
                    point: center,
                    is_position: 1,
                    color,
                    range: reach(center, range)?,
                    edge_1,
                    shape: shape.to_core(),
                    edge_2,
                    number: index as u32,
                    normal,
                    padding: 0,
                })
            }
        }
    }
}

impl Scene {
    /// Adds a camera that sees the whole model and a light, if they are missing, for a picture of this size.
    pub fn complete(&mut self, bounds: Option<Aabb>, [width, height]: [u32; 2]) {
        if self.cameras.is_empty() {
            let aspect = width.max(1) as f32 / height.max(1) as f32;
            let origin = Aabb {
                min: Vec3::ZERO,
                max: Vec3::ZERO,
            };
            self.cameras.push(Camera::facing_up(
                &bounds.unwrap_or(origin),
                aspect,
                self.up,
            ));
        }
        if self.lights.is_empty() {
            self.lights.push(Light::beside(&self.cameras[0]));
        }
    }

    /// The environment of all pictures: a pale sky, brighter at the horizon, and a little ambient light.
    #[must_use]
    pub fn environment(up: [f32; 3]) -> Environment {
        Environment {
            ambient: [0.42, 0.46, 0.52],
            zenith: [0.22, 0.34, 0.55],
            horizon: [0.62, 0.68, 0.74],
            up: unit(up).unwrap_or(Vec3::Y).to_array(),
            ..Environment::default()
        }
    }

    /// The material of a triangle, as pictures show it: the first one where `Mesh::materials` is empty or names none, and the default
    /// material if there are none.
    ///
    /// ```
    /// # use slimbvh::{Material, Mesh, Scene};
    /// # let glass = Material { transmission: 1.0, ..Material::default() };
    /// let scene = Scene {
    ///     mesh: Mesh { materials: vec![1, 0], ..Mesh::default() },
    ///     materials: vec![Material::default(), glass],
    ///     ..Scene::default()
    /// };
    /// assert_eq!(scene.material_of(0), glass);
    /// assert_eq!(scene.material_of(1), Material::default());
    /// ```
    #[must_use]
    pub fn material_of(&self, primitive: u32) -> Material {
        let index = self.mesh.materials.get(primitive as usize);
        let material = self.materials.get(index.map_or(0, |&index| index as usize));
        let material = material.or(self.materials.first());
        material.copied().unwrap_or_default()
    }

    /// The materials in core's form; a default one if there are none.
    #[must_use]
    pub fn core_materials(&self) -> Vec<slimbvh_core::shade::Material> {
        let to_core = |material: &Material| slimbvh_core::shade::Material {
            base_color: material.base_color,
            mirror: material.mirror,
            transmission: material.transmission,
            ior: if material.ior > 0.0 && material.ior.is_finite() {
                material.ior
            } else {
                1.0
            },
            padding: [0; 2],
        };
        if self.materials.is_empty() {
            vec![to_core(&Material::default())]
        } else {
            self.materials.iter().map(to_core).collect()
        }
    }
}

/// The unit vector along three finite numbers, unless all are zero.
pub(crate) fn unit(v: [f32; 3]) -> Option<Vec3> {
    let finite = v.iter().all(|x| x.is_finite());
    let v = Vec3::from_array(v);
    // Tiny vectors are scaled up first: their directions are valid.
    let v = if v.abs().max_element() < 1e-20 {
        v * slimbvh_core::float::power_of_two(100)
    } else {
        v
    };
    let unit = slimbvh_core::surface::normalize(v);
    (finite && unit != Vec3::ZERO).then_some(unit)
}
