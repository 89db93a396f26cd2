//! Plots as SVG, in the colors of the page.

mod bars;
mod growth;
mod labels;

pub use bars::bars;
pub use growth::{GROWING, growth};

use super::super::measure::SetupRecord;
use super::super::pareto::{front, stays};
use super::super::times::Times;
use anyhow::Result;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// The size of a drawing. It is about as wide as a phone, so that its letters are legible there.
const WIDTH: u32 = 360;
const HEIGHT: u32 = 280;

/// Placeholder colors, which [`themed`] replaces by the page's.
const INK: RGBColor = RGBColor(1, 2, 3);
const FAINT: RGBColor = RGBColor(4, 5, 6);
const FRONT: RGBColor = RGBColor(7, 8, 9);

/// The placeholder color of a part of a picture's time.
const fn part_color(part: usize) -> RGBColor {
    RGBColor(16, 16, part as u8)
}

/// An axis: its name, its values and its scale.
#[derive(Clone, Copy)]
pub struct Axis {
    pub name: &'static str,
    pub of: fn(&SetupRecord) -> f64,
    /// Where the value may lie within the spread of the runs; `None` if it is exact.
    pub range: Option<fn(&SetupRecord) -> [f64; 2]>,
    pub scale: Scale,
}

#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Scale {
    /// From 0.
    Linear,
    /// Powers of ten, and 0 below the least.
    PowersAndZero,
}

/// The setups on the Pareto front of two axes, in the order of their numbers in the plot: along the first axis, from 1. Each with
/// whether it is there wherever within their spreads the values lie.
pub fn numbered<'a>(records: &[&'a SetupRecord], axes: [Axis; 2]) -> Vec<(&'a SetupRecord, bool)> {
    let points: Vec<[f64; 2]> = records
        .iter()
        .map(|record| axes.map(|axis| (axis.of)(record)))
        .collect();
    let range = |axis: Axis, record: &SetupRecord| match axis.range {
        Some(range) => range(record),
        None => [(axis.of)(record); 2],
    };
    let ranges = records.iter();
    let ranges: Vec<[[f64; 2]; 2]> = ranges
        .map(|record| axes.map(|axis| range(axis, record)))
        .collect();
    let marks = front(&points).into_iter().zip(stays(&ranges));
    let on_front = records.iter().zip(marks).filter(|(_, (on, _))| *on);
    let mut on_front: Vec<(&SetupRecord, bool)> = on_front
        .map(|(record, (_, stays))| (*record, stays))
        .collect();
    on_front.sort_by(|(a, _), (b, _)| {
        let keys = |record: &SetupRecord| axes.map(|axis| (axis.of)(record));
        let ([ax, ay], [bx, by]) = (keys(a), keys(b));
        ax.total_cmp(&bx).then(ay.total_cmp(&by))
    });
    on_front
}

/// A plot of all setups as dots, those on the front with numbers and a line through them.
pub fn scatter(records: &[&SetupRecord], axes: [Axis; 2]) -> Result<String> {
    let on_front = numbered(records, axes);
    let spans = axes.map(|axis| Span::new(axis, records));
    let place = |record: &SetupRecord| {
        let [x, y] = [0, 1].map(|which: usize| spans[which].place((axes[which].of)(record)));
        (x, y)
    };
    let mut svg = String::new();
    {
        let root = SVGBackend::with_string(&mut svg, (WIDTH, HEIGHT)).into_drawing_area();
        let mut chart = ChartBuilder::on(&root)
            .margin(6)
            .margin_right(14)
            .x_label_area_size(44)
            .y_label_area_size(52)
            .build_cartesian_2d(spans[0].range(), spans[1].range())?;
        let [x_span, y_span] = &spans;
        chart
            .configure_mesh()
            .axis_style(INK)
            .bold_line_style(FAINT.mix(0.4))
            .light_line_style(TRANSPARENT)
            .x_labels(x_span.label_count())
            .y_labels(y_span.label_count())
            .x_label_formatter(&|x| x_span.label(*x))
            .y_label_formatter(&|y| y_span.label(*y))
            .label_style(("sans-serif", 15).into_font().color(&INK))
            .x_desc(axes[0].name)
            .y_desc(axes[1].name)
            .draw()?;
        let dots = records
            .iter()
            .map(|record| Circle::new(place(record), 4, FAINT.filled()));
        chart.draw_series(dots)?;
        // The line is a staircase: the second value improves only at the next setup of the front.
        let mut steps: Vec<(f64, f64)> = Vec::new();
        for (record, _) in &on_front {
            let (x, y) = place(record);
            if let Some(&(_, before)) = steps.last() {
                steps.push((x, before));
            }
            steps.push((x, y));
        }
        chart.draw_series([PathElement::new(steps, FRONT.stroke_width(2))])?;
        // A ring where the place on the front is within the spread.
        let dots = on_front.iter().map(|(record, is_clear)| {
            let style = match is_clear {
                true => FRONT.filled(),
                false => FRONT.stroke_width(2),
            };
            Circle::new(place(record), 5, style)
        });
        chart.draw_series(dots)?;
        let style = ("sans-serif", 16).into_font().color(&INK);
        let style = style.pos(Pos::new(HPos::Left, VPos::Top));
        let dots: Vec<[i32; 2]> = on_front
            .iter()
            .map(|(record, _)| <[i32; 2]>::from(chart.backend_coord(&place(record))))
            .collect();
        for (number, [x, y]) in (1..).zip(labels::places(&dots)) {
            root.draw(&Text::new(number.to_string(), (x, y), style.clone()))?;
        }
        root.present()?;
    }
    Ok(themed(&svg))
}

/// The places of values on an axis.
struct Span {
    scale: Scale,
    /// The exponent of the least power of ten.
    least: f64,
    end: f64,
}

impl Span {
    fn new(axis: Axis, records: &[&SetupRecord]) -> Self {
        let values = || records.iter().map(|record| (axis.of)(record));
        let above = values().filter(|value| *value > 0.0);
        let least = above.fold(f64::INFINITY, f64::min).log10().floor();
        let least = if least.is_finite() { least } else { 0.0 };
        let mut span = Self {
            scale: axis.scale,
            least,
            end: 1.0,
        };
        let most = values().fold(0.0, f64::max);
        span.end = match axis.scale {
            Scale::Linear => most.max(f64::MIN_POSITIVE) * 1.08,
            Scale::PowersAndZero => span.place(most).ceil().max(2.0),
        };
        span
    }

    fn place(&self, value: f64) -> f64 {
        match self.scale {
            Scale::Linear => value,
            Scale::PowersAndZero if value > 0.0 => 1.0 + value.log10() - self.least,
            Scale::PowersAndZero => 0.0,
        }
    }

    fn range(&self) -> std::ops::Range<f64> {
        match self.scale {
            Scale::Linear => 0.0..self.end,
            Scale::PowersAndZero => -0.3..self.end,
        }
    }

    fn label_count(&self) -> usize {
        match self.scale {
            Scale::Linear => 6,
            Scale::PowersAndZero => self.end as usize + 1,
        }
    }

    fn label(&self, place: f64) -> String {
        match self.scale {
            Scale::Linear => format!("{}", (place * 1e3).round() / 1e3),
            Scale::PowersAndZero if place.round() <= 0.0 => "0".into(),
            Scale::PowersAndZero if (place - place.round()).abs() > 1e-6 => String::new(),
            Scale::PowersAndZero => {
                let exponent = (place.round() - 1.0 + self.least) as i32;
                format!("{}", 10f64.powi(exponent))
            }
        }
    }
}

/// Puts in the page's colors, and removes the namespace, which only SVG files need.
fn themed(svg: &str) -> String {
    let hex = |RGBColor(r, g, b): RGBColor| format!("#{r:02X}{g:02X}{b:02X}");
    let mut svg = svg
        .replace(" xmlns=\"http://www.w3.org/2000/svg\"", "")
        .replace(&hex(INK), "var(--ink)")
        .replace(&hex(FAINT), "var(--faint)")
        .replace(&hex(FRONT), "var(--accent)");
    for part in 0..Times::PARTS.len() {
        svg = svg.replace(&hex(part_color(part)), &format!("var(--part{part})"));
    }
    svg
}
