use super::tables::tables;
use crate::measure::table::Table;
use crate::stress::Row;

fn row(family: &str, magnitude: &str, codec: &str) -> Row {
    Row {
        tracer: "slimbvh".into(),
        family: family.into(),
        magnitude: magnitude.into(),
        backend: "cpu".into(),
        codec: codec.into(),
        reduction: "whole".into(),
        rays: 20_000,
        t_error_ulps: 1234.5,
        depth: Some(7),
        time_ms: 1.25,
        ..Row::default()
    }
}

fn text(rows: &[Row]) -> String {
    tables(rows).iter().map(Table::text).collect()
}

#[test]
fn rows_are_summed_up_and_faults_are_listed() {
    let mut rows = vec![
        row("scaled", "1e3", "f32"),
        row("scaled", "1e3", "q10"),
        row("scaled", "1e6", "f32"),
    ];
    let clean = text(&rows);
    assert!(!clean.contains("Faults"), "{clean}");
    let line = clean.lines().find(|line| line.starts_with("  scaled"));
    let cells: Vec<&str> = line.unwrap_or_default().split_whitespace().collect();
    let expected = [
        "scaled", "slimbvh", "cpu", "2", "60,000", "0", "0", "0", "0", "1234.5", "0.0", "7", "–",
        "4",
    ];
    assert_eq!(cells, expected);

    rows[2].missed = 3;
    rows[2].moved = Some(0.5);
    rows[2].moved_bound = Some(2.0);
    let faulty = text(&rows);
    assert!(faulty.contains("Faults"), "{faulty}");
    let last = faulty.lines().last().unwrap_or_default();
    assert!(last.contains("1e6") && last.contains("f32 whole"), "{last}");
    assert!(faulty.contains("25 %"), "{faulty}");
}

#[test]
fn tracers_of_a_family_stand_together() {
    let mut rows = vec![row("scaled", "1e3", "f32"), row("flat", "0", "f32")];
    let others = rows.clone().into_iter().map(|row| Row {
        tracer: "other".into(),
        ..row
    });
    rows.extend(others.collect::<Vec<_>>());
    let text = text(&rows);
    let lines = text.lines().take_while(|line| !line.contains("By codec"));
    let is_row = |line: &&str| line.starts_with("  scaled") || line.starts_with("  flat");
    let own = lines.filter(is_row).map(|line| {
        let mut words = line.split_whitespace();
        [words.next(), words.next()].map(Option::unwrap_or_default)
    });
    let expected = [
        ["scaled", "slimbvh"],
        ["scaled", "other"],
        ["flat", "slimbvh"],
        ["flat", "other"],
    ];
    assert_eq!(own.collect::<Vec<_>>(), expected);
}

/// The longest names and the largest figures fit.
#[test]
fn lines_fit_120_columns() {
    let mut row = row(
        "teapot, stadium",
        "corners at ±f32::MAX/4",
        "paper10+leaf10",
    );
    row.tracer = "parry3d".into();
    row.reduction = "reduced".into();
    row.rays = 20_000_000;
    row.t_error_ulps = 1.5e38;
    row.plane_error_ulps = 99_999.9;
    (row.missed, row.adrift, row.time_ms) = (99_999, 99_999, 99_999.0);
    for line in text(&[row]).lines() {
        assert!(
            line.chars().count() <= 120,
            "{}: {line}",
            line.chars().count()
        );
    }
}
