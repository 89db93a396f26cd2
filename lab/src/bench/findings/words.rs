//! Phrases of the findings.

use super::super::measure::SetupRecord;
use super::super::spread::{Ratios, WITHIN};
use super::super::times::Times;
use super::Verdict;

/// A sentence with its verdict.
pub type Sentence = (Verdict, String);

/// A sentence that compares a part of the time with the default's.
pub fn time(own: &SetupRecord, of: fn(&Times) -> f64, what: &str, place: &str) -> Sentence {
    let ratios = own.ratios(of);
    let text = format!(
        "{what} takes {:.2} times the default's time on this {}{}.",
        ratios.median,
        place.to_uppercase(),
        within(&ratios)
    );
    (verdict(&ratios), text)
}

/// The verdict on a ratio of times: a win if it is clearly below 1.
pub fn verdict(ratios: &Ratios) -> Verdict {
    match ratios.is_clear() {
        true => win_if(ratios.median < 1.0),
        false => Verdict::Open,
    }
}

/// What follows a ratio of times that is not clear.
pub fn within(ratios: &Ratios) -> String {
    match ratios.is_clear() {
        true => String::new(),
        false => format!(", {WITHIN}"),
    }
}

/// `own / usual`, or 1 if `usual` is 0.
pub fn quotient(own: f64, usual: f64) -> f64 {
    match usual > 0.0 {
        true => own / usual,
        false => 1.0,
    }
}

pub fn win_if(wins: bool) -> Verdict {
    match wins {
        true => Verdict::Wins,
        false => Verdict::Loses,
    }
}

/// A time compared with the default's, in words.
pub fn compared(ratios: &Ratios) -> String {
    let ratio = match ratios.median {
        ratio if ratio < 1.0 => format!("in {} of the time", percent(ratio)),
        ratio => format!("in {ratio:.2} times the time"),
    };
    ratio + &within(ratios)
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
        let words = |ratio: f64| compared(&Ratios::new([ratio; 3].into_iter()));
        assert_eq!(words(0.5), "in 50 % of the time");
        assert_eq!(words(2.0), "in 2.00 times the time");
        assert_eq!(
            words(1.01),
            "in 1.01 times the time, which is within the spread of these runs"
        );
        let noisy = Ratios::new([0.5, 0.9, 1.5].into_iter());
        assert_eq!(verdict(&noisy), Verdict::Open);
        assert_eq!(
            compared(&noisy),
            "in 90 % of the time, which is within the spread of these runs"
        );
        assert_eq!((percent(0.27), share(0.0)), ("27 %".into(), "0 %".into()));
        assert_eq!(
            (share(0.0123), share(1e-6)),
            ("1.23 %".into(), "1.0e-4 %".into())
        );
    }
}
