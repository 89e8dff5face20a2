//! What the interior point is asked and what it answers.

/// The numbers of a program over the joints of one scene, in the units and the order of
/// [`Program`](crate::method::limit::Program): three forces a joint, then λ.
pub(in super::super) struct Problem<'a> {
    /// Right sides: three equilibrium rows a block, then four inequalities a joint.
    pub(in super::super) right: &'a [f64],
    /// Cost of every variable, the sum to be smallest.
    pub(in super::super) cost: &'a [f64],
    /// Slope of the friction law of every joint.
    pub(in super::super) slopes: &'a [f64],
    /// Relative tolerance of gap and residuals.
    pub(in super::super) tolerance: f64,
    /// Width of λ*, relative to its size, of an answer where rounding leaves no better one. Who asks
    /// for any tests the answer.
    pub(in super::super) width: f64,
}

/// An optimum, in the units of the program.
pub(in super::super) struct Answer {
    /// Forces of every joint, then λ.
    pub(in super::super) forces: Vec<f64>,
    /// Velocities, three a block.
    pub(in super::super) velocities: Vec<f64>,
    pub(in super::super) iterations: usize,
}
