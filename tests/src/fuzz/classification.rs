//! For any triangle and any target, a triangle that classification leaves out certainly faces away, by exact arithmetic, and
//! 32 triangles classified together give the results of each alone.

use super::input::{any, below_one};
use arbitrary::Arbitrary;
use glam::Vec3;
use slimbvh_core::classify::{Sides, VisibleSet, faces, is_in_set, word_of_set};
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::frustum::Frustum;
use slimbvh_core::orientation::{Orientation, Target};
use slimbvh_core::{IndexedTriangles, Triangle};
use slimbvh_lab::oracle::ExactSum;

/// Targets are at most two to this power away, in a scene of magnitude 1. So products of a tiny edge and this distance lose
/// no more to underflow than the bound allows.
const FARTHEST: i32 = 20;

#[derive(Arbitrary, Debug)]
struct Input {
    vertices: [[u32; 3]; 3],
    point: [u32; 3],
    radius: u32,
    kind: u8,
    distance: u8,
    bend: u8,
    others: Vec<([u8; 3], u8)>,
    sides: [i8; 4],
}

/// See the module.
///
/// # Panics
/// If a triangle is left out that may be hit.
pub fn classification(data: &[u8]) {
    let Some(input) = any::<Input>(data) else {
        return;
    };
    let vertices = input.vertices.map(|v| v.map(below_one));
    let target = target(&input, &vertices);
    let triangle = Triangle {
        v0: Vec3::from(vertices[0]),
        v1: Vec3::from(vertices[1]),
        v2: Vec3::from(vertices[2]),
    };
    let orientation = Orientation::new(&triangle, &target);
    for side in [1, -1] {
        let is_certain = orientation.is_certainly_on(side as f32);
        assert_eq!(faces(&triangle, -side, &target), !is_certain);
        if is_certain {
            let is_right = is_exactly_on(side, &vertices, &target);
            assert!(is_right, "{side} {orientation:?} {triangle:?} {target:?}");
        }
    }
    assert!(faces(&triangle, 0, &target));
    together(&input, &vertices, target);
}

/// A target where doubt is largest: in the triangle's plane, or a few steps of the float grid beside it.
fn target(input: &Input, [a, b, c]: &[[f32; 3]; 3]) -> Target {
    let scale = 2f32.powi(i32::from(input.distance) % (FARTHEST + 1));
    let anywhere = input.point.map(|bits| below_one(bits) * scale);
    let weights = anywhere.map(|x| x - x.trunc());
    let in_plane = [0, 1, 2].map(|axis| {
        let (u, v) = (weights[0] * scale, weights[1] * scale);
        let x = a[axis] + u * (b[axis] - a[axis]) + v * (c[axis] - a[axis]);
        let steps = i32::from(input.bend >> (2 * axis) & 3) - 1;
        let moved = f32::from_bits(x.to_bits().wrapping_add_signed(steps));
        if moved.is_finite() { moved } else { x }
    });
    let across = [0, 1, 2].map(|axis| in_plane[axis] - a[axis]);
    let radius = below_one(input.radius).abs() * scale;
    match input.kind % 6 {
        0 => Target::position(anywhere),
        1 => Target::position(in_plane),
        2 => Target::direction(input.point.map(below_one)),
        3 => Target::direction(across),
        4 => Target::ball(anywhere, radius),
        _ => Target::ball(in_plane, radius),
    }
}

/// Whether a whole target is strictly on one side, exactly: the volume exceeds the radius times the normal's length.
fn is_exactly_on(side: i32, [a, b, c]: &[[f32; 3]; 3], target: &Target) -> bool {
    let difference = |p: &[f32; 3], q: &[f32; 3]| {
        [0, 1, 2].map(|axis| ExactSum::difference(p[axis].into(), q[axis].into()))
    };
    let (e1, e2) = (difference(b, a), difference(c, a));
    let r = match target.is_position {
        1 => difference(&target.point, a),
        _ => difference(&target.point, &[0.0; 3]),
    };
    let normal =
        [(1, 2), (2, 0), (0, 1)].map(|(i, j)| e1[i].times(&e2[j]).minus(&e1[j].times(&e2[i])));
    let dot = |p: &[ExactSum; 3], q: &[ExactSum; 3]| {
        let terms = [0, 1, 2].map(|axis| p[axis].times(&q[axis]));
        terms.iter().fold(ExactSum::default(), ExactSum::plus)
    };
    let volume = dot(&r, &normal);
    if volume.sign() != side || target.radius == 0.0 {
        return volume.sign() == side;
    }
    let radius = ExactSum::difference(target.radius.into(), 0.0);
    let reach = radius.times(&radius).times(&dot(&normal, &normal));
    volume.times(&volume).minus(&reach).sign() > 0
}

/// Components, sides and vertices may be missing.
fn together(input: &Input, vertices: &[[f32; 3]; 3], target: Target) {
    let indices: Vec<[u32; 3]> = (input.others.iter())
        .map(|(corners, _)| corners.map(|corner| u32::from(corner % 4)))
        .collect();
    let components: Vec<u32> = (input.others.iter().skip(1))
        .map(|(_, component)| u32::from(component % 5))
        .collect();
    let sides = input.sides.map(|side| i32::from(side).signum());
    let mesh = IndexedTriangles {
        vertices,
        indices: &indices,
    };
    let reach = VisibleSet {
        sides: Sides {
            components: &components,
            sides: &sides,
        },
        target,
        frustum: Frustum::EVERYWHERE,
    };
    let scale = PowerOfTwo::new(0);
    for word in 0..(indices.len() as u32).div_ceil(32) {
        let each = (32 * word..32 * word + 32).filter(|&i| i < indices.len() as u32);
        let expected = each.map(|i| u32::from(is_in_set(i, &mesh, &scale, &reach)) << (i % 32));
        let bits: u32 = expected.sum();
        assert_eq!(word_of_set(word, &mesh, &scale, &reach), bits);
    }
}
