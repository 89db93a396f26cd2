//! The GPU's trees, and their ranges.

use super::buffer::Range;
use super::bvh::Built;
use super::sides::TargetRanges;
use super::{Bvh, Components, Gpu, GpuError, Misfit, TargetSides};
use crate::backend::{self, Deferral};

/// A hierarchy for rays of one kind.
///
/// ```no_run
/// use slimbvh::gpu::{Bvh, Components, Frame, GpuError, Query, Rays, TargetSides, Tree, wgpu};
/// # fn run(
/// #     frame: &mut Frame, bvh: &Bvh, known: &(Components, TargetSides), rays: Rays,
/// #     to: &[wgpu::Buffer; 2],
/// # ) -> Result<(), GpuError> {
/// # let ((components, sides), [hits, shadows]) = (known, to);
/// // All triangles count; or only those that face the target of the sides.
/// Tree::all(bvh).trace(frame, Query::Closest, rays, hits.slice(..))?;
/// let tree = Tree { bvh, rule: Some((components, sides)) };
/// tree.trace(frame, Query::Any, rays, shadows.slice(..))?;
/// # Ok(())
/// # }
/// ```
pub type Tree<'a> = backend::Tree<'a, Bvh, (&'a Components, &'a TargetSides)>;

/// The hierarchies of a picture, all over the same mesh.
///
/// ```no_run
/// use slimbvh::gpu::{Bvh, Frame, GpuError, Renderer, Scene, Tree, Trees};
/// # use slimbvh::{Camera, Light, RenderSettings};
/// # fn run(
/// #     frame: &mut Frame, renderer: &mut Renderer, scene: &Scene, trees: (&Bvh, &Bvh, &Bvh),
/// #     view: (&Camera, &[Light]), settings: &RenderSettings,
/// # ) -> Result<(), GpuError> {
/// # let (eye, lamp, whole) = trees;
/// // A set for the camera, one for the only lamp, and the whole tree for mirrors.
/// let trees = Trees {
///     primary: Tree::all(eye),
///     lights: vec![Tree::all(lamp)],
///     mirrors: Some(whole),
/// };
/// renderer.render_with(frame, scene, &trees, view, settings)?;
/// # Ok(())
/// # }
/// ```
pub type Trees<'a> = backend::Trees<'a, Bvh, (&'a Components, &'a TargetSides)>;

impl<'a> Tree<'a> {
    pub(super) fn ranges(&self) -> Result<TreeRanges, GpuError> {
        Ok(TreeRanges {
            built: self.bvh.built()?.clone(),
            rule: self.rule_ranges()?.cloned(),
        })
    }

    /// The bindings that the functions of [`super::wgsl_for`] and [`super::wgsl_compute_for`] read, numbered from 0: the scene's
    /// exponent, the nodes, the triangles, if nodes are on a lattice the root, then the rule's sides and target. They are as many with
    /// a rule and without one, so one shader serves both.
    ///
    /// They are those of the present frame: after the next update of its view sets, the tree's buffers may be others.
    ///
    /// The rule is that of the latest [`TargetSides::set`] or [`TargetSides::decide`] before the shader runs.
    ///
    /// ```no_run
    /// # use slimbvh::gpu::{Gpu, GpuError, Tree, wgpu};
    /// # fn run(gpu: &Gpu, tree: &Tree, layout: &wgpu::BindGroupLayout) -> Result<(), GpuError> {
    /// let group = gpu.device().create_bind_group(&wgpu::BindGroupDescriptor {
    ///     label: None,
    ///     layout,
    ///     entries: &tree.bindings()?,
    /// });
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// If the hierarchy is not built yet, or is stored in a codec without such a text; if the rule's sides are not decided, or are those
    /// of other components.
    pub fn bindings(&self) -> Result<Vec<wgpu::BindGroupEntry<'a>>, GpuError> {
        self.bvh.bindings_with(self.rule_ranges()?)
    }

    /// The ranges of the rule: its packed sides belong to its components.
    pub(super) fn rule_ranges(&self) -> Result<Option<&'a TargetRanges>, GpuError> {
        let Some((components, sides)) = self.rule else {
            return Ok(None);
        };
        let ranges = sides.ranges()?;
        if ranges.components != *components {
            return Err(Misfit::OthersSides.of("the rule"));
        }
        Ok(Some(ranges))
    }
}

impl Trees<'_> {
    pub(super) fn ranges(&self) -> Result<TreesRanges, GpuError> {
        let lights = self.lights.iter().map(Tree::ranges);
        let mirrors = self.mirrors.map(|bvh| Tree::all(bvh).ranges());
        Ok(TreesRanges {
            primary: self.primary.ranges()?,
            lights: lights.collect::<Result<_, _>>()?,
            mirrors: mirrors.transpose()?,
        })
    }
}

/// The ranges of a tree that kernels read.
#[derive(Clone, Debug, PartialEq)]
pub struct TreeRanges {
    pub built: Built,
    pub rule: Option<TargetRanges>,
}

impl TreeRanges {
    /// The packed sides of the primitives, or zeros: then all triangles are hits.
    pub fn sides(&self) -> &Range {
        self.rule
            .as_ref()
            .map_or(&self.built.placeholder, |rule| &rule.packed)
    }

    /// The rule's target, or zeros.
    pub fn target(&self) -> &Range {
        self.rule
            .as_ref()
            .map_or(&self.built.placeholder, |rule| &rule.target)
    }
}

/// A light's deferral in a program.
#[derive(Clone, Debug, PartialEq)]
pub enum DeferralRange {
    Ready,
    Always,
    /// Holds 0 if the light reaches no hit.
    IfReached(Range),
}

impl DeferralRange {
    /// The deferral, and the tree that is built.
    pub fn of<'a>(deferral: Deferral<'a, &Gpu>) -> Result<(Self, Option<&'a Bvh>), GpuError> {
        Ok(match deferral {
            Deferral::Ready => (Self::Ready, None),
            Deferral::Always(bvh) => (Self::Always, Some(bvh)),
            Deferral::IfReached(bvh, sides) => {
                (Self::IfReached(sides.ranges()?.needed.clone()), Some(bvh))
            }
        })
    }
}

/// The ranges of all trees that kernels read.
#[derive(Clone, Debug, PartialEq)]
pub struct TreesRanges {
    pub primary: TreeRanges,
    pub lights: Vec<TreeRanges>,
    pub mirrors: Option<TreeRanges>,
}

impl TreesRanges {
    /// All hierarchies.
    pub fn all(&self) -> impl Iterator<Item = &Built> {
        let trees = self.lights.iter().chain(&self.mirrors);
        trees.chain([&self.primary]).map(|tree| &tree.built)
    }
}
