//! Voussoir arches: circular, of constant thickness, with radial joints, on fixed springers.

use super::assembly::{Assembly, Forces, NamedBlock, Support};
use super::friction::Friction;
use super::joints::TOUCHING;
use super::polygon::{Point, Polygon, PolygonError};

/// A circular arch about the origin, symmetric about the vertical.
#[derive(Clone, Debug, PartialEq)]
pub struct Arch {
    /// Radius of the middle line.
    pub mean_radius: f64,
    /// Thickness of the ring, extrados minus intrados; less than twice the mean radius.
    pub thickness: f64,
    /// Angle from springer to springer, degrees; 180 is a semicircle.
    pub embrace: f64,
    /// Number of equal voussoirs, named `1`, `2`, … from the left.
    pub voussoirs: u32,
    /// Weight over the area of the elevation.
    pub specific_weight: f64,
    /// Coefficients of friction; all joints between voussoirs are bed joints.
    pub friction: Friction,
    /// Forces beside the dead weights.
    pub forces: Forces,
}

impl Arch {
    /// The voussoirs between their springers `left` and `right`. The polygons are trapezoids, which
    /// touch as annular sectors do; size and place of the weights are those of the sectors.
    ///
    /// # Errors
    /// [`PolygonError`] where a voussoir is no proper polygon.
    pub fn assembly(&self) -> Result<Assembly, PolygonError> {
        let embrace = self.embrace.to_radians();
        let step = embrace / f64::from(self.voussoirs);
        // From left to right: the angle from +x falls.
        let angle = |k: u32| (std::f64::consts::PI + embrace) / 2.0 - step * f64::from(k);
        let (weight, centre) = self.sector(step);
        let voussoir = |k: u32| {
            let (from, to) = (angle(k), angle(k + 1));
            Ok(NamedBlock {
                name: (k + 1).to_string(),
                shape: self.trapezoid(from, to)?,
                weight,
                centre: on_circle(centre, (from + to) / 2.0),
                friction: None,
            })
        };
        // Wide enough to bear the joint, and clear of each other however far the arch embraces.
        let wide = step.min((std::f64::consts::TAU - embrace) / 4.0);
        let (left, right) = (angle(0), angle(self.voussoirs));
        let springer = |name: &str, from: f64, to: f64| {
            Ok(Support {
                name: name.to_owned(),
                shape: self.trapezoid(from, to)?,
            })
        };
        Ok(Assembly {
            blocks: (0..self.voussoirs)
                .map(voussoir)
                .collect::<Result<_, _>>()?,
            supports: vec![
                springer("left", left + wide, left)?,
                springer("right", right, right - wide)?,
            ],
            friction: self.friction,
            overburden: 0.0,
            forces: self.forces.clone(),
            tolerance: TOUCHING,
            radial: true,
            named_joints: Vec::new(),
            layers: Default::default(),
        })
    }

    /// Radii of intrados and extrados.
    fn radii(&self) -> [f64; 2] {
        [-0.5, 0.5].map(|half| self.mean_radius + half * self.thickness)
    }

    /// Weight of the annular sector of an angle, and the distance of its centroid from the centre:
    /// area φ (R² − r²) / 2, centroid at 4 sin(φ/2) (R³ − r³) / (3 φ (R² − r²)).
    fn sector(&self, angle: f64) -> (f64, f64) {
        let [inner, outer] = self.radii();
        let squares = outer.powi(2) - inner.powi(2);
        let cubes = outer.powi(3) - inner.powi(3);
        let weight = self.specific_weight * angle / 2.0 * squares;
        let centre = 4.0 / (3.0 * angle) * (angle / 2.0).sin() * cubes / squares;
        (weight, centre)
    }

    /// The outline between two angles, the first the larger.
    fn trapezoid(&self, from: f64, to: f64) -> Result<Polygon, PolygonError> {
        let [inner, outer] = self.radii();
        Polygon::new(vec![
            on_circle(inner, from),
            on_circle(inner, to),
            on_circle(outer, to),
            on_circle(outer, from),
        ])
    }
}

fn on_circle(radius: f64, angle: f64) -> Point {
    Point::new(radius * angle.cos(), radius * angle.sin())
}
