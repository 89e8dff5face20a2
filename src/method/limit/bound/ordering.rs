//! In which order unknowns are eliminated, so that a sparse factor has few tiles.

use super::parameters::{ORDERINGS, UNEVEN};
use crate::method::limit::noise::Noise;

/// Unknowns in the order of their elimination, each with those that it meets then.
pub(super) type Ordering = Vec<(usize, Vec<usize>)>;

/// How many products of tiles a factor takes, with one more row that meets all.
pub(super) fn cost(ordering: &Ordering) -> f64 {
    let counts = ordering.iter().map(|(_, meets)| meets.len() as f64 + 1.0);
    counts.map(|count| 1.0 / 3.0 + count + count * count).sum()
}

/// The cheapest of several orderings by minimum local fill, the first as it is, the others with a preference
/// of their own: where many unknowns fill in as few tiles, chance decides what comes later.
pub(super) fn cheapest(meets: &[Vec<bool>]) -> Ordering {
    let orderings = (0..ORDERINGS).map(|sequence| {
        let mut noise = Noise::new(sequence);
        let uneven = if sequence == 0 { 0.0 } else { UNEVEN };
        by_local_fill(meets.to_vec(), || 1.0 + uneven * noise.uniform())
    });
    let cheapest = orderings.min_by(|a, b| cost(a).total_cmp(&cost(b)));
    cheapest.expect("there are several")
}

/// The unknown whose elimination fills in the fewest tiles is eliminated next, of these the one that meets the
/// fewest others (minimum local fill: Tinney and Walker, Proc. IEEE 55 (1967) 1801-1809); both times a
/// `preference`.
fn by_local_fill(mut meets: Vec<Vec<bool>>, mut preference: impl FnMut() -> f64) -> Ordering {
    let mut left: Vec<usize> = (0..meets.len()).collect();
    // What eliminating each would fill in, and how many it meets, while nothing has changed that.
    let mut known: Vec<Option<[f64; 2]>> = vec![None; left.len()];
    let mut ordering = Vec::new();
    while !left.is_empty() {
        let neighbours = |unknown: usize, meets: &[Vec<bool>]| -> Vec<usize> {
            let others = left.iter().copied();
            others.filter(|&other| meets[unknown][other]).collect()
        };
        for &unknown in &left {
            known[unknown].get_or_insert_with(|| {
                let others = neighbours(unknown, &meets);
                let missing =
                    |&a: &usize| others.iter().filter(|&&b| a < b && !meets[a][b]).count();
                let filled: usize = others.iter().map(missing).sum();
                [filled, others.len()].map(|count| count as f64)
            });
        }
        let preferred = left.iter().map(|&unknown| {
            let times = preference();
            (
                known[unknown].map(|counts| counts.map(|count| count * times)),
                unknown,
            )
        });
        let chosen = preferred.min_by(|a, b| a.partial_cmp(b).expect("counts are numbers"));
        let (_, chosen) = chosen.expect("an unknown is left");
        let others = neighbours(chosen, &meets);
        for &a in &others {
            for &b in &others {
                meets[a][b] = a != b;
            }
        }
        left.retain(|&unknown| unknown != chosen);
        for &unknown in &left {
            if others
                .iter()
                .any(|&other| other == unknown || meets[unknown][other])
            {
                known[unknown] = None;
            }
        }
        ordering.push((chosen, others));
    }
    ordering
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A grid of unknowns, each of which meets its neighbours.
    #[test]
    fn none_is_dearer_than_plain_local_fill() {
        let (rows, columns) = (6, 9);
        let at = |unknown: usize| [unknown / columns, unknown % columns];
        let meets = |a: usize, b: usize| {
            let apart = [0, 1].map(|axis| at(a)[axis].abs_diff(at(b)[axis]));
            a != b && apart[0].max(apart[1]) <= 1
        };
        let all = 0..rows * columns;
        let meets: Vec<Vec<bool>> = (all.clone())
            .map(|a| all.clone().map(|b| meets(a, b)).collect())
            .collect();
        let plain = by_local_fill(meets.clone(), || 1.0);
        let chosen = cheapest(&meets);
        assert!(cost(&chosen) <= cost(&plain));
        let mut unknowns: Vec<usize> = chosen.iter().map(|(unknown, _)| *unknown).collect();
        unknowns.sort_unstable();
        assert!(unknowns.into_iter().eq(all));
    }
}
