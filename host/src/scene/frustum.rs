//! The frustum of a camera: planes that contain all its rays.

use crate::dvec3::{cross, dot, normalized};
use slimbvh_core::camera::Camera;
use slimbvh_core::frustum::Frustum;

/// How far each plane is turned or moved outward: a share of the picture's half width or height.
const MARGIN: f64 = 1.0 / 4096.0;

/// A bound on the rounding error of a ray's direction, or of a parallel ray's origin, as a share of its length: two
/// products, two sums and the plane's own coordinates each round by 2^-24.
const ROUNDING: f64 = 1.0 / 524_288.0;

/// The planes around a camera's picture, in the caller's unit. No ray of [`Camera::ray`] leaves them, rounding included. An
/// edge that rounding cannot separate from the middle, as of a nearly empty picture, gets a plane that bounds nothing.
#[must_use]
pub fn frustum(camera: &Camera) -> Frustum {
    let wide = |v: [f32; 3]| v.map(f64::from);
    let [eye, forward, right, up] = [camera.eye, camera.forward, camera.right, camera.up].map(wide);
    let negative = |v: [f64; 3]| v.map(|x| -x);
    let sides = [
        (right, up),
        (negative(right), up),
        (up, right),
        (negative(up), right),
    ];
    let planes = sides.map(|(toward, along)| {
        let plane = if camera.is_parallel == 1 {
            parallel_side(eye, toward, length(along))
        } else {
            let spread = f64::from(camera.lens_slope) / length(toward);
            let [x, y, z] = perspective_side(forward, toward, along, spread);
            [x, y, z, lens_offset(eye, camera.lens_radius)]
        };
        let plane = plane.map(|x| x as f32);
        if plane.iter().all(|x| x.is_finite()) {
            plane
        } else {
            [0.0; 4]
        }
    });
    Frustum {
        eye: camera.eye,
        is_bounded: 1,
        planes,
    }
}

/// The plane through the eye and one edge of the picture. `toward` points from the edge to the middle, `along` runs along
/// the edge. Beyond the focus, the rays through a lens spread past the edge by the share `spread` of the picture's half.
fn perspective_side(forward: [f64; 3], toward: [f64; 3], along: [f64; 3], spread: f64) -> [f64; 3] {
    let longest = length(forward) + length(toward) + length(along);
    let edge_at = |share: f64| std::array::from_fn(|i| forward[i] + share * toward[i]);
    let plane_at = |share: f64| {
        let normal = normalized(cross(along, edge_at(share)));
        if dot(normal, forward) < 0.0 {
            normal.map(|x| -x)
        } else {
            normal
        }
    };
    // A ray at share s of the way to the edge is (edge − s) times this above the plane.
    let edge = 1.0 + MARGIN + spread;
    let slope = -dot(plane_at(edge), toward);
    let rounding = ROUNDING * longest / slope;
    if slope > 0.0 && rounding < 1.0 {
        plane_at(edge + rounding)
    } else {
        [0.0; 3]
    }
}

/// How far a lens's rays may start beyond a plane through the eye.
fn lens_offset(eye: [f64; 3], radius: f32) -> f64 {
    if radius == 0.0 {
        return 0.0;
    }
    let largest = eye.iter().fold(0.0, |most: f64, x| x.abs().max(most));
    f64::from(radius) * (1.0 + MARGIN) + ROUNDING * largest
}

/// The plane at one edge of the picture; `toward` points from the edge to the middle. Rounding of a ray's direction grows
/// with its length; the test of the frustum allows for that.
fn parallel_side(eye: [f64; 3], toward: [f64; 3], along: f64) -> [f64; 4] {
    let half = length(toward);
    let [x, y, z] = normalized(toward).map(|x| -x);
    let largest = eye.iter().fold(half + along, |most, x| x.abs().max(most));
    [x, y, z, half * (1.0 + MARGIN) + ROUNDING * largest]
}

fn length(v: [f64; 3]) -> f64 {
    dot(v, v).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Camera as SceneCamera, Projection};
    use glam::Vec3;
    use proptest::prelude::*;
    use slimbvh_core::Triangle;
    use slimbvh_core::bounds::scene_exponent;
    use slimbvh_core::float::PowerOfTwo;
    use slimbvh_core::snap::leaf_triangle;
    use slimbvh_core::trace::{BruteForce, LeafTriangles, Skip, closest_hit};

    /// Samples a pixel.
    const SAMPLE_COUNT: u32 = 4;

    fn camera(eye: [f32; 3], target: [f32; 3], projection: Projection) -> Camera {
        let up = [0.1, 1.0, 0.0];
        let camera = SceneCamera {
            eye,
            target,
            up,
            projection,
        };
        camera.to_core([7, 5], SAMPLE_COUNT).unwrap()
    }

    fn projections() -> impl Strategy<Value = Projection> {
        let perspective = prop_oneof![1e-3f32..1.0, 1.0f32..179.0, 179.0f32..179.99];
        let height = prop_oneof![1e-4f32..1e-2, 1e-2f32..10.0];
        let fov = prop_oneof![1e-3f32..1.0, 1.0f32..170.0];
        let lens = (fov, 1e-4f32..0.5, 0.1f32..10.0);
        let lens = lens.prop_map(
            |(vertical_fov, radius, focus_distance)| Projection::ThinLens {
                vertical_fov,
                radius,
                focus_distance,
            },
        );
        prop_oneof![
            lens,
            perspective.prop_map(|vertical_fov| Projection::Perspective { vertical_fov }),
            height.prop_map(|height| Projection::Orthographic { height }),
        ]
    }

    fn points(reach: f32) -> impl Strategy<Value = [f32; 3]> {
        proptest::array::uniform3(-reach..reach)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]
        #[test]
        fn no_ray_hits_what_is_certainly_outside(
            eye in prop_oneof![points(1.0), points(300.0)],
            target in points(1.0),
            projection in projections(),
            middle in points(2.0),
            corners in proptest::array::uniform3(prop_oneof![points(1e-3), points(1.0), points(50.0)]),
        ) {
            prop_assume!(eye != target);
            let camera = camera(eye, target, projection);
            let vertices = corners.map(|corner| (Vec3::from(middle) + Vec3::from(corner)).to_array());
            let mesh = crate::Mesh { vertices: vertices.to_vec(), indices: vec![[0, 1, 2]], ..crate::Mesh::default() };
            let scale = PowerOfTwo::new(scene_exponent(&mesh.bounds().unwrap()));
            let leaf = leaf_triangle(0, &mesh.triangles(), &scale);
            if frustum(&camera).scaled(&scale).is_certainly_outside(&leaf.triangle()) {
                let camera = camera.scaled(&scale);
                for sample in 0..35 * SAMPLE_COUNT {
                    let ray = camera.ray(sample);
                    let hit = closest_hit(&BruteForce(1), &LeafTriangles(&[leaf]), &ray, 0, &Skip::NONE);
                    prop_assert!(!hit.is_hit(), "sample {sample} {hit:?}");
                }
            }
        }

        /// The control: objects a hundredth of the picture outside are found to be outside.
        #[test]
        fn little_more_than_the_picture_is_inside(
            eye in points(1.0),
            target in points(1.0),
            fov in 1.0f32..170.0,
            share in 1.01f32..3.0,
            depth in 0.1f32..10.0,
            side in 0usize..4,
        ) {
            prop_assume!((Vec3::from(eye) - Vec3::from(target)).length() > 0.1);
            for projection in [
                Projection::Perspective { vertical_fov: fov },
                Projection::Orthographic { height: fov / 50.0 },
            ] {
                let camera = camera(eye, target, projection);
                let sides = [camera.right, camera.up].map(Vec3::from);
                let toward = if side % 2 == 0 { sides[side / 2] } else { -sides[side / 2] };
                let is_parallel = camera.is_parallel == 1;
                let spread = if is_parallel { 1.0 } else { depth };
                let at = |share: f32| {
                    let middle = Vec3::from(eye) + Vec3::from(camera.forward) * depth;
                    middle + toward * share * spread
                };
                let point = |share: f32| Triangle { v0: at(share), v1: at(share), v2: at(share) };
                let frustum = frustum(&camera);
                prop_assert!(frustum.is_certainly_outside(&point(share)), "{projection:?}");
                prop_assert!(!frustum.is_certainly_outside(&point(0.999)), "{projection:?}");
            }
        }
    }
}
