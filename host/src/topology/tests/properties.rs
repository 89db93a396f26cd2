//! Random closed surfaces with small integer coordinates, checked against the oracle.

use super::oracle::{self, Corners};
use super::shapes::{moved, scaled, unwelded};
use super::*;
use crate::topology::contact::{Face, collide, meet_in_corner_alone};
use proptest::array::{uniform3, uniform4};
use proptest::collection::vec;
use proptest::prelude::*;

type Corner = [i32; 3];

/// Surfaces of touching and intersecting tetrahedra, wound either way. Each is closed, so the union is.
fn tetrahedra() -> impl Strategy<Value = Vec<[Corner; 3]>> {
    vec(uniform4(uniform3(0..=4)), 1..=6).prop_map(|solids| {
        let faces = solids
            .iter()
            .map(|&[a, b, c, d]| [[a, c, b], [a, b, d], [b, c, d], [a, d, c]]);
        faces.flatten().collect()
    })
}

fn mesh_of(triangles: &[[Corner; 3]]) -> Mesh {
    let corners = triangles.as_flattened().iter();
    Mesh {
        vertices: corners.map(|p| p.map(|x| x as f32)).collect(),
        indices: (0..triangles.len() as u32)
            .map(|t| [3 * t, 3 * t + 1, 3 * t + 2])
            .collect(),
        ..Mesh::default()
    }
}

/// The triangles of one component, in units of `1 / scale`.
fn exact(triangles: &[[Corner; 3]], labels: &[u32], component: u32, scale: i128) -> Vec<Corners> {
    let own = triangles
        .iter()
        .zip(labels)
        .filter(|(_, label)| **label == component);
    own.map(|(triangle, _)| triangle.map(|p| p.map(|x| i128::from(x) * scale)))
        .collect()
}

/// Whether a triangle of a reducible component must stay, by the definition in [`Topology::find_seams`]. `others` are the
/// component's triangles, in units of a third of a millionth.
fn is_seam(triangle: Corners, others: &[Corners], side: i128) -> bool {
    const FINE: i128 = 3_000_000;
    if !oracle::has_area(triangle) {
        return true;
    }
    let others: Vec<Corners> = others
        .iter()
        .copied()
        .filter(|&u| oracle::has_area(u))
        .collect();
    let equals = others.iter().filter(|&&u| u == triangle).count();
    if equals > 1
        || others
            .iter()
            .any(|&u| u != triangle && oracle::collide(triangle, u))
    {
        return true;
    }
    // A point just beside the middle.
    let normal = oracle::normal(triangle);
    let [a, b, c] = triangle;
    let beside = [0, 1, 2].map(|i| (a[i] + b[i] + c[i]) * (FINE / 3) + side * normal[i]);
    let fine: Vec<Corners> = others
        .iter()
        .map(|u| u.map(|p| p.map(|x| x * FINE)))
        .collect();
    let winding = oracle::winding_number(&fine, beside).expect("beside a triangle is on none");
    i128::from(winding) * side < 0
}

/// Two triangles of positive area that often share corners.
fn pair() -> impl Strategy<Value = [[Corner; 3]; 2]> {
    let has_area = |t: &[Corner; 3]| oracle::has_area(t.map(|p| p.map(i128::from)));
    let corners = || uniform3(uniform3(0..=3));
    let sharing = |(t, mut u, shared, shift): ([Corner; 3], [Corner; 3], usize, usize)| {
        u[..shared].copy_from_slice(&t[..shared]);
        u.rotate_left(shift);
        [t, u]
    };
    (corners(), corners(), 0_usize..4, 0_usize..3)
        .prop_map(sharing)
        .prop_filter("area", move |pair| pair.iter().all(has_area))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn collide_agrees_with_integers([t, u] in pair(), exponent in prop_oneof![Just(0), -60..60], offset in uniform3(prop_oneof![Just(0), -1000..1000])) {
        let exact = [t, u].map(|corners| corners.map(|p| p.map(i128::from)));
        let all: Vec<Corner> = [t, u].concat();
        let id = |p: Corner| all.iter().position(|&q| q == p).unwrap() as u32;
        let [t, u] = [t, u].map(|corners| Face {
            corners: corners.map(|p| [0, 1, 2].map(|i| (p[i] + offset[i]) as f32 * 2_f32.powi(exponent))),
            ids: corners.map(id),
        });
        prop_assert_eq!(collide(&t, &u), oracle::collide(exact[0], exact[1]));
        prop_assert_eq!(collide(&u, &t), oracle::collide(exact[0], exact[1]));
        prop_assert!(!(meet_in_corner_alone(&t, &u) && oracle::collide(exact[0], exact[1])));
        prop_assert_eq!(meet_in_corner_alone(&t, &u), meet_in_corner_alone(&u, &t));
    }

    #[test]
    fn seams_are_what_their_definition_says(triangles in tetrahedra(), exponent in prop_oneof![Just(0), -60..60]) {
        let mesh = scaled(mesh_of(&triangles), exponent);
        let labels = Topology::new(&mesh).components().to_vec();
        let topology = with_seams(&mesh);
        let (kept, facts) = (kept(&topology), topology.facts());
        for (number, &component) in labels.iter().enumerate() {
            if component == topology.component_count() {
                prop_assert!(kept[number]);
                continue;
            }
            prop_assert!(facts[component as usize].closed);
            let expected = facts[component as usize].outward.is_some_and(|outward| {
                let others = exact(&triangles, &labels, component, 1);
                is_seam(triangles[number].map(|p| p.map(i128::from)), &others, if outward { 1 } else { -1 })
            });
            prop_assert_eq!(kept[number], expected, "triangle {}", number);
        }
    }

    #[test]
    fn sides_are_those_of_components_that_do_not_wind_around_the_target(triangles in tetrahedra(), quarters in uniform3(-2_i32..=18), radius in 0_i32..=6, exponent in prop_oneof![Just(0), -60..60]) {
        let mesh = scaled(mesh_of(&triangles), exponent);
        let topology = Topology::new(&mesh);
        let labels = topology.components();
        let unit = 2_f32.powi(exponent) / 4.0;
        let center = quarters.map(|x| x as f32 * unit);
        let sides = topology.sides(&Target::Point(center));
        let ball = Target::Ball { center, radius: radius as f32 * unit };
        let ball_sides = topology.sides(&ball);
        prop_assert_eq!(sides.len(), 1 + topology.component_count() as usize);
        let (mut outside_all, mut ball_outside_all) = (true, true);
        for (component, facts) in (0_u32..).zip(topology.facts()) {
            let triangles = exact(&triangles, labels, component, 4);
            let winding = |by: [i32; 3]| {
                let point = [0, 1, 2].map(|i| i128::from(quarters[i] + by[i]));
                oracle::winding_number(&triangles, point)
            };
            let side = facts.outward.map_or(0, |outward| if outward { 1 } else { -1 });
            let is_outside = winding([0; 3]) == Some(0);
            outside_all &= is_outside;
            prop_assert_eq!(sides[component as usize], if is_outside { side } else { 0 });

            // Six points of the ball, and its middle.
            let tips = (0..6).map(|i| {
                let mut tip = [0; 3];
                tip[i % 3] = if i < 3 { radius } else { -radius };
                tip
            });
            let tips_are_outside = is_outside && tips.map(winding).all(|number| number == Some(0));
            let ball_side = ball_sides[component as usize];
            prop_assert!(ball_side == 0 || tips_are_outside && ball_side == side);
            ball_outside_all &= tips_are_outside;
        }
        prop_assert_eq!(topology.is_outside_all(&Target::Point(center)), outside_all);
        prop_assert!(!topology.is_outside_all(&ball) || ball_outside_all);
        prop_assert_eq!(sides.last(), Some(&0));
    }

    #[test]
    fn the_order_of_triangles_does_not_matter(triangles in tetrahedra(), seed in any::<u64>()) {
        // A shuffle: sort by a hash.
        let key = |i: usize| (i as u64 + 1).wrapping_mul(seed | 1).wrapping_mul(0x9e37_79b9_7f4a_7c15).rotate_left(29);
        let mut order: Vec<usize> = (0..triangles.len()).collect();
        order.sort_by_key(|&i| key(i));
        let shuffled: Vec<[Corner; 3]> = order.iter().map(|&i| triangles[i]).collect();
        let (plain, other) = (with_seams(&mesh_of(&triangles)), with_seams(&mesh_of(&shuffled)));
        let labels = [mesh_of(&triangles), mesh_of(&shuffled)].map(|mesh| Topology::new(&mesh).components().to_vec());
        let (plain_kept, other_kept) = (kept(&plain), kept(&other));
        let (plain_facts, other_facts) = (plain.facts(), other.facts());
        prop_assert_eq!(plain.component_count(), other.component_count());
        for (place, &i) in order.iter().enumerate() {
            prop_assert_eq!(other_kept[place], plain_kept[i]);
            let component = labels[0][i];
            if component < plain.component_count() {
                prop_assert_eq!(other_facts[labels[1][place] as usize], plain_facts[component as usize]);
            }
        }
    }

    #[test]
    fn welded_or_not_and_moved_by_whole_steps_is_the_same(triangles in tetrahedra(), by in uniform3(-1000_i32..1000)) {
        let mesh = mesh_of(&triangles);
        let expected = with_seams(&mesh);
        let there = moved(unwelded(&mesh), by.map(|x| x as f32));
        let found = with_seams(&there);
        prop_assert_eq!(found.components(), expected.components());
        prop_assert_eq!(found.facts(), expected.facts());

        // Following the move instead gives the same.
        let mut followed = expected.clone();
        followed.update(&there);
        prop_assert_eq!(followed.facts(), expected.facts());
        let target = Target::Point([1.25, 2.25, 1.5]);
        let moved_target = Target::Point([1.25 + by[0] as f32, 2.25 + by[1] as f32, 1.5 + by[2] as f32]);
        prop_assert_eq!(expected.sides(&target), followed.sides(&moved_target));
    }
}

/// In a fan, boxes tell all but neighbours apart; two triangles that cut each other beyond their shared corner are told
/// apart by nothing.
#[test]
fn boxes_tell_slivers_of_a_fan_apart() {
    let rim = |i: u32| {
        let (sin, cos) = (std::f32::consts::TAU * i as f32 / 100.0).sin_cos();
        [cos, 0.25, sin]
    };
    let sliver = |i: u32| Face {
        corners: [[0.0; 3], rim(i), rim(i + 1)],
        ids: [0, 1 + i, 1 + (i + 1) % 100],
    };
    let apart = (2..99).filter(|&i| meet_in_corner_alone(&sliver(0), &sliver(i)));
    assert!(apart.count() > 90);
    let across = Face {
        corners: [[0.0; 3], [2.0, 0.0, 0.2], [2.0, 1.0, 0.2]],
        ids: [0, 200, 201],
    };
    assert!(collide(&sliver(1), &across) && !meet_in_corner_alone(&sliver(1), &across));
    // Two shared corners, or none.
    assert!(!meet_in_corner_alone(&sliver(0), &sliver(1)));
    let far = Face {
        ids: [7, 8, 9],
        ..across
    };
    assert!(!meet_in_corner_alone(&sliver(40), &far));
}

/// The same laws, each broken: the comparisons above can fail.
#[test]
fn broken_laws_are_noticed() {
    // Two tetrahedra that share an edge, one inside out: the wrong side makes seams of the larger.
    let [o, x, y, z] = [[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 4]];
    let [p, q] = [[-1, 0, 1], [0, -1, 1]];
    let large = [[o, y, x], [x, y, z], [o, x, z], [o, z, y]];
    let small = [[o, q, p], [p, q, z], [o, p, z], [o, z, q]];
    let triangles = [large, small].concat();
    let mesh = mesh_of(&triangles);
    let topology = with_seams(&mesh);
    assert_eq!(topology.component_count(), 1);
    let others = exact(&triangles, &[0; 8], 0, 1);
    let expected = |side| {
        others
            .iter()
            .map(|&t| is_seam(t, &others, side))
            .collect::<Vec<_>>()
    };
    let side = i128::from(topology.sides(&Target::Direction([1.0; 3]))[0]);
    assert_eq!(kept(&topology), expected(side));
    assert_ne!(kept(&topology), expected(-side));

    // One corner moved into the other solid: it intersects.
    let mut cutting = triangles.clone();
    for corner in cutting[4..].as_flattened_mut() {
        *corner = if *corner == p { [1, 1, 1] } else { *corner };
    }
    assert_ne!(kept(&with_seams(&mesh_of(&cutting))), kept(&topology));

    // One flipped triangle: no longer closed.
    let mut turned = triangles.clone();
    turned[7].swap(0, 1);
    let turned = with_seams(&mesh_of(&turned));
    assert_ne!(turned.facts(), topology.facts());
    assert_eq!(turned.sides(&Target::Direction([1.0; 3])), [0, 0]);

    // Targets left behind by the movement.
    let by = [1000.0, 0.0, 0.0];
    let mut followed = topology.clone();
    followed.update(&moved(mesh, by));
    let inside = Target::Point([0.25, 0.25, 0.75]);
    assert_eq!(topology.sides(&inside), [0, 0]);
    assert_ne!(followed.sides(&inside), topology.sides(&inside));
}
