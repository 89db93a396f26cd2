//! The methods of storing trees that are measured.

use super::bench::TimedOn;
use crate::measure::step::Step;
use crate::stress::snapped;
use slimbvh::{BuildConfig, LatticeBits, MeshCodec, NodeCodec, RenderSettings, Scene, WideStore};
use std::borrow::Cow;

/// The tolerance that targets are for.
pub const JUDGED_STEP: Step = Step::Pixels(0.5);

/// How nodes and triangles are stored.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    /// Nodes and triangles in full precision.
    Plain,
    /// Nodes in the paper's codec.
    Node,
    /// Nodes and triangles in the paper's codecs.
    NodeMesh,
    /// Nodes on a lattice, triangles in full precision.
    Lattice(LatticeBits),
    /// Both on a lattice, with nodes of 10 bits.
    LatticeMesh(Step),
    /// Nodes of up to four children, triangles in full precision.
    Wide(WideStore),
    /// The same with triangles on a lattice.
    WideMesh(WideStore, Step),
}

/// A scene that is ready for a method.
pub struct Prepared<'a> {
    pub method: Method,
    /// The scene, with its vertices moved onto the lattice if the method has one.
    pub scene: Cow<'a, Scene>,
    pub config: BuildConfig,
    /// The largest move of a vertex, and its bound.
    pub moved: Option<[f32; 2]>,
}

impl Method {
    /// All methods that are compared with [`Self::Plain`]: the paper's, the laboratory's lattice codec, ours of four children, and the
    /// lattice codec with other bits; on a GPU those that it has.
    pub fn all(place: TimedOn) -> Vec<Self> {
        let mut all = vec![
            Self::Node,
            Self::NodeMesh,
            Self::Lattice(LatticeBits::Q10),
            Self::LatticeMesh(Step::Finest),
            Self::LatticeMesh(Step::Pixels(0.1)),
            Self::JUDGED,
            Self::WIDE,
            Self::Wide(WideStore::Exact),
        ];
        for store in [WideStore::Exact, WideStore::Packed] {
            let steps = [Step::Finest, Step::Pixels(0.1), JUDGED_STEP];
            all.extend(steps.map(|step| Self::WideMesh(store, step)));
        }
        let others = LatticeBits::ALL.map(Self::Lattice).into_iter();
        all.extend(others.filter(Self::is_other_width));
        all.retain(|method| !place.is_gpu() || !method.is_for_cpu());
        all
    }

    /// The main method of two children that targets are for.
    pub const JUDGED: Self = Self::LatticeMesh(JUDGED_STEP);

    /// Four children with planes in full: what planes in 8 bits are compared with.
    pub const WIDE: Self = Self::Wide(WideStore::Full);

    /// Whether the method is measured only for the width of its nodes.
    pub fn is_other_width(&self) -> bool {
        matches!(self, Self::Lattice(bits) if *bits != LatticeBits::Q10)
    }

    /// Whether no GPU has the method's nodes.
    const fn is_for_cpu(self) -> bool {
        matches!(self, Self::Lattice(_) | Self::LatticeMesh(_))
    }

    /// The name in tables.
    pub fn name(self) -> String {
        let nodes = match self {
            Self::Plain => "plain",
            Self::Node => "NODE",
            Self::NodeMesh => "NODE+MESH",
            _ => self.nodes().name(),
        };
        match self.step() {
            None => nodes.into(),
            Some(Step::Finest) => format!("{nodes}, mesh at finest step"),
            Some(Step::Pixels(pixels)) => format!("{nodes}, mesh to {pixels}px"),
        }
    }

    fn nodes(self) -> NodeCodec {
        match self {
            Self::Plain => NodeCodec::F32,
            Self::Node | Self::NodeMesh => NodeCodec::Paper10,
            Self::Lattice(bits) => NodeCodec::Lattice(bits),
            Self::LatticeMesh(_) => NodeCodec::Lattice(LatticeBits::Q10),
            Self::Wide(store) | Self::WideMesh(store, _) => NodeCodec::Wide(store),
        }
    }

    /// The step of the triangles' lattice, if they are on one.
    const fn step(self) -> Option<Step> {
        match self {
            Self::LatticeMesh(step) | Self::WideMesh(_, step) => Some(step),
            _ => None,
        }
    }

    /// Bytes per node.
    pub fn node_bytes(self) -> usize {
        self.nodes().node_bytes()
    }

    /// Prepares a scene. Pixels are those of a picture with these settings.
    pub fn prepare<'a>(self, scene: &'a Scene, settings: &RenderSettings) -> Prepared<'a> {
        let mut prepared = Prepared {
            method: self,
            scene: Cow::Borrowed(scene),
            config: BuildConfig {
                nodes: self.nodes(),
                ..BuildConfig::default()
            },
            moved: None,
        };
        if self == Self::NodeMesh {
            prepared.config.mesh = MeshCodec::Leaf10;
        }
        if let Some(step) = self.step() {
            let step_exponent = step.exponent(scene, settings);
            let mesh = &mut prepared.scene.to_mut().mesh;
            mesh.snap(step_exponent);
            let moves = snapped(&scene.mesh.vertices, &mesh.vertices, step_exponent);
            prepared.moved = Some([moves.most, moves.bound].map(|distance| distance as f32));
            prepared.config.mesh = MeshCodec::Lattice { step_exponent };
        }
        prepared
    }
}
