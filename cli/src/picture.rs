//! Options of a picture, and preparation of the scene for it.

use crate::options::{self, CameraOption, LightOption};
use anyhow::{Context, Result};
use clap::{Args, ValueEnum};
use slimbvh::{Aabb, CodeBits, RenderSettings, Scene, TreeKind, Up, View};

/// Size, camera and lights of a picture.
#[derive(Debug, Args)]
pub struct SightArguments {
    /// Size of the picture in pixels
    #[arg(long, value_name = "WIDTHxHEIGHT", default_value = "1280x720", value_parser = options::size)]
    pub size: [u32; 2],

    /// Camera, any of the parts "eye=X,Y,Z target=X,Y,Z up=X,Y,Z fov=DEGREES lens=RADIUS focus=DISTANCE", or height=H in
    /// place of fov for parallel rays. A lens without focus is sharp at the target. Positions are in the file's own coordinates
    #[arg(long, value_name = "PARTS")]
    pub camera: Option<CameraOption>,

    /// Light that replaces the scene's lights; may be repeated. One of "sun=X,Y,Z color=R,G,B" with the direction of its
    /// light, "point=X,Y,Z color=R,G,B range=D", or for soft shadows "disc=X,Y,Z normal=X,Y,Z radius=R" or
    /// "rectangle=X,Y,Z edge1=X,Y,Z edge2=X,Y,Z", whose edges are half its sides and which shines along edge1 x edge2
    #[arg(long, value_name = "PARTS", value_parser = options::light)]
    pub light: Vec<LightOption>,

    /// Which axis points up, for the default camera and light; default: y, or as a slim file says
    #[arg(long, value_enum)]
    pub up: Option<Up>,
}

/// Width of the Morton codes, and how the tree is built over them.
#[derive(Debug, Args)]
pub struct CodesArguments {
    /// Bits of the Morton codes that sort the triangles: 30, or 63 for scenes with small details; default: 30
    #[arg(long, value_enum)]
    codes: Option<Codes>,

    /// Tree construction: from common prefixes of the codes, or by merging the best matching neighbours, which takes longer
    /// to build and visits fewer nodes per ray. The picture stays the same; default: radix
    #[arg(long, value_enum)]
    tree: Option<Tree>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Tree {
    /// Karras' radix tree, on both backends
    Radix,
    /// Locally ordered clustering with rotations; on the CPU only
    Clustered,
}

/// Options of a rendered picture.
#[derive(Debug, Args)]
pub struct PictureArguments {
    #[command(flatten)]
    pub sight: SightArguments,

    /// Samples per pixel: 1, 4, 16 … form a grid, any number works
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = |text: &str| options::whole(text, 1..=65536))]
    pub spp: u32,

    /// What to show
    #[arg(long, value_enum, default_value_t = View::Color)]
    pub view: View,

    /// Maximum number of mirrors and glass surfaces along a ray
    #[arg(long, value_name = "N", default_value_t = 4, value_parser = |text: &str| options::whole(text, 0..=64))]
    mirror_depth: u32,

    /// Also trace shadow rays that cannot change the picture: from surfaces that face away from a light, beyond a light's
    /// range, and to black lights
    #[arg(long)]
    dark_rays: bool,

    #[command(flatten)]
    pub codes: CodesArguments,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Codes {
    #[value(name = "30")]
    Bits30,
    #[value(name = "63")]
    Bits63,
}

impl PictureArguments {
    /// The settings of the renderer.
    pub fn settings(&self) -> RenderSettings {
        RenderSettings {
            size: self.sight.size,
            sample_count: self.spp,
            view: self.view,
            mirror_depth: self.mirror_depth,
            dark_rays: self.dark_rays,
        }
    }

    /// Whether the scene gets the default light beside the camera: neither the scene nor the arguments have a light.
    pub fn needs_light(&self, scene: &Scene) -> bool {
        self.sight.light.is_empty() && scene.lights.is_empty()
    }

    /// [`SightArguments::prepare`] with the scene's own bounds.
    pub fn prepare(&self, scene: &mut Scene, name: &str) -> Result<()> {
        self.sight.prepare(scene, name, None)
    }
}

impl CodesArguments {
    /// The name of the first of these options that was given.
    pub fn asked_for(&self) -> Option<&'static str> {
        match (self.codes, self.tree) {
            (Some(_), _) => Some("--codes"),
            (None, Some(_)) => Some("--tree"),
            (None, None) => None,
        }
    }

    /// How the tree is built.
    pub fn tree(&self) -> TreeKind {
        match self.tree {
            None | Some(Tree::Radix) => TreeKind::Radix,
            Some(Tree::Clustered) => TreeKind::Clustered,
        }
    }

    /// The requested width of the codes, or 30 bits.
    pub fn bits(&self) -> CodeBits {
        match self.codes {
            None | Some(Codes::Bits30) => CodeBits::Bits30,
            Some(Codes::Bits63) => CodeBits::Bits63,
        }
    }
}

impl SightArguments {
    /// Validates a scene, applies `--light` and `--camera` to it, and adds a default camera and light where it has none. A
    /// default camera frames `framing`, or else the scene's bounds.
    pub fn prepare(&self, scene: &mut Scene, name: &str, framing: Option<Aabb>) -> Result<()> {
        scene.up = self.up.unwrap_or(scene.up);
        if !self.light.is_empty() {
            let lights = self.light.iter();
            scene.lights = lights.map(|option| option.in_scene(scene)).collect();
        }
        scene.mesh.validate().with_context(|| name.to_owned())?;
        scene.complete(framing.or_else(|| scene.mesh.bounds()), self.size);
        if let Some(camera) = &self.camera {
            camera.apply(scene).map_err(anyhow::Error::msg)?;
        }
        Ok(())
    }
}
