//! Meshes of every awkward kind, for proptest.

mod kinds;

use proptest::prelude::*;
use slimbvh::Mesh;

pub use kinds::{
    at_one_point, equal_centres, flat, grid, grid_triangles, huge_and_tiny, random_soup, slivers,
    solid,
};

/// Three corners of each triangle.
pub type Corners = [[f32; 3]; 3];

/// A mesh of any kind and place, with a magnitude from `10^-30` to `10^30`.
pub fn any_mesh() -> impl Strategy<Value = Mesh> {
    (any_kind(), placement()).prop_map(|(mesh, placement)| placement.apply(mesh))
}

/// A mesh of some thousand triangles of all kinds, of any magnitude and place.
pub fn large_mesh() -> impl Strategy<Value = Mesh> {
    let parts = proptest::collection::vec(any_kind(), 24..48);
    (parts, placement()).prop_map(|(parts, placement)| {
        let mut mesh = Mesh::default();
        for part in parts {
            let first = mesh.vertices.len() as u32;
            let indices = part.indices.iter();
            mesh.indices
                .extend(indices.map(|corners| corners.map(|corner| first + corner)));
            mesh.vertices.extend(part.vertices);
        }
        placement.apply(mesh)
    })
}

/// Of magnitude 1 or some few units.
fn any_kind() -> impl Strategy<Value = Mesh> {
    prop_oneof![
        4 => random_soup(200),
        4 => grid(4, 120),
        2 => slivers(80),
        2 => flat(80),
        1 => at_one_point(40),
        1 => equal_centres(60),
        2 => huge_and_tiny(80),
        3 => solid(),
    ]
}

/// The place and the scale of a mesh.
#[derive(Clone, Copy, Debug)]
pub struct Placement {
    /// Factor of the coordinates.
    pub scale: f32,
    /// Added after scaling, in scaled units.
    pub translation: [f32; 3],
}

impl Placement {
    /// Moves and scales a mesh. Magnitudes up to `10^30` stay finite.
    #[must_use]
    pub fn apply(&self, mut mesh: Mesh) -> Mesh {
        for vertex in &mut mesh.vertices {
            for (x, offset) in vertex.iter_mut().zip(self.translation) {
                *x = (*x + offset) * self.scale;
            }
        }
        mesh
    }
}

/// Most often the identity; otherwise a scale, a translation that costs bits, or both.
pub fn placement() -> impl Strategy<Value = Placement> {
    let scale = prop_oneof![
        4 => Just(1.0f32),
        2 => (-30i32..=30).prop_map(|e| 10f32.powi(e)),
        1 => (-60i32..=60).prop_map(|e| 2f32.powi(e)),
    ];
    let offset = prop_oneof![3 => Just(0.0f32), 1 => -1e6f32..1e6, 1 => -100f32..100.0];
    let translation = prop_oneof![
        2 => Just([0.0; 3]),
        1 => proptest::array::uniform3(offset),
        1 => Just([148_376.0, 1234.0, -223_423.0]),
    ];
    (scale, translation).prop_map(|(scale, translation)| Placement { scale, translation })
}

/// A mesh whose triangles share no vertex.
#[must_use]
pub fn mesh_of(triangles: &[Corners]) -> Mesh {
    Mesh {
        vertices: triangles.iter().flatten().copied().collect(),
        indices: (0..triangles.len() as u32)
            .map(|i| [3 * i, 3 * i + 1, 3 * i + 2])
            .collect(),
        ..Mesh::default()
    }
}
