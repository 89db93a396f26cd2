//! Polygons of files, concave ones and ones with a keyhole: their triangles cover them once.

use glam::{DQuat, DVec3};
use proptest::prelude::*;
use slimbvh::Mesh;
use slimbvh::scene::{LoadOptions, load_bytes};
use std::fmt::Write;

/// A polygon around the z axis, counter-clockwise.
type Outline = Vec<DVec3>;

/// A polygon whose corners the origin sees, with these distances to them.
fn star(distances: &[f64]) -> Outline {
    let step = std::f64::consts::TAU / distances.len() as f64;
    let corner = |(i, distance): (usize, &f64)| {
        let (sin, cos) = (step * i as f64).sin_cos();
        DVec3::new(cos, sin, 0.0) * *distance
    };
    distances.iter().enumerate().map(corner).collect()
}

/// A star around another, as one polygon: a bridge leads from one to the other and back.
fn keyhole(distances: &[(f64, f64)]) -> Outline {
    let outer: Vec<f64> = distances.iter().map(|(outer, _)| 2.0 + outer).collect();
    let inner: Vec<f64> = distances.iter().map(|(_, inner)| *inner).collect();
    let mut outline = star(&outer);
    outline.push(outline[0]);
    let hole = star(&inner);
    outline.push(hole[0]);
    outline.extend(hole.iter().rev());
    outline
}

fn outlines() -> impl Strategy<Value = Outline> {
    let stars = prop::collection::vec(0.2..1.0, 4..40).prop_map(|d| star(&d));
    let pairs = prop::collection::vec((0.0..1.0, 0.2..1.0), 3..20);
    let corner_on_each_edge = |outline: Outline| -> Outline {
        let next = outline.iter().cycle().skip(1);
        let both = outline.iter().zip(next);
        both.flat_map(|(a, b)| [*a, (*a + *b) / 2.0]).collect()
    };
    let all = prop_oneof![stars, pairs.prop_map(|d| keyhole(&d))];
    prop_oneof![all.clone(), all.prop_map(corner_on_each_edge)]
}

/// The polygon's area, by the formula of the shoelace.
fn area(outline: &[DVec3]) -> f64 {
    let next = outline.iter().cycle().skip(1);
    let doubles = outline.iter().zip(next).map(|(a, b)| a.x * b.y - b.x * a.y);
    doubles.sum::<f64>() / 2.0
}

/// The polygon as a file of each format that has polygons.
fn files(corners: &[DVec3]) -> [(&'static str, String); 3] {
    let mut positions = String::new();
    for corner in corners {
        let _ = writeln!(positions, "{} {} {}", corner.x, corner.y, corner.z);
    }
    let n = corners.len();
    let indices = |first: usize| {
        let indices = (0..n).map(|i| (first + i).to_string());
        indices.collect::<Vec<_>>().join(" ")
    };
    let vertices = positions.lines().map(|line| format!("v {line}\n"));
    let obj = format!("{}f {}\n", vertices.collect::<String>(), indices(1));
    let ply = format!(
        "ply\nformat ascii 1.0\nelement vertex {n}\nproperty double x\nproperty double y\nproperty double z\nelement face 1\n\
         property list int int vertex_indices\nend_header\n{positions}{n} {}\n",
        indices(0)
    );
    let off = format!("OFF\n{n} 1 0\n{positions}{n} {}\n", indices(0));
    [("x.obj", obj), ("x.ply", ply), ("x.off", off)]
}

/// The areas of the triangles, below 0 where they look to the other side.
fn areas(mesh: &Mesh, normal: DVec3) -> Vec<f64> {
    let area = |triangle: &[u32; 3]| {
        let [a, b, c] = triangle.map(|i| DVec3::from(mesh.vertices[i as usize].map(f64::from)));
        (b - a).cross(c - a).dot(normal) / 2.0
    };
    mesh.indices.iter().map(area).collect()
}

/// Whether the triangles are as many as they should be, all look to one side, and have the polygon's area together: then none overlap.
fn check(areas: &[f64], area: f64, corner_count: usize) -> Result<(), String> {
    let sum: f64 = areas.iter().sum();
    let least = areas.iter().copied().fold(0.0, f64::min);
    if areas.len() == corner_count - 2 && (sum - area).abs() < 1e-4 * area && least > -1e-4 * area {
        return Ok(());
    }
    Err(format!(
        "{} triangles of {corner_count} corners, {sum} instead of {area}, one of {least}",
        areas.len()
    ))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(512))]

    #[test]
    fn triangles_cover_a_polygon_once(
        outline in outlines(),
        start in 0_usize..100,
        axis in prop::array::uniform3(-1.0..1.0_f64),
        angle in 0.0..6.0_f64,
        offset in prop::array::uniform3(-5.0..5.0_f64),
        is_clockwise: bool,
    ) {
        let area = area(&outline);
        let turn = DQuat::from_axis_angle(DVec3::from(axis).try_normalize().unwrap_or(DVec3::X), angle);
        let place = |corner: &DVec3| turn * *corner + DVec3::from(offset);
        let mut corners: Vec<DVec3> = outline.iter().map(place).collect();
        let (n, mut normal) = (corners.len(), turn * DVec3::Z);
        corners.rotate_left(start % n);
        if is_clockwise {
            corners.reverse();
            normal = -normal;
        }
        for (name, text) in files(&corners) {
            let mesh = load_bytes(name.as_ref(), text.into(), &LoadOptions::default()).map(|s| s.mesh);
            let mesh = mesh.map_err(|error| TestCaseError::fail(error.to_string()))?;
            let checked = check(&areas(&mesh, normal), area, n);
            prop_assert!(checked.is_ok(), "{}: {:?}", name, checked);
        }
    }
}

/// A negative control: the fan of an L does not pass.
#[test]
fn a_fan_of_a_concave_polygon_fails() {
    let corners = [[3, 0], [3, 1], [1, 1], [1, 3], [0, 3], [0, 0]];
    let corners = corners.map(|[x, y]| DVec3::new(f64::from(x), f64::from(y), 0.0));
    let mut mesh = Mesh {
        vertices: corners
            .iter()
            .map(|corner| corner.as_vec3().to_array())
            .collect(),
        indices: (2..6).map(|i| [0, i - 1, i]).collect(),
        ..Mesh::default()
    };
    assert!(check(&areas(&mesh, DVec3::Z), area(&corners), 6).is_err());
    // And from the corner within, it does.
    mesh.indices = (2..6).map(|i| [2, (i + 1) % 6, (i + 2) % 6]).collect();
    assert_eq!(check(&areas(&mesh, DVec3::Z), area(&corners), 6), Ok(()));
}
