//! What a picture is to be like, and the scene made ready for it.

use crate::options::{self, CameraOption};
use anyhow::{Context, Result};
use clap::{Args, ValueEnum};
use slimbvh::{Aabb, CodeBits, Light, RenderSettings, Scene, TreeKind, View};

/// How large a picture is, from where it is seen, and in what light.
#[derive(Debug, Args)]
pub struct SightArguments {
    /// Size of the picture in pixels
    #[arg(long, value_name = "WIDTHxHEIGHT", default_value = "1280x720", value_parser = options::size)]
    pub size: [u32; 2],

    /// Camera, parts as needed: "eye=X,Y,Z target=X,Y,Z up=X,Y,Z fov=DEGREES lens=RADIUS focus=DISTANCE", or height=H for
    /// parallel rays. A lens without a focus is sharp at the target
    #[arg(long, value_name = "PARTS")]
    pub camera: Option<CameraOption>,

    /// Light instead of the scene's, may be repeated: "sun=X,Y,Z color=R,G,B", where the light goes, or
    /// "point=X,Y,Z color=R,G,B range=D", or with soft shadows "disc=X,Y,Z normal=X,Y,Z radius=R" or
    /// "rectangle=X,Y,Z edge1=X,Y,Z edge2=X,Y,Z", half the sides, which shines to edge1 x edge2
    #[arg(long, value_name = "PARTS", value_parser = options::light)]
    pub light: Vec<Light>,
}

/// In what order triangles are, and how a tree is found over them.
#[derive(Debug, Args)]
pub struct CodesArguments {
    /// Bits of the codes that order triangles: 30, or 63 for scenes with small details. Without it, 30
    #[arg(long, value_enum)]
    codes: Option<Codes>,

    /// How the tree is found: by common prefixes of codes, or by merging neighbours that suit each other best, which takes
    /// longer to build and fewer nodes a ray. The picture stays the same. Without it, radix
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

/// How pictures are made.
#[derive(Debug, Args)]
pub struct PictureArguments {
    #[command(flatten)]
    pub sight: SightArguments,

    /// Samples a pixel: 1, 4, 16 … form a grid, any number works
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = |text: &str| options::whole(text, 1..=65536))]
    pub spp: u32,

    /// What to show
    #[arg(long, value_enum, default_value_t = View::Color)]
    pub view: View,

    /// How many mirrors and surfaces of glass a ray may meet
    #[arg(long, value_name = "N", default_value_t = 4, value_parser = |text: &str| options::whole(text, 0..=64))]
    mirror_depth: u32,

    /// Trace shadow rays where there is no light, too: from surfaces that face away, beyond a light's range, to black lights.
    /// The picture stays the same
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
    /// How to render.
    pub fn settings(&self) -> RenderSettings {
        RenderSettings {
            size: self.sight.size,
            sample_count: self.spp,
            view: self.view,
            mirror_depth: self.mirror_depth,
            dark_rays: self.dark_rays,
        }
    }

    /// Whether the scene gets the light that stands beside the camera, as neither it nor the arguments have any.
    pub fn needs_light(&self, scene: &Scene) -> bool {
        self.sight.light.is_empty() && scene.lights.is_empty()
    }

    /// [`SightArguments::prepare`], for the scene's own bounds.
    pub fn prepare(&self, scene: &mut Scene, name: &str) -> Result<()> {
        self.sight.prepare(scene, name, None)
    }
}

impl CodesArguments {
    /// What is asked for.
    pub fn asked_for(&self) -> Option<&'static str> {
        match (self.codes, self.tree) {
            (Some(_), _) => Some("--codes"),
            (None, Some(_)) => Some("--tree"),
            (None, None) => None,
        }
    }

    /// How trees are found.
    pub fn tree(&self) -> TreeKind {
        match self.tree {
            None | Some(Tree::Radix) => TreeKind::Radix,
            Some(Tree::Clustered) => TreeKind::Clustered,
        }
    }

    /// Those asked for, or the short ones.
    pub fn bits(&self) -> CodeBits {
        match self.codes {
            None | Some(Codes::Bits30) => CodeBits::Bits30,
            Some(Codes::Bits63) => CodeBits::Bits63,
        }
    }
}

impl SightArguments {
    /// Checks a scene and gives it the camera and the lights that are asked for, and what is missing. A camera that is missing
    /// sees this box, or the scene's.
    pub fn prepare(&self, scene: &mut Scene, name: &str, framing: Option<Aabb>) -> Result<()> {
        if !self.light.is_empty() {
            scene.lights.clone_from(&self.light);
        }
        scene.mesh.validate().with_context(|| name.to_owned())?;
        scene.complete(framing.or_else(|| scene.mesh.bounds()), self.size);
        if let Some(camera) = &self.camera {
            let applied = camera.apply(&mut scene.cameras[0]);
            applied.map_err(anyhow::Error::msg)?;
        }
        Ok(())
    }
}
