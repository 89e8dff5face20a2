//! Coefficients of friction by class of joint.

use super::joints::JointClass;

/// Coefficients of friction, tan φ, one a class of joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Friction {
    /// Of bed joints.
    pub bed: f64,
    /// Of head joints.
    pub head: f64,
    /// Of joints against supports.
    pub base: f64,
}

impl Friction {
    /// The coefficient of a class.
    pub fn of(self, class: JointClass) -> f64 {
        match class {
            JointClass::Bed => self.bed,
            JointClass::Head => self.head,
            JointClass::Base => self.base,
            JointClass::Guide => 0.0,
        }
    }

    /// Every coefficient times `factor`.
    pub fn times(self, factor: f64) -> Self {
        Self {
            bed: self.bed * factor,
            head: self.head * factor,
            base: self.base * factor,
        }
    }
}

/// The same coefficient for every joint.
impl From<f64> for Friction {
    fn from(coefficient: f64) -> Self {
        Self {
            bed: coefficient,
            head: coefficient,
            base: coefficient,
        }
    }
}
