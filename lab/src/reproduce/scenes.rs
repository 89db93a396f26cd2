//! The scenes, with exactly the paper's numbers of triangles.

use super::SceneName;
use super::printed::{self, Printed};
use crate::own::Own;
use anyhow::Result;
use slimbvh::scene::{LoadOptions, load};
use slimbvh::topology::Topology;
use slimbvh::{BuildConfig, Mesh, Scene, generate, reduce};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A scene that is ready for measurement.
pub struct Subject {
    pub name: String,
    pub printed: Option<Printed>,
    pub scene: Scene,
    pub topology: Arc<Topology>,
    /// The stand-in for a missing file, and why it is used.
    pub stand_in: Option<String>,
    /// Whether it is a mesh of the user's own.
    pub is_own: bool,
    /// Whether triangles are spread evenly over closed surfaces, so that half of them face any eye.
    pub is_uniform: bool,
}

/// A scene file, and its stand-in.
pub struct Source {
    pub file: &'static str,
    pub stand_in: fn() -> Mesh,
    pub what: &'static str,
}

const ARMADILLO: Source = Source {
    file: "armadillo.off",
    stand_in: || dented_ball(6),
    what: "a dented ball",
};

pub const DRAGON: Source = Source {
    file: "dragon.ply",
    stand_in: knot,
    what: "a torus knot",
};

/// The number of triangles of the dragon, which the paper does not have.
pub const DRAGON_TRIANGLES: usize = 871_414;

impl Subject {
    /// Loads or generates a scene, and surveys its surfaces.
    pub fn new(name: SceneName, folder: Option<&Path>, size: [u32; 2]) -> Result<Self> {
        let mut stand_in = None;
        let (shown, scene, printed) = match name {
            SceneName::Doll => ("doll", crate::scenes::doll(3), Some(printed::DOLL)),
            SceneName::Toasters => (
                "toasters",
                crate::scenes::toasters(57),
                Some(printed::TOASTERS),
            ),
            SceneName::TwentyFourCell => (
                "24-cell",
                crate::scenes::twenty_four_cell(&crate::scenes::TwentyFourCell::default()),
                Some(printed::TWENTY_FOUR_CELL),
            ),
            SceneName::Armadillo => {
                let scene = ARMADILLO.load(folder, &mut stand_in)?;
                ("armadillo", scene, Some(printed::ARMADILLO))
            }
            SceneName::Dragon => ("dragon", DRAGON.load(folder, &mut stand_in)?, None),
        };
        let triangles = printed
            .as_ref()
            .map_or(DRAGON_TRIANGLES, |printed| printed.triangles);
        let mut scene = scene;
        scene.mesh = generate::split_longest(&scene.mesh, triangles);
        scene.complete(scene.mesh.bounds(), size);
        let topology = surveyed(&scene)?;
        Ok(Self {
            name: shown.into(),
            printed,
            scene,
            topology,
            stand_in,
            is_own: false,
            is_uniform: name != SceneName::Toasters,
        })
    }

    /// A mesh of the user's own.
    pub fn own(own: &Own, size: [u32; 2]) -> Result<Self> {
        let Own { name, mut scene } = own.clone();
        scene.complete(scene.mesh.bounds(), size);
        let topology = surveyed(&scene)?;
        Ok(Self {
            name,
            printed: None,
            scene,
            topology,
            stand_in: None,
            is_own: true,
            is_uniform: false,
        })
    }
}

/// The surfaces of a scene.
fn surveyed(scene: &Scene) -> Result<Arc<Topology>> {
    let survey = reduce::survey(&scene.mesh, BuildConfig::default(), reduce::Seams::Find)?;
    Ok(survey.topology)
}

impl Source {
    pub fn load(&self, folder: Option<&Path>, note: &mut Option<String>) -> Result<Scene> {
        let path: Option<PathBuf> = folder.map(|folder| folder.join(self.file));
        if let Some(path) = path.filter(|path| path.exists()) {
            return Ok(load(&path, &LoadOptions::default())?);
        }
        let Self { file, what, .. } = self;
        *note = Some(format!(
            "{what} stands in for {file}, which is in no folder named by --scenes or SLIMBVH_SCENES"
        ));
        Ok(Scene {
            mesh: (self.stand_in)(),
            ..Scene::default()
        })
    }
}

/// A closed surface with valleys, which casts shadows on itself.
pub fn dented_ball(subdivisions: u32) -> Mesh {
    let mut mesh = generate::icosphere(glam::Vec3::ZERO, 1.0, subdivisions);
    for vertex in &mut mesh.vertices {
        let [x, y, z] = *vertex;
        let dent = (5.0 * x).sin() * (6.0 * y + 1.0).sin() * (4.0 * z + 2.0).sin();
        let radius = 1.0 + 0.3 * dent;
        *vertex = [x * radius, y * radius, z * radius];
    }
    mesh
}

fn knot() -> Mesh {
    generate::torus_knot(&generate::TorusKnot {
        segments: 4096,
        sides: 106,
        ..generate::TorusKnot::default()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_scene_has_the_paper10_number_of_triangles() {
        for (name, triangles) in [
            (SceneName::Doll, 71_450),
            (SceneName::Toasters, 105_774),
            (SceneName::TwentyFourCell, 122_882),
            (SceneName::Armadillo, 331_906),
        ] {
            let subject = Subject::new(name, None, [64, 64]).unwrap();
            assert_eq!(subject.scene.mesh.indices.len(), triangles);
            assert_eq!(subject.stand_in.is_some(), name == SceneName::Armadillo);
            let facts = subject.topology.facts();
            assert!(
                facts.iter().all(|facts| facts.reducible),
                "{}",
                subject.name
            );
        }
    }

    #[test]
    fn the_stand_in_of_the_dragon_has_fewer_triangles_by_an_even_number() {
        let count = knot().indices.len();
        assert!(count <= DRAGON_TRIANGLES && (DRAGON_TRIANGLES - count).is_multiple_of(2));
    }
}
