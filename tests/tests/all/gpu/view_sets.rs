//! View sets on the GPU: the answers of the CPU's, over meshes on the host and over the caller's buffers.

use crate::views::rays::{Answers, Rays, answers, rays_of};
use crate::views::{config, meshes, targets, twisted};
use slimbvh::gpu::{self, Frame, Gpu, IndexLayout, Query, VertexLayout, wgpu};
use slimbvh::reduce::{Plan, Reduce, TreeChoice};
use slimbvh::{Change, Cpu, Hit, Mesh, Ray, RayEnds, SurfaceRay, ViewSets};
use slimbvh_tests::gpu::{contents, done, gpu, storage};

/// Buffers of rays and answers for `views::targets`.
struct Asked {
    from: [[wgpu::Buffer; 2]; 2],
    to: [[wgpu::Buffer; 3]; 2],
    others: [wgpu::Buffer; 2],
}

fn closest(gpu: &Gpu, rays: &[Ray]) -> [wgpu::Buffer; 2] {
    [
        storage(gpu, rays),
        storage(gpu, &vec![Hit::MISS; rays.len()]),
    ]
}

fn any(gpu: &Gpu, rays: &[SurfaceRay]) -> [wgpu::Buffer; 3] {
    let parts: (Vec<Ray>, Vec<RayEnds>) = rays.iter().map(|of| (of.ray, of.ends)).unzip();
    [
        storage(gpu, &parts.0),
        storage(gpu, &parts.1),
        storage(gpu, &vec![7u32; rays.len()]),
    ]
}

impl Asked {
    fn new(gpu: &Gpu, rays: &Rays) -> Self {
        Self {
            from: [closest(gpu, &rays.from[0]), closest(gpu, &rays.from[1])],
            to: [any(gpu, &rays.to[0]), any(gpu, &rays.to[1])],
            others: closest(gpu, &rays.others),
        }
    }

    /// Records the traces, each through its target's tree.
    fn record<'g>(&self, frame: &mut Frame<'g>, views: &ViewSets<&'g Gpu>) {
        let trees = views.trees();
        for (place, [rays, hits]) in [(0, &self.from[0]), (3, &self.from[1]), (4, &self.others)] {
            done(trees[place].trace(frame, Query::Closest, rays.slice(..), hits.slice(..)));
        }
        for (place, [rays, ends, found]) in [(1, &self.to[0]), (2, &self.to[1])] {
            let rays = gpu::Rays::new(rays.slice(..)).with_ends(ends.slice(..));
            done(trees[place].trace(frame, Query::Any, rays, found.slice(..)));
        }
    }

    fn answers(&self, gpu: &Gpu) -> Answers {
        let found = |buffer: &wgpu::Buffer| -> Vec<bool> {
            let words: Vec<u32> = contents(gpu, buffer);
            words.into_iter().map(|word| word == 1).collect()
        };
        Answers {
            from: [
                contents(gpu, &self.from[0][1]),
                contents(gpu, &self.from[1][1]),
            ],
            to: [found(&self.to[0][2]), found(&self.to[1][2])],
            others: contents(gpu, &self.others[1]),
        }
    }
}

/// Updates, and traces the rays in the same submission.
fn frame<'a, 'g>(
    gpu: &'g Gpu,
    views: &mut ViewSets<&'g Gpu>,
    mesh: impl Into<gpu::Geometry<'a>>,
    change: Change,
    rays: &Rays,
) -> Answers {
    let asked = Asked::new(gpu, rays);
    let mut frame = gpu.frame();
    done(views.update(&mut frame, mesh, &targets(), change));
    asked.record(&mut frame, views);
    done(done(frame.submit()).wait());
    asked.answers(gpu)
}

/// Primitives and what was found: a GPU may round t, u and v otherwise.
fn same(a: &Answers, b: &Answers) -> bool {
    let primitives = |hits: &[Hit]| hits.iter().map(|hit| hit.primitive).collect::<Vec<_>>();
    let lists = |of: &Answers| [&of.from[0], &of.from[1], &of.others].map(|hits| primitives(hits));
    lists(a) == lists(b) && a.to == b.to
}

fn on_cpu(mesh: &Mesh, reduce: Reduce) -> (Rays, Answers) {
    let mut views = ViewSets::new(Cpu, config(reduce));
    done(views.update(mesh, &targets(), Change::Scene));
    let rays = rays_of(mesh, &views);
    let answers = answers(&views, &rays);
    (rays, answers)
}

/// Vertices of 32 bytes, positions 8 bytes behind their beginning.
fn interleaved(vertices: &[[f32; 3]]) -> Vec<[f32; 8]> {
    let wide = |&[x, y, z]: &[f32; 3]| [f32::NAN, 7.0, x, y, z, f32::MAX, -1.0, 0.5];
    vertices.iter().map(wide).collect()
}

fn in_buffers(gpu: &Gpu, mesh: &Mesh) -> (gpu::Mesh, wgpu::Buffer) {
    let vertices = storage(gpu, &interleaved(&mesh.vertices));
    let indices = storage(gpu, &mesh.indices);
    let layout = VertexLayout {
        slice: vertices.slice(..),
        stride: 32,
        offset: 8,
    };
    let indices = IndexLayout {
        slice: indices.slice(..),
        format: wgpu::IndexFormat::Uint32,
    };
    (done(gpu::Mesh::from_layout(gpu, layout, indices)), vertices)
}

fn has_sets(plan: Option<&Plan>) -> bool {
    plan.is_some_and(|plan| plan.sets.iter().all(|set| set.choice == TreeChoice::Set))
}

#[test]
fn a_targets_rays_have_the_cpus_answers() {
    let Some(gpu) = gpu() else { return };
    for mesh in meshes() {
        let (rays, expected) = on_cpu(&mesh, Reduce::On);
        for reduce in [Reduce::On, Reduce::Off] {
            let mut views = ViewSets::new(gpu, config(reduce));
            let answers = frame(gpu, &mut views, &mesh, Change::Scene, &rays);
            assert!(same(&answers, &expected), "{reduce:?}");
            assert_eq!(has_sets(views.plan()), reduce == Reduce::On);
            // The caller's buffers have the same trees.
            let (buffers, _) = in_buffers(gpu, &mesh);
            let mut views = ViewSets::new(gpu, config(reduce));
            let again = frame(gpu, &mut views, &buffers, Change::Scene, &rays);
            assert_eq!(again, answers, "{reduce:?}");
            assert_eq!(has_sets(views.plan()), reduce == Reduce::On);
            // So they have where the survey reads the mesh on the host.
            let mut views = ViewSets::new(gpu, config(reduce));
            let known = frame(gpu, &mut views, (&buffers, &mesh), Change::Scene, &rays);
            assert_eq!(known, answers, "{reduce:?}");
        }
    }
}

/// Only the GPU knows where the vertices are: it decides the sides itself.
#[test]
fn buffers_that_move_are_followed_on_the_gpu() {
    let Some(gpu) = gpu() else { return };
    let rest = &meshes()[1];
    let (buffers, vertices) = in_buffers(gpu, rest);
    let mut kept = [Reduce::On, Reduce::Off].map(|reduce| ViewSets::new(gpu, config(reduce)));
    for (step, change) in [
        (0, Change::Scene),
        (1, Change::Vertices),
        (2, Change::Vertices),
        (2, Change::View),
    ] {
        let mesh = twisted(rest, 0.1 * step as f32);
        let wide = interleaved(&mesh.vertices);
        gpu.queue()
            .write_buffer(&vertices, 0, bytemuck::cast_slice(&wide));
        let (rays, expected) = on_cpu(&mesh, Reduce::On);
        let [reduced, whole] = kept
            .each_mut()
            .map(|views| frame(gpu, views, &buffers, change, &rays));
        assert_eq!(reduced, whole, "{step}");
        assert!(same(&reduced, &expected), "{step}");
        assert!(has_sets(kept[0].plan()));
    }
    // The negative control: trees of another pose give other answers.
    let (rays, expected) = on_cpu(&twisted(rest, 0.8), Reduce::On);
    let stale = frame(gpu, &mut kept[0], &buffers, Change::View, &rays);
    assert!(!same(&stale, &expected));
}

#[test]
fn decisions_of_the_gpu_are_told() {
    let Some(gpu) = gpu() else { return };
    let mesh = &meshes()[0];
    let mut views = ViewSets::new(gpu, config(Reduce::On));
    for (change, is_decided) in [(Change::Scene, false), (Change::Vertices, true)] {
        let mut frame = gpu.frame();
        done(views.update(&mut frame, mesh, &targets(), change));
        let decisions = done(views.decisions_later(&mut frame));
        done(frame.submit());
        assert_eq!(decisions.is_some(), is_decided);
        if let Some(decisions) = decisions {
            let lines = done(decisions.read(gpu)).explain();
            assert!(
                lines[0]
                    .1
                    .starts_with("of 1 closed component, 1 face outward"),
                "{lines:?}"
            );
        }
    }
}

#[test]
fn another_mesh_on_the_host_is_refused_by_its_counts() {
    let Some(gpu) = gpu() else { return };
    let meshes = meshes();
    let (buffers, _) = in_buffers(gpu, &meshes[0]);
    let mut views = ViewSets::new(gpu, config(Reduce::On));
    let mut frame = gpu.frame();
    let geometry = (&buffers, &meshes[2]);
    let refused = views.update(&mut frame, geometry, &targets(), Change::Scene);
    let message = refused.expect_err("the counts differ").to_string();
    assert!(
        message.contains("the mesh in buffers has 5192 triangles"),
        "{message}"
    );
}

/// A buffer that cannot be copied from is read back all the same.
#[test]
fn a_mesh_in_buffers_is_read_back() {
    let Some(gpu) = gpu() else { return };
    let mesh = &meshes()[2];
    let same = |buffers: &gpu::Mesh| {
        let read = done(buffers.download(gpu));
        read.vertices == mesh.vertices && read.indices == mesh.indices
    };
    assert!(same(&done(gpu::Mesh::upload(gpu, mesh))));
    assert!(same(&in_buffers(gpu, mesh).0));
    let only_read = |bytes: &[u8]| {
        let buffer = gpu.device().create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size: bytes.len() as u64,
            usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        gpu.queue().write_buffer(&buffer, 0, bytes);
        buffer
    };
    let vertices = only_read(bytemuck::cast_slice(&mesh.vertices));
    let indices = only_read(bytemuck::cast_slice(&mesh.indices));
    let buffers = gpu::Mesh::from_buffers(gpu, vertices.slice(..), indices.slice(..));
    assert!(same(&done(buffers)));
}

/// A mesh at rest on the host is another pose than the one in buffers: the GPU decides by the latter.
#[test]
fn buffers_may_be_in_another_pose_than_the_mesh_on_the_host() {
    let Some(gpu) = gpu() else { return };
    // At rest the probe is inside the sphere, so that all of it stays.
    let mut rest = meshes().swap_remove(0);
    let moved = rest.clone();
    for [x, ..] in &mut rest.vertices {
        *x -= 2.0;
    }
    let (buffers, _) = in_buffers(gpu, &moved);
    let (rays, expected) = on_cpu(&moved, Reduce::On);
    let mut views = ViewSets::new(gpu, config(Reduce::On));
    for change in [Change::Scene, Change::View] {
        let answers = frame(gpu, &mut views, (&buffers, &rest), change, &rays);
        assert!(same(&answers, &expected), "{change:?}");
    }
}

/// A copy of a mesh on the host is kept apart from the caller's buffers, and is replaced where the counts differ.
#[test]
fn copies_and_buffers_do_not_take_each_others_place() {
    let Some(gpu) = gpu() else { return };
    let mesh = &meshes()[0];
    let other = twisted(mesh, 0.5);
    let (buffers, vertices) = in_buffers(gpu, mesh);
    let mut views = ViewSets::new(gpu, config(Reduce::On));
    let (rays, expected) = on_cpu(mesh, Reduce::On);
    let (other_rays, of_other) = on_cpu(&other, Reduce::On);
    let answers = frame(gpu, &mut views, &buffers, Change::Scene, &rays);
    assert!(same(&answers, &expected));
    let answers = frame(gpu, &mut views, &other, Change::Vertices, &other_rays);
    assert!(same(&answers, &of_other));
    let kept: Vec<[f32; 8]> = contents(gpu, &vertices);
    assert_eq!(kept[5][2..5], mesh.vertices[5]);
    // More vertices than the copy has room for.
    let mut more = other;
    more.vertices.push([0.0; 3]);
    let answers = frame(gpu, &mut views, &more, Change::Vertices, &other_rays);
    assert!(same(&answers, &of_other));
    // A vertex that is not finite is refused, as on the CPU.
    more.vertices[2][1] = f32::NAN;
    let mut frame = gpu.frame();
    let refused = views.update(&mut frame, &more, &targets(), Change::Vertices);
    assert!(refused.is_err_and(|error| error.to_string().contains("vertex 2")));
}

/// A compressed whole tree can be refitted only if it was built last; else it is built again.
#[test]
fn compressed_trees_follow_vertices() {
    let Some(gpu) = gpu() else { return };
    let rest = &meshes()[1];
    let mut settings = config(Reduce::On);
    settings.build.nodes = slimbvh::NodeCodec::Wide(slimbvh::WideStore::Exact);
    settings.plan.switches.seams = slimbvh::reduce::Seams::Find;
    let mut views = ViewSets::new(gpu, settings);
    for (step, change) in [
        (0, Change::Scene),
        (1, Change::Vertices),
        (2, Change::Vertices),
    ] {
        let mesh = twisted(rest, 0.1 * step as f32);
        let (rays, expected) = on_cpu(&mesh, Reduce::On);
        let answers = frame(gpu, &mut views, &mesh, change, &rays);
        assert!(same(&answers, &expected), "{step}");
    }
    assert!(views.plan().is_some_and(Plan::is_plain));
}
