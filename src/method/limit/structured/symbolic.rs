//! Where the factor of a symmetric matrix of 3 × 3 blocks has entries, found once a scene.

/// The pattern of a factor: block columns that have the same rows form a front, which is dense.
pub(super) struct Pattern {
    /// Block by place in the elimination.
    pub(super) order: Vec<usize>,
    /// Place in the elimination by block.
    place: Vec<usize>,
    /// In the order of elimination; children come before their parents.
    pub(super) fronts: Vec<Front>,
    /// Entries of all fronts' columns.
    pub(super) entries: usize,
    /// Entries of the updates that wait for their parents at most, in either store.
    pub(super) waiting: [usize; 2],
}

/// Some block columns of the factor and the block rows that they share.
pub(super) struct Front {
    /// Place of the first column.
    pub(super) first: usize,
    /// Block columns.
    pub(super) columns: usize,
    /// Places of the rows below the columns, ascending.
    pub(super) rows: Vec<usize>,
    /// Where its columns begin among the entries of the factor.
    pub(super) start: usize,
    /// In which of two stores its update waits for the parent, and where.
    pub(super) store: usize,
    pub(super) waits_at: usize,
    pub(super) children: Vec<Child>,
}

/// A front whose update goes into another one.
pub(super) struct Child {
    /// Its place among the fronts.
    pub(super) front: usize,
    /// Row of the parent, its columns being the first ones, by row of the child.
    pub(super) into: Vec<usize>,
}

impl Front {
    /// Scalar columns.
    pub(super) fn width(&self) -> usize {
        3 * self.columns
    }

    /// Scalar rows, those of the columns included.
    pub(super) fn height(&self) -> usize {
        3 * (self.columns + self.rows.len())
    }

    /// Scalar rows below the columns.
    pub(super) fn below(&self) -> usize {
        3 * self.rows.len()
    }

    fn row(&self, place: usize) -> usize {
        if place < self.first + self.columns {
            return place - self.first;
        }
        let below = self.rows.partition_point(|&row| row < place);
        self.columns + below
    }
}

/// Where a 3 × 3 block of the matrix stands in the factor's entries.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Slot {
    /// First entry.
    pub(super) at: usize,
    /// Distance of its columns.
    pub(super) stride: usize,
    /// Whether its transpose stands there.
    pub(super) transposed: bool,
}

/// Zeros that a front may store so that it takes in its child. Few large fronts are faster than many
/// small ones (measured: 0 and 60 take 5 to 15 % longer on walls of 30 to 150 blocks).
const STORED_ZEROS: usize = 16;

impl Pattern {
    /// The pattern of a matrix whose blocks are `pairs` and the diagonal.
    pub(super) fn new(blocks: usize, pairs: &[(usize, usize)]) -> Self {
        let beside = neighbours(blocks, pairs);
        let (order, parents) = postordered(&beside, minimum_degree(&beside));
        let place = inverse(&order);
        let rows = column_rows(&beside, &order, &place, &parents);
        let mut fronts = fronts(&parents, &rows);
        let entries = store(&mut fronts);
        let waiting = link(&mut fronts, blocks);
        Self {
            order,
            place,
            fronts,
            entries,
            waiting,
        }
    }

    /// Where the block of this row and this column stands.
    pub(super) fn slot(&self, row: usize, column: usize) -> Slot {
        let (row, column) = (self.place[row], self.place[column]);
        let transposed = row < column;
        let (row, column) = (row.max(column), row.min(column));
        let front = self.fronts.partition_point(|front| front.first <= column);
        let front = &self.fronts[front - 1];
        let stride = front.height();
        Slot {
            at: front.start + 3 * (column - front.first) * stride + 3 * front.row(row),
            stride,
            transposed,
        }
    }
}

/// Blocks that each block shares an entry with, ascending.
fn neighbours(blocks: usize, pairs: &[(usize, usize)]) -> Vec<Vec<usize>> {
    let mut beside = vec![Vec::new(); blocks];
    for &(a, b) in pairs {
        if a != b {
            beside[a].push(b);
            beside[b].push(a);
        }
    }
    for blocks in &mut beside {
        blocks.sort_unstable();
        blocks.dedup();
    }
    beside
}

/// An order of elimination that leaves few entries.
fn minimum_degree(beside: &[Vec<usize>]) -> Vec<usize> {
    // The diagonal changes no order; without it `amd` underflows where its debug assertions are on.
    let (mut rows, mut starts) = (Vec::new(), vec![0]);
    for (block, others) in beside.iter().enumerate() {
        let at = others.partition_point(|&other| other < block);
        rows.extend(&others[..at]);
        rows.push(block);
        rows.extend(&others[at..]);
        starts.push(rows.len());
    }
    let control = amd::Control::default();
    match amd::order(beside.len(), &starts, &rows, &control) {
        Ok((order, _, _)) if order.len() == beside.len() => order,
        _ => (0..beside.len()).collect(),
    }
}

fn inverse(order: &[usize]) -> Vec<usize> {
    let mut place = vec![0; order.len()];
    for (at, &block) in order.iter().enumerate() {
        place[block] = at;
    }
    place
}

/// Parent of every column in the elimination tree (Liu 1990); `None` at a root.
fn elimination_tree(beside: &[Vec<usize>], order: &[usize]) -> Vec<Option<usize>> {
    let place = inverse(order);
    let mut parents = vec![None; order.len()];
    let mut ancestors: Vec<Option<usize>> = vec![None; order.len()];
    for (column, &block) in order.iter().enumerate() {
        for &neighbour in &beside[block] {
            let mut below = place[neighbour];
            while below < column {
                match ancestors[below].replace(column) {
                    None => {
                        parents[below] = Some(column);
                        break;
                    }
                    Some(next) => below = next,
                }
            }
        }
    }
    parents
}

/// The order with children right before their parents, and the tree in it.
fn postordered(beside: &[Vec<usize>], order: Vec<usize>) -> (Vec<usize>, Vec<Option<usize>>) {
    let parents = elimination_tree(beside, &order);
    let mut children = vec![Vec::new(); order.len()];
    for (column, parent) in parents.iter().enumerate() {
        if let Some(parent) = parent {
            children[*parent].push(column);
        }
    }
    let mut visited = Vec::with_capacity(order.len());
    let roots = (0..order.len()).filter(|&column| parents[column].is_none());
    for root in roots {
        let mut path = vec![(root, 0)];
        while let Some((column, child)) = path.pop() {
            match children[column].get(child) {
                Some(&next) => path.extend([(column, child + 1), (next, 0)]),
                None => visited.push(order[column]),
            }
        }
    }
    let parents = elimination_tree(beside, &visited);
    (visited, parents)
}

/// Rows below the diagonal of every block column of the factor, ascending.
fn column_rows(
    beside: &[Vec<usize>],
    order: &[usize],
    place: &[usize],
    parents: &[Option<usize>],
) -> Vec<Vec<usize>> {
    let mut rows: Vec<Vec<usize>> = vec![Vec::new(); order.len()];
    for column in 0..order.len() {
        let mut own = std::mem::take(&mut rows[column]);
        own.extend(beside[order[column]].iter().map(|&block| place[block]));
        own.retain(|&row| row > column);
        own.sort_unstable();
        own.dedup();
        if let Some(parent) = parents[column] {
            rows[parent].extend(&own);
        }
        rows[column] = own;
    }
    rows
}

/// Runs of columns with much the same rows.
fn fronts(parents: &[Option<usize>], rows: &[Vec<usize>]) -> Vec<Front> {
    let mut fronts: Vec<Front> = Vec::new();
    let mut zeros = 0;
    for column in 0..rows.len() {
        let grown = fronts.last_mut().filter(|front| {
            let last = column - 1;
            let more =
                zeros + (rows[column].len() + 1).saturating_sub(rows[last].len()) * front.columns;
            let joins = parents[last] == Some(column) && more <= STORED_ZEROS;
            if joins {
                zeros = more;
            }
            joins
        });
        match grown {
            Some(front) => {
                front.columns += 1;
                front.rows.clone_from(&rows[column]);
            }
            None => {
                zeros = 0;
                fronts.push(Front {
                    first: column,
                    columns: 1,
                    rows: rows[column].clone(),
                    start: 0,
                    store: 0,
                    waits_at: 0,
                    children: Vec::new(),
                });
            }
        }
    }
    fronts
}

/// Gives every front its place among the entries; returns how many there are.
fn store(fronts: &mut [Front]) -> usize {
    let mut entries = 0;
    for front in fronts {
        front.start = entries;
        entries += front.width() * front.height();
    }
    entries
}

/// Links every front to its parent and gives its update a place to wait at: fronts of even depth in one store,
/// those of odd depth in the other, so that none overwrites what it is made of. In either store an update
/// waits above those of fronts that wait for the same parent or a later one. Returns the most entries that wait.
fn link(fronts: &mut [Front], blocks: usize) -> [usize; 2] {
    let mut front_of = vec![0; blocks];
    for (f, front) in fronts.iter().enumerate() {
        front_of[front.first..front.first + front.columns].fill(f);
    }
    let parents: Vec<Option<usize>> = fronts
        .iter()
        .map(|front| Some(front_of[*front.rows.first()?]))
        .collect();
    for f in (0..fronts.len()).rev() {
        fronts[f].store = parents[f].map_or(0, |parent| 1 - fronts[parent].store);
    }
    let (mut top, mut most) = ([0; 2], [0; 2]);
    for f in 0..fronts.len() {
        let store = fronts[f].store;
        if let Some(first) = fronts[f].children.first() {
            top[1 - store] = fronts[first.front].waits_at;
        }
        fronts[f].waits_at = top[store];
        top[store] += fronts[f].below().pow(2);
        most[store] = most[store].max(top[store]);
        if let Some(parent) = parents[f] {
            let into = fronts[f].rows.iter().map(|&row| fronts[parent].row(row));
            let into = into.collect();
            fronts[parent].children.push(Child { front: f, into });
        }
    }
    most
}
