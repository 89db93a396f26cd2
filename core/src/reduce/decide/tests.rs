//! What is certain is right, by exact integers, and what should be certain is.

use super::*;
use crate::geometry::float::PowerOfTwo;
use crate::geometry::frustum::Frustum;
use crate::geometry::orientation::Target;
use crate::geometry::triangle::IndexedTriangles;
use crate::launch::{BLOCK, LANES};
use crate::reduce::classify::{Sides, VisibleSet, is_in_set};
use proptest::prelude::*;
use std::vec::Vec;

/// Reduces as a workgroup does.
fn reduce<T: Copy>(own: impl Fn(u32) -> T, step: impl Fn(u32, u32, &[T; LANES]) -> T) -> T {
    let mut all: [T; LANES] = core::array::from_fn(|lane| own(lane as u32));
    let mut distance = LANES as u32 / 2;
    while distance > 0 {
        let before = all;
        for lane in 0..distance {
            all[lane as usize] = step(lane, distance, &before);
        }
        distance /= 2;
    }
    all[0]
}

/// Measures one component in spans of so many faces; all links are in the first.
fn measure(surfaces: &Surfaces, longest: u32, exponent: i32) -> Measure {
    let unit = Unit {
        scale: PowerOfTwo::new(exponent),
        opaque_zero: 0,
    };
    let face_count = surfaces.faces.len() as u32;
    let firsts = (0..face_count).step_by(longest as usize);
    let spans: Vec<Measure> = firsts
        .map(|first_face| {
            let span = Span {
                reference: surfaces.faces[0][0],
                first_face,
                face_count: longest.min(face_count - first_face),
                first_link: 0,
                link_count: if first_face == 0 {
                    surfaces.links.len() as u32
                } else {
                    0
                },
            };
            let own = |lane| lane_measure(lane, &span, surfaces, &unit);
            reduce(own, join_step::<LANES>)
        })
        .collect();
    let component = Component {
        number: 0,
        first_span: 0,
        span_count: spans.len() as u32,
    };
    let own = |lane| lane_joined(lane, &component, &spans);
    reduce(own, join_step::<LANES>)
}

/// A torus of rings, closed whatever its vertices.
fn torus(rings: u32, sides: u32) -> Vec<[u32; 3]> {
    let vertex = |ring: u32, side: u32| ring % rings * sides + side % sides;
    let quads = (0..rings).flat_map(|ring| (0..sides).map(move |side| (ring, side)));
    let faces = quads.flat_map(|(ring, side)| {
        let [a, b] = [vertex(ring, side), vertex(ring, side + 1)];
        let [c, d] = [vertex(ring + 1, side), vertex(ring + 1, side + 1)];
        [[a, c, b], [b, c, d]]
    });
    faces.collect()
}

/// The sign of the exact volume of faces over whole coordinates.
fn exact_sign(vertices: &[[i64; 3]], faces: &[[u32; 3]]) -> i32 {
    let volume: i128 = faces
        .iter()
        .map(|face| {
            let [a, b, c] = face.map(|v| vertices[v as usize].map(i128::from));
            a[0] * (b[1] * c[2] - b[2] * c[1])
                + a[1] * (b[2] * c[0] - b[0] * c[2])
                + a[2] * (b[0] * c[1] - b[1] * c[0])
        })
        .sum();
    volume.signum() as i32
}

fn to_floats(vertices: &[[i64; 3]], exponent: i32) -> Vec<[f32; 3]> {
    let scale = PowerOfTwo::new(exponent);
    let floats = vertices.iter().map(|v| v.map(|x| scale.times(x as f32)));
    floats.collect()
}

/// Small shapes near the origin or far away, large ones, and almost flat ones: coordinates below 2^24.
fn whole_vertices() -> impl Strategy<Value = Vec<[i64; 3]>> {
    let offset = prop_oneof![Just(0i64), -(1i64 << 23)..(1 << 23)];
    let size = proptest::array::uniform3(prop_oneof![Just(1i64), 1i64..20, 1i64..(1 << 22)]);
    (proptest::array::uniform3(offset), size).prop_flat_map(|(offset, size)| {
        let coordinate = |axis: usize| (0..size[axis]).prop_map(move |x| x + offset[axis]);
        let point = (coordinate(0), coordinate(1), coordinate(2)).prop_map(|(x, y, z)| [x, y, z]);
        proptest::collection::vec(point, 5 * 7)
    })
}

proptest! {
    #[test]
    fn a_certain_sign_is_that_of_the_exact_volume(
        vertices in whole_vertices(),
        exponent in prop_oneof![Just(0), -90i32..90],
        longest in 1u32..80,
    ) {
        let faces = torus(5, 7);
        let floats = to_floats(&vertices, exponent);
        let surfaces = Surfaces { vertices: &floats, faces: &faces, links: &[] };
        let side = measure(&surfaces, longest, -24 - exponent).outer_side();
        let exact = exact_sign(&vertices, &faces);
        prop_assert!(side == 0 || side == exact, "{side} instead of {exact}");

        // Turned inside out, the other side is as certain.
        let averted: Vec<[u32; 3]> = faces.iter().map(|&[a, b, c]| [b, a, c]).collect();
        let surfaces = Surfaces { faces: &averted, ..surfaces };
        let averted = measure(&surfaces, longest, -24 - exponent);
        prop_assert!(averted.outer_side() == 0 || averted.outer_side() == -exact);
    }

    #[test]
    fn a_ball_that_is_clear_of_a_box_is_so_exactly(
        corners in proptest::array::uniform2(proptest::array::uniform3(-2000i64..2000)),
        point in proptest::array::uniform3(-4000i64..4000),
        radius in prop_oneof![Just(0i64), 0i64..9000],
        exponent in prop_oneof![Just(0), -110i32..110],
    ) {
        let scale = PowerOfTwo::new(exponent);
        let float = |p: [i64; 3]| p.map(|x| scale.times(x as f32));
        let low = [0, 1, 2].map(|axis| corners[0][axis].min(corners[1][axis]));
        let high = [0, 1, 2].map(|axis| corners[0][axis].max(corners[1][axis]));
        let ball = Target::ball(float(point), scale.times(radius as f32));
        let is_clear = is_clear_of_box(float(low), float(high), &ball);
        let squared: i64 = (0..3)
            .map(|axis| (low[axis] - point[axis]).max(point[axis] - high[axis]).max(0).pow(2))
            .sum();
        prop_assert!(!is_clear || squared > radius * radius);
        // And not in vain: what is clear by a hundred-thousandth is found to be.
        let is_plain = squared as f64 > (radius * radius) as f64 * 1.00002;
        prop_assert!(is_clear || !is_plain);
    }

    #[test]
    fn both_sets_are_counted_as_they_are_classified(
        vertices in proptest::collection::vec(proptest::array::uniform3(-1.0f32..1.0), 20),
        faces in proptest::collection::vec(proptest::array::uniform3(0u32..20), 1..3000),
        sides in proptest::array::uniform4(-1i32..=1),
        eye_sides in proptest::array::uniform4(-1i32..=1),
        point in proptest::array::uniform3(-2.0f32..2.0),
    ) {
        let mesh = IndexedTriangles { vertices: &vertices, indices: &faces };
        // One beyond the last, too.
        let components: Vec<u32> = faces.iter().map(|face| face[0] % 5).collect();
        let (scale, target) = (PowerOfTwo::new(0), Target::position(point));
        let both = Sides { components: &components, sides: &sides };
        let choice = Choice { mesh, scale, sides: both, eye_sides: &eye_sides, target };
        let blocks: Vec<SetCounts> = (0..(faces.len() as u32).div_ceil(BLOCK))
            .map(|block| reduce(|lane| lane_counts(block, lane, &choice), count_step::<LANES>))
            .collect();
        let counts = reduce(|lane| lane_total(lane, &blocks), count_step::<LANES>).decided();

        let count = |sides: &[i32]| {
            let sides = Sides { components: &components, sides };
            let reach = VisibleSet { sides, target, frustum: Frustum::EVERYWHERE };
            let kept = (0..faces.len() as u32).filter(|&i| is_in_set(i, &mesh, &scale, &reach));
            kept.count() as u32
        };
        prop_assert_eq!(counts.plus, count(&sides));
        prop_assert_eq!(counts.minus, count(&sides.map(|side| -side)));
        let is_barred = |&component: &u32| component < 4 && sides[component as usize] != 0 && eye_sides[component as usize] == 0;
        let barred = components.iter().filter(|component| is_barred(component)).count();
        prop_assert_eq!(counts.barred as usize, barred);
        prop_assert_eq!(counts.is_minus == 1, barred == 0 && counts.minus < counts.plus);
    }
}

/// The control: without the bound of the error, signs would be wrong.
#[test]
fn the_rounded_sign_alone_is_wrong_at_times() {
    let faces = torus(5, 7);
    let mut state = 1u64;
    let mut below = |bound: i64| {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as i64 % bound
    };
    let (mut wrong_count, mut certain_count) = (0, 0);
    for round in 0..400 {
        // A slanting sheet with one corner a step above it, or a bulky heap.
        let raised = below(35);
        let vertices: Vec<[i64; 3]> = (0..35)
            .map(|i| {
                let [x, y, z] = [1 << 22, 1 << 22, 1 << 23].map(&mut below);
                let sheet = x + y + i64::from(i == raised);
                [x, y, if round % 2 == 0 { sheet } else { z }]
            })
            .collect();
        let floats = to_floats(&vertices, 0);
        let surfaces = Surfaces {
            vertices: &floats,
            faces: &faces,
            links: &[],
        };
        let measure = measure(&surfaces, 64, -24);
        let rounded = if measure.volume == 0.0 {
            0
        } else {
            measure.volume.signum() as i32
        };
        let exact = exact_sign(&vertices, &faces);
        wrong_count += u32::from(rounded != exact);
        certain_count += u32::from(measure.outer_side() != 0);
        assert!(measure.outer_side() == 0 || measure.outer_side() == exact);
    }
    assert!(
        wrong_count > 0 && certain_count > 100,
        "{wrong_count} {certain_count}"
    );
}

/// Vertices, faces and links.
type Apart = (Vec<[f32; 3]>, Vec<[u32; 3]>, Vec<[u32; 2]>);

/// A 1×2×3 box, its sides apart: 12 faces with their own corners, and links between equal ones.
fn sides_apart() -> Apart {
    let corner = |i: u32| {
        [
            (i & 1) as f32,
            (i >> 1 & 1) as f32 * 2.0,
            (i >> 2) as f32 * 3.0,
        ]
    };
    let quads: [[u32; 4]; 6] = [
        [0, 4, 6, 2],
        [1, 3, 7, 5],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 2, 3, 1],
        [4, 5, 7, 6],
    ];
    let corners: Vec<u32> = quads
        .iter()
        .flat_map(|&[a, b, c, d]| [a, b, c, a, c, d])
        .collect();
    let vertices: Vec<[f32; 3]> = corners.iter().map(|&i| corner(i)).collect();
    let faces = (0..12).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect();
    let mut links = Vec::new();
    for a in 0..36 {
        for b in a + 1..36 {
            if corners[a as usize] == corners[b as usize] {
                links.push([a, b]);
            }
        }
    }
    (vertices, faces, links)
}

#[test]
fn a_box_faces_out_until_a_link_breaks() {
    let (mut vertices, faces, links) = sides_apart();
    let measured = |vertices: &[[f32; 3]]| {
        let surfaces = Surfaces {
            vertices,
            faces: &faces,
            links: &links,
        };
        measure(&surfaces, 5, -2)
    };
    let whole = measured(&vertices);
    assert_eq!((whole.low, whole.high), ([0.0; 3], [1.0, 2.0, 3.0]));
    assert_eq!(whole.volume, 6.0 * 6.0 / 64.0);
    let above = Target::position([0.5, 0.5, 3.5]);
    let within = Target::position([0.5, 0.5, 3.0]);
    assert_eq!([whole.side(&above), whole.side(&within)], [1, 0]);
    assert_eq!(whole.side(&Target::direction([0.0, 0.0, -1.0])), 1);

    // −0 is 0.
    for vertex in &mut vertices {
        if vertex[0] == 0.0 {
            vertex[0] = -0.0;
            break;
        }
    }
    assert_eq!(measured(&vertices).outer_side(), 1);
    // Mirrored, it is inside out.
    let mirrored: Vec<_> = vertices.iter().map(|&[x, y, z]| [-x, y, z]).collect();
    assert_eq!(measured(&mirrored).outer_side(), -1);
    // The smallest step tears it open, anywhere.
    for i in 0..vertices.len() {
        let mut torn = vertices.clone();
        torn[i][2] = torn[i][2].next_up();
        let torn = measured(&torn);
        assert_eq!((torn.is_open, torn.outer_side()), (1, 0), "{i}");
    }
    // Flat, it has no outer side.
    let flat: Vec<_> = vertices.iter().map(|&[x, y, _]| [x, y, 1.0]).collect();
    assert_eq!(measured(&flat).outer_side(), 0);
}

#[test]
fn a_volume_too_small_to_be_certain_has_no_sign() {
    let faces = torus(5, 7);
    let scaled = |size: f32| -> i32 {
        let vertices: Vec<[f32; 3]> = (0..35)
            .map(|i| {
                let turn = |part: u32, of: u32| {
                    (core::f64::consts::TAU * f64::from(part) / f64::from(of)).sin_cos()
                };
                let ([su, cu], [sv, cv]) = (turn(i / 7, 5).into(), turn(i % 7, 7).into());
                let ring: f64 = 3.0 + cv;
                [ring * cu, ring * su, sv].map(|x: f64| x as f32 * size)
            })
            .collect();
        let surfaces = Surfaces {
            vertices: &vertices,
            faces: &faces,
            links: &[],
        };
        // In a scene of magnitude 1.
        measure(&surfaces, 64, 0).outer_side()
    };
    let side = scaled(0.1);
    assert!(side != 0);
    assert_eq!(scaled(1e-8), side);
    assert_eq!([scaled(1e-14), scaled(1e-30), scaled(0.0)], [0; 3]);
}

#[test]
fn what_is_not_a_place_is_not_outside() {
    let clear = |target: Target| is_clear_of_box([0.0; 3], [1.0, 2.0, 3.0], &target);
    assert!(clear(Target::direction([0.0, 1.0, 0.0])) && clear(Target::position([0.0, 2.5, 0.0])));
    assert!(clear(Target::position([0.0, f32::MAX, 0.0])));
    assert!(!clear(Target::position([0.5, f32::NAN, 9.0])));
    assert!(!clear(Target::position([f32::INFINITY, 0.0, 9.0])));
    assert!(!clear(Target::direction([0.0, f32::NAN, 0.0])));
    for (radius, is_clear) in [
        (0.49, true),
        (0.5, false),
        (f32::MAX, false),
        (f32::INFINITY, false),
        (f32::NAN, false),
        (-0.1, false),
    ] {
        assert_eq!(
            clear(Target::ball([0.5, 2.5, 1.0], radius)),
            is_clear,
            "{radius}"
        );
    }
    // Past a corner: 3, 4, 12 away.
    let corner = |radius| clear(Target::ball([-3.0, 6.0, 15.0], radius));
    assert!(corner(12.999) && !corner(13.0) && !corner(13.001));
}
