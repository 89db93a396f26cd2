//! Pictures compared with closed forms, which are computed here in f64 from the scene alone.

mod area;
mod camera;
mod closed;
mod glass;
mod lambert;
mod lens;
mod mirror;
mod scaled;
mod shutter;

use crate::wide::Wide;
use slimbvh::{
    BuildConfig, Builder, Bvh, Camera, Material, Mesh, Picture, Projection, RenderReport,
    RenderSettings, Renderer, Scene,
};
use std::f64::consts::PI;

/// Builds a scene's tree and renders it.
pub fn render(scene: &Scene, settings: &RenderSettings) -> (Picture, RenderReport) {
    let mut bvh = Bvh::default();
    let build = Builder::new(BuildConfig::default()).build_into(&scene.mesh, &mut bvh);
    build.expect("the mesh is sound");
    let mut picture = Picture::default();
    let report = Renderer::new().render(scene, &bvh, settings, &mut picture, |_| {});
    (picture, report.expect("the view is sound"))
}

/// One sample per pixel.
fn settings(size: [u32; 2]) -> RenderSettings {
    RenderSettings {
        size,
        ..RenderSettings::default()
    }
}

/// A mesh of parallelograms with one material each, given as a corner and the two edges that leave it. The edges turn
/// counter-clockwise as seen from the front.
fn quads(quads: &[(Wide, Wide, Wide)]) -> Mesh {
    let mut mesh = Mesh::default();
    for (material, &(corner, a, b)) in quads.iter().enumerate() {
        let first = mesh.vertices.len() as u32;
        mesh.vertices
            .extend([corner, corner + a, corner + a + b, corner + b].map(Wide::narrow));
        mesh.indices
            .extend([[0, 1, 2], [0, 2, 3]].map(|t: [u32; 3]| t.map(|vertex| first + vertex)));
        mesh.materials.extend([material as u32; 2]);
    }
    mesh
}

/// The origin and the direction of a pixel's ray. The direction advances by one along the view.
fn pixel_ray(camera: &Camera, [width, height]: [u32; 2], [x, y]: [f64; 2]) -> (Wide, Wide) {
    let forward = (Wide::from(camera.target) - Wide::from(camera.eye)).normalize();
    let right = forward.cross(Wide::from(camera.up)).normalize();
    let up = right.cross(forward);
    let half_height = match camera.projection {
        Projection::Perspective { vertical_fov } | Projection::ThinLens { vertical_fov, .. } => {
            (f64::from(vertical_fov).to_radians() / 2.0).tan()
        }
        Projection::Orthographic { height } => f64::from(height) / 2.0,
    };
    let (width, height) = (f64::from(width), f64::from(height));
    let s = (x / width * 2.0 - 1.0) * half_height * width / height;
    let t = (1.0 - y / height * 2.0) * half_height;
    match camera.projection {
        Projection::Perspective { .. } | Projection::ThinLens { .. } => {
            (Wide::from(camera.eye), forward + right * s + up * t)
        }
        Projection::Orthographic { .. } => (Wide::from(camera.eye) + right * s + up * t, forward),
    }
}

/// Where a ray meets a parallelogram: the ray's parameter, and the coordinates along both edges, 0 to 1 inside.
fn meet((corner, a, b): (Wide, Wide, Wide), origin: Wide, direction: Wide) -> Option<[f64; 3]> {
    let normal = a.cross(b);
    let t = (corner - origin).dot(normal) / direction.dot(normal);
    let p = origin + direction * t - corner;
    let (u, v) = (p.cross(b).dot(normal), a.cross(p).dot(normal));
    let area = normal.dot(normal);
    (t > 0.0).then_some([t, u / area, v / area])
}

/// Whether these coordinates are inside; `None` near the border, where rounding decides.
fn is_inside([_, u, v]: [f64; 3]) -> Option<bool> {
    const NEAR: f64 = 1e-4;
    let depth = u.min(v).min(1.0 - u).min(1.0 - v);
    (depth.abs() > NEAR).then_some(depth > 0.0)
}

/// The color of a surface with this irradiance, without the mirror's share.
fn diffuse(material: &Material, irradiance: Wide) -> Wide {
    let base_color = Wide::from(material.base_color);
    base_color * irradiance * ((1.0 - f64::from(material.mirror)) / PI)
}

/// The ambient irradiance of every surface.
fn ambient() -> Wide {
    Scene::environment([0.0, 1.0, 0.0]).ambient.into()
}

/// The color of the sky in a direction.
fn sky(up: [f32; 3], direction: Wide) -> Wide {
    let environment = Scene::environment(up);
    let height = direction
        .normalize()
        .dot(Wide::from(environment.up))
        .max(0.0);
    Wide::from(environment.horizon) * (1.0 - height) + Wide::from(environment.zenith) * height
}

/// The largest difference of a channel.
fn distance(found: [f32; 3], expected: Wide) -> f64 {
    expected.farthest(found.into())
}

/// All pixels, with their centers.
fn pixels([width, height]: [u32; 2]) -> impl Iterator<Item = (usize, [f64; 2])> {
    (0..width * height).map(move |pixel| {
        let center = [pixel % width, pixel / width].map(|i| f64::from(i) + 0.5);
        (pixel as usize, center)
    })
}
