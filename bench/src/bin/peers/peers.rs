//! All peers as one tracer with a tree for each peer, so that exact answers are computed once for all.

use crate::child::Task;
use crate::contain::{MISS, contained};
use crate::options::Options;
use anyhow::{Result, ensure};
use slimbvh::Ray;
use slimbvh_bench::Input;
use slimbvh_bench::tracers::{TINY, tracers};
use slimbvh_lab::stress::{BOUND_ULPS, Case, Effort, Failure, Outcome, Row, Tracer, Tree};
use std::collections::HashMap;
use std::time::Duration;

/// A peer's tracer, and the names in its rows.
#[derive(Clone, Copy, Debug)]
pub struct Peer {
    /// Its name among the tracers.
    pub tracer: &'static str,
    /// The peer's name.
    row: &'static str,
    /// The tree's name.
    tree: &'static str,
}

/// One tree for each library and each of its ways to test boxes and triangles. Other presets use the same arithmetic.
const ASKED: [Peer; 7] = [
    Peer::new("obvhs fastest", "obvhs", "fastest"),
    Peer::new("obvhs cwbvh8 fastest", "obvhs cwbvh8", "fastest"),
    Peer::new("bvh nearest", "bvh", "nearest"),
    Peer::new("parry3d", "parry3d", "trimesh"),
    Peer::new(TINY, "tinybvh", "wide"),
    Peer::new("embree sah", "embree", "robust"),
    Peer::new("embree sah x16", "embree x16", "robust"),
];

impl Peer {
    const fn new(tracer: &'static str, row: &'static str, tree: &'static str) -> Self {
        Self { tracer, row, tree }
    }
}

/// The peers in this build.
pub fn asked() -> impl Iterator<Item = Peer> {
    let mesh = slimbvh::Mesh::default();
    let input = Input::new(&mesh);
    let names: Vec<&str> = tracers(&input).iter().map(|tracer| tracer.name()).collect();
    ASKED
        .into_iter()
        .filter(move |peer| names.contains(&peer.tracer))
}

/// All peers.
pub struct Peers {
    /// The place of the current case.
    pub number: usize,
    peers: Vec<Peer>,
    effort: Effort,
    limit: Duration,
    /// Failures of the last case by tracer: a word and a sentence.
    failures: HashMap<String, (String, String)>,
}

impl Peers {
    pub fn new(options: &Options) -> Result<Self> {
        let peers: Vec<Peer> = asked().filter(|peer| options.wants(peer.tracer)).collect();
        ensure!(!peers.is_empty(), "there are no peers to ask");
        Ok(Self {
            number: 0,
            peers,
            effort: options.effort,
            limit: options.limit,
            failures: HashMap::new(),
        })
    }

    /// Renames a row after its peer; the word for a failure takes the place of its tree.
    pub fn named(&self, mut row: Row) -> Row {
        let Some(peer) = self.peers.iter().find(|peer| peer.tracer == row.codec) else {
            return row;
        };
        row.tracer = peer.row.into();
        row.codec = peer.tree.into();
        if let Some((word, sentence)) = self.failures.get(peer.tracer) {
            row.codec.clone_from(word);
            row.example = Some(format!("{word}: {sentence}"));
        }
        row
    }
}

impl Tracer for Peers {
    fn name(&self) -> &str {
        "peers"
    }

    fn backend(&self) -> &'static str {
        "cpu"
    }

    fn bound_ulps(&self) -> f64 {
        BOUND_ULPS
    }

    fn trees(&self, _: &Case) -> Vec<Tree> {
        let tree = |peer: &Peer| Tree {
            codec: peer.tracer.into(),
            is_reduced: false,
        };
        self.peers.iter().map(tree).collect()
    }

    fn trace(&mut self, case: &Case, tree: &Tree, rays: &[Ray]) -> Result<Outcome, Failure> {
        let task = Task {
            peer: &tree.codec,
            case: self.number,
            effort: self.effort,
            first: 0,
            careful_until: 0,
        };
        let answered = contained(task, rays.len(), self.limit)?;
        self.failures.remove(&tree.codec);
        if let Some((word, sentence)) = answered.failure {
            eprintln!("  {}: {word}: {sentence}", tree.codec);
            self.failures.insert(tree.codec.clone(), (word, sentence));
        }
        if answered.refused > 0 {
            eprintln!("  {}: does not take {} rays", tree.codec, answered.refused);
        }
        let mut answers = answered.answers;
        answers.resize(rays.len(), MISS);
        let corner = |v: u32| case.mesh.vertices[v as usize];
        let triangles = case.mesh.indices.iter().map(|face| face.map(corner));
        Ok(Outcome {
            answers,
            triangles: triangles.collect(),
            time_ms: answered.time_ms,
            ..Outcome::default()
        })
    }
}
