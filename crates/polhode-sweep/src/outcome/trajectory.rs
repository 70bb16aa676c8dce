//! The motions of members: a row for each sample.

use polhode::motion::{Scenario, State};

use crate::batch::{Batch, BatchError, Column, MEMBER, Values};

/// The states of a motion at its sample times, as far as it goes.
pub(crate) fn samples(scenario: &Scenario) -> Vec<State> {
    match scenario.simulate() {
        Some(Ok(trajectory)) => trajectory.samples().iter().map(|sample| sample.state).collect(),
        Some(Err(_)) | None => Vec::new(),
    }
}

/// A column: its name, its unit, what it is.
type Head = (&'static str, &'static str, &'static str);

const HEADS: [Head; 8] = [
    ("time_s", "s", "time"),
    ("attitude_w", "", ATTITUDE),
    ("attitude_x", "", ATTITUDE),
    ("attitude_y", "", ATTITUDE),
    ("attitude_z", "", ATTITUDE),
    ("omega_body_x_rad_s", "rad/s", OMEGA),
    ("omega_body_y_rad_s", "rad/s", OMEGA),
    ("omega_body_z_rad_s", "rad/s", OMEGA),
];
const ATTITUDE: &str = "R_space_body as a unit quaternion, Hamilton, scalar first";
const OMEGA: &str = "angular velocity relative to space, along body axes";

/// The rows of members, each of whom has some.
pub(crate) fn table(members: &[u64], samples: impl Iterator<Item = Vec<State>>) -> Result<Batch, BatchError> {
    let mut numbers = Vec::new();
    let mut values: [Vec<f64>; 8] = Default::default();
    for (&member, states) in members.iter().zip(samples) {
        for state in states {
            let [w, x, y, z] = state.attitude.quaternion();
            let row = [state.time, w, x, y, z, state.omega.x, state.omega.y, state.omega.z];
            numbers.push(member);
            values.iter_mut().zip(row).for_each(|(column, value)| column.push(value));
        }
    }
    let member = Column {
        name: MEMBER.to_owned(),
        unit: String::new(),
        description: "the member's number, from 0".to_owned(),
        values: Values::Whole(numbers),
    };
    let columns = HEADS.into_iter().zip(values).map(|((name, unit, description), values)| Column {
        name: name.to_owned(),
        unit: unit.to_owned(),
        description: description.to_owned(),
        values: Values::Numbers(values),
    });
    Batch::new(std::iter::once(member).chain(columns).collect())
}
