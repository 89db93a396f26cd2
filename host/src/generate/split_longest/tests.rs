use super::*;
use crate::analysis::{Component, analyze};
use crate::generate::checks::assert_solid;
use crate::generate::{append, cuboid, icosphere};
use proptest::prelude::*;

fn two_solids(extents: [f32; 3], subdivisions: u32) -> Mesh {
    let mut mesh = Mesh::default();
    let solid = cuboid(Vec3::ZERO, extents.into());
    append(&mut mesh, solid, "cuboid", 3);
    let ball = icosphere(Vec3::new(0.0, 20.0, 0.0), 1.5, subdivisions);
    append(&mut mesh, ball, "ball", 8);
    mesh
}

/// The longest edge.
fn longest(mesh: &Mesh) -> f32 {
    let edges = mesh
        .indices
        .iter()
        .flat_map(|t| [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]]);
    let lengths = edges.map(|edge| {
        let [a, b] = edge.map(|v| Vec3::from(mesh.vertices[v as usize]));
        a.distance(b)
    });
    lengths.fold(0.0, f32::max)
}

fn closed(mesh: &Mesh) -> Vec<bool> {
    let components = analyze(mesh).components;
    components
        .iter()
        .map(|component: &Component| component.closed)
        .collect()
}

proptest! {
    #[test]
    fn a_closed_mesh_stays_closed_and_even_counts_are_met(
        extents in proptest::array::uniform3(0.5f32..9.0),
        subdivisions in 0u32..3,
        splits in 0usize..400,
    ) {
        let mesh = two_solids(extents, subdivisions);
        let count = mesh.indices.len() + 2 * splits;
        let fine = split_longest(&mesh, count);
        prop_assert_eq!(fine.indices.len(), count);
        let components = assert_solid(&fine);
        prop_assert_eq!(components.len(), 2);
        prop_assert!(longest(&fine) <= longest(&mesh));
        let volume: f64 = components.iter().map(|component| component.signed_volume).sum();
        let before: f64 = assert_solid(&mesh).iter().map(|component| component.signed_volume).sum();
        prop_assert!((volume - before).abs() < 1e-5 * before);

        // Odd counts are exceeded by one.
        prop_assert_eq!(split_longest(&mesh, count + 1).indices.len(), count + 2);

        // Materials and parts follow their triangles: the ball is the upper part.
        prop_assert_eq!(fine.validate(), Ok(()));
        for part in &fine.parts {
            let expected = if part.name == "ball" { (true, 8) } else { (false, 3) };
            for triangle in part.first_triangle..part.first_triangle + part.triangle_count {
                let [corner, ..] = fine.indices[triangle as usize];
                let is_above = fine.vertices[corner as usize][1] > 15.0;
                prop_assert_eq!((is_above, fine.materials[triangle as usize]), expected);
            }
        }
    }
}

/// A mesh that lacks a triangle is open before and after; a split at its rim adds one triangle.
#[test]
fn an_open_mesh_stays_open() {
    let mut mesh = cuboid(Vec3::ZERO, Vec3::new(4.0, 2.0, 1.0));
    mesh.indices.pop();
    let fine = split_longest(&mesh, 500);
    assert!((500..=501).contains(&fine.indices.len()));
    assert_eq!((closed(&mesh), closed(&fine)), (vec![false], vec![false]));
    let triangle = Mesh {
        vertices: vec![[0.0; 3], [3.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        indices: vec![[0, 1, 2]],
        ..Mesh::default()
    };
    let halves = split_longest(&triangle, 2);
    assert_eq!(halves.vertices[3], [1.5, 0.5, 0.0]);
    assert_eq!(halves.indices, [[0, 1, 3], [0, 3, 2]]);
}

/// A mesh whose triangles share positions but no vertices, each with its own normal.
#[test]
fn edges_shared_by_position_stay_shared() {
    let ball = icosphere(Vec3::ZERO, 2.0, 1);
    let mut apart = Mesh::default();
    for triangle in &ball.indices {
        let first = apart.vertices.len() as u32;
        let corners = triangle.map(|vertex| Vec3::from(ball.vertices[vertex as usize]));
        let normal = (corners[0] + corners[1] + corners[2]).normalize();
        apart
            .vertices
            .extend(corners.map(|corner| corner.to_array()));
        apart.normals.extend([normal.to_array(); 3]);
        apart.indices.push([first, first + 1, first + 2]);
    }
    let fine = split_longest(&apart, 700);
    assert_eq!((fine.indices.len(), closed(&fine)), (700, vec![true]));
    assert_eq!(fine.validate(), Ok(()));
    for triangle in &fine.indices {
        let [a, b, c] = triangle.map(|vertex| Vec3::from(fine.normals[vertex as usize]));
        assert!(a.distance(b) < 1e-6 && a.distance(c) < 1e-6);
    }
}

/// The control: a split of only one triangle at an edge leaves a hole.
#[test]
fn a_split_on_one_side_alone_would_open_it() {
    let mesh = icosphere(Vec3::ZERO, 1.0, 1);
    let mut splitting = Splitting::new(mesh);
    let (_, Reverse(edge)) = *splitting.queue.peek().unwrap();
    splitting.sides.get_mut(&edge).unwrap().pop();
    splitting.split(edge);
    assert_eq!(closed(&splitting.finish()), [false]);
}

#[test]
fn what_has_no_edges_is_left_as_it_is() {
    let nothing = Mesh::default();
    assert_eq!(split_longest(&nothing, 100), nothing);
    let point = Mesh {
        vertices: vec![[1.0, 2.0, 3.0]; 3],
        indices: vec![[0, 1, 2]; 2],
        ..Mesh::default()
    };
    assert_eq!(split_longest(&point, 100), point);
    let solid = two_solids([1.0, 2.0, 3.0], 0);
    assert_eq!(split_longest(&solid, 5), solid);
}
