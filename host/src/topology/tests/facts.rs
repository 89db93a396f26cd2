//! Components, closedness and the volume's sign, before and after movement.

use super::shapes::*;
use super::*;
use crate::topology::Facts;

/// Triangle count, closed, outward.
fn facts(topology: &Topology) -> Vec<(usize, bool, Option<bool>)> {
    let facts = topology.facts();
    let brief = |f: Facts| (f.triangle_count, f.closed, f.outward);
    facts.into_iter().map(brief).collect()
}

#[test]
fn solids_are_one_component_that_faces_out() {
    for mesh in [
        sphere([1.0, 2.0, 3.0], 2.0),
        block([1.0; 3], [2.0, 3.0, 4.0]),
        knot(0.15),
        unwelded(&knot(0.15)),
    ] {
        let count = mesh.indices.len();
        let topology = Topology::new(&mesh);
        assert_eq!(facts(&topology), [(count, true, Some(true))]);
        assert_eq!(topology.components(), vec![0; count]);
        let other = Topology::new(&inverted(mesh));
        assert_eq!(facts(&other), [(count, true, Some(false))]);
    }
}

#[test]
fn a_cavity_is_a_solid_of_its_own() {
    let mesh = join(sphere([0.0; 3], 2.0), inverted(sphere([0.0; 3], 1.0)));
    let topology = Topology::new(&mesh);
    assert_eq!(
        facts(&topology),
        [(320, true, Some(true)), (320, true, Some(false))]
    );
    assert_eq!(topology.components()[319..321], [0, 1]);
}

#[test]
fn a_klein_bottle_is_not_closed() {
    assert_eq!(
        facts(&Topology::new(&klein_bottle(true))),
        [(384, false, None)]
    );
    // The control: joined without the twist, the same tube is.
    assert!(Topology::new(&klein_bottle(false)).facts()[0].closed);
}

#[test]
fn open_parts_leave_closed_ones_alone() {
    let mut open = block([5.0; 3], [6.0; 3]);
    open.indices.pop();
    let topology = Topology::new(&join(open, block([0.0; 3], [1.0; 3])));
    assert_eq!(
        facts(&topology),
        [(11, false, None), (12, true, Some(true))]
    );
}

#[test]
fn one_triangle_twice_opens_and_all_of_them_twice_do_not() {
    let mut mesh = block([0.0; 3], [1.0, 2.0, 3.0]);
    mesh.indices.push(mesh.indices[3]);
    assert_eq!(facts(&Topology::new(&mesh)), [(13, false, None)]);
    let mesh = block([0.0; 3], [1.0, 2.0, 3.0]);
    let twice = join(mesh.clone(), mesh);
    assert_eq!(facts(&Topology::new(&twice)), [(24, true, Some(true))]);
}

#[test]
fn points_are_in_no_component_and_a_flat_sheet_has_no_sign() {
    let mut mesh = block([0.0; 3], [1.0, 2.0, 3.0]);
    mesh.indices.extend([[2, 2, 2], [0, 1, 1]]);
    let topology = Topology::new(&mesh);
    assert_eq!(topology.component_count(), 1);
    assert_eq!(topology.components()[12..], [1, 0]);
    let sheet = Mesh {
        vertices: vec![[0.0, 0.0, 0.1], [1.0, 0.0, 0.2], [0.0, 2.0, 0.7]],
        indices: vec![[0, 1, 2], [2, 1, 0]],
        ..Mesh::default()
    };
    assert_eq!(facts(&Topology::new(&sheet)), [(2, true, None)]);
    let none = Topology::new(&Mesh::default());
    assert_eq!((none.component_count(), none.bytes()), (0, 0));
}

#[test]
fn edges_that_come_apart_open_a_component_until_they_meet_again() {
    let solid = block([0.0; 3], [1.0, 2.0, 3.0]);
    let mut mesh = unwelded(&solid);
    let rest = mesh.vertices.clone();
    let mut topology = Topology::new(&mesh);
    mesh.vertices[7][1] += 0.25;
    topology.update(&mesh);
    assert_eq!(facts(&topology), [(12, false, None)]);
    mesh.vertices = rest;
    topology.update(&mesh);
    assert_eq!(facts(&topology), [(12, true, Some(true))]);

    // The control: if the corner is shared, moving it opens nothing.
    let mut mesh = solid;
    let mut topology = Topology::new(&mesh);
    mesh.vertices[7][1] += 0.25;
    topology.update(&mesh);
    assert_eq!(facts(&topology), [(12, true, Some(true))]);
}

#[test]
fn solids_that_touch_in_a_point_may_part() {
    let mesh = join(
        block([0.0; 3], [1.0, 2.0, 3.0]),
        block([1.0, 2.0, 3.0], [4.0; 3]),
    );
    let mut topology = Topology::new(&mesh);
    let both = [(12, true, Some(true)); 2];
    assert_eq!(facts(&topology), both);
    let mut parted = mesh.clone();
    for vertex in &mut parted.vertices[8..] {
        vertex[0] += 1.0;
    }
    topology.update(&parted);
    assert_eq!(facts(&topology), both);

    // Along an edge they are one component, and parting them opens it: each surface alone would be closed, but the pairing
    // of the sides is unknown.
    let mesh = join(
        block([0.0; 3], [1.0, 2.0, 3.0]),
        block([1.0, 2.0, 0.0], [4.0, 5.0, 3.0]),
    );
    let mut topology = Topology::new(&mesh);
    assert_eq!(facts(&topology), [(24, true, Some(true))]);
    let mut parted = mesh.clone();
    for vertex in &mut parted.vertices[8..] {
        vertex[0] += 1.0;
    }
    topology.update(&parted);
    assert_eq!(facts(&topology), [(24, false, None)]);
}

#[test]
fn a_needle_that_opens_is_a_gap() {
    let mut mesh = block([0.0; 3], [1.0, 2.0, 3.0]);
    mesh.vertices.push(mesh.vertices[0]);
    let [a, b] = [0, mesh.indices[0][1]];
    mesh.indices.push([a, 8, b]);
    let mut topology = Topology::new(&mesh);
    assert_eq!(facts(&topology), [(13, true, Some(true))]);
    mesh.vertices[8][0] -= 0.5;
    topology.update(&mesh);
    assert_eq!(facts(&topology), [(13, false, None)]);
}

#[test]
fn moving_turns_and_flattens() {
    let mut mesh = knot(0.15);
    let mut topology = Topology::new(&mesh);
    let count = mesh.indices.len();
    for vertex in &mut mesh.vertices {
        vertex[1] = -vertex[1];
    }
    topology.update(&mesh);
    assert_eq!(facts(&topology), [(count, true, Some(false))]);
    for vertex in &mut mesh.vertices {
        vertex[1] = 0.5;
    }
    topology.update(&mesh);
    assert_eq!(facts(&topology), [(count, true, None)]);
}

#[test]
#[should_panic(expected = "of another mesh")]
fn another_mesh_is_refused() {
    Topology::new(&knot(0.15)).update(&block([0.0; 3], [1.0; 3]));
}
