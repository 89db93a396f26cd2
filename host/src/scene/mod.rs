//! Scenes: a mesh, its materials, cameras and lights.

mod area;
#[cfg(feature = "scenes")]
mod contain;
#[cfg(feature = "scenes")]
mod cut;
#[cfg(feature = "scenes")]
mod error;
#[cfg(feature = "scenes")]
mod faces;
#[cfg(feature = "scenes")]
mod format;
mod frustum;
#[cfg(feature = "scenes")]
mod gltf;
mod left_out;
#[cfg(feature = "scenes")]
mod load;
#[cfg(feature = "scenes")]
mod obj;
#[cfg(feature = "scenes")]
mod off;
#[cfg(feature = "scenes")]
mod ply;
#[cfg(feature = "scenes")]
pub mod slim;
#[cfg(feature = "scenes")]
mod stl;
mod target;
#[cfg(all(test, feature = "scenes"))]
mod tests;
#[cfg(feature = "scenes")]
mod vertices;
mod view;
#[cfg(feature = "scenes")]
mod words;

#[cfg(feature = "scenes")]
pub use error::{Indexed, LoadError};
#[cfg(feature = "scenes")]
pub use format::Format;
#[cfg(feature = "scenes")]
pub use gltf::GltfError;
#[cfg(feature = "scenes")]
pub use load::{LoadOptions, load, load_bytes};

pub use frustum::frustum;
pub use left_out::LeftOut;
pub use target::{camera_target, light_target};
pub use view::ViewError;
pub(crate) use view::unit;

use crate::Mesh;

/// The inputs of a picture, in the caller's unit.
#[derive(Clone, Debug, Default)]
pub struct Scene {
    /// All geometry, flattened to one level.
    pub mesh: Mesh,
    /// The materials that `Mesh::materials` indexes. If empty, all triangles have one default material.
    pub materials: Vec<Material>,
    /// The first camera is used. If empty, a default camera sees the whole model.
    pub cameras: Vec<Camera>,
    /// Lights. If empty, a default light is used.
    pub lights: Vec<Light>,
    /// Broken faces that a lenient loader dropped.
    pub dropped_face_count: usize,
    /// What the file holds and the scene does not.
    pub left_out: Vec<LeftOut>,
    /// What was taken off all positions, of cameras and lights, too: add it to a position for that in the file's own coordinates. Zero
    /// unless rounding to `f32` so far away may exceed a thousandth of the median edge.
    pub origin: [f64; 3],
    /// Which axis points up.
    pub up: Up,
}

impl Scene {
    /// A position in the file's own coordinates, as the scene has it: without its [`origin`](Self::origin).
    ///
    /// ```
    /// # use slimbvh::Scene;
    /// let scene = Scene { origin: [500_000.0, 4_600_000.0, 0.0], ..Scene::default() };
    /// let local = scene.to_local([500_123.5, 4_600_001.0, 7.0]);
    /// assert_eq!(local, [123.5, 1.0, 7.0]);
    /// assert_eq!(scene.to_file(local), [500_123.5, 4_600_001.0, 7.0]);
    /// ```
    #[must_use]
    pub fn to_local(&self, position: [f64; 3]) -> [f32; 3] {
        [0, 1, 2].map(|i| (position[i] - self.origin[i]) as f32)
    }

    /// The inverse of [`Self::to_local`]: a hit's position, say, in the file's own coordinates.
    #[must_use]
    pub fn to_file(&self, position: [f32; 3]) -> [f64; 3] {
        [0, 1, 2].map(|i| f64::from(position[i]) + self.origin[i])
    }
}

/// Which axis points up: for the default camera and light.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
pub enum Up {
    /// Y, as in glTF.
    #[default]
    Y,
    /// Z, as in maps, plans and many CAD programs.
    Z,
}

/// Lambert reflection, with a share of mirror reflection or of transmission.
///
/// Glass refracts light that passes through it (Snell), with total internal reflection. It reflects nothing on the outside.
/// It casts a shadow like any other surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Linear RGB, each 0 to 1. For glass, also the transmitted share of each channel at a surface.
    pub base_color: [f32; 3],
    /// The share of light reflected as by a mirror, 0 to 1. Ignored for glass.
    pub mirror: f32,
    /// The share of light that passes through, 0 to 1; above 0 for glass.
    pub transmission: f32,
    /// The index of refraction behind the front side relative to that in front. Values not above 0 count as 1.
    pub ior: f32,
    /// Whether the back is seen like the front; otherwise the file means it to be culled. Only glTF materials can be single-sided. It
    /// changes no picture: every ray meets both sides.
    pub double_sided: bool,
}

impl Default for Material {
    fn default() -> Self {
        Self {
            base_color: [0.8, 0.8, 0.8],
            mirror: 0.0,
            transmission: 0.0,
            ior: 1.5,
            double_sided: true,
        }
    }
}

/// The point of view.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// The eye's position.
    pub eye: [f32; 3],
    /// The point in the middle of the picture.
    pub target: [f32; 3],
    /// The up direction in the picture; need not be perpendicular to the view.
    pub up: [f32; 3],
    /// Perspective or orthographic.
    pub projection: Projection,
}

/// The rays of a camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Projection {
    /// All rays leave the eye.
    Perspective {
        /// Full vertical angle of view in degrees, above 0 and below 180.
        vertical_fov: f32,
    },
    /// Rays leave a disc around the eye, perpendicular to the view: a thin lens, sharp at one distance. Blurred parts need
    /// many samples a pixel.
    ThinLens {
        /// As in [`Self::Perspective`].
        vertical_fov: f32,
        /// The disc's radius in the scene's unit; 0 gives the picture of [`Self::Perspective`].
        radius: f32,
        /// The distance in focus, along the view; above 0.
        focus_distance: f32,
    },
    /// All rays are parallel. Has no lens.
    Orthographic {
        /// Height of the picture in the scene's unit.
        height: f32,
    },
}

/// A light source.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Light {
    /// Parallel light, as from the sun.
    Directional {
        /// The direction in which the light travels.
        direction: [f32; 3],
        /// Linear RGB irradiance on a surface that faces the light.
        color: [f32; 3],
    },
    /// Light from one point, falling off with the squared distance.
    Point {
        /// The light's position.
        position: [f32; 3],
        /// Linear RGB radiant intensity: irradiance at distance 1.
        color: [f32; 3],
        /// The distance beyond which it lights nothing; `f32::INFINITY` for no limit.
        range: f32,
    },
    /// Light from one side of a flat surface, with soft shadows. Each sample uses one point of the surface, so smooth
    /// shadows need many samples a pixel. The surface itself is invisible and blocks no ray.
    Area {
        /// Its middle.
        center: [f32; 3],
        /// From the middle to the rim in two directions. Rectangle: to the middles of two sides; a parallelogram if these
        /// are not perpendicular. Disc: two radii; an ellipse if these differ. The light shines to the side from which the
        /// first turns to the second counter-clockwise. For a two-sided light, add a second one with the edges exchanged.
        half_edges: [[f32; 3]; 2],
        /// Its outline.
        shape: AreaShape,
        /// Linear RGB radiant intensity perpendicular to the surface, independent of its size: far away, the irradiance at
        /// distance 1. It falls off with the cosine of the angle (Lambert).
        color: [f32; 3],
        /// The distance beyond which none of its points lights anything; `f32::INFINITY` for no limit.
        range: f32,
    },
}

/// The outline of an area light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AreaShape {
    /// A disc or an ellipse.
    Disc,
    /// A rectangle or a parallelogram.
    Rectangle,
}
