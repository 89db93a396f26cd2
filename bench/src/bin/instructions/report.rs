//! The record in Markdown.

use super::LIMIT;
use super::jobs::Job;
use super::options::Options;
use anyhow::Result;
use slimbvh_bench::machine;
use std::fmt::Write;

/// The counts of a job.
pub struct Row {
    /// The job.
    pub job: Job,
    /// Instructions with `off`, `auto` and `on`, loading not included.
    pub counts: [u64; 3],
    /// The decisions of `auto`.
    pub said: String,
}

impl Row {
    /// The ratio of auto to off.
    pub fn ratio(&self) -> f64 {
        self.counts[1] as f64 / self.counts[0] as f64
    }

    /// The ratio of on to off.
    fn ratio_on(&self) -> f64 {
        self.counts[2] as f64 / self.counts[0] as f64
    }
}

/// Returns the tables and the median ratio of auto to off.
pub fn report(rows: &[Row], options: &Options) -> Result<(String, f64)> {
    let mut out = String::new();
    let mut ratios: Vec<f64> = rows.iter().map(Row::ratio).collect();
    ratios.sort_by(f64::total_cmp);
    let decided: Vec<f64> = of(rows, |row| !row.said.starts_with("declined"));
    let (median, least, most) = spread(&ratios);
    writeln!(out, "# Never slower\n\n    {}\n", options.command())?;
    writeln!(
        out,
        "Instructions of a frame on the CPU, one thread: the plan, the survey where there is one, the builds and the \
         picture, without loading. Of 100 frames that share a survey: the survey once, each frame built and rendered \
         anew. Counted by Valgrind, {}, on {}.\n",
        env!("BENCH_RUSTC"),
        machine::date()
    )?;
    writeln!(
        out,
        "| `auto` against `off` | views | median | least | most |\n|---|--:|--:|--:|--:|"
    )?;
    writeln!(
        out,
        "| all | {} | {median:.4} | {least:.4} | {most:.4} |",
        rows.len()
    )?;
    if !decided.is_empty() {
        let (median, least, most) = spread(&decided);
        let count = decided.len();
        writeln!(
            out,
            "| where it surveyed | {count} | {median:.4} | {least:.4} | {most:.4} |"
        )?;
    }
    writeln!(out, "\nThe median may be {LIMIT} at most.\n")?;
    writeln!(
        out,
        "| scene | view | off, M | auto, M | on, M | auto / off | on / off | auto |\n|---|---|--:|--:|--:|--:|--:|---|"
    )?;
    for row in rows {
        let [off, auto, on] = row.counts.map(|count| count as f64 * 1e-6);
        writeln!(
            out,
            "| {} | {} | {off:.1} | {auto:.1} | {on:.1} | {:.4} | {:.2} | {} |",
            row.job.scene.name,
            row.job.view.name,
            row.ratio(),
            row.ratio_on(),
            row.said,
        )?;
    }
    Ok((out, median))
}

/// The ratios of the selected rows, sorted.
fn of(rows: &[Row], is_wanted: impl Fn(&&Row) -> bool) -> Vec<f64> {
    let mut ratios: Vec<f64> = rows.iter().filter(is_wanted).map(Row::ratio).collect();
    ratios.sort_by(f64::total_cmp);
    ratios
}

/// Median, least and largest of sorted numbers.
fn spread(ratios: &[f64]) -> (f64, f64, f64) {
    let middle = ratios.len() / 2;
    let median = if ratios.len() % 2 == 1 {
        ratios[middle]
    } else {
        0.5 * (ratios[middle - 1] + ratios[middle])
    };
    (median, ratios[0], ratios[ratios.len() - 1])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_median_of_few() {
        assert_eq!(spread(&[1.0, 2.0, 5.0]), (2.0, 1.0, 5.0));
        assert_eq!(spread(&[1.0, 2.0, 4.0, 5.0]), (3.0, 1.0, 5.0));
    }
}
