//! Points and paths of a drawing, compact and with fixed decimals.

/// A point of the drawing in pixels from its upper left corner, y down.
pub type Pixel = [f64; 2];

/// Pixels with two decimals, without trailing zeros and never a negative zero.
pub fn px(value: f64) -> String {
    crate::number::short(value, 2)
}

/// Path of several outlines, each closed or not. Points are rounded to hundredths first, and then
/// written relative to each other, so that no rounding adds up.
#[derive(Clone, Debug, Default)]
pub struct Path {
    text: String,
}

impl Path {
    /// One outline through these points.
    pub fn through(points: &[Pixel], closed: bool) -> Self {
        let mut path = Self::default();
        path.add(points, closed);
        path
    }

    /// Adds the outline through these points.
    pub fn add(&mut self, points: &[Pixel], closed: bool) {
        let hundredths = |v: f64| (v * 100.0).round() as i64;
        let mut points = points.iter().map(|[x, y]| [hundredths(*x), hundredths(*y)]);
        let Some(mut at) = points.next() else {
            return;
        };
        self.number('M', at[0]);
        self.following(at[1]);
        for to in points {
            let [dx, dy] = [to[0] - at[0], to[1] - at[1]];
            match (dx, dy) {
                (0, 0) => {}
                (_, 0) => self.number('h', dx),
                (0, _) => self.number('v', dy),
                _ => {
                    self.number('l', dx);
                    self.following(dy);
                }
            }
            at = to;
        }
        if closed {
            self.text.push('z');
        }
    }

    fn number(&mut self, command: char, hundredths: i64) {
        self.text.push(command);
        self.text.push_str(&px(hundredths as f64 / 100.0));
    }

    fn following(&mut self, hundredths: i64) {
        if hundredths >= 0 {
            self.text.push(' ');
        }
        self.text.push_str(&px(hundredths as f64 / 100.0));
    }

    /// Whether nothing was added.
    pub fn is_empty(&self) -> bool {
        self.text.is_empty()
    }

    /// The value of the attribute `d`.
    pub fn d(&self) -> &str {
        &self.text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_relative_and_without_negative_zeros() {
        let mut path = Path::through(
            &[[0.0, -0.001], [10.0, 0.0], [10.0, 5.126], [8.5, 4.0]],
            true,
        );
        assert_eq!(path.d(), "M0 0h10v5.13l-1.5-1.13z");
        path.add(&[[1.0, 1.0], [1.0, 1.004]], false);
        assert_eq!(path.d(), "M0 0h10v5.13l-1.5-1.13zM1 1");
    }
}
