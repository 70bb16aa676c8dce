//! Motion as rows of numbers.

use polhode::motion::channel::CONTACT;
use polhode::motion::contact::ContactState;
use polhode::motion::{Crossing, Pointing, Sample, Trajectory, Wheel};
use polhode_document::json::{finite, numbers};
use polhode_document::layout::printable;
use serde_json::{Value, json};

use super::PageSubject;
use super::directions::Directions;
use super::rows::Rows;
use crate::report::balance::{Balance, Driven, balances, has_potential};
use crate::report::plot::series;
use crate::report::torque::named_wheels;

/// Largest number of samples on a page; more would not be visible.
const MOST: usize = 2_001;

/// Samples of a page, with the data for its plots.
#[derive(Debug)]
pub(crate) struct Shown<'a> {
    pub samples: Vec<&'a Sample>,
    /// Contact at each sample, for a body on the ground; else empty.
    pub contact: Vec<ContactState>,
    /// Number of samples of the trajectory.
    pub of: usize,
    driven: Driven,
    drift: Vec<Balance>,
    pub method: &'static str,
    wheels: Vec<(String, Wheel)>,
    pointings: Vec<Pointing>,
    directions: Directions,
    events: Vec<(f64, String)>,
    is_complete: bool,
}

impl<'a> Shown<'a> {
    /// Returns all samples, or [`MOST`] equally spaced ones with the first and the last.
    ///
    /// A trajectory without samples is represented by its start.
    pub(crate) fn of(trajectory: &'a Trajectory, subject: &PageSubject<'a>) -> Self {
        let all = trajectory.samples();
        let (driven, wheels, pointings) = match *subject {
            PageSubject::Scenario(scenario) => {
                (Driven::of(scenario), named_wheels(scenario), series::pointings(scenario))
            }
            PageSubject::Moments(_) => (Driven::default(), Vec::new(), Vec::new()),
        };
        let directions = match *subject {
            PageSubject::Scenario(scenario) => Directions::of(scenario, &pointings),
            PageSubject::Moments(_) => Directions::default(),
        };
        let mut drift = balances(trajectory, driven);
        let mut samples = vec![trajectory.start()];
        let on_ground = trajectory.channel(CONTACT);
        let mut contact: Vec<_> = on_ground.map(|contact| contact.start()).into_iter().collect();
        if !all.is_empty() {
            let chosen = chosen(all.len());
            samples = chosen.iter().filter_map(|&k| all.get(k)).collect();
            contact = chosen.iter().filter_map(|&k| on_ground?.get(k)).collect();
            for balance in &mut drift {
                balance.values = chosen.iter().filter_map(|&k| balance.values.get(k)).copied().collect();
            }
        }
        Self {
            samples,
            contact,
            of: all.len().max(1),
            driven,
            drift,
            method: trajectory.solution().name(),
            wheels,
            pointings,
            directions,
            events: events(trajectory),
            is_complete: trajectory.ending().is_complete(),
        }
    }

    fn row<const N: usize>(&self, rows: &mut Rows, of: impl Fn(&Sample) -> [f64; N]) -> Value {
        rows.put(self.samples.iter().flat_map(|sample| of(sample)))
    }

    /// Returns the lines of the drift plot, one for each conserved quantity.
    fn drift(&self, rows: &mut Rows) -> Value {
        let line = |balance: &Balance| json!({ "name": balance.name, "values": rows.put(balance.values.iter().map(|&d| finite(d))) });
        self.drift.iter().map(line).collect()
    }

    /// Returns the speed and motor torque of each wheel; `null` for a speed that is held.
    fn wheels(&self, rows: &mut Rows) -> Value {
        let one = |(name, wheel): &(String, Wheel)| {
            let speeds: Option<Vec<f64>> =
                self.samples.iter().map(|s| wheel.speed_at(s.state.time, s.state.omega)).collect();
            json!({
                "name": printable(name),
                "axis": wheel.axis().to_array(),
                "motor": wheel.is_driven().then(|| self.row(rows, |s| [wheel.torque_at(s.state.time)])),
                "momentum": self.row(rows, |s| [wheel.momentum_at(s.state.time)]),
                "speed": speeds.map(|speeds| rows.put(speeds)),
            })
        };
        self.wheels.iter().map(one).collect()
    }

    /// Returns the pointing angles between body directions and nadir, velocity or other references,
    /// rad.
    fn pointings(&self, rows: &mut Rows) -> Value {
        let one = |(k, pointing): (usize, &Pointing)| {
            let angle = |s: &Sample| [finite(pointing.angle(&s.state))];
            json!({
                "name": printable(pointing.name()),
                "body": numbers(&pointing.body().to_array().map(finite)),
                "target": self.directions.target(k),
                "limit": pointing.limit(),
                "values": self.row(rows, angle),
            })
        };
        self.pointings.iter().enumerate().map(one).collect()
    }

    /// Returns the work of the torques or motors since the start, J.
    ///
    /// Null if there is a potential energy instead, or if nothing acts.
    fn work(&self, has_potential: bool, rows: &mut Rows) -> Value {
        if has_potential || !self.driven.at_all() || !self.contact.is_empty() {
            return Value::Null;
        }
        json!({ "name": self.driven.work(), "values": self.row(rows, |s| [finite(s.work)]) })
    }

    /// Returns T, J; on the ground including that of the centre of mass.
    fn kinetic(&self, rows: &mut Rows) -> Value {
        if self.contact.is_empty() {
            return self.row(rows, |s| [s.kinetic_energy]);
        }
        rows.put(self.contact.iter().map(|s| s.kinetic_energy))
    }

    /// Returns the potential energy of the torques, J; on the ground that of the weight.
    fn potential(&self, has_potential: bool, rows: &mut Rows) -> Value {
        match has_potential {
            _ if !self.contact.is_empty() => rows.put(self.contact.iter().map(|s| s.potential_energy)),
            true => self.row(rows, |s| [s.potential_energy.unwrap_or_default()]),
            false => Value::Null,
        }
    }

    /// Returns the first events; more would hide the curves.
    fn events(&self) -> Value {
        const MOST: usize = 40;
        let one = |(time, name): &(f64, String)| json!({ "time": time, "name": name });
        self.events.iter().take(MOST).map(one).collect()
    }

    /// Returns true if any torque acts.
    fn is_turned(&self) -> bool {
        self.samples.iter().any(|s| s.torque.norm() > 0.0)
    }
}

/// Returns the times and names of events and contact changes, in the order of time.
fn events(trajectory: &Trajectory) -> Vec<(f64, String)> {
    let one = |crossing: &Crossing| (crossing.state.time, printable(&crossing.name));
    let mut all: Vec<_> = trajectory.events().iter().map(one).collect();
    all.extend(trajectory.changes().iter().map(|event| (event.time, event.change.name().to_owned())));
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    all
}

/// Returns the indices of the samples to be shown, out of `count`.
fn chosen(count: usize) -> Vec<usize> {
    if count <= MOST {
        return (0..count).collect();
    }
    (0..MOST).map(|k| k * (count - 1) / (MOST - 1)).collect()
}

/// Returns the JSON of a motion; `contact` has the data of a body on the ground.
pub(crate) fn json(shown: &Shown<'_>, contact: &Value, rows: &mut Rows) -> Value {
    let has_potential = has_potential(shown.samples.iter().copied());
    json!({
        "count": shown.samples.len(),
        "method": shown.method,
        "times": shown.row(rows, |s| [s.state.time]),
        "attitude": shown.row(rows, |s| s.state.attitude.quaternion()),
        "omega": shown.row(rows, |s| s.state.omega.to_array()),
        "momentum": shown.row(rows, |s| s.momentum.to_array()),
        "torque": shown.is_turned().then(|| shown.row(rows, |s| s.torque.to_array())),
        "kinetic": shown.kinetic(rows),
        "potential": shown.potential(has_potential, rows),
        "work": shown.work(has_potential, rows),
        "drift": shown.drift(rows),
        "wheels": shown.wheels(rows),
        "pointings": shown.pointings(rows),
        "directions": shown.directions.json(&shown.samples),
        "events": shown.events(),
        "eventCount": shown.events.len(),
        "contact": contact,
        "complete": shown.is_complete,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_and_the_last_sample_are_shown() {
        assert_eq!(chosen(3), [0, 1, 2]);
        for count in [MOST, MOST + 1, 2 * MOST - 1, 123_457] {
            let chosen = chosen(count);
            assert_eq!((chosen.len(), chosen[0], chosen[MOST - 1]), (MOST, 0, count - 1));
            assert!(chosen.windows(2).all(|pair| pair[0] < pair[1]));
        }
    }
}
