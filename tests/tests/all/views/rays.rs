//! Rays of the targets of `views`, and their answers.

use super::{LAMP, PROBE, PROBE_RADIUS, SIZE, SUN, camera};
use slimbvh::{Cpu, Hit, Mesh, Ray, SurfaceRay, ViewSets};
use slimbvh_tests::gpu::done;
use slimbvh_tests::random::Random;

/// Rays for each target: from the camera and the probe, to the sun and the lamp, and others.
pub struct Rays {
    pub from: [Vec<Ray>; 2],
    pub to: [Vec<SurfaceRay>; 2],
    pub others: Vec<Ray>,
}

/// Rays through each pixel; from each point that they hit to the lights; from the probe in all directions; and anywhere.
pub fn rays_of(mesh: &Mesh, views: &ViewSets<Cpu>) -> Rays {
    let pixels = (0..SIZE[1]).flat_map(|y| (0..SIZE[0]).map(move |x| [x, y]));
    let primary: Vec<Ray> = pixels
        .map(|pixel| done(camera().ray(pixel, SIZE)))
        .collect();
    let trees = views.trees();
    let points: Vec<_> = primary
        .iter()
        .filter_map(|ray| trees[0].surface(mesh, ray, &trees[0].closest_hit(ray)))
        .collect();
    assert!(points.len() > 100);
    let mut random = Random::new(5);
    let mut direction = || [0; 3].map(|_| 2.0 * random.unit() - 1.0);
    let probe = (0..500).map(|_| {
        // Inside the ball: each coordinate is at most the radius over √3.
        let aside = direction().map(|x| 0.57 * PROBE_RADIUS * x);
        Ray::new([0, 1, 2].map(|i| PROBE[i] + aside[i]), direction())
    });
    let probe = probe.collect();
    let others = (0..500).map(|_| Ray::new(direction().map(|x| 2.0 * x), direction()));
    Rays {
        to: [
            points
                .iter()
                .map(|point| point.ray(SUN.map(|x| -x)))
                .collect(),
            points
                .iter()
                .map(|point| Ray::between(point, LAMP))
                .collect(),
        ],
        others: others.collect(),
        from: [primary, probe],
    }
}

/// The answers to all rays, each by its target's tree.
#[derive(Debug, PartialEq)]
pub struct Answers {
    pub from: [Vec<Hit>; 2],
    pub to: [Vec<bool>; 2],
    pub others: Vec<Hit>,
}

/// Asks the trees of `views::targets`.
pub fn answers(views: &ViewSets<Cpu>, rays: &Rays) -> Answers {
    let trees = views.trees();
    let closest = |place: usize, rays: &[Ray]| -> Vec<Hit> {
        rays.iter()
            .map(|ray| trees[place].closest_hit(ray))
            .collect()
    };
    let any = |place: usize, rays: &[SurfaceRay]| -> Vec<bool> {
        rays.iter().map(|ray| trees[place].any_hit(ray)).collect()
    };
    Answers {
        from: [closest(0, &rays.from[0]), closest(3, &rays.from[1])],
        to: [any(1, &rays.to[0]), any(2, &rays.to[1])],
        others: closest(4, &rays.others),
    }
}
