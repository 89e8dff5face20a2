//! How wide text is, so that labels find room before anything draws them.

/// A rectangle of the picture in pixels: left, top, right, bottom.
pub type Rectangle = [f64; 4];

/// Widths of the characters from space to `~` in Helvetica, thousandths of the font size (Adobe Font
/// Metrics; Arial and Liberation Sans have the same).
const WIDTHS: [u16; 95] = [
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333, 278,
    278, // ' ' to /
    556, 556, 556, 556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556, // 0 to ?
    1015, 667, 667, 722, 722, 667, 611, 778, 722, 278, 500, 667, 556, 833, 722, 778, // @ to O
    667, 778, 722, 667, 611, 722, 667, 944, 667, 667, 611, 278, 278, 278, 469, 556, // P to _
    333, 556, 556, 500, 556, 556, 278, 556, 556, 222, 222, 500, 222, 833, 556, 556, // ` to o
    556, 556, 333, 500, 278, 556, 500, 722, 500, 500, 500, 334, 260, 334, 584, // p to ~
];

/// Width of what is not in the table: Greek letters, dashes and signs are narrower.
const OTHER: u16 = 620;

/// Pixels that a line of text is wide. Bold text is up to a tenth wider.
pub fn text_width(text: &str, font_size: f64) -> f64 {
    let width = |c: char| match (c as usize).checked_sub(' ' as usize) {
        Some(index) if index < WIDTHS.len() => WIDTHS[index],
        _ => OTHER,
    };
    let thousandths: u32 = text.chars().map(|c| u32::from(width(c))).sum();
    f64::from(thousandths) * font_size / 1000.0
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
    fn digits_have_their_width_and_unknown_signs_are_wide() {
        assert_eq!(text_width("0.25", 10.0), 19.46);
        assert_eq!(text_width("λ", 10.0), 6.2);
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
