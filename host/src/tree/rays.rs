//! The public ray queries of a hierarchy.

use super::bvh::Bvh;
use crate::Mesh;
use slimbvh_core::ray::{Hit, PreparedRay};
use slimbvh_core::trace::Collector;
use slimbvh_core::{RayEnds, SurfacePoint, SurfaceRay};

/// # Ray queries
///
/// Rays are in the mesh's unit. A ray with a zero direction, or with a NaN or infinite component (except an infinite `t_max`), hits
/// nothing. Every query takes a [`crate::Ray`] or a [`SurfaceRay`], which leaves a surface or leads to one.
impl Bvh {
    /// The hit with the smallest t; among equals, the smallest primitive index. [`Hit::MISS`] if there is no hit.
    ///
    /// ```
    /// # use slimbvh::{BuildConfig, Builder, Mesh, Ray};
    /// let mesh = Mesh {
    ///     vertices: vec![[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 2.0, 0.0]],
    ///     indices: vec![[0, 1, 2]],
    ///     ..Mesh::default()
    /// };
    /// let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// let hit = bvh.closest_hit(Ray::new([1.0, 0.5, 3.0], [0.0, 0.0, -1.0]));
    /// assert_eq!((hit.primitive, hit.t), (0, 3.0));
    /// # Ok::<(), slimbvh::MeshError>(())
    /// ```
    #[inline]
    #[must_use]
    pub fn closest_hit(&self, ray: impl Into<SurfaceRay>) -> Hit {
        self.query().closest_hit(ray.into())
    }

    /// Whether the ray hits any triangle; stops at the first hit found.
    ///
    /// With [`crate::Ray::between`] it asks whether anything is between two points:
    ///
    /// ```
    /// # use slimbvh::{BuildConfig, Builder, Mesh, Ray};
    /// # let mesh = Mesh {
    /// #     vertices: vec![[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 2.0, 0.0]],
    /// #     indices: vec![[0, 1, 2]],
    /// #     ..Mesh::default()
    /// # };
    /// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// let (above, corner, below) = ([1.0, 0.5, 3.0], [4.0, 0.0, 0.0], [1.0, 0.5, -2.0]);
    /// assert!(bvh.any_hit(Ray::between(above, below)));
    /// assert!(!bvh.any_hit(Ray::between(above, corner)));
    /// # Ok::<(), slimbvh::MeshError>(())
    /// ```
    #[doc(alias = "occluded")]
    #[inline]
    #[must_use]
    pub fn any_hit(&self, ray: impl Into<SurfaceRay>) -> bool {
        self.query().any_hit(ray.into())
    }

    /// The K hits with the smallest `(t, primitive)`, in order, padded with [`Hit::MISS`].
    ///
    /// ```
    /// # use slimbvh::{BuildConfig, Builder, Mesh, Ray};
    /// # let mesh = Mesh {
    /// #     vertices: vec![[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 1.0], [4.0, 0.0, 1.0], [0.0, 2.0, 1.0]],
    /// #     indices: vec![[0, 1, 2], [3, 4, 5]],
    /// #     ..Mesh::default()
    /// # };
    /// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// let hits = bvh.nearest_hits::<3>(Ray::new([1.0, 0.5, 3.0], [0.0, 0.0, -1.0]));
    /// assert_eq!(hits.map(|hit| hit.is_hit()), [true, true, false]);
    /// assert_eq!((hits[0].t, hits[1].t), (2.0, 3.0));
    /// # Ok::<(), slimbvh::MeshError>(())
    /// ```
    #[inline]
    #[must_use]
    pub fn nearest_hits<const K: usize>(&self, ray: impl Into<SurfaceRay>) -> [Hit; K] {
        self.query().nearest_hits(ray.into())
    }

    /// All hits along the ray, in the order of `(t, primitive)`.
    ///
    /// ```
    /// # use slimbvh::{BuildConfig, Builder, Mesh, Ray};
    /// # let mesh = Mesh {
    /// #     vertices: vec![[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 1.0], [4.0, 0.0, 1.0], [0.0, 2.0, 1.0]],
    /// #     indices: vec![[0, 1, 2], [3, 4, 5]],
    /// #     ..Mesh::default()
    /// # };
    /// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// let hits = bvh.all_hits(Ray::new([1.0, 0.5, 3.0], [0.0, 0.0, -1.0]));
    /// let thickness = hits[1].t - hits[0].t;
    /// assert_eq!((hits.len(), thickness), (2, 1.0));
    /// # Ok::<(), slimbvh::MeshError>(())
    /// ```
    #[must_use]
    pub fn all_hits(&self, ray: impl Into<SurfaceRay>) -> Vec<Hit> {
        self.query().all_hits(&ray.into())
    }

    /// [`Self::closest_hit`] of the hits that a closure accepts: a mask of parts or materials, an alpha test.
    ///
    /// The closure gets hits in no particular order, with t in units of the ray's direction, and no hits beyond one that it accepted.
    /// It may trace other rays. Slower than [`Self::closest_hit`]: one ray at a time, with a call for each node.
    ///
    /// ```
    /// # use slimbvh::{BuildConfig, Builder, Mesh, Part, Ray};
    /// # let mesh = Mesh {
    /// #     vertices: vec![[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 1.0], [4.0, 0.0, 1.0], [0.0, 2.0, 1.0]],
    /// #     indices: vec![[0, 1, 2], [3, 4, 5]],
    /// #     materials: vec![0, 1],
    /// #     ..Mesh::default()
    /// # };
    /// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// let ray = Ray::new([1.0, 0.5, 3.0], [0.0, 0.0, -1.0]);
    /// // A mask: only triangles of material 0.
    /// let floor = bvh.closest_hit_where(ray, |hit| mesh.materials[hit.primitive as usize] == 0);
    /// assert_eq!((floor.primitive, floor.t), (0, 3.0));
    /// // An alpha test: v is a texture coordinate, and the texture has holes.
    /// let is_opaque = |v: f32| (v * 8.0) as u32 % 2 == 1;
    /// let leaf = bvh.closest_hit_where(ray, |hit| hit.primitive != 1 || is_opaque(hit.v));
    /// assert_eq!(leaf.primitive, 0);
    /// # Ok::<(), slimbvh::MeshError>(())
    /// ```
    #[must_use]
    pub fn closest_hit_where(
        &self,
        ray: impl Into<SurfaceRay>,
        mut accepts: impl FnMut(&Hit) -> bool,
    ) -> Hit {
        self.query().closest_hit_where(&ray.into(), &mut accepts)
    }

    /// Whether a closure accepts any hit, as [`Self::closest_hit_where`]; stops at the first that it accepts.
    ///
    /// ```
    /// # use slimbvh::{BuildConfig, Builder, Mesh, Ray};
    /// # let mesh = Mesh {
    /// #     vertices: vec![[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 2.0, 0.0]],
    /// #     indices: vec![[0, 1, 2]],
    /// #     ..Mesh::default()
    /// # };
    /// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// // Transparent triangles cast no shadow.
    /// let is_transparent = [true];
    /// let ray = Ray::new([1.0, 0.5, 3.0], [0.0, 0.0, -1.0]);
    /// assert!(bvh.any_hit(ray));
    /// assert!(!bvh.any_hit_where(ray, |hit| !is_transparent[hit.primitive as usize]));
    /// # Ok::<(), slimbvh::MeshError>(())
    /// ```
    #[must_use]
    pub fn any_hit_where(
        &self,
        ray: impl Into<SurfaceRay>,
        mut accepts: impl FnMut(&Hit) -> bool,
    ) -> bool {
        self.query().any_hit_where(&ray.into(), &mut accepts)
    }

    /// [`Bvh::closest_hit`] of many rays, in parallel. `hits` is resized to the number of rays.
    ///
    /// Neighbouring rays should be adjacent in the list: the rays of a packet share node reads. [`crate::Tiles`]
    /// is such an order of a picture's rays.
    ///
    /// ```
    /// # use slimbvh::{BuildConfig, Builder, Mesh, Ray};
    /// # let mesh = Mesh {
    /// #     vertices: vec![[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 2.0, 0.0]],
    /// #     indices: vec![[0, 1, 2]],
    /// #     ..Mesh::default()
    /// # };
    /// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// let rays = [0.5, 1.0, 9.0].map(|x| Ray::new([x, 0.5, 3.0], [0.0, 0.0, -1.0]));
    /// let mut hits = Vec::new();
    /// bvh.closest_hits(&rays, &mut hits);
    /// assert_eq!([hits[0].t, hits[1].t], [3.0; 2]);
    /// assert!(!hits[2].is_hit());
    /// # Ok::<(), slimbvh::MeshError>(())
    /// ```
    pub fn closest_hits<R: Sync>(&self, rays: &[R], hits: &mut Vec<Hit>)
    where
        for<'r> &'r R: Into<SurfaceRay>,
    {
        self.query().closest_hits(rays, hits);
    }

    /// [`Bvh::any_hit`] of many rays, as [`Bvh::closest_hits`].
    ///
    /// ```
    /// # use slimbvh::{BuildConfig, Builder, Mesh, Ray};
    /// # let mesh = Mesh {
    /// #     vertices: vec![[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 2.0, 0.0]],
    /// #     indices: vec![[0, 1, 2]],
    /// #     ..Mesh::default()
    /// # };
    /// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// let lamp = [1.0, 0.5, 3.0];
    /// let rays = [[1.0, 0.5, -1.0], [1.0, 0.5, 1.0]].map(|point| Ray::between(point, lamp));
    /// let mut is_in_shadow = Vec::new();
    /// bvh.any_hits(&rays, &mut is_in_shadow);
    /// assert_eq!(is_in_shadow, [true, false]);
    /// # Ok::<(), slimbvh::MeshError>(())
    /// ```
    pub fn any_hits<R: Sync>(&self, rays: &[R], found: &mut Vec<bool>)
    where
        for<'r> &'r R: Into<SurfaceRay>,
    {
        self.query().any_hits(rays, found);
    }

    /// [`Bvh::closest_hits`] on this thread, for callers with their own threads.
    ///
    /// ```
    /// # use slimbvh::{BuildConfig, Builder, Hit, Mesh, Ray};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = Mesh {
    /// #     vertices: vec![[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 2.0, 0.0]],
    /// #     indices: vec![[0, 1, 2]],
    /// #     ..Mesh::default()
    /// # };
    /// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// # let bvh = &bvh;
    /// let rays = vec![Ray::new([1.0, 0.5, 3.0], [0.0, 0.0, -1.0]); 1000];
    /// let mut hits = vec![Hit::MISS; rays.len()];
    /// std::thread::scope(|threads| {
    ///     for (rays, hits) in rays.chunks(500).zip(hits.chunks_mut(500)) {
    ///         threads.spawn(move || bvh.closest_hits_of_block(rays, hits));
    ///     }
    /// });
    /// assert!(hits.iter().all(Hit::is_hit));
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Panics
    /// If `hits` is shorter than `rays`.
    pub fn closest_hits_of_block<R>(&self, rays: &[R], hits: &mut [Hit])
    where
        for<'r> &'r R: Into<SurfaceRay>,
    {
        self.query().closest_hits_of_block(rays, hits);
    }

    /// [`Bvh::any_hits`] on this thread, as [`Bvh::closest_hits_of_block`].
    ///
    /// ```
    /// # use slimbvh::{BuildConfig, Builder, Mesh, Ray};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = Mesh {
    /// #     vertices: vec![[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 2.0, 0.0]],
    /// #     indices: vec![[0, 1, 2]],
    /// #     ..Mesh::default()
    /// # };
    /// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// let lamp = [1.0, 0.5, 3.0];
    /// let rays = [[1.0, 0.5, -1.0], [1.0, 0.5, 1.0]].map(|point| Ray::between(point, lamp));
    /// let mut is_in_shadow = [false; 2];
    /// bvh.any_hits_of_block(&rays, &mut is_in_shadow);
    /// assert_eq!(is_in_shadow, [true, false]);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Panics
    /// If `found` is shorter than `rays`.
    pub fn any_hits_of_block<R>(&self, rays: &[R], found: &mut [bool])
    where
        for<'r> &'r R: Into<SurfaceRay>,
    {
        self.query().any_hits_of_block(rays, found);
    }

    /// Traces one ray with any collector, for example one that counts nodes and triangles. The ray is prepared with
    /// [`Bvh::scene_exponent`]; the collector gets hits with t in the prepared ray's units ([`PreparedRay::restore`]). Slower than
    /// the other queries: a call for each node.
    ///
    /// ```
    /// use slimbvh::{Collector, Hit, PreparedRay, RayEnds};
    /// # use slimbvh::{BuildConfig, Builder, Mesh, Ray};
    /// # let mesh = Mesh {
    /// #     vertices: vec![[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 1.0], [4.0, 0.0, 1.0], [0.0, 2.0, 1.0]],
    /// #     indices: vec![[0, 1, 2], [3, 4, 5]],
    /// #     ..Mesh::default()
    /// # };
    /// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    ///
    /// /// The hit that is farthest away.
    /// struct Farthest {
    ///     hit: Hit,
    ///     t_max: f32,
    /// }
    ///
    /// impl Collector for Farthest {
    ///     fn limit(&self) -> f32 {
    ///         self.t_max
    ///     }
    ///
    ///     fn offer(&mut self, hit: Hit) {
    ///         if !self.hit.is_hit() || hit.t > self.hit.t {
    ///             self.hit = hit;
    ///         }
    ///     }
    /// }
    ///
    /// let ray = Ray::new([1.0, 0.5, 3.0], [0.0, 0.0, -1.0]);
    /// let prepared = PreparedRay::new(&ray, bvh.scene_exponent());
    /// let mut farthest = Farthest { hit: Hit::MISS, t_max: prepared.t_max };
    /// bvh.collect(&prepared, &RayEnds::NONE, &mut farthest);
    /// assert_eq!(prepared.restore(farthest.hit).t, 3.0);
    /// # Ok::<(), slimbvh::MeshError>(())
    /// ```
    pub fn collect(&self, ray: &PreparedRay, ends: &RayEnds, collector: &mut dyn Collector) {
        self.query().collect(ray, ends, collector);
    }

    /// The point that the ray hits, in the mesh's unit: its position and error, both normals, and the rays that leave it. `None` for a
    /// miss, and for a mesh with a different number of triangles than the hierarchy's.
    ///
    /// The mesh must be the one that the hierarchy is built over, `ray` and `hit` those of a query of this hierarchy.
    ///
    /// ```
    /// # use slimbvh::{BuildConfig, Builder, Mesh, Ray};
    /// # let mesh = Mesh {
    /// #     vertices: vec![[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 2.0, 0.0]],
    /// #     indices: vec![[0, 1, 2]],
    /// #     ..Mesh::default()
    /// # };
    /// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// let ray = Ray::new([1.0, 0.5, 3.0], [0.0, 0.0, -1.0]);
    /// let hit = bvh.closest_hit(ray);
    /// let point = bvh.surface(&mesh, &ray, &hit).expect("the ray hits");
    /// assert_eq!(point.position, [1.0, 0.5, 0.0]);
    /// assert_eq!(point.normal, [0.0, 0.0, 1.0]);
    /// // A mirrored ray, and a shadow ray to a lamp: neither hits the surface that it leaves.
    /// let mirrored = bvh.closest_hit(point.ray([0.0, 0.0, 1.0]));
    /// let is_in_shadow = bvh.any_hit(Ray::between(&point, [2.0, 2.0, 2.0]));
    /// assert!(!mirrored.is_hit() && !is_in_shadow);
    /// # Ok::<(), slimbvh::MeshError>(())
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
}
