//! What a modelling tool asks of a mesh on the CPU: picking, line of sight, ambient occlusion, layers, all hits along a ray.

use slimbvh::generate::{TorusKnot, append, ground, torus_knot};
use slimbvh::{BuildConfig, Builder, Camera, Ray, Tiles};
use std::error::Error;

const SIZE: [u32; 2] = [72, 36];

fn main() -> Result<(), Box<dyn Error>> {
    let mut mesh = torus_knot(&TorusKnot::default());
    append(&mut mesh, ground(6.0, 32), "floor", 0);
    let bounds = mesh.bounds().ok_or("there are no triangles")?;
    let camera = Camera::facing(&bounds, 2.0);
    let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;

    // Picking: what does the mouse point at?
    let ray = camera.ray([36, 18], SIZE)?;
    let hit = bvh.closest_hit(&ray);
    let point = bvh.surface(&mesh, &ray, &hit).ok_or("nothing is there")?;
    let part = mesh
        .part_of(hit.primitive)
        .map_or("no part", |part| &part.name);
    println!(
        "pixel (36, 18): triangle {} of {part:?} at {:?}",
        hit.primitive, point.position
    );

    // Line of sight, from a surface to a place: no offset is needed at either end.
    let sees = |place: [f32; 3]| !bvh.any_hit(Ray::between(&point, place));
    println!(
        "it sees the eye: {}, what is under the floor: {}",
        sees(camera.eye),
        sees([0.0, -9.0, 0.0])
    );

    // Layers: the same ray without the floor. All hits along it, in order.
    let knot = |hit: &slimbvh::Hit| {
        mesh.part_of(hit.primitive)
            .is_none_or(|part| part.name != "floor")
    };
    println!(
        "its knot: {}, its hits: {}",
        bvh.closest_hit_where(&ray, knot).is_hit(),
        bvh.all_hits(&ray).len()
    );

    // Ambient occlusion: the share of 64 directions around the normal that meet nothing.
    let tiles = Tiles {
        width: SIZE[0],
        height: SIZE[1],
    };
    let rays: Vec<Ray> = tiles
        .pixels_from(0)
        .take(72 * 36)
        .map(|pixel| camera.ray(pixel, SIZE))
        .collect::<Result<_, _>>()?;
    let mut hits = Vec::new();
    bvh.closest_hits(&rays, &mut hits);
    let mut picture = vec![b' '; 72 * 36];
    for (i, (ray, hit)) in rays.iter().zip(&hits).enumerate() {
        let Some(point) = bvh.surface(&mesh, ray, hit) else {
            continue;
        };
        let around = (0..64).map(|k| point.ray(around(point.normal, k)));
        let free = around.filter(|ray| !bvh.any_hit(ray)).count();
        let [x, y] = tiles.pixel(i as u32);
        picture[(y * SIZE[0] + x) as usize] = b"@%#*+=-:."[free * 8 / 64];
    }
    for row in picture.chunks(SIZE[0] as usize) {
        println!("{}", String::from_utf8_lossy(row));
    }
    Ok(())
}

/// The k-th of 64 directions on the side of a normal: a Fibonacci spiral on the sphere, turned over where it points inward.
fn around(normal: [f32; 3], k: u32) -> [f32; 3] {
    let z = 1.0 - (2.0 * k as f32 + 1.0) / 64.0;
    let (sin, cos) = (2.399_963 * k as f32).sin_cos();
    let radius = (1.0 - z * z).sqrt();
    let direction = [radius * cos, radius * sin, z];
    let inward = (0..3).map(|i| direction[i] * normal[i]).sum::<f32>() < 0.0;
    direction.map(|x| if inward { -x } else { x })
}
