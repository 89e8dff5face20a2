//! Where the names of points go: beside their points, over no other point and no other name.

/// A rectangle of the picture in pixels: left, top, right, bottom.
type Rectangle = [f64; 4];

/// Places names of points so that they cover neither points nor each other: for each, the first free
/// place on rings round its point. `points` are all points in pixels from the upper left corner of a
/// plane of that size; returns the middle of each name's line.
pub fn place(named: &[([f64; 2], &str)], points: &[[f64; 2]], size: [f64; 2]) -> Vec<[f64; 2]> {
    let mut taken: Vec<Rectangle> = points
        .iter()
        .map(|[x, y]| [x - 5.0, y - 5.0, x + 5.0, y + 5.0])
        .collect();
    let mut placed = Vec::new();
    for (point, name) in named {
        let half = [0.5 * WIDTH * name.chars().count() as f64, 0.5 * HEIGHT];
        let at = |middle: [f64; 2]| {
            let [x, y] = middle;
            [x - half[0], y - half[1], x + half[0], y + half[1]]
        };
        let best = places(*point, half, size)
            .min_by(|&a, &b| {
                cost(a, *point, at(a), &taken).total_cmp(&cost(b, *point, at(b), &taken))
            })
            .unwrap_or(*point);
        taken.push(at(best));
        placed.push(best);
    }
    placed
}

/// Pixels of a letter and of a line.
const WIDTH: f64 = 5.9;
const HEIGHT: f64 = 13.0;

/// Candidates for the middle of a name, kept inside the plane.
fn places(point: [f64; 2], half: [f64; 2], size: [f64; 2]) -> impl Iterator<Item = [f64; 2]> {
    let rings = [14.0, 26.0, 40.0, 58.0, 80.0, 105.0];
    rings.into_iter().flat_map(move |ring| {
        (0..16).map(move |step| {
            let angle = std::f64::consts::TAU * f64::from(step) / 16.0;
            let reach = [ring + half[0] * angle.cos().abs(), ring];
            let x = point[0] + reach[0] * angle.cos();
            let y = point[1] - reach[1] * angle.sin();
            [
                x.clamp(half[0] + 2.0, (size[0] - half[0] - 2.0).max(half[0] + 2.0)),
                y.clamp(half[1], size[1] - half[1]),
            ]
        })
    })
}

/// Overlap first, distance second.
fn cost(middle: [f64; 2], point: [f64; 2], own: Rectangle, taken: &[Rectangle]) -> f64 {
    let overlap = |other: &Rectangle| {
        let wide = own[2].min(other[2]) - own[0].max(other[0]);
        let high = own[3].min(other[3]) - own[1].max(other[1]);
        wide.max(0.0) * high.max(0.0)
    };
    let covered: f64 = taken.iter().map(overlap).sum();
    100.0 * covered + (middle[0] - point[0]).hypot(middle[1] - point[1])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_close_points_do_not_cover_each_other() {
        let points: Vec<[f64; 2]> = (0..6)
            .map(|i| [100.0 + 8.0 * f64::from(i), 100.0])
            .collect();
        let named: Vec<([f64; 2], &str)> = points
            .iter()
            .map(|&point| (point, "associative 1e-6"))
            .collect();
        let placed = place(&named, &points, [500.0, 300.0]);
        for (i, a) in placed.iter().enumerate() {
            for b in &placed[i + 1..] {
                let clear = (a[1] - b[1]).abs() >= HEIGHT || (a[0] - b[0]).abs() >= 16.0 * WIDTH;
                assert!(clear, "{a:?} {b:?}");
            }
        }
    }
}
