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
///
/// ```
/// # use slimbvh::{BuildConfig, Builder, Ray, Tree, generate};
/// # use slimbvh_core::{Vec3, classify::Sides, orientation::Target};
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// # let mesh = generate::cuboid(Vec3::ZERO, Vec3::ONE);
/// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
/// # let (eye, sides) = ([0.5, 0.25, 3.0], Sides { components: &[0; 12], sides: &[1] });
/// // The whole box for rays from an eye outside of it: its far sides do not count.
/// let tree = Tree { bvh: &bvh, rule: Some((sides, Target::position(eye))) };
/// let ray = Ray::new(eye, [0.0, 0.0, -1.0]);
/// assert_eq!(tree.closest_hit(ray), bvh.closest_hit(ray));
/// assert_eq!((tree.all_hits(ray).len(), bvh.all_hits(ray).len()), (1, 2));
/// # Ok(())
/// # }
/// ```
pub type Tree<'a> = backend::Tree<'a, Bvh, (Sides<'a>, Target)>;

/// The hierarchies of a picture, all over the same mesh.
///
/// ```
/// # use slimbvh::{BuildConfig, Builder, Mesh, Picture, RenderSettings, Renderer, Scene, Trees};
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// # let mesh = Mesh {
/// #     vertices: vec![[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 2.0, 0.0]],
/// #     indices: vec![[0, 1, 2]],
/// #     ..Mesh::default()
/// # };
/// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
/// # let mut scene = Scene { mesh, ..Scene::default() };
/// # scene.complete(bvh.bounds(), [64, 36]);
/// // One tree for all rays of a picture; each light may have its own.
/// let trees = Trees::all(&bvh, scene.lights.len());
/// let (mut renderer, mut picture) = (Renderer::new(), Picture::default());
/// # let settings = RenderSettings { size: [64, 36], ..RenderSettings::default() };
/// let report = renderer.render_with(&scene, &trees, &settings, &mut picture, |_| ())?;
/// # assert_eq!(report.primary_ray_count, 64 * 36);
/// # Ok(())
/// # }
/// ```
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
    ///
    /// ```
    /// # use slimbvh::{BuildConfig, Builder, Ray, Tree, generate};
    /// # use slimbvh_core::{Vec3, classify::Sides, orientation::Target};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = generate::cuboid(Vec3::ZERO, Vec3::ONE);
    /// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// # let (eye, sides) = ([0.5, 0.25, 3.0], Sides { components: &[0; 12], sides: &[1] });
    /// # let tree = Tree { bvh: &bvh, rule: Some((sides, Target::position(eye))) };
    /// let ray = Ray::new(eye, [0.0, 0.0, -1.0]);
    /// assert_eq!(tree.closest_hit(ray).t, 2.0);
    /// // Behind the near side of the box only the far side is left, which does not count.
    /// assert!(!tree.closest_hit(Ray { t_min: 2.5, ..ray }).is_hit());
    /// # Ok(())
    /// # }
    /// ```
    #[inline]
    #[must_use]
    pub fn closest_hit(&self, ray: impl Into<SurfaceRay>) -> Hit {
        self.query().closest_hit(ray.into())
    }

    /// [`Bvh::any_hit`] of the triangles that count.
    ///
    /// ```
    /// # use slimbvh::{BuildConfig, Builder, Ray, Tree, generate};
    /// # use slimbvh_core::{Vec3, classify::Sides, orientation::Target};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = generate::cuboid(Vec3::ZERO, Vec3::ONE);
    /// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// # let (eye, sides) = ([0.5, 0.25, 3.0], Sides { components: &[0; 12], sides: &[1] });
    /// # let tree = Tree { bvh: &bvh, rule: Some((sides, Target::position(eye))) };
    /// let lamp = eye;
    /// let (beside, behind) = ([2.0, 0.0, 0.0], [0.5, 0.25, -1.0]);
    /// assert!(!tree.any_hit(Ray::between(beside, lamp)));
    /// assert!(tree.any_hit(Ray::between(behind, lamp)));
    /// # Ok(())
    /// # }
    /// ```
    #[doc(alias = "occluded")]
    #[inline]
    #[must_use]
    pub fn any_hit(&self, ray: impl Into<SurfaceRay>) -> bool {
        self.query().any_hit(ray.into())
    }

    /// [`Bvh::nearest_hits`] of the triangles that count.
    ///
    /// ```
    /// # use slimbvh::{BuildConfig, Builder, Ray, Tree, generate};
    /// # use slimbvh_core::{Vec3, classify::Sides, orientation::Target};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = generate::cuboid(Vec3::ZERO, Vec3::ONE);
    /// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// # let (eye, sides) = ([0.5, 0.25, 3.0], Sides { components: &[0; 12], sides: &[1] });
    /// # let tree = Tree { bvh: &bvh, rule: Some((sides, Target::position(eye))) };
    /// let hits = tree.nearest_hits::<2>(Ray::new(eye, [0.0, 0.0, -1.0]));
    /// // The ray meets two sides of the box, of which the far one does not count.
    /// assert_eq!(hits.map(|hit| hit.is_hit()), [true, false]);
    /// # Ok(())
    /// # }
    /// ```
    #[inline]
    #[must_use]
    pub fn nearest_hits<const K: usize>(&self, ray: impl Into<SurfaceRay>) -> [Hit; K] {
        self.query().nearest_hits(ray.into())
    }

    /// [`Bvh::all_hits`] of the triangles that count.
    ///
    /// ```
    /// # use slimbvh::{BuildConfig, Builder, Ray, Tree, generate};
    /// # use slimbvh_core::{Vec3, classify::Sides, orientation::Target};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = generate::cuboid(Vec3::ZERO, Vec3::ONE);
    /// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// # let (eye, sides) = ([0.5, 0.25, 3.0], Sides { components: &[0; 12], sides: &[1] });
    /// # let tree = Tree { bvh: &bvh, rule: Some((sides, Target::position(eye))) };
    /// let hits = tree.all_hits(Ray::new(eye, [0.0, 0.0, -1.0]));
    /// assert_eq!(hits.iter().map(|hit| hit.t).collect::<Vec<_>>(), [2.0]);
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn all_hits(&self, ray: impl Into<SurfaceRay>) -> Vec<Hit> {
        self.query().all_hits(&ray.into())
    }

    /// [`Bvh::closest_hit_where`] of the triangles that count.
    ///
    /// ```
    /// # use slimbvh::{BuildConfig, Builder, Ray, Tree, generate};
    /// # use slimbvh_core::{Vec3, classify::Sides, orientation::Target};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = generate::cuboid(Vec3::ZERO, Vec3::ONE);
    /// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// # let (eye, sides) = ([0.5, 0.25, 3.0], Sides { components: &[0; 12], sides: &[1] });
    /// # let tree = Tree { bvh: &bvh, rule: Some((sides, Target::position(eye))) };
    /// let ray = Ray::new(eye, [0.0, 0.0, -1.0]);
    /// let near = tree.closest_hit(ray).primitive;
    /// // The closure is asked about triangles that count only.
    /// assert!(!tree.closest_hit_where(ray, |hit| hit.primitive != near).is_hit());
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn closest_hit_where(
        &self,
        ray: impl Into<SurfaceRay>,
        mut accepts: impl FnMut(&Hit) -> bool,
    ) -> Hit {
        self.query().closest_hit_where(&ray.into(), &mut accepts)
    }

    /// [`Bvh::any_hit_where`] of the triangles that count.
    ///
    /// ```
    /// # use slimbvh::{BuildConfig, Builder, Ray, Tree, generate};
    /// # use slimbvh_core::{Vec3, classify::Sides, orientation::Target};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = generate::cuboid(Vec3::ZERO, Vec3::ONE);
    /// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// # let (eye, sides) = ([0.5, 0.25, 3.0], Sides { components: &[0; 12], sides: &[1] });
    /// # let tree = Tree { bvh: &bvh, rule: Some((sides, Target::position(eye))) };
    /// let is_glass = vec![true; mesh.indices.len()];
    /// let to_lamp = Ray::between([0.5, 0.25, -1.0], eye);
    /// assert!(!tree.any_hit_where(to_lamp, |hit| !is_glass[hit.primitive as usize]));
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn any_hit_where(
        &self,
        ray: impl Into<SurfaceRay>,
        mut accepts: impl FnMut(&Hit) -> bool,
    ) -> bool {
        self.query().any_hit_where(&ray.into(), &mut accepts)
    }

    /// [`Bvh::closest_hits`] of the triangles that count.
    ///
    /// ```
    /// # use slimbvh::{BuildConfig, Builder, Ray, Tree, generate};
    /// # use slimbvh_core::{Vec3, classify::Sides, orientation::Target};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = generate::cuboid(Vec3::ZERO, Vec3::ONE);
    /// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// # let (eye, sides) = ([0.5, 0.25, 3.0], Sides { components: &[0; 12], sides: &[1] });
    /// # let tree = Tree { bvh: &bvh, rule: Some((sides, Target::position(eye))) };
    /// let rays = [0.0, 1.0].map(|x| Ray::new(eye, [x, 0.0, -1.0]));
    /// let mut hits = Vec::new();
    /// tree.closest_hits(&rays, &mut hits);
    /// assert_eq!((hits[0].t, hits[1].is_hit()), (2.0, false));
    /// # Ok(())
    /// # }
    /// ```
    pub fn closest_hits<R: Sync>(&self, rays: &[R], hits: &mut Vec<Hit>)
    where
        for<'r> &'r R: Into<SurfaceRay>,
    {
        self.query().closest_hits(rays, hits);
    }

    /// [`Bvh::any_hits`] of the triangles that count.
    ///
    /// ```
    /// # use slimbvh::{BuildConfig, Builder, Ray, Tree, generate};
    /// # use slimbvh_core::{Vec3, classify::Sides, orientation::Target};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = generate::cuboid(Vec3::ZERO, Vec3::ONE);
    /// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// # let (eye, sides) = ([0.5, 0.25, 3.0], Sides { components: &[0; 12], sides: &[1] });
    /// # let tree = Tree { bvh: &bvh, rule: Some((sides, Target::position(eye))) };
    /// let points = [[2.0, 0.0, 0.0], [0.5, 0.25, -1.0]];
    /// let to_lamp = points.map(|point| Ray::between(point, eye));
    /// let mut is_in_shadow = Vec::new();
    /// tree.any_hits(&to_lamp, &mut is_in_shadow);
    /// assert_eq!(is_in_shadow, [false, true]);
    /// # Ok(())
    /// # }
    /// ```
    pub fn any_hits<R: Sync>(&self, rays: &[R], found: &mut Vec<bool>)
    where
        for<'r> &'r R: Into<SurfaceRay>,
    {
        self.query().any_hits(rays, found);
    }

    /// [`Bvh::surface`]: the point that a ray hits.
    ///
    /// ```
    /// # use slimbvh::{BuildConfig, Builder, Ray, Tree, generate};
    /// # use slimbvh_core::{Vec3, classify::Sides, orientation::Target};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = generate::cuboid(Vec3::ZERO, Vec3::ONE);
    /// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// # let (eye, sides) = ([0.5, 0.25, 3.0], Sides { components: &[0; 12], sides: &[1] });
    /// # let tree = Tree { bvh: &bvh, rule: Some((sides, Target::position(eye))) };
    /// let ray = Ray::new(eye, [0.0, 0.0, -1.0]);
    /// let hit = tree.closest_hit(ray);
    /// let point = tree.surface(&mesh, ray, &hit).ok_or("the ray hits nothing")?;
    /// assert_eq!((point.position, point.normal), ([0.5, 0.25, 1.0], [0.0, 0.0, 1.0]));
    /// # Ok(())
    /// # }
    /// ```
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
