//! Simple outlines: whether one crosses itself, and its convex pieces.

use nalgebra::{Point2, Vector2};

type Point = Point2<f64>;
type Vector = Vector2<f64>;

/// Sine of an angle below which an outline goes straight on, or comes straight back.
pub(super) const STRAIGHT: f64 = 1e-9;

/// Twice the signed area of a triangle; positive where it turns to the left.
fn turn(a: Point, b: Point, c: Point) -> f64 {
    (b - a).perp(&(c - a))
}

/// The first edge, by its first corner, that crosses or touches another one which is not its
/// neighbour. The outline has at least three corners.
pub(super) fn crossing(corners: &[Point]) -> Option<usize> {
    let count = corners.len();
    let edge = |i: usize| (corners[i], corners[(i + 1) % count]);
    (0..count).find(|&i| {
        let behind = (i + 2)..count;
        behind
            .filter(|&j| (j + 1) % count != i)
            .any(|j| touch(edge(i), edge(j)))
    })
}

/// Whether two segments share a point.
fn touch((a, b): (Point, Point), (c, d): (Point, Point)) -> bool {
    let reach = (b - a).norm().max((d - c).norm());
    let near = STRAIGHT * reach;
    let apart =
        |k: usize| a[k].max(b[k]) + near < c[k].min(d[k]) || c[k].max(d[k]) + near < a[k].min(b[k]);
    if apart(0) || apart(1) {
        return false;
    }
    // Distances of the ends of one from the line of the other, signed.
    let sides = |from: Point, to: Point, ends: [Point; 2]| {
        let along = (to - from).normalize();
        ends.map(|end| along.perp(&(end - from)))
    };
    let strictly_one_side = |[s, t]: [f64; 2]| (s > near && t > near) || (s < -near && t < -near);
    !(strictly_one_side(sides(a, b, [c, d])) || strictly_one_side(sides(c, d, [a, b])))
}

/// Convex pieces of a simple outline that runs counter-clockwise, as places of its corners: the
/// triangles that ears leave, joined where the joined piece is convex (Hertel and Mehlhorn 1983: at
/// most four times as many as needed). Their edges lie on edges of the outline or inside.
pub(super) fn convex_pieces(corners: &[Point]) -> Vec<Vec<usize>> {
    let triangles = ears(corners);
    let mut pieces: Vec<Vec<usize>> = triangles.iter().map(|t| t.to_vec()).collect();
    let sides = |[a, b, c]: &[usize; 3]| [[*a, *b], [*b, *c], [*c, *a]];
    for [from, to] in triangles.iter().flat_map(sides) {
        // Both pieces beside the diagonal, as they are by now.
        let has = |a: usize, b: usize| {
            move |piece: &Vec<usize>| {
                let next = piece.iter().cycle().skip(1);
                piece.iter().zip(next).any(|(&p, &q)| (p, q) == (a, b))
            }
        };
        let (Some(one), Some(other)) = (
            pieces.iter().position(has(from, to)),
            pieces.iter().position(has(to, from)),
        ) else {
            continue;
        };
        let joined = joined(&pieces[one], &pieces[other], from, to);
        if is_convex(corners, &joined) {
            pieces[one] = joined;
            pieces.remove(other);
        }
    }
    pieces
        .iter()
        .map(|piece| without_straight(corners, piece))
        .collect()
}

/// Two pieces as one, without the diagonal that runs from `from` to `to` in `one`.
fn joined(one: &[usize], other: &[usize], from: usize, to: usize) -> Vec<usize> {
    let begin = |piece: &[usize], at: usize| {
        let place = piece.iter().position(|&corner| corner == at);
        let place = place.expect("both pieces have the diagonal");
        [&piece[place..], &piece[..place]].concat()
    };
    // From `to` round to `from`, and from `from` round to `to`.
    let (one, other) = (begin(one, to), begin(other, from));
    [&one[..one.len() - 1], &other[..other.len() - 1]].concat()
}

fn is_convex(corners: &[Point], piece: &[usize]) -> bool {
    bends(corners, piece).all(|(bend, _)| bend > -STRAIGHT)
}

fn without_straight(corners: &[Point], piece: &[usize]) -> Vec<usize> {
    let kept = bends(corners, piece).filter(|(bend, _)| *bend > STRAIGHT);
    kept.map(|(_, corner)| corner).collect()
}

/// The sine of the angle at every corner of a piece, positive to the left.
fn bends<'a>(corners: &'a [Point], piece: &'a [usize]) -> impl Iterator<Item = (f64, usize)> + 'a {
    let count = piece.len();
    (0..count).map(move |i| {
        let at = |k: usize| corners[piece[k % count]];
        let (before, after) = (at(i) - at(i + count - 1), at(i + 1) - at(i));
        (sine(before, after), piece[i])
    })
}

/// Sine of the angle from one direction to another.
pub(super) fn sine(before: Vector, after: Vector) -> f64 {
    before.perp(&after) / (before.norm() * after.norm())
}

/// Triangles of a simple outline, each counter-clockwise: ears cut off one after the other. Corners
/// that come to lie on a straight line are left out.
fn ears(corners: &[Point]) -> Vec<[usize; 3]> {
    let mut left: Vec<usize> = (0..corners.len()).collect();
    let mut triangles = Vec::new();
    let mut at = 0;
    while left.len() > 3 {
        let count = left.len();
        let three = |i: usize| {
            let i = i % count;
            [
                left[(i + count - 1) % count],
                left[i],
                left[(i + 1) % count],
            ]
        };
        let bend = |i: usize| {
            let [a, b, c] = three(i).map(|corner| corners[corner]);
            sine(b - a, c - b)
        };
        let ear =
            (at..at + count).find(|&i| bend(i) > STRAIGHT && is_ear(corners, &left, three(i)));
        // What is left of a simple outline has an ear, or a straight corner.
        let straight = || (at..at + count).find(|&i| bend(i).abs() <= STRAIGHT);
        let Some(cut) = ear.or_else(straight) else {
            break;
        };
        if ear.is_some() {
            triangles.push(three(cut));
        }
        left.remove(cut % count);
        // The next ear two corners on: fans of slivers about one corner are rare so.
        at = (cut % count + 1) % (count - 1);
    }
    if let [a, b, c] = left[..]
        && turn(corners[a], corners[b], corners[c]) > 0.0
    {
        triangles.push([a, b, c]);
    }
    triangles
}

/// Whether no other corner lies in the triangle or on it.
fn is_ear(corners: &[Point], left: &[usize], triangle: [usize; 3]) -> bool {
    let [a, b, c] = triangle.map(|corner| corners[corner]);
    let mut others = left.iter().filter(|corner| !triangle.contains(corner));
    others.all(|&corner| {
        let p = corners[corner];
        [(a, b), (b, c), (c, a)].iter().any(|&(from, to)| {
            let edge = to - from;
            edge.perp(&(p - from)) < -STRAIGHT * edge.norm_squared()
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(list: &[(f64, f64)]) -> Vec<Point> {
        list.iter().map(|&(x, y)| Point::new(x, y)).collect()
    }

    fn area(corners: &[Point], piece: &[usize]) -> f64 {
        let first = corners[piece[0]];
        let fan = piece[1..].windows(2);
        fan.map(|pair| turn(first, corners[pair[0]], corners[pair[1]]) / 2.0)
            .sum()
    }

    #[test]
    fn an_l_is_two_pieces_and_steps_are_as_many_as_they_have_corners_to_fill() {
        let l = points(&[(0., 0.), (2., 0.), (2., 1.), (1., 1.), (1., 3.), (0., 3.)]);
        assert_eq!(convex_pieces(&l).len(), 2);
        let square = points(&[(0., 0.), (1., 0.), (1., 1.), (0., 1.)]);
        assert_eq!(convex_pieces(&square).len(), 1);
        assert_eq!(crossing(&l), None);
    }

    #[test]
    fn outlines_that_cross_or_touch_themselves_are_found() {
        let bow = points(&[(0., 0.), (2., 2.), (2., 0.), (0., 2.)]);
        assert!(crossing(&bow).is_some());
        let touching = points(&[(0., 0.), (4., 0.), (4., 2.), (2., 0.), (0., 2.)]);
        assert!(crossing(&touching).is_some());
        let back = points(&[(0., 0.), (4., 0.), (4., 1.), (4., 0.5), (0., 0.5)]);
        assert!(crossing(&back).is_some());
    }

    /// Stars of random reach about a point: simple, and mostly far from convex.
    #[test]
    fn pieces_are_convex_and_fill_the_outline() {
        let mut state = 0x9E37_79B9_7F4A_7C15_u64;
        let mut noise = || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 11) as f64 / (1u64 << 53) as f64
        };
        for round in 0..300 {
            let count = 3 + round % 60;
            let corners: Vec<Point> = (0..count)
                .map(|k| {
                    let angle = std::f64::consts::TAU * f64::from(k) / f64::from(count);
                    let reach = 0.2 + noise();
                    Point::new(reach * angle.cos(), reach * angle.sin())
                })
                .collect();
            if crossing(&corners).is_some() {
                continue;
            }
            let whole = area(&corners, &(0..corners.len()).collect::<Vec<_>>());
            let pieces = convex_pieces(&corners);
            let sum: f64 = pieces.iter().map(|piece| area(&corners, piece)).sum();
            assert!((sum - whole).abs() < 1e-9 * whole, "{round}: {sum} {whole}");
            assert!(pieces.iter().all(|piece| is_convex(&corners, piece)));
        }
    }
}
