//! A GPU's one instruction for the smaller of two numbers may return either of two zeros. No answer may depend on which: rays walk
//! with a minimum and a maximum that return the other zero than a CPU's, and answer the same bits.

use proptest::array::{uniform3, uniform8};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;
use slimbvh::{Bvh, CodeBits, Mesh};
use slimbvh_core::lanes::{Each, EachMask, Lanes, Wide};
use slimbvh_core::trace::{
    Children, ClosestHit, Lane, PacketStacks, PreparedRays, Skip, trace_packet,
};
use slimbvh_core::{Hit, NodeRef, Ray};
use slimbvh_tests::parity::same_bits;
use slimbvh_tests::{build, cases};
use std::cell::Cell;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Rays of a packet.
const LANES: usize = 8;

thread_local! {
    /// How often the other of two different zeros was returned.
    static OTHERS: Cell<u32> = const { Cell::new(0) };
}

/// Numbers whose `least` and `most` return the other zero. With `UNSIGNS` an answer that is a zero loses its sign, as it must.
#[derive(Clone, Copy)]
struct Contrary<const UNSIGNS: bool>(Each<LANES>);

/// Of two numbers the one that is `usual`, but of two different zeros the other.
fn contrary(a: f32, b: f32, usual: f32) -> f32 {
    if a == 0.0 && b == 0.0 && a.to_bits() != b.to_bits() {
        OTHERS.set(OTHERS.get() + 1);
        -usual
    } else {
        usual
    }
}

impl<const UNSIGNS: bool> Contrary<UNSIGNS> {
    fn with(self, other: Self, of: impl Fn(f32, f32) -> f32) -> Self {
        let (a, b) = (self.0.0, other.0.0);
        Self(Each(std::array::from_fn(|i| of(a[i], b[i]))))
    }
}

macro_rules! as_each {
    ($($operator:ident $function:ident),*) => {$(
        impl<const UNSIGNS: bool> $operator for Contrary<UNSIGNS> {
            type Output = Self;

            fn $function(self, other: Self) -> Self {
                Self(self.0.$function(other.0))
            }
        }
    )*};
}

as_each!(Add add, Sub sub, Mul mul, Div div);

impl<const UNSIGNS: bool> Neg for Contrary<UNSIGNS> {
    type Output = Self;

    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl<const UNSIGNS: bool> Lanes for Contrary<UNSIGNS> {
    const ZERO: Self = Self(Each::ZERO);

    type Mask = EachMask<LANES>;

    fn splat(x: f32) -> Self {
        Self(Each::splat(x))
    }

    fn min(self, other: Self) -> Self {
        Self(self.0.min(other.0))
    }

    fn max(self, other: Self) -> Self {
        Self(self.0.max(other.0))
    }

    fn least(self, other: Self) -> Self {
        self.with(other, |a, b| contrary(a, b, a.least(b)))
    }

    fn most(self, other: Self) -> Self {
        self.with(other, |a, b| contrary(a, b, a.most(b)))
    }

    fn positive_zero(self) -> Self {
        if UNSIGNS {
            Self(self.0.positive_zero())
        } else {
            self
        }
    }

    fn abs(self) -> Self {
        Self(self.0.abs())
    }

    fn at_most(self, other: Self) -> Self::Mask {
        self.0.at_most(other.0)
    }

    fn at_least(self, other: Self) -> Self::Mask {
        self.0.at_least(other.0)
    }

    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self {
        Self(Each::select(mask, yes.0, no.0))
    }

    fn any(mask: Self::Mask) -> bool {
        Each::any(mask)
    }
}

impl<const UNSIGNS: bool> Wide<LANES> for Contrary<UNSIGNS> {
    fn from_array(numbers: [f32; LANES]) -> Self {
        Self(Each(numbers))
    }

    fn to_array(self) -> [f32; LANES] {
        self.0.0
    }

    fn power_below(self) -> Self {
        Self(self.0.power_below())
    }

    fn bits(mask: Self::Mask) -> u32 {
        Each::bits(mask)
    }
}

/// The closest hits of rays that walk together with contrary zeros.
fn contrary_hits<const UNSIGNS: bool>(bvh: &Bvh, rays: &[Ray; LANES]) -> Vec<Hit> {
    let (nodes, triangles) = (bvh.node_source(), bvh.triangle_source());
    let mut stacks: PacketStacks<Children<NodeRef>, Contrary<UNSIGNS>> = PacketStacks::EMPTY;
    let mut prepared = PreparedRays::EMPTY;
    prepared.prepare(rays, bvh.scene_exponent());
    let mut packet = prepared.t_max().map(|t_max| Lane {
        filter: Skip::NONE,
        collector: ClosestHit::new(t_max),
    });
    trace_packet(&mut stacks, &nodes, &triangles, &mut prepared, &mut packet);
    let hits = packet.iter().enumerate();
    hits.map(|(i, lane)| prepared.restore(i, lane.collector.hit))
        .collect()
}

/// Meshes, and rays side by side, most of whose coordinates are zeros and whole numbers.
fn case() -> impl Strategy<Value = (Mesh, [Ray; LANES])> {
    let number = || prop_oneof![Just(0.0f32), Just(-0.0), Just(1.0), Just(-1.0), Just(0.5)];
    let off = || prop_oneof![4 => Just(0.0f32), 2 => Just(-0.0), 1 => Just(1.0 / 64.0)];
    let corners = vec(uniform3(uniform3(number())), 1..24);
    let mesh = corners.prop_map(|corners| Mesh {
        indices: (0..corners.len() as u32)
            .map(|i| [3 * i, 3 * i + 1, 3 * i + 2])
            .collect(),
        vertices: corners.into_flattened(),
        ..Mesh::default()
    });
    let end = || prop_oneof![Just(f32::MAX), Just(0.0f32), Just(-0.0), Just(1.0)];
    let begin = || prop_oneof![4 => Just(0.0f32), 2 => Just(-0.0), 1 => Just(-1.0)];
    let first = (uniform3(number()), begin(), uniform3(number()), end());
    let others = uniform8(uniform3(off()));
    (mesh, first, others).prop_map(|(mesh, (origin, t_min, direction, t_max), others)| {
        let ray = |off: [f32; 3]| Ray {
            origin: std::array::from_fn(|axis| origin[axis] + off[axis]),
            t_min,
            direction,
            t_max,
        };
        (mesh, others.map(ray))
    })
}

/// Whether rays answer the same with either zero.
fn check<const UNSIGNS: bool>(mesh: &Mesh, rays: &[Ray; LANES]) -> Result<(), String> {
    let bvh = build(mesh, CodeBits::Bits30);
    let usual: Vec<Hit> = rays.iter().map(|ray| bvh.closest_hit(ray)).collect();
    same_bits(&contrary_hits::<UNSIGNS>(&bvh, rays), &usual)
}

proptest! {
    #![proptest_config(cases(2000))]

    #[test]
    fn no_answer_depends_on_which_zero_is_the_smaller((mesh, rays) in case()) {
        prop_assert_eq!(check::<true>(&mesh, &rays), Ok(()));
    }
}

/// The negative control: an answer that keeps its zero's sign is found, and many zeros are exchanged.
#[test]
fn a_zero_that_keeps_its_sign_is_found() {
    let mut runner = TestRunner::deterministic();
    OTHERS.set(0);
    let mut found = 0;
    for _ in 0..500 {
        let tree = case()
            .new_tree(&mut runner)
            .expect("cases are never refused");
        let (mesh, rays) = tree.current();
        found += u32::from(check::<false>(&mesh, &rays).is_err());
    }
    assert!(
        found > 0 && OTHERS.get() > 500,
        "{found} of 500, {} zeros",
        OTHERS.get()
    );
}
