//! Queries with filters, of all trees: the answers of brute force over all triangles, bit for bit.

use proptest::array::uniform2;
use proptest::collection::vec;
use proptest::prelude::*;
use slimbvh::generate::terrain;
use slimbvh::{
    BuildConfig, Bvh, Camera, CodeBits, Collector, Hit, Mesh, MeshCodec, NO_PRIMITIVE, Picture,
    PreparedRay, Ray, RayEnds, RenderSettings, Renderer, Scene, SurfaceRay, Tree, View,
};
use slimbvh_core::classify::{FacingFilter, Sides};
use slimbvh_core::orientation::Target;
use slimbvh_core::trace::{BruteForce, EndsAnd, EndsFilter, LeafTriangles, PreparedEnds, traverse};
use slimbvh_core::view::primitive_color;
use slimbvh_tests::rays::{RayRecipe, any_ray};
use slimbvh_tests::strategies::any_mesh;
use slimbvh_tests::{build, build_as, cases};

/// Which triangles a whole tree's rays may hit.
type Rule<'a> = Option<(Sides<'a>, Target)>;

/// All hits, in no order.
struct All {
    hits: Vec<Hit>,
    t_max: f32,
}

impl Collector for All {
    fn limit(&self) -> f32 {
        self.t_max
    }

    fn offer(&mut self, hit: Hit) {
        self.hits.push(hit);
    }
}

/// All hits of a ray among all triangles, sorted. The target is at the scene's magnitude.
fn brute(plain: &Bvh, ray: &SurfaceRay, rule: Rule) -> Vec<Hit> {
    let exponent = plain.scene_exponent();
    let prepared = PreparedRay::new(&ray.ray, exponent);
    let everything = Sides {
        components: &[],
        sides: &[],
    };
    let (sides, target) = rule.unwrap_or((everything, Target::position([0.0; 3])));
    let facing = FacingFilter {
        skip: NO_PRIMITIVE,
        sides,
        target,
    };
    let filter = EndsAnd {
        ends: EndsFilter(PreparedEnds {
            ray: &prepared,
            ends: &ray.ends,
            scene_exponent: exponent,
        }),
        filter: &facing,
    };
    let mut all = All {
        hits: Vec::new(),
        t_max: prepared.t_max,
    };
    let triangles = plain.leaf_triangles();
    let nodes = BruteForce(triangles.len() as u32);
    traverse(
        &nodes,
        &LeafTriangles(triangles),
        &prepared,
        &filter,
        &mut all,
    );
    let order = |a: &Hit, b: &Hit| a.t.total_cmp(&b.t).then(a.primitive.cmp(&b.primitive));
    all.hits.sort_by(order);
    all.hits.iter().map(|&hit| prepared.restore(hit)).collect()
}

fn bits(hits: &[Hit]) -> Vec<[u32; 4]> {
    hits.iter().map(|hit| bytemuck::cast(*hit)).collect()
}

/// A mask, and an alpha test.
fn is_opaque(hit: &Hit) -> bool {
    hit.primitive % 3 != 1 && ((hit.u * 16.0) as u32).is_multiple_of(2)
}

/// Compares all queries of a tree with the sorted hits of each ray.
fn compare(tree: &Tree, rays: &[SurfaceRay], expected: &[Vec<Hit>]) -> Result<(), TestCaseError> {
    let first = |hits: &[Hit]| hits.first().copied().unwrap_or(Hit::MISS);
    let (mut hits, mut found) = (Vec::new(), Vec::new());
    tree.closest_hits(rays, &mut hits);
    tree.any_hits(rays, &mut found);
    for (i, (ray, expected)) in rays.iter().zip(expected).enumerate() {
        let closest = first(expected);
        prop_assert_eq!(
            bits(&[tree.closest_hit(ray)]),
            bits(&[closest]),
            "{:?}",
            ray
        );
        prop_assert_eq!(bits(&[hits[i]]), bits(&[closest]), "{:?}", ray);
        prop_assert_eq!([tree.any_hit(ray), found[i]], [closest.is_hit(); 2]);
        prop_assert_eq!(bits(&tree.all_hits(ray)), bits(expected));
        let mut nearest = [Hit::MISS; 3];
        for (to, hit) in nearest.iter_mut().zip(expected) {
            *to = *hit;
        }
        prop_assert_eq!(bits(&tree.nearest_hits::<3>(ray)), bits(&nearest));
        let opaque: Vec<Hit> = expected.iter().copied().filter(is_opaque).collect();
        let closest = tree.closest_hit_where(ray, is_opaque);
        prop_assert_eq!(bits(&[closest]), bits(&[first(&opaque)]));
        prop_assert_eq!(tree.any_hit_where(ray, is_opaque), !opaque.is_empty());
    }
    Ok(())
}

/// A ray with ends: primitives by a share of the mesh, errors by one of its size.
fn ends() -> impl Strategy<Value = [(Option<u32>, f32); 2]> {
    let error = prop_oneof![2 => Just(-1.0f32), 1 => Just(0.0), 2 => (-8f32..-1.0).prop_map(|e| 10f32.powf(e))];
    uniform2((proptest::option::of(any::<u32>()), error))
}

fn cook(mesh: &Mesh, recipe: &RayRecipe, [a, b]: [(Option<u32>, f32); 2]) -> SurfaceRay {
    let size = mesh.vertices.as_flattened().iter();
    let size = size.fold(0.0f32, |a, x| a.max(x.abs()));
    let skip = |share: Option<u32>| {
        let count = mesh.indices.len().max(1) as u32;
        share.map_or(NO_PRIMITIVE, |share| share % count)
    };
    let error = |error: f32| if error < 0.0 { error } else { error * size };
    SurfaceRay {
        ray: recipe.cook(mesh),
        ends: RayEnds {
            skip: [skip(a.0), skip(b.0)],
            error: [error(a.1), error(b.1)],
        },
    }
}

proptest! {
    #![proptest_config(cases(96))]

    #[test]
    fn filters_agree_with_brute_force(mesh in any_mesh(), recipes in vec((any_ray(), ends()), 12), side in -1..=1i32, eye in proptest::array::uniform3(-2f32..2.0)) {
        let plain = build(&mesh, CodeBits::Bits30);
        let rays: Vec<_> = recipes.iter().map(|(recipe, ends)| cook(&mesh, recipe, *ends)).collect();
        let components = vec![0; mesh.indices.len()];
        let sides = Sides { components: &components, sides: &[side] };
        // Exact at both magnitudes.
        let unit = 2f32.powi(-plain.scene_exponent().clamp(-100, 100));
        let target = Target::position(eye.map(|x| x * unit));
        let scaled = target.scaled(&slimbvh_core::float::PowerOfTwo::new(plain.scene_exponent()));
        let of = |rule: Rule| -> Vec<_> { rays.iter().map(|ray| brute(&plain, ray, rule)).collect() };
        let (all, facing) = (of(None), of(Some((sides, scaled))));
        for nodes in MeshCodec::F32.nodes() {
            let bvh = build_as(&mesh, BuildConfig { nodes, ..BuildConfig::default() });
            compare(&Tree::all(&bvh), &rays, &all)?;
            compare(&Tree { bvh: &bvh, rule: Some((sides, target)) }, &rays, &facing)?;
            for (ray, expected) in rays.iter().zip(&all) {
                prop_assert_eq!(bits(&bvh.all_hits(ray)), bits(expected));
            }
        }
    }
}

/// Negative controls: each filter changes some answer.
#[test]
fn each_filter_changes_answers() {
    let mesh = terrain(8.0, 16, 7);
    let bvh = build(&mesh, CodeBits::Bits30);
    let components = vec![0; mesh.indices.len()];
    let sides = Sides {
        components: &components,
        sides: &[1],
    };
    let below = Target::position([0.0, -100.0, 0.0]);
    let tree = Tree {
        bvh: &bvh,
        rule: Some((sides, below)),
    };
    let mut counts = [0; 5];
    for i in 0..100u16 {
        let (x, z) = (f32::from(i % 10) * 0.6 - 3.0, f32::from(i / 10) * 0.6 - 3.0);
        let ray = Ray::new([x, 9.0, z], [0.01, -1.0, 0.02]);
        let hit = bvh.closest_hit(ray);
        assert!(hit.is_hit());
        // Nothing faces a point below.
        counts[0] += usize::from(!tree.closest_hit(ray).is_hit());
        counts[1] += usize::from(bvh.closest_hit_where(ray, is_opaque) != hit);
        let ray = |ends| SurfaceRay { ray, ends };
        let skipped = ray(RayEnds::skipping(hit.primitive));
        counts[2] += usize::from(bvh.closest_hit(skipped) != hit);
        // The ball around the origin reaches down to the ground.
        let ends = RayEnds {
            error: [20.0, -1.0],
            ..RayEnds::NONE
        };
        counts[3] += usize::from(!bvh.any_hit(ray(ends)));
        // Both ends are above it.
        let mut short = ray(RayEnds {
            error: [0.0; 2],
            ..RayEnds::NONE
        });
        short.ray.t_max = hit.t * (1.0 - 1e-3);
        assert!(!bvh.any_hit(short));
        short.ray.t_max = hit.t * (1.0 + 1e-3);
        counts[4] += usize::from(bvh.any_hit(short));
    }
    assert!(counts[1] > 20 && counts[1] < 100, "{counts:?}");
    assert_eq!(
        [counts[0], counts[2], counts[3], counts[4]],
        [100; 4],
        "{counts:?}"
    );
}

/// A pixel's ray hits the triangle that a picture shows there. Negative control: its neighbour's does not always.
#[test]
fn rays_of_pixels_hit_what_the_picture_shows() {
    let mut scene = Scene {
        mesh: terrain(8.0, 64, 7),
        ..Scene::default()
    };
    let [width, height] = [48, 27];
    let bvh = build(&scene.mesh, CodeBits::Bits30);
    let bounds = bvh.bounds().expect("there are triangles");
    let camera = Camera::facing(&bounds, width as f32 / height as f32);
    scene.cameras = vec![camera];
    let settings = RenderSettings {
        size: [width, height],
        sample_count: 1,
        view: View::Primitives,
        ..RenderSettings::default()
    };
    let mut picture = Picture::default();
    Renderer::new()
        .render(&scene, &bvh, &settings, &mut picture, |_| {})
        .expect("the scene can be rendered");
    let (mut hit_count, mut beside) = (0, 0);
    for (pixel, color) in (0..width * height).zip(&picture.pixels) {
        let [x, y] = [pixel % width, pixel / width];
        let shows = |x: u32| {
            let ray = camera.ray([x, y], [width, height]).expect("a sound camera");
            let hit = bvh.closest_hit(ray);
            hit.is_hit()
                .then(|| primitive_color(hit.primitive).to_array())
        };
        if let Some(shown) = shows(x) {
            assert_eq!(shown, *color, "{x} {y}");
            hit_count += 1;
            beside += usize::from(shows(x + 1) != Some(*color));
        }
        let middle = camera.ray_at([x as f32 + 0.5, y as f32 + 0.5], [width, height]);
        assert_eq!(middle, camera.ray([x, y], [width, height]));
    }
    assert!(hit_count > 200 && beside > 100, "{hit_count} {beside}");
}
