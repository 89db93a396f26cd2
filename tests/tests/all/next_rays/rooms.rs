//! Concave rooms: whatever blocks two points separates them, points with clear sight see each other, and walls between points block.

use super::{Found, blocker, corners, found, is_blocked_without_errors, separates};
use glam::{DVec3, Vec3};
use slimbvh::generate::icosphere;
use slimbvh::{Bvh, CodeBits, Mesh};
use slimbvh_tests::build;
use slimbvh_tests::closed::{dented_sphere, long_prism, placed, points_inside, small_torus_knot};
use slimbvh_tests::random::Random;

/// Rooms, and eyes in them.
fn rooms() -> Vec<(Mesh, Vec<Vec3>)> {
    let sphere = dented_sphere(2, 0.5, 3);
    let knot = small_torus_knot();
    let prism = long_prism(10.0, 1.0, 7);
    let round = icosphere(Vec3::ZERO, 1.0, 2);
    let of = |mesh: Mesh, depth: f32| {
        let eyes = points_inside(&mesh, depth, 6, 5);
        (mesh, eyes)
    };
    let rooms = [
        of(sphere, 0.1),
        of(knot, 0.05),
        of(prism, 0.3),
        of(round, 0.1),
    ];
    let mut all = Vec::new();
    for (mesh, eyes) in rooms {
        for (scale, translation) in [
            (1.0, Vec3::ZERO),
            (3e-20, Vec3::ZERO),
            (0.3, Vec3::new(50.0, -7.0, 1000.0)),
            (7e25, Vec3::new(1e26, 0.0, -3e26)),
        ] {
            let mesh = placed(mesh.clone(), scale, translation);
            let eyes = eyes.iter().map(|&eye| eye * scale + translation).collect();
            all.push((mesh, eyes));
        }
    }
    all
}

/// Points that rays from the eyes to places in faces, on edges and at corners hit.
fn points(bvh: &Bvh, mesh: &Mesh, eyes: &[Vec3], random: &mut Random) -> Vec<Found> {
    let mut points = Vec::new();
    for i in 0..60 {
        let face = mesh.indices[random.below(mesh.indices.len())];
        let turn = random.below(3);
        let [a, b, c] = [0, 1, 2].map(|k| Vec3::from(mesh.vertices[face[(k + turn) % 3] as usize]));
        let [u, v] = match i % 3 {
            0 => [0.0, 0.0],
            1 => [random.unit(), 0.0],
            _ => [random.unit(), random.unit()],
        };
        let target = a.lerp(b, u).lerp(c, v);
        let eye = eyes[i % eyes.len()];
        points.extend(found(bvh, mesh, eye.to_array(), target.to_array()));
    }
    points
}

/// What a wall is to a segment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Wall {
    /// Clearly beside it, or with both ends on one side.
    Clear,
    /// Clearly across it.
    Across,
    /// Neither.
    Near,
}

/// Judged in `f64`, with a margin.
fn judge(wall: [DVec3; 3], a: DVec3, b: DVec3, margin: f64) -> Wall {
    let [v0, v1, v2] = wall;
    let normal = (v1 - v0).cross(v2 - v0).normalize_or_zero();
    let [from, to] = [a, b].map(|p| normal.dot(p - v0));
    if from * to >= 0.0 || from.abs().min(to.abs()) < 1e-13 * (v0.length() + margin) {
        return Wall::Clear;
    }
    let point = a + (b - a) * (from / (from - to));
    // Distances inside the three sides.
    let sides = [(v0, v1), (v1, v2), (v2, v0)];
    let inside = sides.map(|(p, q)| normal.cross(q - p).normalize_or_zero().dot(point - p));
    let least = inside.into_iter().fold(f64::MAX, f64::min);
    // Where the segment is almost parallel to the wall, a small error moves the crossing far.
    let slope = (from - to).abs() / (b - a).length();
    if least < -margin / slope {
        Wall::Clear
    } else if least > margin / slope && from.abs().min(to.abs()) > margin {
        Wall::Across
    } else {
        Wall::Near
    }
}

#[test]
fn only_what_is_between_blocks() {
    let mut random = Random::new(11);
    let (mut clear, mut across, mut without) = (0, 0, 0);
    for (mesh, eyes) in rooms() {
        let bvh = build(&mesh, CodeBits::Bits63);
        let bounds = bvh.bounds().expect("there are triangles");
        let size = (bounds.max - bounds.min).max_element();
        let farthest = bounds.max.abs().max(bounds.min.abs()).max_element();
        let margin = 1e-4 * f64::from(size) + 3e-6 * f64::from(farthest);
        let points = points(&bvh, &mesh, &eyes, &mut random);
        assert!(points.len() == 60);
        for a in &points {
            for b in &points {
                let hit = blocker(&bvh, a, b);
                if let Some(hit) = hit {
                    assert!(separates(&mesh, hit.primitive, a, b), "{hit:?} {a:?} {b:?}");
                }
                let walls = (0..mesh.indices.len() as u32)
                    .map(|wall| judge(corners(&mesh, wall), a.exact, b.exact, margin));
                let (mut is_clear, mut is_across) = (true, false);
                for wall in walls {
                    is_clear &= wall == Wall::Clear;
                    is_across |= wall == Wall::Across;
                }
                if is_clear {
                    assert_eq!(hit, None, "{a:?} {b:?}");
                    clear += 1;
                    without += usize::from(is_blocked_without_errors(&bvh, a, b));
                }
                if is_across {
                    assert!(hit.is_some(), "{a:?} {b:?}");
                    across += 1;
                }
            }
        }
    }
    println!(
        "{clear} clear, of which {without} are blocked without errors; {across} across a wall"
    );
    assert!(
        clear > 5_000 && across > 5_000 && without > clear / 50,
        "{clear} {across} {without}"
    );
}
