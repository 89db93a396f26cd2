//! Rays whose ends lie on surfaces, whole trees with a rule, and a number of rays that only the GPU knows: the answers are the CPU's.

use crate::deep_chains::{Side, chain, rays_inside};
use glam::Vec3;
use slimbvh::generate::icosphere;
use slimbvh::gpu::{self, Gpu, GpuError, Query, Rays, TargetSides, Tree, wgpu};
use slimbvh::{BuildConfig, Builder, Bvh, Hit, Mesh, MeshCodec, NodeCodec, Ray, WideStore};
use slimbvh_core::classify::faces;
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::frustum::Frustum;
use slimbvh_core::launch::NEAREST_COUNT;
use slimbvh_core::orientation::Target;
use slimbvh_core::snap::snap_triangle;
use slimbvh_core::{IndexedTriangles, RayEnds, SurfaceRay};
use slimbvh_tests::gpu::{contents, done, gpu, gpu_with_limits, is_software, storage};
use slimbvh_tests::parity::{mostly_equal, same_bits};
use slimbvh_tests::random::Random;

/// Two balls on a lattice, and the component of each triangle.
pub fn balls() -> (Mesh, Vec<u32>) {
    let mut mesh = icosphere(Vec3::new(-0.6, 0.1, 0.0), 0.5, 3);
    let other = icosphere(Vec3::new(0.5, 0.0, 0.3), 0.7, 3);
    let count = mesh.indices.len();
    let first = mesh.vertices.len() as u32;
    mesh.vertices.extend(other.vertices);
    let moved = other.indices.iter().map(|face| face.map(|v| v + first));
    mesh.indices.extend(moved);
    mesh.normals.clear();
    mesh.snap(-12);
    let components = (0..mesh.indices.len()).map(|i| u32::from(i >= count));
    let components = components.collect();
    (mesh, components)
}

/// All kinds of trees that the GPU traces.
pub fn configs() -> Vec<BuildConfig> {
    let lattice = MeshCodec::Lattice { step_exponent: -12 };
    let wide = [
        (NodeCodec::F32, MeshCodec::F32),
        (NodeCodec::Wide(WideStore::Full), MeshCodec::F32),
        (NodeCodec::Wide(WideStore::Exact), MeshCodec::F32),
        (NodeCodec::Wide(WideStore::Exact), lattice),
        (NodeCodec::Wide(WideStore::Packed), lattice),
    ];
    let config = |(nodes, mesh)| BuildConfig {
        nodes,
        mesh,
        ..BuildConfig::default()
    };
    wide.map(config).to_vec()
}

/// Rays from everywhere, and rays between and from the points that they hit.
fn next_rays(bvh: &Bvh, mesh: &Mesh) -> Vec<SurfaceRay> {
    let mut random = Random::new(9);
    let mut rays = Vec::new();
    let mut points = Vec::new();
    for _ in 0..300 {
        let (from, to) = (2.0 * random.point(), random.point());
        let ray = Ray::new(from.to_array(), (to - from).to_array());
        rays.push(SurfaceRay::from(ray));
        points.extend(bvh.surface(mesh, ray, &bvh.closest_hit(ray)));
    }
    for pair in points.windows(2) {
        rays.push(Ray::between(pair[0], pair[1]));
        rays.push(pair[0].ray(random.direction().to_array()));
    }
    rays
}

/// The answers of the queries that have hits.
#[derive(Debug, PartialEq)]
struct Answers {
    closest: Vec<Hit>,
    any: Vec<u32>,
    nearest: Vec<Hit>,
}

impl Answers {
    fn of_gpu(gpu: &Gpu, tree: Tree, rays: Rays, ray_count: usize) -> Self {
        let mut frame = gpu.frame();
        let [closest, any, nearest] = [Query::Closest, Query::Any, Query::Nearest].map(|query| {
            let answers = vec![0u8; ray_count * query.answer_bytes() as usize];
            let answers = storage(gpu, &answers);
            done(tree.trace(&mut frame, query, rays, answers.slice(..)));
            answers
        });
        done(frame.submit());
        Self {
            closest: contents(gpu, &closest),
            any: contents(gpu, &any),
            nearest: contents(gpu, &nearest),
        }
    }

    /// Of hits that `accepts` accepts.
    fn of_cpu(bvh: &Bvh, rays: &[SurfaceRay], accepts: impl Fn(&Hit) -> bool) -> Self {
        let nearest = |ray: &SurfaceRay| {
            let mut hits: Vec<Hit> = bvh.all_hits(ray).into_iter().filter(&accepts).collect();
            hits.resize(NEAREST_COUNT, Hit::MISS);
            hits
        };
        let nearest: Vec<Vec<Hit>> = rays.iter().map(nearest).collect();
        Self {
            closest: nearest.iter().map(|hits| hits[0]).collect(),
            any: nearest.iter().map(|hits| hits[0].is_hit().into()).collect(),
            nearest: nearest.concat(),
        }
    }

    fn compare(&self, cpu: &Self, is_software: bool) -> Result<(), String> {
        if is_software {
            same_bits(&self.any, &cpu.any)?;
            same_bits(&self.closest, &cpu.closest)?;
            return same_bits(&self.nearest, &cpu.nearest);
        }
        let primitives = |hits: &[Hit]| hits.iter().map(|hit| hit.primitive).collect::<Vec<_>>();
        mostly_equal(&self.any, &cpu.any)?;
        mostly_equal(&primitives(&self.closest), &primitives(&cpu.closest))?;
        mostly_equal(&primitives(&self.nearest), &primitives(&cpu.nearest))
    }
}

/// Rays and their ends in buffers.
fn upload(gpu: &Gpu, rays: &[SurfaceRay]) -> [wgpu::Buffer; 2] {
    let plain: Vec<Ray> = rays.iter().map(|ray| ray.ray).collect();
    let ends: Vec<RayEnds> = rays.iter().map(|ray| ray.ends).collect();
    [storage(gpu, &plain), storage(gpu, &ends)]
}

#[test]
fn what_ends_lie_on_is_no_hit() {
    let Some(gpu) = gpu() else { return };
    let (mesh, _) = balls();
    for config in configs() {
        let bvh = done(Builder::new(config).build(&mesh));
        let rays = next_rays(&bvh, &mesh);
        let [buffer, ends] = upload(gpu, &rays);
        let uploaded = done(gpu::Bvh::upload(gpu, &bvh));
        let tree = Tree::all(&uploaded);
        let with = Rays::new(buffer.slice(..)).with_ends(ends.slice(..));
        let found = Answers::of_gpu(gpu, tree, with, rays.len());
        let expected = Answers::of_cpu(&bvh, &rays, |_| true);
        done(found.compare(&expected, is_software(gpu)));
        assert!(expected.closest.iter().any(Hit::is_hit));

        // The negative control: without the ends, surfaces block the rays that leave them.
        let without = Answers::of_gpu(gpu, tree, buffer.slice(..).into(), rays.len());
        assert!(without.compare(&expected, is_software(gpu)).is_err());
        let plain: Vec<SurfaceRay> = rays.iter().map(|ray| ray.ray.into()).collect();
        let expected = Answers::of_cpu(&bvh, &plain, |_| true);
        done(without.compare(&expected, is_software(gpu)));
    }
}

#[test]
fn what_a_rule_rejects_is_no_hit() {
    let Some(gpu) = gpu() else { return };
    let (mesh, components) = balls();
    let target = Target::position([0.3, 2.0, -1.0]);
    let sides = [1, -1];
    for config in configs() {
        let bvh = done(Builder::new(config).build(&mesh));
        let rays = next_rays(&bvh, &mesh);
        let [buffer, ends] = upload(gpu, &rays);
        let uploaded = done(gpu::Bvh::upload(gpu, &bvh));
        let on_gpu = done(gpu::Components::upload(gpu, &components));
        let mut facing = TargetSides::new();
        let mut frame = gpu.frame();
        let place = (&target, &Frustum::EVERYWHERE);
        done(facing.set(&mut frame, &on_gpu, place, &sides));
        done(frame.submit());
        let tree = ruled(&uploaded, &on_gpu, &facing);
        let scale = PowerOfTwo::new(bvh.scene_exponent());
        let scaled = target.scaled(&scale);
        let indexed = IndexedTriangles {
            vertices: &mesh.vertices,
            indices: &mesh.indices,
        };
        let accepts = |hit: &Hit| {
            let side = sides[components[hit.primitive as usize] as usize];
            let triangle = snap_triangle(&indexed.triangle(hit.primitive), &scale);
            faces(&triangle, side, &scaled)
        };
        let with = Rays::new(buffer.slice(..)).with_ends(ends.slice(..));
        let found = Answers::of_gpu(gpu, tree, with, rays.len());
        let expected = Answers::of_cpu(&bvh, &rays, accepts);
        done(found.compare(&expected, is_software(gpu)));

        // The negative control: the rule rejects hits.
        let all = Answers::of_gpu(gpu, Tree::all(&uploaded), with, rays.len());
        assert!(all.compare(&expected, is_software(gpu)).is_err());
        // A rule without ends.
        let plain: Vec<SurfaceRay> = rays.iter().map(|ray| ray.ray.into()).collect();
        let found = Answers::of_gpu(gpu, tree, buffer.slice(..).into(), rays.len());
        done(found.compare(&Answers::of_cpu(&bvh, &plain, accepts), is_software(gpu)));
    }
}

/// Traces as many rays as the GPU finds in the second word of a buffer when the trace runs. Answers begin as 7.
fn counted(gpu: &Gpu, bvh: &gpu::Bvh, rays: Rays, ray_count: usize, count: u32) -> Vec<[u32; 4]> {
    let (counter, source) = (storage(gpu, &[9u32, 0, 9]), storage(gpu, &[count]));
    let answers = storage(gpu, &vec![[7u32; 4]; ray_count]);
    let mut frame = gpu.frame();
    let rays = rays.counted_by(counter.slice(4..8));
    frame
        .encoder()
        .copy_buffer_to_buffer(&source, 0, &counter, 4, 4);
    done(bvh.trace(&mut frame, Query::Closest, rays, answers.slice(..)));
    done(frame.submit());
    contents(gpu, &answers)
}

#[test]
fn as_many_rays_are_traced_as_the_gpu_counts() {
    let Some(gpu) = gpu() else { return };
    let small = gpu_with_limits(|limits| limits.max_storage_buffer_binding_size = 16_384);
    let Some(small) = small else { return };
    let mut mesh = icosphere(Vec3::ZERO, 1.0, 1);
    mesh.normals.clear();
    for (gpu, config) in [
        (gpu, configs()[0]),
        (gpu, configs()[4]),
        // A dispatch takes 512 rays.
        (&small, configs()[0]),
    ] {
        mesh.snap(-12);
        let bvh = done(Builder::new(config).build(&mesh));
        let rays = next_rays(&bvh, &mesh);
        let [buffer, ends] = upload(gpu, &rays);
        let uploaded = done(gpu::Bvh::upload(gpu, &bvh));
        let plain = Rays::new(buffer.slice(..));
        for rays_given in [plain, plain.with_ends(ends.slice(..))] {
            let all = counted(gpu, &uploaded, rays_given, rays.len(), u32::MAX);
            assert!(all.iter().all(|answer| *answer != [7; 4]));
            for count in [0, 1, 64, 65, 512, 513, rays.len() - 1, rays.len()] {
                let found = counted(gpu, &uploaded, rays_given, rays.len(), count as u32);
                assert!(found[..count] == all[..count], "{count}");
                let rest = &found[count..];
                assert!(rest.iter().all(|answer| *answer == [7; 4]), "{count}");
            }
            let hits = storage(gpu, &vec![Hit::MISS; rays.len()]);
            let mut frame = gpu.frame();
            done(uploaded.trace(&mut frame, Query::Closest, rays_given, hits.slice(..)));
            done(frame.submit());
            assert!(contents::<[u32; 4]>(gpu, &hits) == all);
        }
    }
}

/// Rays of the second pass have ends and are counted, too.
#[test]
fn rays_that_overflow_are_filtered_and_counted() {
    let Some(gpu) = gpu() else { return };
    let bvh = chain(Side::Left);
    let rays = rays_inside(&bvh, 100);
    let first: Vec<Hit> = rays.iter().map(|ray| bvh.closest_hit(ray)).collect();
    let skipping = |(ray, hit): (&Ray, &Hit)| SurfaceRay {
        ray: *ray,
        ends: RayEnds::skipping(hit.primitive),
    };
    let rays: Vec<SurfaceRay> = rays.iter().zip(&first).map(skipping).collect();
    let [buffer, ends] = upload(gpu, &rays);
    let uploaded = done(gpu::Bvh::upload(gpu, &bvh));
    let with = Rays::new(buffer.slice(..)).with_ends(ends.slice(..));
    let found = Answers::of_gpu(gpu, Tree::all(&uploaded), with, rays.len());
    let expected = Answers::of_cpu(&bvh, &rays, |_| true);
    done(found.compare(&expected, is_software(gpu)));
    assert!(same_bits(&expected.closest, &first).is_err());
    let some = counted(gpu, &uploaded, with, rays.len(), 40);
    let closest: Vec<[u32; 4]> = bytemuck::cast_slice(&found.closest).to_vec();
    assert!(some[..40] == closest[..40] && some[40..].iter().all(|answer| *answer == [7; 4]));
}

#[test]
fn rays_that_do_not_fit_are_refused() {
    let Some(gpu) = gpu() else { return };
    let (mesh, components) = balls();
    let bvh = done(Builder::new(BuildConfig::default()).build(&mesh));
    let uploaded = done(gpu::Bvh::upload(gpu, &bvh));
    let words = storage(gpu, &[0u32; 320]);
    let rays = Rays::new(words.slice(..320));
    let refusal = |tree: Tree, rays: Rays| {
        let traced = tree.trace(&mut gpu.frame(), Query::Any, rays, words.slice(..));
        match traced {
            Err(error @ GpuError::Unfit { .. }) => error.to_string(),
            other => panic!("{other:?}"),
        }
    };
    let all = Tree::all(&uploaded);
    assert_eq!(
        refusal(all, rays.with_ends(words.slice(..144))),
        "the buffer of ends has 144 bytes, but 10 rays have ends of 16 bytes each"
    );
    assert_eq!(
        refusal(all, rays.counted_by(words.slice(..8))),
        "the buffer of the number of rays has 8 bytes; pass a slice of one `u32`"
    );
    let on_gpu = done(gpu::Components::upload(gpu, &components));
    let other = done(gpu::Components::upload(gpu, &components[1..]));
    let mut facing = TargetSides::new();
    let undecided = refusal(ruled(&uploaded, &on_gpu, &facing), rays);
    assert_eq!(undecided, "the target is empty; set or decide it first");
    let target = Target::position([9.0; 3]);
    let place = (&target, &Frustum::EVERYWHERE);
    done(facing.set(&mut gpu.frame(), &other, place, &[1, 1]));
    let message = "the rule has sides of other components; set or decide them for these";
    assert_eq!(refusal(ruled(&uploaded, &on_gpu, &facing), rays), message);
    let bindings = ruled(&uploaded, &on_gpu, &facing).bindings().err();
    assert_eq!(
        bindings.map(|error| error.to_string()).as_deref(),
        Some(message)
    );
}

const fn ruled<'a>(
    bvh: &'a gpu::Bvh,
    components: &'a gpu::Components,
    sides: &'a TargetSides,
) -> Tree<'a> {
    Tree {
        bvh,
        rule: Some((components, sides)),
    }
}
