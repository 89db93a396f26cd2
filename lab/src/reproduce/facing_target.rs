//! Where rays of one kind come from or lead to.

use anyhow::{Context, Result};
use slimbvh::backend::TargetSides;
use slimbvh::scene::{camera_target, light_target};
use slimbvh::topology::Topology;
use slimbvh::{Division, Scene, Subset};
use slimbvh_core::classify::{Sides, VisibleSet};
use slimbvh_core::frustum::Frustum;
use slimbvh_core::orientation::Target;

/// A target, and the side of each component that faces out for it.
#[derive(Clone, Debug)]
pub struct Aim {
    pub target: Target,
    pub sides: Vec<i32>,
}

impl Aim {
    /// The scene's first camera.
    pub fn camera(scene: &Scene, topology: &Topology) -> Result<Self> {
        let camera = scene.cameras.first().context("the scene has no camera")?;
        let core = camera.to_core([1, 1], 1)?;
        Ok(Self::new(camera_target(&core), topology))
    }

    /// One of the scene's lights.
    pub fn light(scene: &Scene, index: usize, topology: &Topology) -> Result<Self> {
        let light = scene.lights.get(index).context("the scene has no light")?;
        let light = light.to_core(index)?;
        Ok(Self::new(light_target(&light), topology))
    }

    /// All lights in a ball.
    pub fn ball(center: [f32; 3], radius: f32, topology: &Topology) -> Self {
        Self::new(Target::ball(center, radius), topology)
    }

    fn new(target: Target, topology: &Topology) -> Self {
        Self {
            target,
            sides: topology.sides(&(&target).into()),
        }
    }

    /// The other half: what faces away from the target. What is not certain is in both.
    pub fn away(&self) -> Self {
        Self {
            sides: self.sides.iter().map(|side| -side).collect(),
            ..self.clone()
        }
    }

    pub fn sides<'a>(&'a self, topology: &'a Topology) -> Sides<'a> {
        Sides {
            components: topology.components(),
            sides: &self.sides,
        }
    }

    /// The papers leave out nothing for lying outside of the picture.
    pub fn reach<'a>(&'a self, topology: &'a Topology) -> VisibleSet<'a> {
        VisibleSet {
            sides: self.sides(topology),
            target: self.target,
            frustum: Frustum::EVERYWHERE,
        }
    }

    pub fn subset<'a>(&'a self, topology: &'a Topology) -> Subset<'a> {
        Subset::Of(self.reach(topology))
    }

    /// The target with these sides, for a backend.
    pub fn target_sides(&self) -> TargetSides {
        TargetSides {
            target: self.target,
            frustum: Frustum::EVERYWHERE,
            sides: self.sides.clone(),
        }
    }

    /// How many triangles are in the set.
    pub fn count(&self, scene: &Scene, topology: &Topology) -> usize {
        let mut division = Division::new();
        division.divide(&scene.mesh, &self.reach(topology));
        division.primitives().len()
    }
}
