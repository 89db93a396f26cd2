//! Merging, with rotations (Kensler 2008, "Tree Rotations for Improving Bounding Volume Hierarchies"), each at the moment
//! when its node is made: what is below is final then, but for the next merges.

use super::{Cluster, Clusters, NOTHING, Round, Size, joint_area};
use crate::float::{max, min};
use crate::node::LEAF_SIZE;

/// A cluster with its number and its size.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Member {
    /// The cluster.
    pub cluster: Cluster,
    /// How much is in it.
    pub size: Size,
    /// Its number, or [`NOTHING`].
    pub id: u32,
}

impl Member {
    const NOTHING: Self = Self {
        cluster: Cluster::EMPTY,
        size: Size::TRIANGLE,
        id: NOTHING,
    };

    #[inline(always)]
    fn load<C: Clusters>(id: u32, clusters: &C) -> Self {
        Self {
            cluster: clusters.cluster(id),
            size: clusters.size(id),
            id,
        }
    }

    /// Two in one, by this number.
    #[inline(always)]
    fn join(id: u32, left: &Self, right: &Self) -> Self {
        let (a, b) = (&left.cluster, &right.cluster);
        Self {
            cluster: Cluster {
                min: [
                    min(a.min[0], b.min[0]),
                    min(a.min[1], b.min[1]),
                    min(a.min[2], b.min[2]),
                ],
                left: left.id,
                max: [
                    max(a.max[0], b.max[0]),
                    max(a.max[1], b.max[1]),
                    max(a.max[2], b.max[2]),
                ],
                right: right.id,
            },
            size: left.size.joined(right.size),
            id,
        }
    }

    #[inline(always)]
    const fn is_triangle(&self) -> bool {
        self.size.triangles <= 1
    }
}

/// What a merge makes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Merge {
    /// The new cluster.
    pub node: Member,
    /// A cluster below it that is another now, if its number is not [`NOTHING`].
    pub first: Member,
    /// One more.
    pub second: Member,
}

/// One thread per pair that merges. Reads it and what is two steps below, which no other pair shares. Returns the new
/// cluster, with the number `id`, and up to two below it to be stored anew.
///
/// Where both are one, nodes and triangles may change places: a child with one of the other's children, or one child of each.
/// Of all these the tree is taken whose nodes have the least area together, the first of equals, and that without any change
/// before all. Below [`LEAF_SIZE`] triangles all is one leaf, and nothing changes.
#[inline]
#[must_use]
pub fn merge<C: Clusters>(
    id: u32,
    [left, right]: [u32; 2],
    round: Round,
    clusters: &C,
    zero: u32,
) -> Merge {
    let (a, b) = (Member::load(left, clusters), Member::load(right, clusters));
    let mut made = Merge {
        node: Member::join(id, &a, &b),
        first: Member::NOTHING,
        second: Member::NOTHING,
    };
    if made.node.size.triangles <= LEAF_SIZE {
        return made;
    }

    // a holds c and d, b holds e and f.
    let (mut c, mut d) = (Member::NOTHING, Member::NOTHING);
    if !a.is_triangle() {
        c = Member::load(a.cluster.left, clusters);
        d = Member::load(a.cluster.right, clusters);
    }
    let (mut e, mut f) = (Member::NOTHING, Member::NOTHING);
    if !b.is_triangle() {
        e = Member::load(b.cluster.left, clusters);
        f = Member::load(b.cluster.right, clusters);
    }

    // The two nodes' areas together, as they are and as they would be.
    let (area_a, area_b) = (area(&a, &a, zero), area(&b, &b, zero));
    let (mut least, mut choice) = (area_a + area_b, 0);
    if !b.is_triangle() && round.may_deepen() {
        (least, choice) = lesser((least, choice), (area_a + area(&a, &f, zero), 1));
        (least, choice) = lesser((least, choice), (area_a + area(&a, &e, zero), 2));
    }
    if !a.is_triangle() && round.may_deepen() {
        (least, choice) = lesser((least, choice), (area_b + area(&d, &b, zero), 3));
        (least, choice) = lesser((least, choice), (area_b + area(&c, &b, zero), 4));
    }
    if !a.is_triangle() && !b.is_triangle() {
        let crossed = area(&c, &e, zero) + area(&d, &f, zero);
        (least, choice) = lesser((least, choice), (crossed, 5));
        let crossed = area(&c, &f, zero) + area(&d, &e, zero);
        (_, choice) = lesser((least, choice), (crossed, 6));
    }

    if choice == 1 {
        made.first = Member::join(b.id, &a, &f);
        made.node = Member::join(id, &e, &made.first);
    } else if choice == 2 {
        made.first = Member::join(b.id, &a, &e);
        made.node = Member::join(id, &made.first, &f);
    } else if choice == 3 {
        made.first = Member::join(a.id, &d, &b);
        made.node = Member::join(id, &c, &made.first);
    } else if choice == 4 {
        made.first = Member::join(a.id, &c, &b);
        made.node = Member::join(id, &made.first, &d);
    } else if choice == 5 {
        made.first = Member::join(a.id, &c, &e);
        made.second = Member::join(b.id, &d, &f);
        made.node = Member::join(id, &made.first, &made.second);
    } else if choice == 6 {
        made.first = Member::join(a.id, &c, &f);
        made.second = Member::join(b.id, &d, &e);
        made.node = Member::join(id, &made.first, &made.second);
    }
    made
}

#[inline(always)]
fn area(a: &Member, b: &Member, zero: u32) -> f32 {
    joint_area(&a.cluster, &b.cluster, zero)
}

/// The lesser of two areas with its number, the first of equals.
#[inline(always)]
const fn lesser(a: (f32, u32), b: (f32, u32)) -> (f32, u32) {
    if b.0 < a.0 { b } else { a }
}
