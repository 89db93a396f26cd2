//! Stage `fit` on the GPU: sets in less memory than all triangles would take.
//!
//! Only the GPU knows how many triangles a set has. Its memory follows the counts of the last frames, which are read back without
//! waiting. A set that does not fit is not built in that frame: its rays go through the whole tree, with the set's rule. So trees of
//! sets lie behind the whole tree, in the same two buffers, and one set of bindings serves both.

mod recent;

use super::buffer::Range;
use super::bvh::{Built, Lists};
use super::coding::Coding;
use super::program::{Groups, Recorder, Uniform, groups, threads};
use super::sides::TargetRanges;
use super::trees::TreeRanges;
use super::{Builder, Bvh, Gpu, GpuError, Kernel, Mesh};
use crate::backend::SetNeed;
pub use recent::Recent;
use slimbvh_core::fit::Fit;
use slimbvh_core::launch::PART_STEP;
use slimbvh_core::trace::MOST_WIDE_NODES;

/// Bytes of what [`Kernel::fit_rays`] stores.
pub const PARTS_BYTES: u64 = 16 * (PART_STEP as u64 + 1);

/// Bytes of what [`Kernel::fit_count`] stores.
pub const FIT_BYTES: u64 = size_of::<Fit>() as u64;

/// Where the tree of a set is: behind the whole tree, and maybe other sets.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// The most triangles that there is memory for.
    pub limit: u32,
    /// Its own parts of the lists of nodes and triangles.
    own: [Range; 2],
    /// Where these begin in the lists, in the units of links.
    first: [u32; 2],
    /// The lists from their beginning, which is the whole tree's.
    lists: [Range; 2],
    whole: Box<Built>,
}

impl Place {
    /// Its part of the list of nodes.
    pub const fn nodes(&self) -> &Range {
        &self.own[0]
    }

    /// Its part of the list of triangles.
    pub const fn triangles(&self) -> &Range {
        &self.own[1]
    }

    /// Whether it is behind a tree over this many triangles, in these buffers.
    fn is_behind(&self, triangle_count: u32, lists: [Option<&wgpu::Buffer>; 2]) -> bool {
        let own = self.lists.each_ref().map(|list| Some(&list.buffer));
        self.whole.triangle_count == triangle_count && lists == own
    }
}

/// How a set fitted into memory for less than all triangles.
///
/// ```
/// # use slimbvh::gpu::SetFit;
/// let fit = SetFit { name: "camera".into(), triangle_count: 900, limit: 1200 };
/// println!("{}: {} of {} triangles", fit.name, fit.triangle_count, fit.limit);
/// # assert!(fit.fits());
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SetFit {
    /// The names of its targets.
    pub name: String,
    /// Its triangles.
    pub triangle_count: u32,
    /// Triangles that there was memory for.
    pub limit: u32,
}

impl SetFit {
    /// Whether it fitted. Else its rays went through the whole tree.
    ///
    /// ```no_run
    /// # use slimbvh::{ViewSets, gpu::Gpu};
    /// # fn run(views: &ViewSets<&Gpu>) {
    /// let late = views.fits().iter().filter(|fit| !fit.fits()).count();
    /// println!("{late} sets were too large for their memory");
    /// # }
    /// ```
    #[must_use]
    pub const fn fits(&self) -> bool {
        self.triangle_count <= self.limit
    }
}

/// What the rays of a set go through that may not fit.
#[derive(Clone, Debug, PartialEq)]
pub struct Fallback {
    pub place: Place,
    /// What is known of the set ([`Fit`]).
    pub fit: Range,
    pub rule: TargetRanges,
}

impl Fallback {
    /// The lists that hold both trees.
    pub const fn lists(&self) -> [&Range; 2] {
        let [nodes, triangles] = &self.place.lists;
        [nodes, triangles]
    }

    /// The whole tree, with the set's rule.
    fn whole(&self) -> TreeRanges {
        TreeRanges {
            built: (*self.place.whole).clone(),
            rule: Some(self.rule.clone()),
        }
    }

    /// Records which set is built: the one counted, or if it does not fit an empty one.
    pub fn record_count(&self, recorder: &mut Recorder, count: &Range) {
        recorder.stage("fit");
        let params = [Uniform::Params([self.place.limit, 0, 0, 0])];
        let to = [count, &self.fit];
        recorder.read(count);
        recorder.dispatch(Kernel::fit_count, &params, &[], &to, groups(1));
    }

    /// Records where the tree begins that rays go through.
    pub fn record_base(&self, recorder: &mut Recorder, set: &Built) {
        recorder.stage("fit");
        let [node, triangle] = self.place.first;
        let params = Uniform::Params([node, triangle, 0, 0]);
        let whole = Uniform::Stored(self.place.whole.root_or_zeros());
        let to = [&set.exponent, set.root_or_zeros()];
        recorder.update(
            Kernel::fit_base,
            &[params, whole],
            &[&self.fit],
            &to,
            groups(1),
        );
    }
}

/// A tree that rays go through, and the dispatch of these rays.
pub struct Part {
    pub tree: TreeRanges,
    pub groups: Groups,
    /// The number of rays, for kernels that ask; `None` where it is known.
    pub number: Option<Range>,
}

/// Rays whose number only the GPU knows.
pub struct Counted<'a> {
    /// Words that hold the number.
    pub words: &'a Range,
    /// Its index among them.
    pub word: u32,
    /// The first ray of the dispatch.
    pub first: u32,
}

impl TreeRanges {
    /// The trees that at most this many rays go through: this one, and if it is a set that may not fit the whole tree. Of two one gets all
    /// rays; that is recorded into a range of [`PARTS_BYTES`].
    pub fn parts(
        &self,
        recorder: &mut Recorder,
        to: &Range,
        most: u32,
        counted: Option<&Counted>,
    ) -> Vec<Part> {
        let part = |tree: &Self, place: u64| {
            let number = to.part(16 * place, 16);
            Part {
                tree: tree.clone(),
                groups: Groups::Indirect(number.part(4, 12)),
                number: Some(number),
            }
        };
        let params = counted.map_or([0, 0, most, 0], |of| [of.word, of.first, most, 1]);
        let params = [Uniform::Params(params)];
        match (&self.built.fallback, counted) {
            (None, None) => vec![Part {
                tree: self.clone(),
                groups: threads(most),
                number: None,
            }],
            (None, Some(of)) => {
                let (from, to) = ([&of.words.touching(4)], [&to.part(0, 16)]);
                recorder.dispatch(Kernel::trace_count, &params, &from, &to, groups(1));
                vec![part(self, 0)]
            }
            (Some(fallback), counted) => {
                let words = counted.map_or(&fallback.fit, |of| of.words);
                let from = [&fallback.fit, &words.touching(4)];
                recorder.dispatch(Kernel::fit_rays, &params, &from, &[to], groups(1));
                let whole = fallback.whole();
                vec![part(self, 0), part(&whole, PART_STEP as u64)]
            }
        }
    }
}

impl Builder {
    /// Lays out the memory of a mesh's trees: a set that needs a share of the triangles gets as much memory as it lately needed, behind
    /// the whole tree; any other set its own, for all triangles. Returns whether that changed: then all trees must be built anew.
    pub(super) fn lay_out(
        &mut self,
        gpu: &Gpu,
        mesh: &Mesh,
        whole: &mut Bvh,
        sets: &mut [(&mut Bvh, SetNeed)],
    ) -> Result<bool, GpuError> {
        let count = mesh.triangle_count;
        if sets.iter().any(|(bvh, _)| bvh.recent.is_waiting()) {
            gpu.poll()?;
        }
        let shared = whole.list_buffers();
        let mut limits = Vec::with_capacity(sets.len());
        for (bvh, need) in sets.iter_mut() {
            let is_followed = matches!(need, SetNeed::Share(_));
            let was_followed = bvh.recent.is_followed();
            bvh.recent.update(gpu, is_followed)?;
            let place = bvh.place.as_ref();
            let place = place.filter(|place| place.is_behind(count, shared));
            let present = place.map(|place| place.limit);
            limits.push(match need {
                SetNeed::Share(share) => {
                    // A set without a place had memory for all.
                    let all = was_followed && bvh.mesh_triangle_count() == count;
                    let present = present.or(all.then_some(count));
                    // One that needs all has its own memory.
                    Some(bvh.recent.limit(count, *share, present)).filter(|limit| *limit < count)
                }
                SetNeed::Nothing => present,
                SetNeed::All => None,
            });
        }
        let lists = self.lists()?;
        while let ends = lists.ends(count, limits.iter().flatten().copied())
            && !Self::can_share(gpu, &lists, ends)
            && let Some(largest) = limits.iter_mut().max_by_key(|limit| **limit)
            && largest.is_some()
        {
            *largest = None;
        }
        let is_kept = |((bvh, _), limit): (&(&mut Bvh, SetNeed), &Option<u32>)| {
            let place = bvh.place.as_ref();
            place.map(|place| place.limit) == *limit
                && place.is_none_or(|place| place.is_behind(count, shared))
        };
        if sets.iter().zip(&limits).all(is_kept) {
            return Ok(false);
        }
        let laid_out = gpu.checked(|| self.place(gpu, count, whole, sets, &limits));
        if laid_out.is_err() {
            *whole = Bvh::new();
            for (bvh, _) in sets {
                **bvh = Bvh::new();
            }
        }
        laid_out.map(|()| true)
    }

    /// Whether lists of this many nodes and triangles can be bound.
    fn can_share(gpu: &Gpu, lists: &Lists, ends: [u64; 2]) -> bool {
        let limits = gpu.limits();
        let most = limits
            .max_storage_buffer_binding_size
            .min(limits.max_buffer_size);
        let bytes = lists.bytes(ends);
        let has_links =
            !lists.coding.is_some_and(Coding::is_wide) || ends[0] <= MOST_WIDE_NODES.into();
        has_links && bytes.iter().all(|bytes| *bytes <= most)
    }

    /// Makes the lists, and gives each set its place in them.
    fn place(
        &mut self,
        gpu: &Gpu,
        count: u32,
        whole: &mut Bvh,
        sets: &mut [(&mut Bvh, SetNeed)],
        limits: &[Option<u32>],
    ) -> Result<(), GpuError> {
        let lists = self.lists()?;
        self.drop_programs();
        for ((bvh, _), limit) in sets.iter_mut().zip(limits) {
            if bvh.place.take().is_some() || limit.is_some() {
                bvh.free_lists();
            }
        }
        if limits.iter().all(Option::is_none) {
            whole.free_lists();
            return Ok(());
        }
        let ends = lists.ends(count, limits.iter().flatten().copied());
        let shared = whole.renew_lists(gpu, lists.bytes(ends));
        let mut built = self.reserve_for(gpu, count, false, whole)?;
        // Of nodes and triangles in full, which a builder shares between its trees, nothing is traced.
        [built.nodes, built.triangles] = built.stored().map(Range::clone);
        let mut end = lists.ends(count, []);
        for ((bvh, _), limit) in sets.iter_mut().zip(limits) {
            let Some(limit) = *limit else { continue };
            let first = end.map(Lists::aligned);
            end = lists.behind(first, limit);
            let begin = lists.bytes(first);
            let size = lists.bytes(lists.counts(limit));
            let own = [0, 1].map(|list| shared[list].part(begin[list], size[list]));
            bvh.place = Some(Place {
                limit,
                own,
                first: first.map(|first| first as u32),
                lists: shared.clone(),
                whole: Box::new(built.clone()),
            });
        }
        Ok(())
    }
}
