//! Phrases of the findings.

use super::super::measure::SetupRecord;
use super::super::times::{Round, Times};
use super::Verdict;

/// A sentence with its verdict.
pub type Sentence = (Verdict, String);

/// Times that differ by less than this share count as equal, whatever the spread.
pub const MIN_DIFFERENCE: f64 = 0.03;

/// A sentence that compares a part of the time with the default's.
pub fn time(own: &SetupRecord, of: fn(&Times) -> f64, what: &str, place: &str) -> Sentence {
    let ratio = own.ratio(of);
    let clear = match is_clear(own, of) {
        true => "",
        false => ", which is within the spread of these runs",
    };
    let text = format!(
        "{what} takes {ratio:.2} times the default's time on this {}{clear}.",
        place.to_uppercase()
    );
    (win_if(ratio < 1.0 && clear.is_empty()), text)
}

/// `own / usual`, or 1 if `usual` is 0.
pub fn quotient(own: f64, usual: f64) -> f64 {
    match usual > 0.0 {
        true => own / usual,
        false => 1.0,
    }
}

/// Whether all rounds agree that a time is shorter than the default's, or that it is longer.
pub fn is_clear(own: &SetupRecord, of: fn(&Times) -> f64) -> bool {
    let ratio = |round: &Round| of(&round.own) / of(&round.usual);
    let faster = own
        .rounds
        .0
        .iter()
        .all(|round| ratio(round) < 1.0 - MIN_DIFFERENCE);
    let slower = own
        .rounds
        .0
        .iter()
        .all(|round| ratio(round) > 1.0 + MIN_DIFFERENCE);
    faster || slower
}

pub fn win_if(wins: bool) -> Verdict {
    match wins {
        true => Verdict::Wins,
        false => Verdict::Loses,
    }
}

/// A part of the time compared with the default's, in words.
pub fn compared(own: &SetupRecord, of: fn(&Times) -> f64) -> String {
    match is_clear(own, of) {
        true => in_words(own.ratio(of)),
        false => "in about the same time".into(),
    }
}

/// A ratio of times in words.
pub fn in_words(ratio: f64) -> String {
    match ratio {
        ratio if ratio < 1.0 - MIN_DIFFERENCE => format!("in {} of the time", percent(ratio)),
        ratio if ratio > 1.0 + MIN_DIFFERENCE => format!("in {ratio:.2} times the time"),
        _ => "in the same time".into(),
    }
}

/// A share in whole percent.
pub fn percent(share: f64) -> String {
    format!("{:.0} %", 100.0 * share)
}

/// A share in percent, with an exponent if it is small.
pub fn share(share: f64) -> String {
    match 100.0 * share {
        0.0 => "0 %".into(),
        percent if percent >= 0.01 => format!("{percent:.2} %"),
        percent => format!("{percent:.1e} %"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ratios_and_shares_in_words() {
        assert_eq!(in_words(0.5), "in 50 % of the time");
        assert_eq!(in_words(1.01), "in the same time");
        assert_eq!(in_words(2.0), "in 2.00 times the time");
        assert_eq!((percent(0.27), share(0.0)), ("27 %".into(), "0 %".into()));
        assert_eq!(
            (share(0.0123), share(1e-6)),
            ("1.23 %".into(), "1.0e-4 %".into())
        );
    }
}
