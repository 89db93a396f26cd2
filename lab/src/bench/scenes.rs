//! The scenes to measure: files and generated scenes.

use crate::scenes::TwentyFourCell;
use anyhow::{Context, Result, bail};
use slimbvh::generate::{self, TorusKnot};
use slimbvh::scene::{LoadOptions, load};
use slimbvh::{Mesh, Scene};
use slimbvh_cli::options::CameraOption;
use std::path::Path;

/// The name and the generator of a scene.
type Generated = (&'static str, fn() -> Scene);

/// All generated scenes.
const GENERATED: [Generated; 13] = [
    ("default", generate::default_scene),
    ("shiny", crate::scenes::shiny),
    ("doll", || crate::scenes::doll(3)),
    ("toasters", || crate::scenes::toasters(57)),
    ("24-cell", || {
        crate::scenes::twenty_four_cell(&TwentyFourCell::default())
    }),
    ("teapot", || of(generate::teapot())),
    ("knot", || of(generate::torus_knot(&TorusKnot::default()))),
    ("sphere", || {
        of(generate::icosphere(glam::Vec3::ZERO, 1.0, 6))
    }),
    ("flake", || of(generate::sphere_flake(4, 2))),
    ("terrain", || of(generate::terrain(10.0, 256, 1))),
    ("grid", || {
        let ball = generate::icosphere(glam::Vec3::ZERO, 1.0, 3);
        of(generate::grid_of_objects(
            &ball,
            [5; 3],
            glam::Vec3::splat(2.5),
        ))
    }),
    ("soup", || of(generate::soup(50_000, 1))),
    ("slivers", || of(generate::slivers(20_000, 1))),
];

/// A scene that is ready for measurement.
pub struct Subject {
    pub name: String,
    pub scene: Scene,
}

impl Subject {
    /// Loads or generates the scene of this name.
    ///
    /// # Errors
    /// If there is no scene of this name, or if it cannot be measured.
    pub fn new(name: &str, size: [u32; 2], camera: Option<&CameraOption>) -> Result<Self> {
        let mut scene = open(name)?;
        scene.mesh.validate().with_context(|| name.to_owned())?;
        if scene.mesh.indices.is_empty() {
            bail!("{name:?} has no triangles; there is nothing to measure");
        }
        scene.complete(scene.mesh.bounds(), size);
        if let Some(camera) = camera {
            camera.apply(&mut scene).map_err(anyhow::Error::msg)?;
            scene.cameras[0]
                .to_core(size, 1)
                .with_context(|| format!("--camera in {name}"))?;
        }
        Ok(Self {
            name: name.to_owned(),
            scene,
        })
    }
}

fn open(name: &str) -> Result<Scene> {
    let path = Path::new(name);
    if path.exists() || path.extension().is_some() {
        return Ok(load(path, &LoadOptions::default())?);
    }
    match GENERATED.iter().find(|(known, _)| *known == name) {
        Some((_, generate)) => Ok(generate()),
        None => {
            let names = GENERATED.map(|(name, _)| name).join(", ");
            bail!(
                "there is neither a file {name:?} nor a generated scene of that name; those are {names}"
            )
        }
    }
}

fn of(mesh: Mesh) -> Scene {
    Scene {
        mesh,
        ..Scene::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_has_a_scene() {
        for (name, _) in GENERATED {
            let subject = Subject::new(name, [32, 18], None).unwrap();
            let count = subject.scene.mesh.indices.len();
            assert!((100..400_000).contains(&count), "{name}: {count}");
        }
        let error = Subject::new("sphe", [32, 18], None)
            .err()
            .unwrap()
            .to_string();
        assert!(
            error.contains("\"sphe\"") && error.contains("sphere"),
            "{error}"
        );
    }
}
