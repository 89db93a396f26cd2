//! The time of compiling is told in the stages; after a warm-up no frame compiles.

use crate::reduced_scenes::scenes::scenes;
use crate::views::{config, targets};
use slimbvh::generate::icosphere;
use slimbvh::gpu::{self, Answer, Frame, Gpu, IndexLayout, Query, VertexLayout, WarmUp, wgpu};
use slimbvh::reduce::Reduce;
use slimbvh::topology::Topology;
use slimbvh::{
    BuildConfig, Change, Mesh, RayEnds, RenderSettings, Stages, View, ViewSets, WideStore,
};
use slimbvh::{MeshCodec, NodeCodec};
use slimbvh_core::frustum::Frustum;
use slimbvh_core::orientation::Target;
use slimbvh_tests::gpu::{done, own_gpu, storage};

fn compiles(stages: &Stages) -> bool {
    stages.iter().any(|(stage, _)| stage == "compile")
}

/// Builds, refits and asks for closest hits, in one frame.
fn frame(gpu: &Gpu, mesh: &gpu::Mesh, config: BuildConfig, query: Query) -> Stages {
    let mut frame = gpu.frame();
    let (mut builder, mut bvh) = (gpu::Builder::new(config), gpu::Bvh::new());
    done(builder.build(&mut frame, mesh, &mut bvh));
    done(builder.refit(&mut frame, mesh, &mut bvh));
    trace(&mut frame, &bvh, query);
    done(done(frame.submit()).wait())
}

fn trace(frame: &mut Frame, bvh: &gpu::Bvh, query: Query) {
    let gpu = frame.gpu();
    let (rays, answers) = (storage(gpu, &[1.0f32; 80]), storage(gpu, &[0u32; 400]));
    done(bvh.trace(frame, query, rays.slice(..), answers.slice(..)));
}

/// A sphere in the caller's own layout.
fn sphere(gpu: &Gpu, level: u32) -> (Mesh, gpu::Mesh) {
    let mesh = icosphere(glam::Vec3::ZERO, 1.0, level);
    let vertices: Vec<[f32; 4]> = mesh
        .vertices
        .iter()
        .map(|&[x, y, z]| [x, y, z, 9.0])
        .collect();
    let vertices = storage(gpu, &vertices);
    let indices = storage(gpu, &mesh.indices);
    let layout = VertexLayout {
        slice: vertices.slice(..),
        stride: 16,
        offset: 0,
    };
    let indices = IndexLayout {
        slice: indices.slice(..),
        format: wgpu::IndexFormat::Uint32,
    };
    let placed = done(gpu::Mesh::from_layout(gpu, layout, indices));
    (mesh, placed)
}

#[test]
fn the_first_frame_tells_the_time_of_compiling_and_the_second_has_none() {
    let Some(gpu) = own_gpu() else { return };
    let (_, mesh) = sphere(&gpu, 3);
    let [first, second] =
        [1, 2].map(|_| frame(&gpu, &mesh, BuildConfig::default(), Query::Closest));
    assert!(compiles(&first) && !compiles(&second));
    println!("first frame:  {first}\nsecond frame: {second}");
}

#[test]
fn after_a_warm_up_no_frame_compiles() {
    let wide = |store, mesh| BuildConfig {
        nodes: NodeCodec::Wide(store),
        mesh,
        ..BuildConfig::default()
    };
    let lattice = MeshCodec::Lattice { step_exponent: -10 };
    for config in [
        BuildConfig::default(),
        wide(WideStore::Full, MeshCodec::F32),
        wide(WideStore::Packed, lattice),
    ] {
        let Some(gpu) = own_gpu() else { return };
        let queries = [Query::Closest, Query::Any];
        let uses = WarmUp::new(config)
            .with_layouts()
            .with_refits()
            .with_queries(&queries);
        assert!(compiles(&done(gpu.warm_up(&uses))));
        assert!(!compiles(&done(gpu.warm_up(&uses))));
        // One triangle, a few, and more than of the warm-up.
        for level in [0, 2, 5] {
            let (_, mesh) = sphere(&gpu, level);
            for query in queries {
                let stages = frame(&gpu, &mesh, config, query);
                assert!(!compiles(&stages), "{config:?} {level}: {stages}");
            }
        }
        // The negative control: what was not named is compiled in the frame.
        let (_, mesh) = sphere(&gpu, 2);
        let mut frame = gpu.frame();
        let (mut builder, mut bvh) = (gpu::Builder::new(config), gpu::Bvh::new());
        done(builder.sort(&mut frame, &mesh));
        let topology = Topology::new(&sphere(&gpu, 2).0);
        let mut decisions = done(gpu::Decisions::new(&gpu, &topology));
        done(decisions.measure(&mut frame, &builder, &mesh));
        done(builder.build(&mut frame, &mesh, &mut bvh));
        assert!(compiles(&done(done(frame.submit()).wait())));
    }
}

#[test]
fn a_warm_up_for_sets_and_pictures_covers_them() {
    let Some(gpu) = own_gpu() else { return };
    let config = BuildConfig::default();
    for view in [View::Color, View::Depth] {
        let settings = RenderSettings {
            size: [40, 30],
            view,
            ..RenderSettings::default()
        };
        let uses = WarmUp::new(config).with_decisions().with_picture(settings);
        assert!(compiles(&done(gpu.warm_up(&uses))), "{view:?}");
        let (_, scene) = scenes().swap_remove(0);
        let mut frame = gpu.frame();
        let placed = done(gpu::Scene::upload(&gpu, &scene));
        let topology = Topology::new(&scene.mesh);
        let mut builder = gpu::Builder::new(config);
        let (mut bvh, mut set) = (gpu::Bvh::new(), gpu::Bvh::new());
        done(builder.build(&mut frame, &placed.mesh, &mut bvh));
        let mut decisions = done(gpu::Decisions::new(&gpu, &topology));
        done(decisions.measure(&mut frame, &builder, &placed.mesh));
        let (mut eye, mut sides) = (gpu::TargetSides::new(), gpu::TargetSides::new());
        let target = (&Target::position([9.0; 3]), &Frustum::EVERYWHERE);
        done(eye.decide(&mut frame, &decisions, target, Answer::Facing));
        let answer = Answer::Smaller { eye: &eye };
        done(sides.decide(&mut frame, &decisions, target, answer));
        let components = decisions.components();
        let subset = gpu::Subset::Of {
            components,
            sides: &sides,
        };
        done(builder.build_sorted(&mut frame, &placed.mesh, subset, &mut set));
        let tree = gpu::Tree {
            bvh: &bvh,
            rule: Some((components, &eye)),
        };
        let trees = gpu::Trees {
            primary: tree,
            lights: scene.lights.iter().map(|_| gpu::Tree::all(&set)).collect(),
            mirrors: Some(&bvh),
        };
        let view = (&scene.cameras[0], scene.lights.as_slice());
        let mut renderer = gpu::Renderer::new();
        done(renderer.render_with(&mut frame, &placed, &trees, view, &settings));
        let stages = done(done(frame.submit()).wait());
        assert!(!compiles(&stages), "{stages}");
    }
}

/// View sets, rays with ends and counts that only the GPU knows compile nothing either.
#[test]
fn after_a_warm_up_view_sets_compile_nothing() {
    let Some(gpu) = own_gpu() else { return };
    let config = config(Reduce::On);
    let queries = [Query::Closest, Query::Any];
    let uses = config.warm_up().with_queries(&queries);
    assert!(compiles(&done(
        gpu.warm_up(&uses.with_ends().with_counts())
    )));
    let (host, mesh) = sphere(&gpu, 3);
    let mut views = ViewSets::new(&gpu, config);
    let (rays, ends) = (
        storage(&gpu, &[1.0f32; 80]),
        storage(&gpu, &[RayEnds::NONE; 10]),
    );
    let (answers, count) = (storage(&gpu, &[0u32; 40]), storage(&gpu, &[5u32]));
    for change in [Change::Scene, Change::Vertices, Change::View] {
        let mut frame = gpu.frame();
        done(views.update(&mut frame, (&mesh, &host), &targets(), change));
        for tree in views.trees() {
            for query in queries {
                let rays = gpu::Rays::new(rays.slice(..));
                for rays in [
                    rays,
                    rays.with_ends(ends.slice(..)),
                    rays.counted_by(count.slice(..)),
                ] {
                    done(tree.trace(&mut frame, query, rays, answers.slice(..)));
                }
            }
        }
        let stages = done(done(frame.submit()).wait());
        assert!(!compiles(&stages), "{change:?}: {stages}");
    }
}
