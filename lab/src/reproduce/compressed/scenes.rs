//! The scenes, with about the paper's numbers of triangles.

use super::super::scenes::{DRAGON, DRAGON_TRIANGLES, Source, dented_ball};
use super::SceneName;
use super::printed::{self, Printed};
use crate::own::Own;
use anyhow::Result;
use slimbvh::generate::{TorusKnot, smooth_normals, split_longest, torus_knot};
use slimbvh::topology::Topology;
use slimbvh::{Mesh, Scene};
use std::path::Path;

/// A scene that is ready for measurement.
pub struct Subject {
    pub name: String,
    pub printed: Option<Printed>,
    pub scene: Scene,
    /// The stand-in for a missing file, and why it is used.
    pub stand_in: Option<String>,
    /// Whether it is a mesh of the user's own.
    pub is_own: bool,
    /// Whether the surfaces are closed and seen from outside.
    pub is_closed: bool,
    /// Whether this is the smallest scene, whose rays open few nodes, so that a codec has little to gain.
    pub is_smallest: bool,
}

/// About 70 000 triangles, as in the paper.
const BUNNY: Source = Source {
    file: "bunny00.off",
    stand_in: || split_longest(&dented_ball(5), 70_000),
    what: "a dented ball",
};

impl Subject {
    pub fn new(name: SceneName, folder: Option<&Path>, size: [u32; 2]) -> Result<Self> {
        let mut stand_in = None;
        let (shown, mut scene, printed) = match name {
            SceneName::Shiny => ("shiny", crate::scenes::shiny(), Some(printed::SHINY)),
            SceneName::Bunny => {
                let scene = BUNNY.load(folder, &mut stand_in)?;
                ("bunny", scene, Some(printed::BUNNY))
            }
            SceneName::Dragon => {
                let mut scene = DRAGON.load(folder, &mut stand_in)?;
                if scene.mesh.indices.len() < DRAGON_TRIANGLES {
                    scene.mesh = split_longest(&scene.mesh, DRAGON_TRIANGLES);
                }
                ("dragon", scene, None)
            }
            SceneName::AsianDragon => {
                let scene = Scene {
                    mesh: dented_knot(15_000, 240),
                    ..Scene::default()
                };
                stand_in = Some("a dented knot stands in for the Asian dragon".into());
                ("asian dragon", scene, Some(printed::ASIAN_DRAGON))
            }
        };
        scene.complete(scene.mesh.bounds(), size);
        Ok(Self {
            name: shown.into(),
            printed,
            scene,
            stand_in,
            is_own: false,
            is_closed: name != SceneName::Shiny,
            is_smallest: name == SceneName::Shiny,
        })
    }

    /// A mesh of the user's own.
    pub fn own(own: &Own, size: [u32; 2]) -> Self {
        let Own { name, mut scene } = own.clone();
        scene.complete(scene.mesh.bounds(), size);
        let topology = Topology::new(&scene.mesh);
        let facts = topology.facts();
        Self {
            name,
            printed: None,
            is_closed: !facts.is_empty() && facts.iter().all(|facts| facts.reducible),
            scene,
            stand_in: None,
            is_own: true,
            is_smallest: false,
        }
    }
}

/// A closed, rough surface of `2 * segments * sides` triangles.
fn dented_knot(segments: u32, sides: u32) -> Mesh {
    let mut mesh = torus_knot(&TorusKnot {
        segments,
        sides,
        ..TorusKnot::default()
    });
    for (vertex, normal) in mesh.vertices.iter_mut().zip(&mesh.normals) {
        let [x, y, z] = *vertex;
        let coarse = (19.0 * x).sin() * (17.0 * y + 1.0).sin() * (23.0 * z + 2.0).sin();
        let fine = (97.0 * x + 1.0).sin() * (101.0 * y).sin() * (89.0 * z).sin();
        let height = 0.02 * coarse + 0.003 * fine;
        *vertex = [0, 1, 2].map(|i| vertex[i] + height * normal[i]);
    }
    smooth_normals(&mut mesh);
    mesh
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scenes_have_about_the_paper10_number_of_triangles() {
        for (name, triangles, has_stand_in) in [
            (SceneName::Shiny, 152, false),
            (SceneName::Bunny, 70_000, true),
        ] {
            let subject = Subject::new(name, None, [64, 64]).unwrap();
            assert_eq!(subject.scene.mesh.indices.len(), triangles);
            assert_eq!(subject.stand_in.is_some(), has_stand_in);
        }
    }

    #[test]
    fn the_knot_is_closed() {
        let topology = Topology::new(&dented_knot(300, 24));
        let facts = topology.facts();
        assert!(facts.len() == 1 && facts[0].reducible && facts[0].triangle_count == 14_400);
    }
}
