//! A built hierarchy.

use super::codec::{MeshCodec, NodeCodec};
use super::meter::{Meter, Reads};
use super::sah_cost;
use super::stored::StoredTree;
use slimbvh_core::aabb::Aabb;
use slimbvh_core::bounds::scene_exponent;
use slimbvh_core::classify::Sides;
use slimbvh_core::encode::RootWords;
use slimbvh_core::orientation::Target;
use slimbvh_core::ray::PreparedRay;
use slimbvh_core::trace::{Collector, LeafTriangles, PlainNodes};
use slimbvh_core::{LeafTriangle, Node};

/// A bounding volume hierarchy over a mesh. A [`crate::Builder`] fills it, and can fill it again without allocating.
///
/// ```
/// # use slimbvh::{BuildConfig, Builder, Bvh, Mesh};
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// # let mesh = slimbvh::generate::cuboid(slimbvh_core::Vec3::ZERO, slimbvh_core::Vec3::ONE);
/// let mut bvh = Bvh::default();
/// let mut builder = Builder::new(BuildConfig::default());
/// for _frame in 0..3 {
///     builder.build_into(&mesh, &mut bvh)?;
///     assert_eq!(bvh.triangle_count(), 12);
/// }
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug, Default)]
pub struct Bvh {
    pub(crate) stored: StoredTree,
    pub(crate) mesh_triangle_count: usize,
    pub(crate) bounds: Option<Aabb>,
    pub(crate) scene_exponent: i32,
    pub(crate) depth_bound: u32,
}

impl Bvh {
    /// As [`Self::collect`], for triangles that a rule accepts ([`crate::Tree::rule`], in the scene's magnitude) or for all. Returns
    /// what the ray tests and reads beside the nodes that it opens.
    ///
    /// ```
    /// # use slimbvh::collect::ClosestHit;
    /// # use slimbvh::{BuildConfig, Builder, Mesh, NO_PRIMITIVE, PreparedRay, Ray};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = slimbvh::generate::cuboid(slimbvh_core::Vec3::ZERO, slimbvh_core::Vec3::ONE);
    /// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// let ray = Ray::new([0.5, 0.25, 3.0], [0.0, 0.0, -1.0]);
    /// let prepared = PreparedRay::new(&ray, bvh.scene_exponent());
    /// let mut closest = ClosestHit::new(prepared.t_max);
    /// let reads = bvh.meter(&prepared, NO_PRIMITIVE, None, &mut closest);
    /// assert!(closest.hit.is_hit() && reads.triangle_bytes > 0);
    /// # Ok(())
    /// # }
    /// ```
    pub fn meter(
        &self,
        ray: &PreparedRay,
        skip: u32,
        rule: Option<(Sides, Target)>,
        collector: &mut dyn Collector,
    ) -> Reads {
        self.stored.visit(Meter {
            ray,
            skip,
            rule,
            collector,
        })
    }

    /// The same tree, decoded: nodes and triangles in full.
    ///
    /// ```
    /// # use slimbvh::{BuildConfig, Builder, Mesh, NodeCodec, WideStore};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = slimbvh::generate::cuboid(slimbvh_core::Vec3::ZERO, slimbvh_core::Vec3::ONE);
    /// # let nodes = NodeCodec::Wide(WideStore::Exact);
    /// # let config = BuildConfig { nodes, ..BuildConfig::default() };
    /// # let bvh = Builder::new(config).build(&mesh)?;
    /// // A tree in a codec has no nodes to look at.
    /// assert!(bvh.nodes().is_empty());
    /// let decoded = bvh.decoded();
    /// assert!(!decoded.nodes().is_empty());
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn decoded(&self) -> Self {
        match self.stored.as_plain() {
            Some(_) => self.clone(),
            None => Self {
                stored: self.stored.decode().into(),
                ..*self
            },
        }
    }

    /// The expected cost of tracing: [`sah_cost`] of the decoded nodes.
    ///
    /// ```
    /// # use slimbvh::{BuildConfig, Builder, TreeKind};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = slimbvh::generate::torus_knot(&slimbvh::generate::TorusKnot::default());
    /// let radix = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// let config = BuildConfig { tree: TreeKind::Clustered, ..BuildConfig::default() };
    /// let clustered = Builder::new(config).build(&mesh)?;
    /// assert!(clustered.sah_cost() < radix.sah_cost());
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn sah_cost(&self) -> f64 {
        match self.stored.as_plain() {
            Some(plain) => sah_cost(&plain.nodes),
            None => sah_cost(&self.stored.decode().nodes),
        }
    }

    /// The bytes of the nodes, and those of the triangles in leaf order. Every backend stores the same tree in the same
    /// bytes.
    ///
    /// ```
    /// # use slimbvh::{BuildConfig, Builder, Mesh};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = slimbvh::generate::cuboid(slimbvh_core::Vec3::ZERO, slimbvh_core::Vec3::ONE);
    /// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// // What a file or a GPU's buffers hold.
    /// let [nodes, triangles] = bvh.stored();
    /// assert_eq!((nodes.len(), triangles.len()), (bvh.node_bytes(), bvh.triangle_bytes()));
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn stored(&self) -> [&[u8]; 2] {
        let lists = self.stored.lists().lists();
        lists.map(|list| bytemuck::cast_slice(list.words))
    }

    /// The root's box and, on a lattice, the exponent of its step, as words. `None` for plain nodes.
    ///
    /// ```
    /// # use slimbvh::{BuildConfig, Builder, Mesh, NodeCodec, WideStore};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = slimbvh::generate::cuboid(slimbvh_core::Vec3::ZERO, slimbvh_core::Vec3::ONE);
    /// # let nodes = NodeCodec::Wide(WideStore::Exact);
    /// # let config = BuildConfig { nodes, ..BuildConfig::default() };
    /// # let bvh = Builder::new(config).build(&mesh)?;
    /// // Beside the two lists, a shader needs these for nodes on a lattice.
    /// assert!(bvh.root_words().is_some());
    /// assert_eq!(bvh.decoded().root_words(), None);
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn root_words(&self) -> Option<RootWords> {
        self.stored.lists().root_words()
    }

    /// How nodes and triangles are stored.
    ///
    /// ```
    /// # use slimbvh::{BuildConfig, Builder, Mesh};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = slimbvh::generate::cuboid(slimbvh_core::Vec3::ZERO, slimbvh_core::Vec3::ONE);
    /// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// let (nodes, mesh) = bvh.codecs();
    /// assert_eq!((nodes.name(), mesh.name()), ("f32", "f32"));
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn codecs(&self) -> (NodeCodec, MeshCodec) {
        self.stored.lists().codecs(self.scene_exponent)
    }

    /// Whether a refit in these codecs is of collapsed nodes and leaves all of them and all triangles where they lie.
    pub(crate) fn keeps_shape(&self, (nodes, mesh): (NodeCodec, MeshCodec)) -> bool {
        let (own_nodes, own_mesh) = self.codecs();
        let is_same = own_nodes == nodes && own_mesh.name() == mesh.name();
        nodes.is_collapsed() && is_same && self.node_count() > 0
    }

    /// Sets the mesh's bounds and the exponent that follows from them.
    pub(crate) fn set_bounds(&mut self, bounds: Aabb) {
        self.bounds = (!bounds.is_empty()).then_some(bounds);
        self.scene_exponent = scene_exponent(&bounds);
    }

    /// The box around all triangles, in the mesh's unit; `None` for an empty mesh.
    ///
    /// ```
    /// # use slimbvh::{BuildConfig, Builder, Camera, Mesh};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = slimbvh::generate::cuboid(slimbvh_core::Vec3::ZERO, slimbvh_core::Vec3::ONE);
    /// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// let bounds = bvh.bounds().ok_or("no triangles")?;
    /// let camera = Camera::facing(&bounds, 16.0 / 9.0);
    /// assert_eq!(bounds.max.to_array(), [1.0; 3]);
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn bounds(&self) -> Option<Aabb> {
        self.bounds
    }

    /// The number of triangles in the hierarchy.
    ///
    /// ```
    /// # use slimbvh::{BuildConfig, Builder, Mesh};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = slimbvh::generate::cuboid(slimbvh_core::Vec3::ZERO, slimbvh_core::Vec3::ONE);
    /// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// assert_eq!(bvh.triangle_count(), mesh.indices.len());
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn triangle_count(&self) -> usize {
        self.stored.lists().triangle_count()
    }

    /// The number of triangles in the mesh it was built over. A reduced hierarchy holds fewer.
    ///
    /// ```
    /// # use slimbvh::{Change, Cpu, FrameConfig, ViewSets, ViewTarget};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = slimbvh::generate::icosphere(slimbvh_core::Vec3::ZERO, 1.0, 2);
    /// # let mut views = ViewSets::new(Cpu, FrameConfig::default().reducing());
    /// # views.update(&mesh, &[ViewTarget::rays_from([0.0, 0.0, 4.0], 0.0)?], Change::Scene)?;
    /// # let bvh = views.trees()[0].bvh;
    /// // Primitive indices of a reduced hierarchy are those of its mesh.
    /// assert_eq!(bvh.mesh_triangle_count(), mesh.indices.len());
    /// assert!(bvh.triangle_count() < bvh.mesh_triangle_count());
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn mesh_triangle_count(&self) -> usize {
        self.mesh_triangle_count
    }

    /// The number of inner nodes.
    ///
    /// ```
    /// # use slimbvh::{BuildConfig, Builder, Mesh};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = slimbvh::generate::cuboid(slimbvh_core::Vec3::ZERO, slimbvh_core::Vec3::ONE);
    /// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// println!("{:.1} bytes a node", bvh.node_bytes() as f64 / bvh.node_count() as f64);
    /// # assert!(bvh.node_count() > 0);
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn node_count(&self) -> usize {
        self.stored.lists().lists()[0].count()
    }

    /// Bytes of the nodes.
    ///
    /// ```
    /// # use slimbvh::{BuildConfig, Builder, Mesh};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = slimbvh::generate::cuboid(slimbvh_core::Vec3::ZERO, slimbvh_core::Vec3::ONE);
    /// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// // Two boxes and two links in full.
    /// assert_eq!(bvh.node_bytes(), 64 * bvh.node_count());
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn node_bytes(&self) -> usize {
        self.stored()[0].len()
    }

    /// Bytes of the triangles in the leaves.
    ///
    /// ```
    /// # use slimbvh::{BuildConfig, Builder, Mesh};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = slimbvh::generate::cuboid(slimbvh_core::Vec3::ZERO, slimbvh_core::Vec3::ONE);
    /// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// // Three corners and the primitive's index.
    /// assert_eq!(bvh.triangle_bytes(), 40 * bvh.triangle_count());
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn triangle_bytes(&self) -> usize {
        self.stored()[1].len()
    }

    /// Bytes of the two buffers, which may be larger than the lists.
    ///
    /// ```
    /// # use slimbvh::{BuildConfig, Builder, Mesh};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = slimbvh::generate::cuboid(slimbvh_core::Vec3::ZERO, slimbvh_core::Vec3::ONE);
    /// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// let unused = bvh.held_bytes() - bvh.node_bytes() - bvh.triangle_bytes();
    /// println!("{unused} bytes are free for larger trees");
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn held_bytes(&self) -> usize {
        self.stored.lists().held_bytes()
    }

    /// An upper bound on the nodes along a path from the root.
    ///
    /// ```
    /// # use slimbvh::{BuildConfig, Builder, Mesh};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = slimbvh::generate::cuboid(slimbvh_core::Vec3::ZERO, slimbvh_core::Vec3::ONE);
    /// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// // A stack for a walk of one's own.
    /// let stack = Vec::<u32>::with_capacity(bvh.depth_bound() as usize);
    /// # assert!(bvh.depth_bound() >= 1 && stack.is_empty());
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn depth_bound(&self) -> u32 {
        self.depth_bound
    }

    /// Stored coordinates are the mesh's, times two to this power.
    ///
    /// ```
    /// # use slimbvh::{BuildConfig, Builder, Mesh};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = Mesh {
    /// #     vertices: vec![[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 2.0, 0.0]],
    /// #     indices: vec![[0, 1, 2]],
    /// #     ..Mesh::default()
    /// # };
    /// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// let corner = bvh.leaf_triangles()[0].vertices[3];
    /// // In the mesh's unit.
    /// assert_eq!(corner * 2_f32.powi(-bvh.scene_exponent()), 4.0);
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn scene_exponent(&self) -> i32 {
        self.scene_exponent
    }

    /// The nodes, the root first; empty if a codec stores them.
    ///
    /// ```
    /// # use slimbvh::{BuildConfig, Builder, Mesh};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = slimbvh::generate::cuboid(slimbvh_core::Vec3::ZERO, slimbvh_core::Vec3::ONE);
    /// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// let links = bvh.nodes().iter().flat_map(|node| [node.left, node.right]);
    /// let leaves = links.filter(|link| link.is_leaf());
    /// assert_eq!(leaves.map(|leaf| leaf.count() as usize).sum::<usize>(), bvh.triangle_count());
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn nodes(&self) -> &[Node] {
        self.stored.as_plain().map_or(&[], |plain| &plain.nodes)
    }

    /// The triangles in leaf order, scaled to magnitude 1; empty if a codec stores them.
    ///
    /// ```
    /// # use slimbvh::{BuildConfig, Builder, Mesh};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = slimbvh::generate::cuboid(slimbvh_core::Vec3::ZERO, slimbvh_core::Vec3::ONE);
    /// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// let mut primitives: Vec<u32> = bvh.leaf_triangles().iter().map(|leaf| leaf.primitive).collect();
    /// primitives.sort_unstable();
    /// assert!(primitives.into_iter().eq(0..12));
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn leaf_triangles(&self) -> &[LeafTriangle] {
        let full = self.stored.lists().full_triangles();
        full.map_or(&[], Vec::as_slice)
    }

    /// [`Self::nodes`] as a source for the traversal.
    ///
    /// ```
    /// # use slimbvh_core::trace::{Skip, closest_hit};
    /// # use slimbvh::{BuildConfig, Builder, Mesh, Ray};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = slimbvh::generate::cuboid(slimbvh_core::Vec3::ZERO, slimbvh_core::Vec3::ONE);
    /// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// let ray = Ray::new([0.5, 0.25, 3.0], [0.0, 0.0, -1.0]);
    /// let (nodes, triangles) = (bvh.node_source(), bvh.triangle_source());
    /// // The walk that kernels call.
    /// let hit = closest_hit(&nodes, &triangles, &ray, bvh.scene_exponent(), &Skip::NONE);
    /// assert_eq!(hit, bvh.closest_hit(ray));
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn node_source(&self) -> PlainNodes<'_> {
        PlainNodes(self.nodes())
    }

    /// [`Self::leaf_triangles`] as a source for the traversal.
    ///
    /// ```
    /// # use slimbvh_core::trace::{Skip, any_hit};
    /// # use slimbvh::{BuildConfig, Builder, Mesh, Ray};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = slimbvh::generate::cuboid(slimbvh_core::Vec3::ZERO, slimbvh_core::Vec3::ONE);
    /// # let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// let ray = Ray::new([0.5, 0.25, 3.0], [0.0, 0.0, -1.0]);
    /// let (nodes, triangles) = (bvh.node_source(), bvh.triangle_source());
    /// // Is anything behind the first hit?
    /// let first = Skip(bvh.closest_hit(ray).primitive);
    /// assert!(any_hit(&nodes, &triangles, &ray, bvh.scene_exponent(), &first));
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn triangle_source(&self) -> LeafTriangles<'_> {
        LeafTriangles(self.leaf_triangles())
    }
}
