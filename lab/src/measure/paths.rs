//! The rays of a picture, as the renderer traces them: from the eye, to lights, and from mirrors and glass.

use anyhow::{Context, Result};
use slimbvh::{Hit, Ray, RenderSettings, Scene};
use slimbvh_core::camera::Camera;
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::ray::NO_PRIMITIVE;
use slimbvh_core::sampling::Draw;
use slimbvh_core::shade::{Light, Material, Path, direct_light};
use slimbvh_core::snap::leaf_triangle;
use slimbvh_core::surface::Surface;

/// The kind of a ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Eye,
    /// To the light with this number.
    Shadow(usize),
    /// From a mirror or out of glass.
    Secondary,
}

/// The first hit of a sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seen {
    /// [`NO_PRIMITIVE`] for a miss.
    pub primitive: u32,
    /// The distance from the origin of the ray, in the scene's unit.
    pub distance: f32,
}

/// The inputs of all paths, scaled to the scene's magnitude.
pub struct Paths<'a> {
    scene: &'a Scene,
    scale: PowerOfTwo,
    camera: Camera,
    lights: Vec<Light>,
    materials: Vec<Material>,
    depth: u32,
    /// The length of a scaled unit in the scene's unit.
    unit: f32,
}

impl Seen {
    pub const NOTHING: Self = Self {
        primitive: NO_PRIMITIVE,
        distance: f32::INFINITY,
    };

    pub fn is_anything(&self) -> bool {
        self.primitive != NO_PRIMITIVE
    }
}

impl<'a> Paths<'a> {
    /// The paths of a scene whose tree has this exponent.
    pub fn new(scene: &'a Scene, exponent: i32, settings: &RenderSettings) -> Result<Self> {
        let scale = PowerOfTwo::new(exponent);
        let camera = scene.cameras.first().context("the scene has no camera")?;
        let camera = camera.to_core(settings.size, settings.sample_count)?;
        let lights = scene.lights.iter().enumerate();
        let lights = lights.map(|(index, light)| Ok(light.to_core(index)?.scaled(&scale)));
        Ok(Self {
            scene,
            scale,
            camera: camera.scaled(&scale),
            lights: lights.collect::<Result<_>>()?,
            materials: scene.core_materials(),
            depth: settings.mirror_depth,
            unit: 2f32.powi(-exponent),
        })
    }

    /// Follows a sample, and returns its first hit. `meet` returns the hit of a ray, skipping the triangle where it starts.
    pub fn follow(&self, sample: u32, mut meet: impl FnMut(Kind, &Ray, u32) -> Hit) -> Seen {
        let mut path = Path::new(self.camera.ray(sample), sample);
        let mut seen = Seen::NOTHING;
        for bounce in 0..=self.depth {
            let kind = match bounce {
                0 => Kind::Eye,
                _ => Kind::Secondary,
            };
            let hit = meet(kind, &path.ray, path.skip);
            if !hit.is_hit() {
                break;
            }
            if bounce == 0 {
                let direction = glam::Vec3::from(path.ray.direction);
                seen = Seen {
                    primitive: hit.primitive,
                    distance: hit.t * direction.length() * self.unit,
                };
            }
            let (surface, material) = self.surface(&path, &hit);
            let draw = Draw {
                sample,
                sample_count: self.camera.sample_count,
                bounce,
            };
            for (number, light) in self.lights.iter().enumerate() {
                let light = light.sampled(&draw);
                let shadow = direct_light(&surface, hit.primitive, &material, &light);
                if shadow.is_possible() {
                    meet(Kind::Shadow(number), &shadow.ray, shadow.skip);
                }
            }
            path = path.scattered(&surface, &material, hit.primitive);
            if !path.is_alive() {
                break;
            }
        }
        seen
    }

    /// The surface and the material that a path hit.
    fn surface(&self, path: &Path, hit: &Hit) -> (Surface, Material) {
        let mesh = &self.scene.mesh;
        let triangle = leaf_triangle(hit.primitive, &mesh.triangles(), &self.scale).triangle();
        let place = hit.primitive as usize;
        let corners = mesh.indices.get(place).copied().unwrap_or_default();
        let normals = corners.map(|corner| {
            let normal = mesh.normals.get(corner as usize);
            normal.map_or(glam::Vec3::ZERO, |&n| n.into())
        });
        let material = mesh.materials.get(place).map_or(0, |&m| m as usize);
        let material = self.materials.get(material).or(self.materials.first());
        let surface = Surface::new(triangle, hit, path.ray.direction.into(), normals);
        (surface, material.copied().unwrap_or_default())
    }
}
