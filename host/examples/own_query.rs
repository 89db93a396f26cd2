//! A query of one's own over slimbvh's traversal: is a point inside closed surfaces? Checked against an answer that is known.

use glam::Vec3;
use slimbvh::generate::{concatenate, cuboid};
use slimbvh::{Builder, Bvh, Collector, Hit, Mesh, PreparedRay, Ray, RayEnds};
use std::error::Error;

/// Counts the surfaces that a ray crosses, all of them.
struct Crossings {
    count: u32,
    t_max: f32,
}

impl Collector for Crossings {
    fn limit(&self) -> f32 {
        // No hit makes a farther one matter less.
        self.t_max
    }

    fn offer(&mut self, _: Hit) {
        self.count += 1;
    }
}

/// Whether a ray in this direction crosses an odd number of surfaces.
fn is_odd(bvh: &Bvh, point: [f32; 3], direction: [f32; 3]) -> bool {
    let ray = PreparedRay::new(&Ray::new(point, direction), bvh.scene_exponent());
    let mut crossings = Crossings {
        count: 0,
        t_max: ray.t_max,
    };
    bvh.collect(&ray, &RayEnds::NONE, &mut crossings);
    crossings.count % 2 == 1
}

/// Three directions vote, as a ray that meets an edge crosses both of its triangles.
fn is_inside(bvh: &Bvh, point: [f32; 3]) -> bool {
    let directions = [[0.48, 0.6, 0.64], [-0.28, 0.31, -0.91], [0.7, -0.69, 0.18]];
    let votes = directions.map(|direction| is_odd(bvh, point, direction));
    votes.into_iter().filter(|&is_odd| is_odd).count() >= 2
}

fn main() -> Result<(), Box<dyn Error>> {
    let bvh = Builder::default().build(&hollow_box())?;
    let (mut inside, mut outside) = (0, 0);
    for place in 0..21_u32.pow(3) {
        let point = [place % 21, place / 21 % 21, place / 441].map(|x| x as f32 * 0.11 - 1.1);
        let expected = is_in(point, OUTER) && !is_in(point, HOLLOW);
        if is_inside(&bvh, point) != expected {
            return Err(
                format!("{point:?} is inside: {expected}, and the query says otherwise").into(),
            );
        }
        *if expected { &mut inside } else { &mut outside } += 1;
    }
    println!("{inside} points inside, {outside} outside, as they should be");
    Ok(())
}

/// The corners of a box, and of the hollow in it.
const OUTER: [Vec3; 2] = [Vec3::new(-1.0, -0.8, -0.6), Vec3::new(1.0, 0.8, 0.6)];
const HOLLOW: [Vec3; 2] = [Vec3::new(-0.5, -0.4, -0.3), Vec3::new(0.7, 0.4, 0.3)];

fn hollow_box() -> Mesh {
    let mut mesh = cuboid(OUTER[0], OUTER[1]);
    concatenate(&mut mesh, &cuboid(HOLLOW[0], HOLLOW[1]));
    mesh
}

fn is_in(point: [f32; 3], [low, high]: [Vec3; 2]) -> bool {
    let point = Vec3::from(point);
    low.cmple(point).all() && point.cmple(high).all()
}
