//! Merging, with rotations (Kensler 2008, "Tree Rotations for Improving Bounding Volume Hierarchies"), each at the moment
//! when its node is made: what is below is final then, but for the next merges.

use super::{Active, Clusters, Content, NOTHING, Round, joint_area};
use crate::node::LEAF_SIZE;
use crate::refit::{PyramidBox, WideBox};

/// A cluster on its way.
#[derive(Clone, Copy)]
struct Member {
    id: u32,
    bounds: WideBox,
    content: Content,
}

impl Member {
    const NOTHING: Self = Self {
        id: NOTHING,
        bounds: WideBox::EMPTY,
        content: Content::TRIANGLE,
    };

    #[inline(always)]
    fn load(id: u32, clusters: &Clusters) -> Self {
        Self {
            id,
            bounds: clusters.bounds(id),
            content: clusters.content(id),
        }
    }

    #[inline(always)]
    fn of_active(i: u32, active: &Active, clusters: &Clusters) -> Self {
        let id = crate::load(active.ids, i, 0);
        Self {
            id,
            bounds: WideBox::of_entry(i, active.boxes),
            content: clusters.content(id),
        }
    }

    /// Two in one, by this number.
    #[inline(always)]
    fn join(id: u32, left: &Self, right: &Self) -> Self {
        let triangles = left.content.triangles + right.content.triangles;
        let nodes = if triangles > LEAF_SIZE {
            1 + left.content.nodes + right.content.nodes
        } else {
            0
        };
        Self {
            id,
            bounds: left.bounds.union(right.bounds),
            content: Content {
                left: left.id,
                right: right.id,
                triangles,
                nodes,
            },
        }
    }

    #[inline(always)]
    const fn is_triangle(&self) -> bool {
        self.content.triangles <= 1
    }

    #[inline(always)]
    fn made(&self) -> Made {
        Made {
            bounds: self.bounds.entry(),
            content: self.content,
            id: self.id,
        }
    }
}

/// A cluster to be stored.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Made {
    /// Its box.
    pub bounds: PyramidBox,
    /// What it holds.
    pub content: Content,
    /// Its number, or [`NOTHING`] where there is none.
    pub id: u32,
}

/// What a merge makes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Merge {
    /// The new cluster.
    pub node: Made,
    /// A cluster below it that is another now.
    pub first: Made,
    /// One more.
    pub second: Made,
}

/// One thread per pair that merges: the clusters at `i` and after it. Reads them and what is two steps below, which no other
/// pair shares. Returns the new cluster, with the number `id`, and up to two below it to be stored anew.
///
/// Where both are one, nodes and triangles may change places: a child with one of the other's children, or one child of each.
/// Of all these the tree is taken whose nodes have the least area together, the first of equals, and that without any change
/// before all. Below [`LEAF_SIZE`] triangles all is one leaf, and nothing changes.
#[inline]
#[must_use]
pub fn merge(
    i: u32,
    id: u32,
    round: Round,
    (active, clusters): (&Active, &Clusters),
    zero: u32,
) -> Merge {
    let a = Member::of_active(i, active, clusters);
    let b = Member::of_active(i + 1, active, clusters);
    let (mut first, mut second) = (Member::NOTHING, Member::NOTHING);
    let mut node = Member::join(id, &a, &b);
    if node.content.triangles <= LEAF_SIZE {
        return Merge {
            node: node.made(),
            first: first.made(),
            second: second.made(),
        };
    }

    // a holds c and d, b holds e and f.
    let (mut c, mut d) = (Member::NOTHING, Member::NOTHING);
    if !a.is_triangle() {
        c = Member::load(a.content.left, clusters);
        d = Member::load(a.content.right, clusters);
    }
    let (mut e, mut f) = (Member::NOTHING, Member::NOTHING);
    if !b.is_triangle() {
        e = Member::load(b.content.left, clusters);
        f = Member::load(b.content.right, clusters);
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
        first = Member::join(b.id, &a, &f);
        node = Member::join(id, &e, &first);
    } else if choice == 2 {
        first = Member::join(b.id, &a, &e);
        node = Member::join(id, &first, &f);
    } else if choice == 3 {
        first = Member::join(a.id, &d, &b);
        node = Member::join(id, &c, &first);
    } else if choice == 4 {
        first = Member::join(a.id, &c, &b);
        node = Member::join(id, &first, &d);
    } else if choice == 5 {
        first = Member::join(a.id, &c, &e);
        second = Member::join(b.id, &d, &f);
        node = Member::join(id, &first, &second);
    } else if choice == 6 {
        first = Member::join(a.id, &c, &f);
        second = Member::join(b.id, &d, &e);
        node = Member::join(id, &first, &second);
    }
    Merge {
        node: node.made(),
        first: first.made(),
        second: second.made(),
    }
}

#[inline(always)]
fn area(a: &Member, b: &Member, zero: u32) -> f32 {
    joint_area(&a.bounds, &b.bounds, zero)
}

/// The lesser of two areas with its number, the first of equals.
#[inline(always)]
const fn lesser(a: (f32, u32), b: (f32, u32)) -> (f32, u32) {
    if b.0 < a.0 { b } else { a }
}
