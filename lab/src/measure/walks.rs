//! Trees whose traversal counts the nodes and triangles that rays touch.

use super::counts::Tally;
use super::paths::Kind;
use slimbvh::{Bvh, Hit, Ray, Tree, Trees};
use slimbvh_core::classify::Sides;
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::orientation::Target;
use slimbvh_core::ray::PreparedRay;
use slimbvh_core::trace::{ClosestOrAny, Counted};

/// The trees of a picture, by kind of ray.
pub struct Walks<'a> {
    eye: Walk<'a>,
    lights: Vec<Walk<'a>>,
    secondary: Walk<'a>,
}

/// A tree for rays of one kind.
#[derive(Clone, Copy)]
pub struct Walk<'a> {
    bvh: &'a Bvh,
    /// The tree's filter of hits, with the target scaled to the scene's magnitude.
    rule: Option<(Sides<'a>, Target)>,
}

impl<'a> Walks<'a> {
    pub fn new(trees: &Trees<'a>) -> Self {
        let eye = Walk::new(&trees.primary);
        let secondary = trees.mirrors.map(|bvh| Walk::new(&Tree::all(bvh)));
        Self {
            eye,
            lights: trees.lights.iter().map(Walk::new).collect(),
            secondary: secondary.unwrap_or(eye),
        }
    }

    /// The exponent of the scene's magnitude.
    pub fn exponent(&self) -> i32 {
        self.eye.bvh.scene_exponent()
    }

    /// The tree for rays of this kind.
    pub fn of(&self, kind: Kind) -> Walk<'a> {
        match kind {
            Kind::Eye => self.eye,
            Kind::Shadow(light) => self.lights[light],
            Kind::Secondary => self.secondary,
        }
    }
}

impl<'a> Walk<'a> {
    fn new(tree: &Tree<'a>) -> Self {
        let scale = PowerOfTwo::new(tree.bvh.scene_exponent());
        let rule = tree.rule;
        Self {
            bvh: tree.bvh,
            rule: rule.map(|(sides, target)| (sides, target.scaled(&scale))),
        }
    }

    /// Traces a ray, skipping one triangle, and counts.
    pub fn meet(&self, kind: Kind, ray: &Ray, skip: u32) -> (Tally, Hit) {
        let ray = PreparedRay::new(ray, 0);
        let mut found = Counted::new(match kind {
            Kind::Shadow(_) => ClosestOrAny::any(ray.t_max),
            Kind::Eye | Kind::Secondary => ClosestOrAny::closest(ray.t_max),
        });
        let reads = self.bvh.meter(&ray, skip, self.rule, &mut found);
        let nodes = u64::from(found.node_count);
        let node_bytes = self.bvh.codecs().0.node_bytes() as u64;
        let tally = Tally {
            rays: 1,
            nodes,
            boxes: u64::from(found.box_count) + reads.boxes,
            triangles: u64::from(found.triangle_count),
            node_bytes: (nodes + reads.nodes_again) * node_bytes,
            triangle_bytes: reads.triangle_bytes,
        };
        (tally, ray.restore(found.inner.closest.hit))
    }
}
