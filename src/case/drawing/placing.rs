//! How a block of a drawing is laid into the drawing.

use nalgebra::{Matrix3, Vector3};

/// A point or a direction in space.
pub(super) type Spatial = Vector3<f64>;

/// How a drawing is laid into another: a linear part and a shift.
#[derive(Clone, Copy)]
pub(super) struct Placing {
    pub linear: Matrix3<f64>,
    pub shift: Spatial,
}

impl Placing {
    pub fn as_drawn() -> Placing {
        Placing {
            linear: Matrix3::identity(),
            shift: Spatial::zeros(),
        }
    }

    /// The axes of an entity whose plane has this normal, its direction of extrusion: DXF says which of
    /// the ways to lay x and y is meant.
    pub fn in_plane(normal: Spatial) -> Matrix3<f64> {
        let normal = normal.normalize();
        let beside = match normal.x.abs().max(normal.y.abs()) < 1.0 / 64.0 {
            true => Spatial::y(),
            false => Spatial::z(),
        };
        let x = beside.cross(&normal).normalize();
        Matrix3::from_columns(&[x, normal.cross(&x), normal])
    }

    pub fn point(&self, p: Spatial) -> Spatial {
        self.linear * p + self.shift
    }

    /// First `inner`, then this.
    pub fn after(&self, inner: &Placing) -> Placing {
        Placing {
            linear: self.linear * inner.linear,
            shift: self.point(inner.shift),
        }
    }
}
