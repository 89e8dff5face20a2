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
    /// The children of each column in the elimination tree (Liu, SIAM J. Matrix Anal. Appl. 11 (1990) 134-172):
    /// a column depends on those below it in the tree alone. Behind them the roots.
    children: Vec<Vec<usize>>,
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
        let mut children = vec![Vec::new(); columns + 1];
        for (column, rows) in below.iter().enumerate() {
            for (at, &row) in rows.iter().enumerate() {
                left[row].push((column, at));
            }
            children[rows.first().copied().unwrap_or(columns)].push(column);
        }
        Self {
            place,
            unknown,
            below,
            left,
            children,
        }
    }

    /// What `work` makes of each column, those to the left that the column depends on being done: columns on
    /// different branches of the tree at once.
    pub(super) fn upwards<T: Send + Sync>(
        &self,
        work: &(impl Fn(usize, &Done<T>) -> T + Sync),
    ) -> Vec<T> {
        Done::of_all(self.below.len(), work, |work| {
            self.leaves_first(self.below.len(), work)
        })
    }

    /// The same, those to the right that the column depends on being done.
    pub(super) fn downwards<T: Send + Sync>(
        &self,
        work: &(impl Fn(usize, &Done<T>) -> T + Sync),
    ) -> Vec<T> {
        Done::of_all(self.below.len(), work, |work| {
            self.leaves_last(self.below.len(), work)
        })
    }

    /// Calls `work` for all columns below this one in the tree, each after its children.
    fn leaves_first(&self, column: usize, work: &(dyn Fn(usize) + Sync)) {
        // A chain of single children takes no calls of its own, which keeps the stack short.
        let mut chain = Vec::new();
        let mut last = column;
        while let [child] = self.children[last][..] {
            chain.push(child);
            last = child;
        }
        let mut children = self.children[last].clone();
        each(&mut children, &|child| {
            self.leaves_first(*child, work);
            work(*child);
        });
        for &column in chain.iter().rev() {
            work(column);
        }
    }

    /// Calls `work` for all columns below this one in the tree, each before its children.
    fn leaves_last(&self, mut column: usize, work: &(dyn Fn(usize) + Sync)) {
        while let [child] = self.children[column][..] {
            work(child);
            column = child;
        }
        let mut children = self.children[column].clone();
        each(&mut children, &|child| {
            work(*child);
            self.leaves_last(*child, work);
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
    /// What `work` makes of all of so many columns, in the order in which `walk` calls it for each once.
    fn of_all(
        columns: usize,
        work: &(impl Fn(usize, &Self) -> T + Sync),
        walk: impl FnOnce(&(dyn Fn(usize) + Sync)),
    ) -> Vec<T>
    where
        T: Send + Sync,
    {
        let done = Self((0..columns).map(|_| OnceLock::new()).collect());
        walk(&|column| {
            let is_first = done.0[column].set(work(column, &done)).is_ok();
            assert!(is_first, "each column is done once");
        });
        let columns = done.0.into_iter().map(OnceLock::into_inner);
        columns.map(|own| own.expect("each is done")).collect()
    }

    /// That of a column which the present one depends on.
    pub(super) fn of(&self, column: usize) -> &T {
        self.0[column].get().expect("what it depends on is done")
    }
}
