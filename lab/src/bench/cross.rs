//! Which setups with several knobs moved are worth a try.

use super::measure::SetupRecord;
use super::pareto::{dominates, front};
use super::setup::{Setup, Triangles};
use slimbvh::{CodeBits, NodeCodec};

/// What setups are compared by: milliseconds a picture, bytes of trees, and how far the picture is off. Less is better.
pub type Objectives = [f64; 3];

/// Crosses the values of knobs that are on the front by themselves, and keeps what nothing measured or foretold is better than:
/// each knob is taken to multiply times and bytes by as much as it does alone, and errors to be as large as the largest.
pub fn candidates(records: &[SetupRecord], most: usize) -> Vec<Setup> {
    let Some(usual) = records.first().map(|record| record.setup) else {
        return Vec::new();
    };
    let comparable = records.iter().filter(|it| it.setup.is_comparable(&usual));
    let comparable: Vec<&SetupRecord> = comparable.collect();
    let measured: Vec<Objectives> = comparable.iter().map(|it| it.objectives()).collect();
    let on_front = front(&measured);
    let chosen = comparable.iter().zip(on_front).filter(|(_, on)| *on);
    let mut values: Vec<Setup> = chosen.map(|(record, _)| record.setup).collect();
    values.push(usual);

    let mut found: Vec<(Setup, Objectives)> = Vec::new();
    for reduce in &values {
        for nodes in &values {
            for mesh in &values {
                for codes in &values {
                    let setup = Setup {
                        reduce: reduce.reduce,
                        lights: reduce.lights,
                        nodes: nodes.nodes,
                        mesh: mesh.mesh,
                        codes: codes.codes,
                        ..usual
                    };
                    let is_new = comparable.iter().all(|record| record.setup != setup)
                        && found.iter().all(|(other, _)| *other != setup);
                    if is_new && setup.is_possible() {
                        found.extend(foretell(&comparable, &usual, setup).map(|it| (setup, it)));
                    }
                }
            }
        }
    }
    let foretold: Vec<Objectives> = found.iter().map(|(_, objectives)| *objectives).collect();
    let is_best = front(&foretold);
    let mut best: Vec<_> = found.into_iter().zip(is_best).collect();
    best.retain(|((_, own), is_best)| *is_best && !measured.iter().any(|it| dominates(it, own)));
    best.sort_by(|((_, a), _), ((_, b), _)| a[0].total_cmp(&b[0]));
    let setups = best.into_iter().map(|((setup, _), _)| setup);
    setups.take(most).collect()
}

/// None where a knob was not measured by itself.
fn foretell(records: &[&SetupRecord], usual: &Setup, setup: Setup) -> Option<Objectives> {
    let of = |setup: Setup| {
        let record = records.iter().find(|record| record.setup == setup);
        record.map(|record| record.objectives())
    };
    let with_nodes = |nodes: NodeCodec| of(Setup { nodes, ..*usual });
    let with_codes = |codes: CodeBits| of(Setup { codes, ..*usual });
    let base = of(*usual)?;
    // A mesh in a codec was measured with the nodes that go with it.
    let (mesh, its_nodes) = match setup.mesh {
        Triangles::Full => (base, base),
        mesh => {
            let same_mesh = records.iter().find(|record| record.setup.mesh == mesh)?;
            (same_mesh.objectives(), with_nodes(mesh.nodes())?)
        }
    };
    let reduced = of(Setup {
        reduce: setup.reduce,
        lights: setup.lights,
        ..*usual
    })?;
    let pairs = [
        (reduced, base),
        (with_nodes(setup.nodes)?, base),
        (mesh, its_nodes),
        (with_codes(setup.codes)?, base),
    ];
    let mut foretold = base;
    for (own, other) in pairs {
        for which in [0, 1] {
            foretold[which] *= own[which] / other[which].max(f64::MIN_POSITIVE);
        }
        foretold[2] = foretold[2].max(own[2]);
    }
    Some(foretold)
}
