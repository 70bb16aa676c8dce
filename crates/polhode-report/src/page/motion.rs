//! The motion as rows of numbers.

use polhode::{Drift, Sample, Trajectory};
use serde_json::{Value, json};

use super::base64::f64s;
use super::data::finite;

/// A page of more samples would be large and show no more.
const MOST: usize = 2_001;

/// The samples that a page shows.
#[derive(Debug)]
pub(super) struct Shown<'a> {
    pub(super) samples: Vec<&'a Sample>,
    /// How many there are.
    pub(super) of: usize,
    drift: Option<Vec<Drift>>,
    pub(super) method: &'static str,
}

impl<'a> Shown<'a> {
    /// All samples, or [`MOST`] evenly chosen with the first and the last; the start where there are none.
    pub(super) fn of(trajectory: &'a Trajectory) -> Self {
        let all = trajectory.samples();
        let method = trajectory.solution().name();
        if all.is_empty() {
            return Self { samples: vec![trajectory.start()], of: 1, drift: None, method };
        }
        let drift = Drift::along(trajectory);
        let chosen = chosen(all.len());
        Self {
            samples: chosen.iter().filter_map(|&k| all.get(k)).collect(),
            of: all.len(),
            drift: drift.map(|drift| chosen.iter().filter_map(|&k| drift.get(k)).copied().collect()),
            method,
        }
    }

    /// The largest angle by which the body turns from one sample to the next, rad, as |ω| Δt.
    pub(super) fn largest_turn(&self) -> f64 {
        let turn = |pair: &[&Sample]| match pair {
            [a, b] => a.state.omega.norm().max(b.state.omega.norm()) * (b.state.time - a.state.time),
            _ => 0.0,
        };
        self.samples.windows(2).map(turn).fold(0.0, f64::max)
    }

    fn rows<const N: usize>(&self, row: impl Fn(&Sample) -> [f64; N]) -> String {
        f64s(self.samples.iter().flat_map(|sample| row(sample)))
    }

    /// Lines of the drift plot: what should stay the same.
    fn drift(&self) -> Value {
        let Some(drift) = &self.drift else { return json!([]) };
        let is_turned = self.is_turned();
        let line = |name: &str, value: &dyn Fn(&Drift) -> f64| json!({ "name": name, "values": f64s(drift.iter().map(|d| finite(value(d)))) });
        let mut lines = if is_turned {
            vec![line("T − work", &|d| d.work_energy), line("L − impulse", &|d| d.momentum)]
        } else {
            vec![
                line("T", &|d| d.kinetic_energy),
                line("|L|", &|d| d.momentum_magnitude),
                line("L in space", &|d| d.momentum),
            ]
        };
        if drift.iter().all(|d| d.total_energy.is_some()) {
            lines.push(line("T + U", &|d| d.total_energy.unwrap_or_default()));
        }
        lines.into()
    }

    /// True if some torque acts.
    fn is_turned(&self) -> bool {
        self.samples.iter().any(|s| s.torque.norm() > 0.0)
    }
}

/// Which of so many samples are shown.
fn chosen(count: usize) -> Vec<usize> {
    if count <= MOST {
        return (0..count).collect();
    }
    (0..MOST).map(|k| k * (count - 1) / (MOST - 1)).collect()
}

pub(super) fn json(shown: &Shown<'_>) -> Value {
    let potential: Option<Vec<f64>> = shown.samples.iter().map(|s| s.potential_energy).collect();
    let potential = potential.filter(|all| all.iter().all(|u| u.is_finite()));
    json!({
        "count": shown.samples.len(),
        "method": shown.method,
        "times": shown.rows(|s| [s.state.time]),
        "attitude": shown.rows(|s| s.state.attitude.quaternion()),
        "omega": shown.rows(|s| s.state.omega.to_array()),
        "momentum": shown.rows(|s| s.momentum.to_array()),
        "torque": shown.is_turned().then(|| shown.rows(|s| s.torque.to_array())),
        "kinetic": shown.rows(|s| [s.kinetic_energy]),
        "potential": potential.map(f64s),
        "drift": shown.drift(),
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
