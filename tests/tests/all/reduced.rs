//! Reduced trees leave out exactly what the rule rejects, so both give the same picture, on both backends.

use glam::{Quat, Vec3};
use slimbvh::gpu;
use slimbvh::{
    BuildConfig, Builder, Bvh, Camera, CodeBits, Light, Mesh, Picture, Projection, Ray,
    RenderSettings, Renderer, Scene, Subset, Tree, Trees, generate,
};
use slimbvh_core::classify::{Sides, VisibleSet, faces};
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::frustum::Frustum;
use slimbvh_core::orientation::Target;
use slimbvh_core::snap::leaf_triangle;
use slimbvh_tests::closed::{dented_sphere, small_torus_knot};
use slimbvh_tests::gpu::{done, gpu};
use slimbvh_tests::{CODE_BITS, build};
use std::collections::BTreeSet;

/// A closed mesh beside an open one: component 0 is reducible, component 1 is not.
struct Model {
    mesh: Mesh,
    components: Vec<u32>,
}

const EYE: [f32; 3] = [0.5, 0.7, 3.5];
const SUN: [f32; 3] = [-0.3, -1.0, -0.4];
const LAMP: [f32; 3] = [2.5, 2.0, 1.5];

fn models() -> Vec<Model> {
    let closed = [
        generate::icosphere(Vec3::ZERO, 1.0, 4),
        dented_sphere(4, 0.3, 7),
        small_torus_knot(),
    ];
    let models = closed.into_iter().map(|mut mesh| {
        let closed_count = mesh.indices.len();
        generate::append(
            &mut mesh,
            generate::transformed(generate::ground(4.0, 6), 1.0, Quat::IDENTITY, Vec3::NEG_Y),
            "ground",
            0,
        );
        let mut components = vec![0; closed_count];
        components.resize(mesh.indices.len(), 1);
        Model { mesh, components }
    });
    models.collect()
}

fn scene(model: &Model) -> Scene {
    Scene {
        mesh: model.mesh.clone(),
        cameras: vec![Camera {
            eye: EYE,
            target: [0.0; 3],
            up: [0.0, 1.0, 0.0],
            projection: Projection::Perspective { vertical_fov: 45.0 },
        }],
        lights: vec![
            Light::Directional {
                direction: SUN,
                color: [2.0; 3],
            },
            Light::Point {
                position: LAMP,
                color: [9.0; 3],
                range: f32::INFINITY,
            },
        ],
        ..Scene::default()
    }
}

const SETTINGS: RenderSettings = RenderSettings {
    size: [96, 72],
    sample_count: 2,
    view: slimbvh::View::Color,
    mirror_depth: 0,
    dark_rays: false,
};

/// The eye, the sun and the lamp.
fn targets() -> [Target; 3] {
    [
        Target::position(EYE),
        Target::direction(SUN.map(|x| -x)),
        Target::position(LAMP),
    ]
}

fn subset(model: &Model, target: Target) -> Subset<'_> {
    Subset::Of(VisibleSet {
        sides: Sides {
            components: &model.components,
            sides: &[1, 0, 0],
        },
        target,
        frustum: Frustum::EVERYWHERE,
    })
}

/// The set of each target, as a tree.
fn sets(model: &Model, code_bits: CodeBits) -> [Bvh; 3] {
    let mut builder = Builder::new(BuildConfig::from(code_bits));
    done(builder.sort(&model.mesh));
    targets().map(|target| {
        let mut bvh = Bvh::default();
        builder.build_sorted(&model.mesh, subset(model, target), &mut bvh);
        bvh
    })
}

fn picture(scene: &Scene, trees: &Trees) -> Picture {
    let mut picture = Picture::default();
    let render = Renderer::new().render_with(scene, trees, &SETTINGS, &mut picture, |_| {});
    done(render);
    picture
}

/// The trees of the camera's, the sun's and the lamp's rays.
fn trees<'a>(primary: Tree<'a>, sun: Tree<'a>, lamp: Tree<'a>) -> Trees<'a> {
    Trees {
        primary,
        lights: vec![sun, lamp],
        mirrors: None,
    }
}

#[test]
fn a_set_holds_what_faces_its_target_in_order() {
    for model in models() {
        for code_bits in CODE_BITS {
            let whole = build(&model.mesh, code_bits);
            let scale = PowerOfTwo::new(whole.scene_exponent());
            for (target, set) in targets().iter().zip(sets(&model, code_bits)) {
                let target = target.scaled(&scale);
                let expected = whole.leaf_triangles().iter().filter(|leaf| {
                    let side = 1 - model.components[leaf.primitive as usize] as i32;
                    let mesh = model.mesh.triangles();
                    let triangle = leaf_triangle(leaf.primitive, &mesh, &scale).triangle();
                    faces(&triangle, side, &target)
                });
                assert!(set.leaf_triangles().iter().eq(expected));
                assert_eq!(set.scene_exponent(), whole.scene_exponent());
                assert_eq!(set.mesh_triangle_count(), model.mesh.indices.len());
                let share = set.triangle_count() as f64 / whole.triangle_count() as f64;
                assert!((0.3..0.7).contains(&share), "{share}");
                let shape = slimbvh_tests::validate::validate_shape(
                    set.nodes(),
                    set.leaf_triangles(),
                    set.depth_bound(),
                );
                assert!(shape.is_ok(), "{shape:?}");
            }
        }
    }
}

/// A set that is sorted alone equals the set that is selected from the order of all triangles.
#[test]
fn a_set_is_the_same_sorted_alone() {
    for model in models() {
        for code_bits in CODE_BITS {
            for (target, expected) in targets().iter().zip(sets(&model, code_bits)) {
                let mut builder = Builder::new(BuildConfig::from(code_bits));
                let mut bvh = Bvh::default();
                done(builder.build_subset(&model.mesh, subset(&model, *target), &mut bvh));
                assert!(bvh.nodes() == expected.nodes());
                assert!(bvh.leaf_triangles() == expected.leaf_triangles());
                assert_eq!(bvh.scene_exponent(), expected.scene_exponent());
                assert_eq!(bvh.depth_bound(), expected.depth_bound());
            }
        }
    }
}

/// After the vertices of a sorted mesh moved, its sets hold the same triangles in the old order.
#[test]
fn an_order_may_be_kept_for_a_mesh_that_moved() {
    for mut model in models() {
        let mut builder = Builder::new(BuildConfig::default());
        done(builder.sort(&model.mesh));
        for vertex in &mut model.mesh.vertices {
            vertex[0] = vertex[0] * 1.5 + 0.1 * vertex[1];
        }
        done(builder.follow(&model.mesh));
        for (target, fresh) in targets().iter().zip(sets(&model, CodeBits::Bits30)) {
            let mut kept = Bvh::default();
            builder.build_sorted(&model.mesh, subset(&model, *target), &mut kept);
            let primitives = |bvh: &Bvh| {
                let triangles = bvh.leaf_triangles().iter();
                triangles
                    .map(|leaf| leaf.primitive)
                    .collect::<BTreeSet<_>>()
            };
            assert!(primitives(&kept) == primitives(&fresh));
            assert_eq!(kept.scene_exponent(), fresh.scene_exponent());
            for i in 0..200 {
                let turn = i as f32 * 0.7;
                let to = [turn.sin(), (turn * 0.37).cos(), (turn * 1.3).cos()];
                let ray = Ray::new(EYE, [to[0] - EYE[0], to[1] - EYE[1], to[2] - EYE[2]]);
                assert_eq!(kept.closest_hit(ray), fresh.closest_hit(ray));
            }
        }
        let other = generate::icosphere(Vec3::ZERO, 1.0, 1);
        assert!(builder.follow(&other).is_err());
    }
}

/// On closed meshes seen from outside the rule changes no picture. The negative control: on a mesh turned inside out it does.
#[test]
fn reduced_and_whole_trees_give_the_same_picture() {
    for model in models() {
        let scene = scene(&model);
        let whole = build(&model.mesh, CodeBits::Bits30);
        let [eye, sun, lamp] = sets(&model, CodeBits::Bits30);
        let reduced = picture(
            &scene,
            &trees(Tree::all(&eye), Tree::all(&sun), Tree::all(&lamp)),
        );
        let rule = |sides: &'static [i32], target: Target| Tree {
            bvh: &whole,
            rule: Some((
                Sides {
                    components: &model.components,
                    sides,
                },
                target,
            )),
        };
        let with = |sides: &'static [i32]| {
            let [eye, sun, lamp] = targets().map(|target| rule(sides, target));
            picture(&scene, &trees(eye, sun, lamp))
        };
        assert!(reduced == with(&[1, 0]));
        assert!(reduced == picture(&scene, &Trees::all(&whole, 2)));
        assert!(reduced != with(&[-1, 0]));
    }
}

#[test]
fn sets_are_the_same_on_both_backends() {
    let Some(gpu) = gpu() else { return };
    for model in models() {
        for code_bits in CODE_BITS {
            let mesh = done(gpu::Mesh::upload(gpu, &model.mesh));
            let components = done(gpu::Components::upload(gpu, &model.components));
            let mut builder = gpu::Builder::new(BuildConfig::from(code_bits));
            // One frame builds all sets in the same buffers.
            let mut bvhs = [(); 3].map(|()| gpu::Bvh::new());
            let mut facing = gpu::TargetSides::new();
            let mut frame = gpu.frame();
            done(builder.sort(&mut frame, &mesh));
            for (target, bvh) in targets().iter().zip(&mut bvhs) {
                done(facing.set(
                    &mut frame,
                    &components,
                    (target, &Frustum::EVERYWHERE),
                    &[1, 0],
                ));
                let subset = gpu::Subset::Of {
                    components: &components,
                    sides: &facing,
                };
                done(builder.build_sorted(&mut frame, &mesh, subset, bvh));
            }
            done(frame.submit());
            for (expected, bvh) in sets(&model, code_bits).iter().zip(&bvhs) {
                let found = done(bvh.download(gpu));
                assert!(found.nodes() == expected.nodes());
                assert!(found.leaf_triangles() == expected.leaf_triangles());
                assert_eq!(found.bounds(), expected.bounds());
                assert_eq!(found.scene_exponent(), expected.scene_exponent());
                assert!(
                    builder
                        .refit(&mut gpu.frame(), &mesh, &mut gpu::Bvh::new())
                        .is_err()
                );
            }
            let mut frame = gpu.frame();
            assert!(builder.refit(&mut frame, &mesh, &mut bvhs[0]).is_err());
        }
    }
}

#[test]
fn reduced_and_whole_trees_give_the_same_picture_on_the_gpu() {
    let Some(gpu) = gpu() else { return };
    for model in models() {
        let scene = scene(&model);
        let uploaded = done(gpu::Scene::upload(gpu, &scene));
        let components = done(gpu::Components::upload(gpu, &model.components));
        let mut builder = gpu::Builder::new(BuildConfig::default());
        let mut renderer = gpu::Renderer::new();
        let mut frame = gpu.frame();
        let mut facings = [(); 3].map(|()| gpu::TargetSides::new());
        let mut sets = [(); 3].map(|()| gpu::Bvh::new());
        let mut whole = gpu::Bvh::new();
        done(builder.build(&mut frame, &uploaded.mesh, &mut whole));
        for ((target, facing), set) in targets().iter().zip(&mut facings).zip(&mut sets) {
            done(facing.set(
                &mut frame,
                &components,
                (target, &Frustum::EVERYWHERE),
                &[1, 0],
            ));
            let subset = gpu::Subset::Of {
                components: &components,
                sides: facing,
            };
            done(builder.build_sorted(&mut frame, &uploaded.mesh, subset, set));
        }
        let [with_rule, reduced] = [true, false].map(|is_whole| {
            let tree = |i: usize| gpu::Tree {
                bvh: if is_whole { &whole } else { &sets[i] },
                rule: is_whole.then_some((&components, &facings[i])),
            };
            gpu::Trees {
                primary: tree(0),
                lights: vec![tree(1), tree(2)],
                mirrors: None,
            }
        });
        let view = (&scene.cameras[0], scene.lights.as_slice());
        let mut pictures = Vec::new();
        for trees in [&with_rule, &reduced, &gpu::Trees::all(&whole, 2)] {
            done(renderer.render_with(&mut frame, &uploaded, trees, view, &SETTINGS));
            pictures.push(done(renderer.read_later(&mut frame)));
        }
        done(frame.submit());
        let pictures = pictures.into_iter().map(|download| {
            let mut picture = Picture::default();
            done(download.read(gpu, &mut picture));
            picture
        });
        let pictures: Vec<Picture> = pictures.collect();
        assert!(pictures[0] == pictures[1]);
        assert!(pictures[0] == pictures[2]);
    }
}
