//! The unit does not matter: a scene scaled by a power of two makes the same picture, bit for bit.

use super::render;
use slimbvh::generate::default_scene;
use slimbvh::{Camera, Light, Projection, RenderSettings, Scene, View};

/// The scene scaled by a power of two. The color of a positional light scales twice: it is the irradiance at distance 1.
fn scaled(mut scene: Scene, factor: f32) -> Scene {
    let scale = |v: [f32; 3]| v.map(|x| x * factor);
    for vertex in &mut scene.mesh.vertices {
        *vertex = scale(*vertex);
    }
    for camera in &mut scene.cameras {
        let projection = match camera.projection {
            Projection::Orthographic { height } => Projection::Orthographic {
                height: height * factor,
            },
            Projection::ThinLens {
                vertical_fov,
                radius,
                focus_distance,
            } => Projection::ThinLens {
                vertical_fov,
                radius: radius * factor,
                focus_distance: focus_distance * factor,
            },
            perspective @ Projection::Perspective { .. } => perspective,
        };
        *camera = Camera {
            eye: scale(camera.eye),
            target: scale(camera.target),
            projection,
            ..*camera
        };
    }
    for light in &mut scene.lights {
        match light {
            Light::Directional { .. } => {}
            Light::Point {
                position,
                color,
                range,
            } => {
                *position = scale(*position);
                *color = scale(scale(*color));
                *range *= factor;
            }
            Light::Area {
                center,
                half_edges,
                color,
                range,
                ..
            } => {
                *center = scale(*center);
                *half_edges = half_edges.map(scale);
                *color = scale(scale(*color));
                *range *= factor;
            }
        }
    }
    scene
}

#[test]
fn any_power_of_two_makes_the_same_picture() {
    let mut scene = default_scene();
    // The range of this light ends in the picture.
    scene.lights.push(Light::Point {
        position: [-1.0, 2.0, 3.0],
        color: [3.0, 4.0, 5.0],
        range: 3.5,
    });
    let parallel = Camera {
        projection: Projection::Orthographic { height: 5.0 },
        ..scene.cameras[0]
    };
    scene.lights.push(Light::disc(
        [-2.0, 4.0, 3.0],
        [0.5, -1.0, -0.8],
        0.75,
        [9.0; 3],
    ));
    let lens = Camera {
        projection: Projection::ThinLens {
            vertical_fov: 30.0,
            radius: 0.1,
            focus_distance: 6.0,
        },
        ..scene.cameras[0]
    };
    for camera in [scene.cameras[0], parallel, lens] {
        scene.cameras[0] = camera;
        for view in [
            View::Color,
            View::Normals,
            View::Depth,
            View::Primitives,
            View::Heatmap,
        ] {
            let settings = RenderSettings {
                size: [160, 90],
                view,
                ..RenderSettings::default()
            };
            let (picture, report) = render(&scene, &settings);
            for exponent in [20, -20, 57, -58] {
                let (other, other_report) =
                    render(&scaled(scene.clone(), 2.0_f32.powi(exponent)), &settings);
                assert!(picture == other, "{view:?} in units of 2^{exponent}");
                assert_eq!(report.shadow_ray_count, other_report.shadow_ray_count);
            }
        }
    }
    // Negative control: a factor other than a power of two rounds.
    let settings = RenderSettings {
        size: [160, 90],
        ..RenderSettings::default()
    };
    assert!(render(&scene, &settings).0 != render(&scaled(scene.clone(), 1.1), &settings).0);
}

/// The last samples of a large picture are its own, not those of the first wave.
#[test]
fn waves_join_without_a_seam() {
    let scene = default_scene();
    let picture = |sample_count, size| {
        let settings = RenderSettings {
            size,
            sample_count,
            view: View::Depth,
            ..RenderSettings::default()
        };
        render(&scene, &settings).0
    };
    // 16 samples per pixel are the pixel centers of a picture of four times the size. Both pictures take several waves.
    let (coarse, fine) = (picture(16, [320, 180]), picture(1, [1280, 720]));
    for (pixel, &found) in coarse.pixels.iter().enumerate() {
        let (x, y) = (pixel % 320, pixel / 320);
        let mean = (0..16)
            .map(|i| f64::from(fine.pixels[(y * 4 + i / 4) * 1280 + x * 4 + i % 4][0]))
            .sum::<f64>()
            / 16.0;
        assert!(
            (f64::from(found[0]) - mean).abs() < 0.06,
            "{x} {y}: {found:?}, not {mean}"
        );
    }
}
