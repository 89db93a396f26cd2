//! Every codec and kind of tree over a mesh of one's own, measured: build time, bytes, expected and counted cost of rays.
//!
//! `cargo run --release --example researcher -- model.ply`

use slimbvh::collect::{ClosestHit, Counted};
use slimbvh::generate::{TorusKnot, torus_knot};
use slimbvh::scene::{LoadOptions, load};
use slimbvh::{BuildConfig, Builder, Bvh, Camera, CodeBits, Mesh, MeshCodec, PreparedRay};
use slimbvh::{RayEnds, TreeKind};
use std::error::Error;
use std::path::Path;

const SIZE: [u32; 2] = [160, 120];

fn main() -> Result<(), Box<dyn Error>> {
    let mut mesh = match std::env::args().nth(1) {
        Some(file) => load(Path::new(&file), &LoadOptions::default())?.mesh,
        None => torus_knot(&TorusKnot::default()),
    };
    // Codecs on the lattice need vertices on it; the finest moves them least.
    let step_exponent = mesh.finest_step();
    let moved = mesh.snap(step_exponent);
    let count = mesh.indices.len();
    println!("{count} triangles, moved by at most {moved:e}\n");
    println!("nodes    triangles  tree       build ms  bytes/tri   SAH  nodes/ray  boxes/ray");

    let trees = [
        (TreeKind::Radix, "radix"),
        (TreeKind::Clustered, "clustered"),
    ];
    for codec in MeshCodec::ALL.map(|codec| codec.with_step(Some(step_exponent))) {
        for (nodes, (tree, kind)) in codec
            .nodes()
            .flat_map(|nodes| trees.map(|tree| (nodes, tree)))
        {
            let (code_bits, mesh_codec) = (CodeBits::Bits63, codec);
            let mut builder = Builder::new(BuildConfig {
                code_bits,
                tree,
                nodes,
                mesh: mesh_codec,
            });
            let mut bvh = builder.build(&mesh)?;
            // The first build allocates; this one is timed.
            let stages = builder.build_into(&mesh, &mut bvh)?;
            let bytes = (bvh.node_bytes() + bvh.triangle_bytes()) as f64 / count as f64;
            let [opened, boxes] = counts(&bvh, &mesh)?;
            println!(
                "{:<8} {:<10} {kind:<10} {:>8.2} {bytes:>10.1} {:>5.0} {opened:>10.2} {boxes:>10.2}",
                nodes.name(),
                codec.name(),
                stages.total().as_secs_f64() * 1e3,
                bvh.sah_cost(),
            );
        }
    }
    Ok(())
}

/// Nodes opened and boxes tested by a picture's rays, a ray.
fn counts(bvh: &Bvh, mesh: &Mesh) -> Result<[f64; 2], Box<dyn Error>> {
    let bounds = mesh.bounds().ok_or("there are no triangles")?;
    let camera = Camera::facing(&bounds, SIZE[0] as f32 / SIZE[1] as f32);
    let mut sums = [0.0; 2];
    for pixel in (0..SIZE[1]).flat_map(|y| (0..SIZE[0]).map(move |x| [x, y])) {
        let ray = PreparedRay::new(&camera.ray(pixel, SIZE)?, bvh.scene_exponent());
        let mut counted = Counted::new(ClosestHit::new(ray.t_max));
        bvh.collect(&ray, &RayEnds::NONE, &mut counted);
        sums[0] += f64::from(counted.node_count);
        sums[1] += f64::from(counted.box_count);
    }
    Ok(sums.map(|sum| sum / f64::from(SIZE[0] * SIZE[1])))
}
