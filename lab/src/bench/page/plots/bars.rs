//! The parts of times as bars.

use super::super::super::measure::SetupRecord;
use super::super::super::report::ms;
use super::{INK, part_color, themed};
use anyhow::Result;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// One bar per setup, made of the parts of its time.
pub fn bars(records: &[&SetupRecord]) -> Result<String> {
    // Room for the longest name of a setup, and for a number behind the longest bar.
    const NAMES: i32 = 216;
    const NUMBER: i32 = 58;
    const ROW: i32 = 22;
    const WIDTH: u32 = 440;
    let longest = records.iter().map(|record| record.frame());
    let longest = longest.fold(f64::MIN_POSITIVE, f64::max);
    let room = f64::from(WIDTH as i32 - NAMES - NUMBER);
    let length = |ms: f64| (ms / longest * room).round() as i32;
    let mut svg = String::new();
    {
        let height = (ROW * records.len() as i32 + 8) as u32;
        let root = SVGBackend::with_string(&mut svg, (WIDTH, height)).into_drawing_area();
        let font = ("sans-serif", 13).into_font().color(&INK);
        let right = font.pos(Pos::new(HPos::Right, VPos::Center));
        let left = font.pos(Pos::new(HPos::Left, VPos::Center));
        for (row, record) in (0..).zip(records) {
            let top = ROW * row + 4;
            let middle = top + ROW / 2;
            root.draw(&Text::new(
                record.name.clone(),
                (NAMES - 6, middle),
                right.clone(),
            ))?;
            let mut sum = 0.0;
            for (part, ms) in record.parts().into_iter().enumerate() {
                let (from, to) = (NAMES + length(sum), NAMES + length(sum + ms));
                sum += ms;
                if to > from {
                    let corners = [(from, top + 3), (to, top + ROW - 3)];
                    root.draw(&Rectangle::new(corners, part_color(part).filled()))?;
                }
            }
            let end = NAMES + length(sum) + 5;
            // The number of the table.
            root.draw(&Text::new(ms(record.frame()), (end, middle), left.clone()))?;
        }
        root.present()?;
    }
    Ok(themed(&svg))
}
