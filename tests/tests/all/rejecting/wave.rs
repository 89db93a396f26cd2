//! The renderer's rays one by one, made and traced with the functions of core that the renderer calls. The picture equals the
//! renderer's to the last bit, which shows that the rays are the same.

use slimbvh::{Picture, RenderSettings, Scene, Tree, Trees};
use slimbvh_core::camera::Camera;
use slimbvh_core::classify::{FacingFilter, Sides};
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::sampling::Draw;
use slimbvh_core::shade::{
    Environment, Light, Material, Path, ambient_light, direct_light, mean_radiance,
};
use slimbvh_core::snap::leaf_triangle;
use slimbvh_core::surface::Surface;
use slimbvh_core::trace::Skip;
use slimbvh_core::{Hit, Ray, Vec3, trace};
use slimbvh_tests::gpu::done;

/// A kind of rays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RayKind {
    /// Camera rays.
    Camera,
    /// Shadow rays to the light with this index.
    Light(usize),
}

/// A camera ray or a shadow ray, at the scene's magnitude, and the tracer's answer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cast {
    /// The camera, or the light.
    pub kind: RayKind,
    /// Number of its sample.
    pub sample: u32,
    /// The ray as it was traced.
    pub ray: Ray,
    /// The primitive that it starts on.
    pub skip: u32,
    /// The closest hit, also for a shadow ray: it exists exactly if there is any hit.
    pub hit: Hit,
}

/// The inputs of a picture.
struct Stage<'a> {
    scene: &'a Scene,
    scale: PowerOfTwo,
    camera: Camera,
    lights: Vec<Light>,
    materials: Vec<Material>,
    environment: Environment,
}

/// All camera rays and all shadow rays of a plan's picture, and the picture.
pub fn cast(scene: &Scene, trees: &Trees, settings: &RenderSettings) -> (Vec<Cast>, Picture) {
    let stage = Stage::new(scene, trees, settings);
    let [width, height] = settings.size;
    let mut casts = Vec::new();
    let mut paths = Vec::new();
    for sample in 0..width * height * settings.sample_count {
        paths.push(stage.follow(sample, trees, settings.mirror_depth, &mut casts));
    }
    let count = settings.sample_count;
    let pixel = |pixel: u32| mean_radiance(&paths, pixel * count, count).to_array();
    let picture = Picture {
        width,
        height,
        pixels: (0..width * height).map(pixel).collect(),
    };
    (casts, picture)
}

impl<'a> Stage<'a> {
    fn new(scene: &'a Scene, trees: &Trees, settings: &RenderSettings) -> Self {
        let scale = PowerOfTwo::new(trees.primary.bvh.scene_exponent());
        let camera = &scene.cameras[0];
        let lights = scene.lights.iter().enumerate();
        Self {
            scene,
            scale,
            camera: done(camera.to_core(settings.size, settings.sample_count)).scaled(&scale),
            lights: lights
                .map(|(index, light)| done(light.to_core(index)).scaled(&scale))
                .collect(),
            materials: scene.core_materials(),
            environment: Scene::environment(camera.up),
        }
    }

    /// Traces a sample's path to its end.
    fn follow(&self, sample: u32, trees: &Trees, mirror_depth: u32, casts: &mut Vec<Cast>) -> Path {
        let mut path = Path::new(self.camera.ray(sample), sample);
        let mut hit = self.closest_hit(&trees.primary, &path.ray, path.skip);
        casts.push(Cast {
            kind: RayKind::Camera,
            sample,
            ray: path.ray,
            skip: path.skip,
            hit,
        });
        for depth in 0..=mirror_depth {
            if !hit.is_hit() {
                return path.escaped(&self.environment);
            }
            let (surface, material) = self.surface(&path, &hit);
            for (index, (light, tree)) in self.lights.iter().zip(&trees.lights).enumerate() {
                let draw = Draw {
                    sample: path.sample,
                    sample_count: self.camera.sample_count,
                    bounce: depth,
                };
                let light = light.sampled(&draw);
                let shadow = direct_light(&surface, hit.primitive, &material, &light);
                if !shadow.is_possible() {
                    continue;
                }
                let blocker = self.closest_hit(tree, &shadow.ray, shadow.skip);
                let is_lit = !self.any_hit(tree, &shadow.ray, shadow.skip);
                assert_eq!(is_lit, !blocker.is_hit());
                if is_lit {
                    path = path.with_light(Vec3::from_array(shadow.radiance));
                }
                casts.push(Cast {
                    kind: RayKind::Light(index),
                    sample,
                    ray: shadow.ray,
                    skip: shadow.skip,
                    hit: blocker,
                });
            }
            path = path
                .with_light(ambient_light(&material, &self.environment))
                .scattered(&surface, &material, hit.primitive);
            let Some(bvh) = trees.mirrors else { break };
            if !path.is_alive() || depth == mirror_depth {
                break;
            }
            hit = self.closest_hit(&Tree::all(bvh), &path.ray, path.skip);
        }
        path
    }

    fn closest_hit(&self, tree: &Tree, ray: &Ray, skip: u32) -> Hit {
        let (nodes, triangles) = (tree.bvh.node_source(), tree.bvh.triangle_source());
        match self.rule(tree, skip) {
            None => trace::closest_hit(&nodes, &triangles, ray, 0, &Skip(skip)),
            Some(rule) => trace::closest_hit(&nodes, &triangles, ray, 0, &rule),
        }
    }

    fn any_hit(&self, tree: &Tree, ray: &Ray, skip: u32) -> bool {
        let (nodes, triangles) = (tree.bvh.node_source(), tree.bvh.triangle_source());
        match self.rule(tree, skip) {
            None => trace::any_hit(&nodes, &triangles, ray, 0, &Skip(skip)),
            Some(rule) => trace::any_hit(&nodes, &triangles, ray, 0, &rule),
        }
    }

    fn rule<'b>(&self, tree: &Tree<'b>, skip: u32) -> Option<FacingFilter<Sides<'b>>> {
        let (sides, target) = tree.rule?;
        Some(FacingFilter {
            skip,
            sides,
            target: target.scaled(&self.scale),
        })
    }

    fn surface(&self, path: &Path, hit: &Hit) -> (Surface, Material) {
        let mesh = &self.scene.mesh;
        let primitive = hit.primitive as usize;
        let triangle = leaf_triangle(hit.primitive, &mesh.triangles(), &self.scale).triangle();
        let normals = mesh.indices[primitive].map(|corner| {
            let normal = mesh.normals.get(corner as usize);
            normal.map_or(Vec3::ZERO, |&normal| Vec3::from_array(normal))
        });
        let material = mesh.materials.get(primitive).map_or(0, |&m| m as usize);
        let direction = Vec3::from_array(path.ray.direction);
        let surface = Surface::new(triangle, hit, direction, normals);
        (surface, self.materials[material])
    }
}
