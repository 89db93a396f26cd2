//! Targets of rays: the eye that they start from, or the light that they lead to.

use anyhow::{Context, Result};
use slimbvh::backend::TargetSides;
use slimbvh::scene::{camera_target, light_target};
use slimbvh::topology::Topology;
use slimbvh::{Division, Scene, Subset};
use slimbvh_core::classify::{Sides, VisibleSet};
use slimbvh_core::frustum::Frustum;
use slimbvh_core::orientation::Target;

/// A target, and for each component the side that faces out.
#[derive(Clone, Debug)]
pub struct FacingTarget {
    pub target: Target,
    pub sides: Vec<i32>,
}

impl FacingTarget {
    /// The target of the scene's first camera.
    pub fn camera(scene: &Scene, topology: &Topology) -> Result<Self> {
        let camera = scene.cameras.first().context("the scene has no camera")?;
        let core = camera.to_core([1, 1], 1)?;
        Ok(Self::new(camera_target(&core), topology))
    }

    /// The target of one of the scene's lights.
    pub fn light(scene: &Scene, index: usize, topology: &Topology) -> Result<Self> {
        let light = scene.lights.get(index).context("the scene has no light")?;
        let light = light.to_core(index)?;
        Ok(Self::new(light_target(&light), topology))
    }

    /// The target of all lights in a ball.
    pub fn ball(center: [f32; 3], radius: f32, topology: &Topology) -> Self {
        Self::new(Target::ball(center, radius), topology)
    }

    fn new(target: Target, topology: &Topology) -> Self {
        Self {
            target,
            sides: topology.sides(&(&target).into()),
        }
    }

    /// The same target with the back set: the triangles that face away. Uncertain triangles are in both sets.
    pub fn back(&self) -> Self {
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

    /// The set for this target. As in the papers, it keeps triangles outside of the picture.
    pub fn visible_set<'a>(&'a self, topology: &'a Topology) -> VisibleSet<'a> {
        VisibleSet {
            sides: self.sides(topology),
            target: self.target,
            frustum: Frustum::EVERYWHERE,
        }
    }

    pub fn subset<'a>(&'a self, topology: &'a Topology) -> Subset<'a> {
        Subset::Of(self.visible_set(topology))
    }

    /// The target and its sides, for a backend.
    pub fn target_sides(&self) -> TargetSides {
        TargetSides {
            target: self.target,
            frustum: Frustum::EVERYWHERE,
            sides: self.sides.clone(),
        }
    }

    /// The number of triangles in the set.
    pub fn count(&self, scene: &Scene, topology: &Topology) -> usize {
        let mut division = Division::new();
        division.divide(&scene.mesh, &self.visible_set(topology));
        division.primitives().len()
    }
}
