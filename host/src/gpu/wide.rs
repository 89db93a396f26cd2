//! Stages `wide` and `encode` of trees of wide nodes.
//!
//! Which binary nodes begin wide ones is found in a build, and kept: a refit encodes the same nodes over new boxes. Where triangles
//! lie on the lattice, their words are counted anew, as leaves may need more or fewer bits.

use super::buffer::{Range, Slot};
use super::bvh::{Built, Coded, most_nodes};
use super::coding::Encodes;
use super::program::{Groups, Recorder, Uniform};
use super::scan::Scan;
use super::{Gpu, Kernel};
use slimbvh_core::wide::Begins;
use wgpu::BufferUsages;

/// What is known of a tree's topology.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Topology {
    /// It was just built.
    New,
    /// It is that of the encoder's latest build.
    Kept,
}

/// Buffers by binary node, kept from a build for its refits.
#[derive(Debug)]
pub struct Wide {
    collapses: Slot,
    origins: Slot,
    begins: Slot,
    corners: Slot,
    scan: Scan,
}

/// What encoding kernels read of the binary nodes, besides these.
#[derive(Debug)]
pub struct Places {
    pub collapses: Range,
    pub origins: Range,
    /// Prefix sums ([`Begins`]).
    pub begins: Range,
    /// For each triangle, which of its leaf's corners it has ([`slimbvh_core::encode::TriangleCorners`]), where these are shared.
    pub corners: Option<Range>,
}

impl Places {
    /// In the order of bindings.
    pub const fn all(&self) -> [&Range; 3] {
        [&self.collapses, &self.origins, &self.begins]
    }
}

impl Wide {
    /// Empty buffers.
    pub const fn new() -> Self {
        Self {
            collapses: Slot::storage("slimbvh wide collapses"),
            origins: Slot::storage("slimbvh wide origins"),
            begins: Slot::new(
                "slimbvh wide sums",
                BufferUsages::STORAGE.union(BufferUsages::COPY_DST),
            ),
            corners: Slot::storage("slimbvh triangle corners"),
            scan: Scan::new(),
        }
    }

    /// Records stage `wide`: the places of all wide nodes over the plain ones, and where the words of their leaves' triangles
    /// begin. `each_node` gives every binary node a thread; `step` is the lattice's step in the kernels' form.
    pub fn record(
        &mut self,
        gpu: &Gpu,
        recorder: &mut Recorder,
        (bvh, coded): (&Built, &Coded),
        step: [u32; 4],
        topology: Topology,
        each_node: &dyn Fn() -> Groups,
    ) -> Places {
        let (words, shares_corners) = match coded.coding.encodes() {
            Encodes::MixedWide {
                words,
                shares_corners,
                ..
            } => (Some(words), shares_corners),
            _ => (None, false),
        };
        let bytes = 4 * most_nodes(bvh.room);
        let halves = if words.is_some() { 2 } else { 1 };
        let places = Places {
            collapses: self.collapses.range(gpu, bytes).touching_nodes(4),
            origins: self.origins.range(gpu, bytes).touching_nodes(4),
            begins: self.begins.range(gpu, halves * bytes),
            corners: shares_corners.then(|| {
                let count = u64::from(bvh.room.max(1));
                self.corners.range(gpu, 4 * count)
            }),
        };
        let Places {
            collapses,
            origins,
            begins,
            corners,
        } = &places;
        if topology == Topology::Kept && words.is_none() {
            return places;
        }

        recorder.stage("wide");
        let total = Uniform::Stored(&bvh.total);
        // The scan sums all that there is room for.
        recorder.clear(begins);
        let stored = &begins.touching_nodes(4);
        if topology == Topology::New {
            // Always 0, hidden from the compiler so that it cannot fuse the product.
            let zero = Uniform::Params([0; 4]);
            let kernel = Kernel::wide_collapse;
            recorder.dispatch(
                kernel,
                &[total, zero],
                &[&bvh.nodes],
                &[collapses],
                each_node(),
            );
            recorder.dispatch(
                Kernel::wide_places,
                &[total],
                &[&bvh.nodes, collapses],
                &[origins, stored],
                each_node(),
            );
        }
        let Some(words) = words else {
            self.scan.record(gpu, recorder, begins, &coded.inner_total);
            return places;
        };
        if let Some(corners) = corners {
            recorder.dispatch(
                Kernel::wide_corners,
                &[total],
                &[&bvh.nodes, &bvh.triangles],
                &[corners],
                each_node(),
            );
        }
        let from = [&bvh.nodes, collapses, origins].into_iter().chain(corners);
        recorder.dispatch(
            words,
            &[total, Uniform::Stored(&bvh.exponent), Uniform::Params(step)],
            &from.collect::<Vec<_>>(),
            &[&begins.touching_nodes(8), &coded.root],
            each_node(),
        );
        self.scan.record(gpu, recorder, begins, &coded.word_total);
        let first_of_words = Begins::first_of_words((begins.size / 4) as u32);
        let inner_total = begins.part(4 * u64::from(first_of_words), 4);
        recorder.copy(&inner_total, &coded.inner_total.part(0, 4));
        places
    }

    pub fn bytes(&self) -> u64 {
        let slots = [&self.collapses, &self.origins, &self.begins, &self.corners];
        slots.iter().map(|slot| slot.bytes()).sum::<u64>() + self.scan.bytes()
    }
}
