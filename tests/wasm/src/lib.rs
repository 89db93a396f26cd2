//! The library's answers as checksums, one a step: the same on every target, with rayon and without.
//!
//! The mesh comes from generators without trigonometry and has no normals: the last bits of a sine depend on the platform's
//! mathematical library.

use slimbvh::animate::Update;
use slimbvh::generate::{append, icosphere, terrain};
use slimbvh::reduce::{PlanConfig, Reduce, Switches};
use slimbvh::scene::slim;
use slimbvh::{
    BuildConfig, Builder, Bvh, Camera, Change, Cpu, FrameConfig, Frames, Hit, Light, Material,
    Mesh, MeshCodec, NodeCodec, Output, Picture, Projection, Ray, RenderSettings, Scene, WideStore,
};
use std::error::Error;

/// A step: its answers as bytes, for a mesh.
type Step = fn(&Mesh) -> Result<Vec<u8>, Box<dyn Error>>;

/// The steps, in order.
const STEPS: &[Step] = &[
    tree,
    single_rays,
    many_rays,
    wide_tree,
    refit,
    reduced_picture,
    saved,
];

/// The number of steps.
#[unsafe(no_mangle)]
pub extern "C" fn step_count() -> u32 {
    STEPS.len() as u32
}

/// The checksum of a step's answers; 0 if there is no such step, or it failed. With a nonzero `fault` the mesh is half a
/// unit higher, so that every checksum must differ.
#[unsafe(no_mangle)]
pub extern "C" fn checksum(step: u32, fault: u32) -> u64 {
    let mut mesh = terrain(8.0, 24, 5);
    for i in 0..4_u16 {
        let center = [f32::from(i) - 1.5, 2.5, 0.5 * f32::from(i) - 1.0];
        append(&mut mesh, icosphere(center.into(), 0.625, 3), "ball", 0);
    }
    mesh.normals.clear();
    if fault != 0 {
        mesh.vertices.iter_mut().for_each(|vertex| vertex[1] += 0.5);
    }
    let step = STEPS.get(step as usize);
    match step.map(|step| step(&mesh)) {
        Some(Ok(bytes)) => fnv(&bytes),
        Some(Err(_)) | None => 0,
    }
}

/// FNV-1a, 64 bits.
fn fnv(bytes: &[u8]) -> u64 {
    let step = |hash: u64, byte: &u8| (hash ^ u64::from(*byte)).wrapping_mul(0x100_0000_01b3);
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, step)
}

fn built(mesh: &Mesh, config: BuildConfig) -> Result<Bvh, Box<dyn Error>> {
    Ok(Builder::new(config).build(mesh)?)
}

/// A tree's stored bytes.
fn bytes_of(bvh: &Bvh) -> Vec<u8> {
    bvh.stored().concat()
}

/// 10,000 rays from above, all over the mesh and beside it.
fn rays() -> Vec<Ray> {
    let ray = |i: u32| {
        let [x, z] = [(i % 100) as f32, (i / 100) as f32].map(|at| (at - 49.5) / 11.0);
        Ray::new([x, 6.0, z], [0.125 * z, -1.0, -0.25 * x])
    };
    (0..10_000).map(ray).collect()
}

fn answers(bvh: &Bvh) -> Vec<u8> {
    let (mut hits, mut found) = (Vec::new(), Vec::new());
    bvh.closest_hits(&rays(), &mut hits);
    bvh.any_hits(&rays(), &mut found);
    let found = found.into_iter().map(u8::from);
    bytemuck::cast_slice(&hits)
        .iter()
        .copied()
        .chain(found)
        .collect()
}

fn tree(mesh: &Mesh) -> Result<Vec<u8>, Box<dyn Error>> {
    Ok(bytes_of(&built(mesh, BuildConfig::default())?))
}

fn single_rays(mesh: &Mesh) -> Result<Vec<u8>, Box<dyn Error>> {
    let bvh = built(mesh, BuildConfig::default())?;
    let hits: Vec<[Hit; 3]> = rays().iter().map(|ray| bvh.nearest_hits(ray)).collect();
    Ok(bytemuck::cast_slice(&hits).to_vec())
}

fn many_rays(mesh: &Mesh) -> Result<Vec<u8>, Box<dyn Error>> {
    Ok(answers(&built(mesh, BuildConfig::default())?))
}

fn wide_tree(mesh: &Mesh) -> Result<Vec<u8>, Box<dyn Error>> {
    let mut snapped = mesh.clone();
    snapped.snap(-12);
    let config = BuildConfig {
        nodes: NodeCodec::Wide(WideStore::Packed),
        mesh: MeshCodec::Lattice { step_exponent: -12 },
        ..BuildConfig::default()
    };
    let bvh = built(&snapped, config)?;
    Ok([bytes_of(&bvh), answers(&bvh)].concat())
}

fn refit(mesh: &Mesh) -> Result<Vec<u8>, Box<dyn Error>> {
    let mut builder = Builder::new(BuildConfig::default());
    let mut bvh = builder.build(mesh)?;
    let mut moved = mesh.clone();
    for vertex in &mut moved.vertices {
        vertex[1] += 0.0625 * vertex[0] * vertex[2];
    }
    builder.refit(&moved, &mut bvh)?;
    Ok([bytes_of(&bvh), answers(&bvh)].concat())
}

/// A picture with shadows through trees of what the camera and the light need.
fn reduced_picture(mesh: &Mesh) -> Result<Vec<u8>, Box<dyn Error>> {
    let scene = Scene {
        mesh: mesh.clone(),
        materials: vec![Material::default()],
        cameras: vec![Camera {
            eye: [3.0, 5.0, 7.0],
            target: [0.0; 3],
            up: [0.0, 1.0, 0.0],
            projection: Projection::Orthographic { height: 8.0 },
        }],
        lights: vec![Light::Directional {
            direction: [0.5, -1.0, -0.25],
            color: [3.0; 3],
        }],
        ..Scene::default()
    };
    let switches = Switches {
        reduce: Reduce::On,
        ..Switches::default()
    };
    let plan = PlanConfig {
        switches,
        ..PlanConfig::default()
    };
    let config = FrameConfig {
        plan,
        update: Update::Rebuild,
        ..FrameConfig::default()
    };
    let settings = RenderSettings {
        size: [80, 45],
        ..RenderSettings::default()
    };
    let (mut frames, mut picture) = (Frames::new(Cpu, config), Picture::default());
    let report = frames.render(&scene, &settings, Change::Scene, Output::new(&mut picture))?;
    let rays = report.render.ray_count().to_le_bytes();
    Ok([bytemuck::cast_slice(&picture.pixels), rays.as_slice()].concat())
}

fn saved(mesh: &Mesh) -> Result<Vec<u8>, Box<dyn Error>> {
    let scene = Scene {
        mesh: mesh.clone(),
        materials: vec![Material::default()],
        ..Scene::default()
    };
    let mut file = Vec::new();
    slim::write(
        &scene,
        &built(mesh, BuildConfig::default())?,
        None,
        &mut file,
    )?;
    let loaded = slim::read(&file)?;
    Ok([answers(&loaded.bvh), file].concat())
}
