//! A possible part, drawn from the errors of its row.

use polhode::body::{BodyError, MassProperties};
use polhode::math::{Direction, Part, Position, Rotation, symmetric_eigen};

use crate::budget::PlacedPart;
use crate::random::log_normal;
use crate::row::Place;
use crate::tank::UncertainLiquid;
use crate::tensor::{mass_properties, plus, steiner};
use crate::uncertainty::{Factor, RowError};

/// The relative rounding of second moments: what is no more below zero is zero.
const ROUNDING: f64 = 1e-12;

impl PlacedPart {
    /// The part with these errors, and whether it had to be moved to be possible.
    ///
    /// The mass is [`log_normal`], with z = δm/σ. All other numbers are normal. The second moments G = ½ tr(I) 1 − I about the centre of mass that come of it are those of a possible body if none of their eigenvalues is negative; one that is,
    /// is put at zero. That is the nearest possible tensor, by the sum of squares of the elements of G, and a lamina.
    ///
    /// Coordinates in which all is possible, as log-Cholesky ones, would do worse: most parts are thin, and of a plate 1 mm thick the logarithm of the thickness has errors that are
    /// not small wherever the tensor's are given as a part of its greatest moment.
    pub(crate) fn drawn(
        &self,
        sd: f64,
        liquid: Option<&UncertainLiquid>,
        follows: bool,
        error: &RowError,
    ) -> Result<(Option<MassProperties<Part>>, bool), BodyError> {
        let nominal = self.properties.mass();
        if let Some(liquid) = liquid {
            return liquid.drawn(nominal, [error.mass, error.density]);
        }
        let mass = if sd > 0.0 { log_normal(nominal, sd, error.mass / sd) } else { nominal };
        let center = self.properties.center_of_mass() + Position::from_array(error.center);
        let mut inertia = plus(self.elements, error.tensor, 1.0);
        if let Some(point) = self.about {
            let d = (center - point).to_array();
            inertia = plus(inertia, steiner(d, d), if follows { -nominal } else { -mass });
        }
        if follows {
            inertia = inertia.map(|element| element * (mass / nominal));
        }
        let (inertia, moved) = possible(inertia);
        Ok((Some(mass_properties(mass, center, inertia, None)?), moved))
    }
}

impl Place {
    /// The frame, moved by these errors; `None` if a turn is not finite.
    pub(crate) fn drawn(&self, error: &RowError) -> Option<(Position<Part>, Rotation<Part, Part>)> {
        let turn = Rotation::exp(Direction::from_array(error.rotation)).ok()?;
        Some((self.position + Position::from_array(error.position), turn * self.rotation))
    }
}

/// Standard deviation of the mass that the errors of a row come to.
pub(crate) fn mass_sd(factors: &[Factor]) -> f64 {
    factors.iter().map(|factor| factor.error.mass * factor.error.mass).sum::<f64>().sqrt()
}

/// The nearest tensor that a body can have, and whether it is another one.
pub(crate) fn possible(i: [f64; 6]) -> ([f64; 6], bool) {
    let half = 0.5 * (i[0] + i[1] + i[2]);
    let (values, vectors) = symmetric_eigen([half - i[0], half - i[1], half - i[2], -i[3], -i[4], -i[5]]);
    let largest = values.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    if values[0] >= 0.0 {
        return (i, false);
    }
    // Along each eigenvector v, a second moment g of mass adds g (1 − v vᵀ).
    let mut inertia = [0.0; 6];
    for (value, v) in values.into_iter().zip(vectors) {
        inertia = plus(inertia, steiner(v, v), value.max(0.0));
    }
    (inertia, values[0] < -ROUNDING * largest)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_possible_stays() {
        let i = [3.1, 4.2, 5.3, 0.4, -0.3, 0.2];
        assert_eq!(possible(i), (i, false));
    }

    #[test]
    fn what_is_not_becomes_the_nearest_lamina() {
        let i = [1.0, 2.0, 4.0, 0.1, 0.05, -0.2];
        let (j, moved) = possible(i);
        assert!(moved);
        let g = |i: [f64; 6]| {
            let half = 0.5 * (i[0] + i[1] + i[2]);
            [half - i[0], half - i[1], half - i[2], -i[3], -i[4], -i[5]]
        };
        let (before, after) = (symmetric_eigen(g(i)), symmetric_eigen(g(j)));
        assert!(before.0[0] < -0.4 && after.0[0].abs() < 2e-15);
        for k in 1..3 {
            assert!((before.0[k] - after.0[k]).abs() < 2e-15, "{before:?} {after:?}");
        }
        // G⁺ − G is along the eigenvector that was negative, so no other change to a possible one is less.
        let change: f64 = g(i)
            .iter()
            .zip(g(j))
            .enumerate()
            .map(|(k, (a, b))| (a - b) * (a - b) * if k < 3 { 1.0 } else { 2.0 })
            .sum();
        assert!((change.sqrt() + before.0[0]).abs() < 2e-15);
    }
}
