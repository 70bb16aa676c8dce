//! Choice of the most useful next swing test.

use nalgebra::DMatrix;
use polhode::math::{Body, Direction, Position, Rotation, Space};

use super::hung_mass::Placement;
use super::identify::SwingEstimate;
use super::measurement::Measurement;
use super::number::TENSOR;
use super::plan::{SwingPlan, SwingTest};
use super::problem::{Stage, Swings};
use crate::error::IdentifyError;
use crate::knowledge::BodyUnits;
use crate::least_squares::{Problem, rows_of};
use crate::next::{Comparison, NextExperiment, signed_axes};

/// Possible next measurement.
#[derive(Clone, Debug, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "there are few")]
pub enum NextSwing {
    /// Another swing in a rig of the plan. The body is rotated about its centre of mass, which
    /// keeps its position.
    Test {
        /// Direction along the body's x, y, z, in whole numbers, that becomes the axis of the
        /// swing.
        about: [i8; 3],
        /// Name of the test with the same rig.
        like: String,
        /// Test with the readings that are predicted for the estimated body.
        test: SwingTest,
    },
    /// Repeated measurement of a number of the plan, with the same error.
    Number {
        /// Name of the number.
        name: String,
        /// Standard deviation of the measurement, in `unit`.
        sd: f64,
        /// Unit of the number.
        unit: &'static str,
    },
}

/// Directions of x, y, z, and between two or three of them.
const AXES: [[i8; 3]; 13] = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
    [1, 1, 0],
    [1, -1, 0],
    [1, 0, 1],
    [1, 0, -1],
    [0, 1, 1],
    [0, 1, -1],
    [1, 1, 1],
    [1, 1, -1],
    [1, -1, 1],
    [-1, 1, 1],
];

/// Ranks possible next measurements, best first.
///
/// Candidates are each rig of the plan with the body rotated to swing about other axes, and each
/// measured number once more. `None` if the tensor is zero.
///
/// # Errors
/// [`IdentifyError::NotFinite`] if a covariance or derivative is not finite.
pub fn next_swing(
    plan: &SwingPlan,
    found: &SwingEstimate,
) -> Result<Option<NextExperiment<NextSwing>>, IdentifyError> {
    let Some(units) = BodyUnits::of_tensor(&found.estimate, TENSOR, true) else { return Ok(None) };
    let information = found.estimate.information()?;
    let mut next = Comparison::new(&units, &information);
    let places = plan.places();
    for (k, test) in templates(plan) {
        let own: Vec<f64> = found.tests[k].own.iter().map(|number| number.value).collect();
        for about in AXES {
            let Some(placement) = turned(test, about, found) else { continue };
            let turned = SwingTest {
                name: format!("about {}", signed_axes(about.map(f64::from))),
                body: Some(placement),
                ..test.clone()
            };
            let (test, rows) = match predicted(plan, turned.clone(), &own, found) {
                Ok((test, rows)) => (test, Ok(rows / found.widening)),
                Err(error) => (turned, Err(error)),
            };
            let experiment = NextSwing::Test { about, like: plan.tests()[k].name.clone(), test };
            next.add(experiment, rows);
        }
    }
    for (k, (name, unit)) in plan.names().into_iter().enumerate() {
        let sd = plan.measured()[k].sd;
        if places[k].is_some() && sd.is_finite() {
            let mut row = DMatrix::zeros(1, places.len());
            row[(0, k)] = 1.0 / (sd * found.widening);
            next.add(NextSwing::Number { name, sd, unit }, Ok(row));
        }
    }
    Ok(Some(next.finish()?))
}

/// Returns the first test with the body in each rig, with its index.
fn templates(plan: &SwingPlan) -> Vec<(usize, &SwingTest)> {
    let mut all: Vec<(usize, &SwingTest)> = Vec::new();
    for (k, test) in plan.tests().iter().enumerate().filter(|(_, test)| test.body.is_some()) {
        let is_same = |(_, other): &(usize, &SwingTest)| {
            other.rig == test.rig && other.fixture == test.fixture && other.air == test.air
        };
        if !all.iter().any(is_same) {
            all.push((k, test));
        }
    }
    all
}

/// Returns the placement with the body rotated about its centre c by the smallest rotation Q that
/// is needed: r_rig = R (c + Q (r − c)) + origin.
fn turned(test: &SwingTest, about: [i8; 3], found: &SwingEstimate) -> Option<Placement> {
    let Placement { rotation, origin } = test.body?;
    let wanted = Direction::<Body>::from_array(about.map(f64::from)).direction()?;
    let axis: Direction<Body> = rotation.inverse() * Direction::<Space>::from_array(test.rig.axis());
    // The sign of an axis does not matter.
    let wanted = if wanted.dot(axis) < 0.0 { -wanted } else { wanted };
    let turn = match wanted.cross(axis).direction() {
        Some(about) => Rotation::<Body, Body>::from_axis_angle(about, wanted.angle_to(axis)).ok()?,
        None => Rotation::identity(),
    };
    let c: Position<Body> = found.body.center_of_mass();
    Some(Placement { rotation: rotation * turn, origin: origin + rotation * (c - turn * c) })
}

/// Returns the test with predicted readings, and its rows: derivatives by all parameters, with the
/// local ones eliminated.
fn predicted(
    plan: &SwingPlan,
    mut test: SwingTest,
    own: &[f64],
    found: &SwingEstimate,
) -> Result<(SwingTest, DMatrix<f64>), IdentifyError> {
    let alone = plan.with_tests(vec![test.clone()]);
    let mut swings = Swings::new(&alone)?;
    swings.stage = Stage::All;
    let places = plan.places();
    let values = found.estimate.numbers.iter().map(|number| number.value);
    let shared: Vec<f64> = values.zip(&places).filter_map(|(value, place)| place.map(|_| value)).collect();
    let rows = rows_of(&swings, swings.groups() - 1, &shared, own)?;
    let left = rows.measurements().flatten().collect::<Vec<f64>>();
    test.measurement = moved(&test.measurement, &left);
    let rest = rows.without_own()?;
    let column = |k: usize| places[k].map(|place| rest.column(place));
    let all = DMatrix::from_fn(rest.nrows(), places.len(), |i, k| column(k).map_or(0.0, |column| column[i]));
    Ok((test, all))
}

/// Returns the measurement minus its residuals, which are in standard deviations: the prediction.
fn moved(measurement: &Measurement, left: &[f64]) -> Measurement {
    let mut moved = measurement.clone();
    match &mut moved {
        Measurement::Counted(counted) => {
            let times = counted.intervals.iter_mut().map(|i| (&mut i.time, i.sd));
            let amplitudes = counted.amplitudes.iter_mut().map(|a| (&mut a.amplitude, a.sd));
            times.chain(amplitudes).zip(left).for_each(|((value, sd), left)| *value -= sd * left);
        }
        Measurement::Logged(logged) => {
            let sd = logged.sd;
            logged.values.iter_mut().zip(left).for_each(|(value, left)| *value -= sd * left);
        }
    }
    moved
}
