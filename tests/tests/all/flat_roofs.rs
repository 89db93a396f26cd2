//! Rays that leave a flat roof upward meet nothing. Coded boxes that reached above the roof would let them in.

use slimbvh::internals::Random;
use slimbvh::{BuildConfig, Builder, Bvh, Mesh, MeshCodec, NodeCodec, WideStore};
use slimbvh_core::Ray;
use slimbvh_core::RayEnds;
use slimbvh_core::ray::PreparedRay;
use slimbvh_core::trace::{ClosestHit, Counted};

/// Sides of the roof's square, and how high it is: no multiple of any lattice's step.
const SIDE: u16 = 40;
const HEIGHT: f32 = 0.3;

/// A roof of squares over [0, 1]² with small triangles below it, of which none reaches up to it.
fn house() -> Mesh {
    let mut mesh = Mesh::default();
    let at = |i: u16| f32::from(i) / f32::from(SIDE);
    for z in 0..=SIDE {
        for x in 0..=SIDE {
            mesh.vertices.push([at(x), HEIGHT, at(z)]);
        }
    }
    let row = u32::from(SIDE) + 1;
    for z in 0..u32::from(SIDE) {
        for x in 0..u32::from(SIDE) {
            let i = z * row + x;
            mesh.indices.push([i, i + row, i + 1]);
            mesh.indices.push([i + 1, i + row, i + row + 1]);
        }
    }
    let mut random = Random::new(7);
    for _ in 0..3000 {
        let first = mesh.vertices.len() as u32;
        let place = [random.unit(), random.unit() * (HEIGHT - 0.1), random.unit()];
        for _ in 0..3 {
            let off = [random.unit(), random.unit(), random.unit()].map(|x| 0.05 * x);
            mesh.vertices.push([0, 1, 2].map(|i| place[i] + off[i]));
        }
        mesh.indices.push([first, first + 1, first + 2]);
    }
    mesh
}

/// The same with a tower beside it.
fn house_and_tower() -> Mesh {
    let mut mesh = house();
    let mut random = Random::new(8);
    for _ in 0..500 {
        let first = mesh.vertices.len() as u32;
        let height = 3.0 * random.unit();
        for _ in 0..3 {
            let off = [random.unit(), random.unit(), random.unit()].map(|x| 0.1 * x);
            mesh.vertices
                .push([1.5 + off[0], height + off[1], 0.5 + off[2]]);
        }
        mesh.indices.push([first, first + 1, first + 2]);
    }
    mesh
}

const RAY_COUNT: u32 = 2000;

/// Rays to the sun from just above the roof, away from the tower.
fn sun_rays() -> Vec<Ray> {
    let mut random = Random::new(9);
    let ray = |_| {
        Ray::new(
            [random.unit(), HEIGHT + 1e-4, random.unit()],
            [-0.3, 0.8, 0.5],
        )
    };
    (0..RAY_COUNT).map(ray).collect()
}

/// How many nodes all rays open, and how many triangles they test.
fn work(bvh: &Bvh) -> [u32; 2] {
    let mut sums = [0; 2];
    for ray in sun_rays() {
        let ray = PreparedRay::new(&ray, bvh.scene_exponent());
        let mut counted = Counted::new(ClosestHit::new(ray.t_max));
        bvh.collect(&ray, &RayEnds::NONE, &mut counted);
        assert!(!counted.inner.hit.is_hit());
        sums[0] += counted.node_count;
        sums[1] += counted.triangle_count;
    }
    sums
}

fn built(mesh: &Mesh, nodes: NodeCodec, mesh_codec: MeshCodec) -> Bvh {
    let config = BuildConfig {
        nodes,
        mesh: mesh_codec,
        ..BuildConfig::default()
    };
    Builder::new(config).build(mesh).expect("the mesh is sound")
}

/// On a lattice of about a thousandth of the scene, onto which vertices move.
const LATTICE: MeshCodec = MeshCodec::Lattice { step_exponent: -10 };

#[test]
fn rays_that_leave_a_flat_roof_open_no_node() {
    let mesh = house();
    let mut moved = house();
    moved.snap(-10);
    for (nodes, mesh, codec) in [
        (WideStore::Exact, &mesh, MeshCodec::F32),
        (WideStore::Exact, &moved, LATTICE),
        (WideStore::Packed, &moved, LATTICE),
    ] {
        let bvh = built(mesh, NodeCodec::Wide(nodes), codec);
        // The lattice moves the roof, by half a step at most: rays may begin below it.
        let above = codec == MeshCodec::F32 || moved.vertices[0][1] < HEIGHT;
        if above {
            assert_eq!(work(&bvh), [0; 2], "{nodes:?} {codec:?}");
        }
    }
    // The negative control: nodes in full are not asked for the root's box.
    let [nodes, _] = work(&built(
        &mesh,
        NodeCodec::Wide(WideStore::Full),
        MeshCodec::F32,
    ));
    assert!(nodes >= RAY_COUNT, "{nodes}");
}

#[test]
fn a_roof_in_a_larger_scene_is_as_flat() {
    let mesh = house_and_tower();
    let full = work(&built(
        &mesh,
        NodeCodec::Wide(WideStore::Full),
        MeshCodec::F32,
    ));
    let exact = work(&built(
        &mesh,
        NodeCodec::Wide(WideStore::Exact),
        MeshCodec::F32,
    ));
    // In the node that holds the tower, too, the roof ends a cell too high: rays open the house's own node, whose side is exact.
    assert!(
        exact[0] <= full[0] + RAY_COUNT * 11 / 10,
        "{exact:?} {full:?}"
    );
    assert!(exact[1] <= full[1] + RAY_COUNT / 20, "{exact:?} {full:?}");
    // The negative control: planes of nodes that know no exact side let rays in, down to triangles.
    let q8 = NodeCodec::Lattice(slimbvh::LatticeBits::Q8);
    let [_, tested] = work(&built(&mesh, q8, MeshCodec::F32));
    assert!(tested > exact[1] + 100, "{tested} {exact:?}");
}
