//! The scenes: generated from the seed, and the dragon where `SLIMBVH_SCENES` has it.

use anyhow::Result;
use glam::Vec3;
use slimbvh::{Mesh, generate};
use slimbvh_bench::meshes::SUBJECTS;

/// A scene, named with its size.
pub struct Subject {
    /// The name in tables.
    pub name: String,
    /// Its triangles.
    pub mesh: Mesh,
}

impl Subject {
    fn new(name: &str, mesh: Mesh) -> Self {
        let name = format!("{name} {}", thousands(mesh.indices.len()));
        Self { name, mesh }
    }
}

/// Hills with 2·cells² triangles.
pub fn terrain(cells: u32, seed: u64) -> Subject {
    Subject::new("terrain", generate::terrain(10.0, cells, seed))
}

/// Scenes whose trees fit a large cache of a GPU.
pub fn cached(is_quick: bool, seed: u64) -> Result<Vec<Subject>> {
    let sphere = generate::icosphere(Vec3::ZERO, 1.0, if is_quick { 2 } else { 3 });
    let spheres = generate::grid_of_objects(&sphere, [5, 5, 5], Vec3::splat(3.0));
    let mut subjects = vec![Subject::new("spheres", spheres)];
    subjects.push(terrain(if is_quick { 100 } else { 660 }, seed));
    let dragon = SUBJECTS.iter().find(|subject| subject.name == "dragon");
    if let Some(dragon) = dragon.filter(|_| !is_quick)
        && let Some(mesh) = dragon.mesh()?
    {
        subjects.push(Subject::new("dragon", mesh));
    }
    Ok(subjects)
}

/// Cells along a side of the terrains that are built: 10 k, 100 k and 871 k triangles.
pub fn build_cells(is_quick: bool) -> &'static [u32] {
    if is_quick { &[71] } else { &[71, 224, 660] }
}

/// Cells along a side of the terrains that fit no cache, 10 and 30 million triangles, with the seconds that each probably takes.
pub fn large_cells(is_quick: bool) -> [(u32, f64); 2] {
    if is_quick {
        [(150, 1.0), (260, 2.0)]
    } else {
        [(2237, 15.0), (3873, 40.0)]
    }
}

/// A number with a comma before each three digits.
pub fn thousands(count: usize) -> String {
    let digits = count.to_string();
    let mut text = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_those_that_the_readme_gives() {
        assert_eq!(terrain(71, 7).name, "terrain 10,082");
        let triangles = |cells: u32| 2 * cells * cells;
        assert_eq!(triangles(build_cells(false)[2]), 871_200);
        let large = large_cells(false).map(|(cells, _)| triangles(cells));
        assert_eq!(large, [10_008_338, 30_000_258]);
        assert_eq!(thousands(999), "999");
    }
}
