//! Targets of rays: balls that contain a camera's lens or an area light.

use crate::dvec3::dot;
use slimbvh_core::camera::Camera;
use slimbvh_core::float::{abs, max, next_up};
use slimbvh_core::light::{DISC, Light, NO_EXTENT};
use slimbvh_core::orientation::Target;

/// The ball from which all rays of a camera start, in the camera's unit.
#[must_use]
pub fn camera_target(camera: &Camera) -> Target {
    if camera.is_parallel == 1 {
        Target::direction(camera.forward.map(|x| -x))
    } else if camera.lens_radius > 0.0 {
        ball(camera.eye, camera.lens_radius.into())
    } else {
        Target::position(camera.eye)
    }
}

/// The ball to which all shadow rays to a light lead, in the light's unit.
#[must_use]
pub fn light_target(light: &Light) -> Target {
    if light.shape == NO_EXTENT {
        return Target {
            is_position: light.is_position,
            ..Target::direction(light.point)
        };
    }
    let [a, b] = [light.edge_1, light.edge_2].map(|edge| edge.map(f64::from));
    let (aa, bb, ab) = (dot(a, a), dot(b, b), dot(a, b));
    let squared = if light.shape == DISC {
        // The longer half axis of the ellipse.
        0.5 * (aa + bb + ((aa - bb).powi(2) + 4.0 * ab * ab).sqrt())
    } else {
        // The further corner.
        aa + bb + 2.0 * ab.abs()
    };
    ball(light.point, squared.sqrt())
}

/// A ball that also contains points displaced by rounding: of a point's three terms and their sums, on each axis.
fn ball(center: [f32; 3], radius: f64) -> Target {
    let largest = center.iter().fold(0.0, |largest, &x| max(largest, abs(x)));
    let radius = radius * (1.0 + 1e-6) + f64::from(largest) * 2e-7;
    let rounded = next_up((radius as f32).min(f32::MAX / 2.0));
    Target::ball(center, rounded)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use slimbvh_core::light::RECTANGLE;
    use slimbvh_core::sampling::Draw;

    fn vector(size: f32) -> impl Strategy<Value = [f32; 3]> {
        proptest::array::uniform3(-size..size)
    }

    fn distance(a: [f32; 3], b: [f32; 3]) -> f64 {
        let r: [f64; 3] = std::array::from_fn(|i| f64::from(a[i]) - f64::from(b[i]));
        dot(r, r).sqrt()
    }

    proptest! {
        #[test]
        fn the_ball_holds_every_point_that_is_drawn(
            point in prop_oneof![vector(1.0), vector(1e4)],
            edge_1 in vector(1.0),
            edge_2 in vector(1.0),
            shape in DISC..=RECTANGLE,
            pixel in 0u32..1 << 20,
        ) {
            let light = Light { point, edge_1, edge_2, shape, is_position: 1, ..Light::default() };
            let target = light_target(&light);
            let (ball, mut farthest) = (f64::from(target.radius), 0.0f64);
            for i in 0..1024 {
                let draw = Draw { sample: pixel * 1024 + i, sample_count: 1024, bounce: 0 };
                farthest = farthest.max(distance(light.sampled(&draw).point, point));
            }
            prop_assert!(farthest <= ball, "{farthest} {ball}");
            // And it is hardly larger than needed: points come near the rim, rounding and corners aside.
            prop_assert!(farthest > 0.8 * (ball - 4e-3), "{farthest} {ball}");
        }

        #[test]
        fn the_ball_holds_every_point_of_a_lens(eye in prop_oneof![vector(1.0), vector(1e4)], radius in 1e-3f32..2.0) {
            let camera = Camera {
                eye,
                forward: [0.0, 0.6, 0.8],
                right: [1.0, 0.0, 0.0],
                up: [0.0, 0.8, -0.6],
                width: 1,
                height: 1,
                sample_count: 1024,
                lens_right: [1.0, 0.0, 0.0],
                lens_radius: radius,
                lens_up: [0.0, 0.8, -0.6],
                lens_slope: 0.1,
                ..Camera::default()
            };
            let ball = f64::from(camera_target(&camera).radius);
            let far = (0..1024).map(|i| distance(camera.ray(i).origin, eye)).fold(0.0, f64::max);
            prop_assert!(far <= ball && far > 0.9 * (ball - 4e-3), "{far} {ball}");
        }
    }

    #[test]
    fn without_an_extent_it_is_a_point_or_a_direction() {
        let lamp = Light {
            point: [1.0, 2.0, 3.0],
            is_position: 1,
            ..Light::default()
        };
        assert_eq!(light_target(&lamp), Target::position([1.0, 2.0, 3.0]));
        let sun = Light {
            is_position: 0,
            ..lamp
        };
        assert_eq!(light_target(&sun), Target::direction([1.0, 2.0, 3.0]));
        let pinhole = Camera {
            eye: [1.0, 2.0, 3.0],
            ..Camera::default()
        };
        assert_eq!(camera_target(&pinhole), Target::position([1.0, 2.0, 3.0]));
    }
}
