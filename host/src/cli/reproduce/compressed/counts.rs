//! What the rays of a picture touch in a tree: the same on every machine.

use super::methods::Prepared;
use super::paths::{Kind, Paths};
use anyhow::{Context, Result, ensure};
use rayon::prelude::*;
use serde::Serialize;
use slimbvh::{Bvh, Hit, LeafTriangle, MeshCodec, Ray, RenderSettings};
use slimbvh_core::classify::Except;
use slimbvh_core::encode::{LeafWidth, PrintedTriangle};
use slimbvh_core::lattice::LatticeBox;
use slimbvh_core::ray::PreparedRay;
use slimbvh_core::trace::{ClosestOrAny, Counted, LeafTriangles, Place, TriangleSource, traverse};
use std::cell::Cell;

/// Sums over rays.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Tally {
    pub rays: u64,
    /// Inner nodes opened, two boxes each.
    pub nodes: u64,
    /// Triangles tested.
    pub triangles: u64,
    /// Bytes of the nodes that were opened.
    pub node_bytes: u64,
    /// Bytes of the triangles that were tested.
    pub triangle_bytes: u64,
}

/// Of the rays of a picture.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Counts {
    pub eye: Tally,
    pub shadow: Tally,
    /// From mirrors and glass.
    pub secondary: Tally,
    /// Whether there is anything at each pixel.
    #[serde(skip)]
    pub hits: Vec<bool>,
}

impl Tally {
    fn plus(self, other: Self) -> Self {
        Self {
            rays: self.rays + other.rays,
            nodes: self.nodes + other.nodes,
            triangles: self.triangles + other.triangles,
            node_bytes: self.node_bytes + other.node_bytes,
            triangle_bytes: self.triangle_bytes + other.triangle_bytes,
        }
    }

    /// Two boxes a node, a ray.
    pub fn box_tests(&self) -> f64 {
        self.mean(2 * self.nodes)
    }

    /// A ray.
    pub fn triangle_tests(&self) -> f64 {
        self.mean(self.triangles)
    }

    /// Bytes of nodes and triangles, a ray.
    pub fn bytes_read(&self) -> f64 {
        self.mean(self.node_bytes + self.triangle_bytes)
    }

    pub fn mean(&self, sum: u64) -> f64 {
        sum as f64 / self.rays.max(1) as f64
    }
}

impl Counts {
    /// All rays.
    pub fn all(&self) -> Tally {
        self.eye.plus(self.shadow).plus(self.secondary)
    }

    fn of(&mut self, kind: Kind) -> &mut Tally {
        match kind {
            Kind::Eye => &mut self.eye,
            Kind::Shadow => &mut self.shadow,
            Kind::Secondary => &mut self.secondary,
        }
    }

    fn plus(mut self, mut other: Self) -> Self {
        self.hits.append(&mut other.hits);
        Self {
            eye: self.eye.plus(other.eye),
            shadow: self.shadow.plus(other.shadow),
            secondary: self.secondary.plus(other.secondary),
            hits: self.hits,
        }
    }
}

/// Samples that a task takes at once.
const BLOCK: u32 = 512;

/// Follows all paths of a picture through a method's tree. `decoded` is the same tree out of its
/// codec, where triangles are in one.
pub fn count(
    prepared: &Prepared,
    (bvh, decoded): (&Bvh, Option<&Bvh>),
    settings: &RenderSettings,
) -> Result<Counts> {
    let tree = Tree {
        bvh,
        node_bytes: prepared.method.node_bytes() as u64,
        triangles: Records::new(prepared, bvh, decoded)?,
    };
    let paths = Paths::new(&prepared.scene, bvh.scene_exponent(), settings)?;
    let [width, height] = settings.size;
    let sample_count = width * height * settings.sample_count;
    let blocks = (0..sample_count.div_ceil(BLOCK)).into_par_iter();
    let blocks = blocks.map(|block| {
        let mut counts = Counts::default();
        let first = block * BLOCK;
        for sample in first..(first + BLOCK).min(sample_count) {
            let meet = |kind, ray: &Ray, skip| tree.meet(kind, ray, skip, &mut counts);
            let sees = paths.follow(sample, meet);
            counts.hits.push(sees);
        }
        counts
    });
    let blocks: Vec<Counts> = blocks.collect();
    let counts = blocks.into_iter().fold(Counts::default(), Counts::plus);
    tree.triangles.check(&counts)?;
    Ok(counts)
}

/// A tree, and how many bytes there are to read.
struct Tree<'a> {
    bvh: &'a Bvh,
    node_bytes: u64,
    triangles: Records<'a>,
}

/// How triangles are stored.
enum Records<'a> {
    /// All in as many bytes.
    Even(u64),
    /// Each leaf's in as many as it needs: in the decoded tree, bytes by place.
    ByLeaf { decoded: &'a Bvh, bytes: Vec<u8> },
}

impl Tree<'_> {
    /// Traces a ray and counts.
    fn meet(&self, kind: Kind, ray: &Ray, skip: u32, counts: &mut Counts) -> Hit {
        let ray = PreparedRay::new(ray, 0);
        let new = || match kind {
            Kind::Shadow => Counted::new(ClosestOrAny::any(ray.t_max)),
            Kind::Eye | Kind::Secondary => Counted::new(ClosestOrAny::closest(ray.t_max)),
        };
        let mut found = new();
        self.bvh.collect(&ray, skip, &mut found);
        let triangles = u64::from(found.triangle_count);
        let triangle_bytes = match &self.triangles {
            Records::Even(bytes) => triangles * bytes,
            Records::ByLeaf { decoded, bytes } => {
                let source = Metered {
                    triangles: decoded.triangle_source(),
                    bytes,
                    read: Cell::new(0),
                };
                let (nodes, rule) = (decoded.node_source(), Except(skip));
                traverse(&nodes, &source, &ray, &rule, &mut new());
                source.read.get()
            }
        };
        let nodes = u64::from(found.node_count);
        let tally = counts.of(kind);
        *tally = tally.plus(Tally {
            rays: 1,
            nodes,
            triangles,
            node_bytes: nodes * self.node_bytes,
            triangle_bytes,
        });
        ray.restore(found.inner.closest.hit)
    }
}

impl<'a> Records<'a> {
    fn new(prepared: &Prepared, bvh: &Bvh, decoded: Option<&'a Bvh>) -> Result<Self> {
        let MeshCodec::Lattice { step_exponent } = prepared.config.mesh else {
            return Ok(Self::Even(match prepared.config.mesh {
                MeshCodec::Leaf10 => size_of::<PrintedTriangle>() as u64,
                MeshCodec::F32 | MeshCodec::Lattice { .. } => size_of::<LeafTriangle>() as u64,
            }));
        };
        let decoded = decoded.context("the tree must be decoded")?;
        // What a leaf's triangles take follows from its box.
        let step_exponent = (step_exponent + bvh.scene_exponent()).clamp(-126, 127);
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
        let stored = bvh.triangle_bytes();
        ensure!(sum == stored, "triangles take {stored} bytes, not {sum}");
        Ok(Self::ByLeaf { decoded, bytes })
    }

    /// No triangle takes less than a narrow one or more than a wide one: both trees are walked alike.
    fn check(&self, counts: &Counts) -> Result<()> {
        let Tally {
            triangles,
            triangle_bytes,
            ..
        } = counts.all();
        let range = 16 * triangles..=40 * triangles;
        ensure!(
            range.contains(&triangle_bytes),
            "{triangles} triangles cannot take {triangle_bytes} bytes"
        );
        Ok(())
    }
}

/// Triangles that sum up what is read of them.
struct Metered<'a> {
    triangles: LeafTriangles<'a>,
    bytes: &'a [u8],
    read: Cell<u64>,
}

impl TriangleSource<()> for Metered<'_> {
    fn corners(&self, place: &Place<()>, axes: [u32; 3]) -> [[f32; 3]; 3] {
        let bytes = self.bytes.get((place.first + place.number) as usize);
        let read = self.read.get() + u64::from(bytes.copied().unwrap_or_default());
        self.read.set(read);
        self.triangles.corners(place, axes)
    }

    fn primitive(&self, place: &Place<()>) -> u32 {
        TriangleSource::<()>::primitive(&self.triangles, place)
    }
}
