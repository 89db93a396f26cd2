//! What is measured, and what is concluded from it.

use super::{TINY, report};
use crate::bench::equal::Work;
use crate::bench::findings::{Finding, Verdict, findings};
use crate::bench::measure::{Conditions, mark_front, measure};
use crate::bench::only::Only;
use crate::bench::page::page;
use crate::bench::prepared::Prepared;
use crate::bench::scenes::Subject;
use crate::bench::setup::{Knob, Setup};
use crate::bench::times::{Round, Times};
use crate::measure::rounds::Rounds;
use slimbvh::RenderSettings;
use slimbvh::reduce::Reduce;
use slimbvh_cli::backend::Chosen;

/// Setups with the same work are measured once and named; others are not taken for equal.
#[test]
fn no_work_is_measured_twice() {
    let report = report();
    let [scene] = &report.records[..] else {
        unreachable!("there is one scene");
    };
    let names: Vec<&str> = scene.setups.iter().map(|it| it.name.as_str()).collect();
    for equal in &scene.equal {
        assert!(!names.contains(&equal.setup.as_str()), "{equal:?}");
        assert!(names.contains(&equal.measured_as.as_str()), "{equal:?}");
    }
    let texts = [report.text(), page(&report).unwrap()];
    for text in texts.map(|text| text.replace("&quot;", "\"").replace('\n', " ")) {
        assert!(text.contains("\"reduce off\" (default)"), "{text}");
    }

    let subject = Subject::new("shiny", TINY.size, None).unwrap();
    let settings = RenderSettings {
        size: TINY.size,
        ..RenderSettings::default()
    };
    let work = |setup: Setup| Work::new(&Prepared::new(setup, &subject.scene, settings)).unwrap();
    let usual = Setup::usual(2);
    assert!(work(usual).is_same(&work(Setup::plain(2))));
    for (knob, setup) in Setup::one_at_a_time(2, 2) {
        if matches!(knob, Knob::Default | Knob::Reduce) {
            continue;
        }
        assert!(!work(setup).is_same(&work(usual)), "{knob:?}");
    }
    let reduced = Setup {
        reduce: Reduce::On,
        ..usual
    };
    assert!(!work(reduced).is_same(&work(usual)));
}

/// Nothing is concluded from times that spread too much, or of which there are too few; from steady ones it is.
#[test]
fn conclusions_need_more_than_the_spread() {
    let report = report();
    // One round.
    assert!(report.rows.iter().all(|row| !row.is_clear));
    let about_times = |finding: &&Finding| finding.text.contains("default's time");
    let mut found = report.findings.iter().filter(about_times).peekable();
    assert!(found.peek().is_some());
    for finding in found {
        assert_eq!(finding.verdict, Verdict::Open, "{}", finding.text);
        assert!(
            finding.text.contains("within the spread"),
            "{}",
            finding.text
        );
    }

    let subject = Subject::new("shiny", TINY.size, None).unwrap();
    let only = Only::new(&["nodes q10".into()], 2, 2).unwrap();
    let conditions = Conditions {
        protocol: &TINY,
        threads: 2,
        only: &only,
    };
    let mut scene = measure(&subject, &Chosen::Cpu, &conditions).unwrap();
    let with = |ratios: [f64; 3]| {
        let usual = Times {
            primary: 8.0,
            ..Times::default()
        };
        let own = |ratio| Times {
            primary: 8.0 * ratio,
            ..Times::default()
        };
        Rounds(Vec::from(ratios.map(|ratio| Round {
            usual,
            own: own(ratio),
        })))
    };
    for (ratios, verdict) in [
        ([0.5, 0.51, 0.52], Verdict::Wins),
        ([0.5, 0.9, 1.9], Verdict::Open),
        ([0.93, 0.94, 1.02], Verdict::Open),
        ([1.5, 1.51, 1.52], Verdict::Loses),
    ] {
        for record in &mut scene.setups {
            let is_it = record.name.starts_with("nodes q10");
            record.rounds = with(if is_it { ratios } else { [1.0; 3] });
            record.usual_ms = 8.0;
        }
        mark_front(&mut scene.setups);
        let tracing = findings(&scene).into_iter();
        let tracing: Vec<Finding> = tracing
            .filter(|it| it.text.starts_with("Tracing nodes of 10 bits"))
            .collect();
        assert_eq!(tracing.len(), 1);
        assert_eq!(tracing[0].verdict, verdict, "{}", tracing[0].text);
        let says_so = tracing[0].text.contains("within the spread");
        assert_eq!(says_so, verdict == Verdict::Open, "{}", tracing[0].text);
        // It is smaller than the default, whose place on the front is sure only if it is clearly slower.
        let usual = &scene.setups[0];
        let is_sure = usual.on_front && usual.front_is_clear;
        assert_eq!(is_sure, verdict == Verdict::Loses, "{ratios:?}");
    }
}
