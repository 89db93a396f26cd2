//! What can be set, and what it is set to.

mod names;

use crate::measure::step::{PIXELS, Step};
use slimbvh::reduce::Reduce;
use slimbvh::{BuildConfig, CodeBits, LatticeBits, MeshCodec, NodeCodec, Scene, TreeKind};

/// One way to make a picture.
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

/// How triangles are stored.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Triangles {
    Full,
    Leaf10,
    Lattice(Step),
}

/// How a tree is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Update {
    Rebuild,
    /// From one over the same triangles that were somewhere else.
    Refit,
}

/// What a setup was made to vary.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Knob {
    Default,
    Reduce,
    Lights,
    Nodes,
    Mesh,
    Codes,
    Tree,
    Update,
    Threads,
    /// Several at once.
    Crossed,
}

/// Tolerances of the lattice, in pixels of a picture of 1280×720.
const TOLERANCES: [f32; 3] = [0.1, 0.5, 2.0];

impl Setup {
    /// What `slimbvh render` does where nobody asks for anything, with a tree that both backends build.
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

    /// One tree over all triangles, nothing in a codec: what pictures are compared with.
    pub fn plain(threads: usize) -> Self {
        Self {
            reduce: Reduce::Off,
            ..Self::usual(threads)
        }
    }

    /// The usual one, then each knob by itself. A mesh in a codec takes the nodes along that go with it.
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
        let others = NodeCodec::ALL.into_iter();
        for nodes in others.filter(|nodes| *nodes != usual.nodes) {
            all.push((Knob::Nodes, Self { nodes, ..usual }));
        }
        let steps = TOLERANCES.map(Step::Pixels);
        let steps = [Step::Finest].into_iter().chain(steps);
        for mesh in [Triangles::Leaf10]
            .into_iter()
            .chain(steps.map(Triangles::Lattice))
        {
            let nodes = mesh.nodes();
            let setup = Self {
                mesh,
                nodes,
                ..usual
            };
            all.push((Knob::Mesh, setup.allowed()));
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

    /// Whether nodes and triangles go together.
    pub fn is_possible(&self) -> bool {
        match self.mesh {
            Triangles::Full => true,
            Triangles::Leaf10 => {
                self.nodes == NodeCodec::Paper10
                    && self.reduce == Reduce::Off
                    && self.lights == Lights::Grouped
            }
            Triangles::Lattice(_) => matches!(self.nodes, NodeCodec::Lattice(_)),
        }
    }

    /// Whether there are kernels for its tree and its codecs.
    pub fn has_kernels(&self) -> bool {
        let has_nodes = match self.nodes {
            NodeCodec::F32 | NodeCodec::Paper10 => true,
            NodeCodec::Lattice(bits) => matches!(bits, LatticeBits::Q10 | LatticeBits::Q21),
        };
        has_nodes && self.tree == TreeKind::Radix
    }

    /// Whether it should make the plain tree's picture, byte for byte.
    pub fn is_lossless(&self) -> bool {
        self.mesh == Triangles::Full
    }

    /// Whether it does the same work on the same cores as the usual one, so that both can be compared.
    pub fn is_comparable(&self, usual: &Self) -> bool {
        self.update == usual.update && self.threads == usual.threads
    }

    /// How to build for a scene, whose vertices must be moved onto the lattice, if there is one.
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

    /// Without reduction where triangles are not those that it was decided for.
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
    /// The nodes that go with it.
    pub fn nodes(self) -> NodeCodec {
        match self {
            Self::Full => NodeCodec::F32,
            Self::Leaf10 => NodeCodec::Paper10,
            Self::Lattice(_) => NodeCodec::Lattice(LatticeBits::Q10),
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
        // 1 + 2 + 1 + 8 + 5 + 1 + 1 + 1 + 2
        assert_eq!(all.len(), 22);
        assert_eq!(Setup::one_at_a_time(1, 1).len(), 19);
    }
}
