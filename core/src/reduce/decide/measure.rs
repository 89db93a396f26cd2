//! A component's box, the sign of its volume, and whether it is closed, as far as that is certain.

use super::is_clear_of_box;
use crate::build::bounds::positive_zeros;
use crate::geometry::aabb::{Aabb, greater, lesser};
use crate::geometry::float::{PowerOfTwo, UNIT_ROUNDOFF, abs, gamma};
use crate::geometry::orientation::{Target, dot, product};
use crate::geometry::triangle::{IndexedTriangles, Triangle};
use crate::launch::LANES;
use bytemuck::{Pod, Zeroable};
use glam::Vec3;

const STRIDE: u32 = LANES as u32;

/// A run of the faces of one component, and its share of the component's links: work for one workgroup. 20 bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct Span {
    /// Bytes 0–3: a vertex of the component, the same for all its spans.
    pub reference: u32,
    /// Bytes 4–7: its first face.
    pub first_face: u32,
    /// Bytes 8–11: how many faces.
    pub face_count: u32,
    /// Bytes 12–15: its first link.
    pub first_link: u32,
    /// Bytes 16–19: how many links.
    pub link_count: u32,
}

const _: () = assert!(size_of::<Span>() == 20);

impl Span {
    /// A span without faces.
    pub const EMPTY: Self = Self {
        reference: 0,
        first_face: 0,
        face_count: 0,
        first_link: 0,
        link_count: 0,
    };
}

/// A component that was closed once, whose seams are known. 12 bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct Component {
    /// Bytes 0–3: its number among all components of the mesh.
    pub number: u32,
    /// Bytes 4–7: its first span.
    pub first_span: u32,
    /// Bytes 8–11: how many spans.
    pub span_count: u32,
}

const _: () = assert!(size_of::<Component>() == 12);

impl Component {
    /// A component without spans.
    pub const EMPTY: Self = Self {
        number: u32::MAX,
        first_span: 0,
        span_count: 0,
    };
}

/// The mesh's vertices, and the faces and links of components that were closed once, by component.
#[derive(Clone, Copy)]
pub struct Surfaces<'a> {
    /// Positions, in the mesh's unit.
    pub vertices: &'a [[f32; 3]],
    /// Three vertices a face.
    pub faces: &'a [[u32; 3]],
    /// Pairs of vertices. A component is closed as long as both vertices of each of its links are at the same place.
    pub links: &'a [[u32; 2]],
}

/// What volumes are measured in.
#[derive(Clone, Copy, Debug)]
pub struct Unit {
    /// Carries the scene to magnitude 1.
    pub scale: PowerOfTwo,
    /// Always 0, hidden from the compiler so that it cannot fuse a product with a sum.
    pub opaque_zero: u32,
}

/// What is known of some faces and links of a component, or of all of them. 36 bytes.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Measure {
    /// Bytes 0–11: smallest coordinates, in the mesh's unit.
    pub low: [f32; 3],
    /// Bytes 12–23: largest coordinates.
    pub high: [f32; 3],
    /// Bytes 24–27: six-fold signed volume between the faces and the reference, in the scene's magnitude, rounded. Positive
    /// where the front sides face out.
    pub volume: f32,
    /// Bytes 28–31: the exact volume is no farther away than twice this.
    pub error: f32,
    /// Bytes 32–35: 0 while all links hold.
    pub is_open: u32,
}

const _: () = assert!(size_of::<Measure>() == 36);

impl Measure {
    /// The measure of no faces, neutral to [`join_step`].
    pub const EMPTY: Self = Self {
        low: [f32::MAX; 3],
        high: [-f32::MAX; 3],
        volume: 0.0,
        error: 0.0,
        is_open: 0,
    };

    /// Of a face. The volume between it and the reference is `(v0 - reference) · ((v1 - v0) × (v2 - v0))`: the sides are
    /// short where there are many faces, so that errors do not grow with their number.
    ///
    /// Each of the six terms has three factors of one rounding each, two products and three sums: `gamma(8)` of the sum of
    /// magnitudes. That sum is itself rounded: covered twice over. Numbers below the normal range may vanish, in the scaled
    /// coordinates, in differences and in products: less than 250 times the smallest normal number.
    #[inline(always)]
    fn of_face(triangle: &Triangle, reference: Vec3, unit: &Unit) -> Self {
        let opaque_zero = unit.opaque_zero;
        let scaled = |v: Vec3| Vec3::from_array(unit.scale.times_each([v.x, v.y, v.z]));
        let corner = scaled(triangle.v0);
        let r = corner - reference;
        let a = scaled(triangle.v1) - corner;
        let b = scaled(triangle.v2) - corner;
        let (xy, yx) = (
            product(a.x, b.y, opaque_zero),
            product(a.y, b.x, opaque_zero),
        );
        let (yz, zy) = (
            product(a.y, b.z, opaque_zero),
            product(a.z, b.y, opaque_zero),
        );
        let (zx, xz) = (
            product(a.z, b.x, opaque_zero),
            product(a.x, b.z, opaque_zero),
        );
        let volume = dot(r, Vec3::new(yz - zy, zx - xz, xy - yx), opaque_zero);
        let terms = Vec3::new(abs(yz) + abs(zy), abs(zx) + abs(xz), abs(xy) + abs(yx));
        let magnitude = dot(Vec3::new(abs(r.x), abs(r.y), abs(r.z)), terms, opaque_zero);
        let bounds = triangle.bounds();
        Self {
            low: positive_zeros(bounds.min).to_array(),
            high: positive_zeros(bounds.max).to_array(),
            volume,
            error: product(gamma(16), magnitude, opaque_zero) + 256.0 * f32::MIN_POSITIVE,
            is_open: 0,
        }
    }

    /// Of all that both are of. The sum's rounding is added to the error; what is lost in adding up errors, less than a
    /// thousandth, is covered by its doubling.
    #[inline(always)]
    #[must_use]
    pub fn joined(self, other: Self) -> Self {
        let volume = self.volume + other.volume;
        let (a, b) = (self.bounds(), other.bounds());
        Self {
            low: lesser(a.min, b.min).to_array(),
            high: greater(a.max, b.max).to_array(),
            volume,
            error: self.error + other.error + UNIT_ROUNDOFF * abs(volume),
            is_open: self.is_open | other.is_open,
        }
    }

    /// The box.
    #[inline]
    #[must_use]
    pub fn bounds(&self) -> Aabb {
        Aabb {
            min: Vec3::from_array(self.low),
            max: Vec3::from_array(self.high),
        }
    }

    /// The side of a whole component that faces out, 1 for the front and −1 for the back; 0 where it is open, or rounding
    /// could have turned the volume's sign.
    #[inline]
    #[must_use]
    pub fn outer_side(&self) -> i32 {
        if self.is_open != 0 {
            0
        } else if self.volume > 2.0 * self.error {
            1
        } else if -self.volume > 2.0 * self.error {
            -1
        } else {
            0
        }
    }

    /// One thread per component and target. Returns the side that faces out; 0 where the target is not certainly outside of
    /// the component's box, and where [`Self::outer_side`] is.
    #[inline]
    #[must_use]
    pub fn side(&self, target: &Target) -> i32 {
        if is_clear_of_box(self.low, self.high, target) {
            self.outer_side()
        } else {
            0
        }
    }
}

/// Phase 1, one lane per run of a span's faces and links: every [`LANES`]th. Returns the measure of these.
#[inline(always)]
#[must_use]
pub fn lane_measure(lane: u32, span: &Span, surfaces: &Surfaces, unit: &Unit) -> Measure {
    let triangles = IndexedTriangles {
        vertices: surfaces.vertices,
        indices: surfaces.faces,
    };
    let reference = crate::load(surfaces.vertices, span.reference, [0.0; 3]);
    let reference = Vec3::from_array(unit.scale.times_each(reference));
    let mut own = Measure::EMPTY;
    for step in 0..span.face_count.div_ceil(STRIDE) {
        let i = step * STRIDE + lane;
        if i < span.face_count {
            let triangle = triangles.triangle(span.first_face + i);
            own = own.joined(Measure::of_face(&triangle, reference, unit));
        }
    }
    for step in 0..span.link_count.div_ceil(STRIDE) {
        let i = step * STRIDE + lane;
        if i < span.link_count {
            let [a, b] = crate::load(surfaces.links, span.first_link + i, [0; 2]);
            let a = crate::load(surfaces.vertices, a, [0.0; 3]);
            let b = crate::load(surfaces.vertices, b, [0.0; 3]);
            let holds = is_same(a[0], b[0]) && is_same(a[1], b[1]) && is_same(a[2], b[2]);
            own.is_open |= !holds as u32;
        }
    }
    own
}

/// Phase 1, one lane per run of a component's spans: every [`LANES`]th. Returns what these are together.
#[inline(always)]
#[must_use]
pub fn lane_joined(lane: u32, component: &Component, spans: &[Measure]) -> Measure {
    let mut own = Measure::EMPTY;
    for step in 0..component.span_count.div_ceil(STRIDE) {
        let i = step * STRIDE + lane;
        if i < component.span_count {
            let measure = crate::load(spans, component.first_span + i, Measure::EMPTY);
            own = own.joined(measure);
        }
    }
    own
}

/// Phase 2, one lane per measure: at each step with `distance` = LANES/2 … 1 every lane below `distance` stores this. Lane 0
/// ends with all together. Returns the lane's new measure.
#[inline(always)]
#[must_use]
pub fn join_step<const LANES: usize>(
    lane: u32,
    distance: u32,
    measures: &[Measure; LANES],
) -> Measure {
    let own = measures[lane as usize % LANES];
    own.joined(measures[(lane + distance) as usize % LANES])
}

/// Equality of numbers by their bits, so that none vanishes: 0 and −0 are equal.
#[inline(always)]
const fn is_same(x: f32, y: f32) -> bool {
    x.to_bits() == y.to_bits() || (x.to_bits() | y.to_bits()) << 1 == 0
}
