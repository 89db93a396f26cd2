//! Traces one ray against two triangles on the CPU.

use slimbvh::{BuildConfig, Builder, Mesh, MeshError, Ray};

fn main() -> Result<(), MeshError> {
    let mesh = Mesh {
        vertices: vec![
            [0.0, 0.0, 0.0],
            [4.0, 0.0, 0.0],
            [0.0, 2.0, 0.0],
            [0.0, 0.0, -1.0],
        ],
        indices: vec![[0, 1, 2], [0, 1, 3]],
        ..Mesh::default()
    };
    let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;

    let hit = bvh.closest_hit(Ray::new([1.0, 0.5, 3.0], [0.0, 0.0, -1.0]));
    println!(
        "triangle {} at t = {}, u = {}, v = {}",
        hit.primitive, hit.t, hit.u, hit.v
    );
    assert_eq!((hit.primitive, hit.t, hit.u, hit.v), (0, 3.0, 0.25, 0.25));
    Ok(())
}
