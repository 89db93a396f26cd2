//! Merging, with rotations (Kensler 2008, "Tree Rotations for Improving Bounding Volume Hierarchies"), each at the moment
//! when its node is made: what is below is final then, but for the next merges.

use super::{Active, Merged, Merges, NO_CLUSTER, Round, Size, joint_area};
use crate::build::node::LEAF_SIZE;
use crate::build::refit::{PyramidBox, WideBox};
use glam::Vec4;

/// A cluster on its way. What a triangle holds means nothing.
#[derive(Clone, Copy)]
struct Member {
    id: u32,
    bounds: WideBox,
    size: Size,
}

impl Member {
    const NONE: Self = Self {
        id: NO_CLUSTER,
        bounds: WideBox::EMPTY,
        size: Size::TRIANGLE,
    };

    #[inline(always)]
    const fn new(id: u32, min: [f32; 3], max: [f32; 3]) -> Self {
        Self {
            id,
            bounds: WideBox {
                min: Vec4::new(min[0], min[1], min[2], 0.0),
                max: Vec4::new(max[0], max[1], max[2], 0.0),
            },
            size: Size::TRIANGLE,
        }
    }

    #[inline(always)]
    fn of_active(i: u32, active: &Active) -> Self {
        Self {
            id: crate::load(active.ids, i, 0),
            bounds: WideBox::of_entry(i, active.boxes),
            size: Size::TRIANGLE,
        }
    }

    /// With its size, where that is not known.
    #[inline(always)]
    fn sized(self, merges: &Merges) -> Self {
        Self {
            size: merges.size(self.id),
            ..self
        }
    }
}

/// Two in one.
#[inline(always)]
fn join(left: &Member, right: &Member) -> Merged {
    let triangles = left.size.triangles + right.size.triangles;
    let (a, b) = (&left.bounds, &right.bounds);
    Merged {
        left_min: [a.min.x, a.min.y, a.min.z],
        left: left.id,
        left_max: [a.max.x, a.max.y, a.max.z],
        right: right.id,
        right_min: [b.min.x, b.min.y, b.min.z],
        triangles,
        right_max: [b.max.x, b.max.y, b.max.z],
        nodes: if triangles > LEAF_SIZE {
            1 + left.size.nodes + right.size.nodes
        } else {
            0
        },
    }
}

/// A cluster that is another now.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Change {
    /// What it is.
    pub merged: Merged,
    /// Its number, or [`NO_CLUSTER`] where nothing changed.
    pub id: u32,
}

impl Change {
    const NONE: Self = Self {
        merged: Merged::NONE,
        id: NO_CLUSTER,
    };

    /// Makes a cluster of two others. Returns it as a part of the next.
    #[inline(always)]
    fn make(&mut self, id: u32, left: &Member, right: &Member) -> Member {
        self.merged = join(left, right);
        self.id = id;
        Member {
            id,
            bounds: left.bounds.union(right.bounds),
            size: self.merged.size(),
        }
    }
}

/// What a merge makes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Merge {
    /// The new cluster, if nothing is rotated.
    pub node: Merged,
    /// Its box.
    pub bounds: PyramidBox,
    /// How it is to be rotated ([`rotate`]), or 0.
    pub rotation: u32,
}

/// What a rotated merge makes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Rotated {
    /// The new cluster.
    pub node: Merged,
    /// A cluster below it that is another now.
    pub first: Change,
    /// One more.
    pub second: Change,
}

/// Two clusters, a and b, and what they hold: c and d, e and f.
struct Family {
    a: Member,
    b: Member,
    c: Member,
    d: Member,
    e: Member,
    f: Member,
    a_is_merge: bool,
    b_is_merge: bool,
}

impl Family {
    #[inline(always)]
    fn load(i: u32, active: &Active, merges: &Merges) -> Self {
        let mut a = Member::of_active(i, active);
        let mut b = Member::of_active(i + 1, active);
        let (mut c, mut d) = (Member::NONE, Member::NONE);
        let a_is_merge = a.id >= merges.triangle_count;
        if a_is_merge {
            let held = merges.merged(a.id);
            a.size = held.size();
            c = Member::new(held.left, held.left_min, held.left_max);
            d = Member::new(held.right, held.right_min, held.right_max);
        }
        let (mut e, mut f) = (Member::NONE, Member::NONE);
        let b_is_merge = b.id >= merges.triangle_count;
        if b_is_merge {
            let held = merges.merged(b.id);
            b.size = held.size();
            e = Member::new(held.left, held.left_min, held.left_max);
            f = Member::new(held.right, held.right_min, held.right_max);
        }
        Self {
            a,
            b,
            c,
            d,
            e,
            f,
            a_is_merge,
            b_is_merge,
        }
    }
}

/// One thread per pair that merges: the clusters at `i` and after it. Reads them and what they hold, which no other pair
/// shares. Returns the new cluster, and whether it is to be rotated.
///
/// Where both are merges, nodes and triangles may change places: a child with one of the other's children, or one child of
/// each. Of all these the tree is taken whose nodes have the least area together, the first of equals, and that without any
/// change before all. Up to [`LEAF_SIZE`] triangles all is one leaf, and nothing changes.
#[inline]
#[must_use]
pub fn merge(i: u32, round: Round, active: &Active, merges: &Merges, opaque_zero: u32) -> Merge {
    let Family {
        a,
        b,
        c,
        d,
        e,
        f,
        a_is_merge,
        b_is_merge,
    } = Family::load(i, active, merges);
    let node = join(&a, &b);
    let bounds = a.bounds.union(b.bounds).entry();
    if node.triangles <= LEAF_SIZE {
        return Merge {
            node,
            bounds,
            rotation: 0,
        };
    }

    // The two nodes' areas together, as they are and as they would be.
    let (area_a, area_b) = (area(&a, &a, opaque_zero), area(&b, &b, opaque_zero));
    let mut best = (area_a + area_b, 0);
    if b_is_merge && round.may_deepen() {
        best = lesser(best, (area_a + area(&a, &f, opaque_zero), 1));
        best = lesser(best, (area_a + area(&a, &e, opaque_zero), 2));
    }
    if a_is_merge && round.may_deepen() {
        best = lesser(best, (area_b + area(&d, &b, opaque_zero), 3));
        best = lesser(best, (area_b + area(&c, &b, opaque_zero), 4));
    }
    if a_is_merge && b_is_merge {
        best = lesser(
            best,
            (area(&c, &e, opaque_zero) + area(&d, &f, opaque_zero), 5),
        );
        best = lesser(
            best,
            (area(&c, &f, opaque_zero) + area(&d, &e, opaque_zero), 6),
        );
    }
    Merge {
        node,
        bounds,
        rotation: best.1,
    }
}

/// One thread per merge that is to be rotated, with what [`merge`] says. Reads what that did, and the sizes of what both hold.
/// Returns the new cluster, and one or two below it to be stored anew.
#[inline]
#[must_use]
pub fn rotate(i: u32, rotation: u32, active: &Active, merges: &Merges) -> Rotated {
    let family = Family::load(i, active, merges);
    let (a, b) = (family.a, family.b);
    let (mut c, mut d) = (family.c, family.d);
    if family.a_is_merge {
        (c, d) = (c.sized(merges), d.sized(merges));
    }
    let (mut e, mut f) = (family.e, family.f);
    if family.b_is_merge {
        (e, f) = (e.sized(merges), f.sized(merges));
    }
    let (mut first, mut second) = (Change::NONE, Change::NONE);
    let node = if rotation == 1 {
        join(&e, &first.make(b.id, &a, &f))
    } else if rotation == 2 {
        join(&first.make(b.id, &a, &e), &f)
    } else if rotation == 3 {
        join(&c, &first.make(a.id, &d, &b))
    } else if rotation == 4 {
        join(&first.make(a.id, &c, &b), &d)
    } else if rotation == 5 {
        join(&first.make(a.id, &c, &e), &second.make(b.id, &d, &f))
    } else {
        join(&first.make(a.id, &c, &f), &second.make(b.id, &d, &e))
    };
    Rotated {
        node,
        first,
        second,
    }
}

#[inline(always)]
fn area(a: &Member, b: &Member, opaque_zero: u32) -> f32 {
    joint_area(&a.bounds, &b.bounds, opaque_zero)
}

/// The lesser of two areas with its number, the first of equals.
#[inline(always)]
const fn lesser(a: (f32, u32), b: (f32, u32)) -> (f32, u32) {
    if b.0 < a.0 { b } else { a }
}
