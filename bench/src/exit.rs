//! Exit codes of programs that check something.

use anyhow::Result;
use std::process::ExitCode;

/// 0 without a fault, 1 with one, 2 after an error. A fault is a sentence; it and errors are printed on standard error.
#[must_use]
pub fn code(outcome: Result<Option<String>>) -> ExitCode {
    match outcome {
        Ok(None) => ExitCode::SUCCESS,
        Ok(Some(fault)) => {
            eprintln!("{fault}");
            ExitCode::from(1)
        }
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::from(2)
        }
    }
}

/// The fault of this many wrong answers, if there are any.
#[must_use]
pub fn wrong_answers(count: u64) -> Option<String> {
    (count > 0).then(|| format!("WRONG: {count} answers are not the CPU's"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faults_and_errors_have_codes_of_their_own() {
        let codes = [
            code(Ok(wrong_answers(0))),
            code(Ok(wrong_answers(3))),
            code(Err(anyhow::anyhow!("no such file"))),
        ];
        let expected = [0, 1, 2].map(ExitCode::from);
        assert_eq!(format!("{codes:?}"), format!("{expected:?}"));
    }
}
