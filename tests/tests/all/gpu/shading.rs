//! Kernels of shading, each alone, on inputs from the CPU's earlier stages: its numbers equal those of core's function within a
//! millionth.

use super::kernels::groups;
use super::pictures::{hall_of_mirrors, open_and_flat, settings, soft_hall};
use bytemuck::{bytes_of, cast_slice};
use slimbvh::gpu::{Gpu, Kernel};
use slimbvh::{Bvh, CodeBits, Scene, View};
use slimbvh_core::camera::Camera;
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::light::NO_EXTENT;
use slimbvh_core::sampling::Draw;
use slimbvh_core::shade::{
    Environment, Light, Material, Path, Shadow, ambient_light, direct_light,
};
use slimbvh_core::snap::leaf_triangle;
use slimbvh_core::surface::Surface;
use slimbvh_core::trace::Skip;
use slimbvh_core::{Hit, Vec3, trace};
use slimbvh_tests::build;
use slimbvh_tests::gpu::{Dispatch, answers, done, gpu};
use slimbvh_tests::parity::{close, same_bits};

/// The tolerance, relative to a number, or to 1 (the scene's magnitude) if that is larger.
pub const SHARE: f32 = 1e-6;

/// A scene with its primary rays and their hits.
pub struct Lit {
    pub scene: Scene,
    pub bvh: Bvh,
    pub camera: Camera,
    pub paths: Vec<Path>,
    pub hits: Vec<Hit>,
    lights: Vec<Light>,
    materials: Vec<Material>,
    environment: Environment,
}

impl Lit {
    pub fn new(scene: Scene) -> Self {
        let settings = settings(View::Color);
        let bvh = build(&scene.mesh, CodeBits::Bits30);
        let camera = done(scene.cameras[0].to_core(settings.size, 1));
        let scaled = camera.scaled(&PowerOfTwo::new(bvh.scene_exponent()));
        let samples = 0..settings.size[0] * settings.size[1];
        let paths: Vec<Path> = samples
            .map(|sample| Path::new(scaled.ray(sample), sample))
            .collect();
        let (nodes, triangles) = (bvh.node_source(), bvh.triangle_source());
        let hit =
            |path: &Path| trace::closest_hit(&nodes, &triangles, &path.ray, 0, &Skip(path.skip));
        let hits = paths.iter().map(hit).collect();
        let lights = scene.lights.iter().enumerate();
        Self {
            hits,
            paths,
            lights: lights.map(|(i, light)| done(light.to_core(i))).collect(),
            materials: scene.core_materials(),
            environment: Scene::environment(scene.cameras[0].up),
            camera,
            bvh,
            scene,
        }
    }

    pub fn all() -> [Self; 3] {
        [hall_of_mirrors(), open_and_flat(), soft_hall()].map(Self::new)
    }

    pub fn exponent(&self) -> [u32; 4] {
        [self.bvh.scene_exponent() as u32, 0, 0, 0]
    }

    /// The mesh's buffers, in the order of the kernels' bindings; none may be empty.
    pub fn mesh(&self) -> [&[u8]; 3] {
        let mesh = &self.scene.mesh;
        let normals: &[u8] = cast_slice(&mesh.normals);
        let normals = if normals.is_empty() {
            &[0; 12]
        } else {
            normals
        };
        [
            cast_slice(&mesh.vertices),
            cast_slice(&mesh.indices),
            normals,
        ]
    }

    /// The surface and the material at a path's hit.
    pub fn surface(&self, path: &Path, hit: &Hit) -> (Surface, Material) {
        let mesh = &self.scene.mesh;
        let scale = PowerOfTwo::new(self.bvh.scene_exponent());
        let triangle = leaf_triangle(hit.primitive, &mesh.triangles(), &scale).triangle();
        let normals = mesh.indices[hit.primitive as usize].map(|corner| {
            let normal = mesh.normals.get(corner as usize);
            normal.map_or(Vec3::ZERO, |&normal| normal.into())
        });
        let named = mesh.materials.get(hit.primitive as usize).unwrap_or(&0);
        let material = self
            .materials
            .get(*named as usize)
            .unwrap_or(&self.materials[0]);
        let direction = Vec3::from(path.ray.direction);
        (Surface::new(triangle, hit, direction, normals), *material)
    }

    /// The shadow ray of each hit to a light, after this number of mirrors.
    fn shadows(&self, light: &Light, bounce: u32) -> Vec<Shadow> {
        let light = light.scaled(&PowerOfTwo::new(self.bvh.scene_exponent()));
        let shadow = |(path, hit): (&Path, &Hit)| {
            if !hit.is_hit() {
                return Shadow::NONE;
            }
            let (surface, material) = self.surface(path, hit);
            let draw = Draw {
                sample: path.sample,
                sample_count: self.camera.sample_count,
                bounce,
            };
            direct_light(&surface, hit.primitive, &material, &light.sampled(&draw))
        };
        self.paths.iter().zip(&self.hits).map(shadow).collect()
    }
}

/// Compares structures of numbers; whole numbers among them must be equal.
pub fn close_words<T: bytemuck::NoUninit>(gpu: &[u8], cpu: &[T]) -> Result<(), String> {
    let (gpu, cpu) = (answers::<f32>(gpu), answers::<f32>(cast_slice(cpu)));
    close(&gpu, &cpu, SHARE, 1.0)
}

fn shade_light(gpu: &Gpu, lit: &Lit, light: &Light, bounce: u32) -> Vec<u8> {
    let [vertices, indices, normals] = lit.mesh();
    let nothing = vec![Shadow::default(); lit.paths.len()];
    let stored = Dispatch {
        kernel: Kernel::shade_light,
        group_count: groups(lit.paths.len()),
        uniforms: &[
            &lit.exponent(),
            cast_slice(&[*light]),
            &[lit.camera.sample_count, bounce, 0, 0],
        ],
        reads: &[
            vertices,
            indices,
            normals,
            cast_slice(&lit.scene.mesh.materials),
            cast_slice(&lit.materials),
            cast_slice(&lit.hits),
            cast_slice(&lit.paths),
        ],
        outputs: &[cast_slice(&nothing)],
    }
    .run(gpu);
    stored.concat()
}

#[test]
fn camera_rays_are_those_of_core() {
    let Some(gpu) = gpu() else { return };
    for lit in Lit::all() {
        for first in [0u32, 64, 7000] {
            let expected = |first: u32| -> Vec<Path> {
                let samples =
                    (first..first + 5000).map(|thread| lit.camera.sample_of_thread(thread));
                samples.map(|sample| lit.paths[sample as usize]).collect()
            };
            let stored = Dispatch {
                kernel: Kernel::camera_rays,
                group_count: groups(5000),
                uniforms: &[&lit.exponent(), &[first, 0, 0, 0]],
                reads: &[bytes_of(&lit.camera)],
                outputs: &[&[0; 5000 * size_of::<Path>()]],
            }
            .run(gpu);
            done(close_words(&stored[0], &expected(first)));
            assert!(close_words(&stored[0], &expected(first + 1)).is_err());
        }
    }
}

#[test]
fn light_on_hits_is_that_of_core() {
    let Some(gpu) = gpu() else { return };
    for lit in Lit::all() {
        for light in &lit.lights {
            let expected = lit.shadows(light, 0);
            assert!(
                expected
                    .iter()
                    .filter(|shadow| shadow.is_possible())
                    .count()
                    > 500
            );
            let stored = shade_light(gpu, &lit, light, 0);
            done(close_words(&stored, &expected));
            // After a mirror other points of an area light are sampled.
            let mirrored = shade_light(gpu, &lit, light, 1);
            done(close_words(&mirrored, &lit.shadows(light, 1)));
            assert_eq!(mirrored == stored, light.shape == NO_EXTENT);

            // The negative control: a slightly stronger light.
            let mut stronger = *light;
            stronger.color = light.color.map(|x| x * 1.001);
            assert!(close_words(&stored, &lit.shadows(&stronger, 0)).is_err());
        }
    }
}

#[test]
fn shadow_rays_let_light_through_as_in_core() {
    let Some(gpu) = gpu() else { return };
    let mut blocked_count = 0;
    for lit in Lit::all() {
        let (nodes, triangles) = (lit.bvh.node_source(), lit.bvh.triangle_source());
        for light in &lit.lights {
            let shadows = lit.shadows(light, 0);
            let mut ray_count = 0;
            let expected: Vec<Path> = lit
                .paths
                .iter()
                .zip(&shadows)
                .map(|(path, shadow)| {
                    if !shadow.is_possible() {
                        return *path;
                    }
                    ray_count += 1;
                    let ray = &shadow.ray;
                    if trace::any_hit(&nodes, &triangles, ray, 0, &Skip(shadow.skip)) {
                        blocked_count += 1;
                        return *path;
                    }
                    path.with_light(shadow.radiance.into())
                })
                .collect();
            let stored = Dispatch {
                kernel: Kernel::trace_shadows,
                group_count: groups(shadows.len()),
                uniforms: &[],
                reads: &[
                    cast_slice(lit.bvh.nodes()),
                    cast_slice(lit.bvh.leaf_triangles()),
                    cast_slice(&shadows),
                ],
                outputs: &[cast_slice(&lit.paths), &[0; 24]],
            }
            .run(gpu);
            done(close_words(&stored[0], &expected));
            done(same_bits(
                &answers::<u32>(&stored[1]),
                &[ray_count, 0, 0, 0, 0, 0],
            ));
            assert!(
                close_words(&stored[0], &lit.paths).is_err(),
                "no light at all"
            );
        }
    }
    assert!(blocked_count > 100, "{blocked_count} are blocked");
}

#[test]
fn counters_of_rays_carry_into_their_second_word() {
    let Some(gpu) = gpu() else { return };
    let lit = Lit::new(hall_of_mirrors());
    let hit_count = lit.hits.iter().filter(|hit| hit.is_hit()).count() as u32;
    let stored = Dispatch {
        kernel: Kernel::trace_paths,
        group_count: groups(lit.paths.len()),
        uniforms: &[],
        reads: &[
            cast_slice(lit.bvh.nodes()),
            cast_slice(lit.bvh.leaf_triangles()),
            cast_slice(&lit.paths),
        ],
        outputs: &[
            &vec![0; size_of_val(lit.hits.as_slice())],
            cast_slice(&[u32::MAX - 5, 7, u32::MAX, 8, 0, 0]),
        ],
    }
    .run(gpu);
    let expected = [lit.paths.len() as u32 - 6, 8, hit_count - 1, 9, 0, 0];
    done(same_bits(&answers::<u32>(&stored[1]), &expected));
    if slimbvh_tests::gpu::is_software(gpu) {
        done(same_bits(&answers::<Hit>(&stored[0]), &lit.hits));
    } else {
        done(slimbvh_tests::parity::close_hits(
            &answers(&stored[0]),
            &lit.hits,
        ));
    }
}

#[test]
fn scattered_paths_are_those_of_core() {
    let Some(gpu) = gpu() else { return };
    for lit in Lit::all() {
        let scatter = |(path, hit): (&Path, &Hit)| {
            if !hit.is_hit() {
                return path.escaped(&lit.environment);
            }
            let (surface, material) = lit.surface(path, hit);
            path.with_light(ambient_light(&material, &lit.environment))
                .scattered(&surface, &material, hit.primitive)
        };
        let expected: Vec<Path> = lit.paths.iter().zip(&lit.hits).map(scatter).collect();
        let [vertices, indices, normals] = lit.mesh();
        let stored = Dispatch {
            kernel: Kernel::shade_scatter,
            group_count: groups(lit.paths.len()),
            uniforms: &[&lit.exponent()],
            reads: &[
                vertices,
                indices,
                normals,
                cast_slice(&lit.scene.mesh.materials),
                cast_slice(&lit.materials),
                bytes_of(&lit.environment),
                cast_slice(&lit.hits),
            ],
            outputs: &[cast_slice(&lit.paths)],
        }
        .run(gpu);
        done(close_words(&stored[0], &expected));
        assert!(close_words(&stored[0], &lit.paths).is_err());
    }
}
