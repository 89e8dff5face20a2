//! Which tiles a sparse factor has, and in which order its columns can be worked on.

use std::sync::OnceLock;

use crate::method::at_once::each;

/// Which tiles a factor has.
pub(super) struct Pattern {
    /// Place in the order of elimination, by unknown, and the other way round.
    pub(super) place: Vec<usize>,
    pub(super) unknown: Vec<usize>,
    /// Places of the tiles below the diagonal, by column, ascending.
    pub(super) below: Vec<Vec<usize>>,
    /// Columns to the left of which a column takes products, ascending, each with the position of this column's
    /// row among its tiles.
    pub(super) left: Vec<Vec<(usize, usize)>>,
    /// The columns that wait for a column alone (the elimination tree: Liu, SIAM J. Matrix Anal. Appl. 11
    /// (1990) 134-172), and behind them those without one to wait for.
    branches: Vec<Vec<usize>>,
}

impl Pattern {
    /// The pattern of so many unknowns, of which these meet. The unknown whose elimination fills in the
    /// fewest tiles is eliminated next, of these the one that meets the fewest others (minimum local fill:
    /// Tinney and Walker, Proc. IEEE 55 (1967) 1801-1809).
    pub(super) fn new(unknowns: usize, meetings: impl Iterator<Item = Vec<usize>>) -> Self {
        let mut meets = vec![vec![false; unknowns]; unknowns];
        for meeting in meetings {
            for &a in &meeting {
                for &b in &meeting {
                    meets[a][b] = a != b;
                }
            }
        }
        let mut left: Vec<usize> = (0..unknowns).collect();
        let mut order = Vec::new();
        let mut columns = Vec::new();
        while !left.is_empty() {
            let neighbours = |unknown: usize| -> Vec<usize> {
                let others = left.iter().copied();
                others.filter(|&other| meets[unknown][other]).collect()
            };
            let fill = |unknown: usize| {
                let others = neighbours(unknown);
                let missing =
                    |&a: &usize| others.iter().filter(|&&b| a < b && !meets[a][b]).count();
                let filled: usize = others.iter().map(missing).sum();
                (filled, others.len())
            };
            let chosen = (left.iter().copied().min_by_key(|&unknown| fill(unknown)))
                .expect("an unknown is left");
            let others = neighbours(chosen);
            for &a in &others {
                for &b in &others {
                    meets[a][b] = a != b;
                }
            }
            left.retain(|&unknown| unknown != chosen);
            order.push(chosen);
            columns.push(others);
        }
        Self::of(order, &columns)
    }

    /// Of unknowns eliminated in this order, each with those that it meets then.
    fn of(unknown: Vec<usize>, meets: &[Vec<usize>]) -> Self {
        let columns = unknown.len();
        let mut place = vec![0; columns];
        for (column, &unknown) in unknown.iter().enumerate() {
            place[unknown] = column;
        }
        let below = meets.iter().map(|column| {
            let mut below: Vec<usize> = column.iter().map(|&other| place[other]).collect();
            below.sort_unstable();
            below
        });
        let below: Vec<Vec<usize>> = below.collect();
        let mut left = vec![Vec::new(); columns];
        let mut branches = vec![Vec::new(); columns + 1];
        for (column, rows) in below.iter().enumerate() {
            for (at, &row) in rows.iter().enumerate() {
                left[row].push((column, at));
            }
            branches[rows.first().copied().unwrap_or(columns)].push(column);
        }
        Self {
            place,
            unknown,
            below,
            left,
            branches,
        }
    }

    /// What `work` makes of each column, what it makes of those to the left that the column hangs on being
    /// done: columns on different branches at once.
    pub(super) fn upwards<T: Send + Sync>(
        &self,
        work: &(impl Fn(usize, &Done<T>) -> T + Sync),
    ) -> Vec<T> {
        let done = Done::none(self.below.len());
        self.above(self.below.len(), &|column| {
            done.set(column, work(column, &done));
        });
        done.all()
    }

    fn above(&self, column: usize, work: &(impl Fn(usize) + Sync)) {
        // A column that alone waits for another is no call of its own, which keeps the stack short.
        let mut alone = vec![column];
        while let [branch] = self.branches[alone[alone.len() - 1]][..] {
            alone.push(branch);
        }
        let mut branches = self.branches[alone[alone.len() - 1]].clone();
        each(&mut branches, &|branch| {
            self.above(*branch, work);
            work(*branch);
        });
        for &column in alone[1..].iter().rev() {
            work(column);
        }
    }

    /// The same with those to the right that a column hangs on being done.
    pub(super) fn downwards<T: Send + Sync>(
        &self,
        work: &(impl Fn(usize, &Done<T>) -> T + Sync),
    ) -> Vec<T> {
        let done = Done::none(self.below.len());
        self.under(self.below.len(), &|column| {
            done.set(column, work(column, &done));
        });
        done.all()
    }

    fn under(&self, mut column: usize, work: &(impl Fn(usize) + Sync)) {
        while let [branch] = self.branches[column][..] {
            work(branch);
            column = branch;
        }
        let mut branches = self.branches[column].clone();
        each(&mut branches, &|branch| {
            work(*branch);
            self.under(*branch, work);
        });
    }

    /// How many products of tiles the factor takes, with one more row that meets all.
    pub(super) fn cost(&self) -> f64 {
        let counts = self.below.iter().map(|below| below.len() as f64 + 1.0);
        counts.map(|count| 1.0 / 3.0 + count + count * count).sum()
    }
}

/// What is done of columns so far.
pub(super) struct Done<T>(Vec<OnceLock<T>>);

impl<T> Done<T> {
    fn none(columns: usize) -> Self {
        Self((0..columns).map(|_| OnceLock::new()).collect())
    }

    fn set(&self, column: usize, value: T) {
        let is_first = self.0[column].set(value).is_ok();
        assert!(is_first, "each column is done once");
    }

    pub(super) fn of(&self, column: usize) -> &T {
        self.0[column].get().expect("what it hangs on is done")
    }

    fn all(self) -> Vec<T> {
        let columns = self.0.into_iter().map(OnceLock::into_inner);
        columns.map(|own| own.expect("each is done")).collect()
    }
}
