//! What slices prove together: those under assumptions are branches of a tree, and two branches that
//! assume either factor of a product to be zero leave no collapse state out.

use super::types::{Assumption, Factor, Proved, Refusal, Slice};

#[derive(Clone, Copy, Debug)]
pub(crate) struct SliceProof {
    /// No collapse state with λ* in the slice has it below this.
    pub(crate) least: f64,
    /// What rounding costs a unit of rates; 0 where the multipliers absorb it.
    pub(crate) deficit: f64,
    /// Largest entry of what rounding leaves of the identity.
    pub(crate) rounding: f64,
}

/// What slices prove together, λ without dimension.
///
/// # Errors
/// A slice begins above what is proved before it, or is no branch of the tree.
pub(crate) fn together(slices: &[(&Slice, SliceProof)], cap: f64) -> Result<Proved, Refusal> {
    let mut tree = Tree {
        slices,
        needs_cap: false,
    };
    let all: Vec<usize> = (0..slices.len()).collect();
    let lower = tree.lower(&all, 0, 0.0)?;
    Ok(Proved {
        lower,
        cap: tree.needs_cap.then_some(cap),
        slices: slices.len(),
        rounding: slices
            .iter()
            .fold(0.0, |most: f64, (_, part)| most.max(part.rounding)),
    })
}

struct Tree<'a> {
    slices: &'a [(&'a Slice, SliceProof)],
    /// Whether what rounding leaves holds for motions up to the cap only.
    needs_cap: bool,
}

impl Tree<'_> {
    /// λ* below which no collapse state lies that meets the first `depth` assumptions, which all these
    /// slices share; none lies below `lower`.
    fn lower(&mut self, slices: &[usize], depth: usize, mut lower: f64) -> Result<f64, Refusal> {
        let (own, deeper): (Vec<usize>, Vec<usize>) =
            (slices.iter()).partition(|&&index| self.slices[index].0.assumed.len() == depth);
        for index in own {
            let (slice, part) = self.slices[index];
            if slice.from > lower {
                return Err(Refusal::Apart { slice: index });
            }
            let reached = part.least.min(slice.to);
            if reached > lower {
                self.needs_cap |= part.deficit > 0.0;
                lower = reached;
            }
        }
        let next = |index: usize| self.slices[index].0.assumed[depth];
        let Some(&first) = deeper.first() else {
            return Ok(lower);
        };
        let pair = next(first).pair;
        if let Some(&slice) = deeper.iter().find(|&&index| next(index).pair != pair) {
            return Err(Refusal::Divided { slice });
        }
        let branch = |zero: Factor| {
            let with = deeper.iter().copied();
            let with = with.filter(|&index| next(index) == Assumption { pair, zero });
            with.collect::<Vec<usize>>()
        };
        let branches = [Factor::Force, Factor::Rate].map(branch);
        let [one, other] = branches.map(|branch| self.lower(&branch, depth + 1, lower));
        Ok(lower.max(one?.min(other?)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn slice(from: f64, to: f64, assumed: &[(usize, Factor)]) -> Slice {
        let assumed = assumed
            .iter()
            .map(|&(pair, zero)| Assumption { pair, zero });
        Slice {
            from,
            to,
            assumed: assumed.collect(),
            sigma: to,
            multipliers: Vec::new(),
            balance: Vec::new(),
        }
    }

    /// What slices that prove all that they span prove together.
    fn lower(slices: &[Slice]) -> Result<f64, Refusal> {
        let part = |least| SliceProof {
            least,
            deficit: 0.0,
            rounding: 0.0,
        };
        let slices: Vec<_> = slices.iter().map(|slice| (slice, part(slice.to))).collect();
        together(&slices, 1e4).map(|proved| proved.lower)
    }

    use Factor::{Force, Rate};

    #[test]
    fn slices_side_by_side_reach_the_end_of_the_last() {
        assert_eq!(
            lower(&[slice(0.0, 0.2, &[]), slice(0.2, 0.5, &[])]),
            Ok(0.5)
        );
        assert_eq!(lower(&[]), Ok(0.0));
        let apart = lower(&[slice(0.0, 0.2, &[]), slice(0.3, 0.5, &[])]);
        assert_eq!(apart, Err(Refusal::Apart { slice: 1 }));
    }

    /// A branch alone proves nothing; both prove the lesser.
    #[test]
    fn branches_prove_what_both_prove() {
        let root = slice(0.0, 0.2, &[]);
        let force = slice(0.2, 0.5, &[(3, Force)]);
        let rate = slice(0.1, 0.4, &[(3, Rate)]);
        assert_eq!(lower(&[root.clone(), force.clone()]), Ok(0.2));
        assert_eq!(lower(&[root.clone(), rate.clone(), force.clone()]), Ok(0.4));
        let deeper = [
            root,
            force,
            rate,
            slice(0.4, 0.6, &[(3, Rate), (7, Rate)]),
            slice(0.4, 0.45, &[(3, Rate), (7, Force)]),
        ];
        assert_eq!(lower(&deeper), Ok(0.45));
        assert_eq!(lower(&deeper[..4]), Ok(0.4));
        let same_twice = [
            slice(0.0, 0.5, &[(3, Force)]),
            slice(0.0, 0.5, &[(3, Force)]),
        ];
        assert_eq!(lower(&same_twice), Ok(0.0));
    }

    #[test]
    fn branches_of_different_products_are_no_tree() {
        let slices = [
            slice(0.0, 0.5, &[(3, Force)]),
            slice(0.0, 0.5, &[(4, Rate)]),
        ];
        assert_eq!(lower(&slices), Err(Refusal::Divided { slice: 1 }));
    }

    /// What a branch proves is not proved outside it.
    #[test]
    fn a_slice_may_not_begin_where_another_branch_ends() {
        let slices = [
            slice(0.0, 0.5, &[(3, Force)]),
            slice(0.5, 0.6, &[(3, Rate)]),
        ];
        assert_eq!(lower(&slices), Err(Refusal::Apart { slice: 1 }));
    }
}
