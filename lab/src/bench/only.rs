//! The choice of setups, by `--only`.

use super::setup::{Knob, Setup};
use anyhow::{Result, bail};
use clap::ValueEnum;

/// Which setups to measure besides the default: all, or those of some knobs or names.
#[derive(Clone, Debug, Default)]
pub struct Only(Vec<String>);

impl Only {
    /// The choice by these words: names of knobs ("nodes", "crossed"), or parts of setups' names ("nodes q10", "refit"). No word
    /// chooses all.
    ///
    /// # Errors
    /// For a word that chooses none of the setups.
    pub fn new(words: &[String], threads: usize, light_count: usize) -> Result<Self> {
        let usual = Setup::usual(threads);
        let all = Setup::one_at_a_time(threads, light_count);
        for word in words {
            let is_it = |(knob, setup): &(Knob, Setup)| is_of(word, *knob, &setup.name(&usual));
            if knob(word).is_none() && !all.iter().any(is_it) {
                let knobs = Knob::value_variants().iter().map(|knob| name(*knob));
                let knobs: Vec<String> = knobs.collect();
                bail!(
                    "--only {word:?} names no setup; give a knob ({}), or a setup as the table calls it, such as \"nodes q10\"",
                    knobs.join(", ")
                );
            }
        }
        Ok(Self(words.to_vec()))
    }

    /// Whether a setup is to be measured. The default is always, as all others are compared with it.
    pub fn wants(&self, knob: Knob, setup: &str) -> bool {
        knob == Knob::Default
            || self.0.is_empty()
            || self.0.iter().any(|word| is_of(word, knob, setup))
    }

    /// The option as written on the command line.
    pub fn words(&self) -> Option<String> {
        let list = self.0.join(",");
        let list = match list.contains(' ') {
            true => format!("{list:?}"),
            false => list,
        };
        (!self.0.is_empty()).then(|| format!("--only {list}"))
    }
}

/// Whether a word is a setup's knob, or one of the parts of its name.
fn is_of(word: &str, own: Knob, setup: &str) -> bool {
    match knob(word) {
        Some(knob) => knob == own,
        None => own != Knob::Crossed && setup.split(", ").any(|part| part == word),
    }
}

/// The knob of this name.
fn knob(word: &str) -> Option<Knob> {
    let mut all = Knob::value_variants().iter();
    all.find(|knob| name(**knob) == word).copied()
}

fn name(knob: Knob) -> String {
    let value = knob.to_possible_value();
    value.map_or_else(String::new, |value| value.get_name().to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chosen(words: &[&str]) -> Vec<String> {
        let words: Vec<String> = words.iter().map(|&word| word.to_owned()).collect();
        let only = Only::new(&words, 4, 2).expect("they name setups");
        let usual = Setup::usual(4);
        let all = Setup::one_at_a_time(4, 2).into_iter();
        let all = all.map(|(knob, setup)| (knob, setup.name(&usual)));
        let all = all.filter(|(knob, name)| only.wants(*knob, name));
        all.map(|(_, name)| name).collect()
    }

    #[test]
    fn knobs_and_names_choose_setups() {
        assert_eq!(chosen(&[]).len(), Setup::one_at_a_time(4, 2).len());
        assert_eq!(chosen(&["reduce"]), ["default", "reduce off", "reduce on"]);
        assert_eq!(
            chosen(&["threads", "nodes q10"]),
            [
                "default",
                "nodes q10",
                "nodes q10, mesh lattice",
                "nodes q10, mesh lattice 0.1px",
                "nodes q10, mesh lattice 0.5px",
                "nodes q10, mesh lattice 2px",
                "1 thread",
                "2 threads"
            ]
        );
        assert_eq!(chosen(&["refit"]), ["default", "refit"]);
        assert_eq!(chosen(&["crossed"]), ["default"]);
        let crossed = Only::new(&["crossed".into()], 4, 2).expect("it is a knob");
        assert!(crossed.wants(Knob::Crossed, "reduce on, nodes q10"));
        assert!(!crossed.wants(Knob::Reduce, "reduce on"));
    }

    #[test]
    fn other_words_are_refused_by_name() {
        for word in ["node", "nodes q11", "", "lattice"] {
            let error = Only::new(&[word.to_owned()], 4, 2).expect_err("it names none");
            let error = error.to_string();
            assert!(error.contains(&format!("{word:?}")), "{error}");
            assert!(error.contains("reduce, lights, nodes"), "{error}");
        }
    }
}
