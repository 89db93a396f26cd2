//! The CPU's trees, and their ray queries.

use crate::backend;
use crate::tree::{Bvh, PacketQuery, Query, Question};
use crate::{Mesh, SurfacePoint, SurfaceRay};
use slimbvh_core::RayEnds;
use slimbvh_core::classify::Sides;
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::orientation::Target;
use slimbvh_core::ray::{Hit, Ray};

/// A hierarchy for rays of one kind. Its filter has a target in the mesh's unit.
pub type Tree<'a> = backend::Tree<'a, Bvh, (Sides<'a>, Target)>;

/// The hierarchies of a picture, all over the same mesh.
pub type Trees<'a> = backend::Trees<'a, Bvh, (Sides<'a>, Target)>;

/// # Ray queries on the CPU
///
/// Those of [`Bvh`], with the same units, for the triangles that count: all of a reduced hierarchy, those of a whole hierarchy that the
/// filter accepts.
///
/// ```
/// use slimbvh::{BuildConfig, Builder, Mesh, Ray, Tree};
/// # let mesh = Mesh {
/// #     vertices: vec![[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 2.0, 0.0]],
/// #     indices: vec![[0, 1, 2]],
/// #     ..Mesh::default()
/// # };
/// let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
/// let tree = Tree::all(&bvh);
/// let ray = Ray::new([1.0, 0.5, 3.0], [0.0, 0.0, -1.0]);
/// assert_eq!(tree.closest_hit(&ray), bvh.closest_hit(ray));
/// # Ok::<(), slimbvh::MeshError>(())
/// ```
impl Tree<'_> {
    /// [`Bvh::closest_hit`] of the triangles that count.
    #[inline]
    #[must_use]
    pub fn closest_hit(&self, ray: impl Into<SurfaceRay>) -> Hit {
        self.query().closest_hit(ray.into())
    }

    /// [`Bvh::any_hit`] of the triangles that count.
    #[doc(alias = "occluded")]
    #[inline]
    #[must_use]
    pub fn any_hit(&self, ray: impl Into<SurfaceRay>) -> bool {
        self.query().any_hit(ray.into())
    }

    /// [`Bvh::nearest_hits`] of the triangles that count.
    #[inline]
    #[must_use]
    pub fn nearest_hits<const K: usize>(&self, ray: impl Into<SurfaceRay>) -> [Hit; K] {
        self.query().nearest_hits(ray.into())
    }

    /// [`Bvh::all_hits`] of the triangles that count.
    #[must_use]
    pub fn all_hits(&self, ray: impl Into<SurfaceRay>) -> Vec<Hit> {
        self.query().all_hits(&ray.into())
    }

    /// [`Bvh::closest_hit_where`] of the triangles that count.
    #[must_use]
    pub fn closest_hit_where(
        &self,
        ray: impl Into<SurfaceRay>,
        mut accepts: impl FnMut(&Hit) -> bool,
    ) -> Hit {
        self.query().closest_hit_where(&ray.into(), &mut accepts)
    }

    /// [`Bvh::any_hit_where`] of the triangles that count.
    #[must_use]
    pub fn any_hit_where(
        &self,
        ray: impl Into<SurfaceRay>,
        mut accepts: impl FnMut(&Hit) -> bool,
    ) -> bool {
        self.query().any_hit_where(&ray.into(), &mut accepts)
    }

    /// [`Bvh::closest_hits`] of the triangles that count.
    pub fn closest_hits<R: Sync>(&self, rays: &[R], hits: &mut Vec<Hit>)
    where
        for<'r> &'r R: Into<SurfaceRay>,
    {
        self.query().closest_hits(rays, hits);
    }

    /// [`Bvh::any_hits`] of the triangles that count.
    pub fn any_hits<R: Sync>(&self, rays: &[R], found: &mut Vec<bool>)
    where
        for<'r> &'r R: Into<SurfaceRay>,
    {
        self.query().any_hits(rays, found);
    }

    /// [`Bvh::surface`]: the point that a ray hits.
    #[must_use]
    pub fn surface(
        &self,
        mesh: &Mesh,
        ray: impl Into<SurfaceRay>,
        hit: &Hit,
    ) -> Option<SurfacePoint> {
        self.query().surface(mesh, &ray.into(), hit)
    }

    #[inline]
    fn query(&self) -> Query<'_> {
        let scale = PowerOfTwo::new(self.bvh.scene_exponent());
        let Self { bvh, rule } = self.scaled(&scale);
        Query { bvh, rule }
    }

    /// The tree with its target at the scene's magnitude.
    pub(super) fn scaled(self, scale: &PowerOfTwo) -> Self {
        Self {
            rule: self
                .rule
                .map(|(sides, target)| (sides, target.scaled(scale))),
            ..self
        }
    }

    /// Traces rays at the scene's magnitude, each with a number, and calls back with each ray's number and answer.
    pub(super) fn ask(
        &self,
        question: Question,
        rays: impl Iterator<Item = (usize, SurfaceRay)>,
        answer: impl FnMut(usize, Hit),
    ) {
        let query = PacketQuery {
            question,
            exponent: 0,
            target: self.rule,
        };
        self.bvh.trace_rays(&query, rays, answer);
    }
}

/// A ray that skips one primitive.
#[inline]
pub fn skipping(ray: Ray, primitive: u32) -> SurfaceRay {
    SurfaceRay {
        ray,
        ends: RayEnds::skipping(primitive),
    }
}
