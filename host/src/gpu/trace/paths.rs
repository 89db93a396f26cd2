//! Dispatches for a picture's paths and shadow rays: the kernel for each kind of tree, and its bindings.

use super::overflow::Overflow;
use crate::gpu::Kernel;
use crate::gpu::buffer::Range;
#[cfg(doc)]
use crate::gpu::fit::PARTS_BYTES;
use crate::gpu::kernel::traces;
use crate::gpu::program::{Groups, Recorder, Uniform};
use crate::gpu::trees::TreeRanges;

/// Where rays are counted, and where those are listed that are traced again.
#[derive(Clone, Debug)]
pub struct Tally {
    /// From the counters to the end of the list.
    pub all: Range,
    /// The list, which is the end of that.
    pub overflow: Overflow,
    pub each: Each,
}

/// The rays of a wave.
#[derive(Clone, Debug)]
pub struct Each {
    pub count: u32,
    /// For the dispatches of those that go through a set and through the whole tree ([`PARTS_BYTES`]).
    pub parts: Range,
}

impl Each {
    /// The trees that the rays go through, with their dispatches.
    fn parts(&self, recorder: &mut Recorder, tree: &TreeRanges) -> Vec<(TreeRanges, Groups)> {
        let parts = tree.parts(recorder, &self.parts, self.count, None);
        let parts = parts.into_iter();
        parts.map(|part| (part.tree, part.groups)).collect()
    }
}

impl Tally {
    /// The counters and the list, of which a first pass accesses no more than the counters, but for few rays.
    fn counted(&self) -> Range {
        self.all.touching(16)
    }
}

impl TreeRanges {
    /// Records a search for each path's closest hit. Reads the scene's exponent. Writes hits and counters.
    pub fn record_paths(
        &self,
        recorder: &mut Recorder,
        exponent: Uniform,
        [paths, hits]: [&Range; 2],
        tally: &Tally,
    ) {
        for (tree, groups) in tally.each.parts(recorder, self) {
            tree.record_own_paths(recorder, exponent, [paths, hits], tally, groups);
        }
    }

    fn record_own_paths(
        &self,
        recorder: &mut Recorder,
        exponent: Uniform,
        [paths, hits]: [&Range; 2],
        tally: &Tally,
        each: Groups,
    ) {
        let kernels = traces(self.built.coding());
        let to = [hits, &tally.counted()];
        let (kernel, uniforms, reads) =
            self.first(exponent, kernels.paths, Kernel::trace_paths_facing);
        let reads: Vec<&Range> = reads.iter().chain([paths]).collect();
        recorder.dispatch(kernel, &uniforms, &reads, &to, each);

        let groups = tally.overflow.record(recorder);
        let (uniforms, reads) = self.second(exponent, tally);
        let paths = &paths.touching(0);
        let reads: Vec<&Range> = reads.iter().chain([paths]).collect();
        let to = [&hits.touching(0), &tally.all.touching(0)];
        recorder.dispatch(kernels.paths_overflow, &uniforms, &reads, &to, groups);
    }

    /// Records a search for each path's closest hit without a facing filter, and a count of the nodes that it opens. Writes
    /// hits, counts and counters.
    pub fn record_paths_counted(
        &self,
        recorder: &mut Recorder,
        paths: &Range,
        to: [&Range; 3],
        each: &Each,
    ) {
        for (tree, groups) in each.parts(recorder, self) {
            let [nodes, triangles] = &tree.built.traced();
            let kernel = traces(tree.built.coding()).paths_counted;
            let root: Vec<Uniform> = tree.built.root().into_iter().collect();
            recorder.dispatch(kernel, &root, &[nodes, triangles, paths], &to, groups);
        }
    }

    /// Records the trace of shadow rays. Reads the scene's exponent. Updates paths and counters.
    pub fn record_shadows(
        &self,
        recorder: &mut Recorder,
        exponent: Uniform,
        [shadows, paths]: [&Range; 2],
        tally: &Tally,
    ) {
        for (tree, groups) in tally.each.parts(recorder, self) {
            tree.record_own_shadows(recorder, exponent, [shadows, paths], tally, groups);
        }
    }

    fn record_own_shadows(
        &self,
        recorder: &mut Recorder,
        exponent: Uniform,
        [shadows, paths]: [&Range; 2],
        tally: &Tally,
        each: Groups,
    ) {
        let kernels = traces(self.built.coding());
        let to = [paths, &tally.counted()];
        let (kernel, uniforms, reads) =
            self.first(exponent, kernels.shadows, Kernel::trace_shadows_facing);
        let reads: Vec<&Range> = reads.iter().chain([shadows]).collect();
        recorder.update(kernel, &uniforms, &reads, &to, each);

        let groups = tally.overflow.record(recorder);
        let (uniforms, reads) = self.second(exponent, tally);
        let (shadows, list) = (&shadows.touching(0), &tally.all.touching(0));
        let reads: Vec<&Range> = reads.iter().chain([shadows, list]).collect();
        let to = [&paths.touching(0)];
        recorder.update(kernels.shadows_overflow, &uniforms, &reads, &to, groups);
    }

    /// The kernel of a first pass, with its uniforms, and the ranges that it reads before the rays: of trees in full without a filter
    /// the bare kernel, else the one with a filter. Kernels of coded trees always have one.
    fn first<'a>(
        &'a self,
        exponent: Uniform<'a>,
        kernel: Kernel,
        facing: Kernel,
    ) -> (Kernel, Vec<Uniform<'a>>, Vec<Range>) {
        let [nodes, triangles] = self.built.traced();
        let kernel = match (&self.built.coded, &self.rule) {
            (None, None) => return (kernel, Vec::new(), vec![nodes, triangles]),
            (None, Some(_)) => facing,
            (Some(_), _) => kernel,
        };
        let reads = vec![nodes, triangles, self.sides().clone()];
        (kernel, self.filter(exponent), reads)
    }

    /// The uniforms of a second pass, and the ranges that it reads before the rays. Its kernels always have a filter.
    fn second<'a>(
        &'a self,
        exponent: Uniform<'a>,
        tally: &'a Tally,
    ) -> (Vec<Uniform<'a>>, Vec<Range>) {
        let [nodes, triangles] = self.built.traced();
        let mut uniforms = self.filter(exponent);
        uniforms.push(tally.overflow.length());
        let sides = self.sides().clone();
        let reads = [nodes, triangles, sides].map(|range| range.touching(0));
        (uniforms, reads.into())
    }

    /// The uniforms of kernels with a filter: the root of a coded tree, the exponent and the target.
    fn filter<'a>(&'a self, exponent: Uniform<'a>) -> Vec<Uniform<'a>> {
        let target = Uniform::Stored(self.target());
        let root = self.built.root();
        root.into_iter().chain([exponent, target]).collect()
    }
}
