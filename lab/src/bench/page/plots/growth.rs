//! Plots of growing costs.

use super::super::super::scaling::{COSTS, Series};
use super::{FAINT, HEIGHT, INK, WIDTH, part_color, themed};
use anyhow::Result;
use plotters::prelude::*;

/// The plotted costs: the color of a part, and the name in [`COSTS`].
pub const GROWING: [(usize, &str); 3] = [(1, "build"), (3, "primary"), (4, "shadow")];

/// The times over the growing amount, with logarithmic axes.
pub fn growth(series: &Series) -> Result<String> {
    let line = |name: &str| {
        let cost = COSTS.iter().find(|(cost, _)| *cost == name);
        let points = series.points.iter().filter_map(|point| {
            let (_, of) = cost?;
            Some((point.amount as f64, of(point)))
        });
        let above = points.filter(|(amount, cost)| *amount > 0.0 && *cost > 0.0);
        above
            .map(|(amount, cost)| (amount.log10(), cost.log10()))
            .collect::<Vec<_>>()
    };
    let lines = GROWING.map(|(part, name)| (part, line(name)));
    let all = || lines.iter().flat_map(|(_, line)| line);
    let mut svg = String::new();
    {
        let root = SVGBackend::with_string(&mut svg, (WIDTH, HEIGHT)).into_drawing_area();
        let mut chart = ChartBuilder::on(&root)
            .margin(6)
            .margin_right(14)
            .x_label_area_size(44)
            .y_label_area_size(52)
            .build_cartesian_2d(
                around(all().map(|point| point.0)),
                around(all().map(|point| point.1)),
            )?;
        let label = |power: &f64| rounded(10f64.powf(*power));
        chart
            .configure_mesh()
            .axis_style(INK)
            .bold_line_style(FAINT.mix(0.4))
            .light_line_style(TRANSPARENT)
            .x_labels(5)
            .y_labels(5)
            .x_label_formatter(&label)
            .y_label_formatter(&label)
            .label_style(("sans-serif", 15).into_font().color(&INK))
            .x_desc(series.of)
            .y_desc("ms")
            .draw()?;
        for (part, line) in lines {
            let color = part_color(part);
            let dots = line
                .iter()
                .map(|&point| Circle::new(point, 4, color.filled()));
            chart.draw_series(dots)?;
            chart.draw_series([PathElement::new(line, color.stroke_width(2))])?;
        }
        root.present()?;
    }
    Ok(themed(&svg))
}

/// The range of all values with a small margin, or 0 to 1 without values.
fn around(values: impl Iterator<Item = f64>) -> std::ops::Range<f64> {
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for value in values {
        (low, high) = (low.min(value), high.max(value));
    }
    match low <= high {
        true => low - 0.08..high + 0.08,
        false => 0.0..1.0,
    }
}

/// A value with two digits, in thousands (k) or millions (M) if it is large.
fn rounded(value: f64) -> String {
    let (value, letter) = match value {
        value if value >= 1e6 => (value / 1e6, "M"),
        value if value >= 1e3 => (value / 1e3, "k"),
        value => (value, ""),
    };
    let digits = (1 - value.log10().floor() as i32).max(0) as usize;
    format!("{value:.digits$}{letter}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_have_two_digits() {
        let labels = [0.034, 1.0, 25.1, 316.0, 1585.0, 1e6].map(rounded);
        assert_eq!(labels, ["0.034", "1.0", "25", "316", "1.6k", "1.0M"]);
    }
}
