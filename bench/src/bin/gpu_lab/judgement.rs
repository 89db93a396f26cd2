//! Judges answers: to the bit on a software adapter; on hardware by primitive and t, with the bounds of the parity tests.

use bytemuck::allocation::pod_collect_to_vec;
use bytemuck::{NoUninit, bytes_of};
use slimbvh_bench::tracers::Question;
use slimbvh_core::Hit;
use slimbvh_tests::parity::{GRAZING, close_hits};
use std::ops::AddAssign;

/// Numbers of answers whose bits are not the expected ones.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Judgement {
    /// On a software adapter all. On hardware answers beyond the bound of t or with another primitive, if they are more of a set
    /// than may graze.
    pub wrong: usize,
    /// On hardware the same answers, if they are no more than may graze.
    pub grazing: usize,
    /// On hardware hits of the expected primitive with t within the bound.
    pub last_bits: usize,
}

impl Judgement {
    /// Judges the answers to one set of rays, as words: [`Hit`]s, or 1 and 0.
    pub fn new(question: Question, expected: &[u32], answers: &[u32], is_software: bool) -> Self {
        match question {
            Question::Closest => {
                let [expected, answers] = [expected, answers].map(pod_collect_to_vec::<_, Hit>);
                let is_close = |a: &Hit, b: &Hit| close_hits(&[*a], &[*b]).is_ok();
                Self::by(
                    &expected,
                    &answers,
                    |a, b| !is_software && is_close(a, b),
                    is_software,
                )
            }
            Question::Any => Self::by(expected, answers, |_, _| false, is_software),
        }
    }

    fn by<T: NoUninit>(
        expected: &[T],
        answers: &[T],
        is_close: impl Fn(&T, &T) -> bool,
        is_software: bool,
    ) -> Self {
        let pairs = answers.iter().zip(expected);
        let other = pairs.filter(|(a, b)| bytes_of(*a) != bytes_of(*b));
        let (close, far): (Vec<_>, Vec<_>) = other.partition(|(a, b)| is_close(a, b));
        let may_graze = !is_software && far.len() * GRAZING <= expected.len();
        let (wrong, grazing) = if may_graze {
            (0, far.len())
        } else {
            (far.len(), 0)
        };
        Self {
            wrong: wrong + expected.len().abs_diff(answers.len()),
            grazing,
            last_bits: close.len(),
        }
    }
}

impl AddAssign for Judgement {
    fn add_assign(&mut self, other: Self) {
        self.wrong += other.wrong;
        self.grazing += other.grazing;
        self.last_bits += other.last_bits;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The judgement on hardware and in software of 200 hits of which some are changed.
    fn judged(change: impl Fn(&mut Hit), changed: usize) -> [Judgement; 2] {
        let sound = [Hit {
            t: 2.0,
            u: 0.25,
            v: 0.5,
            primitive: 3,
        }; 200];
        let mut off = sound;
        off[17..17 + changed].iter_mut().for_each(change);
        let [sound, off]: [&[u32]; 2] = [&sound, &off].map(|hits| bytemuck::cast_slice(hits));
        [false, true].map(|is_software| Judgement::new(Question::Closest, sound, off, is_software))
    }

    const fn wrong(wrong: usize) -> Judgement {
        Judgement {
            wrong,
            grazing: 0,
            last_bits: 0,
        }
    }

    #[test]
    fn hits_are_judged_by_their_bits_in_software_and_by_bounds_on_hardware() {
        let none = Judgement::default();
        assert_eq!(judged(|_| (), 100), [none; 2]);
        // The last bit of t.
        let last_bits = Judgement {
            last_bits: 150,
            ..none
        };
        let nudge = |hit: &mut Hit| hit.t = hit.t.next_up();
        assert_eq!(judged(nudge, 150), [last_bits, wrong(150)]);
        // Beyond the bounds: another t, another primitive, a miss. Two of 200 may graze, three may not.
        let changes: [fn(&mut Hit); 4] = [
            |hit| hit.t = 2.0001,
            |hit| hit.t = f32::NAN,
            |hit| hit.primitive = 4,
            |hit| {
                *hit = Hit {
                    t: f32::MAX,
                    primitive: u32::MAX,
                    ..*hit
                }
            },
        ];
        for change in changes {
            let grazing = Judgement { grazing: 2, ..none };
            assert_eq!(judged(change, 2), [grazing, wrong(2)]);
            assert_eq!(judged(change, 3), [wrong(3); 2]);
        }
    }

    #[test]
    fn answers_of_yes_and_no_are_judged() {
        let sound = [1; 200];
        for (changed, on_hardware) in [(2, 0), (3, 3)] {
            let mut off = sound;
            off[5..5 + changed].fill(0);
            let judged = |is_software| Judgement::new(Question::Any, &sound, &off, is_software);
            assert_eq!(judged(false).wrong, on_hardware);
            assert_eq!(judged(false).wrong + judged(false).grazing, changed);
            assert_eq!(judged(true), wrong(changed));
        }
    }

    #[test]
    fn absent_answers_are_wrong() {
        for is_software in [false, true] {
            let judged = |answers| Judgement::new(Question::Any, &[1; 200], answers, is_software);
            assert_eq!(judged(&[1; 199]), wrong(1));
            assert_eq!(judged(&[]), wrong(200));
        }
    }
}
