//! Torques interpolated from a table of times and values.

use super::TorqueModel;
use super::model::{AnyLaw, Model};
use super::polynomial::{PolynomialVector, Unknowns};
use super::recorder::{Recorder, VectorNode};
use super::tangent::Tangent;
use super::time_polynomial::{TimePolynomial, TorqueAxes};
use super::variation::Variation;
use super::varied::VariedVector;
use crate::math::frame::Body;
use crate::math::spline::Spline;
use crate::math::vector::Torque;
use crate::motion::error::MotionError;
use crate::motion::model::require;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;

/// Interpolation between the rows of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Interpolation {
    /// Piecewise constant: each row holds until the next.
    Steps,
    /// Piecewise linear.
    Linear,
    /// Cubic spline through all rows, with two continuous derivatives ("not-a-knot" end
    /// conditions).
    Spline,
}

/// Torque from a table: a polynomial in time between rows, and zero before the first row and from
/// the last row on.
///
/// The integrators stop at each row, so that no step crosses a corner of the table.
///
/// ```
/// use polhode::prelude::*;
/// use polhode::motion::torque::{Interpolation, Tabulated, TorqueAxes};
/// # let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2])?;
/// # let rotor = Rotor::free(&MassProperties::new(2.0, Position::ZERO, inertia)?);
/// let rows = [[0.0, 0.0, 0.0], [0.0, 0.0, 3.0], [0.0, 0.0, 1.0]];
/// let table = Tabulated::new(TorqueAxes::Body, Interpolation::Linear, &[0.0, 2.0, 6.0], &rows)?;
/// let torque = TorqueModel::Tabulated(Box::new(table));
/// let state = State { time: 3.0, attitude: Attitude::identity(), omega: AngularVelocity::ZERO };
/// assert_eq!(torque.torque(&rotor, &state).to_array(), [0.0, 0.0, 2.5]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Tabulated {
    times: Vec<f64>,
    interpolation: Interpolation,
    axes: TorqueAxes,
    /// Torque from each time to the next.
    pieces: Vec<TorqueModel>,
    /// Largest |N| of a row, N·m.
    greatest: f64,
}

impl Tabulated {
    /// Creates a torque from components (N·m) at ascending times (s).
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if there are fewer than two rows, if the
    /// numbers of torques and times differ, if times do not ascend, or if a number is not finite.
    pub fn new(
        axes: TorqueAxes,
        interpolation: Interpolation,
        times: &[f64],
        torques: &[[f64; 3]],
    ) -> Result<Self, MotionError> {
        let (what, rows) = ("the number of rows of a torque's table", times.len());
        require::that(what, rows as f64, rows >= 2, "at least 2")?;
        require::that(what, rows as f64, rows == torques.len(), "that of its torques")?;
        times.iter().try_for_each(|time| require::finite("the time of a row", *time))?;
        torques.as_flattened().iter().try_for_each(|n| require::finite("the torque of a row", *n))?;
        for pair in times.windows(2) {
            require::that(
                "the time of a row",
                pair[1],
                pair[0] < pair[1],
                "after the time of the previous row",
            )?;
        }
        let of_piece: Vec<Vec<[f64; 3]>> = match interpolation {
            Interpolation::Steps => torques.iter().map(|n| vec![*n]).collect(),
            Interpolation::Linear => straight(times, torques),
            Interpolation::Spline => cubic(times, torques),
        };
        let pieces = times.iter().zip(of_piece).take(rows - 1);
        let polynomial = |(epoch, coefficients): (&f64, _)| {
            TorqueModel::Polynomial(TimePolynomial { axes, epoch: *epoch, coefficients })
        };
        let pieces: Vec<_> = pieces.map(polynomial).collect();
        for piece in &pieces {
            let TorqueModel::Polynomial(polynomial) = piece else { continue };
            for c in polynomial.coefficients.as_flattened() {
                require::finite("the slope of a torque between two rows", *c)?;
            }
        }
        let greatest = torques.iter().map(|n| Torque::<Body>::from_array(*n).norm()).fold(0.0, f64::max);
        Ok(Self { times: times.to_vec(), interpolation, axes, pieces, greatest })
    }

    /// Returns the times of the rows, s.
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// Returns the interpolation between rows.
    pub const fn interpolation(&self) -> Interpolation {
        self.interpolation
    }

    /// Returns the axes of the components.
    pub const fn axes(&self) -> TorqueAxes {
        self.axes
    }

    /// Returns the largest |N| of the rows, N·m.
    pub const fn greatest(&self) -> f64 {
        self.greatest
    }

    /// Returns the torque just after a time; `None` before the first row and from the last row on.
    pub(super) fn piece(&self, time: f64) -> Option<&TorqueModel> {
        let begun = self.times.partition_point(|row| *row <= time);
        begun.checked_sub(1).and_then(|row| self.pieces.get(row))
    }

    /// Returns the time of the first row after a time, s; infinite if there is none.
    pub(super) fn next_change(&self, time: f64) -> f64 {
        let begun = self.times.partition_point(|row| *row <= time);
        self.times.get(begun).copied().unwrap_or(f64::INFINITY)
    }
}

/// Returns the coefficients of Nᵢ + (Nᵢ₊₁ − Nᵢ)/(tᵢ₊₁ − tᵢ) (t − tᵢ).
fn straight(times: &[f64], torques: &[[f64; 3]]) -> Vec<Vec<[f64; 3]>> {
    let rows = times.windows(2).zip(torques.windows(2));
    rows.map(|(t, n)| {
        let slope = core::array::from_fn(|k| (n[1][k] - n[0][k]) / (t[1] - t[0]));
        vec![n[0], slope]
    })
    .collect()
}

/// Returns the coefficients of
/// Nᵢ + N′ᵢ (t − tᵢ) + ½ N″ᵢ (t − tᵢ)² + ⅙ (N″ᵢ₊₁ − N″ᵢ)/(tᵢ₊₁ − tᵢ) (t − tᵢ)³.
fn cubic(times: &[f64], torques: &[[f64; 3]]) -> Vec<Vec<[f64; 3]>> {
    let Some(spline) = Spline::through(times, torques, 3) else { return Vec::new() };
    let rows: Vec<_> = times.iter().map(|time| spline.at(*time)).collect();
    let pieces = times.windows(2).zip(rows.windows(2)).zip(torques);
    pieces
        .map(|((t, n), value)| {
            let [_, slope, bend] = n[0];
            let third = core::array::from_fn(|k| (n[1][2][k] - bend[k]) / (6.0 * (t[1] - t[0])));
            vec![*value, slope, bend.map(|x| 0.5 * x), third]
        })
        .collect()
}

/// A table consists of its pieces, and no step crosses a row: each piece has its own polynomial and
/// graph.
impl AnyLaw for Tabulated {
    fn value(&self, rotor: &Rotor, state: &State) -> Torque<Body> {
        self.piece(state.time).map_or(Torque::ZERO, |piece| piece.torque(rotor, state))
    }

    fn polynomial(&self, unknowns: &Unknowns<'_>) -> PolynomialVector {
        self.pieces[0].model().polynomial(unknowns)
    }

    fn record<'r>(&self, recorder: &Recorder<'r>) -> VectorNode<'r> {
        self.pieces[0].model().record(recorder)
    }

    fn derivative(&self, along: &Tangent<'_>) -> Torque<Body> {
        self.piece(along.time()).map_or(Torque::ZERO, |piece| piece.model().derivative(along))
    }

    fn variation<'r>(&self, at: &Variation<'_, 'r>) -> VariedVector<'r> {
        self.pieces[0].model().variation(at)
    }

    fn parameters(&self) -> &'static [&'static str] {
        &[]
    }
}

impl Model for Tabulated {
    fn name(&self) -> &'static str {
        "table"
    }

    fn scale(&self, _: &Rotor, _: &State) -> f64 {
        self.greatest
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::rotation::Attitude;
    use crate::math::vector::AngularVelocity;
    use crate::motion::model::law::generic_rotor;

    fn at(table: &Tabulated, time: f64) -> [f64; 3] {
        let state = State { time, attitude: Attitude::identity(), omega: AngularVelocity::ZERO };
        table.value(&generic_rotor(), &state).to_array()
    }

    #[test]
    fn each_kind_goes_through_its_rows_and_is_zero_outside() {
        let times = [-1.5, 0.25, 1.0, 4.0, 4.5];
        let rows =
            [[1.0, -2.0, 0.5], [0.25, 3.0, -1.0], [2.0, 2.5, 0.75], [-1.0, 0.125, 4.0], [0.5, 1.0, -3.0]];
        for kind in [Interpolation::Steps, Interpolation::Linear, Interpolation::Spline] {
            let table = Tabulated::new(TorqueAxes::Body, kind, &times, &rows).unwrap();
            for (time, row) in times.iter().zip(rows).take(4) {
                assert_eq!(at(&table, *time), row, "{kind:?} {time}");
                let before = at(&table, time.next_down());
                if kind != Interpolation::Steps && *time > times[0] {
                    for k in 0..3 {
                        assert!((before[k] - row[k]).abs() < 1e-13, "{kind:?} {time}: {before:?}");
                    }
                }
            }
            assert_eq!([at(&table, times[0].next_down()), at(&table, 4.5)], [[0.0; 3]; 2]);
        }
    }

    #[test]
    fn a_spline_through_points_of_a_cubic_is_that_cubic() {
        let cubic =
            |t: f64| [1.0 - 2.0 * t + 0.5 * t * t * t, 0.3 * t * t - 1.0, 4.0 + t * (t - 1.0) * (t - 2.0)];
        let times = [0.0, 0.4, 1.1, 1.3, 2.9, 3.0];
        let rows = times.map(cubic);
        let table = Tabulated::new(TorqueAxes::Space, Interpolation::Spline, &times, &rows).unwrap();
        for time in [0.1, 0.39, 0.7, 1.2, 2.0, 2.95] {
            let (got, want) = (at(&table, time), cubic(time));
            assert!((0..3).all(|k| (got[k] - want[k]).abs() < 1e-12), "{time}: {got:?} {want:?}");
        }
    }

    #[test]
    fn what_is_no_table_is_refused() {
        let row = [1.0, 2.0, 3.0];
        for (times, rows) in [
            (&[0.0][..], &[row][..]),
            (&[0.0, 0.0], &[row; 2]),
            (&[1.0, 0.5], &[row; 2]),
            (&[0.0, f64::NAN], &[row; 2]),
            (&[0.0, 1.0], &[row; 3]),
            (&[0.0, 1.0], &[row, [0.0, f64::INFINITY, 0.0]]),
            (&[0.0, 1e-300], &[row, [1e300, 0.0, 0.0]]),
        ] {
            let refused = Tabulated::new(TorqueAxes::Body, Interpolation::Linear, times, rows);
            assert!(refused.is_err(), "{times:?}");
        }
    }
}
