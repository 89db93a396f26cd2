//! Points on triangles that a codec has moved.

use glam::Vec3;
use slimbvh::{BuildConfig, Mesh, MeshCodec, NodeCodec, Ray};
use slimbvh_tests::build_as;
use slimbvh_tests::closed::small_torus_knot;
use slimbvh_tests::random::Random;

/// A mesh with smooth normals, as they are.
fn knot() -> Mesh {
    let mut mesh = small_torus_knot();
    mesh.normals = vec![[0.0, 0.0, 1.0]; mesh.vertices.len()];
    mesh
}

/// In 10 bits a triangle lies beside the mesh's. The point is on the triangle that the rays hit: the eye that sees it is seen from it.
/// Negative control: points of the mesh's own triangles are far from where the rays hit, on average.
#[test]
fn points_lie_on_the_triangles_that_rays_hit() {
    let mesh = knot();
    let coded = build_as(
        &mesh,
        BuildConfig {
            nodes: NodeCodec::Paper10,
            mesh: MeshCodec::Leaf10,
            ..BuildConfig::default()
        },
    );
    let plain = build_as(&mesh, BuildConfig::default());
    let mut random = Random::new(5);
    let (mut seen, mut off_coded, mut off_mesh) = (0, 0.0, 0.0);
    for _ in 0..2000 {
        let [x, y, z] = [0; 3].map(|_| 2.0 * random.unit() - 1.0);
        let eye = Vec3::new(x, y, z).normalize_or(Vec3::X) * 4.0;
        let off = [0; 3].map(|_| random.unit() - 0.5);
        let ray = Ray::new(eye.to_array(), (Vec3::from(off) - eye).to_array());
        let hit = coded.closest_hit(ray);
        let Some(point) = coded.surface(&mesh, ray, &hit) else {
            assert!(!hit.is_hit());
            continue;
        };
        let along = eye + (Vec3::from(off) - eye) * hit.t;
        let normal = Vec3::from(point.normal);
        let shading = Vec3::from(point.shading_normal);
        assert!(normal.dot(eye - along) >= -1e-5 && shading.dot(normal) > 0.0);
        assert!(shading == normal || shading.z.abs() > 0.999, "{point:?}");
        assert!(
            !coded.any_hit(Ray::between(point, eye.to_array())),
            "{point:?}"
        );
        seen += 1;
        let of_mesh = plain
            .surface(&mesh, ray, &hit)
            .expect("the primitive is there");
        off_coded += (along - Vec3::from(point.position)).length();
        off_mesh += (along - Vec3::from(of_mesh.position)).length();
    }
    println!("{seen} points, off by {off_coded} in all, those of the mesh by {off_mesh}");
    assert!(
        seen > 300 && off_coded < 1e-5 * seen as f32,
        "{seen} {off_coded}"
    );
    assert!(off_mesh > 10.0 * off_coded, "{off_mesh} {off_coded}");
}

/// No point for a miss, nor for another mesh.
#[test]
fn no_hit_has_no_point() {
    let mesh = knot();
    let bvh = build_as(&mesh, BuildConfig::default());
    let ray = Ray::new([0.0, 0.0, 9.0], [0.0, 0.0, 1.0]);
    let miss = bvh.closest_hit(ray);
    assert!(!miss.is_hit() && bvh.surface(&mesh, ray, &miss).is_none());
    let [x, y, _] = mesh.vertices[0];
    let ray = Ray::new([x, y, 9.0], [0.0, 0.0, -1.0]);
    let hit = bvh.closest_hit(ray);
    assert!(hit.is_hit() && bvh.surface(&mesh, ray, &hit).is_some());
    let mut other = mesh.clone();
    other.indices.pop();
    assert!(bvh.surface(&other, ray, &hit).is_none());
}
