//! Trees whose traversal counts the nodes and triangles that rays touch.

use super::counts::Tally;
use super::paths::Kind;
use anyhow::{Result, ensure};
use slimbvh::{Bvh, Hit, Ray, Tree, Trees};
use slimbvh_core::classify::{FacingFilter, Sides};
use slimbvh_core::encode::LeafWidth;
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::lattice::LatticeBox;
use slimbvh_core::orientation::Target;
use slimbvh_core::ray::PreparedRay;
use slimbvh_core::trace::{
    ClosestOrAny, Counted, HitFilter, LeafSlot, LeafTriangles, Skip, TriangleSource, traverse,
};
use std::borrow::Cow;
use std::cell::Cell;

/// The trees of a picture, by kind of ray.
pub struct Walks<'a> {
    stored: Vec<Stored<'a>>,
    eye: Course<'a>,
    lights: Vec<Course<'a>>,
    secondary: Option<Course<'a>>,
}

/// The tree that rays of one kind traverse.
#[derive(Clone, Copy)]
struct Course<'a> {
    /// The index in `stored`.
    place: usize,
    /// The tree's filter of hits, with the target scaled to the scene's magnitude.
    rule: Option<(Sides<'a>, Target)>,
}

/// A tree, and the bytes of its records.
struct Stored<'a> {
    bvh: &'a Bvh,
    /// The decoded tree, if it is traversed too.
    decoded: Option<Cow<'a, Bvh>>,
    node_bytes: u64,
    records: Records,
}

/// The bytes of triangles.
enum Records {
    /// All triangles take this many bytes.
    Even(u64),
    /// Each leaf has a size of its own: the bytes of each triangle, by its index in the leaves.
    ByLeaf(Vec<u8>),
}

/// A tree for rays of one kind.
pub struct Walk<'a> {
    stored: &'a Stored<'a>,
    rule: Option<(Sides<'a>, Target)>,
}

impl<'a> Walks<'a> {
    /// # Errors
    /// If a tree's triangles do not take the bytes that follow from their leaves.
    pub fn new(trees: &Trees<'a>) -> Result<Self> {
        let mut stored: Vec<Stored<'a>> = Vec::new();
        let mut course = |tree: &Tree<'a>| -> Result<Course<'a>> {
            let place = stored
                .iter()
                .position(|stored| std::ptr::eq(stored.bvh, tree.bvh));
            let place = match place {
                Some(place) => place,
                None => {
                    stored.push(Stored::new(tree.bvh)?);
                    stored.len() - 1
                }
            };
            if tree.rule.is_some() {
                stored[place].decode();
            }
            let scale = PowerOfTwo::new(tree.bvh.scene_exponent());
            let rule = tree.rule;
            let rule = rule.map(|(sides, target)| (sides, target.scaled(&scale)));
            Ok(Course { place, rule })
        };
        let eye = course(&trees.primary)?;
        let lights = trees.lights.iter().map(&mut course);
        let lights = lights.collect::<Result<_>>()?;
        let secondary = trees.mirrors.map(|bvh| course(&Tree::all(bvh)));
        let secondary = secondary.transpose()?;
        Ok(Self {
            stored,
            eye,
            lights,
            secondary,
        })
    }

    /// The exponent of the scene's magnitude.
    pub fn exponent(&self) -> i32 {
        self.stored[self.eye.place].bvh.scene_exponent()
    }

    /// The tree for rays of this kind.
    pub fn of(&self, kind: Kind) -> Walk<'_> {
        let course = match kind {
            Kind::Eye => self.eye,
            Kind::Shadow(light) => self.lights[light],
            Kind::Secondary => self.secondary.unwrap_or(self.eye),
        };
        Walk {
            stored: &self.stored[course.place],
            rule: course.rule,
        }
    }
}

impl Walk<'_> {
    /// Traces a ray, skipping one triangle, and counts.
    pub fn meet(&self, kind: Kind, ray: &Ray, skip: u32) -> (Tally, Hit) {
        let ray = PreparedRay::new(ray, 0);
        let new = || match kind {
            Kind::Shadow(_) => Counted::new(ClosestOrAny::any(ray.t_max)),
            Kind::Eye | Kind::Secondary => Counted::new(ClosestOrAny::closest(ray.t_max)),
        };
        let mut found = new();
        // Traverse the stored tree if all triangles count. Otherwise, or if leaves differ in size, traverse the decoded one.
        let mut read = None;
        match &self.rule {
            None => {
                self.stored.bvh.collect(&ray, skip, &mut found);
                if let Records::ByLeaf(_) = self.stored.records {
                    read = self.stored.traverse(&ray, &Skip(skip), &mut new());
                }
            }
            Some((sides, target)) => {
                let (sides, target) = (*sides, *target);
                let rule = FacingFilter {
                    skip,
                    sides,
                    target,
                };
                read = self.stored.traverse(&ray, &rule, &mut found);
            }
        }
        let (nodes, triangles) = (u64::from(found.node_count), u64::from(found.triangle_count));
        let tally = Tally {
            rays: 1,
            nodes,
            triangles,
            node_bytes: nodes * self.stored.node_bytes,
            triangle_bytes: match (&self.stored.records, read) {
                (Records::Even(bytes), _) => triangles * bytes,
                (Records::ByLeaf(_), read) => read.unwrap_or_default(),
            },
        };
        (tally, ray.restore(found.inner.closest.hit))
    }
}

impl<'a> Stored<'a> {
    fn new(bvh: &'a Bvh) -> Result<Self> {
        let mut stored = Self {
            bvh,
            decoded: None,
            node_bytes: bvh.codecs().0.node_bytes() as u64,
            records: Records::Even((bvh.triangle_bytes() / bvh.triangle_count().max(1)) as u64),
        };
        if let Some(step_exponent) = bvh.codecs().1.step_exponent() {
            let step_exponent = (step_exponent + bvh.scene_exponent()).clamp(-126, 127);
            stored.records = leaf_bytes(stored.decode(), step_exponent, bvh.triangle_bytes())?;
        }
        Ok(stored)
    }

    /// Decodes the tree, once.
    fn decode(&mut self) -> &Bvh {
        let bvh = self.bvh;
        self.decoded.get_or_insert_with(|| match bvh.codecs() {
            plain if plain == Default::default() => Cow::Borrowed(bvh),
            _ => Cow::Owned(bvh.decoded()),
        })
    }

    /// Traverses the decoded tree, and sums the bytes of triangles if leaves differ in size.
    fn traverse(
        &self,
        ray: &PreparedRay,
        rule: &impl HitFilter,
        found: &mut Counted<ClosestOrAny>,
    ) -> Option<u64> {
        let decoded = self.decoded.as_deref()?;
        let source = Metered {
            triangles: decoded.triangle_source(),
            bytes: match &self.records {
                Records::ByLeaf(bytes) => bytes,
                Records::Even(_) => &[],
            },
            read: Cell::new(0),
        };
        traverse(&decoded.node_source(), &source, ray, rule, found);
        Some(source.read.get())
    }
}

/// The bytes of each leaf's triangles, which follow from its box.
fn leaf_bytes(decoded: &Bvh, step_exponent: i32, stored: usize) -> Result<Records> {
    let mut bytes = vec![0; decoded.triangle_count()];
    for node in decoded.nodes() {
        for (leaf, bounds) in [(node.left, node.left_box()), (node.right, node.right_box())] {
            if leaf.is_leaf() && leaf.count() > 0 {
                let width = LeafWidth::of(&LatticeBox::around(&bounds, step_exponent));
                let first = leaf.first() as usize;
                bytes[first..][..leaf.count() as usize].fill(4 * width.words() as u8);
            }
        }
    }
    let sum: usize = bytes.iter().map(|&bytes| usize::from(bytes)).sum();
    ensure!(sum == stored, "triangles take {stored} bytes, not {sum}");
    Ok(Records::ByLeaf(bytes))
}

/// Triangles that sum the bytes read from them.
struct Metered<'a> {
    triangles: LeafTriangles<'a>,
    bytes: &'a [u8],
    read: Cell<u64>,
}

impl TriangleSource<()> for Metered<'_> {
    fn corners(&self, place: &LeafSlot<()>, axes: [u32; 3]) -> [[f32; 3]; 3] {
        let bytes = self.bytes.get((place.first + place.number) as usize);
        let read = self.read.get() + u64::from(bytes.copied().unwrap_or_default());
        self.read.set(read);
        self.triangles.corners(place, axes)
    }

    fn primitive(&self, place: &LeafSlot<()>) -> u32 {
        TriangleSource::<()>::primitive(&self.triangles, place)
    }
}
