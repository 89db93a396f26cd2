//! Scenes: a mesh, its materials, cameras and lights.

mod area;
#[cfg(feature = "scenes")]
mod contain;
#[cfg(feature = "scenes")]
mod error;
#[cfg(feature = "scenes")]
mod faces;
mod frustum;
#[cfg(feature = "scenes")]
mod gltf;
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
mod view;

#[cfg(feature = "scenes")]
pub use error::{Indexed, LoadError};
#[cfg(feature = "scenes")]
pub use gltf::GltfError;
#[cfg(feature = "scenes")]
pub use load::{LoadOptions, load, load_bytes};

pub use frustum::frustum;
pub use target::{camera_target, light_target};
pub use view::ViewError;

use crate::Mesh;

/// Everything a picture is made from, in the caller's unit.
#[derive(Clone, Debug, Default)]
pub struct Scene {
    /// All geometry, flattened to one level.
    pub mesh: Mesh,
    /// What `Mesh::materials` points into. Empty stands for one default material.
    pub materials: Vec<Material>,
    /// Cameras, the first of which is used. Empty asks for a default camera that sees the whole model.
    pub cameras: Vec<Camera>,
    /// Lights. Empty asks for a default light.
    pub lights: Vec<Light>,
    /// Faces that a lenient loader left out because they were broken.
    pub dropped_face_count: usize,
}

/// Lambert reflection, with a share for a mirror, or for glass.
///
/// Glass bends what passes through it (Snell), and mirrors it inside where it must. It reflects nothing outside, and stops
/// light like any other surface: what is behind it lies in its shadow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Linear RGB, each 0 to 1. Of glass, also the share of each channel that passes a surface.
    pub base_color: [f32; 3],
    /// Share of light that is reflected as by a mirror, 0 to 1. Of glass it does not count.
    pub mirror: f32,
    /// Share of light that passes through, 0 to 1; above 0 for glass.
    pub transmission: f32,
    /// Index of refraction behind the front side, as a multiple of that before it. What is not above 0 counts as 1.
    pub ior: f32,
}

impl Default for Material {
    fn default() -> Self {
        Self {
            base_color: [0.8, 0.8, 0.8],
            mirror: 0.0,
            transmission: 0.0,
            ior: 1.5,
        }
    }
}

/// Where the picture is seen from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// The eye's position.
    pub eye: [f32; 3],
    /// The point in the middle of the picture.
    pub target: [f32; 3],
    /// A direction that points up in the picture; need not be perpendicular to the view.
    pub up: [f32; 3],
    /// Perspective or orthographic.
    pub projection: Projection,
}

/// How a camera spreads its rays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Projection {
    /// All rays leave the eye.
    Perspective {
        /// Full vertical angle of view in degrees, above 0 and below 180.
        vertical_fov: f32,
    },
    /// Rays leave a disc around the eye, across the view: a thin lens, which is sharp at one distance only. Blurred parts
    /// need many samples a pixel.
    ThinLens {
        /// As in [`Self::Perspective`].
        vertical_fov: f32,
        /// The disc's radius in the scene's unit; 0 makes the picture of [`Self::Perspective`].
        radius: f32,
        /// Distance of what is sharp, along the view; above 0.
        focus_distance: f32,
    },
    /// All rays are parallel. There is no lens for them.
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
        /// Where the light travels to.
        direction: [f32; 3],
        /// Linear RGB irradiance on a surface that faces the light.
        color: [f32; 3],
    },
    /// Light from one point, falling off with the squared distance.
    Point {
        /// Where it is.
        position: [f32; 3],
        /// Linear RGB radiant intensity: irradiance at distance 1.
        color: [f32; 3],
        /// Distance beyond which it lights nothing; `f32::INFINITY` for no limit.
        range: f32,
    },
    /// Light from one side of a flat surface, which casts soft shadows: each sample sees one of its points, so that many
    /// samples a pixel make them smooth. No ray sees the surface itself, and none is stopped by it.
    Area {
        /// Its middle.
        center: [f32; 3],
        /// From the middle to the rim in two directions: of a rectangle to the middles of two sides, else it is a
        /// parallelogram; of a disc two radii, else it is an ellipse. It shines to the side where the first turns to the
        /// second counter-clockwise. Two lights with the edges in either order shine to both sides.
        half_edges: [[f32; 3]; 2],
        /// Its outline.
        shape: AreaShape,
        /// Linear RGB radiant intensity straight ahead, whatever its size: far away, irradiance at distance 1. To the
        /// sides it falls off with the cosine (Lambert).
        color: [f32; 3],
        /// Distance beyond which none of its points lights anything; `f32::INFINITY` for no limit.
        range: f32,
    },
}

/// The outline of a light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AreaShape {
    /// A disc or an ellipse.
    Disc,
    /// A rectangle or a parallelogram.
    Rectangle,
}
