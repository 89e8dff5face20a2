//! Where names go: those of points beside them, over no other point and no other name; those of lines
//! below one another.

use super::words::text_width;

/// A rectangle of the picture in pixels: left, top, right, bottom.
pub type Rectangle = [f64; 4];

/// Font size of names, and pixels from a line to the next.
pub const SIZE: f64 = 12.0;
pub const HEIGHT: f64 = 14.0;

/// Room that a name leaves to what is beside it.
const APART: f64 = 3.0;

/// Places names of points so that they cover neither points nor each other: for each, the first free
/// place on rings round its point. `covered` is what is there already, in pixels from the upper left
/// corner of a plane of that size; returns the middle of each name's line.
pub fn place(named: &[([f64; 2], &str)], covered: &[Rectangle], size: [f64; 2]) -> Vec<[f64; 2]> {
    let mut taken = covered.to_vec();
    let mut placed = Vec::new();
    for (point, name) in named {
        let half = [0.5 * text_width(name, SIZE) + APART, 0.5 * HEIGHT];
        let at = |[x, y]: [f64; 2]| [x - half[0], y - half[1], x + half[0], y + half[1]];
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

/// Candidates for the middle of a name, kept inside the plane.
fn places(point: [f64; 2], half: [f64; 2], size: [f64; 2]) -> impl Iterator<Item = [f64; 2]> {
    let rings = [14.0, 20.0, 28.0, 40.0, 58.0, 80.0, 105.0, 140.0];
    rings.into_iter().flat_map(move |ring| {
        (0..24).map(move |step| {
            let angle = std::f64::consts::TAU * f64::from(step) / 24.0;
            let reach = [ring + half[0] * angle.cos().abs(), ring];
            let x = point[0] + reach[0] * angle.cos();
            let y = point[1] - reach[1] * angle.sin();
            [
                x.clamp(half[0], (size[0] - half[0]).max(half[0])),
                y.clamp(half[1], size[1] - half[1]),
            ]
        })
    })
}

/// Overlap first, distance second.
fn cost(middle: [f64; 2], point: [f64; 2], own: Rectangle, taken: &[Rectangle]) -> f64 {
    let covered: f64 = taken.iter().map(|other| overlap(&own, other)).sum();
    100.0 * covered + (middle[0] - point[0]).hypot(middle[1] - point[1])
}

/// How far two rectangles reach into each other: the area that they share.
pub fn overlap(a: &Rectangle, b: &Rectangle) -> f64 {
    let wide = a[2].min(b[2]) - a[0].max(b[0]);
    let high = a[3].min(b[3]) - a[1].max(b[1]);
    wide.max(0.0) * high.max(0.0)
}

/// Heights for labels below one another that would like to stand at these: each as near as can be,
/// `apart` from the next, in the order of what they wish for, between `top` and `bottom` where there
/// is room.
pub fn spread(wishes: &[f64], apart: f64, [top, bottom]: [f64; 2]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..wishes.len()).collect();
    order.sort_by(|&a, &b| wishes[a].total_cmp(&wishes[b]));
    // Groups that touch stand around the middle of what they wish for: count, middle.
    let mut groups: Vec<(f64, f64)> = Vec::new();
    for &index in &order {
        groups.push((1.0, wishes[index]));
        while let [.., (before, above), (count, below)] = groups[..] {
            let (last, first) = (
                above + (before - 1.0) * apart / 2.0,
                below - (count - 1.0) * apart / 2.0,
            );
            if first - last >= apart {
                break;
            }
            let all = before + count;
            // The middle that each group would have alone, moved to that of both.
            let middle = (before * (above + count * apart / 2.0)
                + count * (below - before * apart / 2.0))
                / all;
            groups.truncate(groups.len() - 2);
            groups.push((all, middle));
        }
    }
    let mut heights = vec![0.0; wishes.len()];
    let mut places = order.into_iter();
    let mut least = top;
    for (count, middle) in groups {
        let half = (count - 1.0) * apart / 2.0;
        let middle = middle.min(bottom - half).max(least + half);
        for place in 0..count as usize {
            if let Some(index) = places.next() {
                heights[index] = middle - half + place as f64 * apart;
            }
        }
        least = middle + half + apart;
    }
    heights
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
        let covered: Vec<Rectangle> = points
            .iter()
            .map(|[x, y]| [x - 5.0, y - 5.0, x + 5.0, y + 5.0])
            .collect();
        let placed = place(&named, &covered, [500.0, 300.0]);
        let half = 0.5 * text_width("associative 1e-6", SIZE);
        let boxes: Vec<Rectangle> = placed
            .iter()
            .map(|[x, y]| [x - half, y - 6.0, x + half, y + 6.0])
            .collect();
        for (i, a) in boxes.iter().enumerate() {
            let others = boxes[i + 1..].iter().chain(&covered);
            assert!(others.clone().all(|b| overlap(a, b) == 0.0), "{placed:?}");
        }
    }
    #[test]
    fn labels_stand_apart_and_near_what_they_wish_for() {
        assert_eq!(spread(&[50.0, 10.0], 12.0, [0.0, 100.0]), [50.0, 10.0]);
        assert_eq!(spread(&[50.0, 50.0], 12.0, [0.0, 100.0]), [44.0, 56.0]);
        assert_eq!(
            spread(&[2.0, 1.0, 0.0], 12.0, [5.0, 100.0]),
            [29.0, 17.0, 5.0]
        );
        let many = spread(&[40.0, 41.0, 60.0, 45.0, 99.0], 12.0, [0.0, 100.0]);
        let mut sorted = many.clone();
        sorted.sort_by(f64::total_cmp);
        assert!(
            sorted.windows(2).all(|pair| pair[1] - pair[0] > 11.999),
            "{many:?}"
        );
    }
}
