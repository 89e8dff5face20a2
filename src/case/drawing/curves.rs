//! Arcs as chords.

use crate::scene::Vector;

/// How near chords are to their arc: within this part of its radius.
#[derive(Clone, Copy)]
pub(super) struct Chords(pub f64);

impl Chords {
    /// Chords of an arc.
    fn count(self, angle: f64) -> usize {
        let step = 2.0 * (1.0 - self.0).acos();
        // Rounding must not give the two sides of one joint different chords.
        ((angle.abs() / step - 1e-6).ceil() as usize).max(1)
    }

    /// Points about a centre, from an angle on, with both ends.
    pub fn arc(self, centre: Vector, radius: f64, from: f64, angle: f64) -> Vec<Vector> {
        let count = self.count(angle);
        let at = |k: usize| {
            let turn = from + angle * k as f64 / count as f64;
            centre + radius * Vector::new(turn.cos(), turn.sin())
        };
        (0..=count).map(at).collect()
    }

    /// Corners, with the arcs behind them (bulge: the tangent of a quarter of the angle, positive to
    /// the left) as chords.
    pub fn polyline(self, corners: &[(Vector, f64)], closed: bool) -> Vec<Vector> {
        let count = corners.len();
        let mut points = Vec::new();
        for (i, &(from, bulge)) in corners.iter().enumerate() {
            points.push(from);
            if bulge == 0.0 || (i + 1 == count && !closed) {
                continue;
            }
            let (to, _) = corners[(i + 1) % count];
            let half = (to - from) / 2.0;
            let left = Vector::new(-half.y, half.x);
            let centre = from + half + left * ((1.0 - bulge * bulge) / (2.0 * bulge));
            let angle = 4.0 * bulge.atan();
            let chords = self.count(angle);
            points.extend((1..chords).map(|k| {
                let (sin, cos) = (angle * k as f64 / chords as f64).sin_cos();
                let arm = from - centre;
                centre + Vector::new(cos * arm.x - sin * arm.y, sin * arm.x + cos * arm.y)
            }));
        }
        points
    }
}
