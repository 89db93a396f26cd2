//! Paths and shadow rays of a picture: which kernel traces them through a tree, and what it is bound to.

use crate::gpu::Kernel;
use crate::gpu::buffer::Range;
use crate::gpu::bvh::Coded;
use crate::gpu::kernel::traces;
use crate::gpu::program::{Groups, Recorder, Uniform};
use crate::gpu::trees::TreeRanges;

impl TreeRanges {
    /// Records that each path's closest hit be found. Reads the scene's exponent. Writes hits and counters.
    pub fn record_paths(
        &self,
        recorder: &mut Recorder,
        exponent: Uniform,
        paths: &Range,
        to: [&Range; 2],
        each: Groups,
    ) {
        let [nodes, triangles] = self.built.stored();
        let kernel = traces(self.built.coding()).paths;
        match (&self.built.coded, &self.rule) {
            (Some(coded), _) => {
                let (uniforms, [components, sides]) = self.coded_rule(coded, exponent);
                let reads = [nodes, triangles, components, sides, paths];
                recorder.dispatch(kernel, &uniforms, &reads, &to, each);
            }
            (None, Some((components, sides))) => recorder.dispatch(
                Kernel::trace_paths_facing,
                &[exponent, sides.target()],
                &[nodes, triangles, &components.0, &sides.sides, paths],
                &to,
                each,
            ),
            (None, None) => recorder.dispatch(kernel, &[], &[nodes, triangles, paths], &to, each),
        }
    }

    /// Records that each path's closest hit be found, whatever faces where, and the nodes be counted that the search opens. Writes
    /// hits, counts and counters.
    pub fn record_paths_counted(
        &self,
        recorder: &mut Recorder,
        paths: &Range,
        to: [&Range; 3],
        each: Groups,
    ) {
        let [nodes, triangles] = self.built.stored();
        let kernel = traces(self.built.coding()).paths_counted;
        let root = self.built.coded.as_ref();
        let root: Vec<Uniform> = root.map(|c| Uniform::Stored(&c.root)).into_iter().collect();
        recorder.dispatch(kernel, &root, &[nodes, triangles, paths], &to, each);
    }

    /// Records that shadow rays be traced. Reads the scene's exponent. Updates paths and counters.
    pub fn record_shadows(
        &self,
        recorder: &mut Recorder,
        exponent: Uniform,
        shadows: &Range,
        to: [&Range; 2],
        each: Groups,
    ) {
        let [nodes, triangles] = self.built.stored();
        let kernel = traces(self.built.coding()).shadows;
        match (&self.built.coded, &self.rule) {
            (Some(coded), _) => {
                let (uniforms, [components, sides]) = self.coded_rule(coded, exponent);
                let reads = [nodes, triangles, components, sides, shadows];
                recorder.update(kernel, &uniforms, &reads, &to, each);
            }
            (None, Some((components, sides))) => recorder.update(
                Kernel::trace_shadows_facing,
                &[exponent, sides.target()],
                &[nodes, triangles, &components.0, &sides.sides, shadows],
                &to,
                each,
            ),
            (None, None) => recorder.update(kernel, &[], &[nodes, triangles, shadows], &to, each),
        }
    }

    /// What kernels of coded trees read for their filter, which they always have: the root, the exponent and the target, then
    /// the components and their sides.
    fn coded_rule<'a>(
        &'a self,
        coded: &'a Coded,
        exponent: Uniform<'a>,
    ) -> ([Uniform<'a>; 3], [&'a Range; 2]) {
        let (target, ranges) = match &self.rule {
            Some((components, sides)) => (sides.target(), [&components.0, &sides.sides]),
            None => {
                let placeholder = &coded.placeholder;
                (Uniform::Stored(placeholder), [placeholder, placeholder])
            }
        };
        ([Uniform::Stored(&coded.root), exponent, target], ranges)
    }
}
