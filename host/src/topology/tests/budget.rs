//! The search for seams takes linear time, whatever the mesh.

use super::shapes::*;
use super::*;
use crate::generate::icosphere;
use crate::topology::budget::PAIR_STEPS;
use glam::Vec3;
use std::f64::consts::TAU;

/// A double cone of `2 count` slivers that share two apexes: closed, and no two of them cut each other.
fn fan(count: u32, center: [f32; 3], radius: f32) -> Mesh {
    let [x, y, z] = center;
    let mut mesh = Mesh {
        vertices: vec![[x, y + radius, z], [x, y - radius, z]],
        ..Mesh::default()
    };
    for i in 0..count {
        let (sin, cos) = (TAU * f64::from(i) / f64::from(count)).sin_cos();
        let [dx, dz] = [cos, sin].map(|a| radius * a as f32);
        mesh.vertices.push([x + dx, y, z + dz]);
        let (this, next) = (2 + i, 2 + (i + 1) % count);
        mesh.indices.extend([[0, next, this], [1, this, next]]);
    }
    mesh
}

/// Copies of one tetrahedron, all at one place.
fn copies(count: u32) -> Mesh {
    let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 3.0]];
    let mut mesh = Mesh::default();
    for i in 0..count {
        mesh.vertices.extend(corners);
        let sides = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
        mesh.indices
            .extend(sides.map(|side| side.map(|corner: u32| 4 * i + corner)));
    }
    mesh
}

/// A closed surface whose corners are scattered in a box: every triangle cuts most others.
fn noise(subdivisions: u32) -> Mesh {
    let mut mesh = icosphere(Vec3::ZERO, 1.0, subdivisions);
    mesh.normals.clear();
    let mut state = 88_172_645_463_325_252_u64;
    let mut random = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 40) as f32
    };
    mesh.vertices
        .iter_mut()
        .for_each(|vertex| *vertex = [random(), random(), random()]);
    mesh
}

/// A sphere of parallels and meridians, with a fan at each pole.
fn globe(parallels: u32, meridians: u32) -> Mesh {
    let mut mesh = Mesh {
        vertices: vec![[0.0, 1.0, 0.0]],
        ..Mesh::default()
    };
    for parallel in 1..parallels {
        let (sin, cos) = (0.5 * TAU * f64::from(parallel) / f64::from(parallels)).sin_cos();
        for meridian in 0..meridians {
            let (s, c) = (TAU * f64::from(meridian) / f64::from(meridians)).sin_cos();
            mesh.vertices
                .push([sin * s, cos, sin * c].map(|x| x as f32));
        }
    }
    let last = mesh.vertices.len() as u32;
    mesh.vertices.push([0.0, -1.0, 0.0]);
    for i in 0..meridians {
        let next = (i + 1) % meridians;
        mesh.indices.push([0, 1 + i, 1 + next]);
        for parallel in 0..parallels - 2 {
            let [a, b] = [i, next].map(|meridian| 1 + parallel * meridians + meridian);
            let [c, d] = [a + meridians, b + meridians];
            mesh.indices.extend([[a, c, d], [a, d, b]]);
        }
        let row = last - meridians;
        mesh.indices.push([last, row + next, row + i]);
    }
    mesh
}

/// A prism of so many sides, as long as it is wide, with a fan at each end.
fn pipe(sides: u32) -> Mesh {
    let mut mesh = fan(sides, [0.0; 3], 1.0);
    let rim = mesh.vertices[2..].to_vec();
    mesh.vertices
        .extend(rim.iter().map(|&[x, y, z]| [x, y - 1.0, z]));
    for [x, y, z] in &mut mesh.vertices[2..2 + sides as usize] {
        (*x, *y, *z) = (*x, *y + 1.0, *z);
    }
    for triangle in &mut mesh.indices {
        if triangle[0] == 1 {
            *triangle = triangle.map(|corner| if corner < 2 { corner } else { corner + sides });
        }
    }
    for i in 0..sides {
        let (this, next) = (2 + i, 2 + (i + 1) % sides);
        mesh.indices.extend([
            [this, next, next + sides],
            [this, next + sides, this + sides],
        ]);
    }
    mesh
}

/// Steps of the search with a budget of so many for each triangle, in all components, and the number of those given up.
fn search(mesh: &Mesh, steps_a_triangle: u64) -> (u64, usize) {
    let mut topology = Topology::new(mesh);
    topology.find_seams_within(mesh, &build(mesh), steps_a_triangle);
    let steps = topology.shapes.iter().map(|shape| shape.spending.steps);
    let given_up = topology
        .facts()
        .into_iter()
        .filter(|facts| facts.search_given_up);
    (steps.sum(), given_up.count())
}

/// A mesh of four times as many triangles takes at most four times as many steps, plus one triangle's search on each
/// thread; without a budget, more than ten times as many.
fn grows_linearly(mesh: impl Fn(u32) -> Mesh, small: u32, large: u32) {
    let (few, many) = (mesh(small), mesh(large));
    let count = many.indices.len() as u64;
    assert_eq!(count, 4 * few.indices.len() as u64);
    // A small budget, so that small meshes exceed it.
    let steps_a_triangle = 64;
    let (_, given_up) = search(&few, steps_a_triangle);
    assert_eq!(given_up, 1);
    let (steps, given_up) = search(&many, steps_a_triangle);
    assert_eq!(given_up, 1);
    let budget = steps_a_triangle / 2 * (count + count.max(1 << 14));
    let threads = crate::parallel::current_num_threads() as u64;
    let last = threads * (count * (PAIR_STEPS + 2) + (1 << 13));
    assert!(
        (budget + 1..=budget + last).contains(&steps),
        "{steps} of {budget}"
    );

    // The control.
    let (few, _) = search(&few, u64::MAX);
    let (many, given_up) = search(&many, u64::MAX);
    assert_eq!(given_up, 0);
    assert!(many > 10 * few, "{few} and {many}");
}

#[test]
fn fans_take_linear_time() {
    grows_linearly(|count| fan(count, [1.0, 2.0, 3.0], 4.0), 1000, 4000);
}

#[test]
fn copies_at_one_place_take_linear_time() {
    grows_linearly(copies, 500, 2000);
}

#[test]
fn noise_takes_linear_time() {
    grows_linearly(noise, 3, 4);
}

#[test]
fn what_is_given_up_stays_whole_and_the_rest_is_reduced() {
    let sphere = globe(60, 120);
    let count = sphere.indices.len();
    let mesh = join(sphere, fan(8000, [3.0, 0.0, 0.0], 0.05));
    let topology = with_seams(&mesh);
    let brief: Vec<_> = topology
        .facts()
        .into_iter()
        .map(|facts| {
            (
                facts.triangle_count,
                facts.reducible,
                facts.search_given_up,
                facts.seam_count,
            )
        })
        .collect();
    assert_eq!(brief, [(count, true, false, 0), (16_000, false, true, 0)]);
    assert_eq!(topology.sides(&Target::Point([9.0; 3])), [1, 0, 0]);
    assert_eq!(topology.seam_count(), 0);
    // It has no place among those that moved vertices may decide on.
    assert_eq!(topology.runs().components.len(), 1);

    // Another search, of another shape of the same triangles, counts anew.
    let mut apart = mesh.clone();
    for (i, vertex) in (0_u32..).zip(&mut apart.vertices[mesh.vertices.len() - 8002..]) {
        *vertex = [3.0 + (i % 2) as f32, 0.0, 0.0];
    }
    let mut followed = topology.clone();
    followed.update(&apart);
    followed.find_seams(&apart, &build(&apart));
    assert!(followed.facts().iter().all(|facts| !facts.search_given_up));
}

/// Sound surfaces take less than 0.7 of their budget, also small ones among many, and small fans.
#[test]
fn sound_surfaces_are_not_given_up() {
    let mut many = Mesh::default();
    for i in 0..500 {
        let x = 2.0 * (i % 25) as f32;
        let y = 2.0 * (i / 25) as f32;
        many = join(many, block([x, y, 0.0], [x + 1.5, y + 1.0, 2.0]));
    }
    // A slanted hull, whose boxes hold everything.
    let mut hull = block([-10.0; 3], [60.0; 3]);
    for [x, y, _] in &mut hull.vertices {
        (*x, *y) = (0.8 * *x - 0.6 * *y, 0.6 * *x + 0.8 * *y);
    }
    // Pipes of 64 sides, whose ends are fans.
    let mut pipes = Mesh::default();
    for i in 0..64 {
        let x = 3.0 * i as f32;
        pipes = join(pipes, moved(pipe(64), [x, 0.0, 0.0]));
    }
    let mut fine = icosphere(Vec3::ZERO, 1.0, 5);
    fine.normals.clear();
    for (name, mesh) in [
        ("sphere", fine.clone()),
        ("globe", globe(120, 240)),
        ("knot", knot(0.15)),
        ("fan", fan(256, [0.0; 3], 1.0)),
        ("pipes", pipes),
        ("blocks", many),
        ("sphere in a hull", join(fine, hull)),
    ] {
        let topology = with_seams(&mesh);
        let spendings = || topology.shapes.iter().map(|shape| shape.spending);
        let shares = spendings().map(|spent| spent.steps as f64 / spent.budget as f64);
        let share = shares.fold(0.0, f64::max);
        eprintln!("{name}: at most {:.1} % of a budget", 100.0 * share);
        assert!(
            spendings().all(|spent| spent.steps > 0) && share < 0.7,
            "{name}: {share}"
        );
        assert!(topology.facts().iter().all(|facts| facts.reducible));
    }
}

/// What is given up depends neither on the threads nor on the order in which they come.
#[cfg(feature = "parallel")]
#[test]
fn threads_do_not_decide() {
    let near = fan(600, [0.0; 3], 1.0);
    let (whole, _) = search(&near, u64::MAX);
    let allowed = |steps: u64| 2 * (steps / (near.indices.len() as u64 + (1 << 14)));
    let run = |threads: usize, steps_a_triangle: u64| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        let pool = pool.expect("threads can be started");
        let mut topology = Topology::new(&near);
        let bvh = build(&near);
        pool.install(|| topology.find_seams_within(&near, &bvh, steps_a_triangle));
        (topology.facts(), topology.components().to_vec())
    };
    // Just enough, and just too little.
    for (steps, given_up) in [(allowed(whole) + 2, false), (allowed(whole) - 2, true)] {
        for threads in [1, 2, 3, 8] {
            let found = run(threads, steps);
            assert_eq!(found, run(1, steps));
            assert_eq!(found.0[0].search_given_up, given_up, "{threads} threads");
        }
    }
}
