//! Answers to rays equal the CPU's: to the bit on a software adapter, almost on a hardware GPU.

use proptest::prelude::*;
use slimbvh::generate::soup;
use slimbvh::gpu::{self, Frame, Gpu, GpuError, Query, wgpu};
use slimbvh::{BuildConfig, Bvh, CodeBits, Mesh};
use slimbvh_core::RayEnds;
use slimbvh_core::launch::NEAREST_COUNT;
use slimbvh_core::ray::PreparedRay;
use slimbvh_core::trace::{ClosestHit, Counted};
use slimbvh_core::{Hit, Ray};
use slimbvh_lab::stress::BOUND_ULPS;
use slimbvh_tests::gpu::{contents, done, gpu, is_software, storage};
use slimbvh_tests::parity::{GRAZING, T_SHARE, same_bits};
use slimbvh_tests::random::Random;
use slimbvh_tests::rays::some_rays;
use slimbvh_tests::strategies::{any_mesh, large_mesh};
use slimbvh_tests::{build, cases};

/// The answers of all queries to all rays.
#[derive(Clone, Debug, PartialEq)]
pub struct Answers {
    closest: Vec<Hit>,
    any: Vec<u32>,
    /// The CPU's answers to rays with slightly shorter or longer ranges, for comparison with a hardware GPU.
    nearly: Vec<Nearly>,
    nearest: Vec<[Hit; NEAREST_COUNT]>,
    counted: Vec<[u32; 2]>,
}

impl Answers {
    /// Builds and traces in one frame.
    pub fn of_gpu(gpu: &Gpu, mesh: &Mesh, config: impl Into<BuildConfig>, rays: &[Ray]) -> Self {
        let mesh = done(gpu::Mesh::upload(gpu, mesh));
        let mut bvh = gpu::Bvh::new();
        let mut frame = gpu.frame();
        let mut builder = gpu::Builder::new(config.into());
        done(builder.build(&mut frame, &mesh, &mut bvh));
        Self::in_frame(frame, &bvh, rays)
    }

    /// Traces through a hierarchy that exists already or is built in this frame.
    pub fn in_frame(mut frame: Frame, bvh: &gpu::Bvh, rays: &[Ray]) -> Self {
        let gpu = frame.gpu();
        let ray_buffer = storage(gpu, rays);
        let queries = [Query::Closest, Query::Any, Query::Nearest, Query::Counted];
        let [closest, any, nearest, counted] = queries.map(|query| {
            let answers = vec![0u8; rays.len() * query.answer_bytes() as usize];
            let answers = storage(gpu, &answers);
            done(bvh.trace(&mut frame, query, ray_buffer.slice(..), answers.slice(..)));
            answers
        });
        done(frame.submit());
        Self {
            closest: contents(gpu, &closest),
            any: contents(gpu, &any),
            nearly: Vec::new(),
            nearest: contents(gpu, &nearest),
            counted: contents(gpu, &counted),
        }
    }

    pub fn of_cpu(bvh: &Bvh, rays: &[Ray]) -> Self {
        let counted = |ray: &Ray| {
            let ray = PreparedRay::new(ray, bvh.scene_exponent());
            let mut counted = Counted::new(ClosestHit::new(ray.t_max));
            bvh.collect(&ray, &RayEnds::NONE, &mut counted);
            [counted.node_count, counted.triangle_count]
        };
        Self {
            closest: rays.iter().map(|ray| bvh.closest_hit(ray)).collect(),
            any: rays.iter().map(|ray| bvh.any_hit(ray).into()).collect(),
            nearly: rays.iter().map(|ray| Nearly::new(bvh, ray)).collect(),
            nearest: rays.iter().map(|ray| bvh.nearest_hits(ray)).collect(),
            counted: rays.iter().map(counted).collect(),
        }
    }

    /// Compares answers: to the bit on a software adapter; on a hardware GPU hits may be slightly off and walks slightly longer.
    pub fn compare(&self, cpu: &Self, is_software: bool) -> Result<(), String> {
        let lists = [self, cpu].map(|answers| answers.nearest.concat());
        if is_software {
            same_bits(&self.any, &cpu.any)?;
            same_bits(&self.closest, &cpu.closest)?;
            same_bits(&lists[0], &lists[1])?;
            return same_bits(&self.counted, &cpu.counted);
        }
        if [self.any.len(), self.closest.len()] != [cpu.nearly.len(); 2] {
            return Err("answers are missing".to_owned());
        }
        let differs = |&i: &usize| {
            let nearly = &cpu.nearly[i];
            // A ray with any hit has a closest hit.
            let [least, most] = nearly.nearest.map(|hits| u32::from(hits[0].is_hit()));
            !(least..=most).contains(&self.any[i])
                || !nearly.is_near(&[self.closest[i]], &[cpu.closest[i]])
                || !nearly.is_near(&self.nearest[i], &cpu.nearest[i])
        };
        let different: Vec<usize> = (0..self.any.len()).filter(differs).collect();
        if let Some(&i) = different
            .first()
            .filter(|_| different.len() * GRAZING > self.any.len())
        {
            return Err(format!(
                "{} of {} differ, first {i}: {:?} instead of {:?}",
                different.len(),
                self.any.len(),
                (self.any[i], self.closest[i], self.nearest[i]),
                (cpu.any[i], cpu.closest[i], cpu.nearest[i]),
            ));
        }
        let counts = self.counted.iter().zip(&cpu.counted);
        let different = counts.filter(|(a, b)| a != b).count();
        if different * GRAZING > self.counted.len() {
            return Err(format!("{different} searches touch other nodes"));
        }
        Ok(())
    }
}

/// The allowed answers of a hardware GPU to a ray: t may be slightly off, and so beyond an end of the range.
#[derive(Clone, Debug, PartialEq)]
struct Nearly {
    /// The allowed absolute error of t, in addition to a relative one.
    still: f32,
    nearest: [[Hit; NEAREST_COUNT]; 2],
}

impl Nearly {
    fn new(bvh: &Bvh, ray: &Ray) -> Self {
        let largest = |v: [f32; 3]| v.into_iter().map(f32::abs).fold(0.0, f32::max);
        let scene = 2f64.powi(-bvh.scene_exponent()) as f32;
        let size = scene.max(largest(ray.origin));
        let ulps = BOUND_ULPS as f32 * f32::EPSILON;
        let still = size / largest(ray.direction).max(f32::MIN_POSITIVE) * ulps;
        let stretched = [-1.0, 1.0].map(|sign: f32| {
            let slack = |t: f32| sign * (T_SHARE * t.abs() + still);
            Ray {
                t_min: ray.t_min - slack(ray.t_min),
                t_max: ray.t_max + slack(ray.t_max),
                ..*ray
            }
        });
        Self {
            still,
            nearest: stretched.map(|ray| bvh.nearest_hits(ray)),
        }
    }

    /// Whether hits almost equal the CPU's, or the CPU's in a slightly shorter or longer range, in which some hits lie at the
    /// ends.
    fn is_near(&self, gpu: &[Hit], cpu: &[Hit]) -> bool {
        let is_close = |(a, b): (&Hit, &Hit)| {
            let off = (f64::from(a.t) - f64::from(b.t)).abs();
            let bound = f64::from(T_SHARE) * f64::from(b.t.abs()) + f64::from(self.still);
            a.primitive == b.primitive && (off <= bound || a.t == b.t)
        };
        let all = |of: &[Hit]| gpu.iter().zip(of).all(is_close);
        all(cpu) || self.nearest.iter().any(|nearest| all(nearest))
    }
}

/// A hardware GPU may answer either way only if a hit lies at an end of the range.
#[test]
fn ends_of_ranges_are_all_that_a_real_gpu_may_see_otherwise() {
    let mesh = soup(50, 1);
    let bvh = build(&mesh, CodeBits::Bits30);
    let hits = rays_at(&mesh, 400, 7).into_iter().filter_map(|ray| {
        let t = Some(bvh.closest_hit(ray)).filter(Hit::is_hit)?.t;
        Some((ray, t))
    });
    let (mut at_end, mut within) = (Vec::new(), Vec::new());
    for (ray, t) in hits {
        at_end.push(Ray {
            t_min: t,
            t_max: t,
            ..ray
        });
        within.push(Ray {
            t_max: 1.1 * t,
            ..ray
        });
    }
    assert!(at_end.len() > 50);
    for (rays, may_differ) in [(at_end, true), (within, false)] {
        let cpu = Answers::of_cpu(&bvh, &rays);
        let mut other = cpu.clone();
        other.any.fill(0);
        other.closest.fill(Hit::MISS);
        other.nearest.fill([Hit::MISS; NEAREST_COUNT]);
        assert_eq!(other.compare(&cpu, false).is_ok(), may_differ);
        assert!(other.compare(&cpu, true).is_err() && cpu.compare(&cpu, true).is_ok());
    }
}

fn check(gpu: &Gpu, mesh: &Mesh, code_bits: CodeBits, rays: &[Ray]) -> Result<usize, String> {
    let answers = Answers::of_gpu(gpu, mesh, code_bits, rays);
    answers.compare(
        &Answers::of_cpu(&build(mesh, code_bits), rays),
        is_software(gpu),
    )?;
    Ok(answers.any.iter().filter(|&&any| any == 1).count())
}

proptest! {
    #![proptest_config(cases(50))]

    #[test]
    fn answers_are_those_of_the_cpu(mesh in any_mesh(), recipes in some_rays(300), long: bool) {
        let Some(gpu) = gpu() else { return Ok(()) };
        let rays: Vec<Ray> = recipes.iter().map(|recipe| recipe.cook(&mesh)).collect();
        let code_bits = if long { CodeBits::Bits63 } else { CodeBits::Bits30 };
        let result = check(gpu, &mesh, code_bits, &rays);
        prop_assert!(result.is_ok(), "{:?}", result);
    }

    #[test]
    fn answers_in_large_meshes_are_those_of_the_cpu(mesh in large_mesh(), recipes in some_rays(300)) {
        let Some(gpu) = gpu() else { return Ok(()) };
        let rays: Vec<Ray> = recipes.iter().map(|recipe| recipe.cook(&mesh)).collect();
        let result = check(gpu, &mesh, CodeBits::Bits30, &rays);
        prop_assert!(result.is_ok(), "{:?}", result);
    }
}

/// Rays from around a mesh to points near it.
pub fn rays_at(mesh: &Mesh, count: usize, seed: u64) -> Vec<Ray> {
    let bounds = mesh.bounds().unwrap_or(slimbvh::Aabb::EMPTY);
    let (middle, size) = ((bounds.min + bounds.max) / 2.0, bounds.max - bounds.min);
    let mut random = Random::new(seed);
    let ray = |_| {
        let origin = middle + random.direction() * size.length();
        let target = middle + random.point() * size / 2.0;
        Ray::new(origin.to_array(), (target - origin).to_array())
    };
    (0..count).map(ray).collect()
}

#[test]
fn answers_in_generated_meshes_are_those_of_the_cpu() {
    let Some(gpu) = gpu() else { return };
    for (name, mesh) in crate::meshes::generated() {
        let hit_count = check(gpu, &mesh, CodeBits::Bits30, &rays_at(&mesh, 1500, 3));
        assert!(
            hit_count.as_ref().is_ok_and(|&count| count > 30),
            "{name}: {hit_count:?}"
        );
    }
}

#[test]
fn numbers_of_rays_around_workgroups_are_all_answered() {
    let Some(gpu) = gpu() else { return };
    let mesh = soup(300, 2);
    for count in [1, 63, 64, 65, 1024, 1025] {
        done(check(
            gpu,
            &mesh,
            CodeBits::Bits30,
            &rays_at(&mesh, count, 7),
        ));
    }
    // An empty mesh has no hits.
    let rays = rays_at(&mesh, 100, 8);
    let hit_count = check(gpu, &Mesh::default(), CodeBits::Bits30, &rays);
    assert_eq!(hit_count, Ok(0));
}

#[test]
fn one_flipped_bit_of_an_answer_is_found() {
    let mesh = soup(300, 2);
    let sound = Answers::of_cpu(&build(&mesh, CodeBits::Bits30), &rays_at(&mesh, 200, 3));
    let at = sound.any.iter().position(|&any| any == 1).unwrap();
    let spoil = |spoil: &dyn Fn(&mut Answers)| {
        let mut spoilt = sound.clone();
        spoil(&mut spoilt);
        spoilt.compare(&sound, true)
    };
    assert!(spoil(&|_| {}).is_ok());
    assert!(spoil(&|a| a.any[at] = 0).is_err());
    assert!(spoil(&|a| a.closest[at].primitive ^= 1).is_err());
    assert!(spoil(&|a| a.closest[at].u = f32::from_bits(a.closest[at].u.to_bits() ^ 1)).is_err());
    assert!(spoil(&|a| a.nearest[at][7].t = 1.0).is_err());
    assert!(spoil(&|a| a.counted[at][1] ^= 1).is_err());
}

#[test]
fn rays_without_room_for_their_answers_are_refused() {
    let Some(gpu) = gpu() else { return };
    let mesh = done(gpu::Mesh::upload(gpu, &soup(10, 1)));
    let mut bvh = gpu::Bvh::new();
    let mut frame = gpu.frame();
    let rays = storage(gpu, &[Ray::EMPTY; 20]);
    let room = storage(gpu, &[Hit::MISS; 20]);
    let mut trace = |bvh: &gpu::Bvh, rays: wgpu::BufferSlice, room: wgpu::BufferSlice| {
        bvh.trace(&mut frame, Query::Closest, rays, room)
    };
    let refused = |result: Result<(), GpuError>| matches!(result, Err(GpuError::Unfit { .. }));
    assert!(refused(trace(&bvh, rays.slice(..), room.slice(..))));
    let mut build = gpu.frame();
    done(gpu::Builder::new(BuildConfig::default()).build(&mut build, &mesh, &mut bvh));
    done(build.submit());
    assert!(refused(trace(&bvh, rays.slice(..), room.slice(..304))));
    assert!(refused(trace(&bvh, rays.slice(..600), room.slice(..))));
    assert!(refused(trace(&bvh, rays.slice(4..), room.slice(..))));
    assert!(trace(&bvh, rays.slice(..), room.slice(..)).is_ok());
}
