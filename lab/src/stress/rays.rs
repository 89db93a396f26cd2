//! The rays that are traced through a scene.

use super::families::Case;
use super::judge::Shot;
use super::recipe::{Aim, Face, Range, RayRecipe, Start};
use slimbvh::internals::Random;
use slimbvh::{Mesh, Ray};

/// The rays of a case: those from anywhere first, then those from its eye.
#[derive(Clone, Debug)]
pub struct Rays {
    /// All of them.
    pub shots: Vec<Shot>,
    /// The index of the first ray from the eye.
    pub from_eye: usize,
}

/// Makes the rays of a case, which are the same on every call.
#[must_use]
pub fn rays(case: &Case) -> Rays {
    let mut random = Random::new(0x5eed);
    let mut shots = Vec::new();
    let free = |ray: Ray| Shot {
        ray,
        is_inside: false,
    };
    let share = if case.inside.is_some() { 4 } else { 2 };
    shots.extend(not_rays(&recipe(&mut random).cook(&case.mesh)).map(free));
    while shots.len() < 2 * case.ray_count / share {
        shots.push(free(recipe(&mut random).cook(&case.mesh)));
    }
    if let Some(inside) = case.inside {
        while shots.len() < 3 * case.ray_count / share {
            shots.push(Shot {
                ray: from(inside, &case.mesh, &mut random),
                is_inside: true,
            });
        }
    }
    let from_eye = shots.len();
    let eye = case.eye.unwrap_or_else(|| beside(&case.mesh));
    while shots.len() < case.ray_count {
        shots.push(free(from(eye, &case.mesh, &mut random)));
    }
    Rays { shots, from_eye }
}

/// Invalid rays, which must hit nothing and terminate.
fn not_rays(good: &Ray) -> impl Iterator<Item = Ray> + use<> {
    let good = *good;
    let bad = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY];
    let of_bad = move |bad: f32| {
        let axes = (0..3).flat_map(move |axis| {
            let [mut here, mut there] = [good; 2];
            (here.origin[axis], there.direction[axis]) = (bad, bad);
            [here, there]
        });
        axes.chain([Ray { t_min: bad, ..good }])
    };
    let nan = Ray {
        t_max: f32::NAN,
        ..good
    };
    let zero = Ray::new(good.origin, [0.0, -0.0, 0.0]);
    let ends = [nan, zero, Ray::EMPTY];
    bad.into_iter().flat_map(of_bad).chain(ends)
}

/// A random whole number below `end`.
fn below(random: &mut Random, end: u64) -> u64 {
    random.bits() % end
}

/// A random point of a triangle: inside, on an edge, or a corner.
fn face(random: &mut Random) -> Face {
    let [u, v] = [random.unit(), random.unit()];
    let weights = match below(random, 8) {
        0..=2 if u + v > 1.0 => [1.0 - u, 1.0 - v],
        0..=2 => [u, v],
        3 => [u, 0.0],
        4 => [0.0, u],
        5 => [u, 1.0 - u],
        _ => [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]][below(random, 3) as usize],
    };
    Face {
        triangle: random.bits() as u32,
        weights,
    }
}

/// Random numbers from -1 to 1.
fn signed(random: &mut Random) -> [f32; 3] {
    random.point().to_array().map(|x| 2.0 * x - 1.0)
}

fn recipe(random: &mut Random) -> RayRecipe {
    let start = match below(random, 8) {
        0..=3 => Start::Near(signed(random).map(|x| 0.5 + x)),
        4 | 5 => Start::Far(signed(random), below(random, 9) as i32),
        _ => Start::On(face(random)),
    };
    let (triangle, edge) = (random.bits() as u32, below(random, 3) as usize);
    let aim = match below(random, 16) {
        0 | 1 => Aim::Direction(signed(random)),
        2 | 3 => Aim::Axis(edge, [0, 1, 2].map(|_| random.unit() < 0.5)),
        4 => {
            let mut direction = signed(random);
            direction[edge] = 0.0;
            Aim::Direction(direction)
        }
        5 => Aim::InPlane(triangle, 4.0 * random.unit()),
        6 => Aim::AlongEdge(triangle, edge),
        7 => Aim::BesideEdge(triangle, edge, signed(random).map(|x| 0.3 * x)),
        _ => Aim::At(face(random)),
    };
    let length = if below(random, 4) == 0 {
        below(random, 121) as i32 - 60
    } else {
        0
    };
    let [a, b] = [random.unit(), random.unit()].map(|t| 2.0 * t - 0.5);
    let range = match below(random, 12) {
        0 => Range::Infinite,
        1 | 2 => Range::Between(a.min(b), a.max(b)),
        3 => Range::Between(a, a),
        4 => Range::Between(0.0, 1.0),
        5 => Range::Between(1.0, 1.0),
        _ => Range::Whole,
    };
    RayRecipe {
        start,
        aim,
        length,
        range,
    }
}

/// A whole ray from a point to a random edge, corner or inside of a triangle.
fn from(origin: [f32; 3], mesh: &Mesh, random: &mut Random) -> Ray {
    let length = 20 * (below(random, 5) as i32 - 2);
    let recipe = RayRecipe {
        start: Start::Exactly(origin),
        aim: Aim::At(face(random)),
        length: if below(random, 4) == 0 { length } else { 0 },
        range: Range::Whole,
    };
    recipe.cook(mesh)
}

/// A point outside of a mesh's box.
fn beside(mesh: &Mesh) -> [f32; 3] {
    let recipe = RayRecipe {
        start: Start::Far([0.6, 0.5, 0.7], 0),
        aim: Aim::Direction([1.0; 3]),
        length: 0,
        range: Range::Whole,
    };
    recipe.cook(mesh).origin
}
