//! Triangles that stay in every set.

use super::shapes::*;
use super::*;
use crate::topology::contact::{Face, collide};
use crate::topology::solid_angle::SolidAngle;

/// The triangles that stay, of a mesh whose components are all reducible.
fn seams(mesh: &Mesh) -> Vec<usize> {
    let topology = with_seams(mesh);
    assert!(topology.facts().iter().all(|facts| facts.reducible));
    let kept = kept(&topology);
    let seams: Vec<usize> = (0..kept.len()).filter(|&t| kept[t]).collect();
    assert_eq!(seams.len(), topology.seam_count());
    let counts = topology.facts().into_iter().map(|facts| facts.seam_count);
    assert_eq!(seams.len(), counts.sum::<usize>());
    seams
}

#[test]
fn sound_solids_have_no_seams() {
    let none: [usize; 0] = [];
    for mesh in [
        sphere([1.0, 2.0, 3.0], 2.0),
        block([1.0; 3], [2.0, 3.0, 4.0]),
        knot(0.15),
        unwelded(&inverted(knot(0.15))),
        join(sphere([0.0; 3], 2.0), inverted(sphere([0.0; 3], 1.0))),
        // Different solids may intersect.
        join(sphere([0.0; 3], 2.0), sphere([0.5; 3], 2.0)),
        Mesh::default(),
    ] {
        assert_eq!(seams(&mesh), none);
        assert_eq!(seams(&moved(mesh.clone(), [1000.0, -30.0, 7.0])), none);
        for exponent in [-60, 60] {
            assert_eq!(seams(&scaled(mesh.clone(), exponent)), none);
        }
    }
}

#[test]
fn the_inverted_lobe_of_a_figure_eight_stays() {
    let sides = 20;
    let mesh = figure_eight(sides, 0.0);
    let expected: Vec<usize> = (0..mesh.indices.len())
        .filter(|&triangle| {
            // Two triangles a quadrilateral; the left lobe lies between the crossings.
            let side = triangle as u32 / 2 % sides;
            (sides / 4..3 * sides / 4).contains(&side)
        })
        .collect();
    assert_eq!(seams(&mesh), expected);
    assert_eq!(seams(&inverted(mesh.clone())), expected);
    assert_eq!(seams(&unwelded(&mesh)), expected);
    for exponent in [-60, 60] {
        assert_eq!(seams(&scaled(mesh.clone(), exponent)), expected);
    }
}

#[test]
fn a_figure_eight_that_cuts_itself_stays_where_it_does_and_beyond() {
    let (sides, mesh) = (20, figure_eight(20, 0.5));
    let found = seams(&mesh);
    for triangle in 0..mesh.indices.len() {
        let side = triangle as u32 / 2 % sides;
        let crosses = side == 4 || side == 14;
        let is_left = (5..14).contains(&side);
        assert_eq!(found.contains(&triangle), crosses || is_left, "side {side}");
    }
}

#[test]
fn a_tube_that_cuts_itself_stays_only_there() {
    let mesh = knot(0.45);
    let found = seams(&mesh);
    assert!(found.len() > 100 && found.len() < mesh.indices.len() / 2);

    // Every pair, without a tree, and the exact winding number beside each triangle.
    let corners = |t: usize| mesh.indices[t].map(|v| mesh.vertices[v as usize]);
    let face = |t: usize| Face {
        corners: corners(t),
        ids: mesh.indices[t],
    };
    let all = 0..mesh.indices.len();
    for t in all.clone() {
        let collides = all.clone().any(|u| t != u && collide(&face(t), &face(u)));
        let [a, b, c] = corners(t).map(|p| p.map(f64::from));
        let [e, f] = [b, c].map(|p| [0, 1, 2].map(|i| p[i] - a[i]));
        let beside = [0, 1, 2].map(|i| {
            let (y, z) = ((i + 1) % 3, (i + 2) % 3);
            a[i] + (e[i] + f[i]) / 3.0 + 1e-4 * (e[y] * f[z] - e[z] * f[y])
        });
        let number = SolidAngle::of(all.clone().map(corners), beside).winding_number();
        let is_inverted = number.expect("it lies on no triangle") < 0;
        assert_eq!(found.contains(&t), collides || is_inverted, "triangle {t}");
    }
}

#[test]
fn a_lobe_that_hangs_by_an_edge_counts_by_its_own_side() {
    let solid = || block([0.0; 3], [1.0, 2.0, 3.0]);
    let beside = || block([1.0, 2.0, 0.0], [4.0, 5.0, 3.0]);
    assert_eq!(seams(&join(solid(), beside())), [0; 0]);
    // The larger block decides which side faces outward.
    let expected: Vec<usize> = (0..12).collect();
    assert_eq!(seams(&join(inverted(solid()), beside())), expected);
    assert_eq!(seams(&join(solid(), inverted(beside()))), expected);
}

#[test]
fn coincident_and_degenerate_triangles_stay() {
    let mesh = block([0.0; 3], [1.0, 2.0, 3.0]);
    let twice = join(mesh.clone(), mesh.clone());
    assert_eq!(seams(&twice).len(), 24);
    let mut mesh = mesh;
    let [a, b, _] = mesh.indices[4];
    mesh.indices.push([a, b, b]);
    assert_eq!(seams(&mesh), [12]);
}

#[test]
fn looking_again_finds_the_same() {
    let mesh = figure_eight(20, 0.5);
    let mut topology = with_seams(&mesh);
    let first = (topology.components().to_vec(), topology.facts());
    topology.find_seams(&mesh, &build(&mesh));
    assert_eq!(first, (topology.components().to_vec(), topology.facts()));

    // A solid that has been deformed back has none.
    let sphere = sphere([0.0; 3], 1.0);
    let mut crumpled = sphere.clone();
    crumpled.vertices[3] = crumpled.vertices[3].map(|x| x * -3.0);
    let mut topology = with_seams(&crumpled);
    assert!(topology.seam_count() > 0);
    topology.update(&sphere);
    assert!(topology.seam_count() > 0, "seams stay as they were found");
    topology.find_seams(&sphere, &build(&sphere));
    assert_eq!(topology.seam_count(), 0);
    assert_eq!(topology.components(), Topology::new(&sphere).components());
}

#[test]
fn what_could_not_be_checked_stays_whole() {
    let solid = sphere([0.0; 3], 1.0);
    let mut flat = solid.clone();
    for vertex in &mut flat.vertices {
        vertex[2] = 0.25;
    }
    let mut topology = Topology::new(&solid);
    topology.update(&flat);
    topology.find_seams(&flat, &build(&flat));
    topology.update(&solid);
    let facts = topology.facts()[0];
    assert!(facts.outward == Some(true) && !facts.reducible);
    let far = Target::Point([9.0; 3]);
    assert_eq!(topology.sides(&far), [0, 0]);
    topology.find_seams(&solid, &build(&solid));
    assert_eq!(topology.sides(&far), [1, 0]);
}
