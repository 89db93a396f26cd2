//! Tetrahedra, the only solids that stay convex however their vertices are rounded: all points of their surfaces see each other.

use super::{Found, blocker, found, is_blocked_without_errors, is_on};
use glam::Vec3;
use proptest::array::{uniform2, uniform3, uniform4};
use proptest::prelude::*;
use slimbvh::{Bvh, CodeBits, Mesh};
use slimbvh_tests::random::Random;
use slimbvh_tests::strategies::placement;
use slimbvh_tests::{build, cases};

/// Four vertices: anywhere, at a sharp edge, or at a spike.
fn vertices() -> impl Strategy<Value = [Vec3; 4]> {
    let point = || uniform3(-1.0f32..1.0).prop_map(Vec3::from);
    let any = uniform4(point());
    let thinness = || (-6f32..-1.0).prop_map(|e| 10f32.powf(e));
    let sharp = (uniform2(point()), point(), point(), thinness())
        .prop_map(|([a, b], c, off, thin)| [a, b, c, c + off * thin]);
    let spike =
        (point(), point(), uniform3(point()), thinness()).prop_map(|(tip, foot, base, thin)| {
            let [b, c, d] = base.map(|off| foot + off * thin);
            [tip, b, c, d]
        });
    prop_oneof![any, sharp, spike]
}

fn tetrahedron([a, b, c, d]: [Vec3; 4]) -> Mesh {
    Mesh {
        vertices: [a, b, c, d].map(|v| v.to_array()).to_vec(),
        indices: vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]],
        ..Mesh::default()
    }
}

/// Points that rays to random places of the faces, of the edges and to the corners hit.
fn points(bvh: &Bvh, mesh: &Mesh, random: &mut Random) -> Vec<Found> {
    let corner = |i: usize| Vec3::from(mesh.vertices[mesh.indices[i / 3][i % 3] as usize]);
    let mut points = Vec::new();
    for i in 0..24 {
        let face = random.below(4);
        let [mut u, mut v] = [random.unit(), random.unit()];
        if i % 3 == 0 {
            v = 0.0;
        }
        if i % 6 == 0 {
            u = 0.0;
        }
        let turn = random.below(3);
        let [a, b, c] = [0, 1, 2].map(|k| corner(3 * face + (k + turn) % 3));
        let target = a.lerp(b, u).lerp(c, v);
        // From inside, or from anywhere.
        let weights = [0; 4].map(|_| random.unit() + 0.1);
        let sum: f32 = weights.iter().sum();
        let inside = (0..4).map(|k| Vec3::from(mesh.vertices[k]) * (weights[k] / sum));
        let eye: Vec3 = inside.sum();
        points.extend(found(bvh, mesh, eye.to_array(), target.to_array()));
    }
    points
}

proptest! {
    #![proptest_config(cases(400))]

    #[test]
    fn points_of_a_tetrahedron_see_each_other(vertices in vertices(), placement in placement(), seed: u64) {
        let mesh = placement.apply(tetrahedron(vertices));
        let bvh = build(&mesh, CodeBits::Bits30);
        let points = points(&bvh, &mesh, &mut Random::new(seed));
        for a in &points {
            for b in &points {
                let hit = blocker(&bvh, a, b);
                prop_assert!(hit.is_none(), "{a:?} {b:?} {hit:?}");
                // A ray on from there hits nothing that it starts on.
                let direction = [0, 1, 2].map(|axis| b.point.position[axis] - a.point.position[axis]);
                let next = bvh.closest_hit(a.point.ray(direction));
                prop_assert!(!next.is_hit() || !is_on(&mesh, next.primitive, a), "{a:?} {b:?} {next:?}");
            }
        }
    }

    /// Corners of the mesh as plain positions see each other, too.
    #[test]
    fn corners_of_a_tetrahedron_see_each_other(vertices in vertices(), placement in placement()) {
        let mesh = placement.apply(tetrahedron(vertices));
        let bvh = build(&mesh, CodeBits::Bits30);
        for &a in &mesh.vertices {
            for &b in &mesh.vertices {
                prop_assert!(!bvh.any_hit(slimbvh::Ray::between(a, b)), "{a:?} {b:?}");
            }
        }
    }
}

/// The negative control, and the blockers: without errors some of the same rays are blocked by their own surfaces, and a triangle
/// between two points blocks them.
#[test]
fn without_errors_they_do_not_and_a_triangle_between_blocks() {
    let mut random = Random::new(7);
    let (mut blocked, mut asked, mut behind, mut stuck) = (0, 0, 0, 0);
    for _ in 0..40 {
        let vertices = [0; 4].map(|_| Vec3::from([0; 3].map(|_| 10.0 + random.unit())));
        let mesh = tetrahedron(vertices);
        let bvh = build(&mesh, CodeBits::Bits30);
        let points = points(&bvh, &mesh, &mut random);
        for (a, b) in points.iter().zip(points.iter().skip(1)) {
            blocked += usize::from(is_blocked_without_errors(&bvh, a, b));
            asked += 1;
            let way = [0, 1, 2].map(|axis| b.point.position[axis] - a.point.position[axis]);
            let mut next = a.point.ray(way);
            next.ends.error = [-1.0; 2];
            let hit = bvh.closest_hit(next);
            stuck += usize::from(hit.is_hit() && is_on(&mesh, hit.primitive, a));
            let [from, to] = [a, b].map(|found| Vec3::from(found.point.position));
            let way = to - from;
            if way.length() < 1e-2 {
                continue;
            }
            // A triangle across the segment, somewhere in its middle.
            let (side, up) = way.any_orthonormal_pair();
            let middle = from.lerp(to, 0.2 + 0.6 * random.unit());
            let size = 0.1 * way.length();
            let mut with_blocker = mesh.clone();
            let first = mesh.vertices.len() as u32;
            let corners = [side - up, up * 2.0, -side - up].map(|off| middle + off * size);
            with_blocker.vertices.extend(corners.map(|v| v.to_array()));
            with_blocker.indices.push([first, first + 1, first + 2]);
            let bvh = build(&with_blocker, CodeBits::Bits30);
            let hit = blocker(&bvh, a, b);
            assert_eq!(hit.map(|hit| hit.primitive), Some(4), "{a:?} {b:?}");
            behind += 1;
        }
    }
    println!(
        "{blocked} of {asked} are blocked without errors, {stuck} where they start, {behind} behind a triangle"
    );
    assert!(stuck > asked / 50, "{stuck} of {asked}");
    assert!(
        blocked > asked / 20 && behind > 500,
        "{blocked} of {asked}, {behind}"
    );
}
