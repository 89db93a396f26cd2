//! Scenes that are hard for tracers.

use super::Effort;
use super::shapes::{coplanar, equal_centres, extremes, flattened, spindle, stadium};
use glam::Vec3;
use slimbvh::generate::{icosphere, slivers, soup, sphere_flake};
use slimbvh::{CodeBits, Mesh};
use std::borrow::Cow;

/// A scene of one family at one magnitude.
#[derive(Clone, Debug)]
pub struct Case {
    /// The kind of scene, or the name of a file.
    pub family: Cow<'static, str>,
    /// How large or how extreme the scene is.
    pub magnitude: String,
    /// The scene.
    pub mesh: Mesh,
    /// The width of the codes that sort the triangles.
    pub code_bits: CodeBits,
    /// A point inside, if the whole scene is closed.
    pub inside: Option<[f32; 3]>,
    /// A point outside, from which some rays start.
    pub eye: Option<[f32; 3]>,
    /// The number of rays.
    pub ray_count: usize,
}

/// All families at all magnitudes.
#[must_use]
pub fn cases(effort: Effort) -> Vec<Case> {
    let mut cases = Vec::new();
    let mut add = |family, mut each: Vec<Case>| {
        for case in &mut each {
            case.family = Cow::Borrowed(family);
        }
        cases.append(&mut each);
    };
    add("translated", translated(effort));
    add("scaled", scaled(effort));
    add("anisotropic", anisotropic(effort));
    add(
        "slivers",
        vec![open("1:1e6", slivers(effort.pick(400, 2000), 8), effort)],
    );
    add("needle fans", needle_fans(effort));
    add(
        "coplanar, doubled",
        vec![open(
            "5 at a place",
            coplanar(effort.pick(60, 300), 4),
            effort,
        )],
    );
    let equal = |magnitude: &str, count| Case {
        ray_count: effort.pick(48, 250) as usize,
        ..open(magnitude, equal_centres(count, 5), effort)
    };
    let counts = [("1e4 triangles", 10_000), ("1e5 triangles", 100_000)];
    add(
        "equal centroids",
        counts.map(|(name, count)| equal(name, count)).into(),
    );
    add("teapot, stadium", stadiums(effort));
    add("flat", flat(effort));
    add("denormal", denormal(effort));
    add("largest numbers", largest(effort));
    add(
        "soup",
        vec![open("1", soup(effort.pick(700, 5000), 7), effort)],
    );
    cases
}

/// A scene without an inside.
fn open(magnitude: impl Into<String>, mesh: Mesh, effort: Effort) -> Case {
    Case {
        family: Cow::Borrowed(""),
        magnitude: magnitude.into(),
        mesh,
        code_bits: CodeBits::Bits30,
        inside: None,
        eye: None,
        ray_count: effort.pick(600, 5000) as usize,
    }
}

/// A closed scene with a point inside and one outside.
fn closed(magnitude: String, mesh: Mesh, [inside, eye]: [Vec3; 2], effort: Effort) -> Case {
    Case {
        inside: Some(inside.to_array()),
        eye: Some(eye.to_array()),
        ..open(magnitude, mesh, effort)
    }
}

/// Points in the unit sphere and beside it.
const INSIDE: Vec3 = Vec3::new(0.1, -0.2, 0.3);
const OUTSIDE: Vec3 = Vec3::new(2.0, 1.5, 3.0);

fn moved(mut mesh: Mesh, place: impl Fn(Vec3) -> Vec3) -> Mesh {
    for vertex in &mut mesh.vertices {
        *vertex = place(Vec3::from(*vertex)).to_array();
    }
    mesh.normals.clear();
    mesh
}

/// A closed scene of unit size, moved by `place`.
fn placed(magnitude: String, mesh: Mesh, effort: Effort, place: impl Fn(Vec3) -> Vec3) -> Case {
    let points = [INSIDE, OUTSIDE].map(&place);
    closed(magnitude, moved(mesh, place), points, effort)
}

fn sphere(effort: Effort) -> Mesh {
    icosphere(Vec3::ZERO, 1.0, effort.pick(2, 4))
}

/// Moved by powers of ten. From 10^7 on, the unit sphere is one cell of the float grid.
fn translated(effort: Effort) -> Vec<Case> {
    let translated = |k: i32| {
        let offset = 10f32.powi(k) * Vec3::new(1.0, 0.37, -0.61);
        placed(format!("1e{k}"), sphere(effort), effort, |p| p + offset)
    };
    (0..=7).map(translated).collect()
}

fn scaled(effort: Effort) -> Vec<Case> {
    let scaled = |k: i32| {
        let scale = 10f64.powi(k) as f32;
        let mesh = sphere_flake(1, effort.pick(1, 2));
        placed(format!("1e{k}"), mesh, effort, |p| p * scale)
    };
    [-30, -20, -10, -3, 3, 10, 20, 30].map(scaled).into()
}

/// A flattened sphere and an elongated one, along each axis.
fn anisotropic(effort: Effort) -> Vec<Case> {
    let pressed = |axis: usize| {
        let mut factors = Vec3::ONE;
        factors[axis] = 1e-6;
        let name = ["x", "y", "z"][axis];
        let flat = format!("1e-6 along {name}");
        let thin = format!("1e6 along {name}");
        let mesh = || sphere(effort);
        [
            placed(flat, mesh(), effort, |p| p * factors),
            placed(thin, mesh(), effort, |p| p / factors),
        ]
    };
    (0..3).flat_map(pressed).collect()
}

fn needle_fans(effort: Effort) -> Vec<Case> {
    let axes = [("x", Vec3::X), ("xyz", Vec3::new(0.6, 0.48, 0.64))];
    let fan = |(name, axis): (&str, Vec3), k: i32| {
        let radius = 10f32.powi(k);
        let mesh = spindle(axis, radius, effort.pick(24, 100));
        let outside = OUTSIDE.normalize();
        closed(
            format!("1:1e{} along {name}", -k),
            mesh,
            [Vec3::ZERO, outside],
            effort,
        )
    };
    let radii = [-2, -4, -6];
    axes.into_iter()
        .flat_map(|axis| radii.map(|k| fan(axis, k)))
        .collect()
}

fn stadiums(effort: Effort) -> Vec<Case> {
    let bits = [("30 bits", CodeBits::Bits30), ("63 bits", CodeBits::Bits63)];
    bits.map(|(name, code_bits)| Case {
        code_bits,
        ..open(name, stadium(effort.pick(12, 60)), effort)
    })
    .into()
}

fn flat(effort: Effort) -> Vec<Case> {
    let flat = |axis: usize, height: f32| {
        let mesh = flattened(soup(effort.pick(200, 2000), 3), axis, height);
        open(
            format!("{} = {height}", ["x", "y", "z"][axis]),
            mesh,
            effort,
        )
    };
    (0..3)
        .flat_map(|axis| [flat(axis, 0.0), flat(axis, 0.3)])
        .collect()
}

fn denormal(effort: Effort) -> Vec<Case> {
    [-39, -41, -43]
        .map(|k| {
            let scale = 10f64.powi(k);
            let place = |p: Vec3| Vec3::from(p.to_array().map(|x| (f64::from(x) * scale) as f32));
            placed(format!("1e{k}"), sphere(effort), effort, place)
        })
        .into()
}

fn largest(effort: Effort) -> Vec<Case> {
    let quarter = f32::MAX / 4.0;
    let points = [INSIDE * quarter, OUTSIDE * quarter];
    let ball = moved(sphere(effort), |p| p * quarter);
    vec![
        closed("sphere of f32::MAX/4".into(), ball, points, effort),
        open(
            "corners at ±f32::MAX/4",
            extremes(effort.pick(60, 300), quarter, 6),
            effort,
        ),
    ]
}
