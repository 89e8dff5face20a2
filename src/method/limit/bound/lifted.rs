//! The lifted program of one slice, and what is left of its conditions at a point.

use nalgebra::DMatrix;

use super::face::Face;
use super::point::{Lengths, Point};
use super::products::Products;

/// A slice of λ*, and when to stop. What is assumed in it is given beside it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Request {
    /// a.
    pub(super) from: f64,
    /// b, which may be infinite. Then bounds are no λ: what is above 0 excludes every state.
    pub(super) to: f64,
    /// Bound at which the iteration may stop.
    pub(super) enough: f64,
    /// σ₀, above b.
    pub(super) most: f64,
    /// Steps at most.
    pub(super) steps: usize,
    /// Whether it goes on to the optimum: slower, and for slices whose multipliers leave too much of the
    /// identity otherwise.
    pub(super) exact: bool,
    /// What multipliers may leave of the identity at the end.
    pub(super) left: f64,
}

impl Request {
    /// A bound that says nothing.
    pub(super) fn nothing(&self) -> f64 {
        match self.to.is_finite() {
            true => self.from,
            false => 0.0,
        }
    }

    /// The share of its width up to this bound of λ; without an upper end all or none.
    pub(super) fn share(&self, reached: f64) -> f64 {
        match self.to.is_finite() {
            true => (reached.min(self.to) - self.from) / (self.to - self.from),
            false => f64::from(reached == f64::INFINITY),
        }
    }

    /// Whether a proof loses no more than a share of the slice's width of what multipliers promise.
    pub(super) fn keeps(&self, promised: f64, least: f64, lost: f64) -> bool {
        match self.to.is_finite() {
            true => promised - least <= lost * (self.to - self.from),
            false => least == f64::INFINITY || promised <= self.enough,
        }
    }
}

/// The lifted program of one slice.
pub(super) struct Lifted<'a> {
    pub(super) products: Products<'a>,
    pub(super) request: Request,
    /// Whether a product is zero, column by column, so that its multiplier has any sign.
    pub(super) is_zero: Vec<bool>,
    /// How many are not, with the scale condition.
    pub(super) count: f64,
    cost: DMatrix<f64>,
    /// The scale condition's row.
    pub(super) scale_row: DMatrix<f64>,
}

/// Residuals of the conditions and of the identity at a point, and what they say of it.
pub(super) struct Residual {
    pub(super) products: DMatrix<f64>,
    pub(super) scale: f64,
    pub(super) identity: DMatrix<f64>,
    /// Mean of product times multiplier.
    pub(super) mean: f64,
    /// The bound, and the λ* of the lifted state above it.
    pub(super) sigma: f64,
    above: f64,
    /// The largest residuals of the identity and of a product.
    pub(super) left: f64,
    violated: f64,
}

impl Residual {
    pub(super) fn is_finite(&self) -> bool {
        self.sigma.is_finite() && self.left.is_finite()
    }
}

impl<'a> Lifted<'a> {
    pub(super) fn new(face: &'a Face, request: Request) -> Self {
        let products = Products::new(face, [request.from, request.to]);
        let rows = products.conditions.nrows();
        let all = 0..rows * face.motion.rows.len();
        let is_none = |force: usize| force == rows - 1 && request.to.is_infinite();
        let is_zero = |at: usize| is_none(at % rows) || face.is_zero(at % rows, at / rows);
        let is_zero: Vec<bool> = all.map(is_zero).collect();
        Self {
            count: (is_zero.iter().filter(|is_zero| !**is_zero).count() + 1) as f64,
            is_zero,
            cost: products.left_side(&products.aim, request.most),
            scale_row: products.scale_row(),
            products,
            request,
        }
    }

    pub(super) fn residual(&self, at: &Point) -> Residual {
        let identity = &self.cost - self.products.transposed(&at.multipliers);
        let identity = identity + &self.scale_row * at.scale[1];
        let products = self.products.of(&at.unknowns) - &at.products;
        let scaled = at.scale[0] * at.scale[1];
        Residual {
            scale: 1.0 - self.products.work(&at.unknowns) - at.scale[0],
            mean: (at.products.dot(&at.multipliers) + scaled) / self.count,
            sigma: self.request.most - at.scale[1],
            above: self.cost.dot(&at.unknowns) + self.request.most,
            left: identity.amax(),
            violated: products.amax(),
            products,
            identity,
        }
    }

    /// Goes on from multipliers that left too much of the identity to be proved.
    pub(super) fn refine(&mut self, residual: &Residual) {
        let own = self.products.parameters();
        self.request.exact = true;
        self.request.left = own.refined * residual.left.min(self.request.left);
    }

    /// Whether the bound is enough, or as good as it gets.
    pub(super) fn is_done(&self, residual: &Residual) -> bool {
        let own = self.products.parameters();
        let Residual {
            sigma,
            above,
            left,
            violated,
            ..
        } = *residual;
        let enough = self.request.enough;
        let excludes = sigma > enough && left < self.request.left;
        // A lifted state well inside the slice: where exactly the bound ends is of no use.
        let gained = above - self.request.nothing();
        let inside = match self.request.to.is_finite() {
            true => above - sigma < own.rough * gained.min(enough - above),
            false => above < own.rough * enough,
        };
        let leave = |most: f64| left < most && violated < most;
        let is_optimal = above - sigma < own.gap && leave(self.request.left);
        let is_rough = inside && leave(own.roughly_left);
        excludes || is_optimal || (is_rough && !self.request.exact)
    }

    /// Longest steps that keep products and multipliers from becoming negative.
    pub(super) fn lengths(&self, at: &Point, step: &Point) -> Lengths {
        let most = 1.0 / (1.0 - self.products.parameters().kept_back);
        at.lengths(step, &self.is_zero, most)
    }
}
