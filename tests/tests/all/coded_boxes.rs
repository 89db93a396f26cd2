//! Boxes of wide nodes on the lattice: planes that are crossed by one operation, fused or not, lose nothing.

use glam::Vec4;
use proptest::array::uniform3;
use proptest::prelude::*;
use slimbvh::internals::Random;
use slimbvh_core::Ray;
use slimbvh_core::planes::PlanePair;
use slimbvh_core::ray::PreparedRay;
use slimbvh_core::slab::{CodedPlanes, FourBoxesHit, FourPlanes, slab, slab_of_four};
use slimbvh_tests::cases;

/// An axis of a node's frame, a child's planes in it, and a part of what lies between them.
#[derive(Clone, Copy, Debug)]
struct Axis {
    base: f32,
    end: f32,
    cell: f32,
    numbers: [u8; 2],
    part: [f32; 2],
}

impl Axis {
    /// A frame of steps of 2^-24, and a child between two of its planes. Parts are fractions of the child, in quarters.
    fn new(base: i32, shift: u32, [a, b]: [u8; 2], parts: [u8; 2]) -> Self {
        let step = 2f32.powi(-24);
        let end = base + (255 << shift);
        let (lower, upper) = (
            base + (i32::from(a) << shift),
            end - (i32::from(b) << shift),
        );
        let at = |quarters: u8| lower + (upper - lower) / 4 * i32::from(quarters % 4);
        let first = at(parts[0]);
        let last = if parts[1] < 2 {
            upper
        } else {
            at(parts[1]).max(first)
        };
        Self {
            base: base as f32 * step,
            end: end as f32 * step,
            cell: 2f32.powi(shift as i32 - 24),
            numbers: [a, b],
            part: [first as f32 * step, last as f32 * step],
        }
    }

    /// The planes that a ray meets first and second.
    fn coded(&self, is_reversed: bool) -> [CodedPlanes; 2] {
        let planes = |number: u8, base, cell| CodedPlanes {
            numbers: Vec4::splat(f32::from(number)),
            base,
            cell,
        };
        let [a, b] = self.numbers;
        let (low, high) = (
            planes(a, self.base, self.cell),
            planes(b, self.end, -self.cell),
        );
        if is_reversed {
            [high, low]
        } else {
            [low, high]
        }
    }
}

fn axis() -> impl Strategy<Value = Axis> {
    let base = prop_oneof![-(1i32 << 23)..1 << 22, -300..300i32, Just(0)];
    let numbers = (any::<u8>(), any::<u8>()).prop_map(|(a, b)| {
        if a > 255 - b {
            [255 - a, 255 - b]
        } else {
            [a, b]
        }
    });
    (base, 0..=14u32, numbers, any::<[u8; 2]>())
        .prop_map(|(base, shift, numbers, parts)| Axis::new(base, shift, numbers, parts))
}

/// Planes whose operations a compiler fuses as it likes, with or without what makes up for it.
#[derive(Clone, Copy, Debug)]
struct Varied<const HAS_MARGIN: bool> {
    planes: CodedPlanes,
    fused: u32,
}

impl<const HAS_MARGIN: bool> FourPlanes for Varied<HAS_MARGIN> {
    const PADDING: f32 = CodedPlanes::PADDING;
    const LIMIT_PADDING: f32 = if HAS_MARGIN {
        CodedPlanes::LIMIT_PADDING
    } else {
        0.0
    };

    fn planes(self) -> Vec4 {
        self.planes.planes()
    }

    fn crossed(self, origin: f32, inverse: f32, is_entry: bool) -> Vec4 {
        let CodedPlanes {
            numbers,
            base,
            cell,
        } = self.planes;
        if self.fused == 0 && HAS_MARGIN {
            return self.planes.crossed(origin, inverse, is_entry);
        }
        let product_and =
            |fused: bool, a: f32, b: f32, c: f32| if fused { a.mul_add(b, c) } else { a * b + c };
        let is_fused = |bit: u32| self.fused >> bit & 1 == 1;
        let scale = cell * inverse;
        let margin = if !HAS_MARGIN {
            0.0
        } else if is_entry {
            scale.abs() * -2f32.powi(-13)
        } else {
            scale.abs() * 2f32.powi(-13)
        };
        let at = product_and(is_fused(0), base - origin, inverse, margin);
        Vec4::from_array(
            [0, 1, 2, 3].map(|i| product_and(is_fused(1 + i as u32), numbers[i], scale, at)),
        )
    }
}

/// A ray to a point of a box, from some distance, in a direction that may be almost parallel to axes.
fn ray_to(axes: &[Axis; 3], direction: [f32; 3], places: [u8; 3], distance: f32) -> Ray {
    let target = [0, 1, 2].map(|i| {
        let [low, high] = axes[i].part;
        match places[i] % 4 {
            0 => low,
            1 => high,
            _ => low + (high - low) * 0.375,
        }
    });
    let origin = [0, 1, 2].map(|i| target[i] - direction[i] * distance);
    Ray::new(origin, direction)
}

/// Whether a box of a node on the lattice is met wherever a part of it is entered: also if a hit lies where it is entered.
fn holds<const HAS_MARGIN: bool>(axes: &[Axis; 3], ray: &Ray, fused: u32) -> bool {
    let ray = PreparedRay::new(ray, 0);
    let own = ray.axes.map(|axis| axes[axis as usize]);
    let part =
        own.map(|axis| PlanePair::new(axis.part[0], axis.part[0], axis.part[1], axis.part[1]));
    let exact = slab(&ray, part, f32::MAX);
    if ray.t_min > ray.t_max || !exact.meets_a {
        return true;
    }
    let coded = [0, 1, 2].map(|i| own[i].coded(ray.inverse[i].to_bits() >> 31 == 1));
    let side = |side: usize| {
        [0, 1, 2].map(|i| Varied::<HAS_MARGIN> {
            planes: coded[i][side],
            fused,
        })
    };
    let found = slab_of_four(&ray, side(0), side(1), exact.enter_a);
    // While it waits, it is due as long as the part may be.
    let is_due = |found: &FourBoxesHit| found.earliest.cmple(Vec4::splat(exact.enter_a)).all();
    let varied = (0..4).all(|i| found.meets[i]) && is_due(&found);
    // As it is compiled here.
    let plain = slab_of_four(
        &ray,
        coded.map(|c| c[0]),
        coded.map(|c| c[1]),
        exact.enter_a,
    );
    varied && (!HAS_MARGIN || plain.meets == [true; 4] && is_due(&plain))
}

fn component() -> impl Strategy<Value = f32> {
    prop_oneof![
        3 => -1f32..1.0,
        2 => (-1f32..1.0, -62..-4i32).prop_map(|(x, e)| x * 2f32.powi(e)),
        1 => Just(0.0f32),
    ]
}

proptest! {
    #![proptest_config(cases(40_000))]

    #[test]
    fn a_coded_box_is_met_where_a_part_of_it_is(
        axes in uniform3(axis()),
        direction in uniform3(component()),
        places: [u8; 3],
        distance in prop_oneof![0f32..4.0, -1f32..1.0, (-20..30i32).prop_map(|e| 2f32.powi(e))],
        fused: u32,
    ) {
        let ray = ray_to(&axes, direction, places, distance);
        prop_assert!(holds::<true>(&axes, &ray, fused));
    }
}

/// The negative control: without margins such rays are lost.
#[test]
fn rays_that_are_lost_without_margins_are_found() {
    let mut random = Random::new(3);
    let mut number = |end: u32| (random.unit() * end as f32) as u32;
    let mut lost = 0;
    for _ in 0..20_000 {
        let axes: [Axis; 3] = std::array::from_fn(|_| {
            let base = number(1 << 23) as i32 - (1 << 22);
            Axis::new(
                base,
                number(10),
                [number(128) as u8, number(127) as u8],
                [0, 0],
            )
        });
        let direction = [
            number(2000) as f32 - 1000.0,
            number(2000) as f32 - 1000.0,
            1.0 + number(1000) as f32,
        ];
        let places = [number(4) as u8, number(4) as u8, number(4) as u8];
        let ray = ray_to(
            &axes,
            direction.map(|x| x / 1000.0),
            places,
            number(100) as f32 / 50.0,
        );
        let fused = number(32);
        assert!(holds::<true>(&axes, &ray, fused));
        lost += usize::from(!holds::<false>(&axes, &ray, fused));
    }
    assert!(lost > 20, "{lost}");
}
