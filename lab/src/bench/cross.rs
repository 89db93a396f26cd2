//! Which setups with several changed knobs to measure.

use super::measure::SetupRecord;
use super::pareto::{dominates, front};
use super::setup::{Setup, Triangles};
use slimbvh::{CodeBits, NodeCodec};

/// The objectives of a setup: milliseconds per picture, bytes of the trees, error of the picture. Less is better.
pub type Objectives = [f64; 3];

/// Combines the knob values on the Pareto front. Keeps at most `most` combinations that no measured or predicted setup
/// dominates. A prediction multiplies time and bytes by each knob's own factor, and takes the largest of the knobs' errors.
/// `known_as` finds the setup that was measured in place of one that does the same work.
pub fn candidates(
    records: &[SetupRecord],
    known_as: &impl Fn(Setup) -> Setup,
    most: usize,
) -> Vec<Setup> {
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
                        let predicted = predict(&comparable, known_as, &usual, setup);
                        found.extend(predicted.map(|it| (setup, it)));
                    }
                }
            }
        }
    }
    let predicted: Vec<Objectives> = found.iter().map(|(_, objectives)| *objectives).collect();
    let is_best = front(&predicted);
    let mut best: Vec<_> = found.into_iter().zip(is_best).collect();
    best.retain(|((_, own), is_best)| *is_best && !measured.iter().any(|it| dominates(it, own)));
    best.sort_by(|((_, a), _), ((_, b), _)| a[0].total_cmp(&b[0]));
    let setups = best.into_iter().map(|((setup, _), _)| setup);
    setups.take(most).collect()
}

/// Predicts a setup's objectives; `None` if one of its knobs was not measured alone.
fn predict(
    records: &[&SetupRecord],
    known_as: &impl Fn(Setup) -> Setup,
    usual: &Setup,
    setup: Setup,
) -> Option<Objectives> {
    let of = |setup: Setup| {
        let setup = known_as(setup);
        let record = records.iter().find(|record| record.setup == setup);
        record.map(|record| record.objectives())
    };
    let with_codes = |codes: CodeBits| of(Setup { codes, ..*usual });
    let base = of(*usual)?;
    let with = |nodes: NodeCodec, mesh: Triangles| {
        let is_it = |setup: &Setup| setup.nodes == nodes && setup.mesh == mesh;
        let record = records.iter().find(|record| is_it(&record.setup));
        record.map(|record| record.objectives())
    };
    // Nodes and triangles that were not measured together: the nodes' own factor, and the triangles' with other nodes.
    let [nodes, mesh] = match with(setup.nodes, setup.mesh) {
        Some(both) => [(both, base), (base, base)],
        None => {
            let others = *setup.mesh.nodes().first()?;
            [
                (with(setup.nodes, Triangles::Full)?, base),
                (with(others, setup.mesh)?, with(others, Triangles::Full)?),
            ]
        }
    };
    let reduced = of(Setup {
        reduce: setup.reduce,
        lights: setup.lights,
        ..*usual
    })?;
    let pairs = [
        (reduced, base),
        nodes,
        mesh,
        (with_codes(setup.codes)?, base),
    ];
    let mut predicted = base;
    for (own, other) in pairs {
        for which in [0, 1] {
            predicted[which] *= own[which] / other[which].max(f64::MIN_POSITIVE);
        }
        predicted[2] = predicted[2].max(own[2]);
    }
    Some(predicted)
}
