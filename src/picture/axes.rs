//! Axes: from values to pixels, round ticks, and the lines and words of both.

use super::palette::{GRID, INK};
use super::plot::Ticks;
use super::svg::{Anchor, Path, Pixel, Svg, style};
use super::words::text_width;
use crate::number::{ends_of, nine_digits, number};

const FONT: f64 = 12.0;

/// Where a plot has its points.
#[derive(Clone, Copy, Debug)]
pub struct Area {
    /// Upper left corner, pixels.
    pub corner: Pixel,
    pub size: [f64; 2],
    /// Values at the left and right edge.
    pub x: [f64; 2],
    /// Values at the lower and upper edge.
    pub y: [f64; 2],
}

impl Area {
    pub fn at(&self, [x, y]: [f64; 2]) -> Pixel {
        let part = |value: f64, [low, high]: [f64; 2]| (value - low) / (high - low);
        let [left, top] = self.corner;
        let [width, height] = self.size;
        [
            left + part(x, self.x) * width,
            top + (1.0 - part(y, self.y)) * height,
        ]
    }

    pub fn bottom(&self) -> f64 {
        self.corner[1] + self.size[1]
    }

    /// Draws the lower axis with a line upwards from each tick, and its label.
    pub fn x_axis(&self, svg: &mut Svg, ticks: &[(f64, String)], label: &str) {
        let bottom = self.bottom();
        let (mut grid, mut axis) = (Path::default(), Path::default());
        let room = self.size[0] / ticks.len().max(2) as f64;
        let widest = ticks.iter().map(|(_, words)| text_width(words, FONT));
        // Every second or third has a label where there is no room for all.
        let every = ((widest.fold(0.0, f64::max) + 6.0) / room).ceil().max(1.0) as usize;
        for (index, (value, words)) in ticks.iter().enumerate() {
            let x = self.at([*value, self.y[0]])[0];
            grid.add(&[[x, self.corner[1]], [x, bottom]], false);
            axis.add(&[[x, bottom], [x, bottom + 5.0]], false);
            if index % every == 0 {
                let style = style().class("x-tick").font_size(FONT);
                svg.text([x, bottom + 18.0], Anchor::Middle, style, words);
            }
        }
        let [left, right] = [self.corner[0], self.corner[0] + self.size[0]];
        axis.add(&[[left, bottom], [right, bottom]], false);
        self.lines(svg, grid, axis);
        let middle = (left + right) / 2.0;
        svg.text([middle, bottom + 37.0], Anchor::Middle, style(), label);
    }

    /// Draws the left axis with a line to the right from each tick, and its label `away` pixels from
    /// the axis.
    pub fn y_axis(&self, svg: &mut Svg, ticks: &[(f64, String)], label: &str, away: f64) {
        let [left, top] = self.corner;
        let (mut grid, mut axis) = (Path::default(), Path::default());
        for (value, words) in ticks {
            let y = self.at([self.x[0], *value])[1];
            grid.add(&[[left, y], [left + self.size[0], y]], false);
            axis.add(&[[left - 5.0, y], [left, y]], false);
            let style = style().class("y-tick").font_size(FONT);
            svg.text([left - 9.0, y + 4.0], Anchor::End, style, words);
        }
        axis.add(&[[left, top], [left, self.bottom()]], false);
        self.lines(svg, grid, axis);
        let at = [left - away, top + self.size[1] / 2.0];
        svg.text(at, Anchor::Middle, style().upwards(at), label);
    }

    fn lines(&self, svg: &mut Svg, grid: Path, axis: Path) {
        svg.path(&grid, style().line(GRID, 1.0), "");
        svg.path(&axis, style().line(INK, 1.2), "");
    }
}

/// Ends and ticks of an axis with these values on it.
pub fn scale(ticks: &Ticks, values: impl Iterator<Item = f64>) -> ([f64; 2], Vec<(f64, String)>) {
    match ticks {
        Ticks::Words(ends, words) => (*ends, words.clone()),
        Ticks::Decades(ends, last) => {
            let decades = ends[0].ceil() as i32..=*last;
            let tick = |decade: i32| (f64::from(decade), power_of_ten(decade));
            (*ends, decades.map(tick).collect())
        }
        Ticks::Fitting => {
            let ticks = round_ticks(ends_of(values));
            ([ticks[0].0, ticks[ticks.len() - 1].0], ticks)
        }
    }
}

fn power_of_ten(power: i32) -> String {
    match power {
        ..-3 | 5.. => format!("1e{power}"),
        -3..0 => number(10f64.powi(power), power.unsigned_abs() as usize),
        _ => number(10f64.powi(power), 0),
    }
}

/// The largest of 1, 2 and 5 times a power of ten that is not above a positive number.
pub fn round_below(value: f64) -> f64 {
    let power = 10f64.powf(value.log10().floor());
    let steps = [10.0, 5.0, 2.0].map(|step| step * power);
    let found = steps.into_iter().find(|&step| step <= 1.0001 * value);
    found.unwrap_or(power)
}

/// About six round numbers, the first and last of which enclose these ends.
pub fn round_ticks([low, high]: [f64; 2]) -> Vec<(f64, String)> {
    let span = if high > low { high - low } else { 1.0 };
    let low = if low.is_finite() { low } else { 0.0 };
    let least = span / 6.0;
    let power = 10f64.powf(least.log10().floor());
    let steps = [1.0, 2.0, 5.0].map(|step| step * power);
    let step = steps.into_iter().find(|&step| step >= 0.999 * least);
    let step = step.unwrap_or(10.0 * power);
    let first = (low / step + 1e-9).floor();
    let count = ((low + span) / step - 1e-9).ceil() - first;
    let decimals = (-(step.log10() + 1e-9).floor()).max(0.0);
    let words = |value: f64| {
        if (1e-6..1e9).contains(&step) {
            number(value, decimals as usize)
        } else {
            nine_digits(value)
        }
    };
    (0..=count as usize)
        .map(|tick| (first + tick as f64) * step)
        .map(|value| (value, words(value)))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every label says its place, to the digits that it has: 0.25 is not 0.2.
    #[test]
    fn labels_say_where_they_stand() {
        let spans = (-8..9)
            .flat_map(|power| [1.0, 1.3, 2.0, 2.4, 3.3, 5.0, 7.7].map(|m| m * 10f64.powi(power)));
        for span in spans {
            for low in [0.0, 0.5 * span, -0.73 * span, 17.0 * span] {
                let ticks = round_ticks([low, low + span]);
                assert!((3..=14).contains(&ticks.len()), "{low} {span}: {ticks:?}");
                for (value, words) in &ticks {
                    let read: f64 = words.parse().unwrap();
                    assert!((read - value).abs() <= 1e-6 * span, "{words} at {value}");
                }
                let (first, last) = (ticks[0].0, ticks[ticks.len() - 1].0);
                assert!(first <= low + 1e-6 * span && last >= low + span - 1e-6 * span);
            }
        }
        for power in -9..9 {
            let read: f64 = power_of_ten(power).parse().unwrap();
            assert!((read.log10() - f64::from(power)).abs() < 1e-12);
        }
    }

    #[test]
    fn ticks_are_round_and_enclose_the_ends() {
        let words = |ends| -> Vec<String> {
            let ticks = round_ticks(ends).into_iter();
            ticks.map(|(_, words)| words).collect()
        };
        assert_eq!(
            words([0.0, 0.93]),
            ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]
        );
        assert_eq!(
            words([0.0, 3.0]),
            ["0.0", "0.5", "1.0", "1.5", "2.0", "2.5", "3.0"]
        );
        assert_eq!(
            words([-3.0, 42.0]),
            ["-10", "0", "10", "20", "30", "40", "50"]
        );
        assert_eq!(words([2.0, 2.0]).len(), 6);
        assert_eq!(words([f64::INFINITY, f64::NEG_INFINITY])[0], "0.0");
    }
}
