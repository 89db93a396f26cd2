//! Which components may be reduced for a target.

use super::shapes::*;
use super::*;

#[test]
fn a_cavity_is_left_from_between_and_kept_from_within() {
    let mesh = join(sphere([0.0; 3], 2.0), inverted(sphere([0.0; 3], 1.0)));
    for exponent in [-60, 0, 60] {
        let topology = with_seams(&scaled(mesh.clone(), exponent));
        let at = |x: f32| Target::Point([x * 2_f32.powi(exponent), 0.0, 0.0]);
        assert_eq!(topology.sides(&at(9.0)), [1, -1, 0]);
        assert_eq!(topology.sides(&at(1.5)), [0, -1, 0]);
        assert_eq!(topology.sides(&at(0.5)), [0, 0, 0]);
        assert!(topology.is_outside_all(&at(9.0)) && !topology.is_outside_all(&at(1.5)));
    }
}

#[test]
fn the_hole_of_a_torus_is_outside() {
    let torus = rings(32, 16, false, |ring, side| {
        let (u, v) = (f64::from(ring) / 32.0, f64::from(side) / 16.0);
        let [(su, cu), (sv, cv)] = [u, v].map(|x| (std::f64::consts::TAU * x).sin_cos());
        [(3.0 + cv) * cu, (3.0 + cv) * su, sv]
    });
    let topology = with_seams(&moved(torus, [100.0, 200.0, 300.0]));
    let side = topology.facts()[0]
        .outward
        .map(|out| if out { 1 } else { -1 });
    let side = side.expect("its volume is certain");
    let ball = |x: f32, radius| Target::Ball {
        center: [100.0 + x, 200.0, 300.0],
        radius,
    };
    for (x, radius, expected) in [
        (0.0, 0.0, side),
        (0.0, 1.9, side),
        (0.0, 2.1, 0),
        (0.0, 9.0, 0),
        (3.0, 0.0, 0),
        (3.0, 0.5, 0),
        (5.0, 0.9, side),
        (5.0, 1.1, 0),
        (5.0, f32::INFINITY, 0),
        (5.0, f32::NAN, 0),
        (5.0, -1.0, 0),
    ] {
        assert_eq!(
            topology.sides(&ball(x, radius)),
            [expected, 0],
            "{x} {radius}"
        );
        assert_eq!(topology.is_outside_all(&ball(x, radius)), expected != 0);
    }
    assert_eq!(
        topology.sides(&Target::Point([100.0, 200.0, 300.0])),
        [side, 0]
    );
    assert_eq!(
        topology.sides(&Target::Point([103.0, 200.0, 300.0])),
        [0, 0]
    );
    assert_eq!(topology.sides(&Target::Point([f32::NAN, 0.0, 0.0])), [0, 0]);
}

#[test]
fn what_is_infinitely_far_is_outside() {
    let mut open = block([5.0; 3], [6.0; 3]);
    open.indices.pop();
    let mesh = join(open, inverted(block([0.0; 3], [1.0, 2.0, 3.0])));
    let topology = with_seams(&mesh);
    let sun = Target::Direction([0.5, -1.0, 3.0]);
    assert_eq!(topology.sides(&sun), [0, -1, 0]);
    assert!(topology.is_outside_all(&sun));
    let nowhere = Target::Direction([f32::NAN, 0.0, 1.0]);
    assert_eq!(topology.sides(&nowhere), [0, 0, 0]);
}

#[test]
fn on_the_surface_is_not_outside() {
    let topology = with_seams(&block([0.0; 3], [1.0, 2.0, 3.0]));
    for point in [
        [0.0, 0.0, 0.0],
        [1.0, 1.0, 1.0],
        [0.5, 2.0, 1.5],
        [0.25, 0.5, 3.0],
    ] {
        assert_eq!(topology.sides(&Target::Point(point)), [0, 0]);
    }
    let above = [0.25, 0.5, 3.0_f32.next_up()];
    assert_eq!(topology.sides(&Target::Point(above)), [1, 0]);
}

#[test]
fn closed_surfaces_without_a_sign_still_have_an_inside() {
    // Two equal blocks that share an edge, one inside out.
    let mesh = join(
        block([0.0; 3], [1.0; 3]),
        inverted(block([1.0, 1.0, 0.0], [2.0, 2.0, 1.0])),
    );
    let topology = with_seams(&mesh);
    assert_eq!(topology.facts()[0].outward, None);
    for (point, is_outside) in [
        ([0.5; 3], false),
        ([1.5, 1.5, 0.5], false),
        ([1.5, 0.5, 0.5], true),
        ([3.0; 3], true),
    ] {
        assert_eq!(topology.is_outside_all(&Target::Point(point)), is_outside);
        assert_eq!(topology.sides(&Target::Point(point)), [0, 0]);
    }
}

#[test]
fn moving_moves_the_inside() {
    let mesh = knot(0.15);
    let mut topology = with_seams(&mesh);
    let middle = |mesh: &Mesh| {
        // The middle of the first ring.
        let ring = &mesh.vertices[..8];
        let sum = ring
            .iter()
            .fold([0.0; 3], |sum, p| [0, 1, 2].map(|i| sum[i] + p[i]));
        Target::Point(sum.map(|x| x / 8.0))
    };
    let far = moved(mesh.clone(), [10.0, 20.0, 30.0]);
    assert_eq!(topology.sides(&middle(&mesh)), [0, 0]);
    assert_eq!(topology.sides(&middle(&far)), [1, 0]);
    topology.update(&far);
    assert_eq!(topology.sides(&middle(&mesh)), [1, 0]);
    assert_eq!(topology.sides(&middle(&far)), [0, 0]);
}
