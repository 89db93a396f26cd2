//! The GPU's pictures equal the CPU's.

use glam::Vec3;
use slimbvh::generate::{append, cuboid, default_scene, icosphere, soup, terrain};
use slimbvh::gpu::Gpu;
use slimbvh::{
    AreaShape, BuildConfig, Camera, Change, Light, Material, Output, Picture, Projection,
    RenderReport, RenderSettings, Scene, View,
};
use slimbvh_tests::build_as;
use slimbvh_tests::gpu::{done, gpu, whole_tree};
use slimbvh_tests::parity::alike;
use slimbvh_tests::scenes::real_meshes;

/// This share of the bytes may differ, by at most [`MOST`], as some values lie at the border between two bytes.
pub const SHARE: f64 = 1e-3;
pub const MOST: u8 = 1;

pub const VIEWS: [View; 5] = [
    View::Color,
    View::Normals,
    View::Depth,
    View::Primitives,
    View::Heatmap,
];

/// Settings of a small picture.
pub fn settings(view: View) -> RenderSettings {
    RenderSettings {
        size: [160, 90],
        view,
        ..RenderSettings::default()
    }
}

/// Renders on the GPU. Returns the picture and its counts.
pub fn of_gpu(gpu: &Gpu, scene: &Scene, settings: &RenderSettings) -> (Picture, RenderReport) {
    of_gpu_as(gpu, scene, settings, BuildConfig::default())
}

pub fn of_gpu_as(
    gpu: &Gpu,
    scene: &Scene,
    settings: &RenderSettings,
    config: BuildConfig,
) -> (Picture, RenderReport) {
    let mut picture = Picture::default();
    let mut frames = whole_tree(gpu, config);
    let output = Output {
        picture: &mut picture,
        progress: Some(&mut |_| {}),
    };
    let rendered = frames.render(scene, settings, Change::Scene, output);
    (picture, done(rendered).render)
}

/// Renders on the CPU.
pub fn of_cpu(scene: &Scene, settings: &RenderSettings) -> (Picture, RenderReport) {
    of_cpu_as(scene, settings, BuildConfig::default())
}

pub fn of_cpu_as(
    scene: &Scene,
    settings: &RenderSettings,
    config: BuildConfig,
) -> (Picture, RenderReport) {
    let bvh = build_as(&scene.mesh, config);
    let mut picture = Picture::default();
    let mut renderer = slimbvh::Renderer::new();
    let report = renderer.render(scene, &bvh, settings, &mut picture, |_| {});
    (picture, done(report))
}

fn counts(report: &RenderReport) -> [u64; 5] {
    [
        report.primary_ray_count,
        report.primary_hit_count,
        report.shadow_ray_count,
        report.mirror_ray_count,
        report.node_visit_count,
    ]
}

fn check(gpu: &Gpu, what: &str, scene: &Scene, settings: &RenderSettings) {
    check_as(gpu, what, scene, settings, BuildConfig::default());
}

/// Compares both pictures, and the counts of rays.
pub fn check_as(
    gpu: &Gpu,
    what: &str,
    scene: &Scene,
    settings: &RenderSettings,
    config: BuildConfig,
) {
    let (a, a_report) = of_gpu_as(gpu, scene, settings, config);
    let (b, b_report) = of_cpu_as(scene, settings, config);
    // On a hardware GPU last bits decide some rays: which of two triangles at one t is hit, or whether a node is opened.
    let most = if slimbvh_tests::gpu::is_software(gpu) {
        MOST
    } else {
        u8::MAX
    };
    let result = alike(&a, &b, SHARE, most);
    assert!(result.is_ok(), "{what}, {:?}: {result:?}", settings.view);
    let (a, b) = (counts(&a_report), counts(&b_report));
    if slimbvh_tests::gpu::is_software(gpu) {
        assert_eq!(a, b, "{what}, {:?}", settings.view);
    } else {
        // Last bits decide some rays.
        let near = |a: u64, b: u64| a.abs_diff(b) <= 2 + a / 1000;
        let all = a.iter().zip(&b).all(|(&a, &b)| near(a, b));
        assert!(all, "{what}, {:?}: {a:?} instead of {b:?}", settings.view);
    }
}

/// Without dark rays fewer shadow rays are traced, and none to a black light or to one that reaches nothing; the picture is
/// the same.
#[test]
fn rays_to_where_no_light_comes_from_change_nothing() {
    let mut scene = hall_of_mirrors();
    for (color, range) in [([0.0; 3], f32::INFINITY), ([9.0; 3], 1e-3)] {
        let position = [0.0, 2.0, 1.0];
        scene.lights.push(Light::Point {
            position,
            color,
            range,
        });
    }
    let settings = settings(View::Color);
    let dark = RenderSettings {
        dark_rays: true,
        ..settings
    };
    let hit_count = |report: &RenderReport| {
        report.primary_hit_count * scene.lights.len() as u64 <= report.shadow_ray_count
    };
    let (a, a_report) = of_cpu(&scene, &settings);
    let (b, b_report) = of_cpu(&scene, &dark);
    assert!(a == b && !hit_count(&a_report) && hit_count(&b_report));
    let Some(gpu) = gpu() else { return };
    let (a, a_report) = of_gpu(gpu, &scene, &settings);
    let (b, b_report) = of_gpu(gpu, &scene, &dark);
    assert!(a == b && !hit_count(&a_report) && hit_count(&b_report));
}

fn look_at(eye: [f32; 3], target: [f32; 3], projection: Projection) -> Camera {
    Camera {
        eye,
        target,
        up: [0.0, 1.0, 0.0],
        projection,
    }
}

/// Mirrors that reflect each other, three lights of both kinds, one of them near, and smooth and flat parts.
pub fn hall_of_mirrors() -> Scene {
    let material = |base_color, mirror| Material {
        base_color,
        mirror,
        ..Material::default()
    };
    let mut mesh = icosphere(Vec3::new(-0.6, 0.1, 0.0), 0.55, 4);
    append(
        &mut mesh,
        cuboid(Vec3::new(0.2, -0.5, -0.6), Vec3::new(1.1, 0.5, 0.3)),
        "box",
        1,
    );
    append(
        &mut mesh,
        cuboid(Vec3::new(-3.0, -0.6, -3.0), Vec3::new(3.0, -0.5, 3.0)),
        "floor",
        2,
    );
    append(
        &mut mesh,
        icosphere(Vec3::new(0.5, 0.8, 0.4), 0.25, 2),
        "ball",
        3,
    );
    Scene {
        mesh,
        materials: vec![
            material([0.9, 0.8, 0.7], 0.8),
            material([0.3, 0.5, 0.9], 0.5),
            material([0.7, 0.7, 0.6], 0.1),
            material([0.9, 0.2, 0.1], 0.0),
        ],
        cameras: vec![look_at(
            [0.5, 1.2, 3.5],
            [0.0, 0.1, 0.0],
            Projection::Perspective { vertical_fov: 40.0 },
        )],
        lights: vec![
            Light::Directional {
                direction: [0.5, -1.0, -0.3],
                color: [1.5, 1.4, 1.2],
            },
            Light::Point {
                position: [-1.5, 1.5, 1.0],
                color: [2.0, 3.0, 4.0],
                range: f32::INFINITY,
            },
            Light::Point {
                position: [1.2, 0.9, 1.0],
                color: [1.0, 0.5, 0.2],
                range: 1.4,
            },
        ],
        ..Scene::default()
    }
}

/// The hall seen through a lens, under lights with an extent.
pub fn soft_hall() -> Scene {
    let mut scene = hall_of_mirrors();
    scene.cameras[0].projection = Projection::ThinLens {
        vertical_fov: 40.0,
        radius: 0.1,
        focus_distance: 3.0,
    };
    scene.lights = vec![
        Light::disc([-1.5, 1.5, 1.0], [1.5, -1.5, -1.0], 0.4, [2.0, 3.0, 4.0]),
        Light::Area {
            center: [1.2, 1.9, 1.0],
            half_edges: [[0.5, 0.0, 0.1], [0.0, 0.1, 0.3]],
            shape: AreaShape::Rectangle,
            color: [4.0, 3.5, 3.0],
            range: f32::INFINITY,
        },
        Light::Area {
            center: [-1.2, 0.4, 1.6],
            half_edges: [[0.0, 0.5, 0.0], [0.3, 0.0, 0.3]],
            shape: AreaShape::Disc,
            color: [1.0, 3.5, 3.0],
            range: 2.5,
        },
    ];
    scene
}

/// Glass with three indices of refraction, before each other and before a mirror, smooth and flat, one of it partly opaque.
pub fn glasses() -> Scene {
    let glass = |base_color, transmission, ior| Material {
        base_color,
        transmission,
        ior,
        ..Material::default()
    };
    let mut scene = hall_of_mirrors();
    scene.materials[0] = glass([1.0; 3], 1.0, 1.5);
    scene.materials[3] = glass([0.9, 0.7, 0.4], 0.8, 1.33);
    let cube = cuboid(Vec3::new(-0.2, -0.4, 0.6), Vec3::new(0.2, 0.1, 1.0));
    append(&mut scene.mesh, cube, "cube", scene.materials.len() as u32);
    scene.materials.push(glass([0.6, 0.9, 0.7], 1.0, 2.4));
    scene
}

/// An open surface without normals, seen by parallel rays, with some indices of missing materials.
pub fn open_and_flat() -> Scene {
    let mut mesh = terrain(4.0, 40, 3);
    mesh.normals.clear();
    mesh.materials = (0..mesh.indices.len() as u32).map(|i| i % 5).collect();
    let colors = [[0.8, 0.3, 0.2], [0.2, 0.8, 0.3], [0.2, 0.3, 0.8]];
    let material = |base_color| Material {
        base_color,
        mirror: 0.0,
        ..Material::default()
    };
    Scene {
        mesh,
        materials: colors.map(material).to_vec(),
        cameras: vec![look_at(
            [3.0, 4.0, 3.0],
            [0.0, 0.0, 0.0],
            Projection::Orthographic { height: 4.0 },
        )],
        lights: vec![Light::Directional {
            direction: [0.3, -1.0, 0.2],
            color: [2.0; 3],
        }],
        ..Scene::default()
    }
}

/// A bare mesh: no materials, with the default camera and light.
pub fn completed(mesh: slimbvh::Mesh) -> Scene {
    let mut scene = Scene {
        mesh,
        ..Scene::default()
    };
    scene.complete(scene.mesh.bounds(), [160, 90]);
    scene
}

#[test]
fn the_default_scene_is_that_of_the_cpu_in_every_view() {
    let Some(gpu) = gpu() else { return };
    for view in VIEWS {
        check(gpu, "default scene", &default_scene(), &settings(view));
    }
}

#[test]
fn mirrors_lights_and_parallel_views_are_those_of_the_cpu() {
    let Some(gpu) = gpu() else { return };
    for view in VIEWS {
        check(gpu, "hall of mirrors", &hall_of_mirrors(), &settings(view));
        check(gpu, "open and flat", &open_and_flat(), &settings(view));
    }
    for mirror_depth in [0, 1, 9] {
        let settings = RenderSettings {
            size: [64, 48],
            mirror_depth,
            ..settings(View::Color)
        };
        check(gpu, "hall of mirrors", &hall_of_mirrors(), &settings);
    }
}

/// On few rays a last bit decides whether glass refracts or reflects.
#[test]
fn glass_is_that_of_the_cpu() {
    let Some(gpu) = gpu() else { return };
    for mirror_depth in [0, 1, 4, 9] {
        let settings = RenderSettings {
            mirror_depth,
            ..settings(View::Color)
        };
        check(gpu, "glasses", &glasses(), &settings);
    }
    let clear = of_cpu(&glasses(), &settings(View::Color)).0;
    let solid = of_cpu(&hall_of_mirrors(), &settings(View::Color)).0;
    assert!(alike(&clear, &solid, 0.05, MOST).is_err());
}

#[test]
fn soft_shadows_and_lenses_are_those_of_the_cpu() {
    let Some(gpu) = gpu() else { return };
    for view in VIEWS {
        check(gpu, "soft hall", &soft_hall(), &settings(view));
    }
    for (size, sample_count) in [([64, 48], 4), ([33, 17], 7), ([16, 9], 64)] {
        let settings = RenderSettings {
            size,
            sample_count,
            ..settings(View::Color)
        };
        check(gpu, "soft hall", &soft_hall(), &settings);
    }
}

#[test]
fn samples_and_odd_sizes_are_those_of_the_cpu() {
    let Some(gpu) = gpu() else { return };
    for (size, sample_count) in [([1, 1], 1), ([65, 3], 1), ([63, 7], 4), ([13, 17], 5)] {
        for view in VIEWS {
            let settings = RenderSettings {
                size,
                sample_count,
                ..settings(view)
            };
            check(gpu, "hall of mirrors", &hall_of_mirrors(), &settings);
        }
    }
}

#[test]
fn scenes_of_little_or_nothing_are_those_of_the_cpu() {
    let Some(gpu) = gpu() else { return };
    let dark = Scene {
        lights: Vec::new(),
        ..hall_of_mirrors()
    };
    let scenes = [
        ("nothing", completed(slimbvh::Mesh::default())),
        ("one triangle", completed(soup(1, 3))),
        ("five triangles", completed(soup(5, 3))),
        ("no lights", dark),
    ];
    for (name, scene) in scenes {
        for view in VIEWS {
            check(gpu, name, &scene, &settings(view));
        }
    }
}

#[test]
fn scenes_of_any_magnitude_are_those_of_the_cpu() {
    let Some(gpu) = gpu() else { return };
    for (scale, mut scene) in [1e-12, 1e-3, 1e9]
        .into_iter()
        .flat_map(|scale| [(scale, hall_of_mirrors()), (scale, soft_hall())])
    {
        let scaled = |p: [f32; 3]| p.map(|x| x * scale);
        for vertex in &mut scene.mesh.vertices {
            *vertex = scaled(*vertex);
        }
        let camera = &mut scene.cameras[0];
        (camera.eye, camera.target) = (scaled(camera.eye), scaled(camera.target));
        if let Projection::ThinLens {
            radius,
            focus_distance,
            ..
        } = &mut camera.projection
        {
            *radius *= scale;
            *focus_distance *= scale;
        }
        for light in &mut scene.lights {
            match light {
                Light::Directional { .. } => {}
                Light::Point {
                    position,
                    color,
                    range,
                } => {
                    *position = scaled(*position);
                    *color = color.map(|x| x * scale * scale);
                    *range *= scale;
                }
                Light::Area {
                    center,
                    half_edges,
                    color,
                    range,
                    ..
                } => {
                    *center = scaled(*center);
                    *half_edges = half_edges.map(scaled);
                    *color = color.map(|x| x * scale * scale);
                    *range *= scale;
                }
            }
        }
        check(
            gpu,
            &format!("scaled by {scale:e}"),
            &scene,
            &settings(View::Color),
        );
    }
}

#[test]
fn real_scenes_are_those_of_the_cpu() {
    let Some(gpu) = gpu() else { return };
    for (name, mesh) in real_meshes(&["dragon.ply", "armadillo.off", "sponza.obj"]) {
        let scene = completed(mesh);
        for view in [View::Color, View::Heatmap] {
            check(gpu, &name, &scene, &settings(view));
        }
    }
}

#[test]
fn a_picture_of_something_else_is_found() {
    let Some(gpu) = gpu() else { return };
    let scene = hall_of_mirrors();
    let mut other = scene.clone();
    other.materials[3].base_color[0] -= 0.05;
    let settings = settings(View::Color);
    let (picture, _) = of_gpu(gpu, &other, &settings);
    done(alike(&picture, &of_cpu(&other, &settings).0, SHARE, MOST));
    assert!(alike(&picture, &of_cpu(&scene, &settings).0, SHARE, MOST).is_err());
}
