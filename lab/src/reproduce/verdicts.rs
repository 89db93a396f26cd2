//! The targets, and whether they are met.

use super::measure::{Pictures, SceneRecord};
use super::times::Picture;
use serde::Serialize;

/// A bound, and the figures to compare with it.
#[derive(Debug, Serialize)]
pub struct Verdict {
    /// The bounded quantity.
    pub what: String,
    pub bound: f64,
    /// Whether the bound is a maximum; otherwise it is a minimum.
    pub is_at_most: bool,
    pub measured: Vec<Measured>,
}

/// One scene's figure.
#[derive(Debug, Serialize)]
pub struct Measured {
    pub scene: String,
    pub value: f64,
}

/// Judges all targets that have figures.
pub fn verdicts(records: &[SceneRecord], is_gpu: bool) -> Vec<Verdict> {
    let uniform = || records.iter().filter(|record| record.is_uniform);
    let most = |what: &str, bound: f64, measured: Vec<Measured>| Verdict {
        what: what.into(),
        bound,
        is_at_most: true,
        measured,
    };
    let least = |what: &str, bound: f64, measured: Vec<Measured>| Verdict {
        what: what.into(),
        bound,
        is_at_most: false,
        measured,
    };
    let each = |of: &dyn Fn(&SceneRecord) -> f64| {
        let values = uniform().map(|record| Measured {
            scene: record.name.clone(),
            value: of(record),
        });
        values
            .filter(|measured| !measured.value.is_nan())
            .collect::<Vec<_>>()
    };
    let size = |record: &SceneRecord| {
        let largest = record.sizes.iter().max().map_or(0, |&size| size);
        largest as f64 / record.triangles as f64
    };
    let construction = |record: &SceneRecord| {
        let sets = &record.sets;
        sets.ratio(
            |round| round.sets[0].alone.construction,
            sets,
            |round| round.all,
        )
    };
    let division = |record: &SceneRecord| {
        let sets = &record.sets;
        let alone = |round: &super::measure::SetsRound| round.sets[0].alone.construction;
        sets.ratio(|round| round.sets[0].division.total(), sets, alone)
    };
    let lights =
        uniform().flat_map(|record| record.lights.iter().map(move |lights| (record, lights)));
    let nine = lights
        .filter(|(_, lights)| lights.lights == 9)
        .filter_map(|(record, lights)| {
            let default = &lights.rows.first()?.rounds;
            let grouped = lights
                .rows
                .iter()
                .filter(|row| row.name.starts_with("one set for all"));
            let gains =
                grouped.map(|row| default.ratio(Picture::total, &row.rounds, Picture::total));
            Some(Measured {
                scene: record.name.clone(),
                value: gains.fold(f64::NAN, f64::max),
            })
        });
    let all = vec![
        most("largest set / all triangles", 0.55, each(&size)),
        most(
            "construction over C+, sorted alone / over all",
            0.55,
            each(&construction),
        ),
        most(
            "division / construction over C+",
            if is_gpu { 0.05 } else { 0.10 },
            each(&division),
        ),
        least(
            "primary rays with construction, default / reduced",
            1.8,
            each(&|record| best(record, 1, Picture::primary_total)),
        ),
        least(
            "4×4 samples with one light, default / reduced",
            1.4,
            each(&|record| best(record, 16, Picture::total)),
        ),
        least(
            "9 lights with one set for all, default / reduced",
            1.13,
            nine.collect(),
        ),
    ];
    all.into_iter()
        .filter(|verdict| !verdict.measured.is_empty())
        .collect()
}

/// The speedup of reduced trees with the better way of sorting; NaN without such pictures.
fn best(record: &SceneRecord, samples: u32, of: fn(&Picture) -> f64) -> f64 {
    let pictures = record
        .pictures
        .iter()
        .find(|pictures| pictures.samples == samples);
    let gain = |pictures: &Pictures| {
        let reduced = pictures.reduced.iter();
        let gains = reduced.map(|reduced| pictures.default.ratio(of, &reduced.rounds, of));
        gains.fold(f64::NAN, f64::max)
    };
    pictures.map_or(f64::NAN, gain)
}

impl Verdict {
    /// How far a figure misses the bound, as a share of the bound; not above 0 if it meets the bound.
    fn miss(&self, value: f64) -> f64 {
        let over = value / self.bound - 1.0;
        if self.is_at_most { over } else { -over }
    }

    /// The verdict in one line.
    pub fn line(&self) -> String {
        let word = if self.is_at_most {
            "at most"
        } else {
            "at least"
        };
        let one = |measured: &Measured| {
            let miss = self.miss(measured.value);
            let missed = if miss > 0.0 {
                format!(" (missed by {:.0} %)", 100.0 * miss)
            } else {
                String::new()
            };
            format!("{} {:.3}{missed}", measured.scene, measured.value)
        };
        let list: Vec<String> = self.measured.iter().map(one).collect();
        let missed = self
            .measured
            .iter()
            .filter(|measured| self.miss(measured.value) > 0.0)
            .count();
        let verdict = match missed {
            0 => "met".to_owned(),
            missed if missed == self.measured.len() => "missed".to_owned(),
            missed => format!("missed in {missed} of {}", self.measured.len()),
        };
        format!(
            "{verdict}: {}, {word} {}: {}",
            self.what,
            self.bound,
            list.join(", ")
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn verdict(bound: f64, is_at_most: bool, values: &[f64]) -> String {
        let scenes = ["doll", "dragon"];
        let measured = scenes
            .into_iter()
            .zip(values)
            .map(|(scene, &value)| Measured {
                scene: scene.into(),
                value,
            });
        Verdict {
            what: "x".into(),
            bound,
            is_at_most,
            measured: measured.collect(),
        }
        .line()
    }

    #[test]
    fn bounds_are_met_or_missed_by_a_share() {
        assert_eq!(
            verdict(0.5, true, &[0.5, 0.4]),
            "met: x, at most 0.5: doll 0.500, dragon 0.400"
        );
        let line = verdict(0.5, true, &[0.6, 0.4]);
        assert_eq!(
            line,
            "missed in 1 of 2: x, at most 0.5: doll 0.600 (missed by 20 %), dragon 0.400"
        );
        let line = verdict(2.0, false, &[1.5, 1.0]);
        assert_eq!(
            line,
            "missed: x, at least 2: doll 1.500 (missed by 25 %), dragon 1.000 (missed by 50 %)"
        );
        assert_eq!(
            verdict(2.0, false, &[2.5]),
            "met: x, at least 2: doll 2.500"
        );
    }
}
