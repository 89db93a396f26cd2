//! Ready collectors for [`crate::Bvh::collect`].
//!
//! ```
//! use slimbvh::collect::{ClosestHit, Counted};
//! use slimbvh::{BuildConfig, Builder, PreparedRay, Ray, RayEnds, generate};
//!
//! let mesh = generate::teapot();
//! let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
//! let ray = Ray::new([0.1, 0.2, 9.0], [0.0, 0.0, -1.0]);
//! let prepared = PreparedRay::new(&ray, bvh.scene_exponent());
//! let mut counted = Counted::new(ClosestHit::new(prepared.t_max));
//! bvh.collect(&prepared, &RayEnds::NONE, &mut counted);
//! println!("{} nodes, {} triangles", counted.node_count, counted.triangle_count);
//! assert_eq!(prepared.restore(counted.inner.hit), bvh.closest_hit(ray));
//! # Ok::<(), slimbvh::MeshError>(())
//! ```

pub use slimbvh_core::trace::{AnyHit, ClosestHit, Counted, FINAL, NearestHits};
