//! Which tiles a sparse factor has, and in which order its columns can be worked on.

use std::ops::Range;
use std::sync::OnceLock;

use super::ordering::{Ordering, cheapest, cost};
use super::parameters::GROUPED;
use crate::method::at_once::each;

/// Which tiles a factor has. Columns one after the other that have the same tiles below them are a group (a
/// supernode), which is worked on as one: what is read is used for all of them.
pub(super) struct Pattern {
    /// Place in the order of elimination, by unknown.
    pub(super) place: Vec<usize>,
    /// Unknown of each place.
    pub(super) unknown: Vec<usize>,
    /// Places of the columns of each group.
    pub(super) groups: Vec<Range<usize>>,
    /// The group of each place.
    pub(super) group: Vec<usize>,
    /// The tiles below each group, ascending: those of the rows of one other group together.
    pub(super) below: Vec<Vec<Rows>>,
    /// Groups to the left of which a group takes products, ascending, each with the position of this group's
    /// rows among those below it.
    pub(super) left: Vec<Vec<(usize, usize)>>,
    /// The children of each group in the elimination tree (Liu, SIAM J. Matrix Anal. Appl. 11 (1990) 134-172):
    /// a group depends on those below it in the tree alone. Behind them the roots.
    children: Vec<Vec<usize>>,
    /// How many products of tiles the factor takes, with one more row that meets all.
    pub(super) cost: f64,
}

/// Rows of one group.
#[derive(Debug)]
pub(super) struct Rows {
    pub(super) group: usize,
    /// Their places, ascending.
    pub(super) places: Vec<usize>,
}

impl Pattern {
    /// The pattern of so many unknowns, of which these meet.
    pub(super) fn new(unknowns: usize, meetings: impl Iterator<Item = Vec<usize>>) -> Self {
        let mut meets = vec![vec![false; unknowns]; unknowns];
        for meeting in meetings {
            for &a in &meeting {
                for &b in &meeting {
                    meets[a][b] = a != b;
                }
            }
        }
        let ordering = cheapest(&meets);
        let cost = cost(&ordering);
        Self::of(&children_first(ordering), cost)
    }

    /// Of unknowns in an order in which children come just before their parents.
    fn of(ordering: &Ordering, cost: f64) -> Self {
        let columns = ordering.len();
        let mut place = vec![0; columns];
        for (column, &(unknown, _)) in ordering.iter().enumerate() {
            place[unknown] = column;
        }
        let rows = ordering.iter().map(|(_, meets)| {
            let mut rows: Vec<usize> = meets.iter().map(|&other| place[other]).collect();
            rows.sort_unstable();
            rows
        });
        let rows: Vec<Vec<usize>> = rows.collect();
        let mut groups: Vec<Range<usize>> = Vec::new();
        for column in 0..columns {
            match groups.last_mut() {
                Some(group)
                    if group.len() < GROUPED
                        && rows[column - 1].first() == Some(&column)
                        && rows[column - 1].len() == rows[column].len() + 1 =>
                {
                    group.end += 1;
                }
                _ => groups.push(column..column + 1),
            }
        }
        let of_group = groups.iter().enumerate();
        let group: Vec<usize> = of_group
            .flat_map(|(at, own)| own.clone().map(move |_| at))
            .collect();
        let below = groups.iter().map(|own| {
            let rows = rows[own.end - 1].chunk_by(|&a, &b| group[a] == group[b]);
            rows.map(|places| Rows {
                group: group[places[0]],
                places: places.to_vec(),
            })
            .collect()
        });
        let below: Vec<Vec<Rows>> = below.collect();
        let mut left = vec![Vec::new(); groups.len()];
        let mut children = vec![Vec::new(); groups.len() + 1];
        for (own, below) in below.iter().enumerate() {
            for (at, rows) in below.iter().enumerate() {
                left[rows.group].push((own, at));
            }
            let parent = below.first().map_or(groups.len(), |rows| rows.group);
            children[parent].push(own);
        }
        Self {
            place,
            unknown: ordering.iter().map(|(unknown, _)| *unknown).collect(),
            groups,
            group,
            below,
            left,
            children,
            cost,
        }
    }

    /// What `work` makes of each group, those to the left that it depends on being done: groups on different
    /// branches of the tree at once.
    pub(super) fn upwards<T: Send + Sync>(
        &self,
        work: &(impl Fn(usize, &Done<T>) -> T + Sync),
    ) -> Vec<T> {
        Done::of_all(self.below.len(), work, |work| {
            self.leaves_first(self.below.len(), work)
        })
    }

    /// The same, those to the right that it depends on being done.
    pub(super) fn downwards<T: Send + Sync>(
        &self,
        work: &(impl Fn(usize, &Done<T>) -> T + Sync),
    ) -> Vec<T> {
        Done::of_all(self.below.len(), work, |work| {
            self.leaves_last(self.below.len(), work)
        })
    }

    /// Calls `work` for all groups below this one in the tree, each after its children.
    fn leaves_first(&self, group: usize, work: &(dyn Fn(usize) + Sync)) {
        // A chain of single children takes no calls of its own, which keeps the stack short.
        let mut chain = Vec::new();
        let mut last = group;
        while let [child] = self.children[last][..] {
            chain.push(child);
            last = child;
        }
        let mut children = self.children[last].clone();
        each(&mut children, &|child| {
            self.leaves_first(*child, work);
            work(*child);
        });
        for &group in chain.iter().rev() {
            work(group);
        }
    }

    /// Calls `work` for all groups below this one in the tree, each before its children.
    fn leaves_last(&self, mut group: usize, work: &(dyn Fn(usize) + Sync)) {
        while let [child] = self.children[group][..] {
            work(child);
            group = child;
        }
        let mut children = self.children[group].clone();
        each(&mut children, &|child| {
            work(*child);
            self.leaves_last(*child, work);
        });
    }
}

/// The same tiles, in an order in which each unknown comes right behind those that depend on it alone: as
/// many columns as can be are then neighbours of what they are grouped with.
fn children_first(ordering: Ordering) -> Ordering {
    let mut place = vec![0; ordering.len()];
    for (column, (unknown, _)) in ordering.iter().enumerate() {
        place[*unknown] = column;
    }
    let mut children = vec![Vec::new(); ordering.len() + 1];
    for (column, (_, meets)) in ordering.iter().enumerate() {
        let parent = meets.iter().map(|&other| place[other]).min();
        children[parent.unwrap_or(ordering.len())].push(column);
    }
    // Parents first, from the last one on, and turned round.
    let mut open = children[ordering.len()].clone();
    let mut order = Vec::new();
    while let Some(column) = open.pop() {
        order.push(column);
        open.extend(&children[column]);
    }
    let mut ordering: Vec<_> = ordering.into_iter().map(Some).collect();
    let taken = order.iter().rev().map(|&column| ordering[column].take());
    taken
        .map(|entry| entry.expect("each stands once"))
        .collect()
}

/// What is done of groups so far.
pub(super) struct Done<T>(Vec<OnceLock<T>>);

impl<T> Done<T> {
    /// What `work` makes of all of so many groups, in the order in which `walk` calls it for each once.
    fn of_all(
        groups: usize,
        work: &(impl Fn(usize, &Self) -> T + Sync),
        walk: impl FnOnce(&(dyn Fn(usize) + Sync)),
    ) -> Vec<T>
    where
        T: Send + Sync,
    {
        let done = Self((0..groups).map(|_| OnceLock::new()).collect());
        walk(&|group| {
            let is_first = done.0[group].set(work(group, &done)).is_ok();
            assert!(is_first, "each group is done once");
        });
        let groups = done.0.into_iter().map(OnceLock::into_inner);
        groups.map(|own| own.expect("each is done")).collect()
    }

    /// That of a group which the present one depends on.
    pub(super) fn of(&self, group: usize) -> &T {
        self.0[group].get().expect("what it depends on is done")
    }
}
