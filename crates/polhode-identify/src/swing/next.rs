//! The swing test that would help most.

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

/// What could be measured next.
#[derive(Clone, Debug, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "there are few")]
pub enum NextSwing {
    /// Another swing in a rig of the plan: the body is turned about its centre of mass, which stays where it was.
    Test {
        /// The axis of the body that is then the axis of the swing: whole numbers along x, y, z.
        about: [i8; 3],
        /// The name of the test whose rig it is.
        like: String,
        /// The test, with what would be measured if the body is as it was found.
        test: SwingTest,
    },
    /// A number of the plan, measured once more with the same error.
    Number {
        /// Its name.
        name: String,
        /// Its standard deviation.
        sd: f64,
        /// And unit.
        unit: &'static str,
    },
}

/// x, y, z, and what is between two or three of them.
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

/// What could be measured next, best first: each rig of the plan with the body turned to swing about others of its axes, and each measured number once more.
/// `None` where there is no tensor to compare.
///
/// # Errors
/// [`IdentifyError::NotFinite`]
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

/// The first test of the body in each rig.
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

/// The placement with the body turned about its centre c by Q, as little as it takes: r_rig = R (c + Q (r − c)) + origin.
fn turned(test: &SwingTest, about: [i8; 3], found: &SwingEstimate) -> Option<Placement> {
    let Placement { rotation, origin } = test.body?;
    let wanted = Direction::<Body>::from_array(about.map(f64::from)).direction()?;
    let axis: Direction<Body> = rotation.inverse() * Direction::<Space>::from_array(test.rig.axis());
    // an axis has no sign
    let wanted = if wanted.dot(axis) < 0.0 { -wanted } else { wanted };
    let turn = match wanted.cross(axis).direction() {
        Some(about) => Rotation::<Body, Body>::about(about, wanted.angle_to(axis)).ok()?,
        None => Rotation::identity(),
    };
    let c: Position<Body> = found.body.center_of_mass();
    Some(Placement { rotation: rotation * turn, origin: origin + rotation * (c - turn * c) })
}

/// The test with what would be measured, and its rows: derivatives by all numbers, with the test's own eliminated.
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

/// A measurement less what is left of it, in standard deviations: what is predicted.
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
