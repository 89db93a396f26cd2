//! Sets with memory for less than all triangles: whether they fit or not, the answers are those of sets with memory for all.

use super::filtered::configs;
use super::own_shaders::{ANYWHERE, IN_GROUP, ask};
use crate::views::{LAMP, config, meshes, twisted};
use proptest::prelude::*;
use slimbvh::gpu::{self, Frame, Gpu, Query, wgpu};
use slimbvh::reduce::{Reduce, SetMemory, TreeChoice};
use slimbvh::{
    BuildConfig, Camera, Change, FrameConfig, Frames, Hit, Material, Mesh, Output, Picture,
    Projection, Ray, RenderSettings, Scene, View, ViewSets, ViewTarget,
};
use slimbvh_tests::gpu::{contents, done, gpu, is_software, storage};
use slimbvh_tests::parity::{close_hits, same_bits};

const SIZE: [u32; 2] = [40, 30];

/// Degrees: of all triangles, few and many are in the picture.
const NARROW: f32 = 1.0;
const WIDE: f32 = 40.0;

fn camera(degrees: f32) -> Camera {
    Camera {
        eye: [0.5, 0.7, 3.5],
        target: [0.0; 3],
        up: [0.0, 1.0, 0.0],
        projection: Projection::Perspective {
            vertical_fov: degrees,
        },
    }
}

/// The camera, a lamp, and all other rays.
const ALL: &[usize] = &[0, 1, 2];

/// Some of the camera, a lamp, and all other rays.
fn some_targets(degrees: f32, which: &[usize]) -> Vec<ViewTarget> {
    let target = |&place: &usize| match place {
        0 => done(ViewTarget::camera(&camera(degrees), SIZE)),
        1 => done(ViewTarget::rays_to(LAMP, 0.0)),
        _ => ViewTarget::other_rays(),
    };
    which.iter().map(target).collect()
}

fn targets(degrees: f32) -> Vec<ViewTarget> {
    some_targets(degrees, ALL)
}

fn with_memory(build: BuildConfig, set_memory: SetMemory) -> FrameConfig {
    FrameConfig {
        build,
        set_memory,
        ..config(Reduce::On)
    }
}

/// View sets whose memory follows their counts, and others with memory for all triangles.
fn both(gpu: &Gpu, build: BuildConfig) -> [ViewSets<&Gpu>; 2] {
    let memories = [SetMemory::Recent, SetMemory::All];
    memories.map(|memory| ViewSets::new(gpu, with_memory(build, memory)))
}

/// Rays of each target, and room for the answers to all queries.
struct Asked {
    rays: [Vec<Ray>; 3],
    buffers: [wgpu::Buffer; 3],
    answers: Vec<wgpu::Buffer>,
}

const QUERIES: [Query; 3] = [Query::Closest, Query::Any, Query::Nearest];

impl Asked {
    fn new(gpu: &Gpu, degrees: f32) -> Self {
        let pixels = (0..SIZE[1]).flat_map(|y| (0..SIZE[0]).map(move |x| [x, y]));
        let eye = camera(degrees);
        let from: Vec<Ray> = pixels.map(|pixel| done(eye.ray(pixel, SIZE))).collect();
        // From a plane below everything to the lamp, and through everything.
        let ground = |i: u32| [i % 30, i / 30].map(|x| 0.2 * (x as f32 - 15.0));
        let to = (0..900).map(|i| {
            let [x, z] = ground(i);
            let from = [x, -2.0, z];
            Ray {
                t_max: 1.0,
                ..Ray::new(from, [0, 1, 2].map(|i| LAMP[i] - from[i]))
            }
        });
        let others = (0..900).map(|i| {
            let [x, z] = ground(i);
            Ray::new([x, -2.0, z], [-0.3 * x, 1.0, -0.3 * z])
        });
        let rays = [from, to.collect(), others.collect()];
        Self {
            buffers: rays.each_ref().map(|rays| storage(gpu, rays)),
            answers: Vec::new(),
            rays,
        }
    }

    /// Records all queries of all trees.
    fn record<'g>(&mut self, frame: &mut Frame<'g>, views: &ViewSets<&'g Gpu>) {
        self.record_some(frame, views, ALL);
    }

    fn record_some<'g>(
        &mut self,
        frame: &mut Frame<'g>,
        views: &ViewSets<&'g Gpu>,
        which: &[usize],
    ) {
        let buffers = which.iter().map(|&place| &self.buffers[place]);
        for (tree, rays) in views.trees().into_iter().zip(buffers) {
            for query in QUERIES {
                let bytes = rays.size() / 32 * query.answer_bytes();
                let answers = storage(frame.gpu(), &vec![0x77u8; bytes as usize]);
                done(tree.trace(frame, query, rays.slice(..), answers.slice(..)));
                self.answers.push(answers);
            }
        }
    }

    fn read(&self, gpu: &Gpu) -> Vec<Vec<u32>> {
        let read = |answers: &wgpu::Buffer| contents(gpu, answers);
        self.answers.iter().map(read).collect()
    }
}

/// Updates, and answers all queries, in one submission.
fn answers<'g>(
    views: &mut ViewSets<&'g Gpu>,
    gpu: &'g Gpu,
    mesh: &Mesh,
    degrees: f32,
    change: Change,
) -> Vec<Vec<u32>> {
    some_answers(views, gpu, mesh, (degrees, ALL), change)
}

fn some_answers<'g>(
    views: &mut ViewSets<&'g Gpu>,
    gpu: &'g Gpu,
    mesh: &Mesh,
    (degrees, which): (f32, &[usize]),
    change: Change,
) -> Vec<Vec<u32>> {
    let mut asked = Asked::new(gpu, degrees);
    let mut frame = gpu.frame();
    done(views.update(&mut frame, mesh, &some_targets(degrees, which), change));
    asked.record_some(&mut frame, views, which);
    done(done(frame.submit()).wait());
    asked.read(gpu)
}

/// Whether the camera's set fitted.
fn fits(views: &ViewSets<&Gpu>) -> bool {
    let sizes = done(views.sizes());
    assert_eq!(sizes.sets[0].name, "camera");
    sizes.sets[0].fits
}

/// The camera widens: its set does not fit, then its memory grows. The answers of all queries, and of the caller's own WGSL, stay.
#[test]
fn a_set_that_does_not_fit_has_the_answers_of_the_whole_tree() {
    let Some(gpu) = gpu() else { return };
    let mut mesh = meshes().swap_remove(1);
    mesh.snap(-12);
    for build in configs() {
        let [mut recent, mut all] = both(gpu, build);
        let steps = [(NARROW, true), (WIDE, false), (WIDE, true), (NARROW, true)];
        for (step, (degrees, expected)) in steps.into_iter().enumerate() {
            let context = format!("{build:?}, step {step}");
            let [found, wanted] = [&mut recent, &mut all]
                .map(|views| answers(views, gpu, &mesh, degrees, Change::View));
            assert!(found == wanted, "{context}");
            assert_eq!(fits(&recent), expected, "{context}");
            assert!(fits(&all), "{context}");
            let plan = recent.plan().expect("it was updated");
            assert_eq!(plan.sets[0].choice, TreeChoice::Set, "{context}");

            let tree = recent.trees()[0];
            let text = done(gpu::wgsl_compute_for(done(tree.bvh.codecs()), 1));
            let rays = Asked::new(gpu, degrees).rays[0].clone();
            let hits: Vec<Hit> = bytemuck::pod_collect_to_vec(&wanted[0]);
            for calls in [ANYWHERE, IN_GROUP] {
                let replies = ask(gpu, tree, &rays, (&text, calls), 64);
                done(close_hits(&replies.closest, &hits));
                if is_software(gpu) {
                    done(same_bits(&replies.closest, &hits));
                    done(same_bits(&replies.any, &wanted[1]));
                }
            }
            // What was built is told.
            match tree.bvh.download(gpu) {
                Ok(bvh) => assert!(expected && bvh.triangle_count() > 0, "{context}"),
                Err(error) => {
                    let message = error.to_string();
                    assert!(
                        !expected && message.contains("memory for 1024"),
                        "{message}"
                    );
                }
            }
        }
        let known = recent.fits();
        assert!(known.iter().all(gpu::SetFit::fits), "{known:?}");
        assert_eq!(known.len(), 2);
        assert!(known[0].limit > 1024 && (known[0].limit as usize) < mesh.indices.len());
        let [less, more] = [&recent, &all].map(ViewSets::held_bytes);
        assert!(less < more, "{build:?}: {less} {more}");
        assert_eq!(all.fits(), []);
    }
}

/// The count of a frame is known in the next one that is recorded after it is done; the caller is told of it.
#[test]
fn a_misfit_is_told_once_the_frame_is_done() {
    let Some(gpu) = gpu() else { return };
    let mesh = &meshes()[1];
    let [mut views, _] = both(gpu, BuildConfig::default());
    answers(&mut views, gpu, mesh, NARROW, Change::Scene);
    assert_eq!(views.fits(), []);
    answers(&mut views, gpu, mesh, WIDE, Change::View);
    assert!(views.fits()[0].fits());
    // Recorded, and never submitted: nothing arrives, and the next frame builds all.
    let mut frame = gpu.frame();
    done(views.update(&mut frame, mesh, &targets(WIDE), Change::View));
    drop(frame);
    views.forget();
    let told = views.fits();
    assert!(!told[0].fits(), "{told:?}");
    assert_eq!(told[0].name, "camera");
    answers(&mut views, gpu, mesh, WIDE, Change::View);
    assert!(fits(&views));
}

/// Frames in flight: all are recorded before the first is submitted, or into one submission.
#[test]
fn frames_may_be_recorded_before_others_are_done() {
    let Some(gpu) = gpu() else { return };
    let mesh = &meshes()[1];
    for is_one in [false, true] {
        let [mut recent, mut all] = both(gpu, BuildConfig::default());
        let degrees = [NARROW, WIDE, NARROW, WIDE];
        let mut asked = degrees.map(|degrees| Asked::new(gpu, degrees));
        let mut frames = vec![gpu.frame()];
        for (degrees, asked) in degrees.into_iter().zip(&mut asked) {
            if !is_one {
                frames.push(gpu.frame());
            }
            let frame = frames.last_mut().expect("one at least");
            done(recent.update(frame, mesh, &targets(degrees), Change::View));
            asked.record(frame, &recent);
        }
        for frame in frames {
            done(frame.submit());
        }
        for (degrees, asked) in degrees.into_iter().zip(&asked) {
            let expected = answers(&mut all, gpu, mesh, degrees, Change::View);
            assert!(asked.read(gpu) == expected, "{is_one} {degrees}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    /// Whatever the camera, the vertices, the mesh and the targets do from frame to frame.
    #[test]
    fn answers_do_not_depend_on_memory(
        steps in proptest::collection::vec((1.0f32..60.0, 0u8..4, 0usize..4), 2..9),
        codec in 0usize..5,
    ) {
        let Some(gpu) = gpu() else { return Ok(()) };
        let lists = [ALL, &[0, 1], &[0, 2], &[1, 2]];
        let mut rest = meshes();
        for mesh in &mut rest {
            mesh.snap(-12);
        }
        let [mut recent, mut all] = both(gpu, configs()[codec]);
        let mut mesh = rest[1].clone();
        for (step, (degrees, change, which)) in steps.into_iter().enumerate() {
            let change = match change {
                0 | 1 => Change::View,
                2 => Change::Vertices,
                _ => Change::Scene,
            };
            match change {
                Change::View => {}
                Change::Vertices => mesh = twisted(&mesh, 0.1 * step as f32),
                Change::Scene => mesh.clone_from(&rest[step % 3]),
            }
            mesh.snap(-12);
            let asked = (degrees, lists[which]);
            let [found, wanted] = [&mut recent, &mut all]
                .map(|views| some_answers(views, gpu, &mesh, asked, change));
            prop_assert_eq!(found, wanted, "step {}", step);
        }
    }
}

/// Pictures with shadows and mirrors, and views of the hits.
#[test]
fn pictures_do_not_depend_on_memory() {
    let Some(gpu) = gpu() else { return };
    let mesh = meshes().swap_remove(1);
    let mut scene = Scene {
        mesh,
        ..Scene::default()
    };
    scene.complete(scene.mesh.bounds(), SIZE);
    let material = Material {
        mirror: 0.3,
        ..Material::default()
    };
    scene.materials = vec![material];
    // Without rays from mirrors there is no whole tree, and every set has memory for all.
    for (view, misfits) in [
        (View::Color, true),
        (View::Normals, false),
        (View::Depth, false),
    ] {
        let settings = RenderSettings {
            size: SIZE,
            sample_count: 1,
            view,
            ..RenderSettings::default()
        };
        let mut frames = [SetMemory::Recent, SetMemory::All]
            .map(|memory| Frames::new(gpu, with_memory(BuildConfig::default(), memory)));
        for (degrees, expected) in [(NARROW, true), (WIDE, false), (WIDE, true)] {
            scene.cameras = vec![camera(degrees)];
            let mut pictures = [Picture::default(), Picture::default()];
            for (frames, picture) in frames.iter_mut().zip(&mut pictures) {
                done(frames.render(&scene, &settings, Change::View, Output::new(picture)));
            }
            assert!(pictures[0] == pictures[1], "{view:?} {degrees}");
            let fitted = fits(frames[0].views());
            assert_eq!(fitted, expected || !misfits, "{view:?} {degrees}");
            assert!(pictures[0].pixels.iter().any(|pixel| pixel[0] > 0.0));
        }
    }
}

/// A mesh whose number of triangles changes in each frame: counts become shares, and what did not fit fits later.
#[test]
fn memory_follows_meshes_of_other_sizes() {
    let Some(gpu) = gpu() else { return };
    let [mut views, mut all] = both(gpu, BuildConfig::default());
    let mesh = |round: usize| {
        let mut mesh = meshes().swap_remove(1);
        // Of the ground, which is not closed anyway.
        mesh.indices.truncate(5192 - 8 * (round % 5));
        mesh.parts.clear();
        mesh.materials.clear();
        mesh
    };
    answers(&mut views, gpu, &mesh(0), NARROW, Change::Scene);
    let fitted: Vec<bool> = (1..6)
        .map(|round| {
            let [found, wanted] = [&mut views, &mut all]
                .map(|views| answers(views, gpu, &mesh(round), WIDE, Change::Scene));
            assert!(found == wanted, "{round}");
            fits(&views)
        })
        .collect();
    assert_eq!(fitted[1..], [true; 4]);
}

/// One camera's set now, then the other's: what a set has stays while it is not needed, so nothing is built anew.
#[test]
fn a_set_that_is_not_needed_keeps_its_memory() {
    let Some(gpu) = gpu() else { return };
    let mesh = &meshes()[1];
    let [mut views, _] = both(gpu, BuildConfig::default());
    let mut held = Vec::new();
    for which in [ALL, &[0, 2], ALL, &[0, 2]] {
        some_answers(&mut views, gpu, mesh, (WIDE, which), Change::View);
        held.push(views.held_bytes());
    }
    assert_eq!(held[1..], [held[0]; 3]);
}

/// A bind group of an earlier frame still finds the tree of that frame: nothing that it binds is written again once trees have moved.
#[test]
fn old_bindings_find_the_old_tree() {
    let Some(gpu) = gpu() else { return };
    let mesh = &meshes()[1];
    let [mut views, _] = both(gpu, BuildConfig::default());
    answers(&mut views, gpu, mesh, NARROW, Change::Scene);
    let bound = |views: &ViewSets<&Gpu>| -> Vec<wgpu::Buffer> {
        let entries = done(views.trees()[0].bindings());
        let buffers = entries.into_iter().map(|entry| match entry.resource {
            wgpu::BindingResource::Buffer(binding) => binding.buffer.clone(),
            other => panic!("{other:?}"),
        });
        buffers.collect()
    };
    let before = bound(&views);
    answers(&mut views, gpu, mesh, WIDE, Change::View);
    assert_eq!(bound(&views), before);
    // It did not fit, and moves.
    answers(&mut views, gpu, mesh, WIDE, Change::View);
    let after = bound(&views);
    for (place, what) in ["exponent", "nodes", "triangles"].into_iter().enumerate() {
        assert_ne!(after[place], before[place], "{what}");
    }
}
