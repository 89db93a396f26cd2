//! What a modelling tool asks of a mesh on the CPU: picking, line of sight, layers, all hits along a ray, ambient occlusion.

use glam::{Quat, Vec3};
use slimbvh::generate::{TorusKnot, append, ground, torus_knot, transformed};
use slimbvh::{BuildConfig, Builder, Camera, Hit, Mesh, Ray, Tiles};
use std::error::Error;

const SIZE: [u32; 2] = [72, 30];
const LAMP: [f32; 3] = [3.0, 4.0, 2.0];
const DIRECTIONS: u32 = 64;

fn main() -> Result<(), Box<dyn Error>> {
    let mesh = knot_over_floor();
    let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    let camera = Camera::facing(&mesh.bounds().ok_or("there are no triangles")?, 2.0);
    let part = |hit: &Hit| {
        mesh.part_of(hit.primitive)
            .map_or("nothing", |part| &part.name)
    };

    // Picking: what does the mouse point at?
    let ray = camera.ray([33, 12], SIZE)?;
    let hit = bvh.closest_hit(ray);
    let point = bvh.surface(&mesh, ray, &hit).ok_or("nothing is there")?;
    println!("the {} at {:?}", part(&hit), point.position);

    // Line of sight: no offset at either end.
    let is_lit = !bvh.any_hit(Ray::between(point, LAMP));
    // Layers, masks, holes: hits that a function accepts.
    let below = bvh.closest_hit_where(ray, |hit| part(hit) == "floor");
    let count = bvh.all_hits(ray).len();
    println!("lit: {is_lit}; behind it {}; {count} hits", part(&below));

    // Ambient occlusion: of 64 directions around the normal, how many meet nothing?
    let tiles = Tiles {
        width: SIZE[0],
        height: SIZE[1],
    };
    let pixels = tiles.pixels_from(0).take((SIZE[0] * SIZE[1]) as usize);
    let rays: Vec<Ray> = pixels
        .map(|pixel| camera.ray(pixel, SIZE))
        .collect::<Result<_, _>>()?;
    let mut hits = Vec::new();
    bvh.closest_hits(&rays, &mut hits);
    let mut picture = vec![b' '; rays.len()];
    for (i, (ray, hit)) in (0..).zip(rays.iter().zip(&hits)) {
        let Some(point) = bvh.surface(&mesh, ray, hit) else {
            continue;
        };
        let rays = (0..DIRECTIONS).map(|k| point.ray(direction(k, point.normal)));
        let free = rays.filter(|ray| !bvh.any_hit(ray)).count() as u32;
        let [x, y] = tiles.pixel(i);
        picture[(y * SIZE[0] + x) as usize] = b"@%#*+=-:."[(free * 8 / DIRECTIONS) as usize];
    }
    for row in picture.chunks(SIZE[0] as usize) {
        println!("{}", String::from_utf8_lossy(row));
    }
    Ok(())
}

fn knot_over_floor() -> Mesh {
    let mut mesh = Mesh::default();
    append(&mut mesh, torus_knot(&TorusKnot::default()), "knot", 0);
    let floor = transformed(ground(5.0, 32), 1.0, Quat::IDENTITY, 0.7 * Vec3::NEG_Y);
    append(&mut mesh, floor, "floor", 0);
    mesh
}

/// The k-th of the directions on the side of a normal: a spiral on the sphere, turned over where it points inward.
fn direction(k: u32, normal: [f32; 3]) -> [f32; 3] {
    let z = 1.0 - (2.0 * k as f32 + 1.0) / DIRECTIONS as f32;
    let (sin, cos) = (2.399_963 * k as f32).sin_cos();
    let direction = Vec3::new(cos, sin, 0.0) * (1.0 - z * z).sqrt() + Vec3::Z * z;
    (direction * direction.dot(normal.into()).signum()).to_array()
}
