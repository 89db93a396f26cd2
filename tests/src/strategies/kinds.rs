//! One strategy for each kind of mesh, all of magnitude 1 or a few units.

use super::{Corners, mesh_of};
use crate::closed;
use glam::Vec3;
use proptest::array::uniform3;
use proptest::collection::vec;
use proptest::prelude::*;
use slimbvh::Mesh;
use slimbvh::generate;

/// Random triangles in a cube, large and small.
pub fn random_soup(most: usize) -> impl Strategy<Value = Mesh> {
    let corner = uniform3(-1.0f32..1.0);
    let large = uniform3(corner.clone());
    let small = (corner, uniform3(uniform3(-0.05f32..0.05)))
        .prop_map(|(p, offsets)| offsets.map(|o| [p[0] + o[0], p[1] + o[1], p[2] + o[2]]));
    vec(prop_oneof![large, small], 0..=most).prop_map(|triangles| mesh_of(&triangles))
}

/// Whole coordinates from -`reach` to `reach`: full of duplicates, degenerate and coplanar triangles.
pub fn grid(reach: i32, most: usize) -> impl Strategy<Value = Mesh> {
    grid_triangles(reach, most).prop_map(|triangles| {
        let corners: Vec<Corners> = triangles
            .iter()
            .map(|triangle| triangle.map(|corner| corner.map(|x| x as f32)))
            .collect();
        mesh_of(&corners)
    })
}

/// As [`grid`], as whole numbers.
pub fn grid_triangles(
    reach: i32,
    most: usize,
) -> impl Strategy<Value = Vec<crate::oracle::exact::GridTriangle>> {
    vec(uniform3(uniform3(-reach..=reach)), 0..=most)
}

/// Triangles of length about 1 that are up to ten million times as long as wide.
pub fn slivers(most: usize) -> impl Strategy<Value = Mesh> {
    let sliver = (
        uniform3(-1.0f32..1.0),
        uniform3(-1.0f32..1.0),
        uniform3(-1.0f32..1.0),
        -7f32..-1.0,
        0f32..1.0,
    );
    vec(sliver, 0..=most).prop_map(|slivers| {
        let corners: Vec<Corners> = slivers
            .iter()
            .map(|&(a, b, across, width, s)| {
                let (a, b, across) = (Vec3::from(a), Vec3::from(b), Vec3::from(across));
                let c = a.lerp(b, s) + 10f32.powf(width) * across;
                [a, b, c].map(|p| p.to_array())
            })
            .collect();
        mesh_of(&corners)
    })
}

/// All triangles in one plane across an axis.
pub fn flat(most: usize) -> impl Strategy<Value = Mesh> {
    (
        random_soup(most),
        0usize..3,
        prop_oneof![Just(0.0f32), -1f32..1.0],
    )
        .prop_map(|(mut mesh, axis, height)| {
            for vertex in &mut mesh.vertices {
                vertex[axis] = height;
            }
            mesh
        })
}

/// Many triangles, each with three equal corners.
pub fn at_one_point(most: usize) -> impl Strategy<Value = Mesh> {
    (uniform3(-1f32..1.0), 0..=most).prop_map(|(p, count)| mesh_of(&vec![[p; 3]; count]))
}

/// Triangles of all sizes around one centre: equal codes.
pub fn equal_centres(most: usize) -> impl Strategy<Value = Mesh> {
    vec((uniform3(-1f32..1.0), -1f32..1.0, 0usize..3), 0..=most).prop_map(|corners| {
        let triangles: Vec<Corners> = corners
            .iter()
            .map(|&(p, s, axis)| {
                // Opposite corners make the box's centre the origin; the third stays inside.
                let mut third = p.map(|x| x * s);
                third[axis] = -third[axis];
                [p, p.map(|x| -x), third]
            })
            .collect();
        mesh_of(&triangles)
    })
}

/// Sizes from 1 down to `10^-8` in one mesh.
pub fn huge_and_tiny(most: usize) -> impl Strategy<Value = Mesh> {
    let triangle = (
        uniform3(-1f32..1.0),
        uniform3(uniform3(-1f32..1.0)),
        0i32..=8,
    );
    vec(triangle, 0..=most).prop_map(|triangles| {
        let corners: Vec<Corners> = triangles
            .iter()
            .map(|&(place, corners, e)| {
                let size = 10f32.powi(-e);
                corners.map(|c| [0, 1, 2].map(|axis| place[axis] * (1.0 - size) + c[axis] * size))
            })
            .collect();
        mesh_of(&corners)
    })
}

/// A small closed solid.
pub fn solid() -> impl Strategy<Value = Mesh> {
    prop_oneof![
        (0u32..=2).prop_map(|level| generate::icosphere(Vec3::ZERO, 1.0, level)),
        (1u64..100, 1u32..=2).prop_map(|(seed, level)| closed::dented_sphere(level, 0.3, seed)),
        uniform3(-3f32..=1.0).prop_map(|size| {
            let size = Vec3::from(size.map(|e| 10f32.powf(e)));
            generate::cuboid(-0.3 * size, 0.7 * size)
        }),
        Just(()).prop_map(|()| closed::small_torus_knot()),
    ]
}
