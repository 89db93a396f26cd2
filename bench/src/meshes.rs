//! The meshes: generated ones, and real ones from the folder that `SLIMBVH_SCENES` names.

use anyhow::{Context, Result};
use glam::Vec3;
use slimbvh::scene::{LoadOptions, load};
use slimbvh::{Mesh, generate};
use std::env;
use std::path::Path;

/// The environment variable that names the folder of real meshes.
pub const SCENES_VARIABLE: &str = "SLIMBVH_SCENES";

/// A mesh to measure with, by name.
#[derive(Clone, Copy, Debug)]
pub struct Subject {
    /// The name in tables.
    pub name: &'static str,
    source: Source,
}

#[derive(Clone, Copy, Debug)]
enum Source {
    Generated(fn() -> Mesh),
    File(&'static str),
}

/// All meshes, the real ones first.
pub const SUBJECTS: [Subject; 9] = [
    Subject::file("dragon", "dragon.ply"),
    Subject::file("armadillo", "armadillo.off"),
    Subject::file("sponza", "sponza.obj"),
    Subject::file("bunny", "bunny00.off"),
    Subject::file("elephant", "refined_elephant.off"),
    Subject::generated("icosphere", || generate::icosphere(Vec3::ZERO, 1.0, 6)),
    Subject::generated("torus knot", || {
        generate::torus_knot(&generate::TorusKnot {
            segments: 1024,
            ..generate::TorusKnot::default()
        })
    }),
    Subject::generated("terrain", || generate::terrain(10.0, 256, 7)),
    Subject::generated("grid of spheres", || {
        let sphere = generate::icosphere(Vec3::ZERO, 1.0, 3);
        generate::grid_of_objects(&sphere, [5, 5, 5], Vec3::splat(3.0))
    }),
];

impl Subject {
    /// A file in the folder of real meshes.
    #[must_use]
    pub const fn file(name: &'static str, file: &'static str) -> Self {
        let source = Source::File(file);
        Self { name, source }
    }

    const fn generated(name: &'static str, make: fn() -> Mesh) -> Self {
        let source = Source::Generated(make);
        Self { name, source }
    }

    /// The mesh. If its file is missing: `None`, and a line on standard error.
    ///
    /// # Errors
    /// If the file exists but cannot be read.
    pub fn mesh(&self) -> Result<Option<Mesh>> {
        let file = match self.source {
            Source::Generated(make) => return Ok(Some(make())),
            Source::File(file) => file,
        };
        let name = self.name;
        let Some(folder) = env::var_os(SCENES_VARIABLE) else {
            eprintln!("SKIPPED {name}: {SCENES_VARIABLE} names no folder with {file} in it");
            return Ok(None);
        };
        let path = Path::new(&folder).join(file);
        if !path.exists() {
            eprintln!("SKIPPED {name}: there is no {}", path.display());
            return Ok(None);
        }
        let scene = load(&path, &LoadOptions::default())
            .with_context(|| format!("cannot measure {name}"))?;
        Ok(Some(scene.mesh))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn generated_meshes_have_the_sizes_that_the_readme_gives() {
        let count = |name: &str| {
            let subject = SUBJECTS.iter().find(|subject| subject.name == name);
            let mesh = subject.and_then(|subject| subject.mesh().unwrap());
            mesh.map_or(0, |mesh| mesh.indices.len())
        };
        assert_eq!(count("icosphere"), 81_920);
        assert_eq!(count("torus knot"), 65_536);
        assert_eq!(count("terrain"), 131_072);
        assert_eq!(count("grid of spheres"), 160_000);
    }
}
