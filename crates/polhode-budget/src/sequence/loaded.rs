//! Body with liquid in its tanks, and its change per kilogram of liquid.

use polhode::body::{BodyError, MassProperties};
use polhode::math::{Body, Part, Position, Rotation, Velocity};
use polhode::motion::MassRates;

use crate::sequence_error::SequenceError;
use crate::tank::{Fill, Slice, Tank};
use crate::tensor::{elements, plus, rows, steiner};

/// Tank at its place in the body.
#[derive(Clone, Debug)]
pub(super) struct PlacedTank<'a> {
    pub(super) tank: &'a Tank,
    pub(super) position: Position<Body>,
    pub(super) rotation: Rotation<Body, Part>,
}

impl PlacedTank<'_> {
    /// Returns the state of the liquid with a mass, kg.
    ///
    /// # Errors
    /// [`SequenceError::Fill`] if the tank does not hold this mass.
    pub(super) fn filled(&self, mass: f64, time: f64) -> Result<Fill, SequenceError> {
        self.tank.liquid.at(mass).ok_or_else(|| SequenceError::Fill {
            tank: self.tank.name.clone(),
            mass,
            capacity: self.tank.liquid.capacity(),
            time,
        })
    }

    pub(super) fn liquid(&self, fill: &Fill) -> Result<Option<MassProperties<Body>>, BodyError> {
        fill.properties.map(|liquid| liquid.placed(self.position, self.rotation)).transpose()
    }

    /// Returns the change per kilogram of liquid, along the axes of the body.
    pub(super) fn slice(&self, slice: &Slice) -> Slice {
        let center = self.position + self.rotation * Position::from_array(slice.center);
        let (r, s) = (self.rotation.matrix(), rows(slice.tensor));
        let turned = core::array::from_fn(|i: usize| {
            core::array::from_fn(|j: usize| {
                let terms = (0..3).flat_map(|k| (0..3).map(move |l| (k, l)));
                terms.map(|(k, l)| r[i][k] * s[k][l] * r[j][l]).sum::<f64>()
            })
        });
        Slice { center: center.to_array(), tensor: elements(turned) }
    }
}

/// Returns Ṁ, ċ and İ of a body to which slices are added at these rates, kg/s.
///
/// Ṁ = Σ ṁ, ċ = Σ ṁ (g − c)/M, İ = Σ ṁ (T + d² 1 − d dᵀ), d = g − c. The motion of the centre
/// contributes to İ about the centre only in second order.
pub(super) fn rates(body: &MassProperties<Body>, slices: &[(f64, Slice)]) -> MassRates {
    let center = body.center_of_mass().to_array();
    let mut sum = MassRates { mass: 0.0, center_of_mass: Velocity::ZERO, inertia: [0.0; 6] };
    for &(rate, Slice { center: place, tensor }) in slices {
        let d: [f64; 3] = core::array::from_fn(|k| place[k] - center[k]);
        sum.mass += rate;
        sum.center_of_mass += Velocity::from_array(d.map(|x| rate * x / body.mass()));
        sum.inertia = plus(sum.inertia, plus(tensor, steiner(d, d), 1.0), rate);
    }
    sum
}
