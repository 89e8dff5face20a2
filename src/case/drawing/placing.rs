//! How a block of a drawing is laid into the drawing.

use crate::scene::Vector;

/// How a drawing is laid into another: a linear part and a shift.
#[derive(Clone, Copy)]
pub(super) struct Placing {
    pub columns: [Vector; 2],
    pub shift: Vector,
}

impl Placing {
    pub const AS_DRAWN: Placing = Placing {
        columns: [Vector::new(1.0, 0.0), Vector::new(0.0, 1.0)],
        shift: Vector::new(0.0, 0.0),
    };

    pub fn direction(&self, v: Vector) -> Vector {
        self.columns[0] * v.x + self.columns[1] * v.y
    }

    pub fn point(&self, p: Vector) -> Vector {
        self.direction(p) + self.shift
    }

    /// First `inner`, then this.
    pub fn after(&self, inner: &Placing) -> Placing {
        Placing {
            columns: inner.columns.map(|column| self.direction(column)),
            shift: self.point(inner.shift),
        }
    }
}
