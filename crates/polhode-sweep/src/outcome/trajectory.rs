//! Trajectories of members: one row per sample.

use polhode::motion::{Scenario, State};

use crate::batch::{Batch, BatchError, Column, Values};

/// Returns the states of a motion at its sample times, until it ends.
pub(crate) fn samples(scenario: &Scenario) -> Vec<State> {
    match scenario.simulate() {
        Some(Ok(trajectory)) => trajectory.samples().iter().map(|sample| sample.state).collect(),
        Some(Err(_)) | None => Vec::new(),
    }
}

/// Name, unit and description of each column.
const HEADS: [[&str; 3]; 8] = [
    ["time_s", "s", "time"],
    ["attitude_w", "", ATTITUDE],
    ["attitude_x", "", ATTITUDE],
    ["attitude_y", "", ATTITUDE],
    ["attitude_z", "", ATTITUDE],
    ["omega_body_x_rad_s", "rad/s", OMEGA],
    ["omega_body_y_rad_s", "rad/s", OMEGA],
    ["omega_body_z_rad_s", "rad/s", OMEGA],
];
const ATTITUDE: &str = "R_space_body as a unit quaternion, Hamilton, scalar first";
const OMEGA: &str = "angular velocity relative to space, along body axes";

/// Returns the rows of members, each with its states.
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
    let columns = HEADS.into_iter().zip(values);
    let columns = columns.map(|(head, values)| Column::new(head, Values::Numbers(values)));
    Batch::new(std::iter::once(Column::of_members(numbers)).chain(columns).collect())
}
