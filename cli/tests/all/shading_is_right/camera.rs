//! The camera: where objects appear in the picture.

use super::{is_inside, meet, pixel_ray, pixels, quads, render, settings};
use crate::wide::{Wide, wide};
use glam::Vec3;
use slimbvh::scene::ViewError;
use slimbvh::{Camera, Mesh, Projection, RenderSettings, Scene, View};
use slimbvh_core::Aabb;
use slimbvh_core::bounds::scene_exponent;
use slimbvh_core::float::PowerOfTwo;

/// Four quads of one size, facing +z, at several depths.
const QUADS: [(Wide, Wide, Wide); 4] = [
    (wide(-3.0, 1.0, 0.0), SIDE, UP),
    (wide(1.0, 1.0, -5.0), SIDE, UP),
    (wide(-3.0, -2.0, -50.0), SIDE, UP),
    (wide(1.0, -2.0, -500.0), SIDE, UP),
];
const SIDE: Wide = wide(2.0, 0.0, 0.0);
const UP: Wide = wide(0.0, 1.0, 0.0);

fn camera(projection: Projection) -> Camera {
    Camera {
        eye: [0.1, 0.2, 10.0],
        target: [0.1, 0.2, 0.0],
        up: [0.0, 1.0, 0.0],
        projection,
    }
}

fn view(camera: Camera, size: [u32; 2], view: View) -> Vec<[f32; 3]> {
    let scene = Scene {
        mesh: quads(&QUADS),
        cameras: vec![camera],
        ..Scene::default()
    };
    let settings = RenderSettings {
        view,
        ..settings(size)
    };
    render(&scene, &settings).0.pixels
}

/// Every pixel shows the primitive that the definition of the camera predicts, in pictures of all shapes.
#[test]
fn each_pixel_has_its_ray() {
    let parallel = Projection::Orthographic { height: 6.5 };
    let pinhole = Projection::Perspective { vertical_fov: 60.0 };
    let from_aside = Camera {
        eye: [9.0, 4.0, 7.0],
        target: [-0.5, 0.0, 0.0],
        up: [0.3, 1.0, 0.1],
        ..camera(pinhole)
    };
    for size in [[160, 90], [90, 160], [101, 101], [7, 200], [200, 3], [1, 1]] {
        for camera in [camera(parallel), camera(pinhole), from_aside] {
            let found = view(camera, size, View::Primitives);
            let mut skipped = 0;
            for (pixel, place) in pixels(size) {
                let (origin, direction) = pixel_ray(&camera, size, place);
                match quad_met(origin, direction) {
                    Some(Some(quad)) => {
                        // Each quad has two triangles, and the pixel shows one of them.
                        let colors = [2 * quad, 2 * quad + 1]
                            .map(|i| slimbvh_core::view::primitive_color(i).to_array());
                        assert!(
                            colors.contains(&found[pixel]),
                            "{size:?} {place:?}: {:?}",
                            found[pixel]
                        );
                    }
                    Some(None) => assert_eq!(found[pixel], [0.0; 3], "{size:?} {place:?}"),
                    None => skipped += 1,
                }
            }
            assert!(skipped * 50 <= found.len(), "{skipped}");
        }
    }
}

/// The nearest quad on a ray; `None` where rounding decides.
fn quad_met(origin: Wide, direction: Wide) -> Option<Option<u32>> {
    let mut nearest = (f64::INFINITY, None);
    for (quad, number) in QUADS.into_iter().zip(0..) {
        if let Some(place) = meet(quad, origin, direction)
            && is_inside(place)?
            && place[0] < nearest.0
        {
            nearest = (place[0], Some(number));
        }
    }
    Some(nearest.1)
}

#[test]
fn parallel_rays_show_no_distance() {
    let size = [208, 130];
    let found = view(
        camera(Projection::Orthographic { height: 6.5 }),
        size,
        View::Primitives,
    );
    for quad in 0..4 {
        let colors =
            [2 * quad, 2 * quad + 1].map(|i| slimbvh_core::view::primitive_color(i).to_array());
        let area = found.iter().filter(|color| colors.contains(color)).count();
        // A unit is 20 pixels, and a quad is 2 x 1 units.
        assert_eq!(area, 800, "{quad}");
    }
    // With a pinhole the far quads are small.
    let found = view(
        camera(Projection::Perspective { vertical_fov: 60.0 }),
        size,
        View::Primitives,
    );
    let far = [6, 7].map(|i| slimbvh_core::view::primitive_color(i).to_array());
    assert!(found.iter().filter(|color| far.contains(color)).count() < 10);
}

/// Depth is measured along the view: a quad that faces the camera has one depth all over.
#[test]
fn depth_of_what_faces_the_camera_is_even() {
    for projection in [
        Projection::Orthographic { height: 6.5 },
        Projection::Perspective { vertical_fov: 60.0 },
    ] {
        let size = [160, 120];
        let camera = camera(projection);
        let found = view(camera, size, View::Depth);
        let depths: Vec<_> = pixels(size)
            .filter_map(|(pixel, place)| {
                let (origin, direction) = pixel_ray(&camera, size, place);
                let quad = quad_met(origin, direction)??;
                Some((pixel, 10.0 - QUADS[quad as usize].0.z))
            })
            .collect();
        // Shades run from 10 at the nearest quad to the depth that one hit in a hundred exceeds. Farther hits are as dark.
        let mut sorted: Vec<_> = depths.iter().map(|&(_, depth)| depth).collect();
        sorted.sort_by(f64::total_cmp);
        let far = sorted[sorted.len() - 1 - sorted.len() / 100];
        assert!(far > 10.0, "{far}");
        for (pixel, depth) in depths {
            let share = (1.0 / 10.0 - 1.0 / depth) / (1.0 / 10.0 - 1.0 / far);
            let expected = 0.9 - 0.85 * share.min(1.0);
            assert!(
                super::distance(found[pixel], wide(expected, expected, expected)) < 1e-5,
                "{pixel}"
            );
        }
    }
}

#[test]
fn a_camera_is_the_same_in_every_unit() {
    for projection in [
        Projection::Perspective { vertical_fov: 50.0 },
        Projection::Orthographic { height: 6.5 },
    ] {
        let of = |exponent: i32| {
            let unit = 2.0_f32.powi(exponent);
            let place = |p: [f32; 3]| p.map(|x| x * unit);
            let camera = Camera {
                eye: place([1.0, 2.0, 3.5]),
                target: place([-0.3, 0.7, -9.0]),
                up: [0.1, 1.0, 0.0],
                projection: match projection {
                    Projection::Orthographic { height } => Projection::Orthographic {
                        height: height * unit,
                    },
                    perspective => perspective,
                },
            };
            let core = camera.to_core([17, 9], 4).expect("it is sound");
            core.scaled(&PowerOfTwo::new(-exponent))
        };
        for exponent in [-110, -3, 40, 120] {
            assert_eq!(of(exponent), of(0));
        }
    }
}

#[test]
fn a_camera_may_be_too_far_away_for_a_tiny_scene() {
    let far = Camera {
        eye: [0.0, 1e30, 0.0],
        ..camera(Projection::Perspective { vertical_fov: 50.0 })
    };
    assert!(far.to_core([4, 3], 1).is_ok());
    assert_eq!(far.check_reach(20), Ok(()));
    let error = ViewError::TooFar { eye: far.eye };
    assert_eq!(far.check_reach(60), Err(error));
}

/// Boxes of many sizes and positions.
fn boxes() -> Vec<Aabb> {
    let mut boxes = Vec::new();
    let shapes = [
        [1.0, 2.0, 3.0],
        [1.0, 1.0, 1.0],
        [100.0, 1.0, 1.0],
        [1.0, 100.0, 1.0],
        [0.01, 0.01, 5.0],
        [1.0, 0.0, 2.0],
        [0.36, 0.24, 0.9],
    ];
    let offsets = [
        [0.0; 3],
        [3.0, -5.0, 7.0],
        [-100.0, 0.0, 0.0],
        [1e4, 1e4, -1e4],
    ];
    for shape in shapes.map(Vec3::from_array) {
        for offset in offsets.map(Vec3::from_array) {
            for scale in [1.0, 1e-30, 1e30, 1e-3, 6e33] {
                boxes.push(Aabb {
                    min: (offset - shape / 2.0) * scale,
                    max: (offset + shape / 2.0) * scale,
                });
            }
        }
    }
    boxes
}

#[test]
fn the_default_camera_sees_the_whole_model() {
    for bounds in boxes() {
        for size in [[160, 90], [100, 100], [90, 160], [1000, 10], [10, 1000]] {
            let mut scene = Scene::default();
            scene.complete(Some(bounds), size);
            let exponent = scene_exponent(&bounds);
            let camera = scene.cameras[0].to_core(size, 1);
            let camera = camera.unwrap_or_else(|error| panic!("{bounds:?} {size:?}: {error}"));
            let camera = camera.scaled(&PowerOfTwo::new(exponent));
            let light = scene.lights[0].to_core(0);
            light.unwrap_or_else(|error| panic!("{bounds:?}: {error}"));
            let [eye, forward, right, up] =
                [camera.eye, camera.forward, camera.right, camera.up].map(Wide::from);
            let mut largest: f64 = 0.0;
            for corner in 0..8 {
                let pick = |axis: usize| {
                    let end = [bounds.min, bounds.max][corner >> axis & 1];
                    f64::from(end[axis]) * 2.0_f64.powi(exponent)
                };
                let way = wide(pick(0), pick(1), pick(2)) - eye;
                let depth = way.dot(forward);
                assert!(depth > 0.0, "{bounds:?} {size:?}: behind the camera");
                for edge in [right, up] {
                    let place = way.dot(edge) / edge.dot(edge) / depth;
                    assert!(place.abs() <= 1.0, "{bounds:?} {size:?}: {place}");
                    largest = largest.max(place.abs());
                }
            }
            // The model is not a dot.
            assert!(largest > 0.2, "{bounds:?} {size:?}: {largest}");
        }
    }
}

/// The same with rays: a model of extreme size is whole in the picture.
#[test]
fn the_default_camera_shows_models_of_extreme_size() {
    for scale in [1.0, 1e-30, 1e30, 1e-36, 1e37] {
        for size in [[64, 36], [36, 64]] {
            let solid = slimbvh::generate::icosphere(Vec3::new(5.0, 6.0, 7.0), 1.0, 3);
            let mut scene = Scene {
                mesh: Mesh {
                    vertices: solid
                        .vertices
                        .iter()
                        .map(|v| v.map(|x| x * scale))
                        .collect(),
                    ..solid
                },
                ..Scene::default()
            };
            let ends = [4.0, 5.0, 6.0, 6.0, 7.0, 8.0].map(|x: f32| x * scale);
            let bounds = Aabb {
                min: Vec3::from_slice(&ends[..3]),
                max: Vec3::from_slice(&ends[3..]),
            };
            scene.complete(Some(bounds), size);
            let (picture, report) = render(&scene, &settings(size));
            // The ball is in the middle, with sky on all sides.
            let share = report.primary_hit_count as f64 / (36.0 * 36.0);
            assert!((0.15..0.5).contains(&share), "{scale}: {share}");
            let corners = [
                0,
                size[0] - 1,
                size[0] * (size[1] - 1),
                size[0] * size[1] - 1,
            ];
            let ball = picture.pixels[(size[0] * (size[1] + 1) / 2) as usize];
            assert!(
                corners
                    .iter()
                    .all(|&corner| picture.pixels[corner as usize] != ball)
            );
            // The ball is lit.
            let brightest = picture
                .pixels
                .iter()
                .map(|color| color[0])
                .fold(0.0, f32::max);
            assert!((0.6..0.9).contains(&brightest), "{scale}: {brightest}");
        }
    }
}
