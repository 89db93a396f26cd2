//! Setups: the settings that `bench` varies, and the setups that it tries.

mod names;

use crate::measure::step::{PIXELS, Step};
use slimbvh::reduce::Reduce;
use slimbvh::{
    BuildConfig, CodeBits, LatticeBits, MeshCodec, NodeCodec, Scene, TreeKind, WideStore,
    check_codecs,
};

/// The settings of a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setup {
    pub reduce: Reduce,
    pub lights: Lights,
    pub nodes: NodeCodec,
    pub mesh: Triangles,
    pub codes: CodeBits,
    pub tree: TreeKind,
    pub update: Update,
    pub threads: usize,
}

/// Whether lights near each other share a set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lights {
    Grouped,
    Apart,
}

/// The codec of triangles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Triangles {
    Full,
    Leaf10,
    Lattice(Step),
}

/// How a frame gets its tree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Update {
    Rebuild,
    /// The tree of the same triangles at other places is refitted.
    Refit,
}

/// The setting that a setup varies.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, clap::ValueEnum)]
#[serde(rename_all = "lowercase")]
pub enum Knob {
    #[value(skip)]
    Default,
    Reduce,
    Lights,
    Nodes,
    Mesh,
    Codes,
    Tree,
    Update,
    Threads,
    /// Several settings at once.
    Crossed,
}

/// Tolerances of the lattice, in pixels of a picture of 1280×720.
const TOLERANCES: [f32; 3] = [0.1, 0.5, 2.0];

impl Setup {
    /// The defaults of `slimbvh render`, with a tree that both backends build.
    pub fn usual(threads: usize) -> Self {
        Self {
            reduce: Reduce::Auto,
            lights: Lights::Grouped,
            nodes: NodeCodec::F32,
            mesh: Triangles::Full,
            codes: CodeBits::Bits30,
            tree: TreeKind::Radix,
            update: Update::Rebuild,
            threads,
        }
    }

    /// The reference for pictures: one tree over all triangles, without codecs.
    pub fn plain(threads: usize) -> Self {
        Self {
            reduce: Reduce::Off,
            ..Self::usual(threads)
        }
    }

    /// The usual setup, then each knob by itself. A codec of triangles brings its codecs of nodes.
    pub fn one_at_a_time(threads: usize, light_count: usize) -> Vec<(Knob, Self)> {
        let usual = Self::usual(threads);
        let mut all = vec![(Knob::Default, usual)];
        for reduce in [Reduce::Off, Reduce::On] {
            all.push((Knob::Reduce, Self { reduce, ..usual }));
        }
        if light_count > 1 {
            let (reduce, lights) = (Reduce::On, Lights::Apart);
            let apart = Self {
                reduce,
                lights,
                ..usual
            };
            all.push((Knob::Lights, apart));
        }
        let others = MeshCodec::F32.nodes();
        for nodes in others.filter(|nodes| *nodes != usual.nodes) {
            all.push((Knob::Nodes, Self { nodes, ..usual }));
        }
        let steps = TOLERANCES.map(Step::Pixels);
        let steps = [Step::Finest].into_iter().chain(steps);
        for mesh in [Triangles::Leaf10]
            .into_iter()
            .chain(steps.map(Triangles::Lattice))
        {
            for &nodes in mesh.nodes() {
                let setup = Self {
                    mesh,
                    nodes,
                    ..usual
                };
                all.push((Knob::Mesh, setup.allowed()));
            }
        }
        let codes = CodeBits::Bits63;
        all.push((Knob::Codes, Self { codes, ..usual }));
        let tree = TreeKind::Clustered;
        all.push((Knob::Tree, Self { tree, ..usual }));
        let update = Update::Refit;
        all.push((Knob::Update, Self { update, ..usual }));
        let mut fewer = 1;
        while fewer < threads {
            let threads = fewer;
            all.push((Knob::Threads, Self { threads, ..usual }));
            fewer *= 2;
        }
        all
    }

    /// Whether the codecs of nodes and triangles go together.
    pub fn is_possible(&self) -> bool {
        let mesh = match self.mesh {
            Triangles::Full => MeshCodec::F32,
            Triangles::Leaf10 => MeshCodec::Leaf10,
            Triangles::Lattice(_) => MeshCodec::Lattice { step_exponent: 0 },
        };
        let is_whole = self.reduce == Reduce::Off && self.lights == Lights::Grouped;
        check_codecs(self.nodes, mesh).is_ok() && (is_whole || !mesh.moves_vertices())
    }

    /// Whether the GPU has kernels for this tree and these codecs.
    pub fn has_kernels(&self) -> bool {
        !matches!(self.nodes, NodeCodec::Lattice(_)) && self.tree == TreeKind::Radix
    }

    /// Whether the picture must equal the plain tree's, byte for byte.
    pub fn is_lossless(&self) -> bool {
        self.mesh == Triangles::Full
    }

    /// Whether times can be compared with the usual setup's: the same update, the same number of threads.
    pub fn is_comparable(&self, usual: &Self) -> bool {
        self.update == usual.update && self.threads == usual.threads
    }

    /// The settings of a build. If they have a lattice, the scene's vertices must be moved onto it.
    pub fn config(&self, scene: &Scene) -> BuildConfig {
        BuildConfig {
            code_bits: self.codes,
            tree: self.tree,
            nodes: self.nodes,
            mesh: match self.mesh {
                Triangles::Full => MeshCodec::F32,
                Triangles::Leaf10 => MeshCodec::Leaf10,
                Triangles::Lattice(step) => MeshCodec::Lattice {
                    step_exponent: step.exponent(scene, &PIXELS),
                },
            },
        }
    }

    /// The setup without reduction, if its codec moves triangles after the plan has chosen sets.
    fn allowed(self) -> Self {
        match self.mesh {
            Triangles::Leaf10 => Self {
                reduce: Reduce::Off,
                ..self
            },
            Triangles::Full | Triangles::Lattice(_) => self,
        }
    }
}

impl Triangles {
    /// The codecs of nodes that this codec of triangles is measured with, its default first.
    pub fn nodes(self) -> &'static [NodeCodec] {
        match self {
            Self::Full => &[NodeCodec::F32],
            Self::Leaf10 => &[NodeCodec::Paper10],
            Self::Lattice(_) => &[
                NodeCodec::Wide(WideStore::Packed),
                NodeCodec::Wide(WideStore::Exact),
                NodeCodec::Lattice(LatticeBits::Q10),
            ],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn knobs_move_one_at_a_time_and_no_setup_comes_twice() {
        let all = Setup::one_at_a_time(4, 2);
        let usual = Setup::usual(4);
        for (i, (knob, setup)) in all.iter().enumerate() {
            assert!(setup.is_possible(), "{knob:?}");
            assert!(all[..i].iter().all(|(_, other)| other != setup));
            let moved = [
                setup.reduce != usual.reduce,
                setup.nodes != usual.nodes,
                setup.mesh != usual.mesh,
                setup.codes != usual.codes,
                setup.tree != usual.tree,
                setup.update != usual.update,
                setup.threads != usual.threads,
                setup.lights != usual.lights,
            ];
            let moved = moved.iter().filter(|moved| **moved).count();
            let most = match (knob, setup.mesh) {
                (Knob::Default, _) => 0,
                (Knob::Mesh, Triangles::Leaf10) => 3,
                (Knob::Mesh | Knob::Lights, _) => 2,
                _ => 1,
            };
            assert_eq!(moved, most, "{knob:?}");
        }
        // 1 + 2 + 1 + 10 + 13 + 1 + 1 + 1 + 2
        assert_eq!(all.len(), 32);
        assert_eq!(Setup::one_at_a_time(1, 1).len(), 29);
    }
}
